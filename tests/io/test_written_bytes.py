"""Files of states have the same bytes on every processor."""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest

from rigidsym.io._tables import doubles, to_csv
from rigidsym.io.cases import Case, parse_case

HERE = {**os.environ}
# Processors on which the fast path has fused multiply-add.
FUSES = {"FMA3", "X86_V3"} & {*np.show_config(mode="dicts")["SIMD Extensions"]["found"]}
MESSAGE = "--epoch 2026-01-01T00:00:00 --creation-date 2026-01-01T00:00:00"
OPTIONS = {"states.csv": "", "states.json": "", "states.npz": "", "states.aem": MESSAGE}
CASE = """
inertia = [1.0, 2.0, 2.5]
omega0 = [0.3, 0.5, -0.7]
attitude0 = [0.1, 0.2, -0.3, 0.4]
times = { start = 0, stop = 1000000, count = 101 }
"""
needs_compiler = pytest.mark.skipif(not shutil.which("gcc"), reason="needs gcc")


def written(folder, environment):
    """Return the bytes of all files by name, written by processes in an environment."""
    folder.mkdir()
    (folder / "case.toml").write_text(CASE)
    for name, options in OPTIONS.items():
        propagate(folder, environment, *options.split(), "-o", folder / name)
    return {name: (folder / name).read_bytes() for name in OPTIONS}


def propagate(folder, environment, *options):
    """Run the command in an environment, and return what it prints."""
    line = [sys.executable, "-m", "rigidsym", "propagate", folder / "case.toml", *options]
    return subprocess.run(line, check=True, env=environment, capture_output=True).stdout


@needs_compiler
@pytest.mark.usefixtures("another_processor")
def test_another_processor_writes_the_same_bytes(tmp_path):
    here = written(tmp_path / "here", HERE)
    assert written(tmp_path / "other", {**os.environ}) == here
    assert propagate(tmp_path / "here", HERE) == here["states.csv"]


@needs_compiler
def test_the_fast_path_has_other_last_digits(tmp_path):
    """Check that files have digits in which arithmetics differ, and those of c-portable."""
    case = parse_case(CASE)
    tables = (Case(case.motion.replace(engine=x), case.times) for x in ("c-portable", "c"))
    portable, fast = (to_csv(doubles(table)) for table in tables)
    if FUSES:
        assert portable != fast
    assert written(tmp_path / "here", HERE)["states.csv"] == portable
