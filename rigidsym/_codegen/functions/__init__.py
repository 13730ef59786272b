"""Functions of a numeric module, made of the solution's formulas.

A docstring "State x" means that the lets returned set names to x.
"""

from rigidsym._codegen.functions.assembly import constants, finished, functions, stated

__all__ = ["constants", "finished", "functions", "stated"]
