"""The hand-written frame of the NumPy module: which axis is which, scaling, branches and shapes.

Its text stands in the generated module after the pairs and the derived functions; here it is
importable only as far as linting goes.
"""

import numpy as np

from rigidsym.codegen.numpy.stubs import (
    BRANCHES,
    DECISIVE,
    FAINTEST,
    FARTHEST,
    FASTEST,
    NEGLIGIBLE,
    START,
    THINNEST,
    _excess,
    _Pair,
    _steady_plan,
)

# --- frame ---
# States computed at a time: their intermediate arrays fit the cache.
_BLOCK = 8192


class _RefusedError(ValueError):
    """What a body is refused for; `body` is its number, counted through the leading axes."""

    def __init__(self, message, body):
        super().__init__(message)
        self.body = body


def plan(inertia, omega0, attitude0=(1.0, 0.0, 0.0, 0.0)):
    """Constants of free motions, for `states`.

    inertia (..., 3) in kg m^2 about principal axes, positive; omega0 (..., 3) in rad/s in body
    axes; attitude0 (..., 4), scalar first, body to inertial, of any length but zero.  The leading
    shapes broadcast.  Raises ValueError for wrong shapes and for numbers that are not finite, not
    positive where they have to be, of too different size, or too near the separatrix for binary64.
    """
    inertia, omega0, attitude0 = (np.asarray(x, float) for x in (inertia, omega0, attitude0))
    _check(inertia, omega0, attitude0)
    shape = _batch(inertia, omega0, attitude0)
    given = ((inertia, 3), (omega0, 3), (attitude0, 4))
    rows = (np.broadcast_to(x, (*shape, size)).reshape(-1, size) for x, size in given)
    (c, _), (omega, unit), (q, _) = map(_scaled, rows)
    made = _plan(_Pair(c, 0 * c), _Pair(omega, 0 * omega), _Pair(q, 0 * q), unit, shape)
    return made | {"omega0": np.broadcast_to(omega0, (*shape, 3)).reshape(-1, 3)}


def plan_from_pairs(inertia, omega0, attitude0, excess, unit):
    """The plan of one motion whose numbers are known beyond binary64, each the sum of two doubles.

    inertia (3, 2), omega0 (3, 2), attitude0 (4, 2), of the size that a largest component between
    1/2 and 4 has; excess (2,): K^2 - 2 H c_b, b the middle axis; unit: the power of two, in rad/s,
    that rates are times.  Raises ValueError as `plan`.
    """
    pairs = (np.asarray(x, float).T[:, None] for x in (inertia, omega0, attitude0))
    known = _Pair(*(np.array([x]) for x in excess))
    return _plan(*(_Pair(hi, lo) for hi, lo in pairs), np.array([[unit]]), (), known)


@np.errstate(all="ignore")
def _plan(c, given, q, unit, shape, excess=None):
    """c, given (rates) and q are pairs of shape (B, 3), (B, 3), (B, 4), in inner units."""
    length = sum((q[:, k] * q[:, k] for k in range(1, 4)), q[:, 0] * q[:, 0]).sqrt()
    q = [q[:, k] / length for k in range(4)]
    kept = np.abs(given.hi) >= NEGLIGIBLE
    omega = _Pair(np.where(kept, given.hi, 0.0), np.where(kept, given.lo, 0.0))
    axes, excess = _axes(c, omega, excess)
    steady = _is_steady(c, omega)
    _check_distance(c, axes, omega, given, excess)
    made = {
        "shape": shape,
        # Nothing turns at rest, however long it takes.
        "unit": np.where(np.any(omega.hi != 0, axis=-1), unit[:, 0], 0.0),
        "farthest": np.full(len(unit), FARTHEST),
        "axes": axes,
        "q0": np.stack([x.hi for x in q], axis=-1),
        "omega0": given.hi * unit,
        "groups": [],
    }
    if np.any(steady):
        index = np.flatnonzero(steady)
        made["groups"].append(("steady", index, _steady(omega[index], [x[index] for x in q])))
    if not np.all(steady):
        _add_moving(made, np.flatnonzero(~steady), c, omega, q, excess)
    return made


def _add_moving(made, index, c, omega, q, excess):
    """The groups of moving bodies: the circular and the hyperbolic branch."""
    axes = made["axes"][index]
    inertia = [c[index, axes[:, k]] for k in range(3)]
    rates = [omega[index, axes[:, k]] for k in range(3)]
    parts = np.stack([x.hi for x in q], -1), np.stack([x.lo for x in q], -1)
    vector = [_Pair(*(x[index, 1 + axes[:, k]] for x in parts)) for k in range(3)]
    epsilon = np.where((axes[:, 1] - axes[:, 0]) % 3 == 1, 1.0, -1.0)
    sigma = np.where(rates[0].hi < 0, -1.0, 1.0)
    rho = np.where(_is_below(inertia[0], inertia[2]), -1.0, 1.0)
    chi = np.where(-rho * epsilon * sigma * rates[2].hi < 0, -1.0, 1.0)
    signs = {"epsilon": epsilon, "sigma": sigma, "rho": rho, "chi": chi}
    known = dict(zip(("c_a", "c_b", "c_d"), inertia, strict=True))
    known |= dict(zip(("Omega_a", "Omega_b", "Omega_d"), rates, strict=True))
    known |= dict(zip(("q_0", "q_a", "q_b", "q_d"), (q[0][index], *vector), strict=True))
    known |= signs | {"E_b": excess[index], "unit": made["unit"][index]}
    if len(index) == 1:
        known = {name: _plain(value) for name, value in known.items()}
    known |= _called(START, known)
    small = known["k_1"].hi ** 2 <= 0.5
    for name, chosen in (("circular", small), ("hyperbolic", np.logical_not(small))):
        if np.any(chosen):
            some = np.flatnonzero(chosen)
            given = known if np.all(chosen) else {n: x[some] for n, x in known.items()}
            constants = _filled(_called(BRANCHES[name], given), some.size)
            _limit(made, index[some], constants, BRANCHES[name]["fast"])
            amplitudes = [given[f"A_{x}"].hi * given["unit"] for x in "abd"]
            _check_rates(constants, amplitudes, index[some])
            made["groups"].append((name, index[some], constants))


def _limit(made, index, constants, fast):
    """Bodies that cannot exist can turn much faster than at t = 0: then times must be nearer."""
    largest = np.max([np.abs(constants[name]) for name in fast], axis=0)
    made["farthest"][index] = FARTHEST * 16 / np.maximum(16, largest)


def _check_rates(constants, amplitudes, bodies):
    """Refuse what doubles do not hold, rates up to their amplitudes."""
    held = np.all([np.isfinite(x) for x in constants.values()], axis=0)
    for amplitude in amplitudes:
        held = held & (amplitude <= FASTEST)
    _refuse("omega0", "rates beyond what binary64 can hold", ~held, bodies)


def _called(entry, known):
    """What the plan of an entry returns, by name, from arguments found by name."""
    values = entry["plan"](*(known[name] for name in entry["given"]))
    return dict(zip(entry["names"], values, strict=True))


def _plain(value):
    """One number as Python's, which is faster than arrays of one."""
    if isinstance(value, _Pair):
        return _Pair(float(value.hi[0]), float(value.lo[0]))
    return float(value[0])


def _filled(constants, size):
    return {
        name: np.full(size, value) if np.ndim(value) == 0 else value
        for name, value in constants.items()
    }


def _steady(omega, q):
    rest = np.all(omega.hi == 0, axis=-1)
    first = _Pair(np.where(rest, 1.0, omega.hi[:, 0]), omega.lo[:, 0])
    values = _steady_plan(first, omega[:, 1], omega[:, 2], *q)
    constants = dict(zip(BRANCHES["steady"]["names"], values, strict=True))
    for name in ("Lambda_rate_hi", "Lambda_rate_lo"):
        constants[name] = np.where(rest, 0.0, constants[name])
    return constants


def states(plan, t, out=None):
    """(q, omega) at the times t in s: (..., 4) and (..., 3) for a scalar t, else (..., N, 4) and
    (..., N, 3) for t (N,).  q is continuous in the double cover from attitude0 on.

    out: arrays (q, omega) of these shapes to write into, which are returned.  Memory beyond them
    does not grow with N.
    """
    if out is None and type(t) is float and plan["shape"] == ():
        return _single(plan, t)
    times = np.asarray(t, float)
    if times.ndim > 1:
        raise ValueError("t: times must be one finite number or a one-dimensional array of them")
    shape = (*plan["shape"], *times.shape)
    q, omega = _results(out, shape)
    flat = times.reshape(-1)
    _check_times(plan, flat)
    bodies = (len(plan["unit"]), flat.size)
    rows = q.reshape(*bodies, 4), omega.reshape(*bodies, 3)
    for name, index, constants in plan["groups"]:
        _fill(plan, name, index, constants, flat, *rows)
    zero = np.flatnonzero(flat == 0)
    if zero.size:
        rows[0][:, zero] = plan["q0"][:, None]
        rows[1][:, zero] = plan["omega0"][:, None]
    return q, omega


def _single(plan, t):
    """The state of one body at one time, by Python's floats."""
    unit, farthest, axes, branch, rates, shape = plan.get("single") or _prepared(plan)
    inner = unit * t
    if not -farthest <= inner <= farthest:
        _check_times(plan, np.array([t]))
    if t == 0:
        return plan["q0"][0].copy(), plan["omega0"][0].copy()
    values = branch["state"](*branch["angles"](inner, *rates), *shape)
    if branch["steady"]:
        return np.array(values), plan["omega0"][0].copy()
    q, omega = [values[0], 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    for k, axis in enumerate(axes):
        q[1 + axis], omega[axis] = values[1 + k], values[4 + k]
    return np.array(q), np.array(omega)


def _prepared(plan):
    """The constants of one body as Python's floats; kept, since they serve every call."""
    ((name, _, constants),) = plan["groups"]
    branch = BRANCHES[name]
    known = {key: float(value[0]) for key, value in constants.items()}
    rates, shape = ([known[n] for n in branch[which]] for which in ("rates", "shape"))
    scale = float(plan["unit"][0]), float(plan["farthest"][0])
    plan["single"] = *scale, plan["axes"][0].tolist(), branch, rates, shape
    return plan["single"]


def _results(out, shape):
    wanted = ((*shape, 4), (*shape, 3))
    if out is None:
        return tuple(map(np.empty, wanted))
    if len(out) != 2 or any(not _fits(x, s) for x, s in zip(out, wanted, strict=True)):
        rule = f"must be C-contiguous float64 arrays of shapes {wanted[0]} and {wanted[1]}"
        raise ValueError(f"out: {rule}")
    return out


def _fits(array, shape):
    is_array = isinstance(array, np.ndarray) and array.dtype == float and array.shape == shape
    return is_array and array.flags.c_contiguous and array.flags.writeable


def _check_times(plan, t):
    if t.size and plan["unit"].size:
        with np.errstate(over="ignore"):
            # No array as long as t is made for this.
            latest = max(-np.min(t), np.max(t))
            inner = plan["unit"] * latest
        if not np.isfinite(latest):
            raise ValueError(
                "t: times must be one finite number or a one-dimensional array of them"
            )
        if not np.all(inner <= plan["farthest"]):
            raise ValueError("t: beyond |omega| t = 2^46 rad the angle is lost in binary64")


def _fill(plan, name, index, constants, t, q, omega):
    """The rows of one group, in blocks: of times, or of bodies where times are few."""
    branch = BRANCHES[name]
    timed, kept = (
        [constants[n] for n in branch[which] if n in constants] for which in ("rates", "shape")
    )
    if len(index) * t.size <= _BLOCK or t.size < _BLOCK // 4:
        step = max(1, _BLOCK // max(1, t.size))
        for first in range(0, len(index), step):
            some = slice(first, first + step)
            columns = [[x[some, None] for x in values] for values in (timed, kept)]
            inner = plan["unit"][index[some], None] * t
            _write(plan, branch, index[some], columns, inner, q, omega, slice(None))
        return
    step = -(-t.size // -(-t.size // _BLOCK))
    for number, body in enumerate(index):
        columns = [[float(x[number]) for x in values] for values in (timed, kept)]
        for first in range(0, t.size, step):
            some = slice(first, first + step)
            inner = float(plan["unit"][body]) * t[some]
            _write(plan, branch, body, columns, inner, q, omega, some)


@np.errstate(all="ignore")
def _write(plan, branch, body, columns, t, q, omega, some):
    """The states of one body at a block of times, or of some bodies at all times."""
    rates, shape = columns
    values = branch["state"](*branch["angles"](t, *rates), *shape)
    axes = plan["axes"][body]
    if branch["steady"]:
        for k in range(4):
            q[body, some, k] = values[k]
        omega[body, some] = plan["omega0"][body, None]
        return
    q[body, some, 0] = values[0]
    for k in range(3):
        q[body, some, 1 + axes[..., k]] = values[1 + k]
        omega[body, some, axes[..., k]] = values[4 + k]


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
    if np.any(np.min(_scaled(inertia)[0], axis=-1) < THINNEST):
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


def _refuse(field, rule, bad, bodies):
    """Raise an error where something is bad, with the number of the first such body."""
    found = bodies[np.broadcast_to(bad, bodies.shape)]
    if found.size:
        raise _RefusedError(f"{field}: {rule}", int(found[0]))


def _check_distance(c, axes, omega, given, excess):
    """Refuse what binary64 cannot tell from the separatrix or from spin about the middle axis.

    A rate taken for zero could decide when such a spin turns over.
    """
    distinct = ~(_same(c[:, 0], c[:, 1]) | _same(c[:, 1], c[:, 2]) | _same(c[:, 2], c[:, 0]))
    kept, before = (np.take_along_axis(x.hi, axes[:, ::2], -1) for x in (omega, given))
    lost = np.any((kept == 0) & (before != 0), -1) & np.all(np.abs(kept) < DECISIVE, -1)
    faint = (excess.hi != 0) & (np.abs(excess.hi) < FAINTEST)
    rule = "nearer to the separatrix than binary64 can follow"
    _refuse("omega0", rule, distinct & (lost | faint), np.arange(len(lost)))


def _scaled(x):
    """x over a power of two that brings its largest component into [1, 2), and that power."""
    exponent = np.frexp(np.max(np.abs(x), axis=-1, keepdims=True))[1] - 1
    return np.ldexp(x, -exponent), np.ldexp(1.0, exponent)


def _same(x, y):
    return (x.hi == y.hi) & (x.lo == y.lo)


def _is_below(x, y):
    return (x.hi < y.hi) | ((x.hi == y.hi) & (x.lo < y.lo))


def _is_steady(c, omega):
    """True where M and Omega are parallel, decided without rounding."""
    steady = np.ones(c.hi.shape[:-1], bool)
    for j, k in ((0, 1), (1, 2), (2, 0)):
        steady &= _same(c[:, j], c[:, k]) | (omega.hi[:, j] == 0) | (omega.hi[:, k] == 0)
    return steady


def _axes(c, omega, excess):
    """The indices of the axes (a, b, d), and E_b, whose sign chooses a."""
    order = np.lexsort((c.lo, c.hi), axis=-1)
    if excess is None:
        excess = _exact_excess(c.hi, omega.hi, order[:, ::-1])
    return np.where(excess.hi[:, None] >= 0, order[:, ::-1], order), excess


def _exact_excess(c, omega, axes):
    """E_b as a pair: where its terms cancel, from integers."""
    c, omega = (np.take_along_axis(x, axes, -1) for x in (c, omega))
    rates = omega[:, ::2]
    exponent = np.frexp(np.max(np.abs(rates), axis=-1))[1]
    inertia = [_Pair(c[:, k]) for k in range(3)]
    rate_a, rate_d = (_Pair(np.ldexp(rates[:, k], -exponent)) for k in range(2))
    zero = _Pair(0.0 * rate_a.hi)
    over, under = _excess(*inertia, rate_a, zero), _excess(*inertia, zero, rate_d)
    excess = over + under
    excess = _Pair(np.ldexp(excess.hi, 2 * exponent), np.ldexp(excess.lo, 2 * exponent))
    cancels = np.abs(over.hi + under.hi) <= 2.0**-10 * (over.hi - under.hi)
    for at in np.flatnonzero(cancels & (over.hi != 0)):
        excess.hi[at], excess.lo[at] = _integer_excess(c[at], omega[at])
    return excess


def _integer_excess(c, omega):
    """E_b of one motion in integer arithmetic, as two doubles."""
    (c, scale_c), (omega, scale_omega) = _integers(c), _integers(omega)
    excess = _excess(*c, omega[0], omega[2])
    shift = max(0, abs(excess).bit_length() - 160)
    kept = excess >> shift
    hi = float(kept)
    exponent = shift + 2 * (scale_c + scale_omega)
    return np.ldexp(hi, exponent), np.ldexp(float(kept - int(hi)), exponent)


def _integers(x):
    """Python integers and the power of two that turns them into x."""
    mantissa, exponent = np.frexp(x)
    exponent = np.where(x == 0, np.max(exponent), exponent)
    least = int(np.min(exponent))
    whole = [int(m) for m in np.ldexp(mantissa, 53)]
    return [m << int(e) - least for m, e in zip(whole, exponent, strict=True)], least - 53
