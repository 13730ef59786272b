"""Cost of the code paths that a wheel brings, beside C compiled for this machine.

    nice uv run python tests/benchmarks/shipped.py --wheel dist/NAME.whl
    python tests/benchmarks/shipped.py --quick              few repetitions

Without --wheel, the libraries are those that the installed package brings, if it brings any.
Figures are ratios of processor time, each the least of runs that take turns: 1 is the library that
`-march=native` makes on this machine, and more is slower.
"""

import sys
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from time import process_time

import numpy as np
from bench import options

from rigidsym._engines import build, shipped
from rigidsym._engines.c_engine import CEngine
from rigidsym._engines.library import load
from rigidsym._engines.steps import CStepper

BODIES, TIMES, REPEATED = 2000, 4096, 500
# The share by which the code path for this machine may be slower.
GOAL = 1.1


def works(states: Path, steps: Path) -> dict[str, Callable[[], object]]:
    """Return what is measured of the libraries of states and of steps, by name."""
    engine = CEngine(load(states, build.package_sources("c")))
    stepper = CStepper(load(steps, build.package_sources("c-step")))
    draw = np.random.default_rng(0)
    inertia = draw.uniform(1, 2, (BODIES, 3))
    q, omega = draw.normal(size=(BODIES, 4)), draw.normal(size=(BODIES, 3))
    body = (1.0, 2.0, 2.5), (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0)
    motion, times = engine.prepare(*body), np.linspace(0, 100, TIMES)
    out = np.empty((TIMES, 4)), np.empty((TIMES, 3))
    ends = np.empty((BODIES, 1, 4)), np.empty((BODIES, 1, 3))
    after, dt = (np.empty_like(q), np.empty_like(omega)), np.array([0.5])
    one = body[0], body[2], body[1]
    return {
        "4096 states of a motion": lambda: [engine.states(motion, times, out) for _ in range(9)],
        "4096 states on a grid": lambda: [
            engine.grid(motion, 0, 0.1, TIMES, out) for _ in range(9)
        ],
        "4096 sensitivities": lambda: engine.sensitivities(motion, times),
        "2000 bodies prepared": lambda: engine.propagate(inertia, omega, q, times[:1], ends),
        "2000 steps": lambda: [stepper.step(inertia, q, omega, dt, after) for _ in range(3)],
        "a state": lambda: [engine.states(motion, 3.25) for _ in range(REPEATED)],
        "a step of one body": lambda: [stepper.one(*one, 0.5) for _ in range(REPEATED)],
    }


def measured(libraries: dict[str, tuple[Path, Path]], rounds: int) -> dict[str, list[float]]:
    """Return the costs of all libraries over those of the first, by what is computed."""
    every = [works(*paths) for paths in libraries.values()]
    found = {}
    for name in every[0]:
        least = [np.inf] * len(every)
        for _ in range(rounds):
            for k, one in enumerate(every):
                start = process_time()
                one[name]()
                least[k] = min(least[k], process_time() - start)
        found[name] = [cost / least[0] for cost in least]
    return found


def main() -> int:
    """Print the table; the status is 1 if the code path for this machine misses the goal."""
    given = options(__doc__, 40, wheel={"metavar": "FILE"})
    with tempfile.TemporaryDirectory() as work:
        if given.wheel:
            zipfile.ZipFile(given.wheel).extractall(work)
            shipped.FOLDER = Path(work, "rigidsym", "_engines", "shipped")
        if (path := shipped.code_path()) is None:
            print("the package brings no libraries: build a wheel, and give it by --wheel")
            return 0
        names = [x for x in shipped.PATHS.values() if (shipped.FOLDER / f"{x}.so").is_file()]
        names = names[: names.index(path) + 1]
        chosen, shipped.FOLDER = shipped.FOLDER, Path(work, "none")
        shipped.code_path.cache_clear()
        own = [build.library([], module).path for module in ("c", "c-step")]
        libraries = {"native": (own[0], own[1])}
        libraries |= {x: (chosen / f"{x}.so", chosen / f"{x}.so") for x in [*names, "portable"]}
        found = measured(libraries, given.rounds)
    print(f"{'':26}", *(f"{name:>10}" for name in libraries))
    for name, ratios in found.items():
        print(f"{name:26}", *(f"{ratio:10.2f}" for ratio in ratios))
    worst = max(ratios[[*libraries].index(path)] for ratios in found.values())
    print(f"{path}: at most {worst:.2f} times the time of -march=native, goal {GOAL}")
    return 0 if given.quick or worst <= GOAL else 1


if __name__ == "__main__":
    sys.exit(main())
