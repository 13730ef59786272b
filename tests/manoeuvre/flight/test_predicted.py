"""The predicted miss in words: what a first burst that is wrong leads to."""

from math import radians

import numpy as np

from rigidsym.manoeuvre import plan
from rigidsym.manoeuvre.flight.run import predicted


def test_the_prediction_says_both_in_degrees():
    _, told = predicted(radians(2.5), 0.75)
    assert told == "2.500 deg by 1 % of the burst, 0.750 deg by 1 deg of its direction"


def test_a_spin_about_its_axis_misses_by_what_it_turns_too_far():
    best = plan((1, 2, 3), (1, 0, 0, 0), (np.cos(0.5), 0, 0, np.sin(0.5)), 10).best
    name, told = predicted(best.sensitivity.size, best.sensitivity.direction)
    assert name == "the same predicted, uncorrected"
    assert told.startswith(f"{np.degrees(0.01):.3f} deg by 1 %")
