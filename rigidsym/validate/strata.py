"""Named strata of cases: where a numeric module could go wrong, sampled on purpose.

Every case is drawn from its own generator, seeded by seed, stratum and index, so that any case can
be drawn again alone.  Numbers are doubles, or fractions, and mean their exact values.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from rigidsym.cases import paper_case

Floats = tuple[float, ...]
Numbers = tuple[float | Fraction, ...]


@dataclass(frozen=True, slots=True)
class Sample:
    """One case: inertia (3), rates (3), attitude (4) and times, of the stratum it stands for."""

    stratum: str
    index: int
    inertia: Numbers
    omega0: Numbers
    attitude0: Floats
    times: Floats


Draw = Callable[[Random, int], tuple[Sequence[float | Fraction], Sequence[float | Fraction]]]


def _body(random: Random) -> list[float]:
    """A body that can exist: three moments of a positive mass distribution."""
    x, y, z = (random.uniform(0.05, 1) for _ in range(3))
    return [y + z, z + x, x + y]


def _rates(random: Random) -> list[float]:
    return [random.gauss(0, 1) for _ in range(3)]


def _mixed(random: Random, body: Sequence[float], rates: Sequence[float]) -> tuple[Floats, Floats]:
    """Any order of the axes and any signs."""
    order = random.sample(range(3), 3)
    signs = [random.choice((-1, 1)) for _ in order]
    flipped = [sign * rates[k] for sign, k in zip(signs, order, strict=True)]
    return tuple(body[k] for k in order), tuple(flipped)


def _uniform(random: Random, index: int) -> tuple[Floats, Floats]:
    return _mixed(random, _body(random), _rates(random))


def _separatrix_body(random: Random) -> tuple[list[float], list[float]]:
    """Near c_a (c_a - c_b) Omega_a^2 = c_d (c_b - c_d) Omega_d^2, as far as doubles say it."""
    low, middle, high = sorted(_body(random))
    fast = random.uniform(0.3, 1)
    slow = fast * math.sqrt(high * (high - middle) / (low * (middle - low)))
    return [low, middle, high], [slow, random.gauss(0, 1), fast]


def _near_separatrix(random: Random, index: int) -> tuple[Floats, Floats]:
    body, rates = _separatrix_body(random)
    rates[0] *= 1 + random.choice((-1, 1)) * 10.0 ** -(1 + index % 15)
    return _mixed(random, body, rates)


def _separatrix(random: Random, index: int) -> tuple[Floats, Floats]:
    """Doubles that are on the separatrix exactly."""
    exact = ((1.0, 2.0, 2.25), (0.75, 1.0)), ((4.0, 5.0, 9.0), (3.0, 1.0))
    body, (slow, fast) = exact[index % 2]
    return _mixed(random, body, [slow, random.gauss(0, 1), fast])


def _symmetric(random: Random, index: int) -> tuple[Floats, Floats]:
    return _mixed(random, [1.0, 1.0, random.uniform(0.1, 2)], _rates(random))


def _near_symmetric(random: Random, index: int) -> tuple[Floats, Floats]:
    split = 1 + 10.0 ** -(1 + index % 15)
    return _mixed(random, [1.0, split, random.uniform(0.15, 1.9)], _rates(random))


def _sphere(random: Random, index: int) -> tuple[Floats, Floats]:
    return (random.uniform(0.1, 2),) * 3, tuple(_rates(random))


def _near_sphere(random: Random, index: int) -> tuple[Floats, Floats]:
    size = 10.0 ** -(1 + index % 15)
    return _mixed(random, [1 + size * random.uniform(-1, 1) for _ in range(3)], _rates(random))


def _decimals(random: Random, index: int) -> tuple[Numbers, Numbers]:
    """Exact decimals that doubles only approximate: moments that nearly agree, or a separatrix."""
    if index % 3 == 0:
        body = [Fraction(x, 10) for x in (4, 5, 9)]
        rates = [Fraction(3, 10), Fraction(random.randint(-99, 99), 100), Fraction(1, 10)]
    else:
        step = Fraction(1, 10 ** (1 + index % 19))
        body = [1 + random.randint(-9, 9) * step for _ in range(3)]
        rates = [Fraction(random.randint(-999, 999), 1000) for _ in range(3)]
    order = random.sample(range(3), 3)
    return tuple(body[k] for k in order), tuple(rates[k] for k in order)


def _spin(random: Random, index: int) -> tuple[Floats, Floats]:
    rates = [0.0, 0.0, 0.0]
    rates[index % 3] = random.gauss(0, 1)
    return tuple(sorted(_body(random))), tuple(rates)


def _near_spin(random: Random, index: int) -> tuple[Floats, Floats]:
    tilt = 10.0 ** -random.choice((1, 3, 6, 9, 12, 15, 30, 100))
    rates = [tilt * random.gauss(0, 1) for _ in range(3)]
    rates[index % 3] = random.choice((-1.0, 1.0))
    return tuple(sorted(_body(random))), tuple(rates)


def _rest(random: Random, index: int) -> tuple[Floats, Floats]:
    return tuple(_body(random)), (0.0, 0.0, 0.0)


def _flat(random: Random, index: int) -> tuple[Floats, Floats]:
    x, y = random.uniform(0.05, 1), random.uniform(0.05, 1)
    return _mixed(random, [x, y, x + y], _rates(random))


def _rod(random: Random, index: int) -> tuple[Floats, Floats]:
    thin = 10.0 ** -(1 + index % 6)
    return _mixed(random, [thin, 1.0, 1 + thin * random.uniform(0.1, 0.9)], _rates(random))


def _scaled(inertia: float, rate: float) -> Draw:
    def draw(random: Random, index: int) -> tuple[Floats, Floats]:
        body, rates = _uniform(random, index)
        return tuple(inertia * x for x in body), tuple(rate * x for x in rates)

    return draw


def _turns(most: float) -> Callable[[Random, Sequence[float | Fraction]], Floats]:
    """Times at which the body has turned by up to `most` radians, either way, and t = 0."""

    def times(random: Random, rates: Sequence[float | Fraction]) -> Floats:
        rate = math.hypot(*rates) or 1.0
        return (0.0, *(random.uniform(-most, most) / rate for _ in range(3)))

    return times


STRATA: dict[str, tuple[Draw, Callable[[Random, Sequence[float | Fraction]], Floats]]] = {
    "uniform": (_uniform, _turns(50)),
    "near separatrix": (_near_separatrix, _turns(300)),
    "separatrix": (_separatrix, _turns(300)),
    "symmetric": (_symmetric, _turns(50)),
    "near symmetric": (_near_symmetric, _turns(50)),
    "sphere": (_sphere, _turns(50)),
    "near sphere": (_near_sphere, _turns(50)),
    "spin": (_spin, _turns(50)),
    "near spin": (_near_spin, _turns(100)),
    "rest": (_rest, _turns(50)),
    "flat": (_flat, _turns(50)),
    "rod": (_rod, _turns(50)),
    "small scales": (_scaled(1e-9, 1e-12), _turns(50)),
    "large scales": (_scaled(1e12, 1e6), _turns(50)),
    "decimals": (_decimals, _turns(100)),
    "long times": (_uniform, _turns(1e6)),
    "longest times": (_uniform, _turns(1e12)),
    "near separatrix, long": (_near_separatrix, _turns(1e12)),
}


def samples(cases: int, seed: int) -> Iterator[Sample]:
    """The paper's body, then `cases` samples of every stratum."""
    yield _paper()
    for stratum in STRATA:
        for index in range(cases):
            yield draw(stratum, index, seed)


def draw(stratum: str, index: int, seed: int) -> Sample:
    """One sample, the same whenever it is drawn."""
    random = Random(f"{seed}/{stratum}/{index}")
    choose, when = STRATA[stratum]
    inertia, omega0 = choose(random, index)
    attitude = tuple(random.gauss(0, 1) for _ in range(4))
    times = when(random, omega0)
    return Sample(stratum, index, tuple(inertia), tuple(omega0), attitude, times)


def _paper() -> Sample:
    """The paper's body, its decimals rounded to doubles."""
    case = paper_case()
    motion = case.motion
    exact = (*motion.exact.values(), case.times[::10])
    return Sample("paper", 0, *(tuple(map(float, values)) for values in exact))
