"""What the number wing may use: programmes of proved formulas, in order of evaluation.

`plan` turns inertia, rates and attitude at t = 0 into constants of the motion, `state` turns the
constants and a time into rates and attitude, `steady` serves the motions with constant rates.
`theta` adds the constants of the theta form, `theta_state` is a state by it, and `pull_back` finds
the constant unit quaternion in front from one attitude.  `circular` and `circular_state` do the
same with every theta as a function of its own, `hyperbolic` and `hyperbolic_state` in the
complementary nome; `rates` go with either.  `shift`, `landen` and `scaling` lead to all of them
without cancellation.
An entry `context:name:equation` stands for the reading of a name: a standard function of known
quantities, used where the paper's equation does.
"""

from rigidsym.algebra import Book

INVARIANTS = "regular.H regular.E_a regular.E_b regular.E_d attitude.M_a attitude.M_b attitude.M_d"
MOMENTA = "attitude.M_a attitude.M_b attitude.M_d"
SHORTEST = "attitude.nu attitude.s_0 attitude.s_b attitude.s_d"
PARTICULAR = "attitude.qbar_0 attitude.qbar_a attitude.qbar_b attitude.qbar_d"
FUNCTIONS = ("T4_re", "T4_im", "T1_re", "T1_im", "X_re", "X_im")
NUMERATORS = " ".join(f"theta_form.P{k}_{part}" for k in (4, 1) for part in ("re", "im"))
ATTITUDE = " ".join(
    [*(f"theta_form.qbar_{x}" for x in "0abd"), *(f"attitude.q_{x}" for x in "0abd")]
)


def _by_functions(context: str) -> str:
    """A state by the functions that the readings of a context name."""
    functions = " ".join(f"{context}:{name}:18" for name in FUNCTIONS)
    return f"""
        descended.u_1 {functions} {NUMERATORS} {context}:W:1 theta_form.N_of_W {ATTITUDE}
    """


PROGRAMMES = {
    "plan": f"""
        {INVARIANTS} attitude.K
        regular.A_a regular.A_b regular.A_d regular.lambda_ regular.m regular.m_1 regular.tau
        descended.k_c descended.k_1 descended.m_c descended.mu
        descended.n descended.psi_0 descended.kappa
        regular.sn regular.cn regular.dn
        descended:u:12 descended.u_1_of_u descended.phase descended:J_0:36
        {SHORTEST} {PARTICULAR} attitude.p_0 attitude.p_a attitude.p_b attitude.p_d
    """,
    "state": f"""
        descended.u_1 descended:s:10 descended:c:10 descended:d:10
        descended.sn descended.cn descended.dn
        regular.Omega_a regular.Omega_b regular.Omega_d {MOMENTA} {SHORTEST}
        descended:J:36 descended.psi attitude:cos_half_psi:18 attitude:sin_half_psi:18 {PARTICULAR}
        attitude.q_0 attitude.q_a attitude.q_b attitude.q_d
    """,
    "theta": """
        theta_form.root_k theta_form.B_a theta_form.B_d theta_form.x theta_form.y theta_form.z
        theta_form:beta:28 theta_form:g:10 theta_form:nome_1:10 theta_form:zeta:34
        theta_form.Lambda
    """,
    "pull_back": "attitude.p_0 attitude.p_a attitude.p_b attitude.p_d",
    "theta_state": """
        descended.u_1 descended:s:10 descended:c:10 descended:d:10
        theta_form.SN_re theta_form.SN_im theta_form:T4_re:18 theta_form:T4_im:18
        theta_form.T1_re theta_form.T1_im theta_form:X_re:18 theta_form:X_im:18
        theta_form.P4_re theta_form.P4_im theta_form.P1_re theta_form.P1_im theta_form.N
        theta_form.qbar_0 theta_form.qbar_a theta_form.qbar_b theta_form.qbar_d
        attitude.M_a_of_attitude attitude.M_b_of_attitude attitude.M_d_of_attitude
        attitude.Omega_a attitude.Omega_b attitude.Omega_d
        attitude.q_0 attitude.q_a attitude.q_b attitude.q_d
    """,
    "shift": """
        theta_form.root_k theta_form.x theta_form.y theta_form.z
        theta_form.s_beta theta_form.c_beta theta_form.d_beta
    """,
    "scaling": """
        scaling.root_r scaling.Q scaling.Y scaling.root_h scaling.h_plus scaling.h_minus
    """,
    "landen": """
        landen.k_next landen.root_kc landen.kc_next landen.s_next landen.v landen.c_next
        landen.d_next landen.r_next landen.S landen.Y_next landen.K
    """,
    "rates": """
        regular:sn:10 regular:cn:10 regular:dn:10 regular.Omega_a regular.Omega_b regular.Omega_d
    """,
    "circular": """
        theta_form:g:10 theta_form:nome_1:10 theta_form:nome_m:10 theta_form:zeta:34
        theta_form.Lambda
    """,
    "circular_state": _by_functions("theta_form"),
    "hyperbolic": """
        hyperbolic_form:gc:10 hyperbolic_form:nome_c:10 hyperbolic_form:zeta:34 theta_form.Lambda
    """,
    "hyperbolic_state": _by_functions("hyperbolic_form"),
    "steady": """
        steady.omega steady.axis1 steady.axis2 steady.axis3 steady.theta
        steady:cos_half_theta:3 steady:sin_half_theta:3 steady.r1 steady.r2 steady.r3
        steady.q0 steady.q1 steady.q2 steady.q3
    """,
}


def derive(book: Book) -> None:
    """Publish the programmes; the kernel refuses entries that are not proved."""
    for name, entries in PROGRAMMES.items():
        book.publish(name, entries.split())
