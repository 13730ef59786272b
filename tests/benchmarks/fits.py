"""Time of a fit with and without a guess, and of the same fit by numerical integration.

    python tests/benchmarks/fits.py [--looks 1000] [--starts 10000] [--engine c]
    python tests/benchmarks/fits.py --quick                 few looks, starts and runs

Simulated attitudes of a triaxial body in long-axis mode.  The rival is SciPy's `least_squares` with
its own differences over SciPy's DOP853, from the same start, and has to end at the same minimum.
Times are of the processor, the least of some runs, so that others on the machine count for little;
what counts is their ratio, side by side.
"""

import sys
from dataclasses import replace
from pathlib import Path
from time import process_time
from timeit import repeat

import bench
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

import rigidsym
from rigidsym.fitting import Attitudes
from rigidsym.fitting._estimate import solved, started
from rigidsym.fitting._minimise import minimise
from rigidsym.fitting._observations import middle
from rigidsym.fitting._parameters import Parameters
from rigidsym.fitting._problem import Problem
from rigidsym.validate.peers._integrators import rates

sys.path.insert(0, str(Path(__file__).parents[1]))
from simulated import TUMBLING, attitudes

SIGMA, TURNS = 1e-3, 10.0
# The rival's: coarser ones end elsewhere, finer ones take longer.
TOLERANCE = 1e-10


def best_of(count, run):
    """Return the least processor time of some runs, s, and what the last of them found."""
    found = []
    times = repeat(lambda: found.append(run()), number=1, repeat=count, timer=process_time)
    return min(times), found[-1]


def integrated(problem, start):
    """Solve the least squares of a problem by DOP853 and derivatives by differences."""
    (one,) = problem.sets

    def residuals(x):
        point = problem.parameters.moved(start, x)
        inertia = tuple(point.moments)
        found = solve_ivp(
            lambda t, y: rates(y, inertia),
            (0, one.t[-1]),
            [*point.attitude, *point.omega],
            "DOP853",
            one.t,
            rtol=TOLERANCE,
            atol=TOLERANCE,
        )
        q = found.y[:4].T
        q = q / np.linalg.norm(q, axis=1, keepdims=True)
        return one.whitened(one.residuals(q, found.y[4:].T)[..., None]).ravel()

    found = least_squares(residuals, np.zeros(problem.parameters.count), x_scale="jac")
    return problem.parameters.moved(start, found.x), 2 * found.cost


def main():
    """Print the time of each kind of fit."""
    looks, starts = ({"type": int, "default": x} for x in (1000, 10000))
    asked = bench.options(__doc__, looks=looks, starts=starts, engine={"default": "c"})
    if asked.quick:
        asked.looks, asked.starts = 30, 200
    runs, turns = (1, 2.0) if asked.quick else (25, TURNS)
    random = np.random.default_rng(1)
    t = np.sort(random.uniform(0, 2 * np.pi * turns, asked.looks))
    seen = Attitudes(t, attitudes(TUMBLING, t, SIGMA, random), SIGMA)
    problem = Problem((seen,), Parameters(), engine=asked.engine, epoch=middle([seen]))
    guess = TUMBLING.replace(inertia=(1.0, 0.86, 0.405), omega0=(0.302, -0.503, 1.104))
    problem, start = started(problem, guess, None)
    own, found = best_of(runs, lambda: minimise(problem, start))
    print(f"local fit, {asked.looks} attitudes: {own * 1e3:.3g} ms, chi2 {found.cost:.6f}")
    motion = TUMBLING.replace(engine=asked.engine)
    one, _ = best_of(runs, lambda: motion.sensitivity(t))
    print(f"in calls of motion.sensitivity at these times: {own / one:.0f}")
    fits = [rigidsym.fit(attitudes=seen, guess=guess, engine=asked.engine) for _ in range(9)]
    for name in ("covariance", "nonlinearity"):
        times = [best_of(1, lambda fit=fit, name=name: getattr(fit, name))[0] for fit in fits]
        print(f"{name} of a fit: {min(times) * 1e3:.3g} ms")
    at_zero, start = started(replace(problem, epoch=0.0), guess, None)
    theirs, (point, cost) = best_of(1, lambda: integrated(at_zero, start))
    omega = np.array(solved(problem, found.point, None).motion.omega0, float)
    same = np.max(np.abs(point.omega - omega))
    print(f"by DOP853 and differences: {theirs:.3g} s, chi2 {cost:.6f}, rates {same:.1e} apart")
    print(f"ratio: {theirs / own:.0f}")
    whole, fit = best_of(
        1,
        lambda: rigidsym.fit(attitudes=seen, starts=asked.starts, fastest=4.0, engine=asked.engine),
    )
    print(f"search from {asked.starts} starts: {whole:.3g} s, chi2 {fit.chi2:.6f}")


if __name__ == "__main__":
    main()
