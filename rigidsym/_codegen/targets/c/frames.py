"""Frames of generated C functions: heads, loads of arguments, and stores of results.

A function of one motion takes parameters, or reads arrays by index and a struct of constants.  A
function of several bodies side by side is a loop over the members of structs of arrays: an extended
number is two members, `<name>_hi` and `<name>_lo`, and a function that takes it as a double reads
the first.  The constants of motions have structs of their own, in the order of one motion's.

Functions of steps take the number of bodies.  Those of motions fill all lanes, as many as a
register holds, even for one motion: for functions this long a compiler should emit vector
code only, without a scalar copy.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from rigidsym._codegen.ir import Function
from rigidsym._codegen.lines import flat_results

_MOTIONS = ("_initial_state", "_circular_constants", "_hyperbolic_constants")


@dataclass(frozen=True, slots=True)
class Frame:
    """Statements of a C function before and after its derived lines.

    number: the prefix of operations on its extended numbers.
    """

    name: str
    function: Function
    number: str
    before: tuple[str, ...]
    after: tuple[str, ...]


def frames(functions: tuple[Function, ...]) -> Iterator[Frame]:
    """Yield the C frames of all functions in order."""
    for function in functions:
        yield from frames_of(function, functions)


def frames_of(function: Function, among: tuple[Function, ...]) -> Iterator[Frame]:
    """Yield the C frames of one function.

    `_discriminant` has two frames, for two kinds of numbers.
    """
    name = function.name[1:]
    if takes_several(function):
        yield _side_by_side(function, pairs(among))
    elif name == "discriminant":
        every = replace(function, extended=frozenset(function.parameters))
        yield _valued(f"{name}_dd", every, "double_double", "dd")
        yield _valued(f"{name}_exact", every, "exact", "exact")
    elif len(function.results) == 1 and not function.extended:
        yield _valued(name, function, "double", "dd", "static INLINED")
    elif function.rounds:
        yield _constants(name, function)
    elif name.endswith(("_angles", "_state")):
        (constants,) = (f for f in among if f.name == f"_{branch(function)}_constants")
        yield _loop(name, function, {*flat_results(constants)})
    elif len(function.results) == 1:
        yield _valued(name, function, "double_double", "dd")
    else:
        yield _handing_out(name, function)


def branch(function: Function) -> str:
    """Return the branch of a function, the first word of its name."""
    return function.name.split("_")[1]


def struct(function: Function) -> tuple[str, ...]:
    """Return the C statements that declare the struct for a function's constants."""
    members = f"double {', '.join(flat_results(function))};"
    return "typedef struct {", members, "}", f"torque_free_{branch(function)};"


def _head(kind: str, name: str, parameters: Iterable[str]) -> str:
    return f"{kind} {name}({', '.join(parameters)}) {{"


def _given(function: Function, extended: str = "double_double") -> list[str]:
    kinds = {True: extended, False: "double"}
    return [f"{kinds[name in function.extended]} {name}" for name in function.parameters]


def _valued(
    name: str, function: Function, kind: str, number: str, storage: str = "static"
) -> Frame:
    head = _head(f"{storage} {kind}", name, _given(function, kind))
    return Frame(name, function, number, (head,), (f"return {function.results[0]};", "}"))


def _handing_out(name: str, function: Function) -> Frame:
    extended = function.all_extended()
    kinds = {True: "double_double", False: "double"}
    outputs = [f"{kinds[result in extended]} *{result}_out" for result in function.results]
    stores = [f"*{result}_out = {result};" for result in function.results]
    head = _head("static void", name, [*_given(function), *outputs])
    return Frame(name, function, "dd", (head,), (*stores, "}"))


def _constants(name: str, function: Function) -> Frame:
    """Return the frame of a C function that stores a motion's constants in a struct.

    Each result is stored as one or two doubles.
    """
    extended = function.all_extended()
    values: dict[str, str] = {}
    for result in function.results:
        if result in function.split:
            values |= {f"{result}_hi": f"{result}.hi", f"{result}_lo": f"{result}.lo"}
        else:
            values[result] = f"dd_rounded({result})" if result in extended else result
    stores = [f"motion->{member} = {value};" for member, value in values.items()]
    head = _head(
        "static void", name, [*_given(function), f"torque_free_{branch(function)} *motion"]
    )
    return Frame(name, function, "dd", (head,), (*stores, "}"))


def _loop(name: str, function: Function, members: set[str]) -> Frame:
    """Return the frame of a C loop over arrays of time-dependent arguments.

    Constants are read from a struct.
    """
    used = function.used()
    changing = [x for x in function.parameters if x not in members]
    kept = [x for x in function.parameters if x in members and x in used]
    parameters = [f"const torque_free_{branch(function)} *motion", "size_t n"]
    parameters += [f"const double *restrict {x}_in" for x in changing]
    parameters += [f"double *restrict {x}_out" for x in function.results]
    before = [_head("static void", name, parameters)]
    before += [f"const double {x} = motion->{x};" for x in kept]
    before += ["for (size_t i = 0; i < n; i++) {"]
    before += [f"const double {x} = {x}_in[i];" for x in changing]
    stores = [f"{x}_out[i] = {x};" for x in function.results]
    return Frame(name, function, "dd", tuple(before), (*stores, "}", "}"))


# --- several bodies side by side


def takes_several(function: Function) -> bool:
    """Return True if a generated C function handles several bodies at once."""
    return _is_step(function) or function.name in _MOTIONS


def _is_step(function: Function) -> bool:
    return function.name.startswith("_step_")


def _has_struct(function: Function) -> bool:
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


def _side_by_side(function: Function, extended: frozenset[str]) -> Frame:
    """Return the frame of a C loop that handles several bodies side by side."""
    name, is_step, has_struct = function.name[1:], _is_step(function), _has_struct(function)
    place = "x->" if is_step else "lane->"
    if is_step:
        head = _head("static void", name, ("size_t n", "lanes *x"))
    elif has_struct:
        own = f"{branch(function)}_lanes *restrict motion"
        head = _head("static FLAT void", name, ("const lanes *restrict lane", own))
    else:
        head = _head("static FLAT void", name, ("lanes *lane",))
    loop = f"for (size_t i = 0; i < {'n' if is_step else 'LANES'}; i++) {{"
    loads = []
    for x in function.parameters:
        if x in function.extended:
            loads.append(f"const double_double {x} = {{{place}{x}_hi[i], {place}{x}_lo[i]}};")
        else:
            loads.append(f"const double {x} = {place}{f'{x}_hi' if x in extended else x}[i];")
    to = "motion->" if has_struct else place
    split, own = _split(function), function.all_extended()
    stores = []
    for x in function.results:
        if x in split:
            stores += [f"{to}{x}_{half}[i] = {x}.{half};" for half in ("hi", "lo")]
        else:
            stores.append(f"{to}{x}[i] = {f'dd_rounded({x})' if x in own else x};")
    return Frame(name, function, "dd", (head, loop, *loads), (*stores, "}", "}"))


def members(functions: tuple[Function, ...]) -> list[str]:
    """Return the members of the struct for several bodies, in the order of their first use."""
    extended, found = pairs(functions), dict[str, None]()
    for function in filter(takes_several, functions):
        found |= dict.fromkeys(_flat(function.parameters, extended))
        if not _has_struct(function):
            found |= dict.fromkeys(_flat(function.results, _split(function)))
    return list(found)


def lane_structs(functions: tuple[Function, ...]) -> list[str]:
    """Return the C statements that declare the structs of arrays for several bodies.

    Each member of a struct has one statement.
    """
    own = tuple(filter(takes_several, functions))
    # `turned` is the runtime's: -1 where a and d have changed places.
    more = ("turned",) if any(map(_is_step, own)) else ()
    found = _lane_struct("lanes", (*members(own), *more))
    for function in filter(_has_struct, own):
        found += _lane_struct(f"{branch(function)}_lanes", flat_results(function))
    return found


def _lane_struct(name: str, arrays: Iterable[str]) -> list[str]:
    return ["typedef struct {", *(f"double {array}[LANES];" for array in arrays), "}", f"{name};"]
