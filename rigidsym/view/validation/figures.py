"""Figures of a report as numbers, and numbers as a reader wants them."""

import math
from fractions import Fraction

from rigidsym.validate.bounds import MEASURES, ULP
from rigidsym.view.report_data import Figure, Report

NOTHING = "\N{EN DASH}"
KAPPA = "\N{GREEK SMALL LETTER KAPPA}"
TIMES = "\N{MULTIPLICATION SIGN}"
UNIT = "2\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT FIVE}\N{SUPERSCRIPT THREE}"
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(figure: Figure) -> float:
    """A figure of the report; what is no number is infinitely wrong."""
    value = float(figure)
    return math.inf if math.isnan(value) else value


def units(figure: Figure, digits: int = 3) -> str:
    """To three digits, "no number" for what is infinite.

    >>> units(9.9), units(18.0), units(4.2e12), units(0.0), units("inf")
    ('9.90', '18.0', '4.20e12', '0', 'no number')
    """
    value = number(figure)
    if math.isinf(value):
        return "no number"
    return _tidy(f"{value:#.{digits}g}") if value else "0"


def brief(figure: Figure) -> str:
    """The same, with no digits of what is hardly anything.

    >>> brief(3.91e-36), brief(0.0), brief(4.46)
    ('< 0.01', '0', '4.46')
    """
    return "< 0.01" if 0 < number(figure) < 0.01 else units(figure)


def condition(figure: Figure) -> str:
    """A condition number to two digits; nothing where it is 1, of what has none.

    >>> condition(4.88e5), condition(1.0)
    ('κ 4.9e5', '')
    """
    value = number(figure)
    return "" if value == 1 else f"{KAPPA} {'∞' if math.isinf(value) else units(value, 2)}"


def plain(figure: Figure) -> str:
    """A figure in units of 2^-53, as the number it stands for.

    >>> plain(18.0)
    '2e-15'
    """
    value = number(figure)
    return "no number" if math.isinf(value) else _tidy(f"{value * ULP:.2g}")


def scientific(figure: Figure) -> str:
    """The same to three digits, always with an exponent.

    >>> scientific(4.5)
    '5.00e-16'
    """
    value = number(figure)
    return "no number" if math.isinf(value) else _tidy(f"{value * ULP:.2e}")


def share(figure: Figure) -> str:
    """A part of a bound: per cent within it, and how many times it beyond.

    >>> share(0.554), share(37.2) == f"37.2 {TIMES}", share("inf")
    ('55 %', True, 'no number')
    """
    value = number(figure)
    if math.isinf(value):
        return "no number"
    if value <= 1:
        return f"{100 * value:.0f} %"
    return f"{units(value)} {TIMES}"


def counted(*given: Figure) -> str:
    """So many units, or from so many to so many."""
    return f"{' to '.join(map(units, given))} {TIMES} {UNIT}"


def decimal(written: str) -> str:
    """A number of a case, a double in hexadecimal or a fraction, as a double's decimal.

    >>> decimal("-0x1.8p+1"), decimal("1/8")
    ('-3.0', '0.125')
    """
    value = float(Fraction(written)) if "/" in written else float.fromhex(written)
    return repr(value)


def seconds(written: str) -> str:
    """A time in hexadecimal, to six digits.

    >>> seconds("0x1.8p+1")
    '3 s'
    """
    return f"{_tidy(f'{float.fromhex(written):.6g}')} s"


def power(base: int, exponent: float) -> str:
    """A power with its exponent raised.

    >>> power(10, -15), power(10, 0)
    ('10⁻¹⁵', '1')
    """
    return f"{base}{f'{exponent:g}'.translate(_RAISED)}" if exponent else "1"


def decade(part: str) -> float:
    """The exponent of a decade; -inf for "0", inf for "inf".

    >>> decade("1e-15"), decade("0"), decade("inf")
    (-15.0, -inf, inf)
    """
    return _exponent(part, "1e")


def half_octave(part: str) -> float:
    """The exponent of a half octave.

    >>> half_octave("2^-1.5"), half_octave("0")
    (-1.5, -inf)
    """
    return _exponent(part, "2^")


def measures(data: Report) -> list[str]:
    """What is measured, in the order of its definition."""
    known = [name for name in MEASURES if name in data["bounds"]]
    return known + sorted(set(data["bounds"]) - set(known))


def _exponent(part: str, base: str) -> float:
    if part in ("0", "inf"):
        return math.inf if part == "inf" else -math.inf
    return float(part.removeprefix(base))


def _tidy(written: str) -> str:
    """1.e+06 as 1e6."""
    mantissa, mark, exponent = written.partition("e")
    mantissa = mantissa.removesuffix(".")
    return f"{mantissa}e{int(exponent)}" if mark else mantissa
