"""The theta form in the complementary nome, for moduli near one.

With K_c = K(1 - k_1^2), g = pi/(2 K_c) and the nome q of 1 - k_1^2, Jacobi's imaginary
transformation (DLMF 20.7.30, 20.7.33) of the thetas of the theta form gives

    T_4 = theta_2(z | q),    T_1 = -i theta_1(z | q),    z = g (rho beta + i u_1),

times a factor common to both, exp(-(v - i rho b)^2 K_1/(pi K_c)).  Its modulus goes into N.  Its
phase is linear in time and goes into Lambda: zeta grows by G beta and Z_u by G u_1,
where G = pi/(2 K_1 K_c) (Legendre's relation, DLMF 19.7.1).  The proof of the theta form leaves
zeta free, so this is a model of it; `theta_functions` proves it of these functions themselves.
"""

from typing import Any

from sympy import Function, I, elliptic_k, pi

from derivations.theta_form import (
    CLASSICAL,
    COMPONENTS,
    FORM,
    T1_im,
    T1_re,
    T4_im,
    T4_re,
    W,
    Z_u,
    k_1,
    rho,
    zeta,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps._names import symbols

gc, nome_c, g, beta, u_1 = symbols("gc nome_c g beta u_1")
functions: Any = map(Function, ["nome", "re", "im", "theta1", "theta2", "theta3", "dtheta2"])
nome, re, im, theta1, theta2, theta3, dtheta2 = functions
SHIFTED = gc * (rho * beta + I * u_1)
MEANT = {
    gc: pi / (2 * elliptic_k(1 - k_1**2)),
    nome_c: nome(1 - k_1**2),
    g: gc,
    zeta: -gc * dtheta2(gc * beta, nome_c) / theta2(gc * beta, nome_c),
    Z_u: gc * re(I * dtheta2(gc * I * u_1, nome_c) / theta2(gc * I * u_1, nome_c)),
    T4_re: re(theta2(SHIFTED, nome_c)),
    T4_im: im(theta2(SHIFTED, nome_c)),
    T1_re: im(theta1(SHIFTED, nome_c)),
    T1_im: -re(theta1(SHIFTED, nome_c)),
    W: 2 * re(theta2(2 * gc * I * u_1, nome_c**2)) * theta3(2 * gc * beta, nome_c**2),
}
READING = Part(reading={x: compute(form).ordered("gc rho beta I") for x, form in MEANT.items()})


def derive(builder: LedgerBuilder) -> None:
    """Prove that the form is a model of the theta form, by functions of the other nome."""
    here = Proofs.open(builder, "hyperbolic_form", *FORM, CLASSICAL, READING)
    here.model("theta_form")
    here.carry("theta_form", "solution", "N_of_W", *COMPONENTS)
