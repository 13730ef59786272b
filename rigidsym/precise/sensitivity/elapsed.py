"""The functions of elapsed time that sensitivities are made of, over Arb's balls.

With p = lambda^2, r = m lambda^2 and 0 <= r <= p,

    S = sn(lambda t | m)/lambda,    C = cn,    D = dn,    E = int S^2,    F = int S^2/D^2

from 0 to t: the last two are J(u, n) = int sn^2/(1 - n sn^2) over lambda^3, with n = 0 and n = m.
On the separatrix, about an axis of symmetry, and where p vanishes, they are elementary.
"""

from typing import NamedTuple

from flint import arb

from rigidsym.precise.amplitude import Functions


class Elapsed(NamedTuple):
    """S, C, D, E and F by the names that formulas use."""

    S_t: arb
    C_t: arb
    D_t: arb
    E_t: arb
    F_t: arb


def elapsed(t: arb, p: arb, r: arb, gap: arb, functions: Functions) -> Elapsed:
    """At a time; `gap` is p - r, which like p is known to be zero where it is."""
    if p.is_zero():
        cube = t * t * t / 3
        return Elapsed(t, arb(1), arb(1), cube, cube)
    rate = p.sqrt()
    u, mc = rate * t, arb(1) if r.is_zero() else gap / p
    s, c, d = functions.jacobi(u, mc)
    return Elapsed(s / rate, c, d, *(x / (rate * p) for x in _integrals(u, mc, functions)))


def _integrals(u: arb, mc: arb, functions: Functions) -> tuple[arb, arb]:
    """Of sn^2 and of sd^2."""
    if mc.is_zero():
        return u - u.tanh(), ((2 * u).sinh() / 2 - u) / 2
    if mc == 1:
        return (value := functions.elliptic_j(u, arb(0), mc)), value
    return functions.elliptic_j(u, arb(0), mc), functions.elliptic_j(u, 1 - mc, mc)
