"""Imported first by tests of what needs CasADi: without it they skip, and say so."""

import pytest

pytest.importorskip("casadi", reason="needs casadi (extra optimal)")
