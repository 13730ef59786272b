"""C in single precision as a target: one body and one time after the other."""
