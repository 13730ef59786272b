"""Attitude ephemeris messages as others write them, in KVN: CCSDS 504.0-B-1 and -2.

Read are quaternions, with angular velocities or without; see `attitude_ephemeris` for what they
mean.  Several segments are read as one track, as long as they speak of the same frames.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from rigidsym.errors import InputError
from rigidsym.io import epochs

# Numbers of a line after the epoch: the quaternion, and where in it the rates are.
_TYPES = {"QUATERNION": 4, "QUATERNION/ANGVEL": 7}
_SCALAR = ("LAST", "FIRST")


@dataclass(frozen=True, slots=True, eq=False)
class Message:
    """epoch: of the first state; times (N,), s after it; q (N, 4), scalar first, body to inertial;
    rates (N, 3), rad/s along the body's axes, where there are any."""

    epoch: str
    times: np.ndarray
    q: np.ndarray
    rates: np.ndarray | None


def read(text: str) -> Message:
    """The states of a message; raises InputError with the line that is wrong."""
    first, ticks, rows, widths = "", [], [], set()
    for number, metadata, line in _states(text):
        kind = metadata.get("ATTITUDE_TYPE", "")
        where = f"line {number}"
        if kind not in _TYPES:
            raise InputError("ATTITUDE_TYPE", kind, f"must be one of: {', '.join(_TYPES)}")
        epoch, *values = line.split()
        ticks.append(epochs.parse(where, epoch, metadata.get("TIME_SYSTEM", "UTC")))
        first = first or epoch
        rows.append(_row(where, values, metadata, _TYPES[kind]))
        widths.add(_TYPES[kind])
    if not rows:
        raise InputError("message", "no states", "there must be DATA_START and states after it")
    if len(widths) > 1:
        raise InputError("ATTITUDE_TYPE", "both", "must be the same in all segments")
    table = np.array(rows)
    times = np.array([(tick - ticks[0]) / epochs.SECOND for tick in ticks])
    rates = np.deg2rad(table[:, 4:]) if 7 in widths else None
    return Message(first, times, table[:, :4], rates)


def _states(text: str) -> Iterator[tuple[int, dict[str, str], str]]:
    """Number, metadata of the segment and text of each line of data."""
    metadata: dict[str, str] = {}
    frames: tuple[str | None, ...] | None = None
    inside = False
    for number, raw in enumerate(text.splitlines(), 1):
        line = raw.strip()
        if line == "META_START":
            metadata = {}
        elif line in ("DATA_START", "DATA_STOP"):
            inside = line == "DATA_START"
            own = tuple(metadata.get(x) for x in ("REF_FRAME_A", "REF_FRAME_B", "TIME_SYSTEM"))
            frames = frames or own
            if own != frames:
                raise InputError("REF_FRAME_A", own[0], "must be the same in all segments")
        elif inside and line and not line.startswith("COMMENT"):
            yield number, metadata, line
        elif "=" in line and not inside and not line.startswith("COMMENT"):
            keyword, value = (x.strip() for x in line.split("=", 1))
            if keyword in metadata:
                rule = "is given twice in a segment: remove one of them"
                raise InputError(f"line {number}, {keyword}", value, rule)
            metadata[keyword] = value


def _row(where: str, values: list[str], metadata: dict[str, str], width: int) -> list[float]:
    """The quaternion with its scalar first, then the rates in deg/s."""
    try:
        numbers = [float(x) for x in values]
    except ValueError:
        raise InputError(where, " ".join(values), "must be an epoch and numbers") from None
    if len(numbers) != width:
        raise InputError(where, f"{len(numbers)} numbers", f"must have {width} after the epoch")
    scalar = metadata.get("QUATERNION_TYPE", "LAST")
    if scalar not in _SCALAR:
        raise InputError("QUATERNION_TYPE", scalar, f"must be one of: {', '.join(_SCALAR)}")
    way = metadata.get("ATTITUDE_DIR", "A2B")
    if way not in ("A2B", "B2A"):
        raise InputError("ATTITUDE_DIR", way, "must be one of: A2B, B2A")
    q = numbers[:4] if scalar == "FIRST" else [numbers[3], *numbers[:3]]
    return [q[0], *((-x for x in q[1:]) if way == "B2A" else q[1:]), *numbers[4:]]
