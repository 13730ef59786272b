"""Windings of Pi: its integral along the real line grows by the same amount each half turn.

    Pi(n; theta + k pi | m) = 2 k Pi(n | m) + Pi(n; theta | m),        n < 1,  m < 1,  k whole

(19) needs it, since theta = am grows without end.  The integrand at theta + pi is that at theta, so
Pi grows as much from theta as from -pi/2: by 2 Pi(n | m), the integral over a half turn.  If what k
half turns add is known for all theta, at theta + pi it is what k + 1 of them add at theta.
"""

import sympy

from rigidsym.proof.algebra import LedgerBuilder, Part
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import Scope, differentiate, nonnegative
from rigidsym.proof.steps._names import symbols

n, m, k, theta, sine, cosine, root = symbols("n m k theta sine cosine root")
Pi, Pi_c, Pi_later = symbols("Pi Pi_c Pi_later")
# theta, its sine and cosine, and Delta = sqrt(1 - m sin^2); Pi_later is Pi at theta + pi.
TURNING = Part(
    (n, m, k, sine, cosine, root),
    units=(root, 1 - n, 1 - n * sine**2),
    relations=("cosine**2 + sine**2 - 1", "root**2 + m*sine**2 - 1"),
    rates={sine: cosine, cosine: -sine, root: -m * sine * cosine / root},
    nonnegative=(root, 1 - n),
    reading={
        sine: sympy.sin(theta),
        cosine: sympy.cos(theta),
        root: sympy.sqrt(1 - m * sine**2),
        k: "a whole number of half turns",
    },
)
INTEGRAL = Part(
    (theta, Pi_c, Pi, Pi_later),
    rates={
        theta: 1,
        Pi: "1/((1 - n*sine**2)*root)",
        Pi_later: "1/((1 - n*(-sine)**2)*root)",  # the sine of theta + pi is -sine
    },
    start=("sine + 1", cosine, "Pi + Pi_c", Pi_later - Pi_c),  # theta is -pi/2
    reading={
        Pi: sympy.elliptic_pi(n, theta, m),
        Pi_later: "elliptic_pi(n, theta + pi, m)",
        Pi_c: sympy.elliptic_pi(n, m),
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that the rest of the rule is constant in theta, with a nonnegative denominator."""
    scope = Scope.open(builder, "windings", TURNING, INTEGRAL)
    rest, why = Pi_later - 2 * Pi_c - Pi, "what half turns add grows no further"
    differentiate(scope, "slope", rest, why, [19, 20, 21])
    path = 1 - n * sympy.sin(theta) ** 2
    form = compute(path) + sympy.cos(theta) ** 2 + sympy.sin(theta) ** 2 - 1
    form = form.expand().collect(sympy.sin(theta) ** 2)
    nonnegative(scope, "path", path, form, "the integral meets no pole", [19])
    # So Pi_later - Pi is what it is where theta is -pi/2.
    added = compute(Pi_later - Pi).subs({Pi_later: Pi_c, Pi: -Pi_c})
    rule = {Pi_later: Pi + added, 2 * k * Pi_c + Pi_later: 2 * k * Pi_c + Pi + added}
    builder.start("windings.rule", rule, [19, 20, 21])
