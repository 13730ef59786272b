"""Equations (1) to (9) of Section II: SU(2), quaternions and equations of motion."""

from rigidsym.proof.paper._equation import Equation, Flaw, Sense
from rigidsym.proof.paper._printed import Vocabulary
from rigidsym.proof.paper._shared import (
    AT_START,
    BASIS,
    BODY,
    COMMUTES,
    CONSTANT,
    MOMENTUM,
    RATES,
    ROTATION,
    algebra,
    su2,
)

# (2) maps quaternions to matrices: so does its vocabulary, and \mathrm i is the quaternion i.
QUATERNIONS = {
    "imaginary": "matrix(imaginary, 0, 0, -imaginary)",
    "e": "matrix(1, 0, 0, 1)",
    "i": "matrix(imaginary, 0, 0, -imaginary)",
    "j": "matrix(0, 1, -1, 0)",
    "k": "matrix(0, imaginary, imaginary, 0)",
}
# The components of a product of quaternions; its matrix is the product of their matrices.
PRODUCT = {
    "R": f"{su2('p0', 'p1', 'p2', 'p3')}*{su2('q0', 'q1', 'q2', 'q3')}",
    "q_0": "p0*q0 - p1*q1 - p2*q2 - p3*q3",
    "q_1": "p0*q1 + p1*q0 + p2*q3 - p3*q2",
    "q_2": "p0*q2 + p2*q0 + p3*q1 - p1*q3",
    "q_3": "p0*q3 + p3*q0 + p1*q2 - p2*q1",
}
COMPONENTS = {
    "z_1": "q0 + imaginary*q1",
    "z_2": "q2 + imaginary*q3",
    "zbar_1": "q0 - imaginary*q1",
    "zbar_2": "q2 - imaginary*q3",
    "e": "matrix(1, 0, 0, 1)",
}
DELTAS = {f"delta_{k}": f"delta{k}_printed" for k in (1, 2, 3)}
INVARIANTS = {"H": "H_printed", "K**2": "K_squared_printed"}
LAX = {"M": "M", "Omega": "Omega", **BASIS}
SPINS = {"M": algebra("M1", "M2", "M3"), "Omega": algebra("Omega1", "Omega2", "Omega3")}

SECTION_2: tuple[Equation, ...] = (
    Equation(
        "1",
        r"R(t)=\begin{pmatrix} z_1 & z_2\\ -\bar z_2 & \bar z_1\end{pmatrix},\ |z_1|^2+|z_2|^2=1",
        "matrices of this form are unitary with determinant one",
        (
            Sense(
                "SU2",
                Vocabulary(COMPONENTS),
                {"R": "R"},
                (r"R(t)R(t)^\dagger=e", r"\det R(t)=1"),
            ),
        ),
    ),
    Equation(
        "2",
        r"F: R \leftrightarrow z_1+z_2 j = q_0 e+q_1 i+q_2 j+q_3 k,\ "
        r"z_1=q_0+\mathrm i q_1,\ z_2=q_2+\mathrm i q_3",
        "F turns the quaternion product into the matrix product",
        (
            Sense(
                "quaternions",
                Vocabulary({**QUATERNIONS, **PRODUCT}),
                {"z_1": "z_1", "z_2": "z_2"},
            ),
        ),
    ),
    Equation(
        "3",
        r"\dot R = R\,(\Omega_1A_1+\Omega_2A_2+\Omega_3A_3)",
        "under F this is q' = q (0, Omega) / 2",
        (Sense("moving_body", Vocabulary({**RATES, **ROTATION}), BASIS, given=("4",)),),
    ),
    Equation(
        "4",
        r"A_1=\tfrac12\begin{pmatrix}\mathrm i&0\\0&-\mathrm i\end{pmatrix},\ "
        r"A_2=\tfrac12\begin{pmatrix}0&1\\-1&0\end{pmatrix},\ "
        r"A_3=\tfrac12\begin{pmatrix}0&\mathrm i\\\mathrm i&0\end{pmatrix};\ "
        r"[A_1,A_2]=A_3,\ [A_2,A_3]=A_1,\ [A_1,A_3]=-A_2",
        "the three brackets",
        (Sense("quaternions", defines=BASIS),),
    ),
    Equation(
        "5",
        r"\dot\Omega_1=\delta_1\Omega_2\Omega_3,\ \dot\Omega_2=\delta_2\Omega_1\Omega_3,\ "
        r"\dot\Omega_3=\delta_3\Omega_1\Omega_2;\ \delta_1=\frac{c_2-c_3}{c_1},\ "
        r"\delta_2=\frac{c_3-c_1}{c_2},\ \delta_3=\frac{c_1-c_2}{c_3}",
        "the components of (7)",
        (Sense("printed_5", Vocabulary(BODY), DELTAS),),
    ),
    Equation(
        "6",
        r"H=\tfrac12(c_1\Omega_1^2+c_2\Omega_2^2+c_3\Omega_3^2),\ "
        r"K^2=c_1^2\Omega_1^2+c_2^2\Omega_2^2+c_3^2\Omega_3^2",
        "both are conserved",
        (
            Sense(
                "printed_6",
                Vocabulary(BODY),
                INVARIANTS,
                texts={
                    "H_printed": "H",
                    "K_squared_printed": "K_squared",
                    "D(H_printed)": "0",
                    "D(K_squared_printed)": "0",
                },
            ),
        ),
    ),
    Equation(
        "7",
        r"\dot M=[M,\Omega]=[M,\nabla H]",
        "the Lax pair is Euler's equations",
        (
            Sense(
                "body",
                Vocabulary({**BODY, "nabla(H)": algebra("M1/c1", "M2/c2", "M3/c3")}),
                LAX,
                given=("4", "8"),
            ),
        ),
    ),
    Equation(
        "8",
        r"M=c_1\Omega_1A_1+c_2\Omega_2A_2+c_3\Omega_3A_3,\ "
        r"\Omega=\Omega_1A_1+\Omega_2A_2+\Omega_3A_3,\ "
        r"\nabla H=\frac{\partial H}{\partial M_i}=\Omega",
        "the gradient of H in the momenta",
        (
            Sense("body", Vocabulary({**BODY, **SPINS}), BASIS, given=("4",), only=(0, 1)),
            *(
                Sense(
                    f"gradient{k}",
                    Vocabulary(
                        {
                            "nabla(H)": "D(H)",
                            "partial(H) / partial(M_i)": "D(H)",
                            "Omega": f"M{k}/c{k}",
                        }
                    ),
                    only=(2,),
                )
                for k in (1, 2, 3)
            ),
        ),
        flaws={Flaw.COMPONENT: "dH/dM_i is Omega_i, the matrix Omega its combination by (4)"},
    ),
    Equation(
        "9",
        r"M(t)=R(t)^{-1}M(0)R(t)",
        "R M R^-1 is constant; it is M at t = 0 where R and M commute, as at R(0) = e",
        (
            CONSTANT,
            AT_START,
            Sense(
                "printed_9",
                Vocabulary({**ROTATION, **MOMENTUM, "at(M, 0)": algebra("N1", "N2", "N3")}),
            ),
        ),
        conditions=(COMMUTES,),
    ),
)
