"""Functions of several bodies side by side: each a loop over the members of structs of arrays.

An extended number is two members, `<name>_hi` and `<name>_lo`; a function that takes it as a double
reads the first.  The constants of motions have structs of their own, in the order of one motion's.

Steps are told how many bodies there are.  Motions fill all lanes, as many as a register holds, even
where there is one: of lines this long a compiler is to make vectors alone, and no second copy.
"""

from collections.abc import Iterable, Iterator

from rigidsym.codegen.ir import Function
from rigidsym.codegen.lines import Lines, flat_results
from rigidsym.codegen.targets.c.frame import Frame

_MOTIONS = ("_initial_state", "_circular_constants", "_hyperbolic_constants")


def side_by_side(functions: Iterable[Function]) -> tuple[Function, ...]:
    """Those of the functions that take several bodies at once."""
    return tuple(filter(takes_several, functions))


def takes_several(function: Function) -> bool:
    """Whether a function takes several bodies at once."""
    return _is_step(function) or function.name in _MOTIONS


def _is_step(function: Function) -> bool:
    return function.name.startswith("_step_")


def _has_struct(function: Function) -> bool:
    """Whether results are constants of motions."""
    return function.name.endswith("_constants")


def pairs(functions: Iterable[Function]) -> frozenset[str]:
    """The names of what is extended for some function of several bodies."""
    own = side_by_side(functions)
    return frozenset(name for f in own for name in (*f.extended, *_split(f)))


def _split(function: Function) -> frozenset[str]:
    """The results that are handed on as two doubles."""
    if function.rounds:
        return function.split
    return function.all_extended() & {*function.results}


def _flat(names: Iterable[str], extended: frozenset[str]) -> Iterator[str]:
    """The members that numbers are."""
    for name in names:
        yield from (f"{name}_hi", f"{name}_lo") if name in extended else (name,)


def members(functions: tuple[Function, ...]) -> list[str]:
    """The members of the struct, in the order in which functions name them."""
    extended, found = pairs(functions), dict[str, None]()
    for function in side_by_side(functions):
        found |= dict.fromkeys(_flat(function.parameters, extended))
        if not _has_struct(function):
            found |= dict.fromkeys(_flat(function.results, _split(function)))
    return list(found)


def frame(function: Function, extended: frozenset[str]) -> Frame:
    """What stands around the lines of a function; extended: what `pairs` of all functions says."""
    name, place = function.name[1:], "x" if _is_step(function) else "lane"
    loads = [_load(x, f"{place}->", function, extended) for x in function.parameters]
    to = "motion->" if _has_struct(function) else f"{place}->"
    stores = [store for x in function.results for store in _stores(x, to, function)]
    before = (f"{_head(name, function)} {{", _loop(function), *loads)
    return Frame(name, function, "dd", before, (*stores, "}", "}"))


def _head(name: str, function: Function) -> str:
    if _is_step(function):
        return f"static void {name}(size_t n, lanes *x)"
    if _has_struct(function):
        own = f"{_struct_name(function)} *restrict motion"
        return f"static FLAT void {name}(const lanes *restrict lane, {own})"
    return f"static FLAT void {name}(lanes *lane)"


def _loop(function: Function) -> str:
    return f"for (size_t i = 0; i < {'n' if _is_step(function) else 'LANES'}; i++) {{"


def _struct_name(function: Function) -> str:
    """The constants of a branch in lanes."""
    return f"{function.name.split('_')[1]}_lanes"


def _load(name: str, place: str, function: Function, extended: frozenset[str]) -> str:
    if name in function.extended:
        return f"const double_double {name} = {{{place}{name}_hi[i], {place}{name}_lo[i]}};"
    member = f"{name}_hi" if name in extended else name
    return f"const double {name} = {place}{member}[i];"


def _stores(name: str, place: str, function: Function) -> list[str]:
    if name in _split(function):
        return [f"{place}{name}_{half}[i] = {name}.{half};" for half in ("hi", "lo")]
    value = f"dd_rounded({name})" if name in function.all_extended() else name
    return [f"{place}{name}[i] = {value};"]


def lines(function: Function, extended: frozenset[str], body: Lines) -> Lines:
    """A function around the lines of its lets."""
    around = frame(function, extended)
    head = [f"/* {function.summary} */", around.before[0].removesuffix(" {"), "{"]
    head += [f"    {around.before[1]}", *(f"        {x}" for x in around.before[2:])]
    ends = [f"        {statement}" for statement in around.after[:-2]]
    text = (*head, *(f"    {line}" for line in body.text), *ends, "    }", "}", "")
    return Lines(text, {len(head) + number: let for number, let in body.lets.items()})


def struct_text(functions: tuple[Function, ...]) -> list[str]:
    """The structs as they are printed."""
    text: list[str] = []
    for statement in structs(functions):
        if text and text[-1] == "}":
            text[-1] = f"}} {statement}"
        else:
            text.append(f"    {statement}" if statement.endswith("];") else statement)
    return text


def structs(functions: tuple[Function, ...]) -> list[str]:
    """The structs as statements, a member each."""
    own = side_by_side(functions)
    # `turned` is the runtime's: -1 where a and d have changed places.
    more = ("turned",) if any(map(_is_step, own)) else ()
    found = _struct("lanes", (*members(own), *more))
    for function in filter(_has_struct, own):
        found += _struct(_struct_name(function), flat_results(function))
    return found


def _struct(name: str, arrays: Iterable[str]) -> list[str]:
    return ["typedef struct {", *(f"double {array}[LANES];" for array in arrays), "}", f"{name};"]
