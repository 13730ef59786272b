"""The hand-written frame of the NumPy module: which axis is which, scaling, and shapes.

Its text stands in the generated module after the kernels and the derived functions `_excess`,
`_plan`, `_state` and `_steady`; here it is importable only as far as linting goes.
"""

import numpy as np

from rigidsym.codegen.numpy_stubs import (
    RESULTS,
    _complete_j,
    _excess,
    _plan,
    _quarter_period,
    _state,
    _steady,
)

# --- frame ---
# Rates below this fraction of the largest one cannot change a state by an ulp, unless they decide
# on which side of the separatrix a motion is: then the motion is refused.
_NEGLIGIBLE = 2.0**-460
_BLOCK = 8192
# Errors grow like 2^-50 |omega| t: here they reach a thousandth of a radian.
_FARTHEST = 2.0**40
# Products of four ratios of inertia stay normal numbers.
_THINNEST = 2.0**-240


def plan(inertia, omega0, attitude0=(1.0, 0.0, 0.0, 0.0)):
    """Constants of free motions, for `states`.

    inertia (..., 3) in kg m^2 about principal axes, positive; omega0 (..., 3) in rad/s in body
    axes; attitude0 (..., 4), scalar first, body to inertial, of any length but zero.  The leading
    shapes broadcast.  Raises ValueError for wrong shapes and for numbers that are not finite, not
    positive where they have to be, of too different size, or too near the separatrix for binary64.
    """
    inertia, omega0, attitude0 = (np.asarray(x, float) for x in (inertia, omega0, attitude0))
    _check(inertia, omega0, attitude0)
    batch = _batch(inertia, omega0, attitude0)
    c, _ = _scaled(np.broadcast_to(inertia, (*batch, 3)))
    omega, rate = _scaled(np.broadcast_to(omega0, (*batch, 3)))
    q, _ = _scaled(np.broadcast_to(attitude0, (*batch, 4)))
    q = q / np.sqrt(np.sum(q * q, axis=-1, keepdims=True))
    axes, excess = _axes(c, omega)
    kept = np.where(np.abs(omega) < _NEGLIGIBLE, 0.0, omega)
    steady = _is_steady(c, kept)
    _check_distance(c, steady & ~_is_steady(c, omega), axes, kept, excess)
    constants = {
        "axes": axes,
        "steady": steady,
        "rate": rate[..., 0],
        "omega0": omega,
        "attitude0": q,
    }
    if not np.all(steady):
        constants |= _moving_plan(c, kept, q, axes, excess)
    return constants


def plan_from_constants(axes, rate, omega0, attitude0, constants):
    """The plan of one motion whose constants were computed elsewhere, more exactly than here.

    axes: the indices of (a, b, d); rate: a power of two, the unit of rates; omega0 (3,) over that
    unit; attitude0 (4,) of length one; constants: by the names in RESULTS, of the motion with rates
    over their unit, or None where the rates are constant.
    """
    plan = {
        "axes": np.array(axes),
        "steady": np.array(constants is None),
        "rate": np.array(rate),
        "omega0": np.array(omega0),
        "attitude0": np.array(attitude0),
    }
    known = {name: np.array(float(value)) for name, value in (constants or {}).items()}
    if known:
        known["quarter_m_c"] = _quarter_period(known["m_c"])
        known["complete_n"] = _complete_j(known["n"], known["m_c"])
    return plan | known


def states(plan, t):
    """(q, omega) at the times t in s: (..., 4) and (..., 3) for a scalar t, else (..., N, 4) and
    (..., N, 3) for t (N,).  q is continuous in the double cover from attitude0 on.
    """
    t = np.asarray(t, float)
    if t.ndim > 1 or not np.all(np.isfinite(t)):
        raise ValueError("t: times must be one finite number or a one-dimensional array of them")
    pieces = -(-t.size * plan["rate"].size // _BLOCK)
    if t.ndim and pieces > 1:
        blocks = [_block(plan, part) for part in np.array_split(t, min(pieces, t.size))]
        q, omega = (np.concatenate(parts, axis=-2) for parts in zip(*blocks, strict=True))
        return q, omega
    return _block(plan, t)


def _block(plan, t):
    """The states of one block of times, whose intermediate arrays fit the cache."""
    widened = {name: _widened(value, name, t.ndim) for name, value in plan.items()}
    with np.errstate(over="ignore"):
        t = t * widened["rate"]
    if np.any(np.abs(t) > _FARTHEST):
        raise ValueError("t: beyond |omega| t = 2^40 rad the angle is lost in binary64")
    steady = widened["steady"]
    if np.all(steady):
        q, omega = _steady_states(widened, t)
    else:
        q, omega = _moving_states(widened, t)
        if np.any(steady):
            still = _steady_states(widened, t)
            q = np.where(steady[..., None], still[0], q)
            omega = np.where(steady[..., None], still[1], omega)
    start = (t == 0)[..., None]
    q = np.where(start, widened["attitude0"], q)
    omega = np.where(start, widened["omega0"], omega)
    return q, omega * widened["rate"][..., None]


def _check(inertia, omega0, attitude0):
    for name, value, size in (
        ("inertia", inertia, 3),
        ("omega0", omega0, 3),
        ("attitude0", attitude0, 4),
    ):
        if value.ndim < 1 or value.shape[-1] != size:
            raise ValueError(f"{name}: shape {value.shape}: the last axis must have {size} numbers")
        if not np.all(np.isfinite(value)):
            raise ValueError(f"{name}: every number must be finite")
    if np.any(inertia <= 0):
        raise ValueError("inertia: principal moments must be positive")
    if np.any(np.min(inertia, axis=-1) < _THINNEST * np.max(inertia, axis=-1)):
        raise ValueError("inertia: principal moments differ by more than binary64 can follow")
    if not np.all(np.any(attitude0 != 0, axis=-1)):
        raise ValueError("attitude0: a zero quaternion is no attitude")


def _batch(inertia, omega0, attitude0):
    shapes = [x.shape[:-1] for x in (inertia, omega0, attitude0)]
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        rule = f"leading shapes {shapes[1]} and {shapes[2]} must broadcast with {shapes[0]}"
        raise ValueError(f"omega0, attitude0: {rule} of inertia") from None


def _check_distance(c, lost, axes, omega, excess):
    """Refuse what binary64 cannot tell from the separatrix or from spin about the middle axis."""
    distinct = np.all(np.diff(np.sort(c, axis=-1), axis=-1) != 0, axis=-1)
    spin = np.take_along_axis(omega, axes[..., 1:2], -1)[..., 0] != 0
    faint = (excess != 0) & (np.abs(excess) < 2.0**-950)
    if np.any(distinct & (lost & spin | faint)):
        raise ValueError("omega0: nearer to the separatrix than binary64 can follow")


def _scaled(x):
    """x over a power of two that brings its largest component into [1, 2), and that power."""
    exponent = np.frexp(np.max(np.abs(x), axis=-1, keepdims=True))[1] - 1
    return np.ldexp(x, -exponent), np.ldexp(1.0, exponent)


def _is_steady(c, omega):
    """True where M and Omega are parallel, decided without rounding."""
    steady = np.ones(c.shape[:-1], bool)
    for j, k in ((0, 1), (1, 2), (2, 0)):
        steady &= (c[..., j] == c[..., k]) | (omega[..., j] == 0) | (omega[..., k] == 0)
    return steady


def _axes(c, omega):
    """The indices of the axes (a, b, d), and E_b, whose sign chooses a."""
    order = np.argsort(c, axis=-1, kind="stable")
    excess = _exact_excess(c, omega, order[..., ::-1])
    return np.where(excess[..., None] >= 0, order[..., ::-1], order), excess


def _exact_excess(c, omega, axes):
    """E_b to double precision: where its terms cancel, from integers."""
    c, omega = (np.take_along_axis(x, axes, -1) for x in (c, omega))
    zero = np.zeros_like(omega[..., 0])
    over = _excess(*_columns(c), omega[..., 0], zero)
    under = _excess(*_columns(c), zero, omega[..., 2])
    excess = np.asarray(over + under)
    for index in np.argwhere(excess * 8 < over - under):
        at = tuple(index)
        if abs(excess[at]) * 8 < over[at] - under[at] or over[at] == 0 == under[at]:
            excess[at] = _integer_excess(c[at], omega[at])
    return excess


def _integer_excess(c, omega):
    """E_b of one motion in integer arithmetic, rounded once."""
    (c, scale_c), (omega, scale_omega) = _integers(c), _integers(omega)
    excess = _excess(*c, omega[0], omega[2])
    shift = max(0, abs(excess).bit_length() - 64)
    return float(np.ldexp(float(excess >> shift), shift + 2 * (scale_c + scale_omega)))


def _integers(x):
    """Python integers and the power of two that turns them into x."""
    mantissa, exponent = np.frexp(x)
    exponent = np.where(x == 0, np.max(exponent), exponent)
    least = int(np.min(exponent))
    whole = [int(m) for m in np.ldexp(mantissa, 53)]
    return [m << int(e) - least for m, e in zip(whole, exponent, strict=True)], least - 53


def _columns(x):
    return tuple(x[..., k] for k in range(x.shape[-1]))


@np.errstate(all="ignore")
def _moving_plan(c, omega, q, axes, excess):
    """The derived constants; without meaning where the rates are constant."""
    inertia = _columns(np.take_along_axis(c, axes, -1))
    rates = _columns(np.take_along_axis(omega, axes, -1))
    vector = _columns(np.take_along_axis(q[..., 1:], axes, -1))
    epsilon = np.where((axes[..., 1] - axes[..., 0]) % 3 == 1, 1.0, -1.0)
    sigma = np.where(rates[0] < 0, -1.0, 1.0)
    rho = np.where(inertia[0] >= inertia[2], 1.0, -1.0)
    chi = np.where(-rho * epsilon * sigma * rates[2] < 0, -1.0, 1.0)
    values = _plan(*inertia, *rates, epsilon, sigma, rho, chi, q[..., 0], *vector, excess)
    return dict(zip(RESULTS, np.broadcast_arrays(*values), strict=True))


def _widened(value, name, ndim):
    """A constant with room for the time axis, which comes before the components of a vector."""
    axis = value.ndim - (name in ("axes", "omega0", "attitude0"))
    return np.expand_dims(value, axis) if ndim else value


@np.errstate(all="ignore")
def _moving_states(plan, t):
    *q, omega_a, omega_b, omega_d = _state(t, *(plan[name] for name in RESULTS))
    rates = np.stack(np.broadcast_arrays(omega_a, omega_b, omega_d), axis=-1)
    vector = np.stack(np.broadcast_arrays(*q[1:]), axis=-1)
    back = np.broadcast_to(np.argsort(plan["axes"], axis=-1), rates.shape)
    vector = np.take_along_axis(vector, back, -1)
    scalar = np.broadcast_to(q[0], vector.shape[:-1])[..., None]
    return np.concatenate((scalar, vector), axis=-1), np.take_along_axis(rates, back, -1)


@np.errstate(all="ignore")
def _steady_states(plan, t):
    omega, attitude = plan["omega0"], plan["attitude0"]
    q = np.stack(np.broadcast_arrays(*_steady(*_columns(omega), *_columns(attitude), t)), axis=-1)
    rest = np.all(omega == 0, axis=-1, keepdims=True)
    return np.where(rest, attitude, q), np.broadcast_to(omega, (*q.shape[:-1], 3))
