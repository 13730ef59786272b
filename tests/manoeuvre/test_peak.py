"""The largest rate on the way, against many samples."""

import numpy as np
import pytest
from random_manoeuvres import BODIES, TARGETS, manoeuvre

from rigidsym.manoeuvre import plan, solve


@pytest.mark.parametrize("index", range(len(BODIES) * len(TARGETS)))
def test_no_sample_is_faster_and_one_is_as_fast(index):
    for one in solve(manoeuvre(index, 31), 4).transfers:
        omega = one.motion(np.linspace(0, one.duration, 4001))[1]
        sampled = np.linalg.norm(omega, axis=1).max()
        assert sampled <= one.peak_rate * (1 + 1e-12)
        assert sampled == pytest.approx(one.peak_rate, rel=1e-4)


@pytest.mark.parametrize("size", [1e-6, 1e-12, 1e-15])
def test_it_is_no_less_than_at_the_start(size):
    best = plan((1, 2, 2.5), (1, 0, 0, 0), (1, size, 0, -size), 10).best
    assert best.peak_rate >= np.linalg.norm(best.omega0) * (1 - 1e-12) > 0
