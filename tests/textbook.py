"""Reference solution of asymmetric motions by mpmath, with random bodies.

Nothing here comes from the project, so that what it derives can be compared.
"""

from dataclasses import dataclass
from fractions import Fraction
from itertools import permutations, product
from random import Random
from typing import Any

from mpmath import mp

ORDERS = list(permutations(range(3)))
OCTANTS = list(product((1, -1), repeat=3))
CIRCULATIONS = ("largest", "smallest")
# Every order of the axes with both circulations.
FAMILIES = [(order, about) for order in ORDERS for about in CIRCULATIONS]


def draw(order, about, signs, seed=0):
    """Draw exact random inertia, angular velocity and attitude of an asymmetric body.

    Axis k has the moment of rank order[k].
    """
    random = Random(f"{seed}/{order}/{about}/{signs}")
    while True:
        moments = sorted(Fraction(random.randint(20, 99), 10) for _ in range(3))
        inertia = tuple(moments[rank] for rank in order)
        omega = tuple(s * Fraction(random.randint(5, 99), 50) for s in signs)
        excess = sum(c * (c - moments[1]) * w * w for c, w in zip(inertia, omega, strict=True))
        if len({*moments}) == 3 and (excess > 0) - (excess < 0) == (
            1 if about == "largest" else -1
        ):
            return inertia, omega, tuple(Fraction(random.randint(-9, 9)) for _ in range(3)) + (1,)


@dataclass
class Motion:
    """Constants of Jacobi's solution after one descending Landen transformation."""

    inertia: tuple[Fraction, ...]
    omega: tuple[Fraction, ...]

    def __post_init__(self) -> None:
        c, w = self.inertia, self.omega
        low, b, high = sorted(range(3), key=lambda k: c[k])
        twice_energy = sum(x * y * y for x, y in zip(c, w, strict=True))
        square = sum((x * y) ** 2 for x, y in zip(c, w, strict=True))
        a, d = (high, low) if square > twice_energy * c[b] else (low, high)
        self.axes = a, b, d
        self.epsilon = (a - b) * (b - d) * (d - a) // 2
        self.sigma = 1 if w[a] > 0 else -1
        self.rho = 1 if c[a] > c[d] else -1
        self.chi = 1 if -self.rho * self.epsilon * self.sigma * w[d] > 0 else -1
        e_a, e_d = twice_energy * c[a] - square, square - twice_energy * c[d]
        self.K, self.H = root(square), number(twice_energy / 2)
        self.c_a, self.c_b, self.c_d = (number(c[k]) for k in self.axes)
        self.B_a = root(c[a] * e_d / (c[a] - c[d]))
        self.B_d = root(c[d] * e_a / (c[a] - c[d]))
        self.lambda_ = root((c[a] - c[b]) * e_d / (c[a] * c[b] * c[d]))
        self.m = number(e_a * (c[d] - c[b]) / (e_d * (c[b] - c[a])))
        k_c = mp.sqrt(1 - self.m)
        self.k_1 = (1 - k_c) / (1 + k_c)
        self.mu = self.lambda_ / (1 + self.k_1)
        sine = self.chi * number(w[b]) / root(e_a / (c[b] * (c[a] - c[b])))
        self.phase = mp.ellipf(mp.asin(sine), self.m) / (1 + self.k_1)
        self.period = 4 * mp.ellipk(self.m) / self.lambda_
        self.psi_0 = (2 * self.H + self.K * self.B_a / self.c_a) / (self.K + self.B_a)
        self.x = mp.sqrt((self.K - self.B_a) / (self.k_1 * (self.K + self.B_a)))


def number(value: Fraction) -> Any:
    return mp.mpf(value.numerator) / value.denominator


def root(value: Fraction) -> Any:
    return mp.sqrt(number(value))


def exactly(value: Any) -> Fraction:
    """Convert an mpf to the rational number that is equal to it."""
    sign, mantissa, exponent, _ = value._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def multiply(p, q):
    """Return the Hamilton product of two quaternions, scalar first."""
    (a, b, c, d), (e, f, g, h) = p, q
    return [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]


def conjugate(q):
    return [q[0], *(-x for x in q[1:])]


def distance(given, expected):
    return max(abs(x - y) for x, y in zip(given, expected, strict=True))
