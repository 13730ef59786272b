"""Comparison of cost and accuracy of all methods of precise evaluation.

Methods are compared by the number of digits and by the distance from the separatrix.

Seconds are medians: of a motion's set-up with its first state, and of one more state.  The error
is an upper bound for the seven midpoints, by balls of a reference method to more digits.  The
radius is the largest of the seven.
"""

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from fractions import Fraction
from statistics import median
from time import perf_counter

from flint import arb
from mpmath import mp

from rigidsym import _inputs as inputs
from rigidsym.errors import InputError
from rigidsym.io.cases import Case
from rigidsym.precise._balls import bits_of, of_mpf, to_mpf, working
from rigidsym.precise._motion import ESTIMATED, METHODS, PreciseMotion
from rigidsym.precise._regime import ExactInputs
from rigidsym.precise._taylor import integrate
from rigidsym.view._plots.charts import Panel, panels_svg

SCHEMA = "rigidsym.methods/1"
NAMES = (*METHODS, *ESTIMATED, "taylor")
DIGITS = (15, 50, 200, 1000)
DISTANCES = ("1e-1", "1e-3", "1e-6", "1e-9", "1e-12", "1e-30", "0")
DISTANCE_DIGITS = 50
REFERENCE, MORE_DIGITS = "carlson", 30
REPEATS, ENOUGH_SECONDS = 5, 0.5
SECOND_TIME = Fraction(5, 7)
# Beyond these a method takes more than a few seconds.
QUADRATURE_DIGITS = 1000
TAYLOR_WORK = 50_000  # digits^2 times radians

Numbers = list[arb]


@dataclass(frozen=True, slots=True)
class Measurement:
    """The time that one method took for a state, and its error.

    Numbers are None where the method was not run.
    """

    method: str
    digits: int
    distance: str | None = None
    seconds: float | None = None
    seconds_more: float | None = None
    error: str | None = None
    radius: str | None = None

    @property
    def cost(self) -> float | None:
        """Return the time in seconds for one more state."""
        return self.seconds_more or self.seconds

    @property
    def units(self) -> float | None:
        """Return the error in units of the last digit.

        Return None for no error.
        """
        return float(mp.mpf(self.error or 0) * mp.mpf(10) ** self.digits) or None

    def row(self, place: str) -> tuple[str, ...]:
        """Return the measurement as a table row, with `place` as its first cell."""
        if self.seconds is None:
            return place, self.method, "not run", "", "", ""
        first, more = (f"{1000 * (x or 0):.2f} ms" for x in (self.seconds, self.cost))
        return place, self.method, first, more, self.error or "", self.radius or "none"


@dataclass(frozen=True, slots=True)
class Comparison:
    """Times and errors of all methods, by digits and by distance from the separatrix.

    There are none by distance for a body without a separatrix.
    """

    motion: dict[str, list[str]]
    neighbour: dict[str, list[str]] | None
    time: str
    by_digits: tuple[Measurement, ...]
    by_distance: tuple[Measurement, ...]

    @property
    def conclusion(self) -> str:
        """A sentence that names the quickest method at each number of digits."""
        measured = [m for m in self.by_digits if m.seconds is not None]
        each = []
        for digits in dict.fromkeys(m.digits for m in measured):
            best = min((m for m in measured if m.digits == digits), key=lambda m: m.cost or 0.0)
            each.append(f"{best.method} at {digits} ({1000 * (best.cost or 0):.2f} ms)")
        return f"The cheapest for one more state, by digits: {', '.join(each)}."

    def to_json(self) -> str:
        """Return the comparison as JSON in the schema rigidsym.methods/1."""
        return json.dumps({"schema": SCHEMA, **asdict(self)}, indent=1) + "\n"

    def to_svg(self) -> str:
        """Return plots of times and errors as SVG.

        They are against digits and distances from the separatrix.
        """
        near = [m for m in self.by_distance if m.distance != "0"]
        where = f"near the separatrix, {DISTANCE_DIGITS} digits"
        panels = []
        for part, x_label, measured in (
            ("by digits", "digits", self.by_digits),
            (where, "distance from the separatrix", near),
        ):
            xs = sorted({float(m.distance or m.digits) for m in measured})
            for title, y_label, name in (
                ("Cost of one more state", "seconds", "cost"),
                ("Error", "units of 10^-digits", "units"),
            ):
                found = {
                    (m.method, float(m.distance or m.digits)): getattr(m, name) for m in measured
                }
                lines = {method: [found[method, x] for x in xs] for method in NAMES}
                if any(map(any, lines.values())):
                    head = f"{title}, {part}"
                    panels.append(Panel(head, x_label, y_label, xs, lines, log=True, marked=True))
        return panels_svg(panels)


def compare(
    case: Case,
    digits: Sequence[int] = DIGITS,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Comparison:
    """Compare all methods of precise evaluation on the motion of a case.

    The state is that at the last time.  Motions near a separatrix are computed as well.

    Raises InputError for uncertain numbers and where there is no time.
    """
    if not case.times:
        raise InputError("times", "[]", "a comparison needs at least one time")
    exact, time = case.motion.exact, case.times[-1]
    given = exact["inertia"], exact["omega0"], exact["attitude0"]
    family = _family(*given)
    tasks = [(given, inputs.digits(d), None) for d in sorted(set(digits))]
    tasks += [(motion, DISTANCE_DIGITS, distance) for distance, motion in family]
    measured: list[list[Measurement]] = []
    for motion, count, distance in tasks:
        measured.append(list(_measure(motion, time, count, distance)))
        progress(len(measured), len(tasks))
    return Comparison(
        _shown(given),
        _shown(family[-1][1]) if family else None,
        _exactly(time),
        tuple(m for group in measured for m in group if m.distance is None),
        tuple(m for group in measured for m in group if m.distance is not None),
    )


def _measure(
    motion: ExactInputs, time: Fraction, digits: int, distance: str | None
) -> Iterator[Measurement]:
    reference = next(_states(REFERENCE, motion, [time], digits + MORE_DIGITS))
    times = [time, time * SECOND_TIME]
    for method in NAMES:
        work = digits**2 * abs(time) * max(map(abs, motion[1]))
        quick = {"taylor": work <= TAYLOR_WORK, "quadrature": digits <= QUADRATURE_DIGITS}
        if not (quick.get(method, True) and _serves(method, motion)):
            yield Measurement(method, digits, distance)
            continue
        seconds, more, found = _timed(lambda m=method: _states(m, motion, times, digits))
        with working(2 * bits_of(digits + MORE_DIGITS)):
            error = max(abs(x.mid() - y).upper() for x, y in zip(found, reference, strict=True))
            radius = _short(max(x.rad() for x in found)) if method in METHODS else None
            yield Measurement(method, digits, distance, seconds, more, _short(error), radius)


def _states(
    method: str, motion: ExactInputs, times: Sequence[Fraction], digits: int
) -> Iterator[Numbers]:
    """Yield the state by one method at each time, as seven balls.

    Balls have no radius by mpmath and by the Taylor series.

    The series have no set-up, so they are summed for the first time only.
    """
    if method == "taylor":
        numbers = [x for part in integrate(*motion, times[0], digits) for x in part]
        yield [of_mpf(x) for x in numbers]
        return
    precise = PreciseMotion(*motion, method)
    if method in ESTIMATED:
        yield from ([of_mpf(x) for x in (*q, *w)] for q, w in precise.states(times, digits))
        return
    yield from ([*q, *w] for q, w in precise.enclosures(times, digits))


def _serves(method: str, motion: ExactInputs) -> bool:
    """Return True if a method can compute motions of this regime."""
    try:
        if method in ESTIMATED:
            PreciseMotion(*motion, method).start(1)
    except InputError:
        return False
    return True


def _timed(states: Callable[[], Iterator[Numbers]]) -> tuple[float, float | None, Numbers]:
    """Measure the median times, in s, to compute a first state and one more state.

    The numbers of the first state are returned as well.
    """
    first: list[float] = []
    more: list[float] = []
    while True:
        start, run = perf_counter(), states()
        found = next(run)
        middle = perf_counter()
        first.append(middle - start)
        if next(run, None):
            more.append(perf_counter() - middle)
        if len(first) == REPEATS or sum(first) > ENOUGH_SECONDS:
            return median(first), median(more) if more else None, found


def _family(
    inertia: Sequence[Fraction], omega0: Sequence[Fraction], attitude0: Sequence[Fraction]
) -> list[tuple[str, ExactInputs]]:
    """Return neighbouring motions at several distances from the separatrix.

    A distance is the relative change of the rate about one axis.

    The separatrix is c_a (c_a - c_b) Omega_a^2 = c_d (c_b - c_d) Omega_d^2, and seldom has
    rational points; it has them once the middle moment c_b is moved in its twelfth digit or so.
    """
    d, b, a = sorted(range(3), key=lambda k: inertia[k])
    c_a, c_b, c_d = inertia[a], inertia[b], inertia[d]
    if not c_d < c_b < c_a or not any(omega0):
        return []
    slope = _root(c_a * (c_a - c_b) / (c_d * (c_b - c_d)))
    moments, rates = list(inertia), list(omega0)
    moments[b] = (c_a**2 + (slope * c_d) ** 2) / (c_a + slope**2 * c_d)
    rates[a] = rates[a] or max(map(abs, omega0))
    on_it = slope * abs(rates[a]) * (-1 if rates[d] < 0 else 1)
    family = []
    for distance in DISTANCES:
        rates[d] = on_it * (1 + Fraction(distance))
        family.append((distance, (tuple(moments), tuple(rates), tuple(attitude0))))
    return family


def _root(value: Fraction) -> Fraction:
    """Return the square root of a rational to about twelve digits."""
    context = Context(prec=12, Emax=MAX_EMAX, Emin=MIN_EMIN)
    return Fraction(context.sqrt(Decimal(inputs.decimal(value, 15))))


def _shown(motion: Sequence[Sequence[Fraction]]) -> dict[str, list[str]]:
    names = ("inertia", "omega0", "attitude0")
    return {name: [_exactly(x) for x in values] for name, values in zip(names, motion, strict=True)}


def _exactly(value: Fraction) -> str:
    """Format a rational number exactly.

    It is a decimal where that is exact and short, else a fraction.
    """
    text = inputs.decimal(value, 17)
    if Fraction(text) == value:
        return text
    return f"{Decimal(value.numerator)}/{Decimal(value.denominator)}"


def _short(value: arb) -> str:
    return mp.nstr(to_mpf(value), 2)
