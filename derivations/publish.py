"""What the number wing may use: sequences of proved formulas, in order of evaluation.

`constants` turns inertia, rates and attitude at t = 0 into constants of the motion, `state` turns
them and a time into rates and attitude, `steady` serves the motions with constant rates.
`theta` adds the constants of the theta form, `theta_state` is a state by it, and `pull_back` finds
the constant unit quaternion in front from one attitude.  `circular` and `circular_state` do the
same with every theta as a function of its own, `hyperbolic` and `hyperbolic_state` in the
complementary nome; `rates` go with either.  `shift`, `landen` and `scaling` lead to all of them
without cancellation.
An entry is a proved fact, or the reading of a name: a standard function of known quantities, used
where the paper's equation does.
"""

from rigidsym.proof.algebra import Book
from rigidsym.proof.algebra.book import Entry, facts, readings

DIFFERENCES = facts("regular", "c_ab c_ad c_bd")
INVARIANTS = [*facts("regular", "H E_a E_b E_d"), *facts("attitude", "M_a M_b M_d")]
MOMENTA = facts("attitude", "M_a M_b M_d")
SHORTEST = facts("attitude", "nu s_0 s_b s_d")
PARTICULAR = facts("attitude", "qbar_0 qbar_a qbar_b qbar_d")
PULL_BACK = facts("attitude", "p_0 p_a p_b p_d")
QUATERNION = facts("attitude", "q_0 q_a q_b q_d")
RATES = facts("regular", "Omega_a Omega_b Omega_d")
LANDEN_RATES = readings("descended", "s c d", "10")
NUMERATORS = facts("theta_form", "P4_re P4_im P1_re P1_im")
BY_THETAS = facts("theta_form", "qbar_0 qbar_a qbar_b qbar_d")
LAMBDA = facts("theta_form", "Lambda")


def _by_functions(context: str) -> list[Entry]:
    """A state by the functions that the readings of a context name."""
    return [
        *facts("descended", "u_1"),
        *readings(context, "T4_re T4_im T1_re T1_im X_re X_im", "18"),
        *NUMERATORS,
        *readings(context, "W", "1"),
        *facts("theta_form", "N_of_W"),
        *BY_THETAS,
        *QUATERNION,
    ]


SEQUENCES: dict[str, list[Entry]] = {
    "constants": [
        *DIFFERENCES,
        *INVARIANTS,
        *facts("attitude", "K"),
        *facts("regular", "A_a A_b A_d lambda_ m m_1 tau"),
        *facts("descended", "k_c k_1 m_c mu n psi_0 kappa"),
        *facts("regular", "sn cn dn"),
        *readings("descended", "u", "12"),
        *facts("descended", "u_1_of_u phase"),
        *readings("descended", "J_0", "36"),
        *SHORTEST,
        *PARTICULAR,
        *PULL_BACK,
    ],
    "state": [
        *facts("descended", "u_1"),
        *LANDEN_RATES,
        *facts("descended", "sn cn dn"),
        *RATES,
        *MOMENTA,
        *SHORTEST,
        *readings("descended", "J", "36"),
        *facts("descended", "psi"),
        *readings("attitude", "cos_half_psi sin_half_psi", "18"),
        *PARTICULAR,
        *QUATERNION,
    ],
    "theta": [
        *facts("theta_form", "root_k B_a B_d x y z"),
        *readings("theta_form", "beta", "28"),
        *readings("theta_form", "g nome_1", "10"),
        *readings("theta_form", "zeta", "34"),
        *LAMBDA,
    ],
    "pull_back": PULL_BACK,
    "theta_state": [
        *facts("descended", "u_1"),
        *LANDEN_RATES,
        *facts("theta_form", "SN_re SN_im"),
        *readings("theta_form", "T4_re T4_im", "18"),
        *facts("theta_form", "T1_re T1_im"),
        *readings("theta_form", "X_re X_im", "18"),
        *NUMERATORS,
        *facts("theta_form", "N"),
        *BY_THETAS,
        *facts("attitude", "M_a_of_attitude M_b_of_attitude M_d_of_attitude"),
        *facts("attitude", "Omega_a Omega_b Omega_d"),
        *QUATERNION,
    ],
    "shift": facts("theta_form", "root_k x y z s_beta c_beta d_beta"),
    "scaling": facts("scaling", "root_r Q Y root_h h_plus h_minus"),
    "landen": facts("landen", "k_next root_kc kc_next s_next v c_next d_next r_next S Y_next K"),
    "rates": [*readings("regular", "sn cn dn", "10"), *RATES],
    "circular": [
        *readings("theta_form", "g nome_1 nome_m", "10"),
        *readings("theta_form", "zeta", "34"),
        *LAMBDA,
    ],
    "circular_state": _by_functions("theta_form"),
    "hyperbolic": [
        *readings("hyperbolic_form", "gc nome_c", "10"),
        *readings("hyperbolic_form", "zeta", "34"),
        *LAMBDA,
    ],
    "hyperbolic_state": _by_functions("hyperbolic_form"),
    "steady": [
        *facts("steady", "omega axis1 axis2 axis3 theta"),
        *readings("steady", "cos_half_theta sin_half_theta", "3"),
        *facts("steady", "r1 r2 r3 q0 q1 q2 q3"),
    ],
}


def derive(book: Book) -> None:
    """Publish the sequences; an entry that is not proved is refused."""
    for sequence, entries in SEQUENCES.items():
        book.publish(sequence, entries)
