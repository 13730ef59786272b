"""The C target: one header and one source, C99 and libm alone."""
