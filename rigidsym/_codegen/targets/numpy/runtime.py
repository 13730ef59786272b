"""Hand-written runtime of the NumPy module: order of axes, scaling, branches and shapes.

Its text is printed into the generated module, after the derived functions.
"""

import math

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import (
    _DoubleDouble,
    _largest,
    _ldexp,
    _power,
    _reversed,
    _taken,
    _two_sum,
    _where,
)
from rigidsym._codegen.targets.numpy.stubs import (
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
    _steady_constants,
)

# --- runtime ---
# States computed at a time: their intermediate arrays fit the cache.
_BLOCK = 8192
_LEAST = 2.0**-1074
_BAD_TIMES = "times must be one finite number or a one-dimensional array of them"


class _RefusedError(ValueError):
    """Error for invalid input: the field, the rule, and the first body and time that break it.

    Bodies are counted through the leading axes.
    """

    def __init__(self, field, rule, body=None, time=None):
        super().__init__(field, rule, body, time)
        self.field, self.rule, self.body, self.time = field, rule, body, time

    def __str__(self):
        return f"{self.field}: {self.rule}"


def prepare(inertia, omega0, attitude0=(1.0, 0.0, 0.0, 0.0), errors="raise"):
    """Compute the constants of free motions that `states` takes.

    inertia (..., 3) in kg m^2 about principal axes, positive; omega0 (..., 3) in rad/s in body
    axes; attitude0 (..., 4), scalar first, body to inertial, of any length but zero.  The leading
    shapes broadcast; no memory is shared.  Raises ValueError for wrong shapes and for numbers that
    are not finite, not positive where they have to be, or of too different size; with errors="nan"
    bodies of such numbers are kept, and their states are NaN.
    """
    given = [np.asarray(x, float) for x in (inertia, omega0, attitude0)]
    shape, lenient = _batch(*given), _is_lenient(errors)
    if math.prod(shape) == 1:
        # In plain numbers: calls of NumPy would take ten times as long.
        try:
            return _made([x.reshape(-1).tolist() for x in given], shape, None)
        except ValueError:
            if not lenient:
                raise
        except ArithmeticError:
            pass
    rows = (np.broadcast_to(x, (*shape, x.shape[-1])).reshape(-1, x.shape[-1]) for x in given)
    columns = [[*x.T.copy()] for x in rows]
    return _made(columns, shape, np.zeros(math.prod(shape), bool) if lenient else None)


@np.errstate(all="ignore")
def _made(columns, shape, refused):
    """Compute the constants of motions from columns of inertia, omega0 and attitude0.

    Columns are arrays (B,), or Python's floats of one body.  Refused bodies are noted in `refused`
    (B,), or raise an error where it is None.  Python raises an ArithmeticError where arrays
    continue with infinities and NaN.
    """
    _check(*columns, refused)
    if refused is not None and refused.any():
        # Any body will do: its states are not given.
        stand_in = ((1.0,) * 3, (0.0,) * 3, (1.0, 0.0, 0.0, 0.0))
        columns = [
            [np.where(refused, *both) for both in zip(x, given, strict=True)]
            for x, given in zip(stand_in, columns, strict=True)
        ]
    (c, moment_unit), (omega, unit), (q, _) = map(_scaled, columns)
    # Differences of doubles are two doubles exactly.
    apart = [_DoubleDouble(*_two_sum(c[k], -c[(k + 1) % 3])) for k in range(3)]
    c, omega, q = ([_DoubleDouble(x, 0 * x) for x in values] for values in (c, omega, q))
    made = _prepared(c, apart, omega, q, unit, shape, refused)
    made["omega0"], made["moment_unit"] = _rows(columns[1]), _rows([moment_unit])[:, 0]
    if refused is not None and refused.any():
        _blot_out(made, refused)
    return made


def prepare_from_double_doubles(inertia, differences, omega0, attitude0, discriminant, unit):
    """Compute the constants of one motion from double-doubles, each the sum of two doubles.

    inertia (3, 2), omega0 (3, 2), attitude0 (4, 2), of the size that a largest component between
    1/2 and 4 has; what is subtracted from inertia is taken from differences (3, 2), moments 0 less
    1, 1 less 2 and 2 less 0, and from discriminant (2,): K^2 - 2 H c_b, b the middle axis; unit:
    the power of two, in rad/s, that rates are times.  Raises ValueError as `prepare`.
    """
    given = (inertia, differences, omega0, attitude0, [discriminant], [[unit, 0.0]])
    rows = [np.asarray(x, float) for x in given]
    try:
        return _made_from_pairs(*(x.tolist() for x in rows))
    except ArithmeticError:
        return _made_from_pairs(*(x[..., None] for x in rows))


@np.errstate(all="ignore")
def _made_from_pairs(*rows):
    columns = [[_DoubleDouble(*pair) for pair in x] for x in rows]
    c, apart, omega, q, (discriminant,), (unit,) = columns
    made = _prepared(c, apart, omega, q, unit.hi, (), None, discriminant)
    omega0 = _rows([x.hi * unit.hi for x in omega])
    return made | {"omega0": omega0, "moment_unit": np.ones(1)}


def _prepared(c, apart, given, q, unit, shape, refused, discriminant=None):
    """Compute the constants of motions from scaled moments c, rates `given` and attitudes q.

    apart: what each moment is above the next in turn.
    """
    length = sum((x * x for x in q[1:]), q[0] * q[0]).sqrt()
    q = [x / length for x in q]
    omega = [_where(abs(x.hi) >= NEGLIGIBLE, x, 0.0) for x in given]
    axes = _sorted(apart)
    if discriminant is None:
        discriminant = _exact_discriminant([x.hi for x in c], [x.hi for x in omega], axes)
    omega, discriminant, reach = _followed(c, apart, axes, omega, given, discriminant)
    side = _sides(apart, omega, axes, discriminant)
    axes = _reversed(side < 0, axes)
    # Nothing turns at rest, however long it takes.
    inner_unit = _where(_largest([x.hi for x in omega]) == 0, 0.0, unit)
    made = {
        "shape": shape,
        "unit": _rows([inner_unit])[:, 0],
        "max_angle": _rows([reach])[:, 0],
        "blurred": _rows([reach < MAX_ANGLE])[:, 0],
        "axes": _rows(axes),
        "q0": _rows([x.hi for x in q]),
        # What sensitivities are made from, where they are asked for.
        "given": (*map(_pair_rows, (c, apart, omega)), _pair_rows([discriminant])[:, 0]),
        "groups": [],
    }
    columns = c, apart, omega, q, axes, [discriminant, inner_unit]
    for add, chosen in ((_add_steady, side == 0), (_add_moving, side != 0)):
        index = np.flatnonzero(chosen)
        if index.size:
            some = columns
            if isinstance(side, np.ndarray):
                some = [[x[index] for x in each] for each in columns]
            add(made, index, *some, refused)
    return made


def _rows(columns):
    """Stack N columns of B numbers into an array of shape (B, N)."""
    many = isinstance(columns[0], np.ndarray)
    return np.stack(columns, axis=-1) if many else np.array([columns])


def _pair_rows(columns):
    return _DoubleDouble(_rows([x.hi for x in columns]), _rows([x.lo for x in columns]))


def _add_steady(made, index, c, apart, omega, q, axes, others, refused):
    """Append the group of bodies with constant rates to `made`."""
    rest = _largest([x.hi for x in omega]) == 0
    first = _DoubleDouble(_where(rest, 1.0, omega[0].hi), omega[0].lo)
    values = _steady_constants(first, omega[1], omega[2], *q)
    constants = dict(zip(BRANCHES["steady"]["names"], values, strict=True))
    for name in ("Lambda_rate_hi", "Lambda_rate_lo"):
        constants[name] = _where(rest, 0.0, constants[name])
    made["groups"].append(("steady", index, _filled(constants, index.size)))


def _add_moving(made, index, c, apart, omega, q, axes, others, refused):
    """Append the groups of the circular and of the hyperbolic branch to `made`."""
    known = dict(zip(("c_ab", "c_ad", "c_bd"), _differences(apart, axes), strict=True))
    for x, axis in zip("abd", axes, strict=True):
        known[f"c_{x}"], known[f"Omega_{x}"] = _taken(c, axis), _taken(omega, axis)
        known[f"q_{x}"], known[f"axis_{x}"] = _taken(q[1:], axis), axis
    known["q_0"], known["E_b"], known["unit"] = q[0], *others
    known |= _called(INITIAL_STATE, known)
    small = known["k_1"].hi ** 2 <= MAX_CIRCULAR
    for name, chosen in (("circular", small), ("hyperbolic", np.logical_not(small))):
        some = np.flatnonzero(chosen)
        if some.size:
            whole = some.size == index.size
            given = known if whole else {n: x[some] for n, x in known.items()}
            constants = _called(BRANCHES[name], given)
            _limit(made, index[some], constants, BRANCHES[name]["fast"])
            amplitudes = [given[f"A_{x}"].hi * given["unit"] for x in "abd"]
            _check_rates(constants, amplitudes, index[some], refused)
            made["groups"].append((name, index[some], _filled(constants, some.size)))


def _limit(made, index, constants, fast):
    """Shorten the time domain of nonphysical bodies, which can speed up a lot after t = 0."""
    largest = _largest([constants[name] for name in fast])
    limit = MAX_ANGLE * 16 / _where(largest > 16, largest, 16.0)
    made["max_angle"][index] = np.minimum(made["max_angle"][index], limit)


def _check_rates(constants, amplitudes, bodies, refused):
    """Refuse bodies whose constants or largest rates overflow binary64."""
    held = _are_finite([*constants.values()]) & (_largest(amplitudes) <= MAX_RATE)
    _refuse("omega0", "rates beyond what binary64 can hold", held, refused, bodies)


def _blot_out(made, refused):
    """Set all constants of refused bodies to NaN."""
    made["q0"][refused] = made["omega0"][refused] = np.nan
    for _, index, constants in made["groups"]:
        for values in constants.values():
            values[refused[index]] = np.nan


def _called(entry, known):
    """Call the function of a table entry and return its results by name."""
    values = entry["constants"](*(known[name] for name in entry["given"]))
    return dict(zip(entry["names"], values, strict=True))


def _plain(value):
    """Convert an array of one number to a Python float, which is faster to compute with."""
    if isinstance(value, _DoubleDouble):
        return _DoubleDouble(float(value.hi[0]), float(value.lo[0]))
    return float(value[0])


def _filled(constants, size):
    values = [*constants.values()]
    if isinstance(values[0], np.ndarray):
        rows = (np.full(size, x, float) if np.ndim(x) == 0 else x.astype(float) for x in values)
    else:
        rows = np.array(values, float)[:, None]
    return dict(zip(constants, rows, strict=True))


def states(prepared, t, out=None, errors="raise"):
    """Return the attitudes q and the body rates omega at the times t in s.

    Shapes are (..., 4) and (..., 3) for a scalar t, else (..., N, 4) and (..., N, 3) for t (N,) or,
    with a row for each motion, t (..., N).  q is continuous in the double cover from attitude0 on.
    out: arrays (q, omega) of these shapes to write into, which are returned; they share no memory
    with each other, t or `prepared`.  Memory beyond them does not grow with N.  Raises ValueError
    for times that are not finite or too late; with errors="nan" their states are NaN.
    """
    lenient = _is_lenient(errors)
    if out is None and type(t) is float and prepared["shape"] == ():
        return _single(prepared, t, lenient)
    times = np.asarray(t, float)
    shape, count = prepared["shape"], len(prepared["unit"])
    if times.ndim > 1 and times.shape[:-1] != shape:
        raise _RefusedError("t", _BAD_TIMES)
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
    """Return the rows of t for some bodies; a single row is used for all bodies."""
    return t if len(t) == 1 else t[bodies]


def _begin(prepared, t, q, omega):
    """Write the exact initial states where t = 0."""
    body, zero = np.nonzero(t == 0)
    for name, rows in (("q0", q), ("omega0", omega)):
        if zero.size and len(t) == 1:
            rows[:, zero] = prepared[name][:, None]
        elif zero.size:
            rows[body, zero] = prepared[name][body]


def _is_lenient(errors):
    if errors not in ("raise", "nan"):
        raise _RefusedError("errors", "must be 'raise' or 'nan'")
    return errors == "nan"


def _single(prepared, t, lenient):
    """Compute the state of one body at one time with Python floats."""
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
    """Convert the constants of one body to Python floats and cache them in `prepared`."""
    ((name, _, constants),) = prepared["groups"]
    branch = BRANCHES[name]
    known = {key: value.item() for key, value in constants.items()}
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
        raise _RefusedError("out", rule)
    read = [t, *(prepared[name] for name in ("q0", "omega0", "unit", "max_angle", "axes"))]
    read += [x for _, index, constants in prepared["groups"] for x in (index, *constants.values())]
    if np.may_share_memory(*out) or any(np.may_share_memory(x, y) for x in out for y in read):
        raise _RefusedError("out", "q and omega must not overlap each other or the inputs")
    return out


def _fits(array, shape):
    is_array = isinstance(array, np.ndarray) and array.dtype == float and array.shape == shape
    return is_array and array.flags.carray


def _are_near(prepared, t):
    """Return True if every time is finite and within the time domain of every body."""
    if not (t.size and prepared["unit"].size):
        return True
    # No array as long as a row is made for this.
    latest = np.maximum(-np.min(t, axis=-1), np.max(t, axis=-1))
    with np.errstate(over="ignore", invalid="ignore"):
        near = np.all(prepared["unit"] * latest <= prepared["max_angle"])
    return bool(np.all(np.isfinite(latest)) and near)


def _refuse_times(prepared, t):
    """Raise an error that names the first time that is not finite or beyond its body's domain."""
    for body, number in np.argwhere(~np.isfinite(t))[:1]:
        raise _RefusedError("t", _BAD_TIMES, int(body) if len(t) > 1 else None, int(number))
    with np.errstate(over="ignore"):
        latest = prepared["unit"] * np.max(np.abs(t), axis=-1)
        body = np.flatnonzero(latest > prepared["max_angle"])[0]
        inner = np.abs(prepared["unit"][body] * t[body if len(t) > 1 else 0])
        late = np.flatnonzero(inner > prepared["max_angle"][body])[0]
    rule = "beyond |omega| t = 2^46 rad the angle is lost in binary64"
    if prepared["blurred"][body]:
        last = float(prepared["max_angle"][body] / prepared["unit"][body])
        rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
    raise _RefusedError("t", rule, int(body), int(late))


@np.errstate(all="ignore")
def _erase(prepared, t, q, omega):
    """Set states to NaN at times that are not finite or beyond their body's domain."""
    step = max(1, _BLOCK // t.shape[1])
    for first in range(0, len(q), step):
        some = slice(first, first + step)
        own = _of(t, some)
        near = np.abs(prepared["unit"][some, None] * own) <= prepared["max_angle"][some, None]
        for rows in (q, omega):
            rows[some][~(near & np.isfinite(own))] = np.nan


@np.errstate(all="ignore")
def _fill(prepared, name, index, constants, t, q, omega):
    """Write one group's states to the output in blocks of times, or of bodies for few times."""
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
    """Write the states of one body at a block of times, or of several bodies at all times."""
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
    """Check columns of inertia, omega0 and attitude0, and refuse invalid bodies."""
    rows = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
    for name, columns in rows.items():
        _refuse(name, "every number must be finite", _are_finite(columns), refused)
    a, b, c = inertia
    rule = "principal moments must be positive"
    _refuse("inertia", rule, (a > 0) & (b > 0) & (c > 0), refused)
    unit = 1 - _power(_largest(inertia))
    a, b, c = (_ldexp(x, unit) >= MIN_MOMENT_RATIO for x in inertia)
    rule = "principal moments differ by more than binary64 can follow"
    _refuse("inertia", rule, a & b & c, refused)
    rule = "a zero quaternion is no attitude"
    _refuse("attitude0", rule, _largest(attitude0) != 0, refused)


def _are_finite(columns):
    if isinstance(columns[0], np.ndarray):
        return np.all([np.isfinite(x) for x in np.broadcast_arrays(*columns)], axis=0)
    return all(map(math.isfinite, columns))


def _batch(inertia, omega0, attitude0):
    """Return the shape that the leading axes of all inputs broadcast to."""
    rows = {"inertia": (inertia, 3), "omega0": (omega0, 3), "attitude0": (attitude0, 4)}
    for name, (value, size) in rows.items():
        if value.ndim < 1 or value.shape[-1] != size:
            rule = f"shape {value.shape}: the last axis must have {size} numbers"
            raise _RefusedError(name, rule)
    shapes = [x.shape[:-1] for x in (inertia, omega0, attitude0)]
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        omega0, attitude0 = shapes[1:]
        rule = f"leading shapes {omega0} and {attitude0} must broadcast with {shapes[0]} of inertia"
        raise _RefusedError("omega0, attitude0", rule) from None


def _refuse(field, rule, good, refused, bodies=None):
    """Mark the bodies where `good` is False as refused, or raise an error for the first."""
    if good is not True:
        at = np.flatnonzero(np.logical_not(good))
        at = at if bodies is None else bodies[at]
        if refused is not None:
            refused[at] = True
        elif at.size:
            raise _RefusedError(field, rule, int(at[0]))


def _followed(c, apart, axes, omega, given, discriminant):
    """Replace motions too near the separatrix by separatrix motions or spins, with last times.

    Where E_b is too faint, or rates taken for zero could decide when spin about the middle axis
    turns over, that is the separatrix, or that spin: the given motion leaves it in time.
    """
    a, b, d = (x.hi != 0 for x in apart)
    lost = [(_taken(omega, x).hi == 0) & (_taken(given, x).hi != 0) for x in axes[::2]]
    faint = (discriminant.hi != 0) & (abs(discriminant.hi) < MIN_DISCRIMINANT)
    doubtful = a & b & d & (lost[0] | lost[1] | faint)
    if doubtful is False:
        return omega, discriminant, MAX_ANGLE
    if doubtful is True:
        raise FloatingPointError("left to arrays")
    reach, at = np.full(len(doubtful), MAX_ANGLE), np.flatnonzero(doubtful)
    if not at.size:
        return omega, discriminant, reach
    c, apart, moving, rates = ([x[at] for x in columns] for columns in (c, apart, omega, given))
    some = [x[at] for x in axes]
    inertia, kept, rates = (
        np.stack([_taken(columns, x).hi for x in some], -1) for columns in (c, moving, rates)
    )
    between = _differences(apart, some)
    turns, spins, times = _blurred(
        inertia, between, rates, (kept == 0)[:, ::2], discriminant.hi[at], faint[at]
    )
    reach[at] = np.where(turns, times, MAX_ANGLE)
    omega = [_DoubleDouble(x.hi.copy(), x.lo.copy()) for x in omega]
    for k, x in enumerate(omega):
        for part in (x.hi, x.lo):
            part[at] = np.where(spins & (some[1] != k), 0.0, part[at])
    discriminant = _DoubleDouble(discriminant.hi.copy(), discriminant.lo.copy())
    for part in (discriminant.hi, discriminant.lo):
        part[at] = np.where(turns, 0.0, part[at])
    return omega, discriminant, reach


def _blurred(inertia, between, rates, lost, discriminant, faint):
    """Return masks of the motions to replace and of those replaced by spins, and last times.

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


def _scaled(columns):
    """Scale columns so that the largest lies in [1, 2); return them and the power of two."""
    exponent = _power(_largest(columns)) - 1
    scaled = []
    for x in columns:
        one = _ldexp(x, -exponent)
        # What is not zero stays so.
        least = _where(x < 0, -_LEAST, _LEAST)
        scaled.append(_where((one == 0) & (x != 0), least, one))
    return scaled, _ldexp(0.0 * columns[0] + 1.0, exponent)


def _differences(apart, axes):
    """Return c_a - c_b, c_a - c_d and c_b - c_d as double-doubles."""
    found = []
    for x, y in ((0, 1), (0, 2), (1, 2)):
        forward = (axes[y] - axes[x]) % 3 == 1
        sign = _where(forward, 1.0, -1.0)
        one = _taken(apart, _where(forward, axes[x], axes[y]))
        found.append(_DoubleDouble(sign * one.hi, sign * one.lo))
    return found


def _sign(x):
    return (x > 0) * 1.0 - (x < 0) * 1.0


def _sorted(apart):
    """Sort the axes by their moments, largest first."""
    # By how many moments are below each, less those above.
    above = [_sign(x.hi) for x in apart]
    ranks = [above[k] - above[k - 1] for k in range(3)]
    if isinstance(ranks[0], np.ndarray):
        return [*np.argsort(ranks, axis=0, kind="stable")[::-1]]
    return sorted(range(3), key=ranks.__getitem__)[::-1]


def _sides(apart, omega, axes, discriminant):
    """Return 1 or -1 by circulation about the axis of largest or smallest moment, else 0."""
    asked = (*_differences(apart, axes), *(_taken(omega, axis) for axis in axes))
    return _circulation(*(_sign(abs(x.hi)) for x in asked), discriminant.hi)


def _exact_discriminant(c, omega, axes):
    """Return the discriminant E_b as a double-double, computed exactly where its terms cancel."""
    c, omega = ([_taken(columns, axis) for axis in axes] for columns in (c, omega))
    exponent = _power(_largest(omega[::2]))
    inertia = [_DoubleDouble(x) for x in c]
    rate_a, rate_d = (_DoubleDouble(_ldexp(x, -exponent)) for x in omega[::2])
    zero = _DoubleDouble(0.0 * rate_a.hi)
    known = inertia[0], inertia[2], inertia[0] - inertia[1], inertia[1] - inertia[2]
    over, under = _discriminant(*known, rate_a, zero), _discriminant(*known, zero, rate_d)
    both = over + under
    hi, lo = _ldexp(both.hi, 2 * exponent), _ldexp(both.lo, 2 * exponent)
    cancels = abs(over.hi + under.hi) <= 2.0**-10 * (over.hi - under.hi)
    cancels = cancels & (over.hi != 0)
    if cancels is True:
        hi, lo = _integer_discriminant(c, omega)
    for at in np.flatnonzero(cancels) if isinstance(cancels, np.ndarray) else ():
        hi[at], lo[at] = _integer_discriminant([x[at] for x in c], [x[at] for x in omega])
    return _DoubleDouble(hi, lo)


def _integer_discriminant(c, omega):
    """Compute the discriminant E_b of one motion in integers; return its high and low double."""
    (c, scale_c), (omega, scale_omega) = _integers(c), _integers(omega)
    discriminant = _discriminant(c[0], c[2], c[0] - c[1], c[1] - c[2], omega[0], omega[2])
    shift = max(0, abs(discriminant).bit_length() - 160)
    kept = discriminant >> shift
    hi = float(kept)
    exponent = shift + 2 * (scale_c + scale_omega)
    return math.ldexp(hi, exponent), math.ldexp(float(kept - int(hi)), exponent)


def _integers(x):
    """Write doubles as integers times one power of two; return the integers and its exponent."""
    mantissa, exponent = np.frexp(x)
    exponent = np.where(x == 0, np.max(exponent), exponent)
    least = int(np.min(exponent))
    whole = [int(m) for m in np.ldexp(mantissa, 53)]
    return [m << int(e) - least for m, e in zip(whole, exponent, strict=True)], least - 53
