"""What the command does around a validation: begin or resume it, and write its report."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TypedDict

from rigidsym import engines
from rigidsym.errors import InputError
from rigidsym.io.files import write_text
from rigidsym.validate import case_file, checkpoint
from rigidsym.validate.campaign import CASES, DIGITS, SEED, Campaign, Progress
from rigidsym.validate.finding import Finding, measure_case
from rigidsym.validate.markdown import markdown
from rigidsym.validate.report import FAILURES, ValidationReport, as_json
from rigidsym.validate.strata import STRATA, Sample, count, draw
from rigidsym.view.validation import page


class Chosen(TypedDict):
    """The arguments of `Campaign.of` that a user can choose."""

    targets: Sequence[str]
    peers: Sequence[str]
    strata: Sequence[str]
    cases: int
    digits: int
    seed: int


class Choices(TypedDict, total=False):
    """Some of them."""

    targets: Sequence[str]
    peers: Sequence[str]
    strata: Sequence[str]
    cases: int
    digits: int
    seed: int


_DEFAULTS: Chosen = {
    "targets": engines.ENGINES,
    "peers": (),
    "strata": (),
    "cases": CASES,
    "digits": DIGITS,
    "seed": SEED,
}


def begin(chosen: Choices, directory: Path | None, resume: bool) -> tuple[Campaign, Progress]:
    """A new campaign of what is chosen, or the unfinished one of a directory.

    Raises InputError where that is another campaign, or would be lost.
    """
    if not resume:
        if directory and (directory / checkpoint.NAME).exists():
            rule = f"holds an unfinished campaign: --resume goes on, or remove {checkpoint.NAME}"
            raise InputError("output", directory, rule)
        wanted: Chosen = {**_DEFAULTS, **chosen}
        return Campaign.of(**wanted), Progress()
    if directory is None:
        raise InputError("resume", "nowhere", "needs -o DIR, the directory of the campaign")
    found, progress = checkpoint.load(directory)
    known: Chosen = {
        "targets": found.targets,
        "peers": found.peers,
        "strata": found.strata,
        "cases": found.cases,
        "digits": found.digits,
        "seed": found.seed,
    }
    same: Chosen = {**known, **chosen}
    checkpoint.check_same(directory, found, Campaign.of(**same))
    return found, progress


def write(report: ValidationReport, directory: Path) -> Path:
    """JSON, Markdown and the page; failing cases as case files. Returns the page's path."""
    data = report.to_data()
    # Those of an earlier report would be taken for this one's.
    for old in directory.glob(f"{FAILURES}/*/*.toml"):
        old.unlink()
    for failure in report.failures:
        remarks = (failure.line, "the simplest case found that breaks this bound")
        case_file.write(directory / failure.file, failure.simplest.sample, remarks)
    write_text(directory / "validation.json", as_json(data))
    write_text(directory / "validation.md", markdown(data))
    return write_text(directory / "validation.html", page(data))


def replay(name: str, campaign: Campaign) -> Finding:
    """One case of a campaign, by a name such as "uniform:7", or that of a case file; raises
    InputError for neither."""
    sample = case_file.read(name) if name.endswith(".toml") else _drawn(name, campaign.seed)
    return measure_case(sample, campaign.digits, campaign.implementations)


def _drawn(name: str, seed: int) -> Sample:
    stratum, _, number = name.rpartition(":")
    if stratum not in STRATA:
        rule = f"must be FILE.toml or STRATUM:INDEX, with one of: {', '.join(map(repr, STRATA))}"
        raise InputError("case", name, rule)
    most = count(stratum, 10**9)
    if not re.fullmatch(r"[0-9]{1,9}", number) or int(number) >= most:
        raise InputError("case", name, f"must end in a whole number below {most}")
    return draw(stratum, int(number), seed)
