"""Writer and reader of CCSDS attitude ephemeris messages (AEM).

Messages are in KVN.  They are written by the standard 504.0-B-2 and read by 504.0-B-1 and -2.

The quaternion of a message is "from frame A to frame B": of the rotation that carries the axes of A
into those of B (annex F2.1).  With A inertial and B the body it turns components along B into
components along A, which this project calls body to inertial: the same four numbers, their scalar
last.  Angular velocities are of B against A (annex F4), here along the axes of B, in deg/s.
Sections 4 and 6 have the format.
"""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import pairwise

import numpy as np

from rigidsym.errors import InputError, unknown
from rigidsym.io import _epochs as epochs
from rigidsym.io._files import subtable
from rigidsym.io._tracks import Track

MISSION_FIELDS = ("object_name", "object_id", "originator", "creation_date", "ref_frame_b")
"Fields of the table [message] that a file can set for any message."
MESSAGE_FIELDS = (*MISSION_FIELDS, "epoch", "time_system", "ref_frame_a")
"All fields, where nothing else determines the epoch and the inertial frame."
UNNAMED = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
"Defaults (CCSDS 504.0-B-2, table 4-3)."

# 6.6.1: characters in a line.
LONGEST_LINE = 254
# Polynomials of higher degree gain little more before they begin to swing at the ends.
HIGHEST_DEGREE = 7
_PRINTABLE = re.compile(r"[ -~]+")
_TYPES = {True: "QUATERNION/ANGVEL", False: "QUATERNION"}
# Numbers of a line after the epoch: the quaternion, then the rates.
_WIDTHS = {"QUATERNION": 4, "QUATERNION/ANGVEL": 7}

Message = Mapping[str, str]


def aem(
    track: Track | Sequence[Track],
    epoch: str,
    *,
    object_name: str,
    object_id: str,
    originator: str,
    ref_frame_a: str = "EME2000",
    ref_frame_b: str = "SC_BODY_1",
    rates: bool = True,
    time_system: str = "UTC",
    creation_date: str | None = None,
) -> str:
    """Write one or several tracks as a CCSDS attitude ephemeris message (AEM).

    The message is in ASCII.

    Parameters
    ----------
    track : Track or list of them
        States of the segments, in order of time.
    epoch : str
        Time of t = 0 of the tracks, YYYY-MM-DDThh:mm:ss[.d...], in `time_system`.
    object_name, object_id : str
        UNKNOWN where there is none (table 4-3).
    originator : str
        Maker of the message (table 4-2).
    ref_frame_a : str
        The inertial frame of the attitudes.
    ref_frame_b : str
        The axes of the body, which are ANGVEL_FRAME too.
    rates : bool
        ATTITUDE_TYPE is QUATERNION/ANGVEL with rates and QUATERNION without.
    time_system : {"UTC", "TAI", "TT", "GPS"}
        System of the epoch and the times; nothing is converted.  UTC has its leap seconds up to
        2016 as 23:59:60, and no later ones.
    creation_date : str
        Date in UTC, now by default; a message that must be reproducible byte for byte needs one.

    Returns
    -------
    str
        Numbers have 16 digits, the most that 6.8.4 allows: 1e-15 rad of attitude, and a relative
        1e-15 of rates.  A time is its shortest decimal, which is read as the same double, in as
        many decimals as its segment needs, 3 at least and 14 at most; beyond those it is off by up
        to 5e-15 s, and the attitude at the epoch by |omega| times that.  Quaternions keep their
        signs, so that they can be interpolated, by Lagrange's polynomial of the 8 nearest or of all
        there are.

    Raises
    ------
    InputError
        For epochs and text that the standard does not allow, times closer than 1e-14 s, and tracks
        that begin before the last one ends.
    """
    tracks = list(track) if isinstance(track, Sequence) else [track]
    if not tracks or not all(isinstance(each, Track) for each in tracks):
        raise InputError("track", repr(track), "must be a Track or a list of them")
    zero = epochs.parse("epoch", epoch, time_system)
    instants = [[epochs.later(zero, t) for t in each.times.tolist()] for each in tracks]
    _check_order(instants)
    if not isinstance(rates, bool):
        choices = ", ".join(f"{key} ({name})" for key, name in _TYPES.items())
        raise InputError("rates", repr(rates), f"must be one of: {choices}")
    if ref_frame_a == ref_frame_b:
        raise InputError("ref_frame_b", repr(ref_frame_b), "must not be frame A as well")
    if creation_date is None:
        creation_date = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S")
    else:
        epochs.parse("creation_date", creation_date, "UTC")
    named = {"originator": originator, "object_name": object_name, "object_id": object_id}
    named |= {"ref_frame_a": ref_frame_a, "ref_frame_b": ref_frame_b}
    checked = {name.upper(): text_value(name, text) for name, text in named.items()}
    header = {"CCSDS_AEM_VERS": "2.0", "CREATION_DATE": creation_date}
    lines = _fields(header | {"ORIGINATOR": checked.pop("ORIGINATOR")})
    for each, when in zip(tracks, instants, strict=True):
        lines += _segment(each, when, checked | {"TIME_SYSTEM": time_system}, rates)
    return "\n".join([*lines, ""])


def _check_order(instants: Sequence[Sequence[int]]) -> None:
    """Raise InputError unless times increase within and between segments.

    The standard asks for this in 4.2.4.8.1.
    """
    for within in instants:
        for k, (one, other) in enumerate(pairwise(within), 1):
            if other <= one:
                rule = "must be 1e-14 s later than the time before it"
                raise InputError(f"times[{k}]", "too early", rule)
    for k, (one, other) in enumerate(pairwise(instants), 1):
        if other[0] < one[-1]:
            raise InputError(f"track[{k}]", "too early", "must not begin before the last one ends")


def text_value(field: str, text: str) -> str:
    """Check that the CCSDS standard allows a text value, and return it.

    Raises InputError for other values (6.6, 6.8.6 to 6.8.8).
    """
    if not isinstance(text, str) or not _PRINTABLE.fullmatch(text):
        raise InputError(field, ascii(text), "must be printable ASCII characters on one line")
    if text != " ".join(text.split()):
        raise InputError(field, repr(text), "must have single blanks, between words only")
    if text not in (text.upper(), text.lower()):
        raise InputError(field, repr(text), "must be all uppercase or all lowercase")
    most = LONGEST_LINE - len("INTERPOLATION_DEGREE = ")
    if len(text) > most:
        raise InputError(field, repr(text), f"must have at most {most} characters")
    return text


def _segment(track: Track, instants: Sequence[int], names: Message, rates: bool) -> list[str]:
    """Return the metadata and data lines of one message segment.

    Metadata are those of table 4-3, and data those of table 4-4. USEABLE_START_TIME and
    USEABLE_STOP_TIME are optional: the states are good to both ends.
    """
    system, digits = names["TIME_SYSTEM"], epochs.decimals(instants)
    times = [epochs.printed(instant, system, digits) for instant in instants]
    metadata = {**names, "START_TIME": times[0], "STOP_TIME": times[-1]}
    metadata["ATTITUDE_TYPE"] = _TYPES[rates]
    if rates:
        metadata["ANGVEL_FRAME"] = names["REF_FRAME_B"]
    if len(times) > 1:
        # Lagrange's polynomial of degree d takes d + 1 states of either type (4.2.4.8.4); readers
        # disagree on HERMITE.
        metadata["INTERPOLATION_METHOD"] = "LAGRANGE"
        metadata["INTERPOLATION_DEGREE"] = str(min(HIGHEST_DEGREE, len(times) - 1))
    values = np.roll(track.q, -1, axis=1)
    if rates:
        values = np.hstack([values, np.degrees(track.omega)])
    # 6.8.4.2: 16 digits, a point after the first; 6.8.5 has no -0, which adding 0 removes.
    data = [
        f"{time} {' '.join(f'{x + 0.0: .15e}' for x in row)}"
        for time, row in zip(times, values.tolist(), strict=True)
    ]
    return [
        *("", "META_START", *_fields(metadata), "META_STOP"),
        *("", "DATA_START", *data, "DATA_STOP"),
    ]


def _fields(fields: Message) -> list[str]:
    return [f"{keyword} = {value}" for keyword, value in fields.items()]


def message_fields(table: object, known: Collection[str] = MESSAGE_FIELDS) -> Message:
    """Convert the table [message] of a file to arguments of `aem`.

    Dates are strings or TOML's own.  Raises InputError for the first unknown key, and for text that
    the standard does not allow.
    """
    found = {}
    for name, value in subtable("message", table, known).items():
        if isinstance(value, datetime):
            utc = value if value.tzinfo is None else value.astimezone(UTC)
            value = utc.replace(tzinfo=None).isoformat()
        if not isinstance(value, str):
            raise InputError(f"message.{name}", repr(value), "must be text")
        found[name] = value
    for name, value in found.items():
        if name in ("epoch", "creation_date"):
            system = found.get("time_system", "UTC") if name == "epoch" else "UTC"
            epochs.parse(f"message.{name}", value, system)
        elif name != "time_system":
            text_value(f"message.{name}", value)
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Ephemeris:
    """Parsed attitude ephemeris message with its states.

    epoch: of the first state; times (N,), s after it; q (N, 4), scalar first, body to inertial;
    rates (N, 3), rad/s along the body's axes, or None.
    """

    epoch: str
    times: np.ndarray
    q: np.ndarray
    rates: np.ndarray | None


def read(text: str) -> Ephemeris:
    """Parse an attitude ephemeris message.

    Quaternions are read, with angular velocities or without.  Several segments are read as one
    track if they have the same frames.  Raises InputError for the first wrong line.
    """
    first, ticks, rows, widths = "", [], [], set()
    for number, metadata, line in _states(text):
        kind = metadata.get("ATTITUDE_TYPE", "")
        where = f"line {number}"
        if kind not in _WIDTHS:
            raise unknown("ATTITUDE_TYPE", kind, _WIDTHS, plain=True)
        epoch, *values = line.split()
        ticks.append(epochs.parse(where, epoch, metadata.get("TIME_SYSTEM", "UTC")))
        first = first or epoch
        rows.append(_row(where, values, metadata, _WIDTHS[kind]))
        widths.add(_WIDTHS[kind])
    if not rows:
        raise InputError("message", "no states", "there must be DATA_START and states after it")
    if len(widths) > 1:
        raise InputError("ATTITUDE_TYPE", "both", "must be the same in all segments")
    table = np.array(rows)
    times = np.array([(tick - ticks[0]) / epochs.SECOND for tick in ticks])
    rates = np.deg2rad(table[:, 4:]) if 7 in widths else None
    return Ephemeris(first, times, table[:, :4], rates)


def _states(text: str) -> Iterator[tuple[int, dict[str, str], str]]:
    """Yield the line number, the segment's metadata and the text of each data line."""
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
    """Convert the numbers of a data line to a scalar-first quaternion and rates in deg/s."""
    try:
        numbers = [float(x) for x in values]
    except ValueError:
        raise InputError(where, " ".join(values), "must be an epoch and numbers") from None
    if len(numbers) != width:
        raise InputError(where, f"{len(numbers)} numbers", f"must have {width} after the epoch")
    scalar = metadata.get("QUATERNION_TYPE", "LAST")
    direction = metadata.get("ATTITUDE_DIR", "A2B")
    for keyword, value, choices in (
        ("QUATERNION_TYPE", scalar, ("LAST", "FIRST")),
        ("ATTITUDE_DIR", direction, ("A2B", "B2A")),
    ):
        if value not in choices:
            raise unknown(keyword, value, choices, plain=True)
    q = numbers[:4] if scalar == "FIRST" else [numbers[3], *numbers[:3]]
    vector = [-x for x in q[1:]] if direction == "B2A" else q[1:]
    return [q[0], *vector, *numbers[4:]]
