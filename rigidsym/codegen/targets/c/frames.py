"""What stands around the lines of a function in C: its head, what it reads, and what it returns."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from rigidsym.codegen.ir import Function
from rigidsym.codegen.lines import flat_results
from rigidsym.codegen.targets.c import lanes
from rigidsym.codegen.targets.c.frame import Frame

_LOOP = "for (size_t i = 0; i < n; i++) {"


def frames(functions: tuple[Function, ...]) -> Iterator[Frame]:
    """All functions in order; `_discriminant` is there for two kinds of numbers."""
    extended = lanes.pairs(functions)
    members = {f.name: {*flat_results(f)} for f in functions if f.name.endswith("_constants")}
    for function in functions:
        name = function.name[1:]
        if lanes.takes_several(function):
            yield lanes.frame(function, extended)
        elif name == "discriminant":
            every = replace(function, extended=frozenset(function.parameters))
            yield _valued(f"{name}_dd", every, "double_double", "dd")
            yield _valued(f"{name}_exact", every, "exact", "exact")
        elif len(function.results) == 1 and not function.extended:
            yield _valued(name, function, "double", "dd", "static INLINED")
        elif name.endswith("_constants"):
            yield _constants(name, function)
        elif name.endswith(("_angles", "_state")):
            yield _loop(name, function, members[f"_{name.split('_')[0]}_constants"])
        elif len(function.results) == 1:
            yield _valued(name, function, "double_double", "dd")
        else:
            yield _handing_out(name, function)


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
    """Each result is a member of a struct, rounded, or two where it is split."""
    branch, extended = name.split("_")[0], function.all_extended()
    values: dict[str, str] = {}
    for result in function.results:
        if result in function.split:
            values |= {f"{result}_hi": f"{result}.hi", f"{result}_lo": f"{result}.lo"}
        else:
            values[result] = f"dd_rounded({result})" if result in extended else result
    stores = [f"motion->{member} = {value};" for member, value in values.items()]
    head = _head("static void", name, [*_given(function), f"torque_free_{branch} *motion"])
    return Frame(name, function, "dd", (head,), (*stores, "}"))


def _loop(name: str, function: Function, members: set[str]) -> Frame:
    """What changes with time is read and written by index, what does not from a struct."""
    branch, used = name.split("_")[0], function.used()
    changing = [x for x in function.parameters if x not in members]
    kept = [x for x in function.parameters if x in members and x in used]
    parameters = [f"const torque_free_{branch} *motion", "size_t n"]
    parameters += [f"const double *restrict {x}_in" for x in changing]
    parameters += [f"double *restrict {x}_out" for x in function.results]
    before = [_head("static void", name, parameters)]
    before += [f"const double {x} = motion->{x};" for x in kept]
    before += [_LOOP, *(f"const double {x} = {x}_in[i];" for x in changing)]
    stores = [f"{x}_out[i] = {x};" for x in function.results]
    return Frame(name, function, "dd", tuple(before), (*stores, "}", "}"))


def struct(function: Function) -> tuple[str, ...]:
    """The constants that a function leaves, as statements."""
    members = f"double {', '.join(flat_results(function))};"
    return "typedef struct {", members, "}", f"torque_free_{function.name.split('_')[1]};"
