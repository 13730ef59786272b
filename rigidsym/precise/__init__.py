"""Any number of digits: the derived solution in Arb's balls."""

from rigidsym.precise.motion import METHODS, PreciseMotion

__all__ = ["METHODS", "PreciseMotion"]
