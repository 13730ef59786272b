"""The C engine agrees with NumPy and `precise`, and refuses the same input."""

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym._engines import EngineError, build, threads
from rigidsym._engines.build import CompilerError
from rigidsym._engines.c_engine import CEngine
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym.validate import strata

NUMPY = NumpyEngine()
TIMES = np.array([0.0, 1e-3, 0.1, -2.5, 17.0, 180.0, -1234.5, 9e4])
IDENTITY = (1.0, 0.0, 0.0, 0.0)
ZEROS = (Fraction(0),) * 3
TILTED = (0.5, -1.0, 2.0, 0.25)
BODIES = {
    "smallest": ((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02), IDENTITY),
    "largest": ((1.0, 2.0, 2.5), (0.3, -0.2, 0.9), TILTED),
    "permuted": ((2.5, 1.0, 2.0), (-0.9, 0.3, 0.2), TILTED),
    "near separatrix": ((1.0, 2.0, 3.0), (1.0, 1e-3, 0.57735026), TILTED),
    "on separatrix": ((3.0, 4.0, 6.0), (2.0, 1.0, 1.0), TILTED),
    "oblate": ((1.0, 1.0, 1.7), (0.2, 0.4, 3.0), TILTED),
    "prolate": ((2.0, 1.1, 2.0), (0.2, 0.4, -3.0), TILTED),
    "sphere": ((2.0, 2.0, 2.0), (0.1, 0.2, -0.3), TILTED),
    "principal": ((1.0, 2.0, 2.5), (0.0, 0.7, 0.0), TILTED),
    "rest": ((1.0, 2.0, 2.5), (0.0, 0.0, 0.0), TILTED),
}


@pytest.fixture(scope="session")
def c():
    """Return the engine in C, whose library may be in the user's cache."""
    remarks = []
    try:
        found = build.library(remarks)
    except CompilerError as error:
        pytest.skip(f"needs a compiler: {error}")
    assert not remarks
    return CEngine(found)


@pytest.fixture
def many_threads(monkeypatch):
    monkeypatch.setattr(threads, "PIECE", 64)
    monkeypatch.setattr(threads, "processors", lambda: 3)


def assert_near(states, expected, omega0, times_bound=1):
    """Compare states; errors of quaternions are half those of rotation angles."""
    size = float(np.max(np.abs(omega0))) or 1.0
    for got, wanted, bound in zip(states, expected, (1e-15, 2e-15 * size), strict=True):
        assert np.all(np.abs(got - np.array(wanted, float)) <= times_bound * bound)


@pytest.mark.parametrize("body", BODIES)
def test_states_agree_with_numpy_and_precise(c, body):
    given = BODIES[body]
    states = c.states(c.prepare(*given), TIMES)
    assert_near(states, NUMPY.states(NUMPY.prepare(*given), TIMES), given[1], 2)
    assert_near(states, TorqueFreeMotion(*given).precise(TIMES.tolist(), 20), given[1])


@pytest.mark.parametrize(
    ("inertia", "omega0"),
    [
        (("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")),
        (("1", "2", "3"), ("0.9999999999999999999999", "1/7", "0")),
        # A hair from the separatrix, on either side, and on it: 1/3 is no double.
        (("3", "4", "6"), ("2/3", "1/7", "1/3")),
        (("3", "4", "6"), ("2/3", "1/7", "0.33333333333333333333333333333333")),
        (("3", "4", "6"), ("2/3", "1/7", "0.33333333333333333333333333333334")),
        # No two moments are equal, but their doubles are.
        (("1/3", "0.33333333333333333333333", "0.4"), ("1", "0.2", "0.1")),
        (("1", "2", "2.5"), ("0", "0", "0")),
    ],
)
def test_exact_numbers_are_not_rounded_first(c, inertia, omega0):
    inertia, omega0 = (tuple(map(Fraction, values)) for values in (inertia, omega0))
    attitude0 = tuple(map(Fraction, ("1/3", "0.1", "-2", "0")))
    t = TIMES[:6]
    prepared = c.prepare_exactly(inertia, omega0, attitude0)
    expected = TorqueFreeMotion(inertia, omega0, attitude0).precise(t.tolist(), 20)
    assert_near(c.states(prepared, t), expected, [float(x) for x in omega0])


@pytest.mark.parametrize(
    "inertia",
    [
        ("1e-25", "1", "1.00000000000000000000000007"),
        ("1e-10", "1", "1.00000000003"),
        # The sums of two doubles next to the larger two are the same.
        ("0.9", "1/3", "0.3333333333333333333333333333333333333333"),
    ],
)
def test_differences_of_moments_are_not_lost_however_late(request, engine, inertia):
    run = NUMPY if engine == "numpy" else request.getfixturevalue("c")
    exact = tuple(tuple(map(Fraction, x)) for x in (inertia, ("1", "0.3", "0.2"), IDENTITY))
    t = np.array([5e3, -1e6, 2.0**45])
    expected = TorqueFreeMotion(*exact, allow_nonphysical=True).precise(t.tolist(), 20)
    assert_near(run.states(run.prepare_exactly(*exact), t), expected, [1.0])


@pytest.mark.parametrize("body", BODIES)
def test_states_do_not_depend_on_company(c, body, many_threads):
    prepared = c.prepare(*BODIES[body])
    t = np.linspace(-50, 70, 1001)
    q, omega = c.states(prepared, t)
    for k in (0, 1, 191, 192, 500, 1000):
        one_q, one_omega = c.states(prepared, float(t[k]))
        assert np.array_equal(q[k], one_q)
        assert np.array_equal(omega[k], one_omega)


def test_threads_share_a_prepared_motion(c):
    prepared = c.prepare(*BODIES["near separatrix"])
    t = np.linspace(0, 50, 5000)
    expected = c.states(prepared, t)
    with ThreadPoolExecutor(8) as pool:
        for states in pool.map(lambda _: c.states(prepared, t), range(64)):
            assert all(map(np.array_equal, states, expected))


@pytest.mark.parametrize("n", [0, 1, 7, 8, 63, 64, 65, 191, 192, 193, 1000])
def test_nothing_is_written_beside_the_rows(c, n):
    prepared, t = c.prepare(*BODIES["smallest"]), np.linspace(0, 9, n)
    q, omega = np.full((n + 2, 4), 7.0), np.full((n + 2, 3), 7.0)
    out = q[1:-1], omega[1:-1]
    for call in (
        lambda: c.states(prepared, t, out),
        lambda: c.grid(prepared, 0.0, 0.1, n, out),
        lambda: c.propagate(*BODIES["smallest"], t, out),
    ):
        call()
        for rows in (q, omega):
            assert np.all(rows[[0, -1]] == 7)
            assert np.all(rows[1:-1] != 7)


@pytest.mark.parametrize(
    ("t", "shape"),
    [(1, ()), (1.0, ()), (np.float64(2), ()), (np.float32(2), ()), (np.array(3.0), ()), ([], (0,)),
     ([1], (1,)), (range(5), (5,)), (np.arange(9.0)[::-2], (5,)), (np.arange(4, dtype=">f8"), (4,)),
     (np.frombuffer(bytes(33), np.uint8)[1:].view(float), (4,))],
)  # fmt: skip
def test_times_of_all_kinds(c, t, shape):
    given = BODIES["largest"]
    q, omega = c.states(c.prepare(*given), t)
    assert (q.shape, omega.shape) == ((*shape, 4), (*shape, 3))
    expected, _ = NUMPY.states(NUMPY.prepare(*given), np.array(t, float))
    np.testing.assert_allclose(q, expected, rtol=0, atol=1e-13)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("count", [0, 1, 63, 64, 1000])
def test_grids_are_states_at_their_times(c, body, count):
    given = BODIES[body]
    prepared = c.prepare(*given)
    t = -3.0 + 0.25 * np.arange(count)
    assert_near(c.grid(prepared, -3.0, 0.25, count), c.states(prepared, t), given[1], 2)


def test_many_bodies_have_the_bits_of_each_alone(c):
    """Draw bodies of every stratum, in an order that mixes all branches."""
    drawn = [sample for sample in strata.samples(12, 11) if sample.in_doubles]
    order = np.random.default_rng(0).permutation(len(drawn))
    given = [
        np.array([getattr(drawn[k], name) for k in order], float)
        for name in ("inertia", "omega0", "attitude0")
    ]
    t = np.array([drawn[k].times[-1] for k in order], float)[:, None]
    q, omega = c.propagate(*given, t, errors="nan")
    for k in range(len(t)):
        try:
            alone = c.states(c.prepare(*(x[k] for x in given)), t[k])
        except EngineError:
            assert np.isnan((*q[k, 0], *omega[k, 0])).all()
            continue
        np.testing.assert_array_equal((*q[k, 0], *omega[k, 0]), (*alone[0][0], *alone[1][0]))
    assert np.isfinite(q).all(axis=(1, 2)).mean() > 0.9


@pytest.mark.parametrize("body", BODIES)
def test_grids_have_the_same_bits_whatever_the_threads(c, body, monkeypatch):
    prepared = c.prepare(*BODIES[body])
    alone = c.grid(prepared, -3.0, 0.25, 5000)
    monkeypatch.setattr(threads, "PIECE", 64)
    monkeypatch.setattr(threads, "processors", lambda: 3)
    assert all(map(np.array_equal, c.grid(prepared, -3.0, 0.25, 5000), alone))


def batch(shape):
    draw = np.random.default_rng(7)
    inertia = draw.uniform(1, 1.9, (*shape, 3))
    return inertia, draw.normal(size=(*shape, 3)), draw.normal(size=(*shape, 4))


@pytest.mark.parametrize("t", [0.5, np.linspace(-9, 9, 33), []], ids=["one", "many", "none"])
@pytest.mark.parametrize("shape", [(), (1,), (2,), (7,), (3, 5), (0,), (2, 0)], ids=str)
def test_batches_are_bodies_one_by_one(c, shape, t, many_threads):
    inertia, omega0, attitude0 = batch(shape)
    q, omega = c.propagate(inertia, omega0, attitude0, t)
    assert q.shape == (*shape, *np.shape(t), 4)
    assert omega.shape == (*shape, *np.shape(t), 3)
    for k in np.ndindex(shape):
        one_q, one_omega = c.states(c.prepare(inertia[k], omega0[k], attitude0[k]), t)
        assert np.array_equal(q[k], one_q)
        assert np.array_equal(omega[k], one_omega)


def test_leading_shapes_broadcast_as_numpy_has_it(c):
    inertia, _, _ = batch((4, 1))
    _, omega0, _ = batch((5,))
    t = np.linspace(0, 3, 10)
    states = c.propagate(inertia, omega0, TILTED, t)
    expected = NUMPY.propagate(inertia, omega0, TILTED, t)
    for got, wanted in zip(states, expected, strict=True):
        assert got.shape == wanted.shape
        np.testing.assert_allclose(got, wanted, rtol=0, atol=1e-13)


def test_given_arrays_are_filled_and_returned(c, engine):
    engine = c if engine == "c" else NUMPY
    given, t = BODIES["smallest"], np.linspace(0, 9, 10)
    prepared = engine.prepare(*given)
    calls = {
        (10,): lambda out: engine.states(prepared, t, out),
        (): lambda out: engine.states(prepared, 0.25, out),
        (12,): lambda out: engine.grid(prepared, 0.0, 0.5, 12, out),
        (2, 10): lambda out: engine.propagate([given[0]] * 2, *given[1:], t, out),
    }
    for shape, call in calls.items():
        out = np.full((*shape, 4), np.nan), np.full((*shape, 3), np.nan)
        q, omega = call(out)
        assert q is out[0]
        assert omega is out[1]
        for got, wanted in zip(out, call(None), strict=True):
            assert np.array_equal(got, wanted)


def frozen(shape):
    array = np.empty(shape)
    array.flags.writeable = False
    return array


SINGLE = np.zeros((5, 4), "f4")
Q, OMEGA, SHARED = np.empty((5, 4)), np.empty((5, 3)), np.empty(35)


@pytest.mark.parametrize(
    ("out", "rule"),
    [
        ((np.empty((4, 5)), OMEGA),
         "q is float64 of shape (4, 5): must be float64 of shape (5, 4)"),
        ((Q, np.empty(3)), "omega is float64 of shape (3,): must be float64 of shape (5, 3)"),
        ((SINGLE, OMEGA), "q is float32 of shape (5, 4): must be float64 of shape (5, 4)"),
        ((Q.astype(">f8"), OMEGA), "q is >f8 of shape (5, 4): must be float64 of shape (5, 4)"),
        ((Q, np.empty((3, 5)).T), "omega must be C-contiguous, aligned and writeable"),
        ((frozen((5, 4)), OMEGA), "q must be C-contiguous, aligned and writeable"),
        ((Q.tolist(), OMEGA), "q is a list: must be an array"),
        (Q, "must be a pair of arrays (q, omega)"),
        ((Q,), "must be a pair of arrays (q, omega)"),
        ((SHARED[:20].reshape(5, 4), SHARED[10:25].reshape(5, 3)),
         "q and omega must not overlap each other or the inputs"),
    ],
)  # fmt: skip
def test_arrays_that_cannot_be_filled(c, engine, out, rule):
    engine = c if engine == "c" else NUMPY
    prepared = engine.prepare(*BODIES["smallest"])
    with pytest.raises(InputError) as caught:
        engine.states(prepared, np.arange(5.0), out)
    assert str(caught.value) == f"out = as given: {rule}"


def test_times_are_not_overwritten_while_they_are_read(c):
    q, omega = np.zeros((5, 4)), np.zeros((5, 3))
    with pytest.raises(InputError, match=r"^out = as given: q and omega must not overlap"):
        c.states(c.prepare(*BODIES["smallest"]), q.reshape(-1)[:5], (q, omega))


GOOD = {"inertia": (1.0, 2.0, 2.5), "omega0": (1.0, 2.0, 3.0), "attitude0": IDENTITY}
REFUSED = [
    {"inertia": (1.0, -2.0, 2.5)},
    {"inertia": (0.0, 2.0, 2.5)},
    {"inertia": (1.0, 1e-100, 1.0)},
    {"inertia": (1.0, np.nan, 1.0)},
    {"omega0": (1.0, np.inf, 1.0)},
    {"attitude0": (0.0, 0.0, np.nan, 0.0)},
    {"attitude0": (0.0, 0.0, 0.0, 0.0)},
    {"inertia": (1.0, 2.0, 3.0), "omega0": (1e300, 1e300, 1e299)},
]


def said(call, kind):
    """Return the error that a call raises."""
    with pytest.raises(kind, match=": ") as caught:
        call()
    return caught.value


@pytest.mark.parametrize("change", REFUSED)
def test_bodies_are_refused_in_the_words_of_the_numpy_module(c, change):
    given = (GOOD | change).values()
    expected = said(lambda: NUMPY.prepare(*given), ValueError)
    assert str(said(lambda: c.prepare(*given), EngineError)) == str(expected)


@pytest.mark.parametrize("change", REFUSED)
@pytest.mark.parametrize("bodies", [3, 8])
def test_the_first_body_that_is_refused_is_named(c, change, bodies, many_threads):
    rows = [GOOD | (change if k >= bodies - 2 else {}) for k in range(bodies)]
    given = [np.array([row[name] for row in rows]) for name in GOOD]
    expected = said(lambda: NUMPY.propagate(*given, TIMES), ValueError)
    found = said(lambda: c.propagate(*given, TIMES), EngineError)
    assert str(found) == str(expected)
    assert found.body == expected.body == bodies - 2


@pytest.mark.parametrize(
    "change",
    [
        {"inertia": 1.0},
        {"omega0": np.ones((5, 4))},
        {"attitude0": np.ones(3)},
        {"omega0": np.ones((5, 3)), "inertia": np.ones((4, 3))},
    ],
)
def test_shapes_are_refused_in_the_words_of_the_numpy_module(c, change):
    given = (GOOD | change).values()
    expected = said(lambda: NUMPY.propagate(*given, 1.0), ValueError)
    assert str(said(lambda: c.propagate(*given, 1.0), InputError)) == str(expected)


def test_a_plan_is_of_one_body(c):
    with pytest.raises(EngineError, match=r"^omega0: shape \(2, 3\): one body's must be \(3,\)$"):
        c.prepare(GOOD["inertia"], np.ones((2, 3)), IDENTITY)


@pytest.mark.parametrize("t", [np.nan, -np.inf, [0.0, np.nan], np.zeros((2, 2))], ids=str)
def test_times_are_refused_in_the_words_of_the_numpy_module(c, t):
    expected = said(lambda: NUMPY.states(NUMPY.prepare(*GOOD.values()), t), ValueError)
    assert str(expected).startswith("t: ")
    found = said(lambda: c.states(c.prepare(*GOOD.values()), t), EngineError)
    assert str(found) == str(expected)
    if np.ndim(t) < 2:
        found = said(lambda: c.propagate(*GOOD.values(), t), EngineError)
        assert str(found) == str(expected)


@pytest.mark.parametrize("t", [1e14, np.float64(-1e14), [0.0, 1e300]], ids=str)
def test_times_too_far_away_are_refused(c, t):
    prepared = c.prepare(*GOOD.values())
    for call in (
        lambda: c.states(prepared, t),
        lambda: c.grid(prepared, 0.0, float(np.max(np.abs(t))), 2),
    ):
        with pytest.raises(EngineError, match=r"^t: beyond \|omega\| t = 2\^46 rad"):
            call()


def test_an_endless_grid_is_refused(c):
    prepared = c.prepare(*GOOD.values())
    for start, step in ((np.nan, 1.0), (0.0, np.inf)):
        with pytest.raises(EngineError, match=r"^t: times must be"):
            c.grid(prepared, start, step, 5)
