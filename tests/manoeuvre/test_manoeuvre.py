"""Tests of the numbers of a manoeuvre as users give them; the first bad one is named in a line."""

from fractions import Fraction

import numpy as np
import pytest

from rigidsym.errors import InputError
from rigidsym.manoeuvre._manoeuvre import Limits, manoeuvre, parse

GIVEN = {
    "inertia": ["0.0109", "0.04", "0.0506"],
    "start": [1, 0, 0, 0],
    "target": [0.9, "1/10", "-0.2", 0.3],
    "duration": "12.5",
}
MISSING = object()
REFUSED = [
    ({"duration": 0}, "duration = 0: must be above zero"),
    ({"duration": -1}, "duration = -1: must be above zero"),
    ({"duration": float("nan")}, "duration = nan: must be finite"),
    ({"duration": True}, "duration = True: must be a number"),
    ({"duration": [1]}, r"duration = \[1\]: must be a number"),
    ({"duration": "1e-400"}, r"duration = \[1E-400\]: must be from 1e-60 to 1e60"),
    ({"duration": "1e400"}, r"duration = \[1.0*E\+400\]: must be from 1e-60 to 1e60"),
    ({"duration": MISSING}, "duration = missing: give one, or a limit"),
    ({"inertia": ["1e70", "1e70", "1e70"]}, r"inertia = .*: must be from 1e-60 to 1e60"),
    ({"inertia": [1, 1]}, "inertia = .*: must have 3 numbers, not 2"),
    ({"inertia": [1, 1, 3]}, "inertia = .*: no body has a principal moment larger"),
    ({"inertia": ["1 +/- 0.1", 1, 1]}, r"inertia\[0\] = 1 \+/- 0.1: is uncertain"),
    ({"start": [0, 0, 0, 0]}, "start = .*: must not be zero"),
    ({"target": [1, 0, 0]}, "target = .*: must have 4 numbers, not 3"),
    ({"target": [1, 0, 0, "x"]}, r"target\[3\] = 'x': must be a finite decimal number"),
    *(
        ({name: MISSING}, f"{name} = missing: a manoeuvre needs it")
        for name in ("inertia", "start", "target")
    ),
    ({"wheels": {}}, "manoeuvre = wheels: is not one of: "),
    ({"spin": 1}, "spin = 1: must be a table of start, target"),
    ({"spin": {"begin": [0, 0, 0]}}, "spin = begin: is not one of: start, target"),
    ({"spin": {"start": [0, 0]}}, "spin.start = .*: must have 3 numbers, not 2"),
    ({"spin": {"target": ["1e61", 0, 0]}}, "spin.target = .*: must not be beyond 1e60"),
    ({"limits": {"max_rate": 0}}, "max_rate = 0: must be above zero"),
    ({"limits": {"max_burst": "1e61"}}, "max_burst = .*: must be from 1e-60 to 1e60"),
    ({"limits": {"max_torque": 1}}, "limits = max_torque: is not one of: max_burst, max_rate"),
]


def test_numbers_mean_exactly_what_they_say():
    asked = parse(GIVEN | {"limits": {"max_rate": "0.1"}, "spin": {"start": [0, "1e-300", 0]}})
    assert asked.duration == Fraction(25, 2)
    assert asked.target == (Fraction(0.9), Fraction(1, 10), Fraction(-1, 5), Fraction(0.3))
    assert asked.start_spin == (0, Fraction(1, 10**300), 0)
    assert asked.limits == Limits(max_rate=Fraction(1, 10))


def test_the_data_of_a_manoeuvre_parse_to_the_same():
    asked = parse(GIVEN | {"limits": {"max_burst": 0.1}, "spin": {"target": [0.1, "1/3", 0]}})
    assert parse(asked.to_data()) == asked


@pytest.mark.parametrize(("changed", "message"), REFUSED)
def test_bad_numbers_are_refused_in_one_line(changed, message):
    given = {key: value for key, value in (GIVEN | changed).items() if value is not MISSING}
    with pytest.raises(InputError, match=f"^{message}") as caught:
        parse(given)
    assert "\n" not in str(caught.value)


def test_with_a_limit_no_duration_is_needed():
    assert manoeuvre([1, 1, 1], [1, 0, 0, 0], np.eye(4)[1], max_rate=1).duration is None
