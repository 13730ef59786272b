"""Hand-written runtime of the NumPy module: groups of bodies, blocks of times, and shapes.

Its text is printed into the generated module, after the derived functions and the decisions.
"""

import math
from fractions import Fraction

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import (
    _DoubleDouble,
    _ldexp,
    _reversed,
    _taken,
    _where,
)
from rigidsym._codegen.targets.numpy.shared import (
    _are_finite,
    _check_finite,
    _refuse_codes,
    _RefusedError,
)
from rigidsym._codegen.targets.numpy.stubs import (
    BRANCHES,
    INITIAL_STATE,
    MAX_ANGLE,
    MAX_CIRCULAR,
    OK,
    RATES,
    RULES,
    TIME,
    _broken_rule,
    _course,
    _difference,
    _discriminant,
    _discriminant_of,
    _is_at_rest,
    _is_held,
    _limit,
    _normalised,
    _not_negligible,
    _scale_of,
    _scale_of_attitude,
    _scaled_rate,
    _side_of,
    _sorted_axes,
    _two_sum,
)

# --- runtime ---
# States computed at a time: their intermediate arrays fit the cache.
_BLOCK = 8192
_BAD_TIMES = "times must be one finite number or a one-dimensional array of them"


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
    _check_finite(dict(zip(("inertia", "omega0", "attitude0"), columns, strict=True)), refused)
    c, moment_unit = _in_units(columns[0], _scale_of(*columns[0]))
    _refuse_codes(_broken_rule(columns[0], c, columns[2]), refused)
    if refused is not None and refused.any():
        # Any body will do: its states are not given.
        rest = iter((1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0))
        columns = [[np.where(refused, next(rest), x) for x in each] for each in columns]
        c, moment_unit = _in_units(columns[0], _scale_of(*columns[0]))
    omega, unit = _in_units(columns[1], _scale_of(*columns[1]))
    q, _ = _in_units(columns[2], _scale_of_attitude(columns[2]))
    # Differences of doubles are two doubles exactly.
    apart = [_two_sum(c[k].hi, -c[(k + 1) % 3].hi) for k in range(3)]
    made = _prepared(c, apart, omega, q, unit, shape, refused)
    made["omega0"], made["moment_unit"] = _rows(columns[1]), _rows([moment_unit])[:, 0]
    if refused is not None and refused.any():
        made["q0"][refused] = made["omega0"][refused] = np.nan
        for _, index, constants in made["groups"]:
            for values in constants.values():
                values[refused[index]] = np.nan
    return made


def _in_units(columns, scale):
    """Return columns as double-doubles below 2, and the power of two that they are times."""
    parts = (_scaled_rate(x, -scale) for x in columns)
    return [_DoubleDouble(x, 0 * x) for x in parts], _ldexp(0.0 * columns[0] + 1.0, scale)


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
    q, omega = _normalised(q), [_not_negligible(x) for x in given]
    a, b, d = _sorted_axes(apart)
    if discriminant is None:
        discriminant = _discriminant_of(c, apart, omega, a, b, d)
    last, *omega, discriminant = _course(c, apart, given, omega, a, b, d, discriminant)
    side = _side_of(apart, omega, a, b, d, discriminant.hi)
    axes, rest = _reversed(side < 0, [a, b, d]), _is_at_rest(omega)
    # Nothing turns at rest, however long it takes.
    unit = _where(rest, 0.0, unit)
    made = {
        "shape": shape,
        "unit": _rows([unit])[:, 0],
        "max_angle": np.full(math.prod(shape), last),
        "blurred": np.full(math.prod(shape), last < MAX_ANGLE),
        "axes": _rows(axes),
        "q0": _rows([x.hi for x in q]),
        # What sensitivities are made from, where they are asked for.
        "given": (c, apart, omega, discriminant),
        "groups": [],
    }
    known = _by_axis(c, apart, omega, axes) | {"E_b": discriminant, "unit": unit, "q_0": q[0]}
    known |= {f"q_{x}": _taken(q[1:], axis) for x, axis in zip("abd", axes, strict=True)}
    known |= {f"p{k}": x for k, x in enumerate(q)}
    known |= {f"Omega{k + 1}": x for k, x in enumerate(omega)}
    known["Omega1"] = _where(rest, _DoubleDouble(1.0), omega[0])
    bodies = np.arange(math.prod(shape))
    _add(made, "steady", *_those(side == 0, bodies, known), refused)
    bodies, known = _those(side != 0, bodies, known)
    if bodies.size:
        known |= _called(INITIAL_STATE, known)
        is_small = known["k_1"].hi ** 2 <= MAX_CIRCULAR
        _add(made, "circular", *_those(is_small, bodies, known), refused)
        _add(made, "hyperbolic", *_those(is_small ^ True, bodies, known), refused)
    return made


def _rows(columns):
    """Stack N columns of B numbers into an array of shape (B, N)."""
    many = isinstance(columns[0], np.ndarray)
    return np.stack(columns, axis=-1) if many else np.array([columns])


def _by_axis(c, apart, omega, axes, start=""):
    """Return moments, their differences and rates by the names that they have in formulas."""
    a, b, d = axes
    known = {f"c_{x}": _taken(c, axis) for x, axis in zip("abd", axes, strict=True)}
    known |= {f"Omega_{x}{start}": _taken(omega, axis) for x, axis in zip("abd", axes, strict=True)}
    known |= {"c_ab": _difference(apart, a, b), "c_ad": _difference(apart, a, d)}
    return known | {"c_bd": _difference(apart, b, d), "axis_a": a, "axis_b": b, "axis_d": d}


def _those(chosen, bodies, known):
    """Select bodies, and what is known of them."""
    if not isinstance(chosen, np.ndarray) or chosen.all():
        return bodies[: np.size(chosen) if np.all(chosen) else 0], known
    return bodies[chosen], {name: x[chosen] for name, x in known.items()}


def _add(made, name, bodies, known, refused):
    """Append a group of bodies, with the constants of its branch, to `made`."""
    if not bodies.size:
        return
    branch = BRANCHES[name]
    constants, unit = _called(branch, known), known["unit"]
    if branch["steady"]:
        for rate in branch["fast"]:
            for part in (rate, f"{rate[:-2]}lo"):
                constants[part] = _where(unit == 0, 0.0, constants[part])
    else:
        rates = (constants[rate] for rate in branch["fast"])
        made["max_angle"][bodies] = _limit(made["max_angle"][bodies], *rates)
        held = _is_held(unit, *(known[f"A_{x}"].hi for x in "abd"))
        held = held & _are_finite([*constants.values()])
        _refuse_codes(_where(held, OK, RATES), refused, bodies)
    values = [*constants.values()]
    if isinstance(values[0], np.ndarray):
        rows = (np.full(bodies.size, x, float) for x in values)
    else:
        rows = np.array(values, float)[:, None]
    made["groups"].append((name, bodies, dict(zip(constants, rows, strict=True))))


def _called(entry, known):
    """Call the function of a table entry and return its results by name."""
    values = entry["constants"](*(known[name] for name in entry["given"]))
    return dict(zip(entry["names"], values, strict=True))


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
    given = _row_or_rows(times, count)
    rows = q.reshape(count, given.shape[1], 4), omega.reshape(count, given.shape[1], 3)
    late = not _are_near(prepared, given)
    if late and not lenient:
        _refuse_times(prepared, given)
    _fill(prepared, given, *rows)
    # The exact initial states where t = 0.
    body, time = np.nonzero(given == 0)
    for name, values in zip(("q0", "omega0"), rows, strict=True):
        if len(given) == 1:
            values[:, time] = prepared[name][:, None]
        else:
            values[body, time] = prepared[name][body]
    if late:
        _erase(prepared, given, rows)
    return q, omega


def _row_or_rows(t, count):
    """Return times as a matrix: one row for all motions, or one for each."""
    return t.reshape(count if t.ndim > 1 else 1, t.shape[-1] if t.ndim else 1)


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


@np.errstate(over="ignore", invalid="ignore")
def _are_near(prepared, t):
    """Return True if every time is finite and within the time domain of every body."""
    if not (t.size and prepared["unit"].size):
        return True
    # No array as long as a row is made for this.
    latest = np.maximum(-np.min(t, axis=-1), np.max(t, axis=-1))
    near = np.all(prepared["unit"] * latest <= prepared["max_angle"])
    return bool(near and np.all(np.isfinite(latest)))


def _refuse_times(prepared, t):
    """Raise an error that names the first time that is not finite or beyond its body's domain."""
    for body, number in np.argwhere(~np.isfinite(t))[:1]:
        raise _RefusedError("t", _BAD_TIMES, int(body) if len(t) > 1 else None, int(number))
    with np.errstate(over="ignore"):
        latest = prepared["unit"] * np.max(np.abs(t), axis=-1)
        body = np.flatnonzero(latest > prepared["max_angle"])[0]
        inner = np.abs(prepared["unit"][body] * t[body if len(t) > 1 else 0])
        time = np.flatnonzero(inner > prepared["max_angle"][body])[0]
    field, rule = RULES[TIME]
    if prepared["blurred"][body]:
        last = float(prepared["max_angle"][body] / prepared["unit"][body])
        rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
    raise _RefusedError(field, rule, int(body), int(time))


@np.errstate(all="ignore")
def _erase(prepared, t, rows):
    """Set states to NaN at times that are not finite or beyond their body's domain."""
    for bodies, blocks in _blocks(len(rows[0]), t.shape[1]):
        unit, last = (_column(prepared[name], bodies) for name in ("unit", "max_angle"))
        for some in blocks:
            near = abs(unit * t[bodies if len(t) > 1 else 0, some]) <= last
            for values in rows:
                values[bodies, some][~near] = np.nan


def _blocks(bodies, times):
    """Yield some bodies with all times, or where times are many one body with blocks of times."""
    if bodies > 1 and times < _BLOCK // 4:
        step = max(1, _BLOCK // max(1, times))
        yield from ((slice(k, k + step), [slice(None)]) for k in range(0, bodies, step))
        return
    step = max(1, -(-times // max(1, -(-times // _BLOCK))))
    # One time as a number: operations on such arrays take ten times as long.
    blocks = [slice(k, k + step) for k in range(0, times, step)] if times > 1 else [0] * times
    yield from ((body, blocks) for body in range(bodies))


def _column(values, bodies):
    """Return the values of some bodies as a column, or that of one as a float."""
    found = values[bodies]
    return found[:, None] if found.ndim else float(found)


@np.errstate(all="ignore")
def _fill(prepared, t, q, omega):
    """Write the states of all groups block by block."""
    for name, index, constants in prepared["groups"]:
        branch = BRANCHES[name]
        for bodies, blocks in _blocks(index.size, t.shape[1]):
            body = index[bodies]
            axes, unit = prepared["axes"][body], _column(prepared["unit"], body)
            rates = [_column(constants[n], bodies) for n in branch["rates"]]
            shape = [_column(constants[n], bodies) for n in branch["shape"]]
            for some in blocks:
                inner = unit * t[body if len(t) > 1 else 0, some]
                values = branch["state"](*branch["angles"](inner, *rates), *shape)
                if branch["steady"]:
                    for k in range(4):
                        q[body, some, k] = values[k]
                    omega[body, some] = prepared["omega0"][body, None]
                    continue
                q[body, some, 0] = values[0]
                for k in range(3):
                    q[body, some, 1 + axes[..., k]] = values[1 + k]
                    omega[body, some, axes[..., k]] = values[4 + k]


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


def _exact_discriminant(*doubles):
    """Return the discriminant of moments a, b, d and rates a, d, rounded from its exact value."""
    if not isinstance(doubles[0], float):
        rows = zip(*(x.tolist() for x in doubles), strict=True)
        pairs = [_exact_discriminant(*row) for row in rows]
        return _DoubleDouble(np.array([x.hi for x in pairs]), np.array([x.lo for x in pairs]))
    c_a, c_b, c_d, Omega_a, Omega_d = map(Fraction, doubles)
    exact = _discriminant(c_a, c_d, c_a - c_b, c_b - c_d, Omega_a, Omega_d)
    hi = float(exact)
    return _DoubleDouble(hi, float(exact - Fraction(hi)))
