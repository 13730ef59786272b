"""How values look in a notebook: cards of HTML, formulas in LaTeX.

What is shown comes as plain data, or as values whose public attributes say it; most values show
themselves by what is here.
"""
