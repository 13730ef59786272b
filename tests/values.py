"""Values of single expressions."""

from functools import cache

from rigidsym.language._sequence import FormulaSequence


@cache
def _compiled(expression):
    return FormulaSequence([("value", expression)])


def value_of(expression, values, functions=()):
    """Return the value of an expression over any numbers; functions include powers."""
    known = {"power": pow, **dict(functions)}
    return _compiled(expression).evaluate(values, known)["value"]
