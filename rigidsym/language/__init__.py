"""Expression trees, shared by proofs and numerical code.

They can be parsed, evaluated and printed as text or LaTeX.
"""

from rigidsym._lazy import lazily

__getattr__, __dir__ = lazily(__name__, {})
