"""The hand-written runtime of the NumPy module: which axis is which, scaling, branches and shapes.

Its text stands in the generated module after the pairs and the derived functions; here it is
importable only as far as linting goes.
"""

import numpy as np

from rigidsym.codegen.targets.numpy.stubs import (
    BRANCHES,
    DECISIVE,
    INITIAL_STATE,
    MAX_ANGLE,
    MAX_CIRCULAR,
    MAX_RATE,
    MIN_DISCRIMINANT,
    MIN_MOMENT_RATIO,
    NEGLIGIBLE,
    TOLERATED,
    _circulation,
    _discriminant,
    _DoubleDouble,
    _steady_constants,
    _two_sum,
)

# --- runtime ---
# States computed at a time: their intermediate arrays fit the cache.
_BLOCK = 8192
_LEAST = 2.0**-1074
_BAD_TIMES = "times must be one finite number or a one-dimensional array of them"


class _RefusedError(ValueError):
    """What a body or a time is refused for, each by its number.

    Bodies are counted through the leading axes.
    """

    def __init__(self, message, body=None, time=None):
        super().__init__(message)
        self.body, self.time = body, time


def prepare(inertia, omega0, attitude0=(1.0, 0.0, 0.0, 0.0), errors="raise"):
    """Constants of free motions, for `states`; nothing in them is the caller's memory.

    inertia (..., 3) in kg m^2 about principal axes, positive; omega0 (..., 3) in rad/s in body
    axes; attitude0 (..., 4), scalar first, body to inertial, of any length but zero.  The leading
    shapes broadcast.  Raises ValueError for wrong shapes and for numbers that are not finite, not
    positive where they have to be, or of too different size; with errors="nan" bodies of such
    numbers are kept, and their states are NaN.
    """
    given = [np.asarray(x, float) for x in (inertia, omega0, attitude0)]
    shape = _batch(*given)
    sizes = (3, 3, 4)
    rows = [
        np.broadcast_to(x, (*shape, size)).reshape(-1, size)
        for x, size in zip(given, sizes, strict=True)
    ]
    refused = np.zeros(len(rows[0]), bool) if _is_lenient(errors) else None
    _check(*rows, refused)
    if refused is not None and refused.any():
        # Any body will do: its states are not given.
        stand_in = ((1.0,), (0.0,), (1.0, 0.0, 0.0, 0.0))
        rows = [np.where(refused[:, None], x, row) for x, row in zip(stand_in, rows, strict=True)]
    (c, moment_unit), (omega, unit), (q, _) = map(_scaled, rows)
    # Differences of doubles are two doubles exactly.
    apart = _DoubleDouble(*_two_sum(c, -np.roll(c, -1, -1)))
    pairs = _DoubleDouble(c, 0 * c), apart, _DoubleDouble(omega, 0 * omega), _DoubleDouble(q, 0 * q)
    made = _prepared(*pairs, unit, shape, refused)
    made["omega0"], made["moment_unit"] = rows[1].copy(), moment_unit[:, 0]
    if refused is not None and refused.any():
        _blot_out(made, refused)
    return made


def prepare_from_double_doubles(inertia, differences, omega0, attitude0, discriminant, unit):
    """One motion prepared whose numbers are known beyond binary64, each the sum of two doubles.

    inertia (3, 2), omega0 (3, 2), attitude0 (4, 2), of the size that a largest component between
    1/2 and 4 has; what is subtracted from inertia is taken from differences (3, 2), moments 0 less
    1, 1 less 2 and 2 less 0, and from discriminant (2,): K^2 - 2 H c_b, b the middle axis; unit:
    the power of two, in rad/s, that rates are times.  Raises ValueError as `prepare`.
    """
    given = (inertia, differences, omega0, attitude0)
    c, apart, omega, q = (_DoubleDouble(*np.asarray(x, float).T[:, None]) for x in given)
    known = _DoubleDouble(*(np.array([x]) for x in discriminant))
    return _prepared(c, apart, omega, q, np.array([[unit]]), (), None, known)


@np.errstate(all="ignore")
def _prepared(c, apart, given, q, unit, shape, refused, discriminant=None):
    """c, given (rates) and q are pairs of shape (B, 3), (B, 3), (B, 4), in inner units; refused
    (B,) is where bodies that are are noted, None to raise an error instead.

    apart (B, 3): what each moment is above the next in turn.
    """
    length = sum((q[:, k] * q[:, k] for k in range(1, 4)), q[:, 0] * q[:, 0]).sqrt()
    q = [q[:, k] / length for k in range(4)]
    kept = np.abs(given.hi) >= NEGLIGIBLE
    omega = _DoubleDouble(np.where(kept, given.hi, 0.0), np.where(kept, given.lo, 0.0))
    axes = _sorted(apart)
    if discriminant is None:
        discriminant = _exact_discriminant(c.hi, omega.hi, axes)
    omega, discriminant, reach = _followed(c, apart, axes, omega, given, discriminant)
    side = _sides(apart, omega, axes, discriminant)
    axes = np.where(side[:, None] < 0, axes[:, ::-1], axes)
    steady = side == 0
    made = {
        "shape": shape,
        # Nothing turns at rest, however long it takes.
        "unit": np.where(np.any(omega.hi != 0, axis=-1), unit[:, 0], 0.0),
        "max_angle": reach,
        "blurred": reach < MAX_ANGLE,
        "axes": axes,
        "q0": np.stack([x.hi for x in q], axis=-1),
        "omega0": given.hi * unit,
        "moment_unit": np.ones(len(axes)),
        # What sensitivities are made from, where they are asked for.
        "given": (c, apart, omega, discriminant),
        "groups": [],
    }
    if np.any(steady):
        index = np.flatnonzero(steady)
        made["groups"].append(("steady", index, _steady(omega[index], [x[index] for x in q])))
    if not np.all(steady):
        _add_moving(made, np.flatnonzero(~steady), c, apart, omega, q, discriminant, refused)
    return made


def _add_moving(made, index, c, apart, omega, q, discriminant, refused):
    """The groups of moving bodies: the circular and the hyperbolic branch."""
    axes = made["axes"][index]
    inertia = [c[index, axes[:, k]] for k in range(3)]
    differences = _differences(apart[index], axes)
    rates = [omega[index, axes[:, k]] for k in range(3)]
    parts = np.stack([x.hi for x in q], -1), np.stack([x.lo for x in q], -1)
    vector = [_DoubleDouble(*(x[index, 1 + axes[:, k]] for x in parts)) for k in range(3)]
    known = dict(zip(("c_a", "c_b", "c_d"), inertia, strict=True))
    known |= dict(zip(("c_ab", "c_ad", "c_bd"), differences, strict=True))
    known |= dict(zip(("Omega_a", "Omega_b", "Omega_d"), rates, strict=True))
    known |= dict(zip(("q_0", "q_a", "q_b", "q_d"), (q[0][index], *vector), strict=True))
    known |= dict(zip(("axis_a", "axis_b", "axis_d"), axes.T, strict=True))
    known |= {"E_b": discriminant[index], "unit": made["unit"][index]}
    if len(index) == 1:
        known = {name: _plain(value) for name, value in known.items()}
    known |= _called(INITIAL_STATE, known)
    small = known["k_1"].hi ** 2 <= MAX_CIRCULAR
    for name, chosen in (("circular", small), ("hyperbolic", np.logical_not(small))):
        if np.any(chosen):
            some = np.flatnonzero(chosen)
            given = known if np.all(chosen) else {n: x[some] for n, x in known.items()}
            constants = _filled(_called(BRANCHES[name], given), some.size)
            _limit(made, index[some], constants, BRANCHES[name]["fast"])
            amplitudes = [given[f"A_{x}"].hi * given["unit"] for x in "abd"]
            _check_rates(constants, amplitudes, index[some], refused)
            made["groups"].append((name, index[some], constants))


def _limit(made, index, constants, fast):
    """Bodies that cannot exist can turn much faster than at t = 0: then times must be nearer."""
    largest = np.max([np.abs(constants[name]) for name in fast], axis=0)
    limit = MAX_ANGLE * 16 / np.maximum(16, largest)
    made["max_angle"][index] = np.minimum(made["max_angle"][index], limit)


def _check_rates(constants, amplitudes, bodies, refused):
    """Refuse what doubles do not hold, rates up to their amplitudes."""
    held = np.all([np.isfinite(x) for x in constants.values()], axis=0)
    for amplitude in amplitudes:
        held = held & (amplitude <= MAX_RATE)
    _refuse("omega0", "rates beyond what binary64 can hold", bodies[~held], refused)


def _blot_out(made, refused):
    """No numbers for all that states of refused bodies are made from."""
    made["q0"][refused] = made["omega0"][refused] = np.nan
    for _, index, constants in made["groups"]:
        for values in constants.values():
            values[refused[index]] = np.nan


def _called(entry, known):
    """What the constants of an entry are, by name, from arguments found by name."""
    values = entry["constants"](*(known[name] for name in entry["given"]))
    return dict(zip(entry["names"], values, strict=True))


def _plain(value):
    """One number as Python's, which is faster than arrays of one."""
    if isinstance(value, _DoubleDouble):
        return _DoubleDouble(float(value.hi[0]), float(value.lo[0]))
    return float(value[0])


def _filled(constants, size):
    return {
        name: np.full(size, value, float) if np.ndim(value) == 0 else np.asarray(value, float)
        for name, value in constants.items()
    }


def _steady(omega, q):
    rest = np.all(omega.hi == 0, axis=-1)
    first = _DoubleDouble(np.where(rest, 1.0, omega.hi[:, 0]), omega.lo[:, 0])
    values = _steady_constants(first, omega[:, 1], omega[:, 2], *q)
    constants = dict(zip(BRANCHES["steady"]["names"], values, strict=True))
    for name in ("Lambda_rate_hi", "Lambda_rate_lo"):
        constants[name] = np.where(rest, 0.0, constants[name])
    return constants


def states(prepared, t, out=None, errors="raise"):
    """(q, omega) at the times t in s: (..., 4) and (..., 3) for a scalar t, else (..., N, 4) and
    (..., N, 3) for t (N,) or, with a row for each motion, t (..., N).  q is continuous in the
    double cover from attitude0 on.

    out: arrays (q, omega) of these shapes to write into, which are returned; they share no memory
    with each other, t or what is prepared.  Memory beyond them does not grow with N.  Raises
    ValueError for times that are not finite or too late; with errors="nan" their states are NaN.
    """
    lenient = _is_lenient(errors)
    if out is None and type(t) is float and prepared["shape"] == ():
        return _single(prepared, t, lenient)
    times = np.asarray(t, float)
    shape, count = prepared["shape"], len(prepared["unit"])
    if times.ndim > 1 and times.shape[:-1] != shape:
        raise ValueError(f"t: {_BAD_TIMES}")
    q, omega = _results(out, (*shape, *times.shape[-1:]), times, prepared)
    # One row for all motions, or one for each.
    given = times.reshape(count if times.ndim > 1 else 1, times.shape[-1] if times.ndim else 1)
    late = not _are_near(prepared, given)
    if late and not lenient:
        _refuse_times(prepared, given)
    rows = q.reshape(count, given.shape[1], 4), omega.reshape(count, given.shape[1], 3)
    for name, index, constants in prepared["groups"]:
        _fill(prepared, name, index, constants, given, *rows)
    _begin(prepared, given, *rows)
    if late:
        _erase(prepared, given, *rows)
    return q, omega


def _of(t, bodies):
    """The rows of times of some motions: the same for all where t has one row."""
    return t if len(t) == 1 else t[bodies]


def _begin(prepared, t, q, omega):
    """Motions are at their start at t = 0, to the last bit."""
    body, zero = np.nonzero(t == 0)
    for name, rows in (("q0", q), ("omega0", omega)):
        if zero.size and len(t) == 1:
            rows[:, zero] = prepared[name][:, None]
        elif zero.size:
            rows[body, zero] = prepared[name][body]


def _is_lenient(errors):
    if errors not in ("raise", "nan"):
        raise ValueError("errors: must be 'raise' or 'nan'")
    return errors == "nan"


def _single(prepared, t, lenient):
    """The state of one body at one time, by Python's floats."""
    unit, max_angle, axes, branch, rates, shape = prepared.get("single") or _in_floats(prepared)
    inner = unit * t
    if not -max_angle <= inner <= max_angle:
        if lenient:
            return np.full(4, np.nan), np.full(3, np.nan)
        _refuse_times(prepared, np.array([[t]]))
    if t == 0:
        return prepared["q0"][0].copy(), prepared["omega0"][0].copy()
    values = branch["state"](*branch["angles"](inner, *rates), *shape)
    if branch["steady"]:
        return np.array(values), prepared["omega0"][0].copy()
    q, omega = [values[0], 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    for k, axis in enumerate(axes):
        q[1 + axis], omega[axis] = values[1 + k], values[4 + k]
    return np.array(q), np.array(omega)


def _in_floats(prepared):
    """The constants of one body as Python's floats; kept, since they serve every call."""
    ((name, _, constants),) = prepared["groups"]
    branch = BRANCHES[name]
    known = {key: float(value[0]) for key, value in constants.items()}
    rates, shape = ([known[n] for n in branch[which]] for which in ("rates", "shape"))
    scale = float(prepared["unit"][0]), float(prepared["max_angle"][0])
    prepared["single"] = *scale, prepared["axes"][0].tolist(), branch, rates, shape
    return prepared["single"]


def _results(out, shape, t, prepared):
    wanted = ((*shape, 4), (*shape, 3))
    if out is None:
        return tuple(map(np.empty, wanted))
    if len(out) != 2 or any(not _fits(x, s) for x, s in zip(out, wanted, strict=True)):
        rule = f"must be C-contiguous float64 arrays of shapes {wanted[0]} and {wanted[1]}"
        raise ValueError(f"out: {rule}")
    read = [t, *(prepared[name] for name in ("q0", "omega0", "unit", "max_angle", "axes"))]
    read += [x for _, index, constants in prepared["groups"] for x in (index, *constants.values())]
    if np.may_share_memory(*out) or any(np.may_share_memory(x, y) for x in out for y in read):
        raise ValueError("out: q and omega must not overlap each other or the inputs")
    return out


def _fits(array, shape):
    is_array = isinstance(array, np.ndarray) and array.dtype == float and array.shape == shape
    return is_array and array.flags.carray


def _are_near(prepared, t):
    """Whether all times are finite and near enough for all bodies."""
    if not (t.size and prepared["unit"].size):
        return True
    # No array as long as a row is made for this.
    latest = np.maximum(-np.min(t, axis=-1), np.max(t, axis=-1))
    with np.errstate(over="ignore", invalid="ignore"):
        near = np.all(prepared["unit"] * latest <= prepared["max_angle"])
    return bool(np.all(np.isfinite(latest)) and near)


def _refuse_times(prepared, t):
    """Raise an error for the first time that is not finite or, for the first such body, too far."""
    for body, number in np.argwhere(~np.isfinite(t))[:1]:
        raise _RefusedError(f"t: {_BAD_TIMES}", int(body) if len(t) > 1 else None, int(number))
    with np.errstate(over="ignore"):
        latest = prepared["unit"] * np.max(np.abs(t), axis=-1)
        body = np.flatnonzero(latest > prepared["max_angle"])[0]
        inner = np.abs(prepared["unit"][body] * t[body if len(t) > 1 else 0])
        late = np.flatnonzero(inner > prepared["max_angle"][body])[0]
    rule = "beyond |omega| t = 2^46 rad the angle is lost in binary64"
    if prepared["blurred"][body]:
        last = float(prepared["max_angle"][body] / prepared["unit"][body])
        rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
    raise _RefusedError(f"t: {rule}", int(body), int(late))


@np.errstate(all="ignore")
def _erase(prepared, t, q, omega):
    """No numbers for states at times that are not finite or too far."""
    step = max(1, _BLOCK // t.shape[1])
    for first in range(0, len(q), step):
        some = slice(first, first + step)
        own = _of(t, some)
        near = np.abs(prepared["unit"][some, None] * own) <= prepared["max_angle"][some, None]
        for rows in (q, omega):
            rows[some][~(near & np.isfinite(own))] = np.nan


@np.errstate(all="ignore")
def _fill(prepared, name, index, constants, t, q, omega):
    """The rows of one group, in blocks: of times, or of bodies where times are few."""
    branch = BRANCHES[name]
    timed, kept = (
        [constants[n] for n in branch[which] if n in constants] for which in ("rates", "shape")
    )
    size = t.shape[1]
    if len(index) * size <= _BLOCK or size < _BLOCK // 4:
        step = max(1, _BLOCK // max(1, size))
        for first in range(0, len(index), step):
            some = slice(first, first + step)
            columns = [[x[some, None] for x in values] for values in (timed, kept)]
            inner = prepared["unit"][index[some], None] * _of(t, index[some])
            _write(prepared, branch, index[some], columns, inner, q, omega, slice(None))
        return
    step = -(-size // -(-size // _BLOCK))
    for number, body in enumerate(index):
        columns = [[float(x[number]) for x in values] for values in (timed, kept)]
        for first in range(0, size, step):
            some = slice(first, first + step)
            inner = float(prepared["unit"][body]) * t[body if len(t) > 1 else 0, some]
            _write(prepared, branch, body, columns, inner, q, omega, some)


def _write(prepared, branch, body, columns, t, q, omega, some):
    """The states of one body at a block of times, or of some bodies at all times."""
    rates, shape = columns
    values = branch["state"](*branch["angles"](t, *rates), *shape)
    axes = prepared["axes"][body]
    if branch["steady"]:
        for k in range(4):
            q[body, some, k] = values[k]
        omega[body, some] = prepared["omega0"][body, None]
        return
    q[body, some, 0] = values[0]
    for k in range(3):
        q[body, some, 1 + axes[..., k]] = values[1 + k]
        omega[body, some, axes[..., k]] = values[4 + k]


def _check(inertia, omega0, attitude0, refused):
    """Refuse bodies by their numbers, (B, 3), (B, 3) and (B, 4)."""
    rows = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
    for name, values in rows.items():
        bad = ~np.all(np.isfinite(values), axis=-1)
        _refuse(name, "every number must be finite", np.flatnonzero(bad), refused)
    bad = np.any(inertia <= 0, axis=-1)
    _refuse("inertia", "principal moments must be positive", np.flatnonzero(bad), refused)
    with np.errstate(invalid="ignore"):
        thin = np.min(_scaled(inertia)[0], axis=-1) < MIN_MOMENT_RATIO
    rule = "principal moments differ by more than binary64 can follow"
    _refuse("inertia", rule, np.flatnonzero(thin), refused)
    bad = ~np.any(attitude0 != 0, axis=-1)
    _refuse("attitude0", "a zero quaternion is no attitude", np.flatnonzero(bad), refused)


def _batch(inertia, omega0, attitude0):
    """What the leading shapes broadcast to."""
    rows = {"inertia": (inertia, 3), "omega0": (omega0, 3), "attitude0": (attitude0, 4)}
    for name, (value, size) in rows.items():
        if value.ndim < 1 or value.shape[-1] != size:
            raise ValueError(f"{name}: shape {value.shape}: the last axis must have {size} numbers")
    shapes = [x.shape[:-1] for x in (inertia, omega0, attitude0)]
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        rule = f"leading shapes {shapes[1]} and {shapes[2]} must broadcast with {shapes[0]}"
        raise ValueError(f"omega0, attitude0: {rule} of inertia") from None


def _refuse(field, rule, bodies, refused):
    """Note the bodies, or raise an error with the number of the first."""
    if refused is not None:
        refused[bodies] = True
    elif len(bodies):
        raise _RefusedError(f"{field}: {rule}", int(bodies[0]))


def _followed(c, apart, axes, omega, given, discriminant):
    """Rates and E_b of the motions that are followed, and up to which inner times (B,).

    Where E_b is too faint, or rates taken for zero could decide when spin about the middle axis
    turns over, that is the separatrix, or that spin: the given motion leaves it in time.
    """
    reach = np.full(len(axes), MAX_ANGLE)
    distinct = np.all(apart.hi != 0, -1)
    kept, before = (np.take_along_axis(x.hi, axes[:, ::2], -1) for x in (omega, given))
    lost = np.any((kept == 0) & (before != 0), -1)
    faint = (discriminant.hi != 0) & (np.abs(discriminant.hi) < MIN_DISCRIMINANT)
    at = np.flatnonzero(distinct & (lost | faint))
    if not at.size:
        return omega, discriminant, reach
    inertia = np.take_along_axis(c.hi[at], axes[at], -1)
    between = _differences(apart[at], axes[at])
    rates = np.take_along_axis(given.hi[at], axes[at], -1)
    turns, spins, times = _blurred(
        inertia, between, rates, kept[at] == 0, discriminant.hi[at], faint[at]
    )
    reach[at] = np.where(turns, times, MAX_ANGLE)
    middle = axes[at, 1, None] == np.arange(3)
    zero = spins[:, None] & ~middle
    omega, discriminant = (_DoubleDouble(x.hi.copy(), x.lo.copy()) for x in (omega, discriminant))
    for part in (omega.hi, omega.lo):
        part[at] = np.where(zero, 0.0, part[at])
    for part in (discriminant.hi, discriminant.lo):
        part[at] = np.where(turns, 0.0, part[at])
    return omega, discriminant, reach


def _blurred(inertia, between, rates, lost, discriminant, faint):
    """Which motions are not followed but as separatrix or spin, which as spin, up to what times.

    With X = sqrt(c_a |c_a - c_b|) Omega_a, Z = sqrt(c_d |c_b - c_d|) Omega_d Euler's equations are
    X' = k Omega_b Z, Z' = k Omega_b X, but for signs.  So X + Z and X - Z, whose product is E_b,
    grow no faster than exp(lambda t), lambda being k times the largest |Omega_b|; of the separatrix
    one is zero, of the spin both are.  What of them is not zero may grow to 2^TOLERATED of the
    momentum.  Logarithms have base 2, because the numbers leave binary64.
    """
    c_a, c_b, c_d = inertia.T
    over, under = (np.abs(between[k].hi) for k in (0, 2))
    weights = np.log2(c_a * over) / 2, np.log2(c_d * under) / 2
    parts = [w + np.log2(np.abs(rates[:, k])) for w, k in zip(weights, (0, 2), strict=True)]
    size = np.logaddexp2(*parts)
    gone, left = (
        np.logaddexp2(*(np.where(lost[:, k] == which, x, -np.inf) for k, x in enumerate(parts)))
        for which in (True, False)
    )
    distance = np.log2(np.abs(discriminant))
    spins = (gone > left + np.log2(DECISIVE)) | (faint & (distance > 2 * size + np.log2(DECISIVE)))
    growth = np.sqrt(
        over / c_a * (under / c_d) * rates[:, 1] ** 2
        + under / c_b * ((over + under) / c_a) * rates[:, 2] ** 2
    )
    largest, least = np.maximum(c_a, c_d), np.minimum(c_a, c_d)
    momentum = np.log2(np.max(np.stack([c_a, c_b, c_d], -1) * np.abs(rates), -1) / largest)
    slow = np.minimum(0.0, np.log2(growth) + np.log2(least / largest))
    room = np.minimum(*weights) + momentum + slow - np.where(spins, size, distance - size)
    times = np.log(2.0) * (np.log2(TOLERATED) + room) / growth
    return spins | faint, spins, np.where(times > 0, np.minimum(times, MAX_ANGLE), 0.0)


def _scaled(x):
    """x over a power of two that brings its largest component into [1, 2), and that power."""
    exponent = np.frexp(np.max(np.abs(x), axis=-1, keepdims=True))[1] - 1
    scaled = np.ldexp(x, -exponent)
    # What is not zero stays so.
    return np.where((scaled == 0) & (x != 0), np.copysign(_LEAST, x), scaled), np.ldexp(
        1.0, exponent
    )


def _differences(apart, axes):
    """c_a - c_b, c_a - c_d and c_b - c_d as pairs of shape (B,)."""
    rows, found = np.arange(len(axes)), []
    for x, y in ((0, 1), (0, 2), (1, 2)):
        first, other = axes[:, x], axes[:, y]
        sign = np.where((other - first) % 3 == 1, 1.0, -1.0)
        which = rows, np.where(sign > 0, first, other)
        found.append(_DoubleDouble(sign * apart.hi[which], sign * apart.lo[which]))
    return found


def _sorted(apart):
    """The indices of the axes by their moments, largest first."""
    # By how many moments are below each, less those above.
    order = np.argsort(np.sign(apart.hi) - np.roll(np.sign(apart.hi), 1, -1), -1, kind="stable")
    return order[:, ::-1]


def _sides(apart, omega, axes, discriminant):
    """1 or -1 where a is the axis of largest or smallest moment, 0 where rates stay (B,)."""
    rates = np.take_along_axis(omega.hi, axes, -1)
    asked = [x.hi for x in _differences(apart, axes)] + [rates[:, k] for k in range(3)]
    given = [*(np.sign(np.abs(x)) for x in asked), discriminant.hi]
    if len(axes) == 1:
        given = [float(x[0]) for x in given]
    return np.reshape(_circulation(*given), -1)


def _exact_discriminant(c, omega, axes):
    """E_b as a pair: where its terms cancel, from integers."""
    c, omega = (np.take_along_axis(x, axes, -1) for x in (c, omega))
    rates = omega[:, ::2]
    exponent = np.frexp(np.max(np.abs(rates), axis=-1))[1]
    inertia = [_DoubleDouble(c[:, k]) for k in range(3)]
    rate_a, rate_d = (_DoubleDouble(np.ldexp(rates[:, k], -exponent)) for k in range(2))
    zero = _DoubleDouble(0.0 * rate_a.hi)
    known = inertia[0], inertia[2], inertia[0] - inertia[1], inertia[1] - inertia[2]
    over, under = _discriminant(*known, rate_a, zero), _discriminant(*known, zero, rate_d)
    discriminant = over + under
    discriminant = _DoubleDouble(
        np.ldexp(discriminant.hi, 2 * exponent), np.ldexp(discriminant.lo, 2 * exponent)
    )
    cancels = np.abs(over.hi + under.hi) <= 2.0**-10 * (over.hi - under.hi)
    for at in np.flatnonzero(cancels & (over.hi != 0)):
        discriminant.hi[at], discriminant.lo[at] = _integer_discriminant(c[at], omega[at])
    return discriminant


def _integer_discriminant(c, omega):
    """E_b of one motion in integer arithmetic, as two doubles."""
    (c, scale_c), (omega, scale_omega) = _integers(c), _integers(omega)
    discriminant = _discriminant(c[0], c[2], c[0] - c[1], c[1] - c[2], omega[0], omega[2])
    shift = max(0, abs(discriminant).bit_length() - 160)
    kept = discriminant >> shift
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
