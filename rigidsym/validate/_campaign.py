"""Validation campaigns, which give the same results on every executor.

Cases are measured in chunks.  A campaign may be saved in a file, from which it is resumed.
"""

import hashlib
import json
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field, fields
from itertools import islice
from pathlib import Path
from typing import Any

from rigidsym import _inputs as inputs
from rigidsym._codegen.forms import STEP, split
from rigidsym._version import __version__
from rigidsym.errors import InputError, unknown
from rigidsym.io._files import write_text
from rigidsym.validate._executors import Place
from rigidsym.validate._finding import Asked, measure_case
from rigidsym.validate._implementations import PEER, check_target, digest, own_peer
from rigidsym.validate._oracle import disagreement, is_due, precise_motion
from rigidsym.validate._tally import Cell, Tally
from rigidsym.validate.peers import PEERS
from rigidsym.validate.strata import STRATA, count, draw
from rigidsym.view import _report_data as report_data

CASES, DIGITS, SEED = 15, 40, 1
# Oracles have to be finer than doubles by far.
LEAST_DIGITS, MOST_DIGITS = 20, 1000
# Cases in a chunk: enough to be worth sending, few enough to be lost.
CHUNK = 50
# The keys of the second oracle's results.
ORACLES, DISAGREEMENT = "oracles", "disagreement"
# The file of an unfinished campaign.
NAME, SCHEMA = "campaign.json", "rigidsym.campaign/2"
# Seconds of work that are lost at most when a machine is switched off.
INTERVAL = 10.0

# A stratum, and the cases from one index to before another.
Chunk = tuple[str, int, int]


@dataclass(frozen=True, slots=True)
class Campaign:
    """Settings of a validation campaign.

    Equal settings give equal results.
    """

    targets: tuple[str, ...]
    peers: tuple[str, ...]
    strata: tuple[str, ...]
    cases: int
    digits: int
    seed: int
    digests: tuple[str, ...]
    peer_versions: tuple[str, ...]
    version: str = __version__

    @classmethod
    def of(
        cls,
        targets: Sequence[str],
        cases: int = CASES,
        digits: int = DIGITS,
        seed: int = SEED,
        peers: Sequence[str] = (),
        strata: Sequence[str] = (),
    ) -> "Campaign":
        """Create a campaign from checked settings.

        Raises InputError for missing targets or peers.
        """
        targets, peers, strata = (
            (names,) if isinstance(names, str) else names for names in (targets, peers, strata)
        )
        for target in targets:
            check_target(target)
        for name in strata:
            if name not in STRATA:
                raise unknown("stratum", name, STRATA, plain=True)
        if not LEAST_DIGITS <= inputs.digits(digits) <= MOST_DIGITS:
            rule = f"must be at least {LEAST_DIGITS} and at most {MOST_DIGITS} for a validation"
            raise InputError("digits", digits, rule)
        if not isinstance(cases, int) or cases < 1:
            raise InputError("cases", repr(cases), "must be a whole number, at least 1")
        listed = tuple(dict.fromkeys(targets))
        wanted = tuple(name for name in STRATA if name in strata or not strata)
        others = tuple(dict.fromkeys(peers))
        versions = tuple(map(digest, listed)), _versions(others)
        return cls(listed, others, wanted, cases, digits, seed, *versions)

    @property
    def implementations(self) -> tuple[str, ...]:
        """The names of the measured implementations, which are targets and peers.

        Peers come last and have PEER as a prefix.
        """
        return (*self.targets, *(PEER + name for name in self.peers))

    @property
    def user_integrator(self) -> str | None:
        """The name of the user's integrator that is measured, or None.

        The name means nothing in other processes.
        """
        return next((name for name in self.peers if name not in PEERS), None)

    @property
    def judged(self) -> tuple[str, ...]:
        """The implementations that have to keep the error bounds.

        Errors of peers are only reported.
        """
        user = self.user_integrator
        return (*self.targets, PEER + user) if user else self.targets

    @property
    def size(self) -> int:
        """The total number of cases in the campaign."""
        return sum(count(stratum, self.cases) for stratum in self.strata)

    def to_data(self) -> report_data.Data:
        """Return the settings of the campaign as plain data."""
        values = ((x.name, getattr(self, x.name)) for x in fields(self))
        data: Any = {name: list(x) if isinstance(x, tuple) else x for name, x in values}
        return data

    @classmethod
    def from_data(cls, data: report_data.Data) -> "Campaign":
        """Create a campaign from the data that `to_data` returns."""
        values: Any = {name: tuple(x) if isinstance(x, list) else x for name, x in data.items()}
        return cls(**values)


@dataclass(slots=True)
class Progress:
    """Results of an unfinished validation campaign.

    These are a tally, and the ranges of finished cases by stratum.  With a directory, they are
    saved in a file there every few seconds, whole or not at all.
    """

    campaign: Campaign
    tally: Tally = field(default_factory=Tally)
    done: dict[str, list[tuple[int, int]]] = field(default_factory=dict)
    directory: Path | None = field(default=None, compare=False)
    _saved: float = field(default_factory=time.monotonic, compare=False)

    @classmethod
    def load(cls, directory: Path) -> "Progress":
        """Load the unfinished campaign that is saved in a directory.

        Raises InputError where there is none, or a damaged one.
        """
        path = directory / NAME
        try:
            data = json.loads(path.read_text("utf-8"))
            seal = {name: data.pop(name) for name in ("schema", "sha256")}
        except FileNotFoundError:
            rule = f"holds no unfinished campaign ({NAME})"
            raise InputError("resume", directory, rule) from None
        except (OSError, ValueError, KeyError, AttributeError, TypeError, RecursionError):
            seal, data = {}, {}
        if not seal or seal != _seal(data):
            raise InputError("resume", path, "is not what a campaign of this version left there")
        done = {name: [(start, stop) for start, stop in x] for name, x in data["done"].items()}
        campaign = Campaign.from_data(data["campaign"])
        return cls(campaign, Tally.from_data(data["tally"]), done, directory)

    def save(self, interval: float = 0.0) -> None:
        """Save the unfinished campaign, at most once in `interval` seconds.

        Raises InputError where that fails, and keeps the old file.
        """
        if self.directory and time.monotonic() - self._saved >= interval:
            tally, campaign = self.tally.to_data(), self.campaign.to_data()
            data = {"campaign": campaign, "done": self.done, "tally": tally}
            text = json.dumps({**_seal(data), **data}, sort_keys=True) + "\n"
            write_text(self.directory / NAME, text)
            self._saved = time.monotonic()

    def remove(self) -> None:
        """Remove the saved file of a finished campaign."""
        if self.directory:
            (self.directory / NAME).unlink(missing_ok=True)

    @property
    def cases(self) -> int:
        """The number of finished cases."""
        return sum(stop - start for ranges in self.done.values() for start, stop in ranges)

    def missing(self) -> Iterator[Chunk]:
        """Yield the chunks of cases that are not measured yet.

        Those of a stratum are missing at the time when the first of them is yielded, whatever is
        counted meanwhile.
        """
        for stratum in self.campaign.strata:
            begin = 0
            end = count(stratum, self.campaign.cases)
            for start, stop in [*self.done.get(stratum, []), (end, end)]:
                for first in range(begin, start, CHUNK):
                    yield stratum, first, min(first + CHUNK, start)
                begin = stop

    def take(self, chunk: Chunk, tally: Tally) -> None:
        """Add the results of a finished chunk of cases.

        If this is interrupted, nothing of it is added.
        """
        stratum, *own = chunk
        merged = self.tally.copy()
        merged.merge(tally)
        ranges: list[tuple[int, int]] = []
        for start, stop in sorted([*self.done.get(stratum, []), (own[0], own[1])]):
            # Ranges that touch are joined.
            if ranges and ranges[-1][1] == start:
                start, _ = ranges.pop()
            ranges.append((start, stop))
        done = {**self.done, stratum: ranges}
        # No call is between these two, so that no interrupt is.
        self.tally, self.done = merged, done


def _seal(data: Mapping[str, object]) -> dict[str, str]:
    """Return the schema and the digest to store in a campaign's file."""
    text = json.dumps(data, sort_keys=True)
    return {"schema": SCHEMA, "sha256": hashlib.sha256(text.encode()).hexdigest()}


def check_together(targets: Sequence[str]) -> None:
    """Raise InputError for targets that are not measured on the same samples."""
    if len({split(target)[1] == STEP for target in targets}) > 1:
        rule = "steps are measured within a turn: validate modules of steps in another call"
        raise InputError("target", ", ".join(targets), rule)


def complete(progress: Progress, place: Place, after: Callable[[], None] = lambda: None) -> None:
    """Measure the missing cases of a campaign, in chunks.

    after: is called whenever more cases are done.  Whatever stops it, `progress` is whole: each
    case is in it once or not at all.
    """
    chunks = progress.missing()
    pending: set[Future[tuple[Chunk, Tally]]] = set()
    try:
        while True:
            for chunk in islice(chunks, place.ahead - len(pending)):
                pending.add(place.submit(tallied, progress.campaign, chunk))
            if not pending:
                return
            finished, pending = wait(pending, return_when=FIRST_COMPLETED)
            for future in finished:
                progress.take(*future.result())
            after()
    finally:
        for future in pending:
            future.cancel()


def tallied(campaign: Campaign, chunk: Chunk) -> tuple[Chunk, Tally]:
    """Measure the cases of a chunk, and return a tally of their errors.

    Raises InputError if other modules are installed than the campaign measures.
    """
    installed = {
        "version": (__version__, campaign.version),
        "digests": (tuple(map(digest, campaign.targets)), campaign.digests),
        "peer_versions": (_versions(campaign.peers), campaign.peer_versions),
    }
    for name, (found, wanted) in installed.items():
        if found != wanted:
            raise InputError(name, found, f"a worker has others than the campaign, {wanted}")
    stratum, start, stop = chunk
    tally = Tally()
    for index in range(start, stop):
        add_case(tally, campaign, stratum, index, campaign.implementations)
    return chunk, tally


def add_case(
    tally: Tally, campaign: Campaign, stratum: str, index: int, implementations: Asked
) -> None:
    """Measure one case, and add its errors to a tally."""
    sample = draw(stratum, index, campaign.seed)
    finding = measure_case(sample, campaign.digits, implementations)
    tally.count(finding.reference)
    for name, errors in finding.errors.items():
        tally.add(name, finding.reference, errors)
    if is_due(index):
        found = disagreement(precise_motion(sample), backwards=index % 2 == 1)
        cell = Cell(1, found, (stratum, index, 0.0), 1.0)
        tally.put((ORACLES, DISAGREEMENT, "stratum", stratum), cell)


def _versions(peers: Sequence[str]) -> tuple[str, ...]:
    return tuple(own_peer(name).version for name in peers)
