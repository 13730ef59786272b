"""Plans and transfers as notebooks show them."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from rigidsym.language.statement import listed
from rigidsym.view.html.cards import card, counted, head, math, muted, table
from rigidsym.view.html.markup import tag
from rigidsym.view.html.quantities import INERTIA, MOMENTUM, RATE, decimal, row, vector

_ASKED = (
    ("inertia", r"(c_1, c_2, c_3)", INERTIA),
    ("start", r"R(0)", ""),
    ("target", r"R(T)", ""),
    ("start_spin", r"\Omega(0^-)", RATE),
    ("target_spin", r"\Omega(T^+)", RATE),
)
_LIMITS = (("max_rate", RATE), ("max_burst", MOMENTUM))
_ROUNDING = 1e-12


def plan_html(plan: Any) -> str:
    """What was asked for, then the transfers, the cheapest first."""
    asked = plan.manoeuvre
    title = head("Plan", muted(f"{counted(len(plan.transfers), 'transfer')}, {_duration(asked)}"))
    found = ((f"{k}", *_row(one)) for k, one in enumerate(plan.transfers, 1))
    columns, _ = plan.table()
    return card(title, table((), _asked(asked)), table((*columns, "regime"), found))


def transfer_html(transfer: Any) -> str:
    """The natural motion, its two bursts, what they cost, and by what it misses."""
    title = head("Transfer", muted(transfer.motion.regime), muted(_duration(transfer.manoeuvre)))
    first, last = transfer.bursts
    told = [
        row("omega0", rf"\Omega(0) = {_computed(transfer.omega0)}", RATE),
        row("omega1", rf"\Omega(T) = {_computed(transfer.omega1)}", RATE),
        row("bursts", listed([_computed(first), _computed(last)]), MOMENTUM),
        row("cost", decimal(transfer.cost), MOMENTUM),
        row("energy", f"H = {decimal(transfer.energy)}", r"\mathrm{J}"),
        row("peak_rate", decimal(transfer.peak_rate), RATE),
        row("residual", _below(transfer.residual), r"\mathrm{rad}"),
    ]
    return card(title, table((), told))


def _asked(asked: Any) -> Iterator[tuple[Any, ...]]:
    for field, name, unit in _ASKED:
        values = getattr(asked, field)
        if any(values) or field in ("inertia", "start", "target"):
            yield row(field, f"{name} = {vector(values)}", unit)
    for field, unit in _LIMITS:
        value = getattr(asked.limits, field)
        if value is not None:
            yield row(field, decimal(value), unit)


def _row(one: Any) -> Iterator[Any]:
    yield math(_computed(one.omega0))
    yield from (math(decimal(x)) for x in (one.cost, one.energy, one.peak_rate))
    yield math(_below(one.residual))
    yield tag("span", one.motion.regime, style="white-space:nowrap")


def _computed(values: np.ndarray) -> str:
    """A vector without what is rounding beside its largest component."""
    rounding = _ROUNDING * np.max(np.abs(values))
    return vector(np.where(np.abs(values) > rounding, values, 0.0).tolist())


def _below(value: float) -> str:
    """A power of ten that a residual, which is rounding, does not reach: the same anywhere."""
    bounds = (k for k in (-14, -12) if value < 10.0**k)
    return next((rf"< 10^{{{k}}}" for k in bounds), decimal(value))


def _duration(asked: Any) -> str:
    return f"{float(asked.duration):g} s"
