"""Import of a package's public names and modules at their first use."""

import sys
from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from pkgutil import iter_modules


def lazily(
    package: str, homes: Mapping[str, str], check: Callable[[], None] = lambda: None
) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` of a package that imports at first use.

    homes: modules by public name, relative to the package if they begin with a dot.  Public modules
    of the package are those without a leading underscore.  check: is called before a name is
    imported, and raises an error if an optional package is missing.
    """
    own = sys.modules[package]

    @cache
    def modules() -> frozenset[str]:
        return frozenset(x.name for x in iter_modules(own.__path__) if not x.name.startswith("_"))

    def attribute(name: str) -> object:
        if name in homes:
            check()
            found = getattr(import_module(homes[name], package), name)
            # Cached, so that this is called once for each name.
            setattr(own, name, found)
            return found
        if not name.startswith("_") and name in modules():
            return import_module(f"{package}.{name}")
        # With both, Python proposes the nearest name.
        raise AttributeError(f"module {package!r} has no attribute {name!r}", name=name, obj=own)

    def names() -> list[str]:
        special = (name for name in vars(own) if name[:2] == "__")
        return sorted({*special, *getattr(own, "__all__", ()), *homes, *modules()})

    return attribute, names
