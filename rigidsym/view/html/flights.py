"""Flights as notebooks show them."""

from typing import Protocol

import numpy as np

from rigidsym.view.html.cards import badge, card, counted, entries, head, muted
from rigidsym.view.html.markup import Markup

Rows = list[tuple[str, str]]


class Run(Protocol):
    """A flight at its samples."""

    @property
    def t(self) -> np.ndarray:
        """(N,), s."""
        ...

    @property
    def arrival(self) -> float:
        """When the target takes the track's place, s."""
        ...


class Motion(Protocol):
    """What is followed."""

    @property
    def regime(self) -> str:
        """The kind of motion."""
        ...


class Natural(Protocol):
    """A track that is a natural motion."""

    @property
    def motion(self) -> Motion:
        """That motion."""
        ...


class Tracked(Protocol):
    """A flight with what it followed."""

    @property
    def run(self) -> Run:
        """What was flown."""
        ...

    @property
    def transfer(self) -> Natural:
        """What was to be followed."""
        ...

    @property
    def missed(self) -> bool:
        """Whether there was time to settle at the target, and it did not."""
        ...


def run_html(run: Run, rows: Rows) -> str:
    """What was measured on a flight, in words."""
    said = muted(f"{run.t[-1]:g} s, {counted(len(run.t), 'sample')}")
    return card(head("Flight", said), _told(rows))


def tracked_html(tracked: Tracked, rows: Rows) -> str:
    """The same with the motion that it follows, and whether it settled at the target."""
    run = tracked.run
    flown = "missed" if tracked.missed else "settled"
    verdict = badge("under way" if run.t[-1] < run.arrival else flown)
    motion = muted(tracked.transfer.motion.regime)
    return card(head("Flight", verdict, motion), _told(rows))


def _told(rows: Rows) -> Markup:
    return entries((muted(name), text) for name, text in rows)
