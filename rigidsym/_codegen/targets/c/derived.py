"""Derived functions as C routines: parameters, loads of arguments, and stores of results.

A function of one motion takes parameters, or reads arrays by index and a struct of constants.  A
function of several bodies side by side is a loop over the members of structs of arrays: an extended
number is two members, `<name>_hi` and `<name>_lo`, and a function that takes it as a double reads
the first.  The constants of motions have structs of their own, in the order of one motion's.

Functions of steps take the number of bodies.  Those of motions fill all lanes, as many as a
register holds, even for one motion: for functions this long a compiler should emit vector
code only, without a scalar copy.
"""

import ast
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from rigidsym._codegen.ir import Function
from rigidsym._codegen.lines import flat_results
from rigidsym._codegen.passes import fuse
from rigidsym._codegen.routines import (
    DOUBLE,
    PAIR,
    SIZE,
    Field,
    Routine,
    Struct,
    Type,
    assignments,
    declaration,
    statement,
)

_MOTIONS = ("_initial_state", "_circular_constants", "_hyperbolic_constants")


def branch(function: Function) -> str:
    """Return the branch of a function, the first word of its name."""
    return function.name.split("_")[1]


def routines(functions: tuple[Function, ...]) -> Iterator[Routine]:
    """Yield the routines of derived functions in order."""
    extended = pairs(functions)
    for function in functions:
        for one in _of(function, functions, extended):
            yield replace(one, function=one.function or function)


def _of(
    function: Function, functions: tuple[Function, ...], extended: frozenset[str]
) -> Iterator[Routine]:
    name = function.name[1:]
    if takes_several(function):
        yield _side_by_side(function, extended)
    elif name == "discriminant":
        yield from discriminants(function)
    elif function.rounds:
        yield constants_of(function)
    elif name.endswith(("_angles", "_state")):
        (constants,) = (f for f in functions if f.name == f"_{branch(function)}_constants")
        yield _loop(function, {*flat_results(constants)})
    else:
        yield plain(function)


def discriminants(function: Function) -> Iterator[Routine]:
    """Yield the discriminant of pairs, and that of exact numbers."""
    every = replace(function, extended=frozenset(function.parameters))
    yield _valued(f"{function.name[1:]}_dd", every, PAIR)
    yield _valued(f"{function.name[1:]}_exact", every, Type("exact"))


def plain(function: Function) -> Routine:
    """Return a derived function as a routine that returns its results."""
    if len(function.results) > 1:
        return _handing_out(function)
    if function.extended:
        return _valued(function.name[1:], function, PAIR)
    return _valued(function.name[1:], function, DOUBLE, frozenset(("inline",)))


def _parameters(function: Function, extended: Type = PAIR) -> dict[str, Type]:
    return {name: extended if name in function.extended else DOUBLE for name in function.parameters}


def _valued(
    name: str, function: Function, kind: Type, marks: frozenset[str] = frozenset()
) -> Routine:
    number = "exact" if kind.name == "exact" else "pair"
    body = assignments(function, fuse(function), number)
    body.append(ast.Return(ast.Name(function.results[0], ast.Load())))
    parameters = _parameters(function, kind)
    return Routine(
        name, function.summary, parameters, (kind,), tuple(body), marks, function=function
    )


def _handing_out(function: Function) -> Routine:
    extended = function.all_extended()
    kinds = tuple(PAIR if result in extended else DOUBLE for result in function.results)
    values: list[ast.expr] = [ast.Name(result, ast.Load()) for result in function.results]
    body = [*assignments(function, fuse(function)), ast.Return(ast.Tuple(values, ast.Load()))]
    return Routine(
        function.name[1:],
        function.summary,
        _parameters(function),
        kinds,
        tuple(body),
        names=function.results,
    )


def constants_of(function: Function) -> Routine:
    """Return a derived function as a routine that stores a motion's constants in a struct."""
    stores = [statement(f"motion.{name} = {value}") for name, value in stored(function).items()]
    struct = Type(branch(function), is_out=True)
    body = (*assignments(function, fuse(function)), *stores)
    parameters = {**_parameters(function), "motion": struct}
    return Routine(function.name[1:], function.summary, parameters, (), body)


def stored(function: Function) -> dict[str, str]:
    """Map each double that a function's results are stored as to its value."""
    extended, values = function.all_extended(), {}
    for result in function.results:
        if result in _split(function):
            values |= {f"{result}_hi": f"{result}.hi", f"{result}_lo": f"{result}.lo"}
        else:
            values[result] = f"rounded({result})" if result in extended else result
    return values


def _loop(function: Function, members: set[str]) -> Routine:
    """Return the routine of a loop over arrays of time-dependent arguments.

    Constants are read from a struct.
    """
    used = function.used()
    changing = [x for x in function.parameters if x not in members]
    kept = [x for x in function.parameters if x in members and x in used]
    row = Type("double", ("...",))
    parameters = {"motion": Type(branch(function)), "n": SIZE}
    parameters |= {f"{x}_in": row for x in changing}
    parameters |= {f"{x}_out": replace(row, is_out=True) for x in function.results}
    inside: list[ast.stmt] = [declaration(x, "double", f"{x}_in[i]") for x in changing]
    inside += assignments(function, fuse(function))
    inside += [statement(f"{x}_out[i] = {x}") for x in function.results]
    body = [declaration(x, "double", f"motion.{x}") for x in kept]
    return Routine(function.name[1:], function.summary, parameters, (), (*body, _over("n", inside)))


def _over(count: str, inside: list[ast.stmt]) -> ast.stmt:
    """Return a loop over the places in arrays."""
    loop = statement(f"for i in range({count}): pass")
    assert isinstance(loop, ast.For)
    loop.body = inside
    return loop


# --- several bodies side by side


def takes_several(function: Function) -> bool:
    """Return True if a generated C function handles several bodies at once."""
    return _is_step(function) or function.name in _MOTIONS


def _is_step(function: Function) -> bool:
    return function.name.startswith("_step_")


def has_struct(function: Function) -> bool:
    """Return True if the results of a function are the constants of a branch."""
    return function.name.endswith("_constants")


def pairs(functions: Iterable[Function]) -> frozenset[str]:
    """Return the names of numbers that functions for several bodies hold as pairs of doubles."""
    own = filter(takes_several, functions)
    return frozenset(name for f in own for name in (*f.extended, *_split(f)))


def _split(function: Function) -> frozenset[str]:
    """Return the names of a function's results that are stored as two doubles."""
    if function.rounds:
        return function.split
    return function.all_extended() & {*function.results}


def _flat(names: Iterable[str], extended: frozenset[str]) -> Iterator[str]:
    """Yield the names of struct members, two for each extended number."""
    for name in names:
        yield from (f"{name}_hi", f"{name}_lo") if name in extended else (name,)


def _side_by_side(function: Function, extended: frozenset[str]) -> Routine:
    """Return the routine of a loop that handles several bodies side by side."""
    is_step = _is_step(function)
    place, marks = ("x", frozenset()) if is_step else ("lane", frozenset(("flat",)))
    to = "motion" if has_struct(function) else place
    parameters: dict[str, Type] = {"n": SIZE} if is_step else {}
    if has_struct(function):
        parameters["lane"] = Type("lanes", is_alone=True)
        parameters["motion"] = Type(f"{branch(function)}_lanes", is_out=True, is_alone=True)
    else:
        parameters[place] = Type("lanes", is_out=True)
    inside: list[ast.stmt] = []
    for x in function.parameters:
        if x in function.extended:
            inside.append(declaration(x, "pair", f"pair({place}.{x}_hi[i], {place}.{x}_lo[i])"))
        else:
            name = f"{x}_hi" if x in extended else x
            inside.append(declaration(x, "double", f"{place}.{name}[i]"))
    inside += assignments(function, fuse(function))
    inside += [statement(f"{to}.{name}[i] = {value}") for name, value in stored(function).items()]
    loop = _over("n" if is_step else "LANES", inside)
    return Routine(function.name[1:], function.summary, parameters, (), (loop,), marks)


def members(functions: tuple[Function, ...]) -> list[str]:
    """Return the members of the struct for several bodies, in the order of their first use."""
    extended, found = pairs(functions), dict[str, None]()
    for function in filter(takes_several, functions):
        found |= dict.fromkeys(_flat(function.parameters, extended))
        if not has_struct(function):
            found |= dict.fromkeys(_flat(function.results, _split(function)))
    return list(found)


def structs(functions: tuple[Function, ...]) -> Iterator[Struct]:
    """Yield the structs of derived functions: constants, and arrays for several bodies."""
    several = tuple(filter(takes_several, functions))
    of_steps = any(map(_is_step, several))
    for function in functions:
        if function.rounds and not of_steps:
            yield _struct(branch(function), dict.fromkeys(flat_results(function), DOUBLE), True)
    # `turned` is the runtime's: -1 where a and d have changed places.
    more = ("turned",) if of_steps else ()
    lane = Type("double", ("LANES",))
    yield _struct("lanes", dict.fromkeys((*members(functions), *more), lane))
    for function in filter(has_struct, several):
        yield _struct(f"{branch(function)}_lanes", dict.fromkeys(flat_results(function), lane))


def _struct(name: str, members: Mapping[str, Type], is_public: bool = False) -> Struct:
    fields = tuple(Field(member, type_) for member, type_ in members.items())
    return Struct(name, "", fields, is_public)
