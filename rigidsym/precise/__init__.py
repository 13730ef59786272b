"""Any number of digits: the derived solution in Arb's balls, and by mpmath's numbers."""

from rigidsym.precise.motion import ESTIMATED, METHODS, PreciseMotion

__all__ = ["ESTIMATED", "METHODS", "PreciseMotion"]
