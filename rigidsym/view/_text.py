"""Representations of values in a terminal: the content of their cards in one line or a few."""

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym._inputs import Number, Uncertain
from rigidsym.errors import InputError
from rigidsym.view._tables import columns

if TYPE_CHECKING:
    from rigidsym.io.cases import Case
    from rigidsym.manoeuvre._manoeuvre import Manoeuvre
    from rigidsym.manoeuvre._planning import Plan
    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.motion import TorqueFreeMotion

# Exact numbers of at most so many characters are written in full.
_SHORT = 24
_IDENTITY = (1, 0, 0, 0)


def number(value: Number) -> str:
    """Return a number as written in a call: doubles and integers bare, decimals quoted.

    >>> number(Fraction(0.0109)), number(Fraction("0.0109")), number(Fraction(1, 3))
    ('0.0109', "'0.0109'", "'1/3'")
    """
    if isinstance(value, Uncertain):
        return f"'{value}'"
    if value.denominator == 1 and abs(value) < 10**15:
        return str(value)
    if abs(value) < 2**1000 and Fraction(float(value)) == value:
        return repr(float(value))
    exact = inputs.exact_text(value) if value.denominator < 10**30 else ""
    return repr(exact if 0 < len(exact) <= _SHORT else f"{inputs.decimal(value, 12)}...")


def vector(values: Iterable[Number]) -> str:
    """Return the components of a vector, each by `number`."""
    return f"({', '.join(map(number, values))})"


def rounded(values: Iterable[float], digits: int = 6) -> str:
    """Return the components of a computed vector."""
    return f"({', '.join(f'{x:.{digits}g}' for x in values)})"


def regime(motion: "TorqueFreeMotion") -> str:
    """Return the regime of a motion, or that it is not certain."""
    try:
        return str(motion.regime)
    except InputError:
        return "regime not certain"


def motion_text(motion: "TorqueFreeMotion") -> str:
    """Return the inputs of a motion, and its regime."""
    given = f"inertia={vector(motion.inertia)}, omega0={vector(motion.omega0)}"
    if tuple(motion.attitude0) != _IDENTITY:
        given += f", attitude0={vector(motion.attitude0)}"
    return f"<TorqueFreeMotion {given}: {regime(motion)}>"


def case_text(case: "Case") -> str:
    """Return the motion of a case, and the number and range of its times."""
    times = case.times
    ends = f" from {number(times[0])} to {number(times[-1])} s" if times else ""
    return f"<Case of {len(times)} times{ends}: {motion_text(case.motion)}>"


def manoeuvre_text(asked: "Manoeuvre") -> str:
    """Return the attitudes of a manoeuvre, and its duration."""
    duration = "" if asked.duration is None else f" in {number(asked.duration)} s"
    ends = f"from {vector(asked.start)} to {vector(asked.target)}"
    return f"<Manoeuvre {ends}{duration}, inertia={vector(asked.inertia)}>"


def transfer_text(one: "Transfer") -> str:
    """Return the initial rates of a transfer, its cost, and its errors."""
    first = one.omega0
    rates = rounded(np.where(abs(first) > 1e-12 * np.max(abs(first)), first, 0.0))
    return (
        f"<Transfer omega0={rates} rad/s, cost {one.cost:.6g} N m s, "
        f"misses by {one.miss} rad, by {one.missed} deg for 1 %, 1 deg of burst: "
        f"{one.motion.regime}>"
    )


def plan_text(plan: "Plan") -> str:
    """Return a line for each transfer, the cheapest first."""
    names, rows = plan.table()
    told = [(*row, one.motion.regime) for row, one in zip(rows, plan.transfers, strict=True)]
    return columns(f"Plan: {plan.title.partition(': ')[2]}", (*names, "regime"), told)
