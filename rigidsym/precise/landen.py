"""By Landen's and Gauss's descending transformations, down to where trigonometry is near enough.

At the bottom the parameter is m_N, and |am(u) - u| <= m_N |u| since 1 - m <= dn <= 1; there the
integral of the third kind lies within the factor 1/sqrt(1 - m_N) of the trigonometric one.
"""

from flint import acb, arb, ctx

from rigidsym.precise.amplitude import Functions, Triple, quarter_period


class Landen(Functions):
    """The method `landen`."""

    def first_half(self, u: arb, mc: arb) -> Triple:
        """The amplitude by the AGM (DLMF 22.20(ii)), then its sine, cosine and dn."""
        phi = amplitude(u, mc)
        s, c = phi.sin_cos()
        return s, c, (c * c + mc * s * s).sqrt()

    def first_half_j(self, u: arb, n: arb, mc: arb) -> arb:
        """(Pi - u)/n."""
        s, c, d = self.first_half(u, mc)
        return (_third_kind(s, c, d, n, 1 - mc, mc, u) - u) / n

    def complete_j(self, n: arb, mc: arb) -> arb:
        """(Pi(n | m) - K)/n."""
        one, zero = arb(1), arb(0)
        quarter = quarter_period(mc)
        return (_third_kind(one, zero, mc.sqrt(), n, 1 - mc, mc, quarter) - quarter) / n


def amplitude(u: arb, mc: arb) -> arb:
    """am(u | 1 - mc), |u| <= K."""
    a, b = arb(1), mc.sqrt()
    ratios, narrows = [], True
    while narrows:  # each step halves the gap at least, until it is all rounding or uncertainty
        gap, mean = a - b, (a + b) / 2
        ratios.append(gap / (2 * mean))
        a, b = mean, (a * b).sqrt()
        narrows = 4 * (a - b).abs_upper() < 3 * gap.abs_upper()
    parameter = 1 - (b / a) ** 2
    phi = 2 ** len(ratios) * a * u
    phi += arb(0, (parameter * phi).abs_upper())
    for ratio in reversed(ratios):
        phi = (phi + (ratio * phi.sin()).asin()) / 2
    return phi


def _third_kind(s: arb, c: arb, d: arb, n: arb, m: arb, mc: arb, u: arb) -> arb:
    """Pi(n; phi | m) of an amplitude in [0, pi/2], by Gauss's transformation (DLMF 19.8.20).

    rho Pi = 4/(1 + k') Pi_1 + (rho - 1) u - R_C(1/s^2 - 1, 1/s^2 - n), until m is gone.
    """
    if m.abs_upper() < arb(2) ** -ctx.prec:
        root = (1 - n).sqrt()
        value = arb.atan2(root * s, c) / root
        return value + arb(0, (value * m).abs_upper())
    kc = mc.sqrt()
    rho, k_1 = (1 - m / n).sqrt(), m / (1 + kc) ** 2
    d_1 = ((1 - k_1 + d * (1 + k_1)) / (1 + d)).sqrt()
    s_1, c_1 = (1 + kc) * s / (1 + d), 2 * c / ((1 + d) * d_1)
    n_1, mc_1 = n * ((1 + rho) / (1 + kc)) ** 2, 4 * kc / (1 + kc) ** 2
    below = _third_kind(s_1, c_1, d_1, n_1, k_1 * k_1, mc_1, u / (1 + k_1))
    turned = s * acb.elliptic_rc(c * c, 1 - n * s * s).real
    return (4 / (1 + kc) * below + (rho - 1) * u - turned) / rho
