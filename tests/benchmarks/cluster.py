"""Cost and memory of many bodies on a Dask cluster of this machine, and of outputs on disk.

    nice uv run python tests/benchmarks/cluster.py
    python tests/benchmarks/cluster.py --quick              few bodies, workers in this process
    python tests/benchmarks/cluster.py --bodies 1e8 --chunk 1e6 --workers 16

Bodies are drawn on the workers.  A row has the processor time of all processes for each body, the
wall-clock time, and the most memory that any process has had until then.  All rows of the cluster
contain the first, drawing the bodies.
"""

import logging
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from bench import options

import rigidsym

TIMES = (600.0,)
_MB = 1 << 20


def main() -> None:
    given = options(
        __doc__,
        bodies={"type": float, "default": 1e7},
        chunk={"type": float, "default": 2.5e5},
        workers={"type": int, "default": 2},
    )
    try:
        import dask.array as da
        import distributed
        import zarr
    except ImportError as error:
        print(f"{error.name} is not installed (extras cluster and dev): nothing is measured")
        return
    count = 40_000 if given.quick else int(given.bodies)
    chunk = min(int(given.chunk), count // 4)
    print(f"{count} bodies in chunks of {chunk}, {len(TIMES)} time each, {given.workers} workers")
    print(f"{'':44} {'µs a body':>10} {'wall s':>8} {'peak MB':>8}")
    with (
        tempfile.TemporaryDirectory() as folder,
        distributed.LocalCluster(
            n_workers=1 if given.quick else given.workers,
            threads_per_worker=1,
            processes=not given.quick,
            dashboard_address=None,
            silence_logs=logging.CRITICAL,
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        client.run(_warm)
        drawn = bodies(da, count, chunk)
        q, omega = rigidsym.propagate(*drawn[:2], TIMES, drawn[2])
        after = rigidsym.step(drawn[0], drawn[2], drawn[1], 0.1)
        shapes = (count, 1, 4), (count, 1, 3)

        def stored(name: str, part: int) -> list[Any]:
            paths = [Path(folder) / f"{name}{k}" for k in range(len(shapes))]
            made = [{"shape": x, "chunks": (part, *x[1:]), "dtype": float} for x in shapes]
            return [
                zarr.create_array(path, compressors=None, **settings)
                for path, settings in zip(paths, made, strict=True)
            ]

        def reduced(*arrays: Any) -> None:
            da.compute(*((x**2).mean(axis=0) for x in arrays))

        reduced(*(x[: 10 * given.workers] for x in drawn))  # imports of the workers
        row("the bodies drawn, reduced", count, client, lambda: reduced(*drawn))
        row("and propagate, reduced", count, client, lambda: reduced(q, omega))
        row("and step, reduced", count, client, lambda: reduced(*after))
        row("and propagate, to Zarr", count, client,
            lambda: da.store([q, omega], stored("dask", chunk), lock=False))  # fmt: skip
        some = min(count, 1_000_000)
        plain = [np.asarray(x) for x in da.compute(*(x[:some] for x in drawn))]
        here = TIMES, plain[2]
        shapes = (some, 1, 4), (some, 1, 3)
        for name, outputs in (("out= Zarr", stored("one", some // 8)), ("in memory", None)):
            out = outputs and (outputs[0], outputs[1])
            row(f"{some} in this process, {name}", some, None,
                lambda out=out: rigidsym.propagate(*plain[:2], *here, out=out))  # fmt: skip


def bodies(da: Any, count: int, chunk: int) -> tuple[Any, Any, Any]:
    """Return lazy moments, rates and attitudes of random bodies, as arrays of Dask."""
    draw = da.random.default_rng(1)
    inertia = draw.uniform(0.5, 0.9, (count, 3), chunks=(chunk, 3))
    omega = draw.normal(0, 0.1, (count, 3), chunks=(chunk, 3))
    return inertia, omega, draw.normal(size=(count, 4), chunks=(chunk, 4))


def row(name: str, count: int, client: Any, call: Callable[[], object]) -> None:
    """Print processor time for each body, wall-clock time and memory of one way."""
    used = client.run if client else lambda function: {"here": function()}
    before, start = used(_used), time.perf_counter()
    call()
    wall, after = time.perf_counter() - start, used(_used)
    cost = sum(after[k][0] - before[k][0] for k in before) / count * 1e6
    memory = max(peak for _, peak in after.values())
    print(f"{name:44} {cost:10.2f} {wall:8.1f} {memory:8.0f}", flush=True)


def _warm() -> None:
    """Load the engine, so that no row contains that."""
    rigidsym.propagate((1, 2, 2.5), (1, 2, 3), (0.0,))
    rigidsym.step((1, 2, 2.5), (1, 0, 0, 0), (1, 2, 3), 0.1)


def _used() -> tuple[float, float]:
    """Return the processor time of a process, s, and its largest memory, MB."""
    scale = 1 if sys.platform == "darwin" else 1024
    return time.process_time(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * scale / _MB


if __name__ == "__main__":
    main()
