"""When a momentum has gone from one point of its polhode to another, in Jacobi's functions.

The formulas are the ledger's, evaluated over arrays; the argument u that their reading names, an
elliptic integral of the first kind, is Carlson's R_F by SciPy.
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import elliprf

from rigidsym.manoeuvre.problem import Problem
from rigidsym.solution.formulas import sequence

_FUNCTIONS = {"sqrt": np.sqrt, "power": np.power}
_WANTED = frozenset({"sn", "cn", "dn", "lambda_", "m", "m_1"})


@dataclass(frozen=True, slots=True)
class Phases:
    """Where momenta of size 1 are on their polhodes; arrays (N,).

    u: the argument of Jacobi's functions.  quarter: K(m).  speed: du/dt.  branch: which of the
    four families of polhodes, about either end of the axis of largest or of smallest moment.
    """

    u: np.ndarray
    quarter: np.ndarray
    speed: np.ndarray
    branch: np.ndarray

    @property
    def period(self) -> np.ndarray:
        """After which momenta are where they were."""
        return 4 * self.quarter / self.speed


@np.errstate(divide="ignore", invalid="ignore")
def phases(problem: Problem, momenta: np.ndarray) -> Phases:
    """Of momenta (N, 3) of size 1; not a number where the momentum does not move."""
    low, middle, high = problem.axes
    c, rates = problem.inertia, momenta / problem.inertia
    # The sign of E_b = K^2 - 2 H c_b tells the circulations apart.
    about_high = (
        c[high] * (c[high] - c[middle]) * rates[:, high] ** 2
        >= c[low] * (c[middle] - c[low]) * rates[:, low] ** 2
    )
    found = np.empty((4, len(momenta)))
    for chosen, axes in ((about_high, (high, middle, low)), (~about_high, (low, middle, high))):
        if chosen.any():
            found[:, chosen] = _circulating(c, rates[chosen], axes, problem.axes)
    return Phases(*found)


def _circulating(
    c: np.ndarray, rates: np.ndarray, axes: tuple[int, int, int], order: tuple[int, int, int]
) -> np.ndarray:
    about_high = axes[0] == order[2]
    known = _constants(c, rates, axes, 1 if about_high else -1)
    sn, cn, dn = known["sn"], known["cn"], known["dn"]
    quarter = elliprf(0.0, np.clip(known["m_1"], 0.0, 1.0), 1.0)
    within = sn * elliprf(cn * cn, dn * dn, 1.0)
    u = np.where(cn < 0, np.copysign(2 * quarter, sn) - within, within)
    return np.array([u, quarter, known["lambda_"], known["sigma"] * (2 if about_high else 1)])


def _constants(
    c: np.ndarray, rates: np.ndarray, axes: tuple[int, int, int], rho: int
) -> dict[str, np.ndarray | int]:
    """What the ledger's formulas of a plan give for arrays; chi is 1 for all, so that phases are
    counted from the same point."""
    known: dict[str, np.ndarray | int] = {"chi": 1, "rho": rho}
    known["epsilon"] = 1 if axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1
    known["sigma"] = np.where(rates[:, axes[0]] < 0, -1, 1)
    for name, k in zip("abd", axes, strict=True):
        known |= {f"c_{name}": c[k], f"Omega_{name}": rates[:, k]}
    return sequence("constants").up_to(_WANTED).evaluate(known, _FUNCTIONS)


@np.errstate(divide="ignore", invalid="ignore")
def transits(problem: Problem, momenta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """First times (N,) at which momenta (N, 3) of size 1 are where the turn puts them, and periods.

    Not a number where they never are, being on another polhode, or do not move.
    """
    begin, end = phases(problem, momenta), phases(problem, momenta @ problem.rotation)
    first = np.mod(end.u - begin.u, 4 * begin.quarter) / begin.speed
    return np.where(begin.branch == end.branch, first, np.nan), begin.period
