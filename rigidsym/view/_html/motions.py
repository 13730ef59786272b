"""Cards of motions, cases, plans, transfers and flights for notebooks."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from rigidsym._inputs import Number
from rigidsym.errors import InputError
from rigidsym.language._latex import listed
from rigidsym.view._html.cards import (
    COMPUTED,
    INERTIA,
    MOMENTUM,
    RATE,
    Markup,
    badge,
    card,
    counted,
    decimal,
    entries,
    head,
    math,
    muted,
    quantity,
    table,
    tag,
    vector,
)

if TYPE_CHECKING:
    from rigidsym.io.cases import Case
    from rigidsym.manoeuvre._manoeuvre import Manoeuvre
    from rigidsym.manoeuvre._planning import Plan
    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.manoeuvre.flight._results import Tracked
    from rigidsym.manoeuvre.flight._run import Run
    from rigidsym.motion import TorqueFreeMotion

_ROUNDING = 1e-12


def motion_html(motion: "TorqueFreeMotion") -> str:
    """Return the inputs of a motion and its regime."""
    return card(head("Torque-free motion", muted(_regime(motion))), table((), _inputs(motion)))


def motion_latex(motion: "TorqueFreeMotion") -> str:
    """Return the inputs of a motion in one line of LaTeX."""
    parts = [
        rf"{name} = {vector(values)}\,{unit}".removesuffix(r"\,")
        for _, name, values, unit in _fields(motion)
    ]
    return f"${listed(parts)}$"


def case_html(case: "Case") -> str:
    """Return the motion of a case, and the number and range of its times."""
    times = case.times
    ends = f", {decimal(times[0])} s to {decimal(times[-1])} s" if times else ""
    said = f"{counted(len(times), 'time')}{ends}"
    rows = [*_inputs(case.motion), (muted("times"), said, "")]
    return card(head("Case", muted(_regime(case.motion))), table((), rows))


def _inputs(motion: "TorqueFreeMotion") -> Iterator[tuple[Markup, ...]]:
    for field, name, values, unit in _fields(motion):
        yield quantity(field, f"{name} = {vector(values)}", unit)


def _fields(motion: "TorqueFreeMotion") -> Iterator[tuple[str, str, Sequence[Number], str]]:
    """Yield the field, name in LaTeX, numbers and unit of each input."""
    yield "inertia", "(c_1, c_2, c_3)", motion.inertia, INERTIA
    yield "omega0", r"\Omega(0)", motion.omega0, RATE
    yield "attitude0", "R(0)", motion.attitude0, ""


def _regime(motion: "TorqueFreeMotion") -> str:
    try:
        return str(motion.regime)
    except InputError as error:
        return f"regime not certain: {error}"


def plan_html(plan: "Plan") -> str:
    """Return the problem of a plan, then its transfers, the cheapest first."""
    asked = plan.manoeuvre
    title = head("Plan", muted(f"{counted(len(plan.transfers), 'transfer')}, {_duration(asked)}"))
    rows = ((f"{k}", *_row(one)) for k, one in enumerate(plan.transfers, 1))
    columns, _ = plan.table()
    return card(title, table((), _problem(asked)), table((*columns, "regime"), rows))


def transfer_html(transfer: "Transfer") -> str:
    """Return the natural motion of a transfer, its two bursts, their cost, and its errors."""
    title = head("Transfer", muted(transfer.motion.regime), muted(_duration(transfer.manoeuvre)))
    first, last = transfer.bursts
    rows = [
        quantity("omega0", rf"\Omega(0) = {_computed(transfer.omega0)}", RATE),
        quantity("omega1", rf"\Omega(T) = {_computed(transfer.omega1)}", RATE),
        quantity("bursts", listed([_computed(first), _computed(last)]), MOMENTUM),
        quantity("cost", decimal(transfer.cost, COMPUTED), MOMENTUM),
        quantity("energy", f"H = {decimal(transfer.energy, COMPUTED)}", r"\mathrm{J}"),
        quantity("peak_rate", decimal(transfer.peak_rate, COMPUTED), RATE),
        quantity("residual", _miss(transfer.miss), r"\mathrm{rad}"),
        (muted("by 1 %, 1 deg of burst (deg)"), muted(transfer.missed)),
    ]
    return card(title, table((), rows))


def _problem(asked: "Manoeuvre") -> Iterator[tuple[Markup, ...]]:
    yield quantity("inertia", f"(c_1, c_2, c_3) = {vector(asked.inertia)}", INERTIA)
    yield quantity("start", f"R(0) = {vector(asked.start)}", "")
    yield quantity("target", f"R(T) = {vector(asked.target)}", "")
    if any(asked.start_spin):
        yield quantity("start_spin", rf"\Omega(0^-) = {vector(asked.start_spin)}", RATE)
    if any(asked.target_spin):
        yield quantity("target_spin", rf"\Omega(T^+) = {vector(asked.target_spin)}", RATE)
    if asked.limits.max_rate is not None:
        yield quantity("max_rate", decimal(asked.limits.max_rate), RATE)
    if asked.limits.max_burst is not None:
        yield quantity("max_burst", decimal(asked.limits.max_burst), MOMENTUM)


def _row(one: "Transfer") -> Iterator[Markup]:
    yield math(_computed(one.omega0))
    yield from (math(decimal(x, COMPUTED)) for x in (one.cost, one.energy, one.peak_rate))
    yield math(_miss(one.miss))
    yield muted(one.missed)
    yield tag("span", one.motion.regime, style="white-space:nowrap")


def _computed(values: np.ndarray) -> str:
    """Return a vector in LaTeX, with zero for components that are rounding errors."""
    rounding = _ROUNDING * np.max(np.abs(values))
    return vector(np.where(np.abs(values) > rounding, values, 0.0).tolist(), COMPUTED)


def _miss(miss: str) -> str:
    """Return `2.3e-10`, or a bound as `< 1e-14`, in LaTeX."""
    mantissa, _, exponent = miss.partition("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}".replace(r"< 1 \cdot", "<")


def _duration(asked: "Manoeuvre") -> str:
    return f"{float(asked.duration or 0):g} s"


def run_html(run: "Run", rows: Sequence[tuple[str, str]]) -> str:
    """Return the measured quantities of a flight, by name."""
    said = muted(f"{run.t[-1]:g} s, {counted(len(run.t), 'sample')}")
    return card(head("Flight", said), entries((muted(name), text) for name, text in rows))


def tracked_html(tracked: "Tracked", rows: Sequence[tuple[str, str]]) -> str:
    """Return a flight with the motion that it follows, and whether it settled at the target."""
    run = tracked.run
    flown = "missed" if tracked.missed else "settled"
    verdict = badge("under way" if run.t[-1] < run.arrival else flown)
    motion = muted(tracked.transfer.motion.regime)
    return card(head("Flight", verdict, motion), entries((muted(x), text) for x, text in rows))
