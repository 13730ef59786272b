"""Files of modules with a fault in an assignment, a routine, a named number or a text."""

import ast
import json
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib import resources

from rigidsym._codegen import routines
from rigidsym._codegen.formats import Format
from rigidsym._codegen.forms import split
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.lines import Module
from rigidsym._codegen.targets import builder, format_of
from rigidsym.language._expression import parse, to_text
from rigidsym.solution import sealed
from rigidsym.validate.faults._fault import Fault, StaleFaultError


def functions_of(target: str) -> tuple[Function, ...]:
    """Return the derived functions of a target."""
    language, form = split(target)
    return _functions(form, format_of(language))


@cache
def _functions(form: str, binary: Format) -> tuple[Function, ...]:
    return functions(sealed(), form, binary)


def constants_of(target: str) -> tuple[Constant, ...]:
    """Return the named numbers of a target."""
    return constants(format_of(split(target)[0]))


def installed(target: str) -> dict[str, str]:
    """Return the generated files of a target that are installed with the package, by name."""
    home = resources.files("rigidsym.generated")
    manifest = json.loads(home.joinpath(f"{target}.map.json").read_text("utf-8"))["manifest"]
    return {name: home.joinpath(name).read_text("utf-8") for name in manifest["sha256"]}


def faulty(fault: Fault) -> Mapping[str, str]:
    """Return the files of a target's module that is printed with a fault.

    Raises StaleFaultError if the text to change is not in its place exactly once, and ValueError if
    the module is the same with the change.
    """
    if fault.is_of_text:
        return _with_text(fault)
    of, numbers, routine = _changed(fault)
    language, form = split(fault.target)
    with routines.replaced(routine):
        module = builder(language)(of, numbers, form)
    if module.digest == sound(fault.target).digest:
        raise ValueError(f"{fault.line}: changes nothing in the module")
    return module.files


def check(fault: Fault) -> None:
    """Raise StaleFaultError if the text to change is not in its place exactly once."""
    (_with_text if fault.is_of_text else _changed)(fault)


@cache
def sound(target: str) -> Module:
    """Return a target's module without a fault."""
    language, form = split(target)
    return builder(language)(functions_of(target), constants_of(target), form)


def _with_text(fault: Fault) -> dict[str, str]:
    # Text is written by hand in modules of one file.
    ((name, text),) = installed(fault.target).items()
    return {name: fault.applied(text)}


Changed = tuple[
    tuple[Function, ...], tuple[Constant, ...], Mapping[tuple[str, str], ast.FunctionDef]
]


def _changed(fault: Fault) -> Changed:
    """Return functions, named numbers and replaced routines after the change of one of them."""
    of, numbers = functions_of(fault.target), constants_of(fault.target)
    where, _, part = fault.place.partition(".")
    if not part:
        found = {x.name: x for x in numbers}
        if where not in found:
            raise StaleFaultError(f"{fault.line}: {where} is no named number")
        found[where] = _number(fault, found[where])
        return of, tuple(found.values()), {}
    if where in routines.files():
        return of, numbers, {(where, part): _routine(fault, where, part)}
    changed = tuple(_function(fault, x, part) for x in of)
    if changed == of:
        raise StaleFaultError(f"{fault.line}: {fault.place} is not assigned")
    return changed, numbers, {}


def number_text(constant: Constant) -> str:
    """Return the value of a named number as text, in two parts if it is extended."""
    return repr(constant.hi) if constant.lo is None else f"{constant.hi!r}, {constant.lo!r}"


def _number(fault: Fault, constant: Constant) -> Constant:
    hi, *lo = map(float, fault.applied(number_text(constant)).split(", "))
    return replace(constant, hi=hi, lo=lo[0] if lo else None)


def _function(fault: Fault, function: Function, quantity: str) -> Function:
    """Change the assignment of a quantity, where this is the function of the fault."""
    if fault.place != f"{function.name[1:]}.{quantity}":
        return function
    places = [k for k, let in enumerate(function.lets) if let.targets[0] == quantity]
    lets = list(function.lets)
    for k in places:
        lets[k] = replace(lets[k], expression=parse(fault.applied(to_text(lets[k].expression))))
    return replace(function, lets=tuple(lets))


def _routine(fault: Fault, file: str, name: str) -> ast.FunctionDef:
    """Change a routine of the runtime, and keep the comments on its statements if none is new."""
    old = routines.definition(file, name)
    if old is None:
        raise StaleFaultError(f"{fault.line}: {fault.place} is no routine")
    (new,) = ast.parse(fault.applied(ast.unparse(old))).body
    assert isinstance(new, ast.FunctionDef)
    before, after = ([x for x in ast.walk(y) if isinstance(x, ast.stmt)] for y in (old, new))
    for k, statement in enumerate(after):
        note = getattr(before[k], "note", "") if len(before) == len(after) else ""
        setattr(statement, "note", note)  # noqa: B010
    return new
