"""What `numpy_runtime` finds around it in the generated module, for linters and type checkers."""

from typing import Any

RESULTS: tuple[str, ...] = ()


def _excess(c_a: Any, c_b: Any, c_d: Any, Omega_a: Any, Omega_d: Any) -> Any:
    raise NotImplementedError


def _plan(*values: Any) -> tuple[Any, ...]:
    raise NotImplementedError


def _state(t: Any, *values: Any) -> tuple[Any, ...]:
    raise NotImplementedError


def _steady(*values: Any) -> tuple[Any, ...]:
    raise NotImplementedError
