"""Evaluations of many digits, in a process of their own that can be ended.

A call of Arb's may take seconds, and hears neither a clock nor Ctrl-C.  So what is long is computed
by a second Python that serves this one: it is started at the first such evaluation, keeps the
constants of the last motions, ends with this process, and is ended where a limit of time or an
interrupt comes first.
"""

import atexit
import os
import pickle
import signal
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from queue import Empty, SimpleQueue
from threading import Lock, Thread
from time import perf_counter
from typing import IO, Protocol

from flint import arb, arf

_CODE = "import sys; sys.path[:] = {path!r}; from rigidsym.precise.apart import serve; serve()"
# How often a wait looks up, where an interrupt does not end it.
GLANCE = 0.1

# Mantissa and exponent of a middle and of a radius; None for no number.
Parts = tuple[tuple[int, int], tuple[int, int]] | None


@dataclass(frozen=True, slots=True)
class Sensitive:
    """What the state at a time is, and what it changes by."""

    time: Fraction


# A time, or names of constants.
Asked = Fraction | Sensitive | tuple[str, ...]


class Numbered(Protocol):
    """A motion that finds numbers in this very process."""

    def __hash__(self) -> int:
        """Equal motions are one."""
        ...

    def numbers_here(self, asked: Asked, bits: int) -> list[arb]:
        """What is asked, from balls of so many bits."""
        ...


Request = tuple[Numbered, Asked, int]
Reply = list[Parts] | Exception


def numbers(motion: Numbered, asked: Asked, bits: int, end: float | None) -> list[arb]:
    """`motion.numbers_here(asked, bits)`; TimeoutError where the clock comes to `end` first.

    It is computed here where no other process can be started.
    """
    while not _turn.acquire(timeout=GLANCE):
        _check(end)
    try:
        server = _started()
        if server is None:
            return motion.numbers_here(asked, bits)
        return [_ball(parts) for parts in _answered(server, (motion, asked, bits), end)]
    finally:
        _turn.release()


def _started() -> "_Server | None":
    global _server
    # A program that is frozen into one file would start itself again.
    if sys.executable and not getattr(sys, "frozen", False):
        with suppress(OSError):
            _server = _server or _Server()
    return _server


def _answered(server: "_Server", request: Request, end: float | None) -> list[Parts]:
    try:
        reply = server.ask(request, end)
    except BaseException:
        stop()
        raise
    if isinstance(reply, Exception):
        raise reply
    return reply


class _Server:
    """A Python that serves this one by its standard input and output."""

    def __init__(self) -> None:
        code = _CODE.format(path=[os.path.abspath(place) for place in sys.path])
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(
            [sys.executable, "-c", code], stdin=pipe, stdout=pipe, stderr=subprocess.DEVNULL
        )
        self.asked, self.told = _opened(self.process.stdin), _opened(self.process.stdout)
        self.replies: SimpleQueue[Reply] = SimpleQueue()
        Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        try:
            while True:
                self.replies.put(pickle.load(self.told))
        except (EOFError, OSError, ValueError, pickle.UnpicklingError):
            self.replies.put(ChildProcessError("the process of many digits has ended"))

    def ask(self, request: Request, end: float | None) -> Reply:
        """The reply to a request, unless the clock comes to `end` first."""
        pickle.dump(request, self.asked)
        self.asked.flush()
        while True:
            _check(end)
            left = GLANCE if end is None else min(GLANCE, end - perf_counter())
            with suppress(Empty):
                return self.replies.get(timeout=max(left, 0))

    def stop(self) -> None:
        """End it now."""
        self.process.kill()
        self.process.wait()
        for stream in (self.asked, self.told):
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
    """End the process that serves this one, if there is one; the next evaluation starts another."""
    global _server
    server, _server = _server, None
    if server:
        server.stop()


def _forget() -> None:
    """A child of fork has no server: that of its parent is not its own, nor its to clean up."""
    global _server, _turn, _inherited
    _server, _turn, _inherited = None, Lock(), _server


_server: _Server | None = None
_inherited: _Server | None = None
_turn = Lock()
atexit.register(stop)
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


def serve() -> None:
    """What the other process does: answer, until there is nobody to ask."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    asked, told = sys.stdin.buffer, sys.stdout.buffer
    while True:
        try:
            request = pickle.load(asked)
        except EOFError:
            return
        pickle.dump(_answer(*request), told)
        told.flush()


def _answer(motion: Numbered, asked: Asked, bits: int) -> Reply:
    try:
        return [_parts(value) for value in _known(motion).numbers_here(asked, bits)]
    except Exception as error:
        return error


@lru_cache(maxsize=2)
def _known(motion: Numbered) -> Numbered:
    """The motion that was asked for before, with its constants, rather than an equal one."""
    return motion


def _parts(value: arb) -> Parts:
    return (_dyadic(value.mid()), _dyadic(value.rad())) if value.is_finite() else None


def _dyadic(value: arb) -> tuple[int, int]:
    mantissa, exponent = value.man_exp()
    return int(mantissa), int(exponent)


def _ball(parts: Parts) -> arb:
    return arb.nan() if parts is None else arb(*map(arf, parts))
