"""Stages of the command `rigidsym reproduce`, from the derivation to the report."""

import json
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from platform import python_version
from time import perf_counter
from typing import Any, TypeVar

from rigidsym import _inputs as inputs
from rigidsym._codegen import TARGETS, Generated, generate
from rigidsym._codegen.seal import seal, seal_text
from rigidsym.errors import InputError
from rigidsym.io._files import write_text
from rigidsym.io.cases import Case, paper_case
from rigidsym.proof.derivation import Derivation, derive, sealed_counts
from rigidsym.proof.paper import Verdict, verdicts
from rigidsym.proof.paper._table import counted, details
from rigidsym.solution import Solution, load
from rigidsym.validate import ValidationReport, validate
from rigidsym.validate._executors import processes
from rigidsym.validate._validation import PACKAGES
from rigidsym.view import _style as style
from rigidsym.view._pages import errata_page, report_markdown, report_page
from rigidsym.view._plots.charts import Panel, panels_svg
from rigidsym.view._validation import page

Say = Callable[[str, str, float, bool], None]
Progress = Callable[[str], Callable[[int, int], None]]
Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class Reproduction:
    """Results of one run of `rigidsym reproduce`."""

    derivation: Derivation
    checked: bool
    generated: tuple[Generated, ...]
    current: bool
    validation: ValidationReport
    verdicts: tuple[Verdict, ...]

    @property
    def passed(self) -> bool:
        """True if the ledger is accepted, the modules are current, and the validation passed."""
        return self.checked and self.current and self.validation.passed


def reproduce(directory: Path, say: Say, progress: Progress) -> Reproduction:
    """Derive, check, generate and validate everything, and write a report to a directory.

    say: is called with each stage, its result, its seconds and whether it passed.  progress: takes
    the name of a stage, and returns a function of the work done and the total.  Raises InputError
    where the directory cannot be written and DerivationError where a proof fails; results of an
    earlier run stay until their successors are complete.
    """
    # A separate process derives while others validate: they read the installed ledger alone, and
    # precision is global, so that threads could not.
    with processes(1) as deriving:
        derived = deriving.submit(_derived)
        # Without C, because the last digits of that module depend on the machine.
        validation, validating = _timed(
            lambda: validate(["numpy"], workers=None, progress=progress("validate"))
        )
        derivation, seconds = derived.result()
    claims = [len(chapter.facts) for chapter in derivation.chapters if chapter.facts]
    say("derive", f"{sum(claims)} facts in {len(claims)} chapters", seconds, True)
    ledger = write_text(directory / "ledger.json", derivation.ledger)

    # The kernel replays in another process while this one generates code.
    command = [sys.executable, "-m", "rigidsym", "check", str(ledger)]
    with ThreadPoolExecutor(1) as beside:
        replayed = beside.submit(
            lambda: _timed(lambda: subprocess.run(command, capture_output=True, check=False))
        )
        generated, generation = _timed(lambda: _all_targets(load(derivation.ledger)))
        process, seconds = replayed.result()
    checked = process.returncode == 0
    say("check", "certificates replayed in a fresh process", seconds, checked)

    current = all(module.files == generate(target).files for target, module in generated.items())
    same = "the same as" if current else "NOT the same as"
    say("codegen", f"{', '.join(TARGETS)}: sealed, {same} what is installed", generation, current)

    states, strata = sum(validation.tally.states.values()), validation.campaign.strata
    share = max(validation.share("numpy", stratum) for stratum in strata)
    found = f"{states} states in {len(strata)} strata, {share:.0%} of the bounds used"
    say("validate", found, validating, validation.passed)

    ruled = tuple(verdicts(json.loads(derivation.ledger)))
    modules = tuple(generated.values())
    # The files do not say how and where they were computed.
    validation = replace(validation, run={})
    result = Reproduction(derivation, checked, modules, current, validation, ruled)
    for module in modules:
        module.write(directory)
    for name, text in _pages(result).items():
        write_text(directory / name, text)
    return result


def _pages(result: Reproduction) -> dict[str, str]:
    """Return the texts of all report files by file name."""
    told, validation = results(result), result.validation
    printed = [(v.equation.number, str(v.ruling), list(details(v))) for v in result.verdicts]
    return {
        "validation.json": validation.to_json(),
        "validation.md": validation.to_markdown(),
        "validation.html": page(validation.to_data()),
        "errata.html": errata_page(counted(result.verdicts), printed),
        "motion.svg": told["picture"],
        "report.md": report(result),
        "report.html": report_page(told),
    }


def _derived() -> tuple[Derivation, float]:
    return _timed(lambda: derive(sealed=sealed_counts()))


def _all_targets(solution: Solution) -> dict[str, Generated]:
    """Generate every numeric module, and verify it against the derivation by the proof kernel."""
    seal(solution)
    generated = {target: generate(target, solution) for target in TARGETS}
    for module in generated.values():
        seal_text(module, solution)
    return generated


def _timed(stage: Callable[[], Value]) -> tuple[Value, float]:
    start = perf_counter()
    return stage(), perf_counter() - start


def plot(case: Case) -> str:
    """Return an SVG plot of a case's attitude and body rates over time."""
    times = [float(t) for t in case.times]
    if not times:
        raise InputError("times", "[]", "a plot needs at least one time")
    # Nothing is compiled for a picture.
    q, omega = case.motion.replace(engine="numpy")(times)
    attitude = dict(zip(style.ATTITUDE, q.T.tolist(), strict=True))
    rates = dict(zip(style.RATES, omega.T.tolist(), strict=True))
    x, three = style.TIME_AXIS, style.AXES
    four = (style.SCALAR, *three)
    return panels_svg(
        [
            Panel("Attitude", x, style.ATTITUDE_AXIS, times, attitude, colours=four),
            Panel("Body rates", x, style.RATES_AXIS, times, rates, colours=three),
        ]
    )


def results(result: Reproduction) -> dict[str, Any]:
    """Return the contents of the report as data."""
    facts = [fact for chapter in result.derivation.chapters for fact in chapter.facts]
    grades = Counter(str(fact.grade) for fact in facts).most_common()
    chapters = [chapter for chapter in result.derivation.chapters if chapter.facts]
    replayed = "accepted" if result.checked else "REFUSED"
    current = "the ones that are installed" if result.current else "NOT those that are installed"
    paper = paper_case().motion
    return {
        "passed": result.passed,
        "headline": "All that is claimed is proved, and the generated code is valid."
        if result.passed
        else "NOT all that is claimed is proved, current and valid.",
        "sentences": (
            f"{len(facts)} facts are decided in {len(chapters)} chapters: "
            f"{', '.join(f'{count} {grade}' for grade, count in grades)}. Their certificates are "
            f"{replayed} by a kernel in a process of its own.",
            f"Of what the paper prints, {counted(result.verdicts)}.",
            f"The kernel has decided that the generated modules ({', '.join(TARGETS)}) are what "
            f"was derived; they are {current}.",
            result.validation.conclusion,
        ),
        "chapters": [(x.name, x.title, str(len(x.facts))) for x in chapters],
        "modules": {
            name: digest
            for module in result.generated
            for name, digest in module.manifest["sha256"].items()
        },
        "motion": f"The paper's spacecraft: inertia {inputs.shown(paper.inertia)} kg m^2, rates "
        f"{inputs.shown(paper.omega0)} rad/s at t = 0.",
        "picture": plot(paper_case()),
        "versions": {"Python": python_version(), **{name: version(name) for name in PACKAGES}},
    }


def report(result: Reproduction) -> str:
    """Return the report as Markdown, including the validation results."""
    validation = result.validation.to_markdown().replace("# Validation", "## Validation", 1)
    return f"{report_markdown(results(result))}\n{validation}"
