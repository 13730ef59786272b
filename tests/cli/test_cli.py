"""The `rigidsym` command: its output, its files, and its errors."""

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from fractions import Fraction
from itertools import chain, product
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import rigidsym
from derivations import CHAPTERS
from rigidsym._cli import main
from rigidsym._codegen import TARGETS, Generated
from rigidsym._codegen.lines import beside
from rigidsym.errors import LedgerError
from rigidsym.io import aem, sampled
from rigidsym.io.cases import load_case, paper_case
from rigidsym.solution import sealed

COMMANDS = ("reproduce", "derive", "check", "export", "errata", "codegen", "trace", "validate",
            "propagate", "methods", "plan", "track", "figures", "fit")  # fmt: skip

CASE = """
inertia = ["0.0109", "0.04", "0.0506"]
omega0 = [0.05, 0.03, -0.02]
times = [0, "0.5", 180.0]
"""


def process(*arguments, **environment):
    """Run the command in a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "rigidsym", *map(str, arguments)],
        capture_output=True, text=True, check=False, env={**os.environ, **environment},
    )  # fmt: skip


def shell(command):
    """Run `rigidsym` in bash, with what follows it."""
    script = f"set -o pipefail; {sys.executable} -m rigidsym {command}"
    return subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=False)


@pytest.fixture
def sealed_once(monkeypatch):
    """Let the kernel decide about each generated module once per test."""
    from rigidsym._codegen import seal

    for name in ("seal", "seal_text"):
        kept, decide = {}, getattr(seal, name)

        def once(*given, kept=kept, decide=decide):
            key = str([x.files if isinstance(x, Generated) else x for x in given if x != sealed()])
            if key not in kept:
                kept[key] = decide(*given)

        monkeypatch.setattr(seal, name, once)


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(CASE)
    return path


def test_help_is_cheap():
    code = (
        "import sys\nfrom rigidsym._cli import main\n"
        "try: main(['--help'])\nexcept SystemExit: pass\n"
        "print(*{'sympy', 'numpy', 'mpmath', 'rich'} & set(sys.modules))"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.rstrip().endswith("bad input") or found.stdout.endswith("\n\n")
    assert all(command in found.stdout for command in COMMANDS)


def test_bad_observations_are_one_line(tmp_path, refused):
    path = tmp_path / "none.csv"
    path.write_text("t,q0,q1,q2,q3\n0,1,0,0,0\n0,1,0,0,0\n")
    assert refused("fit", path, "--sigma", "attitudes=0.1") == (
        "rigidsym fit: line 3, t = '0': is the time of line 2, too: remove one of them, or add "
        "--allow repeated to keep the first"
    )


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_explains_itself(command, run):
    assert "usage: rigidsym " + command in run(f"{command} --help").out


def test_reproduce_leaves_what_is_sealed_and_committed(reproduced):
    """The main job derives and generates the same bytes as other runs."""
    files, package = reproduced / "files", Path(rigidsym.__path__[0])
    generated = [f"{target}.map.json" for target in TARGETS]
    for name in [*generated]:
        written = json.loads((package / "generated" / name).read_text("utf-8"))
        generated += written["manifest"]["sha256"]
    others = {name: package / "generated" / name for name in generated}
    others["ledger.json"] = package.parent / "derivations" / "ledger.json"
    names = {path.relative_to(files).as_posix() for path in files.rglob("*") if path.is_file()}
    figures = {f"validation.{x}" for x in ("json", "md", "html")}
    assert names == {*others, "motion.svg", "report.md", "report.html", "errata.html", *figures}
    for name, other in others.items():
        assert (files / name).read_bytes() == other.read_bytes(), name
    assert not [name for name in names if str(files) in (files / name).read_text()]
    stdout = (reproduced / "stdout").read_text()
    assert all(stage in stdout for stage in ("derive", "check", "codegen", "validate"))
    assert ET.parse(files / "motion.svg").getroot().tag.endswith("svg")


@pytest.mark.slow
def test_reproduce_writes_the_same_bytes_twice(reproduced, tmp_path):
    """Run the whole main job under another hash seed."""
    found = process("reproduce", "-o", tmp_path, PYTHONHASHSEED="2")
    assert found.returncode == 0, found.stderr
    for path in (path for path in (reproduced / "files").rglob("*") if path.is_file()):
        name = path.relative_to(reproduced / "files")
        assert path.read_bytes() == (tmp_path / name).read_bytes(), name


WRITTEN = """
from dataclasses import replace
from rigidsym import generate
from rigidsym._reproduce import Reproduction, report
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.proof.derivation import derive
from rigidsym.proof.paper import verdicts
from rigidsym.validate import validate

modules = tuple(map(generate, ("numpy", "c")))
validation = replace(validate(["numpy"], 2, 20, strata=["rod", "rest"]), run={})
ruled = tuple(verdicts(ledger_data(ledger_text())))
result = Reproduction(derive(["lie_algebra"]), True, modules, True, validation, ruled)
print(validation.to_json(), report(result), *(module.files for module in modules))
"""


def test_what_reproduce_writes_does_not_depend_on_the_hash_seed():
    """Run a small validation and one chapter in two processes with different hash seeds."""
    begun = [
        subprocess.Popen(
            [sys.executable, "-c", WRITTEN], stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        for seed in ("1", "2")
    ]  # fmt: skip
    first, second = (process.communicate()[0] for process in begun)
    assert [process.returncode for process in begun] == [0, 0]
    assert len(first) > 100_000
    assert first == second


def test_derive_some_chapters_reports_them_and_writes_nothing(run):
    captured = run("derive euler_lax --json")
    data = json.loads(captured.out)
    assert [chapter["chapter"] for chapter in data["chapters"]] == ["euler_lax"]
    assert any(fact["source"] == ["6", "15"] for fact in data["chapters"][0]["facts"])
    assert "not written" in captured.err


def test_a_failing_claim_exits_1_and_leaves_the_ledger(monkeypatch, tmp_path, run):
    from derivations import euler_lax

    ledger = tmp_path / "ledger.json"
    ledger.write_text("old")
    monkeypatch.setattr(euler_lax, "Rate", lambda matrix: matrix)
    error = run("derive -o", ledger, status=1).err
    assert "chapter euler_lax: fact body.lax: undecided" in error
    assert "Traceback" not in error
    assert ledger.read_text() == "old"


def test_a_chapter_that_raises_is_one_line(monkeypatch, run):
    from derivations import conjugacy

    monkeypatch.setattr(conjugacy, "derive", lambda builder: 1 / 0)
    said = run("derive conjugacy", status=1).err.splitlines()[-1]
    assert "chapter conjugacy: ZeroDivisionError" in said


@pytest.mark.parametrize("checker", [[], ["--independent"]])
def test_check_accepts_the_sealed_ledger_and_refuses_a_changed_one(checker, tmp_path, run):
    sealed = Path(rigidsym.__path__[0]).parent / "derivations" / "ledger.json"
    assert "accepted" in run("check", sealed, *checker).out
    changed = tmp_path / "ledger.json"
    data = json.loads(sealed.read_text())
    (fact,) = (fact for fact in data["facts"] if fact["id"] == "regular.E_a")
    fact["rhs"] = [fact["rhs"][0].replace("c_ab", "c_ad")]
    changed.write_text(json.dumps(data, indent=1) + "\n")
    error = run("check", changed, *checker, status=1).err
    assert "refused" in error
    assert "fact regular.E_a" in error


@pytest.mark.usefixtures("replayed_once")
def test_errata_tells_the_misprint_in_35(run):
    data = json.loads(run("errata --json").out)
    verdicts = {entry["equation"]: entry for entry in data["equations"]}
    assert verdicts["6"]["verdict"] == "holds"
    assert verdicts["9"]["conditions"] == ["R(0) M(0) = M(0) R(0)"]
    assert verdicts["35"]["verdict"] == "misprint"
    assert verdicts["35"]["counterexample"]["point"]["mu"] == "49/225"
    assert verdicts["35"]["counterexample"]["motion"]["inertia"][2] == "1"
    assert verdicts["12"]["right_as_printed_with"] == ["14"]
    assert "misprint" in run("errata").out


@pytest.mark.usefixtures("replayed_once", "sealed_once")
@pytest.mark.parametrize(
    ("target", "file", "starts"),
    [
        ("numpy", "torque_free.py", '"""Torque-free motion'),
        ("c", "torque_free.c", "/* Torque-free"),
    ],
)
def test_codegen_writes_checks_and_shows_a_difference(target, file, starts, tmp_path, run):
    run("codegen", target, "-o", tmp_path)
    run("codegen", target, "-o", tmp_path, "--check")
    module = tmp_path / file
    module.write_text(module.read_text().replace("m_1 = ", "m_1 = 2 * ", 1))
    assert "m_1 = 2 * " in run("codegen", target, "-o", tmp_path, "--check", status=1).out
    assert run("codegen", target, "--stdout").out.startswith(starts)


@pytest.mark.usefixtures("replayed_once", "sealed_once")
def test_codegen_writes_c_in_a_single_file_and_checks_it(tmp_path, run):
    command = ("codegen c --form step --single-file -o", tmp_path)
    run(*command)
    names = {"torque_free_step.h", "torque_free_step.c", "c-step.map.json"}
    assert {path.name for path in tmp_path.iterdir()} == names
    run(*command, "--check")
    assert "differs" in run("codegen c --form step -o", tmp_path, "--check", status=1).err
    printed = run("codegen c --form step --single-file --stdout").out
    assert printed == "".join((tmp_path / f"torque_free_step.{end}").read_text() for end in "hc")


@pytest.mark.parametrize("options", ["--in-place", "--check"])
def test_the_package_itself_is_not_written_in_single_files(options, refused):
    said = refused("codegen c --single-file", options)
    assert "single-file = the package itself: is for copies: give -o DIR or --stdout" in said


@pytest.mark.usefixtures("replayed_once", "sealed_once")
def test_check_without_a_target_checks_all_modules(tmp_path, run):
    assert run("codegen --check").err == "current\n"
    home = Path(rigidsym.__path__[0]) / "generated"
    every = (path for path in home.rglob("*") if path.is_file() and "__" not in str(path))
    names = [path.relative_to(home).as_posix() for path in every]
    for name in names:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text((home / name).read_text() + "\n")
    said = run("codegen --check -o", tmp_path, status=1).out
    assert len(names) > 20
    assert all(f"--- {tmp_path / name}\n" in said for name in names)


@pytest.mark.usefixtures("sealed_once")
def test_the_ledger_is_replayed_before_modules_are_written(monkeypatch, tmp_path, refused):
    def refusing():
        raise LedgerError("ledger: refused")

    class Here:
        def __init__(self, *_, **__):
            pass

        __enter__, __exit__ = (lambda self: self), (lambda *_: None)

        def submit(self, work):
            return SimpleNamespace(result=work)

    monkeypatch.setattr("rigidsym._cli.code.ProcessPoolExecutor", Here)
    monkeypatch.setattr("rigidsym._cli.code.replayed", refusing)
    assert "ledger: refused" in refused("codegen numpy -o", tmp_path / "new")
    assert not list(tmp_path.iterdir())


def test_trace_goes_both_ways(run):
    places = [line.split(": ")[0] for line in run("trace --equation 34").out.splitlines()]
    assert places
    maps = (Path(rigidsym.__path__[0]) / "generated").glob("*.map.json")
    modules = {name for path in maps for name in json.loads(path.read_text())["lines"]}
    assert len(modules) > 10
    assert {place.split(":")[0] for place in places} == modules
    for place in places:
        assert "(34)" in run("trace", place).out


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        ("--equation 99", "(99) is no equation of the paper, and no source of a line"),
        (
            "--equation '(35)'",
            "no generated line rests on (35), which the paper prints; lines rest on 1, 3, ",
        ),
        ("--equation 'Lemma 2'", "Lemma 2 is no equation of the paper, and no source of a line"),
        ("--equation 'Remark 3'", "no generated line rests on Remark 3, which the paper prints"),
        ("--equation ''", "an empty number is no equation of the paper"),
        ("torque_free.py:1", "torque_free.py:1 is derived from nothing: "),
        ("torque_free.py:0", "torque_free.py has lines 1 to "),
        ("some/where/torque_free.c:99999", "torque_free.c has lines 1 to "),
        ("main.c", "main.c is no generated file: these are torque_free"),
        ("main.c:3", "main.c is no generated file: these are torque_free"),
    ],
)
def test_trace_says_why_it_has_nothing(arguments, line, run):
    said = run(f"trace {arguments}", status=1)
    assert said.out == ""
    assert said.err.startswith(f"rigidsym trace: {line}")
    assert len(said.err.splitlines()) == 1


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("H = ", ["fact", "facts: regular.H", "equations: (6), (15)"]),
        ("tau = ", ["fact", "definitions: regular.tau", "equations: (16), (17)"]),
        ("chi = ", ["fact", "choices: start_signs.chi", "equations: (12)"]),
        (
            "common_8 = 1 + k_c",
            [
                "fact",
                "facts: descended.k_1, descended.mu",
                "definitions: landen.kc_next",
                "equations: DLMF 22.7.1, DLMF 22.7.2",
            ],
        ),
        ("cos_half_theta = ", ["fact", "readings: steady.cos_half_theta", "equations: (3)"]),
        (
            "prolate_motion = ",
            ["fact", "facts: prolate_motion.squares", "equations: (10), (13), (14)"],
        ),
        ("T4_re_0 = ", ["classical", "equations: DLMF 20.2.1, DLMF 20.2.4"]),
        ("v_rate = ", ["arithmetic"]),
    ],
)
def test_trace_tells_what_a_line_is_and_by_what(code, said, run):
    module = Path(rigidsym.__path__[0]) / "generated" / "torque_free.py"
    lines = module.read_text("utf-8").splitlines()
    line = next(k for k, text in enumerate(lines, 1) if text.strip().startswith(code))
    first, *rest = run("trace", f"torque_free.py:{line}").out.splitlines()
    assert first.startswith(code)
    assert rest == said


@pytest.mark.parametrize("file", ["torque_free.py", "some/where/torque_free.c"])
def test_trace_of_a_file_counts_its_lines_as_the_head_does(file, run):
    said = run("trace", file).out
    heads = {".py": "torque_free.py", ".c": "torque_free.h"}
    module = Path(rigidsym.__path__[0]) / "generated" / heads[Path(file).suffix]
    assert said in module.read_text("utf-8")
    counts = [int(line.split()[0]) for line in said.splitlines()[1:]]
    assert counts[:3] == [*counted(Path(file).name)]
    assert 50 < counts[4] <= beside({".py": "numpy", ".c": "c"}[Path(file).suffix])


def counted(file):
    """Count derived lines by their comments."""
    lines = (Path(rigidsym.__path__[0]) / "generated" / file).read_text("utf-8").splitlines()
    for kind in ("fact", "classical", "arithmetic"):
        yield sum(bool(re.search(rf"(  # |; /\* ){kind}(:| \*/|$)", line)) for line in lines)


def test_trace_names_what_rests_on_no_fact(run):
    place = run("trace --equation", "Dekker 1971").out.split(": ")[0]
    _, kind, equations = run("trace", place).out.splitlines()
    assert (kind, equations) == ("arithmetic", "equations: Dekker 1971")


SMALL = "validate numpy --cases 1 --stratum rod --stratum rest --workers 1"


def test_validate_prints_json_and_writes_files(tmp_path, run):
    data = json.loads(run(SMALL, "--digits", "20", "--seed", "3", "--json", "-o", tmp_path).out)
    chosen = [data["campaign"][name] for name in ("cases", "digits", "seed", "strata")]
    assert chosen == [1, 20, 3, ["rest", "rod"]]
    written = json.loads((tmp_path / "validation.json").read_text())
    assert {**written, "run": {}} == {**data, "run": {}}
    names = ["validation.html", "validation.json", "validation.md"]
    assert sorted(path.name for path in tmp_path.iterdir()) == names
    assert "# Validation" in (tmp_path / "validation.md").read_text()


def test_validate_measures_all_targets_in_all_strata_by_default(run):
    table = run("validate --cases 1").out
    assert "validate numpy c --cases 1 --digits 40 --seed 1" in table
    assert "near separatrix, long" in table


def test_a_broken_bound_exits_1_and_leaves_a_case_that_propagate_takes(monkeypatch, tmp_path, run):
    from rigidsym.validate import _measure as measure

    monkeypatch.setitem(measure.BOUNDS, "angle", 1e-17)
    told = run(SMALL, "-o", tmp_path, status=1).err.splitlines()
    broken = [line for line in told if line.startswith("broken: ")]
    assert len(broken) == 2
    assert broken[1].startswith("broken: numpy: rod:0: angle ")
    assert broken[1].endswith("of its bound 1e-17")
    case = tmp_path / "failures" / "numpy" / "rod-0.toml"
    assert "0x" in case.read_text()
    run("propagate", case)
    for name in ("rod:0", case):
        run("validate numpy --case", name, status=1)
    monkeypatch.undo()
    for name in ("rod:0", case):
        run("validate numpy --case", name)


def test_one_case_is_printed_as_json_alone(run):
    data = json.loads(run("validate c --case published:2 --json").out)
    assert (data["schema"], data["case"]) == ("rigidsym.case/2", "published:2")
    assert len(data["errors"]["c"]["angle"]) == len(data["times"]) == len(data["turned"])


def heeding():
    """Handle interrupts, which background jobs of a shell and their children ignore."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def test_an_interrupted_validation_says_how_to_go_on(tmp_path, run):
    """Signals of a terminal and of a batch system end it with the same line."""
    command = [sys.executable, "-m", "rigidsym", "validate", "c", "--cases", "1_000_000"]
    again = [*command, "--resume"]
    for arguments, stop in ((command, signal.SIGINT), (again, signal.SIGTERM)):
        kept = tmp_path / "campaign.json"
        before = kept.stat().st_mtime_ns if kept.exists() else None
        run = [*arguments, "-o", str(tmp_path)]
        with subprocess.Popen(
            run, stderr=subprocess.PIPE, text=True, preexec_fn=heeding
        ) as process:
            # It is written when the campaign begins.
            while not kept.exists() or kept.stat().st_mtime_ns == before:
                assert process.poll() is None
                time.sleep(0.05)
            process.send_signal(stop)
            try:
                said = process.communicate(timeout=600)[1]
            finally:
                process.kill()
        line = r"rigidsym validate: interrupted: \d+ of \d+ cases are kept, --resume goes on .*\n"
        assert re.fullmatch(line, said)
        assert process.returncode == 130
    again = [*again, "-o", str(tmp_path)]
    other = subprocess.run([*again, "--seed", "2"], capture_output=True, text=True, check=False)
    assert other.returncode == 2
    assert other.stderr.count("\n") == 1
    assert "is another campaign: its seed 1, not 2" in other.stderr


def test_propagate_in_three_formats_agrees(case, tmp_path, run):
    table = list(csv.DictReader(run("propagate", case).out.splitlines()))
    data = json.loads(run("propagate", case, "--format", "json").out)
    assert data["schema"] == "rigidsym.states/1"
    out = tmp_path / "states.npz"
    run("propagate", case, "--format", "npz", "-o", out)
    with np.load(out) as loaded:
        arrays = dict(loaded)
    for k, (row, state) in enumerate(zip(table, data["states"], strict=True)):
        numbers = [repr(float(x)) for x in arrays["q"][k]]
        assert [row[f"q{i}"] for i in range(4)] == state["q"] == numbers
        assert [row[f"omega{i}"] for i in (1, 2, 3)] == state["omega"]
        assert float(row["t"]) == float(state["t"]) == arrays["t"][k]
    before = out.read_bytes()
    run("propagate", case, "--format", "npz", "-o", out)
    assert out.read_bytes() == before


def test_propagate_as_an_attitude_ephemeris_message(case, tmp_path, run):
    epoch = ["--format", "aem", "--epoch", "2026-01-01T00:00:00"]
    epoch += ["--creation-date", "2026-01-02T00:00:00"]
    text = run("propagate", case, *epoch).out
    motion, times = load_case(case).motion.replace(engine="c-portable"), [0.0, 0.5, 180.0]
    unknown = {"object_name": "UNKNOWN", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
    unknown["creation_date"] = "2026-01-02T00:00:00"
    assert text == aem(sampled(motion, times), "2026-01-01T00:00:00", **unknown)
    out = tmp_path / "states.aem"
    more = ["--object-name", "MY SAT", "--time-system", "TAI", "--ref-frame-a", "ICRF"]
    run("propagate", case, *epoch, *more, "--no-rates", "-o", out)
    for line in ("OBJECT_NAME = MY SAT", "TIME_SYSTEM = TAI", "REF_FRAME_A = ICRF",
                 "ATTITUDE_TYPE = QUATERNION"):  # fmt: skip
        assert line in out.read_text("ascii").splitlines()


MESSAGE = """
[message]
epoch = 2026-01-01T00:00:00Z
object_name = "NANO"
object_id = "2026-001A"
creation_date = 2026-01-02T03:04:05Z
"""


def test_a_case_names_its_message_and_options_come_first(case, run):
    case.write_text(case.read_text("utf-8") + MESSAGE, "utf-8")
    lines = run("propagate", case, "--format", "aem", "--object-name", "OTHER").out.splitlines()
    for line in ("CREATION_DATE = 2026-01-02T03:04:05", "OBJECT_NAME = OTHER",
                 "OBJECT_ID = 2026-001A", "START_TIME = 2026-01-01T00:00:00.000"):  # fmt: skip
        assert line in lines


def states(run, case, digits):
    data = json.loads(run("propagate", case, "--digits", digits, "--format", "json").out)
    return data["states"]


def test_propagate_to_fifty_digits(case, run):
    fifty, eighty = (states(run, case, digits) for digits in (50, 80))
    for few, many in zip(fifty[1:], eighty[1:], strict=True):
        for a, b in zip(few["q"] + few["omega"], many["q"] + many["omega"], strict=True):
            assert len(a.lstrip("-0.").replace(".", "")) == 50
            assert b.startswith(a[:-2])


UNCERTAIN = CASE.replace("0.0109", "0.0109 +/- 1e-6")


def balls(case, run, *arguments):
    data = json.loads(run("propagate", case, "--enclose", "--format", "json", *arguments).out)
    assert data["schema"] == "rigidsym.states/1"
    numbers = [(s["t"], *s["q"], *s["omega"]) for s in data["states"]]
    return [[(Fraction(x["mid"]), Fraction(x["rad"])) for x in row] for row in numbers]


def holds(found, truth):
    """Return True if all balls contain the middles of others."""
    pairs = zip(chain(*found), chain(*truth), strict=True)
    return all(abs(middle - exact) <= radius for (middle, radius), (exact, _) in pairs)


@pytest.mark.parametrize("method", ["theta", "carlson", "landen", "quadrature"])
def test_enclosures_hold_the_state_and_are_narrow(method, case, run):
    case.write_text(CASE.replace("180.0", '"1/3"'))
    found = balls(case, run, "--digits", "30", "--method", method)
    truth = balls(case, run, "--digits", "60")
    assert found[2][0][0] != Fraction(1, 3)
    assert holds(found, truth)
    assert max(rad for row in found for _, rad in row) <= Fraction(1, 10**29)
    assert any(rad > 0 for row in found for _, rad in row)


def test_enclosures_in_csv_are_those_in_json(case, run):
    found = balls(case, run)
    text = run("propagate", case, "--enclose").out
    assert text.startswith("t_mid,t_rad,q0_mid,q0_rad,")
    table = list(csv.reader(text.splitlines()))[1:]
    assert [[x for ball in row for x in ball] for row in found] == [
        list(map(Fraction, row)) for row in table
    ]
    assert run("propagate", case, "--enclose").out == text


def test_an_empty_table_of_balls_has_their_header(case, run):
    case.write_text(CASE.replace('[0, "0.5", 180.0]', "[]"))
    assert run("propagate", case, "--enclose").out.endswith("omega3_mid,omega3_rad\n")


def test_uncertain_inputs_enclose_every_motion_they_allow(case, run):
    case.write_text(UNCERTAIN)
    found = balls(case, run)
    for moment in ("0.010899", "0.0109", "0.010901"):
        case.write_text(CASE.replace("0.0109", moment))
        assert holds(found, balls(case, run))
    assert max(rad for _, rad in found[2]) > Fraction(1, 10**7)


@pytest.mark.parametrize(
    ("text", "arguments", "status", "message"),
    [
        *((UNCERTAIN, x, 2, "inertia[0] = 0.0109 +/- 0.000001: is uncertain")
          for x in ("", "--digits 20", "--format json")),
        *((x, "--enclose --max-seconds 1e-9", 1, "t = 0: ") for x in (CASE, UNCERTAIN)),
        (UNCERTAIN.replace("1e-6", "1e-3"), "--enclose --method carlson", 1, "too uncertain"),
    ],
)  # fmt: skip
def test_what_is_uncertain_or_late_is_refused(text, arguments, status, message, case, refused):
    """Only --enclose takes uncertain inputs; a time limit and wide inputs exit with 1."""
    case.write_text(text)
    assert message in refused("propagate", case, *arguments.split(), status=status)


def test_wide_inputs_are_enclosed_by_default(case, run):
    case.write_text(UNCERTAIN.replace("1e-6", "1e-3"))
    run("propagate", case, "--enclose")


@pytest.mark.parametrize("method", [(), ("--method", "flow")])
def test_boxes_across_a_boundary_are_enclosed(method, case, run, refused):
    """Methods that need the regime refuse a spin with an uncertain tilt."""
    spin = CASE.replace("[0.05, 0.03, -0.02]", '["{}", 0, "0.5"]')
    assert spin != CASE
    case.write_text(spin.format("0 +/- 1e-9"))
    found = balls(case, run, *method)
    for tilt in ("-1e-9", "0", "1e-9"):
        case.write_text(spin.format(tilt))
        assert holds(found, balls(case, run))
    assert max(rad for row in found for _, rad in row) < Fraction(1, 10**8)
    case.write_text(spin.format("0 +/- 1e-9"))
    error = refused("propagate", case, "--enclose", "--method", "theta")
    assert "the torque by omega0[0] and omega0[2] may be zero" in error


def test_times_beyond_what_python_writes(case, run, refused):
    case.write_text(CASE.replace("180.0", '"1e5000"'))
    assert states(run, case, 20)[-1]["t"].replace("0", "") == "1.E+5"
    assert len(balls(case, run)) == 3
    error = refused("propagate", case)
    assert error.endswith("is beyond the range of binary64")


def test_methods_prints_tables_and_writes_files(case, tmp_path, monkeypatch, run):
    from rigidsym.precise import _comparison as comparison

    monkeypatch.setattr(comparison, "TAYLOR_WORK", 0)
    results, compare = [], comparison.compare

    def compared(*given):
        results.append(compare(*given) if not results else results[0])
        return results[-1]

    monkeypatch.setattr(comparison, "compare", compared)
    case.write_text(CASE.replace("180.0", "2"))
    out = tmp_path / "out"
    arguments = ["methods", case, "--digits", "10", "30"]
    printed = run(*arguments, "-o", out).out
    for word in ("theta", "carlson", "landen", "quadrature", "not run", "separatrix", "1e-30"):
        assert word in printed
    data = json.loads((out / "methods.json").read_text())
    assert data["schema"] == "rigidsym.methods/1"
    assert {m["digits"] for m in data["by_digits"]} == {10, 30}
    assert ET.parse(out / "methods.svg").getroot().tag.endswith("svg")
    assert json.loads(run(*arguments, "--json").out) == data


def test_times_are_printed_as_correct_decimals(case, run):
    case.write_text(CASE.replace('[0, "0.5", 180.0]', '["0.1", "1/3", 0.1, 1e3]'))
    lines = run("propagate", case, "--digits", "30").out.splitlines()[1:]
    times = [line.split(",")[0] for line in lines]
    double = "0.100000000000000005551115123126"
    assert times == ["0.1", "0." + "3" * 30, double, "1000"]


def test_a_chapter_alone_proves_no_theorem(tmp_path, run):
    path = tmp_path / "ledger.json"
    run("derive", CHAPTERS[0], "-o", path)
    for checker in ([], ["--independent"]):
        assert "theorem steady" in run("check", path, *checker, status=1).err.splitlines()[-1]


@pytest.mark.parametrize(
    ("command", "output"),
    [
        *product(["propagate paper"], ["| true", ">&-", "> /dev/null", "| head -1"]),
        *product(["errata", "check", "codegen numpy --stdout"], ["| true"]),
    ],
)
def test_readers_that_do_not_listen(command, output):
    found = shell(f"{command} {output}")
    assert (found.returncode, found.stderr) == (0, "")
    if output.endswith("head -1"):
        assert found.stdout.startswith("t,q0")


def test_a_full_disk_is_one_line():
    found = shell("propagate paper > /dev/full")
    assert found.returncode == 2
    assert found.stderr.splitlines() == ["rigidsym propagate: output: No space left on device"]


def test_terminals_without_our_letters():
    found = process("errata", PYTHONIOENCODING="ascii")
    assert found.returncode == 0
    assert "misprint" in found.stdout


@pytest.mark.parametrize("text", ["", "[]", '{"facts": [], "contexts": []}'])
def test_a_damaged_sealed_ledger_is_one_line(text, monkeypatch, capsys):
    from rigidsym.solution import _formulas as formulas

    monkeypatch.setattr("rigidsym.io.ledger.ledger_text", lambda: text)
    monkeypatch.setattr(formulas, "sealed_text", lambda: text)
    formulas.sealed.cache_clear()
    try:
        for arguments in (
            ["errata"],
            ["codegen", "numpy"],
            ["propagate", "paper", "--digits", "9"],
        ):
            status = main(arguments)
            error = capsys.readouterr().err
            assert status == 2 or (arguments == ["errata"] and "facts" in text)
            assert len(error.splitlines()) == (1 if status else 0)
    finally:
        formulas.sealed.cache_clear()


def test_the_papers_case_ships_with_the_package(run):
    assert len(run("propagate paper").out.splitlines()) == 182
    assert [float(x) for x in paper_case().motion.inertia] == [0.0109, 0.04, 0.0506]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("inertia = [1, 2", "case = the file: is not TOML"),
        (CASE.replace("times", "time"), "case = time: is not one of"),
        (CASE + "start = [1, 0, 0, 0]", "times; `rigidsym plan` reads files that have it"),
        (CASE + "rates = []", "times; `rigidsym fit` reads files that have it"),
        (CASE.replace("inertia", "# inertia"), "inertia = missing"),
        (CASE.replace('"0.04"', '"-0.04"'), "inertia[1] = -0.04: principal moments must be"),
        (CASE.replace('"0.04"', '"0.4"'), "larger than the sum"),
        (CASE.replace('"0.04"', "true"), "inertia[1] = True: must be a number"),
        (CASE.replace("[0.05", "[nan"), "omega0[0] = nan: must be finite"),
        (CASE.replace("180.0", "inf"), "t[2] = inf: must be finite"),
        (CASE + "attitude0 = [0, 0, 0, 0]", "attitude0 = "),
        (CASE + "attitude0 = [1, 0, 0]", "must have 4 numbers, not 3"),
        (CASE.replace("[0, \"0.5\", 180.0]", "3"), "times = 3: must be a list"),
        (CASE.replace("[0, \"0.5\", 180.0]", "{start = 0, stop = 1}"), "start, stop and count"),
        (CASE.replace("[0, \"0.5\", 180.0]", "{start = 0, stop = 1, count = 0}"),
         "times.count = 0: must be a whole number"),
        (CASE.replace('[0, "0.5", 180.0]', "{start = 0, stop = 1, count = 99999999999}"),
         "times.count = 99999999999: must be a whole number"),
        ("a = " + "[" * 3000, "case = the file: is not TOML"),
        ("a = " + "1" * 5000, "case = the file: is not TOML"),
    ],
)  # fmt: skip
def test_bad_case_files_are_one_line(text, message, tmp_path, refused):
    path = tmp_path / "case.toml"
    path.write_text(text)
    out = tmp_path / "out.csv"
    error = refused("propagate", path, "-o", out)
    assert message in error
    assert not out.exists()


@pytest.mark.parametrize(
    ("command", "message"),
    [
        ("propagate nowhere.toml", "cannot be read"),
        ("propagate paper --format npz", "give -o FILE"),
        ("check nowhere.json", "cannot be read"),
        ("derive nowhere", "chapter = nowhere: must be one of: lie_algebra"),
        ("codegen fortran", "target = fortran: must be one of: numpy, c"),
        ("codegen c --profile space -o x", "profile = space: must be one of: flight"),
        ("codegen numpy --profile flight -o x", "profile = flight: is one of C alone"),
        ("codegen c --profile flight", "output = no directory: a profile is several files"),
        ("codegen c --profile flight --form pi -o x", "form = pi: the profile has motions and"),
        ("codegen c --profile flight --single-file -o x", "single-file = given: a profile has"),
        ("codegen fortran --check", "target = fortran: must be one of: numpy, c"),
        ("codegen c --form phi", "form = phi: must be one of: theta, pi, step"),
        ("codegen --form phi --check", "form = phi: must be one of: theta, pi, step"),
        (
            "codegen --stdout",
            f"target = missing: name one, {', '.join(TARGETS)}; --check alone checks all",
        ),
        ("validate fortran", "target = fortran: must be one of: numpy, c"),
        ("validate numpy fortran", "target = fortran: must be one of: numpy, c"),
        ("propagate paper --digits 100001", "digits = 100001: must be a whole number"),
        ("propagate paper --format npz --enclose -o x", "no --enclose"),
        ("propagate paper --enclose --digits 100001", "digits = 100001: must be"),
        ("propagate paper --enclose --method agm", "method = 'agm': must be one of"),
        ("propagate paper --method theta", "method = theta: is for many digits"),
        ("propagate paper --max-seconds 9", "max-seconds = 9.0: is for many digits"),
        ("propagate paper --format aem", "epoch = missing: --format aem needs --epoch"),
        ("propagate paper --format aem --epoch now", "epoch = 'now': must be YYYY"),
        ("propagate paper --epoch 2026-01-01T00:00:00", "is for --format aem"),
        ("propagate paper --format json --no-rates", "no-rates = given: is for --for"),
        ("propagate paper --object-id X", "object-id = X: is for --format aem"),
        ("propagate paper --format aem --epoch x --digits 9", "has 16 digits"),
        ("propagate paper --format aem --epoch x --enclose", "no --enclose"),
        ("methods nowhere.toml", "cannot be read"),
        ("methods --digits 100001", "digits = 100001: must be a whole number"),
        ("methods -o /dev/null/inside", "cannot be written"),
        ("trace", "takes either"),
        *((f"codegen {target}", "output = missing: give -o DIR") for target in TARGETS),
        (f"derive {CHAPTERS[0]} --in-place", "in-place = given: is for all chapters"),
        ("reproduce -o /dev/null/inside", "cannot be written"),
        ("validate -o /dev/null/inside", "cannot be written"),
        ("trace torque_free.py:x", "must be FILE:LINE or FILE"),
        ("", "COMMAND"),
        ("launch", "argument COMMAND: 'launch' must be one of: reproduce"),
        ("validate --cases 0", "'0' must be a whole number, at least 1"),
        ("propagate paper --digits many", "'many' must be a whole number"),
        ("propagate paper --digits 9 --max-seconds 0", "'0' must be a positive"),
        ("propagate paper --digits 9 --max-seconds inf", "'inf' must be a pos"),
        ("methods --digits 0", "'0' must be a whole number"),
        ("propagate paper --format xml", "argument --format: 'xml' must be one of: csv, json"),
        ("propagate paper -o ''", "must name a file or directory"),
        ("propagate paper --digits 99999999999999999999", "must be a whole number"),
        ("validate --case rest:0 --cases 3", "cases = given: is not for --case"),
        ("validate --case rest:0 --scheduler x", "scheduler = given: is not for --case"),
        ("validate --faults --peer dop853", "peer = given: is not for --faults"),
        ("validate --faults --record", "record = given: is not for --faults"),
        ("validate --case rest:0 --faults", "not allowed with argument"),
        ("validate --workers 2 --scheduler x", "not allowed with argument"),
        ("validate --cases 1__0", "must be a whole number"),
        ("validate --cases '٣'", "must be a whole number"),
        ("validate --scheduler ''", "must be an address"),
    ],
)
def test_bad_input_and_usage_exit_2_with_one_line(command, message, refused):
    assert message in refused(command)


@pytest.mark.usefixtures("replayed_once", "sealed_once")
@pytest.mark.parametrize(
    ("command", "more"), [(["propagate", "paper"], ["--format", "csv"]), (["codegen", "numpy"], [])]
)
def test_an_output_that_cannot_be_written_is_one_line(command, more, tmp_path, refused):
    blocker = tmp_path / "file"
    blocker.write_text("here first")
    error = refused(*command, "-o", str(blocker / "inside"), *more)
    assert "output = " in error
    assert "cannot be written" in error
    assert blocker.read_text() == "here first"


def test_an_interrupted_write_leaves_the_old_file(monkeypatch, tmp_path):
    from rigidsym.io import _files as files

    path = tmp_path / "report.md"
    path.write_text("old")

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(files.os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        files.write_text(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_uncertain_cases_are_enclosed_by_the_method_that_is_narrowest(tmp_path, run):
    case = tmp_path / "case.toml"
    case.write_text(
        'inertia = ["0.0109 +/- 1e-9", "0.04", "0.0506"]\n'
        'omega0 = ["0.05", "0.03", "-0.02"]\ntimes = [10]\n'
    )
    ways = ([], ["--method", "flow"], ["--method", "carlson"], ["--method", "theta"])
    radii = [[rad for _, rad in balls(case, run, *method)[0][1:]] for method in ways]
    for default, *others in zip(*radii, strict=True):
        assert all(default <= Fraction(101, 100) * other for other in others)
    assert 100 * max(radii[0]) < min(max(radii[2]), max(radii[3]))
