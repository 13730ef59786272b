"""The validation report: what was measured, against which bounds, and where it was worst."""

import json
import re
import shlex
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from rigidsym.errors import InputError
from rigidsym.validate import second_oracle
from rigidsym.validate.bounds import BOUNDS, CONDITIONED, MEANINGS, MEASURES, ULP, bounds_of
from rigidsym.validate.campaign import DISAGREEMENT, ORACLES, Campaign
from rigidsym.validate.case_file import file_name, hexadecimal
from rigidsym.validate.finding import Finding
from rigidsym.validate.implementations import PEER
from rigidsym.validate.markdown import markdown
from rigidsym.validate.measure import Errors
from rigidsym.validate.strata import STRATA, count, in_doubles
from rigidsym.validate.tally import DRAWN, Cell, Tally
from rigidsym.view import report_data
from rigidsym.view.html.reports import BROKEN, PASSED, report_html

SCHEMA = "rigidsym.validation/3"
FAILURES = "failures"


@dataclass(frozen=True, slots=True)
class Failure:
    """A broken bound: who, where, by which measure, and the simplest case found that breaks it.

    said: the words in which an integrator of the user's refused the case, if it did.
    """

    target: str
    measure: str
    share: float
    stratum: str
    index: int
    simplest: Finding
    said: str = ""

    @property
    def file(self) -> str:
        """Where the simplest case lies, in the directory of the report."""
        return f"{FAILURES}/{self.target}/{file_name(self.simplest.sample)}"

    @property
    def line(self) -> str:
        """One line that names stratum, case and figure."""
        bound = bounds_of(self.target)[self.measure]
        figure = f"{self.share * bound:.2g}"
        if self.measure in CONDITIONED:
            figure += " times its condition"
        return (
            f"{self.target}: {self.stratum}:{self.index}: {self.measure} {figure}, "
            f"{self.share:.3g} of its bound {bound:g}"
        ) + (f" ({self.said})" if self.said else "")


@dataclass(frozen=True, slots=True)
class Worst:
    """The worst of one measure in a stratum: rad, or relative (MEANINGS says which); the condition
    number there, the case as (stratum, index), which `draw` takes, and the time in s."""

    error: float
    condition: float
    case: tuple[str, int]
    time: float

    @classmethod
    def of(cls, cell: Cell) -> "Worst":
        """What a cell of a tally has in units of 2^-53."""
        stratum, index, time = cell.place
        return cls(cell.worst * ULP, cell.condition, (stratum, index), time)


@dataclass(frozen=True, slots=True, repr=False)
class ValidationReport:
    """A campaign, what it found, the worst cases in full, and how it was run."""

    campaign: Campaign
    tally: Tally
    worst: tuple[Finding, ...] = ()
    failures: tuple[Failure, ...] = ()
    run: Mapping[str, report_data.Figure | None] = field(default_factory=dict)

    @property
    def passed(self) -> bool:
        """Something was tested in every stratum, all within the bounds, and the oracles agree."""
        return not self.complaints

    @property
    def complaints(self) -> tuple[str, ...]:
        """Why it did not pass, a line for each reason."""
        told = {(failure.target, failure.stratum) for failure in self.failures}
        lines = [failure.line for failure in self.failures]
        for stratum in self.campaign.strata:
            tested, wanted = self.tally.cases.get(stratum, 0), count(stratum, self.campaign.cases)
            if tested != wanted or not tested:
                lines.append(f"{stratum}: {tested} of {wanted} cases were tested")
            elif not self.agreement(stratum) <= 1:
                apart = self.agreement(stratum) * second_oracle.AGREEMENT
                lines.append(f"{stratum}: the oracles disagree by {apart:.2g}")
            lines += [
                f"{target}: {stratum}: a bound is broken, or was not tested"
                for target in self.campaign.judged
                if not self.share(target, stratum) <= 1 and (target, stratum) not in told
            ]
        return tuple(lines)

    def share(self, name: str, stratum: str) -> float:
        """The largest part of a bound that is needed in a stratum; infinite where untested."""
        expected = [m for m in MEASURES if m != "entry_points" or not name.startswith(PEER)]
        cells = (self.tally.cells.get((name, m, "share", stratum)) for m in expected)
        return max(float("inf") if cell is None else cell.worst for cell in cells)

    def agreement(self, stratum: str) -> float:
        """How far the oracles are apart, as part of what they have to agree to."""
        cell = self.tally.cells.get((ORACLES, DISAGREEMENT, "stratum", stratum))
        return float("inf") if cell is None else cell.worst

    @property
    def command(self) -> str:
        """What writes this report."""
        if self.campaign.user_integrators:
            return self._call
        return f"rigidsym validate {self.options}"

    @property
    def _call(self) -> str:
        """In Python: an integrator of the user's is out of the command's sight."""
        campaign = self.campaign
        drawn = f"cases={campaign.cases}, digits={campaign.digits}, seed={campaign.seed}"
        chosen = "" if campaign.strata == in_doubles() else f", strata={[*campaign.strata]}"
        return f"examine({_variable(campaign.user_integrators[0])}, {drawn}{chosen})"

    @property
    def options(self) -> str:
        """Targets and options of the campaign."""
        campaign = self.campaign
        chosen = [f"--stratum '{name}'" for name in campaign.strata] if self._partial else []
        peers = [f"--peer {name}" for name in campaign.peers]
        drawn = f"--cases {campaign.cases} --digits {campaign.digits} --seed {campaign.seed}"
        return " ".join([*campaign.targets, drawn, *peers, *chosen])

    @property
    def _partial(self) -> bool:
        return len(self.campaign.strata) < len(STRATA)

    def to_data(self) -> report_data.Report:
        """The schema rigidsym.validation/3; figures in units of 2^-53, to three digits."""
        tally = self.tally
        return {
            "schema": SCHEMA,
            "campaign": self.campaign.to_data(),
            "command": self.command,
            "passed": self.passed,
            "complaints": list(self.complaints),
            "unit": "2**-53",
            "bounds": {name: bound / ULP for name, bound in BOUNDS.items()},
            "meanings": MEANINGS,
            "strata": [
                {
                    "name": name,
                    "about": STRATA[name].about,
                    "cases": tally.cases.get(name, 0),
                    "states": tally.states.get(name, 0),
                    "disagreement": _figure(self.agreement(name)),
                }
                for name in self.campaign.strata
            ],
            "agreement": second_oracle.AGREEMENT,
            "implementations": [
                self._implementation(name) for name in self.campaign.implementations
            ],
            "worst": [self._case(finding) for finding in self.worst],
            "failures": [
                {
                    "line": failure.line,
                    "target": failure.target,
                    "measure": failure.measure,
                    "stratum": failure.stratum,
                    "index": failure.index,
                    "share": _figure(failure.share),
                    "simplest": self._case(failure.simplest, self._file(failure)),
                }
                for failure in self.failures
            ],
            "run": dict(self.run),
        }

    def to_markdown(self) -> str:
        """Tables a person can read."""
        return markdown(self.to_data())

    def to_json(self) -> str:
        """`to_data` as text: the same for the same campaign, but for `run`."""
        return as_json(self.to_data())

    def by_stratum(self, measure: str = "angle", name: str | None = None) -> dict[str, Worst]:
        """The worst error in each stratum where an implementation was asked, the first by default.

        measure: a key of BOUNDS.  Raises InputError for others, and for who was not measured.
        """
        if measure not in MEASURES:
            raise InputError("measure", measure, f"must be one of: {', '.join(MEASURES)}")
        known = {x.removeprefix(PEER): x for x in self.campaign.implementations}
        who = next(iter(known)) if name is None else name.removeprefix(PEER)
        if who not in known:
            raise InputError("name", name, f"must be one of: {', '.join(known)}")
        cells = self.tally.view(known[who], measure, "stratum")
        return {
            stratum: Worst.of(cells[stratum])
            for stratum in self.campaign.strata
            if stratum in cells
        }

    @property
    def conclusion(self) -> str:
        """What was found, in a sentence."""
        campaign = self.campaign
        strata = campaign.strata
        shares = {name: max(self.share(name, x) for x in strata) for name in campaign.judged}
        used = ", ".join(f"{name} uses {share:.0%}" for name, share in shares.items())
        states = sum(self.tally.states.values())
        kept = "Every bound is kept" if self.passed else "BOUNDS ARE BROKEN"
        return f"{kept} at {states} states of {len(strata)} strata: of what is allowed, {used}."

    def __repr__(self) -> str:
        return f"<ValidationReport, {PASSED if self.passed else BROKEN}: {self.command}>"

    def _repr_html_(self) -> str:
        return report_html(self)

    def _file(self, failure: Failure) -> str | None:
        """Where the case of a failure lies; None where it is one that is drawn."""
        return None if self.campaign.user_integrators else failure.file

    def _implementation(self, name: str) -> report_data.Implementation:
        campaign, peer = self.campaign, name.startswith(PEER)
        digest = None if peer else campaign.digests[campaign.targets.index(name)]
        sizes = {
            stratum: {
                m: {
                    part: cell.count
                    for part, cell in self.tally.view(name, m, f"sizes: {stratum}").items()
                }
                for m in DRAWN
            }
            for stratum in campaign.strata
        }
        return {
            "name": name,
            "peer": peer,
            "digest": digest,
            "passed": all(self.share(name, stratum) <= 1 for stratum in campaign.strata),
            "strata": self._by_measure(name, "stratum"),
            "shares": self._by_measure(name, "share"),
            "share": {stratum: _figure(self.share(name, stratum)) for stratum in campaign.strata},
            "regimes": self._by_measure(name, "regime"),
            "sizes": sizes,
            "distance": self._drawn(name, "distance"),
            "turned": self._drawn(name, "turned"),
            "condition": self._drawn(name, "condition"),
        }

    def _replay(self, case: str) -> Iterator[str]:
        campaign = self.campaign
        if campaign.user_integrators:
            stratum, _, index = case.rpartition(":")
            name = campaign.user_integrators[0]
            sample = f"draw({stratum!r}, {index}, {campaign.seed})"
            yield f"measure_case({sample}, {campaign.digits}, {{{name!r}: {_variable(name)}}})"
            return
        yield from ("rigidsym validate", *campaign.targets, "--case", shlex.quote(case))
        yield from (f"--digits {campaign.digits}", f"--seed {campaign.seed}")
        yield from (f"--peer {name}" for name in campaign.peers)

    def _drawn(self, name: str, view: str) -> report_data.Cells:
        """Measures, of each the parts of a view."""
        return {measure: _cells(self.tally.view(name, measure, view)) for measure in DRAWN}

    def _by_measure(self, name: str, view: str) -> report_data.Cells:
        """Parts of a view, of each its measures."""
        parts: dict[str, dict[str, report_data.Cell]] = {}
        for measure in MEASURES:
            for part, cell in _cells(self.tally.view(name, measure, view)).items():
                parts.setdefault(part, {})[measure] = cell
        return parts

    def _case(self, finding: Finding, file: str | None = None) -> report_data.Case:
        """A case, by its file in the directory of the report where it is not one that is drawn."""
        sample, reference = finding.sample, finding.reference
        name = f"{sample.stratum}:{sample.index}"
        return {
            "case": name,
            "regime": reference.regime.value,
            "distance": _figure(reference.distance),
            **hexadecimal(sample),
            "errors": {
                implementation: {measure: _worst(found) for measure, found in errors.items()}
                for implementation, errors in finding.errors.items()
            },
            "replay": " ".join(self._replay(file or name)),
        }


def _variable(name: str) -> str:
    """A name as Python may have it."""
    return re.sub(r"\W", "_", name)


def as_json(data: report_data.Report) -> str:
    """Data of a report as text, in the order of its keys."""
    return json.dumps(data, indent=1, sort_keys=True, allow_nan=False) + "\n"


def _cells(cells: Mapping[str, Cell]) -> dict[str, report_data.Cell]:
    return {part: _cell(cell) for part, cell in cells.items()}


def _cell(cell: Cell) -> report_data.Cell:
    """A cell; of shares, `units` is the part of the bound, and `count` what was beyond it."""
    stratum, index, time = cell.place
    return {
        "count": cell.count,
        "units": _figure(cell.worst),
        "condition": _figure(cell.condition),
        "case": f"{stratum}:{index}",
        "t": float(time).hex(),
    }


def _worst(found: Errors) -> report_data.WorstError:
    k = int(found.units.argmax())
    return {
        "units": _figure(found.units[k]),
        "condition": _figure(found.condition[k]),
        "share": _figure(found.share[k]),
        "t": float(found.times[k]).hex(),
    }


def _figure(value: float) -> report_data.Figure:
    """Three digits; "inf" for what JSON has no number for."""
    text = f"{value:.3g}"
    return text if text in ("inf", "nan") else float(text)
