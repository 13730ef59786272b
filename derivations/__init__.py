"""The derivation: one chapter per file, in the paper's order; ledger.json is their sealed result.

Each chapter has a `derive(book)` that states its claims to the kernel, in an order in which every
claim rests on what stands before it.
"""

CHAPTERS = (
    "lie_algebra",
    "euler_lax",
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
    "printed",
    "descended_form",
    "landen_step",
    "theta_form",
    "hyperbolic_form",
    "theta_edges",
    "periods",
    "edges",
    "steady",
    "regimes",
    "manoeuvres",
    "publish",
    "repairs",
    "mutants",
)
