#ifndef TORQUE_FREE_ARITHMETIC_H
#define TORQUE_FREE_ARITHMETIC_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
#define restrict __restrict
#endif

/* What loops call has to be in them, or they are not vectorised; not every module calls all. */
#ifdef __GNUC__
#define INLINED inline __attribute__((always_inline, unused))
#else
#define INLINED inline
#endif

/* Extended numbers need every operation rounded to double once, and none reordered.  Not every option
   that breaks this shows in a macro: all functions that take moments look, too. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "torque_free: -ffast-math reorders sums that must not be; compile without it"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "torque_free: -ffinite-math-only takes the checks of inputs away; compile without it"
#elif defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)
#error "torque_free: sums must round to double; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#elif FLT_RADIX != 2 || DBL_MANT_DIG != 53
#error "torque_free: a double must be a binary64 number"
#endif
/* -fsingle-precision-constant has no macro: an array of negative size is no type. */
typedef char constants_must_be_doubles[sizeof 1.0 == sizeof(double) ? 1 : -1];
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

/* -DTORQUE_FREE_FMA=0 computes without fused multiply-add, and so has the same bits on every processor;
   -DTORQUE_FREE_FMA=1 computes with it, by the C library where the processor has none.  By default the
   faster one is chosen. */
#if defined(TORQUE_FREE_FMA)
#define BITS_ARE_CHOSEN 1
#if defined(__GNUC__) && !defined(__clang__)
/* GCC 12 fuses products in vectors of straight lines, even where it is told not to. */
#pragma GCC optimize("no-tree-slp-vectorize")
#endif
#else
#define BITS_ARE_CHOSEN 0
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
#define TORQUE_FREE_FMA 1
#else
#define TORQUE_FREE_FMA 0
#endif
#endif
#if TORQUE_FREE_FMA
#define fused(a, b, c) fma((a), (b), (c))
#define product_error(a, b, p) fma((a), (b), -(p))
#else
#define fused(a, b, c) ((a) * (b) + (c))
#define product_error(a, b, p) split_product_error((a), (b), (p))
#endif

#ifdef ALLOW_NONPHYSICAL
#undef ALLOW_NONPHYSICAL
#define ALLOW_NONPHYSICAL 1
#else
#define ALLOW_NONPHYSICAL 0
#endif

typedef struct { double hi, lo; } double_double;

static INLINED double_double dd_pair(double hi, double lo)
{
    const double_double x = {hi, lo};
    return x;
}

/* The exponent e of |x| between 2^(e-1) and 2^e, 0 for 0. */
static INLINED int exponent_of(double x)
{
    int e;
    (void)frexp(x, &e);
    return e;
}

/* Copies that compilers see through. */
static INLINED uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static INLINED double from_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* x, which no compiler can know. */
static INLINED double hidden(double x)
{
    const volatile double kept = x;
    return kept;
}

/* Prefetch the cache lines that n doubles will be written to. */
static INLINED void PREFETCH(const double *x, size_t n)
{
#ifdef __GNUC__
    for (size_t i = 0; i < n; i += 8)
        __builtin_prefetch(x + i, 1);
#else
    (void)x, (void)n;
#endif
}
