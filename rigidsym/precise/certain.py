"""Numbers of mpmath that show the digits that are certain of them."""

from collections.abc import Iterable

from mpmath import mp, mpf


class CertainNumber(mpf):
    """A number of mpmath's like any other, but that it prints as many digits as were asked for.

    What is computed from it is an ordinary number, of the precision that mpmath has then.
    """

    __slots__ = ("digits",)
    digits: int

    def __repr__(self) -> str:
        return f"mpf('{self}')"

    def __str__(self) -> str:
        return mp.nstr(self, self.digits, strip_zeros=False)

    def __reduce__(self) -> tuple[object, ...]:
        return _made, (self.__getstate__(), self.digits)


def certain(values: Iterable[mpf], digits: int) -> list[CertainNumber]:
    """The same numbers, unrounded, of which so many digits are certain."""
    return [_made(value.__getstate__(), digits) for value in values]


def _made(state: object, digits: int) -> CertainNumber:
    # Calling the class would round to mpmath's precision.
    number = object.__new__(CertainNumber)
    number.__setstate__(state)
    number.digits = digits
    return number
