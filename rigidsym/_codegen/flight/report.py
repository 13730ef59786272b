"""Checks of the flight profile's C code, and a report of what they find.

    python3 report.py

in the folder that `rigidsym codegen c --profile flight -o DIR` wrote runs the unit tests, measures
their coverage, the stack, the instructions and the size, checks the rules of MISRA C, and writes
REPORT.md.  The status is 1 if a goal is missed.  It needs GCC, and for some checks Valgrind and
cppcheck; it says which checks it left out.  This script uses the standard library alone.
"""

import json
import re
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

SOURCE, HEADER = "torque_free_flight.c", "torque_free_flight.h"
TEST = "test_torque_free.c"
STRICT = (
    *("-std=c99", "-ffp-contract=off", "-Werror", "-Wall", "-Wextra", "-Wpedantic"),
    *("-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Wvla", "-Wswitch-default"),
)
MOST_LINES, MOST_TEXT, LEAST_BRANCHES = 60, 150_000, 95.0
# Where Debian and others install the addon that checks the rules.
ADDONS = ("lib/*/cppcheck/addons/misra.py", "share/cppcheck/addons/misra.py")
# What cppcheck cannot read from the system's headers.
KNOWN = ("FLT_RADIX=2", "DBL_MANT_DIG=53", "FLT_EVAL_METHOD=0")
# Unbounded loops, jumps, and memory from the heap.
FORBIDDEN = r"\b(while|do|goto|setjmp|longjmp|malloc|calloc|realloc|free|alloca)\b"


# Rules of MISRA C:2012 that are advisory; all others are required or mandatory.
ADVISORY = {
    *("1.2", "2.3", "2.4", "2.5", "2.6", "2.7", "4.2", "5.9", "8.7", "8.9", "8.11", "8.13", "10.5"),
    *("11.4", "11.5", "12.1", "12.3", "12.4", "13.3", "13.4", "15.1", "15.4", "15.5", "17.5"),
    *("17.8", "18.4", "18.5", "19.2", "20.1", "20.5", "20.10", "21.12"),
}
# A function in a graph of calls, perhaps one of several copies of it.
_NAME = r'(?:[^":]*:)?([\w.]+)'


class LeftOutError(Exception):
    """Error for a check whose tool is missing."""


@dataclass(frozen=True)
class Goal:
    """Goal, what was found, and True if it is met."""

    name: str
    found: str
    is_met: bool


@dataclass
class Check:
    """Section of the report: its title, its text, and the goals that it decides."""

    title: str
    text: list[str] = field(default_factory=list)
    goals: list[Goal] = field(default_factory=list)


class Folder:
    """Folder with the files of the profile, and the builds and measurements of them."""

    def __init__(self, home: Path) -> None:
        self.home, self.build = home, home / "build"
        self.build.mkdir(exist_ok=True)
        self.profile: dict[str, Any] = json.loads((home / "profile.json").read_text("utf-8"))
        self.text = (home / SOURCE).read_text("utf-8").splitlines()

    def run(self, *command: str | Path, may_fail: bool = False) -> str:
        """Run a command in the folder of builds, and return what it prints.

        Raises LeftOutError where the command is missing, and RuntimeError where it fails.
        """
        line = list(map(str, command))
        if shutil.which(line[0]) is None and not (self.build / line[0]).exists():
            raise LeftOutError(f"no {line[0]} here")
        done = subprocess.run(line, capture_output=True, text=True, cwd=self.build, check=False)
        if done.returncode and not may_fail:
            raise RuntimeError(f"{' '.join(line)}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        return done.stdout + done.stderr

    def compile(self, name: str, *flags: str) -> None:
        """Compile a source to an object of the same name."""
        self.run("gcc", "-std=c99", "-ffp-contract=off", *flags, "-c", self.home / name)

    def link(self, name: str, *flags: str) -> None:
        """Link the objects of code and tests to a program."""
        objects = [Path(one).with_suffix(".o").name for one in (SOURCE, TEST)]
        self.run("gcc", *flags, *objects, "-o", name, "-lm")

    @cached_property
    def coverage(self) -> dict[str, Any]:
        """What gcov finds of the code after all unit tests ran."""
        for old in self.build.glob("*.gc??"):
            old.unlink()
        self.compile(SOURCE, "-O0", "--coverage")
        self.compile(TEST, "-O0")
        self.link("covered", "--coverage")
        self.run("./covered")
        data = Path(SOURCE).with_suffix(".gcda").name
        found = json.loads(self.run("gcov", "--json-format", "-b", "-t", data))
        (own,) = (one for one in found["files"] if one["file"].endswith(SOURCE))
        return own


def tested(folder: Folder) -> Check:
    """Compile without a warning, and run the unit tests."""
    folder.compile(SOURCE, "-O2", *STRICT)
    folder.compile(TEST, "-O2")
    folder.link("tests")
    said = folder.run("./tests", may_fail=True)
    ((tests, failures),) = re.findall(r"tests (\d+), failures (\d+)", said)
    goal = Goal("unit tests pass", f"{tests} tests, {failures} failures", failures == "0")
    return Check("Unit tests", [f"* {line}" for line in said.splitlines()], [goal])


def covered(folder: Folder) -> Check:
    """Measure which statements and branches the unit tests reach."""
    lines = folder.coverage["lines"]
    statements = {line["line_number"]: 0 for line in lines}
    branches: dict[int, list[int]] = {}
    for line in lines:
        statements[line["line_number"]] += line["count"]
        branches.setdefault(line["line_number"], []).extend(x["count"] for x in line["branches"])
    unreached = [number for number, count in statements.items() if not count]
    both = [count for counts in branches.values() for count in counts]
    untaken = [number for number, counts in branches.items() if 0 in counts]
    of_statements = 100 * (1 - len(unreached) / len(statements))
    of_branches = 100 * (1 - both.count(0) / len(both))
    reasons = {
        number: _reason(folder, number) for number in sorted({*unreached, *untaken}) if number
    }
    open_ = [number for number, reason in reasons.items() if not reason]
    goals = [
        Goal("statement coverage 100 %", f"{of_statements:.2f} %", of_statements == 100),
        Goal(
            f"branch coverage at least {LEAST_BRANCHES:g} %",
            f"{of_branches:.2f} %",
            of_branches >= LEAST_BRANCHES,
        ),
        Goal("the rest is explained", f"{len(open_)} lines are not", not open_),
    ]
    text = [f"{len(statements)} lines with statements, {len(both)} branches.", ""]
    for number, reason in reasons.items():
        code = folder.text[number - 1].split("/*")[0].strip()
        text.append(f"* line {number}, `{code}`: {reason or '**not explained**'}")
    return Check("Coverage", text, goals)


def _reason(folder: Folder, number: int) -> str:
    """Return why the unit tests do not reach a line, or one of its branches; "" if not known."""
    known: dict[str, str] = folder.profile["unreached"]
    code = folder.text[number - 1].strip()
    return next((why for pattern, why in known.items() if re.search(pattern, code)), "")


def shaped(folder: Folder) -> Check:
    """Measure the functions, and look for loops that nothing bounds, jumps and the heap."""
    sizes = {
        one["name"]: one["end_line"] - one["start_line"] + 1 for one in folder.coverage["functions"]
    }
    longest = max(sizes, key=lambda name: sizes[name])
    code = re.sub(r"/\*.*?\*/", "", "\n".join(folder.text), flags=re.DOTALL)
    found = sorted({*re.findall(FORBIDDEN, code)})
    goals = [
        Goal(
            f"functions have at most {MOST_LINES} lines",
            f"{sizes[longest]} ({longest})",
            sizes[longest] <= MOST_LINES,
        ),
        Goal(
            "no unbounded loop, jump or heap",
            ", ".join(found) or "none",
            not found,
        ),
    ]
    return Check("Functions", [f"{len(sizes)} functions, {len(code.splitlines())} lines."], goals)


def stacked(folder: Folder) -> Check:
    """Compute the stack that each public function needs, from the calls that it can make."""
    folder.compile(SOURCE, "-Os", "-fno-ipa-icf", "-fstack-usage", "-fcallgraph-info=su")
    text = (folder.build / SOURCE).with_suffix(".ci").read_text("utf-8")
    own = {
        name: int(size)
        for name, size in re.findall(rf'title: "{_NAME}" label: "[^"]*\\n(\d+) bytes', text)
    }
    calls: dict[str, set[str]] = {}
    for one, other in re.findall(rf'sourcename: "{_NAME}" targetname: "{_NAME}"', text):
        calls.setdefault(one, set()).add(other)
    circles: set[str] = set()

    def depth(name: str, above: tuple[str, ...] = ()) -> int:
        if name in above:
            circles.add(name)
            return 0
        below = (depth(other, (*above, name)) for other in calls.get(name, ()))
        return own.get(name, 0) + max(below, default=0)

    public = [name for name in folder.profile["public"] if name in own]
    depths = {name: depth(name) for name in public}
    outside = sorted({x for others in calls.values() for x in others} - own.keys())
    worst = max(depths, key=lambda name: depths[name])
    goals = [
        Goal("no recursion", ", ".join(sorted(circles)) or "none", not circles),
        Goal(
            "stack is bounded", f"{depths[worst]} bytes ({worst})", "__indirect_call" not in outside
        ),
    ]
    rows = [f"| `{name}` | {depths[name]} |" for name in public]
    note = f"At -Os on {_machine(folder)}, without what {', '.join(outside)} need."
    return Check("Stack", [note, "", "| function | bytes |", "| --- | --- |", *rows], goals)


def sized(folder: Folder) -> Check:
    """Measure the size of the code."""
    folder.compile(SOURCE, "-Os", "-fno-pie")
    *_, row = folder.run("size", Path(SOURCE).with_suffix(".o").name).splitlines()
    text, data, bss = map(int, row.split()[:3])
    goals = [
        Goal(f"text at -Os is at most {MOST_TEXT} bytes", f"{text} bytes", text <= MOST_TEXT),
        Goal("no variables of the program", f"{data + bss} bytes", data + bss == 0),
    ]
    found = f"At -Os on {_machine(folder)}: text {text}, data {data}, bss {bss} bytes."
    return Check("Size", [found], goals)


def counted(folder: Folder) -> Check:
    """Count the instructions of each call of a public function in the unit tests."""
    folder.compile(SOURCE, "-O2")
    folder.compile(TEST, "-O2")
    folder.link("tests")
    rows = []
    for name in folder.profile["public"]:
        for old in folder.build.glob("calls.*"):
            old.unlink()
        options = (f"--toggle-collect={name}", f"--dump-after={name}", "--combine-dumps=no")
        # Valgrind rounds to nearest always, so that tests of other directions fail under it.
        folder.run(
            *("valgrind", "--tool=callgrind", *options, "--callgrind-out-file=calls"),
            *("./tests", "states", "steps", "refusals", "words"),
            may_fail=True,
        )
        counts = [
            int(count)
            for dump in folder.build.glob("calls.*")
            for count in re.findall(r"^totals: (\d+)", dump.read_text("utf-8"), re.MULTILINE)
        ]
        called = [count for count in counts if count]
        if called:
            rows.append(f"| `{name}` | {len(called)} | {max(called)} |")
    goal = Goal("instructions are counted", f"{len(rows)} functions", bool(rows))
    head = ["| function | calls | most instructions |", "| --- | --- | --- |"]
    note = f"In the unit tests, at -O2 on {_machine(folder)}, the C library included."
    return Check("Instructions", [note, "", *head, *rows], [goal])


def ruled(folder: Folder) -> Check:
    """Count the reports of cppcheck's MISRA addon, by rules, and look for deviations of each."""
    command = shutil.which("cppcheck")
    if command is None:
        raise LeftOutError("no cppcheck here")
    root = Path(command).resolve().parents[1]
    (addon,) = (path for one in ADDONS for path in root.glob(one))
    defined = [f"-D{one}" for one in KNOWN]
    # The dump is written beside the source.
    for name in (SOURCE, HEADER):
        shutil.copy(folder.home / name, folder.build)
    folder.run(
        *("cppcheck", "--dump", "--std=c99", "--platform=unix64", "--max-configs=1", "-q"),
        *(*defined, SOURCE),
    )
    done = subprocess.run(
        [sys.executable, addon, "-q", "--no-summary", folder.build / f"{SOURCE}.dump"],
        capture_output=True,
        text=True,
        check=False,
    )
    found = re.findall(r":(\d+)\].*\[misra-c2012-([\d.]+)\]", done.stderr + done.stdout)
    reports = Counter(rule for _, rule in found)
    first = {rule: number for number, rule in reversed(found)}
    deviations: dict[str, str] = folder.profile["deviations"]
    advisory = {rule: n for rule, n in reports.items() if rule in ADVISORY}
    required = {rule: n for rule, n in reports.items() if rule not in advisory}
    open_ = {rule: n for rule, n in required.items() if rule not in deviations}
    goals = [
        Goal(
            "required rules of MISRA C:2012 hold, or the deviation is recorded",
            f"{sum(open_.values())} reports without, {sum(required.values())} with",
            not open_,
        )
    ]
    rows = []
    for kind, found_rules, unsaid in (
        ("required", required, "**not recorded**"),
        ("advisory", advisory, ""),
    ):
        for rule, count in sorted(found_rules.items()):
            said = deviations.get(rule, unsaid)
            rows.append(f"| {rule} | {kind} | {count} | {first[rule]} | {said} |")
    head = ["| rule | kind | reports | first line | deviation |", "| --- | --- | --- | --- | --- |"]
    return Check("MISRA C:2012", [*head, *rows], goals)


def _machine(folder: Folder) -> str:
    version = folder.run("gcc", "--version").splitlines()[0]
    return f"{folder.run('gcc', '-dumpmachine').strip()}, {version}"


CHECKS = (tested, covered, shaped, stacked, sized, counted, ruled)


def checks(folder: Folder) -> Iterator[Check]:
    """Yield the results of all checks; a check without its tool says so."""
    for check in CHECKS:
        try:
            yield check(folder)
        except LeftOutError as error:
            title = (check.__doc__ or "").splitlines()[0]
            yield Check(f"Left out: {error}", [title])


def main(home: Path) -> int:
    """Run all checks in a folder, write its report, and return 1 if a goal is missed."""
    folder = Folder(home.resolve())
    found = list(checks(folder))
    goals = [goal for check in found for goal in check.goals]
    lines = ["# Report on the flight profile", "", *folder.profile["about"], ""]
    lines += ["| goal | found | met |", "| --- | --- | --- |"]
    lines += [f"| {x.name} | {x.found} | {'yes' if x.is_met else '**no**'} |" for x in goals]
    for check in found:
        lines += ["", f"## {check.title}", "", *check.text]
    lines += ["", "## Traceability", "", *folder.profile["trace"]]
    (home / "REPORT.md").write_text("\n".join(lines) + "\n", "utf-8")
    for goal in goals:
        print(f"{'met   ' if goal.is_met else 'MISSED'} {goal.name}: {goal.found}")
    for check in found:
        if not check.goals:
            print(check.title)
    return 0 if all(goal.is_met for goal in goals) else 1


if __name__ == "__main__":
    sys.exit(main(Path(__file__).parent))
