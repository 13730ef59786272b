"""Threads share pieces of work and are reused."""

import os
import threading
import time
from itertools import chain

import pytest

from rigidsym._engines import threads


def spans(begin, end):
    return list(range(begin, end))


@pytest.mark.parametrize("parts", [1, 2, 4])
@pytest.mark.parametrize("piece", [1, 3, 64, 1000])
@pytest.mark.parametrize("count", [0, 1, 2, 100])
def test_pieces_are_all_of_it_in_order(parts, piece, count):
    found = threads.in_parts(spans, count, parts, piece)
    assert list(chain(*found)) == list(range(count))


def test_more_threads_than_the_callers_work_and_are_kept():
    met = threading.Barrier(2)

    def meet(begin, end):
        met.wait(600)
        return threading.current_thread()

    first, again = (set(threads.in_parts(meet, 2, 2, 1)) for _ in range(2))
    assert threading.current_thread() in first & again
    assert len(first) == len(again) == 2
    assert all(thread.is_alive() for thread in first | again)


@pytest.mark.parametrize("error", [IndexError, KeyboardInterrupt, RuntimeError])
@pytest.mark.parametrize("bad", [0, 7])
def test_an_error_of_a_piece_is_raised(error, bad):
    def work(begin, end):
        time.sleep(1e-3)
        if begin == bad:
            raise error
        return begin

    with pytest.raises(error):
        threads.in_parts(work, 8, 2, 1)
    assert threads.in_parts(spans, 8, 2, 4) == [[0, 1, 2, 3], [4, 5, 6, 7]]


def test_without_threads_to_be_had_the_caller_does_it_all(monkeypatch):
    class Ended:
        def submit(self, run):
            raise RuntimeError("cannot schedule new futures after interpreter shutdown")

    monkeypatch.setattr(threads, "_kept", [Ended()])
    assert threads.in_parts(spans, 4, 2, 2) == [[0, 1], [2, 3]]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
# Python warns of it where there are threads, and JAX where it has been used.
@pytest.mark.filterwarnings("ignore:.*fork.*")
def test_a_child_of_a_fork_has_threads_of_its_own():
    met = threading.Barrier(2)

    def meet(begin, end):
        met.wait(600)
        return threading.get_ident()

    assert len(set(threads.in_parts(meet, 2, 2, 1))) == 2
    if (child := os.fork()) == 0:
        try:
            both = len(set(threads.in_parts(meet, 2, 2, 1))) == 2
        finally:
            os._exit(0 if both else 1)
    assert os.waitpid(child, 0)[1] == 0


def test_few_states_need_no_thread(monkeypatch):
    monkeypatch.setattr(threads, "processors", lambda: 3)
    enough = 8 * threads.PIECE
    sizes = (0, threads.PIECE, enough - 1, enough, 10**9)
    assert [threads.threads(size) for size in sizes] == [1, 1, 1, 2, 3]
