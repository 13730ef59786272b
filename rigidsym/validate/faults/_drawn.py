"""Faults drawn from derived code: one change in the expression of a let, or of a constant.

A change leaves a double a double and an extended number one, so that no other line changes.  For a
form that is not the default, faults are drawn from the lines that the default does not print.
"""

import math
import struct
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from hashlib import sha256
from importlib import resources
from itertools import chain
from textwrap import shorten
from typing import NamedTuple

from rigidsym._codegen.forms import STEP, THETA, split
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.functions.sensitivity import sensitivity
from rigidsym._codegen.ir import Constant, Function, Let, is_extended
from rigidsym._codegen.lines import Lines
from rigidsym._codegen.special_functions import angles
from rigidsym._codegen.targets.c import emit as c
from rigidsym._codegen.targets.c import frames, module
from rigidsym._codegen.targets.numpy import emit as numpy
from rigidsym.language._expression import (
    Call,
    Expression,
    Number,
    Operation,
    children,
    rebuild,
    to_text,
)
from rigidsym.solution import sealed
from rigidsym.validate._bounds import BOUND, ULP
from rigidsym.validate.faults._fault import BY_HAND, FILES, Fault

# Calls whose value is replaced by a constant, and the kind of fault that makes.
_IDLE = {"alternating": ("winding", 1), "nearest": ("winding", 0), "product_error": ("pair", 0)}
# How many faults of each kind are drawn for a target.
EACH = 5
# Parts of expressions are shortened to this length where faults are named by them.
_SHOWN = 50
_TABLE = resources.files("rigidsym.validate.faults").joinpath("harmless.toml").read_text("utf-8")
# Drawn faults that no motion can show, with the reason, by `Fault.change`.
HARMLESS = {change: why for why, listed in tomllib.loads(_TABLE).items() for change in listed}


class Change(NamedTuple):
    """Change of an expression, with its kind and description."""

    kind: str
    done: str
    expression: Expression
    part: Expression


# For coefficients of series: the largest factor of the k-th, and the error of the sum that no
# motion can show.  Rates depend on logarithms, whose errors grow to the bound of an angle in
# 2^46 rad.
_SERIES: dict[str, tuple[Callable[[int], float], float]] = {
    "over": (lambda k: float(angles.LARGEST) ** (k - 1), BOUND / 2**46),
    "sine": (lambda k: 0.5 ** (2 * k + 3), 2 * ULP),
    "cosine": (lambda k: 0.5 ** (2 * k + 2), 2 * ULP),
    "exponential": (lambda k: (math.log(2) / 2) ** (k + 3), 2 * ULP),
}


@dataclass(frozen=True, slots=True)
class _Printer:
    """Printer of a target's functions and constants."""

    lines: Callable[[Function], Lines]
    begins: Callable[[Function], str]
    constant: Callable[[Constant], str]
    note: str

    def code(self, line: str) -> str:
        """Return a line without its comment on equations."""
        return line.partition(self.note)[0]


@cache
def _functions(form: str) -> tuple[Function, ...]:
    return functions(sealed(), form)


def _own(target: str, in_sensitivities: bool) -> tuple[tuple[Function, ...], set[str]]:
    """Return the functions in which faults of states, or of sensitivities, are drawn.

    The second result has the named numbers that these functions alone use.
    """
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
    used, elsewhere = (set(chain.from_iterable(x.used() for x in y)) for y in (own, shared))
    return own, used - elsewhere


def _printer(target: str) -> _Printer:
    language, form = split(target)
    if language == "numpy":
        return _Printer(
            numpy.function_lines, lambda x: f"def {x.name}(", numpy.constant_text, "  #"
        )

    def lines(function: Function) -> Lines:
        printed = c.pieces(function, _functions(form))[0]
        return replace(printed, text=tuple(module.named(line, form) for line in printed.text))

    def first_line(function: Function) -> str:
        if form == STEP:
            return next(frames.frames_of(function, (function,))).before[0].removesuffix(" {")
        return next(line for line in lines(function).text if line.startswith("static "))

    return _Printer(lines, first_line, c.constant_text, " /*")


@cache
def all_faults() -> tuple[Fault, ...]:
    """Return the faults by hand and the drawn ones; drawing takes a second or two."""
    return (*BY_HAND, *(fault for target in FILES for fault in drawn(target)))


@cache
def drawn(target: str) -> tuple[Fault, ...]:
    """Return up to EACH faults of each kind that are not harmless."""
    counts, chosen = Counter[tuple[str, bool]](), []
    for fault in every(target):
        kind = fault.kind, fault.in_sensitivities
        counts[kind] += 1
        if counts[kind] <= EACH and fault.change not in HARMLESS:
            chosen.append(fault)
    return tuple(chosen)


@cache
def every(target: str) -> tuple[Fault, ...]:
    """Return all faults of a target's module that change one let or one named number.

    Their order is by a hash of their names: it does not depend on how they are printed.
    """
    found = []
    for in_sensitivities in (False, True):
        printer, (own, used) = _printer(target), _own(target, in_sensitivities)
        part = [fault for function in own for fault in _of_function(target, printer, function)]
        for constant in constants():
            if constant.name in used:
                part += _of_constant(target, printer, constant)
        found += [replace(fault, in_sensitivities=in_sensitivities) for fault in part]
    return tuple(sorted(found, key=lambda fault: sha256(fault.line.encode()).digest()))


def _of_function(target: str, printer: _Printer, function: Function) -> Iterator[Fault]:
    begins, extended = printer.begins(function), function.all_extended()
    alone = replace(function, extended=extended)
    found: list[tuple[Change, str, str, Let]] = []
    for let, old in zip(function.lets, _lines(printer, alone, function.lets), strict=True):
        about = f"{', '.join(let.targets)} of {function.name[1:]}"
        for number, change in enumerate(changes(let.expression), 1):
            changed = change.expression
            # Twice a quantity decides the circulation as the quantity does.
            idle = (function.name, change.kind) == ("_circulation", "scale")
            if is_extended(changed, extended) == is_extended(let.expression, extended) and not idle:
                name = f"{about}: {change.done} ({number})"
                found.append((change, name, old, replace(let, expression=changed)))
    changed_lets = tuple(let for *_, let in found)
    for (change, name, old, _), new in zip(
        found, _lines(printer, alone, changed_lets), strict=True
    ):
        if new != old:
            part = shorten(to_text(change.part), _SHOWN, placeholder=" ...")
            key = f"{name.rpartition(' (')[0]}: {part}"
            yield Fault(target, change.kind, name, begins, old, new, change=key)


def _lines(printer: _Printer, function: Function, lets: tuple[Let, ...]) -> list[str]:
    """Return the printed line of each of these lets in place of a function's own."""
    printed = printer.lines(replace(function, lets=lets))
    return [printer.code(printed.text[number]) for number in printed.lets]


def changes(expression: Expression) -> Iterator[Change]:
    """Yield every way to change one place of an expression.

    >>> from rigidsym.language._expression import parse, to_text
    >>> [to_text(change.expression) for change in changes(parse("-x + 2*y"))]
    ['-x - 2 * y', '-x', '2 * y', 'x + 2 * y', '-x + 2 * (2 * y)']
    """
    yield from _at_the_top(expression)
    parts = children(expression)
    for k, part in enumerate(parts):
        for change in changes(part):
            whole = rebuild(expression, (*parts[:k], change.expression, *parts[k + 1 :]))
            yield change._replace(expression=whole)


def _at_the_top(expression: Expression) -> Iterator[Change]:
    match expression:
        case Operation("+", left, right):
            yield Change("sign", "a sign turned", Operation("-", left, right), right)
            yield Change("series", "a term dropped", left, right)
            yield Change("series", "a term dropped", right, left)
        case Operation("-", left, right):
            yield Change("sign", "a sign turned", Operation("+", left, right), right)
            yield Change("series", "a term dropped", left, right)
        case Operation("*", _, _):
            doubled = Operation("*", Number(2), expression)
            yield Change("scale", "doubled", doubled, expression)
        case Operation("/", left, right):
            yield Change("scale", "turned over", Operation("/", right, left), expression)
        case Call("neg", (operand,)):
            yield Change("sign", "a sign turned", operand, expression)
        case Call("choose", (x, y, one, other)):
            chosen = Call("choose", (x, y, other, one))
            yield Change("branch", "the other choice", chosen, expression)
        case Call(function, _) if function in _IDLE:
            kind, value = _IDLE[function]
            yield Change(kind, f"{function} forgotten", Number(value), expression)
        case Call(function, (first, second, *rest)):
            swapped = Call(function, (second, first, *rest))
            yield Change("axis", "arguments swapped", swapped, expression)


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
            name = f"{constant.name} {done}"
            yield Fault(target, kind, name, old, old, new, change=name)


def is_lost(constant: Constant, other: Constant) -> bool:
    """Return True if a change of a series coefficient is too small for any motion to show."""
    family, _, number = constant.name.rpartition("_")
    if family not in _SERIES:
        return False
    change = (other.hi - constant.hi) + ((other.lo or 0.0) - (constant.lo or 0.0))
    factor, lost = _SERIES[family]
    return abs(change) * factor(int(number)) < lost
