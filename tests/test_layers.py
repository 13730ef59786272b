"""Labelled arrays of xarray and lazy arrays of Dask, in and out of the public functions."""

import sys

import numpy as np
import pytest
from document_texts import blocks

from rigidsym import InputError, TorqueFreeMotion, propagate, step
from rigidsym import _layers as layers

DRAW = np.random.default_rng(8)
COUNT, TIMES = 20, np.arange(7.0)
INERTIA, RATES = DRAW.uniform(1, 1.5, (COUNT, 3)), DRAW.normal(size=(COUNT, 3))
ATTITUDES = DRAW.normal(size=(COUNT, 4))
MOTION = TorqueFreeMotion(INERTIA[0], RATES[0])
STATES = propagate(INERTIA, RATES, TIMES, ATTITUDES)
NAMES = [f"body {k}" for k in range(COUNT)]


def same(found, expected):
    for x, y in zip(found, expected, strict=True):
        np.testing.assert_array_equal(np.asarray(x), np.asarray(y))


@pytest.fixture(scope="module")
def xr():
    return pytest.importorskip("xarray", reason="needs xarray (extra frames)")


@pytest.fixture(scope="module")
def da():
    return pytest.importorskip("dask.array", reason="Dask is not installed (extra cluster)")


@pytest.fixture
def labelled(xr):
    """Return labelled moments, rates and attitudes."""
    coords = {"body": NAMES, "mass": ("body", np.arange(COUNT)), "site": 3}
    inertia = xr.DataArray(INERTIA, dims=["body", "axis"], coords=coords)
    rates = xr.DataArray(
        RATES, coords={"body": NAMES, "xyz": ["x", "y", "z"]}, dims=["body", "xyz"]
    )
    return inertia, rates, xr.DataArray(ATTITUDES, dims=["body", "component"])


def test_dimensions_and_coordinates_are_kept(xr, labelled):
    inertia, rates, attitudes = labelled
    dates = np.datetime64("2026-01-01") + np.arange(7).astype("m8[s]")
    time = xr.DataArray(dates, dims="time", coords={"time": dates})
    q, omega = propagate(inertia, rates, time, attitudes)
    same((q, omega), STATES)
    assert (q.dims, omega.dims) == (("body", "time", "component"), ("body", "time", "xyz"))
    assert (q.name, omega.attrs["units"]) == ("q", "rad/s")
    for name in ("body", "mass", "site", "time"):
        assert name in q.coords
        assert name in omega.coords
    assert (omega.sel(body="body 3", xyz="y") == STATES[1][3, :, 1]).all()
    # By name, in whatever order the dimensions are.
    swapped = propagate(inertia.T, rates.T, time, attitudes.T)
    assert swapped[0].identical(q)
    plain = propagate(inertia, RATES[0], TIMES, ATTITUDES[0])
    same(plain, propagate(INERTIA, RATES[0], TIMES, ATTITUDES[0]))
    assert plain[0].dims == ("body", "t", "component")
    assert plain[0].component.values.tolist() == ["q0", "q1", "q2", "q3"]
    assert propagate(inertia, rates, 3.0)[0].dims == ("body", "component")
    stacked = inertia.expand_dims(run=[1, 2]).stack(both=("run", "body"))
    q, _ = propagate(stacked, RATES[0], TIMES)
    assert q.indexes["both"].names == ["run", "body"]
    same(
        [q.sel(run=2).sel(body=NAMES[3])],
        [plain[0][3] * 0 + propagate(INERTIA[3], RATES[0], TIMES)[0]],
    )


def test_times_have_dimensions_of_their_own_or_those_of_bodies(xr, labelled):
    inertia, rates, attitudes = labelled
    runs = xr.DataArray(np.stack([TIMES, TIMES + 1]), dims=["run", "time"])
    q, _ = propagate(inertia, rates, runs, attitudes)
    assert q.dims == ("body", "run", "time", "component")
    same([q[:, 0]], STATES[:1])
    each = xr.DataArray(np.arange(float(COUNT)), dims="body")
    q, omega = propagate(inertia, rates, each, attitudes)
    assert q.dims == ("body", "component")
    same((q[5], omega[5]), propagate(INERTIA[5], RATES[5], 5.0, ATTITUDES[5]))
    rows = xr.DataArray(np.tile(TIMES, (COUNT, 1)), dims=["body", "time"])
    same(propagate(inertia, rates, rows.T, attitudes), STATES)


def test_motions_and_steps_of_labelled_arrays(xr):
    found = MOTION.to_xarray(TIMES)
    time = xr.DataArray(TIMES, dims="when", coords={"when": TIMES})
    q, omega = MOTION(time)
    same((q, omega), (found.q, found.omega))
    assert q.when.identical(time.when)
    for dt in (0.5, xr.DataArray(TIMES / 10, dims="t")):
        after = step(INERTIA[0], found.q, found.omega, dt)
        same(after, step(INERTIA[0], found.q.values, found.omega.values, np.asarray(dt)))
        assert after[0].dims == found.q.dims
        assert after[1].t.identical(found.t)


def test_labelled_arrays_that_do_not_fit_are_refused(xr, labelled):
    inertia, rates, _ = labelled
    square = xr.DataArray(np.ones((3, 3)), dims=["body", "xyz"])
    for call, rule in (
        (
            lambda: propagate(inertia, RATES, TIMES),
            r"omega0 = .* without labels: must be one vector",
        ),
        (lambda: propagate(inertia, rates, np.ones((COUNT, 2))), "t = .*without labels"),
        (lambda: step(inertia, ATTITUDES[0], rates, np.ones(COUNT)), "dt = .*without labels"),
        (lambda: propagate(inertia.to_dataset(name="x"), rates, 1.0), "inertia = a Dataset"),
        (
            lambda: propagate(inertia.rename(axis="body", body="axis"), rates, 1.0),
            "inertia = .*sizes",
        ),
        (lambda: propagate(square, RATES[0], 1.0), r"inertia = .*name must be 'axis'"),
        (lambda: propagate(xr.DataArray(3.0), RATES[0], 1.0), "inertia = a DataArray of sizes {}"),
        (
            lambda: propagate(inertia, rates.assign_attrs(units="deg/s"), 1.0),
            "omega0 = .*contradict",
        ),
        (
            lambda: propagate(inertia, rates.assign_attrs(units="rad/s"), 1.0, degrees=True),
            "omega0 = ",
        ),
        (lambda: propagate(inertia[:5], rates, 1.0), "inertia, omega0 = as given: .*body"),
        (lambda: propagate(inertia, rates, 1.0, sensitivity=True), "sensitivity = True"),
        (lambda: propagate(inertia, rates, TIMES, out=STATES), "out = "),
        (lambda: propagate(-inertia, rates, 1.0), r"inertia\[0, 0\] = -"),
        (lambda: MOTION(xr.DataArray(np.ones((2, 2)))), "t = .*one-dimensional"),
    ):
        with pytest.raises(InputError, match=f"^{rule}"):
            call()


def test_arrays_of_dask_stay_lazy(da, monkeypatch):
    def lazy(array, chunks):
        return da.from_array(array, chunks=chunks)

    seen = []
    for given, expected in (
        ((lazy(INERTIA, (7, 2)), lazy(RATES, 5), TIMES, ATTITUDES), STATES),
        ((INERTIA, RATES, lazy(TIMES, 3), ATTITUDES), STATES),
        ((INERTIA, RATES, lazy(np.tile(TIMES, (COUNT, 1)), (7, 3)), ATTITUDES), STATES),
        (
            (lazy(INERTIA.astype("f4"), 7), RATES[0], 2.0),
            propagate(INERTIA.astype("f4"), RATES[0], 2.0),
        ),
        (
            (lazy(INERTIA[:, None], (7, 1, 3)), lazy(RATES[:6], 4), 2.0),
            propagate(INERTIA[:, None], RATES[:6], 2.0),
        ),
        ((lazy(INERTIA[:0], 7), RATES[0], TIMES), propagate(INERTIA[:0], RATES[0], TIMES)),
    ):
        found = propagate(*given)
        assert all(isinstance(x, da.Array) and x.dtype == np.float64 for x in found)
        assert [x.shape for x in found] == [x.shape for x in expected]
        same(found, expected)
        seen.append(found[0].chunks)
    assert seen[:2] == [((5, 2, 3, 4, 1, 5), (7,), (4,)), ((COUNT,), (3, 3, 1), (4,))]
    same(MOTION(lazy(TIMES, 2)), MOTION(TIMES))
    for dt in (0.1, lazy(np.full(COUNT, 0.1), 3)):
        q, omega = step(lazy(INERTIA, 7), ATTITUDES, RATES, dt)
        assert isinstance(q, da.Array)
        same((q, omega), step(INERTIA, ATTITUDES, RATES, 0.1))


def test_sensitivities_of_dask_and_dask_in_xarray(da, labelled):
    found = propagate(da.from_array(INERTIA, chunks=7), RATES, TIMES, ATTITUDES, sensitivity=True)
    expected = propagate(INERTIA, RATES, TIMES, ATTITUDES, sensitivity=True)
    same((*found[:2], found[2].attitude), (*expected[:2], expected[2].attitude))
    same([found[2].transition], [expected[2].transition])
    inertia, rates, attitudes = labelled
    q, omega = propagate(inertia.chunk(body=6), rates, TIMES, attitudes)
    assert isinstance(q.data, da.Array)
    assert q.chunksizes["body"] == (6, 6, 6, 2)
    same((q, omega), STATES)


def test_every_block_is_computed_once(da, monkeypatch):
    called, block = [], layers._block

    def counted(*blocks, **more):
        called.append(len(blocks[0]))
        return block(*blocks, **more)

    monkeypatch.setattr(layers, "_block", counted)
    lazy = da.from_array(INERTIA, chunks=7)
    for q, omega in (propagate(lazy, RATES[0], TIMES), step(lazy, ATTITUDES[0], RATES[0], 0.1)):
        assert not called
        da.compute((q**2).sum(), omega.mean(), scheduler="synchronous")
        assert sorted(called) == [6, 7, 7]
        called.clear()


def test_the_page_on_many_bodies_runs(tmp_path, monkeypatch):
    """Run its code with few bodies, and without the cluster."""
    for name in ("dask.array", "distributed", "zarr", "xarray"):
        pytest.importorskip(name, reason=f"{name} is not installed (extra dev)")
    code = "".join(blocks("python no-run", "many.md"))
    for line, given in (
        ('client = Client("tcp://host:8786")  # the address of dask scheduler', ""),
        ("1_000_000_000, 1_000_000", "100, 25"),
        ('zarr.create_array("q.zarr"', 'zarr.create_array("q2.zarr"'),
        ('zarr.create_array("omega.zarr"', 'zarr.create_array("omega2.zarr"'),
        ("out = (", "inertia, omega0 = da.compute(inertia, omega0)\nout = ("),
    ):
        assert code.count(line) == 1
        code = code.replace(line, given)
    monkeypatch.chdir(tmp_path)
    scope = {"names": [f"debris {k}" for k in range(100)], "times": TIMES}
    exec(code, scope)
    q, omega = propagate(scope["inertia"], scope["omega0"], [600.0])
    same((*scope["outputs"], *scope["out"]), (q, omega, q, omega))
    assert scope["omega"].dims == ("body", "t", "axis")


def test_chunks_of_unknown_size(da):
    some = da.from_array(INERTIA, chunks=7)
    some = some[some[:, 0] > 1.2]
    same(propagate(some, RATES[0], TIMES), propagate(INERTIA[INERTIA[:, 0] > 1.2], RATES[0], TIMES))
    with pytest.raises(InputError, match=r"unknown size do not fit \(x.compute_chunk_sizes\(\)\)$"):
        propagate(some, RATES, TIMES)


def test_lazy_arrays_that_do_not_fit_are_refused(da):
    lazy, bad = da.from_array(INERTIA, chunks=7), INERTIA.copy()
    bad[9, 1] = -1
    dates = da.from_array(np.array(["2026-01-01"], "M8[s]"))
    for call, rule in (
        (lambda: propagate(lazy[:, :2], RATES, 1.0), "inertia = .*last axis must have 3 numbers"),
        (lambda: propagate(lazy, RATES[:5], 1.0), r"omega0 = leading shape \(5,\): must broadcast"),
        (lambda: propagate(lazy, RATES, 1.0, engine="x"), "engine = 'x'"),
        (lambda: propagate(lazy, RATES, TIMES, out=STATES), "out = "),
        (lambda: propagate(lazy, RATES, dates), r"t = .*dates.*\(give t - epoch\)"),
        (lambda: MOTION(da.ones((2, 2))), "t = .*one-dimensional"),
        (
            lambda: propagate(da.from_array(bad, chunks=7), RATES, 1.0)[0].compute(),
            r"inertia\[2, 1\] = -1.0: .*must be positive \(numbered in its block of a Dask array\)",
        ),
        (
            lambda: propagate(da.from_array(np.ma.masked_less(bad, 0)), RATES, 1.0)[1].compute(),
            r"inertia\[9, 1\] = --: is masked",
        ),
    ):
        with pytest.raises(InputError, match=f"^{rule}"):
            call()
    lenient = propagate(da.from_array(bad, chunks=7), RATES, 1.0, errors="nan")[0].compute()
    assert np.flatnonzero(np.isnan(lenient[:, 0])).tolist() == [9]


def test_a_library_that_is_not_imported_has_no_arrays(monkeypatch):
    for name in ("xarray", "dask.array"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    same(propagate(INERTIA, RATES, TIMES, ATTITUDES), STATES)
    assert "dask.array" not in sys.modules
