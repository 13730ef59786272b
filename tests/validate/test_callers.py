"""What callers do is noticed where it changes states: on modules as they are, and as they were."""

import numpy as np
import pytest

from rigidsym import _inputs as inputs
from rigidsym._engines import ENGINES, batches, exactly
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym.validate import _entry_points as entry_points
from rigidsym.validate.faults import BY_HAND
from rigidsym.validate.faults._detection import mutated_engine

BODY = tuple(map(np.array, ((1.0, 2.0, 2.5), (0.3, -0.2, 0.9), (0.5, -1.0, 2.0, 0.25))))
TIMES = np.array([0.0, 1.0, -30.0])
KEEPS_RATES = next(
    f for f in BY_HAND if f.line == "numpy: the caller's rates kept in a prepared motion"
)


class Unchecked(NumpyEngine):
    """An engine that looks at no memory, as NumPy's once did."""

    def propagate(self, inertia, omega0, attitude0, t, out=None, errors="raise"):
        states = self.module.states(self.module.prepare(inertia, omega0, attitude0, errors), t)
        for given, found in zip(out or states, states, strict=True):
            given[...] = found
        return out or states


class Reading(Unchecked):
    """The same, writing states before all inputs are read."""

    def propagate(self, inertia, omega0, attitude0, t, out=None, errors="raise"):
        if out is None or errors == "nan":
            return super().propagate(inertia, omega0, attitude0, t, out, errors)
        for k in range(len(omega0)):
            prepared = self.module.prepare(inertia[k], omega0[k], attitude0[k])
            out[0][k], out[1][k] = self.module.states(prepared, t)
        return out


def apart(engine, body=BODY):
    return [entry_points._apart(*both) for both in entry_points.by_callers(engine, body, TIMES)]


@pytest.mark.parametrize("name", ENGINES)
def test_engines_refuse_outputs_that_are_inputs_and_change_nothing(name):
    overwritten, mixed = apart(exactly(name))
    assert overwritten == 0
    assert mixed < 4e-15


@pytest.mark.parametrize("size", [2.0**-1073, 2.0**-300, 2.0**1018])
@pytest.mark.parametrize("name", ENGINES)
def test_bodies_of_every_size_have_company(name, size):
    body = (np.array([16.0, 16.0, 1.0]) * size, *BODY[1:])
    assert max(apart(exactly(name), body)) < 4e-15


class Keeping(NumpyEngine):
    """An engine that leaves the caller's memory as it is where a body is refused."""

    def propagate(self, inertia, omega0, attitude0, t, out=None, errors="raise"):
        found = super().propagate(inertia, omega0, attitude0, t, None, errors)
        for given, states in zip(out or found, found, strict=True):
            np.copyto(given, states, where=~np.isnan(states))
        return out or found


def test_states_that_are_not_written_are_noticed():
    assert np.isnan(apart(Keeping())[-1])


def test_a_plan_that_keeps_memory_is_noticed():
    overwritten, *_ = apart(mutated_engine(KEEPS_RATES))
    assert overwritten > 1


def test_outputs_that_are_read_after_they_are_written_are_noticed():
    _, *aliased, _ = apart(Reading())
    # Rates written over moments are no moments, and refused.
    assert len(aliased) == 2
    assert max(aliased) > 0.1
    # An engine may as well compute all before it writes any.
    _, *aliased, _ = apart(Unchecked())
    assert max(aliased) < 4e-15


def only_the_first(inertia, allow_nonphysical, lenient):
    """As it was: of the bodies that rounding makes look impossible, the first was examined."""
    scaled = inertia / np.max(inertia, axis=-1, keepdims=True)
    for place in np.argwhere((inertia > 0).all(-1) & (np.sum(scaled, axis=-1) < 2))[:1]:
        inputs.inertia(inertia[tuple(place)].tolist())
    return inertia


def test_an_impossible_body_behind_a_flat_one_is_noticed(monkeypatch):
    monkeypatch.setattr(batches, "possible", only_the_first)
    assert np.isnan(apart(exactly("numpy"))[-1])
