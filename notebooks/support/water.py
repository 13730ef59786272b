"""A periodic box of rigid water molecules, and steps of it: what `rigidsym.step` is for.

Units are nm, ps, u and e, so that energies are in kJ/mol and moments of inertia in u nm^2.  The
molecules are SPC/E's (Berendsen, Grigera and Straatsma, J. Physical Chemistry 91, 6269-6271).
Every term r^-p of the energy of two sites is shifted, as GROMACS does it from r = 0 on, such that
it, the force and the force's slope vanish at the cut-off: with s = r/cutoff it is

    s^-p + p(p + 4)/3 s^3 - p(p + 3)/4 s^4 - constant.

So an energy that drifts does so by the integrator and not by the cut-off.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array

import rigidsym
from rigidsym.quaternions import matrices, product
from rigidsym.splitting import Method

COULOMB, BOLTZMANN = 138.935458, 0.00831446262  # kJ/mol nm/e^2, kJ/mol/K
MASSES, CHARGES = np.array([15.9994, 1.008, 1.008]), np.array([-0.8476, 0.4238, 0.4238])  # O, H, H
SIGMA, EPSILON = 0.3166, 0.650  # of two oxygens
BOND, ANGLE = 0.1, np.radians(109.47)
DENSITY, KELVIN = 33.33, 300.0  # molecules in nm^3
CUTOFF = 0.49  # of the cube's length


def _sites() -> np.ndarray:
    """O, H, H about their centre of mass, in the principal axes."""
    across, along = BOND * np.sin(ANGLE / 2), BOND * np.cos(ANGLE / 2)
    sites = np.array([[0.0, 0.0, 0.0], [across, 0.0, along], [-across, 0.0, along]])
    return sites - MASSES @ sites / MASSES.sum()


SITES, MASS = _sites(), MASSES.sum()
INERTIA = MASSES @ (np.sum(SITES**2, axis=1)[:, None] - SITES**2)
THERMAL = BOLTZMANN * KELVIN
_PRODUCTS = COULOMB * CHARGES[:, None] * CHARGES


@dataclass(slots=True)
class State:
    """Centres x (N, 3), attitudes q (N, 4), velocities v (N, 3), rates omega (N, 3)."""

    x: np.ndarray
    q: np.ndarray
    v: np.ndarray
    omega: np.ndarray

    def copy(self) -> "State":
        """One that can be moved while this stays."""
        return State(self.x.copy(), self.q.copy(), self.v.copy(), self.omega.copy())

    @property
    def kinetic(self) -> float:
        """The energy of centres and rotations, kJ/mol."""
        return float(MASS * np.sum(self.v**2) + np.sum(INERTIA * self.omega**2)) / 2


class Forces(NamedTuple):
    """The energy of a box, and of its molecules forces (N, 3), and torques (N, 3) in body axes."""

    energy: float
    force: np.ndarray
    torque: np.ndarray


class Box:
    """A cube of edge**3 molecules, as dense as water."""

    def __init__(self, edge: int) -> None:
        self.edge, self.count = edge, edge**3
        self.length = (self.count / DENSITY) ** (1 / 3)
        self.cutoff = CUTOFF * self.length
        self._first, self._second = np.triu_indices(self.count, 1)
        pairs = np.arange(len(self._first))
        self._onto = [
            csr_array((np.ones(len(pairs)), (which, pairs)), shape=(self.count, len(pairs)))
            for which in (self._first, self._second)
        ]
        # New memory for these at each call would take most of its time.
        self._work = np.empty((2, 3, 3, 3, len(pairs)))

    def forces(self, state: State) -> Forces:
        """What the molecules do to each other."""
        turns = matrices(state.q)
        places = state.x.T[:, None] + np.swapaxes(SITES @ np.swapaxes(turns, 1, 2), 0, 2)
        apart = self._apart(places)
        squares = np.einsum("k...,k...->...", apart, apart)
        energy, pull = self._pairs(np.minimum(squares, self.cutoff**2, out=squares))
        apart *= pull
        on_sites = self._onto[0] @ np.sum(apart, axis=2).reshape(9, -1).T
        on_sites -= self._onto[1] @ np.sum(apart, axis=1).reshape(9, -1).T
        on_sites = np.swapaxes(on_sites.reshape(-1, 3, 3), 1, 2)
        torque = np.sum(np.cross(SITES, on_sites @ turns), axis=1)
        return Forces(energy, np.sum(on_sites, axis=1), torque)

    def _apart(self, places: np.ndarray) -> np.ndarray:
        """From sites to the nearest images of sites, (3, 3, 3, M): x y z, two sites, pairs."""
        apart, cells = self._work
        first, second = (np.take(places, which, axis=2) for which in (self._first, self._second))
        np.subtract(first[:, :, None], second[:, None], out=apart)
        np.rint(np.multiply(apart, 1 / self.length, out=cells), out=cells)
        apart -= np.multiply(cells, self.length, out=cells)
        return apart

    def _pairs(self, squares: np.ndarray) -> tuple[float, np.ndarray]:
        """The energy of all pairs; forces of sites (3, 3, M) over what they are apart."""
        energies, pull = _shifted(1, squares, self.cutoff)
        energy = np.sum(_PRODUCTS * np.sum(energies, axis=2))
        pull *= _PRODUCTS[..., None]
        for power, sign in ((12, 1), (6, -1)):
            energies, of_oxygens = _shifted(power, squares[0, 0], self.cutoff)
            energy += sign * 4 * EPSILON * SIGMA**power * np.sum(energies)
            pull[0, 0] += sign * 4 * EPSILON * SIGMA**power * of_oxygens
        return float(energy), pull

    def lattice(self, draw: np.random.Generator) -> State:
        """Centres on a lattice, attitudes and rates at random."""
        cells = np.stack(np.meshgrid(*[np.arange(self.edge)] * 3, indexing="ij"), -1)
        x = (cells.reshape(-1, 3) + 0.5) * self.length / self.edge
        q = draw.normal(size=(self.count, 4))
        return State(x, q / np.linalg.norm(q, axis=1, keepdims=True), *self.rates(draw))

    def rates(self, draw: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """Velocities and rates at 300 K, of which the sum of the velocities is none."""
        v, omega = draw.normal(size=(2, self.count, 3)) * np.sqrt(THERMAL)
        return (v - v.mean(axis=0)) / np.sqrt(MASS), omega / np.sqrt(INERTIA)

    def settled(self, picoseconds: float, seed: int = 0) -> State:
        """A liquid: from the lattice, with rates drawn anew each 0.1 ps until so late."""
        draw = np.random.default_rng(seed)
        state = self.lattice(draw)
        for _ in range(round(picoseconds / 0.1)):
            run(self, state, VERLET, 0.0025, 40)
            state.v, state.omega = self.rates(draw)
        return state


def _shifted(power: int, squares: np.ndarray, cutoff: float) -> tuple[np.ndarray, np.ndarray]:
    """r^-power, shifted, by r^2; and its force over r."""
    s2 = squares * cutoff**-2
    s = np.sqrt(s2)
    inverse = 1 / s if power == 1 else s2 ** (-(power // 2))
    cubic, quartic = power * (power + 4) / 3, power * (power + 3) / 4
    energy = inverse + s * s2 * (cubic - quartic * s) - (1 + cubic - quartic)
    force = power * (inverse / s2 - (power + 4) * s + (power + 3) * s2)
    return energy * cutoff**-power, force * cutoff ** -(power + 2)


Turn = Callable[[np.ndarray, np.ndarray, np.ndarray, float], tuple[np.ndarray, np.ndarray]]
exact: Turn = partial(rigidsym.step, engine="c")


def no_squish(
    inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: float
) -> tuple[np.ndarray, np.ndarray]:
    """The free step of Miller and others (J. Chemical Physics 116, 8649-8659), to second order:
    rotations about one principal axis after the other, that of the smallest moment in the middle,
    as LAMMPS has them."""
    momentum, q = inertia * omega, q.copy()
    last, middle, first = np.argsort(inertia)
    for axis, part in ((first, 0.5), (middle, 0.5), (last, 1), (middle, 0.5), (first, 0.5)):
        angle = part * dt / inertia[axis] * momentum[:, axis]
        i, j = (axis + 1) % 3, (axis + 2) % 3
        c, s = np.cos(angle), np.sin(angle)
        a, b = momentum[:, i].copy(), momentum[:, j].copy()
        momentum[:, i], momentum[:, j] = c * a + s * b, c * b - s * a
        turn = np.zeros_like(q)
        turn[:, 0], turn[:, 1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
        q = product(q, turn)
    return q, momentum / inertia


Scheme = tuple[tuple[float, float], ...]
# Parts of a step: kicks by the forces, and drifts without them.
VERLET: Scheme = ((0.5, 1.0), (0.5, 0.0))


def scheme(method: Method) -> Scheme:
    """A method of `rigidsym.splitting`, which begins and ends with a drift."""
    return tuple(zip((0.0, *method.kicks), method.drifts, strict=True))


def advance(
    box: Box, state: State, forces: Forces | None, parts: Scheme, h: float, turn: Turn
) -> Forces | None:
    """A step of h ps, in place; takes and returns the forces at the state, where they are known."""
    for kick, drift in parts:
        if kick:
            forces = forces or box.forces(state)
            state.v += kick * h / MASS * forces.force
            state.omega += kick * h / INERTIA * forces.torque
        if drift:
            state.x += drift * h * state.v
            state.q, state.omega = turn(INERTIA, state.q, state.omega, drift * h)
            forces = None
    return forces


def run(
    box: Box,
    state: State,
    parts: Scheme,
    h: float,
    steps: int,
    turn: Turn = exact,
    every: int | None = None,
) -> np.ndarray:
    """So many steps of h ps, in place: the energy at the start and after `every` so many of them,
    kJ/mol; raises InputError where rates grow beyond what a turn takes."""
    forces, energies = None, []
    for k in range(steps + 1):
        if every and k % every == 0:
            forces = forces or box.forces(state)
            energies.append(forces.energy + state.kinetic)
        if k < steps:
            forces = advance(box, state, forces, parts, h, turn)
    return np.array(energies)


class Kept(NamedTuple):
    """What a molecule's energy does: drift and its standard error, kT/ns; root mean square, kT."""

    drift: float
    error: float
    scatter: float


def kept(energies: np.ndarray, h: float) -> Kept:
    """Of energies of a molecule, kT, h ps apart: the slope of a straight line and what is left by
    it; the error is that of the mean of four quarters' slopes."""
    ns = h / 1000 * np.arange(len(energies))
    line = np.polyfit(ns, energies, 1)
    quarters = zip(np.array_split(ns, 4), np.array_split(energies, 4), strict=True)
    slopes = [np.polyfit(t, e, 1)[0] for t, e in quarters]
    scatter = np.std(energies - np.polyval(line, ns))
    return Kept(float(line[0]), float(np.std(slopes, ddof=1) / 2), float(scatter))
