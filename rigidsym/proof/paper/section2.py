"""Section II, (1) to (9): SU(2), the quaternions, and the equations of motion."""

from rigidsym.proof.paper.conditions import COMMUTES
from rigidsym.proof.paper.equation import Equation, Flaw

SECTION_2: tuple[Equation, ...] = (
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
        flaws={Flaw.COMPONENT: "dH/dM_i is Omega_i, the matrix Omega its combination by (4)"},
    ),
    Equation(
        "9",
        r"M(t)=R(t)^{-1}M(0)R(t)",
        "R M R^-1 is constant; it is M at t = 0 where R and M commute, as at R(0) = e",
        ("moving_body.momentum_is_constant", "moving_body.start"),
        ("moving_body.any_start",),
        conditions=(COMMUTES,),
    ),
)
