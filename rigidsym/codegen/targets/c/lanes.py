"""Functions of several bodies side by side: each a loop over the members of one struct of arrays.

An extended number is two members, `<name>_hi` and `<name>_lo`; a function that takes it as a double
reads the first.
"""

from collections.abc import Iterable

from rigidsym.codegen.ir import Function
from rigidsym.codegen.lines import Lines, flat_results
from rigidsym.codegen.targets.c.frame import Frame

_HEAD = "static void {name}(size_t n, lanes *x)"
_LOOP = "for (size_t i = 0; i < n; i++) {"


def pairs(functions: Iterable[Function]) -> frozenset[str]:
    """The names of what is extended for some function."""
    return frozenset(name for f in functions for name in (*f.extended, *f.split))


def members(functions: tuple[Function, ...]) -> list[str]:
    """The members of the struct, in the order in which functions name them."""
    extended, found = pairs(functions), dict[str, None]()
    for function in functions:
        for name in function.parameters:
            both = (f"{name}_hi", f"{name}_lo") if name in extended else (name,)
            found |= dict.fromkeys(both)
        found |= dict.fromkeys(flat_results(function))
    return list(found)


def frame(function: Function, extended: frozenset[str]) -> Frame:
    """What stands around the lines of a function; extended: what `pairs` of all functions says."""
    name = function.name[1:]
    loads = [_load(x, function, extended) for x in function.parameters]
    stores = [store for x in function.results for store in _stores(x, function)]
    before = (f"{_HEAD.format(name=name)} {{", _LOOP, *loads)
    return Frame(name, function, "dd", before, (*stores, "}", "}"))


def _load(name: str, function: Function, extended: frozenset[str]) -> str:
    if name in function.extended:
        return f"const double_double {name} = {{x->{name}_hi[i], x->{name}_lo[i]}};"
    member = f"{name}_hi" if name in extended else name
    return f"const double {name} = x->{member}[i];"


def _stores(name: str, function: Function) -> list[str]:
    if name in function.split:
        return [f"x->{name}_{half}[i] = {name}.{half};" for half in ("hi", "lo")]
    value = f"dd_rounded({name})" if name in function.all_extended() else name
    return [f"x->{name}[i] = {value};"]


def lines(function: Function, extended: frozenset[str], body: Lines) -> Lines:
    """A function around the lines of its lets."""
    around = frame(function, extended)
    head = [f"/* {function.summary} */", _HEAD.format(name=around.name), "{", f"    {_LOOP}"]
    head += [f"        {statement}" for statement in around.before[2:]]
    ends = [f"        {statement}" for statement in around.after[:-2]]
    text = (*head, *(f"    {line}" for line in body.text), *ends, "    }", "}", "")
    return Lines(text, {len(head) + number: let for number, let in body.lets.items()})


def has_lanes(functions: Iterable[Function]) -> bool:
    """Whether these are functions of steps, which go side by side."""
    return all(function.name.startswith("_step_") for function in functions)


def struct_text(functions: tuple[Function, ...]) -> list[str]:
    """The struct as it is printed."""
    first, *arrays, end, name = struct(functions)
    return [first, *(f"    {array}" for array in arrays), f"{end} {name}"]


def struct(functions: tuple[Function, ...]) -> list[str]:
    """The struct as statements, a member each."""
    # `turned` is the runtime's: -1 where a and d have changed places.
    arrays = (f"double {name}[LANES];" for name in (*members(functions), "turned"))
    return ["typedef struct {", *arrays, "}", "lanes;"]
