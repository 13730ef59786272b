"""States by mpmath alone, each computed twice: what the two leave open is the error they have.

In the regimes that move between the edges one of the two is the form with the integral of the third
kind and the other the theta form, which share the functions sn, cn and dn and nothing else; on the
edges the second is the first at a higher precision.  A number and its error travel as a ball, which
is an estimate here: nothing proves it.
"""

from abc import ABC, abstractmethod
from typing import Any

from flint import arb
from mpmath import mpf

from rigidsym.precise.apart import Asked
from rigidsym.precise.balls import of_mpf
from rigidsym.precise.evaluation import Evaluation, Given
from rigidsym.precise.floating import CTX, Floating
from rigidsym.precise.theorem1 import Theorem1

# By how much the second precision is above the first.
MORE_BITS = 64


class Estimates(ABC):
    """One motion at the working precision, by mpmath's functions."""

    quick_bits = 2**12

    def __init__(self, given: Given, bits: int) -> None:
        self.bits = bits
        with CTX.workprec(bits):
            self._first = self.first(given)
        with CTX.workprec(bits + MORE_BITS):
            self._second = self.second(given)

    @staticmethod
    @abstractmethod
    def first(given: Given) -> "Evaluation[Any] | Theorem1":
        """What computes states at the lower precision."""

    @staticmethod
    @abstractmethod
    def second(given: Given) -> "Evaluation[Any] | Theorem1":
        """What computes them at the higher one."""

    @property
    def start(self) -> tuple[list[mpf], list[mpf]]:
        """(q, omega) at t = 0."""
        return self._second.start

    def numbers(self, asked: Asked) -> list[arb]:
        """The seven numbers of the state at a time, or constants by their names."""
        try:
            with CTX.workprec(self.bits):
                first = self._first.numbers(asked)
            with CTX.workprec(self.bits + MORE_BITS):
                second = self._second.numbers(asked)
        except ZeroDivisionError:  # of what is too small for this precision
            return [arb.nan()] * (len(asked) if isinstance(asked, tuple) else 7)
        return [self._estimated(*pair) for pair in zip(first, second, strict=True)]

    def _estimated(self, first: mpf, second: mpf) -> arb:
        """The second, with twice the difference and a rounding of the first for its radius."""
        if not CTX.isfinite(first) or not CTX.isfinite(second):
            return arb.nan()
        value, other = of_mpf(second), of_mpf(first)
        return value + arb(0, (2 * (value - other)).abs_upper() + abs(value) * arb(2) ** -self.bits)


class ByMpmath(Estimates):
    """The method `mpmath`."""

    @staticmethod
    def first(given: Given) -> Evaluation[Any]:
        """By the integral of the third kind."""
        return Evaluation(given, Floating().table(), CTX.convert)

    @staticmethod
    def second(given: Given) -> Evaluation[Any]:
        """By theta functions, between the edges."""
        return Evaluation(given, Floating().theta_table(), CTX.convert)


class ByTheorem1(Estimates):
    """The method `theorem1`, at two precisions."""

    @staticmethod
    def first(given: Given) -> Theorem1:
        """By the paper's Theorem 1."""
        return Theorem1(given)

    second = first
