"""The paper's equations as printed, misprints kept: values, never functions.

`proved_by` names the facts that together say what the equation says; `refuted_by` names
counterexamples to the equation as printed, and `condition` or `repair` what mends it.  `needed_by`
names the facts that a condition cannot be dropped: without it a denominator is zero.  The verdict
is computed from the ledger by `rigidsym.paper.verdicts`; it is not written here.
"""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Equation:
    """One printed equation: its number, LaTeX, how it is read, and the facts that decide it."""

    number: str
    latex: str
    reading: str
    proved_by: tuple[str, ...] = ()
    refuted_by: tuple[str, ...] = ()
    condition: str = ""
    repair: str = ""
    needed_by: tuple[str, ...] = ()


EQUATIONS: tuple[Equation, ...] = (
    Equation(
        "1",
        r"R(t)=\begin{pmatrix} z_1 & z_2\\ -\bar z_2 & \bar z_1\end{pmatrix},\ |z_1|^2+|z_2|^2=1",
        "matrices of this form are unitary with determinant one",
        ("SU2.unitary", "SU2.special"),
    ),
    Equation(
        "2",
        r"F: R \leftrightarrow z_1+z_2 j = q_0 e+q_1 i+q_2 j+q_3 k,\ "
        r"z_1=q_0+\mathrm i q_1,\ z_2=q_2+\mathrm i q_3",
        "F turns the quaternion product into the matrix product",
        ("quaternions.product",),
    ),
    Equation(
        "3",
        r"\dot R = R\,(\Omega_1A_1+\Omega_2A_2+\Omega_3A_3)",
        "under F this is q' = q (0, Omega) / 2",
        ("quaternions.kinematics", "moving_body.kinematics", "moving_body.quaternion"),
    ),
    Equation(
        "4",
        r"A_1=\tfrac12\begin{pmatrix}\mathrm i&0\\0&-\mathrm i\end{pmatrix},\ "
        r"A_2=\tfrac12\begin{pmatrix}0&1\\-1&0\end{pmatrix},\ "
        r"A_3=\tfrac12\begin{pmatrix}0&\mathrm i\\\mathrm i&0\end{pmatrix};\ "
        r"[A_1,A_2]=A_3,\ [A_2,A_3]=A_1,\ [A_1,A_3]=-A_2",
        "the three brackets",
        ("quaternions.brackets",),
    ),
    Equation(
        "5",
        r"\dot\Omega_1=\delta_1\Omega_2\Omega_3,\ \dot\Omega_2=\delta_2\Omega_1\Omega_3,\ "
        r"\dot\Omega_3=\delta_3\Omega_1\Omega_2;\ \delta_1=\frac{c_2-c_3}{c_1},\ "
        r"\delta_2=\frac{c_3-c_1}{c_2},\ \delta_3=\frac{c_1-c_2}{c_3}",
        "the components of (7)",
        ("body.euler",),
    ),
    Equation(
        "6",
        r"H=\tfrac12(c_1\Omega_1^2+c_2\Omega_2^2+c_3\Omega_3^2),\ "
        r"K^2=c_1^2\Omega_1^2+c_2^2\Omega_2^2+c_3^2\Omega_3^2",
        "both are conserved",
        ("body.conserved",),
    ),
    Equation(
        "7",
        r"\dot M=[M,\Omega]=[M,\nabla H]",
        "the Lax pair is Euler's equations",
        ("body.lax", "body.euler", "gradient1.rate", "gradient2.rate", "gradient3.rate"),
    ),
    Equation(
        "8",
        r"M=c_1\Omega_1A_1+c_2\Omega_2A_2+c_3\Omega_3A_3,\ "
        r"\Omega=\Omega_1A_1+\Omega_2A_2+\Omega_3A_3,\ "
        r"\nabla H=\frac{\partial H}{\partial M_i}=\Omega",
        "the gradient of H in the momenta",
        ("gradient1.rate", "gradient2.rate", "gradient3.rate"),
    ),
    Equation(
        "9",
        r"M(t)=R(t)^{-1}M(0)R(t)",
        "R M R^-1 is constant, and is M where R = e",
        ("moving_body.momentum_is_constant", "identity_start.momentum"),
        ("moving_body.any_start",),
        condition="R(0) = e",
    ),
    Equation(
        "10",
        r"\Omega_i(t)=\frac{\sqrt{s_i}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_j}\,t+C_i,\ "
        r"\frac{s_i}{s_j}\right)\ \text{when}\ \left|\frac{s_i}{s_j}\right|\le1",
        "Omega_i = sqrt(s_i) sn solves the quartic of (14); divided by c_i it does not",
        ("sine.solves",),
        ("sine.over_inertia",),
        repair=r"\Omega_i(t)=\sqrt{s_i}\,\mathrm{sn}(\pm\sqrt{\alpha s_j}\,t+C_i,\ s_i/s_j)",
    ),
    Equation(
        "11",
        r"\Omega_i(t)=\frac{\sqrt{s_j}}{c_i}\,\mathrm{sn}\!\left(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{\tfrac{s_i}{s_j}}\,C_i,\ \frac{s_j}{s_i}\right)\ \text{otherwise}",
        "(10) by footnote 1",
        ("sine.solves", "reciprocal.footnote"),
        ("sine.over_inertia",),
        repair=r"\Omega_i(t)=\sqrt{s_j}\,\mathrm{sn}(\pm\sqrt{\alpha s_i}\,t+"
        r"\sqrt{s_i/s_j}\,C_i,\ s_j/s_i)",
    ),
    Equation(
        "footnote 1",
        r"\sqrt\mu\,\mathrm{sn}(\zeta,\mu)=\mathrm{sn}(\sqrt\mu\,\zeta,\mu^{-1})",
        "mu is the parameter; both sides satisfy the same equations and vanish together",
        ("reciprocal.footnote",),
    ),
    Equation(
        "12",
        r"C_i=\mathrm{sn}^{-1}\!\left(\frac{c_i\Omega_i(0)}{\sqrt{s_i}},\ \frac{s_i}{s_j}\right)",
        "where (10) starts",
        ("sine.start",),
        ("sine.start_over_inertia",),
        repair=r"C_i=\mathrm{sn}^{-1}(\Omega_i(0)/\sqrt{s_i},\ s_i/s_j)",
    ),
    Equation(
        "13",
        r"s_i=\frac{-\beta+\sqrt{\beta^2-4\alpha\chi}}{2\alpha},\ "
        r"s_j=\frac{-\beta-\sqrt{\beta^2-4\alpha\chi}}{2\alpha}",
        "roots in Omega_i^2 of the quadratic (14), not in (c_i Omega_i)^2",
        ("distinct_axis.roots", "distinct_axis.discriminant"),
        needed_by=("equal_axes_j.alpha", "equal_axes_k.alpha"),
    ),
    Equation(
        "14",
        r"\alpha=-\frac{(c_i-c_j)(c_i-c_k)}{c_jc_k},\ "
        r"\beta=\frac{4c_jc_kH-2c_i(c_j+c_k)H+2c_iK^2-(c_j+c_k)K^2}{c_ic_jc_k},\ "
        r"\chi=-\frac{(2c_jH-K^2)(2c_kH-K^2)}{c_i^2c_jc_k}",
        "Omega_i'^2 = alpha Omega_i^4 + beta Omega_i^2 + chi",
        ("axis.quartic",),
    ),
    Equation("15", r"H,\ K^2\ \text{of (6) at}\ t=0", "they are conserved", ("body.conserved",)),
    Equation(
        "16",
        r"\dot\Omega_i(0)=\pm\sqrt{\alpha s_j}\frac{\sqrt{s_i}}{c_i}\mathrm{cn}(C_i,"
        r"\tfrac{s_i}{s_j})\,\mathrm{dn}(C_i,\tfrac{s_i}{s_j})\ \text{when}\ s_j\ge s_i,\ "
        r"\pm\sqrt{\alpha s_i}\frac{\sqrt{s_j}}{c_i}\mathrm{cn}\!\left(\sqrt{\tfrac{s_i}{s_j}}"
        r"C_i,\tfrac{s_j}{s_i}\right)\mathrm{dn}\!\left(\sqrt{\tfrac{s_i}{s_j}}C_i,"
        r"\tfrac{s_j}{s_i}\right)\ \text{otherwise}",
        "the derivative of (10) at t = 0",
        ("sine.slope",),
        ("sine.slope_over_inertia",),
        repair=r"\dot\Omega_i(0)=\pm\sqrt{\alpha s_j}\sqrt{s_i}\,\mathrm{cn}(C_i,s_i/s_j)\,"
        r"\mathrm{dn}(C_i,s_i/s_j)",
    ),
    Equation(
        "17",
        r"\dot\Omega_i(0)=\delta_i\Omega_l(0)\Omega_k(0),\ l\ne k\ne i",
        "(5) at t = 0",
        ("axis.rate",),
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
        "F3 and F4 are the cosine and sine of phi3/2 only while cos(phi3) > 0",
        ("theorem1.outer_halves", "half_angle_right.tangent", "half_angle_right.squares"),
        ("half_angle_step.everywhere",),
        condition="c3*Omega3 > 0",
    ),
    Equation(
        "20",
        r"n=s_1/K^2,\ f=\pm\sqrt{s_2\alpha}\,t+C_{11},\ m=s_1/s_2,\ \vartheta=\mathrm{am}(f,m),\ "
        r"\kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_2\alpha})\ \text{when}\ |s_1/s_2|\le1",
        "the integral of (34), s1 being a root in Omega_1^2; C_11 is C_1 of (12)",
        ("theorem1_phi1.n", "theorem1_phi1.rate"),
        ("theorem1_phi1.printed_n",),
        repair=r"n=c_1^2s_1/K^2",
    ),
    Equation(
        "21",
        r"n=s_2/K^2,\ f=\pm\sqrt{s_1\alpha}\,t+\sqrt{\tfrac{s_1}{s_2}}\,C_{11},\ m=s_2/s_1,\ "
        r"\vartheta=\mathrm{am}(f,m),\ \kappa=\pm(2Hc_1-K^2)/(Kc_1\sqrt{s_1\alpha})\ "
        r"\text{when}\ |s_1/s_2|>1",
        "as (20), with the roots exchanged",
        ("theorem1_phi1.n", "theorem1_phi1.rate", "reciprocal.footnote"),
        ("theorem1_phi1.printed_n",),
        repair=r"n=c_1^2s_2/K^2",
    ),
    Equation(
        "Remark 2",
        r"S_i=\pm1\ \text{constant}",
        "where c3 Omega3 < 0 even the squares of F3 and F4 are exchanged: no signs mend that",
        ("half_angle_left.cotangent", "half_angle_left.squares"),
        ("half_angle_step.everywhere",),
        repair=r"\text{the regular form, which has no signs}",
    ),
    Equation(
        "22",
        r"R M R^{-1}=M(0)",
        "R M R^-1 is constant, and is M where R = e",
        ("moving_body.momentum_is_constant", "identity_start.momentum"),
        ("moving_body.any_start",),
        condition="R(0) = e",
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
        needed_by=("on_axis.denominators", "across.denominator"),
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
    ),
    Equation(
        "30",
        r"\Omega_2+\mathrm i\Omega_3=\dot\phi_1\mathrm ie^{-\mathrm i\phi_3}\sin\phi_2+"
        r"\dot\phi_2e^{-\mathrm i\phi_3},\ -\Omega_2+\mathrm i\Omega_3="
        r"\dot\phi_1\mathrm ie^{\mathrm i\phi_3}\sin\phi_2-\dot\phi_2e^{\mathrm i\phi_3}",
        "the off-diagonal entries of the display compared with (3)",
        ("turning.off_diagonal", "turning.companion"),
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
        needed_by=("on_axis.denominators",),
    ),
    Equation(
        "33",
        r"\phi_1(t)=\int K\left(\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\right)dt",
        "the derivative of phi1, by (6)",
        ("line32.by_invariants",),
        needed_by=("on_axis.denominators",),
    ),
    Equation(
        "34",
        r"K\left(\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\right)=\frac K{c_1}+"
        r"\frac{2Hc_1-K^2}{Kc_1}\,\frac1{1-(\frac{c_1\zeta}K)^2\mathrm{sn}^2(\xi t+\gamma,\mu)}",
        "with Omega_1 = zeta sn(xi t + gamma, mu)",
        ("sine_motion.split",),
        needed_by=("pole_plus.denominator", "pole_minus.denominator"),
    ),
    Equation(
        "35",
        r"\vartheta=\mathrm{am}(\xi t+\gamma,\mu),\ "
        r"d\vartheta=\xi\sqrt{1-\mu^2\mathrm{sn}^2(\xi t+\gamma,\mu)}\,dt",
        "mu is the parameter, as in Lemma 1 and in (34)",
        ("amplitude.repaired",),
        ("amplitude.printed",),
        repair=r"d\vartheta=\xi\sqrt{1-\mu\,\mathrm{sn}^2(\xi t+\gamma,\mu)}\,dt",
    ),
    Equation(
        "36",
        r"\dot\phi_1=\int\frac K{c_1}dt+\sigma\int\frac1{1-(\frac{c_1\zeta}K)^2\mathrm{sn}^2"
        r"(\xi t+\gamma,\mu)}\frac1{\sqrt{1-\mu^2\mathrm{sn}^2(\xi t+\gamma,\mu)}}d\vartheta,\ "
        r"\sigma=\frac{2Hc_1-K^2}{Kc_1\xi}",
        "the left side is phi1, and mu is the parameter",
        ("theorem1_phi1.by_amplitude",),
        ("theorem1_phi1.modulus",),
        repair=r"\phi_1(t)=\int\frac K{c_1}dt+\sigma\int\frac1{1-(c_1\zeta/K)^2\sin^2\vartheta}"
        r"\frac{d\vartheta}{\sqrt{1-\mu\sin^2\vartheta}}",
    ),
    Equation(
        "37",
        r"R(t)=R_{int}\,\bar R(0)^{-1}\bar R(t)",
        "a constant unit factor in front leaves (3) and |q| = 1 as they are",
        ("attitude.solution", "attitude.p_0", "attitude.p_a", "attitude.p_b", "attitude.p_d"),
    ),
)
