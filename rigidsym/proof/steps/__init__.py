"""Forward steps of a derivation: SymPy finds what comes next, the kernel decides that it does.

A `Desk` is a context to work in.  Its steps take SymPy expressions and matrices and return a
`Step`: what was found, as an expression, a matrix or a mapping of solutions; what was done to what;
what was divided by; and the fact that the kernel admitted for it.

    multiply      a product of named matrices, multiplied out
    coordinates   a matrix as a combination of named ones
    vary          the equations of motion from a Lagrangian (Euler and Poincare)
    solve         linear equations, with what they leave free
    roots         all roots of a polynomial
    eliminate     quantities by equations that hold
    differentiate by the rates of the context
    apart         partial fractions
    integrate     by a table of derivatives
    match         an ansatz, by its coefficients
    nonnegative   by a form that shows it
    rewrite       in a form that reads better: the kernel alone decides

SymPy is never trusted: a wrong value is refused by `Ledger.add`, and a step that SymPy cannot do
raises `StepError`, in one line that names the step.
"""

from rigidsym.proof.steps.algebra import coordinates, determinant, multiply
from rigidsym.proof.steps.calculus import (
    apart,
    coefficients,
    differentiate,
    eliminate,
    integrate,
    match,
    nonnegative,
    rate_of,
    rewrite,
    roots,
)
from rigidsym.proof.steps.desk import Desk
from rigidsym.proof.steps.linear import solve, solve_family
from rigidsym.proof.steps.matrices import Rate, matrix
from rigidsym.proof.steps.record import Step, StepError
from rigidsym.proof.steps.variation import Variation, vary

__all__ = [
    "Desk",
    "Rate",
    "Step",
    "StepError",
    "Variation",
    "apart",
    "coefficients",
    "coordinates",
    "determinant",
    "differentiate",
    "eliminate",
    "integrate",
    "match",
    "matrix",
    "multiply",
    "nonnegative",
    "rate_of",
    "rewrite",
    "roots",
    "solve",
    "solve_family",
    "vary",
]
