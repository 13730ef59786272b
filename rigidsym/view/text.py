"""What objects say of themselves in a terminal: what their cards say, in a line or a few."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Protocol

import numpy as np

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import Number, Uncertain
from rigidsym.view.html.motions import Motion
from rigidsym.view.html.plans import Manoeuvre, Plan, Transfer

# Characters of a number that is written whole.
_SHORT = 24
_IDENTITY = (1, 0, 0, 0)


class Case(Protocol):
    """A motion and times."""

    @property
    def motion(self) -> Motion:
        """The motion."""
        ...

    @property
    def times(self) -> Sequence[Fraction]:
        """When it is wanted, s."""
        ...


def number(value: Number) -> str:
    """A number as one would write it in a call: doubles and whole ones bare, decimals quoted.

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
    """Its components, as `number` has them."""
    return f"({', '.join(map(number, values))})"


def rounded(values: Iterable[float], digits: int = 6) -> str:
    """Components that were computed."""
    return f"({', '.join(f'{x:.{digits}g}' for x in values)})"


def regime(motion: Motion) -> str:
    """The kind of motion, or that it is not certain."""
    try:
        return str(motion.regime)
    except InputError:
        return "regime not certain"


def motion_text(motion: Motion) -> str:
    """What a motion was made from, and its regime."""
    given = f"inertia={vector(motion.inertia)}, omega0={vector(motion.omega0)}"
    if tuple(motion.attitude0) != _IDENTITY:
        given += f", attitude0={vector(motion.attitude0)}"
    return f"<TorqueFreeMotion {given}: {regime(motion)}>"


def case_text(case: Case) -> str:
    """A motion, and how many times of it are wanted."""
    times = case.times
    ends = f" from {number(times[0])} to {number(times[-1])} s" if times else ""
    return f"<Case of {len(times)} times{ends}: {motion_text(case.motion)}>"


def manoeuvre_text(asked: Manoeuvre) -> str:
    """From where to where, and in what time."""
    duration = "" if asked.duration is None else f" in {number(asked.duration)} s"
    ends = f"from {vector(asked.start)} to {vector(asked.target)}"
    return f"<Manoeuvre {ends}{duration}, inertia={vector(asked.inertia)}>"


def transfer_text(one: Transfer) -> str:
    """The rates a transfer starts with, what it costs, and by what it misses."""
    first = one.omega0
    rates = rounded(np.where(abs(first) > 1e-12 * np.max(abs(first)), first, 0.0))
    return (
        f"<Transfer omega0={rates} rad/s, cost {one.cost:.6g} N m s, "
        f"misses by {one.miss} rad, by {one.missed} deg for 1 %, 1 deg of burst: "
        f"{one.motion.regime}>"
    )


def plan_text(plan: Plan) -> str:
    """A line for each transfer, the cheapest first."""
    names, rows = plan.table()
    told = [(*row, one.motion.regime) for row, one in zip(rows, plan.transfers, strict=True)]
    return columns(f"Plan: {plan.title.partition(': ')[2]}", (*names, "regime"), told)


def columns(title: str, names: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in characters, without lines.

    >>> print(columns("planets", ("", "moons"), [("Mars", "2"), ("Jupiter", "101")]))
    planets
             moons
    Mars     2
    Jupiter  101
    """
    table = [tuple(names), *map(tuple, rows)]
    table = table if any(names) else table[1:]
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    lines = ("  ".join(map(str.ljust, row, widths)).rstrip() for row in table)
    return "\n".join([title, *lines])
