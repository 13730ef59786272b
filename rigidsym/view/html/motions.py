"""Motions and cases as notebooks show them."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Protocol

from rigidsym.errors import InputError
from rigidsym.inputs import Number
from rigidsym.language.latex import listed
from rigidsym.view.html.cards import card, counted, head, muted, table
from rigidsym.view.html.markup import Markup
from rigidsym.view.html.quantities import INERTIA, RATE, decimal, row, vector


class Motion(Protocol):
    """A motion: its numbers, exact or uncertain, and its regime."""

    @property
    def inertia(self) -> Sequence[Number]:
        """Principal moments (3,), kg m^2."""
        ...

    @property
    def omega0(self) -> Sequence[Number]:
        """Rates at t = 0 (3,), rad/s."""
        ...

    @property
    def attitude0(self) -> Sequence[Number]:
        """Attitude at t = 0 (4,)."""
        ...

    @property
    def regime(self) -> str:
        """The kind of motion; InputError where it is not certain."""
        ...


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


def motion_html(motion: Motion) -> str:
    """What a motion was made from, and its regime."""
    return card(head("Torque-free motion", muted(_regime(motion))), table((), _rows(motion)))


def motion_latex(motion: Motion) -> str:
    """What a motion was made from, in one line."""
    parts = [
        rf"{name} = {vector(values)}\,{unit}".removesuffix(r"\,")
        for _, name, values, unit in _given(motion)
    ]
    return f"${listed(parts)}$"


def case_html(case: Case) -> str:
    """A motion, and how many times of it are wanted."""
    times = case.times
    ends = f"{decimal(times[0])} s to {decimal(times[-1])} s" if times else ""
    said = counted(len(times), "time") + (f", {ends}" if ends else "")
    title = head("Case", muted(_regime(case.motion)))
    return card(title, table((), [*_rows(case.motion), (muted("times"), said, "")]))


def _rows(motion: Motion) -> Iterator[tuple[Markup, ...]]:
    for field, name, values, unit in _given(motion):
        yield row(field, f"{name} = {vector(values)}", unit)


def _given(motion: Motion) -> Iterator[tuple[str, str, Sequence[Number], str]]:
    """Field, name in LaTeX, numbers and unit."""
    yield "inertia", "(c_1, c_2, c_3)", motion.inertia, INERTIA
    yield "omega0", r"\Omega(0)", motion.omega0, RATE
    yield "attitude0", "R(0)", motion.attitude0, ""


def _regime(motion: Motion) -> str:
    try:
        return str(motion.regime)
    except InputError as error:
        return f"regime not certain: {error}"
