"""Long evaluations in another process and their time limits, and numbers of any size."""

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import pytest
from boxes import PAPER, numbers, overlap
from flint import arb, ctx

from rigidsym import InputError, TorqueFreeMotion
from rigidsym import _inputs as inputs
from rigidsym.errors import PrecisionError
from rigidsym.precise import METHODS
from rigidsym.precise import _worker as worker
from rigidsym.precise._balls import working
from rigidsym.precise._motion import PreciseMotion

MANY = 40_000  # a state takes some ten seconds
GIVEN = tuple(tuple(map(Fraction, x)) for x in (*PAPER, (1, 0, 0, 0)))


def is_same(value, back):
    """Return True for balls of the same middle, of which the radius may be rounded up."""
    with working(40_000):
        wider = back.rad() - value.rad()
        return bool(back.mid() == value.mid() and 0 <= wider <= value.rad() * 1e-8)


@pytest.fixture(autouse=True)
def _no_process_is_left():
    yield
    worker.stop()


@pytest.fixture
def motion():
    return PreciseMotion(*GIVEN, "theta")


def test_time_limits_hold_within_one_evaluation(processor_time):
    motion = TorqueFreeMotion(*PAPER)
    motion.precise(7, 10)
    start = processor_time()
    with pytest.raises(PrecisionError, match=rf"t = 7: \d+ of {MANY} digits were reached") as error:
        motion.precise(7, MANY, max_seconds=1)
    assert processor_time() - start < 1.5
    assert int(str(error.value).split()[3]) > 50
    few = numbers(motion.precise(7, 40))
    assert few == numbers(motion.precise(7, 40))


INTERRUPTED = """
import time
from rigidsym import TorqueFreeMotion
motion = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
motion.precise(7, 6000)
try:
    print("ready", flush=True)
    motion.precise(7, 100_000)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    print(motion.precise(7, 20)[0][0], flush=True)
    print(motion.enclose(7, 6000)[0][0].rad() < 1e-300, flush=True)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_interrupts_are_heard_and_leave_all_in_order():
    """The processor time of both processes shows that no evaluation was waited for."""
    before = os.times()
    with subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED],
        stdout=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    ) as process:
        told: Any = process.stdout
        assert told.readline() == "ready\n"
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        assert told.readline() == "interrupted\n"
        rest = told.read().split()
        assert rest == [str(TorqueFreeMotion(*PAPER).precise(7, 20)[0][0]), "True"]
    assert process.returncode == 0
    after = os.times()
    spent = after.children_user + after.children_system
    assert spent - before.children_user - before.children_system < 10


@pytest.mark.parametrize("method", METHODS)
def test_the_other_process_says_the_same(method):
    motion = PreciseMotion(*GIVEN, method)
    for request in (Fraction(1, 3), ("m", "m_1")):
        here = motion.numbers_here(request, 300)
        there = worker.numbers(motion.numbers_here, request, 300)
        assert all(map(is_same, here, there))


def test_digits_beyond_the_quick_ones_come_from_elsewhere(monkeypatch):
    motion = TorqueFreeMotion(*PAPER)
    expected = motion.enclose("1/3", 300)
    monkeypatch.setattr(METHODS["theta"], "quick_bits", 100)
    again = TorqueFreeMotion(*PAPER).enclose("1/3", 300)
    assert worker._worker
    assert overlap(numbers(expected), numbers(again))
    TorqueFreeMotion(*PAPER).precise(1, 15)
    motion.enclose(1, 15)


def test_few_digits_need_no_process():
    TorqueFreeMotion(*PAPER).precise(3, 4000)
    assert worker._worker is None


def test_errors_over_there_are_errors_here(motion):
    with pytest.raises(KeyError):
        worker.numbers(motion.numbers_here, ("no such constant",), 100)


def test_a_process_that_dies_is_an_error_once(motion):
    worker.numbers(motion.numbers_here, Fraction(1), 100)
    assert worker._worker
    worker._worker.process.kill()
    worker._worker.process.wait()
    with pytest.raises((ChildProcessError, OSError)):
        worker.numbers(motion.numbers_here, Fraction(1), 100)
    assert len(worker.numbers(motion.numbers_here, Fraction(1), 100)) == 7


@pytest.mark.parametrize("python", ["/no/such/python", ""])
def test_where_no_process_can_be_started_the_same_is_computed_here(motion, monkeypatch, python):
    monkeypatch.setattr(sys, "executable", python)
    assert len(worker.numbers(motion.numbers_here, Fraction(1), 100)) == 7
    assert worker._worker is None


def in_child(digits):
    motion = PreciseMotion(*GIVEN, "theta")
    return [str(x) for x in worker.numbers(motion.numbers_here, Fraction(1), digits)]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
@pytest.mark.filterwarnings("ignore:This process:DeprecationWarning")
def test_children_of_fork_start_their_own():
    expected = in_child(100)
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as pool:
        assert list(pool.map(in_child, [100, 100, 100])) == [expected] * 3
    assert in_child(100) == expected


def test_threads_wait_for_their_turn(motion):
    times = list(map(Fraction, range(6)))
    with ThreadPoolExecutor(6) as pool:
        jobs = [pool.submit(worker.numbers, motion.numbers_here, t, 200) for t in times]
        found = [job.result() for job in jobs]
    with working(200):
        for at, values in zip(times, found, strict=True):
            assert overlap(values, motion.numbers_here(at, 200))


@pytest.mark.parametrize("value", [arb.nan(), arb(0), arb(-3) / 7, arb(2, 1e-9), arb(2) ** 5000])
def test_balls_travel_as_they_are(value):
    before = ctx.prec
    back = worker._ball(pickle.loads(pickle.dumps(worker._data_of(value))))
    assert value.is_nan() == back.is_nan()
    assert value.is_nan() or is_same(value, back)
    assert ctx.prec == before


HUGE = ("1e5000", "-1e-10000", 10**4400, Fraction(10**5000 + 1, 3**9000))


@pytest.mark.parametrize("index", range(len(HUGE)))
def test_times_beyond_what_python_writes(index):
    motion, t = TorqueFreeMotion(*PAPER), HUGE[index]
    q, _ = motion.precise(t, 20)
    balls, _ = motion.enclose(t, 30)
    for value, x in zip(balls, q, strict=True):
        assert value.overlaps(arb(str(x)) + arb(0, 1e-14))
    with pytest.raises(PrecisionError, match=r"t = \S{1,30}: 0 of 20 digits"):
        motion.precise(t, 20, max_seconds=1e-9)


@pytest.mark.parametrize("number", ["1e4400", "1e-5000", "1e10000", "1e-10000"])
def test_motions_of_huge_and_tiny_numbers(number):
    """The number stands in each place of the inputs."""
    for given in (
        ((number,) * 3, (1, 2, 3)),
        ((f"1{number[1:]}", f"2{number[1:]}", f"2.5{number[1:]}"), (1, 2, 3)),
        (PAPER[0], (number,) * 3),
        (PAPER[0], PAPER[1], (number, 0, 0, 1)),
        (PAPER[0], PAPER[1], (number, number, 0, 0)),
    ):
        motion = TorqueFreeMotion(*given)
        assert all(len(text) < 400 for text in (repr(motion), motion._repr_latex_()))
        assert "Torque-free motion" in motion._repr_html_()
        assert str(motion.regime)
        scale = max(map(abs, motion.exact["omega0"]))
        q, _ = motion.precise(1 / scale, 20)
        assert abs(sum(x * x for x in q) - 1) < 1e-14
        assert all(x.is_finite() for x in motion.enclose(1 / scale, 20)[1])


def test_a_radius_beyond_what_doubles_hold():
    q, omega = TorqueFreeMotion(PAPER[0], ("1 +/- 1e-5000", 1, 0)).enclose(1, 20)
    assert all(0 <= x.rad() < 1e-15 for x in (*q, *omega))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: TorqueFreeMotion((-(10**5000), 1, 1), PAPER[1]), r"inertia\[0\] = -1E\+5000: "),
        (lambda: TorqueFreeMotion((Fraction(-1, 3**9999), 1, 1), (1, 2, 3)), r"= -\d\.\d+E-4771: "),
        (
            lambda: TorqueFreeMotion([10**5000], PAPER[1]),
            "list with a number of more than 4300 dig",
        ),
        (lambda: TorqueFreeMotion(*PAPER).precise(1, 10**5000), r"digits = 1E\+5000: "),
        (lambda: TorqueFreeMotion(*PAPER)(10**5000), r"t = 1E\+5000: must be an array"),
        (lambda: TorqueFreeMotion(*PAPER)([10**5000]), "t = list with a number"),
        (lambda: inputs.exact("x", "1e" + "9" * 5000), "x = '1e9+.*: exponents go up to 10000"),
        (lambda: inputs.exact("x", "1" * 5000 + "?"), "x = '1+.*: must be a finite decimal number"),
    ],
)
def test_wrong_numbers_beyond_what_python_writes_are_one_line(make, message):
    with pytest.raises(InputError, match=message) as error:
        make()
    assert len(str(error.value)) < 300


@pytest.mark.parametrize(
    "text",
    ["1" * 5000, "0." + "3" * 5000, "1" * 5000 + "/" + "7" * 5000, "-1." + "2" * 5000 + "e-9"],
)
def test_long_texts_are_read_and_written_exactly(text):
    value = inputs.exact("x", text)
    assert inputs.exact("x", inputs.exact_text(value)) == value


def test_the_limit_of_python_is_left_alone():
    before = sys.get_int_max_str_digits()
    repr(TorqueFreeMotion(("1e10000",) * 3, (1, 2, 3)))
    assert sys.get_int_max_str_digits() == before
