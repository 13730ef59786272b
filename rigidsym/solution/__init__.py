"""The derived solution as data, read from the ledger: the formulas every number comes from."""

from rigidsym.solution._formulas import Formula, Solution, load, sealed, sequence

__all__ = ["Formula", "Solution", "load", "sealed", "sequence"]
