"""Tests that the committed files contain no leftovers of an editor or a merge."""

import re
import subprocess
from pathlib import Path, PurePath

import pytest

ROOT = Path(__file__).parents[1]
LEFTOVERS = ("*.orig", "*.rej", "*.bak", "*~", "*.swp")
CONFLICT = re.compile(rb"^(<{7} |\|{7} |>{7} |={7}$)", re.MULTILINE)


def tracked(root=ROOT):
    """Return the names of the files that git tracks."""
    found = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, check=False)
    if found.returncode:
        pytest.skip("needs a checkout and git")
    return [name for name in found.stdout.decode().split("\0") if name]


def is_leftover(name):
    return any(PurePath(name).match(pattern) for pattern in LEFTOVERS)


def has_conflict(content):
    return CONFLICT.search(content) is not None


def test_no_leftovers_are_tracked():
    assert [name for name in tracked() if is_leftover(name)] == []


def test_no_conflict_is_left_in_a_tracked_file():
    paths = [ROOT / name for name in tracked()]
    assert [path for path in paths if path.is_file() and has_conflict(path.read_bytes())] == []


@pytest.mark.parametrize("name", ["a/pyproject.toml.orig", "x.rej", "b.py~", "old.bak"])
def test_leftovers_are_known(name):
    assert is_leftover(name)
    assert not is_leftover(f"{name}.md")


@pytest.mark.parametrize("mark", [b"<<<<<<< HEAD", b"=======", b">>>>>>> branch", b"||||||| base"])
def test_conflicts_are_known(mark):
    assert has_conflict(b"one\n" + mark + b"\ntwo\n")
    assert not has_conflict(b"one\n" + mark[:6] + b"\n# " + mark + b"\n")


def test_types_are_told_to_those_who_use_the_package():
    assert (ROOT / "rigidsym" / "py.typed").is_file()
