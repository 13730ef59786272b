"""What axes and curves are called, with units: the paper's letters."""

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
