"""The figures of the page."""

import math

from rigidsym.view.html.markup import Markup, join, lines, tag
from rigidsym.view.report_data import MOST_CONDITION, ByMeasure, Report
from rigidsym.view.validation import figures
from rigidsym.view.validation.histogram import common, histogram
from rigidsym.view.validation.marks import legend
from rigidsym.view.validation.scatter import Labels, scatter

Y_LABELS = {"angle": "angle error (rad)", "omega": "rate error (relative)"}
NAMES = {"angle": "Angle error (rad)", "omega": "Rate error (relative to |ω|)"}
# View, heading, abscissa, the names of its zero and of what is beyond all decades, and what to look
# for.
VIEWS: tuple[tuple[ByMeasure, str, str, tuple[str, str], str], ...] = (
    (
        "distance",
        "Error and distance from the separatrix",
        "distance from the separatrix (1: nothing cancels, 0: on it)",
        ("on it", "∞"),
        "On the separatrix itself (left) and ever nearer to it, where solutions fly apart: "
        "a sound module shows no rise to the left.",
    ),
    (
        "turned",
        "Error and time",
        "angle turned, |ω₀t| (rad)",
        ("t = 0", "∞"),
        "Times from the start on (left), as the angle that the body has turned by: "
        "errors that accumulate rise to the right.",
    ),
    (
        "condition",
        "Error and condition number",
        "condition number κ",
        ("0", f"> {figures.power(10, math.log10(MOST_CONDITION))}"),
        "κ is how far a relative change of the inputs moves the true state, by its derivatives. "
        "A module that is no better than its inputs rises with κ; one that solves the given "
        "problem stays below the bound: what is ill-conditioned is told apart from what is "
        "computed badly.",
    ),
)


def views(data: Report) -> Markup:
    """Errors against distance, time and condition."""
    return tag(
        "section",
        tag("h2", "Where errors are large"),
        tag(
            "p",
            "Each mark is the worst state of its decade; point at one for its case. "
            "“None” marks states for which no number came out; below 10⁻²⁰ decades are closer.",
        ),
        legend(data["implementations"]),
        *(_view(data, *view) for view in VIEWS),
        id="plots",
    )


def sizes(data: Report) -> Markup:
    """How errors are distributed, stratum by stratum."""
    return tag(
        "section",
        tag("h2", "How large errors are"),
        tag(
            "p",
            "States by the size of their error, in half octaves; a row for each implementation, in "
            "the order of the legend and scaled to its highest bar. "
            "The dashed line is the documented bound.",
        ),
        legend(data["implementations"]),
        *(_sizes(data, measure) for measure in NAMES),
        id="sizes",
    )


def _view(
    data: Report, view: ByMeasure, heading: str, x: str, ends: tuple[str, str], remark: str
) -> Markup:
    pictures = [
        scatter(
            data["implementations"],
            view,
            measure,
            data["bounds"][measure],
            Labels(x, y_label, *ends),
        )
        for measure, y_label in Y_LABELS.items()
    ]
    caption = tag("figcaption", tag("strong", heading), ". ", remark)
    return tag("figure", caption, tag("div", *pictures, class_="pair"), id=f"plot-{view}")


def _sizes(data: Report, measure: str) -> Markup:
    bound = data["bounds"][measure]
    axis = common(data["implementations"], measure, bound)
    pictures = [
        tag(
            "figure",
            tag("figcaption", stratum["name"]),
            histogram(data["implementations"], stratum["name"], measure, bound, axis),
        )
        for stratum in data["strata"]
    ]
    grid = tag("div", lines(*pictures), class_="multiples", id=f"sizes-{measure}")
    return join(tag("h3", NAMES[measure]), grid)
