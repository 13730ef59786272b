"""Reader of case files, which define a motion and its times in TOML."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from importlib import resources
from pathlib import Path

from rigidsym import _inputs as inputs
from rigidsym.errors import InputError, written
from rigidsym.io._attitude_ephemeris import Message, message_fields
from rigidsym.io._files import TomlTable, check_keys, parse_toml, read_text
from rigidsym.motion import IDENTITY, TorqueFreeMotion
from rigidsym.view._motions import case_html

PAPER = "paper.toml"
_KEYS = {"inertia", "omega0", "attitude0", "times", "degrees", "message"}


@dataclass(frozen=True, slots=True)
class Case:
    """A motion, the times to evaluate it at, and the fields of its CCSDS message."""

    motion: TorqueFreeMotion
    times: tuple[Fraction, ...]
    message: Message = field(default_factory=dict)

    def __repr__(self) -> str:
        from rigidsym.view._motions import case_text

        return case_text(self)

    def _repr_html_(self) -> str:
        return case_html(self)


def paper_case() -> Case:
    """Return the case of the paper's spacecraft."""
    return parse_case(resources.files("rigidsym.io").joinpath(PAPER).read_text("utf-8"))


def load_case(path: str | Path, allow_nonphysical: bool = False) -> Case:
    """Read a case file.

    Raises InputError for the first mistake.
    """
    return parse_case(read_text("case", path), allow_nonphysical)


def parse_case(text: str, allow_nonphysical: bool = False) -> Case:
    """Parse the TOML text of a case.

    Numbers are floats, or strings, which are exact decimals.
    """
    data = parse_toml("case", text)
    check_keys("case", data, _KEYS, needed=("inertia", "omega0", "times"))
    motion = TorqueFreeMotion(
        data["inertia"],
        data["omega0"],
        data.get("attitude0", IDENTITY),
        allow_nonphysical=allow_nonphysical,
        degrees=data.get("degrees", False),
    )
    times = data["times"]
    if isinstance(times, Mapping):
        exact = _grid(times)
    else:
        exact = inputs.times(inputs.sequence("times", times))[0]
    return Case(motion, exact, message_fields(data.get("message", {})))


def _grid(table: TomlTable) -> tuple[Fraction, ...]:
    """Return equally spaced times from a TOML table with start, stop and count."""
    if set(table) != {"start", "stop", "count"}:
        raise InputError("times", sorted(table), "a table of times has start, stop and count")
    start, stop = (inputs.exact(f"times.{key}", table[key]) for key in ("start", "stop"))
    count = table["count"]
    whole = isinstance(count, int) and not isinstance(count, bool)
    if not whole or not 1 <= count <= inputs.MOST_TIMES:
        rule = f"must be a whole number, at least 1 and at most {inputs.MOST_TIMES}"
        raise InputError("times.count", written(count, repr), rule)
    step = (stop - start) / max(count - 1, 1)
    return tuple(start + k * step for k in range(count))
