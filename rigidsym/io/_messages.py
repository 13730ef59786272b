"""The table [message] of a file: fields of an attitude ephemeris message."""

from collections.abc import Collection, Mapping
from datetime import UTC, datetime

from rigidsym.errors import InputError
from rigidsym.io import _epochs as epochs
from rigidsym.io import _toml as toml_file
from rigidsym.io._attitude_ephemeris import text_value

MISSION = ("object_name", "object_id", "originator", "creation_date", "ref_frame_b")
"Fields that a file can set for any message."
ALL = (*MISSION, "epoch", "time_system", "ref_frame_a")
"All fields, where nothing else determines the epoch and the inertial frame."
UNNAMED = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
"Defaults (CCSDS 504.0-B-2, table 4-3)."

Message = Mapping[str, str]


def read(table: object, known: Collection[str] = ALL) -> Message:
    """Return the arguments of `rigidsym.io.aem` in a table, by name.

    Dates are strings or TOML's own.  Raises InputError about the first unknown key, and text that
    the standard does not allow.
    """
    if not isinstance(table, Mapping):
        raise InputError("message", repr(table), f"must be a table of {', '.join(sorted(known))}")
    toml_file.check_keys("message", table, known)
    found = {name: _text(f"message.{name}", value) for name, value in table.items()}
    for name, value in found.items():
        _check(name, value, found.get("time_system", "UTC"))
    return found


def _text(field: str, value: object) -> str:
    """Return text as it is, a date of TOML in the standard's form."""
    if isinstance(value, datetime):
        utc = value if value.tzinfo is None else value.astimezone(UTC)
        return utc.replace(tzinfo=None).isoformat()
    if not isinstance(value, str):
        raise InputError(field, repr(value), "must be text")
    return value


def _check(name: str, value: str, system: str) -> None:
    field = f"message.{name}"
    if name == "epoch":
        epochs.parse(field, value, system)
    elif name == "creation_date":
        epochs.parse(field, value, "UTC")
    elif name != "time_system":
        text_value(field, value)
