"""Time of states with sensitivities over states alone, and of heyoka's variational equations.

    python tests/benchmarks/sensitivities.py [ROUNDS]
    python tests/benchmarks/sensitivities.py --quick        few times, one round, goals not judged

The paper's motion, and one near the separatrix, at times in [0, 100] s.  What is compared takes
turns, in each of which the last of three runs counts: memory is there by then, as it is for who
calls again.  Times are of the processor; ratios are of their medians.  heyoka (extra `bench`) has
the same ten parameters, and with six less: those of the attitude at t = 0 are trivial, which is for
its user to know; each time in its fastest way of those in `heyoka_ways`.  Errors are the largest of
a column's, over what is larger: the column, or the change that it is by.  Needs a C compiler for C.
Beside C's ratios stand those of one group of columns, and what filling the same arrays takes.
"""

import sys
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from statistics import median
from time import process_time
from timeit import repeat

import bench
import numpy as np

from rigidsym import TorqueFreeMotion
from rigidsym._engines import ENGINES
from rigidsym.quaternions import conjugate, product

MOTIONS = {
    "paper": ((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)),
    "near the separatrix": ((0.3, 0.5, 0.6), (0.01, 1.0, 0.02)),
}
LAST, SIZES, COMPARED = 100.0, (1, 10, 1000, 10_000, 100_000), 1000
# Of a state alone: what a state with its sensitivities may take, at up to so many times: at one it
# is Python that takes time, at many more the memory of what is found.
GOALS, ASKED = {"numpy": 6.0, "c": 10.0}, {"numpy": 10_000, "c": 100_000}
# Of C's time: what heyoka should take at least.
SLOWER = 50.0
LANES, REPEATS = 8, 3
Work = Callable[[], object]


def main() -> int:
    """Print every ratio; return 1 where a goal is missed."""
    asked = bench.options(__doc__, 15)
    quick, rounds, met = asked.quick, asked.rounds, True
    bench.say_if_heyoka_is_missing()
    for name, (inertia, omega0) in MOTIONS.items():
        for engine in ENGINES:
            motion = TorqueFreeMotion(inertia, omega0, engine=engine)
            for size in SIZES[:3] if quick else SIZES:
                met &= _beside_states(f"{name}: {engine}", motion, size, rounds)
        if bench.HEYOKA and not quick:
            met &= _beside_heyoka(name, inertia, omega0, rounds)
    return int(not (met or quick))


def _beside_states(name: str, motion: TorqueFreeMotion, size: int, rounds: int) -> bool:
    times = np.linspace(0.0, LAST, size)
    alone, both = medians([lambda: motion(times), lambda: motion.sensitivity(times)], rounds)
    goal = GOALS[motion.engine]
    met = both <= goal * alone or not 10 <= size <= ASKED[motion.engine]
    said = f"{both / alone:5.1f} states alone" + ("" if met else f", goal {goal:g} MISSED")
    print(f"{name}, {size} times: {_each(both, size)} with sensitivities, {said}")
    if motion.engine == "c" and size >= 10_000:
        _beside_memory(name, motion, times, alone, rounds)
    return met


def _beside_memory(
    name: str, motion: TorqueFreeMotion, times: np.ndarray, alone: float, rounds: int
) -> None:
    """Print the time of some columns alone, and that of the others over filling their arrays."""
    others = np.empty((times.size, 54))
    works = [
        lambda: motion.sensitivity(times),
        lambda: motion.sensitivity(times, columns=["omega0"]),
        # All of the arithmetic, and few numbers.
        lambda: motion.sensitivity(times, columns=["t"]),
        lambda: others.fill(0.0),
    ]
    every, by_rates, by_time, filled = medians(works, rounds)
    print(
        f"{name}, {times.size} times: columns of omega0 {by_rates / alone:.1f} states alone,",
        f"of t {by_time / alone:.1f}; the others {_each(every - by_time, times.size)},",
        f"{(every - by_time) / filled:.1f} times what filling their arrays takes",
    )


def _beside_heyoka(name: str, inertia, omega0, rounds: int) -> bool:
    times = np.linspace(0.0, LAST, COMPARED)
    motion = TorqueFreeMotion(inertia, omega0, engine="c")
    met = True
    for varied in (10, 6):
        ways = heyoka_ways(inertia, omega0, times, varied)
        ours, *theirs = medians([lambda: motion.sensitivity(times), *ways.values()], rounds)
        way, best = min(zip(ways, theirs, strict=True), key=lambda one: one[1])
        # The goal is about the same parameters.
        missed = f", goal {SLOWER:g} MISSED" if varied == 10 and best < SLOWER * ours else ""
        print(
            f"{name}: heyoka, {varied} parameters, {way}: {_each(best, COMPARED)},",
            f"{best / ours:.0f} times C's {_each(ours, COMPARED)}{missed}",
        )
        met &= not missed
    wrong = errors(inertia, omega0, np.linspace(0.0, LAST, 10 * LANES))
    print(f"{name}: errors:", ", ".join(f"{who} {error:.0e}" for who, error in wrong.items()))
    return met and wrong["c"] <= wrong["heyoka"]


# heyoka: Taylor's method at full precision, q and omega by their start and the moments.


@cache
def _integrators(varied: int):
    """Compile variational integrators of one motion, and of LANES at once.

    In compact mode: without it, compilation takes minutes, and ten parameters no less time.
    """
    import heyoka as hy

    moments = [hy.par[k] for k in range(3)]
    names, equations = bench.heyoka_system(moments)
    system = hy.var_ode_sys(equations, [*names, *moments][-varied:], order=1)
    options = {"tol": 1e-16, "compact_mode": True}
    one = hy.taylor_adaptive(system, [1.0] + [0.0] * 6, pars=[1.0] * 3, **options)
    start = np.repeat(one.state[:, None], LANES, axis=1)
    many = hy.taylor_adaptive_batch(system, start, pars=np.ones((3, LANES)), **options)
    return one, many, one.state.copy()


def heyoka_ways(inertia, omega0, times, varied: int) -> Mapping[str, Work]:
    """Return heyoka's ways to compute states and their derivatives at times."""
    one, many, begin = _integrators(varied)
    first = begin.copy()
    first[4:7] = omega0
    columns = np.ascontiguousarray(times.reshape(LANES, -1).T)

    def started():
        one.pars[:], one.time, one.state[:] = inertia, 0.0, first
        return one

    def in_lanes():
        # Each lane follows its share of the times, from where one pass before has been.
        heads = started().propagate_grid(columns[0])[-1]
        many.pars[:] = np.array(inertia)[:, None]
        many.set_time(columns[0].copy())
        many.state[:] = heads.T
        return many

    last = columns[-1].copy()
    return {
        "grid": lambda: started().propagate_grid(times)[-1],
        "dense": lambda: started().propagate_until(times[-1], c_output=True)[4](times),
        "grid in lanes": lambda: in_lanes().propagate_grid(columns)[1],
        "dense in lanes": lambda: in_lanes().propagate_until(last, c_output=True)[0](columns),
    }


def errors(inertia, omega0, times) -> dict[str, float]:
    """Return the largest error of columns by omega0 and moments, of heyoka and the engines."""
    exact = TorqueFreeMotion(inertia, omega0).precise(times, 30, sensitivity=True)[2]
    true = _columns(exact.attitude.astype(float), exact.rates.astype(float))
    spin = np.linalg.norm(omega0)
    # The change itself: one of omega0, or of all rates by that of a moment.
    itself = np.concatenate([np.ones(3), spin / np.array(inertia)])
    size = np.maximum(np.linalg.norm(true, axis=1), itself)
    rows = heyoka_ways(inertia, omega0, times, 10)["grid"]()
    # Changes (N, 6, 6) of turns and rates: a turn in space is 2 dq q^-1.
    q, by = rows[:, None, :4], rows[:, 7:].reshape(-1, 7, 10)[..., 4:].swapaxes(1, 2)
    turns = 2 * product(by[..., :4], conjugate(q))[..., 1:]
    found = {"heyoka": np.concatenate([turns, by[..., 4:]], axis=-1).swapaxes(1, 2)}
    for engine in ENGINES:
        S = TorqueFreeMotion(inertia, omega0, engine=engine).sensitivity(times)[2]
        found[engine] = _columns(S.attitude, S.rates)
    return {
        who: float((np.linalg.norm(columns - true, axis=1) / size).max())
        for who, columns in found.items()
    }


def _columns(attitude: np.ndarray, rates: np.ndarray) -> np.ndarray:
    return np.concatenate([attitude, rates], axis=1)[..., 3:]


def medians(works: Iterable[Work], rounds: int) -> list[float]:
    """Return the median time of each work, s; they take turns."""
    listed = list(works)
    found: list[list[float]] = [[] for _ in listed]
    for _ in range(rounds):
        for times, work in zip(found, listed, strict=True):
            times.append(repeat(work, number=1, repeat=REPEATS, timer=process_time)[-1])
    return [median(times) for times in found]


def _each(seconds: float, size: int) -> str:
    return f"{1e9 * seconds / size:.0f} ns"


if __name__ == "__main__":
    sys.exit(main())
