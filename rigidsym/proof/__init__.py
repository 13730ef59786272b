"""Proofs: kernel, derivation steps, second checker, Coq export and verdicts on the paper."""

from rigidsym._lazy import lazily

__getattr__, __dir__ = lazily(__name__, {})
