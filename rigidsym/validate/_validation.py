"""Public functions that validate generated modules and users' integrators."""

import math
import os
import platform
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from functools import cache
from importlib.metadata import version
from itertools import product

from rigidsym import _engines as engines
from rigidsym import _inputs as inputs
from rigidsym._codegen.forms import PI, split
from rigidsym.errors import InputError
from rigidsym.motion import IDENTITY
from rigidsym.validate import _executors as executors
from rigidsym.validate._bounds import MEASURES
from rigidsym.validate._campaign import (
    CASES,
    DIGITS,
    INTERVAL,
    SEED,
    Campaign,
    Progress,
    add_case,
    check_together,
    complete,
)
from rigidsym.validate._finding import Finding, measure_case
from rigidsym.validate._implementations import PEER
from rigidsym.validate._report import Failure, ValidationReport
from rigidsym.validate._same_bits import differences
from rigidsym.validate._tally import DRAWN, Tally
from rigidsym.validate.peers._protocol import Solver
from rigidsym.validate.peers._user_integrator import Function, UserIntegrator
from rigidsym.validate.strata import Sample, count, draw, in_doubles
from rigidsym.validate.strata._sample import MAX_ANGLE
from rigidsym.view._progress import bar
from rigidsym.view._report_data import Figure

PACKAGES = ("numpy", "python-flint", "mpmath", "sympy")
# The simplest failing case is searched for among so many samples, with numbers of so many digits.
TRIALS, SIMPLE_DIGITS = 200, 6
Show = Callable[[int, int], None]
Fails = Callable[[Sample], bool]


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
    """Measure the errors of generated modules on samples of all strata.

    Parameters
    ----------
    targets : names of generated modules, such as "numpy" and "c"
    cases : samples of each stratum; a finite stratum may have fewer
    digits : digits of the enclosures, at least 20
    seed : of the cases
    peers : names of other programs to measure beside the targets, see `PEERS`
    strata : names of strata, all by default
    workers : processes, None for one on each core; the report is the same for any number
    progress : called with the number of cases done, and the total

    Returns
    -------
    ValidationReport

    Raises
    ------
    InputError
        For a target, a peer or a stratum that does not exist, and fewer than 20 digits.
    """
    campaign = Campaign.of(targets, cases, digits, seed, peers, strata)
    return run(Progress(campaign), executors.local(workers), progress)


def examine(
    integrator: Function | Solver,
    cases: int = CASES,
    digits: int = DIGITS,
    seed: int = SEED,
    strata: Sequence[str] = (),
    name: str | None = None,
    reach: float | None = None,
    double_cover_sign: bool | None = None,
    progress: Show | None = None,
) -> ValidationReport:
    """Measure the errors of a user's integrator on samples of all strata.

    It has to keep the bounds of the generated modules for the report to pass; `by_stratum` of the
    report has its errors.  Exceptions, wrong shapes and NaN count as infinite errors, and their
    messages are in `complaints`.

    Parameters
    ----------
    integrator : function or object
        A function of inertia (3,) in kg m^2 about principal axes, omega0 (3,) in rad/s, attitude0
        (4,), a unit quaternion, and times (N,) in s, which returns q (N, 4), scalar first, body to
        inertial, and omega (N, 3) in body axes; or an object with the methods of `Peer`.  The times
        of a function are all positive or all negative, each farther from zero than the one before.
    cases, digits, seed : as in `validate`
    strata : names of strata, by default those whose numbers are all doubles
    name : the name in the report, by default that of the function
    reach : the largest |omega0 t| at which it is measured, 300 rad by default; math.inf for an
        integrator without steps
    double_cover_sign : whether q is continuous from attitude0 on, its sign included; if not, either
        sign is right
    progress : called with the number of cases done, and the total; a bar on a terminal by default

    Returns
    -------
    ValidationReport

    Raises
    ------
    InputError
        For arguments without meaning.
    """
    user = UserIntegrator.of(integrator, name, reach, double_cover_sign)
    chosen = Campaign.of((), cases, digits, seed, strata=strata or in_doubles())
    campaign = replace(chosen, peers=(user.name,), peer_versions=(user.version,))
    implementation, begin, tally = PEER + user.name, time.perf_counter(), Tally()
    entered, messages = {implementation: user}, dict[tuple[str, int], str]()
    with nullcontext(progress) if progress else bar("examine") as show:
        for done, (stratum, index) in enumerate(
            ((x, k) for x in campaign.strata for k in range(count(x, campaign.cases))), 1
        ):
            user.said.clear()
            add_case(tally, campaign, stratum, index, entered)
            if user.said:
                messages[stratum, index] = user.said[0]
            show(done, campaign.size)
    seconds = time.perf_counter() - begin
    how = environment(campaign, "this process", seconds, sum(tally.states.values()))
    return reported(campaign, tally, how, entered, messages)


def run(
    progress: Progress,
    place: AbstractContextManager[executors.Place],
    show: Show = lambda done, total: None,
) -> ValidationReport:
    """Measure the missing cases of a campaign, and return its report.

    Finished cases are saved, however this ends.  Raises InputError where workers or the scheduler
    are lost, KeyboardInterrupt where the user stops it; the message says what is kept.
    """
    campaign, begin = progress.campaign, time.perf_counter()
    check_together(campaign.targets)
    before = sum(progress.tally.states.values())
    progress.save()

    def after() -> None:
        show(progress.cases, campaign.size)
        progress.save(INTERVAL)

    try:
        with place as where:
            complete(progress, where, after)
        progress.save()
        seconds = time.perf_counter() - begin
        states = sum(progress.tally.states.values()) - before
        how = environment(campaign, where.name, seconds, states)
        report = reported(campaign, progress.tally, how)
        plain = (split(target) for target in campaign.targets)
        languages = dict.fromkeys(name for name, form in plain if form != PI)
        own = (name for name in languages if name in engines.SAME_BITS)
        bits = (line for name in own for line in differences(campaign.strata, name))
        return replace(report, other_bits=tuple(bits))
    except BaseException as error:
        fate = "nothing is kept without a directory (-o DIR)"
        if progress.directory:
            with executors.undisturbed():
                progress.save()
            done = f"{progress.cases} of {campaign.size} cases"
            fate = f"{done} are kept, --resume goes on from there"
        if isinstance(error, KeyboardInterrupt):
            raise KeyboardInterrupt(f"interrupted: {fate}") from None
        if isinstance(error, BrokenProcessPool):
            rule = f"died, perhaps for lack of memory: {fate}"
            raise InputError("workers", "one process", rule) from None
        if isinstance(error, CancelledError):
            raise InputError("scheduler", "the cluster", f"was lost: {fate}") from None
        raise


def reported(
    campaign: Campaign,
    tally: Tally,
    run: Mapping[str, Figure | None],
    user: Mapping[str, UserIntegrator] | None = None,
    messages: Mapping[tuple[str, int], str] | None = None,
) -> ValidationReport:
    """Return the report of a campaign from its tally.

    The worst cases are measured again for it.  user: a user's integrator by its name; messages: its
    messages by case.
    """

    @cache
    def again(stratum: str, index: int) -> Finding:
        sample = draw(stratum, index, campaign.seed)
        return measure_case(sample, campaign.digits, user or campaign.implementations)

    # The worst angle and rates of each implementation in each stratum, each case once.
    places = {
        cell.place[:2]
        for target in campaign.judged
        for measure in DRAWN
        for cell in tally.view(target, measure, "stratum").values()
    }
    worst = tuple(again(*place) for place in sorted(places))
    failures = []
    for target, stratum in product(campaign.judged, campaign.strata):
        # The worst broken bound of the stratum.
        shares = ((m, tally.cells.get((target, m, "share", stratum))) for m in MEASURES)
        found = [(m, cell) for m, cell in shares if cell and cell.worst > 1]
        if not found:
            continue
        measure, cell = max(found, key=lambda item: item[1].worst)
        case = cell.place[:2]
        # No simpler case for a user's integrator: where all bounds are broken it takes long.
        finding = again(*case) if user else _simplest(campaign, target, measure, case)
        said = (messages or {}).get(case, "")
        failures.append(Failure(target, measure, cell.worst, *case, finding, said))
    return ValidationReport(campaign, tally, worst, tuple(failures), run)


def _simplest(campaign: Campaign, target: str, measure: str, case: tuple[str, int]) -> Finding:
    """Find a simpler case that breaks the same bound of a target, and measure it."""

    def fails(sample: Sample) -> bool:
        return measure_case(sample, campaign.digits, [target]).shares(target).get(measure, 0.0) > 1

    found = simplest(draw(*case, campaign.seed), fails)
    return measure_case(found, campaign.digits, campaign.implementations)


def simplest(sample: Sample, fails: Fails) -> Sample:
    """Simplify a sample as long as it still fails.

    At most TRIALS neighbours are tried.
    """
    neighbours = _simpler(sample)
    for _ in range(TRIALS):
        if (simpler := next(neighbours, None)) is None:
            break
        if _is_bounded(simpler) and fails(simpler):
            sample, neighbours = simpler, _simpler(simpler)
    return sample


def _simpler(sample: Sample) -> Iterator[Sample]:
    """Yield samples that are simpler than a given one in a single respect.

    They have one time only, no attitude, or one simpler number.  Simpler numbers are 0, 1, -1, and
    then decimals of few digits.
    """
    if len(sample.times) > 1:
        yield from (replace(sample, times=(t,)) for t in sample.times)
    if sample.attitude0 != IDENTITY:
        yield replace(sample, attitude0=tuple(map(float, IDENTITY)))
    for name in ("omega0", "inertia", "times"):
        values = getattr(sample, name)
        for k, value in enumerate(values):
            decimals = (float(f"{float(value):.{n}e}") for n in range(SIMPLE_DIGITS))
            for number in dict.fromkeys((0.0, 1.0, -1.0, *decimals)):
                if number == value:
                    break
                yield replace(sample, **{name: (*values[:k], number, *values[k + 1 :])})


def _is_bounded(sample: Sample) -> bool:
    """Return True if the documented error bounds apply to a sample.

    Its body can exist, and its times are not beyond those that modules follow.
    """
    try:
        inputs.inertia(sample.inertia)
    except InputError:
        return False
    turned = math.hypot(*sample.omega0) * max(map(abs, sample.times))
    # Decimals of the largest doubles can be infinite.
    return all(map(math.isfinite, (*sample.inertia, turned))) and turned <= MAX_ANGLE


def environment(
    campaign: Campaign, place: str, seconds: float, states: int
) -> dict[str, Figure | None]:
    """Return a report's data about the run: versions, machine, duration and memory.

    It differs between runs of the same campaign.
    """
    compiler = {}
    if any(x.startswith("c") for x in campaign.targets):
        from rigidsym._engines.build import find

        compiler = {"compiler": find().version.partition("\n")[0]}
    return {
        "place": place,
        "seconds": round(seconds, 2),
        "enclosed states": states,
        "enclosed states a second": round(states / seconds),
        "peak memory of a process, MB": _peak(),
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.machine()}",
        "cores": os.cpu_count(),
        **{name: version(name) for name in PACKAGES},
        **compiler,
        **dict(zip(campaign.peers, campaign.peer_versions, strict=True)),
    }


def _peak() -> int | None:
    """Return the peak memory of this process and its children.

    Returns None if the system does not measure it.
    """
    try:
        import resource
    except ImportError:  # Windows
        return None
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    # Kilobytes, except on macOS.
    unit = 2**20 if sys.platform == "darwin" else 2**10
    return round(max(resource.getrusage(x).ru_maxrss for x in who) / unit)
