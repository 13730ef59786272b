"""Worst errors by stratum, kept beside the generators for the heads of the modules they print.

They are figures of exactly one code: its digest is kept with them, and a head has none where they
belong to another.
"""

import json
from pathlib import Path
from typing import Any

from rigidsym.codegen import generate
from rigidsym.codegen.header import MEASURED_FILE
from rigidsym.errors import InputError
from rigidsym.files import write_text
from rigidsym.validate.measure import ULP
from rigidsym.validate.report import ValidationReport


def record(report: ValidationReport, installed: Path) -> Path:
    """Keep the figures of a report; raises InputError where another code than today's was measured.

    installed: the directory of the generated modules, whose maps say which code was run.
    """
    target = report.target
    digest = generate(target).manifest["digest"]
    ran = json.loads((installed / f"{target}.map.json").read_text("utf-8"))["manifest"]["digest"]
    if ran != digest:
        rule = f"is not the module that `rigidsym codegen {target}` writes now: run that first"
        raise InputError("record", ran[:12], rule)
    known: dict[str, Any] = {}
    if MEASURED_FILE.is_file():
        known = json.loads(MEASURED_FILE.read_text("utf-8"))
    worst = [
        [stratum.name, *(_digits(stratum.worst[field]) for field in ("angle", "omega"))]
        for stratum in report.strata
    ]
    drawn = f"--cases {report.cases} --digits {report.digits} --seed {report.seed}"
    command = f"rigidsym validate {target} {drawn} --record"
    known[target] = {"digest": digest, "command": command, "worst": worst}
    return write_text(MEASURED_FILE, json.dumps(known, indent=1, sort_keys=True) + "\n")


def _digits(units: float) -> float:
    return float(f"{units * ULP:.1e}")
