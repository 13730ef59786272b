#include "torque_free_single.h"

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
static const torque_free_pair pi = {3.1415927410125732f, -8.742277657347586e-08f}; /* pi */
static const float pi_hi = 3.1415927410125732f; /* pi */
static const float pi_lo = -8.742277657347586e-08f; /* pi - pi_hi */
static const torque_free_pair log_2 = {0.6931471824645996f, -1.9046542121259336e-09f}; /* log_2 */
static const float never = 1.2676506002282294e+30f; /* an exponent that stands for infinity */
static const torque_free_pair over_3 = {0.3333333432674408f, -9.934107758624577e-09f}; /* 1/3 */
static const torque_free_pair over_5 = {0.20000000298023224f, -2.9802322831784522e-09f}; /* 1/5 */
static const torque_free_pair over_7 = {0.1428571492433548f, -6.38621200366174e-09f}; /* 1/7 */
static const float over_9 = 0.1111111119389534f; /* 1/9 */
static const float over_11 = 0.09090909361839294f; /* 1/11 */
static const float over_13 = 0.07692307978868484f; /* 1/13 */
static const float sine_0 = -5.167712688446045f; /* sin(pi f)/f, z^1 */
static const float sine_1 = 2.550152540206909f; /* sin(pi f)/f, z^2 */
static const float sine_2 = -0.5990421772003174f; /* sin(pi f)/f, z^3 */
static const float sine_3 = 0.08074044436216354f; /* sin(pi f)/f, z^4 */
static const float sine_4 = -0.004482368007302284f; /* sin(pi f)/f, z^5 */
static const float cosine_0 = -4.934802055358887f; /* cos(pi f), z^1 */
static const float cosine_1 = 4.058693885803223f; /* cos(pi f), z^2 */
static const float cosine_2 = -1.3349053859710693f; /* cos(pi f), z^3 */
static const float cosine_3 = 0.2330067902803421f; /* cos(pi f), z^4 */
static const float cosine_4 = -0.020628124475479126f; /* cos(pi f), z^5 */
static const float least = -87.0f; /* e^x is taken for 0 below it */
static const float log_2_inverse = 1.4426950216293335f; /* 1/log 2 */
static const float log_2_short = 0.693145751953125f; /* log 2, its first digits */
static const float log_2_rest = 1.428606765330187e-06f; /* log 2, the others */
static const float half = 0.5f; /* 1/2 */
static const float exponential_0 = 0.1666666716337204f; /* e^r, r^3 */
static const float exponential_1 = 0.041666556149721146f; /* e^r, r^4 */
static const float exponential_2 = 0.00833332072943449f; /* e^r, r^5 */
static const float exponential_3 = 0.0013926203828305006f; /* e^r, r^6 */
static const float exponential_4 = 0.00019882719789166003f; /* e^r, r^7 */
static const float negligible = 8.673617379884035e-19f; /* 2^-60, rates below this share of the largest are taken for zero */
static const float decisive = 2.9103830456733704e-11f; /* 2^-35, share of a tilt; rates that cause less may be taken for zero */
static const float min_discriminant = 2.6469779601696886e-23f; /* 2^-75, E_b in inner units; below it, motions are on the separatrix */
static const float tolerated = 9.313225746154785e-10f; /* 2^-30, error of such motions, as a share of the momentum */
static const float min_moment_ratio = 9.5367431640625e-07f; /* 2^-20, ratio of two principal moments */
static const float max_circular = 0.5f; /* 2^-1, k_1^2 on the circular branch; above it, the hyperbolic one */
static const float max_angle = 131072.0f; /* 2^17, |omega0 t|, rad */
static const float max_rate = 1.2676506002282294e+30f; /* 2^100, a rate, rad/s; exact products with it do not overflow */
static const float splitter = 4097.0f; /* 2^12 + 1 */
static const float rounder = 12582912.0f; /* 3 2^22; in n + 3 2^22 the last bits are those of the whole number n, |n| < 2^22 */
static const float least_whole = 8388608.0f; /* 2^23: from here on numbers are whole */
static const float exponent_bias = 127.0f; /* what the exponent among the bits of 1 is */
enum { sign_place = 31 }; /* the place of the sign among the bits */
enum { exponent_place = 23 }; /* the place of the exponent among the bits */
static const uint32_t one_bits = 1065353216; /* the bits of 1 */
static const uint32_t half_bits = 1056964608; /* the bits of 1/2 */
static const uint32_t least_whole_bits = 1258291200; /* the bits of 2^23 */
static const uint32_t fraction_bits = 8388607; /* all bits below the exponent */
enum { PREPARED = 2135587861 }; /* the mark of a prepared motion: a number that memory hardly has by chance */
/* Sum of non-overlapping floats, smallest first; 32 hold any value of `discriminant`. */
typedef struct {
    size_t count;
    float part[32];
} exact;
/* Return the nearest whole number, for |x| < 2^51. */
static float nearest(float x)
{
    const float shifted = x + rounder;
    return shifted - rounder;
}

/* Return 2^n for a whole number n between -1022 and 1023, from its bits. */
static float power_of_two(float n)
{
    return from_bits(bits_of(n + (rounder + exponent_bias)) << exponent_place);
}

/* Return one where x <= y, else other. */
static float choose(float x, float y, float one, float other)
{
    return x <= y ? one : other;
}

/* e^x for x <= 0. */
static float exponential(float x)
{
    const float bounded = choose(least, x, x, least); /* classical: DLMF 4.8 */
    const float n = nearest(bounded * log_2_inverse); /* classical: DLMF 4.8 */
    const float r = fused(-n, log_2_rest, fused(-n, log_2_short, bounded)); /* classical: DLMF 4.2.19 */
    const float rest = fused(r, fused(r, fused(r, fused(r, exponential_4, exponential_3), exponential_2), exponential_1), exponential_0); /* classical: DLMF 4.2.19 */
    const float grown = 1.0f + fused(r * r, fused(r, rest, half), r); /* classical: DLMF 4.2.19 */
    const float value = choose(least, x, power_of_two(n) * grown, 0.0f); /* classical: DLMF 4.8 */
    return value;
}

/* Return -x. */
static torque_free_pair dd_neg(torque_free_pair x)
{
    const torque_free_pair result = {-x.hi, -x.lo};
    return result;
}

/* Return a + b exactly (Knuth). */
static torque_free_pair two_sum(float a, float b)
{
    const float s = a + b;
    const float c = s - a;
    const float d = s - c;
    const torque_free_pair result = {s, a - d + (b - c)};
    return result;
}

/* Return a + b exactly, for |a| >= |b| (Dekker). */
static torque_free_pair quick_sum(float a, float b)
{
    const float s = a + b;
    const float c = s - a;
    const torque_free_pair result = {s, b - c};
    return result;
}

/* Return x + y. */
static torque_free_pair dd_add_xx(torque_free_pair x, torque_free_pair y)
{
    const torque_free_pair s = two_sum(x.hi, y.hi);
    const torque_free_pair t = two_sum(x.lo, y.lo);
    const torque_free_pair v = quick_sum(s.hi, s.lo + t.hi);
    return quick_sum(v.hi, v.lo + t.lo);
}

/* Return x - y. */
static torque_free_pair dd_sub_xx(torque_free_pair x, torque_free_pair y)
{
    return dd_add_xx(x, dd_neg(y));
}

/* Return the upper half of the digits of a (Veltkamp); a must stay below 2^995. */
static float upper_half(float a)
{
    const float c = splitter * a;
    const float d = c - a;
    return c - d;
}

/* Return a b - p exactly, where p is the rounded product (Dekker). */
static float split_product_error(float a, float b, float p)
{
    const float a1 = upper_half(a);
    const float b1 = upper_half(b);
    const float a2 = a - a1;
    const float b2 = b - b1;
    float error = a1 * b1;
    error -= p;
    error += a1 * b2;
    error += a2 * b1;
    error += a2 * b2;
    return error;
}

/* Return a b exactly. */
static torque_free_pair two_product(float a, float b)
{
    const float p = a * b;
    const torque_free_pair result = {p, product_error(a, b, p)};
    return result;
}

/* Return x y. */
static torque_free_pair dd_mul_xx(torque_free_pair x, torque_free_pair y)
{
    const torque_free_pair p = two_product(x.hi, y.hi);
    return quick_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* K^2 - 2 H c_b, for numbers of any kind. */
static torque_free_pair discriminant_dd(torque_free_pair c_a, torque_free_pair c_d, torque_free_pair c_ab,
    torque_free_pair c_bd, torque_free_pair Omega_a, torque_free_pair Omega_d)
{
    const torque_free_pair E_b = dd_sub_xx(dd_mul_xx(dd_mul_xx(c_a, c_ab), dd_mul_xx(Omega_a, Omega_a)), dd_mul_xx(dd_mul_xx(c_d, c_bd), dd_mul_xx(Omega_d, Omega_d))); /* fact: regular.E_b; (6), (15) */
    return E_b;
}

/* Add a float to the parts of an exact number, and return how many there are then. */
static size_t grown(float *restrict part, size_t count, float a)
{
    size_t kept = 0;
    float rest = a;
    for (size_t i = 0; i < count; i++) {
        const torque_free_pair s = two_sum(rest, part[i]);
        if (s.lo < 0.0f || s.lo > 0.0f) {
            part[kept] = s.lo;
            kept += 1;
        }
        rest = s.hi;
    }
    part[kept] = rest;
    return kept + 1;
}

/* Return x - y. */
static exact exact_sub_xx(exact x, exact y)
{
    exact z = x;
    for (size_t i = 0; i < y.count; i++) {
        z.count = grown(z.part, z.count, -y.part[i]);
    }
    return z;
}

/* Return x y. */
static exact exact_mul_xx(exact x, exact y)
{
    exact z;
    z.count = 0;
    for (size_t i = 0; i < x.count; i++) {
        for (size_t j = 0; j < y.count; j++) {
            const torque_free_pair p = two_product(x.part[i], y.part[j]);
            z.count = grown(z.part, z.count, p.lo);
            z.count = grown(z.part, z.count, p.hi);
        }
    }
    return z;
}

/* K^2 - 2 H c_b, for numbers of any kind. */
static exact discriminant_exact(exact c_a, exact c_d, exact c_ab, exact c_bd, exact Omega_a,
    exact Omega_d)
{
    const exact E_b = exact_sub_xx(exact_mul_xx(exact_mul_xx(c_a, c_ab), exact_mul_xx(Omega_a, Omega_a)), exact_mul_xx(exact_mul_xx(c_d, c_bd), exact_mul_xx(Omega_d, Omega_d))); /* fact: regular.E_b; (6), (15) */
    return E_b;
}

/* 1 or -1 where a is the axis of largest or smallest moment, 0 for constant rates. */
static float circulation(float c_12, float c_13, float c_23, float Omega_1,
    float Omega_2, float Omega_3, float E_2)
{
    const float c_1 = 1.0f + c_13; /* fact: definition sorted_body.c_1 */
    const float c_2 = 1.0f + c_23; /* fact: definition sorted_body.c_2 */
    const float common_1 = Omega_3 * Omega_3; /* fact: definition sorted_body.E_1, definition sorted_body.turning, definition sorted_body.off_middle */
    const float common_2 = Omega_2 * Omega_2; /* fact: definition sorted_body.E_1, definition sorted_body.E_3, definition sorted_body.turning */
    const float E_1 = fused(c_13, common_1, common_2 * c_12 * c_2); /* fact: definition sorted_body.E_1 */
    const float common_3 = Omega_1 * Omega_1; /* fact: definition sorted_body.E_3, definition sorted_body.turning, definition sorted_body.off_middle */
    const float E_3 = fused(c_13 * common_3, c_1, c_23 * common_2 * c_2); /* fact: definition sorted_body.E_3 */
    const float turning = common_3 + common_2 + common_1; /* fact: definition sorted_body.turning */
    const float off_middle = common_3 + common_1; /* fact: definition sorted_body.off_middle */
    const float rest = 0.0f; /* fact: rest.rates */
    const float spherical = 0.0f; /* fact: spherical.moments */
    const float prolate_equatorial = 0.0f; /* fact: prolate_equatorial.parallel */
    const float prolate_polar = 0.0f; /* fact: prolate_polar.parallel */
    const float prolate_motion = -1.0f; /* fact: prolate_motion.squares; (10), (13), (14) */
    const float oblate_polar = 0.0f; /* fact: oblate_polar.parallel */
    const float oblate_equatorial = 0.0f; /* fact: oblate_equatorial.parallel */
    const float oblate_motion = 1.0f; /* fact: oblate_motion.squares; (10), (13), (14) */
    const float spin_1 = 0.0f; /* fact: spin_1.parallel */
    const float spin_3 = 0.0f; /* fact: spin_3.parallel */
    const float spin_2 = 0.0f; /* fact: spin_2.parallel */
    const float separatrix_motion = 1.0f; /* fact: separatrix_motion.squares; (10), (13), (14) */
    const float largest = 1.0f; /* fact: largest.squares; (10), (13), (14) */
    const float smallest = -1.0f; /* fact: smallest.squares; (10), (13), (14) */
    const float on_separatrix = choose(off_middle, 0.0f, spin_2, separatrix_motion); /* fact: on_separatrix.cases */
    const float off_1_and_3 = choose(E_2, 0.0f, choose(0.0f, E_2, on_separatrix, smallest), largest); /* fact: off_1_and_3.cases */
    const float off_1 = choose(E_3, 0.0f, spin_3, off_1_and_3); /* fact: off_1.cases */
    const float oblate_off_1 = choose(E_3, 0.0f, oblate_equatorial, oblate_motion); /* fact: oblate_off_1.cases */
    const float asymmetric = choose(E_1, 0.0f, spin_1, off_1); /* fact: asymmetric.cases */
    const float oblate = choose(E_1, 0.0f, oblate_polar, oblate_off_1); /* fact: oblate.cases */
    const float prolate_off_1 = choose(E_3, 0.0f, prolate_polar, prolate_motion); /* fact: prolate_off_1.cases */
    const float unequal_large = choose(c_23, 0.0f, oblate, asymmetric); /* fact: unequal_large.cases */
    const float prolate = choose(E_1, 0.0f, prolate_equatorial, prolate_off_1); /* fact: prolate.cases */
    const float nonspherical = choose(c_12, 0.0f, prolate, unequal_large); /* fact: nonspherical.cases */
    const float motion = choose(c_13, 0.0f, spherical, nonspherical); /* fact: motion.cases */
    const float sorted_body = choose(turning, 0.0f, rest, motion); /* fact: sorted_body.cases */
    return sorted_body;
}

/* Return x + y. */
static torque_free_pair dd_add_xd(torque_free_pair x, float y)
{
    const torque_free_pair s = two_sum(x.hi, y);
    return quick_sum(s.hi, s.lo + x.lo);
}

/* Return x + y. */
static torque_free_pair dd_add_dx(float x, torque_free_pair y)
{
    return dd_add_xd(y, x);
}

/* Return x y. */
static torque_free_pair dd_mul_xd(torque_free_pair x, float y)
{
    const torque_free_pair p = two_product(x.hi, y);
    return quick_sum(p.hi, p.lo + x.lo * y);
}

/* Return x y. */
static torque_free_pair dd_mul_dx(float x, torque_free_pair y)
{
    return dd_mul_xd(y, x);
}

/* Return x/y. */
static torque_free_pair dd_div_xx(torque_free_pair x, torque_free_pair y)
{
    const float q = x.hi / y.hi;
    const torque_free_pair r = dd_mul_xd(y, q);
    return quick_sum(q, (x.hi - r.hi + (x.lo - r.lo)) / y.hi);
}

/* Return x/y. */
static torque_free_pair dd_div_xd(torque_free_pair x, float y)
{
    const float q = x.hi / y;
    const torque_free_pair r = two_product(y, q);
    return quick_sum(q, (x.hi - r.hi + (x.lo - r.lo)) / y);
}

/* Return the root of x, zero for zero. */
static torque_free_pair dd_sqrt(torque_free_pair x)
{
    const float s = sqrtf(x.hi);
    const torque_free_pair r = two_product(s, s);
    const float rest = x.hi - r.hi + (x.lo - r.lo);
    const float divisor = s > 0.0f ? 2.0f * s : 1.0f;
    return quick_sum(s, rest / divisor);
}

/* Return x rounded to a float. */
static float dd_rounded(torque_free_pair x)
{
    return x.hi;
}

/* Signs, invariants, amplitudes and functions at t = 0; E_b is from `_discriminant`. */
static void initial_state(torque_free_pair c_a, torque_free_pair c_b, torque_free_pair c_d,
    torque_free_pair c_ab, torque_free_pair c_ad, torque_free_pair c_bd, torque_free_pair Omega_a,
    torque_free_pair Omega_b, torque_free_pair Omega_d, torque_free_pair E_b, float axis_a, float axis_b,
    float axis_d, torque_free_pair *K_out, torque_free_pair *A_a_out, torque_free_pair *A_b_out,
    torque_free_pair *A_d_out, torque_free_pair *B_a_out, torque_free_pair *B_d_out, torque_free_pair *k_1_out,
    torque_free_pair *kc_1_out, torque_free_pair *mu_out, torque_free_pair *psi_0_out, torque_free_pair *s_out,
    torque_free_pair *c_out, torque_free_pair *d_out, float *epsilon_out, float *sigma_out,
    float *rho_out, float *chi_out)
{
    const float epsilon = (axis_b - axis_a) * (axis_d - axis_a) * (axis_d - axis_b) / 2.0f; /* classical: Levi-Civita */
    const float sigma = choose(0.0f, dd_rounded(Omega_a), 1.0f, -1.0f); /* fact: choice start_signs.sigma; (12) */
    const float rho = choose(0.0f, dd_rounded(c_ad), 1.0f, -1.0f); /* fact: choice start_signs.rho; (12) */
    const float tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
    const float chi = choose(0.0f, tau * dd_rounded(Omega_d), 1.0f, -1.0f); /* fact: choice start_signs.chi; (12) */
    const torque_free_pair common_1 = dd_mul_xx(Omega_a, Omega_a); /* fact: regular.H, regular.E_d; (6), (15) */
    const torque_free_pair common_2 = dd_mul_xx(Omega_b, Omega_b); /* fact: regular.H, regular.E_a, regular.E_d; (6), (15) */
    const torque_free_pair common_3 = dd_mul_xx(Omega_d, Omega_d); /* fact: regular.H, regular.E_a; (6), (15) */
    const torque_free_pair H = dd_div_xd(dd_add_xx(dd_add_xx(dd_mul_xx(c_a, common_1), dd_mul_xx(c_b, common_2)), dd_mul_xx(c_d, common_3)), 2.0f); /* fact: regular.H; (6), (15) */
    const torque_free_pair common_4 = dd_mul_xx(c_b, c_ab); /* fact: regular.E_a, regular.A_b; (6), (15), (10), (13), (14) */
    const torque_free_pair common_5 = dd_mul_xx(c_d, c_ad); /* fact: regular.E_a, regular.A_d; (6), (15), (10), (13), (14) */
    const torque_free_pair E_a = dd_add_xx(dd_mul_xx(common_4, common_2), dd_mul_xx(common_5, common_3)); /* fact: regular.E_a; (6), (15) */
    const torque_free_pair common_6 = dd_mul_xx(c_a, c_ad); /* fact: regular.E_d, regular.A_a; (6), (15), (10), (13), (14) */
    const torque_free_pair E_d = dd_add_xx(dd_mul_xx(common_6, common_1), dd_mul_xx(dd_mul_xx(c_b, c_bd), common_2)); /* fact: regular.E_d; (6), (15) */
    const torque_free_pair M_a = dd_mul_xx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
    const torque_free_pair M_b = dd_mul_xx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
    const torque_free_pair M_d = dd_mul_xx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
    const torque_free_pair K = dd_sqrt(dd_add_xx(dd_add_xx(dd_mul_xx(M_a, M_a), dd_mul_xx(M_b, M_b)), dd_mul_xx(M_d, M_d))); /* fact: attitude.K; (6), (15) */
    const torque_free_pair A_a = dd_sqrt(dd_div_xx(E_d, common_6)); /* fact: regular.A_a; (10), (13), (14) */
    const torque_free_pair A_b = dd_sqrt(dd_div_xx(E_a, common_4)); /* fact: regular.A_b; (10), (13), (14) */
    const torque_free_pair A_d = dd_sqrt(dd_div_xx(E_a, common_5)); /* fact: regular.A_d; (10), (13), (14) */
    const torque_free_pair common_7 = dd_mul_xx(c_ab, E_d); /* fact: regular.lambda_, regular.m_1; (10), (13), (14) */
    const torque_free_pair lambda_ = dd_sqrt(dd_div_xx(common_7, dd_mul_xx(dd_mul_xx(c_a, c_b), c_d))); /* fact: regular.lambda_; (10), (13), (14) */
    const torque_free_pair m = dd_div_xx(dd_mul_xx(E_a, c_bd), dd_mul_xx(E_d, c_ab)); /* fact: regular.m; (10), (13), (14) */
    const torque_free_pair m_1 = dd_div_xx(dd_mul_xx(c_ad, E_b), common_7); /* fact: regular.m_1; (10), (13), (14) */
    const torque_free_pair k_c = dd_sqrt(m_1); /* fact: descended.k_c; DLMF 22.7.1 */
    const torque_free_pair common_8 = dd_add_dx(1.0f, k_c); /* fact: descended.k_1, descended.mu, definition landen.kc_next; DLMF 22.7.1, DLMF 22.7.2 */
    const torque_free_pair k_1 = dd_div_xx(m, dd_mul_xx(common_8, common_8)); /* fact: descended.k_1; DLMF 22.7.1 */
    const torque_free_pair mu = dd_div_xd(dd_mul_xx(lambda_, common_8), 2.0f); /* fact: descended.mu; DLMF 22.7.2 */
    const torque_free_pair common_9 = dd_mul_xx(c_a, A_a); /* fact: descended.psi_0, theta_form.B_a; (33), (34), (27) */
    const torque_free_pair psi_0 = dd_div_xx(dd_add_xx(dd_mul_dx(2.0f, H), dd_mul_xx(K, A_a)), dd_add_xx(K, common_9)); /* fact: descended.psi_0; (33), (34) */
    const torque_free_pair sn = dd_div_xx(dd_mul_dx(chi, Omega_b), A_b); /* fact: regular.sn; (12) */
    const torque_free_pair cn = dd_div_xx(dd_mul_dx(chi * tau, Omega_d), A_d); /* fact: regular.cn; (12) */
    const torque_free_pair dn = dd_div_xx(dd_mul_dx(sigma, Omega_a), A_a); /* fact: regular.dn; (12) */
    const torque_free_pair B_a = common_9; /* fact: theta_form.B_a; (27) */
    const torque_free_pair B_d = dd_mul_xx(c_d, A_d); /* fact: theta_form.B_d; (28) */
    const torque_free_pair root_kc = dd_sqrt(k_c); /* fact: landen.root_kc; DLMF 22.7.1 */
    const torque_free_pair kc_1 = dd_div_xx(dd_mul_dx(2.0f, root_kc), common_8); /* fact: definition landen.kc_next; DLMF 22.7.1 */
    const torque_free_pair common_10 = dd_add_dx(1.0f, dn); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const torque_free_pair common_11 = dd_mul_xx(common_10, dd_add_dx(1.0f, k_1)); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const torque_free_pair s = dd_div_xx(dd_mul_dx(2.0f, sn), common_11); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
    const torque_free_pair v = dd_sqrt(dd_mul_xx(common_11, dd_add_xx(k_c, dn))); /* fact: landen.v; DLMF 22.7.4 */
    const torque_free_pair c = dd_div_xx(dd_mul_dx(2.0f, cn), v); /* fact: landen.c_next; DLMF 22.7.2 to 22.7.4 */
    const torque_free_pair d = dd_div_xx(v, common_10); /* fact: landen.d_next; DLMF 22.7.2 to 22.7.4 */
    *K_out = K;
    *A_a_out = A_a;
    *A_b_out = A_b;
    *A_d_out = A_d;
    *B_a_out = B_a;
    *B_d_out = B_d;
    *k_1_out = k_1;
    *kc_1_out = kc_1;
    *mu_out = mu;
    *psi_0_out = psi_0;
    *s_out = s;
    *c_out = c;
    *d_out = d;
    *epsilon_out = epsilon;
    *sigma_out = sigma;
    *rho_out = rho;
    *chi_out = chi;
}

/* One step of Landen's descending transformation. */
static void landen(torque_free_pair k, torque_free_pair kc, torque_free_pair s, torque_free_pair c,
    torque_free_pair d, torque_free_pair r, torque_free_pair Y, torque_free_pair *k_next_out,
    torque_free_pair *kc_next_out, torque_free_pair *s_next_out, torque_free_pair *c_next_out,
    torque_free_pair *d_next_out, torque_free_pair *r_next_out, torque_free_pair *Y_next_out)
{
    const torque_free_pair common_1 = dd_add_dx(1.0f, kc); /* fact: landen.k_next, definition landen.kc_next, landen.r_next; DLMF 22.7.1 */
    const torque_free_pair common_2 = dd_mul_xx(common_1, common_1); /* fact: landen.k_next, landen.r_next; DLMF 22.7.1 */
    const torque_free_pair k_next = dd_div_xx(dd_mul_xx(k, k), common_2); /* fact: landen.k_next; DLMF 22.7.1 */
    const torque_free_pair root_kc = dd_sqrt(kc); /* fact: landen.root_kc; DLMF 22.7.1 */
    const torque_free_pair kc_next = dd_div_xx(dd_mul_dx(2.0f, root_kc), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1 */
    const torque_free_pair common_3 = dd_add_dx(1.0f, d); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const torque_free_pair common_4 = dd_add_dx(1.0f, k_next); /* fact: landen.s_next, landen.v, landen.S, landen.Y_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4, DLMF 22.7.2 */
    const torque_free_pair common_5 = dd_mul_xx(common_3, common_4); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const torque_free_pair s_next = dd_div_xx(dd_mul_dx(2.0f, s), common_5); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
    const torque_free_pair v = dd_sqrt(dd_mul_xx(common_5, dd_add_xx(kc, d))); /* fact: landen.v; DLMF 22.7.4 */
    const torque_free_pair c_next = dd_div_xx(dd_mul_dx(2.0f, c), v); /* fact: landen.c_next; DLMF 22.7.2 to 22.7.4 */
    const torque_free_pair d_next = dd_div_xx(v, common_3); /* fact: landen.d_next; DLMF 22.7.2 to 22.7.4 */
    const torque_free_pair r_next = dd_div_xx(dd_mul_xx(k, r), common_2); /* fact: landen.r_next; DLMF 22.7.1 */
    const torque_free_pair S = dd_sqrt(dd_add_xx(dd_mul_xx(common_4, common_4), dd_mul_xx(dd_mul_dx(4.0f, r_next), dd_mul_xx(Y, Y)))); /* fact: landen.S; DLMF 22.7.2 */
    const torque_free_pair Y_next = dd_div_xx(dd_mul_dx(2.0f, Y), dd_add_xx(common_4, S)); /* fact: landen.Y_next; DLMF 22.7.2 */
    *k_next_out = k_next;
    *kc_next_out = kc_next;
    *s_next_out = s_next;
    *c_next_out = c_next;
    *d_next_out = d_next;
    *r_next_out = r_next;
    *Y_next_out = Y_next;
}

/* K(k^2), and the descended s, c and Y; 4 steps leave k^2 < 2^-48 of (0, 1/2]. */
static void ladder(torque_free_pair k, torque_free_pair kc, torque_free_pair s, torque_free_pair c,
    torque_free_pair d, torque_free_pair r, torque_free_pair Y, torque_free_pair *K0_out, torque_free_pair *s4_out,
    torque_free_pair *c4_out, torque_free_pair *Y4_out)
{
    torque_free_pair k1;
    torque_free_pair kc1;
    torque_free_pair s1;
    torque_free_pair c1;
    torque_free_pair d1;
    torque_free_pair r1;
    torque_free_pair Y1;
    landen(k, kc, s, c, d, r, Y, &k1, &kc1, &s1, &c1, &d1, &r1, &Y1); /* classical: DLMF 22.7.2 */
    torque_free_pair k2;
    torque_free_pair kc2;
    torque_free_pair s2;
    torque_free_pair c2;
    torque_free_pair d2;
    torque_free_pair r2;
    torque_free_pair Y2;
    landen(k1, kc1, s1, c1, d1, r1, Y1, &k2, &kc2, &s2, &c2, &d2, &r2, &Y2); /* classical: DLMF 22.7.2 */
    torque_free_pair k3;
    torque_free_pair kc3;
    torque_free_pair s3;
    torque_free_pair c3;
    torque_free_pair d3;
    torque_free_pair r3;
    torque_free_pair Y3;
    landen(k2, kc2, s2, c2, d2, r2, Y2, &k3, &kc3, &s3, &c3, &d3, &r3, &Y3); /* classical: DLMF 22.7.2 */
    torque_free_pair k4;
    torque_free_pair kc4;
    torque_free_pair s4;
    torque_free_pair c4;
    torque_free_pair d4;
    torque_free_pair r4;
    torque_free_pair Y4;
    landen(k3, kc3, s3, c3, d3, r3, Y3, &k4, &kc4, &s4, &c4, &d4, &r4, &Y4); /* classical: DLMF 22.7.2 */
    const torque_free_pair K4 = dd_div_xd(pi, 2.0f); /* classical: DLMF 19.6.1 */
    const torque_free_pair K3 = dd_mul_xx(dd_add_dx(1.0f, k4), K4); /* fact: definition landen.K; DLMF 19.8.12 */
    const torque_free_pair K2 = dd_mul_xx(dd_add_dx(1.0f, k3), K3); /* fact: definition landen.K; DLMF 19.8.12 */
    const torque_free_pair K1 = dd_mul_xx(dd_add_dx(1.0f, k2), K2); /* fact: definition landen.K; DLMF 19.8.12 */
    const torque_free_pair K0 = dd_mul_xx(dd_add_dx(1.0f, k1), K1); /* fact: definition landen.K; DLMF 19.8.12 */
    *K0_out = K0;
    *s4_out = s4;
    *c4_out = c4;
    *Y4_out = Y4;
}

/* k/sqrt(q) where q is the nome of modulus k, kc its complement, k^2 <= 1/2. */
static torque_free_pair root_ratio(torque_free_pair k, torque_free_pair kc)
{
    const torque_free_pair root_kc = dd_sqrt(kc); /* classical: DLMF 19.8.12 */
    const torque_free_pair common_1 = dd_add_dx(1.0f, kc); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1, DLMF 19.8.12, DLMF 20.9.1 */
    const torque_free_pair common_2 = dd_div_xx(k, common_1); /* fact: landen.k_next; DLMF 22.7.1, DLMF 19.8.12 */
    const torque_free_pair k_next = dd_mul_xx(common_2, common_2); /* fact: landen.k_next; DLMF 22.7.1, DLMF 19.8.12 */
    const torque_free_pair kc_next = dd_div_xx(dd_mul_dx(2.0f, root_kc), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1, DLMF 19.8.12 */
    const torque_free_pair root = dd_add_dx(1.0f, dd_sqrt(kc_next)); /* classical: DLMF 20.9.1 */
    const torque_free_pair f = dd_mul_xx(dd_mul_xx(dd_mul_dx(2.0f, dd_add_dx(1.0f, kc_next)), root), root); /* classical: DLMF 20.9.1 */
    const torque_free_pair e = dd_div_xx(dd_mul_xx(k_next, k_next), f); /* classical: DLMF 20.9.1 */
    const torque_free_pair e2 = dd_mul_xx(e, e); /* classical: DLMF 20.9.1 */
    const torque_free_pair e4 = dd_mul_xx(e2, e2); /* classical: DLMF 20.9.1 */
    const torque_free_pair r = dd_div_xx(common_1, dd_sqrt(dd_sqrt(dd_div_xx(dd_add_dx(1.0f, dd_mul_xd(e4, 2.0f)), f)))); /* classical: DLMF 20.9.1 */
    return r;
}

/* theta/pi where s and c >= 0 are the sine and cosine of theta. */
static torque_free_pair half_turns(torque_free_pair s, torque_free_pair c)
{
    const torque_free_pair t1 = dd_div_xx(s, dd_add_dx(1.0f, c)); /* classical: DLMF 4.21.28 */
    const torque_free_pair t2 = dd_div_xx(t1, dd_add_dx(1.0f, dd_sqrt(dd_add_dx(1.0f, dd_mul_xx(t1, t1))))); /* classical: DLMF 4.21.28 */
    const torque_free_pair t3 = dd_div_xx(t2, dd_add_dx(1.0f, dd_sqrt(dd_add_dx(1.0f, dd_mul_xx(t2, t2))))); /* classical: DLMF 4.21.28 */
    const torque_free_pair t4 = dd_div_xx(t3, dd_add_dx(1.0f, dd_sqrt(dd_add_dx(1.0f, dd_mul_xx(t3, t3))))); /* classical: DLMF 4.21.28 */
    const torque_free_pair z = dd_neg(dd_mul_xx(t4, t4)); /* classical: DLMF 4.24.3 */
    const float z_d = dd_rounded(z); /* classical: DLMF 4.24.3 */
    const float tail = fused(z_d, fused(z_d, over_13, over_11), over_9); /* classical: DLMF 4.24.3 */
    const torque_free_pair series = dd_add_dx(1.0f, dd_mul_xx(z, dd_add_xx(over_3, dd_mul_xx(z, dd_add_xx(over_5, dd_mul_xx(z, dd_add_xx(over_7, dd_mul_xd(z, tail)))))))); /* classical: DLMF 4.24.3 */
    const torque_free_pair angle = dd_div_xx(dd_mul_xx(dd_mul_dx(16.0f, t4), series), pi); /* classical: DLMF 4.24.3 */
    return angle;
}

/* Return x - y. */
static torque_free_pair dd_sub_xd(torque_free_pair x, float y)
{
    return dd_add_xd(x, -y);
}

/* Return the exponent e of x = m 2^e with m between sqrt(1/2) and sqrt(2), nearly. x is between
   2^-1021 and 2^1022. Its bits give a mantissa between 1/2 and 1 first. */
static float dd_exponent(torque_free_pair x)
{
    const uint32_t every = bits_of(x.hi);
    const float fraction = from_bits((every & fraction_bits) | half_bits);
    const float e = from_bits((every >> exponent_place) | least_whole_bits) - (least_whole + exponent_bias - 1.0f);
    return fraction < 0.7071067811865476f ? e - 1.0f : e;
}

/* Return the mantissa that belongs to `dd_exponent`. */
static torque_free_pair dd_mantissa(torque_free_pair x)
{
    const float power = power_of_two(-dd_exponent(x));
    const torque_free_pair result = {x.hi * power, x.lo * power};
    return result;
}

/* log(x) for x > 0. */
static torque_free_pair logarithm(torque_free_pair x)
{
    const float e = dd_exponent(x); /* classical: DLMF 4.8 */
    const torque_free_pair f = dd_sqrt(dd_mantissa(x)); /* classical: DLMF 4.8 */
    const torque_free_pair t4 = dd_div_xx(dd_sub_xd(f, 1.0f), dd_add_xd(f, 1.0f)); /* classical: DLMF 4.38.5 */
    const torque_free_pair z = dd_mul_xx(t4, t4); /* classical: DLMF 4.38.5 */
    const float z_d = dd_rounded(z); /* classical: DLMF 4.38.5 */
    const float tail = fused(z_d, fused(z_d, over_13, over_11), over_9); /* classical: DLMF 4.38.5 */
    const torque_free_pair series = dd_add_dx(1.0f, dd_mul_xx(z, dd_add_xx(over_3, dd_mul_xx(z, dd_add_xx(over_5, dd_mul_xx(z, dd_add_xx(over_7, dd_mul_xd(z, tail)))))))); /* classical: DLMF 4.38.5 */
    const torque_free_pair log_x = dd_add_xx(dd_mul_dx(e, log_2), dd_mul_xx(dd_mul_dx(4.0f, t4), series)); /* classical: DLMF 4.38.5 */
    return log_x;
}

/* Return x - y. */
static torque_free_pair dd_sub_dx(float x, torque_free_pair y)
{
    return dd_add_xd(dd_neg(y), x);
}

/* The constants of a motion on the circular branch, from `_initial_state`. */
static void circular_constants(torque_free_pair K, torque_free_pair A_a, torque_free_pair A_b,
    torque_free_pair A_d, torque_free_pair B_a, torque_free_pair B_d, torque_free_pair k_1, torque_free_pair kc_1,
    torque_free_pair mu, torque_free_pair psi_0, torque_free_pair s, torque_free_pair c, torque_free_pair d,
    torque_free_pair q_0, torque_free_pair q_a, torque_free_pair q_b, torque_free_pair q_d, float epsilon,
    float sigma, float rho, float chi, float unit, torque_free_single_circular *motion)
{
    const torque_free_pair r = root_ratio(k_1, kc_1); /* classical: DLMF 20.9.1 */
    const torque_free_pair root_r = dd_sqrt(r); /* fact: scaling.root_r; (27) */
    const torque_free_pair Q = dd_div_xx(k_1, r); /* fact: scaling.Q; (27) */
    const torque_free_pair Y = dd_div_xx(B_d, dd_mul_xx(root_r, dd_add_xx(K, B_a))); /* fact: definition scaling.Y; (28) */
    torque_free_pair K_1;
    torque_free_pair sin_v;
    torque_free_pair cos_v;
    torque_free_pair Y_b;
    ladder(k_1, kc_1, s, c, d, r, Y, &K_1, &sin_v, &cos_v, &Y_b); /* classical: DLMF 19.8.12 */
    const torque_free_pair root_h = dd_sqrt(dd_add_xx(Q, dd_mul_xx(Y_b, Y_b))); /* fact: scaling.root_h; (28) */
    const torque_free_pair h_plus = dd_add_xx(Y_b, root_h); /* fact: scaling.h_plus; (28) */
    const torque_free_pair h_minus = dd_sub_xx(root_h, Y_b); /* fact: scaling.h_minus; (28) */
    const torque_free_pair g = dd_div_xx(pi, dd_mul_dx(2.0f, K_1)); /* fact: reading theta_form.g; (10) */
    const torque_free_pair up1 = h_plus; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair down1 = h_minus; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_up1 = dd_mul_xx(h_plus, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_down1 = dd_mul_xx(h_minus, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair up2 = dd_mul_xx(up1, step_up1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_up2 = dd_mul_xx(step_up1, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair down2 = dd_mul_xx(down1, step_down1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_down2 = dd_mul_xx(step_down1, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair up3 = dd_mul_xx(up2, step_up2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_up3 = dd_mul_xx(step_up2, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair down3 = dd_mul_xx(down2, step_down2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_down3 = dd_mul_xx(step_down2, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair up4 = dd_mul_xx(up3, step_up3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_up4 = dd_mul_xx(step_up3, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair down4 = dd_mul_xx(down3, step_down3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_down4 = dd_mul_xx(step_down3, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair up5 = dd_mul_xx(up4, step_up4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_up5 = dd_mul_xx(step_up4, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair down5 = dd_mul_xx(down4, step_down4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair step_down5 = dd_mul_xx(step_down4, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair up6 = dd_mul_xx(up5, step_up5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair down6 = dd_mul_xx(down5, step_down5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float down1_rounded = dd_rounded(down1); /* arithmetic */
    const float up1_rounded = dd_rounded(up1); /* arithmetic */
    const float p1 = up1_rounded + down1_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float d1 = up1_rounded - down1_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair p2 = dd_add_xx(up2, down2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair d2 = dd_sub_xx(up2, down2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float down3_rounded = dd_rounded(down3); /* arithmetic */
    const float up3_rounded = dd_rounded(up3); /* arithmetic */
    const float p3 = up3_rounded + down3_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float d3 = up3_rounded - down3_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair p4 = dd_add_xx(up4, down4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair d4 = dd_sub_xx(up4, down4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float down5_rounded = dd_rounded(down5); /* arithmetic */
    const float up5_rounded = dd_rounded(up5); /* arithmetic */
    const float p5 = up5_rounded + down5_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float d5 = up5_rounded - down5_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair p6 = dd_add_xx(up6, down6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair d6 = dd_sub_xx(up6, down6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const torque_free_pair common_1 = dd_mul_dx(4.0f, d4); /* classical: DLMF 20.2.4, DLMF 20.2.1 */
    const torque_free_pair zeta = dd_div_xx(dd_mul_xx(g, dd_add_xx(dd_sub_xx(dd_mul_dx(2.0f, d2), common_1), dd_mul_dx(6.0f, d6))), dd_sub_xx(dd_add_xx(dd_sub_dx(1.0f, p2), p4), p6)); /* classical: DLMF 20.2.4 */
    const float p4_rounded = dd_rounded(p4); /* arithmetic */
    const float T4_re_0 = 1.0f - p4_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float p2_rounded = dd_rounded(p2); /* arithmetic */
    const float T4_re_1 = -p2_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T4_re_2 = 2.0f * p4_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float d2_rounded = dd_rounded(d2); /* arithmetic */
    const float T4_im_0 = rho * (-2.0f * d2_rounded); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float common_1_rounded = dd_rounded(common_1); /* arithmetic */
    const float T4_im_1 = rho * common_1_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T1_re_0 = p1 - p3 - p5; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T1_re_1 = fused(-2.0f, p3, 2.0f * p5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T1_re_2 = 4.0f * p5; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T1_im_0 = rho * (-d1 - d3 + d5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T1_im_1 = rho * fused(2.0f, d3, 2.0f * d5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T1_im_2 = rho * (-4.0f * d5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float Q_rounded = dd_rounded(Q); /* arithmetic */
    const float Q2 = Q_rounded * Q_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float Q4 = Q2 * Q2; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float Q6 = Q4 * Q2; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float Q9 = Q4 * Q4 * Q_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float Q12 = Q6 * Q6; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float common_2 = 2.0f * Q4; /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
    const float even_0 = 1.0f - common_2; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float even_1 = 4.0f * Q4; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float common_3 = 2.0f * Q_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
    const float odd_0 = fused(-6.0f, Q9, common_3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float odd_1 = 8.0f * Q9; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float sine_even_0 = 1.0f - Q2 - Q6 + Q12; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float common_4 = 4.0f * Q12; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float sine_even_1 = fused(4.0f, Q6, -common_4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float sine_odd_0 = fused(-2.0f, Q2, 2.0f * Q6) + common_4; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float sine_odd_1 = -8.0f * Q12; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float two = 1.0f + Q2 + Q6 + Q12; /* classical: DLMF 20.2.2 */
    const float even_sum = 1.0f + common_2; /* classical: DLMF 20.2.3 */
    const float odd_sum = fused(2.0f, Q9, common_3); /* classical: DLMF 20.2.3 */
    const float three = even_sum + odd_sum; /* classical: DLMF 20.2.3 */
    const float four = even_sum - odd_sum; /* classical: DLMF 20.2.4 */
    const float h_plus_rounded = dd_rounded(h_plus); /* arithmetic */
    const float h2_plus = h_plus_rounded * h_plus_rounded; /* classical: DLMF 20.7.14 */
    const float h_minus_rounded = dd_rounded(h_minus); /* arithmetic */
    const float h2_minus = h_minus_rounded * h_minus_rounded; /* classical: DLMF 20.7.14 */
    const float side_plus = h2_plus * fused(Q2 * h2_plus, fused(Q4 * h2_plus, fused(Q6, h2_plus, 1.0f), 1.0f), 1.0f); /* classical: DLMF 20.7.14 */
    const float side_minus = h2_minus * fused(Q2 * h2_minus, fused(Q4 * h2_minus, fused(Q6, h2_minus, 1.0f), 1.0f), 1.0f); /* classical: DLMF 20.7.14 */
    const float watson = 1.0f + side_plus + side_minus; /* classical: DLMF 20.7.14 */
    const torque_free_pair Lambda = dd_add_xx(dd_div_xd(psi_0, 2.0f), dd_mul_xx(dd_mul_dx(rho, mu), zeta)); /* fact: definition theta_form.Lambda; (33), (34) */
    const torque_free_pair Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
    const torque_free_pair v = half_turns(sin_v, cos_v); /* classical: DLMF 4.24.3 */
    const torque_free_pair v_rate = dd_div_xx(dd_mul_xx(mu, g), pi); /* arithmetic */
    const float sin_v_rounded = dd_rounded(sin_v); /* arithmetic */
    const float x = fused(-2.0f, sin_v_rounded * sin_v_rounded, 1.0f); /* classical: DLMF 4.21.27 */
    const float x2 = x * x; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T4_re = fused(x, fused(x, T4_re_2, T4_re_1), T4_re_0); /* classical: DLMF 20.2.4 */
    const float cos_v_rounded = dd_rounded(cos_v); /* arithmetic */
    const float T4_im = sin_v_rounded * cos_v_rounded * fused(x, T4_im_1, T4_im_0); /* classical: DLMF 20.2.4 */
    const float T1_re = sin_v_rounded * fused(x, fused(x, T1_re_2, T1_re_1), T1_re_0); /* classical: DLMF 20.2.1 */
    const float T1_im = cos_v_rounded * fused(x, fused(x, T1_im_2, T1_im_1), T1_im_0); /* classical: DLMF 20.2.1 */
    const float sum_even = fused(x2, even_1, even_0); /* classical: DLMF 20.2.4 */
    const float sum_odd = x * fused(x2, odd_1, odd_0); /* classical: DLMF 20.2.4 */
    const float theta4_v = sum_even - sum_odd; /* classical: DLMF 20.2.4 */
    const float P4_re = T4_re; /* fact: definition theta_form.P4_re; (18) */
    const float P4_im = T4_im; /* fact: definition theta_form.P4_im; (18) */
    const float P1_re = T1_re; /* fact: definition theta_form.P1_re; (18) */
    const float P1_im = T1_im; /* fact: definition theta_form.P1_im; (18) */
    const float W = theta4_v * watson; /* fact: reading theta_form.W; (1) */
    const float N = sqrtf(W); /* fact: theta_form.N_of_W; (1) */
    const float qbar_0 = P4_re / N; /* fact: theta_form.qbar_0; (18), (25) */
    const float qbar_a = sigma * P4_im / N; /* fact: theta_form.qbar_a; (18), (25) */
    const float qbar_b = chi * P1_im / N; /* fact: theta_form.qbar_b; (18), (25) */
    const float common_5 = -epsilon * sigma * chi; /* fact: theta_form.qbar_d, definition attitude.q_0, definition attitude.q_a, definition attitude.q_b, definition attitude.q_d; (18), (25), (37) */
    const float qbar_d = common_5 * P1_re / N; /* fact: theta_form.qbar_d; (18), (25) */
    const float q_0_rounded = dd_rounded(q_0); /* arithmetic */
    const float q_a_rounded = dd_rounded(q_a); /* arithmetic */
    const float q_b_rounded = dd_rounded(q_b); /* arithmetic */
    const float q_d_rounded = dd_rounded(q_d); /* arithmetic */
    const float p_0 = fused(q_d_rounded, qbar_d, fused(q_b_rounded, qbar_b, fused(q_0_rounded, qbar_0, q_a_rounded * qbar_a))); /* fact: attitude.p_0; (37) */
    const float p_a = fused(epsilon, fused(q_d_rounded, qbar_b, -(q_b_rounded * qbar_d)), fused(q_a_rounded, qbar_0, -(q_0_rounded * qbar_a))); /* fact: attitude.p_a; (37) */
    const float p_b = fused(epsilon, fused(q_a_rounded, qbar_d, -(q_d_rounded * qbar_a)), fused(q_b_rounded, qbar_0, -(q_0_rounded * qbar_b))); /* fact: attitude.p_b; (37) */
    const float p_d = fused(epsilon, fused(q_b_rounded, qbar_a, -(q_a_rounded * qbar_b)), fused(q_d_rounded, qbar_0, -(q_0_rounded * qbar_d))); /* fact: attitude.p_d; (37) */
    const float over_N = 1.0f / sqrtf(watson); /* classical: DLMF 20.7.14 */
    const float row_0_P4_re = over_N * p_0; /* fact: definition attitude.q_0; (37) */
    const float row_0_P4_im = over_N * -(p_a * sigma); /* fact: definition attitude.q_0; (37) */
    const float row_0_P1_re = over_N * -(p_d * common_5); /* fact: definition attitude.q_0; (37) */
    const float row_0_P1_im = over_N * -(p_b * chi); /* fact: definition attitude.q_0; (37) */
    const float row_a_P4_re = over_N * p_a; /* fact: definition attitude.q_a; (37) */
    const float row_a_P4_im = over_N * (p_0 * sigma); /* fact: definition attitude.q_a; (37) */
    const float row_a_P1_re = over_N * (epsilon * (p_b * common_5)); /* fact: definition attitude.q_a; (37) */
    const float row_a_P1_im = over_N * (epsilon * -(p_d * chi)); /* fact: definition attitude.q_a; (37) */
    const float row_b_P4_re = over_N * p_b; /* fact: definition attitude.q_b; (37) */
    const float row_b_P4_im = over_N * (epsilon * (p_d * sigma)); /* fact: definition attitude.q_b; (37) */
    const float row_b_P1_re = over_N * (epsilon * -(p_a * common_5)); /* fact: definition attitude.q_b; (37) */
    const float row_b_P1_im = over_N * (p_0 * chi); /* fact: definition attitude.q_b; (37) */
    const float row_d_P4_re = over_N * p_d; /* fact: definition attitude.q_d; (37) */
    const float row_d_P4_im = over_N * (epsilon * -(p_b * sigma)); /* fact: definition attitude.q_d; (37) */
    const float row_d_P1_re = over_N * (p_0 * common_5); /* fact: definition attitude.q_d; (37) */
    const float row_d_P1_im = over_N * (epsilon * (p_a * chi)); /* fact: definition attitude.q_d; (37) */
    const float tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
    const float A_a_rounded = dd_rounded(A_a); /* arithmetic */
    const float gain_a = sigma * A_a_rounded * (four / three) * unit; /* fact: definition regular.Omega_a; (10), DLMF 22.2.4 */
    const float A_b_rounded = dd_rounded(A_b); /* arithmetic */
    const float gain_b = chi * A_b_rounded * (three / two) * unit; /* fact: definition regular.Omega_b; (10), DLMF 22.2.4 */
    const float A_d_rounded = dd_rounded(A_d); /* arithmetic */
    const float gain_d = chi * tau * A_d_rounded * (four / two) * unit; /* fact: definition regular.Omega_d; (10), DLMF 22.2.4 */
    motion->v_rate_hi = v_rate.hi;
    motion->v_rate_lo = v_rate.lo;
    motion->v_hi = v.hi;
    motion->v_lo = v.lo;
    motion->Lambda_rate_hi = Lambda_rate.hi;
    motion->Lambda_rate_lo = Lambda_rate.lo;
    motion->T4_re_0 = T4_re_0;
    motion->T4_re_1 = T4_re_1;
    motion->T4_re_2 = T4_re_2;
    motion->T4_im_0 = T4_im_0;
    motion->T4_im_1 = T4_im_1;
    motion->T1_re_0 = T1_re_0;
    motion->T1_re_1 = T1_re_1;
    motion->T1_re_2 = T1_re_2;
    motion->T1_im_0 = T1_im_0;
    motion->T1_im_1 = T1_im_1;
    motion->T1_im_2 = T1_im_2;
    motion->even_0 = even_0;
    motion->even_1 = even_1;
    motion->odd_0 = odd_0;
    motion->odd_1 = odd_1;
    motion->sine_even_0 = sine_even_0;
    motion->sine_even_1 = sine_even_1;
    motion->sine_odd_0 = sine_odd_0;
    motion->sine_odd_1 = sine_odd_1;
    motion->row_0_P4_re = row_0_P4_re;
    motion->row_0_P4_im = row_0_P4_im;
    motion->row_0_P1_re = row_0_P1_re;
    motion->row_0_P1_im = row_0_P1_im;
    motion->row_a_P4_re = row_a_P4_re;
    motion->row_a_P4_im = row_a_P4_im;
    motion->row_a_P1_re = row_a_P1_re;
    motion->row_a_P1_im = row_a_P1_im;
    motion->row_b_P4_re = row_b_P4_re;
    motion->row_b_P4_im = row_b_P4_im;
    motion->row_b_P1_re = row_b_P1_re;
    motion->row_b_P1_im = row_b_P1_im;
    motion->row_d_P4_re = row_d_P4_re;
    motion->row_d_P4_im = row_d_P4_im;
    motion->row_d_P1_re = row_d_P1_re;
    motion->row_d_P1_im = row_d_P1_im;
    motion->gain_a = gain_a;
    motion->gain_b = gain_b;
    motion->gain_d = gain_d;
}

/* Return (-1)^n for a whole number n: its last bit becomes the sign of 1. */
static float alternating(float n)
{
    return from_bits(one_bits | (bits_of(n + rounder) << sign_place));
}

/* Angles of the circular branch at t + t_lo. */
static void circular_angles(const torque_free_single_circular *motion, float t, float t_lo,
    float *sin_v_out, float *cos_v_out, float *X_im_out, float *X_re_out)
{
    const float v_rate_hi = motion->v_rate_hi;
    const float v_rate_lo = motion->v_rate_lo;
    const float v_hi = motion->v_hi;
    const float v_lo = motion->v_lo;
    const float Lambda_rate_hi = motion->Lambda_rate_hi;
    const float Lambda_rate_lo = motion->Lambda_rate_lo;
    const float p = v_rate_hi * t; /* arithmetic: Dekker 1971 */
    const float p_error = product_error(v_rate_hi, t, p) + fused(v_rate_lo, t, fused(v_rate_hi, t_lo, v_lo)); /* arithmetic: Dekker 1971 */
    const float v = p + v_hi; /* arithmetic: Knuth 4.2.2 */
    const float v_other = v - p; /* arithmetic: Knuth 4.2.2 */
    const float v_error = p - (v - v_other) + (v_hi - v_other); /* arithmetic: Knuth 4.2.2 */
    const float v_whole = nearest(v); /* classical: DLMF 4.16 */
    const float v_rest = v - v_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float v_turns = v_rest + (p_error + v_error); /* classical: DLMF 4.16 */
    const float v_square = v_turns * v_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
    const float v_sign = alternating(v_whole); /* classical: DLMF 4.16 */
    const float sin_v = v_sign * fused(v_turns, pi_hi, v_turns * fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, sine_4, sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
    const float cos_v = v_sign * fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, cosine_4, cosine_3), cosine_2), cosine_1), cosine_0), 1.0f); /* classical: DLMF 4.19.2 */
    const float L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
    const float L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
    const float L_whole = nearest(L); /* classical: DLMF 4.16 */
    const float L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float L_turns = L_rest + L_error; /* classical: DLMF 4.16 */
    const float L_square = L_turns * L_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
    const float L_sign = alternating(L_whole); /* classical: DLMF 4.16 */
    const float X_im = L_sign * fused(L_turns, pi_hi, L_turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_4, sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
    const float X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_4, cosine_3), cosine_2), cosine_1), cosine_0), 1.0f); /* classical: DLMF 4.19.2 */
    *sin_v_out = sin_v;
    *cos_v_out = cos_v;
    *X_im_out = X_im;
    *X_re_out = X_re;
}

/* The state on the circular branch, from `_circular_angles`. */
static void circular_state(const torque_free_single_circular *motion, float sin_v, float cos_v,
    float X_im, float X_re, float *q_0_out, float *q_a_out, float *q_b_out, float *q_d_out,
    float *Omega_a_out, float *Omega_b_out, float *Omega_d_out)
{
    const float T4_re_0 = motion->T4_re_0;
    const float T4_re_1 = motion->T4_re_1;
    const float T4_re_2 = motion->T4_re_2;
    const float T4_im_0 = motion->T4_im_0;
    const float T4_im_1 = motion->T4_im_1;
    const float T1_re_0 = motion->T1_re_0;
    const float T1_re_1 = motion->T1_re_1;
    const float T1_re_2 = motion->T1_re_2;
    const float T1_im_0 = motion->T1_im_0;
    const float T1_im_1 = motion->T1_im_1;
    const float T1_im_2 = motion->T1_im_2;
    const float even_0 = motion->even_0;
    const float even_1 = motion->even_1;
    const float odd_0 = motion->odd_0;
    const float odd_1 = motion->odd_1;
    const float sine_even_0 = motion->sine_even_0;
    const float sine_even_1 = motion->sine_even_1;
    const float sine_odd_0 = motion->sine_odd_0;
    const float sine_odd_1 = motion->sine_odd_1;
    const float row_0_P4_re = motion->row_0_P4_re;
    const float row_0_P4_im = motion->row_0_P4_im;
    const float row_0_P1_re = motion->row_0_P1_re;
    const float row_0_P1_im = motion->row_0_P1_im;
    const float row_a_P4_re = motion->row_a_P4_re;
    const float row_a_P4_im = motion->row_a_P4_im;
    const float row_a_P1_re = motion->row_a_P1_re;
    const float row_a_P1_im = motion->row_a_P1_im;
    const float row_b_P4_re = motion->row_b_P4_re;
    const float row_b_P4_im = motion->row_b_P4_im;
    const float row_b_P1_re = motion->row_b_P1_re;
    const float row_b_P1_im = motion->row_b_P1_im;
    const float row_d_P4_re = motion->row_d_P4_re;
    const float row_d_P4_im = motion->row_d_P4_im;
    const float row_d_P1_re = motion->row_d_P1_re;
    const float row_d_P1_im = motion->row_d_P1_im;
    const float gain_a = motion->gain_a;
    const float gain_b = motion->gain_b;
    const float gain_d = motion->gain_d;
    const float x = fused(-2.0f, sin_v * sin_v, 1.0f); /* classical: DLMF 4.21.27 */
    const float x2 = x * x; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const float T4_re = fused(x, fused(x, T4_re_2, T4_re_1), T4_re_0); /* classical: DLMF 20.2.4 */
    const float T4_im = sin_v * cos_v * fused(x, T4_im_1, T4_im_0); /* classical: DLMF 20.2.4 */
    const float T1_re = sin_v * fused(x, fused(x, T1_re_2, T1_re_1), T1_re_0); /* classical: DLMF 20.2.1 */
    const float T1_im = cos_v * fused(x, fused(x, T1_im_2, T1_im_1), T1_im_0); /* classical: DLMF 20.2.1 */
    const float sum_even = fused(x2, even_1, even_0); /* classical: DLMF 20.2.4 */
    const float sum_odd = x * fused(x2, odd_1, odd_0); /* classical: DLMF 20.2.4 */
    const float theta4_v = sum_even - sum_odd; /* classical: DLMF 20.2.4 */
    const float theta3_v = sum_even + sum_odd; /* classical: DLMF 20.2.3 */
    const float part_even = fused(x2, sine_even_1, sine_even_0); /* classical: DLMF 20.2.1 */
    const float part_odd = x * fused(x2, sine_odd_1, sine_odd_0); /* classical: DLMF 20.2.1 */
    const float theta1_v = sin_v * (part_even + part_odd); /* classical: DLMF 20.2.1 */
    const float theta2_v = cos_v * (part_even - part_odd); /* classical: DLMF 20.2.2 */
    const float P4_re = fused(X_re, T4_re, -(X_im * T4_im)); /* fact: definition theta_form.P4_re; (18) */
    const float P4_im = fused(X_re, T4_im, X_im * T4_re); /* fact: definition theta_form.P4_im; (18) */
    const float P1_re = fused(X_re, T1_re, -(X_im * T1_im)); /* fact: definition theta_form.P1_re; (18) */
    const float P1_im = fused(X_re, T1_im, X_im * T1_re); /* fact: definition theta_form.P1_im; (18) */
    const float over = 1.0f / theta4_v; /* arithmetic */
    const float scale = sqrtf(over); /* arithmetic */
    const float q_0 = scale * fused(row_0_P4_re, P4_re, fused(row_0_P4_im, P4_im, fused(row_0_P1_re, P1_re, row_0_P1_im * P1_im))); /* fact: definition attitude.q_0; (37) */
    const float q_a = scale * fused(row_a_P4_re, P4_re, fused(row_a_P4_im, P4_im, fused(row_a_P1_re, P1_re, row_a_P1_im * P1_im))); /* fact: definition attitude.q_a; (37) */
    const float q_b = scale * fused(row_b_P4_re, P4_re, fused(row_b_P4_im, P4_im, fused(row_b_P1_re, P1_re, row_b_P1_im * P1_im))); /* fact: definition attitude.q_b; (37) */
    const float q_d = scale * fused(row_d_P4_re, P4_re, fused(row_d_P4_im, P4_im, fused(row_d_P1_re, P1_re, row_d_P1_im * P1_im))); /* fact: definition attitude.q_d; (37) */
    const float Omega_a = gain_a * (theta3_v * over); /* fact: definition regular.Omega_a; (10) */
    const float Omega_b = gain_b * (theta1_v * over); /* fact: definition regular.Omega_b; (10) */
    const float Omega_d = gain_d * (theta2_v * over); /* fact: definition regular.Omega_d; (10) */
    *q_0_out = q_0;
    *q_a_out = q_a;
    *q_b_out = q_b;
    *q_d_out = q_d;
    *Omega_a_out = Omega_a;
    *Omega_b_out = Omega_b;
    *Omega_d_out = Omega_d;
}

/* Return a float as an extended number. */
static torque_free_pair dd_of(float a)
{
    const torque_free_pair result = {a, 0.0f};
    return result;
}

/* Return x/y. */
static torque_free_pair dd_div_dx(float x, torque_free_pair y)
{
    return dd_div_xx(dd_of(x), y);
}

/* Return |x|. */
static torque_free_pair dd_size(torque_free_pair x)
{
    return x.hi < 0.0f ? dd_neg(x) : x;
}

/* Return one where x <= y, else other. */
static torque_free_pair dd_choose(float x, float y, torque_free_pair one, torque_free_pair other)
{
    return x <= y ? one : other;
}

/* The constants of a motion on the hyperbolic branch, from `_initial_state`. */
static void hyperbolic_constants(torque_free_pair K, torque_free_pair A_a, torque_free_pair A_b,
    torque_free_pair A_d, torque_free_pair B_a, torque_free_pair B_d, torque_free_pair k_1, torque_free_pair kc_1,
    torque_free_pair mu, torque_free_pair psi_0, torque_free_pair s, torque_free_pair c, torque_free_pair q_0,
    torque_free_pair q_a, torque_free_pair q_b, torque_free_pair q_d, float epsilon, float sigma,
    float rho, float chi, float unit, torque_free_single_hyperbolic *motion)
{
    const torque_free_pair root_k = dd_sqrt(k_1); /* fact: theta_form.root_k; (27) */
    const torque_free_pair x = dd_div_xx(B_d, dd_mul_xx(root_k, dd_add_xx(K, B_a))); /* fact: definition theta_form.x; (28) */
    const torque_free_pair y = dd_sqrt(dd_add_dx(1.0f, dd_mul_xx(x, x))); /* fact: theta_form.y; DLMF 22.6.1 */
    const torque_free_pair common_1 = dd_mul_xx(k_1, x); /* fact: theta_form.z; DLMF 22.6.1 */
    const torque_free_pair z = dd_sqrt(dd_add_dx(1.0f, dd_mul_xx(common_1, common_1))); /* fact: theta_form.z; DLMF 22.6.1 */
    const torque_free_pair s_beta = dd_div_xx(x, y); /* fact: definition theta_form.s_beta; DLMF 22.6.1 */
    const torque_free_pair c_beta = dd_div_dx(1.0f, y); /* fact: definition theta_form.c_beta; DLMF 22.6.1 */
    const torque_free_pair d_beta = dd_div_xx(z, y); /* fact: definition theta_form.d_beta; DLMF 22.6.1 */
    const torque_free_pair r = root_ratio(kc_1, k_1); /* classical: DLMF 20.9.1 */
    const torque_free_pair root_nome = dd_div_xx(kc_1, r); /* classical: DLMF 20.9.1 */
    const torque_free_pair nome = dd_mul_xx(root_nome, root_nome); /* classical: DLMF 20.9.1 */
    const torque_free_pair size_s = dd_size(s); /* classical: DLMF 22.4.3 */
    const float near = dd_rounded(dd_mul_xx(c, c)); /* classical: DLMF 22.4.3 */
    const float far = dd_rounded(dd_mul_xx(kc_1, dd_mul_xx(s, s))); /* classical: DLMF 22.4.3 */
    const torque_free_pair above = dd_choose(far, near, size_s, c); /* classical: DLMF 22.4.3 */
    const torque_free_pair below = dd_choose(far, near, c, dd_mul_xx(kc_1, size_s)); /* classical: DLMF 22.4.3 */
    const torque_free_pair xi = dd_div_xx(above, below); /* classical: DLMF 22.6.7 */
    torque_free_pair K_c;
    torque_free_pair sin_a;
    torque_free_pair cos_a;
    torque_free_pair Y_b;
    ladder(kc_1, k_1, s_beta, c_beta, d_beta, kc_1, xi, &K_c, &sin_a, &cos_a, &Y_b); /* classical: DLMF 19.8.12 */
    const torque_free_pair gc = dd_div_xx(pi, dd_mul_dx(2.0f, K_c)); /* fact: reading hyperbolic_form.gc; (10) */
    const torque_free_pair nome2 = dd_mul_xx(nome, nome); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair nome4 = dd_mul_xx(nome2, nome2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair nome6 = dd_mul_xx(nome4, nome2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair C_0 = cos_a; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair S_0 = sin_a; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair turn = dd_mul_dx(2.0f, dd_sub_dx(1.0f, dd_mul_dx(2.0f, dd_mul_xx(sin_a, sin_a)))); /* classical: DLMF 4.21.27 */
    const torque_free_pair C_1 = dd_mul_xx(dd_sub_xd(turn, 1.0f), C_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair S_1 = dd_mul_xx(dd_add_xd(turn, 1.0f), S_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair C_2 = dd_sub_xx(dd_mul_xx(turn, C_1), C_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair S_2 = dd_sub_xx(dd_mul_xx(turn, S_1), S_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair zeta = dd_div_xx(dd_mul_xx(gc, dd_add_xx(dd_add_xx(S_0, dd_mul_xx(dd_mul_dx(3.0f, nome2), S_1)), dd_mul_xx(dd_mul_dx(5.0f, nome6), S_2))), dd_add_xx(dd_add_xx(C_0, dd_mul_xx(nome2, C_1)), dd_mul_xx(nome6, C_2))); /* classical: DLMF 20.2.2 */
    const float C_0_rounded = dd_rounded(C_0); /* arithmetic */
    const float re_0 = C_0_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float S_0_rounded = dd_rounded(S_0); /* arithmetic */
    const float im_0 = -(rho * S_0_rounded); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float C_1_rounded = dd_rounded(C_1); /* arithmetic */
    const float nome_rounded = dd_rounded(nome); /* arithmetic */
    const float re_1 = nome_rounded * C_1_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float S_1_rounded = dd_rounded(S_1); /* arithmetic */
    const float im_1 = -(rho * nome_rounded * S_1_rounded); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float C_2_rounded = dd_rounded(C_2); /* arithmetic */
    const float nome4_rounded = dd_rounded(nome4); /* arithmetic */
    const float re_2 = nome4_rounded * C_2_rounded; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float S_2_rounded = dd_rounded(S_2); /* arithmetic */
    const float im_2 = -(rho * nome4_rounded * S_2_rounded); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float two = 1.0f + nome4_rounded; /* classical: DLMF 20.2.2 */
    const float nome2_rounded = dd_rounded(nome2); /* arithmetic */
    const float common_2 = 2.0f * nome2_rounded; /* classical: DLMF 20.2.3, DLMF 20.2.4 */
    const float three = 1.0f + common_2; /* classical: DLMF 20.2.3 */
    const float four = 1.0f - common_2; /* classical: DLMF 20.2.4 */
    const float turn_rounded = dd_rounded(turn); /* arithmetic */
    const float twice = fused(turn_rounded, turn_rounded, -2.0f); /* classical: DLMF 4.21.27 */
    const float watson = fused(nome2_rounded, twice, 1.0f); /* classical: DLMF 20.7.14 */
    const torque_free_pair Lambda = dd_add_xx(dd_div_xd(psi_0, 2.0f), dd_mul_xx(dd_mul_dx(rho, mu), zeta)); /* fact: definition theta_form.Lambda; (33), (34) */
    const torque_free_pair Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
    const float nome_d = dd_rounded(nome); /* classical: DLMF 20.2.2 */
    const torque_free_pair period = dd_neg(logarithm(dd_choose(nome_d, 0.0f, dd_of(1.0f), nome))); /* classical: DLMF 20.2.2 */
    const float period_rounded = dd_rounded(period); /* arithmetic */
    const float period_far = choose(nome_d, 0.0f, never, period_rounded); /* classical: DLMF 20.2.7 */
    const float period_d = choose(nome_d, 0.0f, 1.0f, period_rounded); /* classical: DLMF 20.2.7 */
    const float period_inverse = choose(nome_d, 0.0f, 0.0f, 1.0f / period_d); /* classical: DLMF 20.2.7 */
    const torque_free_pair cosh_y = dd_sqrt(dd_add_dx(1.0f, dd_mul_xx(Y_b, Y_b))); /* classical: DLMF 4.35.11 */
    const torque_free_pair common_3 = dd_add_xx(Y_b, cosh_y); /* classical: DLMF 4.37.16 */
    const torque_free_pair y_b = logarithm(common_3); /* classical: DLMF 4.37.16 */
    const torque_free_pair y_size = dd_choose(far, near, y_b, dd_sub_xx(dd_div_xd(period, 2.0f), y_b)); /* classical: DLMF 22.4.3 */
    const float side = choose(0.0f, dd_rounded(s), 1.0f, -1.0f); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const torque_free_pair y0 = dd_mul_dx(side, y_size); /* arithmetic */
    const torque_free_pair y_rate = dd_mul_xx(mu, gc); /* arithmetic */
    const float common_3_rounded = dd_rounded(common_3); /* arithmetic */
    const float e_near = 1.0f / (common_3_rounded * common_3_rounded); /* classical: DLMF 4.37.16 */
    const float e_far = nome_rounded / e_near; /* classical: DLMF 20.2.2 */
    const float w = choose(far, near, e_near, e_far); /* classical: DLMF 20.2.2 */
    const float p = choose(far, near, e_far, e_near); /* classical: DLMF 20.2.2 */
    const torque_free_pair alpha = half_turns(sin_a, cos_a); /* classical: DLMF 4.24.3 */
    const torque_free_pair jump = dd_mul_dx(-2.0f * rho, alpha); /* classical: DLMF 20.2.7 */
    const float p2 = p * p; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float qw = nome_rounded * w; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float qw2 = qw * qw; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_re_even = fused(p2, re_2, re_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_re_odd = p * re_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_re_even = fused(qw2, re_2, re_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_re_odd = qw * re_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_im_even = fused(p2, im_2, im_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_im_odd = p * im_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_im_even = fused(qw2, im_2, im_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_im_odd = qw * im_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float T4_re = fused(w, far_re_even + far_re_odd, near_re_even + near_re_odd); /* classical: DLMF 20.2.2 */
    const float T4_im = side * fused(-w, far_im_even + far_im_odd, near_im_even + near_im_odd); /* classical: DLMF 20.2.2 */
    const float T1_re = side * fused(-w, far_re_even - far_re_odd, near_re_even - near_re_odd); /* classical: DLMF 20.2.1 */
    const float T1_im = fused(w, far_im_even - far_im_odd, near_im_even - near_im_odd); /* classical: DLMF 20.2.1 */
    const float w2 = w * w; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float tall = fused(p2, nome2_rounded, 1.0f); /* classical: DLMF 20.2.2 */
    const float deep = w2 * fused(qw2, nome2_rounded, 1.0f); /* classical: DLMF 20.2.2 */
    const float theta2_y = tall + deep; /* classical: DLMF 20.2.2 */
    const float P4_re = T4_re; /* fact: definition theta_form.P4_re; (18) */
    const float P4_im = T4_im; /* fact: definition theta_form.P4_im; (18) */
    const float P1_re = T1_re; /* fact: definition theta_form.P1_re; (18) */
    const float P1_im = T1_im; /* fact: definition theta_form.P1_im; (18) */
    const float W = 2.0f * theta2_y * watson; /* fact: reading hyperbolic_form.W; (1) */
    const float N = sqrtf(W); /* fact: theta_form.N_of_W; (1) */
    const float qbar_0 = P4_re / N; /* fact: theta_form.qbar_0; (18), (25) */
    const float qbar_a = sigma * P4_im / N; /* fact: theta_form.qbar_a; (18), (25) */
    const float qbar_b = chi * P1_im / N; /* fact: theta_form.qbar_b; (18), (25) */
    const float common_4 = -epsilon * sigma * chi; /* fact: theta_form.qbar_d, definition attitude.q_0, definition attitude.q_a, definition attitude.q_b, definition attitude.q_d; (18), (25), (37) */
    const float qbar_d = common_4 * P1_re / N; /* fact: theta_form.qbar_d; (18), (25) */
    const float q_0_rounded = dd_rounded(q_0); /* arithmetic */
    const float q_a_rounded = dd_rounded(q_a); /* arithmetic */
    const float q_b_rounded = dd_rounded(q_b); /* arithmetic */
    const float q_d_rounded = dd_rounded(q_d); /* arithmetic */
    const float p_0 = fused(q_d_rounded, qbar_d, fused(q_b_rounded, qbar_b, fused(q_0_rounded, qbar_0, q_a_rounded * qbar_a))); /* fact: attitude.p_0; (37) */
    const float p_a = fused(epsilon, fused(q_d_rounded, qbar_b, -(q_b_rounded * qbar_d)), fused(q_a_rounded, qbar_0, -(q_0_rounded * qbar_a))); /* fact: attitude.p_a; (37) */
    const float p_b = fused(epsilon, fused(q_a_rounded, qbar_d, -(q_d_rounded * qbar_a)), fused(q_b_rounded, qbar_0, -(q_0_rounded * qbar_b))); /* fact: attitude.p_b; (37) */
    const float p_d = fused(epsilon, fused(q_b_rounded, qbar_a, -(q_a_rounded * qbar_b)), fused(q_d_rounded, qbar_0, -(q_0_rounded * qbar_d))); /* fact: attitude.p_d; (37) */
    const float over_N = 1.0f / sqrtf(2.0f * watson); /* classical: DLMF 20.7.14 */
    const float row_0_P4_re = over_N * p_0; /* fact: definition attitude.q_0; (37) */
    const float row_0_P4_im = over_N * -(p_a * sigma); /* fact: definition attitude.q_0; (37) */
    const float row_0_P1_re = over_N * -(p_d * common_4); /* fact: definition attitude.q_0; (37) */
    const float row_0_P1_im = over_N * -(p_b * chi); /* fact: definition attitude.q_0; (37) */
    const float row_a_P4_re = over_N * p_a; /* fact: definition attitude.q_a; (37) */
    const float row_a_P4_im = over_N * (p_0 * sigma); /* fact: definition attitude.q_a; (37) */
    const float row_a_P1_re = over_N * (epsilon * (p_b * common_4)); /* fact: definition attitude.q_a; (37) */
    const float row_a_P1_im = over_N * (epsilon * -(p_d * chi)); /* fact: definition attitude.q_a; (37) */
    const float row_b_P4_re = over_N * p_b; /* fact: definition attitude.q_b; (37) */
    const float row_b_P4_im = over_N * (epsilon * (p_d * sigma)); /* fact: definition attitude.q_b; (37) */
    const float row_b_P1_re = over_N * (epsilon * -(p_a * common_4)); /* fact: definition attitude.q_b; (37) */
    const float row_b_P1_im = over_N * (p_0 * chi); /* fact: definition attitude.q_b; (37) */
    const float row_d_P4_re = over_N * p_d; /* fact: definition attitude.q_d; (37) */
    const float row_d_P4_im = over_N * (epsilon * -(p_b * sigma)); /* fact: definition attitude.q_d; (37) */
    const float row_d_P1_re = over_N * (p_0 * common_4); /* fact: definition attitude.q_d; (37) */
    const float row_d_P1_im = over_N * (epsilon * (p_a * chi)); /* fact: definition attitude.q_d; (37) */
    const float tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
    const float A_a_rounded = dd_rounded(A_a); /* arithmetic */
    const float gain_a = sigma * A_a_rounded * (two / three) * unit; /* fact: definition regular.Omega_a; (10), DLMF 22.2.4 */
    const float A_b_rounded = dd_rounded(A_b); /* arithmetic */
    const float gain_b = chi * A_b_rounded * (three / four) * unit; /* fact: definition regular.Omega_b; (10), DLMF 22.2.4 */
    const float A_d_rounded = dd_rounded(A_d); /* arithmetic */
    const float gain_d = chi * tau * A_d_rounded * (two / four) * unit; /* fact: definition regular.Omega_d; (10), DLMF 22.2.4 */
    motion->y_rate_hi = y_rate.hi;
    motion->y_rate_lo = y_rate.lo;
    motion->y0_hi = y0.hi;
    motion->y0_lo = y0.lo;
    motion->period_hi = period.hi;
    motion->period_lo = period.lo;
    motion->Lambda_rate_hi = Lambda_rate.hi;
    motion->Lambda_rate_lo = Lambda_rate.lo;
    motion->jump_hi = jump.hi;
    motion->jump_lo = jump.lo;
    motion->period_far = period_far;
    motion->period_inverse = period_inverse;
    motion->re_0 = re_0;
    motion->re_1 = re_1;
    motion->re_2 = re_2;
    motion->im_0 = im_0;
    motion->im_1 = im_1;
    motion->im_2 = im_2;
    motion->nome = dd_rounded(nome);
    motion->nome2 = dd_rounded(nome2);
    motion->nome4 = dd_rounded(nome4);
    motion->row_0_P4_re = row_0_P4_re;
    motion->row_0_P4_im = row_0_P4_im;
    motion->row_0_P1_re = row_0_P1_re;
    motion->row_0_P1_im = row_0_P1_im;
    motion->row_a_P4_re = row_a_P4_re;
    motion->row_a_P4_im = row_a_P4_im;
    motion->row_a_P1_re = row_a_P1_re;
    motion->row_a_P1_im = row_a_P1_im;
    motion->row_b_P4_re = row_b_P4_re;
    motion->row_b_P4_im = row_b_P4_im;
    motion->row_b_P1_re = row_b_P1_re;
    motion->row_b_P1_im = row_b_P1_im;
    motion->row_d_P4_re = row_d_P4_re;
    motion->row_d_P4_im = row_d_P4_im;
    motion->row_d_P1_re = row_d_P1_re;
    motion->row_d_P1_im = row_d_P1_im;
    motion->gain_a = gain_a;
    motion->gain_b = gain_b;
    motion->gain_d = gain_d;
}

/* Angles of the hyperbolic branch at t + t_lo. */
static void hyperbolic_angles(const torque_free_single_hyperbolic *motion, float t, float t_lo,
    float *w_out, float *p_out, float *side_out, float *flip_out, float *X_im_out,
    float *X_re_out)
{
    const float y_rate_hi = motion->y_rate_hi;
    const float y_rate_lo = motion->y_rate_lo;
    const float y0_hi = motion->y0_hi;
    const float y0_lo = motion->y0_lo;
    const float period_hi = motion->period_hi;
    const float period_lo = motion->period_lo;
    const float Lambda_rate_hi = motion->Lambda_rate_hi;
    const float Lambda_rate_lo = motion->Lambda_rate_lo;
    const float jump_hi = motion->jump_hi;
    const float jump_lo = motion->jump_lo;
    const float period_far = motion->period_far;
    const float period_inverse = motion->period_inverse;
    const float p_y = y_rate_hi * t; /* arithmetic: Dekker 1971 */
    const float p_y_error = product_error(y_rate_hi, t, p_y) + fused(y_rate_lo, t, fused(y_rate_hi, t_lo, y0_lo)); /* arithmetic: Dekker 1971 */
    const float periods = nearest((p_y + y0_hi) * period_inverse); /* classical: DLMF 20.2.7 */
    const float back = period_hi * periods; /* arithmetic: Dekker 1971 */
    const float back_error = fused(period_lo, periods, product_error(period_hi, periods, back)); /* arithmetic: Dekker 1971 */
    const float ahead = p_y + -back; /* arithmetic: Knuth 4.2.2 */
    const float ahead_other = ahead - p_y; /* arithmetic: Knuth 4.2.2 */
    const float ahead_error = p_y - (ahead - ahead_other) + (-back - ahead_other); /* arithmetic: Knuth 4.2.2 */
    const float y_near = ahead + y0_hi; /* arithmetic: Knuth 4.2.2 */
    const float y_near_other = y_near - ahead; /* arithmetic: Knuth 4.2.2 */
    const float y_near_error = ahead - (y_near - y_near_other) + (y0_hi - y_near_other); /* arithmetic: Knuth 4.2.2 */
    const float y = y_near + (y_near_error + (ahead_error + (p_y_error - back_error))); /* classical: DLMF 20.2.7 */
    const float side = choose(0.0f, y, 1.0f, -1.0f); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float flip = alternating(periods); /* classical: DLMF 20.2.6 */
    const float depth = fabsf(2.0f * y); /* classical: DLMF 20.2.2 */
    const float w = exponential(-depth); /* classical: DLMF 20.2.2 */
    const float p = exponential(depth - period_far); /* classical: DLMF 20.2.2 */
    const float L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
    const float L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
    const float L_whole = nearest(L); /* classical: DLMF 4.16 */
    const float L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float j = jump_hi * periods; /* arithmetic: Dekker 1971 */
    const float j_error = fused(jump_lo, periods, product_error(jump_hi, periods, j)); /* arithmetic: Dekker 1971 */
    const float j_whole = nearest(j); /* classical: DLMF 4.16 */
    const float j_rest = j - j_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float turned = L_rest + j_rest; /* arithmetic: Knuth 4.2.2 */
    const float turned_other = turned - L_rest; /* arithmetic: Knuth 4.2.2 */
    const float turned_error = L_rest - (turned - turned_other) + (j_rest - turned_other); /* arithmetic: Knuth 4.2.2 */
    const float turned_whole = nearest(turned); /* classical: DLMF 4.16 */
    const float turned_rest = turned - turned_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float turns = turned_rest + (turned_error + (L_error + j_error)); /* classical: DLMF 4.16 */
    const float whole = L_whole + (j_whole + turned_whole); /* classical: DLMF 4.16 */
    const float L_square = turns * turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
    const float L_sign = alternating(whole); /* classical: DLMF 4.16 */
    const float X_im = L_sign * fused(turns, pi_hi, turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_4, sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
    const float X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_4, cosine_3), cosine_2), cosine_1), cosine_0), 1.0f); /* classical: DLMF 4.19.2 */
    *w_out = w;
    *p_out = p;
    *side_out = side;
    *flip_out = flip;
    *X_im_out = X_im;
    *X_re_out = X_re;
}

/* The state on the hyperbolic branch, from `_hyperbolic_angles`. */
static void hyperbolic_state(const torque_free_single_hyperbolic *motion, float w, float p,
    float side, float flip, float X_im, float X_re, float *q_0_out, float *q_a_out,
    float *q_b_out, float *q_d_out, float *Omega_a_out, float *Omega_b_out, float *Omega_d_out)
{
    const float re_0 = motion->re_0;
    const float re_1 = motion->re_1;
    const float re_2 = motion->re_2;
    const float im_0 = motion->im_0;
    const float im_1 = motion->im_1;
    const float im_2 = motion->im_2;
    const float nome = motion->nome;
    const float nome2 = motion->nome2;
    const float nome4 = motion->nome4;
    const float row_0_P4_re = motion->row_0_P4_re;
    const float row_0_P4_im = motion->row_0_P4_im;
    const float row_0_P1_re = motion->row_0_P1_re;
    const float row_0_P1_im = motion->row_0_P1_im;
    const float row_a_P4_re = motion->row_a_P4_re;
    const float row_a_P4_im = motion->row_a_P4_im;
    const float row_a_P1_re = motion->row_a_P1_re;
    const float row_a_P1_im = motion->row_a_P1_im;
    const float row_b_P4_re = motion->row_b_P4_re;
    const float row_b_P4_im = motion->row_b_P4_im;
    const float row_b_P1_re = motion->row_b_P1_re;
    const float row_b_P1_im = motion->row_b_P1_im;
    const float row_d_P4_re = motion->row_d_P4_re;
    const float row_d_P4_im = motion->row_d_P4_im;
    const float row_d_P1_re = motion->row_d_P1_re;
    const float row_d_P1_im = motion->row_d_P1_im;
    const float gain_a = motion->gain_a;
    const float gain_b = motion->gain_b;
    const float gain_d = motion->gain_d;
    const float p2 = p * p; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float qw = nome * w; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float qw2 = qw * qw; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_re_even = fused(p2, re_2, re_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_re_odd = p * re_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_re_even = fused(qw2, re_2, re_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_re_odd = qw * re_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_im_even = fused(p2, im_2, im_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float near_im_odd = p * im_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_im_even = fused(qw2, im_2, im_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float far_im_odd = qw * im_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float T4_re = fused(w, far_re_even + far_re_odd, near_re_even + near_re_odd); /* classical: DLMF 20.2.2 */
    const float T4_im = side * fused(-w, far_im_even + far_im_odd, near_im_even + near_im_odd); /* classical: DLMF 20.2.2 */
    const float T1_re = side * fused(-w, far_re_even - far_re_odd, near_re_even - near_re_odd); /* classical: DLMF 20.2.1 */
    const float T1_im = fused(w, far_im_even - far_im_odd, near_im_even - near_im_odd); /* classical: DLMF 20.2.1 */
    const float w2 = w * w; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const float common_1 = p2 * nome2; /* classical: DLMF 20.2.2, DLMF 20.2.1 */
    const float tall = 1.0f + common_1; /* classical: DLMF 20.2.2 */
    const float common_2 = qw2 * nome2; /* classical: DLMF 20.2.2, DLMF 20.2.1 */
    const float deep = w2 * (1.0f + common_2); /* classical: DLMF 20.2.2 */
    const float theta2_y = tall + deep; /* classical: DLMF 20.2.2 */
    const float theta1_y = side * fused(-w2, 1.0f - common_2, 1.0f - common_1); /* classical: DLMF 20.2.1 */
    const float ends = fused(w2, nome2, p2); /* classical: DLMF 20.2.3 */
    const float middle = fused(nome4, p2 * p2, 1.0f); /* classical: DLMF 20.2.3 */
    const float theta3_y = 2.0f * (w * (middle + ends)); /* classical: DLMF 20.2.3 */
    const float theta4_y = 2.0f * (w * (middle - ends)); /* classical: DLMF 20.2.4 */
    const float P4_re = fused(X_re, T4_re, -(X_im * T4_im)); /* fact: definition theta_form.P4_re; (18) */
    const float P4_im = fused(X_re, T4_im, X_im * T4_re); /* fact: definition theta_form.P4_im; (18) */
    const float P1_re = fused(X_re, T1_re, -(X_im * T1_im)); /* fact: definition theta_form.P1_re; (18) */
    const float P1_im = fused(X_re, T1_im, X_im * T1_re); /* fact: definition theta_form.P1_im; (18) */
    const float over = 1.0f / theta2_y; /* arithmetic */
    const float scale = sqrtf(over); /* arithmetic */
    const float q_0 = scale * fused(row_0_P4_re, P4_re, fused(row_0_P4_im, P4_im, flip * fused(row_0_P1_re, P1_re, row_0_P1_im * P1_im))); /* fact: definition attitude.q_0; (37) */
    const float q_a = scale * fused(row_a_P4_re, P4_re, fused(row_a_P4_im, P4_im, flip * fused(row_a_P1_re, P1_re, row_a_P1_im * P1_im))); /* fact: definition attitude.q_a; (37) */
    const float q_b = scale * fused(row_b_P4_re, P4_re, fused(row_b_P4_im, P4_im, flip * fused(row_b_P1_re, P1_re, row_b_P1_im * P1_im))); /* fact: definition attitude.q_b; (37) */
    const float q_d = scale * fused(row_d_P4_re, P4_re, fused(row_d_P4_im, P4_im, flip * fused(row_d_P1_re, P1_re, row_d_P1_im * P1_im))); /* fact: definition attitude.q_d; (37) */
    const float Omega_a = gain_a * (theta3_y * over); /* fact: definition regular.Omega_a; (10) */
    const float Omega_b = gain_b * (flip * theta1_y * over); /* fact: definition regular.Omega_b; (10) */
    const float Omega_d = gain_d * (flip * theta4_y * over); /* fact: definition regular.Omega_d; (10) */
    *q_0_out = q_0;
    *q_a_out = q_a;
    *q_b_out = q_b;
    *q_d_out = q_d;
    *Omega_a_out = Omega_a;
    *Omega_b_out = Omega_b;
    *Omega_d_out = Omega_d;
}

/* The axis and the rate of a motion with constant rates. */
static void steady_constants(torque_free_pair Omega1, torque_free_pair Omega2, torque_free_pair Omega3,
    torque_free_pair p0, torque_free_pair p1, torque_free_pair p2, torque_free_pair p3,
    torque_free_single_steady *motion)
{
    const torque_free_pair omega = dd_sqrt(dd_add_xx(dd_add_xx(dd_mul_xx(Omega1, Omega1), dd_mul_xx(Omega2, Omega2)), dd_mul_xx(Omega3, Omega3))); /* fact: steady.omega; (3) */
    const float Omega1_rounded = dd_rounded(Omega1); /* arithmetic */
    const float omega_rounded = dd_rounded(omega); /* arithmetic */
    const float axis1 = Omega1_rounded / omega_rounded; /* fact: definition steady.axis1; (3) */
    const float Omega2_rounded = dd_rounded(Omega2); /* arithmetic */
    const float axis2 = Omega2_rounded / omega_rounded; /* fact: definition steady.axis2; (3) */
    const float Omega3_rounded = dd_rounded(Omega3); /* arithmetic */
    const float axis3 = Omega3_rounded / omega_rounded; /* fact: definition steady.axis3; (3) */
    const torque_free_pair Lambda_rate = dd_div_xx(omega, dd_mul_dx(2.0f, pi)); /* arithmetic */
    motion->Lambda_rate_hi = Lambda_rate.hi;
    motion->Lambda_rate_lo = Lambda_rate.lo;
    motion->axis1 = axis1;
    motion->axis2 = axis2;
    motion->axis3 = axis3;
    motion->p0 = dd_rounded(p0);
    motion->p1 = dd_rounded(p1);
    motion->p2 = dd_rounded(p2);
    motion->p3 = dd_rounded(p3);
}

/* Angles of the steady branch at t + t_lo. */
static void steady_angles(const torque_free_single_steady *motion, float t, float t_lo,
    float *X_im_out, float *X_re_out)
{
    const float Lambda_rate_hi = motion->Lambda_rate_hi;
    const float Lambda_rate_lo = motion->Lambda_rate_lo;
    const float L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
    const float L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
    const float L_whole = nearest(L); /* classical: DLMF 4.16 */
    const float L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float L_turns = L_rest + L_error; /* classical: DLMF 4.16 */
    const float L_square = L_turns * L_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
    const float L_sign = alternating(L_whole); /* classical: DLMF 4.16 */
    const float X_im = L_sign * fused(L_turns, pi_hi, L_turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_4, sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
    const float X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_4, cosine_3), cosine_2), cosine_1), cosine_0), 1.0f); /* classical: DLMF 4.19.2 */
    *X_im_out = X_im;
    *X_re_out = X_re;
}

/* The attitude from `_steady_angles`. */
static void steady_state(const torque_free_single_steady *motion, float X_im, float X_re,
    float *q0_out, float *q1_out, float *q2_out, float *q3_out)
{
    const float axis1 = motion->axis1;
    const float axis2 = motion->axis2;
    const float axis3 = motion->axis3;
    const float p0 = motion->p0;
    const float p1 = motion->p1;
    const float p2 = motion->p2;
    const float p3 = motion->p3;
    const float cos_half_theta = X_re; /* fact: reading steady.cos_half_theta; (3) */
    const float sin_half_theta = X_im; /* fact: reading steady.sin_half_theta; (3) */
    const float r1 = sin_half_theta * axis1; /* fact: definition steady.r1; (37) */
    const float r2 = sin_half_theta * axis2; /* fact: definition steady.r2; (37) */
    const float r3 = sin_half_theta * axis3; /* fact: definition steady.r3; (37) */
    const float q0 = fused(-p3, r3, fused(-p2, r2, fused(p0, cos_half_theta, -(p1 * r1)))); /* fact: definition steady.q0; (37) */
    const float q1 = fused(-p3, r2, fused(p2, r3, fused(p0, r1, p1 * cos_half_theta))); /* fact: definition steady.q1; (37) */
    const float q2 = fused(-p1, r3, fused(p3, r1, fused(p0, r2, p2 * cos_half_theta))); /* fact: definition steady.q2; (37) */
    const float q3 = fused(-p2, r1, fused(p1, r2, fused(p0, r3, p3 * cos_half_theta))); /* fact: definition steady.q3; (37) */
    *q0_out = q0;
    *q1_out = q1;
    *q2_out = q2;
    *q3_out = q3;
}

/* Return a float as an exact number. */
static exact exact_of(float a)
{
    exact x;
    x.count = 1;
    x.part[0] = a;
    return x;
}

/* Return the discriminant of floats, as a pair rounded from its exact value. */
static torque_free_pair exact_discriminant(float c_a, float c_b, float c_d, float Omega_a,
    float Omega_d)
{
    const exact above = exact_sub_xx(exact_of(c_a), exact_of(c_b));
    const exact below = exact_sub_xx(exact_of(c_b), exact_of(c_d));
    const exact E_b = discriminant_exact(exact_of(c_a), exact_of(c_d), above, below, exact_of(Omega_a), exact_of(Omega_d));
    torque_free_pair total = {0.0f, 0.0f};
    for (size_t i = 0; i < E_b.count; i++) {
        total = dd_add_xd(total, E_b.part[i]);
    }
    return total;
}

/* Return True if x > y. */
static int is_above(torque_free_pair x, torque_free_pair y)
{
    return x.hi > y.hi || (x.hi >= y.hi && x.lo > y.lo);
}

/* Return True for moments that a body can have, up to rounding. The largest is at most the sum of
   the others, or that sum as a float, or beyond it by 2^-50 of the smallest. */
static int can_exist(const torque_free_pair c[3])
{
    const int second = is_above(c[1], c[0]) ? 1 : 0;
    const int high = is_above(c[2], c[second]) ? 2 : second;
    const torque_free_pair one = c[(high + 1) % 3];
    const torque_free_pair other = c[(high + 2) % 3];
    const torque_free_pair most = c[high];
    const torque_free_pair total = dd_add_xx(one, other);
    const torque_free_pair beyond = two_sum(most.hi - total.hi, most.lo - total.lo);
    const float allowed = 4.76837158203125e-07f * (one.hi <= other.hi ? one.hi : other.hi);
    return ALLOW_NONPHYSICAL || most.hi < total.hi || (most.hi <= total.hi && most.lo <= 0.0f) || beyond.hi < allowed || (beyond.hi <= allowed && beyond.lo <= 0.0f);
}

/* Return True for zero of either sign. */
static int is_zero(float x)
{
    return !(x < 0.0f || x > 0.0f);
}

/* Return x 2^n, by `ldexp` where 2^n is no normal float. */
static float scaled_by(float x, int n)
{
    return n >= -126 && n <= 127 ? x * power_of_two((float)n) : ldexpf(x, n);
}

/* Return x 2^n. */
static torque_free_pair scaled(torque_free_pair x, int n)
{
    const torque_free_pair result = {scaled_by(x.hi, n), scaled_by(x.lo, n)};
    return result;
}

/* Return the exponent e of the largest size, so that x 2^-e is below 2; -1 for zeros. */
static int scale_of(float x, float y, float z)
{
    const float first = fabsf(x) >= fabsf(y) ? fabsf(x) : fabsf(y);
    const float largest = first >= fabsf(z) ? first : fabsf(z);
    return exponent_of(largest) - 1;
}

/* Return the exponent of a quaternion's largest component; -1 for zeros. */
static int scale_of_attitude(const float q[4])
{
    const float first = fabsf(q[0]) >= fabsf(q[1]) ? fabsf(q[0]) : fabsf(q[1]);
    return scale_of(first, q[2], q[3]);
}

/* Return x 2^n, or the least float of its sign where that is zero but x is not. */
static float scaled_rate(float x, int n)
{
    const float y = scaled_by(x, n);
    const float smallest = x < 0.0f ? -1.401298464324817e-45f : 1.401298464324817e-45f;
    return is_zero(y) && !is_zero(x) ? smallest : y;
}

/* Return the code of the first rule that finite numbers of a body break, or OK. c: the moments in
   inner units. */
static int broken_rule(const float inertia[3], const torque_free_pair c[3], const float attitude0[4])
{
    const float smaller = inertia[0] <= inertia[1] ? inertia[0] : inertia[1];
    const float smallest = smaller <= inertia[2] ? smaller : inertia[2];
    const float thinner = c[0].hi <= c[1].hi ? c[0].hi : c[1].hi;
    const float thinnest = thinner <= c[2].hi ? thinner : c[2].hi;
    const int no_attitude = is_zero(attitude0[0]) && is_zero(attitude0[1]) && is_zero(attitude0[2]) && is_zero(attitude0[3]);
    const int attitude = no_attitude ? TORQUE_FREE_SINGLE_ATTITUDE : TORQUE_FREE_SINGLE_OK;
    const int thin = thinnest < min_moment_ratio ? TORQUE_FREE_SINGLE_THIN : attitude;
    const int nonphysical = ALLOW_NONPHYSICAL || can_exist(c) ? thin : TORQUE_FREE_SINGLE_NONPHYSICAL;
    return smallest > 0.0f ? nonphysical : TORQUE_FREE_SINGLE_INERTIA;
}

/* Return a quaternion divided by its length. */
static void normalised(const torque_free_pair q[4], torque_free_pair *q_0_out, torque_free_pair *q_1_out,
    torque_free_pair *q_2_out, torque_free_pair *q_3_out)
{
    const torque_free_pair square = dd_add_xx(dd_add_xx(dd_add_xx(dd_mul_xx(q[0], q[0]), dd_mul_xx(q[1], q[1])), dd_mul_xx(q[2], q[2])), dd_mul_xx(q[3], q[3]));
    const torque_free_pair length = dd_sqrt(square);
    const torque_free_pair q_0 = dd_div_xx(q[0], length);
    const torque_free_pair q_1 = dd_div_xx(q[1], length);
    const torque_free_pair q_2 = dd_div_xx(q[2], length);
    const torque_free_pair q_3 = dd_div_xx(q[3], length);
    *q_0_out = q_0;
    *q_1_out = q_1;
    *q_2_out = q_2;
    *q_3_out = q_3;
}

/* Return a rate, or zero where it is negligible beside the largest. */
static torque_free_pair not_negligible(torque_free_pair rate)
{
    const torque_free_pair zero = {0.0f, 0.0f};
    return fabsf(rate.hi) < negligible ? zero : rate;
}

/* Return True if all rates are zero. */
static int is_at_rest(const torque_free_pair omega[3])
{
    return is_zero(omega[0].hi) && is_zero(omega[1].hi) && is_zero(omega[2].hi);
}

/* Return c_j - c_k of two different axes. */
static torque_free_pair difference(const torque_free_pair apart[3], int j, int k)
{
    return k == (j + 1) % 3 ? apart[j] : dd_neg(apart[k]);
}

/* Return two axes, that of the larger moment first; equal ones keep their order. */
static void ordered(const torque_free_pair apart[3], int j, int k, int *first_out,
    int *second_out)
{
    const int swaps = difference(apart, j, k).hi < 0.0f;
    const int first = swaps ? k : j;
    const int second = swaps ? j : k;
    *first_out = first;
    *second_out = second;
}

/* Return the axes by their moments, largest first; equal ones keep their order. */
static void sorted_axes(const torque_free_pair apart[3], int *a_out, int *b_out, int *d_out)
{
    int one;
    int other;
    ordered(apart, 0, 1, &one, &other);
    int rest;
    int d;
    ordered(apart, other, 2, &rest, &d);
    int a;
    int b;
    ordered(apart, one, rest, &a, &b);
    *a_out = a;
    *b_out = b;
    *d_out = d;
}

/* Return 0 for zero, else 1. */
static float mark(torque_free_pair x)
{
    return is_zero(x.hi) ? 0.0f : 1.0f;
}

/* Return 1 or -1 where a is the axis of largest or smallest moment, 0 where rates are constant. The
   axes are sorted by their moments. */
static float side_of(const torque_free_pair apart[3], const torque_free_pair omega[3], int a, int b,
    int d, float E_b)
{
    return circulation(mark(difference(apart, a, b)), mark(difference(apart, a, d)), mark(difference(apart, b, d)), mark(omega[a]), mark(omega[b]), mark(omega[d]), E_b);
}

/* Return E_b to all digits of a pair, from exact arithmetic where its terms cancel. */
static torque_free_pair discriminant_of(const torque_free_pair c[3], const torque_free_pair apart[3],
    const torque_free_pair omega[3], int a, int b, int d)
{
    const torque_free_pair c_ab = difference(apart, a, b);
    const torque_free_pair c_bd = difference(apart, b, d);
    const torque_free_pair zero = {0.0f, 0.0f};
    const int scale = scale_of(omega[a].hi, omega[d].hi, 0.0f);
    const torque_free_pair rate_a = scaled(omega[a], -scale);
    const torque_free_pair rate_d = scaled(omega[d], -scale);
    const torque_free_pair over = discriminant_dd(c[a], c[d], c_ab, c_bd, rate_a, zero);
    const torque_free_pair under = discriminant_dd(c[a], c[d], c_ab, c_bd, zero, rate_d);
    torque_free_pair E_b = dd_add_xx(over, under);
    if (!(fabsf(E_b.hi) > (over.hi - under.hi) / 1024.0f) && !is_zero(over.hi)) {
        E_b = exact_discriminant(c[a].hi, c[b].hi, c[d].hi, rate_a.hi, rate_d.hi);
    }
    return scaled(E_b, 2 * scale);
}

/* Return log2(x), x >= 0, without an exception for zero. */
static float log2_of(float x)
{
    return x > 0.0f ? log2f(x) : -HUGE_VALF;
}

/* Return log2(2^x + 2^y); both may be minus infinity. */
static float log2_sum(float x, float y)
{
    const float most = x >= y ? x : y;
    const float other = x <= y ? x : y;
    return isfinite(most) ? most + log2f(1.0f + exp2f(other - most)) : most;
}

/* Return whether a motion is replaced by another, whether by spin, and its last time. A separatrix
   motion replaces a motion whose E_b is too faint. Spin about the middle axis replaces a motion for
   which rates taken for zero could decide when that spin turns over. The last time is that up to
   which the replacement is close enough. With X = sqrt(c_a |c_a - c_b|) Omega_a, Z = sqrt(c_d |c_b
   - c_d|) Omega_d Euler's equations are X' = k Omega_b Z, Z' = k Omega_b X, up to signs. So X + Z
   and X - Z, whose product is E_b, grow no faster than exp(lambda t), where lambda is k times the
   largest |Omega_b|. One of them is zero on the separatrix, and both are zero in spin. Those that
   are not zero may grow to the share `tolerated` of the momentum. Logarithms have base 2: the
   numbers themselves leave the range of binary32. */
static void follow(const torque_free_pair c[3], const torque_free_pair apart[3],
    const torque_free_pair given[3], const torque_free_pair omega[3], int a, int b, int d, float E_b,
    int is_faint, int *follows_out, int *spins_out, float *last_out)
{
    const float c_a = c[a].hi;
    const float c_b = c[b].hi;
    const float c_d = c[d].hi;
    const float rate_b = given[b].hi;
    const float rate_d = given[d].hi;
    const float over = fabsf(difference(apart, a, b).hi);
    const float under = fabsf(difference(apart, b, d).hi);
    const float largest = c_a >= c_d ? c_a : c_d;
    const float smallest = c_a <= c_d ? c_a : c_d;
    const float weight_a = 0.5f * log2_of(c_a * over);
    const float weight_d = 0.5f * log2_of(c_d * under);
    const float part_a = weight_a + log2_of(fabsf(given[a].hi));
    const float part_d = weight_d + log2_of(fabsf(rate_d));
    const int loses_a = is_zero(omega[a].hi);
    const int loses_d = is_zero(omega[d].hi);
    const float gone = log2_sum(loses_a ? part_a : -HUGE_VALF, loses_d ? part_d : -HUGE_VALF);
    const float left = log2_sum(loses_a ? -HUGE_VALF : part_a, loses_d ? -HUGE_VALF : part_d);
    const float momentum_0 = c[0].hi * fabsf(given[0].hi);
    const float momentum_1 = c[1].hi * fabsf(given[1].hi);
    const float momentum_2 = c[2].hi * fabsf(given[2].hi);
    const float larger = momentum_0 >= momentum_1 ? momentum_0 : momentum_1;
    const float momentum = larger >= momentum_2 ? larger : momentum_2;
    const float whole = log2_sum(part_a, part_d);
    const float distance = log2_of(fabsf(E_b));
    const int spins = gone > left + log2f(decisive) || (is_faint && distance > 2.0f * whole + log2f(decisive));
    const float growth = sqrtf(over / c_a * (under / c_d) * (rate_b * rate_b) + under / c_b * ((over + under) / c_a) * (rate_d * rate_d));
    const float speed = log2_of(growth) + log2f(smallest / largest);
    const float slow = 0.0f <= speed ? 0.0f : speed;
    const float room = (weight_a <= weight_d ? weight_a : weight_d) + log2f(momentum / largest) + slow - (spins ? whole : distance - whole);
    const float doublings = log2f(tolerated) + room;
    const float until = doublings > 0.0f ? logf(2.0f) * doublings / growth : 0.0f;
    const float close = until <= max_angle ? until : max_angle;
    const int follows = spins || is_faint;
    const float last = follows ? close : max_angle;
    *follows_out = follows;
    *spins_out = spins;
    *last_out = last;
}

/* Return a motion's last time, and the rates and E_b that it is computed from until then. given:
   the rates; omega: the same but for negligible ones, which are zero. */
static void course(const torque_free_pair c[3], const torque_free_pair apart[3],
    const torque_free_pair given[3], const torque_free_pair omega[3], int a, int b, int d,
    torque_free_pair E_b, float *last_out, torque_free_pair *omega_0_out, torque_free_pair *omega_1_out,
    torque_free_pair *omega_2_out, torque_free_pair *found_out)
{
    const int is_asymmetric = !(is_zero(apart[0].hi) || is_zero(apart[1].hi) || is_zero(apart[2].hi));
    const int is_faint = !is_zero(E_b.hi) && fabsf(E_b.hi) < min_discriminant;
    const int loses_a = is_zero(omega[a].hi) && !is_zero(given[a].hi);
    const int loses_d = is_zero(omega[d].hi) && !is_zero(given[d].hi);
    const torque_free_pair zero = {0.0f, 0.0f};
    int follows = 0;
    int spins = 0;
    float last = max_angle;
    if (is_asymmetric && (is_faint || loses_a || loses_d)) {
        follow(c, apart, given, omega, a, b, d, E_b.hi, is_faint, &follows, &spins, &last);
    }
    const torque_free_pair omega_0 = spins && b != 0 ? zero : omega[0];
    const torque_free_pair omega_1 = spins && b != 1 ? zero : omega[1];
    const torque_free_pair omega_2 = spins && b != 2 ? zero : omega[2];
    const torque_free_pair found = follows ? zero : E_b;
    *last_out = last;
    *omega_0_out = omega_0;
    *omega_1_out = omega_1;
    *omega_2_out = omega_2;
    *found_out = found;
}

/* Return the last time, earlier for nonphysical bodies that speed up a lot after t = 0. */
static float limit(float last, float rate, float other)
{
    const float larger = fabsf(rate) >= fabsf(other) ? fabsf(rate) : fabsf(other);
    const float largest = larger >= 16.0f ? larger : 16.0f;
    const float earlier = 16.0f * max_angle / largest;
    return last <= earlier ? last : earlier;
}

/* Return True if no rate, up to its amplitude, overflows. */
static int is_held(float unit, float A_a, float A_b, float A_d)
{
    return A_a * unit <= max_rate && A_b * unit <= max_rate && A_d * unit <= max_rate;
}

/* Return True if n floats are finite. */
static int all_finite(size_t n, const float *restrict x)
{
    for (size_t k = 0; k < n; k++) {
        if (!isfinite(x[k])) {
            return 0;
        }
    }
    return 1;
}

/* Compute the constants of a motion with constant rates. */
static void steady_init(torque_free_single_motion *motion, const torque_free_pair omega[3],
    const torque_free_pair q[4])
{
    const int at_rest = is_at_rest(omega);
    const torque_free_pair one = {1.0f, 0.0f};
    const torque_free_pair first = at_rest ? one : omega[0];
    steady_constants(first, omega[1], omega[2], q[0], q[1], q[2], q[3], &motion->of.steady);
    if (at_rest) {
        motion->unit = 0.0f;
        motion->of.steady.Lambda_rate_hi = 0.0f;
        motion->of.steady.Lambda_rate_lo = 0.0f;
    }
}

/* Compute the constants of a motion whose rates change; return True if binary32 holds them. */
static int branch_init(torque_free_single_motion *motion, torque_free_pair c_a, torque_free_pair c_b,
    torque_free_pair c_d, torque_free_pair c_ab, torque_free_pair c_ad, torque_free_pair c_bd,
    torque_free_pair Omega_a, torque_free_pair Omega_b, torque_free_pair Omega_d, torque_free_pair E_b,
    torque_free_pair q_0, torque_free_pair q_a, torque_free_pair q_b, torque_free_pair q_d, float axis_a,
    float axis_b, float axis_d, float unit)
{
    torque_free_pair K;
    torque_free_pair A_a;
    torque_free_pair A_b;
    torque_free_pair A_d;
    torque_free_pair B_a;
    torque_free_pair B_d;
    torque_free_pair k_1;
    torque_free_pair kc_1;
    torque_free_pair mu;
    torque_free_pair psi_0;
    torque_free_pair s;
    torque_free_pair c;
    torque_free_pair d;
    float epsilon;
    float sigma;
    float rho;
    float chi;
    initial_state(c_a, c_b, c_d, c_ab, c_ad, c_bd, Omega_a, Omega_b, Omega_d, E_b, axis_a, axis_b, axis_d, &K, &A_a, &A_b, &A_d, &B_a, &B_d, &k_1, &kc_1, &mu, &psi_0, &s, &c, &d, &epsilon, &sigma, &rho, &chi);
    /* Constants are far from the largest numbers: their sum is finite where all are. */
    float sum = 0.0f;
    if (k_1.hi * k_1.hi <= max_circular) {
        motion->branch = 1;
        circular_constants(K, A_a, A_b, A_d, B_a, B_d, k_1, kc_1, mu, psi_0, s, c, d, q_0, q_a, q_b, q_d, epsilon, sigma, rho, chi, unit, &motion->of.circular);
        sum += motion->of.circular.v_rate_hi;
        sum += motion->of.circular.v_rate_lo;
        sum += motion->of.circular.v_hi;
        sum += motion->of.circular.v_lo;
        sum += motion->of.circular.Lambda_rate_hi;
        sum += motion->of.circular.Lambda_rate_lo;
        sum += motion->of.circular.T4_re_0;
        sum += motion->of.circular.T4_re_1;
        sum += motion->of.circular.T4_re_2;
        sum += motion->of.circular.T4_im_0;
        sum += motion->of.circular.T4_im_1;
        sum += motion->of.circular.T1_re_0;
        sum += motion->of.circular.T1_re_1;
        sum += motion->of.circular.T1_re_2;
        sum += motion->of.circular.T1_im_0;
        sum += motion->of.circular.T1_im_1;
        sum += motion->of.circular.T1_im_2;
        sum += motion->of.circular.even_0;
        sum += motion->of.circular.even_1;
        sum += motion->of.circular.odd_0;
        sum += motion->of.circular.odd_1;
        sum += motion->of.circular.sine_even_0;
        sum += motion->of.circular.sine_even_1;
        sum += motion->of.circular.sine_odd_0;
        sum += motion->of.circular.sine_odd_1;
        sum += motion->of.circular.row_0_P4_re;
        sum += motion->of.circular.row_0_P4_im;
        sum += motion->of.circular.row_0_P1_re;
        sum += motion->of.circular.row_0_P1_im;
        sum += motion->of.circular.row_a_P4_re;
        sum += motion->of.circular.row_a_P4_im;
        sum += motion->of.circular.row_a_P1_re;
        sum += motion->of.circular.row_a_P1_im;
        sum += motion->of.circular.row_b_P4_re;
        sum += motion->of.circular.row_b_P4_im;
        sum += motion->of.circular.row_b_P1_re;
        sum += motion->of.circular.row_b_P1_im;
        sum += motion->of.circular.row_d_P4_re;
        sum += motion->of.circular.row_d_P4_im;
        sum += motion->of.circular.row_d_P1_re;
        sum += motion->of.circular.row_d_P1_im;
        sum += motion->of.circular.gain_a;
        sum += motion->of.circular.gain_b;
        sum += motion->of.circular.gain_d;
        motion->max_angle = limit(motion->max_angle, motion->of.circular.v_rate_hi, motion->of.circular.Lambda_rate_hi);
    } else {
        motion->branch = 2;
        hyperbolic_constants(K, A_a, A_b, A_d, B_a, B_d, k_1, kc_1, mu, psi_0, s, c, q_0, q_a, q_b, q_d, epsilon, sigma, rho, chi, unit, &motion->of.hyperbolic);
        sum += motion->of.hyperbolic.y_rate_hi;
        sum += motion->of.hyperbolic.y_rate_lo;
        sum += motion->of.hyperbolic.y0_hi;
        sum += motion->of.hyperbolic.y0_lo;
        sum += motion->of.hyperbolic.period_hi;
        sum += motion->of.hyperbolic.period_lo;
        sum += motion->of.hyperbolic.Lambda_rate_hi;
        sum += motion->of.hyperbolic.Lambda_rate_lo;
        sum += motion->of.hyperbolic.jump_hi;
        sum += motion->of.hyperbolic.jump_lo;
        sum += motion->of.hyperbolic.period_far;
        sum += motion->of.hyperbolic.period_inverse;
        sum += motion->of.hyperbolic.re_0;
        sum += motion->of.hyperbolic.re_1;
        sum += motion->of.hyperbolic.re_2;
        sum += motion->of.hyperbolic.im_0;
        sum += motion->of.hyperbolic.im_1;
        sum += motion->of.hyperbolic.im_2;
        sum += motion->of.hyperbolic.nome;
        sum += motion->of.hyperbolic.nome2;
        sum += motion->of.hyperbolic.nome4;
        sum += motion->of.hyperbolic.row_0_P4_re;
        sum += motion->of.hyperbolic.row_0_P4_im;
        sum += motion->of.hyperbolic.row_0_P1_re;
        sum += motion->of.hyperbolic.row_0_P1_im;
        sum += motion->of.hyperbolic.row_a_P4_re;
        sum += motion->of.hyperbolic.row_a_P4_im;
        sum += motion->of.hyperbolic.row_a_P1_re;
        sum += motion->of.hyperbolic.row_a_P1_im;
        sum += motion->of.hyperbolic.row_b_P4_re;
        sum += motion->of.hyperbolic.row_b_P4_im;
        sum += motion->of.hyperbolic.row_b_P1_re;
        sum += motion->of.hyperbolic.row_b_P1_im;
        sum += motion->of.hyperbolic.row_d_P4_re;
        sum += motion->of.hyperbolic.row_d_P4_im;
        sum += motion->of.hyperbolic.row_d_P1_re;
        sum += motion->of.hyperbolic.row_d_P1_im;
        sum += motion->of.hyperbolic.gain_a;
        sum += motion->of.hyperbolic.gain_b;
        sum += motion->of.hyperbolic.gain_d;
        motion->max_angle = limit(motion->max_angle, motion->of.hyperbolic.y_rate_hi, motion->of.hyperbolic.Lambda_rate_hi);
    }
    return is_held(unit, A_a.hi, A_b.hi, A_d.hi) && isfinite(sum);
}

/* Compute the constants of a motion from numbers that were checked; return a code. c, apart
   (differences of each moment and the next in turn), the rates `given` and q are in inner units;
   known: E_b, where `is_known`. */
static int begun_motion(torque_free_single_motion *motion, const torque_free_pair c[3],
    const torque_free_pair apart[3], const torque_free_pair given[3], const torque_free_pair q[4],
    int is_known, torque_free_pair known, float unit)
{
    motion->unit = unit;
    torque_free_pair omega[3];
    for (size_t k = 0; k < 3; k++) {
        omega[k] = not_negligible(given[k]);
        motion->omega0[k] = given[k].hi * unit;
    }
    torque_free_pair turn[4];
    normalised(q, &turn[0], &turn[1], &turn[2], &turn[3]);
    for (size_t k = 0; k < 4; k++) {
        motion->q0[k] = dd_rounded(turn[k]);
    }
    int a;
    int b;
    int d;
    sorted_axes(apart, &a, &b, &d);
    torque_free_pair found = known;
    if (!is_known) {
        found = discriminant_of(c, apart, omega, a, b, d);
    }
    float last;
    torque_free_pair omega_0;
    torque_free_pair omega_1;
    torque_free_pair omega_2;
    torque_free_pair E_b;
    course(c, apart, given, omega, a, b, d, found, &last, &omega_0, &omega_1, &omega_2, &E_b);
    omega[0] = omega_0;
    omega[1] = omega_1;
    omega[2] = omega_2;
    motion->max_angle = last;
    motion->is_blurred = last < max_angle;
    const float side = side_of(apart, omega, a, b, d, E_b.hi);
    const int first = side < 0.0f ? d : a;
    const int third = side < 0.0f ? a : d;
    motion->axis[0] = first;
    motion->axis[1] = b;
    motion->axis[2] = third;
    motion->prepared = PREPARED;
    if (is_zero(side)) {
        motion->branch = 0;
        steady_init(motion, omega, turn);
        return TORQUE_FREE_SINGLE_OK;
    }
    const int fits = branch_init(motion, c[first], c[b], c[third], difference(apart, first, b), difference(apart, first, third), difference(apart, b, third), omega[first], omega[b], omega[third], E_b, turn[0], turn[1 + first], turn[1 + b], turn[1 + third], (float)first, (float)b, (float)third, unit);
    return fits ? TORQUE_FREE_SINGLE_OK : TORQUE_FREE_SINGLE_RATES;
}

int torque_free_single_motion_init(torque_free_single_motion *motion, const float inertia[3],
    const float omega0[3], const float attitude0[4])
{
    if (!(all_finite(3, inertia) && all_finite(3, omega0) && all_finite(4, attitude0))) {
        return TORQUE_FREE_SINGLE_NOT_FINITE;
    }
    const int c_scale = scale_of(inertia[0], inertia[1], inertia[2]);
    const int scale = scale_of(omega0[0], omega0[1], omega0[2]);
    const int q_scale = scale_of_attitude(attitude0);
    torque_free_pair c[3];
    torque_free_pair apart[3];
    torque_free_pair omega[3];
    torque_free_pair q[4];
    for (size_t k = 0; k < 3; k++) {
        c[k].hi = scaled_by(inertia[k], -c_scale);
        c[k].lo = 0.0f;
        omega[k].hi = scaled_rate(omega0[k], -scale);
        omega[k].lo = 0.0f;
    }
    for (size_t k = 0; k < 4; k++) {
        q[k].hi = scaled_by(attitude0[k], -q_scale);
        q[k].lo = 0.0f;
    }
    /* Differences of floats are pairs exactly. */
    for (size_t k = 0; k < 3; k++) {
        apart[k] = two_sum(c[k].hi, -c[(k + 1) % 3].hi);
    }
    int code = broken_rule(inertia, c, attitude0);
    if (code != TORQUE_FREE_SINGLE_OK) {
        return code;
    }
    torque_free_single_motion made;
    memset(&made, 0, sizeof(torque_free_single_motion));
    code = begun_motion(&made, c, apart, omega, q, 0, q[0], scaled_by(1.0f, scale));
    if (code != TORQUE_FREE_SINGLE_OK) {
        return code;
    }
    memcpy(made.omega0, omega0, 3 * sizeof(float));
    *motion = made;
    return TORQUE_FREE_SINGLE_OK;
}

/* Write the state at the inner time t + t_lo. */
static void state_after(const torque_free_single_motion *motion, float t, float t_lo, float q[4],
    float omega[3])
{
    if (motion->branch == 0) {
        float X_im;
        float X_re;
        steady_angles(&motion->of.steady, t, t_lo, &X_im, &X_re);
        steady_state(&motion->of.steady, X_im, X_re, &q[0], &q[1], &q[2], &q[3]);
        memcpy(omega, motion->omega0, 3 * sizeof(float));
        return;
    }
    const int first = motion->axis[0];
    const int second = motion->axis[1];
    const int third = motion->axis[2];
    if (motion->branch == 1) {
        float sin_v;
        float cos_v;
        float X_im;
        float X_re;
        circular_angles(&motion->of.circular, t, t_lo, &sin_v, &cos_v, &X_im, &X_re);
        circular_state(&motion->of.circular, sin_v, cos_v, X_im, X_re, &q[0], &q[1 + first], &q[1 + second], &q[1 + third], &omega[first], &omega[second], &omega[third]);
    } else {
        float w;
        float p;
        float side;
        float flip;
        float X_im;
        float X_re;
        hyperbolic_angles(&motion->of.hyperbolic, t, t_lo, &w, &p, &side, &flip, &X_im, &X_re);
        hyperbolic_state(&motion->of.hyperbolic, w, p, side, flip, X_im, X_re, &q[0], &q[1 + first], &q[1 + second], &q[1 + third], &omega[first], &omega[second], &omega[third]);
    }
    const float rest = 0.5f * (1.0f - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
    for (size_t k = 0; k < 4; k++) {
        q[k] += q[k] * rest;
    }
}

/* Return True for a time at which a motion has no state. */
static int is_late(const torque_free_single_motion *motion, float t)
{
    return !(fabsf(motion->unit * t) <= motion->max_angle);
}

/* Return the code for times at which a motion has no states. */
static int refusal(const torque_free_single_motion *motion, int are_finite)
{
    if (!are_finite) {
        return TORQUE_FREE_SINGLE_NOT_FINITE;
    }
    return motion->is_blurred ? TORQUE_FREE_SINGLE_SEPARATRIX : TORQUE_FREE_SINGLE_TIME;
}

/* Write a state of NaN. */
static void no_state(float q[4], float omega[3])
{
    for (size_t k = 0; k < 4; k++) {
        q[k] = ((float)NAN);
    }
    for (size_t k = 0; k < 3; k++) {
        omega[k] = ((float)NAN);
    }
}

int torque_free_single_state_at_sum(const torque_free_single_motion *motion, float t, float t_lo,
    float q[4], float omega[3])
{
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_SINGLE_UNPREPARED;
    }
    if (is_late(motion, t)) {
        return refusal(motion, isfinite(t) && isfinite(t_lo));
    }
    if (!isfinite(t_lo)) {
        return TORQUE_FREE_SINGLE_NOT_FINITE;
    }
    if (is_zero(t) && is_zero(t_lo)) {
        memcpy(q, motion->q0, 4 * sizeof(float));
        memcpy(omega, motion->omega0, 3 * sizeof(float));
    } else {
        state_after(motion, motion->unit * t, motion->unit * t_lo, q, omega);
    }
    return TORQUE_FREE_SINGLE_OK;
}

int torque_free_single_state_at(const torque_free_single_motion *motion, float t, float q[4],
    float omega[3])
{
    return torque_free_single_state_at_sum(motion, t, 0.0f, q, omega);
}

/* Write the states at n times; late ones are refused, or states of NaN where `lenient`. */
static int unrefused_states(const torque_free_single_motion *motion, size_t n,
    const float *restrict t, float *restrict q, float *restrict omega, int lenient)
{
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_SINGLE_UNPREPARED;
    }
    int is_refused = 0;
    for (size_t i = 0; i < n; i++) {
        is_refused = is_refused || is_late(motion, t[i]);
    }
    const int code = is_refused ? refusal(motion, all_finite(n, t)) : TORQUE_FREE_SINGLE_OK;
    if (is_refused && !lenient) {
        return code;
    }
    for (size_t i = 0; i < n; i++) {
        if (torque_free_single_state_at(motion, t[i], q + 4 * i, omega + 3 * i) != TORQUE_FREE_SINGLE_OK) {
            no_state(q + 4 * i, omega + 3 * i);
        }
    }
    return code;
}

int torque_free_single_states_at(const torque_free_single_motion *motion, size_t n, const float *t,
    float *q, float *omega)
{
    return unrefused_states(motion, n, t, q, omega, 0);
}

float torque_free_single_last_time(const torque_free_single_motion *motion)
{
    if (motion->prepared != PREPARED) {
        return ((float)NAN);
    }
    if (!(motion->unit > 0.0f)) {
        return 3.4028234663852886e+38f;
    }
    const float last = motion->max_angle / motion->unit;
    return last <= 3.4028234663852886e+38f ? last : 3.4028234663852886e+38f;
}

const char *torque_free_single_digest(void)
{
    return "cf7e54c9024b4d0f6cae1783f2032969469bd293fac4613b0ec8fc2206505dfd";
}

