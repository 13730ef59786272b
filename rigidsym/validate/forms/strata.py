"""The worst errors of each form in each stratum of motions, in NumPy."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from rigidsym import engines
from rigidsym.codegen.forms import PI, THETA, key
from rigidsym.validate.forms.fourier import Series
from rigidsym.validate.measure import measure
from rigidsym.validate.oracle import enclose
from rigidsym.validate.peers.protocol import Solver
from rigidsym.validate.strata import STRATA, count, draw

FOURIER = "Fourier"
COLUMNS = ("stratum", "form", "served", "angle, rad", "rates")
_DIGITS, _SEED = 40, 0


@dataclass(frozen=True, slots=True)
class StratumError:
    """One form in a stratum: how many of its cases it serves, and the worst errors in these.

    angle: rad.  omega: over |omega|.  None where it serves no case.
    """

    stratum: str
    form: str
    served: int
    cases: int
    angle: float | None
    omega: float | None

    def row(self) -> tuple[str, ...]:
        """A line of the table."""
        errors = ("" if x is None else f"{x:.1e}" for x in (self.angle, self.omega))
        return self.stratum, self.form, f"{self.served} of {self.cases}", *errors


def by_stratum(cases: int, progress: Callable[[int, int], None]) -> list[StratumError]:
    """The errors of every form in every stratum, of so many cases each."""
    forms = {form: engines.exactly(key("numpy", form)) for form in (THETA, PI)}
    found: list[StratumError] = []
    for done, stratum in enumerate(STRATA):
        progress(done, len(STRATA))
        found += _of_stratum(stratum, {**forms, FOURIER: Series()}, count(stratum, cases))
    progress(len(STRATA), len(STRATA))
    return found


def _of_stratum(
    stratum: str, forms: Mapping[str, engines.Engine | Solver], cases: int
) -> list[StratumError]:
    drawn = [draw(stratum, index, _SEED) for index in range(cases)]
    references = [enclose(sample, _DIGITS, with_condition=False) for sample in drawn]
    found = []
    for name, form in forms.items():
        measured = [measure(reference, form) for reference in references]
        worst = [tuple(np.max(each[x].values) for x in ("angle", "omega")) for each in measured]
        # What a form refuses is infinitely wrong.
        served = [pair for pair in worst if np.isfinite(pair).all()]
        errors = [float(max(values)) for values in zip(*served, strict=True)] or [None, None]
        found.append(StratumError(stratum, name, len(served), cases, *errors))
    return found
