"""The functions of elapsed time over all of a box, by the theorem of the mean, whatever the signs
of p, r and p - r in it.

Slopes need the values that they are to give.  So these are guessed, and a guess that slopes send
into its own interior is right: along the straight line from the middle to a point of the box the
functions start inside of the guess, and where they first met its border they would be inside.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from rigidsym.precise.amplitude import quarter_period
from rigidsym.precise.balls import meeting, power
from rigidsym.precise.sensitivity.elapsed import Elapsed
from rigidsym.solution.formulas import sequence

# In how many parts a box grows: more where few do not serve.
PARTS, MORE_PARTS = 4, 16
TRIES, REFINED = 12, 2
# By how much a guess is wider than the image of the one before: a part of it, and a little.
MORE, LEAST = arb("0.25"), arb(2) ** -64
POWER = {"power": power}


@dataclass(frozen=True, slots=True)
class Range:
    """A time, and balls of p, r and p - r of all motions of a box.

    grows: whether cn and dn of the middle are known to have no zero on the way there.
    """

    t: arb
    p: arb
    r: arb
    gap: arb
    grows: bool = False

    def over(self, middle: Elapsed, apart: arb_mat) -> tuple[Elapsed, arb_mat] | None:
        """The functions, and slopes (5, 2) by p and p - r; `apart` (2, 1) is these less their
        middles.

        The box grows part by part, as slopes are smaller in its inner parts.  None where no guess
        is found.
        """
        return self._over(middle, apart, PARTS) or self._over(middle, apart, MORE_PARTS)

    def _over(self, middle: Elapsed, apart: arb_mat, parts: int) -> tuple[Elapsed, arb_mat] | None:
        part, summed, image = apart / parts, arb_mat(5, 2), middle
        for _ in range(parts):
            start = Elapsed(*(arb_mat([[x] for x in middle]) + summed * part).entries())
            found = self._grown(start, image, part)
            if found is None:
                return None
            image, slopes = found
            summed += slopes
        return image, summed / parts

    def _grown(
        self, start: Elapsed, inner: Elapsed, part: arb_mat
    ) -> tuple[Elapsed, arb_mat] | None:
        """By one part more: functions and slopes there, `start` being what slopes led to so far."""
        image = self._image(start, inner, part)
        for _ in range(TRIES):
            guess = list(map(wider, image))
            image = self._image(start, Elapsed(*map(meeting, guess, self.limits)), part)
            if all(map(arb.contains_interior, guess, image)):
                for _ in range(REFINED):
                    image = self._image(start, image, part)
                return image, self.slopes(image)
        return None

    def _image(self, start: Elapsed, guess: Elapsed, part: arb_mat) -> Elapsed:
        moved = (self.slopes(guess) * part).entries()
        found = (x + step for x, step in zip(start, moved, strict=True))
        return Elapsed(*map(meeting, found, self.limits))

    def slopes(self, values: Elapsed) -> arb_mat:
        """The derivatives (5, 2) by p and p - r at all values."""
        known = {**values._asdict(), "F_t": values.f / values.D_t}
        found = sequence("elapsed_slopes").evaluate(
            {"p": self.p, "r": self.r, **known, **self._fourths(values, known)}, POWER
        )
        for way in ("k", "r"):
            found[f"f_{way}"] = found[f"D_{way}"] * known["F_t"] + values.D_t * found[f"F_{way}"]
        names = [name[0] for name in Elapsed._fields]
        return arb_mat([[found[f"{x}_k"], -found[f"{x}_r"]] for x in names])

    def _fourths(self, values: Elapsed, known: Mapping[str, arb]) -> dict[str, arb]:
        """The integrals of fourth powers: by formulas, and between bounds."""
        found = sequence("fourth_powers").evaluate(
            {"t": self.t, "p": self.p, "r": self.r, **known}, POWER
        )
        most, steepest = self._largest(values)
        by_e, by_f = values.E_t, known["F_t"]
        limits = {"U_t": most * by_e, "V_t": most * by_f, "W_t": steepest * by_f}
        return {name: meeting(found[name], arb(0).union(x)) for name, x in limits.items()}

    def _largest(self, values: Elapsed) -> tuple[arb, arb]:
        """Upper bounds of S^2 and (S/D)^2 so far: the last ones where neither C nor D has come to
        zero, since both grow till then; else 1/p and 1/(p - r)."""
        s, d = values.S_t, values.D_t
        squares = power(s, 2), power(s / d, 2)
        first, second = squares if self._grow(values) else (1 / self.p, 1 / self.gap)
        return first.upper(), second.upper()

    def _grow(self, values: Elapsed) -> bool:
        """Whether C and D have no zero so far: zeros come in from the end as parameters move away
        from the middle; or the quarter of a period is longer."""
        if self.grows and values.C_t > 0 and values.D_t > 0:
            return True
        if not (self.p > 0 and self.gap >= 0):
            return False
        quarter = quarter_period((self.gap / self.p).upper())
        return bool(abs(self.t) * self.p.upper().sqrt() < quarter)

    @property
    def limits(self) -> Sequence[arb]:
        """What the functions never leave, whatever the time is; no number where nothing is said."""
        if not self.p > 0:
            return [arb.nan()] * 5
        most = (1 - self.r / self.p).upper().max(1).sqrt()
        least = (self.gap / self.p).lower().sqrt()
        size = (1 / self.p).sqrt().upper()
        return arb(0, size), arb(0, 1), least.union(most), arb.nan(), arb.nan()


def wider(image: arb) -> arb:
    """A guess, after what another one led to."""
    return image + arb(0, image.rad() * MORE + LEAST)
