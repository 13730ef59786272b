"""Campaigns on a real Dask cluster on this machine: a scheduler and two worker processes."""

import json
import signal
import subprocess
import sys
import time
from concurrent.futures import CancelledError
from contextlib import contextmanager

import pytest

from rigidsym import InputError
from rigidsym.validate import _executors as executors
from rigidsym.validate import validate
from rigidsym.validate._campaign import Campaign, Progress
from rigidsym.validate._validation import run

Client = pytest.importorskip("distributed", reason="Dask is not installed (extra cluster)").Client

STRATA = ("uniform", "near separatrix", "symmetric")
CASES, CHUNK = 40, 10


@contextmanager
def started(name, *arguments):
    command = [sys.executable, "-m", f"distributed.cli.dask_{name}", *arguments, "--no-dashboard"]
    silent = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    with subprocess.Popen(command, **silent) as process:
        try:
            yield process
        finally:
            process.kill()


@contextmanager
def scheduler(directory):
    """Start a scheduler; yield its address and its process."""
    file = directory / "scheduler.json"
    options = ("--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(file))
    with started("scheduler", *options) as process:
        while not file.exists() or not file.read_text():
            assert process.poll() is None
            time.sleep(0.05)
        yield json.loads(file.read_text())["address"], process


def worker(address):
    return started("worker", address, "--no-nanny", "--nthreads", "1", "--memory-limit", "0")


@pytest.fixture(scope="module")
def alone():
    return validate(cases=CASES, strata=STRATA)


def test_a_worker_that_is_killed_loses_no_case_and_none_is_counted_twice(
    alone, tmp_path, monkeypatch
):
    monkeypatch.setattr("rigidsym.validate._campaign.CHUNK", CHUNK)
    monkeypatch.setattr(executors, "SECONDS_TO_CONNECT", 600)
    campaign = Campaign.of(("numpy", "c"), CASES, strata=STRATA)
    progress, killed = Progress(campaign), []

    def show(done, total):
        if not killed and 0 < done < total:
            first.send_signal(signal.SIGKILL)
            killed.append(done)

    with scheduler(tmp_path) as (address, _), worker(address) as first, worker(address):
        report = run(progress, executors.cluster(address), show)
    assert killed
    assert killed[0] < campaign.size
    assert report.tally.cases == dict.fromkeys(STRATA, CASES)
    assert progress.done == {name: [(0, CASES)] for name in STRATA}
    assert report.run.pop("place").endswith("of a cluster")
    assert {**report.to_data(), "run": {}} == {**alone.to_data(), "run": {}}


def test_a_scheduler_that_is_lost_is_one_line(tmp_path, monkeypatch):
    monkeypatch.setattr(executors, "SECONDS_TO_CONNECT", 600)
    campaign = Campaign.of(("numpy",), 100_000, strata=STRATA)
    with scheduler(tmp_path) as (address, process), worker(address):

        def show(done, total):
            process.kill()

        with pytest.raises((InputError, CancelledError), match="was lost: nothing is kept"):
            run(Progress(campaign), executors.cluster(address), show)


def test_a_scheduler_without_workers_is_one_line(tmp_path, monkeypatch):
    wait = Client.wait_for_workers
    monkeypatch.setattr(executors, "SECONDS_TO_CONNECT", 600)
    monkeypatch.setattr(Client, "wait_for_workers", lambda self, n, timeout: wait(self, n, 1))
    with (
        scheduler(tmp_path) as (address, _),
        pytest.raises(InputError, match="has no workers"),
        executors.cluster(address),
    ):
        pass


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nonsense://x", "127.0.0.1", ""])
def test_a_scheduler_that_cannot_be_reached_is_one_line(address, monkeypatch):
    limits = []

    class Limited(Client):
        def __init__(self, *given, timeout, **more):
            limits.append(timeout)
            super().__init__(*given, timeout=timeout, **more)

    monkeypatch.setattr(executors, "SECONDS_TO_CONNECT", 1)
    monkeypatch.setattr("distributed.Client", Limited)
    with (
        pytest.raises(
            InputError, match=r"^scheduler = .*: (cannot be reached: |must be an address)[^\n]*$"
        ),
        executors.cluster(address),
    ):
        pass
    assert limits == [1] * address.startswith("tcp:")
