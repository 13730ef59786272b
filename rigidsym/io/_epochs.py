"""Conversion of epochs between text and whole ticks of 1e-14 s, with leap seconds.

An instant is a whole number of ticks of 1e-14 s since 0001-01-01T00:00:00 of its own time system,
counted by that system's clock: days of 86400 s, and in UTC the leap seconds besides.
"""

import math
import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from datetime import date
from decimal import Context, Decimal
from fractions import Fraction

from rigidsym.errors import InputError, unknown

# A fixed-point number has at most 16 digits (CCSDS 504.0-B-2, 6.8.4.1), two of them whole seconds.
DECIMALS = 14
# Enough for readers that expect milliseconds, and for those that expect any fraction.
FEWEST_DECIMALS = 3
SECOND = 10**DECIMALS
TIME_SYSTEMS = ("UTC", "TAI", "TT", "GPS")
DAY = 86400

# Days that ended with 23:59:60 UTC: IERS, Bulletin C.  Days to come are taken to have none.
_LEAPS = {
    "06-30": (1972, 1981, 1982, 1983, 1985, 1992, 1993, 1994, 1997, 2012, 2015),
    "12-31": (
        *(1972, 1973, 1974, 1975, 1976, 1977, 1978, 1979, 1987, 1989, 1990, 1995, 1998),
        *(2005, 2008, 2016),
    ),
}
_LEAP_DAYS = sorted(
    date.fromisoformat(f"{year}-{day}").toordinal() - 1
    for day, years in _LEAPS.items()
    for year in years
)
# The seconds of UTC at the midnights that leap seconds come before.
_AFTER_LEAPS = [(day + 1) * DAY + k + 1 for k, day in enumerate(_LEAP_DAYS)]
# Before it UTC's seconds were of other lengths.
_UTC_STARTS = date(1972, 1, 1).toordinal() - 1

_EPOCH = re.compile(
    r"(\d{4})-(?:(\d\d-\d\d)|(\d{3}))T(\d\d):(\d\d):(\d\d)(?:\.(\d+))?(Z?)", re.ASCII
)
_FORMAT = "must be YYYY-MM-DDThh:mm:ss[.d...] or YYYY-DDDThh:mm:ss[.d...]"


def parse(field: str, text: str, system: str) -> int:
    """Parse the text of an epoch to an instant, in ticks of 1e-14 s.

    The format is that of CCSDS 504.0-B-2, 6.8.9. In UTC the text may end in Z. 23:59:60 is an epoch
    on days with a leap second.  Raises InputError.
    """
    if system not in TIME_SYSTEMS:
        raise unknown("time_system", system, TIME_SYSTEMS)
    match = _EPOCH.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        raise InputError(field, repr(text), _FORMAT)
    year, month, number, *clock = match.groups()
    try:
        if month:
            day = date(int(year), *map(int, month.split("-"))).toordinal() - 1
        else:
            day = date(int(year), 1, 1).toordinal() - 2 + int(number)
            if number == "000" or date.fromordinal(day + 1).year != int(year):
                raise ValueError(number)
    except ValueError:
        raise InputError(field, repr(text), "there is no such day") from None
    hours, minutes, seconds = map(int, clock[:3])
    fraction, zulu = clock[3] or "", clock[4]
    if zulu and system != "UTC":
        raise InputError(field, repr(text), f"Z stands for UTC, not for {system}")
    if len(fraction) > DECIMALS:
        raise InputError(field, repr(text), f"must have at most {DECIMALS} decimals of a second")
    leap = system == "UTC" and (hours, minutes, seconds) == (23, 59, 60) and day in _LEAP_DAYS
    if hours > 23 or minutes > 59 or (seconds > 59 and not leap):
        raise InputError(field, repr(text), f"there is no such time of that day in {system}")
    if system == "UTC" and day < _UTC_STARTS:
        raise InputError(field, repr(text), "UTC has had SI seconds since 1972: take TAI")
    leaps = bisect_left(_LEAP_DAYS, day) if system == "UTC" else 0
    whole = day * DAY + leaps + hours * 3600 + minutes * 60 + seconds
    return whole * SECOND + int(fraction.ljust(DECIMALS, "0"))


# Days since 0001-01-01 at the zero of each count of days, and of the seconds of Unix.
_ZEROS = {"jd": Decimal("-1721425.5"), "mjd": Decimal(678575), "unix": Decimal(719162)}
FORMATS = ("seconds", "iso", *_ZEROS)
"Formats of times in tables: a number, an epoch in UTC, days, and seconds since 1970."
_OFFSET = re.compile(r"(.*:\d\d(?:\.\d+)?)\s*([+-])(\d\d):?(\d\d)", re.ASCII)
_EXACT = Context(prec=60)


def instant(field: str, text: str, layout: str, number: Decimal | None = None) -> int:
    """Convert a time of a table to an instant, in ticks of 1e-14 s.

    Days of "jd", "mjd" and "unix" have 86400 s, and are read exactly, as decimals.  An epoch "iso"
    is one of `parse` in UTC; it may have a blank for the T, and an offset from UTC such as +02:00.

    number: the number where the layout is not "iso".  Raises InputError.
    """
    if layout != "iso":
        assert number is not None
        days, seconds = (0, number) if layout == "unix" else (number, 0)
        whole = _EXACT.multiply(_EXACT.add(days, _ZEROS[layout]), DAY * SECOND)
        found = round(_EXACT.add(whole, _EXACT.multiply(seconds, SECOND)))
        if not 0 <= found < date.max.toordinal() * DAY * SECOND:
            rule = f"must lie in the years 1 to 9999, as {layout}: check --time-format"
            raise InputError(field, number, rule)
        return found
    offset = _OFFSET.fullmatch(text)
    ahead = 0
    if offset:
        text, sign, hours, minutes = offset.groups()
        ahead = int(f"{sign}1") * (int(hours) * 60 + int(minutes)) * 60 * SECOND
    return parse(field, re.sub(r"(?<=\d) +(?=\d)", "T", text, count=1), "UTC") - ahead


def later(instant: int, seconds: float) -> int:
    """Add seconds to an instant, and round the sum to a tick of 1e-14 s.

    A double is taken as its shortest decimal: 0.1 s later is .100, and subtracting the epoch again
    gives the same double.
    """
    return instant + round(Fraction(repr(seconds)) * SECOND)


def decimals(instants: Iterable[int]) -> int:
    """Return the least number of decimals needed to write the seconds of all instants exactly.

    It is at least 3.
    """
    common = math.gcd(SECOND, *instants)
    count = DECIMALS
    while count > FEWEST_DECIMALS and common % 10 == 0:
        common //= 10
        count -= 1
    return count


def printed(instant: int, system: str, digits: int) -> str:
    """Format an instant as YYYY-MM-DDThh:mm:ss with `digits` decimals.

    Raises InputError outside of the years with four digits, and for UTC before 1972.
    """
    seconds, fraction = divmod(instant, SECOND)
    leaps = _AFTER_LEAPS if system == "UTC" else []
    past = bisect_right(leaps, seconds)
    day, clock = divmod(seconds - past, DAY)
    if past < len(leaps) and seconds == leaps[past] - 1:
        day, clock = _LEAP_DAYS[past], DAY
    first = _UTC_STARTS if system == "UTC" else 0
    if not first <= day < date.max.toordinal():
        years = f"{date.fromordinal(first + 1).year} to 9999"
        raise InputError("times", "a time of the track", f"must lie in the years {years} {system}")
    whole = f"{clock // 3600:02}:{clock // 60 % 60:02}:{clock % 60:02}"
    if clock == DAY:
        whole = "23:59:60"
    decimal = f".{fraction:0{DECIMALS}}"[: digits + 1] if digits else ""
    return f"{date.fromordinal(day + 1).isoformat()}T{whole}{decimal}"
