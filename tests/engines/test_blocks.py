"""Outputs that take slices: memory maps, Zarr arrays and others, filled block by block."""

import tracemalloc

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion, propagate, step
from rigidsym._engines import blocks

DRAW = np.random.default_rng(5)
COUNT, TIMES = 60, np.arange(7.0)
INERTIA, RATES = DRAW.uniform(1, 1.5, (COUNT, 3)), DRAW.normal(size=(COUNT, 3))
MOTION = TorqueFreeMotion(INERTIA[0], RATES[0])


class Stored:
    """An array on disk: it takes slices of its whole shape, and is no array of NumPy."""

    def __init__(self, shape, chunks=None, dtype=float):
        self.values, self.chunks, self.largest = np.full(shape, np.nan, dtype), chunks, 0
        self.shape, self.dtype = self.values.shape, self.values.dtype

    def __getitem__(self, index):
        return self.values[index]

    def __array__(self, dtype=None, copy=None):
        return self.values.copy()

    def __setitem__(self, index, values):
        assert all(isinstance(x, slice) for x in index)
        self.largest = max(self.largest, values.size)
        self.values[index] = values


@pytest.fixture(params=["stored", "memmap", "zarr"])
def stored(request, tmp_path):
    """Return a function that makes an output array of a shape."""
    made = []

    def make(*shape):
        made.append(shape)
        path = tmp_path / str(len(made))
        if request.param == "stored":
            return Stored(shape, tuple(min(x, 5) for x in shape))
        if request.param == "memmap":
            return np.memmap(path, float, "w+", shape=shape)
        zarr = pytest.importorskip("zarr", reason="Zarr is not installed (extra dev)")
        return zarr.open(
            path, mode="w", shape=shape, dtype=float, chunks=tuple(min(x, 16) for x in shape)
        )

    return make


def message(call):
    with pytest.raises(InputError) as caught:
        call()
    return str(caught.value)


@pytest.mark.parametrize("most", [3, 100, 1 << 18])
def test_outputs_have_the_bits_and_the_errors_of_arrays(most, stored, monkeypatch):
    monkeypatch.setattr(blocks, "_STATES", most)
    grid = INERTIA.reshape(12, 5, 3), RATES[:5]
    start = propagate(INERTIA, RATES, 1.0)[0]
    late, fast, rows = TIMES.copy(), RATES.copy(), np.tile(TIMES, (COUNT, 1))
    late[5], fast[-1], rows[40, 5] = 1e300, 1e3, 1e300
    for call, shape, refused in (
        (lambda **k: propagate(INERTIA, RATES, TIMES, **k), (COUNT, 7), False),
        (lambda **k: propagate(*grid, 1.0, **k), (12, 5), False),
        (lambda **k: propagate(INERTIA[:0], RATES[:0], TIMES, **k), (0, 7), False),
        (lambda **k: propagate(INERTIA, RATES, late, errors="nan", **k), (COUNT, 7), False),
        (lambda **k: propagate(INERTIA, RATES, late, **k), (COUNT, 7), True),
        (lambda **k: propagate(INERTIA, RATES, rows, **k), (COUNT, 7), True),
        (lambda **k: step(INERTIA, start, RATES, 0.1, **k), (COUNT,), False),
        (lambda **k: step(INERTIA, start, fast, 0.1, **k), (COUNT,), True),
        (lambda **k: MOTION(TIMES, **k), (7,), False),
        (lambda **k: MOTION(3.0, **k), (), False),
        (lambda **k: MOTION(late, **k), (7,), True),
    ):
        out = stored(*shape, 4), stored(*shape, 3)
        if refused:
            assert message(lambda call=call, out=out: call(out=out)) == message(call)
            continue
        found = call(out=out)
        assert found[0] is out[0]
        for x, y in zip(found, call(), strict=True):
            np.testing.assert_array_equal(x[...], y)


def test_a_step_in_place(stored):
    q, omega = stored(COUNT, 4), stored(COUNT, 3)
    q[:, :], omega[:, :] = propagate(INERTIA, RATES, 1.0)
    expected = step(INERTIA, q[:, :].copy(), omega[:, :].copy(), 0.1)
    step(INERTIA, q, omega, 0.1, out=(q, omega))
    np.testing.assert_array_equal(q[:, :], expected[0])
    np.testing.assert_array_equal(omega[:, :], expected[1])


def test_blocks_are_whole_chunks_and_memory_is_bounded(monkeypatch):
    monkeypatch.setattr(blocks, "_STATES", 4096)
    count, out = 40_000, (Stored((40_000, 4), (1000, 4)), Stored((40_000, 3), (1000, 3)))
    inertia = np.broadcast_to(INERTIA[0], (count, 3))
    propagate(inertia[:10], RATES[0], 1.0)
    tracemalloc.start()
    propagate(inertia, RATES[0], 1.0, out=out, engine="c")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert [x.largest for x in out] == [16_000, 12_000]
    assert peak < out[0].values.nbytes
    assert not np.isnan(out[1].values).any()


def test_outputs_that_cannot_take_states_are_refused(tmp_path):
    shape, omega = (7, 4), np.empty((7, 3))
    memory = np.memmap(tmp_path / "q", float, "w+", shape=shape)
    dask = pytest.importorskip("dask.array", reason="Dask is not installed (extra cluster)")
    for q, rule in (
        (Stored(shape, dtype=np.float32), r"q is float32 of shape \(7, 4\): must be float64"),
        (Stored((6, 4)), r"q is float64 of shape \(6, 4\): must be float64 of shape \(7, 4\)"),
        (np.memmap(tmp_path / "q", float, "r", shape=shape), "q can only be read"),
        (dask.zeros(shape), "q is a Array: must be an array that takes slices"),
        ([1.0], "q is a list: must be an array"),
    ):
        assert message(lambda q=q: MOTION(TIMES, out=(q, omega))).startswith("out = as given: q ")
        with pytest.raises(InputError, match=rule):
            MOTION(TIMES, out=(q, omega))
    with pytest.raises(InputError, match="must not overlap"):
        MOTION(memory[:, 0], out=(memory, Stored((7, 3))))
    with pytest.raises(InputError, match="must be an array"):
        MOTION.grid(0, 1, 7, out=(Stored(shape), omega))
    assert MOTION.grid(0, 1, 7, out=(memory, omega))[0] is memory
    np.testing.assert_array_equal(memory, MOTION.grid(0, 1, 7)[0])
