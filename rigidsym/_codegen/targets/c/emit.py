"""Printer of generated functions as C99 code.

Operations on double-doubles are printed as calls, those on doubles as operators.

`pieces` prints a function of lets within its frames; `read_back` reads a line of it.
"""

from rigidsym._codegen.ir import CALLS, Constant, Function, is_extended, named
from rigidsym._codegen.lines import Lines, comment, flat_results
from rigidsym._codegen.passes import fuse
from rigidsym._codegen.targets.c.frames import Frame, branch, frames_of, lane_structs
from rigidsym.language._expression import (
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
    """Replace operations on extended numbers by calls of C functions.

    number: the prefix of these functions, `dd` or `exact`.
    """
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
    """Replace operations as `lowered` does, and convert the value to an extended number."""
    text = lowered(expression, extended, number)
    return text if is_extended(expression, extended) else Call(f"{number}_of", (text,))


def function_lines(function: Function, number: str, signature: list[str], ends: list[str]) -> Lines:
    """Print a function in C, one line for each assignment.

    These lines stand between the signature and `ends`.  They are indented as far as the blocks that
    the signature opens.
    """
    extended, indent = function.all_extended(), _indent(signature)
    text, lets = list(signature), {}
    for let in fuse(function):
        is_double_double = is_extended(let.expression, extended)
        code = to_text(lowered(let.expression, extended, number), real=True)
        if len(let.targets) > 1:
            text.append(f"{indent}{_TYPES[number]} {', '.join(let.targets)};")
            code = f"{code[:-1]}, {', '.join(f'&{target}' for target in let.targets)})"
        else:
            kind = _TYPES[number] if is_double_double else "double"
            code = f"const {kind} {let.targets[0]} = {code}"
        note = comment(let)
        lets[len(text)] = let
        text.append(f"{indent}{code};{note and f' /* {note} */'}")
    return Lines((*text, *ends), lets)


def _indent(lines: list[str]) -> str:
    return "    " * sum(line.endswith("{") for line in lines)


def constant_text(constant: Constant) -> str:
    """Print the definition of a named constant in C."""
    name, value = f"double {constant.name}", repr(constant.hi)
    if constant.lo is not None:
        name, value = f"double_double {constant.name}", f"{{{constant.hi!r}, {constant.lo!r}}}"
    return f"static const {name} = {value}; /* {constant.meaning} */"


def module(functions: tuple[Function, ...], constants: tuple[Constant, ...]) -> list[Lines]:
    """Print the constants, structs of arrays and functions of a module in C, in this order."""
    head = [*map(constant_text, named(functions, constants)), ""]
    for statement in lane_structs(functions):
        if head[-1] == "}":
            head[-1] = f"}} {statement}"
        else:
            head.append(f"    {statement}" if statement.endswith("];") else statement)
    head.append("")
    return [Lines(tuple(head), {}), *(part for f in functions for part in pieces(f, functions))]


def pieces(function: Function, among: tuple[Function, ...]) -> list[Lines]:
    """Print the C code of one function, in one piece for each kind of numbers it takes.

    `_discriminant` is printed twice, for two kinds of numbers.
    """
    return [_framed(frame) for frame in frames_of(function, among)]


def _framed(frame: Frame) -> Lines:
    head, *before = frame.before
    begin, _, parameters = head.removesuffix(") {").partition("(")
    inside = ",\n    ".join(map(", ".join, batched(parameters.split(", "))))
    text = [f"/* {frame.function.summary} */", *f"{begin}({inside})".split("\n"), "{"]
    for statement in before:
        text.append(f"{_indent(text)}{statement}")
    indent, ends = _indent(text), []
    for statement in frame.after:
        indent = indent.removesuffix("    ") if statement == "}" else indent
        ends.append(f"{indent}{statement}")
    return function_lines(frame.function, frame.number, text, [*ends, ""])


def branch_struct(function: Function) -> str:
    """Print the C struct for a function's constants."""
    lines = [f"    double {', '.join(row)};" for row in batched(flat_results(function))]
    return "\n".join(["typedef struct {", *lines, f"}} torque_free_{branch(function)};"])


def batched(items: list[str], width: int = 84) -> list[list[str]]:
    """Split a list of strings into rows that stay below a width."""
    rows: list[list[str]] = [[]]
    for item in items:
        if rows[-1] and len(", ".join([*rows[-1], item])) > width:
            rows.append([])
        rows[-1].append(item)
    return rows
