"""Table of the strata, and drawing from them."""

from collections.abc import Iterator
from functools import cache
from random import Random

from rigidsym.validate.strata import _motions as motions
from rigidsym.validate.strata import _published as published
from rigidsym.validate.strata import _quarter_periods as quarter_periods
from rigidsym.validate.strata._sample import MAX_ANGLE, Numbers, Sample, Stratum, turns

_SOME = turns(50)
# Near the separatrix the body lingers for long before it turns over.
_MORE, _MOST = turns(300), turns(3000)

_LISTED = (
    Stratum("paper", "the paper's body as doubles", published.paper, published.paper_times, 1),
    Stratum(
        "published",
        "motions published by others, as exact decimals, at the published times and late ones",
        published.motion,
        published.times,
        len(published.published()),
    ),
    Stratum(
        "axis orders and signs",
        "every order of the axes and every quadrant of rates",
        motions.every_order_and_sign,
        _SOME,
        len(motions.ORDERS) * len(motions.SIGNS),
    ),
    Stratum("uniform", "any body, any rates", motions.uniform, _SOME),
    Stratum(
        "near separatrix",
        "doubles 1e-1 to 1e-16 from the separatrix",
        motions.near_separatrix,
        _MORE,
    ),
    Stratum(
        "beside separatrix", "doubles one ulp from the separatrix", motions.beside_separatrix, _MORE
    ),
    Stratum(
        "nearest separatrix",
        "exact decimals 1e-17 to 1e-250 from the separatrix",
        motions.nearest_separatrix,
        _MOST,
    ),
    Stratum("separatrix", "doubles on the separatrix exactly", motions.separatrix, _MORE),
    Stratum(
        "symmetric", "two equal moments, both kinds, some rates zero", motions.symmetric, _SOME
    ),
    Stratum(
        "near prolate", "the larger moments differ by 1e-1 to 2e-16", motions.near_prolate, _SOME
    ),
    Stratum(
        "near oblate", "the smaller moments differ by 1e-1 to 2e-16", motions.near_oblate, _SOME
    ),
    Stratum(
        "nearest symmetric",
        "exact decimals: two moments differ by 1e-17 to 1e-300, both kinds",
        motions.nearest_symmetric,
        _SOME,
    ),
    Stratum("sphere", "three equal moments", motions.sphere, _SOME),
    Stratum("near sphere", "moments differ by 1e-1 to 2e-16", motions.near_sphere, _SOME),
    Stratum(
        "nearest sphere",
        "exact decimals: moments differ by 1e-17 to 1e-250",
        motions.nearest_sphere,
        _SOME,
    ),
    Stratum("spin", "spin about each axis exactly", motions.spin, _SOME),
    Stratum(
        "near spin, largest",
        "spin about the axis of largest inertia, tilted by 1e-1 to 1e-300",
        motions.near_spin(2, 300),
        turns(100),
    ),
    Stratum(
        "near spin, middle",
        "spin about the middle axis, tilted by 1e-1 to 1e-85",
        motions.near_spin(1, 85),
        _MOST,
    ),
    Stratum(
        "near spin, smallest",
        "spin about the axis of smallest inertia, tilted by 1e-1 to 1e-300",
        motions.near_spin(0, 300),
        turns(100),
    ),
    Stratum("rest", "no rates", motions.rest, _SOME),
    Stratum("flat", "the largest moment is exactly the sum of the others", motions.flat, _SOME),
    Stratum("rod", "one moment is 1e-1 to 1e-15 of the others", motions.rod, _SOME),
    Stratum(
        "needle", "exact decimals: one moment is 1e-1 to 1e-59 of the others", motions.needle, _SOME
    ),
    Stratum(
        "special values",
        "small whole moments, rates equal, powers of two, zeros and negative zeros",
        motions.special_values,
        _SOME,
        len(motions.VALUES),
    ),
    Stratum(
        "special attitudes",
        "half turns and no turns, of lengths 1e-300 to 1e300",
        motions.special_attitudes,
        _SOME,
        len(motions.ATTITUDES),
    ),
    Stratum(
        "scales", "moments by 1e-200 to 1e200, rates by 1e-250 to 1e250", motions.any_scale, _SOME
    ),
    Stratum("small scales", "moments by 1e-9, rates by 1e-12", motions.scaled(1e-9, 1e-12), _SOME),
    Stratum("large scales", "moments by 1e12, rates by 1e6", motions.scaled(1e12, 1e6), _SOME),
    Stratum(
        "extreme scales",
        "whole moments by 2^-1074 to 2^1018, rates by 1e-298 to 1e297",
        motions.extreme_scales,
        _SOME,
    ),
    Stratum(
        "decimals",
        "exact decimals: moments differ by 1e-2 to 1e-19, or a separatrix",
        motions.exact_decimals,
        turns(100),
    ),
    Stratum("long times", "any body, evenly up to 1e6 rad", motions.uniform, turns(1e6)),
    Stratum("longest times", "any body, evenly up to 2^46 rad", motions.uniform, turns(MAX_ANGLE)),
    Stratum(
        "near separatrix, long",
        "doubles 1e-1 to 1e-16 from the separatrix, evenly up to 2^46 rad",
        motions.near_separatrix,
        turns(MAX_ANGLE),
    ),
    Stratum(
        "branch switch",
        "k_1^2 within 3e-1 to 1e-16 of 1/2, where the series change, up to 2^46 rad",
        motions.branch_switch,
        turns(MAX_ANGLE),
    ),
    Stratum(
        "zeros of the rates",
        "on both sides of a zero of each rate that has any, from 1 ulp to 1e-9 away",
        quarter_periods.body,
        quarter_periods.zeros,
    ),
    Stratum(
        "quarter periods",
        "on both sides of 1, 2, ... quarter periods, up to 2^46 rad",
        quarter_periods.body,
        quarter_periods.quarters,
    ),
)
STRATA = {stratum.name: stratum for stratum in _LISTED}


def count(stratum: str, cases: int) -> int:
    """Return the number of cases of a stratum: `cases`, or all where it has fewer."""
    size = STRATA[stratum].size
    return cases if size is None else min(cases, size)


@cache
def in_doubles() -> tuple[str, ...]:
    """Return the strata whose numbers are all doubles, for programs that take doubles."""
    return tuple(name for name in STRATA if draw(name, 0, 0).in_doubles)


def samples(cases: int, seed: int) -> Iterator[Sample]:
    """Yield `cases` samples of every stratum, or all where it has fewer."""
    for stratum in STRATA:
        for index in range(count(stratum, cases)):
            yield draw(stratum, index, seed)


def draw(stratum: str, index: int, seed: int) -> Sample:
    """Draw one sample, which is always the same.

    Parameters
    ----------
    stratum : a key of `STRATA`
    index : the number of the case, below the size of a finite stratum
    seed : of all cases

    Returns
    -------
    Sample
        Inertia (3) in kg m^2, omega0 (3) in rad/s, attitude0 (4) and times in s.

    Examples
    --------
    >>> draw("paper", 0, seed=1).inertia
    (0.0109, 0.04, 0.0506)
    """
    random = Random(f"{seed}/{stratum}/{index}")
    chosen = STRATA[stratum]
    motion = chosen.body(random, index)
    attitude: Numbers = tuple(random.gauss(0, 1) for _ in range(4))
    if motion.attitude0 is not None:
        attitude = motion.attitude0
    times = chosen.times(random, index, motion)
    return Sample(stratum, index, motion.inertia, motion.omega0, attitude, times)
