"""Written records of the flight profile: deviations from rules, and branches without tests."""

# Rules of MISRA C:2012 that are required, each with the reason why the code deviates.
DEVIATIONS = {
    "21.15": (
        "`bits_of` and `from_bits` copy a double to a 64-bit number and back by memcpy.  C99 "
        "defines this for types of the same size; a union would break rule 19.2."
    ),
}
# Reasons why the unit tests do not reach branches, by a pattern of the line.
UNREACHED = {
    r"return \(x\.hi > y\.hi\)": "moments are doubles, whose low parts are zero",
    r"return \(most\.hi < total\.hi\)": "moments are doubles, whose low parts are zero",
    r"= \(c_a [<>]= c_d\) \?": "the axes are sorted by their moments here, so c_a >= c_d",
    r"= \(0\.0 <= speed\) \?": "negative for all bodies that can exist",
    r"\(larger >= 16\.0\)": "less than 16 for all bodies that can exist",
    r"\(last <= earlier\)": "never later for bodies that can exist",
    r"return \(\(A_a \* unit\) <= max_rate\)": (
        "for bodies that can exist, the rate about d stays below that about b"
    ),
    r"isfinite\(work\.sum\)": (
        "no input is known whose constants overflow while its rates are below the limit"
    ),
    r"fabs\(x\.lo - lo\) <= 1e-30": "high parts differ, too, where directed rounding spoils sums",
    r"is_double_double\(": "the first test fails already under directed rounding",
    r"return sums && quotients": "directed rounding spoils sums and quotients alike",
}
