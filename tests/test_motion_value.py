"""A motion is a value: it never changes, equals others of the same numbers, and travels."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion

BODY, RATES = ("0.0109", "0.04", "0.0506"), (0.05, 0.03, -0.02)


@pytest.mark.parametrize(
    "name", ["inertia", "omega0", "attitude0", "engine", "anything", "_prepared"]
)
def test_nothing_of_a_motion_changes(name):
    motion = TorqueFreeMotion(BODY, RATES)
    before = repr(motion), motion(1.0)[0].tolist()
    rule = rf"^{name}: a motion does not change; motion.replace gives another$"
    with pytest.raises(AttributeError, match=rule):
        setattr(motion, name, (1, 2, 3))
    with pytest.raises(AttributeError, match=rule):
        delattr(motion, name)
    assert (repr(motion), motion(1.0)[0].tolist()) == before


def test_what_it_was_made_from_may_change():
    given = [np.array(x, float) for x in (BODY, RATES, (1, 0, 0, 0))]
    motion = TorqueFreeMotion(*given)
    for array in given:
        array[:] = 99
    assert motion(0.0)[1].tolist() == list(RATES)
    motion(0.0)[1][:] = 7
    motion([0.0])[0][:] = 7
    assert motion(0.0)[1].tolist() == list(RATES)
    assert motion(0.0)[0].tolist() == [1, 0, 0, 0]


def test_equal_numbers_are_equal_motions():
    motion = TorqueFreeMotion(BODY, RATES)
    same = TorqueFreeMotion([Fraction(x) for x in BODY], np.array(RATES))
    motion(1.0)
    assert motion == same
    assert hash(motion) == hash(same)
    assert {motion: 1}[same] == 1
    others = [
        TorqueFreeMotion([float(x) for x in BODY], RATES),
        motion.replace(omega0=(0.05, 0.03, 0.02)),
        motion.replace(attitude0=(1, 0, 0, 1)),
        motion.replace(engine="c"),
    ]
    assert len({motion, *others}) == 5
    assert motion != (BODY, RATES)


def test_replace_keeps_the_rest():
    motion = TorqueFreeMotion((1, 1, 5), RATES, (1, 2, 3, 4), allow_nonphysical=True, engine="c")
    other = motion.replace(omega0=("0.1", 0, 0))
    assert other.engine == "c"
    assert other.inertia == motion.inertia
    assert other.attitude0 == motion.attitude0
    assert other.omega0 == (Fraction(1, 10), 0, 0)
    with pytest.raises(InputError, match=r"^inertia = .*larger than the sum"):
        motion.replace(allow_nonphysical=False)
    with pytest.raises(InputError, match=r"^omega0\[0\] = 'x'"):
        motion.replace(omega0=("x", 1, 2))
    with pytest.raises(TypeError, match="torque"):
        motion.replace(torque=1)


def test_copies_and_messages():
    motion = TorqueFreeMotion(BODY, ("0.05 +/- 1e-9", 0.03, -0.02)).replace(omega0=RATES)
    state = motion(1.0)[0]
    assert motion._prepared is motion._prepared
    assert copy.copy(motion) is copy.deepcopy([motion])[0] is motion
    again = pickle.loads(pickle.dumps(motion))
    assert again == motion
    assert again(1.0)[0].tolist() == state.tolist()
    uncertain = motion.replace(omega0=("0.05 +/- 1e-9", 0.03, -0.02))
    assert pickle.loads(pickle.dumps(uncertain)) == uncertain
    again = uncertain.replace(engine="c").replace(engine="numpy")
    assert again == uncertain
