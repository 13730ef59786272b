"""What users get to see when something cannot be done: always one line."""

from collections.abc import Callable
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from importlib import import_module
from importlib.util import find_spec
from numbers import Rational
from types import ModuleType

_LONGEST = 120
_SHORT = Context(prec=12, Emax=MAX_EMAX, Emin=MIN_EMIN)


def written(value: object, write: Callable[[object], str] = str) -> str:
    """A value as text, by a dozen digits where Python would not write a number that long."""
    try:
        return write(value)
    except ValueError:  # int to str stops at 4300 digits
        if not isinstance(value, Rational):
            return f"{type(value).__name__} with a number of more than 4300 digits"
        parts = (Decimal(int(part)) for part in (value.numerator, value.denominator))
        return str(_SHORT.normalize(_SHORT.divide(*parts)))


class InputError(ValueError):
    """One line: the field, the value it has, and the rule that the value breaks."""

    def __init__(self, field: str, value: object, rule: str) -> None:
        shown = written(value).replace("\n", "\\n")
        if len(shown) > _LONGEST:
            shown = f"{shown[:_LONGEST]}..."
        super().__init__(f"{field} = {shown}: {rule}")
        self.field, self.value, self.rule = field, value, rule

    def __reduce__(self) -> "tuple[type[InputError], tuple[str, object, str]]":
        """It comes back from other processes as what it was."""
        return type(self), (self.field, self.value, self.rule)


class LedgerError(ValueError):
    """The ledger is missing, damaged, or does not prove what it publishes."""


class PrecisionError(ArithmeticError):
    """The digits asked for were not reached."""


def package(name: str, user: str, extra: str = "lab") -> ModuleType:
    """A module of an extra by its name; raises ImportError, in one line, without it."""
    try:
        return import_module(name)
    except ImportError:
        raise _missing(user, [name.partition(".")[0]], extra) from None


def require(user: str, *names: str, extra: str = "app") -> None:
    """Raise ImportError, in one line, for the packages of these names that are not installed.

    They are looked for and not imported: some take long.
    """
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        raise _missing(user, missing, extra)


def _missing(user: str, names: list[str], extra: str) -> ImportError:
    needed = ", ".join(names)
    message = f"{user} needs {needed} (extra {extra}): pip install 'rigidsym[{extra}]'"
    return ImportError(message, name=names[0])
