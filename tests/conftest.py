"""What all tests share: how they are spread over processes, and what is done once for all."""

import fcntl
import os
import shlex
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import pytest


def pytest_configure(config):
    """Where sources may have no bytecode beside them, it is kept in pytest's own folder.

    Tests start hundreds of processes, each of which would compile all that it imports again.
    """
    if sys.dont_write_bytecode and hasattr(config, "cache"):
        sys.dont_write_bytecode = False
        sys.pycache_prefix = str(config.cache.mkdir("bytecode"))
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        os.environ["PYTHONPYCACHEPREFIX"] = sys.pycache_prefix
    if (
        find_spec("casadi") is None
    ):  # its docstrings cannot be imported; its tests say why they skip
        config.option.ignore = [*(config.option.ignore or []), "rigidsym/manoeuvre/_comparison"]


@pytest.hookimpl(tryfirst=True)
def pytest_xdist_auto_num_workers(config):
    """No other process for the tests of one file, else one for each processor."""
    named = [Path(argument.partition("::")[0]) for argument in config.args]
    return 0 if len(named) == 1 and named[0].is_file() else None


@pytest.fixture(scope="session")
def once(tmp_path_factory):
    """`once(name, make)`: a folder of this run, filled by the process that first asks for it."""
    own = tmp_path_factory.getbasetemp()
    shared = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own

    def folder(name: str, make: Callable[[Path], None]) -> Path:
        made = shared / name
        with (shared / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not made.exists():
                begun = tmp_path_factory.mktemp(name)
                make(begun)
                begun.rename(made)
        return made

    return folder


@pytest.fixture(params=["numpy", "c"])
def engine(request):
    """The name of each engine in turn."""
    return request.param


@pytest.fixture
def replayed_once(monkeypatch):
    """The sealed ledger, which several commands of a test ask for, is replayed for the first."""
    from rigidsym._cli import proofs

    monkeypatch.setattr(proofs, "replayed", cache(proofs.replayed))


@pytest.fixture(scope="session")
def reproduced(once):
    """What `rigidsym reproduce` leaves, the derivation in it, run once: the files and `stdout`."""

    def run(folder):
        command = [sys.executable, "-m", "rigidsym", "reproduce", "-o", folder / "files"]
        found = subprocess.run(
            command, capture_output=True, text=True, check=False,
            env={**os.environ, "PYTHONHASHSEED": "1"},
        )  # fmt: skip
        assert found.returncode == 0, found.stderr
        (folder / "stdout").write_text(found.stdout)

    return once("reproduced", run)


@pytest.fixture
def run(capsys):
    """Run a command; return what it prints as `out` and `err`.

    The first argument is split as a shell splits it, the others are taken as they are.
    """

    from rigidsym._cli import main

    def run(command, *arguments, status=0):
        capsys.readouterr()
        try:
            found = main([*shlex.split(command), *map(str, arguments)])
        except SystemExit as leaving:
            found = leaving.code
        assert found == status
        return capsys.readouterr()

    return run


@pytest.fixture
def refused(run):
    """Run a command that is refused with status 2; return its one line of error."""

    def refused(command, *arguments, status=2):
        (error,) = run(command, *arguments, status=status).err.splitlines()
        return error

    return refused


@pytest.fixture(scope="session")
def here(once):
    """Return a folder of this run with all C sources, and with what is built of them."""
    from compilers import written

    return once("c_builds", written)
