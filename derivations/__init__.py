"""The derivation: one chapter per file, in the paper's order; ledger.json is their sealed result.

Each chapter has a `derive(builder)`.  Those of `FORWARD` compute: from the basis (4) and the
kinetic energy, by the steps of `rigidsym.proof.steps`, to Theorem 1, for any `Setting`.  In the
others a right-hand side is a guess until the kernel has decided it.
"""

FORWARD = (
    "lie_algebra",
    "euler_lax",
    "lie_poisson",
    "conjugacy",
    "kinematics",
    "phi1_integral",
    "winding",
    "lemma1",
    "theorem1",
)

CHAPTERS = (
    "lie_algebra",
    "euler_lax",
    "lie_poisson",
    "conjugacy",
    "kinematics",
    "phi1_integral",
    "winding",
    "attitude",
    "equivalence",
    "regular_form",
    "lemma1",
    "real_axes",
    "theorem1",
    "conditions",
    "theorem1_signs",
    "theorem1_motion",
    "printed",
    "descended_form",
    "landen_step",
    "theta_form",
    "hyperbolic_form",
    "theta_edges",
    "theta_functions",
    "pi_form",
    "fourier_form",
    "periods",
    "edges",
    "addition_form",
    "step_form",
    "kicks",
    "rate_sensitivities",
    "integral_sensitivities",
    "attitude_sensitivities",
    "sensitivity_columns",
    "attitude_columns",
    "steady",
    "regimes",
    "manoeuvres",
    "publish",
    "repairs",
    "mutants",
)
