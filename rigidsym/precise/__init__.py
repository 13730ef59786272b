"""Evaluation of the closed-form solution to any number of digits, by Arb or mpmath."""

from rigidsym.precise._motion import ESTIMATED, METHODS, PreciseMotion

__all__ = ["ESTIMATED", "METHODS", "PreciseMotion"]
