"""The reference of the API: what the packages name in `__all__`, from their docstrings."""

import inspect
from importlib import import_module
from types import ModuleType
from typing import Any

PACKAGES = {
    "rigidsym": "What most programmes need",
    "rigidsym.splitting": "Splitting methods",
    "rigidsym.manoeuvre": "Manoeuvres",
    "rigidsym.fitting": "Fitting motions",
    "rigidsym.manoeuvre.flight": "Flights",
    "rigidsym.io": "For other programs",
    "rigidsym.view.scenes": "Pictures",
    "rigidsym.precise": "Digits and balls",
    "rigidsym.proof.kernel": "The kernel",
    "rigidsym.proof.checker": "The second checker",
    "rigidsym.proof.algebra": "Writing derivations",
    "rigidsym.proof.steps": "Steps of a derivation",
    "rigidsym.proof.paper": "The printed equations",
    "rigidsym.solution": "The solution as data",
    "rigidsym.validate": "Validation",
}
# What a page begins with.
FIRST = (
    "TorqueFreeMotion",
    "propagate",
    "integrate",
    "plan",
    "generate",
    "PreciseMotion",
    "Ledger",
    "replay",
    "validate",
    "examine",
)


def contents() -> str:
    """The list of these pages for the page that leads to them."""
    return "\n".join(f"api/{package}" for package in PACKAGES)


def pages() -> dict[str, str]:
    """A page for each package, by its name; what an earlier one has is not said again."""
    told: dict[int, str] = {}
    return {package: _page(package, title, told) for package, title in PACKAGES.items()}


def _page(package: str, title: str, told: dict[int, str]) -> str:
    module = import_module(package)
    parts = [f"{title}\n{'=' * len(title)}\n", f"``{package}``\n", f".. automodule:: {package}\n"]
    for name in sorted(module.__all__, key=lambda name: (name not in FIRST, name.lower())):
        value = getattr(module, name)
        known = told.get(id(value))
        if known:
            parts.append(f"``{name}`` is :py:obj:`{known}`.\n")
        else:
            told[id(value)] = f"{package}.{name}"
            parts.append(_entry(module, name, value))
    return "\n".join(parts)


def _entry(module: ModuleType, name: str, value: Any) -> str:
    """The directive of autodoc for one name."""
    place = f"{module.__name__}.{name}"
    if not inspect.isclass(value):
        return _function(place) if callable(value) else _data(place, value)
    options = [":members:", *_extras(value)]
    lines = "\n".join(f"   {option}" for option in options)
    kind = "autoexception" if issubclass(value, BaseException) else "autoclass"
    return f".. {kind}:: {place}\n{lines}\n"


def _extras(value: type) -> list[str]:
    """Enumerations say their members, and callable things how they are called."""
    if hasattr(value, "__members__"):
        return [":undoc-members:"]
    own = "__call__" in vars(value) and bool(vars(value)["__call__"].__doc__)
    # A private base class has no page, so that its methods belong to those of its subclasses.
    shared = any(base.__module__.startswith("rigidsym._") for base in value.__mro__[1:])
    options = [":special-members: __call__"] if own else []
    return [*options, ":inherited-members: ABC"] if shared else options


def _function(place: str) -> str:
    return f".. autofunction:: {place}\n"


def _data(place: str, value: Any) -> str:
    listed = [*value] if isinstance(value, (dict, tuple, list)) else []
    short = all(isinstance(entry, str) for entry in listed)
    words = ", ".join(f"``{entry}``" for entry in listed) if listed and short else ""
    about = f"{words}." if words else f"{len(listed)} values." if listed else "A type."
    return f".. py:data:: {place}\n\n   {about}\n"
