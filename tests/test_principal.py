"""Principal axes reproduce the tensor, convert motions, and refuse bad tensors."""

import math
import pickle
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

from rigidsym import InputError, TorqueFreeMotion, principal_axes
from rigidsym.quaternions import conjugate, matrices, of_matrix, product, rotated

NUMBERS = st.floats(-1, 1)
ROTATIONS = (
    st.tuples(NUMBERS, NUMBERS, NUMBERS, NUMBERS)
    .filter(lambda q: math.hypot(*q) > 0.1)
    .map(lambda q: np.array(q) / math.hypot(*q))
)
# Bodies that can exist: moments are sums of two of three second moments of mass.
SPREADS = st.tuples(*[st.floats(1e-3, 1)] * 3).map(np.array)
SCALES = st.sampled_from([1e-300, 1e-9, 1.0, 1e12, 1e300])
SETTING = np.array([0.5, -0.5, 0.5, 0.5])


def matrix(q):
    return rotated(q, np.eye(3)).T


def tensor_of(moments, q):
    full = matrix(q) @ np.diag(moments) @ matrix(q).T
    return (full + full.T) / 2


@given(SPREADS, ROTATIONS, SCALES)
def test_moments_and_axes_give_the_tensor_again(spread, q, scale):
    moments = np.sum(spread) - spread
    tensor = tensor_of(moments, q) * scale
    found = principal_axes(tensor)
    assert np.all(np.diff(found.moments) >= 0)
    assert np.allclose(found.moments / scale, np.sort(moments), rtol=0, atol=1e-14)
    again = found.matrix @ np.diag(found.moments / scale) @ found.matrix.T
    assert np.allclose(again, tensor / scale, rtol=0, atol=1e-14)
    assert np.allclose(found.matrix.T @ found.matrix, np.eye(3), rtol=0, atol=1e-14)
    assert np.linalg.det(found.matrix) == pytest.approx(1)
    assert np.allclose(matrix(found.quaternion), found.matrix, rtol=0, atol=1e-14)
    assert found.quaternion[0] >= 0


@given(SPREADS, ROTATIONS, ROTATIONS, st.tuples(NUMBERS, NUMBERS, NUMBERS))
def test_what_is_turned_there_comes_back(spread, q, attitude, rates):
    body = principal_axes(tensor_of(np.sum(spread) - spread, q))
    omega0, attitude0 = body.to_principal(rates, attitude)
    back = body.from_principal(attitude0, omega0)
    assert np.allclose(back[0], attitude, rtol=0, atol=1e-14)
    assert np.allclose(back[1], rates, rtol=0, atol=1e-14)
    # The momentum in space is the same by either axes.
    there = rotated(attitude0, body.moments * omega0)
    here = rotated(attitude, tensor_of(np.sum(spread) - spread, q) @ np.array(rates))
    assert np.allclose(there, here, rtol=0, atol=1e-13)


def test_a_motion_keeps_its_momentum_in_the_given_axes():
    tensor = tensor_of((0.0109, 0.04, 0.0506), np.array([0.1, -0.7, 0.5, 0.5]))
    body, rates = principal_axes(tensor), np.array([0.03, -0.02, 0.05])
    motion = TorqueFreeMotion(body.moments, *body.to_principal(rates, SETTING))
    q, omega = body.from_principal(*motion(np.linspace(0, 600, 50)))
    assert (q.shape, omega.shape) == ((50, 4), (50, 3))
    assert np.allclose(q[0], SETTING, rtol=0, atol=1e-15)
    assert np.allclose(omega[0], rates, rtol=0, atol=1e-16)
    momentum = rotated(q, omega @ tensor)
    assert np.ptp(momentum, axis=0).max() < 1e-16
    assert np.einsum("ni,ij,nj->n", omega, tensor, omega) == pytest.approx(rates @ tensor @ rates)


@given(st.permutations([0.1, 0.3, 0.35]))
def test_diagonal_tensors_are_put_in_order_exactly(moments):
    found = principal_axes(np.diag(moments))
    assert found.moments.tolist() == [0.1, 0.3, 0.35]
    assert {*np.abs(found.matrix).ravel().tolist()} == {0.0, 1.0}
    assert np.linalg.det(found.matrix) == 1
    if moments == [0.1, 0.3, 0.35]:
        assert found.quaternion.tolist() == [1, 0, 0, 0]


def test_equal_moments_have_any_axes():
    assert principal_axes(np.eye(3)).matrix.tolist() == np.eye(3).tolist()
    found = principal_axes(tensor_of((1, 1, 1.5), SETTING))
    assert np.allclose(found.moments, (1, 1, 1.5), rtol=1e-15)
    assert np.allclose(found.matrix.T @ found.matrix, np.eye(3), rtol=0, atol=1e-15)


def test_numbers_of_any_kind():
    found = principal_axes([["0.5", 0, Fraction(0)], [0, "1/2", 0], [0, 0, np.float32(0.5)]])
    assert found.moments.tolist() == [0.5, 0.5, 0.5]


def test_what_is_nearly_symmetric_is_made_so():
    tensor = np.array([[2, 0.1, 0], [0.1 + 1e-9, 3, 0], [0, 0, 4]])
    assert principal_axes(tensor).moments.tolist() == principal_axes(tensor.T).moments.tolist()


@pytest.mark.parametrize(
    ("tensor", "line"),
    [
        ([[1, 0.1, 0], [0, 1, 0], [0, 0, 1]],
         "tensor[0][1] = 0.1: but tensor[1][0] = 0: an inertia tensor is symmetric"),
        ([[1, 0, 0], [0, 1, 0], [0, 0, 0]], "tensor = one of principal moments [0, 1, 1]: pr"),
        ([[1, 1, 0], [1, 1, 0], [0, 0, 1]], "tensor = one of principal moments [0, 1, 2]: "),
        ([[1, 2, 0], [2, 1, 0], [0, 0, 1]], "tensor = one of principal moments [-1, 1, 3]: "),
        (np.zeros((3, 3)), "tensor = one of principal moments [0, 0, 0]: "),
        ([[1, 0, 0], [0, math.nan, 0], [0, 0, 1]], "tensor[1][1] = nan: must be finite"),
        ([[1, 0, 0], [0, 1, 0], [0, 0, math.inf]], "tensor[2][2] = inf: must be finite"),
        ([[1, 0, 0], [0, "x", 0], [0, 0, 1]], "tensor[1][1] = 'x': must be"),
        ([[1, 0, 0], [0, 1j, 0], [0, 0, 1]], "tensor[1][1] = 1j: must be a number"),
        (["1 +/- 0.1", 0, 0], "tensor[0] = '1 +/- 0.1': must be a list of numbers"),
        ([["1 +/- 0.1", 0, 0], [0, 1, 0], [0, 0, 1]], "tensor[0][0] = 1 +/- 0.1: is uncertain"),
        ([["1 +/- 0.1", 0, 0], [0, 1], [0, 0, 1]], "tensor[0][0] = 1 +/- 0.1: is uncertain"),
        ([["1e999", 0, 0], [0, 1, 0], [0, 0, 1]], "tensor[0] = [1.00000000000E+999, 0, 0]: "),
        (np.eye(2), "tensor = 2 rows: must have 3 rows of 3 numbers"),
        (np.ones((3, 4)), "tensor[0] = [1. 1. 1. 1.]: must have 3 numbers, not 4"),
        ((1, 2, 3), "tensor[0] = 1: must be a list of numbers"),
        (2.0, "tensor = 2.0: must be a list of numbers"),
        (None, "tensor = None: must be a list of numbers"),
        ("abc", "tensor = 'abc': must be a list of numbers"),
    ],
)  # fmt: skip
def test_tensors_that_are_none(tensor, line):
    with pytest.raises(InputError) as caught:
        principal_axes(tensor)
    assert str(caught.value).startswith(line)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (([1, 2], [1, 0, 0, 0]), "omega = shape (2,): must be (..., 3)"),
        (([1, 2, 3], 1), "attitude = shape (): must be (..., 4)"),
        ((["x", 2, 3], [1, 0, 0, 0]), "omega = ['x', 2, 3]: must be numbers"),
    ],
)
def test_states_that_are_none(arguments, line):
    with pytest.raises(InputError) as caught:
        principal_axes(np.eye(3)).to_principal(*arguments)
    assert str(caught.value) == line


@given(ROTATIONS, ROTATIONS)
def test_products_of_quaternions_are_products_of_matrices(p, q):
    assert np.allclose(matrix(product(p, q)), matrix(p) @ matrix(q), rtol=0, atol=1e-14)
    assert np.allclose(product(q, conjugate(q)), [1, 0, 0, 0], rtol=0, atol=1e-15)
    found = of_matrix(matrix(q))
    assert min(np.abs(found - q).max(), np.abs(found + q).max()) < 1e-14


ENTRIES = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
TENSOR = np.array([[2.0, 0.1, -0.2], [0.1, 3.0, 0.3], [-0.2, 0.3, 4.0]])
RATES, ATTITUDE = np.array([0.1, 0.7, -0.3]), np.array([2.0, -1.0, 3.0, 1.0])


def along_given_axes(tensor, rates, t):
    """Return the attitude, rates and sensitivity of a motion along the given axes."""
    axes = principal_axes(tensor)
    motion = TorqueFreeMotion(axes.moments, *axes.to_principal(rates, ATTITUDE))
    q, omega, found = motion.sensitivity(t)
    return *axes.from_principal(q, omega), axes.sensitivity(motion(0.0), q, omega, found)


def test_sensitivities_by_the_tensor_are_those_of_differences():
    t, step = 7.0, 1e-6
    _, _, found = along_given_axes(TENSOR, RATES, np.array([t]))
    q, _, one = along_given_axes(TENSOR, RATES, t)
    assert np.array_equal(found.attitude[0], one.attitude)
    assert np.array_equal(found.rates[0], one.rates)
    for k in range(9):
        ends = []
        for change in (step, -step):
            rates, tensor = RATES.copy(), TENSOR.copy()
            if k < 3:
                rates[k] += change
            else:
                i, j = ENTRIES[k - 3]
                tensor[i, j] = tensor[j, i] = TENSOR[i, j] + change
            ends.append(along_given_axes(tensor, rates, t)[:2])
        (before, slower), (after, faster) = ends[1], ends[0]
        turned = 2 * product(after - before, conjugate(q))[1:] / (2 * step)
        assert np.allclose(one.attitude[:, 3 + k], turned, atol=1e-8)
        assert np.allclose(one.rates[:, 3 + k], (faster - slower) / (2 * step), atol=1e-8)


def test_a_small_turn_at_first_stays_one():
    _, _, found = along_given_axes(TENSOR, RATES, 7.0)
    assert np.allclose(found.attitude[:, :3], np.eye(3), atol=1e-15)
    assert not found.rates[:, :3].any()


def test_equal_moments_have_no_derivative_by_the_tensor():
    with pytest.raises(InputError, match="two are equal: their axes are any in a plane"):
        along_given_axes(np.diag([2.0, 2.0, 3.0]), RATES, 1.0)


TENSOR = np.array([[2.0, 0.3, 0.1], [0.3, 3.0, -0.2], [0.1, -0.2, 4.0]])
TURNING, LEANING = (0.1, 0.2, 0.3), (-0.5, 0.5, 0.1, 0.3)


def by_mpmath(times):
    """Rotation matrices and rates of TENSOR's motion, from eigenvectors with 50 digits."""

    def matrix(q):
        w, x, y, z = (mp.mpf(c) for c in q)
        rows = (
            (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        )
        return mp.matrix(rows)

    moments, axes = mp.eigsy(mp.matrix(TENSOR.tolist()))
    axes[:, 2] *= mp.sign(mp.det(axes))
    rates = axes.T * mp.matrix([mp.mpf(x) for x in TURNING])
    length = mp.sqrt(sum(mp.mpf(x) ** 2 for x in LEANING))
    start = matrix([mp.mpf(x) / length for x in LEANING])
    states = zip(*TorqueFreeMotion([*moments], [*rates]).precise(times, 40), strict=True)
    return [(start * axes * matrix(q) * axes.T, axes * mp.matrix([*w])) for q, w in states]


def test_states_of_a_tensor_are_those_of_its_exact_eigenvectors():
    """The error that the class documents: it grows with the angle, up to 37 000 rad."""
    motion = TorqueFreeMotion.from_tensor(TENSOR, TURNING, LEANING)
    times = [0.0, 1.0, 100.0, 1e5]
    with mp.workdps(50):
        expected = by_mpmath(times)
        for t, q, omega, (turned, rates) in zip(times, *motion(times), expected, strict=True):
            bound = 1e-15 + 3e-16 * t * np.linalg.norm(TURNING)
            assert mp.mnorm(mp.matrix(matrices(q).tolist()) - turned) < 2 * bound
            assert mp.norm(mp.matrix(omega.tolist()) - rates) < bound
    np.testing.assert_allclose(
        motion(0.0)[0], np.array(LEANING) / np.linalg.norm(LEANING), atol=4e-16
    )


def test_a_motion_of_a_tensor_has_everything_in_its_axes():
    motion = TorqueFreeMotion.from_tensor(TENSOR, TURNING, LEANING)
    t = np.array([0.0, 2.0, 4.0])
    q, omega = motion(t)
    for x, y in zip(motion.grid(0, 2, 3), (q, omega), strict=True):
        np.testing.assert_allclose(x, y, atol=4e-15)
    there, _, found = motion.sensitivity(t)
    np.testing.assert_array_equal(there, q)
    assert found.attitude.shape == (3, 3, 12)
    transition = motion.state_transition(0.0, t)
    np.testing.assert_allclose(transition, found.transition, atol=1e-13)
    later = TorqueFreeMotion.from_tensor(TENSOR, omega[1] + [0, 1e-6, 0], q[1])(2.0)
    np.testing.assert_allclose(
        (later[1] - omega[2]) / 1e-6, motion.state_transition(2, 4)[3:, 4], atol=1e-5
    )
    assert motion.energy == pytest.approx(np.array(TURNING) @ TENSOR @ TURNING / 2, rel=1e-15)
    momentum = matrices(q) @ (TENSOR @ omega[..., None])
    np.testing.assert_allclose(momentum[1:], momentum[:1].repeat(2, axis=0), atol=3e-15)
    steps = np.linspace(0, motion.period, 2001)[:-1]
    np.testing.assert_allclose(motion(steps)[1].mean(axis=0), motion.mean_rates, atol=1e-14)
    assert motion.regime is motion.principal.regime
    assert "axes of its tensor" in repr(motion)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(motion))(t)[0], q)
    for name in ("precise", "enclose", "symbolic", "inertia", "plot", "replace"):
        with pytest.raises(
            AttributeError, match=rf"^{name}: is along the principal axes only: motion"
        ):
            getattr(motion, name)
    with pytest.raises(AttributeError, match="has no attribute 'precises'"):
        _ = motion.precises


def test_a_diagonal_tensor_is_taken_exactly():
    motion = TorqueFreeMotion.from_tensor(np.diag([4, 2, 3]), TURNING, LEANING)
    plain = TorqueFreeMotion((4, 2, 3), TURNING, LEANING)
    assert motion.regime is plain.regime
    assert sorted(motion.principal.inertia) == [2, 3, 4]
    for x, y in zip(motion([1.0, 1e6]), plain([1.0, 1e6]), strict=True):
        np.testing.assert_allclose(x, y, atol=4e-15)
    sphere = TorqueFreeMotion.from_tensor(np.eye(3), TURNING)
    np.testing.assert_array_equal(sphere(9.0)[1], TURNING)
    with pytest.raises(InputError, match="two are equal"):
        sphere.sensitivity(1.0)


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"tensor": (1, 2, 3)}, "tensor"),
        ({"tensor": np.diag([1, 1, 5])}, r"inertia = \[1, 1, 5\]: no body"),
        ({"omega0": ("1 +/- 0.1", 2, 3)}, r"omega0\[0\] = .*is uncertain; a motion from a tensor"),
        ({"omega0": (1, 2)}, "omega0 = .*must have 3 numbers"),
        ({"attitude0": (0, 0, 0, 0)}, "attitude0 = .*must not be zero"),
        ({"engine": "x"}, "engine = 'x'"),
        ({"degrees": 1}, "degrees = 1"),
    ],
)
def test_tensors_and_states_that_are_refused(changed, rule):
    with pytest.raises(InputError, match=f"^{rule}"):
        TorqueFreeMotion.from_tensor(**{"tensor": TENSOR, "omega0": TURNING, **changed})


def test_degrees_and_lengths_of_a_tensors_motion():
    motion = TorqueFreeMotion.from_tensor(TENSOR, TURNING, LEANING)
    other = TorqueFreeMotion.from_tensor(
        TENSOR, np.rad2deg(TURNING), np.multiply(LEANING, 1e308), degrees=True
    )
    np.testing.assert_allclose(other(5.0)[0], motion(5.0)[0], atol=4e-16)
