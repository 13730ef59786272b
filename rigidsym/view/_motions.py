"""Terminal text and notebook cards of motions, cases, manoeuvres, plans and flights."""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym._inputs import Number, Uncertain
from rigidsym.errors import InputError
from rigidsym.language._latex import listed
from rigidsym.view import _cards as cards
from rigidsym.view._cards import Markup, card, counted, head, math, muted
from rigidsym.view._tables import columns

if TYPE_CHECKING:
    from rigidsym.io.cases import Case
    from rigidsym.manoeuvre._manoeuvre import Manoeuvre
    from rigidsym.manoeuvre._planning import Plan
    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.manoeuvre.flight._results import Tracked
    from rigidsym.manoeuvre.flight._run import Run
    from rigidsym.motion import TorqueFreeMotion

# Exact numbers of at most so many characters are written in full.
_SHORT = 24
_IDENTITY = (1, 0, 0, 0)
_ROUNDING = 1e-12
_RATE, _MOMENTUM = r"\mathrm{rad/s}", r"\mathrm{N\,m\,s}"
_INERTIA = r"\mathrm{kg\,m^2}"
_GIVEN, _COMPUTED = 6, 4
"Digits of numbers that a user gave, and of computed ones."


def number(value: Number) -> str:
    """Format a number as Python source, in quotes unless it is a double.

    >>> number(Fraction(0.0109)), number(Fraction("0.0109")), number(Fraction(1, 3))
    ('0.0109', "'0.0109'", "'1/3'")
    """
    if isinstance(value, Uncertain):
        return f"'{value}'"
    if value.denominator == 1 and abs(value) < 10**15:
        return str(value)
    if abs(value) < 2**1000 and Fraction(float(value)) == value:
        return repr(float(value))
    exact = inputs.exact_text(value) if value.denominator < 10**30 else ""
    return repr(exact if 0 < len(exact) <= _SHORT else f"{inputs.decimal(value, 12)}...")


def _vector(values: Iterable[Number]) -> str:
    """Format a vector as Python source."""
    return f"({', '.join(map(number, values))})"


def motion_text(motion: "TorqueFreeMotion") -> str:
    """Return one line of text with the inputs of a motion and its regime."""
    given = f"inertia={_vector(motion.inertia)}, omega0={_vector(motion.omega0)}"
    if tuple(motion.attitude0) != _IDENTITY:
        given += f", attitude0={_vector(motion.attitude0)}"
    return f"<TorqueFreeMotion {given}: {_regime(motion)[0]}>"


def case_text(case: "Case") -> str:
    """Return one line of text with the motion and the times of a case."""
    times = case.times
    ends = f" from {number(times[0])} to {number(times[-1])} s" if times else ""
    return f"<Case of {len(times)} times{ends}: {motion_text(case.motion)}>"


def manoeuvre_text(asked: "Manoeuvre") -> str:
    """Return one line of text with the attitudes and the duration of a manoeuvre."""
    duration = "" if asked.duration is None else f" in {number(asked.duration)} s"
    ends = f"from {_vector(asked.start)} to {_vector(asked.target)}"
    return f"<Manoeuvre {ends}{duration}, inertia={_vector(asked.inertia)}>"


def transfer_text(one: "Transfer") -> str:
    """Return one line of text with the initial rates, cost and errors of a transfer."""
    rates = ", ".join(f"{x:.6g}" for x in _without_rounding(one.omega0))
    return (
        f"<Transfer omega0=({rates}) rad/s, cost {one.cost:.6g} N m s, "
        f"misses by {one.miss} rad, by {one.missed} deg for a burst 1 %, 1 deg off: "
        f"{one.motion.regime}>"
    )


def plan_text(plan: "Plan") -> str:
    """Return a text table of the transfers of a plan, the cheapest first."""
    names, rows = plan.table()
    told = [(*row, one.motion.regime) for row, one in zip(rows, plan.transfers, strict=True)]
    return columns(f"Plan: {plan.title.partition(': ')[2]}", (*names, "regime"), told)


def motion_html(motion: "TorqueFreeMotion") -> str:
    """Return a notebook card with the inputs of a motion and its regime."""
    title = head("Torque-free motion", muted(*_regime(motion)))
    return card(title, cards.table((), _inputs(motion)))


def motion_latex(motion: "TorqueFreeMotion") -> str:
    """Return the inputs of a motion as one line of LaTeX."""
    parts = (
        rf"{name} = {vector(values)}\,{unit}".removesuffix(r"\,")
        for _, name, values, unit in _fields(motion)
    )
    return f"${listed(parts)}$"


def case_html(case: "Case") -> str:
    """Return a notebook card with the motion and the times of a case."""
    times = case.times
    ends = f", {decimal(times[0])} s to {decimal(times[-1])} s" if times else ""
    said = f"{counted(len(times), 'time')}{ends}"
    rows = [*_inputs(case.motion), (muted("times"), said, "")]
    return card(head("Case", muted(*_regime(case.motion))), cards.table((), rows))


def _inputs(motion: "TorqueFreeMotion") -> Iterator[tuple[Markup, ...]]:
    for field, name, values, unit in _fields(motion):
        yield _quantity(field, f"{name} = {vector(values)}", unit)


def _fields(motion: "TorqueFreeMotion") -> Iterator[tuple[str, str, Sequence[Number], str]]:
    """Yield the name, symbol, values and unit of each input of a motion."""
    yield "inertia", "(c_1, c_2, c_3)", motion.inertia, _INERTIA
    yield "omega0", r"\Omega(0)", motion.omega0, _RATE
    yield "attitude0", "R(0)", motion.attitude0, ""


def _regime(motion: "TorqueFreeMotion") -> tuple[str, str]:
    """Return the name of a motion's regime, and the reason if it is not certain."""
    try:
        return str(motion.regime), ""
    except InputError as error:
        return "regime not certain", f": {error}"


def plan_html(plan: "Plan") -> str:
    """Return a notebook card with the transfers of a plan and the manoeuvre they solve.

    The cheapest transfer comes first.
    """
    asked = plan.manoeuvre
    title = head("Plan", muted(f"{counted(len(plan.transfers), 'transfer')}, {_duration(asked)}"))
    rows = (
        (
            f"{k}",
            math(_computed(one.omega0)),
            *(math(decimal(x, _COMPUTED)) for x in (one.cost, one.energy, one.peak_rate)),
            math(_miss(one.miss)),
            muted(one.missed),
            cards.tag("span", one.motion.regime, style="white-space:nowrap"),
        )
        for k, one in enumerate(plan.transfers, 1)
    )
    names, _ = plan.table()
    return card(title, cards.table((), _problem(asked)), cards.table((*names, "regime"), rows))


def transfer_html(transfer: "Transfer") -> str:
    """Return a notebook card with the motion, bursts, cost and errors of a transfer."""
    title = head("Transfer", muted(transfer.motion.regime), muted(_duration(transfer.manoeuvre)))
    rows = [
        _quantity("omega0", rf"\Omega(0) = {_computed(transfer.omega0)}", _RATE),
        _quantity("omega1", rf"\Omega(T) = {_computed(transfer.omega1)}", _RATE),
        _quantity("bursts", listed(map(_computed, transfer.bursts)), _MOMENTUM),
        _quantity("cost", decimal(transfer.cost, _COMPUTED), _MOMENTUM),
        _quantity("energy", f"H = {decimal(transfer.energy, _COMPUTED)}", r"\mathrm{J}"),
        _quantity("peak_rate", decimal(transfer.peak_rate, _COMPUTED), _RATE),
        _quantity("residual", _miss(transfer.miss), r"\mathrm{rad}"),
        (muted("miss for a burst 1 %, 1 deg off (deg)"), muted(transfer.missed)),
    ]
    return card(title, cards.table((), rows))


def _problem(asked: "Manoeuvre") -> Iterator[tuple[Markup, ...]]:
    """Yield table rows with the inputs of a manoeuvre."""
    yield _quantity("inertia", f"(c_1, c_2, c_3) = {vector(asked.inertia)}", _INERTIA)
    yield _quantity("start", f"R(0) = {vector(asked.start)}", "")
    yield _quantity("target", f"R(T) = {vector(asked.target)}", "")
    if any(asked.start_spin):
        yield _quantity("start_spin", rf"\Omega(0^-) = {vector(asked.start_spin)}", _RATE)
    if any(asked.target_spin):
        yield _quantity("target_spin", rf"\Omega(T^+) = {vector(asked.target_spin)}", _RATE)
    if asked.limits.max_rate is not None:
        yield _quantity("max_rate", decimal(asked.limits.max_rate), _RATE)
    if asked.limits.max_burst is not None:
        yield _quantity("max_burst", decimal(asked.limits.max_burst), _MOMENTUM)


def run_html(run: "Run", rows: Sequence[tuple[str, str]]) -> str:
    """Return a notebook card with the measured quantities of a flight."""
    said = muted(f"{run.t[-1]:g} s, {counted(len(run.t), 'sample')}")
    return card(head("Flight", said), cards.entries((muted(name), text) for name, text in rows))


def tracked_html(tracked: "Tracked", rows: Sequence[tuple[str, str]]) -> str:
    """Return a notebook card with the verdict, regime and measured quantities of a flight."""
    run = tracked.run
    flown = "missed" if tracked.missed else "settled"
    verdict = cards.badge("under way" if run.t[-1] < run.arrival else flown)
    title = head("Flight", verdict, muted(tracked.transfer.motion.regime))
    return card(title, cards.entries((muted(name), text) for name, text in rows))


def decimal(value: Number | float, digits: int = _GIVEN) -> str:
    """Format a number to a given number of digits in LaTeX."""
    if isinstance(value, Uncertain):
        return rf"{decimal(value.middle)} \pm {decimal(value.radius)}"
    number, _, exponent = inputs.decimal(Fraction(value), digits).lower().partition("e")
    number = number.rstrip("0").rstrip(".") if "." in number else number
    number = f"{{{number}}}" if value < 0 else number
    return rf"{number} \cdot 10^{{{int(exponent)}}}" if exponent else number


def vector(values: Iterable[Number | float], digits: int = _GIVEN) -> str:
    """Format the components of a vector in LaTeX."""
    inside = r",\ ".join(decimal(value, digits) for value in values)
    return f"({inside})"


def _computed(values: np.ndarray) -> str:
    """Format a computed vector in LaTeX, with zero for components that are rounding errors."""
    return vector(_without_rounding(values).tolist(), _COMPUTED)


def _without_rounding(values: np.ndarray) -> np.ndarray:
    """Set components of a vector that are only rounding errors to zero."""
    return np.where(np.abs(values) > _ROUNDING * np.max(np.abs(values)), values, 0.0)


def _quantity(field: str, latex: str, unit: str) -> tuple[Markup, Markup, Markup]:
    """Return a table row with the name, the value and the unit of a quantity."""
    return muted(field), math(latex), math(unit or r"\,")


def _miss(miss: str) -> str:
    """Format an error such as `2.3e-10`, or a bound such as `< 1e-14`, in LaTeX."""
    mantissa, _, exponent = miss.partition("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}".replace(r"< 1 \cdot", "<")


def _duration(asked: "Manoeuvre") -> str:
    return f"{float(asked.duration or 0):g} s"
