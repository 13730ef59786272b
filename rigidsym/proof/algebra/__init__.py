"""Tools for writing derivations: ledger builder, parts of contexts, quaternions.

Every claim is decided by the kernel.
"""

from rigidsym.proof.algebra._builder import LedgerBuilder, equal, text
from rigidsym.proof.algebra._parts import (
    Part,
    circle,
    double_angle,
    extend,
    half_angle,
    jacobi,
    join,
    named,
    part_of,
    sign,
    unit_quaternion,
)
from rigidsym.proof.algebra._proofs import Proofs

__all__ = [
    "LedgerBuilder",
    "Part",
    "Proofs",
    "circle",
    "double_angle",
    "equal",
    "extend",
    "half_angle",
    "jacobi",
    "join",
    "named",
    "part_of",
    "sign",
    "text",
    "unit_quaternion",
]
