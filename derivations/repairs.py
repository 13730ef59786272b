"""Repairs: every refuted line of the paper, mended by one small edit where one does it.

A sign, index, power, factor, divisor or derivative is changed in what the paper prints; the edits
that agree at rational points are decided by the kernel.  The ledger keeps the shortest repairs
that are proved.  (14) for Lemma 1 is not found: it takes two edits at once.
"""

from rigidsym.proof.algebra import Book
from rigidsym.proof.algebra.repairs import repairs

# Where each refuted fact holds what the paper prints: a side of it, or a definition.
PRINTED = {
    "printed_sine.over_inertia": "Omega_printed",
    "printed_sine.slope_over_inertia": "rhs",
    "printed_start.over_inertia": "rhs",
    "half_angle_step.everywhere": "y_star",
    "theorem1_printed.n": "n_printed",
    "amplitude.printed": "rhs",
    "theorem1_printed.modulus": "root_printed",
    "third_kind.left_side": "lhs",
}


def derive(book: Book) -> None:
    """Search, and list what is found."""
    book.ledger.published["repairs"] = [
        {"fact": fact, "lhs": lhs, "rhs": rhs}
        for fact, place in PRINTED.items()
        for lhs, rhs in repairs(book.ledger, fact, place)
    ]
