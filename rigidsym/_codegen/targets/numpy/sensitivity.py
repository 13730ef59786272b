"""Hand-written runtime of sensitivities: order of axes, scaling, blocks and shapes.

Its text is printed into the generated module of the theta form, after `runtime`.
"""

import math

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import (
    _DoubleDouble,
    _power,
    _reversed,
    _where,
)
from rigidsym._codegen.targets.numpy.runtime import (
    _blocks,
    _by_axis,
    _called,
    _column,
    _row_or_rows,
    _rows,
    states,
)
from rigidsym._codegen.targets.numpy.shared import _RefusedError
from rigidsym._codegen.targets.numpy.stubs import (
    GROWTH,
    MAX_REAL,
    RULES,
    SENSITIVITY,
    _difference,
    never,
)

# --- runtime ---
# The changes at t = 0: of the attitude with a small turn, of the rates with those.
_AT_ONCE = np.eye(3, 9), np.eye(3, 9, 3)
# What there are columns for, in their order.
COLUMNS = ("attitude0", "omega0", "inertia", "t")


@np.errstate(all="ignore")
def sensitivities(prepared, t, errors="raise", columns=COLUMNS):
    """Return the states at the times t in s and their derivatives by the inputs.

    (q, omega, attitude, rates, attitude_t, rates_t): q (..., 4) and omega (..., 3) are those of
    `states`.  attitude and rates (..., 3, 9): a small turn in space, eta with delta R = [eta] R,
    and the body rates, by a small turn at t = 0, the rates there, and the principal moments;
    attitude_t and rates_t (..., 3): by the time.  What leaves binary64 in these units is infinite.
    Raises ValueError as `states` does, and for times at which binary64 does not hold the squares of
    changes in any; with errors="nan" there are no numbers then.  With `columns`, some of the names
    in COLUMNS, there are no others: three for each of the first three names, in their order.
    """
    asked = [name for name in COLUMNS if name in columns]
    if len(asked) != len(columns):
        raise _RefusedError("columns", f"must be some of {', '.join(COLUMNS)}, each once")
    # Where in a row the columns of each begin, and which those are of all nine.
    first = {name: 3 * k for k, name in enumerate(asked) if name != "t"}
    chosen = [3 * COLUMNS.index(name) + k for name in first for k in range(3)]
    # One time of one body as a number, which has the shortest way.
    if np.ndim(t) == 0 and prepared["shape"] == ():
        t = float(t)
    q, omega = states(prepared, t, None, errors)
    given = _row_or_rows(np.asarray(t, float), len(prepared["unit"]))
    by_t = (3 * ("t" in asked),)
    ends = (3, len(chosen)), (3, len(chosen)), by_t, by_t
    # In one block of memory: allocators return several to the system page by page.
    sizes = [math.prod((*omega.shape[:-1], *end)) for end in ends]
    block, found = np.zeros(sum(sizes)), []
    for size, end in zip(sizes, ends, strict=True):
        found.append(block[:size].reshape(*omega.shape[:-1], *end))
        block = block[size:]
    shape = len(prepared["unit"]), given.shape[1]
    rows = [
        x.reshape(*shape, *end)
        for x, end in zip((q, omega, *found), ((4,), (3,), *ends), strict=True)
    ]
    if "elapsed" not in prepared:
        prepared["elapsed"] = _elapsed(prepared)
    # While blocks are in the cache it is seen whether any number is lost.
    lost = [_fill_sensitivities(prepared, one, given, rows, first) for one in prepared["elapsed"]]
    at_once = [x[:, chosen] for x in _AT_ONCE]
    _at_rest(prepared, given, rows, first, at_once)
    # The exact initial derivatives where t = 0.
    for body, time in np.argwhere(given == 0):
        some = slice(None) if len(given) == 1 else body
        rows[2][some, time], rows[3][some, time] = at_once
    if any(lost):
        _check_held(rows, errors)
    return (q, omega, *found)


def _elapsed(prepared):
    """Compute the constants of sensitivities, grouped by nome and order of axes."""
    c, apart, omega, discriminant = prepared["given"]
    is_plain = isinstance(discriminant.hi, float)
    axes = prepared["axes"][0].tolist() if is_plain else [*prepared["axes"].T]
    # Where rates are constant, too, a is the axis with p >= r.
    turned = _difference(apart, axes[0], axes[2]).hi * discriminant.hi < 0
    axes = _reversed(turned, axes)
    known = _by_axis(c, apart, omega, axes, "0") | {"E_b": discriminant} | _phases(prepared)
    for k in range(3):
        known |= {f"c{k + 1}": c[k].hi, f"Omega{k + 1}_0": omega[k].hi}
    for j, k in ((0, 1), (0, 2), (1, 2)):
        known[f"c{j + 1}{k + 1}"] = _difference(apart, j, k).hi
    # At rest nothing comes of it.
    known["Omega1_0"] = _where(prepared["unit"] == 0, 1.0, known["Omega1_0"])
    known |= {f"p{k}": prepared["q0"][:, k] for k in range(4)}
    if len(prepared["unit"]) == 1:
        known = {name: _plain(value) for name, value in known.items()}
    known |= _called(SENSITIVITY["moduli"], known)
    is_real = np.reshape(known["modulus"].hi ** 2 <= MAX_REAL, -1)
    groups, orders = [], _rows(axes)
    for order in sorted(set(map(tuple, orders.tolist()))):
        ordered = np.all(orders == order, axis=-1)
        for name, chosen in (("real", is_real & ordered), ("imaginary", ~is_real & ordered)):
            index = np.flatnonzero(chosen)
            if index.size:
                groups.append((name, order, index, _of_group(name, index, known)))
    return groups


def _plain(value):
    """Convert an array of one number to a Python float, which is faster to compute with."""
    if isinstance(value, _DoubleDouble):
        return _DoubleDouble(_plain(value.hi), _plain(value.lo))
    return float(np.reshape(value, -1)[0])


def _phases(prepared):
    """Return the phases at t = 0, and limits of p t^2 above which these phases are used."""
    reach, y0 = np.full(len(prepared["axes"]), never), np.zeros((2, len(prepared["axes"])))
    for name, index, constants in prepared["groups"]:
        if name == "hyperbolic":
            reach[index] = 1.0
            y0[:, index] = constants["y0_hi"], constants["y0_lo"]
    return {"reach": reach, "y0": _DoubleDouble(*y0)}


def _of_group(name, index, known):
    """Return a group's constants by the function using them: arrays, or floats of one body."""
    if np.ndim(known["c1"]):
        known = {key: value[index] for key, value in known.items()}
    made = {}
    for part in (name, "along", "columns", "turn"):
        constants = _called(SENSITIVITY[part], known).items()
        made[part] = {key: np.full(index.size, value, float) for key, value in constants}
    return _of_some(made, 0) if index.size == 1 else made


def _of_some(made, bodies):
    """Return the constants of some bodies as columns, or those of one as floats."""
    return {
        part: {key: _column(x, bodies) for key, x in known.items()} for part, known in made.items()
    }


def _fill_sensitivities(prepared, group, t, rows, first_of):
    """Write the sensitivities of one group to the output arrays block by block.

    Returns True if any number is lost.
    """
    name, order, index, made = group
    lost = False
    for bodies, blocks in _blocks(index.size, t.shape[1]):
        body = index[bodies]
        known = made if index.size == 1 else _of_some(made, bodies)
        units = [_column(prepared[x], body) for x in ("unit", "moment_unit")]
        for some in blocks:
            times, place = t[body if len(t) > 1 else 0, some], (body, some)
            lost |= _write_sensitivities(name, order, known, units, times, rows, place, first_of)
    return lost


def _write_sensitivities(name, order, constants, units, t, rows, place, first_of):
    """Write the sensitivities of one body at a block of times, or of several at all times.

    Returns True if any number is lost.
    """
    unit, moment_unit = units
    q, omega = (x[place] for x in rows[:2])
    scale = unit + (unit == 0)
    known = {"t": unit * t} | {f"q{k}": q[..., k][()] for k in range(4)}
    known |= {f"Omega{k + 1}": omega[..., k] / scale for k in range(3)}
    letters = [*zip("abd", order, strict=True)]
    known |= {f"Omega_{x}": known[f"Omega{axis + 1}"] for x, axis in letters}
    entry = SENSITIVITY[name]
    by_time = entry["angles"](known["t"], *(constants[name][n] for n in entry["rates"]))
    known |= dict(zip(entry["timed"], by_time, strict=False))
    for part in (name, "along"):
        known |= _stated(part, known, constants)
    columns = _stated("columns", known, constants)
    for one, i in letters:
        known[f"excess{i + 1}"] = columns[f"excess_{one}"]
        for of in ("Omega", "c"):
            for other, j in letters:
                known[f"Omega{i + 1}_by_{of}{j + 1}"] = columns[f"Omega_{one}_by_{of}_{other}"]
    known |= _stated("turn", known, constants)
    # A unit of rates over one of moments may leave binary64 where no rate by a moment does.
    half = np.ldexp(1.0, (_power(scale) - _power(moment_unit)) // 2)
    factors = {
        ("eta", "omega0"): (None, 1 / scale),
        ("eta", "inertia"): (None, 1 / moment_unit),
        ("Omega", "omega0"): (None, 1.0),
        ("Omega", "inertia"): (half, scale / half / moment_unit),
    }
    lost = False
    for changed, found in (("eta", rows[2]), ("Omega", rows[3])):
        block = found[place]
        for given, of in (("omega0", "Omega"), ("inertia", "c")):
            if given in first_of:
                before, after = factors[changed, given]
                for i in range(3):
                    for j in range(3):
                        value = known[f"{changed}{i + 1}_by_{of}{j + 1}"]
                        value = value if before is None else value * before
                        np.multiply(value, after, out=block[..., i, first_of[given] + j])
        if changed == "eta" and "attitude0" in first_of:
            for k in range(3):
                block[..., k, k] = 1.0
        lost |= bool(np.isnan(np.min(block, initial=0.0)))
        # Of several bodies it is a copy.
        if isinstance(place[0], np.ndarray):
            found[place] = block
    for i in range(rows[4].shape[-1]):
        rows[4][(*place, ..., i)] = unit * known[f"eta{i + 1}_by_t"]
        rows[5][(*place, ..., i)] = unit * (unit * known[f"Omega{i + 1}_by_t"])
    return lost


def _stated(part, known, constants):
    """Call a function of the elapsed time and return its results by name."""
    entry = SENSITIVITY[part]
    given = (*(known[n] for n in entry["timed"]), *(constants[part][n] for n in entry["shape"]))
    return dict(zip(entry["results"], entry["state"](*given), strict=True))


def _at_rest(prepared, t, rows, first_of, at_once):
    """Write the sensitivities of bodies at rest, whose rates and attitude change with omega0."""
    for body in np.flatnonzero(prepared["unit"] == 0):
        w, x, y, z = prepared["q0"][body]
        start = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        for found, rest in zip(rows[2:], (*at_once, 0.0, 0.0), strict=True):
            found[body] = rest
        if (k := first_of.get("omega0")) is not None:
            times = t[body if len(t) > 1 else 0, :, None, None]
            rows[2][body, :, :, k : k + 3] = times * np.array(start)


def _check_held(rows, errors):
    """Refuse times at which squares of derivatives overflow binary64, or write NaN there."""
    lost = np.any([np.any(np.isnan(x), axis=tuple(range(2, x.ndim))) for x in rows], axis=0)
    if not np.any(lost):
        return
    if errors == "raise":
        body, time = np.argwhere(lost)[0]
        raise _RefusedError(*RULES[GROWTH], int(body), int(time))
    for found in rows[2:]:
        found[lost] = np.nan
