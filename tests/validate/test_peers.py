"""Peers: accuracy on easy motions, refusals, and failures."""

import math
import os
import subprocess
import sys
from importlib import import_module

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym._engines import EngineError
from rigidsym.validate import peers
from rigidsym.validate.peers import PEERS
from rigidsym.validate.peers import _integrators as integrators
from rigidsym.validate.peers._integrators import Integrator
from rigidsym.validate.peers._protocol import Start, checked

# Distance of quaternions, relative to unity, and of rates, relative to |omega0|.
WITHIN = {"heyoka": 1e-13, "dop853": 1e-12, "lsoda": 3e-11, "orekit": 1e-10}
TIMES = np.array([0.0, 3.0, -7.5, 20.0, 3.0, -0.1, 0.0, -30.0, 11.0])
MOTIONS = {
    "circulation about the largest": ((1, 2, 2.5), (0.1, 0.2, 0.8), (1, 0, 0, 0)),
    "circulation about the least": ((2.5, 1, 2), (0.1, -0.9, 0.2), (0.5, -0.5, 0.5, 0.5)),
    "the middle axis last, not a unit": ((1, 2.5, 2), (-0.6, 0.3, 0.4), (3, -1, 2, -8)),
    "negative rates, a tiny attitude": ((2, 1, 2.5), (-0.3, -0.2, -0.7), (0, 1e-200, 0, -2e-200)),
    "two equal moments": ((1, 1, 1.5), (0.4, 0.3, -0.5), (-1, 0, 0, 0)),
    "slow": ((1e-9, 2e-9, 2.5e-9), (4e-4, -3e-4, 6e-4), (1, 1, -1, 1)),
    "fast": ((1e4, 1.2e4, 8e3), (-4e3, 3e3, 5e3), (-1, 0, 2, 0)),
}


def the(name):
    """Return a peer, made once; skip the test if it is not installed."""
    if name not in MADE:
        try:
            MADE[name] = peers.peer(name)
        except InputError as error:
            pytest.skip(str(error))
    return MADE[name]


MADE: dict = {}
peer = pytest.fixture(params=PEERS)(lambda request: the(request.param))
integrator = pytest.fixture(params=[name for name in PEERS if name != "orekit"])(
    lambda request: the(request.param)
)


def turned(omega0):
    """Return times that suit the speed of a motion."""
    return TIMES / math.hypot(*omega0)


def exact(motion, t):
    q, omega = TorqueFreeMotion(*motion).precise(t.tolist(), 25)
    return np.array(q, float), np.array(omega, float)


def gaps(found, expected):
    return np.max(np.abs(np.array(found, float) - expected), axis=-1)


@pytest.mark.parametrize("name", MOTIONS)
def test_peers_agree_with_the_derivation(peer, name):
    t, within, motion = turned(MOTIONS[name][1]), WITHIN[peer.name], MOTIONS[name]
    (q, omega), (exact_q, exact_omega) = peer.states(peer.prepare(*motion), t), exact(motion, t)
    assert q.shape == (t.size, 4)
    assert omega.shape == (t.size, 3)
    apart = gaps(q, exact_q)
    if not peer.double_cover_sign:
        apart = np.minimum(apart, gaps(-q, exact_q))
    assert np.max(apart) < within
    assert np.max(gaps(omega, exact_omega)) < within * math.hypot(*motion[1])


def test_the_start_is_the_attitude_with_its_sign(integrator):
    prepared = integrator.prepare((1, 2, 2.5), (0.1, 0.2, 0.8), (-3, 0, 4, 0))
    q, omega = integrator.states(prepared, [0.0])
    assert q.tolist() == [[-0.6, 0, 0.8, 0]]
    assert omega.tolist() == [[0.1, 0.2, 0.8]]


def test_a_whole_turn_turns_the_double_cover_sign(integrator):
    prepared = integrator.prepare((1, 1, 1), (0, 0, 1), (1, 0, 0, 0))
    q, _ = integrator.states(prepared, [2 * np.pi, 4 * np.pi, -2 * np.pi])
    assert gaps(q[:, 0], [-1, 1, -1]).max() < 1e-10


def test_plans_and_calls_leave_nothing_behind(peer):
    first, second = (peer.prepare(*MOTIONS[name]) for name in list(MOTIONS)[:2])
    found = [peer.states(prepared, TIMES) for prepared in (first, second, first)]
    assert all(np.array_equal(a, b) for a, b in zip(found[0], found[2], strict=True))


def test_no_times(peer):
    q, omega = peer.states(peer.prepare((1, 2, 2.5), (0.1, 0.2, 0.8), (1, 0, 0, 0)), [])
    assert (q.shape, omega.shape) == ((0, 4), (0, 3))


def test_rest(integrator):
    q, omega = integrator.states(
        integrator.prepare((1, 2, 2.5), (0, 0, 0), (0, 2, 0, 0)), [5.0, -5.0]
    )
    assert q.tolist() == [[0, 1, 0, 0]] * 2
    assert not np.any(omega)


def outcome(peer, motion, t):
    """Return the shape of q, or the number of lines of a refusal."""
    try:
        return peer.states(peer.prepare(*motion), t)[0].shape
    except EngineError as error:
        return str(error).count("\n") + 1


@pytest.mark.parametrize("rate", [1e-300, 1e-160, 1e160, 1e300])
@pytest.mark.parametrize("moment", [1e-300, 1e300])
def test_the_ends_of_the_range_break_nothing_but_the_states(peer, rate, moment, monkeypatch):
    monkeypatch.setattr(integrators, "_MOST_EVALUATIONS", 10_000)
    motion = np.array([1, 1.5, 2]) * moment, np.array([0.3, 0.4, 0.5]) * rate, (1, 0, 0, 0)
    assert outcome(peer, motion, turned(motion[1])) in {(TIMES.size, 4), 1}


def test_the_separatrix_breaks_nothing_but_the_states(peer):
    assert outcome(peer, ((4, 5, 9), (3, 0.3, 1), (1, 0, 0, 0)), [20.0]) in {(1, 4), 1}


@pytest.mark.parametrize(
    ("motion", "line"),
    [
        (((1, 2), (0, 0, 1), (1, 0, 0, 0)), "inertia: shape (2,): one body's must be (3,)"),
        (((1, 2, 0), (0, 0, 1), (1, 0, 0, 0)), "inertia: principal moments must be positive"),
        (((1, 2, 2), (0, 0, np.nan), (1, 0, 0, 0)), "omega0: every number must be finite"),
        (((1, 2, 2), (0, 0, "x"), (1, 0, 0, 0)), "omega0: must be numbers"),
        (((1, 2, 2), (0, 0, 1), (0, 0, 0, 0)), "attitude0: must not be zero"),
    ],
)
def test_motions_that_are_none(motion, line):
    with pytest.raises(EngineError) as caught:
        Start.of(*motion)
    assert str(caught.value) == line


@pytest.mark.parametrize("t", [[np.inf], [np.nan], 1.0, [[1.0]], ["x"]])
def test_times_that_are_none(t):
    with pytest.raises(EngineError, match=r"^t: "):
        checked(t)


def test_what_breaks_down_on_one_side_is_nan_there_from_then_on():
    class Breaking(Integrator):
        def follow(self, start, times):
            if times[0] < 0:
                raise ArithmeticError
            return np.array([[1.0] * 7, [np.nan] * 7, [1.0] * 7])

    start = Start.of((1, 2, 2), (0, 0, 1), (1, 0, 0, 0))
    q, _ = Breaking().states(start, [4, -1, 0, 2, 1, 3])
    assert np.isnan(q[:, 0]).tolist() == [True, True, False, True, False, True]


@pytest.mark.parametrize("name", ["dop853", "lsoda"])
def test_evaluations_are_limited(name, monkeypatch):
    monkeypatch.setattr(integrators, "_MOST_EVALUATIONS", 100)
    found = the(name)
    q, _ = found.states(found.prepare(*MOTIONS["two equal moments"]), [0.0, 1e6])
    assert np.isnan(q[:, 0]).tolist() == [False, True]


def test_steps_are_limited():
    heyoka = the("heyoka")
    q, _ = heyoka.states(heyoka.prepare(*MOTIONS["two equal moments"]), [1.0, 1e7])
    assert np.isnan(q[:, 0]).tolist() == [False, True]


def test_packages_are_imported_by_the_peers_that_need_them():
    code = (
        "import sys, rigidsym.validate.peers; print({'heyoka', 'scipy', 'jpype'} & {*sys.modules})"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


def test_a_peer_that_does_not_exist():
    with pytest.raises(InputError) as caught:
        peers.peer("foo")
    line = "peer = foo: must be one of: heyoka, dop853, lsoda, orekit"
    assert str(caught.value) == line


@pytest.mark.parametrize(
    ("name", "module", "package"),
    [
        ("heyoka", "heyoka", "heyoka"),
        ("dop853", "scipy.integrate", "scipy"),
        ("lsoda", "scipy.integrate", "scipy"),
        ("orekit", "orekit_jpype", "orekit-jpype"),
    ],
)
def test_a_package_that_is_missing(name, module, package, monkeypatch):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(InputError) as caught:
        peers.peer(name)
    assert str(caught.value) == f"peer = {name}: needs the package {package} (extra bench)"


def test_java_that_is_missing(monkeypatch):
    the("orekit")
    jpype = import_module("jpype")

    def none():
        raise jpype.JVMNotFoundException

    monkeypatch.setattr(jpype, "getDefaultJVMPath", none)
    with pytest.raises(InputError, match=r"^peer = orekit: needs Java"):
        peers.peer("orekit")


def test_java_does_not_outlive_a_fork(monkeypatch):
    orekit = the("orekit")
    orekit.prepare(*MOTIONS["two equal moments"])
    monkeypatch.setattr(os, "getpid", lambda: -1)
    with pytest.raises(EngineError, match=r"^orekit: Java does not outlive a fork"):
        orekit.prepare(*MOTIONS["two equal moments"])


def test_peers_name_themselves_and_how_far_they_go(peer):
    assert peer.name in PEERS
    assert peer.version[0].isdigit()
    assert peer.reach >= 300
    assert peer.double_cover_sign == (peer.name != "orekit")
