"""Measurement of the solution's forms by time, operations, size and error.

Motions are near the separatrix.  Errors are measured in every stratum, too.  Times are medians of
repetitions on this machine, and only their ratios mean anything: in C where a form is generated,
and in NumPy for all three.
"""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from fractions import Fraction
from statistics import median
from timeit import repeat

import numpy as np

from rigidsym import _engines as engines
from rigidsym._codegen.forms import PI, THETA, key
from rigidsym._codegen.functions import functions
from rigidsym._codegen.functions.fourier import state
from rigidsym._codegen.generate import generate
from rigidsym._codegen.ir import Function
from rigidsym._codegen.lines import flat_results
from rigidsym.errors import InputError
from rigidsym.language._expression import Call, Expression, Operation, children
from rigidsym.precise._motion import PreciseMotion
from rigidsym.solution import sealed
from rigidsym.validate._bounds import ULP
from rigidsym.validate._forms import fourier
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import enclose
from rigidsym.validate.peers._protocol import Solver
from rigidsym.validate.strata import STRATA, count, draw
from rigidsym.view._plots.charts import Panel, panels_svg
from rigidsym.view._tables import table

FOURIER = "Fourier"
SCHEMA = "rigidsym.forms/1"
# The rate about the third axis, off the separatrix of this body by these parts of itself.
INERTIA, RATES, ATTITUDE = (1.0, 2.0, 2.25), (0.75, 0.5, 1.0), (0.5, 0.5, -0.5, 0.5)
AWAY = (16.0, 4.0, 1.0, 0.1, 1e-2, 1e-4, 1e-8, 1e-12)
_TIMES, _CHECKED, _REPEATS, _DIGITS, _SPAN = 4096, 24, 7, 25, 100.0
# Cases of each stratum, and how they are drawn and enclosed.
CASES, _SEED, _STRATUM_DIGITS = 8, 0, 40
# The parts of a state: what changes with time, and what is made of it.
PARTS = ("angles", "state")
# A sum of Clenshaw's recurrence takes a product and two sums a term; there are four series.
_A_TERM, _SERIES = 3, 4


@dataclass(frozen=True, slots=True)
class FormCost:
    """Cost of one form of the solution for one motion.

    Numbers that do not exist are None.  plan_us: time of the plan in C, of Fourier series by
    mpmath.
    """

    form: str
    away: float
    parameter: float
    terms: int | None
    operations: int | None
    constant_bytes: int | None
    plan_us: float | None
    numpy_ns: float | None
    c_ns: float | None
    angle: float | None
    omega: float | None

    def row(self) -> tuple[str, ...]:
        """Return the costs as a row of a table.

        The columns are those of `COLUMNS`.
        """
        numbers = _shown((self.operations, self.constant_bytes, self.terms), "d")
        times = _shown((self.plan_us, self.c_ns, self.numpy_ns), ".3g")
        errors = _shown((self.angle, self.omega), ".1e")
        first = f"{self.away:g}", f"{self.parameter:.6g}", self.form
        return *first, *numbers, *times, *errors


COLUMNS = (
    *("away", "k1^2", "form", "operations", "constants, bytes", "terms"),
    *("plan, us", "C, ns", "NumPy, ns", "angle, rad", "rates"),
)


@dataclass(frozen=True, slots=True)
class StratumError:
    """Worst errors of one form of the solution in a stratum.

    served: the number of cases that the form can compute.  angle: rad.  omega: over |omega|. None
    where it serves no case.
    """

    stratum: str
    form: str
    served: int
    cases: int
    angle: float | None
    omega: float | None

    def row(self) -> tuple[str, ...]:
        """Return the errors as a row of a table.

        The columns are those of `STRATA_COLUMNS`.
        """
        served = f"{self.served} of {self.cases}"
        return self.stratum, self.form, served, *_shown((self.angle, self.omega), ".1e")


def _shown(figures: Iterable[float | None], spec: str) -> list[str]:
    """Format numbers, with an empty string for None."""
    return ["" if x is None else format(x, spec) for x in figures]


STRATA_COLUMNS = ("stratum", "form", "served", "angle, rad", "rates")


@dataclass(frozen=True, slots=True)
class FormCosts:
    """Results of the comparison of the solution's forms.

    They are costs by form and motion, sizes of the generated C, and errors by stratum.
    """

    code_bytes: dict[str, int]
    costs: tuple[FormCost, ...]
    strata: tuple[StratumError, ...]

    @property
    def conclusion(self) -> str:
        """A sentence that recommends one form of the solution."""
        c_ns = {(x.form, x.away): x.c_ns for x in self.costs if x.c_ns is not None}
        ratio = [c_ns[PI, away] / c_ns[THETA, away] for form, away in c_ns if form == PI]
        last = [one for one in self.costs if one.form == FOURIER and one.terms]
        most = max(last, key=lambda one: one.terms or 0)
        return (
            "Fly the theta form: a state of the Pi form takes "
            f"{min(ratio):.1f} to {max(ratio):.1f} times as long in C, and Fourier series, "
            f"{min(one.terms or 0 for one in last)} terms far from the separatrix, need "
            f"{most.terms} at k1^2 = {most.parameter:.6g} and more without end."
        )

    def to_json(self) -> str:
        """Return the results as JSON.

        The schema is rigidsym.forms/1.
        """
        return json.dumps({"schema": SCHEMA, **asdict(self)}, indent=1) + "\n"

    def to_markdown(self) -> str:
        """Return the tables of costs and errors as Markdown."""
        costs = table(COLUMNS, [one.row() for one in self.costs])
        errors = table(STRATA_COLUMNS, [one.row() for one in self.strata])
        sizes = ", ".join(f"{form} {size}" for form, size in self.code_bytes.items())
        parts = (*costs, "", f"Bytes of C: {sizes}.", "", *errors, "", self.conclusion, "")
        return "\n".join(parts)

    def to_svg(self) -> str:
        """Plot time, operations and errors as SVG.

        They are drawn against the distance from the separatrix, and by stratum.
        """
        drawn: list[tuple[str, str, Callable[[FormCost], float | None]]] = [
            ("A state in NumPy", "ns", lambda one: one.numpy_ns),
            ("Operations of a state", "number", lambda one: one.operations),
            ("Worst angle", "rad", lambda one: one.angle),
        ]
        forms, panels = (THETA, PI, FOURIER), []
        for title, label, value in drawn:
            found = {(one.form, one.away): value(one) for one in self.costs}
            xs = sorted({away for _, away in found})
            lines = {form: [found[form, x] for x in xs] for form in forms}
            where = "distance from the separatrix"
            panels.append(Panel(title, where, label, xs, lines, log=True, marked=True))
        by_form = ((form, [x.angle for x in self.strata if x.form == form]) for form in forms)
        lines = {form: [None if x is None else x / ULP for x in y] for form, y in by_form}
        numbers = [float(k) for k in range(1, len(lines[THETA]) + 1)]
        title, where = "Worst angle by stratum", "stratum, as in the table"
        panels.append(Panel(title, where, "2^-53 rad", numbers, lines, marked=True))
        return panels_svg(panels)


def compare_forms(
    progress: Callable[[int, int], None] = lambda done, total: None, cases: int = CASES
) -> FormCosts:
    """Measure the costs and errors of all forms of the solution.

    Without a C compiler, the numbers for C are None.
    """
    costs = []
    for motion in map(_Motion.off, AWAY):
        costs += [_generated(form, motion) for form in (THETA, PI)]
        costs.append(_fourier(motion))
    sizes = {form: code_bytes(form) for form in (THETA, PI)}
    forms = {form: engines.exactly(key("numpy", form)) for form in (THETA, PI)}
    every: dict[str, engines.Engine | Solver] = {**forms, FOURIER: fourier.Series()}
    errors: list[StratumError] = []
    for done, stratum in enumerate(STRATA):
        progress(done, len(STRATA))
        drawn = [draw(stratum, index, _SEED) for index in range(count(stratum, cases))]
        references = [enclose(sample, _STRATUM_DIGITS, with_condition=False) for sample in drawn]
        for name, form in every.items():
            measured = [measure(reference, form) for reference in references]
            worst = [[np.max(each[x].values) for x in ("angle", "omega")] for each in measured]
            # Errors of a case that a form refuses are infinite.
            served = [pair for pair in worst if np.isfinite(pair).all()]
            most = [float(max(values)) for values in zip(*served, strict=True)] or [None, None]
            errors.append(StratumError(stratum, name, len(served), len(drawn), *most))
    progress(len(STRATA), len(STRATA))
    return FormCosts(sizes, tuple(costs), tuple(errors))


@dataclass(frozen=True, slots=True)
class _Motion:
    """Motion near the separatrix, with its true states at several times."""

    away: float
    precise: PreciseMotion
    parameter: float
    given: tuple[np.ndarray, ...]
    times: np.ndarray
    true: engines.States

    @classmethod
    def off(cls, away: float) -> "_Motion":
        given = INERTIA, (*RATES[:2], RATES[2] * (1 + away)), ATTITUDE
        inertia, omega0, attitude0 = (tuple(map(Fraction, values)) for values in given)
        precise = PreciseMotion(inertia, omega0, attitude0)
        modulus = float(precise.constants(("k_1",), _DIGITS)["k_1"])
        times = np.linspace(-_SPAN, _SPAN, _CHECKED)
        states = list(precise.states([Fraction(t) for t in times], _DIGITS))
        q, omega = (np.array([[float(x) for x in row[k]] for row in states]) for k in range(2))
        return cls(away, precise, modulus**2, tuple(map(np.array, given)), times, (q, omega))

    @property
    def branch(self) -> str:
        """The branch of a generated module that computes this motion."""
        return "circular" if self.parameter <= 0.5 else "hyperbolic"


def _generated(form: str, motion: _Motion) -> FormCost:
    numpy = engines.exactly(key("numpy", form))
    prepared = numpy.prepare(*motion.given)
    in_c: tuple[float | None, float | None] = (None, None)
    try:
        fast = engines.exactly(key("c", form))
    except InputError:
        fast = None
    if fast:
        kept = fast.prepare(*motion.given)
        in_c = 1e6 * _seconds(lambda: fast.prepare(*motion.given)), _a_state(fast, kept)
    angle, omega = _errors(numpy.states(prepared, motion.times), motion.true)
    return FormCost(
        form=form,
        away=motion.away,
        parameter=motion.parameter,
        terms=None,
        operations=operations(form, motion.branch),
        constant_bytes=constant_bytes(form, motion.branch),
        plan_us=in_c[0],
        numpy_ns=_a_state(numpy, prepared),
        c_ns=in_c[1],
        angle=angle,
        omega=omega,
    )


def _fourier(motion: _Motion) -> FormCost:
    series = fourier.plan(motion.precise)
    if series is None:
        return FormCost(FOURIER, motion.away, motion.parameter, *[None] * 8)
    angle, omega = _errors(series.states(motion.times), motion.true)
    # Apart from its series, a state takes the sines of two angles and the ledger's formulas.
    others = 2 * operations(PI, "steady", ["angles"])
    others += sum(_operations(let.expression, {}) for let in state(sealed()).lets)
    numbers = _SERIES * series.terms + len(series.constants) + len(series.v) + len(series.psi)
    return FormCost(
        form=FOURIER,
        away=motion.away,
        parameter=motion.parameter,
        terms=series.terms,
        operations=others + _A_TERM * _SERIES * series.terms,
        constant_bytes=8 * numbers,
        plan_us=1e6 * _seconds(lambda: fourier.plan(PreciseMotion(*motion.precise.exact))),
        numpy_ns=_a_state(fourier.Series(), series),
        c_ns=None,
        angle=angle,
        omega=omega,
    )


def _errors(found: engines.States, true: engines.States) -> tuple[float, float]:
    """Return the largest errors of the attitude, rad, and of the rates, relative."""
    angle = 2 * np.linalg.norm(found[0] - true[0], axis=-1)
    rate = np.linalg.norm(found[1] - true[1], axis=-1) / np.linalg.norm(true[1], axis=-1)
    return float(np.max(angle)), float(np.max(rate))


def _a_state(engine: "engines.Engine | fourier.Series", prepared: engines.Prepared) -> float:
    """Measure an engine's time per state in nanoseconds, for many states at once."""
    times = np.linspace(0.0, _SPAN, _TIMES)
    return 1e9 * _seconds(lambda: engine.states(prepared, times)) / _TIMES


def _seconds(run: Callable[[], object]) -> float:
    """Return the median run time of a function in seconds, after one run to warm up."""
    return median(repeat(run, number=1, repeat=_REPEATS + 1)[1:])


def operations(form: str, branch: str, parts: Sequence[str] = PARTS) -> int:
    """Count the arithmetic operations per state on one branch of a generated module.

    These are sums, products, quotients, roots and exponentials.
    """
    known = {function.name: function for function in functions(sealed(), form)}
    lets = (let for part in parts for let in known[f"_{branch}_{part}"].lets)
    return sum(_operations(let.expression, known) for let in lets)


def _operations(expression: Expression, known: Mapping[str, Function]) -> int:
    """Count the operations of an expression and of the generated functions that it calls."""
    found = sum(_operations(part, known) for part in children(expression))
    match expression:
        case Operation() | Call("sqrt" | "exp", _):
            found += 1
        case Call(name, _) if name in known:
            found += sum(_operations(let.expression, known) for let in known[name].lets)
    return found


def constant_bytes(form: str, branch: str) -> int:
    """Return the size of a prepared motion's constants in bytes."""
    by_name = {function.name: function for function in functions(sealed(), form)}
    return 8 * len(flat_results(by_name[f"_{branch}_constants"]))


def code_bytes(form: str) -> int:
    """Return the size of a form's generated C source in bytes.

    The header file does not count.
    """
    files = generate("c", form=form).files
    return sum(len(text.encode()) for name, text in files.items() if name.endswith(".c"))
