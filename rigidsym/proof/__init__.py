"""Proofs: kernel, derivation steps, second checker, Coq export and verdicts on the paper."""
