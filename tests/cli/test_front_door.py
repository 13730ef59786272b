"""Help texts, templates, completion, formats by file name, errata, and conclusions."""

import argparse
import json
import re
import shlex
import sys

import numpy as np
import pytest

import rigidsym
from rigidsym import _engines as engines
from rigidsym._cli import output, parser
from rigidsym.errors import InputError
from rigidsym.io.ledger import ledger_text
from rigidsym.precise import _comparison as comparison
from rigidsym.proof.derivation import sealed_path
from rigidsym.proof.paper import EQUATIONS, Ruling
from rigidsym.validate import _campaign as campaign
from rigidsym.validate.faults import FaultReport, by_hand
from rigidsym.validate.faults import Outcome as FaultOutcome
from rigidsym.validate.faults import _detection as detection

(COMMANDS,) = (action.choices for action in parser()._actions if action.dest == "command")
# Switches, and what is given or not: these have no value by themselves.
SILENT = {"output", "case", "scheduler", "format", "lagrangian", "equation"}


@pytest.mark.parametrize("name", COMMANDS)
def test_help_ends_with_an_example_that_is_understood(name):
    example = COMMANDS[name].format_help().rstrip().splitlines()[-1]
    told = shlex.split(example.partition(">")[0])
    assert told[:2] == ["rigidsym", name]
    assert parser().parse_args(told[1:]).command == name


@pytest.mark.parametrize("name", COMMANDS)
def test_help_says_what_is_so_by_default(name):
    for action in COMMANDS[name]._actions:
        takes_value = action.option_strings and action.nargs != 0 and not action.required
        if takes_value and action.dest not in SILENT:
            said = COMMANDS[name]._get_formatter()._expand_help(action)
            assert re.search(r"default|needed", said), (name, action.dest, said)
        assert action.help is argparse.SUPPRESS or action.help, (name, action.dest)


def test_help_lists_all_names_that_an_option_takes():
    from rigidsym._codegen.forms import FORMS
    from rigidsym._codegen.targets import TARGETS
    from rigidsym.fitting._estimate import LOSSES
    from rigidsym.fitting._problem import INERTIA
    from rigidsym.precise import ESTIMATED, METHODS

    for command, dest, names in (
        ("codegen", "target", TARGETS), ("codegen", "form", FORMS), ("fit", "loss", LOSSES),
        ("fit", "inertia", INERTIA), ("propagate", "method", (*METHODS, *ESTIMATED)),
    ):  # fmt: skip
        (said,) = (str(x.help) for x in COMMANDS[command]._actions if x.dest == dest)
        assert [x for x in names if not re.search(rf"\b{x}\b", said)] == [], (command, dest)


@pytest.mark.parametrize(
    ("command", "near"),
    [
        ("propogate paper", "propagate"), ("propagate paper --enclsoe", "--enclose"),
        ("propagate paper --format jsno", "json"), ("init motoin.toml", "motion.toml"),
        ("propagate paper --digits 20 --method thta", "theta"), ("derive Theta-Form", "theta_form"),
        ("codegen jvascript --stdout", "javascript"), ("codegen c --form Pi --stdout", "pi"),
        ("validate numpy --stratum seperatrix", "separatrix"),
        ("fit t-handle --loss hubr", "huber"),
        ("validate --case separatrx:1", "'separatrix:1'"), ("validate --peer DOP835", "dop853"),
    ],
)  # fmt: skip
def test_a_misspelt_name_is_answered_with_the_nearest(command, near, refused):
    assert f"did you mean {near}?" in refused(command)


TENSOR = [[2.0, 0.1, 0.0], [0.1, 3.0, 0.0], [0.0, 0.0, 4.0]]
START = ([1, 0, 0, 0], [0.1, 0.2, 0.3])
SEEN = [START[0]] * 5


@pytest.mark.parametrize(
    "call",
    [
        lambda tensor: rigidsym.TorqueFreeMotion(tensor, START[1]),
        lambda tensor: rigidsym.propagate(tensor, START[1], [0, 1]),
        lambda tensor: rigidsym.step(tensor, *START, 0.1),
        lambda tensor: rigidsym.integrate(tensor, *START, lambda t, q, w: 0 * w, [0, 1], step=0.1),
        lambda tensor: rigidsym.plan(tensor, START[0], (0, 1, 0, 0), 10),
    ],
)
def test_a_tensor_where_moments_are_expected_names_principal_axes(call):
    for tensor in (TENSOR, np.array(TENSOR), np.diag([1, 2, 2.5])):
        with pytest.raises(InputError, match=r"rigidsym\.principal_axes\(tensor\) has them"):
            call(tensor)


def test_messages_of_a_beginner_say_the_next_step(tmp_path, refused):
    path = tmp_path / "case.toml"
    path.write_text("inertia = [1, 2, 2.5]\nomega0 = [1, 2, 3]\n")
    for command, step in (
        ("propagate papper", "rigidsym init motion.toml"), ("plan nothere.toml", "init slew.toml"),
        ("fit nothere.csv", "init observations.csv"), (f"propagate {path}", "times = [0, 10]"),
    ):  # fmt: skip
        assert step in refused(command)
    for call, step in (
        (lambda: rigidsym.TorqueFreeMotion(2.0, START[1]), "3 of them, about principal axes"),
        (lambda: rigidsym.TorqueFreeMotion([1, 2, 2.5], START[1], np.eye(3)), "from_matrix"),
        (lambda: rigidsym.TorqueFreeMotion([1, 2, 2.5], START[1], [1, 2, 3]), "from_euler"),
        (lambda: rigidsym.principal_axes(np.ones(3)), "3 rows of 3 numbers"),
        (lambda: rigidsym.fit(range(5), attitudes=SEEN, sigma=0.1, inertia=[1, 2, 2]), "moments="),
    ):  # fmt: skip
        with pytest.raises(InputError, match=re.escape(step)):
            call()
    with pytest.raises(AttributeError) as found:
        getattr(rigidsym, "TorqueFreemotion")  # noqa: B009
    assert found.value.obj is rigidsym


def test_a_name_that_is_like_none_is_answered_with_all(refused):
    assert "did you mean" not in refused("codegen fortran --stdout")
    assert "did you mean" not in refused("move --enclose")


def test_a_terminal_gets_a_short_table_and_a_pipe_all_states(tmp_path, monkeypatch, run):
    whole, digits = run("propagate paper").out, run("propagate paper --digits 20").out
    assert len(whole.splitlines()) == len(digits.splitlines()) == 182
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    assert run("propagate paper --format csv").out == whole
    path = tmp_path / "states.csv"
    run("propagate paper -o", path)
    assert path.read_text() == whole
    short = run("propagate paper").out.splitlines()
    assert len(short) == 14
    assert max(map(len, short[:-1])) <= 80
    assert short[2].split() == ["0", *["1.000000", *["0.000000"] * 3], "0.05", "0.03", "-0.02"]
    assert short[-2].startswith("180  0.909666")
    assert short[-1].startswith("10 of 181 states are shown. Write all: -o states.csv")
    for options in ("--digits 20", "--digits 20 --enclose"):
        told = run("propagate paper", *options.split()).out
        assert "2 of 181 states are shown" in told
        assert digits.splitlines()[-1].split(",")[1][:19] in told


def test_defaults_in_words_are_those_in_the_code():
    said = {action.dest: str(action.help) for action in COMMANDS["validate"]._actions}
    for dest, value in (("cases", campaign.CASES), ("digits", campaign.DIGITS),
                        ("seed", campaign.SEED)):  # fmt: skip
        assert said[dest].endswith(f"; {value} by default")
    said = {action.dest: str(action.help) for action in COMMANDS["methods"]._actions}
    assert said["digits"] == f"{' '.join(map(str, comparison.DIGITS))} by default"


@pytest.mark.parametrize("name", ["observations.csv", "observations.toml"])
def test_a_template_of_observations_is_fitted(name, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    run("init", name)
    assert (tmp_path / name).read_text().startswith("# Observations")
    captured = run("fit", name, "--starts", "200", "-o", "found", "--json")
    found = json.loads(captured.out)
    assert (found["schema"], found["converged"]) == ("rigidsym.fit/1", True)
    assert found == json.loads((tmp_path / "found" / "fit.json").read_text())
    run("propagate found/motion.toml")
    page = (tmp_path / "found" / "fit.html").read_text()
    assert all(page.count(word) == 1 for word in (">Correlations<", ">Motions by chi2<"))
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert page.count("<svg") == 2
    assert len(ids) == len(set(ids)), "pictures on a page share no clips and letters"


def test_a_fit_says_what_is_not_observable(run):
    told = run("fit t-handle --starts 200").out
    assert "not observable: attitude 1, attitude 2, attitude 3" in told
    assert "the largest is 1" in told


@pytest.mark.parametrize("template", ["motion.toml", "slew.toml"])
def test_a_template_is_a_file_to_begin_with(template, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    run("init", template)
    assert (tmp_path / template).read_text().startswith("# A ")
    command = "propagate" if template == "motion.toml" else "plan"
    run(command, template)
    assert "is there already" in run("init", template, status=2).err
    run("init", template, "-o", "other.toml")
    assert (tmp_path / template).read_text() == (tmp_path / "other.toml").read_text()


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_shells_complete_commands_and_options(shell, run):
    pytest.importorskip("shtab", reason="needs shtab (extra completion)")
    script = run("completion", shell).out
    assert all(name in script for name in COMMANDS)
    assert "verdict" in script


def test_completion_without_its_package_is_one_line(monkeypatch, refused):
    monkeypatch.setitem(sys.modules, "shtab", None)
    assert "pip install 'rigidsym[completion]'" in refused("completion bash")


@pytest.mark.parametrize(
    ("name", "starts"),
    [("x.csv", b"t,q0"), ("x.json", b"{"), ("x.JSON", b"{"), ("x.npz", b"PK"),
     ("x.aem", b"CCSDS_AEM_VERS")],
)  # fmt: skip
def test_the_name_of_a_file_says_its_format(name, starts, tmp_path, run, refused):
    epoch = ["--epoch", "2026-01-01T00:00:00"] if name.endswith("aem") else []
    if epoch:
        assert "epoch = missing" in refused("propagate paper -o", tmp_path / name)
    run("propagate paper -o", tmp_path / name, *epoch)
    assert (tmp_path / name).read_bytes().startswith(starts)


@pytest.mark.parametrize("name", ["x.dat", "states", ".csv"])
def test_other_names_are_refused_unless_a_format_is_given(name, tmp_path, run, refused):
    path = tmp_path / name
    rule = "ends in none of .csv, .json, .npz, .aem: give --format"
    assert rule in refused("propagate paper -o", path)
    assert not path.exists()
    run("propagate paper -o", path, "--format", "csv")


@pytest.fixture
def replayed(monkeypatch, _checked):
    """Skip the replay of the sealed ledger, which other tests do."""
    monkeypatch.setattr("rigidsym._cli.proofs.replayed", ledger_text)


@pytest.mark.usefixtures("replayed")
def test_errata_begin_with_counts(run):
    first, *others = run("errata").out.splitlines()
    counts = [int(n) for n in re.findall(r"(\d+) (?:hold|are|amb)", first)]
    assert len(counts) == 4
    assert sum(counts) == len(EQUATIONS)
    assert len(others) < 200
    assert "\\frac" not in "".join(others)


@pytest.mark.usefixtures("replayed")
def test_one_equation_is_told_in_full(run):
    told = run("errata 10", "(35)", "lemma 1").out
    assert all(f"({number})" in told for number in ("10", "35", "Lemma 1"))
    assert "Ωᵢ(t)=√(sᵢ) sn(±√(αsⱼ) t+Cᵢ, sᵢ/sⱼ)" in told  # noqa: RUF001
    assert "(11)" not in told.partition("(35)")[0]
    assert "equation = 99: must be one of: 1, 2, " in run("errata 99", status=2).err


@pytest.mark.usefixtures("replayed")
@pytest.mark.parametrize("verdict", ["holds", "holds-if", "misprint", "ambiguous"])
def test_verdicts_can_be_chosen(verdict, run):
    data = json.loads(run("errata --verdict", verdict, "--json").out)
    assert {entry["verdict"] for entry in data["equations"]} == {verdict.replace("-", " ")}
    assert data["prose"] == []


def test_every_ruling_can_be_chosen():
    (action,) = (x for x in COMMANDS["errata"]._actions if x.dest == "verdict")
    assert [x.replace("-", " ") for x in action.choices] == [str(x) for x in Ruling]


def test_long_texts_go_through_the_pager_on_a_terminal(monkeypatch, capsys):
    seen = []
    monkeypatch.setattr("pydoc.pager", seen.append)
    output.page("to a file\n")
    assert capsys.readouterr().out == "to a file\n"
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    output.page("to a reader\n")
    assert seen == ["to a reader\n"]


def test_the_sealed_ledger_is_written_in_place_alone(monkeypatch, tmp_path, run):
    from rigidsym.proof import derivation
    from rigidsym.proof.derivation import Derivation

    sealed, place = sealed_path().read_text("utf-8"), tmp_path / "ledger.json"
    monkeypatch.setattr(derivation, "sealed_path", lambda: place)
    for text, word in ((sealed, "the one that is"), (sealed + " ", "NOT the one")):
        found = Derivation((), text)
        monkeypatch.setattr(derivation, "derive", lambda *given, found=found: found)
        told = run("derive").err
        assert word in told
        assert "not written (-o FILE, or --in-place)" in told
        assert not place.exists()
    run("derive --in-place")
    assert place.read_text("utf-8") == sealed + " "


def test_derive_says_which_mutants_it_counted(monkeypatch, tmp_path, run):
    from rigidsym.proof import derivation
    from rigidsym.proof.derivation import Derivation

    text, given = sealed_path().read_text("utf-8"), []
    counts = json.loads(text)["published"]["mutants"]
    count = sum(sum(fates.values()) for fates in counts.values())

    def derive(wanted, progress, setting, sealed):
        given.append(sealed)
        return Derivation((), text, 0 if sealed else len(counts))

    monkeypatch.setattr(derivation, "sealed_path", lambda: tmp_path / "ledger.json")
    monkeypatch.setattr(derivation, "derive", derive)
    kept = f"{len(counts)} facts as sealed and not again (--mutants counts all)"
    for option, expected in (([], text), (["--mutants"], ""), (["--in-place"], "")):
        told = run("derive", *option).err
        assert given.pop() == expected
        assert f"mutants: {count} of {len(counts)} facts are counted" in told
        assert (kept in told) == bool(expected)


def test_a_ledger_that_is_not_as_sealed_gives_no_counts(monkeypatch):
    from rigidsym.io import ledger
    from rigidsym.proof.derivation import sealed_counts

    assert sealed_counts() == ledger.ledger_text()
    monkeypatch.setattr(ledger, "ledger_text", lambda: sealed_path().read_text("utf-8") + " ")
    assert sealed_counts() == ""


def test_without_a_compiler_numpy_is_measured_and_said_to_be_alone(monkeypatch, run):
    had = engines.exactly

    def exactly(name):
        if name == "c":
            raise InputError("engine", name, "no C compiler found (cc, gcc, clang)")
        return had(name)

    monkeypatch.setattr(engines, "exactly", exactly)
    told = run("validate --stratum rest --cases 1")
    assert "c is not measured: no C compiler found" in told.err
    assert "Every bound is kept at " in told.out.splitlines()[-1]
    run("validate c --stratum rest --cases 1", status=2)


def test_methods_end_with_a_conclusion():
    measured = (
        comparison.Measurement("theta", 15, seconds=0.2, seconds_more=0.001),
        comparison.Measurement("carlson", 15, seconds=0.1, seconds_more=0.002),
        comparison.Measurement("taylor", 15),
        comparison.Measurement("taylor", 50, seconds=0.003),
    )
    found = comparison.Comparison({}, None, "180", measured, ())
    said = "theta at 15 (1.00 ms), taylor at 50 (3.00 ms)"
    assert found.conclusion == f"The cheapest for one more state, by digits: {said}."


def test_faults_end_with_a_conclusion():
    """The conclusion counts the faults that strata notice and those that none does."""
    fault = by_hand()[0]
    seen = [detection.Detection(stratum, 0, ("angle",)) for stratum in ("rest", "rod")]
    outcomes = (FaultOutcome(fault, tuple(seen)), FaultOutcome(fault, (seen[0],)))
    found = FaultReport(("numpy",), ("rest", "rod"), 1, 20, 1, outcomes)
    said = "Each of 2 faults is noticed, by 1 stratum or more; rest alone notices 2."
    assert found.conclusion == said
    missed = FaultReport(("numpy",), ("rest", "rod"), 1, 20, 1, (FaultOutcome(fault, ()),))
    assert missed.conclusion.startswith("1 of 1 faults are NOT noticed")
