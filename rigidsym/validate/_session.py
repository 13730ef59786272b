"""Files of the command `validate`, such as unfinished campaigns and reports.

Other ones are cases and recorded errors.
"""

import json
import re
from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from rigidsym import _engines as engines
from rigidsym._codegen import forms, generate
from rigidsym._codegen.header import MEASURED_FILE
from rigidsym.errors import InputError, nearest
from rigidsym.io._files import write_text
from rigidsym.validate import _same_bits
from rigidsym.validate._bounds import ULP
from rigidsym.validate._campaign import NAME, Campaign, Progress, check_together
from rigidsym.validate._finding import Finding, case_text, measure_case, read_case
from rigidsym.validate._report import FAILURES, ValidationReport, as_json, markdown
from rigidsym.validate._tally import DRAWN
from rigidsym.validate.strata import STRATA, count, draw
from rigidsym.view._validation import page

# The arguments of `Campaign.of`.
_CHOICES = ("targets", "peers", "strata", "cases", "digits", "seed")


def begin(chosen: Mapping[str, Any], directory: Path | None, resume: bool) -> Progress:
    """Begin a new validation campaign, or resume the unfinished one in a directory.

    chosen: arguments of `Campaign.of`; others have their defaults, or are those of the unfinished
    campaign.  Raises InputError where that is another campaign, or would be lost.
    """
    if not resume:
        if directory and (directory / NAME).exists():
            rule = f"holds an unfinished campaign: --resume goes on, or remove {NAME}"
            raise InputError("output", directory, rule)
        wanted: dict[str, Any] = {"targets": engines.ENGINES, **chosen}
        return Progress(Campaign.of(**wanted), directory=directory)
    if directory is None:
        raise InputError("resume", "nowhere", "needs -o DIR, the directory of the campaign")
    progress = Progress.load(directory)
    found = asdict(progress.campaign)
    expected = asdict(Campaign.of(**{**{name: found[name] for name in _CHOICES}, **chosen}))
    for name, theirs in found.items():
        if theirs != expected[name]:
            rule = f"is another campaign: its {name} {_short(theirs)}, not {_short(expected[name])}"
            raise InputError("resume", directory, rule)
    return progress


def _short(value: object) -> str:
    if isinstance(value, tuple):
        return ", ".join(str(x)[:12] for x in value) or "none"
    return str(value)


def write(report: ValidationReport, directory: Path) -> Path:
    """Write a report and the case files of its failures, and return the path of its page."""
    data = report.to_data()
    # Case files of an earlier report would be taken for this one's.
    for old in directory.glob(f"{FAILURES}/*/*.toml"):
        old.unlink()
    for failure in report.failures:
        remarks = (failure.line, "the simplest case found that breaks this bound")
        write_text(directory / failure.file, case_text(failure.simplest.sample, remarks))
    write_text(directory / "validation.json", as_json(data))
    write_text(directory / "validation.md", markdown(data))
    return write_text(directory / "validation.html", page(data))


def replay(name: str, campaign: Campaign) -> Finding:
    """Measure one case, named like "uniform:7" or read from a case file.

    Raises InputError for names of neither.
    """
    check_together(campaign.targets)
    stratum, _, number = name.rpartition(":")
    if name.endswith(".toml"):
        sample = read_case(name)
    elif stratum not in STRATA:
        near = nearest(stratum or name, STRATA)
        rule = f"must be FILE.toml or STRATUM:INDEX, with one of: {', '.join(map(repr, STRATA))}"
        step = f"did you mean '{near}:{number if stratum else 0}'?" if near else ""
        raise InputError("case", name, rule, next_step=step)
    else:
        most = count(stratum, 10**9)
        if not re.fullmatch(r"[0-9]{1,9}", number) or int(number) >= most:
            raise InputError("case", name, f"must end in a whole number below {most}")
        sample = draw(stratum, int(number), campaign.seed)
    return measure_case(sample, campaign.digits, campaign.implementations)


def record(report: ValidationReport) -> Path:
    """Record the worst errors by stratum for the headers of generated modules.

    They belong to one version of the code: its digest is kept with them, and a head has none where
    they belong to another version.  Raises InputError unless today's code was measured.
    """
    known: dict[str, dict[str, Any]] = {}
    if MEASURED_FILE.is_file():
        known = json.loads(MEASURED_FILE.read_text("utf-8"))
    campaign = report.campaign
    # Hashes of bits are recorded, too.
    if not replace(report, other_bits=()).passed:
        raise InputError("record", report.complaints[0], "only what passed is recorded")
    if len(campaign.strata) < len(STRATA):
        raise InputError("record", ", ".join(campaign.strata), "the heads speak of all strata")
    for target, ran in zip(campaign.targets, campaign.digests, strict=True):
        module, form = forms.split(target)
        digest = generate(module, form=form).manifest["digest"]
        if ran != digest:
            command = f"rigidsym codegen {module}{forms.option(form)} --in-place"
            rule = f"is not the module that `{command}` writes now: run that first"
            raise InputError("record", ran[:12], rule)
        views = [report.tally.view(target, measure, "stratum") for measure in DRAWN]
        worst = [
            [stratum, *(float(f"{view[stratum].worst * ULP:.1e}") for view in views)]
            for stratum in campaign.strata
        ]
        alone = replace(report, campaign=replace(campaign, targets=(target,), peers=()))
        known[target] = {"digest": digest, "command": f"{alone.command} --record", "worst": worst}
    if {"c", "c-step"} & {*campaign.targets}:
        _same_bits.record()
    return write_text(MEASURED_FILE, json.dumps(known, indent=1, sort_keys=True) + "\n")
