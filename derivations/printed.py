"""The print compared: every displayed line of the paper, in each of its readings.

The chapters before found what is true.  Here the paper is opened: the LaTeX of each line is parsed
and put into the names of a context (`rigidsym.proof.paper`), what it defines becomes a definition
there, and the kernel is asked whether the rest holds.  Nobody says beforehand what comes out.
"""

import re
from string import ascii_lowercase

from rigidsym.language._expression import to_text
from rigidsym.proof.algebra import LedgerBuilder, Part, extend, join, unit_quaternion
from rigidsym.proof.kernel import Context
from rigidsym.proof.paper import EQUATIONS
from rigidsym.proof.paper._answers import Question, asked, question, without_trivial
from rigidsym.proof.paper._printed import in_names
from rigidsym.proof.paper._shared import SEEN_FROM_SPACE

CONSTANT_M = Part(
    witness={"N1": 0, "N2": 0, "N3": 0},
    reading={f"N{k}": f"component {k} of M(0)" for k in (1, 2, 3)},
)
# M(0) by (22): what R M R^-1 is, entry by entry.
_SEEN = [to_text(part) for part in in_names(SEEN_FROM_SPACE)]
SEEN = Part(
    definitions={f"N{k}": f"2*({_SEEN[place]})" for k, place in ((1, 1), (2, 2), (3, 3))},
    reading=CONSTANT_M.reading,
)
TIME = Part(witness={"t": 0}, rates={"t": 1}, reading={"t": "time, s"})
PHASE = Part(witness={"gamma": 0}, reading={"gamma": "the phase of sn in (34)"})
MODULUS = Part(
    witness={"modulus": "7/15"},
    relations=("modulus**2 - mu",),
    reading={"modulus": "a square root of the parameter mu"},
)
QUATERNIONS = (unit_quaternion("p", "R_int"), unit_quaternion("r", "Rbar(0)"))
# A motion in rational numbers, so that nothing printed has to be rounded: moments (16/25,
# 3600/6409, 1), rates (53/64, -6409/6000, 24/25), axis i = 1 being the middle one.
ROOT_I, ROOT_J, S_J = "265/192", "1325/448", "1755625/200704"
MOTION = Part(
    witness={
        "zeta": ROOT_I,
        "s_j": S_J,
        "xi": "53/80",
        "c_i": "16/25",
        "alpha": "784/15625",
        "sn": "3/5",
        "cn": "4/5",
        "w": "159/56",
        "root_s": ROOT_J,
    },
)
BY_S_I = Part(units=("zeta",))
START = Part(witness={"C_i": 0}, reading={"C_i": "the argument at t = 0"})
UNDER_ROOT = Part(
    witness={"root_over_c": "1325/768"},
    relations=("root_over_c**2*c_i - s_i",),
    reading={"root_over_c": "sqrt(s_i/c_i)"},
)
ON_THIRD_AXIS = Part(
    witness={"c_i": 1, "r": 1, "q": "5/4", "v": 1, "x": "3/4", "y": "5/4", "w": 1},
    units=("c_i", "r", "q", "v"),
    definitions={"Omega_i": "r*x"},
    relations=("y**2 - x**2 - 1", "w**2 + r**2*x**2 - q**2"),
    rates={"x": "-v*y*w/q", "y": "-v*x*w/q", "w": "r**2*v*x*y/q"},
    reading={
        "r": "sqrt(-s_i)",
        "q": "sqrt(s_j)",
        "v": "sqrt(-alpha s_j)",
        "x": "i sn of the argument in (10), which is imaginary up to a constant",
        "y": "cn of it",
        "w": "sqrt(s_j) dn of it",
    },
)
NAMED = Part(
    definitions={"root_of_discriminant": "alpha*(root_j - root_k)"},
    reading={"root_of_discriminant": "a root of beta^2 - 4 alpha chi"},
)
ARGUMENT = Part(witness={"u": 0}, rates={"u": "nu"}, reading={"u": "zeta of footnote 1"})
HALVES = Part(units=("side", "cos_half_phi3", "sin_phi2", "cos_phi3"))
OUTER_MATCHED, INNER_MATCHED = Part(relations=("S2 - side*S1",)), Part(relations=("S4 - S3",))
TRUE_ANGLES = Part(relations=("side - 1",))
WRONG_OUTER, WRONG_INNER = Part(witness={"S2": -1}), Part(witness={"S4": -1})
# The same motion, by the names of the chapter on phi1.
AXIS_1 = Part(
    witness={
        "c1": "16/25",
        "H": "12809/12800",
        "K": "5/4",
        "zeta": ROOT_I,
        "xi": "53/80",
        "mu": "49/225",
        "sn": "3/5",
        "cn": "4/5",
        "dn": "24/25",
    },
)
THIRD_KIND = Part(
    witness={"t": 0, "C_11": 0, "D_19": 0, "Pi": 0, "s_2": S_J},
    units=("xi", "s_2", "K - c1*zeta*sn", "K + c1*zeta*sn"),
    definitions={"Omega1": "zeta*sn", "s_1": "zeta**2", "alpha": "xi**2/s_2"},
    relations=("mu*s_2 - s_1",),
    rates={"t": 1, "Pi": "xi/(1 - n_printed*sn**2)"},
    reading={
        "t": "time, s",
        "C_11": "the phase of f",
        "D_19": "D of (19)",
        "Pi": "elliptic_pi(n_printed, theta, m_printed)",
    },
)
INVERSE = Part(
    witness={"inverse_k": "15/7"},
    units=("zeta",),
    relations=("inverse_k**2*zeta**2 - s_2",),
    reading={"inverse_k": "1/sqrt(mu)"},
)
OFF_POLES = Part(units=("K - c1*zeta*sn", "K + c1*zeta*sn"), definitions={"Omega1": "zeta*sn"})
OWN_POLES = Part(units=("1 - n_printed*sn**2",))
ABOUT_MIDDLE = (MOTION, TIME, START)
BY_THIRD_KIND = ("amplitude", (AXIS_1, THIRD_KIND))
BY_INVERSE = ("amplitude", (AXIS_1, THIRD_KIND, INVERSE))
# Contexts with more to them than those of the chapters before, or with the paper's definitions.
SETTINGS: dict[str, tuple[str, tuple[Part, ...]]] = {
    "printed_5": ("body", ()),
    "printed_6": ("body", ()),
    "printed_9": ("moving_body", (SEEN,)),
    "printed_13": ("distinct_axis", (NAMED,)),
    "printed_13_mended": ("distinct_axis", (NAMED,)),
    "printed_14": ("axis", ()),
    "printed_14_mended": ("axis", ()),
    "printed_sine": ("sine", ABOUT_MIDDLE),
    "printed_sine_divided": ("sine", (*ABOUT_MIDDLE, BY_S_I)),
    "printed_under_root": ("sine", (*ABOUT_MIDDLE, UNDER_ROOT)),
    "printed_third_axis": ("", (ON_THIRD_AXIS, START)),
    "printed_footnote_1": ("reciprocal", (ARGUMENT,)),
    "printed_18": ("theorem1", ()),
    "printed_19": ("matched_signs", (HALVES,)),
    "printed_19_any_outer": ("signed", (HALVES, INNER_MATCHED, WRONG_OUTER)),
    "printed_19_any_inner": ("signed", (HALVES, OUTER_MATCHED, WRONG_INNER)),
    "printed_star": ("half_angle_step", ()),
    "printed_star_mended": ("half_angle_step", ()),
    "printed_remark_2": ("signed", (TRUE_ANGLES, OUTER_MATCHED, INNER_MATCHED)),
    "printed_20": ("amplitude", (AXIS_1, THIRD_KIND, OWN_POLES)),
    "printed_20_mended": BY_THIRD_KIND,
    "printed_20_with_14": BY_THIRD_KIND,
    "printed_21": ("amplitude", (AXIS_1, THIRD_KIND, INVERSE, OWN_POLES)),
    "printed_21_mended": BY_INVERSE,
    "printed_21_with_14": BY_INVERSE,
    "printed_22": ("moving_body", (CONSTANT_M,)),
    "printed_34": ("amplitude", (AXIS_1, TIME, PHASE, OFF_POLES)),
    "printed_35": ("amplitude", (AXIS_1, TIME, PHASE)),
    "printed_35_of_modulus": ("amplitude", (AXIS_1, TIME, PHASE, MODULUS)),
    "printed_36": ("theorem1_amplitude", (AXIS_1, PHASE)),
    "printed_36_mended": ("theorem1_amplitude", (AXIS_1, PHASE)),
    "printed_36_of_modulus": ("theorem1_amplitude", (AXIS_1, PHASE, MODULUS)),
    "printed_37": ("moving_body", QUATERNIONS),
}
# Where to look for a difference first.
POINTS: dict[str, list[dict[str, str]]] = {
    "printed_14": [
        {"c_i": "2", "c_j": "3", "c_k": "3/2", "Omega_i": "1", "Omega_j": "1/2", "Omega_k": "2"}
    ],
    "printed_footnote_1": [{"sqrt_mu": "3/4", "sn": "4/5", "cn": "3/5", "dn": "4/5"}],
    "moving_body": [{"q0": "3/5", "q2": "4/5"}],
    "pulled_back": [{"p0": "3/5", "p1": "4/5"}],
}


def derive(builder: LedgerBuilder) -> None:
    """Decide every question that the verdicts rest on, once."""
    printed = {equation.number: equation for equation in EQUATIONS}
    for equation in EQUATIONS:
        for latex, sense in asked(equation):
            ask(builder, equation.number, question(latex, sense, printed))


def ask(builder: LedgerBuilder, number: str, whole: Question) -> None:
    """Let the kernel decide a question in a context of its own, unless it is decided."""
    if whole.context not in builder.ledger.contexts:
        builder.open(_context(builder, whole))
    context = builder.ledger.contexts[whole.context]
    whole = without_trivial(whole, context.definitions, context.rates or {})
    said = (whole.context, whole.lhs, whole.rhs)
    if not any((f.context, f.lhs, f.rhs) == said for f in builder.ledger.facts.values()):
        equations = list(zip(whole.lhs, whole.rhs, strict=True))
        points = POINTS.get(whole.context, ())
        builder.compare(_new_id(builder, whole.context, number), equations, points, [number])


def _context(builder: LedgerBuilder, whole: Question) -> Context:
    base, parts = SETTINGS[whole.context]
    printed = Part(definitions=whole.definitions)
    if not base:
        return join(whole.context, *parts, printed)
    return extend(whole.context, builder.ledger.contexts[base], *parts, printed)


def _new_id(builder: LedgerBuilder, context: str, number: str) -> str:
    """Return a fact's name by the line's number, with a letter if there are several."""
    line = re.sub(r"\W+", "_", number).lower()
    names = (f"{context}.print_{line}{letter}" for letter in ("", *ascii_lowercase))
    return next(name for name in names if name not in builder.ledger.facts)
