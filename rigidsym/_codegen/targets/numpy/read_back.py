"""Check of the printed NumPy module, which is read back and compared with its functions.

The module holds numbers, functions, tables and limits in order.
"""

import ast
from collections.abc import Collection, Iterator, Mapping
from copy import copy

from rigidsym._codegen import header
from rigidsym._codegen.formats import BINARY64
from rigidsym._codegen.forms import STEP, THETA, key, limits
from rigidsym._codegen.ir import Constant, Function, Let, named
from rigidsym._codegen.lines import comment, flat_results
from rigidsym._codegen.passes import specialise
from rigidsym._codegen.seal.equality import DIFFERS, is_equal
from rigidsym._codegen.seal.text import Between, between
from rigidsym._codegen.targets.numpy import emit, module
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
    """Check the printed Python file against its functions; return the number of derived lines.

    Raises InputError for a line that differs from its let.
    """
    file, functions = module.FILES[form], emit.own(functions)
    derived = _derived(files[file], functions, form)
    statements = iter(_statements(derived))
    for one in named(functions, constants):
        pair = f"_DoubleDouble({one.hi!r}, {one.lo!r})"
        expected = f"{one.name} = {repr(one.hi) if one.lo is None else pair}"
        _check_statement(_next(statements, file, expected), file, expected)
    known: set[str] = set()
    for function in functions:
        node = _next(statements, file, f"def {function.name}")
        _check_function(function, node, known, derived)
        known.add(function.name)
    tables = [f"{name} = {table}" for name, table in emit.tables(functions).items()]
    ends = [f"{limit.name.upper()} = 2.0**{limit.exponent}" for limit in limits(form)]
    ends += [f"STEPS = {BINARY64.doublings}", f"LAST = {BINARY64.last}"] if form == STEP else []
    for expected in (*tables, *ends):
        _check_statement(_next(statements, file, expected), file, expected)
    for left in statements:
        raise InputError(_place(file, left), ast.unparse(left), "is no statement of this module")
    return sum(len(function.lets) for function in functions)


def _derived(text: str, functions: tuple[Function, ...], form: str) -> Between:
    """Return the generated text between the hand-written parts of the module."""
    file = module.FILES[form]
    kinds = (let.kind for function in functions for let in function.lets)
    first = module.first(form).replace(header.SHARES, module.counted(kinds, form))
    return between(file, text, key("numpy", form), first, module.last(form))


def _statements(derived: Between) -> list[ast.stmt]:
    try:
        tree = ast.parse(derived.text)
    except SyntaxError as error:
        place = f"{derived.file}:{derived.line - 1 + (error.lineno or 1)}"
        raise InputError(place, (error.text or "").strip(), f"is no Python: {error.msg}") from None
    except ValueError as error:
        raise InputError(derived.file, "its text", f"is no Python: {error}") from None
    return list(ast.increment_lineno(tree, derived.line - 1).body)


def _next(statements: Iterator[ast.stmt], file: str, expected: str) -> ast.stmt:
    for statement in statements:
        return statement
    raise InputError(file, expected, "is not there")


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
    function: Function, node: ast.stmt, known: Collection[str], derived: Between
) -> None:
    parameters = ", ".join(name for name in function.parameters if name != "t_lo")
    head = f"def {function.name}({parameters}):"
    if not isinstance(node, ast.FunctionDef) or _head(node) != head:
        raise InputError(_place(derived.file, node), _head(node), f"is not {head}")
    said, *lines, last = node.body
    if ast.dump(said) != ast.dump(ast.Expr(ast.Constant(function.summary))):
        rule = f"is not {function.summary!r}"
        raise InputError(_place(derived.file, said), ast.unparse(said), rule)
    if len(lines) != len(function.lets):
        raise InputError(function.name, f"{len(lines)} lines", f"has {len(function.lets)} lets")
    for line, let in zip(lines, function.lets, strict=True):
        _check_line(function, line, let, known)
        _, _, note = derived.at(line.lineno).partition("  # ")
        if note != comment(let):
            raise InputError(function.name, f"{let}  # {note}", f"is by {comment(let)}")
    results = flat_results(function) if function.rounds else list(function.results)
    if _returned(last) != results:
        raise InputError(function.name, ast.unparse(last), f"does not return {results}")


def _head(node: ast.stmt) -> str:
    """Return the signature of a function definition as text."""
    if not isinstance(node, ast.FunctionDef):
        return ast.unparse(node)
    bare = copy(node)
    bare.body = [ast.Pass()]
    return ast.unparse(bare).removesuffix("\n    pass").strip()


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
