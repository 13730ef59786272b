"""Division of work among threads, with results that do not depend on their number.

Threads are kept from one call to the next.  Each takes the next piece when it is done with one, the
caller's among them, so that a thread which starts late, or not at all, delays nothing.
"""

import os
import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from typing import TypeVar

Result = TypeVar("Result")

# States in a piece: a tenth of a millisecond, several times what it takes to wake a thread.  Grids
# need a multiple of 64.
PIECE = 1 << 14
# Pieces per thread below which none is woken.
LEAST = 4
# With more threads than these, memory is slower than the arithmetic.
MOST = 4
_LOCK = threading.Lock()
_kept: list[ThreadPoolExecutor] = []


def threads(states: int) -> int:
    """Return the number of threads to use for computing a number of states."""
    wanted = min(MOST, states // (LEAST * PIECE))
    return min(wanted, processors()) if wanted > 1 else 1


def in_parts(
    work: Callable[[int, int], Result], count: int, parts: int, piece: int
) -> list[Result]:
    """Run a function on pieces of a range in several threads, and return the results in order.

    It is called as work(begin, end) on pieces of range(count).  The first error of a piece is
    raised once all threads are done.
    """
    if parts == 1:
        return [work(0, count)]
    begins = range(0, count, piece)
    left, done = deque(begins), dict[int, Result]()

    def run() -> None:
        while True:
            # Threads have to test and take in one step.
            try:
                begin = left.popleft()
            except IndexError:
                return
            done[begin] = work(begin, min(begin + piece, count))

    helpers = _started(run, parts - 1)
    try:
        run()
    finally:
        # Helpers that never began are cancelled, not waited for.
        ended = [helper for helper in helpers if not helper.cancel()]
        left.clear()
        errors = [helper.exception() for helper in ended]
    for error in filter(None, errors):
        raise error
    return [done[begin] for begin in begins]


def processors() -> int:
    """Return the number of processors that this process may run on."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _started(run: Callable[[], None], count: int) -> list[Future[None]]:
    """Start helper threads that run a function.

    None are started if the interpreter is shutting down.
    """
    with suppress(RuntimeError), _LOCK:
        if not _kept:
            _kept.append(ThreadPoolExecutor(MOST - 1, "rigidsym"))
        return [_kept[0].submit(run) for _ in range(count)]
    return []


def _forget() -> None:
    """Reset the thread pool and its lock in a forked process, which inherits no threads."""
    global _LOCK
    _LOCK = threading.Lock()
    _kept.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)
