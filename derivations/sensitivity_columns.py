"""Sensitivities column by column: formulas for numbers, without cancellation.

A column is the change of the rates by one rate at t = 0 or by one moment of inertia.  Each is what
it is where S_t, C_t and D_t stay, and what they change it by, along two directions alone: `_k`,
where p, r and k = alpha_a alpha_d Omega_b0^2 grow alike, and `_r`, where r does.  With

    F_t = the integral of S_t^2/D_t^2

these divide by D_t and `below` alone, in every regime: no case is told apart.  b being the middle
axis, kappa_a = p - k, kappa_d = r - k and p - r are single products, `below` is a sum of squares,
and what is left of Omega_b_k is small where the spin is about b.  Omega_a_k and Omega_a_r leave out
Omega_a S_t^2/2, taken off and put on: what is left is small where the spin is about a, and S_t
grows like t if the body is symmetric.  E_t and F_t follow from each other: the one where p - r is
not small, the other where p is not.
"""

from collections.abc import Mapping
from typing import Any

import sympy
from sympy import Expr, Symbol, UnevaluatedExpr, factor

from derivations.addition_form import (
    BODY,
    COEFFICIENTS,
    EULER,
    FUNCTIONS,
    INTEGRALS,
    INTEGRANDS,
    NODE,
    OTHERS,
    OVER_SQUARE,
    SQUARED,
    START,
    TIME,
)
from derivations.addition_form import GIVEN as INVARIANTS
from derivations.addition_form import MODULI as NODE_MODULI
from derivations.addition_form import RATES as RATES_AT_TIME
from derivations.attitude import HANDEDNESS, INERTIA
from derivations.rate_sensitivities import (
    ALONG_K,
    ALONG_R,
    FUNCTION_PARTS,
    MODULI,
    MOVING,
    C,
    D,
    E,
    F,
    S,
    at_start,
    change,
    change_of,
    defined,
    integral,
    p,
    r,
    still,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._computation import Computation, compute, guess
from rigidsym.proof.steps._names import collected, symbol, symbols

AXES = ("a", "b", "d")
t, epsilon, tilt, k, below, over, leant, turning, f = symbols(
    "t epsilon tilt k below over leant turning f"
)
c, alpha, OMEGA_0, OMEGA = (
    {x: symbol(form.format(x)) for x in AXES}
    for form in ("c_{}", "alpha_{}", "Omega_{}0", "Omega_{}")
)
CHANGES = (*(f"Omega_{x}" for x in AXES), *(f"c_{x}" for x in AXES))


def by(name: Any, y: str) -> Symbol:
    """Return the name of what a quantity changes by with a rate at t = 0 or a moment."""
    return symbol(f"{name}_by_{y}")


def named(found: Mapping[str, Computation]) -> dict[Any, Symbol]:
    """Return the names of values, to put them in the place of these."""
    return {value.value: symbol(name) for name, value in found.items()}


RATES_AT_START = Part(
    (*OMEGA_0.values(),),
    reading={OMEGA_0[x]: f"body rate about axis {x} at t = 0, rad/s" for x in AXES},
)
# Numbers have the differences of moments from before rounding.
DIFFERENCES = {symbol(f"c_{x}{y}"): c[x] - c[y] for x, y in (("a", "b"), ("a", "d"), ("b", "d"))}
TILT = alpha["d"] * OMEGA_0["a"] ** 2 - alpha["a"] * OMEGA_0["d"] ** 2


def _moment_definitions() -> dict[Any, Any]:
    """Return the coefficients of Euler's equations and `tilt`, with their changes.

    `tilt` is E_b in these units.  Differences are those of moments alone.
    """
    names = {difference: name for name, difference in DIFFERENCES.items()}
    forces = {
        x: compute(value).subs(names)
        for x, value in defined(HANDEDNESS, INERTIA, BODY).items()
        if x in alpha.values()
    }
    whole = compute(TILT).subs(forces).factor()
    numerator = whole.apply(sympy.fraction)[0] / epsilon
    found = {**DIFFERENCES, **forces, symbol("E_b"): numerator}
    found[tilt] = whole / numerator * symbol("E_b")
    for x, others in OTHERS.items():
        for y in (x, *others):
            found[by(alpha[x], f"c_{y}")] = change_of(alpha[x], forces[alpha[x]], _moved(y))
    for y in AXES:
        moved = {symbol("E_b"): change(numerator, _moved(y)).factor(), **_moved(y)}
        found[by(tilt, f"c_{y}")] = change_of(tilt, found[tilt], moved)
    return found


def _moved(y: str) -> dict[Any, Any]:
    """Return the change of one moment, and those of differences by it."""
    return {c[y]: 1, **{name: change(x, {c[y]: 1}) for name, x in DIFFERENCES.items()}}


MOMENTS = _moment_definitions()
TILT_BY = {
    by(tilt, f"c_{y}"): change(TILT, {alpha[x]: by(alpha[x], f"c_{y}") for x in AXES}) for y in AXES
}


def _constants() -> dict[Any, Any]:
    """Return p, r and what they are made of, with their changes by all inputs.

    p = k + kappa_a and r = k + kappa_d, where kappa is what is left without a rate about b.
    """
    of_motion = defined(COEFFICIENTS, INVARIANTS)
    named_by = join("invariants", COEFFICIENTS, INVARIANTS, static=True).definitions
    whole = {x: compute(of_motion[x]).subs(of_motion).expand() for x in (p, r)}
    found: dict[Any, Any] = {symbol(x): named_by[x] for x in ("g_a", "g_d")}
    kappa = {x: whole[y].subs(OMEGA_0["b"], 0) for x, y in (("a", p), ("d", r))}
    found[k] = whole[p] - kappa["a"]
    found |= {symbol(f"kappa_{x}"): value for x, value in kappa.items()}
    parts = {found[x].value: x for x in symbols("k kappa_a kappa_d")}
    found |= {x: value.subs(parts) for x, value in whole.items()}
    apart = (whole[p] - whole[r]).factor().subs(TILT, tilt)
    found[symbol("apart")] = apart
    for y, moduli in {"a": (p,), "b": (p,), "d": (r,)}.items():
        found |= {by(x, f"Omega_{y}"): whole[x].diff(OMEGA_0[y]) for x in moduli}
    for y in (f"c_{x}" for x in AXES):
        moved = {x: by(x, y) for x in (tilt, *alpha.values())}
        of_k, of_a, of_d = (change(found[x], moved).factor() for x in symbols("k kappa_a kappa_d"))
        found[by("kappa", y)] = of_a
        found[by(p, y)] = of_k + by("kappa", y)
        found[by("apart", y)] = change(apart, moved)
        # Of k - kappa_d: p and p - r together are twice kappa_a, and this.
        found[by("leant", y)] = of_k - of_d
        for x, (v, w) in OTHERS.items():
            found[by(x, y)] = change(alpha[x] * OMEGA_0[v] * OMEGA_0[w], moved)
    return found


CONSTANTS = _constants()


DEFINED_RATES = defined(HANDEDNESS, INERTIA, BODY, INVARIANTS, FUNCTIONS, RATES_AT_TIME)
ABOVE = {x: compute(DEFINED_RATES[OMEGA[x]]).apply(sympy.fraction)[0] for x in AXES}


def _at_time() -> dict[Any, Any]:
    """Return the rates and what they change by in both directions.

    E_t in S_k, C_k and D_k is half of the functions' rates times E_t, and so for -F_t in S_r, C_r
    and D_r.  So that much of Omega_a_k and Omega_a_r is half of Omega_a' times E_t and -F_t.
    """
    product = {CONSTANTS[k].value: k}
    space = compute(DEFINED_RATES[below]).subs(product)
    found: dict[Any, Any] = {
        below: space.subs(k, r - symbol("kappa_d")).expand().subs(1 - r * S**2, D**2),
        over: 1 / below,
    }
    found |= {OMEGA[x]: compute(DEFINED_RATES[OMEGA[x]]).subs(below, 1 / over) for x in AXES}
    lean = {leant: alpha["a"] * OMEGA_0["b"] * OMEGA_0["d"]}
    leaning = ABOVE["a"].subs(lean[leant], leant)
    quick = change_of(OMEGA["a"], leaning / space, MOVING).subs(space, 1 / over) / 2
    found |= lean
    found[turning] = (quick / over).expand().collect(leant, collected) * over
    for way, functions, part, sign, grow in (
        ("k", ALONG_K, E, 1, {k: 1}),
        ("r", ALONG_R, F, -1, {}),
    ):
        names = symbols(f"S_{way} C_{way} D_{way}")
        values = dict(zip((S, C, D), functions, strict=True))
        if way == "r":
            found[f] = D * F
        found |= {x: value.subs(F, f / D) for x, value in zip(names, functions, strict=True)}
        of_below = change(space, {**grow, **values}).expand().subs(k * S**4, S**2 * (1 - below))
        found[symbol(f"below_{way}")] = of_below.subs(F, f / D).factor()
        begun = {x: value.subs(part, 0) for x, value in values.items()}
        left = over * change(leaning, begun) - over * OMEGA["a"] * of_below.subs(part, 0)
        left = (left - sign * HALF).subs({below: 1 / over, OMEGA["a"]: over * leaning}).expand()
        left = left.subs(OMEGA_0["a"] * D, OMEGA_0["a"] * (1 - r * S**2) / D)
        rest = (2 * left / (over * S**3)).expand() * over * S**3 / 2
        slow = turning * E if way == "k" else -f * UnevaluatedExpr(turning / D)
        found[along("a", way)] = rest + slow
        steps = {**grow, **dict(zip((S, C, D), names, strict=True))}
        for x in ("b", "d"):
            moved = change(ABOVE[x], steps).collect([alpha["b"], alpha["d"]], factor)
            falls = OMEGA[x] * symbol(f"below_{way}")
            found[along(x, way)] = over * (moved.held() - falls)
    # Each small square is multiplied by 1/below: two of them may be below the least double.
    why = "small where the spin is about b, and without underflow: found by hand"
    found[along("b", "k")] = guess(MIDDLE_ALONG_K, why)
    for y in CHANGES:
        found |= {by(OMEGA[x], y): _column(x, y) for x in AXES}
    return found


def along(x: str, way: str) -> Symbol:
    """Return the name of what a rate changes by in a direction, for Omega_a less HALF."""
    return symbol(f"Omega_{x}_{way}")


def _column(x: str, y: str) -> Computation:
    """Return the change of a rate by an input, by the chain rule in p, p - r and kappa_a.

    Along the first p, r and k grow alike, along the second r falls, and along the third k falls,
    and with it over, while the functions stay.
    """
    grows, apart_grows, *_ = _coordinates(y)
    by_p, by_apart = (value * along(x, way) for value, way in ((grows, "k"), (apart_grows, "r")))
    return (_stays(x, y) + by_p - by_apart).collect(by(p, y)).collect(by(r, y))


def _stays(x: str, y: str) -> Computation:
    """Return the change of a rate by an input where S_t, C_t and D_t stay."""
    *_, kappa_grows, leans = _coordinates(y)
    if y.startswith("c"):
        explicit = {alpha[x]: by(alpha[x], y)}
        whole = {CONSTANTS[by(x, y)].value: by(x, y)}
    else:
        explicit, whole = {OMEGA_0[y[-1]]: 1}, {}
    stays = change(ABOVE[x], explicit).subs(whole)
    if x != "a":
        return over * (stays - OMEGA[x] * kappa_grows * S**2)
    if kappa_grows == 0:
        return over * stays + HALF * leans
    lost = 2 * (LOSS / over) * UnevaluatedExpr(over * kappa_grows)
    return (over * stays + HALF * (leans + lost)).held()


def _coordinates(y: str) -> list[Any]:
    """Return the changes of p, p - r, kappa_a and k - kappa_d by an input."""
    if y.startswith("c"):
        return [by(x, y) for x in ("p", "apart", "kappa", "leant")]
    kappa_a, kappa_d = symbols("kappa_a kappa_d")
    moved = {"a": {kappa_a: by(p, y)}, "b": {k: by(p, y)}, "d": {kappa_d: by(r, y)}}[y[-1]]
    every = (k + kappa_a, kappa_a - kappa_d, kappa_a, k - kappa_d)
    return [change(value, moved).value for value in every]


# What Omega_a_k and Omega_a_r leave out, taken off and put on.
HALF = OMEGA["a"] * S**2 / 2
# 1 - 1/below.
LOSS = compute(1 - over).subs(over, 1 / (1 - k * S**2)).factor().subs(1 - k * S**2, 1 / over)
MIDDLE_ALONG_K = (
    "over*(alpha_b*Omega_d0*Omega_a0)*(S_k - S_t*(over*below_k))"
    " - Omega_b0*S_t*E_t*((over*kappa_a + over*kappa_d)*(over*C_t**2)*D_t**2"
    " + S_t**2*(p*(over*kappa_a)*(over*D_t**2) + r*(over*kappa_d)*(over*C_t**2)))/2"
)
AT_TIME = _at_time()


def _excesses() -> dict[Any, Any]:
    """Return the integrals of squared rates beyond those of the rates at t = 0."""
    integrals = defined(
        HANDEDNESS, INERTIA, BODY, INVARIANTS, *FUNCTION_PARTS, RATES_AT_TIME, INTEGRALS
    )
    late = sympy.Dummy()
    whole = compute(integrals[symbol("I_b")]) - OMEGA_0["b"] ** 2 * t
    growing = whole.coeff(E) * E
    left = ((whole - growing) / OMEGA_0["b"]).expand().subs(S, late + t).expand()
    excess_b = symbol("excess_b")
    found = {excess_b: growing + OMEGA_0["b"] * left.collect(t).subs(late, S - t)}
    for x in "ad":
        by_b = compute(integrals[symbol(f"I_{x}")]) - OMEGA_0[x] ** 2 * t
        found[symbol(f"excess_{x}")] = by_b.subs(symbol("I_b"), excess_b + OMEGA_0["b"] ** 2 * t)
    return found


EXCESS_B, *EXCESSES = _excesses().items()
AT_TIME[EXCESS_B[0]] = EXCESS_B[1]


def _middle(x: str, y: str) -> Computation:
    """Return the middle rate's column by a rate, as alpha_x Omega_b^2 - alpha_b Omega_x^2 stays."""
    kept = alpha[x] * OMEGA["b"] ** 2 - alpha["b"] * OMEGA[x] ** 2
    unknown, ratio = sympy.Dummy(), sympy.Dummy()
    stays = change(kept, {OMEGA["b"]: unknown, OMEGA[x]: by(OMEGA[x], f"Omega_{y}")})
    (found,) = stays.apply(sympy.solve, unknown)
    quotient = UnevaluatedExpr(OMEGA[x] / OMEGA["b"])
    return found.subs(OMEGA[x], ratio * OMEGA["b"]).subs(ratio, quotient)


# The middle rate's columns where the spin is about it: with no difference.
MIDDLE = {by("middle", f"Omega_{y}"): _middle(x, y) for x, y in (("d", "a"), ("a", "d"))}
# By what each integral follows from the other.
ELAPSED = {
    F: (E, integral(MOVING[F], t, E, S * C / D), p - r),
    E: (F, integral(MOVING[E], t, F, S * C / D), p),
}


def _spun() -> dict[Any, Any]:
    """Return the middle rate and its integral near a spin about b, where E_t and t are large.

    kappa_a, kappa_d, p - r and the product of the other two rates are small there, and each term
    has one of them: below is C_t^2 + kappa_a S_t^2 and D_t^2 + kappa_d S_t^2, and k E_t + S_t - t
    is small with E_t by F_t.
    """
    kappa_a, kappa_d, apart, swung, lag, late = symbols("kappa_a kappa_d apart swung lag late")
    leaning = UnevaluatedExpr(alpha["b"] * OMEGA_0["d"] * OMEGA_0["a"])
    squares = {C**2: below - kappa_a * S**2, D**2: below - kappa_d * S**2}
    lost = compute((below - C * D) * (C + D)).expand().subs(squares).factor() / S**2
    found: dict[Any, Any] = {swung: over * S * (leaning - OMEGA_0["b"] * S * lost / (C + D))}

    behind = k * E + S - t
    by_F = compute(behind).subs(E, ELAPSED[E][1]).subs(t, S * C / D - late).expand()
    by_late = by_F.coeff(late).together().subs(p - k, kappa_a).held()
    rest = (by_F.subs(late, 0).subs(F, f / D) * D).expand()
    by_f = (-rest.coeff(f) / (p - r)).cancel().held()
    chord = (rest.subs(f, 0) * (C + D)).expand().subs({C**2: 1 - p * S**2, D**2: 1 - r * S**2})
    chord = (chord.expand().factor() / (p - r)).cancel() / (C + D)
    found[lag] = by_late * (S * C / D - t) + apart * (chord - by_f * f) / D

    product = {alpha["b"] * OMEGA_0["a"] * OMEGA_0["d"]: leaning}
    names = {CONSTANTS[x].value: x for x in (k, kappa_a, kappa_d)}
    whole = (
        EXCESS_B[1].subs(defined(COEFFICIENTS, INVARIANTS)).subs(OMEGA["b"], OMEGA_0["b"] + swung)
    )
    powers = whole.expand().subs(names).collect(OMEGA_0["b"], evaluate=False)
    fast = lag + (powers[OMEGA_0["b"] ** 2] - behind).factor()
    slow = OMEGA_0["b"] * powers[OMEGA_0["b"]] + powers[sympy.S.One].subs(product)
    found[symbol("excess_spun")] = OMEGA_0["b"] ** 2 * fast + slow
    return found


def _passing() -> dict[Any, Any]:
    """Return what the rates change by where p grows alone: `_k` less `_r`.

    It is what they change by with Omega_a0, less what stays, by `share`.  As g_d stays, Omega_b and
    Omega_d go on along their rates, by `since`; g_a gives Omega_a.  The rate of `since` has
    Omega_b^2/Omega_a^2, which is a multiple of S_t^2/D_t^2 from where Omega_b is zero: `passed` is
    its integral over the phase, from where that was at t = 0.
    """
    passed, half_over_p, since, share, x = symbols("passed half_over_p since share x")
    grows = by(p, "Omega_a")
    rates = {OMEGA[y]: EULER[f"D(Omega_{y})"] for y in AXES}
    begun = {S: 0, C: 1, D: 1, **{OMEGA[y]: OMEGA_0[y] for y in AXES}}
    by_node = compute(TURNED_OVER).subs(NODE).subs(NODE_MODULI[r], r) * D**2 / S**2
    ratio = OMEGA["b"] / OMEGA["a"]
    slope = change(by_node * F + x * ratio * S / D, {**MOVING, **rates}) - TURNED_OVER
    by_ratio = (slope.subs(begun).solve_for(x) * OMEGA_0["a"] / OMEGA_0["b"]).held()
    held = UnevaluatedExpr(ratio * OMEGA_0["b"] / OMEGA_0["a"])
    found: dict[Any, Any] = {passed: by_node * F + by_ratio * held * S / D}

    along_b = rates[OMEGA["b"]] * since
    kept = {y: alpha[y] * OMEGA["b"] ** 2 - alpha["b"] * OMEGA[y] ** 2 for y in "ad"}
    start = change(kept["a"].subs(begun), {OMEGA_0["a"]: -share})
    along_a = (change(kept["a"], {OMEGA["b"]: along_b, OMEGA["a"]: x}) - start).solve_for(x)
    along_d = change(kept["d"], {OMEGA["b"]: along_b, OMEGA["d"]: x}).solve_for(x)
    moves = {"a": along_a.expand(), "b": compute(along_b), "d": along_d}
    growing = change(along_b, {**rates, since: x})
    varied = change(rates[OMEGA["b"]], {OMEGA[y]: move for y, move in moves.items()})
    per_turn = (varied - growing).expand().solve_for(x) / (1 + TURNED_OVER)
    per_turn = per_turn.cancel().subs(kept["a"], p / alpha["d"])
    found[share] = -1 / CONSTANTS[grows]
    found[half_over_p] = per_turn.subs(share, found[share])
    found[since] = (t + passed) * half_over_p
    for y, move in moves.items():
        stays = (share * _stays(y, "Omega_a")).subs(grows, -1 / share).doit()
        rest = stays.expand().factor() + move.subs(since, 0).expand()
        found[symbol(f"Omega_{y}_p")] = move.coeff(since) * since + rest.held()
    return found


# The integrand of `passed`.
TURNED_OVER = -alpha["a"] / alpha["b"] * (OMEGA["b"] / OMEGA["a"]) ** 2
SPUN, PASSING = _spun(), _passing()
GIVEN = Part(
    (*COEFFICIENTS.names, *(by(alpha[x], f"c_{y}") for x in AXES for y in AXES)),
    reading={
        **COEFFICIENTS.reading,
        **{
            by(alpha[x], f"c_{y}"): f"what alpha_{x} changes by with c_{y}"
            for x in AXES
            for y in AXES
        },
    },
)
ANOTHER = "two computed forms of one quantity"
DEFINED = Part(definitions={tilt: TILT, **TILT_BY, **CONSTANTS, **AT_TIME}, units=(below,))


def derive(builder: LedgerBuilder) -> None:
    """Prove the variation of Euler's equations, the start, and E_t by F_t."""
    _moments(builder)
    _columns_vary(builder)
    _elapsed(builder)


def _moments(builder: LedgerBuilder) -> None:
    """Prove the coefficients and their changes by the moments of inertia."""
    h = dict(zip(AXES, symbols("h1 h2 h3"), strict=True))
    changes = {
        symbol(f"dalpha_{x}"): sum(by(alpha[x], f"c_{y}") * h[y] for y in AXES) for x in AXES
    }
    moved = Part(
        (*h.values(),),
        definitions={**MOMENTS, **changes},
        reading={h[y]: f"a change of c_{y}" for y in AXES},
    )
    builder.open(join("coefficients", HANDEDNESS, INERTIA, RATES_AT_START, moved, static=True))
    forces = defined(HANDEDNESS, INERTIA, BODY)
    euler = {x: compute(forces[alpha[x]] * c[x]) for x in AXES}
    law = "Euler's equations, times the moments"
    builder.claim("coefficients.euler", {c[x] * alpha[x]: euler[x] for x in AXES}, ["5"], law=law)
    by_moments = {c[x]: h[x] for x in AXES}
    small = {**by_moments, **{alpha[x]: symbol(f"dalpha_{x}") for x in AXES}}
    varied = {change(c[x] * alpha[x], small): change(euler[x], by_moments) for x in AXES}
    builder.claim("coefficients.variation", varied, ["5"])
    why = "what tilt was computed from"
    builder.claim("coefficients.tilt", {tilt: TILT}, ["6", "15"], why=why)
    builder.claim("coefficients.tilt_by", TILT_BY, ["6", "15"])


def _columns_vary(builder: LedgerBuilder) -> None:
    """Prove the columns at all times and at the start."""
    given = (GIVEN, RATES_AT_START)
    parts = (*given, *FUNCTION_PARTS, DEFINED)
    builder.open(join("varied_rates", *parts))
    claims, why = {below: 1 - k * S**2, p - r: symbol("apart")}, "what they were computed from"
    builder.claim("varied_rates.below", claims, ["10"], why=why)
    builder.claim("varied_rates.euler", EULER, ["5"])
    for y in CHANGES:
        moved = {OMEGA[x]: by(OMEGA[x], y) for x in AXES}
        if y.startswith("c"):
            moved |= {alpha[x]: by(alpha[x], y) for x in AXES}
        varied = {f"D({by(OMEGA[x], y)})": change(EULER[f"D({OMEGA[x]})"], moved) for x in AXES}
        builder.claim(f"varied_rates.by_{y}", varied, ["5"])
    builder.claim("varied_rates.excess", {"D(excess_b)": _square("b")}, ["10"], law=INTEGRANDS)
    _other_forms(builder, *parts)
    start = Part(relations=(*START.relations, F))
    parts = (*given, *still(*FUNCTION_PARTS), DEFINED, start)
    builder.open(join("varied_rates_start", *parts, static=True))
    columns = (by(OMEGA[x], y) for y in CHANGES for x in AXES)
    begun = [*OMEGA.values(), *columns, EXCESS_B[0]]
    builder.evaluate("varied_rates_start.rates", begun, ["12"])


def _square(x: str) -> Expr:
    return OMEGA[x] ** 2 - OMEGA_0[x] ** 2


def _other_forms(builder: LedgerBuilder, *parts: Part) -> None:
    """Prove the forms for symmetric bodies, for spins about b, and for motions that turn over."""
    defined = Part(definitions=dict(EXCESSES), units=(alpha["b"],))
    builder.open(join("excesses", *parts, defined))
    squares = {f"D({name})": _square(str(name)[-1]) for name, _ in EXCESSES}
    builder.claim("excesses.squares", squares, ["10"], law=INTEGRANDS)
    units = (alpha["a"], alpha["d"], OMEGA["b"])
    builder.open(join("middle_columns", *parts, Part(definitions=MIDDLE, units=units)))
    same = {name: str(name).replace("middle", "Omega_b") for name in MIDDLE}
    builder.claim("middle_columns.products", same, ["10"], why=ANOTHER)
    by_F = Part(definitions={E: ELAPSED[E][1]})
    parts = tuple(x for x in parts if x is not SQUARED)
    # p is alpha_d g_a.
    units = (alpha["b"], alpha["d"], OMEGA["a"], OMEGA_0["a"], "g_a")
    builder.open(join("passing", *parts, by_F, Part(definitions=PASSING, units=units)))
    builder.claim("passing.integral", {"D(passed)": TURNED_OVER}, ["10"], law=INTEGRANDS)
    same = {f"Omega_{x}_p": along(x, "k") - along(x, "r") for x in AXES}
    builder.claim("passing.changes", same, ["10"], why=ANOTHER)
    builder.open(join("spun", *parts, by_F, Part(definitions=SPUN, units=(p, C + D))))
    same = {"swung": OMEGA["b"] - OMEGA_0["b"], "excess_spun": "excess_b"}
    builder.claim("spun.excess", same, ["10"], why=ANOTHER)


def _elapsed(builder: LedgerBuilder) -> None:
    """Prove E_t by F_t, and F_t by E_t."""
    for name, (other, value, divisor) in ELAPSED.items():
        known = {E: SQUARED, F: OVER_SQUARE}[other]
        defined = Part(definitions={name: value}, units=(D, divisor))
        context = f"elapsed_{str(name)[0]}"
        builder.open(join(context, MODULI, FUNCTIONS, TIME, known, defined))
        integrand = {f"D({name})": MOVING[name]}
        builder.claim(f"{context}.integral", integrand, ["DLMF 22.16"], law=INTEGRANDS)
        begun = Part(relations=(t, S, C - 1, D - 1, other))
        parts = (MODULI, *still(FUNCTIONS, TIME, known), begun, defined)
        builder.open(join(f"{context}_start", *parts, static=True))
        builder.claim(f"{context}_start.integral", at_start(defined), ["12"])
