"""Expression trees, which proofs and numerical code share, with evaluation and printing."""
