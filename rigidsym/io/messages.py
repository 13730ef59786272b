"""The table [message] of a file: what an attitude ephemeris message says of itself."""

from collections.abc import Collection, Mapping
from datetime import UTC, datetime

from rigidsym.errors import InputError
from rigidsym.io import epochs
from rigidsym.io import toml as toml_file
from rigidsym.io.attitude_ephemeris import text_value

MISSION = ("object_name", "object_id", "originator", "creation_date", "ref_frame_b")
"Who flies, who writes, and when: what a file can say of any message."
ALL = (*MISSION, "epoch", "time_system", "ref_frame_a")
"With those of a message whose epoch and inertial frame nothing else decides."
UNNAMED = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
"For files that name nothing (CCSDS 504.0-B-2, table 4-3)."

Message = Mapping[str, str]


def read(table: object, known: Collection[str] = ALL) -> Message:
    """The arguments of `rigidsym.io.aem` that a table gives, by name.

    Dates are strings or TOML's own.  Raises InputError about the first key that is not known and
    text that the standard has no place for.
    """
    if not isinstance(table, Mapping):
        raise InputError("message", repr(table), f"must be a table of {', '.join(sorted(known))}")
    toml_file.check_keys("message", table, known)
    found = {name: _text(f"message.{name}", value) for name, value in table.items()}
    for name, value in found.items():
        _check(name, value, found.get("time_system", "UTC"))
    return found


def _text(field: str, value: object) -> str:
    """Text as it is, a date of TOML as the standard writes it."""
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
