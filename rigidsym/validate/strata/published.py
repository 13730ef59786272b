"""Motions that others have published, or test their programs by, as data of this project."""

import tomllib
from fractions import Fraction
from functools import cache
from importlib import resources
from random import Random
from typing import TypedDict

from rigidsym.io.cases import paper_case
from rigidsym.validate.strata.sample import Floats, Motion, Numbers
from rigidsym.validate.strata.times import late, turns

_ENOUGH = 10


class Entry(TypedDict):
    """A published motion, its numbers as they were printed."""

    name: str
    source: str
    inertia: list[str]
    omega0: list[str]
    attitude0: list[str]
    times: list[str]


@cache
def published() -> tuple[Entry, ...]:
    """The entries of published.toml, in its order."""
    text = resources.files("rigidsym.validate.strata").joinpath("published.toml").read_text("utf-8")
    return tuple(tomllib.loads(text)["motion"])


def motion(random: Random, index: int) -> Motion:
    """The index-th published motion."""
    entry = published()[index]
    return Motion(*(_numbers(entry[name]) for name in ("inertia", "omega0", "attitude0")))


def times(random: Random, index: int, motion: Motion) -> Floats:
    """t = 0 and the published times, both ways, others where these are few, and late ones."""
    known = {sign * float(Fraction(t)) for t in published()[index]["times"] for sign in (-1, 1)}
    listed = (0.0, *sorted(known))
    some = (listed + turns(50)(random, index, motion)[1:])[: max(len(listed), _ENOUGH)]
    return some + late(random, motion, 50)


def _numbers(texts: list[str]) -> Numbers:
    """Decimals as doubles where these are the same numbers."""
    return tuple(float(x) if Fraction(float(x)) == x else x for x in map(Fraction, texts))


def paper(random: Random, index: int) -> Motion:
    """The paper's body, its decimals rounded to doubles."""
    exact = paper_case().motion.exact
    return Motion(*(tuple(map(float, values)) for values in exact.values()))


def paper_times(random: Random, index: int, motion: Motion) -> Floats:
    """Every tenth of the paper's times, and late ones; as there is one case, always the same."""
    return tuple(map(float, paper_case().times[::10])) + late(Random("paper"), motion, 50)
