"""Jacobi's elliptic functions and their kin over NumPy arrays, in the complement mc = 1 - m.

With mc as the input nothing is lost as m -> 1, where cn and dn fade away and only their
relative errors matter.  Every function broadcasts and none of them warns.
"""

import numpy as np

# The square of anything fainter than this is lost beside 1: there leading terms are exact.
_FAINT = 1e-8


def _agm_steps(mc):
    """List the pairs (a, b) of the AGM of 1 and sqrt(mc); their last mean is its limit.

    DLMF 19.8(i).  The AGM of 1 and 0 would halve for ever: mc = 0 is taken for mc = 1.
    """
    b = np.sqrt(np.where(mc == 0, 1.0, mc))
    a = np.ones_like(b)
    steps = [(a, b)]
    while np.any(a - b > _FAINT * a):
        a, b = (a + b) / 2, np.sqrt(a * b)
        steps.append((a, b))
    return steps


@np.errstate(all="ignore")
def _quarter_period(mc):
    """K(m) = pi / (2 agm(1, sqrt(mc))), logarithmic as mc -> 0 (DLMF 19.8.5, 19.12.1)."""
    a, b = _agm_steps(mc)[-1]
    kc = np.sqrt(mc)
    return np.where(kc < _FAINT, np.log(4 / kc), np.pi / (a + b))


def _fold(u, quarter):
    """Write u = 2 K turns + v with |v| <= K; an infinite K leaves v = u."""
    period = np.minimum(2 * quarter, 1e300)
    turns = np.rint(u / period)
    return turns, u - turns * period


def _landen_sc(u, mc):
    """sc(u) = sn / cn for 0 <= u <= K/2, climbing from the circular limit of the AGM.

    This is the descending Landen transformation (DLMF 22.7(i)) on t = sc / a, in the spirit
    of Bulirsch (1965): only positive terms are added, so relative accuracy survives.
    """
    steps = _agm_steps(mc)
    mean = sum(steps[-1]) / 2
    t, gain = np.tan(mean * u) / mean, 0.0
    for a, b in reversed(steps):
        square = mean * t * t
        t, gain, mean = t + t * gain, (a - b) * square / (1 + b * square), a
    return t


@np.errstate(all="ignore")
def _jacobi(u, mc, quarter):
    """(sn, cn, dn) of u, where quarter = K(m).

    Past K/2 the argument is reflected to K - |v| (DLMF 22.4(iii)), so that cn and dn are
    products rather than differences all the way to K.
    """
    turns, v = _fold(u, quarter)
    size = np.abs(v)
    far = size > quarter / 2
    t = _landen_sc(np.where(far, quarter - size, size), mc)
    kc = np.sqrt(mc)
    p, q = np.sqrt(1 + t * t), np.sqrt(1 + mc * t * t)
    flip = 1 - 2 * (turns % 2)
    sn = flip * np.copysign(np.where(far, 1 / q, t / p), v)
    cn = flip * np.where(far, kc * t / q, 1 / p)
    dn = np.where(far, kc * p / q, q / p)
    if np.any(mc == 0):
        e = np.exp(-np.abs(u))
        sech = 2 * e / (1 + e * e)
        sn = np.where(mc == 0, np.tanh(u), sn)
        cn, dn = np.where(mc == 0, sech, cn), np.where(mc == 0, sech, dn)
    return sn, cn, dn


def _arctan_ratio(x):
    """arctan(x) / x for x >= 0, which is R_C(1, 1 + x^2) (DLMF 19.2.18)."""
    x = np.maximum(x, 1e-150)
    return np.arctan(x) / x


def _carlson_f(x, y):
    """R_F(x, y, 1) for 0 <= x <= y <= 1, y > 0, by duplication (Carlson 1995; DLMF 19.36.1)."""
    z = 1.0
    for _ in range(20):
        mean = (x + y + z) / 3
        if not np.any(z - x > 0.02 * mean):
            break
        rx, ry, rz = np.sqrt(x), np.sqrt(y), np.sqrt(z)
        shift = rx * (ry + rz) + ry * rz
        x, y, z = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4
    x, y = 1 - x / mean, 1 - y / mean
    z = -x - y
    e2, e3 = x * y - z * z, x * y * z
    series = e2 * (-1 / 10 + e2 * (1 / 24 - 5 / 208 * e2))
    series += e3 * (1 / 14 + 3 / 104 * e3 + e2 * (-3 / 44 + e2 / 16))
    return (1 + series) / np.sqrt(mean)


def _carlson_j(x, y, p):
    """R_J(x, y, 1, p) for 0 <= x <= y <= 1 <= p, y > 0, by duplication.

    Carlson (1995); DLMF 19.36.2.  The order of the arguments makes every R_C an arctangent.
    """
    z, scale, total = 1.0, 1.0, 0.0
    for _ in range(20):
        mean = (x + y + z + 2 * p) / 5
        if not np.any(p - x > 0.02 * mean):
            break
        rx, ry, rz, rp = np.sqrt(x), np.sqrt(y), np.sqrt(z), np.sqrt(p)
        shift = rx * (ry + rz) + ry * rz
        d = (rp + rx) * (rp + ry) * (rp + rz)
        e = (rp - rx) * (rp - ry) * (rp - rz) / d
        total = total + scale / d * _arctan_ratio(np.sqrt(e))
        x, y, z, p = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4, (p + shift) / 4
        scale /= 4
    x, y, z = 1 - x / mean, 1 - y / mean, 1 - z / mean
    p = -(x + y + z) / 2
    xyz, pp = x * y * z, p * p
    e2 = x * y + (x + y) * z - 3 * pp
    e3 = xyz + 2 * p * (e2 + 2 * pp)
    e4 = p * (2 * xyz + p * (e2 + 3 * pp))
    e5 = xyz * pp
    series = e2 * (-3 / 14 + 3 / 20 * e4 - 9 / 68 * e5 + e2 * (9 / 88 - e2 / 16))
    series += e3 * (1 / 6 + 3 / 40 * e3 - 9 / 68 * e4 + e2 * (-9 / 52 + 45 / 272 * e2))
    series += 3 / 26 * e5 - 3 / 22 * e4
    return scale * (1 + series) / (mean * np.sqrt(mean)) + 6 * total


@np.errstate(all="ignore")
def _complete_j(n, mc):
    """J(K, n | m), infinite at mc = 0 like K itself (Fukushima 2012)."""
    near = _carlson_j(0.0, np.maximum(mc, _FAINT**2), 1 - n) / 3
    limit = (_quarter_period(mc) - _arctan_ratio(np.sqrt(-n))) / (1 - n)
    return np.where(mc < _FAINT**2, limit, near)


@np.errstate(all="ignore")
def _elliptic_j(u, n, quarter, sn, cn, dn, complete):
    """J(u, n | m), the integral of sn^2 / (1 - n sn^2) from 0 to u, for -1 < n <= 0.

    Fukushima (2012), by DLMF 19.25.14, with complete = J(K, n | m); m enters through cn and
    dn.  Where dn is faint so is kc, and the closed form for m = 1 serves up to K itself.
    """
    turns, v = _fold(u, quarter)
    s = np.copysign(sn, v)
    ss = s * s
    near = s * ss / 3 * _carlson_j(cn * cn, np.maximum(dn, _FAINT) ** 2, 1 - n * ss)
    limit = (v - s * _arctan_ratio(np.sqrt(-n) * np.abs(s))) / (1 - n)
    whole = np.where(turns == 0, 0.0, 2 * turns * complete)
    return whole + np.where(dn < _FAINT, limit, near)


@np.errstate(all="ignore")
def _jacobi_argument(sn, cn, dn):
    """The u in [-K, K] with these sn, cn >= 0 and dn, through which alone m enters.

    DLMF 19.25.5, and 19.27.2 where dn is faint and cn fainter still.
    """
    near = _carlson_f(cn * cn, np.maximum(dn, _FAINT) ** 2)
    return sn * np.where(dn < _FAINT, np.log(4 / (cn + dn)), near)
