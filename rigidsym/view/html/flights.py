"""Flights as notebooks show them."""

from typing import Any

from rigidsym.view.html.cards import badge, card, counted, head, muted, table
from rigidsym.view.html.markup import Markup

Rows = list[tuple[str, str]]


def run_html(run: Any, rows: Rows) -> str:
    """What was measured on a flight, in words."""
    said = muted(f"{run.t[-1]:g} s, {counted(len(run.t), 'sample')}")
    return card(head("Flight", said), _told(rows))


def tracked_html(tracked: Any, rows: Rows) -> str:
    """The same with the motion that it follows, and whether it settled at the target."""
    run = tracked.run
    flown = "missed" if tracked.missed else "settled"
    verdict = badge("under way" if run.t[-1] < run.arrival else flown)
    motion = muted(tracked.transfer.motion.regime)
    return card(head("Flight", verdict, motion), _told(rows))


def _told(rows: Rows) -> Markup:
    return table((), ((muted(name), text) for name, text in rows))
