"""Every fault against every stratum, in processes that may be lost."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from functools import partial

from rigidsym.engines import STEPPERS
from rigidsym.engines.threads import processors
from rigidsym.validate.executors import processes, undisturbed
from rigidsym.validate.faults.detection import CRASHED, Detection, detections, references
from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.mutated_build import faulty
from rigidsym.validate.faults.report import FaultReport, Outcome
from rigidsym.validate.faults.tables import all_faults
from rigidsym.validate.implementations import check_target
from rigidsym.validate.oracle import Reference
from rigidsym.validate.strata import STRATA

Strata = Sequence[Sequence[Reference]]
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

    All faults are measured, unless some are given; those of steps on what `stepped` makes of the
    cases.
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
    kinds = {kind: [x for x in chosen if (x.target in STEPPERS) == kind] for kind in (False, True)}
    kinds = {kind: faults for kind, faults in kinds.items() if faults}
    told = partial(_tell, progress, len(kinds) * len(strata) + len(chosen))
    found: dict[Fault, list[Detection]] = {}
    done = 0
    for of_steps, some in kinds.items():
        enclosed = _enclosed(strata, (cases, digits, seed, of_steps), partial(told, done))
        done += len(strata)
        found |= _found(some, enclosed, partial(told, done))
        done += len(some)
    outcomes = tuple(Outcome(fault, tuple(found[fault])) for fault in chosen)
    return FaultReport(tuple(targets), tuple(strata), cases, digits, seed, outcomes)


def _tell(progress: Progress, total: int, before: int, done: int = 0) -> None:
    progress(before + done, total)


def _enclosed(
    strata: Sequence[str], drawn: tuple[int, int, int, bool], told: Callable[[int], None]
) -> Strata:
    """The truth about all cases, which all faults share; drawn: what `references` is told."""
    with processes(processors()) as pool:
        with undisturbed():
            jobs = [pool.submit(references, name, *drawn) for name in strata]
        enclosed = []
        for done, job in enumerate(jobs, 1):
            enclosed.append(job.result())
            told(done)
    return enclosed


def _found(
    faults: Sequence[Fault], strata: Strata, told: Callable[[int], None]
) -> dict[Fault, list[Detection]]:
    """The notices of every fault; those that may have ended a process are looked at alone."""
    left, found = list(faults), {}
    while left:
        for fault, result in _until_a_crash(left, strata):
            found[fault] = _alone(fault, strata) if result is None else result
            left.remove(fault)
            told(len(found))
    return found


def _until_a_crash(
    faults: Sequence[Fault], strata: Strata
) -> Iterator[tuple[Fault, list[Detection] | None]]:
    """Faults and detections; None for all that were under way when a process was lost, the last."""
    waiting, running = list(faults), dict[Future[list[Detection]], Fault]()
    lost = False
    with processes(processors()) as pool:
        while running or (waiting and not lost):
            try:
                while waiting and len(running) < processors() and not lost:
                    with undisturbed():
                        job = pool.submit(detections, waiting[0], strata)
                    running[job] = waiting.pop(0)
            except BrokenProcessPool:
                lost = True
            for job in wait(running, return_when=FIRST_COMPLETED).done:
                crashed = isinstance(job.exception(), BrokenProcessPool)
                lost = lost or crashed
                yield running.pop(job), None if crashed else job.result()


def _alone(fault: Fault, strata: Strata) -> list[Detection]:
    """The detections of a fault that may end a process: each stratum has its own."""
    found = []
    for stratum in strata:
        try:
            with processes(1) as pool:
                found += pool.submit(detections, fault, [stratum]).result()
        except BrokenProcessPool:
            found.append(Detection(stratum[0].sample.stratum, 0, (CRASHED,)))
    return found
