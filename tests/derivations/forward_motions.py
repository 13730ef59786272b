"""Motions by numbers, without the derivation: R' = R Omega and M' = [M, Omega] in matrices."""

from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np
import sympy
from scipy.linalg import expm

from derivations.setting import Setting
from rigidsym.proof.derivation import Derivation
from rigidsym.proof.steps import Step
from rigidsym.proof.steps._names import symbol, symbols

INERTIA = np.array([1.0, 1.7, 2.3])
RATES0 = np.array([0.7, 0.9, 0.8])
WHEELS = {"h1": 0.3, "h2": -0.4, "h3": 0.25}
PRODUCTS = {"c12": 0.2, "c13": -0.15, "c23": 0.3}
TIME, STEPS = 1.0, 400
RATES, MOMENTA = symbols("Omega1 Omega2 Omega3"), symbols("M1 M2 M3")


def steps_of(derivation: Derivation) -> dict[str, Step]:
    """Return all steps of a derivation by their facts."""
    return {step.fact.id: step for chapter in derivation.chapters for step in chapter.steps}


def constants() -> dict[sympy.Symbol, float]:
    """Return the values of moments and products of inertia, and of wheels."""
    inertia = dict(zip(symbols("c1 c2 c3"), INERTIA, strict=True))
    return {**inertia, **{symbol(name): x for name, x in (WHEELS | PRODUCTS).items()}}


def value(expression: sympy.Expr, point: dict[sympy.Symbol, float]) -> float:
    """Return the value of an expression at a point."""
    return float(sympy.sympify(expression).subs(point))


@dataclass(frozen=True)
class Motion:
    """A body from RATES0, in the basis and with the Lagrangian of a setting."""

    setting: Setting

    @cached_property
    def basis(self) -> np.ndarray:
        """The basis A1, A2, A3 as matrices."""
        return np.array([np.array(A.tolist(), dtype=complex) for A in self.setting.basis()])

    @cached_property
    def wheel(self) -> np.ndarray:
        """The wheel momentum along each axis."""
        return np.array([value(h, constants()) for h in self.setting.wheel()])

    @cached_property
    def tensor(self) -> np.ndarray:
        """The inertia tensor I, by values of the Lagrangian: L(v) + L(-v) = v I v."""
        known = {str(x): number for x, number in constants().items()}

        def form(v: np.ndarray) -> float:
            ends = [dict(zip(map(str, RATES), sign * v, strict=True)) for sign in (1, -1)]
            return sum(eval(self.setting.lagrangian, known | end) for end in ends)

        e = np.eye(3)
        return np.array([[form(x + y) - form(x) - form(y) for x in e] for y in e]) / 2

    def momentum(self, rates: np.ndarray) -> np.ndarray:
        """Return M = I Omega + h."""
        return self.tensor @ rates + self.wheel

    def energy(self, rates: np.ndarray) -> float:
        """Return the kinetic energy."""
        return float(rates @ self.tensor @ rates) / 2

    def matrix(self, vector: np.ndarray) -> np.ndarray:
        """Return x1 A1 + x2 A2 + x3 A3."""
        return np.einsum("k,kij->ij", vector, self.basis)

    def coordinates(self, matrix: np.ndarray) -> np.ndarray:
        """Return x1, x2, x3 of x1 A1 + x2 A2 + x3 A3."""
        return np.einsum("kji,ji->k", self.basis.conj(), matrix).real / np.vdot(*self.basis[[0, 0]])

    def rates(self, momentum: np.ndarray) -> np.ndarray:
        """Return Omega of M = I Omega + h."""
        return np.linalg.solve(self.tensor, momentum - self.wheel)

    def moments(self, momentum: np.ndarray) -> np.ndarray:
        """Return M' = [M, Omega]."""
        M, Omega = self.matrix(momentum), self.matrix(self.rates(momentum))
        return self.coordinates(M @ Omega - Omega @ M)

    def run(self, phi1_rate) -> tuple[np.ndarray, np.ndarray, float]:
        """Return R and M at TIME from R = 1, and the integral of phi1_rate, by Runge-Kutta."""

        def slope(state):
            R, M, _ = state
            Omega = self.rates(M)
            return R @ self.matrix(Omega), self.moments(M), phi1_rate(Omega)

        def moved(state, rate, h):
            return tuple(x + h * y for x, y in zip(state, rate, strict=True))

        h = TIME / STEPS
        state = (np.eye(len(self.basis[0]), dtype=complex), self.momentum(RATES0), 0.0)
        for _ in range(STEPS):
            k1 = slope(state)
            k2 = slope(moved(state, k1, h / 2))
            k3 = slope(moved(state, k2, h / 2))
            k4 = slope(moved(state, k3, h))
            rates = zip(k1, k2, k3, k4, strict=True)
            state = moved(state, tuple((a + 2 * b + 2 * c + d) / 6 for a, b, c, d in rates), h)
        return state

    def turn(self, axis: int, angle: float) -> np.ndarray:
        """Return exp(angle A) for one axis."""
        return expm(angle * self.basis[axis - 1])

    def front(self) -> np.ndarray:
        """Return a constant turn of the outer axis onto the target, the first that is found."""
        outer, target = (self.basis[k - 1] for k in (self.setting.sequence[0], self.setting.target))
        quarter = np.pi / 4 / float(self.setting.factor)
        turns = [self.turn(axis, k * quarter) for axis in (1, 2, 3) for k in range(4)]
        pairs = (x @ y for x, y in product(turns, turns))
        return next(T for T in pairs if np.allclose(T @ outer @ T.conj().T, target))

    def angles(self, steps: dict[str, Step], momentum: np.ndarray) -> tuple[float, float]:
        """Return phi2 and phi3 of a momentum by the solutions that the derivation found."""
        K = float(np.linalg.norm(momentum))
        point = {symbol("K"): K, **dict(zip(MOMENTA, momentum, strict=True))}
        double = 2 * self.setting.factor
        ((function, along),) = steps["compared.phi2"].value.items()
        # The other function of phi2 is not negative.
        if isinstance(function, sympy.cos):
            phi2 = float(np.arccos(value(along, point)))
            point[sympy.sin(double * symbol("phi2"))] = np.sin(phi2)
        else:
            phi2 = float(np.arcsin(value(along, point)))
            point[sympy.cos(double * symbol("phi2"))] = np.cos(phi2)
        C, S = (value(x, point) for x in steps["compared.phi3"].value.values())
        return phi2 / float(double), float(np.arctan2(S, C)) / float(double)

    def turned(self, phi: tuple[float, float, float]) -> np.ndarray:
        """Return R of the three angles."""
        product = self.front()
        for axis, angle in zip(self.setting.sequence, phi, strict=True):
            product = product @ self.turn(axis, angle)
        return product


def rotation(
    steps: dict[str, Step], setting: Setting, momentum: np.ndarray, phi1: float
) -> np.ndarray:
    """Return the rotation matrix of a momentum and phi1 that a derivation in SO(3) found."""
    phi = (phi1, *Motion(setting).angles(steps, momentum))
    point = {symbol("K"): np.linalg.norm(momentum), **dict(zip(MOMENTA, momentum, strict=True))}
    point |= {symbol(f"phi{k}"): angle for k, angle in enumerate(phi, 1)}
    found = [steps[f"theorem1.{name}"].value for name in ("by_momentum", "matrix")]
    one, other = (np.array(matrix.subs(point), dtype=float) for matrix in found)
    assert np.allclose(one, other, atol=1e-12)
    return one


def errors(derivation: Derivation, setting: Setting, fact: str) -> tuple[float, float]:
    """Return the errors at TIME of the attitude by three angles, and of R M R^-1 = K A.

    `fact` is the step that has phi1' of the rates, K and H.
    """
    steps, motion = steps_of(derivation), Motion(setting)
    momentum0 = motion.momentum(RATES0)
    known = {
        **constants(),
        symbol("K"): float(np.linalg.norm(momentum0)),
        symbol("H"): motion.energy(RATES0),
    }
    phi1_rate = sympy.lambdify([RATES, MOMENTA], steps[fact].value.subs(known))
    R, momentum, phi1 = motion.run(lambda rates: phi1_rate(rates, motion.momentum(rates)))
    before = motion.turned((0.0, *motion.angles(steps, momentum0)))
    after = motion.turned((phi1, *motion.angles(steps, momentum)))
    K, target = np.linalg.norm(momentum0), motion.basis[setting.target - 1]
    M = motion.matrix(momentum)
    gap = before.conj().T @ after - R
    return np.abs(gap).max(), np.abs(after @ M @ after.conj().T - K * target).max()
