"""Data schema of validation reports, the columns of their tables, and number formats.

The schema is rigidsym.validation/3.  A figure is a number, or "inf" or "nan", for which JSON has no
number.  Errors and bounds are in units of 2^-53.  A report has the keys

* schema, command, passed, complaints, unit; run, what the campaign ran on; campaign, its options;
* bounds and meanings, by measure; agreement, the tolerance of the oracles;
* strata: name, about, and the keys of `COLUMNS` each;
* implementations: name, peer, digest (None for a peer), passed; share, the largest part of a bound
  by stratum; strata, shares and regimes, cells by part and measure; distance, turned and condition,
  cells by measure and decade; sizes, counts by stratum, measure and half octave;
* worst, a list of cases; failures: line, target, measure, stratum, index, share, and simplest, a
  case.

A cell is the worst of `count` figures: its units, condition, case and time t; of shares, `units` is
the part of the bound and `count` the number beyond it.  A case has its name (case), regime,
distance, replay (the command that runs it again), errors by implementation and measure (units,
condition, share, t), and its inputs without loss: inertia, omega0, attitude0 and times, doubles in
hexadecimal and other numbers as fractions.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from rigidsym.validate._report import ValidationReport

Figure = float | str
Data = Mapping[str, Any]
# Decades of the condition end here: beyond it are exponentials of times.
MOST_CONDITION = 1e40
ULP = 2.0**-53
KAPPA = "\N{GREEK SMALL LETTER KAPPA}"
TIMES = "\N{MULTIPLICATION SIGN}"
UNIT = "2\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT FIVE}\N{SUPERSCRIPT THREE}"
_EVERYWHERE = ("page", "card", "markdown", "terminal")
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(figure: Figure) -> float:
    """Convert a reported number to a float, with infinity for NaN."""
    value = float(figure)
    return math.inf if math.isnan(value) else value


def units(figure: Figure, digits: int = 3) -> str:
    """Format a reported number to three digits, or as "no number" if it is infinite.

    >>> units(9.9), units(18.0), units(4.2e12), units(0.0), units("inf")
    ('9.90', '18.0', '4.20e12', '0', 'no number')
    """
    value = number(figure)
    if math.isinf(value):
        return "no number"
    return _tidy(f"{value:#.{digits}g}") if value else "0"


def brief(figure: Figure) -> str:
    """Format a reported number to three digits, or as "< 0.01" if it is small.

    >>> brief(3.91e-36), brief(0.0), brief(4.46)
    ('< 0.01', '0', '4.46')
    """
    return "< 0.01" if 0 < number(figure) < 0.01 else units(figure)


def condition(figure: Figure) -> str:
    """Format a condition number to two digits, or as "" if it is 1.

    >>> condition(4.88e5), condition(1.0)
    ('κ 4.9e5', '')
    """
    value = number(figure)
    return "" if value == 1 else f"{KAPPA} {'∞' if math.isinf(value) else units(value, 2)}"


def plain(figure: Figure, form: str = ".2g") -> str:
    """Format an error that is given in units of 2^-53 as a plain number.

    >>> plain(18.0), plain(4.5, ".2e")
    ('2e-15', '5.00e-16')
    """
    value = number(figure)
    return "no number" if math.isinf(value) else _tidy(f"{value * ULP:{form}}")


def share(figure: Figure) -> str:
    """Format the ratio of an error to its bound as a percentage or, above 1, as a multiple.

    >>> share(0.554), share(37.2) == f"37.2 {TIMES}", share("inf")
    ('55 %', True, 'no number')
    """
    value = number(figure)
    if value <= 1:
        return f"{100 * value:.0f} %"
    return units(value) if math.isinf(value) else f"{units(value)} {TIMES}"


def counted(*given: Figure) -> str:
    """Format an error, or a range between two errors, in units of 2^-53."""
    return f"{' to '.join(map(units, given))} {TIMES} {UNIT}"


def decimal(written: str) -> str:
    """Convert the text of a hexadecimal double or of a fraction to a decimal.

    It is the decimal of the nearest double.

    >>> decimal("-0x1.8p+1"), decimal("1/8")
    ('-3.0', '0.125')
    """
    return repr(float(Fraction(written)) if "/" in written else float.fromhex(written))


def seconds(written: str) -> str:
    """Format a time, given as a hexadecimal double, to six digits in seconds.

    >>> seconds("0x1.8p+1")
    '3 s'
    """
    return f"{_tidy(f'{float.fromhex(written):.6g}')} s"


def power(base: int, exponent: float) -> str:
    """Format a power with a superscript.

    >>> power(10, -15), power(10, 0)
    ('10⁻¹⁵', '1')
    """
    return f"{base}{f'{exponent:g}'.translate(_RAISED)}" if exponent else "1"


def exponent(part: str) -> float:
    """Parse the exponent from the name of a decade or half octave, such as "1e-15".

    >>> exponent("1e-15"), exponent("2^-1.5"), exponent("0"), exponent("inf")
    (-15.0, -1.5, -inf, inf)
    """
    return -math.inf if part == "0" else float(part.removeprefix("1e").removeprefix("2^"))


def place(cell: Data) -> str:
    """Format the case, the time and the condition number at which an error occurred."""
    known = condition(cell["condition"])
    return f"{cell['case']} at t = {seconds(cell['t'])}{known and ', '}{known}"


def _tidy(written: str) -> str:
    """Shorten the text of a number with an exponent, such as 1.e+06 to 1e6."""
    mantissa, mark, power_of_ten = written.partition("e")
    mantissa = mantissa.removesuffix(".")
    return f"{mantissa}e{int(power_of_ten)}" if mark else mantissa


class Column(NamedTuple):
    """Column of the report tables that have a row for each stratum.

    It has a key in the data, a title and a value.  `shown` formats the value, `bad` marks strata,
    and `tables` are those that have the column: "page", "card", "markdown" and "terminal". A new
    entry of `COLUMNS` needs no change elsewhere.
    """

    key: str
    title: str
    value: Callable[["ValidationReport", str], Figure]
    shown: Callable[[Figure], str]
    bad: Callable[[Data], bool]
    tables: Sequence[str]


COLUMNS = (
    Column(
        "cases",
        "cases",
        lambda report, stratum: report.tally.cases.get(stratum, 0),
        str,
        lambda stratum: not stratum["cases"],
        _EVERYWHERE,
    ),
    Column(
        "states",
        "states",
        lambda report, stratum: report.tally.states.get(stratum, 0),
        str,
        lambda stratum: not stratum["cases"],
        _EVERYWHERE,
    ),
    Column(
        "disagreement",
        "oracles",
        lambda report, stratum: report.agreement(stratum),
        units,
        lambda stratum: number(stratum["disagreement"]) > 1,
        ("page",),
    ),
)


def columns_of(table: str) -> list[Column]:
    """Return the columns of a report's table for one output, such as "page" or "terminal"."""
    return [column for column in COLUMNS if table in column.tables]
