"""Floating-point formats of generated code, and the lengths of series that they need.

A series is as long as its proved truncation error is small: below the last bit of a pair of numbers
in what grows with time, and of a number elsewhere.  `special_functions` computes these bounds.
"""

from dataclasses import dataclass
from fractions import Fraction
from math import ceil, frexp, ldexp, log

import mpmath
from mpmath import mpf


@dataclass(frozen=True, slots=True)
class Format:
    """Floating-point format, and the number of terms or steps of each special function.

    The format:

    * digits: bits of a number; a pair of numbers has twice as many.
    * largest: all finite numbers are below 2^largest.
    * never: a number that stands for an infinite exponent.
    * is_wide: True if all constants of a motion are computed as pairs; False if only those are
      whose errors grow with time.

    Lengths of series, and numbers of steps:

    * arctangent: the terms computed as pairs, and all terms.
    * log_2: bits of the first part of log 2, so few that its products with exponents are exact.
    * doublings: how often the shortest time of a step is doubled; in the `last` of these doublings
      the projection is computed as pairs.
    * elapsed, third_kind: terms of the series of a step.
    * moderate: rates of a step from 2^moderate on, or below its inverse, are scaled.
    * circular, hyperbolic: the largest index of the thetas in a state, that of their slopes, and
      the largest power of the nome that rates need.
    """

    name: str
    digits: int
    largest: int
    never: float
    is_wide: bool
    arctangent: tuple[int, int]
    exponential: int
    log_2: int
    landen: int
    nome: int
    trigonometric: int
    doublings: int
    last: int
    elapsed: int
    third_kind: int
    moderate: int
    circular: tuple[int, int, int]
    hyperbolic: tuple[int, int, int]

    @property
    def word(self) -> int:
        """The number of bits of a number, with its sign and exponent."""
        return self.digits + self.largest.bit_length()

    @property
    def least_exponential(self) -> float:
        """The least x, a whole number, for which e^x is a normal number."""
        return float(ceil((2 - self.largest) * log(2)))

    def numbers(self) -> dict[str, float]:
        """Return the numbers of this format that runtimes name.

        * LEAST, LARGEST: the least and largest positive numbers that scales are computed from.
        * LEAST_EXPONENT, MOST_EXPONENT: the exponents of the normal powers of two.
        * HALF_ULP: a number plus HALF_ULP times itself rounds to the next number.
        * ROUNDING: how far the largest moment may exceed the sum of the others, relative to the
          smallest.
        * MODERATE: rates of a step between its inverse and it are not scaled.
        * NORMALISES: whether a state is divided by its length at the end.
        * HIGH_IS_ROUNDED: whether the first number of a pair stands for the pair, except for ties.
        * The others mix words of bits, from which three random numbers are taken.
        """
        turn, chance = self.word // 3, (self.word - 2) // 3
        return {
            "STEPS": self.doublings,
            "LAST": self.last,
            "LEAST": ldexp(1.0, 3 - self.largest - self.digits),
            "LARGEST": ldexp(2.0 - ldexp(1.0, 1 - self.digits), self.largest - 1),
            "LEAST_EXPONENT": 2 - self.largest,
            "MOST_EXPONENT": self.largest - 1,
            "HALF_ULP": ldexp(1.0 + ldexp(1.0, 1 - self.digits), -self.digits),
            "ROUNDING": ldexp(1.0, 3 - self.digits),
            "MODERATE": ldexp(1.0, self.moderate),
            **dict.fromkeys(("NORMALISES", "HIGH_IS_ROUNDED"), not self.is_wide),
            **{"TURN": turn, "TURN_BACK": self.word - turn},
            **{"SECOND_TURN": 2 * turn, "SECOND_BACK": self.word - 2 * turn},
            "HALF_WORD": self.word // 2,
            "FACTOR": 0x9E3779B97F4A7C15 >> (64 - self.word) | 1,
            "SECOND_FACTOR": 0xD6E8FEB86659FD93 >> (64 - self.word) | 1,
            **{"CHANCE": chance, "SECOND_CHANCE": 2 * chance, "TOP": self.word - chance},
            "PLACE": self.digits - 1 - chance,
            "ONE_BITS": (self.largest - 1) << (self.digits - 1),
        }

    def arithmetic(self) -> dict[str, tuple[float, str]]:
        """Return the numbers that the arithmetic of pairs has by their names, with meanings."""
        half, fraction, bias = -(-self.digits // 2), self.digits - 1, self.largest - 1
        nearest = f"2^{fraction - 1}"
        return {
            "splitter": (ldexp(1.0, half) + 1.0, f"2^{half} + 1"),
            "rounder": (
                ldexp(1.5, fraction),
                f"3 {nearest}; in n + 3 {nearest} the last bits are those of the whole number n,"
                f" |n| < {nearest}",
            ),
            "least_whole": (
                ldexp(1.0, fraction),
                f"2^{fraction}: from here on numbers are whole",
            ),
            "exponent_bias": (float(bias), "what the exponent among the bits of 1 is"),
            "sign_place": (self.word - 1, "the place of the sign among the bits"),
            "exponent_place": (fraction, "the place of the exponent among the bits"),
            "one_bits": (bias << fraction, "the bits of 1"),
            "half_bits": (bias - 1 << fraction, "the bits of 1/2"),
            "least_whole_bits": (bias + fraction << fraction, f"the bits of 2^{fraction}"),
            "fraction_bits": ((1 << fraction) - 1, "all bits below the exponent"),
        }

    def rounded(self, value: float | Fraction | mpf) -> float:
        """Round a number to this format.

        >>> BINARY32.rounded(Fraction(1, 10))
        0.10000000149011612
        """
        if isinstance(value, mpf):
            with mpmath.workprec(self.digits):
                return float(+value)
        last = frexp(value)[1] - self.digits
        return ldexp(round(Fraction(value) / Fraction(2) ** last), last)

    def pair(self, value: Fraction | mpf) -> tuple[float, float]:
        """Round a number to the sum of two numbers of this format."""
        high = self.rounded(value)
        rest = value - Fraction(high) if isinstance(value, Fraction) else value - high
        return high, self.rounded(rest)


BINARY64 = Format(
    name="binary64",
    digits=53,
    largest=1024,
    never=1e300,
    is_wide=True,
    arctangent=(8, 17),
    exponential=9,
    log_2=32,
    landen=5,
    nome=4,
    trigonometric=8,
    doublings=5,
    last=2,
    elapsed=8,
    third_kind=12,
    moderate=40,
    circular=(7, 10, 25),
    hyperbolic=(4, 6, 18),
)
# Steps start at a shorter time, since a term of a series is more code than a doubling.
BINARY32 = Format(
    name="binary32",
    digits=24,
    largest=128,
    never=2.0**100,
    is_wide=False,
    arctangent=(3, 7),
    exponential=5,
    log_2=17,
    landen=4,
    nome=2,
    trigonometric=5,
    doublings=7,
    last=0,
    elapsed=4,
    third_kind=3,
    moderate=10,
    circular=(5, 6, 15),
    hyperbolic=(3, 3, 7),
)
