"""Motions drawn from the text of a ledger, at least three of every regime."""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import permutations
from random import Random

from rigidsym.solution._polhode import handedness

# The least distance from the separatrix, where periods are long.
LEAST = Fraction(1, 16)
Vector = tuple[Fraction, ...]
# Draws of each kind of motion.
DRAWS = {
    **{"rest": 3, "spherical": 3, "spin_1": 1, "spin_2": 1, "spin_3": 1},
    **{"prolate_polar": 1, "prolate_equatorial": 1, "oblate_polar": 1, "oblate_equatorial": 1},
    **{"prolate_motion": 2, "oblate_motion": 2, "separatrix_motion": 3},
    **{"largest": 3, "smallest": 3},
}


@dataclass(frozen=True, slots=True)
class Motion:
    """A motion with exact inputs, and the roles of its axes.

    `axes` are the axes a, b and d of the formulas as indices of the body's axes.  Rates circulate
    about a, and b is the middle axis.  `time` is short against a turn; it may be negative.  `spare`
    are more numbers, for torques and changes.
    """

    kind: str
    number: int
    inertia: Vector
    omega0: Vector
    attitude0: Vector
    axes: tuple[int, int, int]
    time: Fraction
    spare: Vector

    def __str__(self) -> str:
        def shown(values: Vector) -> str:
            return ", ".join(map(str, values))

        return (
            f"{self.kind} {self.number}: inertia ({shown(self.inertia)}), "
            f"omega0 ({shown(self.omega0)}), q0 ({shown(self.attitude0)}), t = {self.time}"
        )

    @property
    def circulates(self) -> bool:
        """True where the modulus is neither 0 nor 1."""
        return self.kind in ("largest", "smallest")

    @property
    def moves(self) -> bool:
        """True where the rates change."""
        return self.circulates or self.kind.endswith("_motion")

    @property
    def signs(self) -> dict[str, int]:
        """The signs epsilon, sigma, rho and chi of the formulas."""
        a, _, d = self.axes
        epsilon = handedness(*self.axes)
        sigma = -1 if self.omega0[a] < 0 else 1
        rho = 1 if self.inertia[a] > self.inertia[d] else -1
        chi = -1 if -rho * epsilon * sigma * self.omega0[d] < 0 else 1
        return {"epsilon": epsilon, "sigma": sigma, "rho": rho, "chi": chi}


def motions(text: str) -> Iterator[Motion]:
    """Draw motions of every kind from a hash of a ledger's text."""
    random = Random(int.from_bytes(hashlib.sha256(text.encode()).digest()))
    for kind, count in DRAWS.items():
        orders = random.sample([*permutations(range(3))], 6)
        # The axis a is another one in each of three draws.
        first = sorted(orders, key=lambda axes: (axes[0] + orders[0][0]) % 3)[::2]
        for number, (a, b, d) in enumerate(first[:count], 1):
            yield _drawn(kind, number, (a, b, d), random)


def _drawn(kind: str, number: int, axes: tuple[int, int, int], random: Random) -> Motion:
    # Roles are those of axes in order of moments: largest, middle, smallest.
    while True:
        c = sorted((Fraction(x, 16) for x in random.sample(range(20, 39, 3), 3)), reverse=True)
        w = [Fraction(random.choice((-1, 1)) * random.randrange(16, 40), 32) for _ in range(3)]
        share = _discriminant(c, w) * (-1 if kind == "smallest" else 1)
        if kind not in ("largest", "smallest") or share > LEAST:
            break
    if kind == "rest":
        w = [Fraction(0)] * 3
    elif kind == "spherical":
        c = [c[0]] * 3
    elif kind.startswith("spin"):
        w = [x if k == int(kind[-1]) - 1 else Fraction(0) for k, x in enumerate(w)]
    elif kind.startswith("prolate"):
        c[1] = c[0]
    elif kind.startswith("oblate"):
        c[1] = c[2]
    if kind.endswith(("polar", "equatorial")):
        symmetric = 2 if kind.startswith("prolate") else 0
        polar = kind.endswith("polar")
        w = [x if (k == symmetric) == polar else Fraction(0) for k, x in enumerate(w)]
    elif kind == "separatrix_motion":  # where c_1 c_12 Omega_1^2 = c_3 c_23 Omega_3^2
        ratio = Fraction(random.randrange(12, 24), 16)
        c[1] = (c[0] ** 2 + ratio**2 * c[2] ** 2) / (c[0] + ratio**2 * c[2])
        w[2] = random.choice((-1, 1)) * ratio * w[0]
    if kind in ("smallest", "prolate_motion"):
        c, w = c[::-1], w[::-1]
    inertia, omega0 = (tuple(x[axes.index(k)] for k in range(3)) for x in (c, w))
    components = [random.choice((-1, 1)) * random.randrange(1, 5) for _ in range(4)]
    # A unit quaternion of rational numbers is the square of one.
    p, *v = components
    square = [p * p - sum(x * x for x in v), *(2 * p * x for x in v)]
    norm = sum(x * x for x in components)
    time = Fraction(random.choice((-1, 1)) * random.randrange(24, 40), 64)
    return Motion(
        *(kind, number, inertia, omega0, tuple(Fraction(x, norm) for x in square)),
        *(axes, time / max(map(abs, (*omega0, Fraction(1))))),
        tuple(Fraction(random.choice((-1, 1)) * random.randrange(8, 32), 16) for _ in range(16)),
    )


def _discriminant(c: list[Fraction], w: list[Fraction]) -> Fraction:
    """Return (K^2 - 2 H c_2)/K^2, which is positive where rates circulate about axis 1."""
    terms = [x * rate**2 for x, rate in zip(c, w, strict=True)]
    momentum = sum((x * term for x, term in zip(c, terms, strict=True)), Fraction(0))
    return sum(((x - c[1]) * y for x, y in zip(c, terms, strict=True)), Fraction(0)) / momentum
