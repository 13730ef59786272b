"""By theta functions: no branch and no winding, a state costs two of Arb's theta evaluations."""

from flint import acb, arb

from rigidsym.precise.amplitude import Table, Triple, carlson_f, quarter_period
from rigidsym.precise.carlson import Carlson


class Theta(Carlson):
    """The method `theta`: the theta form, and sn, cn, dn as quotients of thetas (DLMF 22.2)."""

    quick_bits = 2**14

    def table(self) -> Table:
        """The functions of the theta form besides those of the other methods."""
        return {
            **super().table(),
            "pi": arb.pi(),
            "I": acb(0, 1),
            "re": lambda z: z.real,
            "im": lambda z: z.imag,
            "elliptic_k": quarter_period,
            "elliptic_pi": lambda n, mc: quarter_period(mc) + n * self.complete_j(n, mc),
            "nome": _nome,
            "arcsc": _arcsc,
            "theta4": lambda z, q: self.kept(self._theta4, z, q),
            "dtheta4": lambda z, q: _thetas(z, self.kept(_tau, q), 1)[3] / arb.pi(),
        }

    def between(self, u: arb, mc: arb) -> Triple:
        """Quotients of thetas (DLMF 22.2.4 to 22.2.6)."""
        scale, tau, two, three, four = self.kept(_constants, mc)
        one_u, two_u, three_u, four_u = (z.real for z in _thetas(acb(scale * u), tau))
        s = three * one_u / (two * four_u)
        return s, four * two_u / (two * four_u), four * three_u / (three * four_u)

    def first_half(self, u: arb, mc: arb) -> Triple:
        """As anywhere else."""
        return self.between(u, mc)

    def _theta4(self, z: acb, q: arb) -> acb:
        return _thetas(z, self.kept(_tau, q))[3]


def _thetas(z: acb, tau: acb, derivative: int = 0) -> tuple[acb, ...]:
    """theta_1 to theta_4 of z, reduced by whole turns 2 pi; Arb counts z in units of pi."""
    turns = z / arb.pi()
    whole = (turns.real / 2 + arb(1) / 2).mid().floor()
    return (turns - 2 * whole).modular_theta(tau, derivative)


def _tau(q: arb) -> acb:
    return acb(0, -q.log() / arb.pi())


def _nome(mc: arb) -> arb:
    """exp(-pi K'/K), the periods by the AGM."""
    return (-arb.pi() * arb(1).agm(mc.sqrt()) / arb(1).agm((1 - mc).sqrt())).exp()


def _arcsc(x: arb, mc: arb) -> arb:
    """The u >= 0 with sc(u | 1 - mc) = x >= 0: F(arctan x)."""
    square = 1 + x * x
    s, c, dd = x / square.sqrt(), 1 / square.sqrt(), (1 + mc * x * x) / square
    return s * carlson_f(c * c, dd, arb(1))


def _constants(mc: arb) -> tuple[arb, acb, arb, arb, arb]:
    """pi/(2 K), tau, and theta_2, theta_3, theta_4 of zero."""
    tau = _tau(_nome(mc))
    _, two, three, four = (z.real for z in _thetas(acb(0), tau))
    return arb.pi() / (2 * quarter_period(mc)), tau, two, three, four
