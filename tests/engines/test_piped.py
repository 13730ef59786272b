"""Engines that ask a process: bits, words, refused bodies and times, and processes that end."""

import multiprocessing
import os
import shutil

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion, _engines
from rigidsym._codegen.targets import server
from rigidsym._engines.piped import PipedEngine, PipedStepper
from rigidsym.errors import EngineError
from rigidsym.validate import _same_bits
from rigidsym.validate.strata import STRATA

LANGUAGES = [name for name in _engines.SAME_BITS if name != "c"]
NEEDS = {"javascript": "node", "rust": "rustc"}
pytestmark = pytest.mark.skipif(
    not all(shutil.which(NEEDS[name]) for name in LANGUAGES),
    reason="needs what runs the languages: Node.js and rustc (Debian: nodejs, rustc)",
)
BODY = (1.0, 2.0, 2.5), (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0)
TIMES = np.linspace(-50.0, 400.0, 7)
every = pytest.mark.parametrize("language", LANGUAGES)


@every
def test_states_and_steps_have_the_bits_of_c(language):
    assert _same_bits.differences(STRATA, language) == ()


@every
@pytest.mark.parametrize("form", ["", "-pi"])
def test_states_are_those_of_numpy(language, form):
    engine = _engines.exactly(language + form)
    q, omega = engine.states(engine.prepare(*BODY), TIMES)
    expected = TorqueFreeMotion(*BODY)(TIMES)
    assert np.max(np.abs(q - expected[0])) < 3e-15
    assert np.max(np.abs(omega - expected[1])) < 3e-15
    # Through the interface of motions, for one time and for a grid.
    motion = TorqueFreeMotion(*BODY, engine=language + form)
    assert np.array_equal(motion(TIMES)[0], q)
    assert np.array_equal(motion(float(TIMES[2]))[0], q[2])
    assert np.array_equal(motion.grid(-50.0, 75.0, 7)[0], q)


@every
def test_refusals_have_the_words_of_c(language):
    ours, theirs = _engines.exactly(language), _engines.exactly("numpy")
    wrong = [
        *(((1.0, -2.0, 2.5), *BODY[1:]), (BODY[0], (np.nan, 0.0, 0.0), BODY[2])),
        *((*BODY[:2], (0.0, 0.0, 0.0, 0.0)), ((1.0, 2.0, 1e-70), *BODY[1:])),
        (BODY[0], (1e300, 0.0, 1e299), BODY[2]),
    ]
    for given in wrong:
        said = []
        for engine in (ours, theirs):
            with pytest.raises(EngineError) as error:
                engine.prepare(*given)
            said.append((error.value.field, error.value.rule))
        assert said[0] == said[1]
    prepared = ours.prepare(*BODY), theirs.prepare(*BODY)
    for late in (1e300, np.nan):
        said = []
        for engine, one in zip((ours, theirs), prepared, strict=True):
            with pytest.raises(EngineError) as error:
                engine.states(one, np.array([0.0, late]))
            said.append((error.value.field, error.value.rule, error.value.time))
        assert said[0] == said[1]
        q, omega = ours.states(prepared[0], np.array([0.0, late]), errors="nan")
        assert np.isfinite(q[0]).all()
        assert np.isnan(q[1]).all()
        assert np.isnan(omega[1]).all()


@every
def test_the_first_body_that_is_refused_is_named(language):
    engine = _engines.exactly(language)
    inertia = np.array([BODY[0], BODY[0], (1.0, -1.0, 1.0)])
    with pytest.raises(EngineError) as error:
        engine.propagate(inertia, BODY[1], BODY[2], TIMES)
    assert (error.value.field, error.value.body) == ("inertia", 2)
    q, _ = engine.propagate(inertia, BODY[1], BODY[2], TIMES, errors="nan")
    assert np.isnan(q[2]).all()
    assert np.array_equal(q[1], engine.states(engine.prepare(*BODY), TIMES)[0])
    stepper = _engines.exact_stepper(f"{language}-step")
    states = np.tile(BODY[2], (3, 1)), np.tile(BODY[1], (3, 1))
    with pytest.raises(EngineError) as error:
        stepper.step(inertia, *states, np.array([0.1]), states)
    assert (error.value.field, error.value.body) == ("inertia", 2)
    assert stepper.one((1.0, -1.0, 1.0), BODY[2], BODY[1], 0.1) is None


@every
def test_there_are_no_sensitivities(language):
    engine = _engines.exactly(language)
    with pytest.raises(EngineError, match="no sensitivities"):
        engine.sensitivities(engine.prepare(*BODY), TIMES)


def _child(engine, prepared, queue):
    queue.put((os.getpid(), engine.states(prepared, TIMES)[0]))


# JAX warns of it, where it has been used.
@pytest.mark.filterwarnings("ignore:.*fork.*")
@every
def test_a_child_of_a_fork_starts_a_process_of_its_own(language):
    engine = PipedEngine(language)
    prepared = engine.prepare(*BODY)
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=_child, args=(engine, prepared, queue))
    child.start()
    pid, found = queue.get(timeout=600)
    child.join(600)
    assert pid != os.getpid()
    assert np.array_equal(found, engine.states(prepared, TIMES)[0])


@every
def test_a_process_that_ends_is_told(language):
    stepper = PipedStepper(f"{language}-step")
    process = stepper._process._process
    process.kill()
    process.wait(600)
    with pytest.raises(EngineError, match="has ended"):
        stepper.one(*BODY[:1], BODY[2], BODY[1], 0.1)


@pytest.mark.parametrize(
    ("name", "needs"), [("javascript-pi", r"Node\.js"), ("rust-pi", r"Rust's compiler")]
)
def test_a_missing_tool_is_named(name, needs, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(InputError, match=rf"engine = {name}: needs {needs}"):
        server(name.partition("-")[0])(name, tmp_path, tmp_path)
