"""Test of the arithmetic by the program that uses it."""


@public
def self_test() -> bool:
    """Return True if this build's sums, products, quotients and roots are rounded as they must be.

    Options of compilers and directed rounding spoil them.  Call it once before any other function,
    and whenever the processor's rounding may have changed.
    """
    sums: bool = sums_hold()
    quotients: bool = quotients_hold()
    return sums and quotients
