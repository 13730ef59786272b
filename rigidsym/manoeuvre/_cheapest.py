"""The cheapest motions within limits, the shortest duration, and limits that cannot be kept."""

from collections.abc import Callable
from dataclasses import replace
from decimal import ROUND_UP, Context, Decimal
from fractions import Fraction
from typing import NoReturn

import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre import _one_parameter_families as one_parameter_families
from rigidsym.manoeuvre._bursts import Bursts
from rigidsym.manoeuvre._families import families, least
from rigidsym.manoeuvre._manoeuvre import Manoeuvre

_NEVER = "found no natural motion that keeps to it, at any duration, up to some twenty turns"
# Durations are longer by this part than the shortest, so that rounding does not break limits.
_ROOM = 1e-12
_GROWTH = 1.5
_ROUNDING = 1e-12
# Where spins need more than a burst may give, there may be no motion within the limits.  The search
# ends here, at momenta of some twenty turns.
_LARGEST = 30.0
_SHOWN = Context(prec=6, rounding=ROUND_UP)


def cheapest(bursts: Bursts, duration: float, count: int) -> np.ndarray:
    """Return the cheapest motions within the limits, rates (N, 3), N at most `count`.

    From rest to rest a motion costs twice its momentum (facts manoeuvre.first_burst,
    manoeuvre.last_burst), and never less than that less what the spins before and after can save;
    so all motions up to a cost follow from all up to a momentum.
    """
    spins = bursts.spin * duration
    most = bursts.most(duration)
    bound = min(least(bursts.problem) + spins, most)
    while True:
        known = families(bursts.problem, bound)
        if one_parameter_families.matter(bursts):
            known = one_parameter_families.cheapest(bursts, known, duration)
        allowed = known[bursts.allowed(known, duration)]
        costs = bursts.sizes(allowed, duration).sum(axis=1)
        order = np.argsort(costs, kind="stable")[:count]
        found = costs[order]
        needed = (found[-1] + spins) / 2 if len(found) == count else np.inf
        if min(needed, most) <= bound * (1 + _ROUNDING):
            return allowed[order]
        larger = _GROWTH * bound + bursts.problem.inertia.min()
        bound = min(needed, most) if needed < np.inf else min(larger, most)


def shortest(bursts: Bursts, asked: Manoeuvre) -> Fraction:
    """Return the shortest duration in s that the limits allow; raises InputError without one."""
    found = _shortest(bursts)
    if found == 0:
        rule = "start equals target, which takes no time: give one"
        raise InputError("duration", "missing", rule)
    if not np.isfinite(found):
        _refuse(bursts, asked, lambda one: np.isfinite(_shortest(one)), _NEVER)
    return Fraction(found * (1 + _ROOM))


def refuse(bursts: Bursts, asked: Manoeuvre) -> NoReturn:
    """Raise InputError with the limit that binds in the duration, and a duration that would do."""
    duration = float(asked.duration or 0)
    found = _shortest(bursts)
    rule = _NEVER
    if np.isfinite(found):
        enough = _SHOWN.create_decimal(Decimal(found))
        rule = f"no natural motion of {duration:g} s keeps to it; {enough.normalize():f} s would do"
    _refuse(bursts, asked, lambda one: len(cheapest(one, duration, 1)) > 0, rule)


def _refuse(
    bursts: Bursts, asked: Manoeuvre, can_be_kept: Callable[[Bursts], bool], rule: str
) -> NoReturn:
    """Raise InputError about the limits that cannot be kept even alone, or about both."""
    limits = asked.limits
    alone = {
        "max_rate": (limits.max_rate, replace(bursts, max_burst=np.inf)),
        "max_burst": (limits.max_burst, replace(bursts, max_rate=np.inf)),
    }
    there = {name: (value, one) for name, (value, one) in alone.items() if value is not None}
    binding = [name for name, (_, one) in there.items() if not can_be_kept(one)] or [*there]
    values = ", ".join(f"{float(there[name][0]):g}" for name in binding)
    raise InputError(" and ".join(binding), values, rule)


def _shortest(bursts: Bursts) -> float:
    """Return the shortest duration, s; motions of larger momentum than those found need longer."""
    bound = least(bursts.problem)
    while True:
        known = families(bursts.problem, bound)
        if one_parameter_families.matter(bursts):
            known = one_parameter_families.least(bursts, known, bursts.shortest)
        found = float(np.min(bursts.shortest(known), initial=np.inf))
        if found <= bound / bursts.most(1.0) * (1 + _ROOM) or bound > _LARGEST:
            return found
        bound = found * bursts.most(1.0) if np.isfinite(found) else _GROWTH * bound + 0.1
