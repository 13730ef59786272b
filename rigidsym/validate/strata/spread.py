"""Numbers that few indices already spread over a whole range, and more of them fill."""

from fractions import Fraction


def share(index: int, base: int = 2) -> float:
    """The index-th of a sequence that fills [0, 1] evenly from its beginning, both ends first.

    Behind the ends it is van der Corput's, whose bases make independent coordinates.

    >>> [share(index) for index in range(7)]
    [0.0, 1.0, 0.5, 0.25, 0.75, 0.125, 0.625]
    """
    if index < 2:
        return float(index)
    index, value, unit = index - 1, 0.0, 1.0
    while index:
        index, digit = divmod(index, base)
        unit /= base
        value += digit * unit
    return value


def spread(index: int, first: float, last: float, base: int = 2) -> float:
    """A number from first to last, both included, by `share`."""
    return first + (last - first) * share(index, base)


def decade(index: int, first: float, last: float) -> float:
    """A double from 10^-first to 10^-last, evenly over the decades."""
    return 10.0 ** -spread(index, first, last)


def exact_decade(index: int, first: int, last: int) -> Fraction:
    """A power of ten, exactly: from 10^-first to 10^-last."""
    return Fraction(1, 10 ** round(spread(index, first, last)))
