"""Published formulas: sequences for the number half, in order of evaluation.

`constants` turns inertia, rates and attitude at t = 0 into constants of the motion, `state` turns
them and a time into rates and attitude, `steady` serves the motions with constant rates.
`theta` adds the constants of the theta form, `theta_state` is a state by it, and `pull_back` finds
the constant unit quaternion in front from one attitude.  `circular` and `circular_state` do the
same with every theta as a function of its own, `hyperbolic` and `hyperbolic_state` in the
complementary nome; `rates` go with either.  `shift`, `landen` and `scaling` lead to all of them
without cancellation.  `pi_circular` and `pi_hyperbolic` are psi by an integral of the third kind,
far from the separatrix and near it, and `ascent` goes back up the steps of `landen`.
`fourier` are coefficients of Fourier series, `fourier_rest` those of psi/2.
`step` has the constants of a step from any state, `projection`, `doubling` and `second_half` double
a time, `thirds` are psi after the shortest, and `step_rates` the rates after all; `kick` is what a
direction in space exerts.
`periods` are what comes back and how far the attitude has turned by then, `momentum` the rates that
an attitude shows.  `sine` and `sine_state` are one rate by Lemma 1, `theorem1` and `theorem1_state`
the paper's attitude from a rate that is a sine, and `turned` puts the constant quaternion in front.
`moments`, `columns` and `sensitivity` are what the rates change by with each input, `middle` those
of the middle rate where the spin is about it, `passing` what rates change by once the motion has
turned over, `excesses` what the integrals of their squares have, `spun` that of the middle rate
near a spin about its axis,
`elapsed_F` and `elapsed_E` one integral of the elapsed time by the other, `turn_constants` and
`turn` what the attitude changes by.
An entry is a proved fact, the definition of a name in its context, or the reading of a name: a
standard function of known quantities.  The last two say which equations they are used in.
"""

from collections.abc import Iterable

from derivations import attitude_columns, kicks, sensitivity_columns
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._builder import Entry, definitions, facts, readings

DIFFERENCES = definitions("regular", "c_ab c_ad c_bd", 10, 13, 14)
MOMENTA = definitions("attitude", "M_a M_b M_d", 8)
INVARIANTS = [*facts("regular", "H E_a E_b E_d"), *MOMENTA]
SHORTEST = [
    *facts("attitude", "nu"),
    *definitions("attitude", "s_0", 27),
    *definitions("attitude", "s_b s_d", 28),
]
PARTICULAR = definitions("attitude", "qbar_0 qbar_a qbar_b qbar_d", 18, 25)
PULL_BACK = facts("attitude", "p_0 p_a p_b p_d")
QUATERNION = definitions("attitude", "q_0 q_a q_b q_d", 37)
SIGN = definitions("regular", "tau", 16, 17)
RATES = definitions("regular", "Omega_a Omega_b Omega_d", 10)
ARGUMENT = definitions("descended", "u_1", 20, 21)
LANDEN_RATES = readings("descended", "s c d", 10)
SHIFT = definitions("theta_form", "x", 28)
NUMERATORS = definitions("theta_form", "P4_re P4_im P1_re P1_im", 18)
BY_THETAS = facts("theta_form", "qbar_0 qbar_a qbar_b qbar_d")
MOMENTUM = [
    *facts("attitude", "M_a_of_attitude M_b_of_attitude M_d_of_attitude"),
    *facts("attitude", "Omega_a Omega_b Omega_d"),
]
LAMBDA = definitions("theta_form", "Lambda", 33, 34)


def _by_functions(context: str) -> list[Entry]:
    """Return a state by the functions that a context reads."""
    return [
        *ARGUMENT,
        *readings(context, "T4_re T4_im T1_re T1_im X_re X_im", 18),
        *NUMERATORS,
        *readings(context, "W", 1),
        *facts("theta_form", "N_of_W"),
        *BY_THETAS,
        *QUATERNION,
    ]


def _all(context: str, names: Iterable[object], *source: int | str) -> list[Entry]:
    """Return the definitions of some names in their order."""
    return definitions(context, " ".join(map(str, names)), *source)


SEQUENCES: dict[str, list[Entry]] = {
    "constants": [
        *DIFFERENCES,
        *INVARIANTS,
        *facts("attitude", "K"),
        *facts("regular", "A_a A_b A_d lambda_ m m_1"),
        *SIGN,
        *facts("descended", "k_c k_1 m_c mu n psi_0 kappa"),
        *facts("regular", "sn cn dn"),
        *readings("descended", "u", 12),
        *facts("descended", "u_1_of_u phase"),
        *readings("descended", "J_0", 36),
        *SHORTEST,
        *PARTICULAR,
        *PULL_BACK,
    ],
    "state": [
        *ARGUMENT,
        *LANDEN_RATES,
        *definitions("descended", "sn", "DLMF 22.7.2"),
        *definitions("descended", "cn", "DLMF 22.7.3"),
        *facts("descended", "dn"),
        *RATES,
        *MOMENTA,
        *SHORTEST,
        *readings("descended", "J", 36),
        *definitions("descended", "psi", 33, 34),
        *readings("attitude", "cos_half_psi sin_half_psi", 18),
        *PARTICULAR,
        *QUATERNION,
    ],
    "theta": [
        *facts("theta_form", "root_k B_a B_d"),
        *SHIFT,
        *facts("theta_form", "y z"),
        *readings("theta_form", "beta", 28),
        *readings("theta_form", "g nome_1", 10),
        *readings("theta_form", "zeta", 34),
        *LAMBDA,
    ],
    "pull_back": PULL_BACK,
    "theta_state": [
        *ARGUMENT,
        *LANDEN_RATES,
        *definitions("theta_form", "SN_re SN_im", "DLMF 22.8.1"),
        *readings("theta_form", "T4_re T4_im", 18),
        *definitions("theta_form", "T1_re T1_im", "DLMF 22.2.4"),
        *readings("theta_form", "X_re X_im", 18),
        *NUMERATORS,
        *facts("theta_form", "N"),
        *BY_THETAS,
        *MOMENTUM,
        *QUATERNION,
    ],
    "shift": [
        *facts("theta_form", "root_k"),
        *SHIFT,
        *facts("theta_form", "y z"),
        *definitions("theta_form", "s_beta c_beta d_beta", "DLMF 22.6.1"),
    ],
    "scaling": [
        *facts("scaling", "root_r Q"),
        *definitions("scaling", "Y", 28),
        *facts("scaling", "root_h h_plus h_minus"),
    ],
    "landen": [
        *facts("landen", "k_next root_kc"),
        *definitions("landen", "kc_next", "DLMF 22.7.1"),
        *facts("landen", "s_next v c_next d_next r_next S Y_next"),
        *definitions("landen", "K", "DLMF 19.8.12"),
    ],
    "rates": [*readings("regular", "sn cn dn", 10), *RATES],
    "circular": [
        *readings("theta_form", "g nome_1 nome_m", 10),
        *readings("theta_form", "zeta", 34),
        *LAMBDA,
    ],
    "circular_state": _by_functions("theta_form"),
    "hyperbolic": [
        *readings("hyperbolic_form", "gc nome_c", 10),
        *readings("hyperbolic_form", "zeta", 34),
        *LAMBDA,
    ],
    "hyperbolic_state": _by_functions("hyperbolic_form"),
    "ascent": definitions("landen", "s c d inside x", "DLMF 22.7.2"),
    "pi_circular": [
        *definitions("pi_form", "Lambda", 33, 34),
        *definitions("pi_form", "rest rest_0", 36),
    ],
    "pi_hyperbolic": [
        *definitions("pi_near", "delta n_2 Lambda g g_1 g_2 h_2 slope alpha", 36),
        *facts("pi_near", "T_size"),
        *definitions("arctangent", "T_re T_im", 36),
        *definitions("pi_near", "cos_half_psi sin_half_psi", 18),
    ],
    "step": [
        *definitions("step", "c_ab c_ad c_bd alpha_a alpha_b alpha_d l_a l_b l_d", 10),
        *facts("step", "M_a0 M_b0 M_d0 K h e_1"),
        *definitions("step", "e_2", 10),
        *definitions("step", "H_0", 6),
        *definitions("step", "psi_0", 33, 34),
        *definitions("step", "z_re z_im", 27),
        *facts("step", "zr_re zr_im"),
    ],
    "doubling": definitions("doubling", "inside X_next Y_next", 10),
    "projection": definitions(
        "turn", "nu_re nu_im rate_re rate_im G_re G_im square F_re F_im w_re w_im", 27, 36
    ),
    "thirds": [
        *definitions("thirds", "square", 36),
        *facts("thirds", "R N"),
        *definitions("thirds", "U_re U_im P_re P_im cos_half_psi sin_half_psi", 33, 34),
    ],
    "second_half": [
        *definitions("second_half", "square", 36),
        *facts("second_half", "R"),
        *definitions("second_half", "V_re V_im", 33, 34),
    ],
    "step_rates": [
        *definitions("step", "f g", 10),
        *facts("step", "room Omega_a Omega_b Omega_d"),
    ],
    "kick": _all("kick", (*kicks.SEEN, *kicks.EXERTED), 3),
    "steady": [
        *facts("steady", "omega"),
        *definitions("steady", "axis1 axis2 axis3 theta", 3),
        *readings("steady", "cos_half_theta sin_half_theta", 3),
        *definitions("steady", "r1 r2 r3 q0 q1 q2 q3", 37),
    ],
    "moments": _all("coefficients", sensitivity_columns.MOMENTS, 5),
    "columns": _all("varied_rates", sensitivity_columns.CONSTANTS, 5),
    "sensitivity": _all("varied_rates", sensitivity_columns.AT_TIME, 5),
    "excesses": definitions("excesses", "excess_a excess_d", 5),
    "middle": _all("middle_columns", sensitivity_columns.MIDDLE, 5),
    "passing": _all("passing", sensitivity_columns.PASSING, 5),
    "spun": _all("spun", sensitivity_columns.SPUN, 5),
    "elapsed_F": definitions("elapsed_F", "F_t", 10),
    "elapsed_E": definitions("elapsed_E", "E_t", 10),
    "turn_constants": _all("turned_columns_start", attitude_columns.START, 3),
    "turn": _all("turned_columns", attitude_columns.AT_TIME, 3),
    "momentum": MOMENTUM,
    "turned": QUATERNION,
}
# Forms for readers, and for oracles that have no other use of them: no flown number rests on these.
FORMS: dict[str, list[Entry]] = {
    "periods": [
        *readings("period", "K_1 J_c", 36),
        *definitions("period", "period psi_mean", 10, 34),
        *readings("period", "turn", 10),
        *definitions("period", "Omega_mean", 10),
    ],
    "fourier": definitions("fourier_terms", "a", "DLMF 20.5.13", "DLMF 22.11"),
    "fourier_rest": definitions("fourier_phase", "e a rest_k", 33, 34),
    "turned_body": definitions(
        "turned_attitude", "M1 M2 M3 dM1 dM2 dM3 xi1 xi2 xi3 dq0 dq1 dq2 dq3", 3
    ),
    "fourth_powers": definitions("fourth_powers", "U_t V_t W_t", 10),
    "elapsed_slopes": definitions(
        "varied_integrals", "S_k C_k D_k E_k F_k S_r C_r D_r E_r F_r", 10
    ),
    "sine": [
        *definitions("one_rate", "H K_squared", 6, 15),
        *definitions("one_rate", "alpha root_j root_k", 13, 14),
        *readings("one_rate", "zeta xi", 10, "Remark 1"),
        *definitions("one_rate", "mu", 10),
        *readings("one_rate", "C_i", 12),
    ],
    "sine_state": [
        *readings("one_rate", "sn", 10),
        *facts("one_rate", "Omega_i"),
    ],
    "theorem1": [
        *definitions("theorem1_motion", "M1 M2 M3", 8),
        *facts("theorem1_motion", "K"),
        *definitions("theorem1_motion", "H", 6),
        *definitions("theorem1_motion", "n kappa", 19, 36),
        *readings("theorem1_motion", "Pi_0", 36),
    ],
    "theorem1_state": [
        *readings("theorem1_motion", "Pi", 36),
        *definitions("theorem1_motion", "phi1", 19),
        *readings("theorem1_motion", "cos_half_phi1 sin_half_phi1", 18),
        *definitions("theorem1_motion", "x y", 27, 29),
        *facts("theorem1_motion", "F1 F2 root_y"),
        *definitions("theorem1_motion", "y_star", 19, "Remark 2"),
        *facts("theorem1_motion", "root_star F3 F4"),
        *definitions("theorem1_motion", "qbar_0 qbar_1 qbar_2 qbar_3", 18),
    ],
}


def derive(builder: LedgerBuilder) -> None:
    """Publish the sequences; refuse an entry that is neither proved nor in a context."""
    for group, sequences in {"sequences": SEQUENCES, "forms": FORMS}.items():
        for name, entries in sequences.items():
            builder.publish(name, entries, group)
