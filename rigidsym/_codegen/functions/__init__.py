"""Construction of a numeric module's functions from the formulas of the solution."""

from rigidsym._codegen.functions.assembly import constants, finished, functions, stated

__all__ = ["constants", "finished", "functions", "stated"]
