"""The hand-written runtime of the NumPy module of steps: which axis is which, scaling and shapes.

Its text stands in the generated module after the pairs and the derived functions; here it is
importable only as far as linting goes.
"""

from typing import Any

import numpy as np

from rigidsym.codegen.targets.numpy.stubs import (
    LAST,
    MAX_STEP,
    MIN_MOMENT_RATIO,
    STEPS,
    _DoubleDouble,
    _product_error,
    _step_attitude,
    _step_body,
    _step_doubled,
    _step_first,
    _step_front,
    _step_kick,
    _step_last_projected,
    _step_last_second_half,
    _step_projected,
    _step_rates,
    _step_second_half,
    _step_shortest,
    _step_shortest_before,
    _step_start,
    _two_sum,
)

# --- runtime ---
# Bodies at a time: what is computed of them fits the cache.
_BLOCK = 4096
_INERTIA, _BODY = (
    ["c_a", "c_b", "c_d", "c_ab", "c_ad", "c_bd"],
    ["alpha_a", "alpha_b", "alpha_d", "l_a", "l_b", "l_d"],
)


class _RefusedError(ValueError):
    """What a body is refused for; bodies are counted through the leading axes."""

    def __init__(self, message, body):
        super().__init__(message)
        self.body, self.time = body, None


def prepare(inertia):
    """What is of bodies alone, for `step`; inertia (B, 3) in kg m^2, positive.

    Raises ValueError for moments that are not positive and finite, or of too different size.
    """
    inertia = np.asarray(inertia, float)
    with np.errstate(invalid="ignore"):
        bad = ~np.all((inertia > 0) & np.isfinite(inertia), axis=-1)
        _refuse("inertia", "principal moments must be positive", bad)
        thin = np.min(inertia, axis=-1) / np.max(inertia, axis=-1) < MIN_MOMENT_RATIO
        _refuse("inertia", "principal moments differ by more than binary64 can follow", thin)
    order = np.argsort(-inertia, axis=-1, kind="stable")
    exponent = np.frexp(np.max(inertia, axis=-1))[1]
    c = np.ldexp(np.take_along_axis(inertia, order, -1), -exponent[:, None]).T.copy()
    known: dict[str, Any] = {f"c_{x}": _DoubleDouble(c[k], 0 * c[k]) for k, x in enumerate("abd")}
    for x, y in ("ab", "ad", "bd"):
        known[f"c_{x}{y}"] = _DoubleDouble(*_two_sum(known[f"c_{x}"].hi, -known[f"c_{y}"].hi))
    known["epsilon"] = np.where((order[:, 1] - order[:, 0]) % 3 == 1, 1.0, -1.0)
    values = _paired(_step_body(*(known[name] for name in (*_INERTIA, "epsilon"))))
    return known | dict(zip(_BODY, values, strict=True)) | {"axes": order}


def _refuse(field, rule, bad):
    for body in np.flatnonzero(bad)[:1]:
        raise _RefusedError(f"{field}: {rule}", int(body))


def _paired(values):
    """Pairs from doubles hi, lo, hi, lo, ..."""
    return [_DoubleDouble(*pair) for pair in zip(values[::2], values[1::2], strict=True)]


def step(bodies, q, omega, dt, out):
    """The free motion of B bodies after dt: q (B, 4), omega (B, 3) and dt (B,) or () to out.

    bodies: of `prepare`, for one body or B of them.  q may have any length but zero, and is
    returned a unit quaternion; out, a pair of such arrays, may be (q, omega).  Raises ValueError
    for what is not finite, a zero quaternion, and |omega dt| beyond 2^3 rad.
    """
    dt = np.broadcast_to(dt, len(q))
    for name, values in (("q", q), ("omega", omega), ("dt", dt[:, None])):
        _refuse(name, "every number must be finite", ~np.isfinite(values).all(axis=-1))
    _refuse("q", "a zero quaternion is no attitude", ~np.any(q != 0, axis=-1))
    for first in range(0, len(q), _BLOCK):
        some = slice(first, min(first + _BLOCK, len(q)))
        try:
            _some(_of(bodies, some), q[some], omega[some], dt[some], [x[some] for x in out])
        except _RefusedError as error:
            raise _RefusedError(str(error), first + error.body) from None


def _of(bodies, some):
    """Some of the bodies: one serves all."""
    return bodies if len(bodies["axes"]) == 1 else {n: x[some] for n, x in bodies.items()}


@np.errstate(all="ignore")
def _some(bodies, q, omega, dt, out):
    axes = np.broadcast_to(bodies["axes"], (len(q), 3))
    exponent = np.frexp(np.max(np.abs(omega), axis=-1))[1]
    rates = np.ldexp(np.take_along_axis(omega, axes, -1), -exponent[:, None]).T
    t = np.ldexp(dt, exponent)
    angle = np.sqrt(np.sum(rates * rates, axis=0)) * np.abs(t)
    rule = f"|omega dt| must be at most {MAX_STEP:.0f} rad"
    _refuse("dt", rule, ~(angle <= MAX_STEP))
    known, axes = _circulating(bodies, rates, axes)
    start = [known[name] for name in ("Omega_a0", "Omega_b0", "Omega_d0")]
    # Quaternions of any size: a power of two off.
    size = np.frexp(np.max(np.abs(q), axis=-1, keepdims=True))[1]
    scaled = np.ldexp(q, -size)
    parts = [scaled[:, 0], *np.take_along_axis(scaled[:, 1:], axes, -1).T]
    found, rates = _moved(known, parts, t)
    _refuse("dt", "the body turns too fast for one step", ~np.isfinite(found).all(axis=0))
    # What does not turn keeps its attitude to the last bit, once that is of length one.
    still = (t == 0) | ~np.any(omega != 0, axis=-1)
    found = [np.where(still, *both) for both in zip(parts, found, strict=True)]
    found = _unit(found)
    rates = _rounded_rates(rates, found)
    out[0][:, 0] = found[0]
    for k in range(3):
        np.put_along_axis(out[0][:, 1:], axes[:, k, None], found[1 + k][:, None], -1)
        after = np.where(still, np.ldexp(start[k], exponent), np.ldexp(rates[k], exponent))
        np.put_along_axis(out[1], axes[:, k, None], after[:, None], -1)


def _unit(parts):
    """A quaternion over its length, each number as good as rounded once."""
    squares = (_DoubleDouble(x * x, _product_error(x, x, x * x)) for x in parts)
    square = sum(squares, _DoubleDouble(0.0))
    over = 1 / np.sqrt(square.hi)
    rest = 1 - square * over * over
    more = over * (rest.hi + rest.lo) / 2
    return [x * over + (_product_error(x, over, x * over) + x * more) for x in parts]


def _rounded_rates(rates, parts):
    """Rates rounded up or down, each as often as they are near.

    Rounded to nearest, the rates of a motion so slow that they change by an ulp a step would err
    one way for long.  The attitude's last digits are as good as chance.
    """
    one, two, three = (np.ascontiguousarray(x).view(np.uint64) for x in parts[:3])
    turned = [x << np.uint64(n) | x >> np.uint64(64 - n) for x, n in ((two, 21), (three, 42))]
    mixed = (one ^ turned[0] ^ turned[1]) * np.uint64(0x9E3779B97F4A7C15)
    mixed = (mixed ^ mixed >> np.uint64(32)) * np.uint64(0xD6E8FEB86659FD93)
    mixed ^= mixed >> np.uint64(32)
    found = []
    for number, rate in enumerate(rates):
        some = mixed << np.uint64(20 * number) >> np.uint64(44)
        size = np.abs(rate.hi)
        ulp = (size + size * 1.1102230246251568e-16) - size
        found.append(rate.hi + (rate.lo + (some * 2.0**-20 - 0.5) * ulp))
    return found


def _circulating(bodies, rates, axes):
    """Names for the axes: a is the one of largest moment, or of smallest where K^2 < 2 H c_b."""
    over, under = bodies["l_a"].hi * rates[0] ** 2, bodies["l_d"].hi * rates[2] ** 2
    turned = over < under
    known = {"sigma": None, "epsilon": np.where(turned, -1.0, 1.0) * bodies["epsilon"]}
    swapped = dict(zip("abd", "dba", strict=True))
    for name in ("c_a", "c_b", "c_d", *_BODY):
        known[name] = _either(turned, bodies[name[:-1] + swapped[name[-1]]], bodies[name])
    known["Omega_a0"] = np.where(turned, rates[2], rates[0])
    known["Omega_b0"] = rates[1]
    known["Omega_d0"] = np.where(turned, rates[0], rates[2])
    known["sigma"] = np.where(known["Omega_a0"] < 0, -1.0, 1.0)
    return known, np.where(turned[:, None], axes[:, ::-1], axes)


def _either(first, one, other):
    hi, lo = (np.where(first, getattr(one, x), getattr(other, x)) for x in ("hi", "lo"))
    return _DoubleDouble(hi, lo)


def _moved(body, q, t):
    """The attitude, of some length near that of q, and the rates, on the axes a, b, d."""
    names = ("Omega_a0", "Omega_b0", "Omega_d0")
    start = [_DoubleDouble(body[name], 0.0) for name in names]
    inertia = [body[name] for name in ("c_a", "c_b", "c_d")]
    # Constant rates have no direction of the momentum to divide by at rest.
    still = (body["Omega_a0"] == 0) & (body["Omega_b0"] == 0) & (body["Omega_d0"] == 0)
    start[0] = _DoubleDouble(np.where(still, 1.0, start[0].hi), 0.0)
    t = np.where(still, 0.0, t)
    squares = [body[name] for name in ("l_a", "l_b", "l_d")]
    signs = body["epsilon"], body["sigma"]
    values = _step_start(*inertia, *squares, *start, t, *signs)
    h, e_1, e_2, K, rate, X, Y, *z = _paired(values)
    re, im = _step_first(h.hi, e_1.hi, e_2.hi, X.hi, *(x.hi for x in z))
    for k in range(STEPS):
        if k < STEPS - LAST:
            w = _step_projected(h.hi, *(x.hi for x in z), X.hi, Y.hi)
            re, im = _step_second_half(h.hi, X.hi, *w, re, im)
        else:
            w = _paired(_step_last_projected(h, *z, X, Y))
            re, im = _step_last_second_half(h, X, *w, re, im)
        X, Y = _paired(_step_doubled(X, Y, e_1, e_2))
    alphas = [body[name] for name in ("alpha_a", "alpha_b", "alpha_d")]
    rates = _paired(_step_rates(X, Y, h, *alphas, body["l_d"], *start))
    moments = [x.hi for x in inertia]
    before = _step_shortest_before(K, *start, *moments, *signs)
    after = _step_shortest(K, *rates, *moments, *signs)
    front = _step_front(*before, *q, body["epsilon"])
    attitude = _step_attitude(t, rate.hi, rate.lo, re, im, *after, *front, *signs)
    return attitude, rates


def torque(q, direction, coefficients):
    """What a vector in space (..., 3) exerts on bodies of unit quaternions q (..., 4), (..., 3).

    With v that vector in body axes, it is b + k v + v x (Q v - m); coefficients (..., 13): three
    b, k, three m, and Q11, Q22, Q33, Q23, Q13, Q12 of a symmetric Q.
    """
    given = [np.asarray(x, float) for x in (q, direction, coefficients)]
    if all(x.ndim == 1 for x in given):
        # Of one body in plain numbers: calls of NumPy would take ten times as long.
        return np.array(_step_kick(*(x for each in given for x in each.tolist())))
    rows = (np.moveaxis(x, -1, 0) for x in given)
    return np.stack(_step_kick(*(x for each in rows for x in each)), axis=-1)
