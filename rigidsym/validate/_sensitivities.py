"""Measurement of errors in the derivatives of states with respect to inputs and time.

The true derivatives are enclosures.  A column is what the small turn eta, in rad, and the rates,
over |omega0|, change by with an input, in units of the input's own: 1 rad of the attitude at t = 0,
|omega0| of the rates, a moment of inertia, and 1/|omega0| of the time.  An error is the length of a
column's difference over the length of the column.  Two lengths are at least something else: columns
by the moments, which start at zero, are taken to be as long as after a turn of `EARLY`, and no
column is below `LEAST`, because the squares of such changes leave binary64.
"""

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from rigidsym._engines import Engine
from rigidsym._engines.exact_inputs import by_exact_moments
from rigidsym.errors import EngineError
from rigidsym.validate._measure import prepare
from rigidsym.validate._oracle import column_digits, precise_motion
from rigidsym.validate.peers._protocol import Solver
from rigidsym.validate.strata import Sample, samples

DIGITS, CASES, SEED = 25, 15, 1
# Above and below these lengths, squares of columns leave binary64.
LARGEST, LEAST = 2.0**500, 2.0**-300
# |omega0 t| in rad from which on columns by the moments are measured by their own length.
EARLY = 1.0
# Columns below this length are enclosed once more.
_SHORT = 1e-8
HEADS = ("worst error", "documented", "case", "column", "t, s", "columns measured", "times refused")
COLUMNS = (*(f"{x}{k}" for x in ("eta", "omega", "c") for k in (1, 2, 3)), "t")
MOMENTS = slice(6, 9)
Sensitive = Callable[[Sample], np.ndarray]


@dataclass(frozen=True, slots=True)
class Wider:
    """Widened error bound of one stratum.

    It has a reason, and a case that comes near the bound.
    """

    bound: float
    why: str
    case: int


# The documented bound, and those of some strata.
BOUND = 1e-13
_BESIDE_ZERO = (
    "where a rate of a nearly symmetric body is zero a column is small, by the root of what moments"
    " differ by, beside what it is just before, and so beside the rounding of the state"
)
_TO_MIDDLE = (
    "integrals of rates and phases are rounded, and on the way to spin about the middle axis a"
    " column may be small beside them"
)
WIDER = {
    "beside separatrix": Wider(1e-12, _TO_MIDDLE, 22),
    "near spin, middle": Wider(1e-12, _TO_MIDDLE, 22),
    "extreme scales": Wider(
        5e-13,
        "what rates change by with moments is near the least double, which has few digits",
        32,
    ),
    "zeros of the rates": Wider(1e-9, _BESIDE_ZERO, 99),
    "quarter periods": Wider(1e-9, _BESIDE_ZERO, 35),
}


def bound_of(stratum: str) -> float:
    """Return the documented bound on errors of derivatives in a stratum."""
    return WIDER[stratum].bound if stratum in WIDER else BOUND


@dataclass(frozen=True, slots=True)
class StratumErrors:
    """Largest error of derivatives in a stratum, with its case, column and time.

    measured: the number of columns.  refused: the number of times without numbers.
    """

    stratum: str
    error: float
    case: int
    column: str
    time: float
    measured: int
    refused: int

    def row(self) -> tuple[str, ...]:
        """Return the errors as a row of a table.

        The columns are those of `HEADS`.
        """
        sizes = f"{self.error:.1e}", f"{bound_of(self.stratum):.0e}"
        where = f"{self.stratum}:{self.case}", self.column, f"{self.time:.3g}"
        return *sizes, *where, str(self.measured), str(self.refused)

    @property
    def is_within(self) -> bool:
        """True if derivatives were measured and all errors are within the documented bound."""
        return self.measured > 0 and self.error <= bound_of(self.stratum)


@dataclass(frozen=True, slots=True)
class ColumnsReference:
    """True derivatives of a sample's states, with the norms by which errors are divided.

    columns (N, 6, 10), lengths (N, 10).
    """

    sample: Sample
    columns: np.ndarray
    lengths: np.ndarray

    @classmethod
    def of(cls, sample: Sample, digits: int = DIGITS) -> "ColumnsReference":
        """Compute a sample's true derivatives and their norms by enclosures."""
        found = enclosed(sample, digits)
        lengths, times = _lengths(found), np.array(sample.times)
        early = EARLY / (math.hypot(*map(float, sample.omega0)) or 1.0)
        ends = _lengths(enclosed(replace(sample, times=(-early, early)), digits))[:, MOMENTS]
        first = np.minimum(np.where(times[:, None] < 0, *ends), 1.0)
        least = np.where(np.abs(times)[:, None] < early, first, LEAST)
        lengths[:, MOMENTS] = np.maximum(lengths[:, MOMENTS], least)
        return cls(sample, found, lengths)


def share(engine: Engine, reference: ColumnsReference) -> float:
    """Return the largest ratio of error to bound of an engine's derivatives in a case.

    It is infinite where a column is missing.
    """
    found = of_engine(engine)(reference.sample)
    wrong = errors(found, reference.columns, reference.lengths)
    # Where one column leaves binary64, a module has no numbers for the others.
    asked = (reference.lengths < LARGEST).all(axis=1, keepdims=True)
    if np.any(asked & np.isnan(wrong)):
        return math.inf
    return float(np.nanmax(wrong, initial=0.0)) / bound_of(reference.sample.stratum)


def references(
    cases: int = CASES, seed: int = SEED, strata: Collection[str] = ()
) -> dict[str, list[ColumnsReference]]:
    """Compute the true derivatives in the first cases of each stratum."""
    found: dict[str, list[ColumnsReference]] = {}
    for sample in samples(cases, seed):
        if not strata or sample.stratum in strata:
            found.setdefault(sample.stratum, []).append(ColumnsReference.of(sample))
    return found


def by_stratum(
    sensitive: Sensitive, truth: Mapping[str, Iterable[ColumnsReference]]
) -> Iterator[StratumErrors]:
    """Yield the largest error of an implementation's derivatives in each stratum.

    sensitive: returns the columns (N, 6, 10) of a sample as `columns` does, NaN for none.
    """
    for stratum, listed in truth.items():
        cases = list(listed)
        wrong = [errors(sensitive(x.sample), x.columns, x.lengths) for x in cases]
        measured = sum(int(np.sum(~np.isnan(x))) for x in wrong)
        refused = sum(int(np.sum(np.isnan(x).all(axis=1))) for x in wrong)
        worst = 0.0, 0, COLUMNS[0], 0.0
        for case, found in zip(cases, wrong, strict=True):
            if (error := float(np.nanmax(found, initial=0.0))) > worst[0]:
                at, k = np.unravel_index(np.nanargmax(found), found.shape)
                worst = error, case.sample.index, COLUMNS[k], case.sample.times[at]
        yield StratumErrors(stratum, *worst, measured, refused)


def errors(
    found: np.ndarray, expected: np.ndarray, lengths: np.ndarray | None = None
) -> np.ndarray:
    """Return the relative errors of the columns of derivatives.

    For columns (N, 6, 10) they are (N, 10), NaN where there are no numbers.  Lengths are by default
    those of the expected columns.  Infinite numbers have infinite errors.
    """
    lengths = _lengths(expected) if lengths is None else lengths
    with np.errstate(all="ignore"):
        wrong = np.linalg.norm(found - expected, axis=1) / lengths
    given = ~np.isnan(found).any(axis=1)
    return np.where((lengths < LARGEST) & given, np.where(np.isnan(wrong), np.inf, wrong), np.nan)


def _lengths(expected: np.ndarray) -> np.ndarray:
    """Return the Euclidean norm of each column of derivatives.

    For columns (N, 6, 10) they are (N, 10), and at least LEAST.
    """
    with np.errstate(all="ignore"):
        return np.maximum(np.linalg.norm(expected, axis=1), LEAST)


def enclosed(sample: Sample, digits: int = DIGITS) -> np.ndarray:
    """Compute the true derivatives of a sample's states by enclosures.

    The columns have the shape (N, 6, 10).
    """
    motion, times, found = precise_motion(sample), list(map(Fraction, sample.times)), np.empty(0)
    # Short columns once more, to digits of LEAST.
    for more in (0, -math.floor(math.log10(LEAST))):
        balls = motion.sensitivities(times, column_digits(sample, digits + more))
        rows = np.array([[float(x) for x in row[7:]] for row in balls])
        blocks = np.split(rows, [27, 54, 57], axis=-1)
        turns, rates = (x.reshape(-1, 3, 9) for x in blocks[:2])
        found = columns(sample, turns, rates, *blocks[2:])
        if _lengths(found).min(initial=1.0) >= _SHORT:
            break
    return found


def columns(
    sample: Sample,
    attitude: np.ndarray,
    rates: np.ndarray,
    attitude_t: np.ndarray,
    rates_t: np.ndarray,
) -> np.ndarray:
    """Combine derivatives into one column per input, scaled by the size of that input.

    The columns have the shape (N, 6, 10). attitude and rates: sensitivities (N, 3, 9); attitude_t
    and rates_t: those by time (N, 3).
    """
    rate = math.hypot(*map(float, sample.omega0)) or 1.0
    units = np.array([*[1.0] * 3, *[rate] * 3, *map(float, sample.inertia), 1 / rate])
    with np.errstate(all="ignore"):
        rows = [
            np.concatenate([attitude, attitude_t[..., None]], axis=-1),
            np.concatenate([rates, rates_t[..., None]], axis=-1) / rate,
        ]
        return np.concatenate(rows, axis=-2) * units


def of_engine(engine: Engine | Solver) -> Sensitive:
    """Return a function that computes a sample's derivatives by an engine.

    Raises EngineError for a module that has none.
    """
    if not isinstance(engine, Engine) or not engine.has_sensitivities:
        raise EngineError("engine", "its module has no sensitivities")

    def found(sample: Sample) -> np.ndarray:
        prepared, _ = prepare(sample, engine)
        numbers = engine.sensitivities(prepared, np.array(sample.times), errors="nan")
        if not sample.in_doubles:
            by_exact_moments(numbers, sample.exact[0])
        return columns(sample, *numbers[2:])

    return found
