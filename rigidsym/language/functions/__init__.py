"""Special functions that SymPy lacks, such as Jacobi's elliptic functions.

Legendre's Pi of Jacobi's argument and theta functions are the others.
"""

from rigidsym.language.functions import _jacobi as jacobi
from rigidsym.language.functions import _thetas as thetas
from rigidsym.language.functions import _third_kind as third_kind
from rigidsym.language.functions._jacobi import (
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_epsilon,
    jacobi_sn,
)
from rigidsym.language.functions._thetas import theta_im, theta_re
from rigidsym.language.functions._third_kind import jacobi_pi

__all__ = [
    "MPMATH",
    "NUMPY",
    "jacobi_am",
    "jacobi_cn",
    "jacobi_dn",
    "jacobi_epsilon",
    "jacobi_pi",
    "jacobi_sn",
    "theta_im",
    "theta_re",
]

NUMPY = {**jacobi.NUMPY, **third_kind.NUMPY, **thetas.NUMPY}
"""All implementations over NumPy arrays by name; `lambdify` finds them by itself."""

MPMATH = {**jacobi.MPMATH, **third_kind.MPMATH, **thetas.MPMATH}
"""All implementations over mpmath numbers."""
