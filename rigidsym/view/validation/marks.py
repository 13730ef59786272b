"""Marks of implementations: one colour and one shape each, told apart without colour too."""

from collections.abc import Sequence

from rigidsym.view.html.markup import Markup, join, tag
from rigidsym.view.palette import SERIES, SERIES_ON_DARK
from rigidsym.view.report_data import Implementation

RADIUS = 4.0
# Corners around the centre, in radii; none for a circle.
SHAPES: tuple[Sequence[tuple[float, float]], ...] = (
    (),
    ((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)),
    ((0, -1.2), (1.1, 0.9), (-1.1, 0.9)),
    ((0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0)),
    ((0, 1.2), (1.1, -0.9), (-1.1, -0.9)),
    ((-0.5, -1.2), (0.5, -1.2), (0.5, 1.2), (-0.5, 1.2)),
    ((-1.2, -0.5), (1.2, -0.5), (1.2, 0.5), (-1.2, 0.5)),
)


def colour(k: int) -> str:
    """The class of what is drawn in the colour of implementation k."""
    return f"c{k % len(SERIES)}"


def mark(k: int, x: float, y: float, title: str) -> Markup:
    """The mark of implementation k, with what a pointer over it says."""
    return _shape(k, x, y, f"mark {colour(k)}", tag("title", title))


def legend(implementations: Sequence[Implementation]) -> Markup:
    """Whose marks are whose."""
    return tag("ul", *(_entry(k, one) for k, one in enumerate(implementations)), class_="legend")


def palette() -> str:
    """The colours as a style sheet, on light and on dark ground."""
    light, dark = (_rules(colours) for colours in (SERIES, SERIES_ON_DARK))
    return f"{light}\n@media screen and (prefers-color-scheme: dark) {{\n{dark}\n}}"


def _rules(colours: Sequence[str]) -> str:
    return "\n".join(f".c{k} {{ --series: {name}; }}" for k, name in enumerate(colours))


def _entry(k: int, one: Implementation) -> Markup:
    drawn = _shape(k, 6.0, 6.0, f"key {colour(k)}")
    picture = tag("svg", drawn, viewBox="0 0 12 12", width=12, height=12, aria_hidden="true")
    return tag("li", join(picture, " ", one["name"]))


def _shape(k: int, x: float, y: float, class_: str, *inside: Markup) -> Markup:
    corners = SHAPES[k % len(SHAPES)]
    if not corners:
        return tag("circle", *inside, class_=class_, cx=x, cy=y, r=RADIUS)
    points = " ".join(f"{x + RADIUS * a:.2f},{y + RADIUS * b:.2f}" for a, b in corners)
    return tag("polygon", *inside, class_=class_, points=points)
