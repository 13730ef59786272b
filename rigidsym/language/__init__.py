"""Expressions shared by proofs and numbers: trees, their text, their values and LaTeX."""
