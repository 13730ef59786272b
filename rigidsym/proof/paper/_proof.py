"""Equations of the proof of Theorem 1, (22) to (37), with Remark 3."""

from dataclasses import replace

from rigidsym.proof.paper._equation import Condition, Equation, Flaw, Reading, Root, Sense
from rigidsym.proof.paper._printed import Second, Vocabulary
from rigidsym.proof.paper._shared import (
    ACROSS,
    ANGLES,
    AT_START,
    BASIS,
    BODY,
    COMMUTES,
    CONSTANT,
    MOMENTUM,
    OFF_AXIS,
    POLES,
    RATE,
    RATES,
    ROTATION,
    THREE_TURNS,
    Words,
    plain,
    su2,
    vanishing,
)

ANGLE_RATES: Words = {f"D(phi_{k})": f"phi{k}_rate" for k in (1, 2, 3)}
REDUCED = Vocabulary({**BODY, **MOMENTUM, **ANGLES, "K": "K"})

REDUCTION = Sense("reduced", REDUCED, THREE_TURNS, given=("4", "25"))
TURNS = Vocabulary({**ANGLES, **ANGLE_RATES, **RATES, "K": "K"})
MOTION = Sense("three_angle_motion", TURNS)
FREE = Vocabulary(dict(ANGLES, K="K"))
THIRD_KIND = {
    **plain("zeta xi mu gamma t H K sn cn dn"),
    "c_1": "c1",
    "Omega_1": "Omega1",
    "vartheta": "theta",
    "sin(vartheta)": "sn",
}
SINE = Vocabulary(THIRD_KIND, (), (("sn", "cn", "dn"),), arguments=("xi*t + gamma",))
AMPLITUDE = replace(SINE, roots=("dn",))
BY_PHI1 = replace(AMPLITUDE, words={**THIRD_KIND, "phi_1": "phi1"})
# The dot on the left taken for a slip.
WITHOUT_DOT = replace(BY_PHI1, words={**BY_PHI1.words, "D(phi_1)": "phi1"})
# mu is the modulus: a square root of the parameter mu of the context.
AMPLITUDE_OF_MODULUS = replace(
    AMPLITUDE, words={**AMPLITUDE.words, "mu": "modulus"}, second=Second.MODULUS
)
BY_PHI1_OF_MODULUS = replace(
    BY_PHI1, words={**BY_PHI1.words, "mu": "modulus"}, second=Second.MODULUS
)
WITHOUT_DOT_OF_MODULUS = replace(
    WITHOUT_DOT, words={**WITHOUT_DOT.words, "mu": "modulus"}, second=Second.MODULUS
)
SIGMA = {"sigma": "sigma_printed"}
R_INT, R_START = su2("p0", "p1", "p2", "p3"), su2("r0", "r1", "r2", "r3")
PULLED = {"R_int": R_INT, "at(Rbar, 0)": R_START}
# Rbar is any that satisfies (3).
PULLED_BACK = Sense(
    "printed_37",
    Vocabulary({**RATES, **PULLED, "Rbar": ROTATION["R"]}),
    {**BASIS, "R": "R"},
    (r"\dot R=R(\Omega_1A_1+\Omega_2A_2+\Omega_3A_3)", r"\det R=1"),
    ("4",),
    of="37",
)
# At t = 0: R is R(0), and Rbar is Rbar(0).
STARTING = Sense(
    "pulled_back",
    Vocabulary({**PULLED, "R": R_INT, "Rbar": R_START}),
    of="37",
)
FROM_IDENTITY = Vocabulary({**STARTING.vocabulary.words, "R_int": "matrix(1, 0, 0, 1)"})
LINE_32 = Sense("line32", Vocabulary({**BODY, **ANGLE_RATES, "K": "K", "H": "H"}))

PROOF: tuple[Equation, ...] = (
    Equation(
        "22",
        r"R M R^{-1}=M(0)",
        "R M R^-1 is constant; it is M at t = 0 where R and M commute, as at R(0) = e",
        (CONSTANT, AT_START),
        conditions=(COMMUTES,),
    ),
    Equation(
        "23",
        r"\bar R M\bar R^{-1}=KA_1",
        "for R = exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) with (27) and (28)",
        (REDUCTION,),
    ),
    Equation("24", r"M=K\bar R^{-1}A_1\bar R", "the same, solved for M", (REDUCTION,)),
    Equation(
        "25",
        r"\bar R=\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1)",
        "exp(phi1 A1) stabilises A1, and the three factors carry a motion",
        (
            Sense(
                "three_angle_motion",
                TURNS,
                THREE_TURNS,
                (
                    r"\exp(\phi_1A_1)A_1=A_1\exp(\phi_1A_1)",
                    r"\dot{\bar R}=\bar R(\Omega_1A_1+\Omega_2A_2+\Omega_3A_3)",
                ),
                ("4",),
            ),
        ),
    ),
    Equation(
        "26",
        r"M=\frac{\mathrm iK}2\begin{pmatrix}\cos\phi_2&e^{-\mathrm i\phi_3}\sin\phi_2\\ "
        r"e^{\mathrm i\phi_3}\sin\phi_2&-\cos\phi_2\end{pmatrix}",
        "(25) put into (24)",
        (
            Sense("reduced", REDUCED),
            Sense("three_angles", FREE, {**THREE_TURNS, "M": "M"}, given=("4", "25", "24")),
        ),
    ),
    Equation(
        "27",
        r"c_1\Omega_1=K\cos\phi_2",
        "the diagonal of (26) compared with (8)",
        (Sense("reduced", REDUCED),),
    ),
    Equation(
        "28",
        r"c_2\Omega_2+\mathrm ic_3\Omega_3=\mathrm iKe^{-\mathrm i\phi_3}\sin\phi_2,\ "
        r"-c_2\Omega_2+\mathrm ic_3\Omega_3=\mathrm iKe^{\mathrm i\phi_3}\sin\phi_2",
        "the off-diagonal entries of (26) compared with (8)",
        (Sense("reduced", REDUCED),),
    ),
    Equation(
        "29",
        r"\tan\phi_3=\frac{c_2\Omega_2}{c_3\Omega_3}",
        "the quotient of the two parts of (28)",
        (Sense("tangent", Vocabulary({**BODY, "tan(phi_3)": "sin_phi3/cos_phi3"})),),
        conditions=(OFF_AXIS, Condition("cos_phi3 != 0", ("cos_phi3",), (ACROSS,))),
        flaws={Flaw.BRANCH: "it fixes phi3 up to half turns; (28) fixes it up to whole ones"},
    ),
    Equation(
        "R^-1 dR/dt",
        r"\bar R^{-1}\dot{\bar R}=\frac{\dot\phi_1}2\begin{pmatrix}\mathrm i\cos\phi_2&"
        r"\mathrm ie^{-\mathrm i\phi_3}\sin\phi_2\\ \mathrm ie^{\mathrm i\phi_3}\sin\phi_2&"
        r"-\mathrm i\cos\phi_2\end{pmatrix}+\frac{\dot\phi_2}2\begin{pmatrix}0&"
        r"e^{-\mathrm i\phi_3}\\-e^{\mathrm i\phi_3}&0\end{pmatrix}+\frac{\dot\phi_3}2"
        r"\begin{pmatrix}\mathrm i&0\\0&-\mathrm i\end{pmatrix}",
        "the display without a number",
        (Sense("turning", TURNS, THREE_TURNS, given=("4", "25")),),
        flaws={Flaw.REFERENCE: "the text calls it (30), the number of the next equations"},
    ),
    Equation(
        "30",
        r"\Omega_2+\mathrm i\Omega_3=\dot\phi_1\mathrm ie^{-\mathrm i\phi_3}\sin\phi_2+"
        r"\dot\phi_2e^{-\mathrm i\phi_3},\ -\Omega_2+\mathrm i\Omega_3="
        r"\dot\phi_1\mathrm ie^{\mathrm i\phi_3}\sin\phi_2-\dot\phi_2e^{\mathrm i\phi_3}",
        "the off-diagonal entries of the display compared with (3)",
        (MOTION,),
        flaws={Flaw.TWICE: "the text means the display before when it equates (30) to (3)"},
    ),
    Equation(
        "31",
        r"\frac{\Omega_2}{e^{-\mathrm i\phi_3}}+\frac{\mathrm i\Omega_3}{e^{-\mathrm i\phi_3}}="
        r"\dot\phi_1\mathrm i\sin\phi_2+\dot\phi_2,\ -\frac{\Omega_2}{e^{\mathrm i\phi_3}}+"
        r"\frac{\mathrm i\Omega_3}{e^{\mathrm i\phi_3}}=\dot\phi_1\mathrm i\sin\phi_2-\dot\phi_2",
        "(30) times a phase",
        (MOTION,),
    ),
    Equation(
        "32",
        r"\dot\phi_1=K\left(\frac{\Omega_2^2c_2+c_3\Omega_3^2}"
        r"{(c_2\Omega_2)^2+(c_3\Omega_3)^2}\right)",
        "the sum of (31), with (28)",
        (LINE_32,),
        conditions=(OFF_AXIS,),
    ),
    Equation(
        "33",
        r"\phi_1(t)=\int K\left(\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\right)dt",
        "the derivative of phi1, by (6)",
        (replace(LINE_32, differentiated=True),),
        conditions=(OFF_AXIS,),
    ),
    Equation(
        "34",
        r"K\left(\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\right)=\frac K{c_1}+"
        r"\frac{2Hc_1-K^2}{Kc_1}\,\frac1{1-(\frac{c_1\zeta}K)^2\mathrm{sn}^2(\xi t+\gamma,\mu)}",
        "with Omega_1 = zeta sn(xi t + gamma, mu)",
        (Sense("printed_34", SINE),),
        conditions=(POLES,),
        flaws={Flaw.TWICE: "zeta, the amplitude here, is the argument in footnote 1"},
    ),
    Equation(
        "35",
        r"\vartheta=\mathrm{am}(\xi t+\gamma,\mu),\ "
        r"d\vartheta=\xi\sqrt{1-\mu^2\mathrm{sn}^2(\xi t+\gamma,\mu)}\,dt",
        "mu is the parameter, as in Lemma 1 and in (34)",
        (Sense("printed_35", AMPLITUDE),),
        mended=(Sense("printed_35", AMPLITUDE),),
        roots=(Root.MODULUS,),
        repair=r"d\vartheta=\xi\sqrt{1-\mu\,\mathrm{sn}^2(\xi t+\gamma,\mu)}\,dt",
        flaws={Flaw.MODULUS: "mu is the parameter in Lemma 1, footnote 1 and (34)"},
        readings=(
            Reading(
                "mu is the parameter, as in Lemma 1",
                "mu^2 should be mu",
                (Sense("printed_35", AMPLITUDE),),
            ),
            Reading(
                "mu is the modulus, here only",
                "(35) holds, and what (34) and (36) call mu is another quantity",
                (Sense("printed_35_of_modulus", AMPLITUDE_OF_MODULUS),),
            ),
        ),
    ),
    Equation(
        "36",
        r"\dot\phi_1=\int\frac K{c_1}dt+\sigma\int\frac1{1-(\frac{c_1\zeta}K)^2\mathrm{sn}^2"
        r"(\xi t+\gamma,\mu)}\frac1{\sqrt{1-\mu^2\mathrm{sn}^2(\xi t+\gamma,\mu)}}d\vartheta,\ "
        r"\sigma=\frac{2Hc_1-K^2}{Kc_1\xi}",
        "the left side is phi1, and mu is the parameter",
        (Sense("printed_36", BY_PHI1, SIGMA, differentiated=True),),
        mended=(
            Sense(
                "printed_36_mended",
                BY_PHI1,
                SIGMA,
                given=("36",),
                differentiated=True,
            ),
        ),
        roots=(Root.MODULUS, Root.DOT),
        repair=r"\phi_1(t)=\int\frac K{c_1}dt+\sigma\int\frac1{1-(c_1\zeta/K)^2\sin^2\vartheta}"
        r"\frac{d\vartheta}{\sqrt{1-\mu\sin^2\vartheta}}",
        conditions=(
            POLES,
            RATE,
            Condition("mu*sn**2 != 1", ("dn",), (vanishing("amplitude_at_rest", "dn**2"),)),
        ),
        flaws={
            Flaw.LEFT_SIDE: "the derivative of phi1, where phi1 is integrated",
            Flaw.MODULUS: "mu is the parameter in Lemma 1, footnote 1 and (34)",
        },
        readings=(
            Reading(
                "the left side is phi1, and mu is the parameter",
                "mu^2 should be mu",
                (Sense("printed_36", WITHOUT_DOT, SIGMA, differentiated=True),),
            ),
            Reading(
                "the left side is phi1, and mu is the modulus",
                "(36) holds",
                (
                    Sense(
                        "printed_36_of_modulus", WITHOUT_DOT_OF_MODULUS, SIGMA, differentiated=True
                    ),
                ),
            ),
            Reading(
                "the left side is the derivative, and mu is the modulus",
                "the left side should be phi1",
                (Sense("printed_36_of_modulus", BY_PHI1_OF_MODULUS, SIGMA, differentiated=True),),
            ),
        ),
    ),
    Equation(
        "Remark 3",
        r"\text{To obtain the initial state through the origin}\ R_{int},\ "
        r"\text{the quaternions (18) are pulled back to the identity via (37)}",
        "R_int is not defined; at t = 0 (37) says R(0) = R_int",
        (PULLED_BACK,),
        readings=(
            Reading(
                "R_int is the initial attitude R(0)",
                "every motion is reached; (9) and (22) then need R_int M(0) = M(0) R_int",
                (PULLED_BACK, STARTING),
            ),
            Reading(
                "R_int is the origin, the identity",
                "only motions with R(0) = e are reached; for these (9) and (22) hold",
                (replace(STARTING, vocabulary=FROM_IDENTITY),),
            ),
        ),
        flaws={Flaw.UNDEFINED: "R_{int}"},
    ),
    Equation(
        "37",
        r"R(t)=R_{int}\,\bar R(0)^{-1}\bar R(t)",
        "a constant unit factor in front leaves (3) and |q| = 1 as they are",
        (PULLED_BACK, STARTING),
        flaws={Flaw.UNDEFINED: "R_{int}"},
    ),
)
