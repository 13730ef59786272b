"""One validation from start to report, kept in a directory where it may be interrupted."""

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager

from rigidsym import engines
from rigidsym.errors import InputError
from rigidsym.validate import checkpoint, executors
from rigidsym.validate.bounds import MEASURES
from rigidsym.validate.campaign import CASES, DIGITS, SEED, Campaign, Progress, complete
from rigidsym.validate.finding import measure_case
from rigidsym.validate.provenance import environment
from rigidsym.validate.report import Failure, ValidationReport
from rigidsym.validate.shrink import simplest
from rigidsym.validate.strata import Sample, draw
from rigidsym.validate.tally import DRAWN, Cell, Place, Tally
from rigidsym.view.report_data import Figure

Show = Callable[[int, int], None]


def validate(
    targets: Sequence[str] = engines.ENGINES,
    cases: int = CASES,
    digits: int = DIGITS,
    seed: int = SEED,
    peers: Sequence[str] = (),
    strata: Sequence[str] = (),
    workers: int | None = 1,
    progress: Show = lambda done, total: None,
) -> ValidationReport:
    """Measure generated modules on `cases` samples of every stratum, or of those named.

    workers: processes, None for one on each core; the report is the same for any number.  Raises
    InputError for a target, a peer or a stratum that does not exist, and fewer than 20 digits.
    """
    campaign = Campaign.of(targets, cases, digits, seed, peers, strata)
    return run(campaign, Progress(), executors.local(workers), progress)


def run(
    campaign: Campaign,
    progress: Progress,
    place: AbstractContextManager[executors.Place],
    show: Show = lambda done, total: None,
    kept: checkpoint.Checkpoint | None = None,
) -> ValidationReport:
    """Do what is missing of a campaign and report; what is done is kept, however it ends.

    Raises InputError where workers or the scheduler are lost, KeyboardInterrupt where the user
    stops it: both say what is kept.
    """
    begin, before = time.perf_counter(), sum(progress.tally.states.values())
    if kept:
        kept.write()

    def after() -> None:
        show(progress.cases, campaign.size)
        if kept:
            kept.now_and_then()

    try:
        with place as where:
            complete(campaign, progress, where, after)
        if kept:
            kept.write()
        seconds = time.perf_counter() - begin
        states = sum(progress.tally.states.values()) - before
        how = environment(campaign, where.name, seconds, states)
        return reported(campaign, progress.tally, how)
    except BaseException as error:
        if kept:
            with executors.undisturbed():
                kept.write()
        raise _told(error, progress, campaign, kept) from None


def _told(
    error: BaseException, progress: Progress, campaign: Campaign, kept: checkpoint.Checkpoint | None
) -> BaseException:
    """What stopped a campaign, in one line that says what is kept."""
    fate = "nothing is kept without a directory (-o DIR)"
    if kept:
        fate = f"{progress.cases} of {campaign.size} cases are kept, --resume goes on from there"
    if isinstance(error, KeyboardInterrupt):
        return KeyboardInterrupt(f"interrupted: {fate}")
    if isinstance(error, BrokenProcessPool):
        return InputError("workers", "one process", f"died, perhaps for lack of memory: {fate}")
    if isinstance(error, CancelledError):
        return InputError("scheduler", "the cluster", f"was lost: {fate}")
    return error


def reported(
    campaign: Campaign, tally: Tally, run: Mapping[str, Figure | None]
) -> ValidationReport:
    """The report of a campaign: its worst cases are measured once more, in full."""
    worst = (
        draw(stratum, index, campaign.seed) for stratum, index, _ in worst_places(campaign, tally)
    )
    findings = tuple(
        measure_case(sample, campaign.digits, campaign.implementations) for sample in worst
    )
    return ValidationReport(campaign, tally, findings, tuple(_failures(campaign, tally)), run)


def worst_places(campaign: Campaign, tally: Tally) -> list[Place]:
    """Where each who is judged is worst in each stratum, by angle and by rates; each case once."""
    cells = (
        cell
        for target in campaign.judged
        for measure in DRAWN
        for cell in tally.view(target, measure, "stratum").values()
    )
    places = {cell.place[:2]: cell.place for cell in cells}
    return [places[key] for key in sorted(places)]


def _failures(campaign: Campaign, tally: Tally) -> Iterator[Failure]:
    """The worst broken bound of each target in each stratum, with the simplest case like it."""
    for target in campaign.targets:
        for stratum in campaign.strata:
            shares = {m: tally.cells.get((target, m, "share", stratum)) for m in MEASURES}
            found = {m: cell for m, cell in shares.items() if cell and cell.worst > 1}
            if found:
                name = max(found, key=lambda m: found[m].worst)
                yield _failure(campaign, target, name, found[name])


def _failure(campaign: Campaign, target: str, measure: str, cell: Cell) -> Failure:
    def fails(sample: Sample) -> bool:
        return measure_case(sample, campaign.digits, [target]).shares(target).get(measure, 0.0) > 1

    stratum, index, _ = cell.place
    simple = simplest(draw(stratum, index, campaign.seed), fails)
    finding = measure_case(simple, campaign.digits, campaign.implementations)
    return Failure(target, measure, cell.worst, stratum, index, finding)
