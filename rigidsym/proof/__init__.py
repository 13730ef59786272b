"""What is true: the kernel, what derivations are written with, the second checker, the paper."""
