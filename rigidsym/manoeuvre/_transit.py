"""Times at which the momentum passes given points of its polhode.

The formulas are the ledger's, evaluated over arrays; their argument u, an elliptic integral of the
first kind, is Carlson's R_F by SciPy.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from scipy.special import elliprf

from rigidsym.manoeuvre._problem import IDENTITY, Problem
from rigidsym.solution._formulas import sequence
from rigidsym.solution._partition import GIVEN, ONES, ROOT, SIGNS, handedness
from rigidsym.solution._polhode import discriminant


def _choose(
    x: np.ndarray | float, y: np.ndarray | float, one: np.ndarray | int, other: np.ndarray | int
) -> np.ndarray | int:
    """Select `one` where x <= y, and `other` elsewhere."""
    first = x <= y
    if isinstance(first, np.ndarray):
        return np.where(first, one, other)
    return one if first else other


# Squares are faster by the operator than by np.power, which takes logarithms.
_FUNCTIONS = {"sqrt": np.sqrt, "power": pow, "choose": _choose}
_WANTED = frozenset({"sn", "cn", "dn", "lambda_", "m", "m_1"})


@dataclass(frozen=True, slots=True)
class Phases:
    """Phases of unit momenta on their polhodes.

    All fields are arrays (N,).

    u: the argument of Jacobi's functions.  quarter: K(m).  speed: du/dt.  branch: which of the
    four families of polhodes, about either end of the axis of largest or of smallest moment.
    """

    u: np.ndarray
    quarter: np.ndarray
    speed: np.ndarray
    branch: np.ndarray

    @property
    def period(self) -> np.ndarray:
        """Periods with which the momenta go round their polhodes."""
        return 4 * self.quarter / self.speed


@np.errstate(divide="ignore", invalid="ignore")
def phases(problem: Problem, momenta: np.ndarray) -> Phases:
    """Return the phases of unit momenta (N, 3) on their polhodes.

    They are NaN where the momentum does not move.
    """
    low, middle, high = problem.axes
    c, rates = problem.inertia, momenta / problem.inertia
    # 1 or -1 where rates circulate about the axis of largest or smallest moment, 0 for constant
    # rates; the ledger's formulas want the axes sorted by their moments, largest first.
    differences = [c[j] - c[k] for j, k in combinations((high, middle, low), 2)]
    asked = [*differences, *(rates[:, k] for k in (high, middle, low))]
    signs = [*(np.sign(np.abs(x)) for x in asked), discriminant([*c], [*rates.T])]
    partition: dict[str, np.ndarray | int] = dict(zip(GIVEN, signs, strict=True)) | ONES
    sides = np.asarray(sequence("decisions").evaluate(partition, _FUNCTIONS)[ROOT])
    found = np.full((4, len(momenta)), np.nan)
    for side, axes in ((1, (high, middle, low)), (-1, (low, middle, high))):
        chosen = sides == side
        if chosen.any():
            found[:, chosen] = _circulating(c, rates[chosen], axes)
    return Phases(*found)


def _circulating(c: np.ndarray, rates: np.ndarray, axes: tuple[int, int, int]) -> np.ndarray:
    """Return the phases (4, N) of motions that circulate about the first of the axes.

    chi is 1 for all, so that phases are counted from the same point.
    """
    known: dict[str, np.ndarray | int] = {}
    for name, k in zip("abd", axes, strict=True):
        known |= {f"c_{name}": c[k], f"Omega_{name}": rates[:, k]}
    begin = {"epsilon": handedness(*axes), "c_ad": c[axes[0]] - c[axes[2]]}
    signs = sequence("signs").evaluate(known | begin, _FUNCTIONS)
    known |= {name: signs[name] for name in SIGNS} | {"chi": 1}
    known = sequence("constants").up_to(_WANTED).evaluate(known, _FUNCTIONS)
    sn, cn, dn = known["sn"], known["cn"], known["dn"]
    quarter = elliprf(0.0, np.clip(known["m_1"], 0.0, 1.0), 1.0)
    within = sn * elliprf(cn * cn, dn * dn, 1.0)
    u = np.where(cn < 0, np.copysign(2 * quarter, sn) - within, within)
    return np.array([u, quarter, known["lambda_"], known["sigma"] * (1.5 + 0.5 * known["rho"])])


@np.errstate(divide="ignore", invalid="ignore")
def transits(problem: Problem, momenta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the times at which momenta first reach their final directions, and the periods.

    Momenta have the shape (N, 3), times and periods (N,).

    They arrive where the turn puts them, and have size 1.  NaN where they never arrive, being on
    another polhode, or do not move.
    """
    count = len(momenta)
    both = phases(problem, np.concatenate([momenta, momenta @ problem.rotation]))
    first = np.mod(both.u[count:] - both.u[:count], 4 * both.quarter[:count]) / both.speed[:count]
    arrives = both.branch[:count] == both.branch[count:]
    return np.where(arrives, first, np.nan), both.period[:count]


def peaks(problem: Problem, rates: np.ndarray) -> np.ndarray:
    """Return the peak rate |omega| of motions that reach the target in time 1.

    Peaks have the shape (N,), initial rates (N, 3).

    Motions take time 1.  On a polhode |omega|^2 is linear in sn^2, so that its extremes are at the
    ends of the motion and where the argument of Jacobi's functions passes a multiple of K(m) (facts
    regular.speed, regular.speed_rate).
    """
    sizes = problem.momenta(rates)
    momenta = problem.inertia * rates / np.where(sizes > 0, sizes, 1.0)[:, None]
    where = phases(problem, momenta)
    u, quarter, speed = where.u[:, None], where.quarter[:, None], where.speed[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        passed = np.ceil(u / quarter) + np.arange(2)
        times = (passed * quarter - u) / (speed * sizes[:, None])
    # Time 1 replaces times that never come, or come too late.
    times = np.concatenate([times, np.ones((len(rates), 1))], axis=1)
    times = np.where((times > 0) & (times < 1), times, 1.0)
    _, later = problem.engine.propagate(
        problem.inertia, rates[:, None] * times[..., None], IDENTITY, np.ones(1)
    )
    reached = np.linalg.norm(later[..., 0, :], axis=-1) / times
    return np.maximum(np.linalg.norm(rates, axis=1), reached.max(axis=1))
