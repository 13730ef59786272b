"""Cost of a step beside what it replaces: ratios of one run on this machine.

    nice uv run python tests/benchmarks/steps.py
    python tests/benchmarks/steps.py --quick                few bodies and steps

A step is compared with a propagation of as many bodies to one time each, by the same engine, with
NO_SQUISH in C, whose error stands beside its cost, and with two threads; a call for one body with a
bare call of C by ctypes; and a step of SABA2 under gravity gradient with its own free motions
alone.
"""

import ctypes
import math
import sys
import tempfile
from collections.abc import Callable, Generator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from time import process_time
from timeit import repeat, timeit

import numpy as np

import rigidsym
from rigidsym._engines import build, threads
from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.splitting import GravityGradient, KeplerOrbit

BODIES, MANY = 10_000, 1_000_000
# Bodies and steps under a torque.
RUNS = ((1, 20_000), (16, 2000), (BODIES, 100))
# Calls in a row of what takes microseconds.
REPEATED = 200


def drawn(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Draw moments of bodies that can exist, attitudes and rates."""
    draw = np.random.default_rng(0)
    x, y, z = draw.uniform(0.05, 1, (3, count))
    q = draw.normal(size=(count, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    return np.stack([y + z, z + x, x + y], -1), q, draw.normal(size=(count, 3))


def seconds(work: Callable[[], object], rounds: int = 7) -> float:
    """Return the least time of some rounds."""
    return min(repeat(work, number=1, repeat=rounds))


@contextmanager
def on_processors(count: int) -> Generator[None]:
    """Limit steps to some processors."""
    known = threads.processors
    threads.processors = lambda: min(count, known())
    try:
        yield
    finally:
        threads.processors = known


def costs() -> None:
    """Print the time of a step of many bodies by each engine."""
    inertia, q, omega = drawn(BODIES)
    out = np.empty_like(q), np.empty_like(omega)
    for engine in ("c", "numpy"):
        step = partial(rigidsym.step, q=q, omega=omega, dt=0.3, engine=engine, out=out)
        for name, moments in (("one body", inertia[0]), ("a body each", inertia)):
            taken = seconds(partial(step, moments))
            print(f"{engine:6} step, {name:12} {taken / BODIES * 1e6:8.3f} us a body")
        run = partial(rigidsym.propagate, inertia, omega, [0.3], q, engine=engine)
        print(f"{engine:6} propagation to one time over step {seconds(run, 3) / taken:8.1f}")


def calls() -> None:
    """Print the time of one body by a call from Python, and of the C functions called.

    What is compared takes turns; processor time, the least of some rounds.
    """
    inertia, q, omega = (x[0] for x in drawn(1))
    out, own = (np.empty(4), np.empty(3)), (q.copy(), omega.copy())
    works: dict[str, Callable[[], object]] = bare_calls(inertia, q, omega)
    for engine in ("c", "numpy"):
        step = partial(rigidsym.step, inertia, q, omega, 0.3, engine=engine)
        turn = partial(rigidsym.step, inertia, *own, 0.3, engine=engine, out=own)
        made = partial(rigidsym.TorqueFreeMotion, inertia, omega, q, engine=engine)
        works |= {f"{engine} step": step, f"{engine} step, out": partial(step, out=out)}
        works |= {f"{engine} step in place": turn}
        works[f"{engine} motion made and called"] = lambda made=made: made()(0.3)
    found = dict.fromkeys(works, math.inf)
    for _ in range(15):
        for name, work in works.items():
            taken = timeit(work, number=REPEATED, timer=process_time) / REPEATED
            found[name] = min(found[name], taken)
    bare = found["torque_free_step by ctypes"]
    for name, taken in found.items():
        print(f"one body, {name:30} {taken * 1e6:8.2f} us, over a bare call {taken / bare:7.1f}")


def bare_calls(
    inertia: np.ndarray, q: np.ndarray, omega: np.ndarray
) -> dict[str, Callable[[], object]]:
    """Return bare calls of C functions by ctypes."""
    library = build.library([], "c-step").raw
    given = [x.copy() for x in (inertia, q, omega, np.array([0.3]), q, omega)]
    places = [ctypes.c_void_p(x.ctypes.data) for x in given]
    body = ctypes.create_string_buffer(library.body_size())
    library.body_init(body, places[0])
    failed = ctypes.byref(ctypes.c_size_t())
    more = (*places[1:3], places[3], 0, *places[4:], failed)

    def step(kept: object = given) -> int:
        return library.step(body, places[4], places[5], 0.3)

    return {
        "torque_free_step by ctypes": step,
        "torque_free_steps by ctypes": lambda: library.steps(1, places[0], 0, *more),
        "torque_free_body_size by ctypes": library.body_size,
    }


def no_squish() -> Callable[..., None]:
    """Compile no_squish.c and return its function."""
    source = Path(__file__).with_name("no_squish.c")
    with tempfile.TemporaryDirectory() as place:
        flags = ("-std=c99", "-Ofast", *build.NATIVE, "-fPIC", "-shared")
        sources = {source.name: source.read_text(encoding="utf-8")}
        built = build.compile_library(build.find(), sources, Path(place), flags)
        found = ctypes.CDLL(str(built)).no_squish
    found.argtypes = (ctypes.c_size_t, *(ctypes.c_void_p,) * 3, ctypes.c_double)
    return found


def rival() -> None:
    """Print the time and error of a free NO_SQUISH step."""
    inertia, q, omega = drawn(BODIES)
    step = no_squish()
    rows = [np.ascontiguousarray(x.T) for x in (1 / inertia, q, inertia * omega)]
    places = [x.ctypes.data for x in rows]
    step(BODIES, *places, 0.3)
    truth, rates = rigidsym.step(inertia, q, omega, 0.3, engine="c")
    turned = np.linalg.norm(rotation_vectors(product(conjugate(truth), rows[1].T)), axis=-1)
    off = np.linalg.norm(rows[2].T / inertia - rates, axis=-1) / np.linalg.norm(omega, axis=-1)
    out = np.empty_like(q), np.empty_like(omega)
    own = seconds(lambda: rigidsym.step(inertia, q, omega, 0.3, engine="c", out=out))
    same = seconds(lambda: rigidsym.step(inertia[0], q, omega, 0.3, engine="c", out=out))
    taken = seconds(lambda: step(BODIES, *places, 0.3))
    print(f"NO_SQUISH step in C             {taken / BODIES * 1e6:8.3f} us a body")
    print(f"a step of ours over it          {own / taken:8.2f}, of one body {same / taken:.2f}")
    errors = f"{np.median(turned):8.1e} rad, of rates {np.median(off):.1e}"
    print(f"its error in one step (median)  {errors}")


def pushed() -> None:
    """Print the time of a SABA2 step under gravity gradient over that of its free motions."""
    orbit = KeplerOrbit(mu=3.986004418e14, periapsis=6.778137e6)
    for bodies, steps in RUNS:
        inertia, q, omega = drawn(bodies)
        torque, out = GravityGradient(inertia, orbit), (np.empty_like(q), np.empty_like(omega))
        start = inertia, q, omega, torque, [0, 0.6 * steps]
        run = seconds(partial(rigidsym.integrate, *start, step=0.6, engine="c"), 5)
        free = seconds(partial(rigidsym.step, *start[:3], 0.3, engine="c", out=out))
        taken = run / steps / bodies
        ratio = f"{taken / (2 * free / bodies):6.2f} of two steps by themselves"
        print(f"saba2, {bodies:5} bodies {taken * 1e6:8.3f} us a step and body, {ratio}")


def scaling() -> None:
    """Print the time of a step on one processor over that on two."""
    inertia, q, omega = drawn(MANY)
    out, found = (np.empty_like(q), np.empty_like(omega)), []
    for count in (1, 2):
        with on_processors(count):
            step = partial(rigidsym.step, inertia, q, omega, 0.3, engine="c", out=out)
            found.append(seconds(step, rounds=5))
    print(f"c      {MANY} bodies, one processor over two {found[0] / found[1]:8.2f}")


if __name__ == "__main__":
    if "--quick" in sys.argv:
        BODIES, MANY, RUNS, REPEATED = 100, 1000, ((1, 20), (16, 20)), 2
    with on_processors(1):
        costs()
    calls()
    with on_processors(1):
        rival()
        pushed()
    scaling()
