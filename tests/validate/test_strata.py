"""Strata: cases do not depend on when they are drawn, and strata cover what they say."""

import json
import math
import pickle
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from rigidsym import InputError, TorqueFreeMotion
from rigidsym import _inputs as inputs
from rigidsym.solution._polhode import Regime, classify, discriminant
from rigidsym.validate._oracle import precise_motion
from rigidsym.validate.strata import STRATA, count, draw, samples
from rigidsym.validate.strata import _motions as motions
from rigidsym.validate.strata._own_times import published

REFERENCE = Path(__file__).parents[3] / "shared" / "reference" / "reference_cases.json"
FEW, SEED = 16, 4
MAX_ANGLE = 2.0**46


def drawn(stratum, cases=FEW, seed=SEED):
    return [draw(stratum, index, seed) for index in range(count(stratum, cases))]


def motion(sample):
    return TorqueFreeMotion(sample.inertia, sample.omega0, sample.attitude0)


def regime(sample):
    return motion(sample).regime


def test_a_sample_is_the_same_whenever_it_is_drawn():
    listed = list(samples(2, seed=9))
    assert len(listed) == 2 * len(STRATA) - 1
    for sample in reversed(listed):
        assert repr(sample) == repr(draw(sample.stratum, sample.index, 9))
        assert pickle.loads(pickle.dumps(sample)) == sample
    assert draw("uniform", 0, 9) != draw("uniform", 0, 10)


def test_the_papers_body_comes_first_and_alone():
    assert next(iter(STRATA)) == "paper"
    assert (STRATA["paper"].size, count("paper", 50)) == (1, 1)
    assert draw("paper", 0, 1) == draw("paper", 0, 2)


@pytest.mark.parametrize("stratum", STRATA)
def test_strata_say_who_they_are(stratum):
    assert STRATA[stratum].name == stratum
    assert "\n" not in STRATA[stratum].about


@pytest.mark.parametrize("stratum", STRATA)
def test_every_sample_can_exist_and_be_followed(stratum):
    for sample in drawn(stratum, 60):
        inputs.inertia(sample.inertia)
        inputs.attitude(sample.attitude0)
        assert all(type(x) in (float, Fraction) for x in (*sample.inertia, *sample.omega0))
        assert all(type(t) is float and math.isfinite(t) for t in sample.times)
        rate = math.hypot(*sample.omega0)
        assert all(rate * abs(t) <= MAX_ANGLE for t in sample.times)
        assert 0.0 in sample.times
        assert 10 <= len(sample.times) <= 45
        assert max(sample.times) > 0
        assert min(sample.times) < 0
        # Nothing is excepted: every stratum goes as far as the domain and doubles do.
        latest = max(map(abs, sample.times))
        assert rate * latest > MAX_ANGLE / 4 or not rate or latest == 2.0**1023


@pytest.mark.parametrize("stratum", [name for name in STRATA if STRATA[name].size])
def test_every_case_of_a_finite_stratum_is_another_one(stratum):
    size = STRATA[stratum].size
    listed = drawn(stratum, size + 5)
    different = {repr((s.inertia, s.omega0, s.attitude0)) for s in listed}
    if stratum == "special values":
        different = {repr((s.inertia, s.omega0)) for s in listed}
    assert len(listed) == len(different) == size


def gap(sample, low, high):
    """Return the relative difference of two moments, by rank."""
    ranked = sorted(map(Fraction, sample.inertia))
    return (ranked[high] - ranked[low]) / ranked[high]


def from_separatrix(sample):
    """Return |E_b| over the sum of the sizes of its terms."""
    inertia, omega = (list(map(Fraction, x)) for x in (sample.inertia, sample.omega0))
    middle = sorted(inertia)[1]
    size = sum(c * abs(c - middle) * w * w for c, w in zip(inertia, omega, strict=True))
    return abs(discriminant(inertia, omega)) / size


def tilt(sample):
    _, middle, main = sorted(abs(Fraction(w)) for w in sample.omega0)
    return middle / main


def symmetric_gap(sample):
    return min(gap(sample, 0, 1), gap(sample, 1, 2))


# What is small, and between which powers of ten: the first and last decade that few cases reach.
DISTANCES = {
    "near separatrix": (from_separatrix, 1, 15),
    "nearest separatrix": (from_separatrix, 17, 249),
    "near separatrix, long": (from_separatrix, 1, 15),
    "near prolate": (lambda s: gap(s, 1, 2), 1, 15),
    "near oblate": (lambda s: gap(s, 0, 1), 1, 15),
    "nearest symmetric": (symmetric_gap, 17, 299),
    "near sphere": (lambda s: gap(s, 0, 2), 1, 14),
    "nearest sphere": (lambda s: gap(s, 0, 2), 16, 248),
    "near spin, largest": (tilt, 1, 299),
    "near spin, middle": (tilt, 1, 84),
    "near spin, smallest": (tilt, 1, 299),
    "rod": (lambda s: min(s.inertia) / max(s.inertia), 1, 14),
    "needle": (lambda s: min(s.inertia) / max(s.inertia), 1, 58),
}


@pytest.mark.parametrize("stratum", DISTANCES)
def test_few_cases_already_spread_over_all_decades(stratum):
    distance, first, last = DISTANCES[stratum]
    exponents = sorted(-math.log10(distance(sample)) for sample in drawn(stratum))
    assert exponents[0] <= first + 1
    assert exponents[-1] >= last
    # No hole is wider than a fifth of the whole, and so it is evenly covered.
    assert max(np.diff(exponents)) < (last - first) / 5 + 1


@pytest.mark.parametrize(("stratum", "axis"), [("largest", 2), ("middle", 1), ("smallest", 0)])
def test_spin_is_about_the_axis_named(stratum, axis):
    for sample in drawn(f"near spin, {stratum}"):
        max_rate = max(range(3), key=lambda k: abs(sample.omega0[k]))
        assert sorted(sample.inertia)[axis] == sample.inertia[max_rate]


def test_doubles_on_the_separatrix_are_on_it_exactly():
    listed = drawn("separatrix", 40)
    assert all(from_separatrix(sample) == 0 for sample in listed)
    assert all(isinstance(x, float) for s in listed for x in (*s.inertia, *s.omega0))
    ratios = {tuple(Fraction(c) / Fraction(max(s.inertia)) for c in s.inertia) for s in listed}
    assert len(ratios) > 30
    assert len(motions.points()) > 150


def test_beside_the_separatrix_is_an_ulp_away():
    distances = [from_separatrix(sample) for sample in drawn("beside separatrix", 40)]
    assert 0 < min(distances) < 2**-53
    assert max(distances) < 2**-46


MOVING = {Regime.LARGEST, Regime.SMALLEST}
REGIMES = {
    **dict.fromkeys(
        ("uniform", "axis orders and signs", "near separatrix", "beside separatrix", "rod",
         "nearest separatrix", "near prolate", "near oblate", "nearest symmetric", "near sphere",
         "nearest sphere", "near spin, middle", "flat", "needle", "zeros of the rates",
         "quarter periods"),
        MOVING,
    ),
    "separatrix": {Regime.SEPARATRIX},
    "symmetric": {Regime.SYMMETRIC, Regime.SPIN},
    "sphere": {Regime.SPHERICAL},
    "spin": {Regime.SPIN},
    "near spin, largest": {Regime.LARGEST},
    "near spin, smallest": {Regime.SMALLEST},
    "rest": {Regime.REST},
    "decimals": MOVING | {Regime.SEPARATRIX},
    "special values": set(Regime),
    "published": set(Regime),
}  # fmt: skip


@pytest.mark.parametrize("stratum", REGIMES)
def test_strata_produce_the_regimes_they_stand_for(stratum):
    found = {regime(sample) for sample in drawn(stratum, 4000 if "special" in stratum else 40)}
    optional = {Regime.SYMMETRIC} if stratum == "decimals" else set()
    assert found - optional == REGIMES[stratum]


def test_symmetric_bodies_of_both_kinds_with_zeros_everywhere():
    listed = drawn("symmetric", 60)
    patterns = set()
    for prolate in (False, True):
        some = [s for s in listed if (gap(s, 1, 2) == 0) == prolate]
        assert len(some) > 20
        for sample in some:
            odd = next(k for k in range(3) if sample.inertia.count(sample.inertia[k]) == 1)
            across = sum(sample.omega0[k] != 0 for k in range(3) if k != odd)
            patterns.add((prolate, sample.omega0[odd] != 0, across))
    kinds = {(True, 2), (True, 1), (True, 0), (False, 2), (False, 1)}
    assert patterns == {(prolate, *kind) for prolate in (False, True) for kind in kinds}


def test_every_order_of_the_axes_and_every_sign():
    seen = set()
    for sample in drawn("axis orders and signs", 48):
        order = tuple(sorted(sample.inertia).index(c) for c in sample.inertia)
        seen.add((order, tuple(w > 0 for w in sample.omega0)))
    assert len(seen) == 48


def test_flat_bodies_are_flat_exactly():
    for sample in drawn("flat", 40):
        low, middle, high = sorted(map(Fraction, sample.inertia))
        assert low + middle == high


def test_special_values_have_every_zero_and_equal_rates():
    listed = drawn("special values", 10**6)
    assert {tuple(map(int, s.inertia)) for s in listed} == set(motions.BODIES)
    zeros = {tuple(w == 0 for w in s.omega0) for s in listed}
    assert len(zeros) == 8
    assert any(math.copysign(1, w) < 0 for s in listed for w in s.omega0 if w == 0)
    assert any(len(set(s.omega0)) == 1 for s in listed)


def test_special_attitudes_are_half_turns_of_every_length():
    quaternions = {s.attitude0 for s in drawn("special attitudes", 10**6)}
    assert {(0, 1, 0, 0), (0, 0, 0, -1), (-1, 0, 0, 0), (1, 0, 0, 0)} <= quaternions
    lengths = {max(map(abs, q)) for q in quaternions}
    assert {1e-300, 1e-150, 1.0, 1e150, 1e300} <= lengths


@pytest.mark.parametrize(
    ("stratum", "inertia", "rates"),
    [("scales", (-199, 199), (-249, 249)), ("extreme scales", (-322, 306), (-297, 296))],
)
def test_scales_reach_from_the_least_to_the_largest(stratum, inertia, rates):
    listed = drawn(stratum)
    for field, (least, most) in (("inertia", inertia), ("omega0", rates)):
        sizes = sorted(math.log10(max(map(abs, getattr(s, field)))) for s in listed)
        assert sizes[0] < least + 1
        assert sizes[-1] > most - 1
        assert max(np.diff(sizes)) < (most - least) / 4


def test_a_zero_of_each_rate_lies_between_neighbouring_times():
    for sample in drawn("zeros of the rates", 24):
        axes = precise_motion(sample).polhode.axes
        _, omega = motion(sample).precise(list(map(Fraction, sample.times)), 20)
        for axis, first in ((axes[1], 1), (axes[2], 6)):
            around = sample.times[first : first + 5]
            assert math.nextafter(around[0], around[1]) == around[1]
            values = omega[first : first + 5, axis]
            assert values[0] * values[1] < 0
            assert values[0] * values[2] > 0
            assert values[3] * values[4] < 0


def test_multiples_of_the_quarter_period_lie_between_neighbouring_times():
    longest = 0.0
    for sample in drawn("quarter periods", 24):
        quarter = quarter_period(sample)
        for one, other in zip(sample.times[1::2], sample.times[2::2], strict=True):
            with mpmath.workdps(60):
                low, high = sorted((mpf(one), mpf(other)))
                number = mpmath.nint(low / quarter)
                assert low <= number * quarter <= high
                assert number != 0
        longest = max(longest, *(abs(t) * math.hypot(*sample.omega0) for t in sample.times))
    assert MAX_ANGLE / 2 < longest < MAX_ANGLE


def quarter_period(sample):
    """Return K(m) / lambda, with lambda and m of the textbook."""
    exact = motion(sample)
    axes = classify(exact.inertia, exact.omega0).axes
    a, b, d = (exact.inertia[k] for k in axes)
    energy = sum(c * w * w for c, w in zip(exact.inertia, exact.omega0, strict=True))
    momentum = sum((c * w) ** 2 for c, w in zip(exact.inertia, exact.omega0, strict=True))
    fast = momentum - energy * d
    square = (a - b) * fast / (a * b * d)
    m = (energy * a - momentum) * (d - b) / (fast * (b - a))
    with mpmath.workdps(60):
        k, root = (mpf(x.numerator) / x.denominator for x in (m, square))
        return mpmath.ellipk(k) / mpmath.sqrt(root)


def test_long_times_reach_the_end():
    for stratum, most in (("long times", 1e6), ("longest times", MAX_ANGLE)):
        listed = drawn(stratum)
        turned = [[abs(t) * math.hypot(*s.omega0) for t in s.times[1:9]] for s in listed]
        assert most / 2 < max(map(max, turned)) < most
        assert all(max(angles) > most / 4 for angles in turned)
        assert min(abs(t) for s in listed for t in s.times if t) < 1


def test_published_motions_are_exact_decimals():
    for entry, sample in zip(published(), drawn("published", 100), strict=True):
        for field in ("inertia", "omega0", "attitude0"):
            exact = [Fraction(x) for x in entry[field]]
            assert [Fraction(x) for x in getattr(sample, field)] == exact
        assert {float(Fraction(t)) for t in entry["times"]} <= set(sample.times)


def can_exist(inertia):
    try:
        inputs.inertia(inertia)
    except InputError:
        return False
    return True


@pytest.mark.skipif(not REFERENCE.exists(), reason="shared reference data is not here")
def test_all_reference_motions_of_bodies_that_can_exist_are_published():
    def key(inertia, omega0, attitude0):
        return tuple(tuple(map(Fraction, x)) for x in (inertia, omega0, attitude0))

    known = {key(e["inertia"], e["omega0"], e["attitude0"]) for e in published()}
    cases = json.loads(REFERENCE.read_text())["cases"]
    cases = [case for case in cases if can_exist(case["inertia"])]
    assert {key(c["inertia"], c["omega0"], c["q0"]) for c in cases} < known
