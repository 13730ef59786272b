"""Campaigns: cases in chunks, on any executor, with one result however they are shared out."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field
from itertools import islice

from rigidsym import inputs
from rigidsym._version import __version__
from rigidsym.errors import InputError
from rigidsym.validate import second_oracle
from rigidsym.validate.executors import Place
from rigidsym.validate.finding import Asked, measure_case
from rigidsym.validate.implementations import PEER, check_kinds, check_target, digest, own_peer
from rigidsym.validate.oracle import precise_motion
from rigidsym.validate.peers import PEERS
from rigidsym.validate.strata import STRATA, count, draw
from rigidsym.validate.tally import Cell, Tally
from rigidsym.view import report_data

CASES, DIGITS, SEED = 15, 40, 1
# Oracles have to be finer than doubles by far.
LEAST_DIGITS, MOST_DIGITS = 20, 1000
# Cases in a chunk: enough to be worth sending, few enough to be lost.
CHUNK = 50
# The keys of what the second oracle has to say.
ORACLES, DISAGREEMENT = "oracles", "disagreement"

# A stratum, and the cases from one index to before another.
Chunk = tuple[str, int, int]


@dataclass(frozen=True, slots=True)
class Campaign:
    """What is measured: two campaigns that are equal have equal results."""

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
        """That of these targets and peers; InputError where one of them cannot be had here."""
        targets, peers, strata = (
            (names,) if isinstance(names, str) else names for names in (targets, peers, strata)
        )
        for target in targets:
            check_target(target)
        check_kinds(targets)
        for name in strata:
            if name not in STRATA:
                raise InputError("stratum", name, f"must be one of: {', '.join(map(repr, STRATA))}")
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
        """Targets, and peers with a word before them."""
        return (*self.targets, *(PEER + name for name in self.peers))

    @property
    def user_integrators(self) -> tuple[str, ...]:
        """Peers that are none of PEERS, which have no name elsewhere."""
        return tuple(name for name in self.peers if name not in PEERS)

    @property
    def judged(self) -> tuple[str, ...]:
        """The implementations that have to keep the bounds; of other peers it is only said."""
        return (*self.targets, *(PEER + name for name in self.user_integrators))

    @property
    def size(self) -> int:
        """How many cases there are."""
        return sum(count(stratum, self.cases) for stratum in self.strata)

    def to_data(self) -> report_data.Campaign:
        """As JSON takes it."""
        return {
            "targets": list(self.targets),
            "peers": list(self.peers),
            "strata": list(self.strata),
            "cases": self.cases,
            "digits": self.digits,
            "seed": self.seed,
            "digests": list(self.digests),
            "peer_versions": list(self.peer_versions),
            "version": self.version,
        }

    @classmethod
    def from_data(cls, data: report_data.Campaign) -> "Campaign":
        """The inverse of `to_data`."""
        return cls(
            tuple(data["targets"]),
            tuple(data["peers"]),
            tuple(data["strata"]),
            data["cases"],
            data["digits"],
            data["seed"],
            tuple(data["digests"]),
            tuple(data["peer_versions"]),
            data["version"],
        )


@dataclass(slots=True)
class Progress:
    """What a campaign has done: a tally, and the ranges of cases that are in it, by stratum."""

    tally: Tally = field(default_factory=Tally)
    done: dict[str, list[tuple[int, int]]] = field(default_factory=dict)

    @property
    def cases(self) -> int:
        """How many cases are done."""
        return sum(stop - start for ranges in self.done.values() for start, stop in ranges)

    def missing(self, campaign: Campaign) -> Iterator[Chunk]:
        """Chunks that are left to do, found one by one: those of a stratum are what is missing of
        it when the first of them is asked for, whatever is taken in meanwhile."""
        for stratum in campaign.strata:
            begin = 0
            end = count(stratum, campaign.cases)
            for start, stop in [*self.done.get(stratum, []), (end, end)]:
                for first in range(begin, start, CHUNK):
                    yield stratum, first, min(first + CHUNK, start)
                begin = stop

    def take(self, chunk: Chunk, tally: Tally) -> None:
        """Count a chunk that was missing, wholly or, if interrupted, not at all."""
        stratum, start, stop = chunk
        merged = self.tally.copy()
        merged.merge(tally)
        ranges = _joined([*self.done.get(stratum, []), (start, stop)])
        done = {**self.done, stratum: ranges}
        # No call is between these two, so that no interrupt is.
        self.tally, self.done = merged, done


def complete(
    campaign: Campaign,
    progress: Progress,
    place: Place,
    after: Callable[[], None] = lambda: None,
) -> None:
    """Do what is missing; `after` is called whenever more is done.

    Whatever stops it, `progress` is whole: each case is in it once or not at all.
    """
    chunks = progress.missing(campaign)
    pending: set[Future[tuple[Chunk, Tally]]] = set()
    try:
        while True:
            for chunk in islice(chunks, place.ahead - len(pending)):
                pending.add(place.submit(tallied, campaign, chunk))
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
    """Measure the cases of a chunk; where other modules are installed there is no result."""
    _check_installed(campaign)
    stratum, start, stop = chunk
    tally = Tally()
    for index in range(start, stop):
        add_case(tally, campaign, stratum, index, campaign.implementations)
    return chunk, tally


def add_case(
    tally: Tally,
    campaign: Campaign,
    stratum: str,
    index: int,
    implementations: Asked,
) -> None:
    """Measure and count one case; implementations as `measure_case` takes them."""
    sample = draw(stratum, index, campaign.seed)
    finding = measure_case(sample, campaign.digits, implementations)
    tally.count(finding.reference)
    for name, errors in finding.errors.items():
        tally.add(name, finding.reference, errors)
    if second_oracle.is_due(index):
        found = second_oracle.disagreement(precise_motion(sample), backwards=index % 2 == 1)
        cell = Cell(1, found, (stratum, index, 0.0), 1.0)
        tally.put((ORACLES, DISAGREEMENT, "stratum", stratum), cell)


def _check_installed(campaign: Campaign) -> None:
    here = {
        "version": (__version__, campaign.version),
        "digests": (tuple(map(digest, campaign.targets)), campaign.digests),
        "peer_versions": (_versions(campaign.peers), campaign.peer_versions),
    }
    for name, (found, wanted) in here.items():
        if found != wanted:
            raise InputError(name, found, f"a worker has others than the campaign, {wanted}")


def _versions(peers: Sequence[str]) -> tuple[str, ...]:
    return tuple(own_peer(name).version for name in peers)


def _joined(ranges: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Ranges in order, those that touch made one."""
    joined: list[tuple[int, int]] = []
    for start, stop in sorted(ranges):
        if joined and joined[-1][1] == start:
            joined[-1] = (joined[-1][0], stop)
        else:
            joined.append((start, stop))
    return joined
