"""The derived solution as data, read from the ledger: the formulas every number comes from."""

from rigidsym.solution.formulas import (
    Formula,
    Solution,
    ledger_data,
    ledger_text,
    load,
    sealed,
)

__all__ = ["Formula", "Solution", "ledger_data", "ledger_text", "load", "sealed"]
