"""Formulas of the closed-form solution, read from the ledger."""

from rigidsym.solution._formulas import Formula, Solution, load, sealed, sequence

__all__ = ["Formula", "Solution", "load", "sealed", "sequence"]
