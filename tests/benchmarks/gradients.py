"""Time of gradients in JAX and PyTorch over `propagate(sensitivity=True)`.

    python tests/benchmarks/gradients.py [ROUNDS]
    python tests/benchmarks/gradients.py --quick        one round, goals not judged

Many bodies at some times: the gradient of a sum over all states, by all inputs and by the rates at
the start.  What is compared takes turns; times are of the processor, of all threads, and ratios are
of their medians.  Needs the extras `jax` and `torch`; rows of the one that is missing are left out.
"""

import sys
from collections.abc import Callable
from importlib.util import find_spec
from statistics import median
from time import process_time

import bench
import numpy as np

import rigidsym

# Bodies and times: 10^4 bodies at one time and at ten, and fewer bodies at many times.
SIZES = (10_000, 1), (10_000, 10), (500, 200)
# Of `propagate(sensitivity=True)`: what a gradient by 10^4 bodies may take.  At many times it takes
# more: the derivatives of all states are in memory, which `propagate` has from its last call.
GOAL, JUDGED = 2.0, 10_000
INPUTS = {"all inputs": (0, 1, 2, 3), "omega0": (1,)}
COLUMNS = {"all inputs": None, "omega0": ["omega0"]}
Work = Callable[[], object]


def main() -> int:
    """Print every ratio; return 1 where a goal is missed."""
    asked, met = bench.options(__doc__, 15), True
    for bodies, times in SIZES[:1] if asked.quick else SIZES:
        given, weights = _drawn(bodies, times)
        for name, numbers in INPUTS.items():
            works = {"sensitivity=True": _in_numpy(given, COLUMNS[name])}
            if find_spec("jax"):
                works["JAX"] = _in_jax(given, weights, numbers)
            if find_spec("torch"):
                works["PyTorch"] = _in_torch(given, weights, numbers)
            found = medians(works, asked.rounds)
            own = found.pop("sensitivity=True")
            said = f"{bodies} bodies, {times} times, {name}: {1e3 * own:.1f} ms"
            for library, time in found.items():
                missed = "" if time <= GOAL * own or bodies < JUDGED else f", goal {GOAL:g} MISSED"
                met &= not missed
                said += f"; {library} {time / own:.2f} times that{missed}"
            print(said)
    return int(not (met or asked.quick))


def _drawn(bodies: int, times: int) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    random = np.random.default_rng(1)
    inertia = np.array([1.0, 2.0, 2.5]) * random.uniform(0.9, 1.1, (bodies, 1))
    omega0, attitude0 = random.normal(size=(bodies, 3)), random.normal(size=(bodies, 4))
    given = inertia, omega0, np.linspace(0.1, 10.0, times), attitude0
    return given, random.normal(size=(bodies, times, 7))


def _in_numpy(given: tuple[np.ndarray, ...], columns: list[str] | None) -> Work:
    options = {"engine": "c", "sensitivity": True, "columns": columns}
    return lambda: rigidsym.propagate(*given, **options)


def _in_jax(given: tuple[np.ndarray, ...], weights: np.ndarray, numbers: tuple[int, ...]) -> Work:
    import jax

    jax.config.update("jax_enable_x64", True)

    def loss(*given):
        q, omega = rigidsym.jax.propagate(*given)
        return (q * weights[..., :4]).sum() + (omega * weights[..., 4:]).sum()

    gradient, arrays = jax.jit(jax.grad(loss, numbers)), [jax.numpy.asarray(x) for x in given]
    return lambda: jax.block_until_ready(gradient(*arrays))


def _in_torch(given: tuple[np.ndarray, ...], weights: np.ndarray, numbers: tuple[int, ...]) -> Work:
    import torch

    # Waiting threads of PyTorch would count as processor time.
    torch.set_num_threads(1)
    tensors = [torch.tensor(x, requires_grad=k in numbers) for k, x in enumerate(given)]
    by, factors = [tensors[k] for k in numbers], torch.tensor(weights)

    def work():
        q, omega = rigidsym.torch.propagate(*tensors)
        loss = (q * factors[..., :4]).sum() + (omega * factors[..., 4:]).sum()
        return torch.autograd.grad(loss, by)

    return work


def medians(works: dict[str, Work], rounds: int) -> dict[str, float]:
    """Return the median processor time of each work, s; they take turns, after one run each."""
    found: dict[str, list[float]] = {name: [] for name in works}
    for work in works.values():
        work()
    for _ in range(rounds):
        for name, work in works.items():
            begin = process_time()
            work()
            found[name].append(process_time() - begin)
    return {name: median(times) for name, times in found.items()}


if __name__ == "__main__":
    sys.exit(main())
