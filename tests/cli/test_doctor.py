"""`rigidsym doctor` says which engine computes and why."""

import json
import shutil

import pytest

from rigidsym import _engines as engines
from rigidsym._cli import doctor
from rigidsym._engines import build, shipped

needs_compiler = pytest.mark.skipif(
    not any(map(shutil.which, build.NAMES)), reason="needs a C compiler: cc, gcc or clang"
)


@pytest.fixture
def told(run):
    """Return what the command prints as JSON."""
    return lambda status=0: json.loads(run("doctor --json", status=status).out)


@needs_compiler
def test_c_is_named_with_its_library_and_compiler(told, run):
    found = told()
    assert found["schema"] == "rigidsym.doctor/1"
    assert found["engine"]["name"] == "c" == engines.resolved(engines.DEFAULT)
    assert found["engine"]["problem"] is None
    assert all(path.endswith(".so") for path in found["engine"]["libraries"])
    assert found["compiler"]["command"] == " ".join(build.find().command)
    assert found["packages"]["numpy"][0].isdigit()
    assert "app" in found["extras"]
    shown = run("doctor").out
    assert 'c (engine="auto")' in shown
    assert "-march=native" in shown


def test_without_a_compiler_it_says_what_to_do(told, run, monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    found = told()
    assert found["compiler"] is None
    assert found["engine"]["name"] == "numpy"
    assert "no C compiler found (cc, gcc, clang)" in found["engine"]["why"]
    assert found["engine"]["problem"] is None
    assert "install cc, gcc or clang, or a wheel" in " ".join(run("doctor").out.split())


def test_a_compiler_that_fails_is_a_problem(told, monkeypatch, tmp_path):
    script = tmp_path / "broken"
    script.write_text("#!/bin/sh\necho 'error: broken' >&2\nexit 1\n")
    script.chmod(0o700)
    monkeypatch.setenv("CC", str(script))
    found = told(1)["engine"]
    assert found["name"] == "numpy"
    assert found["problem"] == found["why"] == f"{script} failed: error: broken"


def test_a_shipped_library_is_named_with_its_code_path(told, monkeypatch, tmp_path):
    class Brought:
        path = tmp_path / "x86-64-v3.so"

    monkeypatch.setattr(shipped, "FOLDER", tmp_path)
    monkeypatch.setattr(shipped, "code_path", lambda: "x86-64-v3")
    monkeypatch.setattr(build, "library", lambda remarks, module: Brought)
    found = told()["engine"]
    assert (found["name"], found["path"]) == ("c", "x86-64-v3")
    assert found["libraries"] == [str(Brought.path)]
    assert "no compiler is needed" in found["why"]


def test_extras_lack_what_is_not_installed(monkeypatch):
    """An extra that takes others lacks what they lack; other systems' packages are not missed."""
    lines = [
        "numpy>=2.0",
        "nowhere>=1; extra == 'one'",
        "elsewhere; sys_platform == 'amiga' and extra == 'one'",
        'rigidsym[one,two]; extra == "both"',
        "numpy; extra == 'two'",
    ]
    monkeypatch.setattr(doctor.metadata, "requires", lambda _: lines)
    assert doctor._extras() == {"both": ["nowhere"], "one": ["nowhere"], "two": []}
    assert [*doctor._versions()] == ["numpy"]


def test_a_folder_that_is_not_installed_has_no_extras(monkeypatch):
    def missing(_):
        raise doctor.metadata.PackageNotFoundError

    monkeypatch.setattr(doctor.metadata, "requires", missing)
    assert (doctor._extras(), doctor._versions()) == ({}, {})
