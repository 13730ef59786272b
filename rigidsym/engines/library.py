"""The compiled functions of torque_free.h, as ctypes calls them."""

import ctypes
import re
from collections.abc import Callable, Mapping
from ctypes import c_char_p, c_double, c_int, c_size_t, c_void_p
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Any, TypeAlias

_Type = type[c_char_p | c_double | c_int | c_size_t | c_void_p]
_BODY = (c_void_p,) * 3
_OUT = (c_void_p,) * 2
_ARITHMETIC, _STEP_ARITHMETIC = 8, 6
_CHANGES = (c_void_p,) * 4
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
# Of the theta form alone.
_SENSITIVITIES: dict[str, tuple[_Type, tuple[_Type, ...]]] = {
    "states_with_sensitivity": (c_int, (c_void_p, c_size_t, c_void_p, *_OUT, *_CHANGES)),
    "propagate_with_sensitivity": (
        c_int,
        (c_size_t, *_BODY, c_size_t, c_void_p, c_size_t, *_OUT, *_CHANGES, c_void_p, c_void_p),
    ),
}
_STEPS: dict[str, tuple[_Type, tuple[_Type, ...]]] = {
    "step_digest": (c_char_p, ()),
    "step_message": (c_char_p, (c_int,)),
    "body_size": (c_size_t, ()),
    "body_init": (c_int, (c_void_p, c_void_p)),
    "step": (c_int, (c_void_p, *_OUT, c_double)),
    "steps": (
        c_int,
        (c_size_t, c_void_p, c_size_t, *_BODY, c_size_t, *_OUT, c_void_p),
    ),
    "integrate": (
        c_int,
        (
            *(c_size_t, c_void_p, c_size_t, c_void_p, c_void_p),
            *(c_double, c_double, c_size_t, c_size_t, *_OUT, c_void_p),
        ),
    ),
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
    states_with_sensitivity: Callable[..., int] | None = None
    propagate_with_sensitivity: Callable[..., int] | None = None


@dataclass(frozen=True, slots=True)
class StepLibrary:
    """The functions of torque_free_step.h; pointers are addresses or ctypes arrays."""

    digest: Callable[..., bytes]
    message: Callable[..., bytes]
    body_size: Callable[..., int]
    body_init: Callable[..., int]
    step: Callable[..., int]
    steps: Callable[..., int]
    integrate: Callable[..., int]


AnyLibrary: TypeAlias = Library | StepLibrary


def load(path: Path, sources: Mapping[str, str]) -> AnyLibrary:
    """The library in a file; raises LibraryError where it was not built from the sources."""
    makes_steps = "torque_free_step.h" in sources
    try:
        shared = ctypes.CDLL(str(path))
        functions = _step_functions(shared) if makes_steps else _functions(shared, _prefix(sources))
    except (OSError, AttributeError) as error:
        raise LibraryError(f"{path} cannot be loaded ({_reason(error, path)})") from None
    expected = written_digest(sources)
    if expected and functions.digest().decode("ascii", "replace") != expected:
        raise LibraryError(f"{path} was built from other sources")
    return functions


def check_arithmetic(library: AnyLibrary) -> None:
    """Raise LibraryError where none will be prepared: options in $CC can do that."""
    one = (c_double * 4)(1.0, 1.0, 1.0, 1.0)
    if isinstance(library, Library):
        code, refused = (
            library.motion_init(_room(library.motion_size()), one, one, one),
            _ARITHMETIC,
        )
    else:
        code, refused = library.body_init(_room(library.body_size()), one), _STEP_ARITHMETIC
    if code == refused:
        raise LibraryError(f"the C module refuses: {library.message(refused).decode()}")


def _room(size: int) -> ctypes.Array[c_double]:
    return (c_double * -(-size // ctypes.sizeof(c_double)))()


def written_digest(sources: Mapping[str, str]) -> str | None:
    """The digest that the comment of the sources names, if one does."""
    text = "\n".join(sources.values())
    found = re.search(r"^\W*digest ([0-9a-f]{64})\b", text, re.MULTILINE)
    return found[1] if found else None


def _prefix(sources: Mapping[str, str]) -> str:
    """What names begin with: a module's own, as its header's does."""
    return next(PurePath(name).stem for name in sources if name.endswith(".h"))


def _functions(shared: ctypes.CDLL, prefix: str) -> Library:
    declared = _declared(shared, prefix, _SIGNATURES)
    if hasattr(shared, f"{prefix}_{next(iter(_SENSITIVITIES))}"):
        declared |= _declared(shared, prefix, _SENSITIVITIES)
    return Library(**declared)


def _step_functions(shared: ctypes.CDLL) -> StepLibrary:
    declared = _declared(shared, "torque_free", _STEPS).items()
    return StepLibrary(**{name.removeprefix("step_"): value for name, value in declared})


def _declared(
    shared: ctypes.CDLL, prefix: str, signatures: Mapping[str, tuple[_Type, tuple[_Type, ...]]]
) -> dict[str, Any]:
    functions = {name: getattr(shared, f"{prefix}_{name}") for name in signatures}
    for name, (result, arguments) in signatures.items():
        functions[name].restype, functions[name].argtypes = result, arguments
    return functions


def _reason(error: Exception, path: Path) -> str:
    return " ".join(str(error).removeprefix(f"{path}: ").split())
