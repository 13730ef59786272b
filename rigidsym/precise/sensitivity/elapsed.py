"""The functions of elapsed time that sensitivities are made of, over Arb's balls.

With p = lambda^2, r = m lambda^2 and 0 <= r <= p,

    S = sn(lambda t | m)/lambda,    C = cn,    D = dn,    E = int S^2,    f = D int S^2/D^2

from 0 to t: the integrals are J(u, n) = int sn^2/(1 - n sn^2) over lambda^3, with n = 0 and n = m.
Near the separatrix the second one changes much from motion to motion, but times D it hardly does.
On the separatrix, about an axis of symmetry, and where p vanishes, they are elementary.
"""

from typing import NamedTuple

from flint import arb

from rigidsym.precise.amplitude import Functions, quarter_period


class Elapsed(NamedTuple):
    """S, C, D, E and f by the names that formulas use."""

    S_t: arb
    C_t: arb
    D_t: arb
    E_t: arb
    f: arb


def elapsed(t: arb, p: arb, r: arb, gap: arb, functions: Functions) -> Elapsed:
    """At a time; `gap` is p - r, which like p is known to be zero where it is."""
    if p.is_zero():
        cube = t * t * t / 3
        return Elapsed(t, arb(1), arb(1), cube, cube)
    rate, zero, m, mc = functions.kept(_modulus, p, r, gap)
    u = rate * t
    s, c, d = functions.jacobi(u, mc)
    integrals = _integrals(u, (zero, m), mc, functions)
    first, second = (x / (rate * p) for x in integrals)
    return Elapsed(s / rate, c, d, first, d * second)


def until_quarter(t: arb, p: arb, r: arb, gap: arb) -> bool:
    """Whether a time is within the first quarter of a period, where cn and dn have no zero."""
    if p.is_zero() or (gap.is_zero() and not r.is_zero()):
        return True
    return bool(abs(t) * p.sqrt() < quarter_period(gap / p))


def _modulus(p: arb, r: arb, gap: arb) -> tuple[arb, arb, arb, arb]:
    """lambda, zero, m and 1 - m: the same objects at all times, so that what is theirs is kept."""
    mc = arb(1) if r.is_zero() else gap / p
    return p.sqrt(), arb(0), 1 - mc, mc


def _integrals(u: arb, n: tuple[arb, arb], mc: arb, functions: Functions) -> tuple[arb, arb]:
    """Of sn^2 and of sd^2, by J with n = 0 and n = m."""
    if mc.is_zero():
        return u - u.tanh(), ((2 * u).sinh() / 2 - u) / 2
    if mc == 1:
        return (value := functions.elliptic_j(u, n[0], mc)), value
    return functions.elliptic_j(u, n[0], mc), functions.elliptic_j(u, n[1], mc)
