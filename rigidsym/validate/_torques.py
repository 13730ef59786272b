"""Validation of the errors of `integrate` against its tolerance, for difficult torques.

The reference is SciPy's Dormand-Prince method of order 8, restarted wherever the torque jumps or
bends.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from random import Random

import numpy as np

from rigidsym.errors import PrecisionError
from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.splitting import METHODS, Torque, integrate
from rigidsym.validate._applications import Application, Goal
from rigidsym.validate.peers._integrators import rates
from rigidsym.validate.peers._protocol import needed

# Of the reference, of unit quaternions and of the largest rate.
_EXACT = 1e-12
# Steps of low orders are many for small tolerances.
_LEAST = {"strang": 1e-4, "saba2": 1e-5}

Profile = Callable[[float], float]
Vector = tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Case:
    """Body under a torque, with the arguments for `integrate`.

    breaks: times at which the torque is not smooth, s.  discontinuities: those that are passed on.
    """

    inertia: Vector
    q0: Vector
    omega0: Vector
    torque: Torque
    times: Vector
    breaks: Vector
    discontinuities: Vector
    method: str
    tolerance: float
    rate_dependent: bool = False


@dataclass(frozen=True, slots=True)
class _Body:
    """Random body with a source of random torques."""

    inertia: Vector
    q0: Vector
    omega0: Vector
    span: float
    rate: float
    random: Random

    @classmethod
    def drawn(cls, random: Random, at_rest: bool = False) -> "_Body":
        c = sorted(random.uniform(0.2, 1) for _ in range(2))
        moments = [*c, random.uniform(max(c[1], c[1] - c[0] + 0.05), sum(c))]
        random.shuffle(moments)
        scale, rate = 10 ** random.uniform(-3, 3), 10 ** random.uniform(-2, 1)
        unit = _unit(random, 3)
        return cls(
            tuple(scale * x for x in moments),
            _unit(random, 4),
            (0.0,) * 3 if at_rest else tuple(rate * x for x in unit),
            10 ** random.uniform(0.3, 1.7) / rate,
            rate,
            random,
        )

    def pushed(self, profile: Profile, breaks: Vector = (), seconds: float | None = None) -> "Case":
        """Return a case with a torque whose magnitude is a given function of time.

        It changes the rates by a part of themselves in one radian, or in `seconds`.
        """
        random = self.random
        strength = 10 ** random.uniform(-1.5, 0) * self.rate / (seconds or 1 / self.rate)
        vector = strength * np.array(self.inertia) * _unit(random, 3)
        kind = random.randrange(3)
        lever = np.array(_unit(random, 3))

        def torque(t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
            found = profile(t) * vector
            if kind:
                found = _in_body(q, found)
            return found if kind < 2 else _cross(lever, found)

        return self.case(torque, breaks)

    def case(self, torque: Torque, breaks: Vector = (), rate_dependent: bool = False) -> "Case":
        random = self.random
        inside = sorted(random.uniform(0, self.span) for _ in range(random.randrange(4)))
        method = random.choice(list(METHODS))
        tolerance = max(10 ** random.uniform(-6.5, -3), _LEAST.get(method, 0.0))
        breaks = tuple(sorted(t for t in breaks if 0 < t < self.span))
        passed = breaks if random.random() < 0.2 else ()
        times = 0.0, *inside, self.span
        body = self.inertia, self.q0, self.omega0
        return Case(*body, torque, times, breaks, passed, method, tolerance, rate_dependent)


def kink(random: Random, at_rest: bool = False) -> Case:
    """Draw a case with a continuous torque that has kinks.

    It is a sine cut at zero, the modulus of a sine, or a zigzag.
    """
    body = _Body.drawn(random, at_rest)
    rate, phase = body.rate * 10 ** random.uniform(-0.5, 0.7), random.uniform(0, 6)
    zeros = _zeros(rate, phase, body.span)
    kind = random.randrange(3)

    def profile(t: float) -> float:
        sine = math.sin(rate * t + phase)
        if kind == 2:
            return math.asin(math.cos(rate * t + phase))
        return abs(sine) if kind else max(0.0, sine)

    return body.pushed(profile, zeros)


def jump(random: Random, at_rest: bool = False) -> Case:
    """Draw a case with a torque that jumps.

    It jumps between random levels, or by the sign of a sine.
    """
    body = _Body.drawn(random, at_rest)
    if random.random() < 0.3:
        rate, phase = body.rate * 10 ** random.uniform(-0.5, 0.5), random.uniform(0, 6)
        return body.pushed(
            lambda t: math.copysign(1.0, math.sin(rate * t + phase)), _zeros(rate, phase, body.span)
        )
    times = sorted(random.uniform(0, body.span) for _ in range(random.randint(1, 8)))
    levels = [random.uniform(-1, 1) for _ in range(len(times) + 1)]
    return body.pushed(lambda t: levels[int(np.searchsorted(times, t, "right"))], tuple(times))


# A box, a bell and a half sine of width 1 at half their height, each with places where it is not
# smooth, and some more at which the reference is restarted.
_PULSES: list[tuple[Profile, Vector]] = [
    (lambda x: 1.0 if abs(x) <= 0.5 else 0.0, (-0.5, 0.5)),
    (lambda x: math.exp(-4 * math.log(2) * x * x), (-3, -0.5, 0.5, 3)),
    (lambda x: math.sin(math.pi * (0.75 * x + 0.5)) if abs(x) < 2 / 3 else 0.0, (-2 / 3, 2 / 3)),
]


def pulse(random: Random, at_rest: bool = False) -> Case:
    """Draw a case with a torque of short pulses.

    Pulses are boxes, bells or half sines.  They are 1/200 to 1/5 of the span wide at half their
    height.
    """
    body = _Body.drawn(random, at_rest)
    pulses = []
    for _ in range(random.randint(1, 3)):
        width = body.span * 10 ** random.uniform(-math.log10(200), -math.log10(5))
        pulses.append((random.uniform(0, body.span), width))
    shape, ends = random.choice(_PULSES)
    least = min(width for _, width in pulses)
    edges = [t + k * width for t, width in pulses for k in ends]
    return body.pushed(
        lambda t: sum(shape((t - middle) / width) for middle, width in pulses), tuple(edges), least
    )


def stiff(random: Random) -> Case:
    """Draw a case with a stiff torque, which acts far faster than the body moves.

    It is damping, a spring or an oscillation.
    """
    body = _Body.drawn(random)
    begin, end = sorted(random.uniform(0, body.span) for _ in range(2))
    quick = 10 ** random.uniform(1, 2.5) / body.span
    edge = (end - begin) / 10
    kind = random.randrange(3)

    def window(t: float) -> float:
        return 0.5 * (math.tanh((t - begin) / edge) - math.tanh((t - end) / edge))

    inertia, rest = np.array(body.inertia), np.array(_unit(random, 3))
    if kind == 0:
        return body.case(lambda t, q, omega: -quick * window(t) * inertia * omega, (), True)
    if kind == 1:
        strength = quick**2 * float(np.min(inertia)) / 4
        return body.case(lambda t, q, omega: _cross(rest, _in_body(q, strength * window(t) * rest)))
    return body.pushed(lambda t: window(t) * math.sin(quick * t))


def facing(random: Random) -> Case:
    """Draw a case with a torque that acts while one side of the body is lit.

    It has kinks or jumps that depend on the attitude.
    """
    body = _Body.drawn(random)
    inertia = np.array(body.inertia)
    light, normal, push = (np.array(_unit(random, 3)) for _ in range(3))
    strength = 10 ** random.uniform(-1.5, -0.3) * body.rate**2
    jumps = random.random() < 0.3

    def torque(t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        lit = float(normal @ _in_body(q, light))
        part = 1.0 * (lit > 0) if jumps else max(lit, 0.0)
        return strength * part * inertia * push

    return body.case(torque)


def rest(random: Random) -> Case:
    """Draw a case of a body at rest under a torque with kinks, jumps or pulses."""
    return random.choice([kink, jump, pulse])(random, True)


def smooth(random: Random) -> Case:
    """Draw a case with a smooth torque, for comparison."""
    body = _Body.drawn(random)
    rate = body.rate * 10 ** random.uniform(-1, 0.5)
    return body.pushed(lambda t: math.sin(rate * t + 1.0))


def measured(case: Case, engine: str = "c") -> float | None:
    """Integrate a case, and return its true error divided by the tolerance.

    Returns None if `integrate` refuses.
    """
    try:
        found = integrate(
            case.inertia,
            case.q0,
            case.omega0,
            case.torque,
            case.times,
            step=None,
            method=case.method,
            tolerance=case.tolerance,
            discontinuities=case.discontinuities,
            rate_dependent=case.rate_dependent,
            engine=engine,
        )
    except PrecisionError:
        return None
    return error(case, found.q, found.omega) / case.tolerance


def error(case: Case, q: np.ndarray, omega: np.ndarray) -> float:
    """Return the largest error of the attitude, rad, or of the rates, relative."""
    true_q, true_omega = reference(case)
    turns = np.linalg.norm(rotation_vectors(product(conjugate(true_q), q)), axis=-1)
    size = np.max(np.linalg.norm(true_omega, axis=-1))
    parts = np.linalg.norm(omega - true_omega, axis=-1) / (size or 1.0)
    return float(max(np.max(turns), np.max(parts)))


def reference(case: Case) -> tuple[np.ndarray, np.ndarray]:
    """Compute accurate reference states at the times of a case.

    They are q (N, 4) and omega (N, 3).
    """
    solve = needed("dop853", "scipy.integrate", "scipy")[0].solve_ivp
    inertia = np.array(case.inertia)
    state, states = np.array([*case.q0, *case.omega0]), []
    size = max(np.linalg.norm(case.omega0), 1 / case.times[-1])
    absolute = _EXACT / 10 * np.array([1.0] * 4 + [size] * 3)
    ends = sorted({*case.times, *case.breaks})
    for begin, end in pairwise(ends):
        if begin in case.times:
            states.append(state)
        inner = math.nextafter(begin, end), math.nextafter(end, begin)

        def derivative(t: float, y: np.ndarray, inner: Vector = inner) -> np.ndarray:
            found = np.array(rates(y.tolist(), case.inertia))
            # On this side of a jump.
            t = min(max(t, inner[0]), inner[1])
            found[4:] += case.torque(t, y[:4] / np.linalg.norm(y[:4]), y[4:]) / inertia
            return found

        most = (case.times[-1] - case.times[0]) / 400
        found = solve(
            derivative, (begin, end), state, "DOP853", rtol=_EXACT, atol=absolute, max_step=most
        )
        state = found.y[:, -1]
    states.append(state)
    q, omega = np.split(np.array(states), [4], axis=1)
    return q / np.linalg.norm(q, axis=-1, keepdims=True), omega


APPLICATION = Application(
    "torques",
    {draw.__name__: draw for draw in (smooth, kink, jump, pulse, stiff, rest, facing)},
    measured,
    Goal(refused=0.02, most=3.0, part=0.99, worst=10.0),
)


def _unit(random: Random, size: int) -> Vector:
    vector = [random.gauss(0, 1) for _ in range(size)]
    return tuple(x / math.hypot(*vector) for x in vector)


def _in_body(q: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """Convert the components of a vector from inertial to body axes.

    This uses Python's floats, which are faster than small arrays.
    """
    (a, b, c, d), (x, y, z) = q.tolist(), vector.tolist()
    u, v, w = 2 * (y * d - z * c), 2 * (z * b - x * d), 2 * (x * c - y * b)
    return np.array(
        [x + a * u + v * d - w * c, y + a * v + w * b - u * d, z + a * w + u * c - v * b]
    )


def _cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    (a, b, c), (x, y, z) = one.tolist(), other.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


def _zeros(rate: float, phase: float, span: float) -> Vector:
    first, last = math.ceil(phase / math.pi), math.floor((rate * span + phase) / math.pi)
    return tuple((k * math.pi - phase) / rate for k in range(first, last + 1))
