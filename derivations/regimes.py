"""The regimes partition the parameter space: every body and every motion is in exactly one.

The axes are sorted, c_1 >= c_2 >= c_3 > 0; beyond that, the rates and moments are any numbers.
Signs are decided one after the other (is it turning? are moments equal? the three differences
2 H c_1 - K^2, K^2 - 2 H c_3 and K^2 - 2 H c_2; on K^2 = 2 H c_2, does it spin about the middle
axis?), and a sign is +, 0 or -: that is exhaustive, and the leaves of the tree exclude each other.

In a steady leaf M = c Omega for one of the moments c: what that takes to vanish is shown to be
both >= 0 and <= 0.  In a moving one the squares of the regular form's amplitudes and of lambda,
with a the axis of largest or smallest inertia, are nonnegative, and so are m and 1 - m; on the
separatrix 1 - m = 0, for symmetric bodies m = 0.
"""

from sympy import Expr, S, Symbol, UnevaluatedExpr

from derivations.regular_form import FORMULAS, PARAMETERS
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, extend, named, part_of
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps._names import symbol, symbols

MOMENTS = c_1, c_2, c_3 = symbols("c_1 c_2 c_3")
OMEGA = Omega_1, Omega_2, Omega_3 = symbols("Omega_1 Omega_2 Omega_3")
c_12, c_13, c_23, H, K_squared = symbols("c_12 c_13 c_23 H K_squared")
E_1, E_2, E_3, turning, off_middle = symbols("E_1 E_2 E_3 turning off_middle")
GAPS = {c_1 - c_2: c_12, c_1 - c_3: c_13, c_2 - c_3: c_23}
EXCESSES = {
    E_1: 2 * H * c_1 - K_squared,
    E_2: K_squared - 2 * H * c_2,
    E_3: K_squared - 2 * H * c_3,
}
INVARIANTS = {
    H: sum(c * w**2 for c, w in zip(MOMENTS, OMEGA, strict=True)) / 2,
    K_squared: sum((c * w) ** 2 for c, w in zip(MOMENTS, OMEGA, strict=True)),
}


def excess(form: Expr) -> Computation:
    """Return a multiple of the energy less K^2, by the rates and the differences of moments."""
    whole = compute(form).subs(INVARIANTS).expand()
    names = {**GAPS, **{-gap: -name for gap, name in GAPS.items()}}
    parts = (whole.coeff(w**2).factor().xreplace(names) * w**2 for w in OMEGA)
    return sum(parts, compute(S.Zero))


BY_RATES = {name: excess(form) for name, form in EXCESSES.items()}
SQUARES_SUM = Omega_1**2 + Omega_2**2 + Omega_3**2
BODY = Part(
    (c_3, c_13, c_23, *OMEGA),
    units=(c_3, c_2, c_1),
    definitions={
        c_12: c_13 - c_23,
        c_1: c_3 + c_13,
        c_2: c_3 + c_23,
        **INVARIANTS,
        **BY_RATES,
        turning: SQUARES_SUM,
        off_middle: Omega_1**2 + Omega_3**2,
    },
    nonnegative=(c_3, c_13, c_23, c_12),
    reading={
        "c_3": "smallest moment of inertia, kg m^2",
        "c_13": "largest less smallest moment",
        "c_23": "middle less smallest moment",
        **{f"Omega_{k}": f"body rate about axis {k}, rad/s" for k in (1, 2, 3)},
    },
)
# Context, the quantity whose sign is decided, and the cases 0, > 0, < 0.
TREE = (
    ("sorted_body", "turning", "rest", "motion"),
    ("motion", "c_13", "spherical", "nonspherical"),
    ("nonspherical", "c_12", "prolate", "unequal_large"),
    ("unequal_large", "c_23", "oblate", "asymmetric"),
    ("prolate", "E_1", "prolate_equatorial", "prolate_off_1"),
    ("prolate_off_1", "E_3", "prolate_polar", "prolate_motion"),
    ("oblate", "E_1", "oblate_polar", "oblate_off_1"),
    ("oblate_off_1", "E_3", "oblate_equatorial", "oblate_motion"),
    ("asymmetric", "E_1", "spin_1", "off_1"),
    ("off_1", "E_3", "spin_3", "off_1_and_3"),
    ("off_1_and_3", "E_2", "on_separatrix", "largest", "smallest"),
    ("on_separatrix", "off_middle", "spin_2", "separatrix_motion"),
)
# The regular form's axes, its differences of moments and its E's in terms of those above, of which
# all but E_2 are nonnegative.  Here it is -E_2 that is, if a is the axis of the smallest moment.
NAMES = symbols("c_a c_b c_d c_ab c_ad c_bd E_a E_b E_d")
NOT_E_2 = -UnevaluatedExpr(-E_2)
VISIBLY = {
    1: named(NAMES, (c_1, c_2, c_3, c_12, c_13, c_23, E_1, E_2, E_3)),
    3: named(NAMES, (c_3, c_2, c_1, -c_23, -c_13, -c_12, -E_3, NOT_E_2, -E_1)),
}
PLAINLY = {c_12: c_1 - c_2, c_13: c_1 - c_3, c_23: c_2 - c_3, NOT_E_2: E_2}
# What is 0 at an edge, and makes m or 1 - m zero.
EDGES: dict[str, Symbol] = {
    "separatrix_motion": E_2,
    "oblate_motion": c_23,
    "prolate_motion": c_12,
}
SOURCE = ("10", "13", "14")


def derive(builder: LedgerBuilder) -> None:
    """Split all motions into leaves, and state what holds in each leaf."""
    here = Proofs.open(builder, "sorted_body", BODY, static=True)
    differences = [(BY_RATES[name], form) for name, form in EXCESSES.items()]
    here.claim("differences", differences, 6, 15)
    for context, name, *cases in TREE:
        builder.split(context, name, *cases)
    _steady(builder)
    for leaf in ("largest", "oblate_motion", "separatrix_motion"):
        _moving(builder, leaf, 1)
    for leaf in ("smallest", "prolate_motion"):
        _moving(builder, leaf, 3)
    for context, name, *cases in reversed(TREE):
        builder.partition(context, name, *cases)


def _steady(builder: LedgerBuilder) -> None:
    """Prove (c_i - c) Omega_i = 0, by a quantity that is both >= 0 and <= 0."""
    squares = {w: compute(SQUARES_SUM).solve_for(w**2) for w in OMEGA}
    Proofs(builder, "rest").sign("rates", {-(w**2): -form for w, form in squares.items()})
    gap = compute(c_13 - c_23).subs(c_13, 0)  # it is c_12
    other = compute(c_13 - c_12).subs(c_13, 0)
    Proofs(builder, "spherical").sign("moments", {-c_12: -gap, -c_23: -other})
    for E, pairs, leaves in (
        (E_1, ((c_12, Omega_2), (c_13, Omega_3)), ("spin_1", "oblate_polar", "prolate_equatorial")),
        (E_3, ((c_13, Omega_1), (c_23, Omega_2)), ("spin_3", "prolate_polar", "oblate_equatorial")),
    ):
        forms = {-gap * w**2: -gap * BY_RATES[E].solve_for(w**2) for gap, w in pairs}
        for leaf in leaves:
            Proofs(builder, leaf).sign("parallel", forms)
    across = compute(Omega_1**2 + Omega_3**2)
    forms = {-(w**2): -across.solve_for(w**2) for w in (Omega_1, Omega_3)}
    Proofs(builder, "spin_2").sign("parallel", forms)


def _moving(builder: LedgerBuilder, leaf: str, axis: int) -> None:
    """Prove that squares, m and 1 - m of the regular form are nonnegative."""
    forms = {
        name: form.xreplace(VISIBLY[axis]) for name, form in {**FORMULAS, **PARAMETERS}.items()
    }
    plain = {name: form.xreplace(PLAINLY) for name, form in forms.items()}
    for name in PARAMETERS:
        # An excess and a difference of moments are divided by one after the other.
        gaps = forms[name].subs(dict.fromkeys((E_1, E_3, NOT_E_2), 1)).xreplace(PLAINLY)
        plain[name] = (plain[name] / gaps) * gaps.held()
    edge = _edge(leaf, forms)
    signs = {plain[name]: form for name, form in forms.items() if name not in edge}
    Proofs(builder, leaf).sign("squares", signs, *SOURCE)
    if edge:
        values = [(plain[name], value) for name, value in edge.items()]
        Proofs(builder, leaf).claim("edge", values, *SOURCE)
    _constants(builder, leaf, axis, forms | edge)


def _edge(leaf: str, forms: dict[str, Computation]) -> dict[str, Computation]:
    """Return the values of m and 1 - m at an edge."""
    if leaf not in EDGES:
        return {}
    values = {name: forms[name].subs(EDGES[leaf], 0) for name in PARAMETERS}
    (zero,) = (name for name, value in values.items() if value.value == 0)
    (one,) = PARAMETERS.keys() - {zero}
    return {zero: values[zero], one: 1 - values[zero]}


def _constants(builder: LedgerBuilder, leaf: str, axis: int, forms: dict[str, Computation]) -> None:
    """Prove that the regular form has its constants here: squares of real numbers, 0 <= m <= 1."""
    whole, context = builder.ledger.contexts[leaf], f"{leaf}_constants"
    squares = part_of(builder.ledger.contexts["any_motion"]).definitions
    named = {
        symbol(f"{x}_{name}"): symbol(f"{x}_{k}")
        for x in ("c", "Omega")
        for name, k in zip("abd", (axis, 2, 4 - axis), strict=True)
    }
    differ = (c_23,) if leaf == "prolate_motion" else ()
    definitions = {**squares, **whole.definitions, **named}
    builder.open(extend(context, whole, Part(units=differ, definitions=definitions)))
    Proofs(builder, context).model("any_motion")
    m = symbol("m")
    names = {"m": m, "m_1": 1 - m}
    signs = {names.get(name, symbol(f"{name}_squared")): form for name, form in forms.items()}
    Proofs(builder, context).sign("squares", signs, *SOURCE)
    if leaf in EDGES:
        Proofs(builder, context).claim("edge", {m: forms["m"]}, *SOURCE)
