"""What derivations are written with: su(2), quaternions, and the differential rings of the
rigid body, trigonometric and Jacobi functions.  Every claim ends in the kernel."""

from rigidsym.proof.algebra.book import Book, equal, text
from rigidsym.proof.algebra.parts import (
    Part,
    circle,
    double_angle,
    extend,
    half_angle,
    jacobi,
    join,
    part_of,
    sign,
)

__all__ = [
    "Book",
    "Part",
    "circle",
    "double_angle",
    "equal",
    "extend",
    "half_angle",
    "jacobi",
    "join",
    "part_of",
    "sign",
    "text",
]
