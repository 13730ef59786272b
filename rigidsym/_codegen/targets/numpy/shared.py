"""Hand-written runtime of all NumPy modules: errors, and choices among bodies.

Its text is printed into the generated modules, after the double-doubles.
"""

import math

import numpy as np

from rigidsym._codegen.targets.numpy.stubs import RULES

# --- runtime ---


class _RefusedError(ValueError):
    """Error for invalid input: the field, the rule, and the first body and time that break it.

    Bodies are counted through the leading axes.
    """

    def __init__(self, field, rule, body=None, time=None):
        super().__init__(field, rule, body, time)
        self.field, self.rule, self.body, self.time = self.args

    def __str__(self):
        return f"{self.field}: {self.rule}"


def _refuse(field, rule, good, refused=None, bodies=None):
    """Mark the bodies where `good` is False as refused, or raise an error for the first."""
    if good is not True:
        at = np.flatnonzero(np.logical_not(good))
        at = at if bodies is None else bodies[at]
        if refused is not None:
            refused[at] = True
        elif at.size:
            raise _RefusedError(field, rule, int(at[0]))


def _refuse_codes(codes, refused=None, bodies=None):
    """Refuse bodies by their codes, or raise an error for the first rule that one breaks."""
    for number in (codes,) if type(codes) is int else np.unique(codes).tolist():
        if number:
            _refuse(*RULES[number], codes != number, refused, bodies)


def _check_finite(columns, refused=None):
    """Refuse bodies with numbers that are not finite; columns by the name of the field."""
    for name, values in columns.items():
        _refuse(name, RULES[1][1], _are_finite(values), refused)


def _are_finite(columns):
    if isinstance(columns[0], np.ndarray):
        return np.all([np.isfinite(x) for x in np.broadcast_arrays(*columns)], axis=0)
    return all(map(math.isfinite, columns))
