"""Bodies and spins at an edge exactly: symmetric, spherical, flat, spinning about one axis."""

from random import Random

from rigidsym.validate.strata.bodies import body, mixed, rates
from rigidsym.validate.strata.sample import Motion

# Which rates of a symmetric body are not zero; its last axis is that of symmetry.
PATTERNS = ((1, 1, 1), (1, 0, 1), (0, 1, 1), (1, 1, 0), (0, 0, 1), (1, 0, 0))
_GRID = 2.0**-40


def symmetric(random: Random, index: int) -> Motion:
    """Two equal moments, both kinds in turn; in every second case some rates are zero."""
    third = random.uniform(0.1, 0.99) if index % 2 else random.uniform(1.01, 2)
    pattern = PATTERNS[index // 4 % len(PATTERNS)] if index // 2 % 2 else PATTERNS[0]
    spin = [x * some for x, some in zip(rates(random), pattern, strict=True)]
    size = random.uniform(0.5, 1)
    # Twice an exact half is the whole, so that a disc stays flat and no flatter.
    return mixed(random, [size, size, min(size * third, 2 * size)], spin)


def sphere(random: Random, index: int) -> Motion:
    """Three equal moments."""
    return Motion((random.uniform(0.1, 2),) * 3, tuple(rates(random)))


def flat(random: Random, index: int) -> Motion:
    """Two moments whose sum, exactly, is the third."""
    x, y = (random.randint(2**35, 2**40) * _GRID for _ in range(2))
    return mixed(random, [x, y, x + y], rates(random))


def spin(random: Random, index: int) -> Motion:
    """One rate that is not zero, about the three axes in turn."""
    omega = [0.0, 0.0, 0.0]
    omega[index % 3] = random.gauss(0, 1)
    return mixed(random, sorted(body(random)), omega)
