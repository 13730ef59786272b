"""The theta form in the complementary nome, for moduli near one.

With K_1' = K(1 - k_1^2), g = pi/(2 K_1') and the nome q of 1 - k_1^2, Jacobi's imaginary
transformation (DLMF 20.7.30, 20.7.33) of the thetas of the theta form gives

    T_4 = theta_2(z | q),    T_1 = -i theta_1(z | q),    z = g (rho beta + i u_1),

times a factor common to both, exp(-(v - i rho b)^2 K_1/(pi K_1')).  Its modulus goes into N.  Its
phase is linear in time and goes into Lambda: zeta grows by G beta, Z_u by G u_1, and e falls by G,
where G = pi/(2 K_1 K_1'), so that e = 1 - E_1'/K_1' (Legendre's relation, DLMF 19.7.1).  The proof
of the theta form leaves zeta and e free, so this is a model of it; what the functions are is
assumed anew.
"""

from derivations.theta_form import ASSUMED, CLASSICAL, COMPONENTS, FORM, FREE
from rigidsym.proof.algebra import Book, Part, join

READING = Part(
    reading={
        "gc": "pi/(2*elliptic_k(1 - k_1**2))",
        "nome_c": "nome(1 - k_1**2)",
        "g": "gc",
        "zeta": "-gc*dtheta2(gc*beta, nome_c)/theta2(gc*beta, nome_c)",
        "e": "1 - elliptic_e(1 - k_1**2)/elliptic_k(1 - k_1**2)",
        "T4_re": "re(theta2(gc*(rho*beta + I*u_1), nome_c))",
        "T4_im": "im(theta2(gc*(rho*beta + I*u_1), nome_c))",
        "T1_re": "im(theta1(gc*(rho*beta + I*u_1), nome_c))",
        "T1_im": "-re(theta1(gc*(rho*beta + I*u_1), nome_c))",
        "W": "2*re(theta2(2*gc*I*u_1, nome_c**2))*theta3(2*gc*beta, nome_c**2)",
    },
)
DERIVATIVES = Part(
    reading={
        "dT4_re": "-im(dtheta2(gc*(rho*beta + I*u_1), nome_c))",
        "dT4_im": "re(dtheta2(gc*(rho*beta + I*u_1), nome_c))",
    }
)
REFERENCES = {
    "quotient": "DLMF 22.2.4 with 22.8.1, 20.7.30 and 20.7.33",
    "slope": "DLMF 22.16.30 with 22.16.27, 20.7.33 and 19.7.1",
    "norm": "Watson's identity, DLMF 20.7.13",
}
POINTS = [
    {"k_1": k_1, "K": K, "B_a": B_a, "B_d": B_d, "rho": rho, "phase": u_1, "Delta": "1", "t": "0"}
    for k_1, u_1 in (("1/10", "1/3"), ("3/5", "-7/5"), ("99/100", "2"))
    for (K, B_a, B_d), rho in ((("5", "3", "4"), "1"), (("25", "24", "7"), "-1"))
]


def derive(book: Book) -> None:
    """A model of the theta form by other functions, and what is classical about these."""
    book.open(join("hyperbolic_form", *FORM, CLASSICAL, READING))
    book.model("hyperbolic_form", "theta_form")
    carried = ("solution", "N_of_W", *COMPONENTS)
    book.carry("hyperbolic_form", [f"theta_form.{name}" for name in carried])
    book.open(join("hyperbolic_functions", *FORM, FREE, READING, DERIVATIVES))
    for name, equations in ASSUMED.items():
        book.assume(f"hyperbolic_functions.{name}", equations, REFERENCES[name], POINTS)
    assumed = [f"hyperbolic_functions.{name}" for name in ASSUMED]
    book.model("hyperbolic_functions", "hyperbolic_form", assumed)
    book.carry("hyperbolic_functions", [f"hyperbolic_form.{name}" for name in carried])
