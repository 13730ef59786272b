"""`rigidsym.step`: from any state, in place, alone as in a batch, and refused by name."""

import math
import warnings
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from benchmarks.drift import drifts

import rigidsym
from rigidsym import InputError, TorqueFreeMotion, steps
from rigidsym._engines import threads
from rigidsym.generated import torque_free
from rigidsym.validate.strata import STRATA, draw

BODY, RATES = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
START = (1.0, 0.0, 0.0, 0.0)


def bodies(count, seed=0):
    draw = np.random.default_rng(seed)
    x, y, z = draw.uniform(0.05, 1, (3, count))
    omega, q = draw.normal(size=(count, 3)), draw.normal(size=(count, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    return np.stack([y + z, z + x, x + y], -1), q, omega


def test_steps_of_both_engines_agree_and_so_do_motions():
    inertia, q, omega = bodies(200)
    dt = np.linspace(-2, 2, 200)
    ours = rigidsym.step(inertia, q, omega, dt)
    for found, expected in zip(ours, rigidsym.step(inertia, q, omega, dt, engine="c"), strict=True):
        np.testing.assert_allclose(found, expected, rtol=0, atol=5e-15)
    for k in (0, 77, 199):
        motion = TorqueFreeMotion(inertia[k], omega[k], q[k])
        np.testing.assert_allclose(ours[0][k], motion(dt[k])[0], rtol=0, atol=5e-15)
        np.testing.assert_allclose(ours[1][k], motion(dt[k])[1], rtol=0, atol=1e-14)


def test_leading_shapes_broadcast(engine):
    inertia, q, omega = bodies(5)
    dt = np.array([[0.5], [-1.0], [0.0]])
    after = rigidsym.step(inertia, q, omega, dt, engine=engine)
    assert [x.shape for x in after] == [(3, 5, 4), (3, 5, 3)]
    for place in ((0, 4), (1, 0), (2, 2)):
        k = place[1]
        alone = rigidsym.step(inertia[k], q[k], omega[k], dt[place[0], 0], engine=engine)
        for x, y in zip(after, alone, strict=True):
            np.testing.assert_array_equal(x[place], y)
    one = rigidsym.step(BODY, q, omega, 0.5, engine=engine)
    assert one[0].shape == (5, 4)
    assert rigidsym.step(BODY, np.empty((0, 4)), RATES, 0.5, engine=engine)[1].shape == (0, 3)


def test_a_body_has_the_same_bits_wherever_it_stands(monkeypatch):
    inertia, q, omega = bodies(40_000)
    whole = rigidsym.step(inertia, q, omega, 0.3, engine="c")
    for some in (slice(7, 8), slice(101, 250), slice(39_990, 40_000)):
        part = rigidsym.step(inertia[some], q[some], omega[some], 0.3, engine="c")
        assert all(np.array_equal(x[some], y) for x, y in zip(whole, part, strict=True))
    monkeypatch.setattr(threads, "processors", lambda: 3)
    again = rigidsym.step(inertia, q, omega, 0.3, engine="c")
    assert all(map(np.array_equal, whole, again))


def test_a_step_in_place(engine):
    inertia, q, omega = bodies(50)
    expected = rigidsym.step(inertia, q, omega, 0.4, engine=engine)
    found = rigidsym.step(inertia, q, omega, 0.4, engine=engine, out=(q, omega))
    assert found[0] is q
    assert found[1] is omega
    assert all(map(np.array_equal, found, expected))
    shared = np.zeros(400)
    out = shared[:200].reshape(50, 4), shared[199:349].reshape(50, 3)
    with pytest.raises(InputError, match=r"^out = as given: q and omega must not overlap"):
        rigidsym.step(inertia, q, omega, 0.4, engine=engine, out=out)


def test_what_does_not_turn_stays_as_it_is(engine):
    q = np.array([[0.5, 0.5, -0.5, 0.5]] * 3)
    omega = np.array([(0.0, 0.0, 0.0), RATES, (0.0, -0.0, 0.0)])
    after = rigidsym.step(BODY, q, omega, [3.0, 0.0, 1e300], engine=engine)
    np.testing.assert_array_equal(after[0], q)
    np.testing.assert_array_equal(after[1], omega)


@pytest.mark.parametrize("scale", [1e-250, 1e-80, 1e80, 1e250])
def test_units_do_not_matter(engine, scale):
    inertia, q, omega = bodies(30)
    powers = 2.0 ** round(math.log2(scale))
    expected = rigidsym.step(inertia, q, omega, 0.5, engine=engine)
    found = rigidsym.step(inertia * powers, q / powers, omega * powers, 0.5 / powers, engine=engine)
    np.testing.assert_array_equal(found[0], expected[0])
    np.testing.assert_array_equal(found[1] / powers, expected[1])


@pytest.mark.parametrize("steps", [2000, pytest.param(10**6, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", ["uniform", "separatrix", "near sphere", "rod", "flat"])
def test_energy_and_momentum_drift_no_faster_than_a_random_walk(kind, steps):
    """Near a sphere rates change by an ulp per step, which once was rounded one way."""
    for drift in drifts(steps, bodies=16, kinds=(kind,)):
        assert drift.rms[steps] <= 3 * math.sqrt(steps)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"inertia": (1, -2, 2)}, r"^inertia\[1\] = -2.0: principal moments must be positive"),
        ({"inertia": (1, 1, 5)}, r"^inertia = .*larger than the sum"),
        ({"q": [START, (0, 0, 0, 0)]}, r"^q\[1\] = .*a zero quaternion is no attitude"),
        ({"omega": [RATES, (1, math.nan, 0)]}, r"^omega\[1, 1\] = nan: must be finite"),
        ({"dt": [0.1, math.inf]}, r"^dt\[1\] = inf: must be finite"),
        ({"dt": [0.1, 300.0]}, r"^dt\[1\] = 300.0: \|omega dt\| must be at most 8 rad"),
        ({"omega": [RATES, (0, 90, 0)]}, r"^dt = 0.1: \|omega dt\| .* 8 rad \(body 1\)"),
        ({"dt": [0.1, 0.2, 0.3]}, r"^dt = an array of shape \(3,\): leading shape \(3,\)"),
        ({"q": np.zeros((2, 3))}, r"^q = an array of shape \(2, 3\): the last axis"),
        ({"engine": "fortran"}, r"^engine = 'fortran': must be one of: auto, numpy, c"),
        ({"inertia": (1e-70, 1, 1)}, r"^inertia = .*differ by more than binary64"),
    ],
    ids=str,
)
def test_bad_input_is_one_line(engine, changes, message):
    given = {"inertia": BODY, "q": [START] * 2, "omega": [RATES] * 2, "dt": 0.1, "engine": engine}
    with pytest.raises(InputError, match=message):
        rigidsym.step(**given | changes)


def drawn(seed, cases=4):
    """Return random inputs of a step for every stratum: moments, attitude, rates and time.

    The body rotates by less than one turn.
    """
    rows = []
    for stratum in STRATA:
        for index in range(cases):
            sample = draw(stratum, index, seed)
            body = [list(map(float, x)) for x in (sample.inertia, sample.attitude0, sample.omega0)]
            dt = (-1) ** index * index / (max(map(abs, body[2])) or 1.0)
            rows.append((*map(np.array, body), dt))
    return rows


def bits(state):
    """Return q and omega as bytes, which distinguish the signs of zeros."""
    return [x.tobytes() for x in state]


def outcome(*args, **options):
    """Return the arrays and warnings of a step, or the type and text of its error."""
    try:
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            found = rigidsym.step(*args, **options)
    except Exception as error:
        return type(error), str(error)
    assert all(type(x) is np.ndarray and x.flags.owndata for x in found)
    return [(x.dtype, x.shape, x.tobytes()) for x in found], [str(x.message) for x in heard]


def without_the_short_way(monkeypatch, *args, **options):
    with monkeypatch.context() as patch:
        patch.setattr(steps, "_one", lambda *_: None)
        return outcome(*args, **options)


def test_one_body_has_the_bits_that_it_has_in_a_batch(engine):
    rows = drawn(3)
    inertia, q, omega, dt = map(np.array, zip(*rows, strict=True))
    batch = rigidsym.step(inertia, q, omega, dt, engine=engine)
    for k, row in enumerate(rows):
        assert bits(rigidsym.step(*row, engine=engine)) == bits(x[k] for x in batch)


def test_most_bodies_go_the_short_way(engine):
    """Flat bodies and numbers whose sums overflow take the long way."""
    found = [steps._one(*row, engine, None) for row in drawn(3)]
    assert sum(x is not None for x in found) > 0.9 * len(found)
    assert steps._one(BODY, START, RATES, 300.0, engine, None) is None


KINDS = {
    "tuples": lambda x: x,
    "lists": list,
    "arrays": np.array,
    "float32": lambda x: np.array(x, "f4"),
    "another byte order": lambda x: np.array(x, ">f8"),
    "objects": lambda x: np.array(x, object),
    "strings": lambda x: [str(value) for value in x],
    "whole numbers": lambda x: [1 + k for k in range(len(x))],
    "bytes": lambda x: np.arange(1, 1 + len(x), dtype="i1"),
    "booleans": lambda x: [True] * len(x),
    "a column": lambda x: np.array(x)[:, None],
    "a row": lambda x: np.array([x]),
    "a stride": lambda x: np.repeat(x, 2)[::2],
    "scalars of NumPy": lambda x: [np.float64(value) for value in x],
    "masked": lambda x: np.ma.masked_equal(x, x[0]),
    "not masked": lambda x: np.ma.array(x),
    "a matrix": lambda x: np.array([x]).view(np.matrix),
    "complex": lambda x: np.array(x, complex),
    "one more": lambda x: (*x, 0.5),
    "one less": lambda x: x[1:],
    "one number": lambda x: x[0],
    "nothing": lambda x: None,
    "NaN": lambda x: (math.nan, *x[1:]),
    "infinite": lambda x: [*x[:-1], -math.inf],
    "both infinities": lambda x: [math.inf, -math.inf, *x[2:]],
    "zeros": lambda x: np.zeros(len(x)),
    "negative": lambda x: tuple(-value for value in x),
    "huge": lambda x: [1e308] * len(x),
    "tiny": lambda x: [5e-324] * len(x),
    "far apart": lambda x: (1e-200, *x[1:]),
    "too large a whole number": lambda x: (10**400, *x[1:]),
}
TIMES = {
    **{"a whole number": 1, "true": True, "of NumPy": np.float64(0.5), "zero": -0.0},
    **{"no dimension": np.array(0.5), "one of one": [0.5], "too far": 500.0, "NaN": math.nan},
    **{"text": "0.5", "nothing": None, "huge": 10**400, "infinite": -math.inf},
}


@pytest.mark.parametrize("kind", KINDS)
def test_inputs_of_every_kind_mean_what_they_meant(engine, kind, monkeypatch):
    for k in range(3):
        given = [np.array(x) for x in (BODY, START, RATES)]
        given[k] = KINDS[kind](given[k].tolist())
        for allowed in (False, True):
            options = {"engine": engine, "allow_nonphysical": allowed}
            expected = without_the_short_way(monkeypatch, *given, 0.5, **options)
            assert outcome(*given, 0.5, **options) == expected


@pytest.mark.parametrize("kind", TIMES)
def test_times_of_every_kind_mean_what_they_meant(engine, kind, monkeypatch):
    given = (BODY, START, RATES, TIMES[kind])
    expected = without_the_short_way(monkeypatch, *given, engine=engine)
    assert outcome(*given, engine=engine) == expected


def test_an_unknown_engine_is_refused_last(monkeypatch):
    for inertia in (BODY, (1, -2, 2)):
        given = (inertia, START, RATES, 0.5)
        expected = without_the_short_way(monkeypatch, *given, engine="fortran")
        assert outcome(*given, engine="fortran") == expected


def outputs():
    """Yield inputs of a step together with output arrays of every kind, each newly made."""
    inertia, q, omega = map(np.array, (BODY, START, RATES))
    state, whole = np.array([*START, *RATES]), np.zeros(20)
    read_only = np.zeros(3)
    read_only.flags.writeable = False
    yield (inertia, q, omega), (np.zeros(4), np.zeros(3))
    yield (inertia, q, omega), [np.zeros(4), np.zeros(3)]
    yield (inertia, q, omega), (q, omega)
    yield (inertia, q.tolist(), omega), (q, omega)
    yield (inertia, state[:4], state[4:]), (state[:4], state[4:])
    views = state[:4], state[4:]
    yield (inertia, *views), views
    yield (inertia, q, omega), (q, inertia)
    yield (omega, q, omega), (q, omega)
    yield (inertia, q, omega), (whole[:4], whole[4:7])
    yield (inertia, q, omega), (whole[:4], whole[3:6])
    yield (whole[10:13], q, omega), (whole[:4], whole[12:15])
    yield (inertia, q, omega), (whole[:8:2], np.zeros(3))
    yield (inertia, q, omega), (np.zeros(4, "f4"), np.zeros(3))
    yield (inertia, q, omega), (np.zeros(4), read_only)
    yield (inertia, q, omega), (np.zeros((1, 4)), np.zeros((1, 3)))
    yield (inertia, q, omega), (np.zeros(3), np.zeros(4))
    yield (inertia, q, omega), (np.zeros(4).tolist(), np.zeros(3))
    yield (inertia, q, omega), (np.zeros(4),)
    yield (inertia, q, omega), 5
    yield (inertia, q, omega), np.zeros((2, 4))
    yield (inertia, np.frombuffer(memoryview(q)), omega), (q, omega)


@pytest.mark.parametrize("number", range(len(list(outputs()))))
def test_outputs_of_every_kind_are_filled_or_refused_as_they_were(engine, number, monkeypatch):
    def stepped():
        given, out = list(outputs())[number]
        try:
            found = rigidsym.step(*given, 0.5, engine=engine, out=out)
        except Exception as error:
            return type(error), str(error)
        assert all(x is y for x, y in zip(found, out, strict=True))
        return bits(found)

    found = stepped()
    monkeypatch.setattr(steps, "_one", lambda *_: None)
    assert found == stepped()


def test_a_step_that_is_refused_leaves_its_arrays_as_they_were(engine):
    q, omega = np.array(START), np.array(RATES)
    with pytest.raises(rigidsym.InputError, match=r"^dt = 500.0: \|omega dt\| must be at most 8"):
        rigidsym.step(BODY, q, omega, 500.0, engine=engine, out=(q, omega))
    assert bits((q, omega)) == bits(map(np.array, (START, RATES)))


def test_nothing_is_kept_but_constants_of_bodies(engine):
    inertia, q, omega = map(np.array, (BODY, START, RATES))
    first = bits(rigidsym.step(inertia, q, omega, 0.5, engine=engine))
    inertia[:] = (1.0, 2.0, 2.5)
    other = rigidsym.step((1.0, 2.0, 2.5), q, omega, 0.5, engine=engine)
    assert bits(rigidsym.step(inertia, q, omega, 0.5, engine=engine)) == bits(other)
    for k in range(600):
        rigidsym.step((1.0, 2.0, 2.0 + k / 1000), q, omega, 0.5, engine=engine)
    assert bits(rigidsym.step(BODY, q, omega, 0.5, engine=engine)) == first
    # A body that cannot exist is one that was let pass by a caller before.
    rigidsym.step((1, 1, 5), q, omega, 0.5, engine=engine, allow_nonphysical=True)
    with pytest.raises(rigidsym.InputError, match="larger than the sum"):
        rigidsym.step((1.0, 1.0, 5.0), q, omega, 0.5, engine=engine)


def test_threads_have_their_own_states(engine):
    rows = drawn(5, cases=2)
    expected = [bits(rigidsym.step(*row, engine=engine)) for row in rows]

    def run(_):
        return [bits(rigidsym.step(*row, engine=engine)) for row in rows]

    with ThreadPoolExecutor(4) as pool:
        assert all(found == expected for found in pool.map(run, range(8)))


def numbers(prepared):
    """Return the numbers that sensitivities are made from."""
    *columns, discriminant = prepared["given"]
    return [*(x for each in columns for x in each), discriminant]


def test_a_prepared_motion_is_what_it_is_in_a_batch():
    rows = drawn(4)
    inertia, attitude0, omega0, _ = map(np.array, zip(*rows, strict=True))
    many = torque_free.prepare(inertia, omega0, attitude0)
    seen = set()
    for branch, bodies, constants in many["groups"]:
        for place, body in enumerate(bodies):
            one = torque_free.prepare(inertia[body], omega0[body], attitude0[body])
            ((name, _, own),) = one["groups"]
            assert name == branch
            assert [x[0] for x in own.values()] == [x[place] for x in constants.values()]
            for key in ("unit", "max_angle", "blurred", "axes", "q0", "omega0", "moment_unit"):
                np.testing.assert_array_equal(one[key][0], many[key][body])
            for x, y in zip(numbers(one), numbers(many), strict=True):
                assert (x.hi, x.lo) == (y.hi[body], y.lo[body])
            seen.add(branch)
    assert seen == {"steady", "circular", "hyperbolic"}
