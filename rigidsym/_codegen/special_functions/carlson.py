"""Elliptic integral of the third kind by Carlson's duplication, in a fixed number of steps.

    integral of s^2/(1 - n s^2) du = (s^3/3) R_J(c^2, d^2, 1, 1 - n s^2)        (DLMF 19.25.14)

with s, c, d = sn, cn, dn of (u | k^2).  Each duplication (DLMF 19.36(i)) takes x, y, z, p four
times closer to each other and adds R_C(1, 1 + e), here a series in e; the rest is Taylor's, to
degree seven (DLMF 19.36.2).  e is (p - x)(p - y)(p - z) over what does not vanish, and that product
is given, since it is s^6 (1 - n)(k^2 - n)(-n) without a difference.

`STEPS` leave no more than `MEASURED`, of R_J's share in half of psi, where c >= 0 and s^2 <= 1 for
k^2 <= 1/2 and where c^2 >= k' s^2 above: measured, not proved.
"""

from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.special_functions.polynomials import horner

STEPS = 4
# What the kernel, in exact arithmetic, is off by at most, on the grids of the tests.
MEASURED = 3e-19
# Terms of R_C's series: e falls by 64 and more with each step.
_TERMS = (12, 8, 5, 4)
_DOUBLING, _TAYLOR, _ELEMENTARY = "DLMF 19.36.1", "DLMF 19.36.2", "DLMF 19.2.17"


def third_kind() -> Function:
    """Build the function that computes (s^3/3) R_J(c^2, d^2, 1, p) for c, d, p > 0.

    spread: (p - c^2)(p - d^2)(p - 1)/s^6.
    """
    lets = [
        let("square = s*s", "DLMF 19.25.14"),
        let("e_0 = spread*(square*(square*square))", _DOUBLING),
        let("x_0 = c*c", "DLMF 19.25.14"),
        let("y_0 = d*d", "DLMF 19.25.14"),
        let("mean_0 = (1/5)*(x_0 + y_0 + 1 + 2*p_0)", _DOUBLING),
    ]
    for step in range(STEPS):
        lets += _duplication(step)
    lets += _taylor()
    elementary = f"added_{STEPS - 1}"
    for step in reversed(range(STEPS - 1)):
        elementary = f"added_{step} + ({elementary})/4"
    lets.append(let(f"elementary = {elementary}", _DOUBLING))
    lets.append(
        let("J = s*square*(2*elementary + rest)", "DLMF 19.25.14"),
    )
    summary = "(s^3/3) R_J(c^2, d^2, 1, p); spread s^6 is (p - c^2)(p - d^2)(p - 1)."
    return Function("_third_kind", summary, ("s", "c", "d", "p_0", "spread"), tuple(lets), ("J",))


def _duplication(n: int) -> list[Let]:
    """Return assignments for one duplication step of Carlson's R_J.

    They compute the roots, the term by R_C, and the next x, y, z, p and mean.
    """
    roots = [let(f"root_p_{n} = sqrt(p_{n})", _DOUBLING)]
    names = {"x": "c", "y": "d", "z": "1"} if n == 0 else {x: f"root_{x}_{n}" for x in "xyz"}
    if n:
        roots += [let(f"{name} = sqrt({x}_{n})", _DOUBLING) for x, name in names.items()]
    x, y, z = names.values()
    lets = [
        *roots,
        let(f"step_{n} = {x}*({y} + {z}) + {y}*{z}", _DOUBLING),
        let(
            f"inverse_{n} = 1/((root_p_{n} + {x})*(root_p_{n} + {y})*(root_p_{n} + {z}))",
            _DOUBLING,
        ),
        let(f"ratio_{n} = e_{n}*(inverse_{n}*inverse_{n})", _DOUBLING),
        let(f"added_{n} = inverse_{n}*({_arctangent(f'ratio_{n}', _TERMS[n])})", _ELEMENTARY),
    ]
    for name in ("x", "y", "z", "p", "mean"):
        before = "1" if (name, n) == ("z", 0) else f"{name}_{n}"
        lets.append(let(f"{name}_{n + 1} = ({before} + step_{n})/4", _DOUBLING))
    return [*lets, let(f"e_{n + 1} = e_{n}/64", _DOUBLING)]


def _arctangent(variable: str, terms: int) -> str:
    """Format the truncated arctangent series of Carlson's R_C(1, 1 + e) in powers of e.

    R_C(1, 1 + e) = arctan(sqrt(e))/sqrt(e) = 1 - e/3 + e^2/5 - ...
    """
    return horner(variable, ["1", *(f"({(-1) ** n})/{2 * n + 1}" for n in range(1, terms))])


def _taylor() -> list[Let]:
    """Return assignments for the Taylor part of R_J after all duplications.

    It is a third of what remains of R_J, by a series in elementary symmetric functions.
    """
    share, mean = 4**STEPS, f"mean_{STEPS}"
    return [
        let(f"scale = 1/({share}*{mean})", _TAYLOR),
        let("X = (mean_0 - x_0)*scale", _TAYLOR),
        let("Y = (mean_0 - y_0)*scale", _TAYLOR),
        let("Z = (mean_0 - 1)*scale", _TAYLOR),
        let("P = -(X + Y + Z)/2", _TAYLOR),
        let("P2 = P*P", _TAYLOR),
        let("XYZ = X*Y*Z", _TAYLOR),
        let("E2 = X*Y + X*Z + Y*Z - 3*P2", _TAYLOR),
        let("E3 = XYZ + 2*E2*P + 4*P2*P", _TAYLOR),
        let("E4 = (2*XYZ + E2*P + 3*P2*P)*P", _TAYLOR),
        let("E5 = XYZ*P2", _TAYLOR),
        let(
            "low = (1/6)*E3 - (3/22)*E4 + (3/26)*E5 - E2*(3/14 - (9/88)*E2 + (9/52)*E3)",
            _TAYLOR,
        ),
        let(
            "high = (3/40)*(E3*E3) + (3/20)*(E2*E4) - E2*E2*(E2/16 - (45/272)*E3)"
            " - (9/68)*(E3*E4 + E2*E5)",
            _TAYLOR,
        ),
        let(f"rest = (1 + (low + high))/({3 * share}*({mean}*sqrt({mean})))", _TAYLOR),
    ]
