"""Faults written by hand, each for all targets that print its place."""

import re
import tomllib
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from importlib import resources

from rigidsym._codegen.forms import key, split
from rigidsym._codegen.functions.sensitivity import sensitivity
from rigidsym._codegen.ir import Function, Let
from rigidsym._codegen.lines import texts_by_hand
from rigidsym._codegen.routines import defined, files
from rigidsym._codegen.targets import format_of
from rigidsym.solution import sealed
from rigidsym.validate.faults._fault import KINDS, TARGETS, Fault
from rigidsym.validate.faults._printed import constants_of, functions_of, installed

_TABLE = resources.files("rigidsym.validate.faults").joinpath("by_hand.toml").read_text("utf-8")
# Between places of which a target has the first that it prints.
_OR = " or "


@cache
def by_hand() -> tuple[Fault, ...]:
    """Return the faults written by hand, ordered by target."""
    found = list[Fault]()
    for section, content in tomllib.loads(_TABLE).items():
        kinds = {section: content} if section in KINDS else content
        for kind, faults in kinds.items():
            for name, (places, old, new, *options) in faults.items():
                is_general = section in KINDS
                of = _everywhere(places.split(_OR)) if is_general else [(section, places)]
                for target, place in of:
                    in_sensitivities = place.partition(".")[0] in _of_sensitivities()
                    fault = Fault(target, kind, name, place, old, new, (), in_sensitivities)
                    if not is_general:
                        found.append(replace(fault, options=tuple(options)))
                    elif not options or format_of(split(target)[0]).is_wide:
                        found.append(fault)
                    elif options[0]:
                        found.append(replace(fault, new=options[0]))
    return tuple(sorted(found, key=lambda fault: TARGETS.index(fault.target)))


def _everywhere(places: list[str]) -> Iterator[tuple[str, str]]:
    """Yield the first target of each language that prints one of some places, and that place."""
    languages = set[str]()
    for target in TARGETS:
        language, _ = split(target)
        own = next((place for place in places if _prints(target, place)), None)
        if language not in languages and own:
            languages.add(language)
            yield target, own


@cache
def _of_sensitivities() -> frozenset[str]:
    """Return the names of derived functions, and of a file, that compute sensitivities alone."""
    return frozenset(("sensitivity", *(x.name[1:] for x in sensitivity(sealed()))))


@cache
def derived(target: str) -> tuple[Function, ...]:
    """Return the derived functions that a target prints."""
    text = "\n".join(installed(target).values())
    heads = {*re.findall(r"\b_?(\w+?)(?:_dd)?\(", text)}
    return tuple(one for one in functions_of(target) if one.name[1:] in heads)


def _prints(target: str, place: str) -> bool:
    """Return True if a target prints a named number, a derived function, or a routine."""
    where, _, part = place.partition(".")
    # Faults are written for binary64: another format has other lines and numbers, too.
    language, form = split(target)
    wide = target if format_of(language).is_wide else key("c", form)
    if not part:
        own, other = ([x for x in constants_of(y) if x.name == where] for y in (target, wide))
        return own == other and any(where in function.used() for function in derived(target))
    if where not in files():
        own, other = (_assigned(x, where, part) for x in (target, wide))
        return own is not None and own == other
    printed = _routines(target)
    # Files have routines of the same names, but each has some of its own.
    others = {name for file in files() if file != where for name in defined([file])}
    return part in printed and not printed.isdisjoint({*defined([where])} - others)


def _assigned(target: str, name: str, quantity: str) -> list[Let] | None:
    """Return what a target's derived function assigns to a quantity, None without the function."""
    for one in derived(target):
        if one.name == f"_{name}":
            return [let for let in one.lets if let.targets[0] == quantity]
    return None


@cache
def _routines(target: str) -> frozenset[str]:
    """Return the names of routines of the runtime that an installed module has."""
    text = "\n".join(installed(target).values())
    for part in texts_by_hand(split(target)[0]):
        text = text.replace(part, "")
    heads = re.findall(
        r"^\w.*?\b(?:_|torque_free_(?:pi_|single_)?(?:step_)?)?(\w+)\(", text, re.MULTILINE
    )
    return frozenset(heads) & {*defined(files())}
