"""Time and error of the generated modules, integrators and the paper's formulas.

    python tests/benchmarks/generated.py [ROUNDS]
    python tests/benchmarks/generated.py --quick      small sizes, one round, goals not judged

Needs gcc on x86-64 with glibc, and SciPy; heyoka's rows need the extra `bench`.  One motion is the
paper's, at random times in [0, 100] s.  The programmes take turns, so that a busy minute of the
machine spoils one round and not one figure; the fastest round counts.  van Zon and Schofield's code
is not available.
"""

import ctypes
import math
import subprocess
import sys
import tempfile
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from timeit import timeit

import bench
import numpy as np
import rivals
from mpmath import mp

from rigidsym import TorqueFreeMotion, generated
from rigidsym._engines.library import Library
from rigidsym.generated import torque_free

PAPER = rivals.Motion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
NEAR = rivals.Motion((0.3, 0.5, 0.6), (0.01, 1.0, 0.02))
SEPARATRIX = rivals.Motion((1.0, 2.0, 2.25), (0.75, 0.5, 1.0))
SOURCE = Path(generated.__file__).with_name("torque_free.c")
STRICT = ("-std=c99", "-O3", "-fno-math-errno", "-fno-trapping-math")
NATIVE = (*STRICT, "-march=native", "-mprefer-vector-width=512")
AVX2 = "-O3 -march=x86-64-v3"
# What the header speaks of, by what distinguishes it.
BUILDS = {
    "-O3 -march=native, 512 bits": NATIVE,
    "-O3 -march=native": (*STRICT, "-march=native"),
    "-O2 -march=native": (*STRICT, "-march=native", "-O2"),
    AVX2: (*STRICT, "-march=x86-64-v3"),
    "-O3 -msse2": (*STRICT, "-march=x86-64"),
}
ENGINES = {"NumPy": "numpy", "C": "c"}
BODIES, LATEST, SECONDS = 10_000, 10.0, 100.0
Work = Callable[[], object]


def main() -> int:
    """Print every table; return 1 where a goal is missed."""
    asked = bench.options(__doc__, 30)
    quick, rounds = asked.quick, asked.rounds
    bench.say_if_heyoka_is_missing()
    met = []
    for size in (800,) if quick else (10_000, 1_000_000):
        met.append(_states(size, rounds).print(not quick))
    met.append(_bodies(rounds, 160 if quick else BODIES).print(not quick))
    met.append(_small(rounds, *((2, 10_000) if quick else (200, 10_000_000))).print(not quick))
    met.append(_builds(rounds, 1 if quick else len(BUILDS)).print(not quick))
    met.append(_errors("the paper's motion, 50 times in [0, 100] s", PAPER, 50).print(not quick))
    met.append(_errors("the separatrix, t = 100 s", SEPARATRIX, 1).print(not quick))
    return int(not (quick or all(met)))


@dataclass
class Table:
    """Table of figures in one unit, with goals.

    A goal beside a rival that is not installed is none.
    """

    title: str
    figures: dict[str, float]
    unit: str
    goals: list[tuple[str, bool]] = field(default_factory=list)

    def at_most(self, name: str, limit: float) -> None:
        found = self.figures[name]
        self.goals.append((f"{name}: {found:.3g} {self.unit}, at most {limit}", found <= limit))

    def within(self, name: str, factor: float, other: str) -> None:
        """Add the goal that one takes at most `factor` times as long as another."""
        if other not in self.figures:
            return
        ratio = self.figures[name] / self.figures[other]
        self.goals.append((f"{name}: {ratio:.2f} x {other}, at most {factor}", ratio <= factor))

    def faster(self, name: str, factor: float, others: list[str]) -> None:
        """Add the goal that one is at least `factor` times as fast as all others."""
        if not (others := [name for name in others if name in self.figures]):
            return
        other = min(others, key=self.figures.__getitem__)
        ratio = self.figures[other] / self.figures[name]
        self.goals.append((f"{other}: {ratio:.1f} x {name}, at least {factor}", ratio >= factor))

    def print(self, judged: bool) -> bool:
        """Print figures and goals; return True if all goals are met."""
        print(f"\n{self.title}")
        for name, figure in self.figures.items():
            print(f"  {name:40}{figure:12.4g} {self.unit}")
        for text, met in self.goals if judged else ():
            print(f"  {'met   ' if met else 'MISSED'} {text}")
        return all(met for _, met in self.goals)


def _best(works: dict[str, Work], rounds: int, per: int) -> dict[str, float]:
    """Return the fastest nanoseconds of each, over `per`; slow works take two rounds only."""
    found = {name: timeit(work, number=1) for name, work in works.items()}
    for k in range(rounds):
        for name, work in works.items():
            if k < 2 or found[name] < 0.5:
                # The mean of runs in a row: each finds the caches as the one before left them.
                count = math.ceil(4e-3 / found[name])
                found[name] = min(found[name], timeit(work, number=count) / count)
    return {name: 1e9 * seconds / per for name, seconds in found.items()}


# The C module, by ctypes and not by the engine: in several builds, without Python in between.


class CModule:
    """The generated C source, compiled with some flags."""

    def __init__(self, flags: tuple[str, ...] = NATIVE) -> None:
        header = SOURCE.with_suffix(".h").read_text("utf-8")
        self.library = Library(_compiled(SOURCE, flags), header, SOURCE.stem)

    def prepare(self, motion: rivals.Motion) -> ctypes.Array:
        prepared = ctypes.create_string_buffer(self.library.motion_size())
        start = motion.inertia, motion.omega0, (1.0, 0, 0, 0)
        self.call("motion_init", prepared, *map(np.array, start))()
        return prepared

    def call(self, name: str, *arguments: object) -> Work:
        """Return a call of torque_free_<name> whose arguments are checked only once."""
        given = self.library.signatures[name].arguments(arguments, {})
        function = getattr(self.library.raw, name)

        def run() -> None:
            if function(*given):
                raise ValueError(f"torque_free_{name}: refused")

        # The arrays have to live as long as what points to them.
        run.arrays = arguments
        return run


@cache
def _compiled(source: Path, flags: tuple[str, ...]) -> ctypes.CDLL:
    with tempfile.TemporaryDirectory() as directory:
        path = Path(directory, f"{source.stem}.so")
        ends = "-shared", "-fPIC", str(source), "-o", str(path), "-lmvec", "-lm"
        subprocess.run(["gcc", *flags, *ends], check=True)
        return ctypes.CDLL(str(path))


def _bounds(t: np.ndarray, out: rivals.States) -> dict[str, Work]:
    """Return programs whose time is the machine's bound, in two vector widths."""
    source = Path(__file__).with_name("bound.c")
    library = _compiled(source, ("-O3", "-march=native"))
    times, *places = (ctypes.c_void_p(x.ctypes.data) for x in (t, *out))
    given = ctypes.c_size_t(t.size), times, ctypes.c_double(0.3), ctypes.c_double(0.4), *places
    return {
        f"bound, {width} bits": lambda f=library[f"bound_{width}"]: f(*given)
        for width in (256, 512)
    }


# The tables.


def _states(size: int, rounds: int) -> Table:
    """Measure many states of one body, written to existing arrays."""
    t = np.random.default_rng(size).uniform(0, SECONDS, size)
    in_order = np.sort(t)
    out = np.zeros((size, 4)), np.zeros((size, 3))
    prepared = torque_free.prepare(PAPER.inertia, PAPER.omega0, (1.0, 0, 0, 0))
    c = CModule()
    paper, near = c.prepare(PAPER), c.prepare(NEAR)
    works = _bounds(t, out) | {
        "C": c.call("states_at", paper, size, t, *out),
        "C, sorted": c.call("states_at", paper, size, in_order, *out),
        "C, grid": c.call("states_on_grid", paper, 0.0, SECONDS / size, 0, size, *out),
        "C, hyperbolic branch": c.call("states_at", near, size, t, *out),
        "NumPy": lambda: torque_free.states(prepared, t, out),
        "NumPy, sorted": lambda: torque_free.states(prepared, in_order, out),
    }
    rest = {name: rival(PAPER, in_order) for name, rival in RIVALS.items()}
    figures = _best(works | rest, rounds, size)
    figures["bound"] = min(figures.pop(f"bound, {width} bits") for width in (256, 512))
    table, small = Table(f"{size} states of one body", figures, "ns a state"), size < 100_000
    table.within("C", 2.0 if small else 2.4, "bound")
    table.faster("C", 8 if small else 5.5, [name for name in FROM_START if "heyoka" in name])
    table.within("NumPy", 1.2, "heyoka, propagate_grid")
    table.faster("C", 300, ["SciPy, DOP853"])
    table.faster("NumPy", 4, ["SciPy, the paper's formulas"])
    return table


_ALL_RIVALS = {
    "heyoka, propagate_grid": rivals.heyoka_grid,
    "heyoka, continuous output": rivals.heyoka_dense,
    "heyoka, propagate_grid in lanes": rivals.heyoka_lanes_grid,
    "heyoka, continuous output in lanes": rivals.heyoka_lanes_dense,
    "heyoka, evaluation alone": rivals.heyoka_evaluation,
    "SciPy, DOP853": rivals.dop853,
    "SciPy, the paper's formulas": rivals.paper,
}
RIVALS = {
    name: rival for name, rival in _ALL_RIVALS.items() if "heyoka" not in name or bench.HEYOKA
}
FROM_START = [name for name in RIVALS if name != "heyoka, evaluation alone"]


def _bodies(rounds: int, bodies: int) -> Table:
    """Measure one state of each of many bodies."""
    random = np.random.default_rng(0)
    # Moments of real bodies: sums of two of three positive numbers.
    parts = random.uniform(0.1, 1.0, (bodies, 3))
    inertia = np.ascontiguousarray(parts.sum(axis=1, keepdims=True) - parts)
    omega0, start = random.normal(size=(bodies, 3)), np.tile([1.0, 0, 0, 0], (bodies, 1))
    t, out = np.array([LATEST]), (np.empty((bodies, 1, 4)), np.empty((bodies, 1, 3)))
    failed = ctypes.c_size_t()
    c = CModule()
    given = (bodies, inertia, omega0, start, 1, t, 0, *out, None, failed)
    works = {
        "C": c.call("propagate", *given),
        "NumPy": lambda: torque_free.states(torque_free.prepare(inertia, omega0, start), t, out),
    }
    if bench.HEYOKA:
        works["heyoka, eight bodies at once"] = rivals.heyoka_bodies(inertia, omega0, LATEST)
    figures = {name: x / 1000 for name, x in _best(works, rounds, bodies).items()}
    table = Table(f"{bodies} bodies, one state each at t = {LATEST:g} s", figures, "us a body")
    table.at_most("C", 0.8)
    table.faster("C", 20, ["heyoka, eight bodies at once"])
    table.at_most("NumPy", 20)
    return table


def _small(rounds: int, repeated: int, size: int) -> Table:
    """Measure one state by a call in Python, and the memory of many states."""

    def calls(engine: str) -> Work:
        motion = TorqueFreeMotion(PAPER.inertia, PAPER.omega0, engine=engine)
        return lambda: [motion(0.1) for _ in range(repeated)]

    def made(engine: str, kind: Callable[..., object] = tuple) -> Work:
        given = kind(PAPER.inertia), kind(PAPER.omega0)
        return lambda: [TorqueFreeMotion(*given, engine=engine)(0.1) for _ in range(repeated)]

    works = {f"{name}, motion(0.1)": calls(engine) for name, engine in ENGINES.items()}
    works |= {f"{name}, made and called": made(engine) for name, engine in ENGINES.items()}
    works["C, made of arrays and called"] = made("c", np.array)
    figures = {name: x / 1000 for name, x in _best(works, rounds, repeated).items()}
    table = Table("one state by a call in Python", figures, "us")
    for name, limit in zip(figures, (15, 15, 400, 25, 25), strict=True):
        table.at_most(name, limit)
    used, most = _memory(size), 64
    text = f"NumPy, {size} states: {used:.1f} MB beyond them, at most {most}"
    table.goals.append((text, used <= most))
    return table


def _memory(size: int) -> float:
    """Return the peak memory beyond the output in MB, by tracemalloc."""
    prepared = torque_free.prepare(PAPER.inertia, PAPER.omega0, (1.0, 0, 0, 0))
    t, out = np.linspace(0, SECONDS, size), (np.empty((size, 4)), np.empty((size, 3)))
    tracemalloc.start()
    torque_free.states(prepared, t, out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak / 1e6


def _builds(rounds: int, count: int, size: int = 10_000) -> Table:
    """Measure one source compiled for different machines.

    The build for AVX2 is compared with the bound of its own vector width.
    """
    t = np.random.default_rng(1).uniform(0, SECONDS, size)
    out = np.zeros((size, 4)), np.zeros((size, 3))
    works = _bounds(t, out)
    for name, flags in [*BUILDS.items()][:count]:
        c = CModule(flags)
        for motion, branch in ((PAPER, ""), (NEAR, "; hyperbolic")):
            works[name + branch] = c.call("states_at", c.prepare(motion), size, t, *out)
    table = Table("one source, several builds", _best(works, rounds, size), "ns a state")
    if AVX2 in table.figures:
        table.within(AVX2, 1.5, "bound, 256 bits")
    return table


def _errors(title: str, motion: rivals.Motion, count: int) -> Table:
    """Return the worst errors of the rotation angle in rad."""
    t = np.sort(np.random.default_rng(7).uniform(0, SECONDS, 8000))
    t[-1] = SECONDS
    chosen = np.linspace(0, t.size - 1, count, dtype=int) if count > 1 else np.array([t.size - 1])
    exact = TorqueFreeMotion(motion.inertia, motion.omega0).precise(t[chosen].tolist(), 30)[0]
    figures = {name: _worst(q[chosen], exact) for name, q in _attitudes(motion, t).items()}
    table = Table(f"rotation angle, {title}", figures, "rad")
    ours = max(figures["C"], figures["NumPy"])
    for name in RIVALS:
        ratio = figures[name] / ours
        table.goals.append((f"{name}: {ratio:.3g} times our error, more than 1", not ratio <= 1))
    return table


def _attitudes(motion: rivals.Motion, t: np.ndarray) -> dict[str, np.ndarray]:
    """Return the attitudes (N, 4) of each implementation and rival."""
    out = np.zeros((t.size, 4)), np.zeros((t.size, 3))
    c = CModule()
    c.call("states_at", c.prepare(motion), t.size, t, *out)()
    prepared = torque_free.prepare(motion.inertia, motion.omega0, (1.0, 0, 0, 0))
    ours = {"C": out[0], "NumPy": torque_free.states(prepared, t)[0]}
    return ours | {n: rival(motion, t)()[0].reshape(-1, 4) for n, rival in RIVALS.items()}


def _worst(found: np.ndarray, exact: np.ndarray) -> float:
    """Return twice the largest distance of quaternions up to sign; NaN if one is no number."""
    if not np.all(np.isfinite(found)):
        return math.nan
    with mp.workdps(40):
        rows = np.vectorize(mp.mpf, otypes=[object])(found)
        squares = (np.sum((rows - sign * exact) ** 2, axis=1) for sign in (1, -1))
        return max(float(2 * mp.sqrt(min(both))) for both in zip(*squares, strict=True))


if __name__ == "__main__":
    sys.exit(main())
