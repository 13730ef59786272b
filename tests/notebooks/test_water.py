"""A box of water in notebooks and benchmarks: its forces, and the NO_SQUISH step."""

import sys
from pathlib import Path

import numpy as np
import pytest

import rigidsym
from rigidsym.quaternions import conjugate, of_rotation_vectors, product, rotation_vectors

for package in ("IPython", "scipy"):
    pytest.importorskip(package, reason=f"{package} is not installed: extra `lab` or `dev`")
sys.path.append(str(Path(__file__).parents[2] / "notebooks"))
from support import water  # noqa: E402

BOX = water.Box(edge=3)
STATE = BOX.lattice(np.random.default_rng(1))


def test_forces_and_torques_are_the_slopes_of_the_energy():
    small, draw = 1e-6, np.random.default_rng(2)
    shift, turn = draw.normal(size=(2, BOX.count, 3))

    def energy(amount: float) -> float:
        moved = STATE.copy()
        moved.x = STATE.x + amount * shift
        moved.q = product(STATE.q, of_rotation_vectors(amount * turn))
        return BOX.forces(moved).energy

    slope = (energy(small) - energy(-small)) / (2 * small)
    found = BOX.forces(STATE)
    assert slope == pytest.approx(-np.sum(found.force * shift + found.torque * turn), rel=1e-7)
    assert np.abs(found.force.sum(axis=0)).max() < 1e-9


def test_what_ends_at_the_cut_off_ends_with_its_slope_and_its_force_s():
    near = 0.5 * (1 - np.array([0.0, 1e-3, 2e-3]))
    for power in (1, 6, 12):
        energy, over_r = water._shifted(power, near**2, 0.5)
        assert np.abs([energy[0], over_r[0]]).max() < 1e-9 * 0.5 ** -(power + 2)
        # A third power of what is left of the way, and its slope a second.
        assert energy[2] / energy[1] == pytest.approx(8, rel=0.1)
        assert over_r[2] / over_r[1] == pytest.approx(4, rel=0.1)


def test_no_squish_is_the_free_step_to_second_order():
    def apart(h: float) -> float:
        q, omega = STATE.q, STATE.omega
        for _ in range(round(0.016 / h)):
            q, omega = water.no_squish(water.INERTIA, q, omega, h)
        truth, _ = rigidsym.step(water.INERTIA, STATE.q, STATE.omega, 0.016)
        return float(np.max(np.abs(rotation_vectors(product(conjugate(truth), q)))))

    coarse, fine = apart(0.002), apart(0.001)
    assert 1e-7 < fine < 1e-3
    assert coarse / fine == pytest.approx(4, rel=0.1)
