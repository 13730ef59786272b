"""The NumPy module read back: its functions hold the lets, one a line, and nothing else."""

import ast
from collections import Counter
from collections.abc import Mapping

from rigidsym.codegen.ir import Constant, Function, Let
from rigidsym.codegen.lines import flat_results
from rigidsym.codegen.passes import specialise
from rigidsym.codegen.seal.claims import DIFFERS
from rigidsym.codegen.seal.equality import is_equal
from rigidsym.codegen.targets.numpy import emit, module
from rigidsym.errors import InputError
from rigidsym.language.expression import Expression, Number, put


def check(
    files: Mapping[str, str], functions: tuple[Function, ...], constants: tuple[Constant, ...]
) -> int:
    """The number of lines that read back as their lets; raises InputError for the first not to."""
    tree, functions = ast.parse(files[module.FILE]), emit.own(functions)
    defined = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    _check_bound_once(tree)
    _check_numbers(tree, functions, constants)
    for function in functions:
        if function.name not in defined:
            raise InputError(function.name, module.FILE, "is not there")
        _check_function(function, defined[function.name])
    return sum(len(function.lets) for function in functions)


def _check_bound_once(tree: ast.Module) -> None:
    bound = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
    bound += [ast.unparse(t) for node in tree.body if isinstance(node, ast.Assign)
              for t in node.targets]  # fmt: skip
    again = sorted(name for name, count in Counter(bound).items() if count > 1)
    if again:
        raise InputError(module.FILE, ", ".join(again), "defined more than once")


def _check_numbers(
    tree: ast.Module, functions: tuple[Function, ...], constants: tuple[Constant, ...]
) -> None:
    """Named numbers are written to the last digit."""
    written = {
        ast.unparse(node.targets[0]): ast.unparse(node.value)
        for node in tree.body
        if isinstance(node, ast.Assign)
    }
    used = {name for function in functions for name in function.used()}
    for number in constants:
        text = repr(number.hi)
        if number.lo is not None:
            text = f"_DoubleDouble({number.hi!r}, {number.lo!r})"
        if number.name in used and written.get(number.name) != text:
            raise InputError(module.FILE, number.name, f"is not {text}")


def _check_function(function: Function, node: ast.FunctionDef) -> None:
    parameters = [name for name in function.parameters if name != "t_lo"]
    if ast.unparse(node.args) != ", ".join(parameters):
        raise InputError(function.name, ast.unparse(node.args), "are not its parameters")
    _, *lines, last = node.body  # the first is the docstring
    if len(lines) != len(function.lets):
        raise InputError(function.name, f"{len(lines)} lines", f"has {len(function.lets)} lets")
    for line, let in zip(lines, function.lets, strict=True):
        _check_line(function, ast.unparse(line), let)
    results = flat_results(function) if function.rounds else list(function.results)
    if _returned(last) != results:
        raise InputError(function.name, ast.unparse(last), f"does not return {results}")


def _check_line(function: Function, line: str, let: Let) -> None:
    targets, _, _ = line.partition(" = ")
    read = emit.read(line)
    if targets.strip("()") != ", ".join(let.targets) or read != _expected(function, let):
        raise InputError(function.name, line, f"{let}: {DIFFERS}")


def _expected(function: Function, let: Let) -> Expression:
    """Times are doubles here: with t_lo = 0 the line says the same, and less."""
    if "t_lo" not in function.parameters:
        return let.expression
    (short,) = specialise([let], {"t_lo": 0})
    if not is_equal(put(let.expression, {"t_lo": Number(0)}), short.expression):
        raise InputError(function.name, let, "is not this where t_lo = 0")
    return short.expression


def _returned(node: ast.stmt) -> list[str]:
    """The names that are returned, the halves of a pair as name_hi and name_lo."""
    if not isinstance(node, ast.Return) or node.value is None:
        return []
    values = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
    return [_name(value) for value in values]


def _name(value: ast.expr) -> str:
    match value:
        case ast.Attribute(value=ast.Name(id=name), attr=half):
            return f"{name}_{half}"
        case ast.Call(func=ast.Name(id="_rounded"), args=[ast.Name(id=name)]):
            return name
    return ast.unparse(value)
