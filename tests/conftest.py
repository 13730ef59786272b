"""Fixtures for all tests: worker processes, and results that are computed once."""

import fcntl
import os
import platform
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable
from contextlib import contextmanager
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest


def pytest_configure(config):
    """Keep bytecode in pytest's cache folder if Python writes none beside the sources.

    Tests start hundreds of processes, each of which would compile all that it imports again.
    """
    if sys.dont_write_bytecode and hasattr(config, "cache"):
        sys.dont_write_bytecode = False
        sys.pycache_prefix = str(config.cache.mkdir("bytecode"))
        os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
        os.environ["PYTHONPYCACHEPREFIX"] = sys.pycache_prefix
    # Docstrings that need CasADi cannot be imported; the tests say why they skip.
    if find_spec("casadi") is None:
        config.option.ignore = [*(config.option.ignore or []), "rigidsym/manoeuvre/_comparison"]


@pytest.hookimpl(tryfirst=True)
def pytest_xdist_auto_num_workers(config):
    """Run a single test file in this process, and several files in one process per processor."""
    named = [Path(argument.partition("::")[0]) for argument in config.args]
    return 0 if len(named) == 1 and named[0].is_file() else None


@pytest.fixture(scope="session")
def once(tmp_path_factory):
    """Return `once(name, make)`, which fills a shared folder once per test run.

    One process fills the folder for all.
    """
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
    """Return the name of each engine in turn."""
    return request.param


@pytest.fixture(scope="session")
def sealed_ledger():
    """Return the sealed ledger, replayed by the kernel once in this process."""
    from rigidsym.io.ledger import ledger_text
    from rigidsym.proof.algebra._enclosures import encloses
    from rigidsym.proof.kernel import replay

    return replay(ledger_text(), encloses)


@pytest.fixture(scope="session")
def _checked():
    # Both, before anything is replaced: one keeps a name of the other.
    from rigidsym._cli import code, proofs

    assert code.replayed is proofs.replayed
    return cache(proofs.replayed)


@pytest.fixture
def replayed_once(monkeypatch, _checked):
    """Let commands run the second checker on the sealed ledger once in this process."""

    @contextmanager
    def beside():
        _checked()
        yield SimpleNamespace(map=map)

    monkeypatch.setattr("rigidsym._cli.proofs.replayed", _checked)
    monkeypatch.setattr("rigidsym._cli.code.replayed_beside", beside)


@pytest.fixture(scope="session")
def reproduced(once):
    """Return a folder with the output of `rigidsym reproduce`: its files, and `stdout`."""

    def run(folder):
        command = [sys.executable, "-m", "rigidsym", "reproduce", "-o", folder / "files"]
        found = subprocess.run(
            command, capture_output=True, text=True, check=False,
            env={**os.environ, "PYTHONHASHSEED": "1"},
        )  # fmt: skip
        assert found.returncode == 0, found.stderr
        (folder / "stdout").write_text(found.stdout)

    return once("reproduced", run)


# Other processors: how C is compiled for them, and what NumPy, OpenBLAS and libm may use there.
PROCESSORS = {
    "without AVX and FMA": ("-march=x86-64", (), "Nehalem", "-AVX,-AVX2,-FMA,-FMA4,-AVX512F"),
    "with AVX2 and FMA": ("-march=haswell", ("X86_V3",), "Haswell", "-AVX512F"),
}


@pytest.fixture(params=PROCESSORS)
def another_processor(request, once, monkeypatch):
    """Let processes compute as on another processor; what they compile is kept for this run."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if platform.machine() != "x86_64" or compiler is None:
        pytest.skip("needs x86-64 and a C compiler")
    architecture, kept, cores, without = PROCESSORS[request.param]
    found = np.show_config(mode="dicts")["SIMD Extensions"]["found"]
    if not {*kept} <= {*found}:
        pytest.skip("this processor has no AVX2")

    def make(folder):
        # Its flags come last, and so count.
        options = f"{architecture} -mtune=generic -mprefer-vector-width=none"
        (folder / "cc").write_text(f'#!/bin/sh\nexec {compiler} "$@" {options}\n')
        (folder / "cc").chmod(0o755)

    folder = once(request.param.replace(" ", "-"), make)
    for name, value in {
        "CC": str(folder / "cc"),
        "RIGIDSYM_CACHE": str(folder / "cache"),
        "NPY_DISABLE_CPU_FEATURES": " ".join(x for x in found if x not in kept),
        "OPENBLAS_CORETYPE": cores,
        "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={without}",
    }.items():
        monkeypatch.setenv(name, value)


@pytest.fixture
def run(capsys):
    """Run a command, and return its output as `out` and `err`.

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
    """Run a command that must fail with status 2, and return its one line of error."""

    def refused(command, *arguments, status=2):
        (error,) = run(command, *arguments, status=status).err.splitlines()
        return error

    return refused


@pytest.fixture(scope="session")
def here(once):
    """Return a folder with all C sources and with the programs built from them.

    It is shared in this run of the tests.
    """
    from compilers import written

    return once("c_builds", written)


@pytest.fixture(scope="session")
def exact_motions(once):
    """Return motions in every regime, each with its exact states.

    One process computes the states for all.
    """
    from regimes import save_exact, with_exact

    return with_exact(once("exact_motions", save_exact))
