"""The language that both wings speak: expressions as trees, their text, values and LaTeX."""
