"""The proof of Theorem 1, (22) to (37), and Remark 3."""

from rigidsym.proof.paper.conditions import COMMUTES, OFF_AXIS, POLES, RATE
from rigidsym.proof.paper.equation import Condition, Equation, Flaw, Reading

PROOF: tuple[Equation, ...] = (
    Equation(
        "22",
        r"R M R^{-1}=M(0)",
        "R M R^-1 is constant; it is M at t = 0 where R and M commute, as at R(0) = e",
        ("moving_body.momentum_is_constant", "moving_body.start"),
        ("moving_body.any_start",),
        conditions=(COMMUTES,),
    ),
    Equation(
        "23",
        r"\bar R M\bar R^{-1}=KA_1",
        "for R = exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) with (27) and (28)",
        ("reduced.conjugate",),
    ),
    Equation("24", r"M=K\bar R^{-1}A_1\bar R", "the same, solved for M", ("reduced.momentum",)),
    Equation(
        "25",
        r"\bar R=\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1)",
        "exp(phi1 A1) stabilises A1, and the three factors carry a motion",
        ("three_angles.exponential", "three_angles.stabiliser", "three_angle_motion.kinematics"),
    ),
    Equation(
        "26",
        r"M=\frac{\mathrm iK}2\begin{pmatrix}\cos\phi_2&e^{-\mathrm i\phi_3}\sin\phi_2\\ "
        r"e^{\mathrm i\phi_3}\sin\phi_2&-\cos\phi_2\end{pmatrix}",
        "(25) put into (24)",
        ("three_angles.momentum", "reduced.form"),
    ),
    Equation(
        "27",
        r"c_1\Omega_1=K\cos\phi_2",
        "the diagonal of (26) compared with (8)",
        ("compared.entries", "reduced.phi2"),
    ),
    Equation(
        "28",
        r"c_2\Omega_2+\mathrm ic_3\Omega_3=\mathrm iKe^{-\mathrm i\phi_3}\sin\phi_2,\ "
        r"-c_2\Omega_2+\mathrm ic_3\Omega_3=\mathrm iKe^{\mathrm i\phi_3}\sin\phi_2",
        "the off-diagonal entries of (26) compared with (8)",
        ("compared.entries", "reduced.phi3"),
    ),
    Equation(
        "29",
        r"\tan\phi_3=\frac{c_2\Omega_2}{c_3\Omega_3}",
        "the quotient of the two parts of (28)",
        ("tangent.phi3",),
        conditions=(
            OFF_AXIS,
            Condition("cos_phi3 != 0", ("cos_phi3",), ("across.denominator",)),
        ),
    ),
    Equation(
        "R^-1 dR/dt",
        r"\bar R^{-1}\dot{\bar R}=\frac{\dot\phi_1}2\begin{pmatrix}\mathrm i\cos\phi_2&"
        r"\mathrm ie^{-\mathrm i\phi_3}\sin\phi_2\\ \mathrm ie^{\mathrm i\phi_3}\sin\phi_2&"
        r"-\mathrm i\cos\phi_2\end{pmatrix}+\frac{\dot\phi_2}2\begin{pmatrix}0&"
        r"e^{-\mathrm i\phi_3}\\-e^{\mathrm i\phi_3}&0\end{pmatrix}+\frac{\dot\phi_3}2"
        r"\begin{pmatrix}\mathrm i&0\\0&-\mathrm i\end{pmatrix}",
        "the display without a number",
        ("turning.display",),
        flaws={Flaw.REFERENCE: "the text calls it (30), the number of the next equations"},
    ),
    Equation(
        "30",
        r"\Omega_2+\mathrm i\Omega_3=\dot\phi_1\mathrm ie^{-\mathrm i\phi_3}\sin\phi_2+"
        r"\dot\phi_2e^{-\mathrm i\phi_3},\ -\Omega_2+\mathrm i\Omega_3="
        r"\dot\phi_1\mathrm ie^{\mathrm i\phi_3}\sin\phi_2-\dot\phi_2e^{\mathrm i\phi_3}",
        "the off-diagonal entries of the display compared with (3)",
        ("turning.off_diagonal", "turning.companion"),
        flaws={Flaw.TWICE: "the text means the display before when it equates (30) to (3)"},
    ),
    Equation(
        "31",
        r"\frac{\Omega_2}{e^{-\mathrm i\phi_3}}+\frac{\mathrm i\Omega_3}{e^{-\mathrm i\phi_3}}="
        r"\dot\phi_1\mathrm i\sin\phi_2+\dot\phi_2,\ -\frac{\Omega_2}{e^{\mathrm i\phi_3}}+"
        r"\frac{\mathrm i\Omega_3}{e^{\mathrm i\phi_3}}=\dot\phi_1\mathrm i\sin\phi_2-\dot\phi_2",
        "(30) times a phase",
        ("turning.divided", "turning.sum"),
    ),
    Equation(
        "32",
        r"\dot\phi_1=K\left(\frac{\Omega_2^2c_2+c_3\Omega_3^2}"
        r"{(c_2\Omega_2)^2+(c_3\Omega_3)^2}\right)",
        "the sum of (31), with (28)",
        ("line32.sum_of_31", "line32.rate"),
        conditions=(OFF_AXIS,),
    ),
    Equation(
        "33",
        r"\phi_1(t)=\int K\left(\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\right)dt",
        "the derivative of phi1, by (6)",
        ("line32.by_invariants",),
        conditions=(OFF_AXIS,),
    ),
    Equation(
        "34",
        r"K\left(\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\right)=\frac K{c_1}+"
        r"\frac{2Hc_1-K^2}{Kc_1}\,\frac1{1-(\frac{c_1\zeta}K)^2\mathrm{sn}^2(\xi t+\gamma,\mu)}",
        "with Omega_1 = zeta sn(xi t + gamma, mu)",
        ("sine_motion.split",),
        conditions=(POLES,),
        flaws={Flaw.TWICE: "zeta, the amplitude here, is the argument in footnote 1"},
    ),
    Equation(
        "35",
        r"\vartheta=\mathrm{am}(\xi t+\gamma,\mu),\ "
        r"d\vartheta=\xi\sqrt{1-\mu^2\mathrm{sn}^2(\xi t+\gamma,\mu)}\,dt",
        "mu is the parameter, as in Lemma 1 and in (34)",
        ("amplitude.repaired",),
        ("amplitude.printed",),
        repair=r"d\vartheta=\xi\sqrt{1-\mu\,\mathrm{sn}^2(\xi t+\gamma,\mu)}\,dt",
        repair_form="D(theta)**2 = xi**2*(1 - mu*sn**2)",
        flaws={Flaw.MODULUS: "mu is the parameter in Lemma 1, footnote 1 and (34)"},
        readings=(
            Reading(
                "mu is the parameter, as in Lemma 1",
                "mu^2 should be mu",
                ("amplitude.repaired",),
                ("amplitude.printed",),
            ),
            Reading(
                "mu is the modulus, here only",
                "(35) holds, and what (34) and (36) call mu is another quantity",
                ("amplitude_of_modulus.printed",),
            ),
        ),
    ),
    Equation(
        "36",
        r"\dot\phi_1=\int\frac K{c_1}dt+\sigma\int\frac1{1-(\frac{c_1\zeta}K)^2\mathrm{sn}^2"
        r"(\xi t+\gamma,\mu)}\frac1{\sqrt{1-\mu^2\mathrm{sn}^2(\xi t+\gamma,\mu)}}d\vartheta,\ "
        r"\sigma=\frac{2Hc_1-K^2}{Kc_1\xi}",
        "the left side is phi1, and mu is the parameter",
        ("theorem1_amplitude.integrand", "third_kind.integral"),
        ("theorem1_printed.modulus", "third_kind.left_side"),
        repair=r"\phi_1(t)=\int\frac K{c_1}dt+\sigma\int\frac1{1-(c_1\zeta/K)^2\sin^2\vartheta}"
        r"\frac{d\vartheta}{\sqrt{1-\mu\sin^2\vartheta}}",
        repair_form="root_printed = 1 - mu*sn**2",
        conditions=(
            POLES,
            RATE,
            Condition("mu*sn**2 != 1", ("dn",), ("amplitude_at_rest.denominator",)),
        ),
        flaws={
            Flaw.LEFT_SIDE: "the derivative of phi1, where phi1 is integrated",
            Flaw.MODULUS: "mu is the parameter in Lemma 1, footnote 1 and (34)",
        },
    ),
    Equation(
        "Remark 3",
        r"\text{To obtain the initial state through the origin}\ R_{int},\ "
        r"\text{the quaternions (18) are pulled back to the identity via (37)}",
        "R_int is not defined; at t = 0 (37) says R(0) = R_int",
        ("pulled_back.start", "attitude.solution"),
        readings=(
            Reading(
                "R_int is the initial attitude R(0)",
                "every motion is reached; (9) and (22) then need R_int M(0) = M(0) R_int",
                ("pulled_back.start", "attitude.solution", "moving_body.start"),
            ),
            Reading(
                "R_int is the origin, the identity",
                "only motions with R(0) = e are reached; for these (9) and (22) hold",
                ("identity_start.momentum",),
                ("pulled_back.from_identity",),
            ),
        ),
        flaws={Flaw.UNDEFINED: "R_{int}"},
    ),
    Equation(
        "37",
        r"R(t)=R_{int}\,\bar R(0)^{-1}\bar R(t)",
        "a constant unit factor in front leaves (3) and |q| = 1 as they are",
        ("attitude.solution", "attitude.p_0", "attitude.p_a", "attitude.p_b", "attitude.p_d"),
        flaws={Flaw.UNDEFINED: "R_{int}"},
    ),
)
