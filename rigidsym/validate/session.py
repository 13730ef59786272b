"""What the command does around a validation: begin or resume it, and write its report."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rigidsym import engines
from rigidsym.errors import InputError
from rigidsym.io.files import write_text
from rigidsym.validate import case_file, checkpoint
from rigidsym.validate.campaign import Campaign, Progress
from rigidsym.validate.finding import Finding, measure_case
from rigidsym.validate.markdown import markdown
from rigidsym.validate.report import FAILURES, ValidationReport, as_json
from rigidsym.validate.strata import STRATA, Sample, count, draw
from rigidsym.view.validation import page

# The arguments of `Campaign.of` that a user can choose.
CHOICES = ("targets", "peers", "strata", "cases", "digits", "seed")


def begin(
    chosen: Mapping[str, Any], directory: Path | None, resume: bool
) -> tuple[Campaign, Progress]:
    """A new campaign of what is chosen, or the unfinished one of a directory.

    Raises InputError where that is another campaign, or would be lost.
    """
    if not resume:
        if directory and (directory / checkpoint.NAME).exists():
            rule = f"holds an unfinished campaign: --resume goes on, or remove {checkpoint.NAME}"
            raise InputError("output", directory, rule)
        defaults: dict[str, Any] = {"targets": engines.ENGINES}
        return Campaign.of(**defaults | dict(chosen)), Progress()
    if directory is None:
        raise InputError("resume", "nowhere", "needs -o DIR, the directory of the campaign")
    found, progress = checkpoint.load(directory)
    known: dict[str, Any] = {name: getattr(found, name) for name in CHOICES}
    checkpoint.check_same(directory, found, Campaign.of(**known | dict(chosen)))
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
