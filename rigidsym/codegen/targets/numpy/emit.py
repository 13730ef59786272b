"""Lets as Python over NumPy arrays: extended numbers are `_DoubleDouble`s, with operators."""

from rigidsym.codegen.ir import CALLS, Constant, Function
from rigidsym.codegen.lines import Lines, comment, flat_results
from rigidsym.codegen.passes import specialise
from rigidsym.language.expression import (
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
    """The functions that the module prints: NumPy brings the exponential."""
    return tuple(function for function in functions if function.name != "_exponential")


def module(functions: tuple[Function, ...], constants: tuple[Constant, ...]) -> list[Lines]:
    """The named numbers, all functions in order, and the table of branches, if there are any."""
    used = {name for function in functions for name in function.used()}
    head = tuple(constant_text(c) for c in constants if c.name in used)
    parts = [Lines((*head, "", ""), {})]
    parts += [function_lines(function) for function in functions]
    if not any(function.name == "_initial_state" for function in functions):
        return parts
    return [*parts, Lines(tuple(_branches(functions)), {})]


def constant_text(constant: Constant) -> str:
    """The definition of a named number."""
    value = repr(constant.hi)
    if constant.lo is not None:
        value = f"_DoubleDouble({constant.hi!r}, {constant.lo!r})"
    return f"{constant.name} = {value}  # {constant.meaning}"


def function_lines(function: Function) -> Lines:
    """A function, a line for each of its lets."""
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
    """An expression as Python; raises ValueError for a function that the module does not have."""
    _check(expression)
    return to_text(_with_horner(expression), _CALLS | {"horner": "_horner"})


def _with_horner(expression: Expression) -> Expression:
    """Nested polynomials as one call, which works in place."""
    variable, coefficients = _polynomial(expression)
    if len(coefficients) > 2:
        return Call("horner", (variable, *map(_with_horner, coefficients)))
    return rebuild(expression, tuple(map(_with_horner, children(expression))))


def _polynomial(expression: Expression) -> tuple[Expression, tuple[Expression, ...]]:
    """The variable and the coefficients of a + x*(b + x*c), lowest first."""
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


def _branches(functions: tuple[Function, ...]) -> list[str]:
    """What the frame needs to know of each branch."""
    by_name = {function.name: function for function in functions}
    lines = _entry("INITIAL_STATE = {", by_name["_initial_state"], [], "}", "    ")
    lines.append("BRANCHES = {")
    for name in ("circular", "hyperbolic", "steady"):
        first, angles, state = (
            by_name[f"_{name}_{part}"] for part in ("constants", "angles", "state")
        )
        timed = set(angles.results)
        more = [
            f"'angles': {angles.name},",
            f"'state': {state.name},",
            f"'rates': {tuple(n for n in angles.parameters if n not in ('t', 't_lo'))!r},",
            f"'shape': {tuple(n for n in state.parameters if n not in timed)!r},",
            f"'fast': {tuple(f'{n}_hi' for n in first.results if n.endswith('_rate'))!r},",
            f"'steady': {name == 'steady'},",
        ]
        lines += _entry(f"    {name!r}: {{", first, more, "    },", "        ")
    lines.append("}")
    if "_moduli" in by_name:
        lines += _sensitivity(by_name)
    return [*lines, "", ""]


def _sensitivity(functions: dict[str, Function]) -> list[str]:
    """What the frame needs to know to find sensitivities."""
    lines = ["SENSITIVITY = {", *_part("moduli", functions["_moduli"], [])]
    for name in ("along", "columns", "real", "imaginary", "turn"):
        first, state = functions[f"_{name}_constants"], functions[f"_{name}_state"]
        kept = set(flat_results(first))
        more = [
            f"'state': {state.name},",
            f"'timed': {tuple(n for n in state.parameters if n not in kept)!r},",
            f"'shape': {tuple(n for n in state.parameters if n in kept)!r},",
            f"'results': {state.results!r},",
        ]
        if angles := functions.get(f"_{name}_angles"):
            rates = tuple(n for n in angles.parameters if n not in ("t", "t_lo"))
            more += [f"'angles': {angles.name},", f"'rates': {rates!r},"]
        lines += _part(name, first, more)
    return [*lines, "}"]


def _part(name: str, function: Function, more: list[str]) -> list[str]:
    return _entry(f"    {name!r}: {{", function, more, "    },", "        ")


def _entry(head: str, function: Function, more: list[str], end: str, indent: str) -> list[str]:
    """A function that makes constants, with what goes in and what comes out, by name."""
    inside = [
        f"'constants': {function.name},",
        f"'given': {function.parameters!r},",
        f"'names': {tuple(flat_results(function))!r},",
        *more,
    ]
    return [head, *(f"{indent}{line}" for line in inside), end]
