"""What users get to see when something cannot be done: always one line."""

from typing import Any


class InputError(ValueError):
    """One line: the field, the value it has, and the rule that the value breaks."""

    def __init__(self, field: str, value: Any, rule: str) -> None:
        super().__init__(f"{field} = {value}: {rule}")
        self.field, self.value, self.rule = field, value, rule


class LedgerError(ValueError):
    """The ledger is missing, damaged, or does not prove what it publishes."""


class PrecisionError(ArithmeticError):
    """The digits asked for were not reached."""
