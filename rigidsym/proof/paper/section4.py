"""Section IV, Theorem 1 to footnote 3: the quaternion solution."""

from rigidsym.proof.paper.conditions import (
    C3_OMEGA3,
    CHANGING,
    HALF_TURN,
    IMAGINARY,
    POLES,
    RATE_1,
    RATE_2,
    ROOT_IN_RATE,
    ROOTS_OF_N,
    S_2,
)
from rigidsym.proof.paper.equation import Condition, Equation, Flaw, Reading

SECTION_4: tuple[Equation, ...] = (
    Equation(
        "Theorem 1",
        r"\text{(18) to (21) are the natural motions of a free rigid body}",
        "(18) carries a motion where F1 to F4 are those of (27) and (29); n and y* are not",
        (
            "theorem1.quaternion",
            "theorem1.outer_halves",
            "half_angle_step.mended",
            "theorem1_phi1.n",
            "theorem1_phi1.rate",
            "three_angle_motion.kinematics",
            "three_angle_motion.euler",
        ),
        ("theorem1_printed.n", "half_angle_step.everywhere", "crossing.continuous"),
        conditions=(C3_OMEGA3, HALF_TURN, POLES, RATE_2),
        repair=r"n=c_1^2s_1/K^2\ \text{(or (14) as for Lemma 1)},\ "
        r"y^\star=\frac y{1+\operatorname{sgn}(c_3\Omega_3)\sqrt{1+y^2}}",
        readings=(
            Reading(
                "1 is the middle or the third axis",
                "kappa and f can be real",
                ("middle_axis.rates", "third_axis.rates"),
            ),
            Reading(
                "1 is the circulation axis",
                "kappa is imaginary, and so is the rate of f",
                ("circulating_axis.outer", "circulating_axis.inner"),
                ("circulating_axis.real_rate",),
            ),
        ),
        flaws={**ROOT_IN_RATE, **CHANGING, **IMAGINARY},
    ),
    Equation(
        "18",
        r"q_0=F_1(\cos\tfrac{\phi_1}2F_3-\sin\tfrac{\phi_1}2F_4),\ "
        r"q_1=F_1(\sin\tfrac{\phi_1}2F_3+\cos\tfrac{\phi_1}2F_4),\ "
        r"q_2=F_2(\cos\tfrac{\phi_1}2F_3+\sin\tfrac{\phi_1}2F_4),\ "
        r"q_3=F_2(\sin\tfrac{\phi_1}2F_3-\cos\tfrac{\phi_1}2F_4)",
        "the quaternion of (25), F1 to F4 being cosines and sines of half angles",
        ("theorem1.quaternion",),
    ),
    Equation(
        "19",
        r"\phi_1(t)=\frac K{c_1}t+\kappa\,\Pi(n;\vartheta|m)+D;\ F_1=S_1\sqrt{\tfrac{1+x}2},\ "
        r"F_2=S_2\sqrt{\tfrac{1-x}2},\ F_3=S_3\frac1{\sqrt{1+y^{\star2}}},\ "
        r"F_4=S_4\frac{y^\star}{\sqrt{1+y^{\star2}}},\ S_i=\pm1;\ "
        r"y^\star=\frac{y}{1+\sqrt{1+y^2}},\ x=\frac{c_1\Omega_1}K,\ "
        r"y=\frac{c_2\Omega_2}{c_3\Omega_3}",
        "phi3 is arctan(y): S1 S2 = 1 serves c3 Omega3 > 0, and S1 S2 = -1 serves c3 Omega3 < 0",
        (
            "theorem1.outer_halves",
            "half_angle_right.tangent",
            "half_angle_right.squares",
            "matched_signs.momentum",
        ),
        ("signed.any_S1_S2", "signed.any_S3_S4"),
        conditions=(
            Condition(
                "S1*S2*c3*Omega3 > 0",
                ("cos_half**2 - sin_half**2",),
                ("signed.any_S1_S2", "across.denominator"),
            ),
            Condition("S3*S4 > 0", needed_by=("signed.any_S3_S4",)),
        ),
        flaws=CHANGING,
    ),
    Equation(
        "20",
        r"n=s_1/K^2,\ f=\pm\sqrt{s_2\alpha}\,t+C_{11},\ m=s_1/s_2,\ \vartheta=\mathrm{am}(f,m),\ "
        r"\kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_2\alpha})\ \text{when}\ |s_1/s_2|\le1",
        "the integral of (34), s1 being a root in Omega_1^2; C_11 is C_1 of (12)",
        ("theorem1_phi1.n", "theorem1_phi1.rate"),
        ("theorem1_printed.n",),
        repair=r"n=c_1^2s_1/K^2",
        repair_form="n_printed = c1**2*s_1/K**2",
        readings=ROOTS_OF_N,
        conditions=(POLES, RATE_2),
        flaws={**ROOT_IN_RATE, **IMAGINARY, Flaw.UNDEFINED: "C_{11}"},
    ),
    Equation(
        "21",
        r"n=s_2/K^2,\ f=\pm\sqrt{s_1\alpha}\,t+\sqrt{\tfrac{s_1}{s_2}}\,C_{11},\ m=s_2/s_1,\ "
        r"\vartheta=\mathrm{am}(f,m),\ \kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_1\alpha})\ "
        r"\text{when}\ |s_1/s_2|>1",
        "as (20), with the roots exchanged",
        ("theorem1_phi1.n", "theorem1_phi1.rate", "reciprocal.footnote"),
        ("theorem1_printed.n",),
        repair=r"n=c_1^2s_2/K^2",
        repair_form="n_printed = c1**2*s_1/K**2",
        readings=ROOTS_OF_N,
        conditions=(POLES, RATE_1, S_2),
        flaws={**ROOT_IN_RATE, **IMAGINARY, Flaw.UNDEFINED: "C_{11}"},
    ),
    Equation(
        "Remark 2",
        r"S_i=\pm1\ \text{constant, two of them suffice, set by}\ "
        r"\dot{\bar q}_0=\bar\Omega_0(\Omega_1(0),\Omega_2(0),\Omega_3(0))\,\bar q_0",
        "S1 S2 is the sign of c3 Omega3, which changes; where S2 changes phi1 has to jump by pi",
        ("matched_signs.side", "crossing.turned", "half_angle_step.mended"),
        ("signed.any_S1_S2", "crossing.continuous", "half_angle_step.everywhere"),
        conditions=(C3_OMEGA3, HALF_TURN),
        repair=r"S_1=S_2,\ S_3=S_4,\ "
        r"y^\star=\frac y{1+\operatorname{sgn}(c_3\Omega_3)\sqrt{1+y^2}}",
        repair_form="y_star = y/(1 + side/rho)",
        readings=(
            Reading(
                "Omega_0 is the linear map q -> q (0, Omega)/2",
                "the display is (3) at t = 0",
                ("moving_body.quaternion",),
            ),
            Reading(
                "Omega_0 is the quaternion (0, Omega)/2, to the left of q_0",
                "the factors are in the wrong order for rates in body axes",
                ("moving_body.quaternion",),
                ("moving_body.left_factor",),
            ),
            Reading(
                "Omega_0 is the map q -> q (0, Omega)",
                "the half of (3) is missing",
                ("moving_body.quaternion",),
                ("moving_body.without_half",),
            ),
        ),
        flaws={
            **CHANGING,
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
        ("signed.frame", "matched_signs.side"),
        ("signed.reflection",),
        repair=r"\text{depending on the sign of}\ c_3\Omega_3",
        flaws={Flaw.REASON: "S1 S2 is the sign of c3 Omega3, not an orientation"},
    ),
)
