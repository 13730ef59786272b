"""Exact numbers, for a discriminant whose terms cancel.

Shewchuk, Discrete and Computational Geometry 18, 1997.
"""


class exact:
    """Sum of non-overlapping doubles, smallest first; 32 hold any value of `discriminant`."""

    count: size
    part: double[32]


def grown(part: out[double[...]], count: size, a: double) -> size:
    """Add a double to the parts of an exact number, and return how many there are then."""
    kept: size = 0
    rest: double = a
    for i in range(count):
        s: pair = two_sum(rest, part[i])
        if s.lo < 0.0 or s.lo > 0.0:
            part[kept] = s.lo
            kept += 1
        rest = s.hi
    part[kept] = rest
    return kept + 1


def exact_of(a: double) -> exact:
    """Return a double as an exact number."""
    x: exact
    x.count = 1
    x.part[0] = a
    return x


def exact_sub_xx(x: exact, y: exact) -> exact:
    """Return x - y."""
    z: exact = x
    for i in range(y.count):
        z.count = grown(z.part, z.count, -y.part[i])
    return z


def exact_mul_xx(x: exact, y: exact) -> exact:
    """Return x y."""
    z: exact
    z.count = 0
    for i in range(x.count):
        for j in range(y.count):
            p: pair = two_product(x.part[i], y.part[j])
            z.count = grown(z.part, z.count, p.lo)
            z.count = grown(z.part, z.count, p.hi)
    return z


def exact_discriminant(
    c_a: double, c_b: double, c_d: double, Omega_a: double, Omega_d: double
) -> pair:
    """Return the discriminant of doubles, as a pair rounded from its exact value."""
    above: exact = exact_sub_xx(exact_of(c_a), exact_of(c_b))
    below: exact = exact_sub_xx(exact_of(c_b), exact_of(c_d))
    E_b: exact = discriminant_exact(
        exact_of(c_a), exact_of(c_d), above, below, exact_of(Omega_a), exact_of(Omega_d)
    )
    total: pair = pair(0.0, 0.0)
    for i in range(E_b.count):
        total = total + E_b.part[i]
    return total
