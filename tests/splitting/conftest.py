"""A body under a torque, shared by all tests of splittings."""

import pytest
from pushed_bodies import Pushed, gradient

from rigidsym.splitting import Potential


@pytest.fixture(scope="session")
def pushed():
    start = (2.0, 3.0, 4.0), (1.0, 0.0, 0.0, 0.0), (0.5, 0.3, -0.2)
    return Pushed(*start, Potential(gradient), (1.0, 2.5, 5.0))


@pytest.fixture(scope="session")
def reference(pushed):
    return pushed.reference()
