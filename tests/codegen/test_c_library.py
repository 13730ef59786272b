"""Grids, blocks and double-doubles of the C modules, and their messages for bad input."""

import ctypes
import math
import random
from fractions import Fraction
from itertools import permutations

import numpy as np
import pytest
from compilers import (
    ATTITUDE,
    BUILDS,
    PLAIN,
    PORTABLE,
    RATES,
    ROOM,
    Library,
    either,
    needed,
    numbers,
)
from regimes import are_right

from rigidsym import InputError, TorqueFreeMotion, step
from rigidsym import _inputs as inputs
from rigidsym._codegen import forms
from rigidsym._engines import exact_inputs
from rigidsym._engines.build import ANY_MOMENTS

NAN, INF, MOST = math.nan, math.inf, 1.7e308
BODY = ((1.0, 2.0, 2.5), RATES, ATTITUDE)
# On the circular, the hyperbolic and the steady branch, for the body (1, 2, 2.25).
BRANCHES = (RATES, (0.75, 0.5, 1.0), (0, 1.0, 0))


@pytest.fixture(scope="module", params=forms.FORMS)
def any_form(request, here):
    return Library(either(), here, *PORTABLE, form=request.param)


@pytest.fixture(scope="module")
def motions(here):
    return Library(either(), here, *PORTABLE)


@pytest.fixture(scope="module")
def steps(here):
    return Library(either(), here, *PORTABLE, form=forms.STEP)


@pytest.fixture(scope="module", params=BUILDS)
def built(request, here):
    kind, machine, flags = BUILDS[request.param]
    return Library(needed(kind), here, *flags, *needed(kind).machine(machine))


@pytest.fixture(scope="module", params=[1, 8, 100])
def small(request, here):
    return Library(either(), here, *PLAIN, f"-DTORQUE_FREE_BLOCK={request.param}")


# --- blocks and grids


@pytest.mark.parametrize("omega0", BRANCHES)
def test_blocks_of_any_size_have_the_same_states(small, omega0, motions):
    _, prepared = motions.prepare((1, 2, 2.25), omega0)
    times = np.linspace(-7, 30, 250)
    found, grid = small.states(prepared, times)[1], small.grid(prepared, 1.0, 0.1, 250)[1]
    assert np.abs(found - motions.states(prepared, times)[1]).max() < 2e-15
    assert np.abs(grid - motions.grid(prepared, 1.0, 0.1, 250)[1]).max() < 2e-15


@pytest.mark.parametrize("omega0", BRANCHES)
def test_a_state_does_not_depend_on_its_place_in_a_block(omega0, motions):
    _, prepared = motions.prepare((1, 2, 2.25), omega0)
    times = np.linspace(-7, 30, 400)
    one_by_one = np.array([motions.states(prepared, [t])[1][0] for t in times])
    for n in (0, 1, 63, 64, 65, 191, 192, 193, 383, 384, 385):
        code, found = motions.states(prepared, times[:n])
        assert code == 0
        # In turns of a loop that the compiler made wide and those left over, sums may differ in
        # a bit.
        assert np.abs(found - one_by_one[:n]).max(initial=0) < 1e-15


@pytest.mark.parametrize("omega0", BRANCHES)
def test_a_grid_in_parts_has_the_same_bits(omega0, motions):
    _, prepared = motions.prepare((1.0, 2.0, 2.25), omega0, (3.0, 0, -4.0, 0))
    _, whole = motions.grid(prepared, -20.0, 0.25, 5000)
    parts = [
        motions.grid(prepared, -20.0, 0.25, n, k)[1] for k, n in ((0, 64), (64, 4416), (4480, 520))
    ]
    assert np.array_equal(np.concatenate(parts), whole)


def test_parts_of_grids_that_are_too_far_are_refused(motions):
    _, prepared = motions.prepare(*BODY)
    assert motions.grid(prepared, 0.0, 2.0**40, 2, 1)[0] == 0
    assert motions.grid(prepared, 0.0, 2.0**40, 2, 200)[0] == motions.c.raw.TIME


def test_a_grid_of_one_sample_does_not_ask_its_step(built):
    _, prepared = built.prepare(*BODY)
    code, found = built.grid(prepared, 2.0, MOST, 1)
    assert code == 0
    assert np.array_equal(found, built.grid(prepared, 2.0, 0.25, 1)[1])


@pytest.mark.parametrize("omega0", BRANCHES)
def test_a_grid_that_passes_zero_is_at_its_start_there(omega0, motions):
    _, prepared = motions.prepare((1.0, 2.0, 2.25), omega0, (3.0, 0, -4.0, 0))
    expected = [0.6, 0, -0.8, 0, *omega0]
    for start, step_, at in ((-1.0, 0.5, [2]), (6.25, -0.125, [50]), (0.0, 1.0, [0])):
        found = motions.grid(prepared, start, step_, 100)[1]
        assert [k for k in range(100) if found[k].tolist() == expected] == at
    assert motions.grid(prepared, 0.0, 0.0, 3)[1].tolist() == [expected] * 3


PICKED = (0, 1, 63, 64, 129)


@pytest.fixture(scope="module")
def exact_grids(exact_motions):
    """Return some motions, a start and a step for each, and exact states of such a grid."""
    found = []
    for case, _ in exact_motions[::7]:
        start, apart = case.times[0] / 4, case.times[0] / 400
        exact = case.exact([Fraction(start) + k * Fraction(apart) for k in PICKED])
        found.append((case, start, apart, exact))
    return found


def test_grids_are_right_in_every_regime(built, exact_grids):
    for case, start, apart, exact in exact_grids:
        code, found = built.grid(built.prepare(*case.given)[1], start, apart, 130)
        assert code == 0, case.name
        assert are_right(found[[*PICKED]], exact), case


# --- motions of double-doubles


def pairs(inertia, omega0, attitude0=ATTITUDE):
    """Return doubles, and the differences of moments, as double-doubles."""
    apart = [inertia[k] - inertia[(k + 1) % 3] for k in range(3)]
    return [[(x, 0.0) for x in values] for values in (inertia, apart, omega0, attitude0)]


@pytest.mark.parametrize(
    ("code", "inertia", "omega0", "unit"),
    [
        ("RATES", (1.0, 1.5, 1.2), (1e300, 0.0, 0.0), 1.0),
        ("RATES", (1.0, 1.5, 1.2), (1.0, 0.5, 0.1), -3.0),
        ("RATES", (1.0, 1.5, 1.2), (1.0, 0.5, 0.1), 0.0),
        ("THIN", (1.0, 1.5, 1e-70), (1.0, 0.5, 0.1), 1.0),
        ("NOT_FINITE", (1.0, 1.5, 1.2), (NAN, 0.5, 0.1), 1.0),
        ("INERTIA", (1.0, -1.5, 1.2), (1.0, 0.5, 0.1), 1.0),
    ],
)
def test_pairs_that_no_motion_is_made_of(code, inertia, omega0, unit, motions):
    found, prepared = motions.prepare_pairs(*pairs(inertia, omega0), (0.1, 0.0), unit=unit)
    assert found == getattr(motions.c.raw, code)
    assert prepared.raw == bytes(len(prepared)), "a refused call writes nothing"


def test_pairs_begin_where_doubles_do(motions):
    """Double-doubles without low parts give the states of doubles."""
    (d, b, a), (rate_d, _, rate_a), _ = BODY
    discriminant = a * (a - b) * rate_a**2 - d * (b - d) * rate_d**2
    code, prepared = motions.prepare_pairs(*pairs(*BODY), (discriminant, 0.0), unit=1.0)
    assert code == 0
    _, found = motions.states(prepared, [0.0, 1.0, 50.0])
    _, other = motions.prepare(*BODY)
    assert np.abs(found - motions.states(other, [0.0, 1.0, 50.0])[1]).max() < 1e-14


@pytest.mark.parametrize(
    "moments", [("0.1", "0.2", "0.3"), ("0.3", "0.1", "0.2"), ("1/3", "1", "4/3")]
)
@pytest.mark.parametrize("more", ["0", "1e-17", "1e-15", "-1e-20"])
def test_exact_bodies_are_those_that_exist(motions, moments, more):
    exact = [Fraction(x) for x in moments]
    exact[exact.index(max(exact))] += Fraction(more)
    *others, largest = sorted(exact)
    given = exact_inputs.exact_inputs(exact, [*map(Fraction, RATES)], [*map(Fraction, ATTITUDE)])
    code, _ = motions.prepare_pairs(*given[:5], unit=given.unit)
    assert code == (0 if inputs.can_exist(largest, *others) else motions.c.raw.NONPHYSICAL)


# --- bodies and words


def drawn():
    """Yield moments of all sizes close to the triangle inequality."""
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


def test_bodies_are_those_that_exist_in_python(any_form):
    counts = {True: 0, False: 0}
    for moments in drawn():
        *others, largest = sorted(map(Fraction, moments))
        exists = inputs.can_exist(largest, *others)
        code, _ = any_form.prepare(moments)
        assert code == (0 if exists else any_form.c.raw.NONPHYSICAL), moments
        counts[exists] += 1
    assert min(counts.values()) > 500


@pytest.mark.parametrize("form", forms.FORMS)
def test_a_build_may_allow_any_moments(form, here):
    library = Library(either(), here, *PLAIN, ANY_MOMENTS, form=form)
    assert library.prepare((1, 2, 5))[0] == 0


def test_python_reaches_c_with_any_moments():
    found, other = (
        TorqueFreeMotion((1, 2, 5), RATES, allow_nonphysical=True, engine=engine)([1.0, 2.0])[0]
        for engine in ("c", "numpy")
    )
    np.testing.assert_allclose(found, other, atol=1e-14)
    found, other = (
        step((1, 2, 5), ATTITUDE, RATES, 0.5, engine=engine, allow_nonphysical=True)[0]
        for engine in ("numpy", "c")
    )
    np.testing.assert_allclose(found, other, atol=1e-14)


@pytest.mark.parametrize(
    "moments",
    [(1, 2, 5), (1, -2, 2), (1, 0, 1), (1e-80, 1, 1), (1, NAN, 1), (INF, 1, 1), (1, 1e-100, 2)],
)
def test_moments_are_refused_in_the_words_of_python(any_form, moments):
    with pytest.raises(InputError) as caught:
        TorqueFreeMotion(moments, RATES)(1.0)
    code, room = any_form.prepare(moments)
    rule = any_form.c.rule(code).decode().partition(" (")[0]
    assert rule.removeprefix("every number ") in str(caught.value)
    assert room.raw == bytes(ROOM), "a refused call writes nothing"


def test_every_code_has_words_of_its_own(any_form):
    c = any_form.c
    names = {name: value for name, value in vars(c.raw).items() if name.isupper()}
    codes = sorted(value for name, value in names.items() if not name.startswith("BY_"))
    assert codes == [*range(len(codes))]
    said = [any_form.message(code) for code in codes]
    assert len({*said}) == len(codes)
    assert c.message(len(codes)) == c.message(-1) == b"no such code"
    for code, message in zip(codes, said, strict=True):
        field, rule = c.field(code).decode(), c.rule(code).decode()
        assert message == (f"{field}: {rule}" if field else rule)


def test_codes_keep_their_numbers(motions):
    names = ("OK", "NOT_FINITE", "INERTIA", "THIN", "ATTITUDE", "SEPARATRIX", "TIME", "RATES")
    assert [getattr(motions.c.raw, name) for name in names] == [*range(8)]


@pytest.mark.parametrize("garbage", [b"\0", b"\x01", b"\xff", b"\x7f"])
def test_what_was_not_prepared_is_refused(motions, steps, garbage):
    room = ctypes.create_string_buffer(garbage * ROOM, ROOM)
    t, q, omega = numbers([1.0]), np.full((1, 4), 7.0), np.full((1, 3), 7.0)
    wide, narrow = np.full((1, 3, 9), 7.0), np.full((1, 3), 7.0)
    found = (q, omega, wide, wide.copy(), narrow, narrow.copy())
    c = motions.c
    codes = [
        c.state_at(room, 1.0, q, omega),
        c.states_at(room, 1, t, q, omega),
        c.states_on_grid(room, 0.0, 1.0, 0, 1, q, omega),
        c.states_with_sensitivity(room, 1, t, *found),
        c.states_with_columns(room, 1, t, c.raw.BY_ALL, *found),
    ]
    assert codes == [c.raw.UNPREPARED] * 5
    assert math.isnan(c.last_time(room))
    assert "torque_free_motion_init" in motions.message(codes[0])
    assert steps.c.step(room, q, omega, 0.1) == steps.c.raw.UNPREPARED
    assert all((x == 7.0).all() for x in found), "a refused call writes nothing"


@pytest.mark.parametrize("t", [NAN, INF, -INF])
@pytest.mark.parametrize("omega0", [RATES, (0, 0, 0), (0, 1, 1e-130)])
def test_times_that_are_none_are_not_called_late(motions, t, omega0):
    code, room = motions.prepare((1, 2, 2.5), omega0)
    assert code == 0
    c, times = motions.c, numbers([1e300, t])
    q, omega, failed = np.empty((2, 4)), np.empty((2, 3)), ctypes.c_size_t()
    codes = np.empty(1, np.intc)
    given = numbers([(1, 2, 2.5)]), numbers([omega0]), numbers([ATTITUDE])
    assert c.propagate(1, *given, 2, times, 0, q, omega, codes, failed) == 0
    found = [
        c.state_at(room, t, q, omega),
        c.states_at(room, 2, times, q, omega),
        c.states_on_grid(room, t, 1.0, 0, 2, q, omega),
        c.states_on_grid(room, 1.0, t, 0, 2, q, omega),
        c.propagate(1, *given, 2, times, 0, q, omega, None, failed),
        codes[0],
    ]
    assert found == [c.raw.NOT_FINITE] * 6
    assert motions.message(found[0]) == "every number must be finite"


# --- steps


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
    code, body = steps.prepare((1, 2, 2.5))
    before, rates, expected = numbers(q), numbers(omega), getattr(steps.c.raw, name)
    assert code == 0
    assert steps.c.step(body, before, rates, dt) == expected
    np.testing.assert_array_equal(before, numbers(q))
    after, failed = (np.empty((1, 4)), np.empty((1, 3))), ctypes.c_size_t()
    given = numbers((1, 2, 2.5)), 0, before, rates, numbers([dt]), 0
    assert steps.c.steps(1, *given, *after, failed) == expected


@pytest.mark.parametrize("stride", [0, 3])
def test_many_steps_ask_for_bodies_that_exist(steps, stride):
    inertia = numbers([(1, 2, 2.5), (1, 2, 5)]) if stride else numbers((1, 2, 5))
    q, omega, failed = numbers([ATTITUDE] * 2), numbers([RATES] * 2), ctypes.c_size_t()
    code = steps.c.steps(2, inertia, stride, q, omega, numbers([0.1]), 0, q, omega, failed)
    assert (code, failed.value) == (steps.c.raw.NONPHYSICAL, 1 if stride else 0)
