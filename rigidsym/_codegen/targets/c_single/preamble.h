#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "torque_free_single: -ffast-math reorders sums that must not be; compile without it"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "torque_free_single: -ffinite-math-only takes the checks of inputs away; compile without it"
#elif defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "torque_free_single: sums must round to float; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#elif FLT_RADIX != 2 || FLT_MANT_DIG != 24
#error "torque_free_single: a float must be a binary32 number"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

/* -DTORQUE_FREE_FMA=0 computes without fused multiply-add, and so has the same bits on every processor. */
#if !defined(TORQUE_FREE_FMA)
#if defined(FP_FAST_FMAF) || defined(__FMA__) || defined(__aarch64__)
#define TORQUE_FREE_FMA 1
#else
#define TORQUE_FREE_FMA 0
#endif
#endif
#if TORQUE_FREE_FMA
#define fused(a, b, c) fmaf((a), (b), (c))
#define product_error(a, b, p) fmaf((a), (b), -(p))
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

/* The exponent e of |x| between 2^(e-1) and 2^e, 0 for 0. */
static int exponent_of(float x)
{
    int e;
    (void)frexpf(x, &e);
    return e;
}

/* Copies that compilers see through. */
static uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float from_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}
