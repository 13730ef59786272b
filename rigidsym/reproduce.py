"""The main job: derive, check, generate, validate on the paper's body, and report."""

import json
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter
from typing import TypeVar

from rigidsym import inputs
from rigidsym.codegen import TARGETS, Generated, generate
from rigidsym.codegen.seal import seal, seal_text
from rigidsym.errors import InputError
from rigidsym.io.cases import Case, paper_case
from rigidsym.io.files import write_text
from rigidsym.proof.derivation import Derivation, derive
from rigidsym.proof.paper import Ruling, Verdict, verdicts
from rigidsym.solution import Solution, load
from rigidsym.validate import ValidationReport, validate
from rigidsym.view.svg import Panel, svg

Say = Callable[[str, str, float, bool], None]
Progress = Callable[[str], Callable[[int, int], None]]
Found = TypeVar("Found")


@dataclass(frozen=True, slots=True)
class Reproduction:
    """Everything one run found."""

    derivation: Derivation
    checked: bool
    generated: tuple[Generated, ...]
    current: bool
    validation: ValidationReport
    verdicts: tuple[Verdict, ...]

    @property
    def passed(self) -> bool:
        """All proved, replayed, current and valid."""
        return self.checked and self.current and self.validation.passed


def reproduce(directory: Path, say: Say, progress: Progress) -> Reproduction:
    """Run every stage and write the results into a directory; `say` hears of each stage,
    `progress` names a stage and gets what is done of it and the total.

    Raises InputError where the directory cannot be written and DerivationError where a proof
    fails; what an earlier run has written stays until its successor is complete.
    """
    derivation, seconds = _timed(lambda: derive(progress=progress("derive")))
    claims = sum(len(chapter.facts) for chapter in derivation.chapters)
    say("derive", f"{claims} facts in {len(derivation.chapters)} chapters", seconds, True)
    ledger = write_text(directory / "ledger.json", derivation.ledger)

    checked, seconds = _timed(lambda: _replayed(ledger))
    say("check", "certificates replayed in a fresh process", seconds, checked)

    generated, seconds = _timed(lambda: _all_targets(load(derivation.ledger)))
    current = all(module.files == generate(target).files for target, module in generated.items())
    same = "the same as" if current else "NOT the same as"
    say("codegen", f"{', '.join(TARGETS)}: sealed, {same} what is installed", seconds, current)

    show = progress("validate")
    # The last digits of the C module depend on the machine, and the report must not.
    validation, seconds = _timed(lambda: validate(["numpy"], workers=None, progress=show))
    states, strata = sum(validation.tally.states.values()), validation.campaign.strata
    share = max(validation.share("numpy", stratum) for stratum in strata)
    found = f"{states} states in {len(strata)} strata, {share:.0%} of the bounds used"
    say("validate", found, seconds, validation.passed)

    ruled = tuple(verdicts(json.loads(derivation.ledger)))
    modules = tuple(generated.values())
    # How and where it was run is not to be in what is written.
    validation = replace(validation, run={})
    result = Reproduction(derivation, checked, modules, current, validation, ruled)
    for module in modules:
        module.write(directory)
    write_text(directory / "validation.json", validation.to_json())
    write_text(directory / "validation.md", validation.to_markdown())
    write_text(directory / "motion.svg", plot(paper_case()))
    write_text(directory / "report.md", report(result))
    return result


def _all_targets(solution: Solution) -> dict[str, Generated]:
    """Every module, after the kernel has decided that it is what was derived."""
    seal(solution)
    generated = {target: generate(target, solution) for target in TARGETS}
    for module in generated.values():
        seal_text(module, solution)
    return generated


def _timed(stage: Callable[[], Found]) -> tuple[Found, float]:
    start = perf_counter()
    return stage(), perf_counter() - start


def _replayed(ledger: Path) -> bool:
    command = [sys.executable, "-m", "rigidsym", "check", str(ledger)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def plot(case: Case) -> str:
    """Quaternion and body rates of a motion over time, by the generated module."""
    times = [float(t) for t in case.times]
    if not times:
        raise InputError("times", "[]", "a plot needs at least one time")
    q, omega = case.motion(times)
    quaternion = {f"q{k}": q[:, k].tolist() for k in range(4)}
    rates = {f"Omega{k + 1}": omega[:, k].tolist() for k in range(3)}
    return svg(
        [
            Panel("Attitude, body to inertial", "t (s)", "quaternion", times, quaternion),
            Panel("Body rates", "t (s)", "rad/s", times, rates),
        ]
    )


def report(result: Reproduction) -> str:
    """One page: what is proved, what the paper's equations are worth, how good the module is."""
    paper = paper_case().motion
    rulings = {ruling: sum(v.ruling == ruling for v in result.verdicts) for ruling in Ruling}
    counted = ", ".join(f"{count} {ruling}" for ruling, count in rulings.items() if count)
    chapters = [
        f"| {chapter.name} | {chapter.title} | {len(chapter.facts)} |"
        for chapter in result.derivation.chapters
    ]
    return "\n".join(
        [
            "# rigidsym reproduce",
            "",
            "Written by `rigidsym reproduce`.  The motion below is the paper's spacecraft: inertia "
            f"{inputs.shown(paper.inertia)} kg m^2, rates {inputs.shown(paper.omega0)} rad/s at "
            "t = 0.",
            "",
            "![attitude and rates](motion.svg)",
            "",
            "## Proved",
            "",
            "Each fact is decided by normal form, or graded ENCLOSED where it rests on a classical "
            "identity that balls agree with; `ledger.json` holds the certificates, "
            f"{'accepted' if result.checked else 'REFUSED'} by `rigidsym check` in a process of "
            "its own.",
            "",
            "| chapter | | facts |",
            "|---|---|---|",
            *chapters,
            "",
            f"The paper's equations: {counted} (`rigidsym errata`).",
            "",
            "## Generated",
            "",
            *(
                f"* `{name}`, sha256 {digest}"
                for module in result.generated
                for name, digest in module.manifest["sha256"].items()
            ),
            "",
            "`numpy.map.json` and `c.map.json` give the equations of each line."
            + ("" if result.current else "  These are NOT the modules that are installed."),
            "",
            result.validation.to_markdown().replace("# Validation", "## Validation", 1),
        ]
    )
