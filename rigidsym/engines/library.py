"""The compiled functions of torque_free.h, as ctypes calls them."""

import ctypes
import re
from collections.abc import Callable, Mapping
from ctypes import c_char_p, c_double, c_int, c_size_t, c_void_p
from dataclasses import dataclass
from pathlib import Path, PurePath

_Type = type[c_char_p | c_double | c_int | c_size_t | c_void_p]
_BODY = (c_void_p,) * 3
_OUT = (c_void_p,) * 2
_ARITHMETIC = 8
# Of the theta form alone.
_SENSITIVITY = "states_with_sensitivity", (c_void_p, c_size_t, *(c_void_p,) * 7)
# Name after the prefix, result, arguments.
_SIGNATURES: dict[str, tuple[_Type, tuple[_Type, ...]]] = {
    "digest": (c_char_p, ()),
    "message": (c_char_p, (c_int,)),
    "motion_size": (c_size_t, ()),
    "motion_init": (c_int, (c_void_p, *_BODY)),
    "motion_init_double_doubles": (c_int, (c_void_p, *_BODY, *(c_void_p,) * 2, c_double)),
    "state_at": (c_int, (c_void_p, c_double, *_OUT)),
    "states_at": (c_int, (c_void_p, c_size_t, c_void_p, *_OUT)),
    "states_on_grid": (c_int, (c_void_p, c_double, c_double, c_size_t, c_size_t, *_OUT)),
    "propagate": (
        c_int,
        (c_size_t, *_BODY, c_size_t, c_void_p, c_size_t, *_OUT, c_void_p, c_void_p),
    ),
    "last_time": (c_double, (c_void_p,)),
}


class LibraryError(Exception):
    """A file that is not the library it should be."""


@dataclass(frozen=True, slots=True)
class Library:
    """The functions of torque_free.h; pointers are addresses or ctypes arrays."""

    digest: Callable[..., bytes]
    message: Callable[..., bytes]
    motion_size: Callable[..., int]
    motion_init: Callable[..., int]
    motion_init_double_doubles: Callable[..., int]
    state_at: Callable[..., int]
    states_at: Callable[..., int]
    states_on_grid: Callable[..., int]
    propagate: Callable[..., int]
    last_time: Callable[..., float]
    states_with_sensitivity: Callable[..., int] | None


def load(path: Path, sources: Mapping[str, str]) -> Library:
    """The library in a file; raises LibraryError where it was not built from the sources."""
    try:
        functions = _functions(ctypes.CDLL(str(path)), _prefix(sources))
    except (OSError, AttributeError) as error:
        raise LibraryError(f"{path} cannot be loaded ({_reason(error, path)})") from None
    expected = written_digest(sources)
    if expected and functions.digest().decode("ascii", "replace") != expected:
        raise LibraryError(f"{path} was built from other sources")
    return functions


def check_arithmetic(library: Library) -> None:
    """Raise LibraryError where no prepared will be made: options in $CC can do that."""
    prepared = (c_double * -(-library.motion_size() // ctypes.sizeof(c_double)))()
    one = (c_double * 4)(1.0, 1.0, 1.0, 1.0)
    if library.motion_init(prepared, one, one, one) == _ARITHMETIC:
        raise LibraryError(f"the C module refuses: {library.message(_ARITHMETIC).decode()}")


def written_digest(sources: Mapping[str, str]) -> str | None:
    """The digest that the comment of the sources names, if one does."""
    text = "\n".join(sources.values())
    found = re.search(r"^\W*digest ([0-9a-f]{64})\b", text, re.MULTILINE)
    return found[1] if found else None


def _prefix(sources: Mapping[str, str]) -> str:
    """What names begin with: a module's own, as its header's does."""
    return next(PurePath(name).stem for name in sources if name.endswith(".h"))


def _functions(shared: ctypes.CDLL, prefix: str) -> Library:
    functions = {name: getattr(shared, f"{prefix}_{name}") for name in _SIGNATURES}
    for name, (result, arguments) in _SIGNATURES.items():
        functions[name].restype, functions[name].argtypes = result, arguments
    name, arguments = _SENSITIVITY
    more = getattr(shared, f"{prefix}_{name}", None)
    if more is not None:
        more.restype, more.argtypes = c_int, arguments
    return Library(**functions, states_with_sensitivity=more)


def _reason(error: Exception, path: Path) -> str:
    return " ".join(str(error).removeprefix(f"{path}: ").split())
