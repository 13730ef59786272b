"""Any number of digits: the derived solution evaluated by mpmath."""

from rigidsym.precise.motion import PreciseMotion

__all__ = ["PreciseMotion"]
