"""Programs of the C target: derived functions and runtime of a form, ready to be printed."""

import ast
from dataclasses import replace
from functools import cache

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.forms import PI, STEP, THETA, limits
from rigidsym._codegen.header import DIGEST
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.routines import (
    DOUBLE,
    Number,
    Program,
    Type,
    defined,
    lowered,
    numbered,
    read,
)
from rigidsym._codegen.targets.c import codes, derived
from rigidsym._codegen.targets.c.pointers import with_pointers

_ARITHMETIC = ("arithmetic", "self_test")
_MOTIONS = (*_ARITHMETIC, "motion_self_test", "exact", "bodies", "decisions", "motion")
_RUNTIMES = {
    THETA: (*_MOTIONS, "sensitivity", "messages"),
    PI: (*_MOTIONS, "messages"),
    STEP: (
        *(*_ARITHMETIC, "step_self_test", "bodies", "step_decisions"),
        *("step", "kick", "messages"),
    ),
}
# From which branch on a grid is computed one time after the other.
_ONE_BY_ONE = {THETA: 2, PI: 1, STEP: 0}
# What macros of the preamble define, and their types.
_MACROS = {"BLOCK": "size", "LANES": "size", "ALLOW_NONPHYSICAL": "bool", "BITS_ARE_CHOSEN": "bool"}
_SAID = ("message", "field", "rule", "digest")


def program(
    functions: tuple[Function, ...], constants: tuple[Constant, ...], form: str = THETA
) -> Program:
    """Return all that the C module of a form has, in an order that C can read."""
    made = Program(known={name: Type(kind) for name, kind in _MACROS.items()})
    made.enumerations["codes"] = codes.enumeration(form)
    made.known |= {name: Type("int") for name in codes.names(form)}
    made.structs = {struct.name: struct for struct in derived.structs(functions)}
    made.numbers = named_numbers(constants, form)
    made.routines = {one.name: one for one in derived.routines(functions)}
    own = made.routines
    made = read(
        _RUNTIMES[form],
        made,
        {
            **BINARY64.numbers(),
            "ONE_BY_ONE": _ONE_BY_ONE[form],
            "THETA": form == THETA,
            "DIGEST": DIGEST,
        },
    )
    made.routines |= {name: lowered(one, made) for name, one in own.items()}
    if form == STEP:
        made.routines = {
            f"step_{name}" if name in _SAID else name: replace(one, name=f"step_{name}")
            if name in _SAID
            else one
            for name, one in made.routines.items()
        }
    for enumeration in made.enumerations.values():
        made.names |= {x.name: f"TORQUE_FREE_{x.name}" for x in enumeration.numbers}
    made.names |= codes.names(form)
    return with_pointers(made.without_idle(arithmetic()).in_order())


@cache
def arithmetic() -> tuple[str, ...]:
    """Return the names of the routines of the arithmetic that all forms share, in their order."""
    return tuple(defined(_ARITHMETIC))


def named_numbers(
    constants: tuple[Constant, ...], form: str, binary: Format = BINARY64
) -> dict[str, Number]:
    """Map the names of a form's constants, limits and messages to their definitions."""
    found = [numbered(constant) for constant in constants]
    for limit in limits(form, binary):
        value, meaning = ast.Constant(2.0**limit.exponent), f"2^{limit.exponent}, {limit.meaning}"
        found.append(Number(limit.name, DOUBLE, value, meaning))
    return {one.name: one for one in (*found, *codes.texts(form))}
