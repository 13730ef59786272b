"""Representations of values in notebooks: cards of HTML, formulas in LaTeX.

Most values show themselves by these functions.
"""
