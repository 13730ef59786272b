"""What the C modules refuse: by the rules of Python, in its words, and what was never prepared."""

import ctypes
import math
import random
from fractions import Fraction
from itertools import permutations

import numpy as np
import pytest
from compilers import PLAIN, either

from rigidsym import InputError, TorqueFreeMotion, generate, step
from rigidsym import _inputs as inputs
from rigidsym._codegen import forms
from rigidsym._engines import exact_inputs
from rigidsym._engines.compiler import ANY_MOMENTS
from rigidsym._engines.library import load

RATES, ATTITUDE, NAN, INF = (0.3, 0.5, -0.7), (1.0, 0, 0, 0), math.nan, math.inf
ROOM = 8192
U = 2.0**-52


@pytest.fixture(scope="module", params=["theta", "pi", "step"])
def module(request, here):
    return built(request.param, here)


@pytest.fixture(scope="module")
def steps(here):
    return built("step", here)


@pytest.fixture(scope="module")
def motions(here):
    return built("theta", here)


def built(form, here, *flags):
    files = generate("c", form=form).files
    source = next(name for name in files if name.endswith(".c"))
    return load(either().linked(here, *PLAIN, *flags, sources=(source,), end=".so"), files)


def array(values):
    return np.array(values, float)


def prepared(library, inertia, omega0=RATES, attitude0=ATTITUDE):
    """The code for a body, and what was prepared."""
    room = ctypes.create_string_buffer(ROOM)
    if "body_init" in library.signatures:
        return library.body_init(room, array(inertia)), room
    return library.motion_init(room, array(inertia), array(omega0), array(attitude0)), room


def drawn():
    """Moments about the edge of what can exist, of all sizes."""
    draw = random.Random(5)
    for _ in range(4000):
        low, middle = (
            draw.choice((1.0, draw.uniform(0.1, 3), 2.0 ** -draw.randint(0, 60))) for _ in "ab"
        )
        size = 2.0 ** draw.choice((0, 3, -300, 900))
        total = low + middle
        high = draw.choice(
            (
                total,
                math.nextafter(total, INF),
                math.nextafter(total, 0),
                total + draw.randint(-6, 6) * 2.0**-52 * min(low, middle),
                total + 2.0**-50 * min(low, middle),
                total * draw.uniform(0.9, 1.1),
            )
        )
        yield tuple(size * x for x in draw.choice([*permutations((low, middle, high))]))


def test_bodies_are_those_that_exist_in_python(module):
    counts = {True: 0, False: 0}
    for moments in drawn():
        *others, largest = sorted(map(Fraction, moments))
        exists = inputs.can_exist(largest, *others)
        code = prepared(module, moments)[0]
        assert code == (0 if exists else module.raw.NONPHYSICAL), moments
        counts[exists] += 1
    assert min(counts.values()) > 500


@pytest.mark.parametrize(
    "moments", [("0.1", "0.2", "0.3"), ("0.3", "0.1", "0.2"), ("1/3", "1", "4/3")]
)
@pytest.mark.parametrize("more", ["0", "1e-17", "1e-15", "-1e-20"])
def test_exact_bodies_too(motions, moments, more):
    exact = [Fraction(x) for x in moments]
    exact[exact.index(max(exact))] += Fraction(more)
    *others, largest = sorted(exact)
    given = exact_inputs.exact_inputs(
        exact, [Fraction(x) for x in RATES], [Fraction(1), *[Fraction(0)] * 3]
    )
    room, pairs = ctypes.create_string_buffer(ROOM), [array(x) for x in given[:5]]
    code = motions.motion_init_double_doubles(room, *pairs, given.unit)
    assert code == (0 if inputs.can_exist(largest, *others) else motions.raw.NONPHYSICAL)


@pytest.mark.parametrize("form", forms.FORMS)
def test_a_build_may_allow_any_moments(form, here):
    library = built(form, here, ANY_MOMENTS)
    assert prepared(library, (1, 2, 5))[0] == 0


def test_python_reaches_c_with_any_moments():
    motion = TorqueFreeMotion((1, 2, 5), RATES, allow_nonphysical=True, engine="c")
    other = TorqueFreeMotion((1, 2, 5), RATES, allow_nonphysical=True)
    np.testing.assert_allclose(motion([1.0, 2.0])[0], other([1.0, 2.0])[0], atol=1e-14)
    found = [
        step((1, 2, 5), ATTITUDE, RATES, 0.5, engine=engine, allow_nonphysical=True)[0]
        for engine in ("numpy", "c")
    ]
    np.testing.assert_allclose(*found, atol=1e-14)


def words(call):
    with pytest.raises(InputError) as caught:
        call()
    return str(caught.value)


@pytest.mark.parametrize(
    "moments",
    [(1, 2, 5), (1, -2, 2), (1, 0, 1), (1e-80, 1, 1), (1, NAN, 1), (INF, 1, 1), (1, 1e-100, 2)],
)
def test_moments_are_refused_in_the_words_of_python(module, moments):
    said = words(lambda: TorqueFreeMotion(moments, RATES)(1.0))
    code, room = prepared(module, moments)
    rule = module.rule(code).decode().partition(" (")[0]
    assert rule.removeprefix("every number ") in said
    assert room.raw == bytes(ROOM), "a refused call writes nothing"


def test_every_code_has_words_of_its_own(module):
    names = {name: value for name, value in vars(module.raw).items() if name.isupper()}
    codes = sorted(value for name, value in names.items() if not name.startswith("BY_"))
    assert codes == [*range(len(codes))]
    said = [module.message(code).decode() for code in codes]
    assert len({*said}) == len(codes)
    assert module.message(len(codes)) == module.message(-1) == b"no such code"
    for code, message in zip(codes, said, strict=True):
        field, rule = module.field(code).decode(), module.rule(code).decode()
        assert message == (f"{field}: {rule}" if field else rule)


@pytest.mark.parametrize("garbage", [b"\0", b"\x01", b"\xff", b"\x7f"])
def test_a_motion_that_was_not_prepared_has_no_states(motions, garbage):
    room = ctypes.create_string_buffer(garbage * ROOM, ROOM)
    t, q, omega = array([1.0]), np.full((1, 4), 7.0), np.full((1, 3), 7.0)
    wide, narrow = np.full((1, 3, 9), 7.0), np.full((1, 3), 7.0)
    found = (q, omega, wide, wide.copy(), narrow, narrow.copy())
    codes = [
        motions.state_at(room, 1.0, q, omega),
        motions.states_at(room, 1, t, q, omega),
        motions.states_on_grid(room, 0.0, 1.0, 0, 1, q, omega),
        motions.states_with_sensitivity(room, 1, t, *found),
        motions.states_with_columns(room, 1, t, motions.raw.BY_ALL, *found),
    ]
    assert codes == [motions.raw.UNPREPARED] * 5
    assert math.isnan(motions.last_time(room))
    assert all((x == 7.0).all() for x in found), "a refused call writes nothing"
    assert b"torque_free_motion_init" in motions.message(codes[0])


@pytest.mark.parametrize("t", [NAN, INF, -INF])
@pytest.mark.parametrize("omega0", [RATES, (0, 0, 0), (0, 1, 1e-130)])
def test_times_that_are_none_are_not_called_late(motions, t, omega0):
    code, room = prepared(motions, (1, 2, 2.5), omega0)
    assert code == 0
    q, omega, failed = np.empty((2, 4)), np.empty((2, 3)), ctypes.c_size_t()
    codes = np.empty(1, np.intc)
    given = array([(1, 2, 2.5)]), array([omega0]), array([ATTITUDE])
    assert motions.propagate(1, *given, 2, array([1e300, t]), 0, q, omega, codes, failed) == 0
    found = [
        motions.state_at(room, t, q, omega),
        motions.states_at(room, 2, array([1e300, t]), q, omega),
        motions.states_on_grid(room, t, 1.0, 0, 2, q, omega),
        motions.states_on_grid(room, 1.0, t, 0, 2, q, omega),
        motions.propagate(1, *given, 2, array([1e300, t]), 0, q, omega, None, failed),
        codes[0],
    ]
    assert found == [motions.raw.NOT_FINITE] * 6
    assert motions.message(found[0]) == b"every number must be finite"


@pytest.mark.parametrize(
    ("name", "q", "omega", "dt"),
    [
        ("NOT_FINITE", ATTITUDE, RATES, NAN),
        ("NOT_FINITE", ATTITUDE, RATES, -INF),
        ("NOT_FINITE", (1, 0, NAN, 0), RATES, 1),
        ("NOT_FINITE", ATTITUDE, (0, INF, 0), 1),
        ("ATTITUDE", (0, -0.0, 0, 0), RATES, 1),
        ("ANGLE", ATTITUDE, RATES, 1e3),
        ("ANGLE", ATTITUDE, (1e308, 1e308, 0), 1e308),
    ],
)
def test_steps_that_are_refused(steps, name, q, omega, dt):
    code, body = prepared(steps, (1, 2, 2.5))
    before, rates = array(q), array(omega)
    assert code == 0
    assert steps.step(body, before, rates, dt) == getattr(steps.raw, name)
    np.testing.assert_array_equal(before, array(q))
    after, failed = (np.empty((1, 4)), np.empty((1, 3))), ctypes.c_size_t()
    given = array((1, 2, 2.5)), 0, before, rates, array([dt]), 0
    assert steps.steps(1, *given, *after, failed) == getattr(steps.raw, name)


@pytest.mark.parametrize("stride", [0, 3])
def test_many_steps_ask_for_bodies_that_exist(steps, stride):
    inertia = array([(1, 2, 2.5), (1, 2, 5)]) if stride else array((1, 2, 5))
    q, omega, failed = array([ATTITUDE] * 2), array([RATES] * 2), ctypes.c_size_t()
    code = steps.steps(2, inertia, stride, q, omega, array([0.1]), 0, q, omega, failed)
    assert (code, failed.value) == (steps.raw.NONPHYSICAL, 1 if stride else 0)


@pytest.mark.parametrize("garbage", [b"\0", b"\x01", b"\xff"])
def test_a_body_that_was_not_prepared_makes_no_step(steps, garbage):
    room = ctypes.create_string_buffer(garbage * ROOM, ROOM)
    q, omega = array(ATTITUDE), array(RATES)
    assert steps.step(room, q, omega, 0.1) == steps.raw.UNPREPARED
    np.testing.assert_array_equal(q, ATTITUDE)
