"""The proof wing: the kernel, tools for derivations, the second checker, Coq, the paper."""
