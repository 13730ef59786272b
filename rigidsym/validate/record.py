"""Worst errors by stratum, kept beside the generators for the heads of the modules they print.

They are figures of exactly one code: its digest is kept with them, and a head has none where they
belong to another.
"""

import json
from pathlib import Path
from typing import TypedDict

from rigidsym.codegen import forms, generate
from rigidsym.codegen.header import MEASURED_FILE
from rigidsym.errors import InputError
from rigidsym.io.files import write_text
from rigidsym.validate.bounds import ULP
from rigidsym.validate.report import ValidationReport
from rigidsym.validate.strata import STRATA
from rigidsym.validate.tally import DRAWN


class Measured(TypedDict):
    """What was measured of a target; worst: stratum, then errors by the measures drawn."""

    digest: str
    command: str
    worst: list[list[str | float]]


def record(report: ValidationReport) -> Path:
    """Keep the figures of a report; raises InputError unless today's code was measured."""
    known: dict[str, Measured] = {}
    if MEASURED_FILE.is_file():
        known = json.loads(MEASURED_FILE.read_text("utf-8"))
    campaign = report.campaign
    if not report.passed:
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
            [stratum, *(_digits(view[stratum].worst) for view in views)]
            for stratum in campaign.strata
        ]
        drawn = f"--cases {campaign.cases} --digits {campaign.digits} --seed {campaign.seed}"
        command = f"rigidsym validate {target} {drawn} --record"
        known[target] = {"digest": digest, "command": command, "worst": worst}
    return write_text(MEASURED_FILE, json.dumps(known, indent=1, sort_keys=True) + "\n")


def _digits(units: float) -> float:
    return float(f"{units * ULP:.1e}")
