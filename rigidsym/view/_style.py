"""Colours and labels of all plots and pictures.

Colours of data are visible on light and on dark ground, and distinct for colour-blind readers
(after Okabe and Ito).  Labels use the paper's letters, with units.
"""

BLUE, ORANGE, GREEN, RED, VIOLET = "#1f83c4", "#e0682a", "#139a6f", "#d62f5f", "#7a5cc4"
GOLD, MAGENTA = "#b58a00", "#c0399f"
GREY, GRID, FAINT, OPEN = "#808080", "#a6a6a6", "rgba(128,128,128,0.25)", "#7f8c9b"

AXES = (BLUE, ORANGE, GREEN)
"The axes 1, 2, 3, and components along them."
SCALAR = GREY
"The scalar part of a quaternion, beside the axes."
SIDES = (BLUE, "#7fb8de", ORANGE, "#f0b28f", GREEN, "#86c9b2")
"The two ends of each axis of a body."
CONE, MARK = "#c9a227", RED
"A set of allowed directions, and a highlighted point."
ELLIPSOID = "#8fa3b8"
TRANSFERS = (RED, BLUE, GREEN, ORANGE, VIOLET)
"Several transfers; the colours repeat where there are more."
DISTURBANCES = {
    "drag": BLUE,
    "gravity_gradient": GREEN,
    "radiation": GOLD,
    "dipole": MAGENTA,
}
GOOD, FAIR, BAD = "#0a9e73", "#d29a00", "#e0552b"
"Verdicts."
SERIES = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#806000")
"Curves of a report, on white."
SERIES_ON_DARK = ("#56b4e9", "#f0894a", "#2cc295", "#e6a3c7", "#d9b84a")
"The same hues on a dark ground."

_BELOW = "₀₁₂₃"
RATES = tuple(f"Ω{k}" for k in _BELOW[1:])
ATTITUDE = tuple(f"q{k}" for k in _BELOW)
MOMENTUM = tuple(f"M{k}" for k in _BELOW[1:])
TORQUE = tuple(f"N{k}" for k in _BELOW[1:])

TIME_AXIS = "t (s)"
RATES_AXIS = "body rates Ω (rad/s)"
ATTITUDE_AXIS = "attitude q, body to inertial"
MOMENTUM_AXES = tuple(f"{name} (kg m²/s)" for name in MOMENTUM)
DIRECTION_AXES = tuple(f"{name}/|M|" for name in MOMENTUM)
SPACE_RATES_AXES = tuple(f"Ω in space, {k} (rad/s)" for k in "xyz")
