"""Derivation steps: SymPy finds the next expression, and the kernel checks it.

A `Scope` is a context as SymPy sees it.  A step takes it with SymPy expressions or matrices, and
returns a `Step`: the value found, as an expression, a matrix or a mapping of solutions; the
equations of the line; the divisors that must not vanish; and the fact that the kernel admitted.

    multiply      a product of named matrices, multiplied out
    coordinates   a matrix as a combination of named ones
    vary          the equations of motion from a Lagrangian (Euler and Poincare)
    solve         linear equations, with the unknowns they leave free
    roots         all roots of a polynomial
    eliminate     quantities by equations that hold
    differentiate by the rates of the context
    apart         partial fractions
    integrate     by a table of derivatives
    match         an ansatz, by its coefficients
    nonnegative   by a form that shows it
    rewrite       in a form that is easier to read

SymPy is never trusted: a wrong value is refused by `Ledger.add`, and a step that SymPy cannot do
raises `StepError`, in one line that names the step.
"""

from rigidsym.proof.steps._algebra import coordinates, determinant, multiply
from rigidsym.proof.steps._calculus import (
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
from rigidsym.proof.steps._linear import solve, solve_family
from rigidsym.proof.steps._matrices import SIZE, Rate, matrix
from rigidsym.proof.steps._record import Step, StepError
from rigidsym.proof.steps._scope import Scope
from rigidsym.proof.steps._variation import Variation, vary

__all__ = [
    "SIZE",
    "Rate",
    "Scope",
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
