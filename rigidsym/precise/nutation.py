"""Between which angles the body nods: its circulation axis, against the momentum."""

from math import atan2

from rigidsym.precise.motion import PreciseMotion

_DIGITS = 20
_NAMES = ("A_a", "A_b", "A_d", "k_c")


def nutation(motion: PreciseMotion) -> tuple[float, float]:
    """The least and the largest angle of axis a, at its nearer end, from the momentum, rad.

    Of the rates A_a dn, A_b sn and A_d cn the first is largest where sn = 0, and smallest, k_c A_a,
    where sn is 1 or -1 (facts regular.dn, descended.k_c).  Both are zero where the rates are
    constant, and the largest is a right angle on the separatrix.
    """
    polhode = motion.polhode
    if polhode.regime.steady:
        return 0.0, 0.0
    a, b, d = (float(motion.exact[0][k]) for k in polhode.axes)
    found = motion.constants(_NAMES, _DIGITS)
    along, across, other, least = (float(found[name]) for name in _NAMES)
    return atan2(d * other, a * along), atan2(b * across, a * along * least)
