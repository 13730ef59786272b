"""Motions of bodies in every regime, their exact states, and errors of computed states."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from random import Random

import mpmath
import numpy as np

from rigidsym import TorqueFreeMotion

DIGITS = 40


@dataclass(frozen=True, slots=True)
class Case:
    """A motion, and times at which its states are computed."""

    name: str
    inertia: tuple[float, ...]
    omega0: tuple[float, ...]
    attitude0: tuple[float, ...]
    times: tuple[float, ...]

    @property
    def given(self) -> tuple[tuple[float, ...], ...]:
        return self.inertia, self.omega0, self.attitude0

    def line(self) -> str:
        """Return a line of the driver's input."""
        numbers = " ".join(float(x).hex() for part in self.given for x in part)
        return f"{numbers} {len(self.times)} {' '.join(float(t).hex() for t in self.times)}\n"

    def exact(self, times: Sequence[float | Fraction] = ()) -> np.ndarray:
        """Return the exact states (n, 7, 2), each number as the sum of two doubles."""
        motion = TorqueFreeMotion(self.inertia, self.omega0, self.attitude0)
        with mpmath.workdps(DIGITS + 5):
            states = np.hstack(motion.precise(list(times or self.times), DIGITS))
            high = states.astype(float)
            return np.stack([high, (states - high).astype(float)], axis=-1)


def save_exact(folder: Path) -> None:
    """Save the exact states of all cases in a folder."""
    np.savez(folder / "exact.npz", *(case.exact() for case in cases()))


def with_exact(folder: Path) -> list[tuple[Case, np.ndarray]]:
    """Return all cases with the exact states that were saved in a folder."""
    with np.load(folder / "exact.npz") as saved:
        return [(case, saved[f"arr_{k}"]) for k, case in enumerate(cases())]


def cases(seed: int = 1) -> list[Case]:
    """Return a few motions of each kind, the same for each seed."""
    random = Random(seed)
    kinds = (_circulating, _near_separatrix, _symmetric, _spinning, _slender, _sized, _limits)
    return [case for kind in kinds for case in kind(random)]


def _circulating(random: Random) -> Iterator[Case]:
    for span in (10.0, 1e6, 1e12):
        for _ in range(8):
            yield _case(f"to {span:g} s", random, _body(random), _vector(random), span)


def _near_separatrix(random: Random) -> Iterator[Case]:
    """Yield motions on the separatrix of (1, 2, 2.25), and on both sides at all distances."""
    for exponent in (None, *range(3, 16)):
        for side in (1, -1):
            away = 0.0 if exponent is None else side * 10.0**-exponent
            rates = (0.75, random.choice((0.5, 0.0, 1e-9)), 1.0 + away)
            yield _turned(f"separatrix {away:g}", random, (1.0, 2.0, 2.25), rates, 100.0)


def _symmetric(random: Random) -> Iterator[Case]:
    for off in (0.0, 2.0**-52, 1e-12, 1e-8, 1e-4):
        for twin in ((1.0, 1.0 + off, 0.6), (1.0, 1.0 + off, 1.7)):
            yield _turned(f"symmetric {off:g}", random, twin, _vector(random), 1e4)
        ball = (1.0, 1.0 + off, 1.0 - off / 2)
        yield _turned(f"sphere {off:g}", random, ball, _vector(random), 1e4)


def _spinning(random: Random) -> Iterator[Case]:
    for axis in range(3):
        for off in (0.0, 1e-100, 1e-30, 1e-15, 1e-6, 1e-2):
            rates = tuple(1.3 if k == axis else off * random.gauss(0, 1) for k in range(3))
            inertia = (0.4, 0.7, 0.9)
            yield _case(f"spin {axis} {off:g}", random, inertia, rates, 1e3)
    yield _case("rest", random, _body(random), (0.0, 0.0, 0.0), 1e12)


def _slender(random: Random) -> Iterator[Case]:
    for thin in (1e-2, 1e-6, 1e-12):
        yield _turned("slender", random, (thin, 1.0, 1.0 + thin / 3), _vector(random), 1e4)
        yield _turned("disc", random, (0.5, 0.5 - thin, 1.0 - thin), _vector(random), 1e4)


def _sized(random: Random) -> Iterator[Case]:
    for size in (1e-300, 1e-150, 1e150, 1e297):
        rates = tuple(size * x for x in _vector(random))
        yield _case(f"rates {size:g}", random, _body(random), rates, 100.0 / size)
        inertia = tuple(size * x for x in _body(random))
        yield _case(f"inertia {size:g}", random, inertia, _vector(random), 100.0)
    yield Case("attitude", (1.0, 2.0, 2.5), (1.0, 2.0, 3.0), (1e300, 1e-300, -3e299, 0.0), (5.0,))
    yield Case("omega", (1.0, 2.0, 2.5), (1e150, 1e60, 1e-60), (1.0, 1.0, 0.0, 0.0), (3e-150,))


def _limits(random: Random) -> Iterator[Case]:
    """Yield motions next to k_1^2 = 1/2, where the branch changes, and the last times."""
    for away in (-1e-3, -1e-15, 1e-15, 1e-3):
        rates = _at_modulus(0.5**0.5 * (1 + away))
        yield _turned(f"switch {away:g}", random, (1.0, 0.8, 0.5), rates, 2.0**45)
    case = _case("last times", random, _body(random), (1.0, 0.3, -0.9), 1.0)
    yield replace(case, times=(2.0**46, -(2.0**46), 1 - 2.0**46))


def _at_modulus(k: float) -> tuple[float, float, float]:
    """Return rates of the body (1, 0.8, 0.5) with the descended modulus k."""
    kc = (1 - k) / (1 + k)
    wa = wb = 1.0
    e_d = 0.5 * wa**2 + 0.24 * wb**2
    e_b = kc**2 * 0.2 * e_d / 0.5
    return wa, wb, ((0.2 * wa**2 - e_b) / 0.15) ** 0.5


def _case(
    name: str, random: Random, inertia: Sequence[float], omega0: Sequence[float], span: float
) -> Case:
    attitude = tuple(random.gauss(0, 1) for _ in range(4))
    times = tuple(span * random.uniform(-1, 1) for _ in range(3))
    return Case(name, tuple(inertia), tuple(omega0), attitude, times)


def _turned(
    name: str, random: Random, inertia: Sequence[float], omega0: Sequence[float], span: float
) -> Case:
    """Return a case with the axes in another order, and with rates of other signs."""
    order = random.sample(range(3), 3)
    rates = tuple(random.choice((1, -1)) * omega0[k] for k in order)
    return _case(name, random, [inertia[k] for k in order], rates, span)


def _vector(random: Random) -> tuple[float, ...]:
    return tuple(random.gauss(0, 1) for _ in range(3))


def _body(random: Random) -> tuple[float, ...]:
    while True:
        inertia = tuple(random.uniform(0.05, 1) for _ in range(3))
        if 2 * max(inertia) < sum(inertia):
            return inertia


def errors(found: np.ndarray, exact: np.ndarray) -> tuple[float, float]:
    """Return the largest rotation angle and relative rate error of states (n, 7)."""
    apart = (found - exact[..., 0]) - exact[..., 1]
    size = np.abs(exact[:, 4:, 0]).max(axis=1, keepdims=True)
    size[size == 0] = 1.0
    rates = np.linalg.norm(exact[:, 4:, 0] / size, axis=1)
    rates[rates == 0] = 1.0
    angles = 2 * np.linalg.norm(apart[:, :4], axis=1)
    return float(angles.max()), float((np.linalg.norm(apart[:, 4:] / size, axis=1) / rates).max())


def are_right(found: np.ndarray, exact: np.ndarray, bound: float = 2e-15) -> bool:
    """Return True where both errors of states are below a bound."""
    return all(error <= bound for error in errors(found, exact))
