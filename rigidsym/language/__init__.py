"""Expression trees, shared by proofs and numerical code.

They can be parsed, evaluated and printed as text or LaTeX.
"""
