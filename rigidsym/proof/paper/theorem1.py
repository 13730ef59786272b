"""How Theorem 1, its lines and its remarks are put: vocabularies and senses of (18) to (21)."""

from dataclasses import replace

from rigidsym.proof.paper.conditions import stated
from rigidsym.proof.paper.equation import Sense
from rigidsym.proof.paper.printed import Vocabulary
from rigidsym.proof.paper.words import (
    ANGLES,
    BASIS,
    MOMENTUM,
    ROTATION,
    THREE_TURNS,
    algebra,
    plain,
)

QUATERNION = {f"q_{k}": f"q{k}" for k in range(4)}
EIGHTEEN = Sense(
    "printed_18",
    Vocabulary(
        {
            **ANGLES,
            "F_1": "cos_half_phi2",
            "F_2": "sin_half_phi2",
            "F_3": "cos_half_phi3",
            "F_4": "sin_half_phi3",
        }
    ),
    {**THREE_TURNS, **QUATERNION},
    (
        r"\begin{pmatrix}q_0+\mathrm iq_1&q_2+\mathrm iq_3\\"
        r"-q_2+\mathrm iq_3&q_0-\mathrm iq_1\end{pmatrix}=\bar R",
    ),
    ("4", "25"),
)
# (19) as a whole: x and y from the momentum, F1 to F4 from them, q by (18); q has the momentum.
FACTORS = {"x": "x", "y": "y", "y_star": "y_star", **{f"F_{k}": f"F{k}" for k in (1, 2, 3, 4)}}
NINETEEN = Sense(
    "printed_19",
    Vocabulary(
        {
            **{f"c_{k} * Omega_{k}": f"M{k}" for k in (1, 2, 3)},
            **{f"S_{k}": f"S{k}" for k in (1, 2, 3, 4)},
            **ANGLES,
            **MOMENTUM,
            **ROTATION,
            "K": "K",
        },
        ("cos_half_phi2", "sin_half_phi2", "1/cos_half_phi3", "1/cos_phi3"),
    ),
    {**BASIS, **FACTORS, **QUATERNION},
    (r"M=KR^{-1}A_1R",),
    ("4", "18"),
    only=(1, 2, 3, 4, 6, 7, 8),
)
ANY_OUTER_SIGNS = replace(NINETEEN, context="printed_19_any_outer")
ANY_INNER_SIGNS = replace(NINETEEN, context="printed_19_any_inner")
ANY_OUTER_SIGNS_AS_SAID = replace(ANY_OUTER_SIGNS, given=("4", "18", "19"), latex="", only=())
# y* alone: whether it is the tangent of phi3/2.
HALF_ANGLE = {"y_star*cos_half": "sin_half", "cos_half**2*(1 + y_star**2)": "1"}
STAR = Sense(
    "printed_star",
    Vocabulary({"y": "y", "sgn(c_3 * Omega_3)": "side"}, ("1/rho",)),
    {"y_star": "y_star"},
    given=("19",),
    latex="",
    texts=HALF_ANGLE,
)
STAR_MENDED = replace(STAR, context="printed_star_mended", given=(), latex=None, only=(2,))
_THIRD_KIND = {
    **plain("H K C_11 t s_1 s_2 alpha"),
    "c_1": "c1",
    "vartheta": "theta",
    "D": "D_19",
}
_MENDED = {"s_1": "c1**2*s_1", "s_2": "c1**2*s_2", "alpha": "alpha/c1**2"}
_BY_20 = {name: f"{name}_printed" for name in ("n", "f", "m", "kappa")} | {"phi_1": "phi1_printed"}
TWENTY = Sense(
    "printed_20",
    Vocabulary(
        _THIRD_KIND,
        ("xi",),
        (("sn", "cn", "dn"),),
        arguments=("xi*t + C_11",),
        when="1 - (s_1/s_2)**2",
    ),
    _BY_20,
    given=("19",),
    of="20",
    texts={"D(phi1_printed)": "K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2)"},
)
TWENTY_MENDED = replace(TWENTY, context="printed_20_mended", given=("19", "20"), of="", only=(0,))
TWENTY_WITH_14 = replace(
    TWENTY,
    context="printed_20_with_14",
    vocabulary=replace(TWENTY.vocabulary, words={**_THIRD_KIND, **_MENDED}),
)
_INVERSE = replace(
    TWENTY.vocabulary,
    words={**_THIRD_KIND, "s_1": "s_2", "s_2": "s_1"},
    roots=("xi", "inverse_k"),
    arguments=("xi*t + inverse_k*C_11",),
    when="(s_2/s_1)**2 - 1",
)
TWENTY_ONE = replace(TWENTY, context="printed_21", vocabulary=_INVERSE, of="21")
TWENTY_ONE_MENDED = replace(
    TWENTY_ONE, context="printed_21_mended", given=("19", "21"), of="", only=(0,)
)
TWENTY_ONE_WITH_14 = replace(
    TWENTY_ONE,
    context="printed_21_with_14",
    vocabulary=replace(
        _INVERSE, words={**_INVERSE.words, **_MENDED, "s_1": _MENDED["s_2"], "s_2": _MENDED["s_1"]}
    ),
)
_OMEGA = algebra("Omega1", "Omega2", "Omega3")
_APPLIED = "Omegabar_0(at(Omega_1, 0), at(Omega_2, 0), at(Omega_3, 0))"
_TURNED = {"D(qbar_0)": "matrix(D(q0) + imaginary*D(q1), D(q2) + imaginary*D(q3), "
           "-D(q2) + imaginary*D(q3), D(q0) - imaginary*D(q1))"}  # fmt: skip
AS_MAP, WITHOUT_HALF = (
    Sense(
        "moving_body",
        Vocabulary({**_TURNED, f"{_APPLIED} * qbar_0": f"{factor}{ROTATION['R']}*{_OMEGA}"}),
        only=(2,),
    )
    for factor in ("", "2*")
)
AS_LEFT_FACTOR = Sense(
    "moving_body",
    Vocabulary({**_TURNED, _APPLIED: _OMEGA, "qbar_0": ROTATION["R"]}),
    only=(2,),
)
_SIGNS = {f"S_{k}": f"S{k}" for k in (1, 2, 3, 4)}
FRAME = Sense("signed", Vocabulary(ROTATION), latex=r"\det R=1")
REFLECTED = Sense("signed", Vocabulary({**ROTATION, **_SIGNS}), latex=r"\det R=S_1S_2")
SIDE = Sense(
    "matched_signs",
    Vocabulary({**_SIGNS, **ANGLES, "c_3 * Omega_3": "M3", "K": "K"}),
    says=(r"S_1S_2(c_3\Omega_3)=K\sin\phi_2\cos\phi_3",),
)
# S_i = +-1, for one i.
EITHER_SIGN = Sense("signed", Vocabulary({"S_i": "S1"}, pm="S1"), texts={"S1**2": "1"}, only=(5,))
SIGNS_MENDED = tuple(
    Sense("printed_remark_2", Vocabulary(_SIGNS), only=(which,)) for which in (0, 1)
)


def _by_18(c: str, s: str, F1: str, F2: str, F3: str, F4: str) -> tuple[str, ...]:
    """(18) from the cosine and sine of phi1/2 and F1 to F4."""
    return (
        f"{F1}*({c}*{F3} - {s}*{F4})",
        f"{F1}*({s}*{F3} + {c}*{F4})",
        f"{F2}*({c}*{F3} + {s}*{F4})",
        f"{F2}*({s}*{F3} - {c}*{F4})",
    )


# Where Omega3 passes zero y* jumps from 1 to -1, h being F3 there.
_HALF = ("cos_half_phi1", "sin_half_phi1", "cos_half_phi2")
_BEFORE = _by_18(*_HALF, "sin_half_phi2", "h", "h")
_AFTER = _by_18(*_HALF, "(-sin_half_phi2)", "h", "(-h)")
CONTINUOUS = stated("crossing", dict(zip(_BEFORE, _AFTER, strict=True)))
