"""What `rigidsym fit -o DIR` leaves: JSON, a case file, a page, and pictures."""

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.fitting import report
from rigidsym.io.files import write_bytes, write_text
from rigidsym.view.fits import fit_page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rigidsym.fitting.found import Fit


def write(fit: "Fit", directory: Path) -> list[Path]:
    """Write fit.json, motion.toml, fit.html, and pictures where there is matplotlib."""
    pictures = _pictures(fit) if find_spec("matplotlib") else {}
    drawn = [(title, files["svg"].decode()) for title, files in pictures.values()]
    page = fit_page(report.title(fit), report.tables(fit), drawn)
    return [
        write_text(directory / "fit.json", report.to_json(fit)),
        write_text(directory / "motion.toml", report.case(fit)),
        write_text(directory / "fit.html", page),
        *(
            write_bytes(directory / f"{name}.{suffix}", data)
            for name, (_, files) in pictures.items()
            for suffix, data in files.items()
        ),
    ]


def _pictures(fit: "Fit") -> dict[str, tuple[str, dict[str, bytes]]]:
    from rigidsym.view.plots.histories import rendered

    drawn = {"residuals": ("Residuals", residuals(fit))}
    if any(fit.motion.exact["omega0"]):
        ends = fit.problem.times[[0, -1]]
        drawn["motion"] = ("The motion", fit.motion.plot(np.linspace(*ends, 801)))
    return {name: (title, rendered(figure)) for name, (title, figure) in drawn.items()}


def residuals(fit: "Fit") -> "Figure":
    """The picture of all residuals."""
    from rigidsym.view.plots.fits import Panel
    from rigidsym.view.plots.fits import residuals as draw

    named = {k: [i for place, i in fit.outliers if place == k] for k in range(len(fit.residuals))}
    whole = zip(fit.problem.sets, fit.residuals, strict=True)
    return draw([Panel(x.kind, x.t, found, named[k]) for k, (x, found) in enumerate(whole)])
