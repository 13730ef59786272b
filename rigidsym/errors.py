"""Exceptions of the package, and checks for optional packages.

Exceptions have one-line messages.
"""

from collections.abc import Callable, Iterable
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from importlib import import_module
from importlib.util import find_spec
from numbers import Rational
from types import ModuleType

_LONGEST = 120
# How alike a misspelt name is to the name that is meant, of 1.
_ALIKE = 0.65
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


def unknown(
    field: str, value: object, known: Iterable[object], note: str = "", plain: bool = False
) -> InputError:
    """Create the error for a name that is not one of those known.

    Its message lists these and proposes the nearest.  note: what follows the list.  plain: show a
    text without quotation marks.

    >>> print(unknown("form", "thta", ("theta", "pi", "step")))
    form = 'thta': must be one of: theta, pi, step (did you mean theta?)
    """
    names = [str(name) for name in known]
    shown = value if plain and isinstance(value, str) else written(value, repr)
    near = nearest(value, names)
    listed = map(repr, names) if any("," in name for name in names) else names
    step = f"did you mean {near}?" if near else ""
    return InputError(field, shown, f"must be one of: {', '.join(listed)}{note}", next_step=step)


def nearest(value: object, known: Iterable[str]) -> str:
    """Return the name that is most like a value, or "" if none is like it."""
    from difflib import get_close_matches

    by_folded = {_folded(name): name for name in known}
    text = _folded(str(value)[:_LONGEST])
    # A number is not a misspelt one.
    found = [] if text.isdigit() else get_close_matches(text, by_folded, 1, _ALIKE)
    return by_folded[found[0]] if found else ""


def _folded(name: str) -> str:
    return name.casefold().replace("_", "-").replace(" ", "-")


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
