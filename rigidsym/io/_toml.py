"""TOML files of users, with one clear line for a mistake."""

import tomllib
from collections.abc import Collection, Mapping
from typing import Any

from rigidsym.errors import InputError

# Values may be of any type.
TomlTable = Mapping[str, Any]

# Kinds of files, and of fields that one kind alone has, the command that reads it.
_KINDS = {"case", "manoeuvre", "observations"}
_READ_BY = {"omega0": "propagate", "start": "plan", "target": "plan"}
_READ_BY |= dict.fromkeys(("attitudes", "rates", "vectors"), "fit")


def parse(field: str, text: str) -> TomlTable:
    """Return the tables of TOML text; raise InputError if it is not TOML."""
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
            rule = f"is not one of: {', '.join(sorted(known))}"
            if field in _KINDS and (reader := _READ_BY.get(key)):
                rule += f"; `rigidsym {reader}` reads files that have it"
            raise InputError(field, key, rule)
    for key in needed:
        if key not in table:
            raise InputError(key, "missing", f"a {field} needs it")
