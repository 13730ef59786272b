"""Special functions for SymPy that it lacks: Jacobi's, Legendre's Pi over them, and thetas."""

from rigidsym.language.functions.jacobi import (
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_epsilon,
    jacobi_sn,
)
from rigidsym.language.functions.thetas import theta_im, theta_re
from rigidsym.language.functions.third_kind import jacobi_pi

__all__ = [
    "jacobi_am",
    "jacobi_cn",
    "jacobi_dn",
    "jacobi_epsilon",
    "jacobi_pi",
    "jacobi_sn",
    "theta_im",
    "theta_re",
]
