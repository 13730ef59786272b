"""phi1 as an elliptic integral of the third kind: (33) by partial fractions to (34), (35), (36).

Where a rate is zeta sn, the integrand (33) is a fraction in sn^2.  Its partial fractions are a
constant and a multiple of 1/(1 - n sn^2), which is the derivative of Legendre's Pi in the table: n
and the factor kappa are read off.
"""

from dataclasses import dataclass
from typing import Any

import sympy

from derivations.euler_lax import RATES
from derivations.kinematics import Phi1
from derivations.lie_algebra import Algebra
from rigidsym.language.functions._jacobi import jacobi_dn, jacobi_sn
from rigidsym.proof.algebra import LedgerBuilder, Part, jacobi
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps import Scope, apart, integrate, rate_of, rewrite
from rigidsym.proof.steps._names import symbol, symbols

K, H, ZETA, XI, MU, T = symbols("K H zeta xi mu t")
ARGUMENT = XI * T + symbol("gamma")
SN, DN = jacobi_sn(ARGUMENT, MU), jacobi_dn(ARGUMENT, MU)
sn, dn, n, Pi, phi1, kappa, theta = symbols("sn dn n Pi phi1 kappa theta")
FUNCTIONS = jacobi("sn", "cn", "dn", "xi*t + gamma", "mu", "xi")
AMPLITUDE = Part({theta: "jacobi_am(xi*t + gamma, mu)"}, rates={theta: XI * dn})


def constants(axis: int, moment: str = "") -> Part:
    """Return a moment of inertia, the invariants, and constants of zeta sn(xi t + gamma | mu)."""
    c = symbol(moment or f"c{axis}")
    return Part(
        (c, H, K, ZETA, XI, MU),
        units=(c, K),
        reading={
            H: "kinetic energy, J",
            K: "|M|, kg m^2 rad/s",
            ZETA: f"amplitude of Omega{axis}, rad/s",
            XI: "rate of the argument, rad/s",
            MU: "parameter (k^2) of the Jacobi functions",
        },
    )


def sine(axis: int, moment: str = "") -> Part:
    """Return a rate that is zeta sn, with K^2 - (c Omega)^2 never zero."""
    momentum = symbol(moment or f"c{axis}") * ZETA * sn
    units = (K - momentum, K + momentum)
    return Part(units=units, definitions={RATES[axis - 1]: ZETA * sn})


@dataclass(frozen=True, slots=True)
class ThirdKind:
    """Results of this chapter: phi1 = K/c t + kappa Pi, and phi1' in partial fractions."""

    axis: int
    parts: tuple[Part, ...]
    rate: Computation


def derive(builder: LedgerBuilder) -> None:
    """Prove (34), its integral (36), and (35)."""
    setting = builder.result(Algebra).setting
    axis, moment = setting.axes[0], str(setting.moment(setting.axes[0]))
    integrand = builder.result(Phi1).by_invariants
    if integrand.free_symbols & {*RATES} != {RATES[axis - 1]}:
        return  # wheels about other axes: phi1' is no function of one rate
    if any(h != 0 for h in setting.wheel()) or not setting.about_principal_axes:
        return  # the rates of a gyrostat, or about other axes, are no multiples of sn
    given = (constants(axis, moment), FUNCTIONS, sine(axis, moment))
    scope = Scope.open(builder, "sine_motion", *given, static=True)
    put_in = integrand.subs(RATES[axis - 1], ZETA * SN)
    split = apart(put_in, SN**2)
    why = "with the rate put in, partial fractions in sn^2"
    rewrite(scope, "split", integrand, split, why, [34], "partial_fractions")

    found = split.apply(_parameter)
    table = Part(
        {Pi: "elliptic_pi(n, jacobi_am(xi*t + gamma, mu), mu)", T: "time, s"},
        definitions={n: found},
        rates={Pi: compute(XI / (1 - n * sn**2)).ordered("xi n"), T: 1},
        units=(XI,),
    )
    scope = Scope.open(builder, "table", *given, table)
    rates = {T: sympy.S.One, Pi: XI / (1 - found.value * SN**2)}
    why = "integrated term by term, by the table that has the rate of Pi"
    total = integrate(scope, "phi1", split, rates, why, [19, 36]).found
    factor = total.coeff(Pi)
    named = Part(definitions={kappa: factor, phi1: total.subs(factor * Pi, kappa * Pi)})
    scope = Scope.open(builder, "third_kind", *given, table, named)
    why, law = "so phi1 has the rate (33)", "(33), which phi1 was integrated from"
    source, verb = [19, 33], "differentiate"
    rewrite(scope, "phi1", rate_of(phi1), integrand, why, source, verb, law=law)
    builder.keep(ThirdKind(axis, (*given, table, named), split))

    scope = Scope.open(builder, "amplitude", given[0], FUNCTIONS, AMPLITUDE)
    why = "the square of the rate of the amplitude theta"
    by_sn = compute(DN**2 + MU * SN**2 - 1).solve_for(DN**2)
    squared = rate_of(theta) ** 2
    rewrite(scope, "squared", squared, XI**2 * by_sn, why, [35], "differentiate")


def _parameter(split: Any) -> sympy.Expr:
    """Return n of a sum of constants and c/(1 - n sn^2)."""
    (term,) = (term for term in split.args if term.has(SN))
    (below,) = (1 / factor for factor in sympy.Mul.make_args(term) if factor.has(SN))
    return -sympy.expand(below).coeff(SN**2)
