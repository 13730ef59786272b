"""Functions of a numeric module, made of the solution's formulas."""

from rigidsym._codegen.functions.assembly import constants, finished, functions, stated

__all__ = ["constants", "finished", "functions", "stated"]
