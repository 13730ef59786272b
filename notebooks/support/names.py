"""The names of the derivation: the paper's matrices, and its numbers in SymPy."""

from derivations.conjugacy import PHI, K
from derivations.euler_lax import MOMENTA, RATES
from derivations.lie_algebra import M, Omega, R, commutator
from rigidsym.proof.steps._names import read, symbol, symbols

__all__ = [
    "MOMENTA",
    "PHI",
    "RATES",
    "K",
    "M",
    "Omega",
    "R",
    "commutator",
    "read",
    "symbol",
    "symbols",
]
