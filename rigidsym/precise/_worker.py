"""A worker process for evaluations of many digits, which can be ended at any time.

A call of Arb's may take seconds, and cannot be interrupted by a time limit or Ctrl-C.  So a second
Python computes what takes long.  It starts at the first such evaluation and ends with this process;
a time limit or an interrupt ends it at once.
"""

import atexit
import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from queue import Empty, SimpleQueue
from threading import Lock, Thread
from time import perf_counter
from typing import IO, Any

from flint import arb, arf

_CODE = "import sys; sys.path[:] = {path!r}; from rigidsym.precise._worker import serve; serve()"
# Seconds between checks of the time limit.
POLL = 0.1

# Mantissa and exponent of the middle and of the radius; None for no number.
BallData = tuple[tuple[int, int], tuple[int, int]] | None


# A function of balls that can be pickled, and its arguments.
Request = tuple[Callable[..., list[arb]], tuple[Any, ...]]
Reply = list[BallData] | Exception


def numbers(
    compute: Callable[..., list[arb]], *arguments: Any, end: float | None = None
) -> list[arb]:
    """Evaluate `compute(*arguments)` in the worker process.

    Raises TimeoutError where the clock reaches `end` first.  Where no process can be started, this
    one computes.
    """
    while not _turn.acquire(timeout=POLL):
        _check(end)
    try:
        worker = _started()
        if worker is None:
            return compute(*arguments)
        try:
            reply = worker.reply((compute, arguments), end)
        except BaseException:
            stop()
            raise
        if isinstance(reply, Exception):
            raise reply
        return [_ball(data) for data in reply]
    finally:
        _turn.release()


def _started() -> "_Worker | None":
    global _worker
    # A program that is frozen into one file would start itself again.
    if sys.executable and not getattr(sys, "frozen", False):
        with suppress(OSError):
            _worker = _worker or _Worker()
    return _worker


class _Worker:
    """A Python process that evaluates requests from its input and writes replies."""

    def __init__(self) -> None:
        code = _CODE.format(path=[os.path.abspath(place) for place in sys.path])
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(
            [sys.executable, "-c", code], stdin=pipe, stdout=pipe, stderr=subprocess.DEVNULL
        )
        self.requests, self.answers = _opened(self.process.stdin), _opened(self.process.stdout)
        self.replies: SimpleQueue[Reply] = SimpleQueue()
        Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        try:
            while True:
                self.replies.put(pickle.load(self.answers))
        except (EOFError, OSError, ValueError, pickle.UnpicklingError):
            self.replies.put(ChildProcessError("the process of many digits has ended"))

    def reply(self, request: Request, end: float | None) -> Reply:
        """Send a request to the process and wait for the reply.

        Raises TimeoutError where the clock reaches `end` first.
        """
        pickle.dump(request, self.requests)
        self.requests.flush()
        while True:
            _check(end)
            left = POLL if end is None else min(POLL, end - perf_counter())
            with suppress(Empty):
                return self.replies.get(timeout=max(left, 0))

    def stop(self) -> None:
        """Kill the worker process."""
        self.process.kill()
        self.process.wait()
        for stream in (self.requests, self.answers):
            with suppress(OSError):
                stream.close()


def _opened(stream: IO[bytes] | None) -> IO[bytes]:
    if stream is None:
        raise OSError("the process of many digits has no pipe")
    return stream


def _check(end: float | None) -> None:
    if end is not None and perf_counter() >= end:
        raise TimeoutError


def stop() -> None:
    """End the worker process if there is one.

    The next evaluation starts a new one.
    """
    global _worker
    worker, _worker = _worker, None
    if worker:
        worker.stop()


def _forget() -> None:
    """Discard the worker in a forked process, because it belongs to the parent."""
    global _worker, _turn, _inherited
    _worker, _turn, _inherited = None, Lock(), _worker


_worker: _Worker | None = None
_inherited: _Worker | None = None
_turn = Lock()
atexit.register(stop)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


def serve() -> None:
    """Process requests in the worker process until its input ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    requests, answers = sys.stdin.buffer, sys.stdout.buffer
    while True:
        try:
            request = pickle.load(requests)
        except EOFError:
            return
        pickle.dump(_answer(*request), answers)
        answers.flush()


def _answer(compute: Callable[..., list[arb]], arguments: tuple[Any, ...]) -> Reply:
    try:
        return [_data_of(value) for value in compute(*arguments)]
    except Exception as error:
        return error


def _data_of(value: arb) -> BallData:
    return (_dyadic(value.mid()), _dyadic(value.rad())) if value.is_finite() else None


def _dyadic(value: arb) -> tuple[int, int]:
    mantissa, exponent = value.man_exp()
    return int(mantissa), int(exponent)


def _ball(data: BallData) -> arb:
    return arb.nan() if data is None else arb(*map(arf, data))
