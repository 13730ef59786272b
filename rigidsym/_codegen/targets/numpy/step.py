"""Hand-written runtime of the NumPy module of steps: checks and shapes.

Its text is printed into the generated module, after the derived functions and the decisions.
"""

import math

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import (
    _DoubleDouble,
    _product_error,
    _reversed,
    _taken,
    _two_sum,
    _where,
)
from rigidsym._codegen.targets.numpy.stubs import (
    LAST,
    MAX_STEP,
    MIN_MOMENT_RATIO,
    STEPS,
    _is_finite_state,
    _is_short,
    _is_under,
    _order_of,
    _places,
    _scale,
    _scaled_attitude,
    _scaled_rates,
    _scaled_time,
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
    _stochastic,
    _times_power,
    _unit,
)

# --- runtime ---
# Bodies at a time: what is computed of them fits the cache.
_BLOCK = 4096
_MASK = 2**64 - 1
# Of bodies, by axis.
_COLUMNS = ("moments", "alphas", "squares", "axes")


class _RefusedError(ValueError):
    """Error for invalid input: the field, the broken rule, and the first body that breaks it.

    Bodies are counted through the leading axes.
    """

    def __init__(self, field, rule, body):
        super().__init__(field, rule, body)
        self.field, self.rule, self.body, self.time = field, rule, body, None

    def __str__(self):
        return f"{self.field}: {self.rule}"


@np.errstate(invalid="ignore")
def prepare(inertia):
    """Compute the constants of bodies that `step` takes, from inertia (B, 3) in kg m^2.

    For one body, (3,), they are Python floats, which `step_one` takes.  Raises ValueError for
    moments that are not positive and finite, or of too different size.
    """
    inertia = np.asarray(inertia, float)
    columns = inertia.tolist() if inertia.ndim == 1 else [*inertia.T.copy()]
    *axes, epsilon = _order_of(columns)
    c = [_taken(columns, axis) for axis in axes]
    rule = "principal moments must be positive"
    _refuse("inertia", rule, (c[0] < math.inf) & (c[1] > 0) & (c[2] > 0))
    rule = "principal moments differ by more than binary64 can follow"
    _refuse("inertia", rule, c[2] / c[0] >= MIN_MOMENT_RATIO)
    power = -_scale(c[0])
    c = [_times_power(x, power) for x in c]
    pairs = [_DoubleDouble(x, 0 * x) for x in c]
    apart = [_DoubleDouble(*_two_sum(c[x], -c[y])) for x, y in ((0, 1), (0, 2), (1, 2))]
    values = _paired(_step_body(*pairs, *apart, epsilon))
    return {
        "moments": pairs,
        "alphas": values[:3],
        "squares": values[3:],
        "epsilon": epsilon,
        "axes": axes,
    }


def _refuse(field, rule, good):
    """Raise an error for the first body where `good` is False."""
    if good is not True:
        for body in np.flatnonzero(np.logical_not(good))[:1]:
            raise _RefusedError(field, rule, int(body))


def _paired(values):
    """Return the double-doubles of a sequence hi, lo, hi, lo, ..."""
    return [_DoubleDouble(*pair) for pair in zip(values[::2], values[1::2], strict=True)]


def step(bodies, q, omega, dt, out):
    """Write the states of B free bodies after dt to `out`.

    q (B, 4), omega (B, 3), dt (B,) or (); bodies: of `prepare`, for one body or B of them.  q may
    have any length but zero, and is returned a unit quaternion; out, a pair of such arrays, may be
    (q, omega).  Raises ValueError for what is not finite, a zero quaternion, and |omega dt| beyond
    2^3 rad.
    """
    dt = np.broadcast_to(dt, len(q))
    for name, values in (("q", q), ("omega", omega), ("dt", dt[:, None])):
        _refuse(name, "every number must be finite", np.isfinite(values).all(axis=-1))
    _refuse("q", "a zero quaternion is no attitude", np.any(q != 0, axis=-1))
    for first in range(0, len(q), _BLOCK):
        some = slice(first, min(first + _BLOCK, len(q)))
        try:
            _some(_of(bodies, some), q[some], omega[some], dt[some], [x[some] for x in out])
        except _RefusedError as error:
            raise _RefusedError(error.field, error.rule, first + error.body) from None


def step_one(body, q, omega, dt):
    """Return the state of one body after dt, as lists computed with Python floats.

    It has the bits of `step`; body: of `prepare`.  Raises ValueError or ArithmeticError where
    `step` refuses a body, and for numbers that overflow on the way.
    """
    if not (all(map(math.isfinite, (*q, *omega, dt))) and any(q)):
        raise _RefusedError("q", "every number must be finite, and one not zero", 0)
    return _stepped(body, q, omega, dt)


def _of(bodies, some):
    """Return the constants of some bodies; a single body's constants are used for all."""
    if len(bodies["epsilon"]) == 1:
        return bodies
    columns = {name: [x[some] for x in bodies[name]] for name in _COLUMNS}
    return columns | {"epsilon": bodies["epsilon"][some]}


@np.errstate(all="ignore")
def _some(bodies, q, omega, dt, out):
    found = _stepped(bodies, [*q.T.copy()], [*omega.T.copy()], dt)
    for array, columns in zip(out, found, strict=True):
        for k, column in enumerate(columns):
            array[:, k] = column


def _stepped(bodies, q, omega, dt):
    """Return attitudes and rates after dt.

    Both are lists of columns: arrays (B,), or the floats of one body.
    """
    power, still, t = _scaled_time(omega, dt)
    rates = _scaled_rates(bodies["axes"], omega, power)
    _refuse("dt", f"|omega dt| must be at most {MAX_STEP:.0f} rad", _is_short(*rates, t))
    squares = bodies["squares"]
    turned = _is_under(squares[0].hi, squares[2].hi, rates[0], rates[2])
    columns = (*(bodies[name] for name in _COLUMNS), rates)
    *body, axes, start = (_reversed(turned, x) for x in columns)
    epsilon = _where(turned, -1.0, 1.0) * bodies["epsilon"]
    given, *vector = _scaled_attitude(q)
    parts = [given, *(_taken(vector, axis) for axis in axes)]
    found, after = _moved(*body, epsilon, start, parts, t)
    fast = _is_finite_state(*found, *(x.hi for x in after))
    _refuse("dt", "the body turns too fast for one step", fast)
    # What does not turn keeps its attitude to the last bit, once that is of length one.
    scalar, *vector = _unit(*(_where(still, *both) for both in zip(parts, found, strict=True)))
    after = _stochastic(scalar, *vector[:2], *after)
    places = _places(bodies["axes"], turned)
    rates = (_times_power(_taken(after, place), power) for place in places)
    omega = [_where(still, *both) for both in zip(omega, rates, strict=True)]
    return [scalar, *(_taken(vector, place) for place in places)], omega


def _two_product(a, b):
    """Return a b exactly."""
    p = a * b
    return _DoubleDouble(p, _product_error(a, b, p))


def _bits_of(x):
    bits = np.asarray(x).view(np.uint64)
    return bits if bits.ndim else bits.item()


def _from_bits(bits):
    x = np.asarray(bits, np.uint64).view(float)
    return x if x.ndim else x.item()


def _moved(moments, alphas, squares, epsilon, start, q, t):
    """Return unnormalised attitudes of moving bodies after t, and rates as double-doubles."""
    signs = epsilon, _where(start[0] < 0, -1.0, 1.0)
    start = [_DoubleDouble(x, 0.0) for x in start]
    h, e_1, e_2, K, rate, X, Y, *z = _paired(_step_start(*moments, *squares, *start, t, *signs))
    re, im = _step_first(h.hi, e_1.hi, e_2.hi, X.hi, *(x.hi for x in z))
    for k in range(STEPS):
        if k < STEPS - LAST:
            w = _step_projected(h.hi, *(x.hi for x in z), X.hi, Y.hi)
            re, im = _step_second_half(h.hi, X.hi, *w, re, im)
        else:
            w = _paired(_step_last_projected(h, *z, X, Y))
            re, im = _step_last_second_half(h, X, *w, re, im)
        X, Y = _paired(_step_doubled(X, Y, e_1, e_2))
    rates = _paired(_step_rates(X, Y, h, *alphas, squares[2], *start))
    sizes = [x.hi for x in moments]
    before = _step_shortest_before(K, *start, *sizes, *signs)
    after = _step_shortest(K, *rates, *sizes, *signs)
    front = _step_front(*before, *q, epsilon)
    return _step_attitude(t, rate.hi, rate.lo, re, im, *after, *front, *signs), rates


def torque(q, direction, coefficients):
    """Return the torque that a vector in space (..., 3) exerts on bodies of attitude q (..., 4).

    With v that vector in body axes, it is b + k v + v x (Q v - m); coefficients (..., 13): three
    b, k, three m, and Q11, Q22, Q33, Q23, Q13, Q12 of a symmetric Q.
    """
    given = [np.asarray(x, float) for x in (q, direction, coefficients)]
    if all(x.ndim == 1 for x in given):
        # Of one body in plain numbers: calls of NumPy would take ten times as long.
        return np.array(_step_kick(*(x for each in given for x in each.tolist())))
    rows = (np.moveaxis(x, -1, 0) for x in given)
    return np.stack(_step_kick(*(x for each in rows for x in each)), axis=-1)
