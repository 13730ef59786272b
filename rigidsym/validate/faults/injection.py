"""Every fault against every stratum, in processes that may be lost."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from functools import partial

from rigidsym.engines.threads import processors
from rigidsym.validate.executors import processes, undisturbed
from rigidsym.validate.faults.detection import (
    CRASHED,
    AnyReference,
    Detection,
    columns_references,
    detections,
    references,
    steps_references,
)
from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.mutated_build import faulty
from rigidsym.validate.faults.report import FaultReport, Outcome
from rigidsym.validate.faults.tables import all_faults
from rigidsym.validate.implementations import check_target
from rigidsym.validate.strata import STRATA

# By what it is the truth about.
Truth = Mapping[str, Sequence[Sequence[AnyReference]]]
_REFERENCES = {
    "states": references,
    "sensitivities": columns_references,
    "steps": steps_references,
}
Progress = Callable[[int, int], None]


def inject(
    targets: Sequence[str],
    cases: int,
    digits: int,
    seed: int,
    progress: Progress = lambda done, total: None,
    faults: Sequence[Fault] | None = None,
    strata: Sequence[str] = tuple(STRATA),
) -> FaultReport:
    """Measure each fault of the targets on `cases` cases of each stratum, `count` says how many.

    All faults are measured, unless some are given.
    progress is told how many strata and faults are done, and of how many.  Raises InputError for a
    target that cannot be had here, and StaleFaultError for a fault whose place is gone.
    """
    for target in targets:
        check_target(target)
    chosen = [
        fault for fault in (all_faults() if faults is None else faults) if fault.target in targets
    ]
    for fault in chosen:
        faulty(fault)
    of = sorted({fault.shown_in for fault in chosen})
    enclosed = len(strata) * len(of)
    told = partial(_tell, progress, enclosed + len(chosen))
    truth = _truth(of, strata, (cases, digits, seed), told)
    found = _found(chosen, truth, partial(told, enclosed))
    outcomes = tuple(Outcome(fault, tuple(found[fault])) for fault in chosen)
    return FaultReport(tuple(targets), tuple(strata), cases, digits, seed, outcomes)


def _tell(progress: Progress, total: int, before: int, done: int = 0) -> None:
    progress(before + done, total)


def _truth(
    of: Sequence[str],
    strata: Sequence[str],
    drawn: tuple[int, int, int],
    told: Callable[[int], None],
) -> Truth:
    """What is true of all cases, which all faults share: of states, sensitivities and steps."""
    enclosed: dict[str, list[Sequence[AnyReference]]] = {kind: [] for kind in of}
    with processes(processors()) as pool:
        with undisturbed():
            jobs = [
                (kind, pool.submit(_REFERENCES[kind], name, *drawn))
                for kind in of
                for name in strata
            ]
        for done, (kind, job) in enumerate(jobs, 1):
            enclosed[kind].append(job.result())
            told(done)
    return enclosed


def _found(
    faults: Sequence[Fault], truth: Truth, told: Callable[[int], None]
) -> dict[Fault, list[Detection]]:
    """The notices of every fault; those that may have ended a process are looked at alone."""
    left, found = list(faults), {}
    while left:
        for fault, result in _until_a_crash(left, truth):
            found[fault] = _alone(fault, truth) if result is None else result
            left.remove(fault)
            told(len(found))
    return found


def _until_a_crash(
    faults: Sequence[Fault], truth: Truth
) -> Iterator[tuple[Fault, list[Detection] | None]]:
    """Faults and detections; None for all that were under way when a process was lost, the last."""
    waiting, running = list(faults), dict[Future[list[Detection]], Fault]()
    lost = False
    with processes(processors()) as pool:
        while running or (waiting and not lost):
            try:
                while waiting and len(running) < processors() and not lost:
                    fault = waiting[0]
                    with undisturbed():
                        job = pool.submit(detections, fault, truth[fault.shown_in])
                    running[job] = waiting.pop(0)
            except BrokenProcessPool:
                lost = True
            for job in wait(running, return_when=FIRST_COMPLETED).done:
                crashed = isinstance(job.exception(), BrokenProcessPool)
                lost = lost or crashed
                yield running.pop(job), None if crashed else job.result()


def _alone(fault: Fault, truth: Truth) -> list[Detection]:
    """The detections of a fault that may end a process: each stratum has its own."""
    found = []
    for stratum in truth[fault.shown_in]:
        try:
            with processes(1) as pool:
                found += pool.submit(detections, fault, [stratum]).result()
        except BrokenProcessPool:
            found.append(Detection(stratum[0].sample.stratum, 0, (CRASHED,)))
    return found
