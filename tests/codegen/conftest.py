"""Fixtures that several tests of generated code share."""

import pytest
from compilers import written


@pytest.fixture(scope="session")
def here(once):
    """Return a folder of this run with all C sources, and with what is built of them."""
    return once("c_builds", written)
