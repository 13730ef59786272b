"""The proof half: the kernel, derivation steps, a second checker, Coq export and verdicts."""
