"""The derived solution as data, read from the ledger: the formulas every number comes from."""

from rigidsym.solution.formulas import Formula, LedgerError, Solution, ledger_text, load, sealed

__all__ = ["Formula", "LedgerError", "Solution", "ledger_text", "load", "sealed"]
