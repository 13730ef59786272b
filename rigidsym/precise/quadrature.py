"""By rigorous quadrature: J is integrated over the amplitude, as psi' is over time."""

from flint import acb, arb, ctx

from rigidsym.precise.carlson import Carlson


class Quadrature(Carlson):
    """The method `quadrature`; sn, cn and dn are those of Carlson's."""

    quick_bits = 2**10

    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """The integral of sin^2/((1 - n sin^2) Delta) from 0 to am(u)."""
        s, c, _ = self.kept(self.first_half, u, mc)
        return _integral(arb.atan2(s, c), n, mc)

    def complete_j(self, n: arb, mc: arb) -> arb:
        """The same to pi/2."""
        return _integral(arb.pi() / 2, n, mc)


def _integral(phi: arb, n: arb, mc: arb) -> arb:
    if not (phi.is_finite() and n.is_finite() and mc.is_finite()):
        return arb.nan()
    # No finer than the numbers that go in.
    sharp = [x.rel_accuracy_bits() for x in (phi, mc, 1 - n)]
    tolerance = arb(2) ** -max(1, min(ctx.prec, *sharp))

    def integrand(angle: acb, analytic: bool) -> acb:
        sine, cosine = angle.sin_cos()
        square = sine * sine
        delta = (cosine * cosine + mc * square).sqrt(analytic=analytic)
        return square / ((1 - n * square) * delta)

    return acb.integral(integrand, 0, phi, rel_tol=tolerance, abs_tol=tolerance).real
