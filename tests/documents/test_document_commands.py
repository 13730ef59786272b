"""Every command that a document names is run, with small sizes where it takes sizes.

`document_texts.commands` collects them.  What is not run here stands in `NOT_RUN` with the reason.
"""

import json
import re
import shlex
import shutil
import subprocess
import sys
from functools import cache

import pytest
import six_files
from document_texts import ROOT, blocks, commands

from rigidsym._cli import main, parser

TESTS = re.compile(r"pytest|bash .ci/run")
NAME = "it names a command that needs arguments; it is run with them"
# Commands by the reason; `uv run`, `time` and `nice` before them are left out.
_NOT_RUN = {
    NAME: (
        "rigidsym codegen", "rigidsym export", "rigidsym fit", "rigidsym init", "rigidsym plan",
        "rigidsym propagate", "rigidsym trace", "rigidsym track", "rigidsym validate --case",
    ),
    "it installs packages": (
        "python3 -m venv .venv", ". .venv/bin/activate", "pip install uv", "pip install -e .",
        'pip install -e ".[lab]"', "pip install pre-commit", "pre-commit install",
        'pip install "rigidsym[jax]"', 'pip install "rigidsym[torch]"',
        "uv sync --group all", "apt-get install chromium chromium-driver",
        "apt-get install texlive-latex-recommended",
    ),
    "minutes; tests/engines/test_wheels.py builds all wheels by it": (
        "python -m rigidsym._engines.wheels -o dist",
    ),
    "it makes a wheel of pure Python, as tests/engines/test_wheels.py does": (
        "uv build", "pip install .",
    ),
    "other commands follow it": ("uv run", "uv run --no-sync"),
    "it writes into the checkout": (
        "rigidsym derive --in-place", "rigidsym codegen TARGET --in-place",
        "rigidsym validate numpy c --cases 200 --record",
    ),
    "tests/conftest.py derives every chapter once (`reproduced`)": (
        "rigidsym reproduce", "rigidsym derive", "rigidsym derive pi_form",
    ),
    "tests/cli/test_cli.py replays the sealed ledger by it": (
        "rigidsym check", "rigidsym check --independent",
    ),
    "tests/proof/test_mutants.py runs a sample of it": ("rigidsym check --mutants",),
    "tests/derivations/test_specification.py runs it": ("rigidsym audit", "rigidsym audit --json"),
    "tests/cli/test_cli.py writes targets, and compares all modules": (
        "rigidsym codegen --check", "rigidsym codegen c --check",
        "rigidsym codegen c -o attitude",
        "rigidsym codegen c --single-file -o DIR", "rigidsym codegen c --single-file -o attitude",
        "rigidsym codegen c --single-file -o src/attitude",
        "rigidsym codegen c --single-file -o src/attitude --check",
        "rigidsym codegen c --form pi -o DIR", "rigidsym codegen numpy --form pi -o DIR",
        "rigidsym codegen c --form step -o DIR", "rigidsym codegen javascript -o DIR",
        "rigidsym codegen rust -o DIR",
        "rigidsym codegen c_single -o DIR",
    ),
    "tests/codegen/test_flight_profile.py writes these files, and runs the checks": (
        "rigidsym codegen c --profile flight -o DIR", "make -C DIR report",
        "make report", "make test",
    ),
    "tests/cli/test_front_door.py runs it for every shell": ("rigidsym completion",),
    "tests/manoeuvre/test_commands.py runs it": ("rigidsym figures", "rigidsym figures -o figures"),
    "minutes; tests/manoeuvre/comparison/test_compare.py runs it for one manoeuvre": (
        "rigidsym compare", "rigidsym compare -o compare",
    ),
    "half a minute; tests/validate/test_forms.py compares forms for few cases": (
        "rigidsym compare-forms", "rigidsym compare-forms -o DIR",
    ),
    "tests/cli/test_cli.py runs it for a case of its own": (
        "rigidsym methods", "rigidsym methods --digits 50 1000",
    ),
    "minutes of Coq, which .ci/coq runs; tests/proof/coq/test_coq.py checks theorems": (
        "bash .ci/coq", "make -C DIR plain", "make -C DIR computed", "make -C DIR published",
        "rigidsym export coq -o DIR --check",
    ),
    "tests/notebooks/test_notebooks.py executes notebooks": (
        "python notebooks/build.py", "python notebooks/build.py --check",
    ),
    "the target is one that the notebook writes": (
        "rigidsym codegen floats --in-place", "rigidsym validate floats",
    ),
    "tests/notebooks/test_site.py builds a site by it": ("python notebooks/site/build.py",),
    "tests/documents/test_document_links.py draws it twice": ("python notebooks/site/picture.py",),
    "it does not end; tests/notebooks/test_browser.py opens its pages": ("jupyter lab notebooks",),
    "minutes; tests/validate/faults/test_faults.py has its faults": ("rigidsym validate --faults",),
    "extra bench; tests/validate/test_peers.py": ("rigidsym validate --peer heyoka --peer orekit",),
    "it needs a cluster; tests/validate/test_cluster.py has one": (
        "rigidsym validate --cases 1_000_000 -o campaign --scheduler tcp://host:8786",
    ),
    "tests/documents/test_document_blocks.py compiles by it": (
        "cc -std=c99 -O3 -ffp-contract=off -fno-math-errno -fno-trapping-math "
        "main.c torque_free.c -lm",
    ),
}  # fmt: skip
NOT_RUN = {command: reason for reason, named in _NOT_RUN.items() for command in named}
NOT_RUN |= {command: "it runs tests" for command in commands() if TESTS.match(command)}
# A line with facts, whatever is generated above it.
_TRACED = json.loads((ROOT / "rigidsym" / "generated" / "c.map.json").read_text("utf-8"))["lines"]
_LINE = next(one["line"] for one in _TRACED["torque_free.c"] if one["facts"])
# What stands for a placeholder.
GIVEN = {"LINE": str(_LINE), "NUMBER": "10", "FILE": "torque_free.py", "TARGET": "c",
         "COMMAND": "check", "NAME": "dop853"}  # fmt: skip
# By beginning: the options that are given last, and so count, to what takes sizes.
SMALL = {
    r"python tests/benchmarks/": "--quick",
    r"python notebooks/site/export.py": "howto_fifty_digits -o exported",
    r"rigidsym validate(?!.* --(case |torques))": "--cases 1 --stratum uniform",
    r"rigidsym validate(?!.* --(case|fits|sensitivity|torques))": "--workers 1",
    r"rigidsym validate --torques": "--cases 1 --stratum smooth",
    r"rigidsym fit": "--starts 200",
    r"rigidsym export": "--ledger part.json",
    r"rigidsym derive(?! --show \w)(?!.*--lagrangian)": "lie_algebra",
}


def smallest(command):
    """Return a documented command as it is run here."""
    command = re.sub(r"\b[A-Z]{4,}\b", lambda word: GIVEN.get(word[0], word[0]), command)
    command = re.sub(r" --cases \S+|(?<=\.py) \d+", "", command)
    more = [options for start, options in SMALL.items() if re.match(start, command)]
    return " ".join([command, *more])


@cache
def run_here():
    """Return the commands to run; prefer a form with `-o` to the same without."""
    written = {}
    for command in map(smallest, commands().keys() - NOT_RUN.keys()):
        bare = re.sub(r" -o \S+", "", command)
        written[bare] = max(command, written.get(bare, bare), key=lambda one: (len(one), one))
    return sorted(written.values())


def test_what_is_not_run_is_documented_and_its_reason_is_there():
    assert not NOT_RUN.keys() - commands().keys()
    for command, reason in NOT_RUN.items():
        for path in re.findall(r"(?:tests|notebooks|\.ci)/[\w./]+\b", f"{command} {reason}"):
            assert (ROOT / path).is_file(), (command, path)


@pytest.mark.parametrize("command", sorted(x for x in NOT_RUN if x.startswith("rigidsym ")))
def test_a_command_line_that_is_not_run_is_understood(command):
    if NOT_RUN[command] == NAME:
        assert any(one.startswith(f"{command} ") for one in [*run_here(), *NOT_RUN])
    elif command != "rigidsym completion":
        command = command.replace("TARGET", GIVEN["TARGET"])
        assert parser().parse_args(shlex.split(command)[1:]).command


def test_commands_are_found_in_every_kind_of_document():
    documents = {name.rpartition("/")[0] for name in commands().values()}
    assert documents >= {"", "notebooks/site/pages", "notebooks/text"}
    assert len(run_here()) > 60


def test_every_benchmark_is_named_and_run():
    scripts = [path for path in (ROOT / "tests" / "benchmarks").glob("*.py")
               if "__main__" in path.read_text("utf-8")]  # fmt: skip
    run = " ".join(run_here())
    assert [path.name for path in scripts if f"benchmarks/{path.name} " not in run] == []


# What runs the modules of some targets.
TOOLS = {"javascript": "node", "rust": "rustc"}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Return a folder to work in, with the files that documents speak of."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "satellite.toml").write_text(blocks("toml", "use.md")[0])
    (manoeuvre,) = blocks("toml manoeuvre", "manoeuvres.md")
    (tmp_path / "slew.toml").write_text(f"{manoeuvre}[run]\nlength = 10\n")
    six_files.write(tmp_path / "six")
    return tmp_path


@pytest.mark.usefixtures("replayed_once")
@pytest.mark.parametrize("command", run_here())
def test_a_documented_command_runs(command, folder, capfd):
    program, *arguments = shlex.split(command)
    missing = [tool for name, tool in TOOLS.items() if name in arguments and not shutil.which(tool)]
    if missing:
        pytest.skip(f"needs {missing[0]}")
    if "part.json" in arguments:
        assert main(["derive", "euler_lax", "-o", "part.json"]) == 0
    if program == "rigidsym" and "--help" not in arguments:
        assert main(arguments) == 0
    else:
        start = [sys.executable] if program == "python" else [sys.executable, "-m", program]
        places = [ROOT / one if one.endswith(".py") else one for one in arguments]
        subprocess.run([*start, *places], check=True, cwd=folder)
    silent = {"-o", "-c", "init"} & {*arguments}
    assert silent or "".join(capfd.readouterr())
    assert all((folder / name).exists() for name in re.findall(r" -o (\S+)", command))
