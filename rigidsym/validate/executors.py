"""Where chunks are run: in this process, in others on this machine, or on a Dask cluster."""

import os
import signal
import threading
from collections.abc import Callable, Generator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context, parent_process
from typing import Any

from rigidsym.engines.threads import processors
from rigidsym.errors import InputError

# Chunks under way for each worker, so that none waits for work.
AHEAD = 2
SECONDS_TO_CONNECT = 10


@dataclass(frozen=True, slots=True)
class Place:
    """An executor, how many chunks to give it at once, and what to call it."""

    executor: Executor
    ahead: int
    name: str


class Here(Executor):
    """One after the other, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future:
        """The result, or what was raised, at once."""
        future: Future = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


def processes(count: int) -> ProcessPoolExecutor:
    """Fresh processes: forks would share locks and threads of this one."""
    return ProcessPoolExecutor(count, mp_context=get_context("spawn"), initializer=_begin)


@contextmanager
def local(workers: int | None = None) -> Generator[Place]:
    """So many processes on this machine, one for each core by default."""
    count = workers or processors()
    if count == 1:
        yield Place(Here(), 1, "this process")
        return
    pool = processes(count)
    try:
        yield Place(pool, AHEAD * count, f"{count} processes")
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


@contextmanager
def cluster(address: str) -> Generator[Place]:
    """A Dask cluster; raises InputError where its scheduler cannot be reached."""
    try:
        from distributed import Client
    except ImportError:
        rule = "needs the package distributed (extra cluster)"
        raise InputError("scheduler", address, rule) from None
    try:
        client = Client(address, timeout=SECONDS_TO_CONNECT, set_as_default=False)
    except (OSError, ValueError) as error:
        rule = f"cannot be reached: {' '.join(str(error).split())}"
        raise InputError("scheduler", address, rule) from None
    with client:
        threads = sum(client.nthreads().values())
        yield Place(
            client.get_executor(), AHEAD * max(1, threads), f"{threads} threads of a cluster"
        )


def _begin() -> None:
    """Interrupts are for the parent to take; without a parent there is nothing to do."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    if parent := parent_process():
        parent.join()
        os._exit(1)
