"""Plans and transfers as notebooks show them."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Protocol

import numpy as np

from rigidsym.language.latex import listed
from rigidsym.view.html.cards import card, counted, head, math, muted, table
from rigidsym.view.html.flights import Motion
from rigidsym.view.html.markup import Markup, tag
from rigidsym.view.html.quantities import COMPUTED, INERTIA, MOMENTUM, RATE, decimal, row, vector

_ROUNDING = 1e-12


class Limits(Protocol):
    """What the spacecraft can do; None where there is no limit."""

    @property
    def max_rate(self) -> Fraction | None:
        """rad/s."""
        ...

    @property
    def max_burst(self) -> Fraction | None:
        """N m s."""
        ...


class Manoeuvre(Protocol):
    """What is asked for."""

    @property
    def inertia(self) -> Sequence[Fraction]:
        """Principal moments (3,), kg m^2."""
        ...

    @property
    def start(self) -> Sequence[Fraction]:
        """Quaternion (4,)."""
        ...

    @property
    def target(self) -> Sequence[Fraction]:
        """Quaternion (4,)."""
        ...

    @property
    def duration(self) -> Fraction | None:
        """s."""
        ...

    @property
    def start_spin(self) -> Sequence[Fraction]:
        """Rates before (3,), rad/s."""
        ...

    @property
    def target_spin(self) -> Sequence[Fraction]:
        """Rates after (3,), rad/s."""
        ...

    @property
    def limits(self) -> Limits:
        """Of rates and bursts."""
        ...


class Transfer(Protocol):
    """A natural motion from start to target."""

    @property
    def manoeuvre(self) -> Manoeuvre:
        """What it is for, with its duration."""
        ...

    @property
    def motion(self) -> Motion:
        """The motion."""
        ...

    @property
    def omega0(self) -> np.ndarray:
        """Rates at the start (3,), rad/s."""
        ...

    @property
    def omega1(self) -> np.ndarray:
        """Rates at the end (3,), rad/s."""
        ...

    @property
    def bursts(self) -> np.ndarray:
        """(2, 3), N m s."""
        ...

    @property
    def cost(self) -> float:
        """N m s."""
        ...

    @property
    def energy(self) -> float:
        """J."""
        ...

    @property
    def peak_rate(self) -> float:
        """rad/s."""
        ...

    @property
    def miss(self) -> str:
        """The angle by which it misses the target, rad; a bound where that is rounding."""
        ...

    @property
    def missed(self) -> str:
        """By a first burst wrong by 1 % and by 1 degree, in degrees."""
        ...


class Plan(Protocol):
    """Transfers for one manoeuvre."""

    @property
    def manoeuvre(self) -> Manoeuvre:
        """What was asked for."""
        ...

    @property
    def transfers(self) -> Sequence[Transfer]:
        """The cheapest first."""
        ...

    @property
    def title(self) -> str:
        """What is planned, behind a colon."""
        ...

    def table(self) -> tuple[Sequence[str], Sequence[Sequence[str]]]:
        """Columns and rows."""
        ...


def plan_html(plan: Plan) -> str:
    """What was asked for, then the transfers, the cheapest first."""
    asked = plan.manoeuvre
    title = head("Plan", muted(f"{counted(len(plan.transfers), 'transfer')}, {_duration(asked)}"))
    found = ((f"{k}", *_row(one)) for k, one in enumerate(plan.transfers, 1))
    columns, _ = plan.table()
    return card(title, table((), _asked(asked)), table((*columns, "regime"), found))


def transfer_html(transfer: Transfer) -> str:
    """The natural motion, its two bursts, what they cost, and by what it misses."""
    title = head("Transfer", muted(transfer.motion.regime), muted(_duration(transfer.manoeuvre)))
    first, last = transfer.bursts
    told = [
        row("omega0", rf"\Omega(0) = {_computed(transfer.omega0)}", RATE),
        row("omega1", rf"\Omega(T) = {_computed(transfer.omega1)}", RATE),
        row("bursts", listed([_computed(first), _computed(last)]), MOMENTUM),
        row("cost", decimal(transfer.cost, COMPUTED), MOMENTUM),
        row("energy", f"H = {decimal(transfer.energy, COMPUTED)}", r"\mathrm{J}"),
        row("peak_rate", decimal(transfer.peak_rate, COMPUTED), RATE),
        row("residual", _latex(transfer.miss), r"\mathrm{rad}"),
        (muted("by 1 %, 1 deg of burst (deg)"), muted(transfer.missed)),
    ]
    return card(title, table((), told))


def _asked(asked: Manoeuvre) -> Iterator[tuple[Markup, ...]]:
    yield row("inertia", f"(c_1, c_2, c_3) = {vector(asked.inertia)}", INERTIA)
    yield row("start", f"R(0) = {vector(asked.start)}", "")
    yield row("target", f"R(T) = {vector(asked.target)}", "")
    if any(asked.start_spin):
        yield row("start_spin", rf"\Omega(0^-) = {vector(asked.start_spin)}", RATE)
    if any(asked.target_spin):
        yield row("target_spin", rf"\Omega(T^+) = {vector(asked.target_spin)}", RATE)
    if asked.limits.max_rate is not None:
        yield row("max_rate", decimal(asked.limits.max_rate), RATE)
    if asked.limits.max_burst is not None:
        yield row("max_burst", decimal(asked.limits.max_burst), MOMENTUM)


def _row(one: Transfer) -> Iterator[Markup]:
    yield math(_computed(one.omega0))
    yield from (math(decimal(x, COMPUTED)) for x in (one.cost, one.energy, one.peak_rate))
    yield math(_latex(one.miss))
    yield muted(one.missed)
    yield tag("span", one.motion.regime, style="white-space:nowrap")


def _computed(values: np.ndarray) -> str:
    """A vector without what is rounding beside its largest component."""
    rounding = _ROUNDING * np.max(np.abs(values))
    return vector(np.where(np.abs(values) > rounding, values, 0.0).tolist(), COMPUTED)


def _latex(miss: str) -> str:
    """Return `2.3e-10`, or a bound as `< 1e-14`, in LaTeX."""
    mantissa, _, exponent = miss.partition("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}".replace(r"< 1 \cdot", "<")


def _duration(asked: Manoeuvre) -> str:
    return f"{float(asked.duration or 0):g} s"
