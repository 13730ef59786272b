"""Printer of generated functions as Python code over NumPy arrays.

Extended numbers are printed as `_DoubleDouble`s.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from rigidsym._codegen.ir import CALLS, Constant, Function, named
from rigidsym._codegen.lines import Lines, comment, flat_results
from rigidsym._codegen.passes import specialise
from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    Operation,
    children,
    rebuild,
    to_text,
)

_CALLS = {name: f"_{name}" for name in CALLS} | {"size": "abs", "neg": "neg"}


def own(functions: tuple[Function, ...]) -> tuple[Function, ...]:
    """Return the functions to print in Python: all but the exponential.

    NumPy has its own.
    """
    return tuple(function for function in functions if function.name != "_exponential")


def module(functions: tuple[Function, ...], constants: tuple[Constant, ...]) -> list[Lines]:
    """Print the constants, functions and tables of a module in Python, in this order."""
    head = map(constant_text, named(functions, constants))
    parts = [Lines((*head, "", ""), {}), *map(function_lines, functions)]
    found = tables(functions).items()
    text = [line for name, table in found for line in _table_lines(f"{name} = ", table, "}")]
    return [*parts, Lines((*text, "", ""), {})] if text else parts


def constant_text(constant: Constant) -> str:
    """Print the definition of a named constant in Python."""
    value = repr(constant.hi)
    if constant.lo is not None:
        value = f"_DoubleDouble({constant.hi!r}, {constant.lo!r})"
    return f"{constant.name} = {value}  # {constant.meaning}"


def function_lines(function: Function) -> Lines:
    """Print a function in Python, one line for each assignment."""
    lets = function.lets
    if "t_lo" in function.parameters:
        lets = specialise(lets, {"t_lo": 0})
    parameters = [name for name in function.parameters if name != "t_lo"]
    text = [f"def {function.name}({', '.join(parameters)}):", f'    """{function.summary}"""']
    places = {}
    for let in lets:
        places[len(text)] = let
        note = comment(let)
        code = f"    {', '.join(let.targets)} = {printed(let.expression)}"
        text.append(f"{code}  # {note}" if note else code)
    return Lines((*text, f"    return {_results(function)}", "", ""), places)


def printed(expression: Expression) -> str:
    """Print an expression as Python code.

    Raises ValueError for a call of an unknown function.
    """
    _check(expression)
    return to_text(_with_horner(expression), _CALLS | {"horner": "_horner"})


def _with_horner(expression: Expression) -> Expression:
    """Replace nested polynomials in an expression by calls of `_horner`.

    These work in place.
    """
    variable, coefficients = _polynomial(expression)
    if len(coefficients) > 2:
        return Call("horner", (variable, *map(_with_horner, coefficients)))
    return rebuild(expression, tuple(map(_with_horner, children(expression))))


def _polynomial(expression: Expression) -> tuple[Expression, tuple[Expression, ...]]:
    """Return the variable and the coefficients of a nested polynomial a + x*(b + x*c).

    Coefficients are lowest first.
    """
    match expression:
        case Operation("+", first, Operation("*", Name() as variable, inner)):
            same, rest = _polynomial(inner)
            return variable, (first, *(rest if same == variable else (inner,)))
    return expression, (expression,)


def _check(expression: Expression) -> None:
    called = expression.function if isinstance(expression, Call) else "_"
    if called not in CALLS and not called.startswith("_"):
        raise ValueError(f"{called}: the NumPy target has no such function")
    for part in children(expression):
        _check(part)


def _results(function: Function) -> str:
    if not function.rounds:
        return ", ".join(function.results)
    extended = function.all_extended()
    values = []
    for name in function.results:
        if name in function.split:
            values += [f"{name}.hi", f"{name}.lo"]
        else:
            values.append(f"_rounded({name})" if name in extended else name)
    return ", ".join(values)


class _Code(str):
    """String printed without quotes: the name of a function in a table."""

    __slots__ = ()
    __repr__ = str.__str__


Table = dict[str, Any]


def tables(functions: tuple[Function, ...]) -> Table:
    """Return the tables, by name, in which the runtime looks up functions.

    An entry has a function of constants with the names of its arguments and results.  The entry of
    a branch also has the functions of the time with theirs.
    """
    by_name = {function.name: function for function in functions}
    if "_initial_state" not in by_name:
        return {}
    branches = {name: _branch(name, by_name) for name in ("circular", "hyperbolic", "steady")}
    found = {"INITIAL_STATE": _entry(by_name["_initial_state"]), "BRANCHES": branches}
    if "_moduli" in by_name:
        parts = ("along", "columns", "real", "imaginary", "turn")
        found["SENSITIVITY"] = {"moduli": _entry(by_name["_moduli"])}
        found["SENSITIVITY"] |= {name: _part(name, by_name) for name in parts}
    return found


def _entry(function: Function) -> Table:
    names = tuple(flat_results(function))
    return {"constants": _Code(function.name), "given": function.parameters, "names": names}


def _branch(name: str, functions: Mapping[str, Function]) -> Table:
    first, angles, state = (functions[f"_{name}_{x}"] for x in ("constants", "angles", "state"))
    return _entry(first) | {
        "angles": _Code(angles.name),
        "state": _Code(state.name),
        "rates": tuple(n for n in angles.parameters if n not in ("t", "t_lo")),
        "shape": tuple(n for n in state.parameters if n not in angles.results),
        "fast": tuple(f"{n}_hi" for n in first.results if n.endswith("_rate")),
        "steady": name == "steady",
    }


def _part(name: str, functions: Mapping[str, Function]) -> Table:
    """Return the table entry for one group of sensitivity functions."""
    first, state = functions[f"_{name}_constants"], functions[f"_{name}_state"]
    kept = set(flat_results(first))
    part = _entry(first) | {
        "state": _Code(state.name),
        "timed": tuple(n for n in state.parameters if n not in kept),
        "shape": tuple(n for n in state.parameters if n in kept),
        "results": state.results,
    }
    if angles := functions.get(f"_{name}_angles"):
        rates = tuple(n for n in angles.parameters if n not in ("t", "t_lo"))
        part |= {"angles": _Code(angles.name), "rates": rates}
    return part


def _table_lines(head: str, table: Table, end: str, indent: str = "") -> Iterator[str]:
    """Print a table as Python code, one entry in a line.

    Nested tables are indented.
    """
    yield f"{indent}{head}{{"
    for name, value in table.items():
        if isinstance(value, dict):
            yield from _table_lines(f"{name!r}: ", value, "},", f"{indent}    ")
        else:
            yield f"{indent}    {name!r}: {value!r},"
    yield f"{indent}{end}"
