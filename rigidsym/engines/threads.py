"""Work shared among threads, in the same pieces of arithmetic whatever their number."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Result = TypeVar("Result")

# Fewer states than this are computed before a thread has started.
LEAST = 1 << 17
# Beyond this many, memory is slower than the arithmetic.
_MOST = 4


def threads(states: int) -> int:
    """How many threads are worth their start for so many states."""
    wanted = min(_MOST, states // LEAST)
    return min(wanted, processors()) if wanted > 1 else 1


def in_parts(work: Callable[[int, int], Result], count: int, parts: int) -> list[Result]:
    """work(begin, end) for consecutive parts of range(count), results in their order."""
    if parts == 1:
        return [work(0, count)]
    ends = [count * k // parts for k in range(parts + 1)]
    with ThreadPoolExecutor(parts) as pool:
        return list(pool.map(work, ends[:-1], ends[1:]))


def processors() -> int:
    """The processors this process may run on."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
