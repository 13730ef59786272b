"""Motions and cases as notebooks show them."""

from collections.abc import Iterator
from typing import Any

from rigidsym import inputs
from rigidsym.display.parts import card, counted, head, math, muted, table
from rigidsym.display.statement import listed
from rigidsym.errors import InputError

_GIVEN = (
    ("inertia", r"(c_1, c_2, c_3)", r"\mathrm{kg\,m^2}"),
    ("omega0", r"\Omega(0)", r"\mathrm{rad/s}"),
    ("attitude0", r"R(0)", ""),
)


def motion_html(motion: Any) -> str:
    """What a motion was made from, and its regime."""
    return card(head("Torque-free motion", muted(_regime(motion))), table((), _rows(motion)))


def motion_latex(motion: Any) -> str:
    """What a motion was made from, in one line."""
    parts = [
        rf"{name} = {_row(getattr(motion, field))}\,{unit}".removesuffix(r"\,")
        for field, name, unit in _GIVEN
    ]
    return f"${listed(parts)}$"


def case_html(case: Any) -> str:
    """A motion, and how many times of it are wanted."""
    times = case.times
    ends = f"{_decimal(times[0])} s to {_decimal(times[-1])} s" if times else ""
    said = counted(len(times), "time") + (f", {ends}" if ends else "")
    title = head("Case", muted(_regime(case.motion)))
    return card(title, table((), [*_rows(case.motion), (muted("times"), said, "")]))


def _rows(motion: Any) -> Iterator[tuple[Any, ...]]:
    for field, name, unit in _GIVEN:
        yield muted(field), math(f"{name} = {_row(getattr(motion, field))}"), math(unit or r"\,")


def _row(values: Any) -> str:
    inside = r",\ ".join(map(_decimal, values))
    return f"({inside})"


def _decimal(value: Any) -> str:
    """Six digits, in LaTeX."""
    if isinstance(value, inputs.Uncertain):
        return rf"{_decimal(value.middle)} \pm {_decimal(value.radius)}"
    number, _, exponent = inputs.decimal(value, 6).lower().partition("e")
    number = number.rstrip("0").rstrip(".") if "." in number else number
    number = f"{{{number}}}" if value < 0 else number
    return rf"{number} \cdot 10^{{{int(exponent)}}}" if exponent else number


def _regime(motion: Any) -> str:
    try:
        return str(motion.regime)
    except InputError as error:
        return f"regime not certain: {error}"
