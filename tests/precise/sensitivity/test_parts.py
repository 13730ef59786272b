"""Parts of a box: they cover it, hold its motions, and are hardly wider than these."""

from fractions import Fraction

import numpy as np
import pytest
from boxes import contain, overlap, spread, widest
from flint import arb, arb_mat

import rigidsym
from rigidsym import TorqueFreeMotion
from rigidsym._inputs import Uncertain, middle, radius
from rigidsym.precise._balls import ball, working
from rigidsym.precise._boxed import BoxedMotion
from rigidsym.precise._sensitivity.box import Box, Slab
from rigidsym.precise._sensitivity.parts import MeanStates, Part, parts_of

# Moments and rates, their radii as parts of the largest of each, times, and the largest ratio of
# radii of balls to those of sampled motions.
BOXES = {
    "symmetric": ((1, 1, 1.4), (0.5, -0.6, 0.7), (8e-3, 0), (12,), 1.5),
    "nearly symmetric": ((0.5764, 1.2811, 1.281), (-0.19, -0.92, 0.49), (5e-3, 0), (20,), 1.5),
    "spin about the middle axis": ((1, 2, 2.5), (0, 1, 0), (0, 1e-2), (12,), 2),
    "the same, all uncertain": ((1, 2, 2.5), (0, 1, 0), (1e-3, 1e-3), (12,), 2),
    "across the separatrix": ((4, 5, 9), (3, 1, 1), (1e-3, 1e-3), (3,), 2),
    "sphere": ((0.77, 0.77, 0.77), (0.26, 0.07, -0.23), (8e-3, 0), (30,), 2),
    "general": ((1.16, 1.04, 0.55), (-0.53, -0.73, -0.42), (4e-3, 0), (12,), 2),
    "late": ((1.46, 0.7, 1.24), (1, -0.16, -0.48), (2e-3, 2e-3), (100,), 2),
}


def uncertain(values, part):
    return tuple(spread(x, Fraction(part) * max(abs(Fraction(y)) for y in values)) for x in values)


def boxed(name):
    inertia, omega, (by_inertia, by_omega), times, most = BOXES[name]
    given = uncertain(inertia, by_inertia), uncertain(omega, by_omega), (1, 2, -3, 0.5)
    return TorqueFreeMotion(*given, allow_nonphysical=True), times, most


def shifts(count, seed=1):
    """Return corners of the unit box and points inside, (count, 6)."""
    random = np.random.default_rng(seed)
    inside = random.uniform(-1, 1, (count, 6))
    return np.where(np.arange(count)[:, None] % 2, np.sign(inside), inside) * (1 - 1e-7)


def sampled(motion, times, count):
    """Return states (count, N, 7) of sampled motions of a box in doubles."""
    numbers = (*motion.inertia, *motion.omega0)
    middles, radii = (np.array([float(f(x)) for x in numbers]) for f in (middle, radius))
    points = middles + shifts(count) * radii
    attitude = np.array([float(x) for x in motion.attitude0])
    states = rigidsym.propagate(
        points[:, :3], points[:, 3:], np.array(times, float), attitude, allow_nonphysical=True
    )
    return np.concatenate(states, axis=2)


@pytest.mark.parametrize("name", BOXES)
def test_balls_hold_the_motions_and_are_hardly_wider(name):
    motion, times, most = boxed(name)
    found = np.concatenate(motion.enclose(times, 15), axis=1)
    for states, balls in zip(sampled(motion, times, 1000).swapaxes(0, 1), found, strict=True):
        middles, radii = (np.array([float(f(x)) for x in balls]) for f in (arb.mid, arb.rad))
        assert (abs(states - middles) <= radii + 1e-12).all()
        half = np.ptp(states, axis=0) / 2
        for part in (slice(4), slice(4, 7)):
            assert radii[part].max() < most * half[part].max()


@pytest.mark.parametrize("name", ["nearly symmetric", "spin about the middle axis", "general"])
def test_parts_cover_the_box_and_each_holds_its_motions(name):
    motion, times, _ = boxed(name)
    time = times[-1]
    mean = MeanStates(motion.inertia, motion.omega0, motion.attitude0, 64)
    parts = parts_of(lambda slabs: mean._part(Fraction(time), lambda: None, slabs), 1e-15)
    assert len(parts) > 3
    box = Box(motion.inertia, motion.omega0)
    points, states = shifts(300), sampled(motion, (time,), 300)[:, 0]
    units = np.concatenate([points[:, 3:], points[:, :3]], axis=1)[:, box.open] * box.radii
    for offsets, state in zip(units, states, strict=True):
        holding = [
            part
            for part in parts
            if all(s.low <= np.dot(s.direction, offsets) <= s.high for s in part.slabs)
        ]
        assert holding
        for part in holding:
            assert contain([x + arb(0, 1e-12) for x in part.state], map(arb, state.tolist()))


BOX = uncertain((1, 2, 2.5), 1e-2), uncertain((0.3, 1, -0.2), 1e-2)
RADII = Box(*BOX).radii


def column(values):
    return arb_mat([[x if isinstance(x, arb) else ball(x)] for x in values])


def within(points, rows, ends):
    """Return the part of BOX within slabs, and the points (N, 6) in it; inputs in their radii."""
    heights = points @ rows.T
    inside = points[((ends[:, 0] <= heights) & (heights <= ends[:, 1])).all(axis=1)]
    pairs = zip((rows / RADII).tolist(), ends.tolist(), strict=True)
    return Box(*BOX, tuple(Slab(tuple(row), *pair) for row, pair in pairs)), inside


def sides_of(box, far):
    """Return the sides of a part at a point, given less the middle of the part, (6, 1)."""
    along = (arb_mat([list(slab.direction) for slab in box.slabs]) * far).entries()
    moved = column(box.shift) - column(box._unscaled(box.limits.mean(axis=1)))
    return [*along, *(far + moved - box._across * moved).entries()]


def test_parts_within_slabs_hold_their_points_and_sides_give_the_places_of_these():
    random = np.random.default_rng(2)
    points = random.uniform(-1, 1, (4000, 6))
    for count in (1, 2, 3):
        rows = random.normal(size=(count, 6))
        ends = np.sort(random.uniform(-1.5, 1.5, (count, 2)), axis=1)
        with working(120):
            box, inside = within(points, rows, ends)
            assert len(inside)
            assert (box.limits[:, 0] <= inside).all()
            assert (inside <= box.limits[:, 1]).all()
            for point in inside[:50]:
                off = [arb(x) * arb(r) for x, r in zip(point.tolist(), RADII.tolist(), strict=True)]
                far = column(off) - column(box.shift)
                sides = sides_of(box, far)
                assert contain([x + arb(0, 1e-15) for x in box.sides.entries()], sides)
                assert overlap((box.by_sides * column(sides)).entries(), far.entries())


def test_the_reach_of_slopes_holds_all_points_of_a_narrow_slab():
    """Slopes by the inputs that lead farther than those along a slab are counted along it."""
    random = np.random.default_rng(3)
    points, taken = random.uniform(-1, 1, (20000, 6)), 0
    for begin in np.arange(-2, 2, 0.2):
        rows = random.normal(size=(2, 6))
        ends = np.array([[begin, begin + 0.2], [-begin / 2, -begin / 2 + 0.5]])
        with working(120):
            box, inside = within(points, rows, ends)
            shift = np.array([float(x) for x in box.shift])
            for slope in (rows / RADII).tolist() + random.normal(size=(6, 6)).tolist():
                along = [arb(x) for x in random.normal(size=2).tolist()]
                # Slopes by the inputs alone lie in the row space of `_across`.
                row = (arb_mat([slope]) * box._across).entries()
                slopes = [*along, *(x + y * 3 for x, y in zip(row, map(arb, slope), strict=True))]
                reached = box.reach(slopes)
                for far in inside[:20] * RADII - shift:
                    sides = sides_of(box, column(map(arb, far.tolist())))
                    value = sum((x * y for x, y in zip(slopes, sides, strict=True)), arb(0))
                    assert (reached + arb(0, 1e-13)).contains(value.mid())
                    taken += 1
    assert taken > 1000


def test_slabs_that_leave_nothing_are_found():
    inertia, omega = uncertain((1, 2, 2.5), 0), uncertain((0.3, 1, -0.2), 1e-2)
    direction = tuple(100.0 * np.ones(3))
    assert Box(inertia, omega, (Slab(direction, 3.1, 4.0),)).limits is None
    assert Box(inertia, omega, (Slab(direction, 2.9, 4.0),)).limits is not None


def test_moments_do_not_matter_to_a_spin():
    """This holds at late times, too, even about the middle axis."""
    motion = TorqueFreeMotion(("1 +/- 1e-2", 2, "2.5 +/- 1e-2"), (0, 1, 0))
    exact = TorqueFreeMotion((1, 2, 2.5), (0, 1, 0))
    for time in (1, 1000):
        found, true = (np.concatenate(x.enclose(time, 15)) for x in (motion, exact))
        assert overlap(found, true)
        assert widest(found) < 1e-14


def test_a_part_that_says_nothing_is_not_cut():
    state, bends = [arb(0, 1)] * 7, np.full((6, 1), 1e9)
    part = Part((), state, np.zeros((7, 2)), bends, np.ones(1), np.eye(2)[:1])
    assert part.pieces() == []


def test_pieces_cover_a_part_that_is_small_beside_its_distance():
    """The widths are lost in sums of doubles, so the sums are exact."""
    random = np.random.default_rng(1)
    for _ in range(100):
        middles = random.uniform(-1, 1, 3)
        widths = np.array([1, 1e-8, 1e-8]) * random.uniform(0.5, 1, 3)
        ends = np.array([middles - widths, middles + widths]).T
        bends = random.normal(size=(6, 3)) * 0.1 / widths
        pieces = Part((), [], np.zeros((7, 2)), bends, widths, ends).pieces()
        direction = [Fraction(x) for x in pieces[0][-1].direction]
        sides = zip(direction, ends.tolist(), strict=True)
        reached = [sorted(g * Fraction(x) for x in row) for g, row in sides]
        assert Fraction(pieces[0][-1].low) <= sum(low for low, _ in reached)
        assert Fraction(pieces[-1][-1].high) >= sum(high for _, high in reached)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("rate", "time"), [(Fraction(10) ** 320, Fraction(1, 10**320)), (Fraction(1), 10**320)]
)
def test_boxes_beyond_binary64_are_enclosed(rate, time):
    omega = Uncertain(rate, rate / 10**330), rate, 2 * rate
    inertia, attitude = (tuple(map(Fraction, x)) for x in ((1, 2, 3), (1, 0, 0, 0)))
    motion = BoxedMotion(inertia, omega, attitude)
    (state,) = motion.enclosures([Fraction(time)], 12)
    assert all(x.is_finite() for part in state for x in part)
