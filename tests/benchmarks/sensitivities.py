"""States with their sensitivities beside states alone, and beside heyoka's variational equations.

    python tests/benchmarks/sensitivities.py [ROUNDS]

The paper's motion, and one near the separatrix, at 1000 times in [0, 100] s.  What is compared
takes turns; ratios are of the medians.  Needs the extra `bench` for heyoka, a C compiler for C.
"""

import sys
from collections.abc import Callable, Iterable
from importlib.util import find_spec
from statistics import median
from time import perf_counter

import numpy as np

from rigidsym import TorqueFreeMotion
from rigidsym.engines import ENGINES

MOTIONS = {
    "paper": ((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)),
    "near the separatrix": ((0.3, 0.5, 0.6), (0.01, 1.0, 0.02)),
}
TIMES = np.linspace(0.0, 100.0, 1000)
# Of a state alone: what a state with its sensitivities may take.
GOALS = {"numpy": 6.0, "c": 10.0}
Work = Callable[[], object]


def main(rounds: int) -> int:
    """Print every ratio; 1 where a goal is missed."""
    met = True
    for name, (inertia, omega0) in MOTIONS.items():
        for engine in ENGINES:
            motion = TorqueFreeMotion(inertia, omega0, engine=engine)
            alone, both = medians(
                [lambda m=motion: m(TIMES), lambda m=motion: m.sensitivity(TIMES)], rounds
            )
            met &= both <= GOALS[engine] * alone
            share = f"{both / alone:5.1f} states alone (goal: {GOALS[engine]:g})"
            print(f"{name}: {engine}: {_each(both)} a state with sensitivities, {share}")
        if find_spec("heyoka"):
            _beside_heyoka(name, inertia, omega0, rounds)
    return int(not met)


def _beside_heyoka(name: str, inertia, omega0, rounds: int) -> None:
    motion = TorqueFreeMotion(inertia, omega0, engine="c")
    run = heyoka_variations(inertia, omega0)
    ours, theirs = medians([lambda: motion.sensitivity(TIMES), run], rounds)
    print(f"{name}: heyoka, var_ode_sys: {_each(theirs)}, {theirs / ours:.0f} times C's")


def heyoka_variations(inertia, omega0) -> Work:
    """q and omega by q0, omega0 and the moments: order 1, Taylor's method at full precision."""
    import heyoka as hy

    names = hy.make_vars("q0", "q1", "q2", "q3", "w1", "w2", "w3")
    q, w, c = names[:4], names[4:], [hy.par[k] for k in range(3)]
    rates = [
        -0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]),
        0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
        0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]),
        0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]),
        (c[1] - c[2]) / c[0] * w[1] * w[2],
        (c[2] - c[0]) / c[1] * w[2] * w[0],
        (c[0] - c[1]) / c[2] * w[0] * w[1],
    ]
    system = hy.var_ode_sys(list(zip(names, rates, strict=True)), [*names, *c], order=1)
    start = [1.0, 0.0, 0.0, 0.0, *omega0]
    integrator = hy.taylor_adaptive(system, start, pars=list(inertia), tol=1e-16)
    begin = integrator.state.copy()

    def run() -> object:
        integrator.time = 0.0
        integrator.state[:] = begin
        return integrator.propagate_grid(TIMES)

    return run


def medians(works: Iterable[Work], rounds: int) -> list[float]:
    """The median time of each, s; they take turns."""
    listed = list(works)
    found: list[list[float]] = [[] for _ in listed]
    for _ in range(rounds + 1):
        for times, work in zip(found, listed, strict=True):
            begin = perf_counter()
            work()
            times.append(perf_counter() - begin)
    return [median(times[1:]) for times in found]


def _each(seconds: float) -> str:
    return f"{1e9 * seconds / TIMES.size:.0f} ns"


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 25))
