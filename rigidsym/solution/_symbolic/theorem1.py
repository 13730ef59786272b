"""The solution of the paper's Theorem 1 in SymPy.

Rates follow from Lemma 1, phi1 from Pi, and the attitude from (18) and (37).

With free symbols it is the paper's solution on one interval, over complex numbers.  With a motion's
numbers it holds at all times, and is real:

* About the axis that the rates circulate about, xi is imaginary, and xi t + C runs beside +-K(mu),
  where with mu' = 1 - mu (DLMF 22.4(iii), 22.6(iv))

      sn(+-K + i y | mu) = +-1/dn(y | mu'),
      Pi(n; +-K + i y) - Pi(n; +-K) = i (y + n/(1 - n) Pi(mu'/(1 - n); y | mu')).

* Where Omega3 < 0 the y* of (19) is -cot(phi3/2) (`half_angle_left`): F3 and F4 become -F4 and F3.
  So phi3/2 is continuous but where Omega2 < 0 = Omega3: there (18) is taken with the other sign.
"""

from typing import Any

from sympy import Expr, Gt, Integer, Ne, Piecewise, S, asin, cos, elliptic_f, sin, sqrt

from rigidsym.language.functions import jacobi_am, jacobi_dn, jacobi_pi
from rigidsym.solution._polhode import check_sines, sine_axes, sine_sign
from rigidsym.solution._symbolic.calculation import Calculation, ExactMotion, conditions_of
from rigidsym.solution._symbolic.symbols import TIME, named
from rigidsym.solution._symbolic.value import Dynamics, Symbolic

_ABD = ("0", "a", "b", "d")
_SERVE = "pi and theta serve"
_CYCLIC = ((1, 2), (2, 0), (0, 1))
_CHOICES = {
    "half_1": "the sign of xi_1 with which Omega1 starts, C_1 being a principal value (Remark 1)",
    "half_2": "the same of Omega2",
    "half_3": "the same of Omega3",
    "side": "the sign of Omega3, which does not change: where it does, another interval begins",
}
# The inputs: moments, rates and the quaternion.
_INPUTS = [
    *(f"{letter}{k}" for letter in ("c", "Omega") for k in (1, 2, 3)),
    "q0",
    "q1",
    "q2",
    "q3",
]


def theorem1(work: Calculation) -> Symbolic:
    """Return the solution of the paper's Theorem 1.

    With free symbols it holds on one interval, with a motion's numbers at all times.
    """
    given = work.given
    if given:
        check_sines("form", "'theorem1'", given.polhode.regime, given.exact[1], _SERVE)
    work.begin(_INPUTS, given.numbers() if given else ())
    parts = [_sine(work, i) for i in range(3)]
    constant = [("sn",) if "sn" in part.known else () for part in parts]
    rates = [
        part.work_out("sine_state", {"t": TIME}, names)["Omega_i"]
        for part, names in zip(parts, constant, strict=True)
    ]
    first = parts[0].known
    work.known |= {name: first[name] for name in ("zeta", "xi", "mu")} | {"C_1": first["C_i"]}
    moving = {f"Omega{k}": rate for k, rate in enumerate(rates, 1)} | {"t": TIME}
    if "sn" in first:
        work.compute("theorem1", ("H", "K", "n", "kappa"))
        moving["Pi"] = _third_kind_across(work)
    else:
        work.compute("theorem1")
    side = work.known["side"] = S.One if given else named("side")
    holds = [*conditions_of("theorem1_motion", work.known, ("side",))]
    for part in parts:
        holds += conditions_of("one_rate", part.known, ("half",))
        work.facts |= part.facts
    if given:
        at = _turned(work, *_followed(work, given, moving, parts[2].known))
        holds.append(Ne(rates[2], 0))
    else:
        at = _turned(work, _by_angles(work, {"t": S.Zero}), _by_angles(work, moving))
        holds.append(Gt(side * rates[2], 0))
    return work.solution(
        [at[f"q_{x}"] for x in _ABD],
        rates,
        holds,
        {} if given else _CHOICES,
        {"energy": work.known["H"], "momentum": work.known["K"]},
        Dynamics(work.values(*_INPUTS[:3]), work.values(*_INPUTS[6:]), work.values(*_INPUTS[3:6])),
    )


def _sine(work: Calculation, i: int) -> Calculation:
    """Compute the constants in the sine function sn of one body rate in Theorem 1.

    Their names end with the number of the axis.
    """
    given = work.given
    j, k = sine_axes(given.polhode, i) if given else _CYCLIC[i]
    known: dict[str, Any] = {
        f"{letter}_{x}": work.known[f"{letter}{n + 1}"]
        for letter in ("c", "Omega")
        for x, n in zip("ijk", (i, j, k), strict=True)
    }
    known["half"] = Integer(sine_sign(*given.exact, i)) if given else named(f"half_{i + 1}")
    part = Calculation(work.form, given, known)
    inner = ("alpha", "root_j", "root_k", "zeta", "xi", "mu", "H", "K_squared")
    names = {n: f"{n}_{i + 1}" for n in inner} | {"C_i": f"C_{i + 1}"}
    if given and given.polhode.axes[0] == i:
        part.compute("sine", ("zeta", "mu", "alpha", "root_k"), names)
        _across_the_line(part, i)
    else:
        part.compute("sine", rename=names)
    work.constants |= part.constants
    return part


def _across_the_line(part: Calculation, i: int) -> None:
    """Replace an imaginary frequency xi of sn by real constants, and compute sn from them."""
    known = part.known
    sign, mc = 1 if known["Omega_i"] > 0 else -1, 1 - known["mu"]
    part.name("xi", sqrt(-known["alpha"] * known["root_k"]), f"nu_{i + 1}")
    sine = sqrt((1 - (known["zeta"] / known["Omega_i"]) ** 2) / mc)
    part.name("C_i", sign * known["half"] * elliptic_f(asin(sine), mc), f"y_{i + 1}")
    known["sn"] = sign / jacobi_dn(known["xi"] * TIME + known["C_i"], mc)


def _third_kind_across(work: Calculation) -> Expr:
    """Return the change of the integral Pi since t = 0 in real form, for imaginary xi."""
    n, mu, xi, begin = (work.known[name] for name in ("n", "mu", "xi", "C_1"))
    nu = (1 - mu) / (1 - n)
    work.name("Pi_0", jacobi_pi(nu, begin, 1 - mu))
    along = jacobi_pi(nu, xi * TIME + begin, 1 - mu) - work.known["Pi_0"]
    return xi * TIME + n / (1 - n) * along


def _followed(
    work: Calculation, given: ExactMotion, moving: dict[str, Any], third: dict[str, Any]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the quaternion of equation (18) at all times, continuous at zeros of Omega3.

    The quaternion at t = 0 is returned first.
    """
    right = _by_angles(work, moving)
    start = _by_angles(work, {"t": S.Zero, "Pi": S.Zero})
    (a, *_), c, w = given.polhode.axes, given.inertia, given.omega0
    begins_left = w[2] < 0
    if begins_left:
        start = _left(start)
    work.facts |= dict.fromkeys(("half_angle_left.cotangent", "half_angle_left.squares"))
    if a == 2:
        return start, _left(right) if begins_left else right
    turned, left_sign, start_sign = S.One, 1, 1
    if a == 1 and w[1] < 0:
        left_sign, start_sign = -1, -1 if begins_left else 1
    if a == 0:
        # phi3 goes round: Omega2 < 0 = Omega3 wherever am is a multiple of 2 pi, or where it is an
        # odd multiple of pi.  Omega3' = (c1 - c2)/c3 Omega1 Omega2.
        half_am = jacobi_am(third["xi"] * TIME + third["C_i"], third["mu"]) / 2
        at_zero = third["half"] * (c[0] - c[1]) * w[0] < 0
        changing = sin(half_am) if at_zero else cos(half_am)
        turned = Piecewise((1, changing > 0), (-1, True))
        start_sign = -1 if at_zero and begins_left else 1
    left, ahead = _left(right), moving["Omega3"] > 0
    followed = {
        x: turned * Piecewise((right[x], ahead), (left_sign * left[x], True)) for x in right
    }
    return {x: start_sign * value for x, value in start.items()}, followed


def _left(right: dict[str, Any]) -> dict[str, Any]:
    """Return the quaternion of the paper's (18) for an angle phi3 that is larger by pi.

    -F4 takes the place of F3, and F3 that of F4.
    """
    zero, a, b, d = right.values()
    return dict(zip(right, (-a, zero, d, -b), strict=True))


def _by_angles(work: Calculation, known: dict[str, Any]) -> dict[str, Any]:
    """Evaluate the quaternion of the paper's (18), with axes 1, 2, 3 named a, b, d."""
    found = work.work_out("theorem1_state", known, ("Pi",) if "Pi" in known else ())
    return {f"qbar_{x}": found[f"qbar_{k}"] for k, x in enumerate(_ABD)}


def _turned(work: Calculation, start: dict[str, Any], moving: dict[str, Any]) -> dict[str, Any]:
    """Multiply the quaternion of equation (18) by a constant to match the initial attitude.

    The constant is the quaternion of equation (37).
    """
    given = {f"q_{x}": work.known[f"q{k}"] for k, x in enumerate(_ABD)}
    front = work.work_out("pull_back", {**start, **given, "epsilon": S.One})
    for x in _ABD:
        work.name(f"p_{x}", front[f"p_{x}"])
    return work.work_out("turned", {**moving, "epsilon": S.One})
