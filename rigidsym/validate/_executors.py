"""Executors that run work in this process, in local processes, or on a Dask cluster."""

import logging
import os
import re
import signal
import threading
from collections.abc import Callable, Generator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context, parent_process
from typing import ParamSpec, TypeVar

from rigidsym._engines.threads import processors
from rigidsym.errors import InputError

# Chunks under way for each worker, so that none waits for work.
AHEAD = 2
SECONDS_TO_CONNECT = 10
_INTERRUPTS = (signal.SIGINT, signal.SIGTERM)
Arguments = ParamSpec("Arguments")
Found = TypeVar("Found")


@dataclass(frozen=True, slots=True)
class Place:
    """Executor, with its name and how many chunks of work to submit in advance."""

    executor: Executor
    ahead: int
    name: str

    def submit(
        self, work: Callable[Arguments, Found], *args: Arguments.args, **kwargs: Arguments.kwargs
    ) -> Future[Found]:
        """Submit work to the executor.

        Interrupts are delayed while this may start a process.
        """
        with undisturbed():
            return self.executor.submit(work, *args, **kwargs)


class Here(Executor):
    """Executor that runs work immediately in this process."""

    def submit(
        self, fn: Callable[Arguments, Found], /, *args: Arguments.args, **kwargs: Arguments.kwargs
    ) -> Future[Found]:
        """Run the work immediately, and return a future with its result or exception."""
        future: Future[Found] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


@contextmanager
def undisturbed() -> Generator[None]:
    """Delay interrupts during a `with` block, and block them in processes started within it."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    heard: list[int] = []
    known = {number: signal.signal(number, lambda n, _: heard.append(n)) for number in _INTERRUPTS}
    # New processes begin with what is blocked here, and without our handlers.
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, _INTERRUPTS)
    try:
        yield
    finally:
        for number, handler in known.items():
            signal.signal(number, handler)
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        for number in heard[:1]:
            if callable(handler := known[signal.Signals(number)]):
                handler(number, None)


def processes(count: int) -> ProcessPoolExecutor:
    """Return a pool of spawned processes.

    Forked ones would share locks and threads.
    """
    return ProcessPoolExecutor(count, mp_context=get_context("spawn"), initializer=_begin)


@contextmanager
def local(workers: int | None = None) -> Generator[Place]:
    """Provide an executor that uses processes on this machine.

    There is one for each core by default.
    """
    count = workers or processors()
    if count == 1:
        yield Place(Here(), 1, "this process")
        return
    pool = processes(count)
    try:
        yield Place(pool, AHEAD * count, f"{count} processes")
    finally:
        with undisturbed():
            pool.shutdown(wait=True, cancel_futures=True)


@contextmanager
def cluster(address: str) -> Generator[Place]:
    """Provide an executor that uses a Dask cluster.

    Raises InputError if its scheduler is not reached or has no worker.
    """
    if not re.fullmatch(r"(tcp|tls|ucx|ws|wss)://[^\s/]+:\d+", address):
        raise InputError("scheduler", address, "must be an address such as tcp://host:8786")
    try:
        from distributed import Client
    except ImportError:
        rule = "needs the package distributed (extra cluster)"
        raise InputError("scheduler", address, rule) from None
    # A lost connection is reported in one line here, without its own messages.
    for name in ("distributed", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        client = Client(address, timeout=SECONDS_TO_CONNECT, set_as_default=False)
    except (OSError, ValueError) as error:
        rule = f"cannot be reached: {' '.join(str(error).split())}"
        raise InputError("scheduler", address, rule) from None
    with client:
        try:
            client.wait_for_workers(1, timeout=SECONDS_TO_CONNECT)
        except TimeoutError:
            raise InputError("scheduler", address, "has no workers") from None
        threads = sum(client.nthreads().values())
        name = f"{threads} threads of a cluster"
        yield Place(client.get_executor(), AHEAD * threads, name)


def _begin() -> None:
    """Make a worker process ignore interrupts and exit when its parent process ends."""
    for number in _INTERRUPTS:
        signal.signal(number, signal.SIG_IGN)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, _INTERRUPTS)

    def end_with_parent() -> None:
        if parent := parent_process():
            parent.join()
            os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()
