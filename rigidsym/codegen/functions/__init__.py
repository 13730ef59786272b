"""Which formulas, in which order, make the functions of a numeric module."""

from rigidsym.codegen.functions.assembly import constants, finished, functions, stated

__all__ = ["constants", "finished", "functions", "stated"]
