"""The derived solution to any number of digits, in Arb's balls and mpmath's numbers."""

from rigidsym.precise._motion import ESTIMATED, METHODS, PreciseMotion

__all__ = ["ESTIMATED", "METHODS", "PreciseMotion"]
