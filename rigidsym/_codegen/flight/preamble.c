/* Extended numbers need every operation rounded to double once, and none reordered.  Not every option
   that breaks this shows in a macro: torque_free_self_test looks, too. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "torque_free_flight: -ffast-math reorders sums that must not be; compile without it"
#elif defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ != 0)
#error "torque_free_flight: -ffinite-math-only takes the checks of inputs away; compile without it"
#elif defined(FLT_EVAL_METHOD) && ((FLT_EVAL_METHOD < 0) || (FLT_EVAL_METHOD == 2))
#error "torque_free_flight: sums must round to double; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#elif (FLT_RADIX != 2) || (DBL_MANT_DIG != 53)
#error "torque_free_flight: a double must be a binary64 number"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
/* GCC 12 fuses products in vectors of straight lines, even where it is told not to. */
#pragma GCC optimize("no-tree-slp-vectorize")
#endif

/* Call the handler of a precondition that does not hold. */
static void require(bool holds, int32_t line)
{
    if (!holds) {
        torque_free_assertion_failed(line);
    }
}

/* Return a b + c, rounded twice: the same bits on every processor. */
static double fused(double a, double b, double c)
{
    return (a * b) + c;
}

/* Return the exponent e of |x| between 2^(e-1) and 2^e, 0 for 0. */
static int exponent_of(double x)
{
    int e = 0;
    (void)frexp(x, &e);
    return e;
}

/* Return the bits of a number. */
static uint64_t bits_of(double x)
{
    uint64_t every = 0u;
    (void)memcpy(&every, &x, sizeof(every));
    return every;
}

/* Return the number with some bits. */
static double from_bits(uint64_t every)
{
    double x = 0.0;
    (void)memcpy(&x, &every, sizeof(x));
    return x;
}

/* Return x, which no compiler can know. */
static double hidden(double x)
{
    const volatile double kept = x;
    return kept;
}
