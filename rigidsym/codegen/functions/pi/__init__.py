"""The functions of the Pi form: psi by one integral of the third kind, and no theta function."""
