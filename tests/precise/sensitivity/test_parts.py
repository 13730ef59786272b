"""Parts of a box: they cover it, hold its motions, and together are hardly wider than these."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb, arb_mat

import rigidsym
from rigidsym import TorqueFreeMotion
from rigidsym._inputs import Uncertain, middle, radius
from rigidsym.precise._balls import ball, working
from rigidsym.precise._boxed import BoxedMotion
from rigidsym.precise._sensitivity.box import Box, Slab
from rigidsym.precise._sensitivity.parts import MeanStates, Part, parts_of

# Moments and rates, their radii as parts of the largest of each, times, and how much wider than the
# sampled motions the balls may be.
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
    spread = Fraction(part) * max(abs(Fraction(x)) for x in values)
    return tuple(Uncertain(Fraction(x), spread) if spread else Fraction(x) for x in values)


def boxed(name):
    inertia, omega, (by_inertia, by_omega), times, most = BOXES[name]
    given = uncertain(inertia, by_inertia), uncertain(omega, by_omega), (1, 2, -3, 0.5)
    return TorqueFreeMotion(*given, allow_nonphysical=True), times, most


def shifts(count, seed=1):
    """Corners of the unit box (count, 6), and points inside."""
    random = np.random.default_rng(seed)
    inside = random.uniform(-1, 1, (count, 6))
    return np.where(np.arange(count)[:, None] % 2, np.sign(inside), inside) * (1 - 1e-7)


def sampled(motion, times, count):
    """States (count, N, 7) in doubles."""
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
            for ball_, value in zip(part.state, state, strict=True):
                assert (ball_ + arb(0, 1e-12)).contains(arb(float(value)))


def test_what_slabs_leave_holds_their_points_and_its_sides_say_where_these_are():
    inertia, omega = uncertain((1, 2, 2.5), 1e-2), uncertain((0.3, 1, -0.2), 1e-2)
    radii = Box(inertia, omega).radii
    random = np.random.default_rng(2)
    points = random.uniform(-1, 1, (4000, 6))
    for count in (1, 2, 3):
        directions = random.normal(size=(count, 6))
        ends = np.sort(random.uniform(-1.5, 1.5, (count, 2)), axis=1)
        slabs = tuple(
            Slab(tuple((row / radii).tolist()), *pair)
            for row, pair in zip(directions, ends.tolist(), strict=True)
        )
        heights = points @ directions.T
        inside = points[((ends[:, 0] <= heights) & (heights <= ends[:, 1])).all(axis=1)]
        with working(120):
            box = Box(inertia, omega, slabs)
            assert len(inside)
            assert (box.limits[:, 0] <= inside).all()
            assert (inside <= box.limits[:, 1]).all()
            across, back = box._across, box.by_sides
            center = [ball(x) for x in box._unscaled(box.limits.mean(axis=1))]
            for point in inside[:50]:
                off = [arb(x) * arb(r) for x, r in zip(point.tolist(), radii.tolist(), strict=True)]
                far = [x - ball(y) for x, y in zip(off, box.shift, strict=True)]
                along = [
                    sum((arb(g) * x for g, x in zip(slab.direction, far, strict=True)), arb(0))
                    for slab in slabs
                ]
                moved = arb_mat([[ball(x) - y] for x, y in zip(box.shift, center, strict=True)])
                near = arb_mat([[x - y] for x, y in zip(off, center, strict=True)]) - across * moved
                sides = [*along, *near.entries()]
                for side, value in zip(box.sides.entries(), sides, strict=True):
                    assert (side + arb(0, 1e-15)).contains(value)
                again = (back * arb_mat([[x] for x in sides])).entries()
                assert all(x.overlaps(y) for x, y in zip(again, far, strict=True))


def test_the_reach_of_slopes_holds_all_points_of_a_narrow_slab():
    """Where slopes by inputs lead farther than along the slab they are seen along it."""
    inertia, omega = uncertain((1, 2, 2.5), 1e-2), uncertain((0.3, 1, -0.2), 1e-2)
    radii = Box(inertia, omega).radii
    random = np.random.default_rng(3)
    points, taken = random.uniform(-1, 1, (20000, 6)), 0
    for begin in np.arange(-2, 2, 0.2):
        rows = random.normal(size=(2, 6))
        ends = np.array([[begin, begin + 0.2], [-begin / 2, -begin / 2 + 0.5]])
        slabs = tuple(
            Slab(tuple((row / radii).tolist()), *pair)
            for row, pair in zip(rows, ends.tolist(), strict=True)
        )
        heights = points @ rows.T
        inside = points[((ends[:, 0] <= heights) & (heights <= ends[:, 1])).all(axis=1)]
        with working(120):
            box = Box(inertia, omega, slabs)
            shift = np.array([float(x) for x in box.shift])
            for slope in (rows / radii).tolist() + random.normal(size=(6, 6)).tolist():
                along = [arb(x) for x in random.normal(size=2).tolist()]
                # By the inputs alone, whatever is seen along the slabs: the row space of `_across`.
                row = (arb_mat([list(map(arb, slope))]) * box._across).entries()
                tilted = [x + y * 3 for x, y in zip(row, map(arb, slope), strict=True)]
                reached = box.reach([*along, *tilted])
                for far in inside[:20] * radii - shift:
                    sides = [arb(float(x)) for x in rows / radii @ far]
                    offsets = arb_mat([[ball(x)] for x in box._unscaled(box.limits.mean(axis=1))])
                    moved = arb_mat([[ball(x)] for x in box.shift]) - offsets
                    back = moved - box._across * moved
                    near = arb_mat([[arb(float(x))] for x in far]) + back
                    value = sum((x * y for x, y in zip(along, sides, strict=True)), arb(0))
                    value += sum(
                        (x * y for x, y in zip(tilted, near.entries(), strict=True)), arb(0)
                    )
                    assert (reached + arb(0, 1e-13)).contains(value.mid())
                    taken += 1
    assert taken > 1000


def test_slabs_that_leave_nothing_are_found():
    inertia, omega = uncertain((1, 2, 2.5), 0), uncertain((0.3, 1, -0.2), 1e-2)
    direction = tuple(100.0 * np.ones(3))
    assert Box(inertia, omega, (Slab(direction, 3.1, 4.0),)).limits is None
    assert Box(inertia, omega, (Slab(direction, 2.9, 4.0),)).limits is not None


def test_moments_do_not_matter_to_a_spin():
    """Not even about the middle axis, late."""
    motion = TorqueFreeMotion(("1 +/- 1e-2", 2, "2.5 +/- 1e-2"), (0, 1, 0))
    exact = TorqueFreeMotion((1, 2, 2.5), (0, 1, 0))
    for time in (1, 1000):
        found, true = (np.concatenate(x.enclose(time, 15)) for x in (motion, exact))
        assert all(x.rad() < 1e-14 and x.overlaps(y) for x, y in zip(found, true, strict=True))


def test_a_part_that_says_nothing_is_not_cut():
    part = Part(
        (), [arb(0, 1)] * 7, np.zeros((7, 2)), np.full((6, 1), 1e9), np.ones(1), np.eye(2)[:1]
    )
    assert part.pieces() == []


def test_pieces_cover_a_part_that_is_small_beside_its_distance():
    """By exact sums, of which doubles lose what the part is wide."""
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
    motion = BoxedMotion(*(tuple(map(number, x)) for x in ((1, 2, 3), omega, (1, 0, 0, 0))))
    (state,) = motion.enclosures([Fraction(time)], 12)
    assert all(x.is_finite() for part in state for x in part)


def number(x):
    return x if isinstance(x, Uncertain) else Fraction(x)
