"""Section IV, Theorem 1 to footnote 3: the attitude, (18) to (21)."""

from dataclasses import replace

from rigidsym.proof.paper import lemma1, theorem1
from rigidsym.proof.paper.conditions import (
    ACROSS,
    C3_OMEGA3,
    CHANGING,
    HALF_TURN,
    IMAGINARY,
    JUMPS,
    POLES,
    RATE_1,
    RATE_2,
    ROOT_IN_RATE,
    S_2,
)
from rigidsym.proof.paper.equation import Condition, Equation, Flaw, Reading, Root, Sense


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
            theorem1.TWENTY,
            theorem1.STAR,
            theorem1.CONTINUOUS,
        ),
        mended=(theorem1.TWENTY_MENDED, theorem1.STAR_MENDED),
        roots=(Root.SCALE, Root.HALF_ANGLE),
        conditions=(C3_OMEGA3, HALF_TURN, POLES, RATE_2),
        repair=r"n=c_1^2s_1/K^2\ \text{(or (14) as for Lemma 1)},\ "
        r"y^\star=\frac y{1+\operatorname{sgn}(c_3\Omega_3)\sqrt{1+y^2}}",
        readings=(
            Reading(
                "1 is the middle or the third axis",
                "kappa and f can be real",
                lemma1.MIDDLE_REAL,
            ),
            Reading(
                "1 is the circulation axis",
                "kappa is imaginary, and so is the rate of f",
                (lemma1.REAL_RATE,),
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
        (theorem1.EIGHTEEN,),
    ),
    Equation(
        "19",
        r"\phi_1(t)=\frac K{c_1}t+\kappa\,\Pi(n;\vartheta|m)+D;\ F_1=S_1\sqrt{\tfrac{1+x}2},\ "
        r"F_2=S_2\sqrt{\tfrac{1-x}2},\ F_3=S_3\frac1{\sqrt{1+y^{\star2}}},\ "
        r"F_4=S_4\frac{y^\star}{\sqrt{1+y^{\star2}}},\ S_i=\pm1;\ "
        r"y^\star=\frac{y}{1+\sqrt{1+y^2}},\ x=\frac{c_1\Omega_1}K,\ "
        r"y=\frac{c_2\Omega_2}{c_3\Omega_3}",
        "phi3 is arctan(y): S1 S2 = 1 serves c3 Omega3 > 0, and S1 S2 = -1 serves c3 Omega3 < 0",
        (theorem1.NINETEEN, theorem1.TWENTY_WITH_14, theorem1.EITHER_SIGN),
        conditions=(
            Condition(
                "S1*S2*c3*Omega3 > 0",
                ("cos_half_phi3", "sin_phi2", "cos_phi3"),
                (theorem1.ANY_OUTER_SIGNS, ACROSS),
            ),
            Condition("S3*S4 > 0", needed_by=(theorem1.ANY_INNER_SIGNS,)),
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
        (theorem1.TWENTY,),
        mended=(theorem1.TWENTY_MENDED,),
        with_mended={"14": (theorem1.TWENTY_WITH_14,)},
        roots=(Root.SCALE,),
        repair=r"n=c_1^2s_1/K^2",
        readings=_roots_of_n(theorem1.TWENTY, theorem1.TWENTY_WITH_14),
        conditions=(POLES, RATE_2),
        flaws={**ROOT_IN_RATE, **IMAGINARY, Flaw.UNDEFINED: "C_{11}"},
    ),
    Equation(
        "21",
        r"n=s_2/K^2,\ f=\pm\sqrt{s_1\alpha}\,t+\sqrt{\tfrac{s_1}{s_2}}\,C_{11},\ m=s_2/s_1,\ "
        r"\vartheta=\mathrm{am}(f,m),\ \kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_1\alpha})\ "
        r"\text{when}\ |s_1/s_2|>1",
        "as (20), with the roots exchanged",
        (theorem1.TWENTY_ONE,),
        mended=(theorem1.TWENTY_ONE_MENDED,),
        with_mended={"14": (theorem1.TWENTY_ONE_WITH_14,)},
        roots=(Root.SCALE,),
        repair=r"n=c_1^2s_2/K^2",
        readings=_roots_of_n(theorem1.TWENTY_ONE, theorem1.TWENTY_ONE_WITH_14),
        conditions=(POLES, RATE_1, S_2),
        flaws={**ROOT_IN_RATE, **IMAGINARY, Flaw.UNDEFINED: "C_{11}"},
    ),
    Equation(
        "Remark 2",
        r"S_i=\pm1\ \text{constant, two of them suffice, set by}\ "
        r"\dot{\bar q}_0=\bar\Omega_0(\Omega_1(0),\Omega_2(0),\Omega_3(0))\,\bar q_0",
        "S1 S2 is the sign of c3 Omega3, which changes; where S2 changes phi1 has to jump by pi",
        (
            theorem1.ANY_OUTER_SIGNS_AS_SAID,
            theorem1.STAR,
            theorem1.CONTINUOUS,
        ),
        mended=(theorem1.STAR_MENDED, *theorem1.SIGNS_MENDED),
        roots=(Root.HALF_ANGLE,),
        conditions=(C3_OMEGA3, HALF_TURN),
        repair=r"S_1=S_2,\ S_3=S_4,\ "
        r"y^\star=\frac y{1+\operatorname{sgn}(c_3\Omega_3)\sqrt{1+y^2}}",
        readings=(
            Reading(
                "Omega_0 is the linear map q -> q (0, Omega)/2",
                "the display is (3) at t = 0",
                (theorem1.AS_MAP, replace(theorem1.EITHER_SIGN, only=(0,))),
            ),
            Reading(
                "Omega_0 is the quaternion (0, Omega)/2, to the left of q_0",
                "the factors are in the wrong order for rates in body axes",
                (theorem1.AS_LEFT_FACTOR,),
            ),
            Reading(
                "Omega_0 is the map q -> q (0, Omega)",
                "the half of (3) is missing",
                (theorem1.WITHOUT_HALF,),
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
        (theorem1.REFLECTED,),
        mended=(theorem1.FRAME, theorem1.SIDE),
        repair=r"\text{depending on the sign of}\ c_3\Omega_3",
        flaws={
            Flaw.REASON: "S1 S2 is the sign of c3 Omega3, not an orientation",
            Flaw.JUDGEMENT: "what is refuted is an interpretation: that S1 S2 is the determinant",
        },
    ),
)
