"""What users get to see when something they gave cannot be used."""

from typing import Any


class InputError(ValueError):
    """One line: the field, the value it has, and the rule that the value breaks."""

    def __init__(self, field: str, value: Any, rule: str) -> None:
        super().__init__(f"{field} = {value}: {rule}")
        self.field, self.value, self.rule = field, value, rule
