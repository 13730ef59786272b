"""Jacobi's functions over NumPy arrays, by the arithmetic-geometric mean."""

from collections.abc import Callable
from typing import Any

import numpy as np


def agm(mc: Any) -> list[tuple[Any, Any]]:
    """List the iterates of the arithmetic-geometric mean of 1 and sqrt(mc) (DLMF 19.8(i)).

    For mc = 0, they are those of 1 and 1.
    """
    b = np.sqrt(np.where(mc == 0, 1.0, mc))
    a = np.ones_like(b)
    steps = [(a, b)]
    while np.any(np.abs(a - b) > 1e-8 * a):  # the next mean is then exact in double precision
        a, b = (a + b) / 2, np.sqrt(a * b)
        steps.append((a, b))
    return steps


def _tangents(u: Any, steps: list[tuple[Any, Any]]) -> list[Any]:
    """List tan(am u) for 0 <= u <= K/2 and its descending Landen transforms.

    DLMF 22.7(i) for t = sc / a, with a and b from the AGM: only positive terms are added.
    """
    mean = sum(steps[-1]) / 2
    tangents = [np.tan(mean * u) / mean]
    for a, b in reversed(steps[1:]):
        t = tangents[-1]
        tangents.append(t * np.hypot(1, a * t) / np.hypot(1, b * t))
    return tangents[::-1]


def _reduce(u: Any, mc: Any) -> tuple[Any, Any, Any, list[tuple[Any, Any]], list[Any]]:
    """Reduce an argument by half turns, u = 2 K turns + v.

    Return turns, v, whether |v| > K/2, the iterates of the AGM, and the tangents.

    A far |v| is reflected to K - |v| (DLMF 22.4(iii)), so that cn and dn come without
    cancellation.  m = 1, where K is infinite, has its closed forms.
    """
    steps = agm(mc)
    quarter = np.where(mc == 0, 1e300, np.pi / sum(steps[-1]))
    turns = np.rint(u / (2 * quarter))
    v = u - turns * (2 * quarter)
    size = np.abs(v)
    far = size > quarter / 2
    tangents = _tangents(np.where(far, quarter - size, size), steps)
    return turns, v, far, steps, tangents


def _amplitude(u: Any, m: Any) -> tuple[Any, Any, Any, Any]:
    """Return the half turns in am(u), the sine and cosine of the remainder, and dn."""
    mc = 1 - m
    turns, v, far, _, (t, *_) = _reduce(u, mc)
    size, kc = np.abs(v), np.sqrt(mc)
    e = np.exp(-size)
    s = np.where(mc == 0, np.tanh(size), np.where(far, 1.0, t))
    c = np.where(mc == 0, 2 * e / (1 + e * e), np.where(far, kc * t, 1.0))
    norm = np.hypot(s, c)
    return turns, np.copysign(s, v) / norm, c / norm, np.hypot(c, kc * s) / norm


def _epsilon(u: Any, m: Any) -> Any:
    """Compute Jacobi's epsilon as E u / K plus Jacobi's zeta function.

    Gauss's transformation (DLMF 19.8(iii)) of the integral of x cos^2 am + y sin^2 am leaves one
    of the same form and a term of zeta, until x = y = E / K.  For m >= 0 no term is negative.
    """
    mc = 1 - m
    _, v, far, steps, tangents = _reduce(u, mc)
    x, y, zeta = np.ones_like(mc), mc, np.zeros_like(mc)
    for (a, b), t in zip(steps, tangents, strict=True):
        p, q = np.hypot(1, a * t), np.hypot(1, b * t)
        near = t / (p * (p + q))  # sn cn / (a + dn), where dn^2 = a^2 cn^2 + b^2 sn^2
        gap = x - y
        zeta = zeta + gap * np.where(far, b * t / (q * (a * q + b * p)), near)
        x, y = x - gap / 2, y + gap * (b / (a + b))
    return np.where(mc == 0, np.tanh(u), x * u + np.sign(v) * zeta)[()]


def _function(kind: str) -> Callable[[Any, Any], Any]:
    """Return the NumPy implementation of one of Jacobi's five functions.

    Its arguments broadcast.  It returns nan for m > 1.
    """

    @np.errstate(all="ignore")
    def evaluate(u: Any, m: Any) -> Any:
        u, m = np.asarray(u, dtype=float), np.asarray(m, dtype=float)
        if kind == "epsilon":
            return _epsilon(u, m)
        turns, sine, cosine, dn = _amplitude(u, m)
        if kind == "am":
            return turns * np.pi + np.arctan2(sine, cosine)
        if kind == "dn":
            return dn
        return (1 - 2 * (turns % 2)) * (sine if kind == "sn" else cosine)

    return evaluate


NUMPY = {f"jacobi_{kind}": _function(kind) for kind in ("sn", "cn", "dn", "am", "epsilon")}
"""Implementations over NumPy arrays of real u and m <= 1.

Absolute errors are about 1e-15 for small u and grow with the rounding of u / K: 1e-14 at 30.
Those of epsilon are about 1e-15 of its value, or for m < 0 of E |u| / K where that is larger.
"""
