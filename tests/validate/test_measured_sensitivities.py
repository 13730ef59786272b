"""Measured sensitivities: enclosures are right, and wrong columns are detected."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from sensitivity_oracle import differences

from rigidsym import _engines as engines
from rigidsym.validate import _sensitivities as sensitivities
from rigidsym.validate._implementations import missing
from rigidsym.validate._sensitivities import (
    BOUND,
    COLUMNS,
    LEAST,
    WIDER,
    ColumnsReference,
    bound_of,
    by_stratum,
    columns,
    enclosed,
    errors,
    of_engine,
    references,
)
from rigidsym.validate.strata import STRATA, draw

# A step is small beside all distances from edges that strata have early.
DIGITS, STEP = 400, 160
# Differences lose what the third derivatives have, which grow with the cube of the time.
EARLY, TIMES = 1e4, 3
NAMES = [name for name, reason in missing(engines.ENGINES).items() if not reason]
FEW = ("paper", "uniform", "near spin, middle", "symmetric", "sphere", "rest")


def early(sample):
    rate = max(map(abs, map(float, sample.omega0))) or 1.0
    kept = [t for t in sample.times if abs(t) * rate < EARLY]
    return type(sample)(*[getattr(sample, x) for x in sample.__slots__[:-1]], tuple(kept[:TIMES]))


def by_differences(sample):
    """Return columns by differences of states of many digits."""
    times = list(map(Fraction, sample.times))
    moved = differences(*sample.exact, times, STEP, DIGITS)
    turned = np.broadcast_to(np.eye(6)[:, :3], (len(times), 6, 3))
    table = np.concatenate([turned, moved[..., :6]], axis=-1)
    by_time = moved[..., 6]
    return columns(sample, table[:, :3], table[:, 3:], by_time[:, :3], by_time[:, 3:])


@pytest.mark.parametrize("stratum", STRATA)
def test_enclosures_are_what_differences_tend_to(stratum):
    sample = early(draw(stratum, 1, seed=5))
    assert sample.times
    wrong = errors(by_differences(sample), enclosed(sample))
    assert np.nanmax(wrong) < 1e-14, COLUMNS[int(np.nanargmax(np.nanmax(wrong, axis=0)))]


@pytest.fixture(scope="module")
def few():
    """Return two cases of each of a few strata with their true columns."""
    return references(cases=2, strata=FEW)


def test_enclosures_measure_nothing_of_themselves(few):
    found = list(by_stratum(enclosed, few))
    assert [worst.stratum for worst in found] == [name for name in STRATA if name in FEW]
    assert all(worst.error == 0 and worst.is_within for worst in found)


FAULTS = {
    "a sign": lambda x: x * np.where(np.arange(10) == 4, -1, 1),
    "body axes for space's": lambda x: np.roll(x, 1, axis=1),
    "columns in another order": lambda x: x[..., [0, 1, 2, 3, 4, 5, 7, 6, 8, 9]],
    "a digit": lambda x: x * (1 + 1e-12),
    "no numbers but infinite ones": lambda x: x + np.inf,
    "no numbers at all": lambda x: np.full_like(x, np.nan),
    "no moments": lambda x: x * (np.arange(10) != 8),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_are_noticed(fault, few):
    truth = {name: few[name] for name in FEW[:3]}
    known = {id(case.sample): case.columns for cases in truth.values() for case in cases}
    found = list(by_stratum(lambda sample: FAULTS[fault](known[id(sample)]), truth))
    assert not any(worst.is_within for worst in found)


def test_a_short_column_is_measured_by_its_own_length():
    """Change a column of 1e-20 near a spin by its own size."""
    sample = draw("near spin, middle", 1, seed=sensitivities.SEED)
    reference = ColumnsReference.of(sample)
    late = np.abs(sample.times) * float(np.linalg.norm(sample.omega0)) >= 1
    own = np.linalg.norm(reference.columns[late], axis=1)
    assert np.array_equal(reference.lengths[late], own)
    assert LEAST < own.min() < 1e-20
    wrong = reference.columns + 1e-20
    assert np.nanmax(errors(wrong, reference.columns, reference.lengths)) > 1


def test_columns_start_at_the_length_of_the_first_radian():
    (reference,) = references(cases=1, strata=("paper",))["paper"]
    sample, moments = reference.sample, slice(6, 9)
    rate = float(np.linalg.norm(sample.omega0))
    ends = enclosed(replace(sample, times=(-1 / rate, 1 / rate)))
    first = np.minimum(np.linalg.norm(ends, axis=1)[:, moments], 1)
    for t, columns_then, lengths in zip(
        sample.times, reference.columns, reference.lengths, strict=True
    ):
        own = np.linalg.norm(columns_then, axis=0)
        assert np.array_equal(lengths[[*range(6), 9]], own[[*range(6), 9]])
        least = first[int(t >= 0)] if abs(t) * rate < 1 else 0
        assert np.allclose(lengths[moments], np.maximum(own[moments], least), rtol=1e-15)


def test_what_is_refused_is_counted():
    def half(sample):
        found = enclosed(sample)
        found[1::2] = np.nan
        return found

    (worst,) = by_stratum(half, references(cases=1, strata=("paper",)))
    times = len(draw("paper", 0, seed=sensitivities.SEED).times)
    assert worst.is_within
    assert (worst.refused, worst.measured) == (times // 2, 10 * (times - times // 2))


def test_the_bound_is_the_documented_one():
    assert BOUND == 1e-13
    assert set(WIDER) < set(STRATA)


@pytest.mark.parametrize("stratum", WIDER)
def test_no_bound_is_wider_than_it_has_to_be(stratum):
    """Measure a case that needs the wider bound, and more than a fifth of it."""
    sample = draw(stratum, WIDER[stratum].case, seed=sensitivities.SEED)
    true = ColumnsReference.of(sample)
    found = (of_engine(engines.engine(name))(sample) for name in NAMES)
    worst = max(np.nanmax(errors(numbers, true.columns, true.lengths)) for numbers in found)
    assert max(BOUND, bound_of(stratum) / 5) < worst <= bound_of(stratum)


@pytest.mark.parametrize("stratum", ["paper", "near spin, middle"])
def test_a_bound_is_kept_and_broken(stratum):
    """Change columns by errors within and beyond the bound."""
    truth = references(cases=1, strata=(stratum,))
    for share, kept in ((0.9, True), (1.1, False)):
        size = 1 + share * bound_of(stratum)
        found = by_stratum(lambda sample, size=size: enclosed(sample) * size, truth)
        assert [worst.is_within for worst in found] == [kept]


def test_modules_are_measured_by_the_command(run):
    strata = "--stratum uniform --stratum 'near separatrix'"
    printed = run(f"validate numpy --sensitivity {strata} --cases 2")
    assert "near separatrix:" in printed.out
    assert "broken" not in printed.err


def test_a_broken_bound_is_named(monkeypatch, run):
    monkeypatch.setattr(sensitivities, "BOUND", 1e-18)
    command = "validate numpy --sensitivity --stratum uniform --cases 1"
    assert "broken: numpy: uniform: " in run(command, status=1).err
