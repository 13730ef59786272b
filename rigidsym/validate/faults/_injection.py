"""Injection of faults in worker processes that may crash, with a report on their detection."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import chain, product
from typing import Any

from rigidsym._engines.threads import processors
from rigidsym.validate._executors import processes, undisturbed
from rigidsym.validate._implementations import check_target
from rigidsym.validate.faults._detection import (
    CRASHED,
    AnyReference,
    Detection,
    detections,
    references,
)
from rigidsym.validate.faults._drawn import all_faults
from rigidsym.validate.faults._fault import KINDS, Fault
from rigidsym.validate.faults._printed import check
from rigidsym.validate.strata import STRATA
from rigidsym.view._tables import table

SCHEMA = "rigidsym.faults/2"
# More strata than these are counted, not named.
_NAMED = 4
# The references of each stratum, by what they enclose.
References = Mapping[str, Sequence[Sequence[AnyReference]]]
Progress = Callable[[int, int], None]


@dataclass(frozen=True, slots=True)
class Outcome:
    """Result of the injection of one fault.

    It has at most one detection for each stratum.
    """

    fault: Fault
    detections: tuple[Detection, ...]

    @property
    def strata(self) -> tuple[str, ...]:
        """The names of the strata that detected the fault."""
        return tuple(detection.stratum for detection in self.detections)


@dataclass(frozen=True, slots=True)
class FaultReport:
    """Report on the detection of injected faults."""

    targets: tuple[str, ...]
    strata: tuple[str, ...]
    cases: int
    digits: int
    seed: int
    outcomes: tuple[Outcome, ...]

    @property
    def passed(self) -> bool:
        """True if there are faults of every target, and each is detected by some stratum."""
        named = {outcome.fault.target for outcome in self.outcomes}
        return named == set(self.targets) and not self.missed

    @property
    def missed(self) -> tuple[Fault, ...]:
        """The faults that no stratum detected."""
        return tuple(outcome.fault for outcome in self.outcomes if not outcome.detections)

    @property
    def conclusion(self) -> str:
        """A sentence that states the result."""
        total, best = len(self.outcomes), max(self.strata, key=self.caught)
        sharpest = f"{best} alone notices {self.caught(best)}"
        if self.missed:
            return f"{len(self.missed)} of {total} faults are NOT noticed; {sharpest}."
        fewest = min((len(outcome.strata) for outcome in self.outcomes), default=0)
        strata = "stratum" if fewest == 1 else "strata"
        return f"Each of {total} faults is noticed, by {fewest} {strata} or more; {sharpest}."

    def caught(self, stratum: str) -> int:
        """Return the number of faults that a stratum detected."""
        return sum(stratum in outcome.strata for outcome in self.outcomes)

    def alone(self, stratum: str) -> int:
        """Return the number of faults that only this stratum detected."""
        return sum((stratum,) == outcome.strata for outcome in self.outcomes)

    def to_data(self) -> dict[str, Any]:
        """Return the report as plain data.

        The schema is rigidsym.faults/2.
        """
        total = len(self.outcomes)
        return {
            "schema": SCHEMA,
            **{name: getattr(self, name) for name in ("cases", "digits", "seed", "passed")},
            "targets": list(self.targets),
            "kinds": KINDS,
            "strata": {
                name: {"caught": self.caught(name), "alone": self.alone(name), "of": total}
                for name in self.strata
            },
            "faults": [
                {
                    "target": x.fault.target,
                    "name": x.fault.name,
                    "kind": x.fault.kind,
                    "old": x.fault.old,
                    "new": x.fault.new,
                    "options": list(x.fault.options),
                    "caught": {
                        found.stratum: {
                            "case": f"{found.stratum}:{found.index}",
                            "by": list(found.measures),
                        }
                        for found in x.detections
                    },
                }
                for x in self.outcomes
            ],
        }

    def to_json(self) -> str:
        """Return the report as JSON."""
        return json.dumps(self.to_data(), indent=1, sort_keys=True) + "\n"

    def to_markdown(self) -> str:
        """Return the report as Markdown tables of strata and of faults."""
        total = len(self.outcomes)
        strata = [(x, f"{self.caught(x)} of {total}", str(self.alone(x))) for x in self.strata]
        faults = []
        for x in self.outcomes:
            count, measures = str(len(x.strata)), (found.measures for found in x.detections)
            by = ", ".join(dict.fromkeys(chain.from_iterable(measures)))
            faults.append((x.fault.line, x.fault.kind, count, self._which(x.strata), by))
        return "\n".join(
            [
                f"{total - len(self.missed)} of {total} faults were caught.",
                "",
                *table(("stratum", "caught", "by no other"), strata),
                "",
                *table(("fault", "kind", "strata", "which", "by"), faults),
                "",
            ]
        )

    def _which(self, strata: tuple[str, ...]) -> str:
        """Format a list of strata briefly.

        The missing ones are listed if they are fewer.
        """
        if len(strata) <= _NAMED:
            return ", ".join(strata) or "NOT CAUGHT"
        others = [name for name in self.strata if name not in strata]
        if len(others) <= _NAMED:
            return f"all but {', '.join(others)}" if others else "all"
        return f"{', '.join(strata[:_NAMED])}, ..."


def inject(
    targets: Sequence[str],
    cases: int,
    digits: int,
    seed: int,
    progress: Progress = lambda done, total: None,
    faults: Sequence[Fault] | None = None,
    strata: Sequence[str] = tuple(STRATA),
) -> FaultReport:
    """Inject faults into generated modules, and report which strata of test motions detect them.

    Each fault is measured on `cases` cases of each stratum, or on all cases if there are fewer.

    Parameters
    ----------
    targets : names of generated modules, as `rigidsym validate` takes them
    cases, digits, seed : cases per stratum, digits of the enclosures, seed of the cases
    progress : called with the number of strata and faults done, and the total
    faults : the faults to measure, all by default
    strata : names of strata, all by default

    Raises
    ------
    InputError
        If a target cannot be built on this machine.
    StaleFaultError
        If the old text of a fault is no longer in the module.
    """
    for target in targets:
        check_target(target)
    chosen = [
        fault for fault in (all_faults() if faults is None else faults) if fault.target in targets
    ]
    for fault in chosen:
        check(fault)
    of = sorted({fault.shown_in for fault in chosen})
    before, total = len(strata) * len(of), len(strata) * len(of) + len(chosen)
    enclosed: dict[str, list[Sequence[AnyReference]]] = {kind: [] for kind in of}
    left, found = list(chosen), {}
    with ExitStack() as pools:
        pool = pools.enter_context(processes(processors()))
        with undisturbed():
            jobs = [
                (kind, pool.submit(references, name, cases, digits, seed, kind))
                for kind, name in product(of, strata)
            ]
        for done, (kind, job) in enumerate(jobs, 1):
            enclosed[kind].append(job.result())
            progress(done, total)
        while left:
            for fault, result in _until_a_crash(pool, left, enclosed):
                # A fault that may have ended the process is measured again alone.
                found[fault] = _alone(fault, enclosed) if result is None else result
                left.remove(fault)
                progress(before + len(found), total)
            # A pool that lost a process takes no more work.
            pool = pools.enter_context(processes(processors()))
    outcomes = tuple(Outcome(fault, tuple(found[fault])) for fault in chosen)
    return FaultReport(tuple(targets), tuple(strata), cases, digits, seed, outcomes)


def _until_a_crash(
    pool: ProcessPoolExecutor, faults: Sequence[Fault], enclosed: References
) -> Iterator[tuple[Fault, list[Detection] | None]]:
    """Measure faults in parallel processes until one crashes, and yield their detections.

    Detections are None for a fault that may have caused the crash.
    """
    waiting, running = list(faults), dict[Future[list[Detection]], Fault]()
    lost = False
    while running or (waiting and not lost):
        try:
            while waiting and len(running) < processors() and not lost:
                fault = waiting[0]
                with undisturbed():
                    job = pool.submit(detections, fault, enclosed[fault.shown_in])
                running[job] = waiting.pop(0)
        except BrokenProcessPool:
            lost = True
        for job in wait(running, return_when=FIRST_COMPLETED).done:
            crashed = isinstance(job.exception(), BrokenProcessPool)
            lost = lost or crashed
            yield running.pop(job), None if crashed else job.result()


def _alone(fault: Fault, enclosed: References) -> list[Detection]:
    """Measure a potentially crashing fault in a process of its own.

    The process is replaced after a crash.
    """
    found = []
    with ExitStack() as pools:
        pool = pools.enter_context(processes(1))
        for stratum in enclosed[fault.shown_in]:
            try:
                found += pool.submit(detections, fault, [stratum]).result()
            except BrokenProcessPool:
                found.append(Detection(stratum[0].sample.stratum, 0, (CRASHED,)))
                pool = pools.enter_context(processes(1))
    return found
