"""What a step costs, beside what it replaces: ratios of one run on this machine.

    nice uv run python tests/benchmarks/steps.py

A step is compared with a propagation of as many bodies to one time each, by the same engine, and
with two threads.  What is printed last is drift: the root mean square of the relative change of
energy and momentum over 64 bodies, beside what a random walk of steps of 2^-53 has.
"""

import math
import sys
import time
from collections.abc import Callable
from functools import partial

import numpy as np

import rigidsym
from rigidsym.engines import threads

BODIES, MANY, DRIFT_STEPS = 10_000, 1_000_000, (10**4, 10**6)


def drawn(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Bodies that can exist, attitudes and rates."""
    draw = np.random.default_rng(0)
    x, y, z = draw.uniform(0.05, 1, (3, count))
    q = draw.normal(size=(count, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    return np.stack([y + z, z + x, x + y], -1), q, draw.normal(size=(count, 3))


def seconds(work: Callable[[], object], rounds: int = 7) -> float:
    """The least of some rounds."""
    found = []
    for _ in range(rounds):
        begin = time.perf_counter()
        work()
        found.append(time.perf_counter() - begin)
    return min(found)


def costs() -> None:
    """A step of many bodies, by either engine, on one core."""
    inertia, q, omega = drawn(BODIES)
    out = np.empty_like(q), np.empty_like(omega)
    alone = threads.processors
    threads.processors = lambda: 1
    for engine in ("c", "numpy"):
        step = partial(rigidsym.step, q=q, omega=omega, dt=0.3, engine=engine, out=out)
        for name, moments in (("one body", inertia[0]), ("a body each", inertia)):
            taken = seconds(partial(step, moments))
            print(f"{engine:6} step, {name:12} {taken / BODIES * 1e6:8.3f} us a body")
        run = partial(rigidsym.propagate, inertia, omega, [0.3], q, engine=engine)
        print(f"{engine:6} propagation to one time over step {seconds(run, 3) / taken:8.1f}")
    threads.processors = alone


def scaling() -> None:
    """Two processors against one."""
    inertia, q, omega = drawn(MANY)
    out, found = (np.empty_like(q), np.empty_like(omega)), []
    whole = threads.processors
    for count in (1, 2):
        threads.processors = lambda count=count: min(count, whole())
        found.append(
            seconds(lambda: rigidsym.step(inertia, q, omega, 0.3, engine="c", out=out), rounds=5)
        )
    threads.processors = whole
    print(f"c      {MANY} bodies, one processor over two {found[0] / found[1]:8.2f}")


def drift() -> None:
    """Energy and momentum after many steps."""
    for steps in DRIFT_STEPS:
        inertia, q, omega = drawn(64)
        first = [np.sum(inertia**n * omega**2, axis=1) for n in (1, 2)]
        for _ in range(steps):
            rigidsym.step(inertia, q, omega, 0.25, engine="c", out=(q, omega))
        last = [np.sum(inertia**n * omega**2, axis=1) for n in (1, 2)]
        sizes = [np.sqrt(np.mean((y / x - 1) ** 2)) for x, y in zip(first, last, strict=True)]
        walk = math.sqrt(steps) * 2.0**-53
        print(f"drift  {steps:8} steps: H {sizes[0]:.1e}, K^2 {sizes[1]:.1e}, a walk {walk:.1e}")


if __name__ == "__main__":
    costs()
    scaling()
    if "--drift" in sys.argv:
        drift()
