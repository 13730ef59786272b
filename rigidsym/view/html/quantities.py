"""Numbers and their units, as rows of the tables that show motions and manoeuvres."""

from collections.abc import Iterable
from fractions import Fraction

from rigidsym import inputs
from rigidsym.inputs import Number
from rigidsym.view.html.cards import math, muted
from rigidsym.view.html.markup import Markup

RATE, MOMENTUM = r"\mathrm{rad/s}", r"\mathrm{N\,m\,s}"
INERTIA = r"\mathrm{kg\,m^2}"


GIVEN, COMPUTED = 6, 4
"Digits of what a user gave, and of what was computed."


def decimal(value: Number | float, digits: int = GIVEN) -> str:
    """So many digits, in LaTeX."""
    if isinstance(value, inputs.Uncertain):
        return rf"{decimal(value.middle)} \pm {decimal(value.radius)}"
    number, _, exponent = inputs.decimal(Fraction(value), digits).lower().partition("e")
    number = number.rstrip("0").rstrip(".") if "." in number else number
    number = f"{{{number}}}" if value < 0 else number
    return rf"{number} \cdot 10^{{{int(exponent)}}}" if exponent else number


def vector(values: Iterable[Number | float], digits: int = GIVEN) -> str:
    """Its components, in LaTeX."""
    inside = r",\ ".join(decimal(value, digits) for value in values)
    return f"({inside})"


def row(field: str, latex: str, unit: str) -> tuple[Markup, Markup, Markup]:
    """A name, what it is, and the unit, "" where there is none."""
    return muted(field), math(latex), math(unit or r"\,")
