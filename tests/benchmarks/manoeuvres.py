"""Time that plans take, a check that they are the cheapest, and the time of shooting instead.

    python tests/benchmarks/manoeuvres.py [PROBLEMS] [--brute] [--shooting N] [--differences N]
    python tests/benchmarks/manoeuvres.py --quick           three problems, one of them by all ways

Random bodies (any, nearly symmetric, flat, rods, nearly spheres) and turns (any, by 180 degrees,
about the middle axis nearly, small, nearly symmetries), from rest to rest, by the C engine.
--brute: a search from 15 000 random rates, up to 1.05 of a momentum with which some motion arrives,
of which the best 1000 are refined, must find none cheaper.  --shooting N: N of the problems also by
SciPy's DOP853 at 1e-13, side by side: the same search with its motions integrated, all at once, and
refined by central differences; and plain shooting by least squares from a turn about the axis of
the whole turn, which finds some motion.
--differences N: N of the searches also refined by central differences instead of sensitivities.
"""

import sys
from pathlib import Path
from time import perf_counter, process_time

import bench
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

sys.path.insert(0, str(Path(__file__).parents[1]))
from random_manoeuvres import brute, manoeuvre, posed

from rigidsym import _engines as engines
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._families import families, least
from rigidsym.manoeuvre._problem import Problem
from rigidsym.validate.peers._integrators import rates

TOLERANCE = 1e-13
# Of central differences: their error and that of rounding are about the same.
STEP = 1e-5
GOAL_MS, RESIDUAL, DEARER = 20.0, 1e-12, 1e-9


def main() -> int:
    """Print every figure; 1 where a goal is missed."""
    looked = {"type": int, "default": 0, "metavar": "N"}
    brute_force = {"action": "store_true"}
    options = bench.options(__doc__, 1000, brute=brute_force, shooting=looked, differences=looked)
    if options.quick:
        options.rounds, options.shooting, options.differences = 3, 1, 1
    engine, problems = engines.engine("c"), [manoeuvre(k) for k in range(options.rounds)]
    solve(problems[0])
    milliseconds, residuals, dearer = [], [], []
    for k, asked in enumerate(problems):
        begin = perf_counter()
        best = solve(asked).best
        milliseconds.append(1e3 * (perf_counter() - begin))
        residuals.append(best.residual)
        if options.brute:
            one = posed(asked, engine)
            found = brute(one, np.random.default_rng(k)) * float(max(asked.inertia))
            if not np.isfinite(found):
                sys.exit(f"problem {k}: brute force found no motion, which proves nothing")
            dearer.append(best.momentum / found - 1)
            if dearer[-1] > DEARER:
                print(f"problem {k}: {best.momentum} where {found} would do")
    failed = _report(milliseconds, residuals, dearer)
    if options.shooting:
        _shooting(problems[: options.shooting])
    if options.differences:
        _differences(problems[: options.differences])
    return int(failed and not options.quick)


def _report(milliseconds, residuals, dearer) -> bool:
    mean, median, worst = np.mean(milliseconds), np.median(milliseconds), np.max(milliseconds)
    print(f"{len(milliseconds)} plans: {mean:.1f} ms on average (goal {GOAL_MS}),", end=" ")
    print(f"median {median:.1f}, longest {worst:.1f}")
    print(f"largest residual {max(residuals):.1e} rad (goal {RESIDUAL})")
    if dearer:
        better = sum(x < -DEARER for x in dearer)
        print(f"dearer than brute force by at most {max(dearer):.1e}; cheaper in {better}")
    return mean > GOAL_MS or max(residuals) > RESIDUAL or max(dearer, default=0) > DEARER


class Integrated:
    """Engine by SciPy's DOP853, which integrates all bodies in one run."""

    def propagate(self, inertia, omega0, attitude0, t):
        omega0 = np.asarray(omega0)
        shape, count = omega0.shape, omega0.size // 3
        begin = np.concatenate([np.broadcast_to(attitude0, (count, 4)), omega0.reshape(-1, 3)], 1)

        def right_side(_, y):
            return np.concatenate(rates(y.reshape(7, count), inertia))

        found = solve_ivp(
            right_side, (0, t[-1]), begin.T.ravel(), "DOP853", rtol=TOLERANCE, atol=TOLERANCE
        )
        end = found.y[:, -1].reshape(7, *shape[:-1], 1)
        return np.moveaxis(end[:4], 0, -1), np.moveaxis(end[4:], 0, -1)


class Differenced(Problem):
    """Problem whose slopes are central differences, computed in one batch."""

    def slopes(self, rates):
        moved = STEP * np.concatenate([np.zeros((1, 3)), np.eye(3), -np.eye(3)])
        found = self.misses(rates[:, None] + moved)
        return found[:, 0], np.swapaxes(found[:, 1:4] - found[:, 4:], 1, 2) / (2 * STEP)


def _differences(problems) -> None:
    """Print the time of searches by differences over that by sensitivities; they take turns."""
    spent = np.zeros((len(problems), 2))
    for k, asked in enumerate(problems):
        exact = posed(asked, engines.engine("c"))
        ways = exact, Differenced(exact.inertia, exact.turn, exact.engine)
        for way, one in enumerate(ways):
            begin = process_time()
            families(one, least(one))
            spent[k, way] = process_time() - begin
    ratio = spent[:, 1].sum() / spent[:, 0].sum()
    print(f"{len(problems)} searches refined by differences: {ratio:.2f} times as long")


def _shooting(problems) -> None:
    """Print the time of a search by C, by DOP853, and of shooting from one start."""
    spent, dearer = np.zeros(3), 0
    for asked in problems:
        exact = posed(asked, engines.engine("c"))
        # Integrated motions come without sensitivities.
        ways = exact, Differenced(exact.inertia, exact.turn, Integrated())
        cheapest = []
        for k, one in enumerate(ways):
            begin = process_time()
            cheapest.append(one.momenta(families(one, least(one)))[0])
            spent[k] += process_time() - begin
        begin = process_time()
        one = ways[1]
        shot = least_squares(one.misses, one.angle * one.axis, xtol=TOLERANCE, method="lm").x
        spent[2] += process_time() - begin
        arrives = np.linalg.norm(one.misses(shot)) < 1e-9
        dearer += not (arrives and one.momenta(shot) <= cheapest[0] * (1 + DEARER))
    c, integrated, shot = 1e3 * spent / len(problems)
    print(f"{len(problems)} searches: C {c:.1f} ms, DOP853 {integrated:.0f} ms,", end=" ")
    print(f"{integrated / c:.0f} times; one shot {shot:.0f} ms, {shot / c:.1f} times,", end=" ")
    print(f"not the cheapest in {dearer}")


if __name__ == "__main__":
    sys.exit(main())
