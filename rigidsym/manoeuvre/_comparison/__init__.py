"""Comparison of torque-free motions with quaternion feedback and optimal control.

The paper (section V) calls its natural motions presumably close to those of minimum fuel and good
first guesses of optimisers, and leaves to future work "a comparison with a quaternion feedback
technique": this is that work, on random manoeuvres from rest to rest.
"""

from rigidsym.errors import require

require("comparing manoeuvres", "scipy", "erfa", "ppigrf", "matplotlib")
require("comparing manoeuvres", "casadi", "pandas", extra="optimal")

from rigidsym.manoeuvre._comparison.results import Comparison, compare  # noqa: E402

__all__ = ["Comparison", "compare"]
