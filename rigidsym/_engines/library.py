"""Calls of compiled C functions with arguments checked against a header's prototypes."""

import ctypes
import operator
import re
from collections.abc import Callable, Mapping
from ctypes import c_char_p, c_double, c_float, c_int, c_size_t, c_void_p
from dataclasses import dataclass
from math import prod
from pathlib import Path, PurePath
from types import SimpleNamespace
from typing import Any

import numpy as np

_PROTOTYPE = re.compile(r"^(const char \*|[a-z_]+ )(\w+)\(([^(){}]*)\);", re.MULTILINE)
_PARAMETER = re.compile(r"(const )?(\w+) (\*?)(\w+)((?:\[\d+\])*)( OR_NULL)?")
_CONSTANT = re.compile(r"^ +([A-Z_0-9]+) = (\d+)", re.MULTILINE)
_PLAIN = {"double": c_double, "float": c_float, "int": c_int, "size_t": c_size_t}


class LibraryError(Exception):
    """Error for a file that is not a library built from the expected sources."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """Parameter of a C function, as declared in its prototype.

    least: the number of elements that a pointer must have.
    """

    text: str
    name: str
    type: str
    is_pointer: bool
    is_const: bool
    least: int
    may_be_null: bool

    def given(self, value: Any, sizes: Mapping[str, int]) -> Any:
        """Convert a Python value to the ctypes argument of this parameter.

        A pointer is an array of NumPy, contiguous and of this type, or an object of ctypes.  Raises
        TypeError for another type than declared.
        """
        found = self._address(value, sizes) if self.is_pointer else self._number(value)
        if found is None and not (value is None and self.may_be_null):
            shown = type(value).__name__
            if isinstance(value, np.ndarray):
                shown = f"{value.dtype} of shape {value.shape}"
            raise TypeError(f"{self.name}: {shown} is given: must be {self.text}")
        return found

    def _address(self, value: Any, sizes: Mapping[str, int]) -> int | None:
        """Return the address of an array's memory if this pointer parameter can have it.

        Returns None for other values.
        """
        kind = _PLAIN.get(self.type)
        if isinstance(value, np.ndarray):
            flags = value.flags
            fits = flags.c_contiguous and flags.aligned and (flags.writeable or self.is_const)
            fits = fits and kind is not None and value.dtype == np.dtype(kind)
            return value.ctypes.data if fits and value.size >= self.least else None
        if not isinstance(value, ctypes.Array | ctypes.Structure | ctypes._SimpleCData):
            return None
        # A struct may be any memory of its size.
        fits, least = kind is None, sizes.get(self.type, 1)
        if kind is not None:
            fits = isinstance(value, kind) or getattr(value, "_type_", 0) is kind
            least = self.least * ctypes.sizeof(kind)
        return ctypes.addressof(value) if fits and ctypes.sizeof(value) >= least else None

    def _number(self, value: Any) -> float | int | None:
        """Convert a number to this parameter's type.

        Returns None for values that the type does not have.
        """
        if isinstance(value, bool | str):
            return None
        try:
            whole = float(value) if self.type in ("double", "float") else operator.index(value)
        except TypeError:
            return None
        if self.type in ("double", "float"):
            return whole
        bits = 8 * ctypes.sizeof(_PLAIN[self.type])
        least = 0 if self.type == "size_t" else -(1 << bits - 1)
        return whole if least <= whole < least + (1 << bits) else None


@dataclass(frozen=True, slots=True)
class Signature:
    """Signature of a C function, as declared in its prototype."""

    name: str
    result: type[c_char_p | c_double | c_float | c_int | c_size_t]
    parameters: tuple[Parameter, ...]

    def arguments(self, given: tuple[Any, ...], sizes: Mapping[str, int]) -> list[Any]:
        """Convert Python values to the ctypes arguments of this function.

        Raises TypeError for a wrong number or type.
        """
        if len(given) != len(self.parameters):
            names = ", ".join(x.name for x in self.parameters)
            rule = f"{self.name} takes {len(self.parameters)} arguments ({names})"
            raise TypeError(f"{rule}, {len(given)} are given")
        return [x.given(value, sizes) for x, value in zip(self.parameters, given, strict=True)]


def signatures(header: str) -> dict[str, Signature]:
    """Parse the function prototypes in a generated C header.

    Returns the signatures by the functions' names.

    >>> found = signatures("int f(size_t n, const double x[3], int *codes /* or NULL */);")
    >>> [x.text for x in found["f"].parameters]
    ['size_t n', 'const double x[3]', 'int *codes or NULL']
    """
    text = re.sub(r"/\*.*?\*/", "", header.replace("/* or NULL */", "OR_NULL"), flags=re.DOTALL)
    return {
        name: Signature(name, _PLAIN.get(result.strip(), c_char_p), _parameters(parameters))
        for result, name, parameters in _PROTOTYPE.findall(text)
    }


def _parameters(text: str) -> tuple[Parameter, ...]:
    found = []
    for one in "".join(text.split("\n")).split(",") if text != "void" else ():
        whole = " ".join(one.split())
        match = _PARAMETER.fullmatch(whole)
        if match is None:
            raise LibraryError(f"{whole}: a parameter of no kind that is called here")
        const, kind, star, name, sizes, null = match.groups()
        least = prod(map(int, re.findall(r"\d+", sizes))) if sizes else 0
        said = whole.replace("OR_NULL", "or NULL")
        pointer = bool(star or sizes)
        found.append(Parameter(said, name, kind, pointer, bool(const), least, bool(null)))
    return tuple(found)


class Library:
    """Shared library with its C functions as attributes.

    Attributes are named without the module's prefix.  A call with a wrong number of arguments, or a
    wrong one, raises TypeError.  `raw` has the same functions for engines, which pass addresses of
    arrays that they have checked: other types raise there, too.  It also has the header's
    constants, in capitals; `path` is the file.
    """

    def __init__(self, shared: ctypes.CDLL, header: str, stem: str) -> None:
        self.path = Path(shared._name)
        self.signatures: dict[str, Signature] = {}
        self.raw: Any = SimpleNamespace()
        for name, signature in signatures(header).items():
            function = getattr(shared, name)
            function.restype = signature.result
            function.argtypes = [
                c_void_p if x.is_pointer else _PLAIN[x.type] for x in signature.parameters
            ]
            # The steps' module has a prefix of its own only where another module has the name.
            short = name.removeprefix(f"{stem}_").removeprefix(f"{stem.removesuffix('_step')}_")
            self.signatures[short] = signature
            setattr(self.raw, short, function)
        for name, value in _CONSTANT.findall(header):
            setattr(self.raw, name.removeprefix(f"{stem.upper()}_"), int(value))
        prefix = "torque_free_" if "body_size" in self.signatures else f"{stem}_"
        self._sizes = {
            prefix + short.removesuffix("_size"): getattr(self.raw, short)()
            for short in self.signatures
            if short.endswith("_size")
        }

    def __getattr__(self, name: str) -> Callable[..., Any]:
        if name not in vars(self).get("signatures", ()):
            raise AttributeError(name)
        signature, function = self.signatures[name], getattr(self.raw, name)

        def checked(*given: Any) -> Any:
            return function(*signature.arguments(given, self._sizes))

        return checked


def load(path: Path, sources: Mapping[str, str]) -> Library:
    """Load a shared library that was built from given sources.

    Raises LibraryError if it cannot be loaded or was built from other sources.
    """
    header = next(name for name in sources if name.endswith(".h"))
    try:
        library = Library(ctypes.CDLL(str(path)), sources[header], PurePath(header).stem)
        digest = library.raw.digest().decode("ascii", "replace")
    except (OSError, AttributeError) as error:
        reason = " ".join(str(error).removeprefix(f"{path}: ").split())
        raise LibraryError(f"{path} cannot be loaded ({reason})") from None
    expected = written_digest(sources)
    if expected and digest != expected:
        raise LibraryError(f"{path} was built from other sources")
    return library


def check_arithmetic(library: Library) -> None:
    """Raise LibraryError if compiler options broke the floating-point arithmetic of a library.

    Modules in single precision do not look.
    """
    if not {"body_size", "motion_size"} & library.signatures.keys():
        return
    one, size = np.ones(4), ctypes.sizeof(c_double)
    if "body_init" in library.signatures:
        code = library.body_init((c_double * -(-library.body_size() // size))(), one)
    else:
        memory = (c_double * -(-library.motion_size() // size))()
        code = library.motion_init(memory, one, one, one)
    if code == library.raw.ARITHMETIC:
        raise LibraryError(f"the C module refuses: {library.message(code).decode()}")


def written_digest(sources: Mapping[str, str]) -> str | None:
    """Return the digest that a comment in the sources states, or None without one."""
    text = "\n".join(sources.values())
    found = re.search(r"^\W*digest ([0-9a-f]{64})\b", text, re.MULTILINE)
    return found[1] if found else None
