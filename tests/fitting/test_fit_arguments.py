"""What a fit refuses, in one line each."""

import numpy as np
import pytest
from simulated import TUMBLING

import rigidsym
from rigidsym.errors import InputError
from rigidsym.fitting import Attitudes, Rates

T = np.arange(5.0)
Q, OMEGA = TUMBLING(T)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "observations = none: give attitudes, rates, vectors, models, or some of them"),
        ({"attitudes": Q, "sigma": 1}, "times = missing: attitudes given as an array need them"),
        ({"times": T, "attitudes": Q}, "sigma.attitudes = missing: a standard deviation or"),
        ({"times": T, "attitudes": Q, "rates": OMEGA, "sigma": 1}, "give one for each of: att"),
        ({"times": T[:2], "attitudes": Q[:2], "sigma": 1},
         "observations = 6 numbers: are fewer than the 8 parameters"),
        ({"times": T[:3], "attitudes": Q[:3], "sigma": 1, "inertia": "tensor"},
         "observations = 9 numbers: are fewer than the 11 parameters"),
        ({"times": [1.0], "attitudes": Q[:1], "sigma": 1},
         "times = 1.0: all observations are at one time, and show no motion"),
        ({"attitudes": Attitudes([2], Q[:1], 1), "rates": Rates([2], OMEGA[:1], 1)},
         "times = 2.0: all observations are at one time"),
        ({"times": T, "attitudes": Q, "sigma": {"attitude": 1}}, "sigma = attitude: is not one"),
        ({"times": T, "attitudes": Q, "sigma": 1, "inertia": "some"}, "inertia = 'some': must be"),
        ({"times": T, "attitudes": Q, "sigma": 1, "inertia": "known"}, "moments = missing"),
        ({"times": T, "attitudes": Q, "sigma": 1, "moments": [1, 1, 3]}, "inertia = [1, 1, 3]"),
        ({"times": T, "attitudes": Q, "sigma": 1, "loss": "cubic"}, "loss = 'cubic': must be one"),
        ({"times": T, "attitudes": Q, "sigma": 1, "starts": 0}, "starts = 0: must be a whole"),
        ({"times": T, "attitudes": Q, "sigma": 1, "fastest": -1}, "fastest = -1: must be above"),
        ({"times": T, "attitudes": Q, "sigma": 1, "delta_chi2": 0}, "delta_chi2 = 0: must be"),
        ({"times": T, "attitudes": Q, "sigma": 1, "engine": "x"}, "engine = 'x': must be one of"),
        ({"attitudes": Rates(T, OMEGA, 1)}, "attitudes = Rates: must be Attitudes"),
        ({"vectors": OMEGA, "times": T, "sigma": 1}, "vectors = ndarray: must be"),
        ({"times": T, "attitudes": Q, "sigma": {"attitudes": 1, "moments": 1}},
         "sigma.moments = given: is about moments that are given"),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(arguments, message):
    with pytest.raises(InputError) as error:
        rigidsym.fit(**arguments)
    assert message in str(error.value)
    assert "\n" not in str(error.value)
