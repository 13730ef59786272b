"""Skip of the tests that need CasADi if it is not installed; these import this module first."""

import pytest

pytest.importorskip("casadi", reason="needs casadi (extra optimal)")
