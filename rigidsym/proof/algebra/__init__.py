"""What derivations are written with: su(2), quaternions, and the differential rings of the
rigid body, trigonometric and Jacobi functions.  Every claim ends in the kernel."""

from rigidsym.proof.algebra.book import Book, equal, names, text
from rigidsym.proof.algebra.parts import Part, extend, half_angle, jacobi, join, sign

__all__ = [
    "Book",
    "Part",
    "equal",
    "extend",
    "half_angle",
    "jacobi",
    "join",
    "names",
    "sign",
    "text",
]
