"""Any number of digits: the derived solution evaluated by mpmath."""

from rigidsym.precise.motion import PrecisionError, PreciseMotion

__all__ = ["PreciseMotion", "PrecisionError"]
