"""Motions and cases as notebooks show them."""

from collections.abc import Iterator
from typing import Any

from rigidsym.errors import InputError
from rigidsym.language.statement import listed
from rigidsym.view.html.cards import card, counted, head, muted, table
from rigidsym.view.html.quantities import INERTIA, RATE, decimal, row, vector

_GIVEN = (
    ("inertia", r"(c_1, c_2, c_3)", INERTIA),
    ("omega0", r"\Omega(0)", RATE),
    ("attitude0", r"R(0)", ""),
)


def motion_html(motion: Any) -> str:
    """What a motion was made from, and its regime."""
    return card(head("Torque-free motion", muted(_regime(motion))), table((), _rows(motion)))


def motion_latex(motion: Any) -> str:
    """What a motion was made from, in one line."""
    parts = [
        rf"{name} = {vector(getattr(motion, field))}\,{unit}".removesuffix(r"\,")
        for field, name, unit in _GIVEN
    ]
    return f"${listed(parts)}$"


def case_html(case: Any) -> str:
    """A motion, and how many times of it are wanted."""
    times = case.times
    ends = f"{decimal(times[0])} s to {decimal(times[-1])} s" if times else ""
    said = counted(len(times), "time") + (f", {ends}" if ends else "")
    title = head("Case", muted(_regime(case.motion)))
    return card(title, table((), [*_rows(case.motion), (muted("times"), said, "")]))


def _rows(motion: Any) -> Iterator[tuple[Any, ...]]:
    for field, name, unit in _GIVEN:
        yield row(field, f"{name} = {vector(getattr(motion, field))}", unit)


def _regime(motion: Any) -> str:
    try:
        return str(motion.regime)
    except InputError as error:
        return f"regime not certain: {error}"
