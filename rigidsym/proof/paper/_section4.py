"""Equations of Section IV on the attitude, from Theorem 1 to footnote 3."""

from dataclasses import replace

from rigidsym.proof.paper._equation import Condition, Equation, Flaw, Reading, Root, Sense
from rigidsym.proof.paper._printed import Vocabulary
from rigidsym.proof.paper._section3 import MIDDLE_REAL, REAL_RATE
from rigidsym.proof.paper._shared import (
    ACROSS,
    ANGLES,
    BASIS,
    IMAGINARY,
    MOMENTUM,
    POLES,
    RATE,
    ROTATION,
    SPINNING,
    THREE_TURNS,
    algebra,
    plain,
    stated,
    vanishing,
)

RATE_1 = replace(RATE, text="alpha*s_1 != 0", units=("xi", "s_2"))
RATE_2 = replace(RATE, text="alpha*s_2 != 0", units=("xi", "s_2"))
S_2 = Condition("s_2 != 0", ("zeta",), (SPINNING,))
C3_OMEGA3 = Condition("c3*Omega3 != 0", ("cos_half**2 - sin_half**2",), (ACROSS,))
HALF_TURN = Condition("cos(phi3/2) != 0", ("cos_half",), (vanishing("half_turn", "rho + side"),))
ROOT_IN_RATE = {Flaw.VARIABLE: "s_1 is a root in Omega_1^2; n expects one in (c_1 Omega_1)^2"}
CHANGING = {
    Flaw.SIGNS: "S1 S2 is the sign of c3 Omega3: no constant signs last through a period, unless "
    "axis 3 is the circulation axis"
}
JUMPS = {
    Flaw.JUMP: "mended, q changes its sign where phi3 passes pi, as cos(phi3/2) does; "
    "the attitude does not jump"
}

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
    """Return the components of the quaternion in equation (18).

    The arguments are cos(phi1/2), sin(phi1/2) and F1 to F4.
    """
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


def _roots_of_n(as_printed: Sense, with_14: Sense) -> tuple[Reading, ...]:
    return (
        Reading(
            "s_1 and s_2 by (13) and (14) as they are printed",
            "n lacks the factor c_1^2",
            (as_printed,),
        ),
        Reading(
            "s_1 and s_2 are roots in (c_1 Omega_1)^2, by (14) as mended for Lemma 1",
            "n is right as it is printed",
            (with_14,),
        ),
    )


SECTION_4: tuple[Equation, ...] = (
    Equation(
        "Theorem 1",
        r"\text{(18) to (21) are the natural motions of a free rigid body}",
        "(18) carries a motion where F1 to F4 are those of (27) and (29); n and y* are not",
        (
            TWENTY,
            STAR,
            CONTINUOUS,
        ),
        mended=(TWENTY_MENDED, STAR_MENDED),
        roots=(Root.SCALE, Root.HALF_ANGLE),
        conditions=(C3_OMEGA3, HALF_TURN, POLES, RATE_2),
        repair=r"n=c_1^2s_1/K^2\ \text{(or (14) as for Lemma 1)},\ "
        r"y^\star=\frac y{1+\operatorname{sgn}(c_3\Omega_3)\sqrt{1+y^2}}",
        readings=(
            Reading(
                "1 is the middle or the third axis",
                "kappa and f can be real",
                MIDDLE_REAL,
            ),
            Reading(
                "1 is the circulation axis",
                "kappa is imaginary, and so is the rate of f",
                (REAL_RATE,),
            ),
        ),
        flaws={**ROOT_IN_RATE, **CHANGING, **IMAGINARY, **JUMPS},
    ),
    Equation(
        "18",
        r"q_0=F_1(\cos\tfrac{\phi_1}2F_3-\sin\tfrac{\phi_1}2F_4),\ "
        r"q_1=F_1(\sin\tfrac{\phi_1}2F_3+\cos\tfrac{\phi_1}2F_4),\ "
        r"q_2=F_2(\cos\tfrac{\phi_1}2F_3+\sin\tfrac{\phi_1}2F_4),\ "
        r"q_3=F_2(\sin\tfrac{\phi_1}2F_3-\cos\tfrac{\phi_1}2F_4)",
        "the quaternion of (25), F1 to F4 being cosines and sines of half angles",
        (EIGHTEEN,),
    ),
    Equation(
        "19",
        r"\phi_1(t)=\frac K{c_1}t+\kappa\,\Pi(n;\vartheta|m)+D;\ F_1=S_1\sqrt{\tfrac{1+x}2},\ "
        r"F_2=S_2\sqrt{\tfrac{1-x}2},\ F_3=S_3\frac1{\sqrt{1+y^{\star2}}},\ "
        r"F_4=S_4\frac{y^\star}{\sqrt{1+y^{\star2}}},\ S_i=\pm1;\ "
        r"y^\star=\frac{y}{1+\sqrt{1+y^2}},\ x=\frac{c_1\Omega_1}K,\ "
        r"y=\frac{c_2\Omega_2}{c_3\Omega_3}",
        "phi3 is arctan(y): S1 S2 = 1 serves c3 Omega3 > 0, and S1 S2 = -1 serves c3 Omega3 < 0",
        (NINETEEN, TWENTY_WITH_14, EITHER_SIGN),
        conditions=(
            Condition(
                "S1*S2*c3*Omega3 > 0",
                ("cos_half_phi3", "sin_phi2", "cos_phi3"),
                (ANY_OUTER_SIGNS, ACROSS),
            ),
            Condition("S3*S4 > 0", needed_by=(ANY_INNER_SIGNS,)),
            POLES,
            RATE_2,
        ),
        roots=(Root.HALF_ANGLE,),
        flaws=CHANGING,
    ),
    Equation(
        "20",
        r"n=s_1/K^2,\ f=\pm\sqrt{s_2\alpha}\,t+C_{11},\ m=s_1/s_2,\ \vartheta=\mathrm{am}(f,m),\ "
        r"\kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_2\alpha})\ \text{when}\ |s_1/s_2|\le1",
        "the integral of (34), s1 being a root in Omega_1^2; C_11 is C_1 of (12)",
        (TWENTY,),
        mended=(TWENTY_MENDED,),
        with_mended={"14": (TWENTY_WITH_14,)},
        roots=(Root.SCALE,),
        repair=r"n=c_1^2s_1/K^2",
        readings=_roots_of_n(TWENTY, TWENTY_WITH_14),
        conditions=(POLES, RATE_2),
        flaws={**ROOT_IN_RATE, **IMAGINARY, Flaw.UNDEFINED: "C_{11}"},
    ),
    Equation(
        "21",
        r"n=s_2/K^2,\ f=\pm\sqrt{s_1\alpha}\,t+\sqrt{\tfrac{s_1}{s_2}}\,C_{11},\ m=s_2/s_1,\ "
        r"\vartheta=\mathrm{am}(f,m),\ \kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_1\alpha})\ "
        r"\text{when}\ |s_1/s_2|>1",
        "as (20), with the roots exchanged",
        (TWENTY_ONE,),
        mended=(TWENTY_ONE_MENDED,),
        with_mended={"14": (TWENTY_ONE_WITH_14,)},
        roots=(Root.SCALE,),
        repair=r"n=c_1^2s_2/K^2",
        readings=_roots_of_n(TWENTY_ONE, TWENTY_ONE_WITH_14),
        conditions=(POLES, RATE_1, S_2),
        flaws={**ROOT_IN_RATE, **IMAGINARY, Flaw.UNDEFINED: "C_{11}"},
    ),
    Equation(
        "Remark 2",
        r"S_i=\pm1\ \text{constant, two of them suffice, set by}\ "
        r"\dot{\bar q}_0=\bar\Omega_0(\Omega_1(0),\Omega_2(0),\Omega_3(0))\,\bar q_0",
        "S1 S2 is the sign of c3 Omega3, which changes; where S2 changes phi1 has to jump by pi",
        (
            ANY_OUTER_SIGNS_AS_SAID,
            STAR,
            CONTINUOUS,
        ),
        mended=(STAR_MENDED, *SIGNS_MENDED),
        roots=(Root.HALF_ANGLE,),
        conditions=(C3_OMEGA3, HALF_TURN),
        repair=r"S_1=S_2,\ S_3=S_4,\ "
        r"y^\star=\frac y{1+\operatorname{sgn}(c_3\Omega_3)\sqrt{1+y^2}}",
        readings=(
            Reading(
                "Omega_0 is the linear map q -> q (0, Omega)/2",
                "the display is (3) at t = 0",
                (AS_MAP, replace(EITHER_SIGN, only=(0,))),
            ),
            Reading(
                "Omega_0 is the quaternion (0, Omega)/2, to the left of q_0",
                "the factors are in the wrong order for rates in body axes",
                (AS_LEFT_FACTOR,),
            ),
            Reading(
                "Omega_0 is the map q -> q (0, Omega)",
                "the half of (3) is missing",
                (WITHOUT_HALF,),
            ),
        ),
        flaws={
            **CHANGING,
            **JUMPS,
            Flaw.UNDEFINED: r"\bar\Omega_0",
            Flaw.TWICE: "q_0 is the initial quaternion here and a component in (18)",
            Flaw.ORDER: "(3) has Omega on the right",
        },
    ),
    Equation(
        "footnote 3",
        r"\text{[equivalent rotations] depending of whether the orthonormal frame is "
        r"positively or negatively oriented}",
        "with any signs (18) is in SU(2) and leaves the frame's orientation alone",
        (REFLECTED,),
        mended=(FRAME, SIDE),
        repair=r"\text{depending on the sign of}\ c_3\Omega_3",
        flaws={
            Flaw.REASON: "S1 S2 is the sign of c3 Omega3, not an orientation",
            Flaw.JUDGEMENT: "what is refuted is an interpretation: that S1 S2 is the determinant",
        },
        roots=(Root.HALF_ANGLE,),
    ),
)
