"""By Carlson's symmetric integrals: R_F inverted, and R_J.

The inverse is found by Newton's method and then seen to be one: a step of interval Newton maps a
ball into its own interior.
"""

from flint import acb, arb, ctx

from rigidsym.precise.amplitude import Functions, Triple, carlson_f
from rigidsym.precise.landen import amplitude


class Carlson(Functions):
    """The method `carlson`."""

    def first_half(self, u: arb, mc: arb) -> Triple:
        """The amplitude phi with F(phi) = u, then its sine, cosine and dn."""
        start = amplitude(u.mid(), mc.mid()).mid()  # a guess, whatever it is
        for _ in range(3):
            value, slope = first_kind(start, mc)
            start = (start - (value - u) / slope).mid()
        value, slope = first_kind(start, mc)
        reach = 2 * ((value - u) / slope).abs_upper() + arb(2) ** (-ctx.prec // 2)
        box = start + arb(0, reach)
        phi = start - (value - u) / first_kind(box, mc)[1]
        # F(start) is what R_F says it is where the cosine is positive.
        if not (box.contains_interior(phi) and start.cos() > 0):
            phi = arb.nan()
        s, c = phi.sin_cos()
        return s, c, _delta(s, c, mc)

    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """s^3 R_J(c^2, d^2, 1, 1 - n s^2)/3 (DLMF 19.25.14)."""
        s, c, d = self.kept(self.first_half, u, mc)
        return s * s * s * acb.elliptic_rj(c * c, d * d, arb(1), 1 - n * s * s).real / 3

    def complete_j(self, n: arb, mc: arb) -> arb:
        """R_J(0, mc, 1, 1 - n)/3."""
        return acb.elliptic_rj(arb(0), mc, arb(1), 1 - n).real / 3


def first_kind(phi: arb, mc: arb) -> tuple[arb, arb]:
    """F(phi) = s R_F(c^2, d^2, 1) and its derivative 1/d."""
    s, c = phi.sin_cos()
    d = _delta(s, c, mc)
    return s * carlson_f(c * c, d * d, arb(1)), 1 / d


def _delta(s: arb, c: arb, mc: arb) -> arb:
    """dn = sqrt(c^2 + mc s^2), no difference in it."""
    return (c * c + mc * s * s).sqrt()
