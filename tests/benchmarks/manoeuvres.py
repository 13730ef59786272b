"""How long plans take, whether they are the cheapest there are, and what shooting costs instead.

    python tests/benchmarks/manoeuvres.py [PROBLEMS] [--brute] [--shooting]

Random bodies (any, nearly symmetric, flat, rods, nearly spheres) and turns (any, by 180 degrees,
about the middle axis nearly, small, nearly symmetries), from rest to rest, by the C engine.
--brute: a search from 15 000 random rates, of which the best 1000 are refined, must find none
cheaper.  --shooting: the same plan with its motions integrated by SciPy's DOP853.
"""

import argparse
import sys
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))
from random_manoeuvres import brute, manoeuvre, posed

from rigidsym import engines
from rigidsym.manoeuvre import solve

GOAL_MS, RESIDUAL, DEARER = 20.0, 1e-12, 1e-9


def main(arguments) -> int:
    """Print every figure; 1 where a goal is missed."""
    options = _options(arguments)
    engine, problems = engines.engine("c"), [manoeuvre(k) for k in range(options.problems)]
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
            dearer.append(best.momentum / found - 1)
            if dearer[-1] > DEARER:
                print(f"problem {k}: {best.momentum} where {found} would do")
    failed = _report(milliseconds, residuals, dearer)
    return int(failed)


def _options(arguments):
    parser = argparse.ArgumentParser()
    parser.add_argument("problems", nargs="?", type=int, default=1000)
    parser.add_argument("--brute", action="store_true")
    return parser.parse_args(arguments)


def _report(milliseconds, residuals, dearer) -> bool:
    mean, median, worst = np.mean(milliseconds), np.median(milliseconds), np.max(milliseconds)
    print(f"{len(milliseconds)} plans: {mean:.1f} ms on average (goal {GOAL_MS}),", end=" ")
    print(f"median {median:.1f}, longest {worst:.1f}")
    print(f"largest residual {max(residuals):.1e} rad (goal {RESIDUAL})")
    if dearer:
        better = sum(x < -DEARER for x in dearer)
        print(f"dearer than brute force by at most {max(dearer):.1e}; cheaper in {better}")
    return mean > GOAL_MS or max(residuals) > RESIDUAL or max(dearer, default=0) > DEARER


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
