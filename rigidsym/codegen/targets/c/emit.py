"""Lets as C99: double-doubles by calls, doubles by operators.

`pieces` prints a function of lets; `rigidsym.codegen.targets.c.expressions` reads a line of it.
"""

from collections.abc import Iterable
from dataclasses import replace

from rigidsym.codegen.ir import CALLS, Constant, Function, Let, is_extended
from rigidsym.codegen.lines import Lines, comment, flat_results
from rigidsym.codegen.passes import fuse
from rigidsym.codegen.targets.c import lanes
from rigidsym.language.expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    to_text,
)

# The type of extended numbers by what begins the names of its functions.
_TYPES = {"dd": "double_double", "exact": "exact", "double": "double"}
_VERBS = {"+": "add", "-": "sub", "*": "mul", "/": "div"}
_DOUBLE_CALLS = {"fma": "fused", "size": "fabs", "sqrt": "sqrt", "exp": "exponential"}


def lowered(expression: Expression, extended: frozenset[str], number: str) -> Expression:
    """Operations on extended numbers as calls; `number`: whose, `dd` or `exact`."""
    match expression:
        case Name() | Number():
            return expression
        case Operation(symbol, left, right) if symbol in _VERBS:
            parts = (lowered(left, extended, number), lowered(right, extended, number))
            if not is_extended(expression, extended):
                return Operation(symbol, *parts)
            kinds = "".join("x" if is_extended(part, extended) else "d" for part in (left, right))
            return Call(f"{number}_{_VERBS[symbol]}_{kinds}", parts)
        case Call("choose", (x, y, *values)) if is_extended(expression, extended):
            condition = (lowered(x, extended, number), lowered(y, extended, number))
            lifted = tuple(_lifted(value, extended, number) for value in values)
            return Call(f"{number}_choose", condition + lifted)
        case Call(function, arguments) if function.startswith("_"):
            lift = _lifted if is_extended(expression, extended) else lowered
            return Call(function[1:], tuple(lift(each, extended, number) for each in arguments))
        case Call(function, arguments) if function in CALLS:
            given = tuple(lowered(argument, extended, number) for argument in arguments)
            if any(is_extended(argument, extended) for argument in arguments):
                return Call(f"{number}_{function}", given)
            return Call(_DOUBLE_CALLS.get(function, function), given)
    raise ValueError(f"{to_text(expression)}: C cannot say this")


def _lifted(expression: Expression, extended: frozenset[str], number: str) -> Expression:
    """An extended number, whatever the expression is."""
    text = lowered(expression, extended, number)
    return text if is_extended(expression, extended) else Call(f"{number}_of", (text,))


def _let_lines(function: Function) -> Lines:
    """The lines of a function's lets alone."""
    return function_lines(function, "dd", [], [])


def function_lines(function: Function, number: str, signature: list[str], ends: list[str]) -> Lines:
    """A function with its lets between what the caller says of its head and its end."""
    extended = function.all_extended()
    text, lets = list(signature), {}
    for let in fuse(function):
        is_double_double = is_extended(let.expression, extended)
        code = to_text(lowered(let.expression, extended, number), real=True)
        if len(let.targets) > 1:
            text.append(f"    {_TYPES[number]} {', '.join(let.targets)};")
            code = f"{code[:-1]}, {', '.join(f'&{target}' for target in let.targets)})"
        else:
            kind = _TYPES[number] if is_double_double else "double"
            code = f"const {kind} {let.targets[0]} = {code}"
        lets[len(text)] = let
        text.append(f"    {code};{_noted(let)}")
    return Lines((*text, *ends), lets)


def _noted(let: Let) -> str:
    note = comment(let)
    return f" /* {note} */" if note else ""


def constant_text(constant: Constant) -> str:
    """The definition of a named number."""
    hi = _literal(constant.hi)
    if constant.lo is None:
        return f"static const double {constant.name} = {hi}; /* {constant.meaning} */"
    lo = _literal(constant.lo)
    return f"static const double_double {constant.name} = {{{hi}, {lo}}}; /* {constant.meaning} */"


def _literal(value: float) -> str:
    return repr(value) if "." in repr(value) or "e" in repr(value) else f"{value!r}.0"


def module(functions: tuple[Function, ...], constants: tuple[Constant, ...]) -> list[Lines]:
    """All functions in order, over double-doubles; `_discriminant` for exact numbers too."""
    used = {name for function in functions for name in function.used()}
    head = [constant_text(c) for c in constants if c.name in used]
    head += ["", *lanes.struct_text(functions), ""]
    return [Lines(tuple(head), {}), *(part for f in functions for part in pieces(f, functions))]


def kept(functions: Iterable[Function]) -> frozenset[tuple[str, str]]:
    """What does not change with time, after what it is a constant of."""
    made = (f for f in functions if f.rounds)
    return frozenset((branch(f), name) for f in made for name in flat_results(f))


def pieces(function: Function, among: tuple[Function, ...]) -> list[Lines]:
    """A function among all of its module as it is printed, `_discriminant` twice."""
    if lanes.takes_several(function):
        return [lanes.lines(function, lanes.pairs(among), _let_lines(function))]
    if function.name == "_discriminant":
        every = replace(function, extended=frozenset(function.parameters))
        return [_valued(every, number, f"discriminant_{number}") for number in ("dd", "exact")]
    if function.rounds:
        return [_constants(function)]
    if len(function.results) == 1 and not function.extended:
        return [_valued(function, "double", function.name[1:], "INLINED double")]
    if function.extended:
        return [_extended_function(function)]
    # What is not kept changes with time.
    return [_loop(function, kept(among))]


def branch_struct(function: Function) -> str:
    """The constants that a function leaves, as a struct."""
    lines = [f"    double {', '.join(row)};" for row in batched(flat_results(function))]
    return "\n".join(["typedef struct {", *lines, f"}} torque_free_{branch(function)};"])


def branch(function: Function) -> str:
    """circular, hyperbolic or steady."""
    return function.name.split("_")[1]


def batched(items: list[str], width: int = 84) -> list[list[str]]:
    """The items in rows that stay below a width."""
    rows: list[list[str]] = [[]]
    for item in items:
        if rows[-1] and len(", ".join([*rows[-1], item])) > width:
            rows.append([])
        rows[-1].append(item)
    return rows


def _parameters(function: Function) -> list[str]:
    return [
        f"{'double_double' if name in function.extended else 'double'} {name}"
        for name in function.parameters
    ]


def _head(kind: str, name: str, parameters: list[str], summary: str) -> list[str]:
    rows = batched(parameters)
    inside = (",\n    ").join(", ".join(row) for row in rows)
    return [f"/* {summary} */", *f"static {kind} {name}({inside})".split("\n"), "{"]


def _valued(function: Function, number: str, name: str, kind: str = "") -> Lines:
    kind_of = _TYPES[number]
    parameters = [f"{kind_of} {p}" for p in function.parameters]
    head = _head(kind or kind_of, name, parameters, function.summary)
    return function_lines(function, number, head, [f"    return {function.results[0]};", "}", ""])


def _extended_function(function: Function) -> Lines:
    name, results = function.name[1:], function.results
    if len(results) == 1:
        head = _head(_TYPES["dd"], name, _parameters(function), function.summary)
        return function_lines(function, "dd", head, [f"    return {results[0]};", "}", ""])
    extended = function.all_extended()
    kinds = {True: "double_double", False: "double"}
    outputs = [f"{kinds[result in extended]} *{result}_out" for result in results]
    head = _head("void", name, _parameters(function) + outputs, function.summary)
    ends = [f"    *{result}_out = {result};" for result in results]
    return function_lines(function, "dd", head, [*ends, "}", ""])


def _constants(function: Function) -> Lines:
    output = f"torque_free_{branch(function)} *motion"
    head = _head("void", function.name[1:], [*_parameters(function), output], function.summary)
    extended = function.all_extended()
    ends = []
    for name in function.results:
        if name in function.split:
            ends += [f"    motion->{name}_hi = {name}.hi;", f"    motion->{name}_lo = {name}.lo;"]
        else:
            value = f"dd_rounded({name})" if name in extended else name
            ends.append(f"    motion->{name} = {value};")
    return function_lines(function, "dd", head, [*ends, "}", ""])


def _loop(function: Function, constants: frozenset[tuple[str, str]]) -> Lines:
    """A function of doubles over arrays: what changes with time is read and written by index."""
    own = {name for of, name in constants if of == branch(function)}
    timed = [name for name in function.parameters if name not in own]
    used = function.used()
    still = [name for name in function.parameters if name in own and name in used]
    parameters = [f"const torque_free_{branch(function)} *motion", "size_t n"]
    parameters += [f"const double *restrict {name}_in" for name in timed]
    parameters += [f"double *restrict {name}_out" for name in function.results]
    head = _head("void", function.name[1:], parameters, function.summary)
    head += [f"    const double {name} = motion->{name};" for name in still]
    head += ["    for (size_t i = 0; i < n; i++) {"]
    head += [f"        const double {name} = {name}_in[i];" for name in timed]
    ends = [f"        {name}_out[i] = {name};" for name in function.results]
    lines = function_lines(function, "dd", head, [*ends, "    }", "}", ""])
    start = len(head)
    text = tuple(
        f"    {line}" if start <= k < start + len(function.lets) else line
        for k, line in enumerate(lines.text)
    )
    return Lines(text, lines.lets)
