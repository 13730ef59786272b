"""Published motions, and motions by which others test their programs, as data of this project."""

import tomllib
from fractions import Fraction
from functools import cache
from importlib import resources
from random import Random
from typing import Any

from rigidsym.io.cases import paper_case
from rigidsym.validate.strata._sample import Floats, Motion, late, turns

_ENOUGH = 10


@cache
def published() -> tuple[dict[str, Any], ...]:
    """Return the entries of published.toml, in its order, with numbers as they were printed."""
    text = resources.files("rigidsym.validate.strata").joinpath("published.toml").read_text("utf-8")
    return tuple(tomllib.loads(text)["motion"])


def motion(random: Random, index: int) -> Motion:
    """Return the index-th published motion; decimals become doubles where these are equal."""
    entry = published()[index]
    exact = ([Fraction(x) for x in entry[name]] for name in ("inertia", "omega0", "attitude0"))
    return Motion(*(tuple(float(x) if Fraction(float(x)) == x else x for x in y) for y in exact))


def times(random: Random, index: int, motion: Motion) -> Floats:
    """Return t = 0, the published times both ways, others where these are few, and late ones."""
    known = {sign * float(Fraction(t)) for t in published()[index]["times"] for sign in (-1, 1)}
    listed = (0.0, *sorted(known))
    some = (listed + turns(50)(random, index, motion)[1:])[: max(len(listed), _ENOUGH)]
    return some + late(random, motion, 50)


def paper(random: Random, index: int) -> Motion:
    """Return the paper's body, its decimals rounded to doubles."""
    exact = paper_case().motion.exact
    return Motion(*(tuple(map(float, values)) for values in exact.values()))


def paper_times(random: Random, index: int, motion: Motion) -> Floats:
    """Return every tenth of the paper's times, and late ones: always the same, for its one case."""
    return tuple(map(float, paper_case().times[::10])) + late(Random("paper"), motion, 50)
