"""Hand-written runtime of the NumPy module of steps: checks and shapes.

Its text is printed into the generated module, after the derived functions and the decisions.
"""

import math

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import (
    _at,
    _DoubleDouble,
    _only,
    _reversed,
    _taken,
    _where,
)
from rigidsym._codegen.targets.numpy.shared import (
    _check_finite,
    _refuse,
    _refuse_codes,
    _RefusedError,
)
from rigidsym._codegen.targets.numpy.stubs import (
    ANGLE,
    ATTITUDE,
    INERTIA,
    NOT_FINITE,
    OK,
    RULES,
    _body_code,
    _is_finite_state,
    _is_short,
    _is_under,
    _moment_scale,
    _moved,
    _order_of,
    _places,
    _scaled_attitude,
    _scaled_rates,
    _scaled_time,
    _step_body,
    _step_kick,
    _times_power,
    _two_sum,
    _unit,
)

# --- runtime ---
# Bodies at a time: what is computed of them fits the cache.
_BLOCK = 4096
_MASK = 2**64 - 1


@np.errstate(all="ignore")
def prepare(inertia):
    """Compute the constants of bodies that `step` takes, from inertia (B, 3) in kg m^2.

    For one body, (3,), they are Python floats, which `step_one` takes.  Raises ValueError for
    moments that are not positive and finite, or of too different size.
    """
    inertia = np.asarray(inertia, float)
    columns = inertia.tolist() if inertia.ndim == 1 else [*inertia.T.copy()]
    power = _moment_scale(columns)
    c = [_times_power(x, power) for x in columns]
    code = _body_code(columns, c)
    _refuse_codes(_where(code == NOT_FINITE, INERTIA, code))
    *axes, epsilon = _order_of(columns)
    c = [_taken(c, axis) for axis in axes]
    pairs = [_DoubleDouble(x, 0 * x) for x in c]
    apart = [_two_sum(c[x], -c[y]) for x, y in ((0, 1), (0, 2), (1, 2))]
    values = _paired(_step_body(*pairs, *apart, epsilon))
    made = {"moments": c, "alphas": values[:3], "squares": values[3:], "axes": axes}
    return made | {"epsilon": epsilon}


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
    _check_finite({"q": q.T, "omega": omega.T, "dt": [dt]})
    _refuse(*RULES[ATTITUDE], np.any(q != 0, axis=-1))
    for first in range(0, len(q), _BLOCK):
        some = slice(first, first + _BLOCK)
        own = (
            bodies
            if len(bodies["epsilon"]) == 1
            else {name: _at(x, some) for name, x in bodies.items()}
        )
        try:
            with np.errstate(all="ignore"):
                found = _stepped(own, [*q[some].T.copy()], [*omega[some].T.copy()], dt[some])
        except _RefusedError as error:
            raise _RefusedError(error.field, error.rule, first + error.body) from None
        for array, columns in zip(out, found, strict=True):
            np.stack(columns, axis=-1, out=array[some])


def step_one(body, q, omega, dt):
    """Return the state of one body after dt, as lists computed with Python floats.

    It has the bits of `step`; body: of `prepare`.  Raises ValueError or ArithmeticError where
    `step` refuses a body, and for numbers that overflow on the way.
    """
    if not (all(map(math.isfinite, (*q, *omega, dt))) and any(q)):
        raise _RefusedError("q", "every number must be finite, and one not zero", 0)
    return _stepped(body, q, omega, dt)


def _stepped(bodies, q, omega, dt):
    """Return attitudes and rates after dt.

    Both are lists of columns: arrays (B,), or the floats of one body.
    """
    power, still, t = _scaled_time(omega, dt)
    rates = _scaled_rates(bodies["axes"], omega, power)
    _refuse_codes(_where(_is_short(*rates, t), OK, ANGLE))
    turned = _is_under(bodies["squares"][0].hi, bodies["squares"][2].hi, rates[0], rates[2])
    scalar, *vector = _scaled_attitude(q)
    given = scalar, *(_taken(vector, axis) for axis in bodies["axes"])
    columns = (*(bodies[name] for name in ("moments", "alphas", "squares")), given[1:], rates)
    moments, alphas, squares, vector, start = (_reversed(turned, x) for x in columns)
    signs = _where(turned, -1.0, 1.0) * bodies["epsilon"], _where(start[0] < 0, -1.0, 1.0)
    found = _moved(*moments, *alphas, *squares, scalar, *vector, *start, t, *signs)
    # What does not turn keeps its attitude to the last bit, once that is of length one.
    unit = _only(still, _unit, found[:4], (scalar, *vector))
    _refuse("dt", "the body turns too fast for one step", _is_finite_state(*unit, *found[4:]))
    places = _places(bodies["axes"], turned)
    rates = [_times_power(_taken(found[4:], place), power) for place in places]
    omega = [_where(still, *both) for both in zip(omega, rates, strict=True)]
    return [unit[0], *(_taken(unit[1:], place) for place in places)], omega


def _bits_of(x):
    bits = np.asarray(x).view(np.uint64)
    return bits if bits.ndim else bits.item()


def _from_bits(bits):
    x = np.asarray(bits, np.uint64).view(float)
    return x if x.ndim else x.item()


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
