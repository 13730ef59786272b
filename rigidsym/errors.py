"""What users get to see when something cannot be done: always one line."""

from typing import Any

_LONGEST = 120


class InputError(ValueError):
    """One line: the field, the value it has, and the rule that the value breaks."""

    def __init__(self, field: str, value: Any, rule: str) -> None:
        shown = str(value).replace("\n", "\\n")
        if len(shown) > _LONGEST:
            shown = f"{shown[:_LONGEST]}..."
        super().__init__(f"{field} = {shown}: {rule}")
        self.field, self.value, self.rule = field, value, rule

    def __reduce__(self) -> tuple[Any, ...]:
        """It comes back from other processes as what it was."""
        return type(self), (self.field, self.value, self.rule)


class LedgerError(ValueError):
    """The ledger is missing, damaged, or does not prove what it publishes."""


class PrecisionError(ArithmeticError):
    """The digits asked for were not reached."""
