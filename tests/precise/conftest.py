"""Clock of processor time for tests of time limits on a machine under load."""

import os
import time

import pytest

from rigidsym.precise import _balls as balls
from rigidsym.precise import _worker as worker


def _spent():
    """Return the seconds that this process, its ended children and the worker took."""
    own = os.times()
    server = worker._worker
    # The clock of another process, as clock_getcpuclockid(3) of Linux has it.
    live = time.clock_gettime(~server.process.pid << 3 | 2) if server else 0.0
    return own.user + own.system + own.children_user + own.children_system + live


@pytest.fixture
def processor_time(monkeypatch):
    """Make `max_seconds` count processor time, and return its clock."""
    for module in (balls, worker):
        monkeypatch.setattr(module, "perf_counter", _spent)
    return _spent
