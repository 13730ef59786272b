"""Exceptions of the package, and checks for optional packages.

Exceptions have one-line messages.
"""

from collections.abc import Callable
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from importlib import import_module
from importlib.util import find_spec
from numbers import Rational
from types import ModuleType

_LONGEST = 120
_SHORT = Context(prec=12, Emax=MAX_EMAX, Emin=MIN_EMIN)


def written(value: object, write: Callable[[object], str] = str) -> str:
    """Convert a value to text, even an integer too long for Python's `str`."""
    try:
        return write(value)
    except ValueError:  # int to str stops at 4300 digits
        if not isinstance(value, Rational):
            return f"{type(value).__name__} with a number of more than 4300 digits"
        parts = (Decimal(int(part)) for part in (value.numerator, value.denominator))
        return str(_SHORT.normalize(_SHORT.divide(*parts)))


class InputError(ValueError):
    """Error for invalid user input.

    The message has the field, its value, the rule and the next step.  All parameters are attributes
    of the error.

    Parameters
    ----------
    field : str
        The name of the argument, with the index of the number that is refused.
    value : object
        Its value.
    rule : str
        The rule that the value breaks.
    body, time : int, optional
        The number of the body in a batch, counted through all leading axes, and of its time.
    next_step : str, optional
        How to have the value accepted.
    """

    def __init__(
        self,
        field: str,
        value: object,
        rule: str,
        body: int | None = None,
        time: int | None = None,
        next_step: str = "",
    ) -> None:
        shown = written(value).replace("\n", "\\n")
        if len(shown) > _LONGEST:
            shown = f"{shown[:_LONGEST]}..."
        super().__init__(f"{field} = {shown}: {rule}{next_step and f' ({next_step})'}")
        self.field, self.value, self.rule = field, value, rule
        self.body, self.time, self.next_step = body, time, next_step

    def __reduce__(self) -> "tuple[type[InputError], tuple[object, ...]]":
        """Return the arguments, so that the error can be pickled."""
        given = self.field, self.value, self.rule, self.body, self.time, self.next_step
        return type(self), given


class EngineError(ValueError):
    """Error for an array that an engine refuses.

    It has the array's field and the rule that the array breaks.  body, time: the numbers of the
    first body and time that do.  Engines do not have the values as users gave them: the public
    functions add these, and raise InputError.
    """

    def __init__(
        self, field: str, rule: str, body: int | None = None, time: int | None = None
    ) -> None:
        super().__init__(f"{field}: {rule}")
        self.field, self.rule, self.body, self.time = field, rule, body, time

    def __reduce__(self) -> "tuple[type[EngineError], tuple[object, ...]]":
        """Return the arguments, so that the error can be pickled."""
        return type(self), (self.field, self.rule, self.body, self.time)


class LedgerError(ValueError):
    """Error for a ledger of proofs that is missing, damaged or incomplete.

    An incomplete ledger does not prove what it publishes.
    """


class PrecisionError(ArithmeticError):
    """Error for a computation that did not reach the requested precision."""


def package(name: str, user: str, extra: str = "lab") -> ModuleType:
    """Import an optional package.

    Raises an ImportError with a one-line message if it is not installed.
    """
    try:
        return import_module(name)
    except ImportError:
        raise _missing(user, [name.partition(".")[0]], extra) from None


def require(user: str, *names: str, extra: str = "app") -> None:
    """Raise an ImportError that names the optional packages that are not installed.

    Its message has one line.  It looks for them and does not import them, which takes long for
    some.
    """
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        raise _missing(user, missing, extra)


def _missing(user: str, names: list[str], extra: str) -> ImportError:
    needed = ", ".join(names)
    message = f"{user} needs {needed} (extra {extra}): pip install 'rigidsym[{extra}]'"
    return ImportError(message, name=names[0])
