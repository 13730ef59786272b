"""TOML files of users: one clear line when something is wrong."""

import tomllib
from collections.abc import Collection, Mapping
from typing import Any

from rigidsym.errors import InputError

# Of values that may be of any type, until somebody has read them.
TomlTable = Mapping[str, Any]


def parse(field: str, text: str) -> TomlTable:
    """The tables of TOML text; raises InputError where it is none."""
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise InputError(field, "the file", f"is not TOML: {error}") from None


def check_keys(
    field: str, table: TomlTable, known: Collection[str], needed: Collection[str] = ()
) -> None:
    """Raise InputError for a key that is not known, and for one that is needed and missing."""
    for key in table:
        if key not in known:
            raise InputError(field, key, f"is not one of: {', '.join(sorted(known))}")
    for key in needed:
        if key not in table:
            raise InputError(key, "missing", f"a {field} needs it")
