"""Names of quantities that several generated functions share."""

from rigidsym.solution import _partition as partition
from rigidsym.solution._formulas import AXES

INERTIA = tuple(f"c_{x}" for x in AXES)
DIFFERENCES = ("c_ab", "c_ad", "c_bd")
RATES = tuple(f"Omega_{x}" for x in AXES)
ATTITUDE = ("q_0", "q_a", "q_b", "q_d")
SIGNS = partition.SIGNS
NUMBERS = tuple(f"axis_{x}" for x in AXES)
# What the start of a motion hands to the constants of either branch.
AMPLITUDES = tuple(f"A_{x}" for x in AXES)
INITIAL = ("K", *AMPLITUDES, "B_a", "B_d", "k_1", "kc_1", "mu", "psi_0", "s", "c", "d")
STATE = (*ATTITUDE, *RATES)
# e^(i Lambda t) theta_4 and theta_1, and what multiplies them in each component.
PARTS = ("P4_re", "P4_im", "P1_re", "P1_im")
ROWS = tuple(f"row_{x}_{part}" for x in ("0", *AXES) for part in PARTS)
GAINS = tuple(f"gain_{x}" for x in AXES)
