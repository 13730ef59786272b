"""Check of the printed NumPy module, which is read back and compared with what it prints.

Derived functions are compared with their assignments, routines statement by statement, constants,
tables and limits with their values, and everything else word for word.
"""

import ast
from collections.abc import Collection, Iterator, Mapping
from itertools import chain

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key, limits
from rigidsym._codegen.ir import Constant, Function, Let, named
from rigidsym._codegen.lines import comment, flat_results
from rigidsym._codegen.passes import specialise
from rigidsym._codegen.seal.bodies import Body, check_outside
from rigidsym._codegen.seal.equality import DIFFERS, is_equal
from rigidsym._codegen.targets.numpy import emit, module
from rigidsym._codegen.targets.numpy.reader import read_routine, wanted_of
from rigidsym.errors import InputError
from rigidsym.language._expression import (
    Call,
    Expression,
    Number,
    Operation,
    children,
    parse,
    put,
    rebuild,
)

# What hand-written functions, and one of Python's, compute; `_horner` is a polynomial.
_CALLED = {
    **{"abs": "size", "_sqrt": "sqrt", "_choose": "choose", "_rounded": "rounded"},
    **{"_exponent": "exponent", "_mantissa": "mantissa", "_exp": "exp", "_nearest": "nearest"},
    **{"_alternating": "alternating", "_product_error": "product_error"},
}


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed Python file against what it prints; return the number of derived lines.

    Raises InputError for a line that differs.
    """
    file, of = module.FILES[form], key("numpy", form)
    built = module.build(functions, constants, form)
    if files.keys() != built.files.keys():
        raise InputError("files", ", ".join(files), f"are not {file}")
    text = header.unsealed(files[file], of, header.digest_in(file, files[file]))
    wanted = header.unsealed(built.files[file], of, built.digest)
    functions = emit.own(functions)
    made = module.program(functions, constants, form)
    routines = {module.printer.name_of(one): one for one in module.routines(made, form)}
    derived = {function.name: function for function in functions}
    found = _parsed(file, text)
    printed = {*routines, *derived}
    check_outside(
        file,
        _outside(text, _functions(found, printed)),
        _outside(wanted, _functions(_parsed(file, wanted), printed)),
    )
    _check_values(file, found, functions, constants, form)
    known: set[str] = set()
    lines = text.split("\n")
    for node in _functions(found, printed):
        if node.name in derived:
            _check_function(derived[node.name], node, known, lines)
            known.add(node.name)
        else:
            one = routines[node.name]
            read = read_routine(file, node, one, made)
            Body(file, lines, one).check(read, wanted_of(one))
    return sum(len(function.lets) for function in functions)


def _parsed(file: str, text: str) -> ast.Module:
    try:
        return ast.parse(text)
    except SyntaxError as error:
        place = f"{file}:{error.lineno or 1}"
        raise InputError(place, (error.text or "").strip(), f"is no Python: {error.msg}") from None
    except ValueError as error:
        raise InputError(file, "its text", f"is no Python: {error}") from None


def _functions(tree: ast.Module, names: Collection[str]) -> list[ast.FunctionDef]:
    """Return the functions that print something, by their names."""
    return [x for x in tree.body if isinstance(x, ast.FunctionDef) and x.name in names]


def _outside(text: str, printed: list[ast.FunctionDef]) -> Iterator[tuple[int, str]]:
    """Yield the lines with their numbers, but for those of statements of printed functions."""
    inside = {
        number
        for one in printed
        for number in range(one.body[0].lineno, (one.end_lineno or one.lineno) + 1)
        if number > (one.body[0].end_lineno or 0)
    }
    yield from ((k, line) for k, line in enumerate(text.split("\n"), 1) if k not in inside)


def _check_values(
    file: str,
    tree: ast.Module,
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str,
) -> None:
    """Raise InputError for a constant, table or limit with another value than it has."""
    assigned = {
        x.targets[0].id: x
        for x in tree.body
        if isinstance(x, ast.Assign) and isinstance(x.targets[0], ast.Name)
    }
    pairs = (
        (x.name, repr(x.hi) if x.lo is None else f"_DoubleDouble({x.hi!r}, {x.lo!r})")
        for x in named(functions, constants)
    )
    tables = emit.tables(functions).items()
    ends = ((x.name.upper(), f"2.0**{x.exponent}") for x in limits(form))
    for name, value in chain(pairs, tables, ends):
        expected = f"{name} = {value}"
        if name not in assigned:
            raise InputError(file, expected, "is not there")
        _check_statement(assigned[name], file, expected)


def _place(file: str, node: ast.stmt) -> str:
    return f"{file}:{node.lineno}"


def _check_statement(node: ast.stmt, file: str, expected: str) -> None:
    (wanted,) = ast.parse(expected).body
    if ast.dump(node) != ast.dump(wanted):
        found, wanted = map(ast.unparse, _difference(node, wanted))
        raise InputError(_place(file, node), found, f"is not {wanted:.80}")


def _difference(found: ast.AST, wanted: ast.AST) -> tuple[ast.AST, ast.AST]:
    """Return the innermost parts in which two statements differ."""
    match found, wanted:
        case ast.Assign(targets=[ast.Name(id=name)]), ast.Assign(targets=[ast.Name(id=other)]):
            return _difference(found.value, wanted.value) if name == other else (found, wanted)
        case ast.Dict(), ast.Dict() if _keys(found) == _keys(wanted):
            for one, other in zip(found.values, wanted.values, strict=True):
                if ast.dump(one) != ast.dump(other):
                    return _difference(one, other)
    return found, wanted


def _keys(table: ast.Dict) -> list[str]:
    return [ast.unparse(key) if key else "**" for key in table.keys]


def _check_function(
    function: Function, node: ast.FunctionDef, known: Collection[str], text: list[str]
) -> None:
    parameters = [name for name in function.parameters if name != "t_lo"]
    if ast.unparse(node.args) != ", ".join(parameters):
        raise InputError(function.name, ast.unparse(node.args), f"are not {', '.join(parameters)}")
    _, *lines, last = node.body
    if len(lines) != len(function.lets):
        raise InputError(function.name, f"{len(lines)} lines", f"has {len(function.lets)} lets")
    for line, let in zip(lines, function.lets, strict=True):
        _check_line(function, line, let, known)
        _, _, note = text[line.lineno - 1].partition("  # ")
        if note != comment(let):
            raise InputError(function.name, f"{let}  # {note}", f"is by {comment(let)}")
    results = flat_results(function) if function.rounds else list(function.results)
    if _returned(last) != results:
        raise InputError(function.name, ast.unparse(last), f"does not return {results}")


def _check_line(function: Function, line: ast.stmt, let: Let, known: Collection[str]) -> None:
    match line:
        case ast.Assign(targets=[ast.Name(id=name)], value=value):
            targets = (name,)
        case ast.Assign(targets=[ast.Tuple(elts=elements)], value=value):
            targets = tuple(map(ast.unparse, elements))
        case _:
            raise InputError(function.name, ast.unparse(line), f"sets no name: {let}")
    if targets != let.targets or read(function.name, value, known) != _expected(function, let):
        raise InputError(function.name, ast.unparse(line), f"{let}: {DIFFERS}")


def _expected(function: Function, let: Let) -> Expression:
    """Return the expression expected in Python: that of an assignment, with t_lo set to 0.

    Times are doubles in the NumPy module.
    """
    if "t_lo" not in function.parameters:
        return let.expression
    (short,) = specialise([let], {"t_lo": 0})
    if not is_equal(put(let.expression, {"t_lo": Number(0)}), short.expression):
        raise InputError(function.name, let, "is not this where t_lo = 0")
    return short.expression


def _returned(node: ast.stmt) -> list[str]:
    """Return the names in a return statement.

    The halves of a pair are name_hi and name_lo.
    """
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


def read(place: str, node: ast.expr, known: Collection[str]) -> Expression:
    """Convert a Python syntax tree to an expression of formulas.

    It may call hand-written and known functions.  Raises InputError, naming the place, for what is
    no expression of this module.
    """
    _check_calls(place, node, {*_CALLED, "_horner", *known})
    try:
        return _read(parse(ast.unparse(node)))
    except ValueError as error:
        raise InputError(place, ast.unparse(node), str(error)) from None


def _check_calls(place: str, node: ast.expr, known: set[str]) -> None:
    """Check that a Python expression calls only known functions.

    `neg`, the parser's word for a sign, is not known.
    """
    for part in ast.walk(node):
        if isinstance(part, ast.Call) and ast.unparse(part.func) not in known:
            raise InputError(place, ast.unparse(part), "calls what is not known")


def _read(expression: Expression) -> Expression:
    match rebuild(expression, tuple(map(_read, children(expression)))):
        case Call("_horner", (variable, *coefficients)):
            return _nested(variable, tuple(coefficients))
        case Call(function, arguments):
            return Call(_CALLED.get(function, function), arguments)
        case other:
            return other


def _nested(variable: Expression, coefficients: tuple[Expression, ...]) -> Expression:
    """Build the nested polynomial c_0 + x*(c_1 + x*(c_2 + ...))."""
    first, *rest = coefficients
    if not rest:
        return first
    return Operation("+", first, Operation("*", variable, _nested(variable, tuple(rest))))
