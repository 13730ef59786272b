"""A user's integrator, measured as everything else is, in this process."""

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from rigidsym.validate.bounds import MEASURES
from rigidsym.validate.campaign import CASES, DIGITS, SEED, Campaign, add_case
from rigidsym.validate.finding import Finding, measure_case
from rigidsym.validate.implementations import PEER
from rigidsym.validate.peers.protocol import Solver
from rigidsym.validate.peers.user_integrator import Function, UserIntegrator
from rigidsym.validate.provenance import environment
from rigidsym.validate.report import Failure, ValidationReport
from rigidsym.validate.strata import count, draw, in_doubles
from rigidsym.validate.tally import Cell, Tally
from rigidsym.validate.validation import Show, worst_places

Case = tuple[str, int]


def examine(
    integrator: Function | Solver,
    cases: int = CASES,
    digits: int = DIGITS,
    seed: int = SEED,
    strata: Sequence[str] = (),
    name: str | None = None,
    reach: float | None = None,
    double_cover_sign: bool | None = None,
    progress: Show = lambda done, total: None,
) -> ValidationReport:
    """Measure a user's integrator on `cases` samples of the strata that doubles can say, or
    of those named.

    integrator: a function of inertia (3,) in kg m^2 about principal axes, omega0 (3,) in rad/s,
    attitude0 (4,), a unit quaternion, and times (N,) in s, which gives q (N, 4), scalar first, body
    to inertial, and omega (N, 3) in body axes; or an object with the methods of `Peer`.  The times
    a function gets are all positive or all negative, each farther from zero than the one before.
    name: by which it is reported, that of the function by default.
    reach: the largest |omega0 t| it is asked for, 300 rad by default; math.inf for what needs no
    steps.  double_cover_sign: whether q goes on from attitude0 continuously, its sign included; if
    not, either sign is right.

    It has to keep the bounds of the generated modules for the report to pass; `by_stratum` says how
    good it is.  Whatever it raises, wrong shapes and NaN are infinitely wrong, and said in
    `complaints`.  Raises InputError for options that mean nothing.
    """
    user_integrator = UserIntegrator.of(integrator, name, reach, double_cover_sign)
    chosen = Campaign.of((), cases, digits, seed, strata=strata or in_doubles())
    campaign = replace(
        chosen, peers=(user_integrator.name,), peer_versions=(user_integrator.version,)
    )
    return _Examination(campaign, user_integrator).report(progress)


@dataclass(frozen=True, slots=True)
class _Examination:
    """A campaign of one integrator, which no name can bring to another process."""

    campaign: Campaign
    integrator: UserIntegrator

    @property
    def name(self) -> str:
        """As an implementation under test."""
        return PEER + self.integrator.name

    @property
    def entered(self) -> Mapping[str, UserIntegrator]:
        """As `measure_case` takes it."""
        return {self.name: self.integrator}

    def report(self, progress: Show) -> ValidationReport:
        """All cases, and the worst of them in full."""
        begin, tally = time.perf_counter(), Tally()
        said = dict(self._measured(tally, progress))
        seconds = time.perf_counter() - begin
        run = environment(self.campaign, "this process", seconds, sum(tally.states.values()))
        worst = [place[:2] for place in worst_places(self.campaign, tally)]
        broken = list(self._broken(tally))
        again = {
            case: self._again(*case) for case in {*worst, *(cell.place[:2] for _, cell in broken)}
        }
        failures = (
            Failure(self.name, measure, cell.worst, *case, again[case], said.get(case, ""))
            for measure, cell in broken
            for case in [cell.place[:2]]
        )
        found = tuple(again[case] for case in worst)
        return ValidationReport(self.campaign, tally, found, tuple(failures), run)

    def _measured(self, tally: Tally, progress: Show) -> Iterator[tuple[Case, str]]:
        """Count every case; gives what the integrator was heard to say, by case."""
        done = 0
        for stratum in self.campaign.strata:
            for index in range(count(stratum, self.campaign.cases)):
                self.integrator.said.clear()
                add_case(tally, self.campaign, stratum, index, self.entered)
                yield from (((stratum, index), line) for line in self.integrator.said[:1])
                done += 1
                progress(done, self.campaign.size)

    def _broken(self, tally: Tally) -> Iterator[tuple[str, Cell]]:
        """The worst broken bound in each stratum: a measure, and the part of the bound.

        No simpler cases are looked for: that takes too long where all bounds are broken.
        """
        for stratum in self.campaign.strata:
            shares = {m: tally.cells.get((self.name, m, "share", stratum)) for m in MEASURES}
            found = {m: cell for m, cell in shares.items() if cell and cell.worst > 1}
            if found:
                yield max(found.items(), key=lambda item: item[1].worst)

    def _again(self, stratum: str, index: int) -> Finding:
        return measure_case(
            draw(stratum, index, self.campaign.seed), self.campaign.digits, self.entered
        )
