"""Programs that compute one body and one time after another, without lanes and blocks.

Derived functions are routines with plain arguments and tuples as results.  Those of a branch at a
time read its constants from a struct, and `_<branch>_constants` writes these.
"""

import ast
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.forms import PI, STEP, THETA
from rigidsym._codegen.header import DIGEST
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.lines import flat_results
from rigidsym._codegen.passes import fuse
from rigidsym._codegen.routines import (
    DOUBLE,
    PAIR,
    Program,
    Routine,
    Type,
    assignments,
    declaration,
    lowered,
    read,
    statement,
)
from rigidsym._codegen.targets.c import codes, derived
from rigidsym._codegen.targets.c.program import named_numbers

_MOTIONS = ("arithmetic", "exact", "bodies", "decisions", "one_by_one", "messages")
RUNTIMES = {
    THETA: _MOTIONS,
    PI: _MOTIONS,
    STEP: ("arithmetic", "bodies", "step_decisions", "steps_one_by_one", "messages"),
}


def program(
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
    binary: Format = BINARY64,
    brought: Collection[str] = (),
    more: Sequence[str] = (),
) -> Program:
    """Return all that a module without lanes and blocks has, in an order of use.

    brought: names of routines that the target's own text has.  It defines ALLOW_NONPHYSICAL, too.
    more: files of runtimes that have what the target's language lacks.
    """
    own = {one.name: one for one in routines(functions)}
    made = Program(enumerations={"codes": codes.enumeration(form)})
    made.known = {name: Type("int") for name in codes.names(form)}
    made.known["ALLOW_NONPHYSICAL"] = Type("bool")
    made.numbers = named_numbers(constants, form, binary)
    made.structs = {one.name: one for one in derived.structs(functions)}
    known = {**binary.numbers(), "DIGEST": DIGEST}
    made = read((*RUNTIMES[form], *more), replace(made, routines=own), known)
    for name, (value, meaning) in binary.arithmetic().items():
        number = made.numbers[name]
        made.numbers[name] = replace(number, value=ast.Constant(value), comment=meaning)
    used = own.keys() & made.without_idle().routines.keys()
    branches = {one.name.removesuffix("_constants") for name, one in own.items() if name in used}
    made.routines = {
        name: lowered(one, made) if name in own else one
        for name, one in made.routines.items()
        if (name in used or name not in own) and name not in brought
    }
    from_functions = {one.name for one in derived.structs(functions)}
    made.structs = {
        name: one
        for name, one in made.structs.items()
        if name in branches or name not in from_functions
    }
    return made.without_idle().in_order()


def routines(functions: tuple[Function, ...]) -> Iterator[Routine]:
    """Yield the routines of derived functions in order."""
    for function in functions:
        for one in _of(function, functions):
            yield replace(one, function=one.function or function)


def _of(function: Function, functions: tuple[Function, ...]) -> Iterator[Routine]:
    name = function.name[1:]
    if name == "discriminant":
        yield from derived.discriminants(function)
    elif derived.has_struct(function) and function.rounds:
        yield derived.constants_of(function)
    elif name.endswith(("_angles", "_state")) and name != "initial_state":
        (constants,) = (
            one for one in functions if one.name == f"_{derived.branch(function)}_constants"
        )
        yield _at_a_time(function, {*flat_results(constants)})
    elif function.rounds:
        yield _rounding(function)
    else:
        yield derived.plain(function)


def _at_a_time(function: Function, members: set[str]) -> Routine:
    """Return a derived function of a time, which reads constants from a struct."""
    used = function.used()
    changing = [name for name in function.parameters if name not in members]
    kept = [name for name in function.parameters if name in members and name in used]
    one = derived.plain(function)
    loads = (declaration(name, "double", f"motion.{name}") for name in kept)
    parameters = {"motion": Type(derived.branch(function))} | dict.fromkeys(changing, DOUBLE)
    return replace(one, parameters=parameters, body=(*loads, *one.body))


def _rounding(function: Function) -> Routine:
    """Return a derived function whose results are pairs where these are split, else rounded."""
    extended = function.all_extended()
    values = [
        f"rounded({name})" if name in extended - function.split else name
        for name in function.results
    ]
    results = tuple(PAIR if name in function.split else DOUBLE for name in function.results)
    body = (*assignments(function, fuse(function)), statement(f"return {', '.join(values)}"))
    return replace(derived.plain(function), results=results, body=body)
