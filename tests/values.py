"""Values of single expressions."""

from rigidsym.language._sequence import FormulaSequence


def value_of(expression, values, functions=()):
    """Of an expression, over any numbers."""
    known = {"power": pow, **dict(functions)}
    return FormulaSequence([("value", expression)]).evaluate(values, known)["value"]
