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

import re

from derivations.regular_form import FORMULAS
from rigidsym.proof.algebra import LedgerBuilder, Part, extend, join, part_of

BODY = Part(
    witness={
        "c_3": "1",
        "c_13": "2",
        "c_23": "1",
        "Omega_1": "1",
        "Omega_2": "1",
        "Omega_3": "1/2",
    },
    units=("c_3", "c_2", "c_1"),
    definitions={
        "c_12": "c_13 - c_23",
        "c_1": "c_3 + c_13",
        "c_2": "c_3 + c_23",
        "H": "(c_1*Omega_1**2 + c_2*Omega_2**2 + c_3*Omega_3**2)/2",
        "K_squared": "(c_1*Omega_1)**2 + (c_2*Omega_2)**2 + (c_3*Omega_3)**2",
        "E_1": "c_2*c_12*Omega_2**2 + c_3*c_13*Omega_3**2",
        "E_2": "c_1*c_12*Omega_1**2 - c_3*c_23*Omega_3**2",
        "E_3": "c_1*c_13*Omega_1**2 + c_2*c_23*Omega_2**2",
        "turning": "Omega_1**2 + Omega_2**2 + Omega_3**2",
        "off_middle": "Omega_1**2 + Omega_3**2",
    },
    nonnegative=("c_3", "c_13", "c_23", "c_12"),
    reading={
        "c_3": "smallest moment of inertia, kg m^2",
        "c_13": "largest less smallest moment",
        "c_23": "middle less smallest moment",
        **{f"Omega_{k}": f"body rate about axis {k}, rad/s" for k in (1, 2, 3)},
    },
)
CYCLES = ((1, 2, 3), (2, 3, 1), (3, 1, 2))
SPIN = {"Omega_1": "0", "Omega_2": "0", "Omega_3": "0"}
PROLATE, OBLATE = {"c_23": "2"}, {"c_23": "0"}
SEPARATRIX = {"c_13": "5/4", "Omega_1": "1", "Omega_3": "3/4"}
# Context, the quantity whose sign is decided, and the cases 0, > 0, < 0 with their witnesses.
TREE = (
    ("sorted_body", "turning", ("rest", SPIN), ("motion", {})),
    ("motion", "c_13", ("spherical", {"c_13": "0", "c_23": "0"}), ("nonspherical", {})),
    ("nonspherical", "c_12", ("prolate", PROLATE), ("unequal_large", {})),
    ("unequal_large", "c_23", ("oblate", OBLATE), ("asymmetric", {})),
    ("prolate", "E_1", ("prolate_equatorial", {"Omega_3": "0"}), ("prolate_off_1", {})),
    ("prolate_off_1", "E_3", ("prolate_polar", SPIN | {"Omega_3": "1"}), ("prolate_motion", {})),
    ("oblate", "E_1", ("oblate_polar", SPIN | {"Omega_1": "1"}), ("oblate_off_1", {})),
    ("oblate_off_1", "E_3", ("oblate_equatorial", {"Omega_1": "0"}), ("oblate_motion", {})),
    ("asymmetric", "E_1", ("spin_1", SPIN | {"Omega_1": "1"}), ("off_1", {})),
    ("off_1", "E_3", ("spin_3", SPIN | {"Omega_3": "1"}), ("off_1_and_3", {})),
    (
        "off_1_and_3",
        "E_2",
        ("on_separatrix", SEPARATRIX),
        ("largest", {}),
        ("smallest", {"Omega_3": "4"}),
    ),
    ("on_separatrix", "off_middle", ("spin_2", SPIN | {"Omega_2": "1"}), ("separatrix_motion", {})),
)
# The regular form's axes, and its E's in terms of those above; c_a - c_d > 0 or < 0.
LARGEST = {"a": "1", "b": "2", "d": "3", "E_a": "E_1", "E_b": "E_2", "E_d": "E_3"}
SMALLEST = {"a": "3", "b": "2", "d": "1", "E_a": "(-E_3)", "E_b": "E_2", "E_d": "(-E_1)"}
SQUARES = FORMULAS | {"m": "E_a/E_d*c_bd/c_ab", "m_1": "E_b/E_d*c_ad/c_ab"}
VISIBLY = {
    "1": {
        "A_a": "E_3/(c_1*c_13)",
        "A_b": "E_1/(c_2*c_12)",
        "A_d": "E_1/(c_3*c_13)",
        "lambda_": "c_12*E_3/(c_1*c_2*c_3)",
        "m": "E_1*c_23/(E_3*c_12)",
        "m_1": "c_13*E_2/(c_12*E_3)",
    },
    "3": {
        "A_a": "E_1/(c_3*c_13)",
        "A_b": "E_3/(c_2*c_23)",
        "A_d": "E_3/(c_1*c_13)",
        "lambda_": "c_23*E_1/(c_1*c_2*c_3)",
        "m": "E_3*c_12/(E_1*c_23)",
        "m_1": "c_13*(-E_2)/(c_23*E_1)",
    },
}
EDGES = {
    "separatrix_motion": {"m": "1", "m_1": "0"},
    "oblate_motion": {"m": "0", "m_1": "1"},
    "prolate_motion": {"m": "0", "m_1": "1"},
}


def derive(builder: LedgerBuilder) -> None:
    """Split all motions into leaves, and state what holds in each leaf."""
    builder.open(join("sorted_body", BODY, static=True))
    square = {"E_1": "2*H*c_1 - K_squared", "E_2": "K_squared - 2*H*c_2"}
    builder.claim("sorted_body.differences", square | {"E_3": "K_squared - 2*H*c_3"}, ["6", "15"])
    for context, name, *cases in TREE:
        builder.split(context, name, *cases)
    _steady(builder)
    for leaf in ("largest", "oblate_motion", "separatrix_motion"):
        _moving(builder, leaf, LARGEST)
    for leaf in ("smallest", "prolate_motion"):
        _moving(builder, leaf, SMALLEST)
    for context, name, *cases in reversed(TREE):
        builder.partition(context, name, *(case for case, _ in cases))


def _steady(builder: LedgerBuilder) -> None:
    """Prove (c_i - c) Omega_i = 0, by a quantity that is both >= 0 and <= 0."""
    builder.sign(
        "rest.rates", {f"-Omega_{k}**2": f"Omega_{i}**2 + Omega_{j}**2" for k, i, j in CYCLES}
    )
    builder.sign("spherical.moments", {"-c_12": "c_23", "-c_23": "c_12"})
    for leaf in ("spin_1", "oblate_polar", "prolate_equatorial"):
        forms = {
            "-(c_12*Omega_2**2)": "c_3*c_13*Omega_3**2/c_2",
            "-(c_13*Omega_3**2)": "c_2*c_12*Omega_2**2/c_3",
        }
        builder.sign(f"{leaf}.parallel", forms)
    for leaf in ("spin_3", "prolate_polar", "oblate_equatorial"):
        forms = {
            "-(c_13*Omega_1**2)": "c_2*c_23*Omega_2**2/c_1",
            "-(c_23*Omega_2**2)": "c_1*c_13*Omega_1**2/c_2",
        }
        builder.sign(f"{leaf}.parallel", forms)
    builder.sign("spin_2.parallel", {"-Omega_1**2": "Omega_3**2", "-Omega_3**2": "Omega_1**2"})


def _moving(builder: LedgerBuilder, leaf: str, axes: dict[str, str]) -> None:
    """Prove that squares, m and 1 - m of the regular form are nonnegative."""
    edge = EDGES.get(leaf, {})
    forms = {key: form for key, form in VISIBLY[axes["a"]].items() if key not in edge}
    signs = {_named(SQUARES[key], axes): form for key, form in forms.items()}
    builder.sign(f"{leaf}.squares", signs, ["10", "13", "14"])
    if edge:
        values = {_named(SQUARES[key], axes): value for key, value in edge.items()}
        builder.claim(f"{leaf}.edge", values, ["10", "13", "14"])
    _constants(builder, leaf, axes)


def _constants(builder: LedgerBuilder, leaf: str, axes: dict[str, str]) -> None:
    """Prove that the regular form has its constants here: squares of real numbers, 0 <= m <= 1."""
    whole, context = builder.ledger.contexts[leaf], f"{leaf}_constants"
    squares = part_of(builder.ledger.contexts["any_motion"]).definitions
    named = {f"{x}_{axis}": f"{x}_{axes[axis]}" for x in ("c", "Omega") for axis in "abd"}
    differ = ("c_23",) if leaf == "prolate_motion" else ()
    definitions = {**squares, **whole.definitions, **named}
    builder.open(extend(context, whole, Part(units=differ, definitions=definitions)))
    builder.model(context, "any_motion")
    names = {"m": "m", "m_1": "1 - m"}
    edge = EDGES.get(leaf, {})
    forms = {names.get(key, f"{key}_squared"): x for key, x in (VISIBLY[axes["a"]] | edge).items()}
    builder.sign(f"{context}.squares", forms, ["10", "13", "14"])
    if edge:
        builder.claim(f"{context}.edge", {"m": edge["m"]}, ["10", "13", "14"])


def _named(text: str, axes: dict[str, str]) -> str:
    """Return a formula of the regular form with axes a, b, d replaced by numbers."""
    text = re.sub(r"c_([abd])([abd])", r"(c_\1 - c_\2)", text)
    text = re.sub(r"E_[abd]", lambda found: axes[found[0]], text)
    return re.sub(r"(?<=c_)[abd]", lambda found: axes[found[0]], text)
