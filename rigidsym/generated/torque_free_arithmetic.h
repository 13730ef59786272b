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
static const double splitter = 134217729.0; /* 2^27 + 1 */
static const double rounder = 6755399441055744.0; /* 3 2^51; in n + 3 2^51 the last bits are those of the whole number n, |n| < 2^51 */
static const double least_whole = 4503599627370496.0; /* 2^52: from here on doubles are whole numbers */
static const double exponent_bias = 1023.0; /* what the exponent among the bits of 1 is */
enum { sign_place = 63 }; /* the place of the sign among the bits */
enum { exponent_place = 52 }; /* the place of the exponent among the bits */
static const uint64_t one_bits = 4607182418800017408; /* the bits of 1 */
static const uint64_t half_bits = 4602678819172646912; /* the bits of 1/2 */
static const uint64_t least_whole_bits = 4841369599423283200; /* the bits of 2^52 */
static const uint64_t fraction_bits = 4503599627370495; /* all bits below the exponent */
static const double quotient_cases[6][4] = {{7.0, 3.0, 2.3333333333333335, -1.4802973661668753e-16}, {3.0, 5.0, 0.6, 2.2204460492503132e-17}, {7.0, 25.0, 0.28, -2.6645352591003756e-17}, {15.0, 13.0, 1.1538461538461537, 1.0248212535001446e-16}, {15.0, 22.0, 0.6818181818181818, 5.0464682937507114e-17}, {13.0, 23.0, 0.5652173913043478, 4.344350965924526e-17}}; /* x, y, and x/y in two doubles */

/* Return a + b exactly, for |a| >= |b| (Dekker). */
static INLINED double_double quick_sum(double a, double b)
{
    const double s = a + b;
    const double c = s - a;
    const double_double result = {s, b - c};
    return result;
}

/* Return the upper half of the digits of a (Veltkamp); a must stay below 2^995. */
static INLINED double upper_half(double a)
{
    const double c = splitter * a;
    const double d = c - a;
    return c - d;
}

/* Return a b - p exactly, where p is the rounded product (Dekker). */
static INLINED double split_product_error(double a, double b, double p)
{
    const double a1 = upper_half(a);
    const double b1 = upper_half(b);
    const double a2 = a - a1;
    const double b2 = b - b1;
    const double e1 = a1 * b1 - p;
    const double e2 = e1 + a1 * b2;
    const double e3 = e2 + a2 * b1;
    return e3 + a2 * b2;
}

/* Return a b exactly. */
static INLINED double_double two_product(double a, double b)
{
    const double p = a * b;
    const double_double result = {p, product_error(a, b, p)};
    return result;
}

/* Return x y. */
static INLINED double_double dd_mul_xx(double_double x, double_double y)
{
    const double_double p = two_product(x.hi, y.hi);
    return quick_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* Return x y. */
static INLINED double_double dd_mul_xd(double_double x, double y)
{
    const double_double p = two_product(x.hi, y);
    return quick_sum(p.hi, p.lo + x.lo * y);
}

/* Return x y. */
static INLINED double_double dd_mul_dx(double x, double_double y)
{
    return dd_mul_xd(y, x);
}

/* Return x/y. */
static INLINED double_double dd_div_xx(double_double x, double_double y)
{
    const double q = x.hi / y.hi;
    const double_double r = dd_mul_xd(y, q);
    return quick_sum(q, (x.hi - r.hi + (x.lo - r.lo)) / y.hi);
}

/* Return a + b exactly (Knuth). */
static INLINED double_double two_sum(double a, double b)
{
    const double s = a + b;
    const double c = s - a;
    const double d = s - c;
    const double_double result = {s, a - d + (b - c)};
    return result;
}

/* Return x + y. */
static INLINED double_double dd_add_xx(double_double x, double_double y)
{
    const double_double s = two_sum(x.hi, y.hi);
    const double_double t = two_sum(x.lo, y.lo);
    const double_double v = quick_sum(s.hi, s.lo + t.hi);
    return quick_sum(v.hi, v.lo + t.lo);
}

/* Return x + y. */
static INLINED double_double dd_add_xd(double_double x, double y)
{
    const double_double s = two_sum(x.hi, y);
    return quick_sum(s.hi, s.lo + x.lo);
}

/* Return -x. */
static INLINED double_double dd_neg(double_double x)
{
    const double_double result = {-x.hi, -x.lo};
    return result;
}

/* Return x - y. */
static INLINED double_double dd_sub_xx(double_double x, double_double y)
{
    return dd_add_xx(x, dd_neg(y));
}

/* Return x/y. */
static INLINED double_double dd_div_xd(double_double x, double y)
{
    const double q = x.hi / y;
    const double_double r = two_product(y, q);
    return quick_sum(q, (x.hi - r.hi + (x.lo - r.lo)) / y);
}

/* Return the root of x, zero for zero. */
static INLINED double_double dd_sqrt(double_double x)
{
    const double s = sqrt(x.hi);
    const double_double r = two_product(s, s);
    const double rest = x.hi - r.hi + (x.lo - r.lo);
    return quick_sum(s, s > 0.0 ? rest / (2.0 * s) : 0.0);
}

/* Return x rounded to a double. */
static INLINED double dd_rounded(double_double x)
{
    return x.hi + x.lo;
}

/* Return x + y. */
static INLINED double_double dd_add_dx(double x, double_double y)
{
    return dd_add_xd(y, x);
}

/* Return x - y. */
static INLINED double_double dd_sub_dx(double x, double_double y)
{
    return dd_add_xd(dd_neg(y), x);
}

/* Return the nearest whole number, for |x| < 2^51. */
static INLINED double nearest(double x)
{
    const double shifted = x + rounder;
    return shifted - rounder;
}

/* Return (-1)^n for a whole number n: its last bit becomes the sign of 1. */
static INLINED double alternating(double n)
{
    return from_bits(one_bits | (bits_of(n + rounder) << sign_place));
}

/* Return 2^n for a whole number n between -1022 and 1023, from its bits. */
static INLINED double power_of_two(double n)
{
    return from_bits(bits_of(n + (rounder + exponent_bias)) << exponent_place);
}

/* Return one where x <= y, else other. */
static INLINED double choose(double x, double y, double one, double other)
{
    return x <= y ? one : other;
}

/* Return a double as an extended number. */
static INLINED double_double dd_of(double a)
{
    const double_double result = {a, 0.0};
    return result;
}

/* Return x - y. */
static INLINED double_double dd_sub_xd(double_double x, double y)
{
    return dd_add_xd(x, -y);
}

/* Return x/y. */
static INLINED double_double dd_div_dx(double x, double_double y)
{
    return dd_div_xx(dd_of(x), y);
}

/* Return |x|. */
static INLINED double_double dd_size(double_double x)
{
    return x.hi < 0.0 ? dd_neg(x) : x;
}

/* Return one where x <= y, else other. */
static INLINED double_double dd_choose(double x, double y, double_double one, double_double other)
{
    return x <= y ? one : other;
}

/* Return the exponent e of x = m 2^e with m between sqrt(1/2) and sqrt(2), nearly. x is between
   2^-1021 and 2^1022. Its bits give a mantissa between 1/2 and 1 first. */
static INLINED double dd_exponent(double_double x)
{
    const uint64_t every = bits_of(x.hi);
    const double fraction = from_bits((every & fraction_bits) | half_bits);
    const double e = from_bits((every >> exponent_place) | least_whole_bits) - (least_whole + exponent_bias - 1.0);
    return fraction < 0.7071067811865476 ? e - 1.0 : e;
}

/* Return the mantissa that belongs to `dd_exponent`. */
static INLINED double_double dd_mantissa(double_double x)
{
    const double power = power_of_two(-dd_exponent(x));
    const double_double result = {x.hi * power, x.lo * power};
    return result;
}

/* Return True where x is hi + lo to all its digits. */
static int is_double_double(double_double x, double hi, double lo)
{
    return fabs(x.hi - hi) <= 0.0 && fabs(x.lo - lo) <= 1e-30;
}

/* Return True where the compiler itself fuses no product with a sum. Return True, too, where the
   bits were not chosen. */
static int bits_hold(void)
{
    const double zero = hidden(0.0);
    const double more = zero + 1.0000000009313226;
    const double less = zero + 0.9999999990686774;
    return !BITS_ARE_CHOSEN || fabs(more * less - (zero + 1.0)) <= 0.0;
}

/* Return True where sums and products are rounded once, to nearest, and no low part is lost. */
static int sums_hold(void)
{
    const double zero = hidden(0.0);
    const double one = zero + 1.0;
    const double many = zero + 49.0;
    const double part = zero + 0.02040816326530612;
    const double tiny = zero + 8.673617379884035e-19;
    const double_double third = {one * 0.3333333333333333, one * 1.850371707708594e-17};
    const double_double fifth = {0.2, -1.1102230246251566e-17};
    const double_double seventh = {one * 0.14285714285714285, one * 7.93016446160826e-18};
    return bits_hold() && is_double_double(two_sum(one, tiny), 1.0, 8.673617379884035e-19) && is_double_double(two_sum(-tiny, one), 1.0, -8.673617379884035e-19) && is_double_double(two_product(part, many), 0.9999999999999999, 3.122502256758253e-17) && is_double_double(dd_mul_xx(third, third), 0.1111111111111111, 6.1679056923619804e-18) && is_double_double(dd_mul_xx(third, dd_mul_dx(one, fifth)), 0.06666666666666667, 9.251858538542971e-19) && is_double_double(dd_mul_xd(seventh, many), 7.0, 0.0);
}

/* Return True where quotients and roots have all their digits. y (x/y) is not x, nor a root's
   square its radicand. Compilers that assume so are wrong in one quotient of five, some of which
   are here. */
static int quotients_hold(void)
{
    const double zero = hidden(0.0);
    const double_double root = dd_sqrt(dd_of(zero + 2.0));
    int holds = is_double_double(root, 1.4142135623730951, -9.667293313452913e-17);
    for (size_t k = 0; k < 6; k++) {
        const double x = zero + quotient_cases[k][0];
        const double y = zero + quotient_cases[k][1];
        const double hi = quotient_cases[k][2];
        const double lo = quotient_cases[k][3];
        holds = holds && is_double_double(dd_div_xd(dd_of(x), y), hi, lo);
        holds = holds && is_double_double(dd_div_dx(x, dd_of(y)), hi, lo);
    }
    return holds;
}

#endif
