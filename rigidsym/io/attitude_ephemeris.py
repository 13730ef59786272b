"""Attitude ephemeris messages, version 2.0 in KVN: CCSDS 504.0-B-2, sections 4 and 6, annex F.

The quaternion of a message is "from frame A to frame B": of the rotation that carries the axes of
A into those of B (annex F2.1).  With A inertial and B the body it turns components along B into
components along A, which is what this project calls body to inertial: the same four numbers, their
scalar last.  Angular velocities are of B against A (annex F4), here along the axes of B, in deg/s.
"""

import re
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from itertools import pairwise

import numpy as np

from rigidsym.errors import InputError
from rigidsym.io import epochs
from rigidsym.io.tracks import Track

# 6.6.1: characters in a line.
LONGEST_LINE = 254
# Polynomials of higher degree gain little more before they begin to swing at the ends.
HIGHEST_DEGREE = 7
_PRINTABLE = re.compile(r"[ -~]+")
_TYPES = {True: "QUATERNION/ANGVEL", False: "QUATERNION"}

Field = tuple[str, str]


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
    """The message of a track, or of several after each other, one segment for each, as ASCII text.

    epoch: when the times of the tracks are zero, YYYY-MM-DDThh:mm:ss[.d...], in `time_system`:
    UTC, TAI, TT or GPS, which names what the epoch and the times are counted in; nothing is
    converted.  UTC shows its leap seconds up to 2016 as 23:59:60 and is taken to have no later
    ones.  object_name, object_id: UNKNOWN where there is none (table 4-3).  originator: who makes
    the message (table 4-2).  ref_frame_a: the inertial frame of the attitudes; ref_frame_b: the
    axes of the body, which are ANGVEL_FRAME too.  rates: ATTITUDE_TYPE is QUATERNION/ANGVEL with
    them and QUATERNION without.  creation_date: in UTC; now where it is None: a message that has to
    be the same byte for byte needs one.

    Numbers have 16 digits, the most that 6.8.4 allows: 1e-15 rad of attitude, and of the rates
    1e-15 of their size.  A time is its shortest decimal, which a reader gets back as the double it
    was, in as many decimals as its segment needs, 3 at least and 14 at most; beyond those it is off
    by up to 5e-15 s, and the attitude at the epoch by |omega| times that.  Quaternions keep the
    signs they have, so that they can be interpolated, by Lagrange's polynomial of the 8 nearest or
    of all there are.

    Raises InputError for epochs and text the standard has no place for, times closer than 1e-14 s,
    and tracks that begin before the last one ends.
    """
    tracks = _tracks(track)
    zero = epochs.parse("epoch", epoch, time_system)
    instants = [[epochs.later(zero, t) for t in each.times.tolist()] for each in tracks]
    _check_order(instants)
    if not isinstance(rates, bool):
        raise InputError("rates", repr(rates), f"must be one of: {_choices()}")
    if ref_frame_a == ref_frame_b:
        raise InputError("ref_frame_b", repr(ref_frame_b), "must not be frame A as well")
    header = [
        ("CCSDS_AEM_VERS", "2.0"),
        ("CREATION_DATE", _creation_date(creation_date)),
        ("ORIGINATOR", text_value("originator", originator)),
    ]
    names = {
        "OBJECT_NAME": text_value("object_name", object_name),
        "OBJECT_ID": text_value("object_id", object_id),
        "REF_FRAME_A": text_value("ref_frame_a", ref_frame_a),
        "REF_FRAME_B": text_value("ref_frame_b", ref_frame_b),
        "TIME_SYSTEM": time_system,
    }
    lines = _fields(header)
    for each, when in zip(tracks, instants, strict=True):
        lines += _segment(each, when, names, rates)
    return "\n".join([*lines, ""])


def _tracks(track: Track | Sequence[Track]) -> list[Track]:
    tracks = list(track) if isinstance(track, Sequence) else [track]
    if not tracks or not all(isinstance(each, Track) for each in tracks):
        raise InputError("track", repr(track), "must be a Track or a list of them")
    return tracks


def _choices() -> str:
    return ", ".join(f"{key} ({name})" for key, name in _TYPES.items())


def _check_order(instants: Sequence[Sequence[int]]) -> None:
    """4.2.4.8.1: time tags increase within a segment; here segments do not overlap either."""
    for within in instants:
        for k, (one, other) in enumerate(pairwise(within), 1):
            if other <= one:
                rule = "must be 1e-14 s later than the time before it"
                raise InputError(f"times[{k}]", "too early", rule)
    for k, (one, other) in enumerate(pairwise(instants), 1):
        if other[0] < one[-1]:
            raise InputError(f"track[{k}]", "too early", "must not begin before the last one ends")


def text_value(field: str, text: str) -> str:
    """A text value: 6.6.3, 6.8.6 to 6.8.8, and short enough for any keyword (6.6.1)."""
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


def _creation_date(given: str | None) -> str:
    """4.2.2.2: a date in UTC, the time of writing unless it is given."""
    if given is None:
        return datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%S")
    epochs.parse("creation_date", given, "UTC")
    return given


def _segment(
    track: Track, instants: Sequence[int], names: dict[str, str], rates: bool
) -> list[str]:
    """The metadata in the order of table 4-3, and the lines of table 4-4.

    USEABLE_START_TIME and USEABLE_STOP_TIME are optional: the states are good to both ends.
    """
    system, digits = names["TIME_SYSTEM"], epochs.decimals(instants)
    times = [epochs.printed(instant, system, digits) for instant in instants]
    metadata = [
        *names.items(),
        ("START_TIME", times[0]),
        ("STOP_TIME", times[-1]),
        ("ATTITUDE_TYPE", _TYPES[rates]),
    ]
    if rates:
        metadata.append(("ANGVEL_FRAME", names["REF_FRAME_B"]))
    metadata += _interpolation(len(times))
    values = np.roll(track.q, -1, axis=1)
    if rates:
        values = np.hstack([values, np.degrees(track.omega)])
    data = [f"{time} {_numbers(row)}" for time, row in zip(times, values.tolist(), strict=True)]
    return [
        *("", "META_START", *_fields(metadata), "META_STOP"),
        *("", "DATA_START", *data, "DATA_STOP"),
    ]


def _interpolation(count: int) -> list[Field]:
    """By a polynomial that the states of the segment are enough for (4.2.4.8.4).

    Lagrange's of degree d takes d + 1 states of either type; what HERMITE takes is read in two
    ways.
    """
    if count < 2:
        return []
    degree = min(HIGHEST_DEGREE, count - 1)
    return [("INTERPOLATION_METHOD", "LAGRANGE"), ("INTERPOLATION_DEGREE", str(degree))]


def _fields(fields: Iterable[Field]) -> list[str]:
    return [f"{keyword} = {value}" for keyword, value in fields]


def _numbers(row: Iterable[float]) -> str:
    """6.8.4.2: 16 digits, a point after the first; 6.8.5 has no -0, which adding 0 mends."""
    return " ".join(f"{x + 0.0: .15e}" for x in row)
