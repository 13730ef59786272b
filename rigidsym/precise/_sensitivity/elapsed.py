"""Elliptic functions of the elapsed time in the formulas of sensitivities.

They are evaluated for one motion and over a box.

With p = lambda^2, r = m lambda^2 and 0 <= r <= p,

    S = sn(lambda t | m)/lambda,    C = cn,    D = dn,    E = int S^2,    f = D int S^2/D^2

from 0 to t: the integrals are J(u, n) = int sn^2/(1 - n sn^2) over lambda^3, with n = 0 and n = m.
Near the separatrix the second integral changes much from motion to motion; D times it hardly does.
On the separatrix, about an axis of symmetry, and where p vanishes, they are elementary.

Over a box of p, r and p - r they follow from the mean value theorem, whatever the signs of these.
The slopes need the values themselves.  So the values are guessed, and a guess that the slopes map
into its own interior is right: along the straight line from the middle to a point of the box the
functions start inside of the guess, and where they first met its border they would be inside.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from flint import arb, arb_mat

from rigidsym.precise._balls import intersection, power
from rigidsym.precise._functions import Functions, quarter_period
from rigidsym.solution._formulas import sequence

# The numbers of parts in which a box grows: the second where the first does not suffice.
PARTS, MORE_PARTS = 4, 16
# Guesses before giving up, and refinements of a right one.
TRIES, REFINED = 12, 2
# A guess is wider than the last image by a part of its radius, and a little.
MORE, LEAST = arb("0.25"), arb(2) ** -64
_POWER = {"power": power}


class Elapsed(NamedTuple):
    """Elliptic functions of elapsed time and their integrals, named as in formulas."""

    S_t: arb
    C_t: arb
    D_t: arb
    E_t: arb
    f: arb


def elapsed(t: arb, p: arb, r: arb, gap: arb, functions: Functions) -> Elapsed:
    """Evaluate the functions of elapsed time for one motion.

    gap: p - r.  A zero p or gap must be exactly zero.
    """
    if p.is_zero():
        cube = t * t * t / 3
        return Elapsed(t, arb(1), arb(1), cube, cube)
    rate, zero, m, mc = functions.kept(_modulus, p, r, gap)
    u = rate * t
    s, c, d = functions.jacobi(u, mc)
    if mc.is_zero():
        integrals = u - u.tanh(), ((2 * u).sinh() / 2 - u) / 2
    else:
        first = functions.elliptic_j(u, zero, mc)
        integrals = first, first if mc == 1 else functions.elliptic_j(u, m, mc)
    first, second = (x / (rate * p) for x in integrals)
    return Elapsed(s / rate, c, d, first, d * second)


def until_quarter(t: arb, p: arb, r: arb, gap: arb) -> bool:
    """Return True for a time within the first quarter of a period.

    cn and dn have no zero there.
    """
    if p.is_zero() or (gap.is_zero() and not r.is_zero()):
        return True
    return bool(abs(t) * p.sqrt() < quarter_period(gap / p))


def _modulus(p: arb, r: arb, gap: arb) -> tuple[arb, arb, arb, arb]:
    """Return a motion's frequency lambda, zero, the parameter m and its complement 1 - m.

    They are cached as the same objects for all times.
    """
    mc = arb(1) if r.is_zero() else gap / p
    return p.sqrt(), arb(0), 1 - mc, mc


@dataclass(frozen=True, slots=True)
class Range:
    """A time, and the ranges of elliptic parameters p, r, p - r over all motions of a box.

    grows: True if cn and dn of the middle surely have no zero before the time.
    """

    t: arb
    p: arb
    r: arb
    gap: arb
    grows: bool = False

    def over(self, middle: Elapsed, deviation: arb_mat) -> tuple[Elapsed, arb_mat] | None:
        """Enclose the functions of elapsed time over the box, with their slopes.

        The slopes (5, 2) are those by p and p - r.  Return None where no guess is right.

        `deviation` (2, 1) is p and p - r less their middles.  The box grows part by part, as slopes
        are smaller in its inner parts.
        """
        for parts in (PARTS, MORE_PARTS):
            part, summed, image = deviation / parts, arb_mat(5, 2), middle
            for _ in range(parts):
                start = Elapsed(*(arb_mat([[x] for x in middle]) + summed * part).entries())
                found = self._grown(start, image, part)
                if found is None:
                    break
                image, summed = found[0], summed + found[1]
            else:
                return image, summed / parts
        return None

    def _grown(
        self, start: Elapsed, inner: Elapsed, part: arb_mat
    ) -> tuple[Elapsed, arb_mat] | None:
        """Enclose the functions of elapsed time and their slopes over a larger box.

        The box is one part larger than that of the values so far.
        """
        image = self._image(start, inner, part)
        for _ in range(TRIES):
            guess = list(map(wider, image))
            image = self._image(start, Elapsed(*map(intersection, guess, self.limits)), part)
            if all(map(arb.contains_interior, guess, image)):
                for _ in range(REFINED):
                    image = self._image(start, image, part)
                return image, self.slopes(image)
        return None

    def _image(self, start: Elapsed, guess: Elapsed, part: arb_mat) -> Elapsed:
        moved = (self.slopes(guess) * part).entries()
        found = (x + step for x, step in zip(start, moved, strict=True))
        return Elapsed(*map(intersection, found, self.limits))

    def slopes(self, values: Elapsed) -> arb_mat:
        """Return the slopes (5, 2) of the functions of elapsed time in p and p - r.

        They hold at all given values.
        """
        known = {**values._asdict(), "F_t": values.f / values.D_t}
        given = {"p": self.p, "r": self.r, **known}
        # The integrals of fourth powers, by formulas and within bounds.
        fourths = sequence("fourth_powers").evaluate({**given, "t": self.t}, _POWER)
        most, steepest = self._largest(values)
        limits = (("U_t", most * values.E_t), ("V_t", most * known["F_t"]))
        for name, x in (*limits, ("W_t", steepest * known["F_t"])):
            given[name] = intersection(fourths[name], arb(0).union(x))
        found = sequence("elapsed_slopes").evaluate(given, _POWER)
        for way in ("k", "r"):
            found[f"f_{way}"] = found[f"D_{way}"] * known["F_t"] + values.D_t * found[f"F_{way}"]
        names = [name[0] for name in Elapsed._fields]
        return arb_mat([[found[f"{x}_k"], -found[f"{x}_r"]] for x in names])

    def _largest(self, values: Elapsed) -> tuple[arb, arb]:
        """Return upper bounds of (sn/lambda)^2 and (sn/(lambda dn))^2 from 0 to the time.

        They are S^2 and (S/D)^2.  Both grow until C or D is zero, so before that the last values
        are bounds; else 1/p and 1/(p - r) are.  C and D surely have no zero if they have none at
        the middle, and none at the end for any parameters, as zeros enter at the end; or if a
        quarter of a period is longer.
        """
        grow = self.grows and values.C_t > 0 and values.D_t > 0
        if not grow and self.p > 0 and self.gap >= 0:
            quarter = quarter_period((self.gap / self.p).upper())
            grow = abs(self.t) * self.p.upper().sqrt() < quarter
        s, d = values.S_t, values.D_t
        squares = power(s, 2), power(s / d, 2)
        first, second = squares if grow else (1 / self.p, 1 / self.gap)
        return first.upper(), second.upper()

    @property
    def limits(self) -> Sequence[arb]:
        """Bounds of the functions of elapsed time at all times, NaN for a function without any."""
        if not self.p > 0:
            return [arb.nan()] * 5
        most = (1 - self.r / self.p).upper().max(1).sqrt()
        least = (self.gap / self.p).lower().sqrt()
        size = (1 / self.p).sqrt().upper()
        return arb(0, size), arb(0, 1), least.union(most), arb.nan(), arb.nan()


def wider(image: arb) -> arb:
    """Return a slightly wider ball around the given one, as the next guess."""
    return image + arb(0, image.rad() * MORE + LEAST)
