"""Formats of the numbers of reports: errors in units of 2^-53, shares of bounds, times, powers."""

import math
from fractions import Fraction

from rigidsym.view._report_data import Cell, Figure

ULP = 2.0**-53
KAPPA = "\N{GREEK SMALL LETTER KAPPA}"
TIMES = "\N{MULTIPLICATION SIGN}"
UNIT = "2\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT FIVE}\N{SUPERSCRIPT THREE}"
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(figure: Figure) -> float:
    """Return a figure as a number: NaN counts as infinite."""
    value = float(figure)
    return math.inf if math.isnan(value) else value


def units(figure: Figure, digits: int = 3) -> str:
    """Return a figure to three digits, or "no number" if it is infinite.

    >>> units(9.9), units(18.0), units(4.2e12), units(0.0), units("inf")
    ('9.90', '18.0', '4.20e12', '0', 'no number')
    """
    value = number(figure)
    if math.isinf(value):
        return "no number"
    return _tidy(f"{value:#.{digits}g}") if value else "0"


def brief(figure: Figure) -> str:
    """Return a figure to three digits, or "< 0.01".

    >>> brief(3.91e-36), brief(0.0), brief(4.46)
    ('< 0.01', '0', '4.46')
    """
    return "< 0.01" if 0 < number(figure) < 0.01 else units(figure)


def condition(figure: Figure) -> str:
    """Return a condition number to two digits; "" if it is 1, which stands for none.

    >>> condition(4.88e5), condition(1.0)
    ('κ 4.9e5', '')
    """
    value = number(figure)
    return "" if value == 1 else f"{KAPPA} {'∞' if math.isinf(value) else units(value, 2)}"


def plain(figure: Figure) -> str:
    """Return a figure in units of 2^-53 as a plain number to two digits.

    >>> plain(18.0)
    '2e-15'
    """
    value = number(figure)
    return "no number" if math.isinf(value) else _tidy(f"{value * ULP:.2g}")


def scientific(figure: Figure) -> str:
    """Return a figure in units of 2^-53 as a plain number to three digits, with an exponent.

    >>> scientific(4.5)
    '5.00e-16'
    """
    value = number(figure)
    return "no number" if math.isinf(value) else _tidy(f"{value * ULP:.2e}")


def share(figure: Figure) -> str:
    """Return a part of a bound: per cent within the bound, a multiple beyond it.

    >>> share(0.554), share(37.2) == f"37.2 {TIMES}", share("inf")
    ('55 %', True, 'no number')
    """
    value = number(figure)
    if math.isinf(value):
        return "no number"
    if value <= 1:
        return f"{100 * value:.0f} %"
    return f"{units(value)} {TIMES}"


def percent(part: Figure) -> str:
    """Return the length of a bar for a part of a bound, in per cent.

    >>> percent(0.554), percent(37.2)
    ('55%', '100%')
    """
    return f"{100 * min(number(part), 1):.0f}%"


def counted(*given: Figure) -> str:
    """Return one figure, or a range of two, with its unit."""
    return f"{' to '.join(map(units, given))} {TIMES} {UNIT}"


def decimal(written: str) -> str:
    """Return a number of a case, a hexadecimal double or a fraction, as the decimal of a double.

    >>> decimal("-0x1.8p+1"), decimal("1/8")
    ('-3.0', '0.125')
    """
    value = float(Fraction(written)) if "/" in written else float.fromhex(written)
    return repr(value)


def seconds(written: str) -> str:
    """Return a hexadecimal time to six digits.

    >>> seconds("0x1.8p+1")
    '3 s'
    """
    return f"{_tidy(f'{float.fromhex(written):.6g}')} s"


def power(base: int, exponent: float) -> str:
    """Return a power with a superscript.

    >>> power(10, -15), power(10, 0)
    ('10⁻¹⁵', '1')
    """
    return f"{base}{f'{exponent:g}'.translate(_RAISED)}" if exponent else "1"


def decade(part: str) -> float:
    """Return the exponent of a decade; -inf for "0", inf for "inf".

    >>> decade("1e-15"), decade("0"), decade("inf")
    (-15.0, -inf, inf)
    """
    return _exponent(part, "1e")


def half_octave(part: str) -> float:
    """Return the exponent of a half octave.

    >>> half_octave("2^-1.5"), half_octave("0")
    (-1.5, -inf)
    """
    return _exponent(part, "2^")


def place(cell: Cell) -> str:
    """Return the case and time of a cell, and its condition if it has one."""
    known = condition(cell["condition"])
    return f"{cell['case']} at t = {seconds(cell['t'])}{known and ', '}{known}"


def _exponent(part: str, base: str) -> float:
    if part in ("0", "inf"):
        return math.inf if part == "inf" else -math.inf
    return float(part.removeprefix(base))


def _tidy(written: str) -> str:
    """Return 1.e+06 as 1e6."""
    mantissa, mark, exponent = written.partition("e")
    mantissa = mantissa.removesuffix(".")
    return f"{mantissa}e{int(exponent)}" if mark else mantissa
