"""Faults drawn from what is printed: one change in the tree of a let, or in a named number.

A change leaves a double a double and an extended number one, so that no other line changes.  Of a
form that is not the default they are drawn from what that one does not print.
"""

import math
import struct
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from hashlib import sha256

from rigidsym.codegen.forms import STEP, THETA, split
from rigidsym.codegen.functions import constants, functions
from rigidsym.codegen.functions.sensitivity import sensitivity
from rigidsym.codegen.ir import Constant, Function, Let, is_extended
from rigidsym.codegen.lines import Lines
from rigidsym.codegen.special_functions import angles
from rigidsym.codegen.targets.c import emit as c
from rigidsym.codegen.targets.c import lanes, module
from rigidsym.codegen.targets.numpy import emit as numpy
from rigidsym.language.expression import (
    Call,
    Expression,
    Number,
    Operation,
    children,
    rebuild,
)
from rigidsym.solution import sealed
from rigidsym.validate.bounds import BOUND, ULP
from rigidsym.validate.faults.fault import Fault

# A kind of fault, what is done, and the expression then.
Change = tuple[str, str, Expression]
# Calls without what they do.
_IDLE = {"alternating": ("winding", 1), "nearest": ("winding", 0), "product_error": ("pair", 0)}
# How many faults of each kind are drawn for a target.
EACH = 5
# Of all faults that can be drawn, those that no motion can show, and why.
HARMLESS = {
    "turned_other of hyperbolic_angles: a term dropped (2)": "a sum's error, near enough",
    "j_whole of hyperbolic_angles: nearest forgotten (1)": "turns stay with the rest",
    "L_whole of hyperbolic_angles: nearest forgotten (1)": "turns stay with the rest",
    "turned_whole of hyperbolic_angles: nearest forgotten (1)": "turns stay with the rest",
    "high of third_kind: a term dropped (4)": "degree six of R_J, after four duplications",
    **{
        f"least_c {done}": "below every cosine but 0"
        for done in ("off by 1e-12", "in single precision")
    },
    "deepest off by 1e-12": "the exponential of that has vanished",
    "tail of half_turns: doubled (4)": "4e-22 of an angle",
    "tail of half_turns: a sign turned (13)": "1e-27 of an angle",
    "pi_lo off by 1e-12": "1e-28 of an angle below 1/2",
    "log_2_rest in single precision": "6e-18 of an exponent for each half that is taken off",
    "log_2_inverse off by 1e-12": "the other of two whole numbers that are equally near",
    "tail of logarithm: a term dropped (22)": "4e-34 of a logarithm",
    "c_7_re of step_first: a term dropped (3)": "X^14 at a 32nd of the time, below 1e-12 of J",
    "d_10 of step_first: doubled (7)": "X^20 at a 32nd of the time, below 1e-17 of J",
    **{
        f"J_im of step_first: {done}": "X^14 or more at a 32nd of the time, below 1e-12 of J"
        for done in ("a term dropped (39)", "doubled (51)")
    },
    "E_im of step_first: a sign turned (6)": "the fifth power of an angle below 2e-3",
    "more_X of step_start: a term dropped (92)": "the 14th power of an angle below 1/4, over 3e6",
    "more_Y of step_start: a sign turned (67)": "the 14th power of an angle below 1/4, over 1e5",
    "C_5 of hyperbolic_constants: a sign turned (1)": "is times the nome to the 30th, below 2e-41",
    "zeta of hyperbolic_constants: doubled (26)": "the nome to the 30th, below 2e-41",
    **{
        f"{name} of {x}_constants: {done}": "in a term that is 1e-13 of a column, p t^2 below 1/16"
        for x, name, done in (
            ("imaginary", "E_square_9", "doubled (30)"),
            ("imaginary", "F_square_7", "a sign turned (2)"),
            ("imaginary", "F_square_7", "doubled (22)"),
            ("imaginary", "F_square_9", "a sign turned (13)"),
        )
    },
    "behind_error of imaginary_angles: product_error forgotten (4)": (
        "1e-16 of what whole turns have added by then"
    ),
    "sum_even of real_state: a sign turned (5)": "is times the nome to the 16th, below 2e-22",
    **{
        f"c_{k} of circulation: a term dropped ({n})": "what is not zero still is not"
        for k, n in ((1, 2), (1, 3), (2, 2), (2, 3))
    },
}


@dataclass(frozen=True, slots=True)
class _Series:
    """The coefficients of a series: what the k-th is times, at most, and what of the sum is lost:
    no motion can show it."""

    times: Callable[[int], float]
    lost: float


# Rates depend on logarithms: theirs is what after 2^46 rad is the bound of an angle.
_AFTER_ALL_TIME = BOUND / 2**46
_SERIES = {
    "over": _Series(lambda k: float(angles.LARGEST) ** (k - 1), _AFTER_ALL_TIME),
    "sine": _Series(lambda k: 0.5 ** (2 * k + 3), 2 * ULP),
    "cosine": _Series(lambda k: 0.5 ** (2 * k + 2), 2 * ULP),
    "exponential": _Series(lambda k: (math.log(2) / 2) ** (k + 3), 2 * ULP),
}


@dataclass(frozen=True, slots=True)
class _Printer:
    """How a target prints functions, how a function begins, its numbers, and what ends code."""

    lines: Callable[[Function], Lines]
    begins: Callable[[Function], str]
    constant: Callable[[Constant], str]
    note: str

    def code(self, line: str) -> str:
        """A line without the equations behind it."""
        return line.partition(self.note)[0]


@cache
def _functions(form: str) -> tuple[Function, ...]:
    return functions(sealed(), form)


def _own(target: str, in_sensitivities: bool) -> tuple[tuple[Function, ...], set[str]]:
    """Functions that faults of a target's states, or of its sensitivities, are drawn from, and the
    named numbers that they alone use."""
    language, form = split(target)
    names = {function.name for function in sensitivity(sealed())}
    of_states = tuple(one for one in _functions(form) if one.name not in names)
    if in_sensitivities:
        own = tuple(one for one in _functions(form) if one.name in names)
        shared = of_states
    else:
        shared = _functions(THETA) if form != THETA else ()
        own = tuple(one for one in of_states if one not in shared)
    own = numpy.own(own) if language == "numpy" else own
    return own, _used(own) - _used(shared)


def _used(functions: tuple[Function, ...]) -> set[str]:
    return {name for function in functions for name in function.used()}


def _definition(function: Function) -> str:
    return f"def {function.name}("


def _printer(target: str) -> _Printer:
    language, form = split(target)
    if language == "numpy":
        return _Printer(numpy.function_lines, _definition, numpy.constant_text, "  #")

    def lines(function: Function) -> Lines:
        printed = c.pieces(function, _functions(form))[0]
        return replace(printed, text=tuple(module.named(line, form) for line in printed.text))

    def first_line(function: Function) -> str:
        if form == STEP:
            return lanes.frame(function, frozenset()).before[0].removesuffix(" {")
        return next(line for line in lines(function).text if line.startswith("static "))

    return _Printer(lines, first_line, c.constant_text, " /*")


@cache
def drawn(target: str) -> tuple[Fault, ...]:
    """The first EACH of each kind, but for those that are harmless."""
    return tuple(fault for fault in first(target) if fault.name not in HARMLESS)


def first(target: str) -> tuple[Fault, ...]:
    """The first EACH faults of each kind in states, and in sensitivities."""
    counts, chosen = Counter[tuple[str, bool]](), []
    for fault in every(target):
        kind = fault.kind, fault.in_sensitivities
        counts[kind] += 1
        if counts[kind] <= EACH:
            chosen.append(fault)
    return tuple(chosen)


@cache
def every(target: str) -> tuple[Fault, ...]:
    """All faults of a target's module that are one change of a let or of a named number.

    Their order is by their names, as good as random: how they are printed does not move them.
    """
    found = (*_of_part(target, False), *_of_part(target, True))
    return tuple(sorted(found, key=lambda fault: sha256(fault.line.encode()).digest()))


def _of_part(target: str, in_sensitivities: bool) -> Iterator[Fault]:
    """Those in states, or in sensitivities."""
    printer, (own, used) = _printer(target), _own(target, in_sensitivities)
    found = [fault for function in own for fault in _of_function(target, printer, function)]
    found += [
        fault
        for constant in constants()
        if constant.name in used
        for fault in _of_constant(target, printer, constant)
    ]
    return (replace(fault, in_sensitivities=in_sensitivities) for fault in found)


def _of_function(target: str, printer: _Printer, function: Function) -> Iterator[Fault]:
    begins, extended = printer.begins(function), function.all_extended()
    alone = replace(function, extended=extended)
    found: list[tuple[str, str, str, Let]] = []
    for let, old in zip(function.lets, _lines(printer, alone, function.lets), strict=True):
        for number, (kind, done, changed) in enumerate(changes(let.expression), 1):
            # Of what decides the circulation, twice a quantity decides the same.
            idle = (function.name, kind) == ("_circulation", "scale")
            if is_extended(changed, extended) == is_extended(let.expression, extended) and not idle:
                name = f"{', '.join(let.targets)} of {function.name[1:]}: {done} ({number})"
                found.append((kind, name, old, replace(let, expression=changed)))
    changed_lets = tuple(let for *_, let in found)
    for (kind, name, old, _), new in zip(found, _lines(printer, alone, changed_lets), strict=True):
        if new != old:
            yield Fault(target, kind, name, begins, old, new)


def _lines(printer: _Printer, function: Function, lets: tuple[Let, ...]) -> list[str]:
    """Return the line of each let, as the function prints it in place of its own lets."""
    printed = printer.lines(replace(function, lets=lets))
    return [printer.code(printed.text[number]) for number in printed.lets]


def changes(expression: Expression) -> Iterator[Change]:
    """Every way to change one place of an expression.

    >>> from rigidsym.language.expression import parse, to_text
    >>> [to_text(changed) for _, _, changed in changes(parse("-x + 2*y"))]
    ['-x - 2 * y', '-x', '2 * y', 'x + 2 * y', '-x + 2 * (2 * y)']
    """
    yield from _at_the_top(expression)
    parts = children(expression)
    for k, part in enumerate(parts):
        for kind, done, changed in changes(part):
            yield kind, done, rebuild(expression, (*parts[:k], changed, *parts[k + 1 :]))


def _at_the_top(expression: Expression) -> Iterator[Change]:
    match expression:
        case Operation("+", left, right):
            yield "sign", "a sign turned", Operation("-", left, right)
            yield "series", "a term dropped", left
            yield "series", "a term dropped", right
        case Operation("-", left, right):
            yield "sign", "a sign turned", Operation("+", left, right)
            yield "series", "a term dropped", left
        case Operation("*", _, _):
            yield "scale", "doubled", Operation("*", Number(2), expression)
        case Operation("/", left, right):
            yield "scale", "turned over", Operation("/", right, left)
        case Call("neg", (operand,)):
            yield "sign", "a sign turned", operand
        case Call("choose", (x, y, one, other)):
            yield "branch", "the other choice", Call("choose", (x, y, other, one))
        case Call(function, _) if function in _IDLE:
            kind, value = _IDLE[function]
            yield kind, f"{function} forgotten", Number(value)
        case Call(function, (first, second, *rest)):
            yield "axis", "arguments swapped", Call(function, (second, first, *rest))


def _of_constant(target: str, printer: _Printer, constant: Constant) -> Iterator[Fault]:
    changed = [("constant", "off by 1e-12", replace(constant, hi=constant.hi * (1 + 1e-12)))]
    (single,) = struct.unpack("f", struct.pack("f", constant.hi)) if constant.hi < 1e38 else (0.0,)
    changed.append(("precision", "in single precision", replace(constant, hi=single)))
    if constant.lo is not None:
        changed.append(("constant", "its last digits lost", replace(constant, lo=0.0)))
    old = printer.code(printer.constant(constant))
    for kind, done, other in changed:
        new = printer.code(printer.constant(other))
        if new != old and not is_lost(constant, other):
            yield Fault(target, kind, f"{constant.name} {done}", old, old, new)


def is_lost(constant: Constant, other: Constant) -> bool:
    """Whether a coefficient of a series may as well be another: its sum is the same to all digits
    that a motion can show."""
    family, _, number = constant.name.rpartition("_")
    if family not in _SERIES:
        return False
    change = (other.hi - constant.hi) + ((other.lo or 0.0) - (constant.lo or 0.0))
    series = _SERIES[family]
    return abs(change) * series.times(int(number)) < series.lost
