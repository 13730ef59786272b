"""Evaluation of single expressions."""

from functools import cache

from rigidsym.language._sequence import FormulaSequence


@cache
def _compiled(expression):
    return FormulaSequence([("value", expression)])


def value_of(expression, values, functions=()):
    """Evaluate an expression over any kind of numbers; `functions` include powers."""
    known = {"power": pow, **dict(functions)}
    return _compiled(expression).evaluate(values, known)["value"]
