#include "torque_free_pi.h"

#include <float.h>
#include <math.h>
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

/* How many states are computed side by side; each takes about 240 bytes of stack on a grid. */
#ifndef TORQUE_FREE_PI_BLOCK
#define TORQUE_FREE_PI_BLOCK 64
#endif

/* How many motions are prepared side by side, or one in as many lanes: what a register holds, but
   one where roots that report errors keep loops from being vectorised.  What these call has to be
   in them, too, which takes seconds to compile, and is in vain where addresses are checked. */
#ifndef TORQUE_FREE_PI_LANES
#if !defined(__OPTIMIZE__) || !defined(__NO_MATH_ERRNO__)
#define TORQUE_FREE_PI_LANES 1
#elif defined(__AVX512F__)
#define TORQUE_FREE_PI_LANES 8
#elif defined(__AVX__)
#define TORQUE_FREE_PI_LANES 4
#elif defined(__aarch64__)
#define TORQUE_FREE_PI_LANES 2
#else
#define TORQUE_FREE_PI_LANES 1
#endif
#endif
#define LANES TORQUE_FREE_PI_LANES
#if LANES > 1 && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define FLAT __attribute__((flatten))
#else
#define FLAT
#endif

/* Extended numbers need every operation rounded to double once, and none reordered.  Not every option
   that breaks this shows in a macro: torque_free_pi_motion_init looks, too. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "torque_free.c: -ffast-math reorders sums that must not be; compile without it"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "torque_free.c: -ffinite-math-only takes the checks of inputs away; compile without it"
#elif defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)
#error "torque_free.c: sums must round to double; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#elif FLT_RADIX != 2 || DBL_MANT_DIG != 53
#error "torque_free.c: a double must be a binary64 number"
#endif
/* -fsingle-precision-constant has no macro: an array of negative size is no type. */
typedef char constants_must_be_doubles[sizeof 1.0 == sizeof(double) ? 1 : -1];
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

/* An extended number is the unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2.  The relative
   errors, with u = 2^-53, are those of Joldes, Muller and Popescu (ACM TOMS 44(2), 2017): 3 u^2 for
   sums, 5 u^2 for products, 15 u^2 for quotients; 25/8 u^2 for roots (Lefevre, Louvet, Muller, Picot
   and Rideau, ACM TOMS 49(1), 2023). */
typedef struct { double hi, lo; } double_double;

/* -DTORQUE_FREE_PI_FMA=0 computes without fused multiply-add, and so has the same bits on every processor;
   -DTORQUE_FREE_PI_FMA=1 computes with it, by the C library where the processor has none.  By default the
   faster one is chosen. */
#if defined(TORQUE_FREE_PI_FMA)
#define BITS_ARE_CHOSEN 1
#else
#define BITS_ARE_CHOSEN 0
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__)
#define TORQUE_FREE_PI_FMA 1
#else
#define TORQUE_FREE_PI_FMA 0
#endif
#endif
#if TORQUE_FREE_PI_FMA
#define fused(a, b, c) fma((a), (b), (c))
#define product_error(a, b, p) fma((a), (b), -(p))
#else
#define fused(a, b, c) ((a) * (b) + (c))

/* The upper half of the digits of a (Veltkamp); a must stay below 2^995. */
static INLINED double upper_half(double a)
{
    const double c = 134217729.0 * a;
    const double d = c - a;
    return c - d;
}

/* a b - p exactly, where p is the rounded product (Dekker). */
static INLINED double product_error(double a, double b, double p)
{
    const double a1 = upper_half(a), b1 = upper_half(b);
    const double a2 = a - a1, b2 = b - b1;
    const double e1 = a1 * b1 - p;
    const double e2 = e1 + a1 * b2;
    const double e3 = e2 + a2 * b1;
    return e3 + a2 * b2;
}
#endif

/* The nearest whole number, for |x| < 2^51. */
static INLINED double nearest(double x)
{
    const double shifted = x + 6755399441055744.0;
    return shifted - 6755399441055744.0;
}

/* Copies that compilers see through.  In n + 3 2^51 the last bits are those of the whole number n,
   |n| < 2^51. */
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

/* (-1)^n for a whole number n: its last bit becomes the sign of 1. */
static INLINED double alternating(double n)
{
    return from_bits(UINT64_C(0x3ff0000000000000) | bits_of(n + 6755399441055744.0) << 63);
}

/* 2^n for a whole number n between -1022 and 1023, from its bits. */
static INLINED double power_of_two(double n)
{
    return from_bits(bits_of(n + (6755399441055744.0 + 1023.0)) << 52);
}

/* one where x <= y, else other. */
static INLINED double choose(double x, double y, double one, double other)
{
    return x <= y ? one : other;
}

static INLINED double_double dd_of(double a)
{
    const double_double x = {a, 0.0};
    return x;
}

/* a + b exactly (Knuth). */
static INLINED double_double two_sum(double a, double b)
{
    const double s = a + b;
    const double c = s - a;
    const double d = s - c;
    const double_double x = {s, (a - d) + (b - c)};
    return x;
}

/* a + b exactly, for |a| >= |b| (Dekker). */
static INLINED double_double quick_sum(double a, double b)
{
    const double s = a + b;
    const double c = s - a;
    const double_double x = {s, b - c};
    return x;
}

/* a b exactly. */
static INLINED double_double two_product(double a, double b)
{
    const double p = a * b;
    const double_double x = {p, product_error(a, b, p)};
    return x;
}

static INLINED double_double dd_neg(double_double x)
{
    const double_double y = {-x.hi, -x.lo};
    return y;
}

static INLINED double_double dd_add_xx(double_double x, double_double y)
{
    const double_double s = two_sum(x.hi, y.hi), t = two_sum(x.lo, y.lo);
    const double_double v = quick_sum(s.hi, s.lo + t.hi);
    return quick_sum(v.hi, v.lo + t.lo);
}

static INLINED double_double dd_add_xd(double_double x, double y)
{
    const double_double s = two_sum(x.hi, y);
    return quick_sum(s.hi, s.lo + x.lo);
}

static INLINED double_double dd_add_dx(double x, double_double y) { return dd_add_xd(y, x); }
static INLINED double_double dd_sub_xx(double_double x, double_double y) { return dd_add_xx(x, dd_neg(y)); }
static INLINED double_double dd_sub_xd(double_double x, double y) { return dd_add_xd(x, -y); }
static INLINED double_double dd_sub_dx(double x, double_double y) { return dd_add_xd(dd_neg(y), x); }

static INLINED double_double dd_mul_xx(double_double x, double_double y)
{
    const double_double p = two_product(x.hi, y.hi);
    return quick_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

static INLINED double_double dd_mul_xd(double_double x, double y)
{
    const double_double p = two_product(x.hi, y);
    return quick_sum(p.hi, p.lo + x.lo * y);
}

static INLINED double_double dd_mul_dx(double x, double_double y) { return dd_mul_xd(y, x); }

static INLINED double_double dd_div_xx(double_double x, double_double y)
{
    const double q = x.hi / y.hi;
    const double_double r = dd_mul_xd(y, q);
    return quick_sum(q, ((x.hi - r.hi) + (x.lo - r.lo)) / y.hi);
}

static INLINED double_double dd_div_xd(double_double x, double y)
{
    const double q = x.hi / y;
    const double_double r = two_product(y, q);
    return quick_sum(q, ((x.hi - r.hi) + (x.lo - r.lo)) / y);
}

static INLINED double_double dd_div_dx(double x, double_double y) { return dd_div_xx(dd_of(x), y); }

static INLINED double_double dd_sqrt(double_double x)
{
    const double s = sqrt(x.hi);
    const double_double r = two_product(s, s);
    const double rest = (x.hi - r.hi) + (x.lo - r.lo);
    return quick_sum(s, s > 0.0 ? rest / (2.0 * s) : 0.0);
}

static INLINED double_double dd_size(double_double x) { return x.hi < 0.0 ? dd_neg(x) : x; }
static INLINED double dd_rounded(double_double x) { return x.hi + x.lo; }
static INLINED double_double dd_choose(double x, double y, double_double one, double_double other)
{
    return x <= y ? one : other;
}

/* x = mantissa 2^exponent with a mantissa between sqrt(1/2) and sqrt(2), nearly; x between 2^-1021 and
   2^1022, from its bits: first as a mantissa between 1/2 and 1. */
static INLINED double dd_exponent(double_double x)
{
    const uint64_t bits = bits_of(x.hi);
    const double fraction = from_bits((bits & UINT64_C(0x000fffffffffffff)) | UINT64_C(0x3fe0000000000000));
    const double e = from_bits(bits >> 52 | UINT64_C(0x4330000000000000)) - (4503599627370496.0 + 1022.0);
    return fraction < 0.70710678118654752 ? e - 1.0 : e;
}

static INLINED double_double dd_mantissa(double_double x)
{
    const double power = power_of_two(-dd_exponent(x));
    const double_double y = {x.hi * power, x.lo * power};
    return y;
}
/* An exact number is the sum of non-overlapping doubles, smallest first (Shewchuk, Discrete and
   Computational Geometry 18, 1997).  32 parts hold any value of `discriminant`. */
typedef struct { int size; double part[32]; } exact;

static void exact_grow(exact *x, double a)
{
    int size = 0;
    for (int i = 0; i < x->size; i++) {
        const double_double s = two_sum(a, x->part[i]);
        if (s.lo < 0.0 || s.lo > 0.0)
            x->part[size++] = s.lo;
        a = s.hi;
    }
    x->part[size++] = a;
    x->size = size;
}

static exact exact_of(double a)
{
    exact x = {1, {0.0}};
    x.part[0] = a;
    return x;
}

static exact exact_sub_xx(exact x, exact y)
{
    for (int i = 0; i < y.size; i++)
        exact_grow(&x, -y.part[i]);
    return x;
}

static exact exact_mul_xx(exact x, exact y)
{
    exact z = {0, {0.0}};
    for (int i = 0; i < x.size; i++)
        for (int j = 0; j < y.size; j++) {
            const double_double p = two_product(x.part[i], y.part[j]);
            exact_grow(&z, p.lo);
            exact_grow(&z, p.hi);
        }
    return z;
}

static double_double exact_to_dd(exact x)
{
    double_double sum = {0.0, 0.0};
    for (int i = 0; i < x.size; i++)
        sum = dd_add_xd(sum, x.part[i]);
    return sum;
}
static const double_double pi = {3.141592653589793, 1.2246467991473532e-16}; /* pi */
static const double pi_hi = 3.141592653589793; /* pi */
static const double pi_lo = 1.2246467991473532e-16; /* pi - pi_hi */
static const double_double log_2 = {0.6931471805599453, 2.3190468138462996e-17}; /* log_2 */
static const double never = 1e+300; /* an exponent that stands for infinity */
static const double_double over_3 = {0.3333333333333333, 1.850371707708594e-17}; /* 1/3 */
static const double_double over_5 = {0.2, -1.1102230246251566e-17}; /* 1/5 */
static const double_double over_7 = {0.14285714285714285, 7.93016446160826e-18}; /* 1/7 */
static const double_double over_9 = {0.1111111111111111, 6.1679056923619804e-18}; /* 1/9 */
static const double_double over_11 = {0.09090909090909091, -2.523234146875356e-18}; /* 1/11 */
static const double_double over_13 = {0.07692307692307693, -4.270088556250602e-18}; /* 1/13 */
static const double_double over_15 = {0.06666666666666667, 9.251858538542971e-19}; /* 1/15 */
static const double_double over_17 = {0.058823529411764705, 8.163404592832033e-19}; /* 1/17 */
static const double over_19 = 0.05263157894736842; /* 1/19 */
static const double over_21 = 0.047619047619047616; /* 1/21 */
static const double over_23 = 0.043478260869565216; /* 1/23 */
static const double over_25 = 0.04; /* 1/25 */
static const double over_27 = 0.037037037037037035; /* 1/27 */
static const double over_29 = 0.034482758620689655; /* 1/29 */
static const double over_31 = 0.03225806451612903; /* 1/31 */
static const double over_33 = 0.030303030303030304; /* 1/33 */
static const double sine_0 = -5.16771278004997; /* sin(pi f)/f, z^1 */
static const double sine_1 = 2.5501640398774312; /* sin(pi f)/f, z^2 */
static const double sine_2 = -0.5992645293260574; /* sin(pi f)/f, z^3 */
static const double sine_3 = 0.08214588673057224; /* sin(pi f)/f, z^4 */
static const double sine_4 = -0.007370432209249014; /* sin(pi f)/f, z^5 */
static const double sine_5 = 0.00046630937491450004; /* sin(pi f)/f, z^6 */
static const double sine_6 = -2.1930233242974144e-05; /* sin(pi f)/f, z^7 */
static const double sine_7 = 7.992431720329268e-07; /* sin(pi f)/f, z^8 */
static const double cosine_0 = -4.934802200544679; /* cos(pi f), z^1 */
static const double cosine_1 = 4.058712126416648; /* cos(pi f), z^2 */
static const double cosine_2 = -1.335262768846726; /* cos(pi f), z^3 */
static const double cosine_3 = 0.2353306301574239; /* cos(pi f), z^4 */
static const double cosine_4 = -0.025806888796526702; /* cos(pi f), z^5 */
static const double cosine_5 = 0.0019295558327461697; /* cos(pi f), z^6 */
static const double cosine_6 = -0.00010456397431434991; /* cos(pi f), z^7 */
static const double cosine_7 = 4.1457287175433435e-06; /* cos(pi f), z^8 */
static const double least = -708.0; /* e^x is taken for 0 below it */
static const double log_2_inverse = 1.4426950408889634; /* 1/log 2 */
static const double log_2_short = 0.6931471803691238; /* log 2, its first digits */
static const double log_2_rest = 1.9082149292705877e-10; /* log 2, the others */
static const double half = 0.5; /* 1/2 */
static const double exponential_0 = 0.16666666666666666; /* e^r, r^3 */
static const double exponential_1 = 0.04166666666665132; /* e^r, r^4 */
static const double exponential_2 = 0.008333333333332154; /* e^r, r^5 */
static const double exponential_3 = 0.0013888888905908563; /* e^r, r^6 */
static const double exponential_4 = 0.0001984126985435939; /* e^r, r^7 */
static const double exponential_5 = 2.4801536334724617e-05; /* e^r, r^8 */
static const double exponential_6 = 2.7557280025515365e-06; /* e^r, r^9 */
static const double exponential_7 = 2.7613836801372293e-07; /* e^r, r^10 */
static const double exponential_8 = 2.509557770167194e-08; /* e^r, r^11 */
static const double deepest = 100.0; /* beyond it tanh is 1 and sech is 0 */
static const double least_c = 1e-45; /* stands for sech where that is 0 */

typedef struct {
    double c_a_hi[LANES];
    double c_a_lo[LANES];
    double c_b_hi[LANES];
    double c_b_lo[LANES];
    double c_d_hi[LANES];
    double c_d_lo[LANES];
    double c_ab_hi[LANES];
    double c_ab_lo[LANES];
    double c_ad_hi[LANES];
    double c_ad_lo[LANES];
    double c_bd_hi[LANES];
    double c_bd_lo[LANES];
    double Omega_a_hi[LANES];
    double Omega_a_lo[LANES];
    double Omega_b_hi[LANES];
    double Omega_b_lo[LANES];
    double Omega_d_hi[LANES];
    double Omega_d_lo[LANES];
    double E_b_hi[LANES];
    double E_b_lo[LANES];
    double axis_a[LANES];
    double axis_b[LANES];
    double axis_d[LANES];
    double K_hi[LANES];
    double K_lo[LANES];
    double A_a_hi[LANES];
    double A_a_lo[LANES];
    double A_b_hi[LANES];
    double A_b_lo[LANES];
    double A_d_hi[LANES];
    double A_d_lo[LANES];
    double B_a_hi[LANES];
    double B_a_lo[LANES];
    double B_d_hi[LANES];
    double B_d_lo[LANES];
    double k_c_hi[LANES];
    double k_c_lo[LANES];
    double k_1_hi[LANES];
    double k_1_lo[LANES];
    double kc_1_hi[LANES];
    double kc_1_lo[LANES];
    double m_c_hi[LANES];
    double m_c_lo[LANES];
    double mu_hi[LANES];
    double mu_lo[LANES];
    double psi_0_hi[LANES];
    double psi_0_lo[LANES];
    double n_hi[LANES];
    double n_lo[LANES];
    double kappa_hi[LANES];
    double kappa_lo[LANES];
    double H_hi[LANES];
    double H_lo[LANES];
    double s_hi[LANES];
    double s_lo[LANES];
    double c_hi[LANES];
    double c_lo[LANES];
    double d_hi[LANES];
    double d_lo[LANES];
    double epsilon[LANES];
    double sigma[LANES];
    double rho[LANES];
    double chi[LANES];
    double q_0_hi[LANES];
    double q_0_lo[LANES];
    double q_a_hi[LANES];
    double q_a_lo[LANES];
    double q_b_hi[LANES];
    double q_b_lo[LANES];
    double q_d_hi[LANES];
    double q_d_lo[LANES];
    double unit[LANES];
} lanes;
typedef struct {
    double v_rate_hi[LANES];
    double v_rate_lo[LANES];
    double v_hi[LANES];
    double v_lo[LANES];
    double Lambda_rate_hi[LANES];
    double Lambda_rate_lo[LANES];
    double k_2[LANES];
    double k_3[LANES];
    double k_4[LANES];
    double k_5[LANES];
    double characteristic[LANES];
    double spread[LANES];
    double kappa[LANES];
    double j[LANES];
    double two_K[LANES];
    double rest_0[LANES];
    double c_a[LANES];
    double c_b[LANES];
    double c_d[LANES];
    double A_a[LANES];
    double A_b[LANES];
    double A_d[LANES];
    double K[LANES];
    double k_1[LANES];
    double k_c[LANES];
    double epsilon[LANES];
    double sigma[LANES];
    double chi[LANES];
    double tau[LANES];
    double p_0[LANES];
    double p_a[LANES];
    double p_b[LANES];
    double p_d[LANES];
    double unit[LANES];
} circular_lanes;
typedef struct {
    double y_rate_hi[LANES];
    double y_rate_lo[LANES];
    double y0_hi[LANES];
    double y0_lo[LANES];
    double period_hi[LANES];
    double period_lo[LANES];
    double Lambda_rate_hi[LANES];
    double Lambda_rate_lo[LANES];
    double jump_hi[LANES];
    double jump_lo[LANES];
    double period_far[LANES];
    double period_inverse[LANES];
    double l_2[LANES];
    double l_3[LANES];
    double l_4[LANES];
    double l_5[LANES];
    double gc[LANES];
    double kc_1[LANES];
    double m_c[LANES];
    double rho[LANES];
    double g_1[LANES];
    double g_2[LANES];
    double h_2[LANES];
    double alpha[LANES];
    double delta[LANES];
    double spread[LANES];
    double slope[LANES];
    double z[LANES];
    double characteristic[LANES];
    double start_rest[LANES];
    double c_a[LANES];
    double c_b[LANES];
    double c_d[LANES];
    double A_a[LANES];
    double A_b[LANES];
    double A_d[LANES];
    double K[LANES];
    double k_1[LANES];
    double k_c[LANES];
    double epsilon[LANES];
    double sigma[LANES];
    double chi[LANES];
    double tau[LANES];
    double p_0[LANES];
    double p_a[LANES];
    double p_b[LANES];
    double p_d[LANES];
    double unit[LANES];
} hyperbolic_lanes;

/* e^x for x <= 0. */
static INLINED double exponential(double x)
{
    const double bounded = choose(least, x, x, least); /* classical: DLMF 4.8 */
    const double n = nearest(bounded * log_2_inverse); /* classical: DLMF 4.8 */
    const double r = fused(-n, log_2_rest, fused(-n, log_2_short, bounded)); /* classical: DLMF 4.2.19 */
    const double rest = fused(r, fused(r, fused(r, fused(r, fused(r, fused(r, fused(r, fused(r, exponential_8, exponential_7), exponential_6), exponential_5), exponential_4), exponential_3), exponential_2), exponential_1), exponential_0); /* classical: DLMF 4.2.19 */
    const double grown = 1.0 + fused(r * r, fused(r, rest, half), r); /* classical: DLMF 4.2.19 */
    const double value = choose(least, x, power_of_two(n) * grown, 0.0); /* classical: DLMF 4.8 */
    return value;
}

/* K^2 - 2 H c_b, for numbers of any kind. */
static double_double discriminant_dd(double_double c_a, double_double c_d, double_double c_ab, double_double c_bd,
    double_double Omega_a, double_double Omega_d)
{
    const double_double E_b = dd_sub_xx(dd_mul_xx(dd_mul_xx(c_a, c_ab), dd_mul_xx(Omega_a, Omega_a)), dd_mul_xx(dd_mul_xx(c_d, c_bd), dd_mul_xx(Omega_d, Omega_d))); /* fact: regular.E_b; (6), (15) */
    return E_b;
}

/* K^2 - 2 H c_b, for numbers of any kind. */
static exact discriminant_exact(exact c_a, exact c_d, exact c_ab, exact c_bd, exact Omega_a, exact Omega_d)
{
    const exact E_b = exact_sub_xx(exact_mul_xx(exact_mul_xx(c_a, c_ab), exact_mul_xx(Omega_a, Omega_a)), exact_mul_xx(exact_mul_xx(c_d, c_bd), exact_mul_xx(Omega_d, Omega_d))); /* fact: regular.E_b; (6), (15) */
    return E_b;
}

/* 1 or -1 where a is the axis of largest or smallest moment, 0 for constant rates. */
static INLINED double circulation(double c_12, double c_13, double c_23, double Omega_1, double Omega_2,
    double Omega_3, double E_2)
{
    const double c_1 = 1.0 + c_13; /* fact: definition sorted_body.c_1 */
    const double c_2 = 1.0 + c_23; /* fact: definition sorted_body.c_2 */
    const double common_1 = Omega_2 * Omega_2; /* fact: definition sorted_body.E_1, definition sorted_body.E_3, definition sorted_body.turning */
    const double common_2 = Omega_3 * Omega_3; /* fact: definition sorted_body.E_1, definition sorted_body.turning, definition sorted_body.off_middle */
    const double E_1 = fused(c_2 * c_12, common_1, c_13 * common_2); /* fact: definition sorted_body.E_1 */
    const double common_3 = Omega_1 * Omega_1; /* fact: definition sorted_body.E_3, definition sorted_body.turning, definition sorted_body.off_middle */
    const double E_3 = fused(c_1 * c_13, common_3, c_2 * c_23 * common_1); /* fact: definition sorted_body.E_3 */
    const double turning = common_3 + common_1 + common_2; /* fact: definition sorted_body.turning */
    const double off_middle = common_3 + common_2; /* fact: definition sorted_body.off_middle */
    const double rest = 0.0; /* fact: rest.rates */
    const double spherical = 0.0; /* fact: spherical.moments */
    const double prolate_equatorial = 0.0; /* fact: prolate_equatorial.parallel */
    const double prolate_polar = 0.0; /* fact: prolate_polar.parallel */
    const double prolate_motion = -1.0; /* fact: prolate_motion.squares; (10), (13), (14) */
    const double oblate_polar = 0.0; /* fact: oblate_polar.parallel */
    const double oblate_equatorial = 0.0; /* fact: oblate_equatorial.parallel */
    const double oblate_motion = 1.0; /* fact: oblate_motion.squares; (10), (13), (14) */
    const double spin_1 = 0.0; /* fact: spin_1.parallel */
    const double spin_3 = 0.0; /* fact: spin_3.parallel */
    const double spin_2 = 0.0; /* fact: spin_2.parallel */
    const double separatrix_motion = 1.0; /* fact: separatrix_motion.squares; (10), (13), (14) */
    const double largest = 1.0; /* fact: largest.squares; (10), (13), (14) */
    const double smallest = -1.0; /* fact: smallest.squares; (10), (13), (14) */
    const double on_separatrix = choose(off_middle, 0.0, spin_2, separatrix_motion); /* fact: on_separatrix.cases */
    const double off_1_and_3 = choose(E_2, 0.0, choose(0.0, E_2, on_separatrix, smallest), largest); /* fact: off_1_and_3.cases */
    const double off_1 = choose(E_3, 0.0, spin_3, off_1_and_3); /* fact: off_1.cases */
    const double oblate_off_1 = choose(E_3, 0.0, oblate_equatorial, oblate_motion); /* fact: oblate_off_1.cases */
    const double asymmetric = choose(E_1, 0.0, spin_1, off_1); /* fact: asymmetric.cases */
    const double oblate = choose(E_1, 0.0, oblate_polar, oblate_off_1); /* fact: oblate.cases */
    const double prolate_off_1 = choose(E_3, 0.0, prolate_polar, prolate_motion); /* fact: prolate_off_1.cases */
    const double unequal_large = choose(c_23, 0.0, oblate, asymmetric); /* fact: unequal_large.cases */
    const double prolate = choose(E_1, 0.0, prolate_equatorial, prolate_off_1); /* fact: prolate.cases */
    const double nonspherical = choose(c_12, 0.0, prolate, unequal_large); /* fact: nonspherical.cases */
    const double motion = choose(c_13, 0.0, spherical, nonspherical); /* fact: motion.cases */
    const double sorted_body = choose(turning, 0.0, rest, motion); /* fact: sorted_body.cases */
    return sorted_body;
}

/* Signs, invariants, amplitudes and functions at t = 0; E_b is from `_discriminant`. */
static FLAT void initial_state(lanes *lane)
{
    for (size_t i = 0; i < LANES; i++) {
        const double_double c_a = {lane->c_a_hi[i], lane->c_a_lo[i]};
        const double_double c_b = {lane->c_b_hi[i], lane->c_b_lo[i]};
        const double_double c_d = {lane->c_d_hi[i], lane->c_d_lo[i]};
        const double_double c_ab = {lane->c_ab_hi[i], lane->c_ab_lo[i]};
        const double_double c_ad = {lane->c_ad_hi[i], lane->c_ad_lo[i]};
        const double_double c_bd = {lane->c_bd_hi[i], lane->c_bd_lo[i]};
        const double_double Omega_a = {lane->Omega_a_hi[i], lane->Omega_a_lo[i]};
        const double_double Omega_b = {lane->Omega_b_hi[i], lane->Omega_b_lo[i]};
        const double_double Omega_d = {lane->Omega_d_hi[i], lane->Omega_d_lo[i]};
        const double_double E_b = {lane->E_b_hi[i], lane->E_b_lo[i]};
        const double axis_a = lane->axis_a[i];
        const double axis_b = lane->axis_b[i];
        const double axis_d = lane->axis_d[i];
        const double epsilon = (axis_b - axis_a) * (axis_d - axis_a) * (axis_d - axis_b) / 2.0; /* classical: Levi-Civita */
        const double sigma = choose(0.0, dd_rounded(Omega_a), 1.0, -1.0); /* fact: choice start_signs.sigma; (12) */
        const double rho = choose(0.0, dd_rounded(c_ad), 1.0, -1.0); /* fact: choice start_signs.rho; (12) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double chi = choose(0.0, tau * dd_rounded(Omega_d), 1.0, -1.0); /* fact: choice start_signs.chi; (12) */
        const double_double common_1 = dd_mul_xx(Omega_a, Omega_a); /* fact: regular.H, regular.E_d; (6), (15) */
        const double_double common_2 = dd_mul_xx(Omega_b, Omega_b); /* fact: regular.H, regular.E_a, regular.E_d; (6), (15) */
        const double_double common_3 = dd_mul_xx(Omega_d, Omega_d); /* fact: regular.H, regular.E_a; (6), (15) */
        const double_double H = dd_div_xd(dd_add_xx(dd_add_xx(dd_mul_xx(c_a, common_1), dd_mul_xx(c_b, common_2)), dd_mul_xx(c_d, common_3)), 2.0); /* fact: regular.H; (6), (15) */
        const double_double common_4 = dd_mul_xx(c_b, c_ab); /* fact: regular.E_a, regular.A_b; (6), (15), (10), (13), (14) */
        const double_double common_5 = dd_mul_xx(c_d, c_ad); /* fact: regular.E_a, regular.A_d; (6), (15), (10), (13), (14) */
        const double_double E_a = dd_add_xx(dd_mul_xx(common_4, common_2), dd_mul_xx(common_5, common_3)); /* fact: regular.E_a; (6), (15) */
        const double_double common_6 = dd_mul_xx(c_a, c_ad); /* fact: regular.E_d, regular.A_a; (6), (15), (10), (13), (14) */
        const double_double E_d = dd_add_xx(dd_mul_xx(common_6, common_1), dd_mul_xx(dd_mul_xx(c_b, c_bd), common_2)); /* fact: regular.E_d; (6), (15) */
        const double_double M_a = dd_mul_xx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_xx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_xx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
        const double_double K = dd_sqrt(dd_add_xx(dd_add_xx(dd_mul_xx(M_a, M_a), dd_mul_xx(M_b, M_b)), dd_mul_xx(M_d, M_d))); /* fact: attitude.K; (6), (15) */
        const double_double A_a = dd_sqrt(dd_div_xx(E_d, common_6)); /* fact: regular.A_a; (10), (13), (14) */
        const double_double A_b = dd_sqrt(dd_div_xx(E_a, common_4)); /* fact: regular.A_b; (10), (13), (14) */
        const double_double A_d = dd_sqrt(dd_div_xx(E_a, common_5)); /* fact: regular.A_d; (10), (13), (14) */
        const double_double common_7 = dd_mul_xx(c_ab, E_d); /* fact: regular.lambda_, regular.m_1; (10), (13), (14) */
        const double_double lambda_ = dd_sqrt(dd_div_xx(common_7, dd_mul_xx(dd_mul_xx(c_a, c_b), c_d))); /* fact: regular.lambda_; (10), (13), (14) */
        const double_double m = dd_div_xx(dd_mul_xx(E_a, c_bd), dd_mul_xx(E_d, c_ab)); /* fact: regular.m; (10), (13), (14) */
        const double_double m_1 = dd_div_xx(dd_mul_xx(c_ad, E_b), common_7); /* fact: regular.m_1; (10), (13), (14) */
        const double_double k_c = dd_sqrt(m_1); /* fact: descended.k_c; DLMF 22.7.1 */
        const double_double common_8 = dd_add_dx(1.0, k_c); /* fact: descended.k_1, descended.m_c, descended.mu, definition landen.kc_next; DLMF 22.7.1, DLMF 22.7.2 */
        const double_double common_9 = dd_mul_xx(common_8, common_8); /* fact: descended.k_1, descended.m_c; DLMF 22.7.1 */
        const double_double k_1 = dd_div_xx(m, common_9); /* fact: descended.k_1; DLMF 22.7.1 */
        const double_double m_c = dd_div_xx(dd_mul_dx(4.0, k_c), common_9); /* fact: descended.m_c; DLMF 22.7.1 */
        const double_double mu = dd_div_xd(dd_mul_xx(lambda_, common_8), 2.0); /* fact: descended.mu; DLMF 22.7.2 */
        const double_double common_10 = dd_mul_xx(c_d, A_d); /* fact: descended.n, theta_form.B_d; (34), (28) */
        const double_double common_11 = dd_mul_xx(c_a, A_a); /* fact: descended.n, descended.psi_0, descended.kappa, theta_form.B_a; (34), (33), (27) */
        const double_double common_12 = dd_add_xx(K, common_11); /* fact: descended.n, descended.psi_0, descended.kappa; (34), (33) */
        const double_double common_13 = dd_mul_xx(common_12, common_12); /* fact: descended.n, descended.kappa; (34) */
        const double_double n = dd_div_xx(dd_mul_xx(dd_neg(k_1), dd_mul_xx(common_10, common_10)), common_13); /* fact: descended.n; (34) */
        const double_double psi_0 = dd_div_xx(dd_add_xx(dd_mul_dx(2.0, H), dd_mul_xx(K, A_a)), common_12); /* fact: descended.psi_0; (33), (34) */
        const double_double kappa = dd_div_xx(dd_mul_xx(dd_mul_xx(dd_mul_dx(2.0, E_a), A_a), k_1), dd_mul_xx(common_13, mu)); /* fact: descended.kappa; (34) */
        const double_double sn = dd_div_xx(dd_mul_dx(chi, Omega_b), A_b); /* fact: regular.sn; (12) */
        const double_double cn = dd_div_xx(dd_mul_dx(chi * tau, Omega_d), A_d); /* fact: regular.cn; (12) */
        const double_double dn = dd_div_xx(dd_mul_dx(sigma, Omega_a), A_a); /* fact: regular.dn; (12) */
        const double_double B_a = common_11; /* fact: theta_form.B_a; (27) */
        const double_double B_d = common_10; /* fact: theta_form.B_d; (28) */
        const double_double root_kc = dd_sqrt(k_c); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_1 = dd_div_xx(dd_mul_dx(2.0, root_kc), common_8); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_14 = dd_add_dx(1.0, dn); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
        const double_double common_15 = dd_mul_xx(dd_add_dx(1.0, k_1), common_14); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
        const double_double s = dd_div_xx(dd_mul_dx(2.0, sn), common_15); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
        const double_double v = dd_sqrt(dd_mul_xx(common_15, dd_add_xx(dn, k_c))); /* fact: landen.v; DLMF 22.7.4 */
        const double_double c = dd_div_xx(dd_mul_dx(2.0, cn), v); /* fact: landen.c_next; DLMF 22.7.2 to 22.7.4 */
        const double_double d = dd_div_xx(v, common_14); /* fact: landen.d_next; DLMF 22.7.2 to 22.7.4 */
        lane->K_hi[i] = K.hi;
        lane->K_lo[i] = K.lo;
        lane->A_a_hi[i] = A_a.hi;
        lane->A_a_lo[i] = A_a.lo;
        lane->A_b_hi[i] = A_b.hi;
        lane->A_b_lo[i] = A_b.lo;
        lane->A_d_hi[i] = A_d.hi;
        lane->A_d_lo[i] = A_d.lo;
        lane->B_a_hi[i] = B_a.hi;
        lane->B_a_lo[i] = B_a.lo;
        lane->B_d_hi[i] = B_d.hi;
        lane->B_d_lo[i] = B_d.lo;
        lane->k_c_hi[i] = k_c.hi;
        lane->k_c_lo[i] = k_c.lo;
        lane->k_1_hi[i] = k_1.hi;
        lane->k_1_lo[i] = k_1.lo;
        lane->kc_1_hi[i] = kc_1.hi;
        lane->kc_1_lo[i] = kc_1.lo;
        lane->m_c_hi[i] = m_c.hi;
        lane->m_c_lo[i] = m_c.lo;
        lane->mu_hi[i] = mu.hi;
        lane->mu_lo[i] = mu.lo;
        lane->psi_0_hi[i] = psi_0.hi;
        lane->psi_0_lo[i] = psi_0.lo;
        lane->n_hi[i] = n.hi;
        lane->n_lo[i] = n.lo;
        lane->kappa_hi[i] = kappa.hi;
        lane->kappa_lo[i] = kappa.lo;
        lane->H_hi[i] = H.hi;
        lane->H_lo[i] = H.lo;
        lane->s_hi[i] = s.hi;
        lane->s_lo[i] = s.lo;
        lane->c_hi[i] = c.hi;
        lane->c_lo[i] = c.lo;
        lane->d_hi[i] = d.hi;
        lane->d_lo[i] = d.lo;
        lane->epsilon[i] = epsilon;
        lane->sigma[i] = sigma;
        lane->rho[i] = rho;
        lane->chi[i] = chi;
    }
}

/* One step of Landen's descending transformation. */
static void landen(double_double k, double_double kc, double_double s, double_double c, double_double d,
    double_double r, double_double Y, double_double *k_next_out,
    double_double *kc_next_out, double_double *s_next_out, double_double *c_next_out,
    double_double *d_next_out, double_double *r_next_out, double_double *Y_next_out)
{
    const double_double common_1 = dd_add_dx(1.0, kc); /* fact: landen.k_next, definition landen.kc_next, landen.r_next; DLMF 22.7.1 */
    const double_double common_2 = dd_div_xx(k, common_1); /* fact: landen.k_next; DLMF 22.7.1 */
    const double_double k_next = dd_mul_xx(common_2, common_2); /* fact: landen.k_next; DLMF 22.7.1 */
    const double_double root_kc = dd_sqrt(kc); /* fact: landen.root_kc; DLMF 22.7.1 */
    const double_double kc_next = dd_div_xx(dd_mul_dx(2.0, root_kc), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1 */
    const double_double common_3 = dd_add_dx(1.0, k_next); /* fact: landen.s_next, landen.v, landen.S, landen.Y_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4, DLMF 22.7.2 */
    const double_double common_4 = dd_add_dx(1.0, d); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const double_double common_5 = dd_mul_xx(common_3, common_4); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const double_double s_next = dd_div_xx(dd_mul_dx(2.0, s), common_5); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
    const double_double v = dd_sqrt(dd_mul_xx(common_5, dd_add_xx(d, kc))); /* fact: landen.v; DLMF 22.7.4 */
    const double_double c_next = dd_div_xx(dd_mul_dx(2.0, c), v); /* fact: landen.c_next; DLMF 22.7.2 to 22.7.4 */
    const double_double d_next = dd_div_xx(v, common_4); /* fact: landen.d_next; DLMF 22.7.2 to 22.7.4 */
    const double_double r_next = dd_div_xx(dd_mul_xx(r, k), dd_mul_xx(common_1, common_1)); /* fact: landen.r_next; DLMF 22.7.1 */
    const double_double S = dd_sqrt(dd_add_xx(dd_mul_xx(common_3, common_3), dd_mul_xx(dd_mul_dx(4.0, r_next), dd_mul_xx(Y, Y)))); /* fact: landen.S; DLMF 22.7.2 */
    const double_double Y_next = dd_div_xx(dd_mul_dx(2.0, Y), dd_add_xx(common_3, S)); /* fact: landen.Y_next; DLMF 22.7.2 */
    *k_next_out = k_next;
    *kc_next_out = kc_next;
    *s_next_out = s_next;
    *c_next_out = c_next;
    *d_next_out = d_next;
    *r_next_out = r_next;
    *Y_next_out = Y_next;
}

/* K(k^2), and the descended s, c and Y; 5 steps leave k^2 < 2^-106 of (0, 1/2]. */
static void ladder(double_double k, double_double kc, double_double s, double_double c, double_double d,
    double_double r, double_double Y, double_double *K0_out, double_double *s5_out,
    double_double *c5_out, double_double *Y5_out)
{
    double_double k1, kc1, s1, c1, d1, r1, Y1;
    landen(k, kc, s, c, d, r, Y, &k1, &kc1, &s1, &c1, &d1, &r1, &Y1); /* classical: DLMF 22.7.2 */
    double_double k2, kc2, s2, c2, d2, r2, Y2;
    landen(k1, kc1, s1, c1, d1, r1, Y1, &k2, &kc2, &s2, &c2, &d2, &r2, &Y2); /* classical: DLMF 22.7.2 */
    double_double k3, kc3, s3, c3, d3, r3, Y3;
    landen(k2, kc2, s2, c2, d2, r2, Y2, &k3, &kc3, &s3, &c3, &d3, &r3, &Y3); /* classical: DLMF 22.7.2 */
    double_double k4, kc4, s4, c4, d4, r4, Y4;
    landen(k3, kc3, s3, c3, d3, r3, Y3, &k4, &kc4, &s4, &c4, &d4, &r4, &Y4); /* classical: DLMF 22.7.2 */
    double_double k5, kc5, s5, c5, d5, r5, Y5;
    landen(k4, kc4, s4, c4, d4, r4, Y4, &k5, &kc5, &s5, &c5, &d5, &r5, &Y5); /* classical: DLMF 22.7.2 */
    const double_double K5 = dd_div_xd(pi, 2.0); /* classical: DLMF 19.6.1 */
    const double_double K4 = dd_mul_xx(dd_add_dx(1.0, k5), K5); /* fact: definition landen.K; DLMF 19.8.12 */
    const double_double K3 = dd_mul_xx(dd_add_dx(1.0, k4), K4); /* fact: definition landen.K; DLMF 19.8.12 */
    const double_double K2 = dd_mul_xx(dd_add_dx(1.0, k3), K3); /* fact: definition landen.K; DLMF 19.8.12 */
    const double_double K1 = dd_mul_xx(dd_add_dx(1.0, k2), K2); /* fact: definition landen.K; DLMF 19.8.12 */
    const double_double K0 = dd_mul_xx(dd_add_dx(1.0, k1), K1); /* fact: definition landen.K; DLMF 19.8.12 */
    *K0_out = K0;
    *s5_out = s5;
    *c5_out = c5;
    *Y5_out = Y5;
}

/* theta/pi where s and c >= 0 are the sine and cosine of theta. */
static double_double half_turns(double_double s, double_double c)
{
    const double_double t1 = dd_div_xx(s, dd_add_dx(1.0, c)); /* classical: DLMF 4.21.28 */
    const double_double t2 = dd_div_xx(t1, dd_add_dx(1.0, dd_sqrt(dd_add_dx(1.0, dd_mul_xx(t1, t1))))); /* classical: DLMF 4.21.28 */
    const double_double t3 = dd_div_xx(t2, dd_add_dx(1.0, dd_sqrt(dd_add_dx(1.0, dd_mul_xx(t2, t2))))); /* classical: DLMF 4.21.28 */
    const double_double t4 = dd_div_xx(t3, dd_add_dx(1.0, dd_sqrt(dd_add_dx(1.0, dd_mul_xx(t3, t3))))); /* classical: DLMF 4.21.28 */
    const double_double z = dd_neg(dd_mul_xx(t4, t4)); /* classical: DLMF 4.24.3 */
    const double z_d = dd_rounded(z); /* classical: DLMF 4.24.3 */
    const double tail = fused(z_d, fused(z_d, fused(z_d, fused(z_d, fused(z_d, fused(z_d, fused(z_d, over_33, over_31), over_29), over_27), over_25), over_23), over_21), over_19); /* classical: DLMF 4.24.3 */
    const double_double series = dd_add_dx(1.0, dd_mul_xx(z, dd_add_xx(over_3, dd_mul_xx(z, dd_add_xx(over_5, dd_mul_xx(z, dd_add_xx(over_7, dd_mul_xx(z, dd_add_xx(over_9, dd_mul_xx(z, dd_add_xx(over_11, dd_mul_xx(z, dd_add_xx(over_13, dd_mul_xx(z, dd_add_xx(over_15, dd_mul_xx(z, dd_add_xx(over_17, dd_mul_xd(z, tail)))))))))))))))))); /* classical: DLMF 4.24.3 */
    const double_double angle = dd_div_xx(dd_mul_xx(dd_mul_dx(16.0, t4), series), pi); /* classical: DLMF 4.24.3 */
    return angle;
}

/* log(x) for x > 0. */
static double_double logarithm(double_double x)
{
    const double e = dd_exponent(x); /* classical: DLMF 4.8 */
    const double_double f = dd_sqrt(dd_mantissa(x)); /* classical: DLMF 4.8 */
    const double_double t4 = dd_div_xx(dd_sub_xd(f, 1.0), dd_add_xd(f, 1.0)); /* classical: DLMF 4.38.5 */
    const double_double z = dd_mul_xx(t4, t4); /* classical: DLMF 4.38.5 */
    const double z_d = dd_rounded(z); /* classical: DLMF 4.38.5 */
    const double tail = fused(z_d, fused(z_d, fused(z_d, fused(z_d, fused(z_d, fused(z_d, fused(z_d, over_33, over_31), over_29), over_27), over_25), over_23), over_21), over_19); /* classical: DLMF 4.38.5 */
    const double_double series = dd_add_dx(1.0, dd_mul_xx(z, dd_add_xx(over_3, dd_mul_xx(z, dd_add_xx(over_5, dd_mul_xx(z, dd_add_xx(over_7, dd_mul_xx(z, dd_add_xx(over_9, dd_mul_xx(z, dd_add_xx(over_11, dd_mul_xx(z, dd_add_xx(over_13, dd_mul_xx(z, dd_add_xx(over_15, dd_mul_xx(z, dd_add_xx(over_17, dd_mul_xd(z, tail)))))))))))))))))); /* classical: DLMF 4.38.5 */
    const double_double log_x = dd_add_xx(dd_mul_dx(e, log_2), dd_mul_xx(dd_mul_dx(4.0, t4), series)); /* classical: DLMF 4.38.5 */
    return log_x;
}

/* K(k^2), and the sum of Q for 1 - n = path; kc^2 = 1 - k^2. */
static void complete(double_double kc, double_double path, double_double *K_out, double_double *total_out)
{
    const double_double product_0 = kc; /* classical: DLMF 19.8.6 */
    const double_double square_0 = path; /* classical: DLMF 19.8.6 */
    const double_double sum_0 = dd_add_xx(square_0, product_0); /* classical: DLMF 19.8.6 */
    const double_double Q_1 = dd_div_xd(dd_mul_dx(1.0, dd_div_xx(dd_sub_xx(square_0, product_0), sum_0)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_1 = dd_div_xd(dd_add_dx(1.0, kc), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_1 = dd_div_xx(sum_0, dd_mul_dx(2.0, dd_sqrt(path))); /* classical: DLMF 19.8.6 */
    const double_double g_1 = dd_sqrt(product_0); /* classical: DLMF 19.8.6 */
    const double_double product_1 = dd_mul_xx(a_1, g_1); /* classical: DLMF 19.8.6 */
    const double_double square_1 = dd_mul_xx(p_1, p_1); /* classical: DLMF 19.8.6 */
    const double_double sum_1 = dd_add_xx(square_1, product_1); /* classical: DLMF 19.8.6 */
    const double_double Q_2 = dd_div_xd(dd_mul_xx(Q_1, dd_div_xx(dd_sub_xx(square_1, product_1), sum_1)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_2 = dd_div_xd(dd_add_xx(a_1, g_1), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_2 = dd_div_xx(sum_1, dd_mul_dx(2.0, p_1)); /* classical: DLMF 19.8.6 */
    const double_double g_2 = dd_sqrt(product_1); /* classical: DLMF 19.8.6 */
    const double_double product_2 = dd_mul_xx(a_2, g_2); /* classical: DLMF 19.8.6 */
    const double_double square_2 = dd_mul_xx(p_2, p_2); /* classical: DLMF 19.8.6 */
    const double_double sum_2 = dd_add_xx(square_2, product_2); /* classical: DLMF 19.8.6 */
    const double_double Q_3 = dd_div_xd(dd_mul_xx(Q_2, dd_div_xx(dd_sub_xx(square_2, product_2), sum_2)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_3 = dd_div_xd(dd_add_xx(a_2, g_2), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_3 = dd_div_xx(sum_2, dd_mul_dx(2.0, p_2)); /* classical: DLMF 19.8.6 */
    const double_double g_3 = dd_sqrt(product_2); /* classical: DLMF 19.8.6 */
    const double_double product_3 = dd_mul_xx(a_3, g_3); /* classical: DLMF 19.8.6 */
    const double_double square_3 = dd_mul_xx(p_3, p_3); /* classical: DLMF 19.8.6 */
    const double_double sum_3 = dd_add_xx(square_3, product_3); /* classical: DLMF 19.8.6 */
    const double_double Q_4 = dd_div_xd(dd_mul_xx(Q_3, dd_div_xx(dd_sub_xx(square_3, product_3), sum_3)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_4 = dd_div_xd(dd_add_xx(a_3, g_3), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_4 = dd_div_xx(sum_3, dd_mul_dx(2.0, p_3)); /* classical: DLMF 19.8.6 */
    const double_double g_4 = dd_sqrt(product_3); /* classical: DLMF 19.8.6 */
    const double_double product_4 = dd_mul_xx(a_4, g_4); /* classical: DLMF 19.8.6 */
    const double_double square_4 = dd_mul_xx(p_4, p_4); /* classical: DLMF 19.8.6 */
    const double_double sum_4 = dd_add_xx(square_4, product_4); /* classical: DLMF 19.8.6 */
    const double_double Q_5 = dd_div_xd(dd_mul_xx(Q_4, dd_div_xx(dd_sub_xx(square_4, product_4), sum_4)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_5 = dd_div_xd(dd_add_xx(a_4, g_4), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_5 = dd_div_xx(sum_4, dd_mul_dx(2.0, p_4)); /* classical: DLMF 19.8.6 */
    const double_double g_5 = dd_sqrt(product_4); /* classical: DLMF 19.8.6 */
    const double_double product_5 = dd_mul_xx(a_5, g_5); /* classical: DLMF 19.8.6 */
    const double_double square_5 = dd_mul_xx(p_5, p_5); /* classical: DLMF 19.8.6 */
    const double_double sum_5 = dd_add_xx(square_5, product_5); /* classical: DLMF 19.8.6 */
    const double_double Q_6 = dd_div_xd(dd_mul_xx(Q_5, dd_div_xx(dd_sub_xx(square_5, product_5), sum_5)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_6 = dd_div_xd(dd_add_xx(a_5, g_5), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_6 = dd_div_xx(sum_5, dd_mul_dx(2.0, p_5)); /* classical: DLMF 19.8.6 */
    const double_double g_6 = dd_sqrt(product_5); /* classical: DLMF 19.8.6 */
    const double_double product_6 = dd_mul_xx(a_6, g_6); /* classical: DLMF 19.8.6 */
    const double_double square_6 = dd_mul_xx(p_6, p_6); /* classical: DLMF 19.8.6 */
    const double_double sum_6 = dd_add_xx(square_6, product_6); /* classical: DLMF 19.8.6 */
    const double_double Q_7 = dd_div_xd(dd_mul_xx(Q_6, dd_div_xx(dd_sub_xx(square_6, product_6), sum_6)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_7 = dd_div_xd(dd_add_xx(a_6, g_6), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_7 = dd_div_xx(sum_6, dd_mul_dx(2.0, p_6)); /* classical: DLMF 19.8.6 */
    const double_double g_7 = dd_sqrt(product_6); /* classical: DLMF 19.8.6 */
    const double_double product_7 = dd_mul_xx(a_7, g_7); /* classical: DLMF 19.8.6 */
    const double_double square_7 = dd_mul_xx(p_7, p_7); /* classical: DLMF 19.8.6 */
    const double_double sum_7 = dd_add_xx(square_7, product_7); /* classical: DLMF 19.8.6 */
    const double_double Q_8 = dd_div_xd(dd_mul_xx(Q_7, dd_div_xx(dd_sub_xx(square_7, product_7), sum_7)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_8 = dd_div_xd(dd_add_xx(a_7, g_7), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_8 = dd_div_xx(sum_7, dd_mul_dx(2.0, p_7)); /* classical: DLMF 19.8.6 */
    const double_double g_8 = dd_sqrt(product_7); /* classical: DLMF 19.8.6 */
    const double_double product_8 = dd_mul_xx(a_8, g_8); /* classical: DLMF 19.8.6 */
    const double_double square_8 = dd_mul_xx(p_8, p_8); /* classical: DLMF 19.8.6 */
    const double_double sum_8 = dd_add_xx(square_8, product_8); /* classical: DLMF 19.8.6 */
    const double_double Q_9 = dd_div_xd(dd_mul_xx(Q_8, dd_div_xx(dd_sub_xx(square_8, product_8), sum_8)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_9 = dd_div_xd(dd_add_xx(a_8, g_8), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_9 = dd_div_xx(sum_8, dd_mul_dx(2.0, p_8)); /* classical: DLMF 19.8.6 */
    const double_double g_9 = dd_sqrt(product_8); /* classical: DLMF 19.8.6 */
    const double_double product_9 = dd_mul_xx(a_9, g_9); /* classical: DLMF 19.8.6 */
    const double_double square_9 = dd_mul_xx(p_9, p_9); /* classical: DLMF 19.8.6 */
    const double_double sum_9 = dd_add_xx(square_9, product_9); /* classical: DLMF 19.8.6 */
    const double_double Q_10 = dd_div_xd(dd_mul_xx(Q_9, dd_div_xx(dd_sub_xx(square_9, product_9), sum_9)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_10 = dd_div_xd(dd_add_xx(a_9, g_9), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_10 = dd_div_xx(sum_9, dd_mul_dx(2.0, p_9)); /* classical: DLMF 19.8.6 */
    const double_double g_10 = dd_sqrt(product_9); /* classical: DLMF 19.8.6 */
    const double_double product_10 = dd_mul_xx(a_10, g_10); /* classical: DLMF 19.8.6 */
    const double_double square_10 = dd_mul_xx(p_10, p_10); /* classical: DLMF 19.8.6 */
    const double_double sum_10 = dd_add_xx(square_10, product_10); /* classical: DLMF 19.8.6 */
    const double_double Q_11 = dd_div_xd(dd_mul_xx(Q_10, dd_div_xx(dd_sub_xx(square_10, product_10), sum_10)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_11 = dd_div_xd(dd_add_xx(a_10, g_10), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_11 = dd_div_xx(sum_10, dd_mul_dx(2.0, p_10)); /* classical: DLMF 19.8.6 */
    const double_double g_11 = dd_sqrt(product_10); /* classical: DLMF 19.8.6 */
    const double_double product_11 = dd_mul_xx(a_11, g_11); /* classical: DLMF 19.8.6 */
    const double_double square_11 = dd_mul_xx(p_11, p_11); /* classical: DLMF 19.8.6 */
    const double_double sum_11 = dd_add_xx(square_11, product_11); /* classical: DLMF 19.8.6 */
    const double_double Q_12 = dd_div_xd(dd_mul_xx(Q_11, dd_div_xx(dd_sub_xx(square_11, product_11), sum_11)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_12 = dd_div_xd(dd_add_xx(a_11, g_11), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_12 = dd_div_xx(sum_11, dd_mul_dx(2.0, p_11)); /* classical: DLMF 19.8.6 */
    const double_double g_12 = dd_sqrt(product_11); /* classical: DLMF 19.8.6 */
    const double_double product_12 = dd_mul_xx(a_12, g_12); /* classical: DLMF 19.8.6 */
    const double_double square_12 = dd_mul_xx(p_12, p_12); /* classical: DLMF 19.8.6 */
    const double_double sum_12 = dd_add_xx(square_12, product_12); /* classical: DLMF 19.8.6 */
    const double_double Q_13 = dd_div_xd(dd_mul_xx(Q_12, dd_div_xx(dd_sub_xx(square_12, product_12), sum_12)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_13 = dd_div_xd(dd_add_xx(a_12, g_12), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_13 = dd_div_xx(sum_12, dd_mul_dx(2.0, p_12)); /* classical: DLMF 19.8.6 */
    const double_double g_13 = dd_sqrt(product_12); /* classical: DLMF 19.8.6 */
    const double_double product_13 = dd_mul_xx(a_13, g_13); /* classical: DLMF 19.8.6 */
    const double_double square_13 = dd_mul_xx(p_13, p_13); /* classical: DLMF 19.8.6 */
    const double_double sum_13 = dd_add_xx(square_13, product_13); /* classical: DLMF 19.8.6 */
    const double_double Q_14 = dd_div_xd(dd_mul_xx(Q_13, dd_div_xx(dd_sub_xx(square_13, product_13), sum_13)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_14 = dd_div_xd(dd_add_xx(a_13, g_13), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_14 = dd_div_xx(sum_13, dd_mul_dx(2.0, p_13)); /* classical: DLMF 19.8.6 */
    const double_double g_14 = dd_sqrt(product_13); /* classical: DLMF 19.8.6 */
    const double_double product_14 = dd_mul_xx(a_14, g_14); /* classical: DLMF 19.8.6 */
    const double_double square_14 = dd_mul_xx(p_14, p_14); /* classical: DLMF 19.8.6 */
    const double_double sum_14 = dd_add_xx(square_14, product_14); /* classical: DLMF 19.8.6 */
    const double_double Q_15 = dd_div_xd(dd_mul_xx(Q_14, dd_div_xx(dd_sub_xx(square_14, product_14), sum_14)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_15 = dd_div_xd(dd_add_xx(a_14, g_14), 2.0); /* classical: DLMF 19.8.6 */
    const double_double p_15 = dd_div_xx(sum_14, dd_mul_dx(2.0, p_14)); /* classical: DLMF 19.8.6 */
    const double_double g_15 = dd_sqrt(product_14); /* classical: DLMF 19.8.6 */
    const double_double product_15 = dd_mul_xx(a_15, g_15); /* classical: DLMF 19.8.6 */
    const double_double square_15 = dd_mul_xx(p_15, p_15); /* classical: DLMF 19.8.6 */
    const double_double sum_15 = dd_add_xx(square_15, product_15); /* classical: DLMF 19.8.6 */
    const double_double Q_16 = dd_div_xd(dd_mul_xx(Q_15, dd_div_xx(dd_sub_xx(square_15, product_15), sum_15)), 2.0); /* classical: DLMF 19.8.6 */
    const double_double a_16 = dd_div_xd(dd_add_xx(a_15, g_15), 2.0); /* classical: DLMF 19.8.6 */
    const double_double K = dd_div_xx(pi, dd_mul_dx(2.0, a_16)); /* classical: DLMF 19.8.5 */
    const double_double total = dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_dx(1.0, Q_1), Q_2), Q_3), Q_4), Q_5), Q_6), Q_7), Q_8), Q_9), Q_10), Q_11), Q_12), Q_13), Q_14), Q_15), Q_16); /* classical: DLMF 19.8.6 */
    *K_out = K;
    *total_out = total;
}

/* (s^3/3) R_J(c^2, d^2, 1, p); spread s^6 is (p - c^2)(p - d^2)(p - 1). */
static INLINED double third_kind(double s, double c, double d, double p_0, double spread)
{
    const double square = s * s; /* classical: DLMF 19.25.14 */
    const double e_0 = spread * (square * (square * square)); /* classical: DLMF 19.36.1 */
    const double x_0 = c * c; /* classical: DLMF 19.25.14 */
    const double y_0 = d * d; /* classical: DLMF 19.25.14 */
    const double common_1 = 1.0 / 5.0; /* classical: DLMF 19.36.1, DLMF 19.2.17 */
    const double mean_0 = common_1 * fused(2.0, p_0, x_0 + y_0 + 1.0); /* classical: DLMF 19.36.1 */
    const double root_p_0 = sqrt(p_0); /* classical: DLMF 19.36.1 */
    const double step_0 = fused(c, d + 1.0, d * 1.0); /* classical: DLMF 19.36.1 */
    const double inverse_0 = 1.0 / ((root_p_0 + c) * (root_p_0 + d) * (root_p_0 + 1.0)); /* classical: DLMF 19.36.1 */
    const double ratio_0 = e_0 * (inverse_0 * inverse_0); /* classical: DLMF 19.36.1 */
    const double common_2 = -1.0 / 3.0; /* classical: DLMF 19.2.17 */
    const double common_3 = -1.0 / 7.0; /* classical: DLMF 19.2.17 */
    const double common_4 = 1.0 / 9.0; /* classical: DLMF 19.2.17 */
    const double common_5 = -1.0 / 11.0; /* classical: DLMF 19.2.17 */
    const double common_6 = 1.0 / 13.0; /* classical: DLMF 19.2.17 */
    const double added_0 = inverse_0 * fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, fused(ratio_0, 1.0 / 21.0 + ratio_0 * -1.0 / 23.0, -1.0 / 19.0), 1.0 / 17.0), -1.0 / 15.0), common_6), common_5), common_4), common_3), common_1), common_2), 1.0); /* classical: DLMF 19.2.17 */
    const double x_1 = (x_0 + step_0) / 4.0; /* classical: DLMF 19.36.1 */
    const double y_1 = (y_0 + step_0) / 4.0; /* classical: DLMF 19.36.1 */
    const double z_1 = (1.0 + step_0) / 4.0; /* classical: DLMF 19.36.1 */
    const double p_1 = (p_0 + step_0) / 4.0; /* classical: DLMF 19.36.1 */
    const double mean_1 = (mean_0 + step_0) / 4.0; /* classical: DLMF 19.36.1 */
    const double e_1 = e_0 / 64.0; /* classical: DLMF 19.36.1 */
    const double root_p_1 = sqrt(p_1); /* classical: DLMF 19.36.1 */
    const double root_x_1 = sqrt(x_1); /* classical: DLMF 19.36.1 */
    const double root_y_1 = sqrt(y_1); /* classical: DLMF 19.36.1 */
    const double root_z_1 = sqrt(z_1); /* classical: DLMF 19.36.1 */
    const double step_1 = fused(root_x_1, root_y_1 + root_z_1, root_y_1 * root_z_1); /* classical: DLMF 19.36.1 */
    const double inverse_1 = 1.0 / ((root_p_1 + root_x_1) * (root_p_1 + root_y_1) * (root_p_1 + root_z_1)); /* classical: DLMF 19.36.1 */
    const double ratio_1 = e_1 * (inverse_1 * inverse_1); /* classical: DLMF 19.36.1 */
    const double added_1 = inverse_1 * fused(ratio_1, fused(ratio_1, fused(ratio_1, fused(ratio_1, fused(ratio_1, fused(ratio_1, common_6 + ratio_1 * -1.0 / 15.0, common_5), common_4), common_3), common_1), common_2), 1.0); /* classical: DLMF 19.2.17 */
    const double x_2 = (x_1 + step_1) / 4.0; /* classical: DLMF 19.36.1 */
    const double y_2 = (y_1 + step_1) / 4.0; /* classical: DLMF 19.36.1 */
    const double z_2 = (z_1 + step_1) / 4.0; /* classical: DLMF 19.36.1 */
    const double p_2 = (p_1 + step_1) / 4.0; /* classical: DLMF 19.36.1 */
    const double mean_2 = (mean_1 + step_1) / 4.0; /* classical: DLMF 19.36.1 */
    const double e_2 = e_1 / 64.0; /* classical: DLMF 19.36.1 */
    const double root_p_2 = sqrt(p_2); /* classical: DLMF 19.36.1 */
    const double root_x_2 = sqrt(x_2); /* classical: DLMF 19.36.1 */
    const double root_y_2 = sqrt(y_2); /* classical: DLMF 19.36.1 */
    const double root_z_2 = sqrt(z_2); /* classical: DLMF 19.36.1 */
    const double step_2 = fused(root_x_2, root_y_2 + root_z_2, root_y_2 * root_z_2); /* classical: DLMF 19.36.1 */
    const double inverse_2 = 1.0 / ((root_p_2 + root_x_2) * (root_p_2 + root_y_2) * (root_p_2 + root_z_2)); /* classical: DLMF 19.36.1 */
    const double ratio_2 = e_2 * (inverse_2 * inverse_2); /* classical: DLMF 19.36.1 */
    const double added_2 = inverse_2 * fused(ratio_2, fused(ratio_2, fused(ratio_2, common_3 + ratio_2 * 1.0 / 9.0, common_1), common_2), 1.0); /* classical: DLMF 19.2.17 */
    const double x_3 = (x_2 + step_2) / 4.0; /* classical: DLMF 19.36.1 */
    const double y_3 = (y_2 + step_2) / 4.0; /* classical: DLMF 19.36.1 */
    const double z_3 = (z_2 + step_2) / 4.0; /* classical: DLMF 19.36.1 */
    const double p_3 = (p_2 + step_2) / 4.0; /* classical: DLMF 19.36.1 */
    const double mean_3 = (mean_2 + step_2) / 4.0; /* classical: DLMF 19.36.1 */
    const double e_3 = e_2 / 64.0; /* classical: DLMF 19.36.1 */
    const double root_p_3 = sqrt(p_3); /* classical: DLMF 19.36.1 */
    const double root_x_3 = sqrt(x_3); /* classical: DLMF 19.36.1 */
    const double root_y_3 = sqrt(y_3); /* classical: DLMF 19.36.1 */
    const double root_z_3 = sqrt(z_3); /* classical: DLMF 19.36.1 */
    const double step_3 = fused(root_x_3, root_y_3 + root_z_3, root_y_3 * root_z_3); /* classical: DLMF 19.36.1 */
    const double inverse_3 = 1.0 / ((root_p_3 + root_x_3) * (root_p_3 + root_y_3) * (root_p_3 + root_z_3)); /* classical: DLMF 19.36.1 */
    const double ratio_3 = e_3 * (inverse_3 * inverse_3); /* classical: DLMF 19.36.1 */
    const double added_3 = inverse_3 * fused(ratio_3, fused(ratio_3, common_1 + ratio_3 * -1.0 / 7.0, common_2), 1.0); /* classical: DLMF 19.2.17 */
    const double mean_4 = (mean_3 + step_3) / 4.0; /* classical: DLMF 19.36.1 */
    const double scale = 1.0 / (256.0 * mean_4); /* classical: DLMF 19.36.2 */
    const double X = (mean_0 - x_0) * scale; /* classical: DLMF 19.36.2 */
    const double Y = (mean_0 - y_0) * scale; /* classical: DLMF 19.36.2 */
    const double Z = (mean_0 - 1.0) * scale; /* classical: DLMF 19.36.2 */
    const double P = -(X + Y + Z) / 2.0; /* classical: DLMF 19.36.2 */
    const double P2 = P * P; /* classical: DLMF 19.36.2 */
    const double common_7 = X * Y; /* classical: DLMF 19.36.2 */
    const double XYZ = common_7 * Z; /* classical: DLMF 19.36.2 */
    const double common_8 = 3.0 * P2; /* classical: DLMF 19.36.2 */
    const double E2 = fused(Y, Z, fused(X, Z, common_7)) - common_8; /* classical: DLMF 19.36.2 */
    const double E3 = fused(4.0 * P2, P, fused(2.0 * E2, P, XYZ)); /* classical: DLMF 19.36.2 */
    const double E4 = fused(common_8, P, fused(2.0, XYZ, E2 * P)) * P; /* classical: DLMF 19.36.2 */
    const double E5 = XYZ * P2; /* classical: DLMF 19.36.2 */
    const double low = fused(-E2, fused(9.0 / 52.0, E3, fused(-(9.0 / 88.0), E2, 3.0 / 14.0)), fused(3.0 / 26.0, E5, fused(1.0 / 6.0, E3, -(3.0 / 22.0 * E4)))); /* classical: DLMF 19.36.2 */
    const double high = fused(-(9.0 / 68.0), fused(E3, E4, E2 * E5), fused(-(E2 * E2), fused(-(45.0 / 272.0), E3, E2 / 16.0), fused(3.0 / 40.0, E3 * E3, 3.0 / 20.0 * (E2 * E4)))); /* classical: DLMF 19.36.2 */
    const double rest = (1.0 + (low + high)) / (768.0 * (mean_4 * sqrt(mean_4))); /* classical: DLMF 19.36.2 */
    const double elementary = added_0 + (added_1 + (added_2 + added_3 / 4.0) / 4.0) / 4.0; /* classical: DLMF 19.36.1 */
    const double J = s * square * fused(2.0, elementary, rest); /* classical: DLMF 19.25.14 */
    return J;
}

/* The constants of a motion on the circular branch, from `_initial_state`. */
static FLAT void circular_constants(const lanes *restrict lane, circular_lanes *restrict motion)
{
    for (size_t i = 0; i < LANES; i++) {
        const double_double K = {lane->K_hi[i], lane->K_lo[i]};
        const double_double A_a = {lane->A_a_hi[i], lane->A_a_lo[i]};
        const double_double A_b = {lane->A_b_hi[i], lane->A_b_lo[i]};
        const double_double A_d = {lane->A_d_hi[i], lane->A_d_lo[i]};
        const double_double k_c = {lane->k_c_hi[i], lane->k_c_lo[i]};
        const double_double k_1 = {lane->k_1_hi[i], lane->k_1_lo[i]};
        const double_double kc_1 = {lane->kc_1_hi[i], lane->kc_1_lo[i]};
        const double_double mu = {lane->mu_hi[i], lane->mu_lo[i]};
        const double_double psi_0 = {lane->psi_0_hi[i], lane->psi_0_lo[i]};
        const double_double n = {lane->n_hi[i], lane->n_lo[i]};
        const double_double kappa = {lane->kappa_hi[i], lane->kappa_lo[i]};
        const double_double s = {lane->s_hi[i], lane->s_lo[i]};
        const double_double c = {lane->c_hi[i], lane->c_lo[i]};
        const double_double d = {lane->d_hi[i], lane->d_lo[i]};
        const double_double c_a = {lane->c_a_hi[i], lane->c_a_lo[i]};
        const double_double c_b = {lane->c_b_hi[i], lane->c_b_lo[i]};
        const double_double c_d = {lane->c_d_hi[i], lane->c_d_lo[i]};
        const double_double Omega_a = {lane->Omega_a_hi[i], lane->Omega_a_lo[i]};
        const double_double Omega_b = {lane->Omega_b_hi[i], lane->Omega_b_lo[i]};
        const double_double Omega_d = {lane->Omega_d_hi[i], lane->Omega_d_lo[i]};
        const double_double q_0 = {lane->q_0_hi[i], lane->q_0_lo[i]};
        const double_double q_a = {lane->q_a_hi[i], lane->q_a_lo[i]};
        const double_double q_b = {lane->q_b_hi[i], lane->q_b_lo[i]};
        const double_double q_d = {lane->q_d_hi[i], lane->q_d_lo[i]};
        const double epsilon = lane->epsilon[i];
        const double sigma = lane->sigma[i];
        const double rho = lane->rho[i];
        const double chi = lane->chi[i];
        const double unit = lane->unit[i];
        const double_double common_1 = dd_add_dx(1.0, kc_1); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_2 = dd_div_xx(k_1, common_1); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double k_2 = dd_mul_xx(common_2, common_2); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_1 = dd_sqrt(kc_1); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_2 = dd_div_xx(dd_mul_dx(2.0, root_1), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_3 = dd_add_dx(1.0, kc_2); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_4 = dd_div_xx(k_2, common_3); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double k_3 = dd_mul_xx(common_4, common_4); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_2 = dd_sqrt(kc_2); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_3 = dd_div_xx(dd_mul_dx(2.0, root_2), common_3); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_5 = dd_add_dx(1.0, kc_3); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_6 = dd_div_xx(k_3, common_5); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double k_4 = dd_mul_xx(common_6, common_6); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_3 = dd_sqrt(kc_3); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_4 = dd_div_xx(dd_mul_dx(2.0, root_3), common_5); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_7 = dd_div_xx(k_4, dd_add_dx(1.0, kc_4)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double k_5 = dd_mul_xx(common_7, common_7); /* fact: landen.k_next; DLMF 22.7.1 */
        double_double K_1, sin_v, cos_v, shift;
        ladder(k_1, kc_1, s, c, d, k_1, dd_of(0.0), &K_1, &sin_v, &cos_v, &shift); /* classical: DLMF 19.8.12 */
        const double_double v = half_turns(sin_v, cos_v); /* classical: DLMF 4.24.3 */
        const double_double two_K = dd_mul_dx(2.0, K_1); /* classical: DLMF 22.4(i) */
        const double_double v_rate = dd_div_xx(mu, two_K); /* arithmetic */
        const double_double u_start = dd_mul_xx(two_K, v); /* arithmetic */
        const double_double common_8 = dd_sub_dx(1.0, n); /* classical: DLMF 19.8.6, DLMF 19.36.1 */
        double_double quarter, total;
        complete(kc_1, common_8, &quarter, &total); /* classical: DLMF 19.8.6 */
        const double_double characteristic = n; /* arithmetic */
        const double_double j = dd_div_xx(total, dd_mul_dx(2.0, common_8)); /* classical: DLMF 19.8.6 */
        const double_double Lambda = dd_div_xd(dd_add_xx(psi_0, dd_mul_xx(dd_mul_xx(kappa, mu), j)), 2.0); /* fact: definition pi_form.Lambda; (33), (34) */
        const double_double Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
        const double_double spread = dd_mul_xx(dd_mul_xx(dd_neg(n), common_8), dd_sub_xx(dd_mul_xx(k_1, k_1), n)); /* classical: DLMF 19.36.1 */
        const double path = dd_rounded(dd_sub_dx(1.0, dd_mul_xx(n, dd_mul_xx(s, s)))); /* classical: DLMF 19.25.14 */
        const double J_0 = third_kind(dd_rounded(s), dd_rounded(c), dd_rounded(d), path, dd_rounded(spread)); /* classical: DLMF 19.25.14 */
        const double_double rest_0 = dd_div_xd(dd_mul_xx(kappa, dd_sub_dx(J_0, dd_mul_xx(j, u_start))), 2.0); /* fact: definition pi_form.rest_0; (36) */
        const double_double M_a = dd_mul_xx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_xx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_xx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double_double common_9 = dd_mul_dx(2.0, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double_double nu = dd_sqrt(dd_mul_xx(common_9, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
        const double_double s_0 = dd_div_xx(nu, common_9); /* fact: definition attitude.s_0; (27) */
        const double_double s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
        const double_double s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
        const double_double qbar_0 = s_0; /* fact: definition attitude.qbar_0; (18), (25) */
        const double qbar_a = 0.0; /* fact: definition attitude.qbar_a; (18), (25) */
        const double_double qbar_b = s_b; /* fact: definition attitude.qbar_b; (18), (25) */
        const double_double qbar_d = s_d; /* fact: definition attitude.qbar_d; (18), (25) */
        const double_double p_0 = dd_add_xx(dd_add_xx(dd_add_xx(dd_mul_xx(q_0, qbar_0), dd_mul_xd(q_a, qbar_a)), dd_mul_xx(q_b, qbar_b)), dd_mul_xx(q_d, qbar_d)); /* fact: attitude.p_0; (37) */
        const double_double p_a = dd_add_xx(dd_sub_xx(dd_mul_xx(q_a, qbar_0), dd_mul_xd(q_0, qbar_a)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_d, qbar_b), dd_mul_xx(q_b, qbar_d)))); /* fact: attitude.p_a; (37) */
        const double_double p_b = dd_add_xx(dd_sub_xx(dd_mul_xx(q_b, qbar_0), dd_mul_xx(q_0, qbar_b)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_a, qbar_d), dd_mul_xd(q_d, qbar_a)))); /* fact: attitude.p_b; (37) */
        const double_double p_d = dd_add_xx(dd_sub_xx(dd_mul_xx(q_d, qbar_0), dd_mul_xx(q_0, qbar_d)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xd(q_b, qbar_a), dd_mul_xx(q_a, qbar_b)))); /* fact: attitude.p_d; (37) */
        motion->v_rate_hi[i] = v_rate.hi;
        motion->v_rate_lo[i] = v_rate.lo;
        motion->v_hi[i] = v.hi;
        motion->v_lo[i] = v.lo;
        motion->Lambda_rate_hi[i] = Lambda_rate.hi;
        motion->Lambda_rate_lo[i] = Lambda_rate.lo;
        motion->k_2[i] = dd_rounded(k_2);
        motion->k_3[i] = dd_rounded(k_3);
        motion->k_4[i] = dd_rounded(k_4);
        motion->k_5[i] = dd_rounded(k_5);
        motion->characteristic[i] = dd_rounded(characteristic);
        motion->spread[i] = dd_rounded(spread);
        motion->kappa[i] = dd_rounded(kappa);
        motion->j[i] = dd_rounded(j);
        motion->two_K[i] = dd_rounded(two_K);
        motion->rest_0[i] = dd_rounded(rest_0);
        motion->c_a[i] = dd_rounded(c_a);
        motion->c_b[i] = dd_rounded(c_b);
        motion->c_d[i] = dd_rounded(c_d);
        motion->A_a[i] = dd_rounded(A_a);
        motion->A_b[i] = dd_rounded(A_b);
        motion->A_d[i] = dd_rounded(A_d);
        motion->K[i] = dd_rounded(K);
        motion->k_1[i] = dd_rounded(k_1);
        motion->k_c[i] = dd_rounded(k_c);
        motion->epsilon[i] = epsilon;
        motion->sigma[i] = sigma;
        motion->chi[i] = chi;
        motion->tau[i] = tau;
        motion->p_0[i] = dd_rounded(p_0);
        motion->p_a[i] = dd_rounded(p_a);
        motion->p_b[i] = dd_rounded(p_b);
        motion->p_d[i] = dd_rounded(p_d);
        motion->unit[i] = unit;
    }
}

/* Angles of the circular branch at t + t_lo. */
static void circular_angles(const torque_free_pi_circular *motion, size_t n, const double *restrict t_in,
    const double *restrict t_lo_in, double *restrict s_out, double *restrict c_out,
    double *restrict X_im_out, double *restrict X_re_out, double *restrict d_out)
{
    const double v_rate_hi = motion->v_rate_hi;
    const double v_rate_lo = motion->v_rate_lo;
    const double v_hi = motion->v_hi;
    const double v_lo = motion->v_lo;
    const double Lambda_rate_hi = motion->Lambda_rate_hi;
    const double Lambda_rate_lo = motion->Lambda_rate_lo;
    const double k_2 = motion->k_2;
    const double k_3 = motion->k_3;
    const double k_4 = motion->k_4;
    const double k_5 = motion->k_5;
    const double characteristic = motion->characteristic;
    const double spread = motion->spread;
    const double kappa = motion->kappa;
    const double j = motion->j;
    const double two_K = motion->two_K;
    const double rest_0 = motion->rest_0;
    for (size_t i = 0; i < n; i++) {
        const double t = t_in[i];
        const double t_lo = t_lo_in[i];
        const double p = v_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double p_error = product_error(v_rate_hi, t, p) + fused(v_rate_lo, t, fused(v_rate_hi, t_lo, v_lo)); /* arithmetic: Dekker 1971 */
        const double v = p + v_hi; /* arithmetic: Knuth 4.2.2 */
        const double v_other = v - p; /* arithmetic: Knuth 4.2.2 */
        const double v_error = p - (v - v_other) + (v_hi - v_other); /* arithmetic: Knuth 4.2.2 */
        const double v_whole = nearest(v); /* classical: DLMF 4.16 */
        const double v_rest = v - v_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double v_turns = v_rest + (p_error + v_error); /* classical: DLMF 4.16 */
        const double w_whole = nearest(v_turns); /* classical: DLMF 4.16 */
        const double w_rest = v_turns - w_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double half_periods = v_whole + w_whole; /* classical: DLMF 4.16 */
        const double w_square = w_rest * w_rest; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double w_sign = alternating(half_periods); /* classical: DLMF 4.16 */
        const double s_5 = w_sign * fused(w_rest, pi_hi, w_rest * fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double c_5 = w_sign * fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, fused(w_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        const double common_1 = k_5 * (s_5 * s_5); /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_2 = 1.0 + common_1; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s_4 = (1.0 + k_5) * s_5 / common_2; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c_4 = c_5 / common_2; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d_4 = (1.0 - common_1) / common_2; /* fact: definition landen.d; DLMF 22.7.2 */
        const double common_3 = k_4 * (s_4 * s_4); /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_4 = 1.0 + common_3; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s_3 = (1.0 + k_4) * s_4 / common_4; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c_3 = c_4 * d_4 / common_4; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d_3 = (1.0 - common_3) / common_4; /* fact: definition landen.d; DLMF 22.7.2 */
        const double common_5 = k_3 * (s_3 * s_3); /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_6 = 1.0 + common_5; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s_2 = (1.0 + k_3) * s_3 / common_6; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c_2 = c_3 * d_3 / common_6; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d_2 = (1.0 - common_5) / common_6; /* fact: definition landen.d; DLMF 22.7.2 */
        const double common_7 = k_2 * (s_2 * s_2); /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_8 = 1.0 + common_7; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s = (1.0 + k_2) * s_2 / common_8; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c = c_2 * d_2 / common_8; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d = (1.0 - common_7) / common_8; /* fact: definition landen.d; DLMF 22.7.2 */
        const double path = fused(-characteristic, s * s, 1.0); /* classical: DLMF 19.25.14 */
        const double J = w_sign * third_kind(s, fabs(c), d, path, spread); /* classical: DLMF 19.25.14 */
        const double u_1 = two_K * w_rest; /* classical: DLMF 19.2.7 */
        const double rest = kappa * fused(-j, u_1, J) / 2.0; /* fact: definition pi_form.rest; (36) */
        const double L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
        const double L_whole = nearest(L); /* classical: DLMF 4.16 */
        const double L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double psi_turns = L_rest + (L_error + (rest - rest_0) / pi_hi); /* arithmetic */
        const double psi_whole = nearest(psi_turns); /* classical: DLMF 4.16 */
        const double psi_rest = psi_turns - psi_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double whole = L_whole + psi_whole; /* classical: DLMF 4.16 */
        const double psi_square = psi_rest * psi_rest; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double psi_sign = alternating(whole); /* classical: DLMF 4.16 */
        const double X_im = psi_sign * fused(psi_rest, pi_hi, psi_rest * fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double X_re = psi_sign * fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        s_out[i] = s;
        c_out[i] = c;
        X_im_out[i] = X_im;
        X_re_out[i] = X_re;
        d_out[i] = d;
    }
}

/* The state on the circular branch, from `_circular_angles`. */
static void circular_state(const torque_free_pi_circular *motion, size_t n, const double *restrict s_in,
    const double *restrict c_in, const double *restrict X_im_in,
    const double *restrict X_re_in, const double *restrict d_in,
    double *restrict q_0_out, double *restrict q_a_out, double *restrict q_b_out,
    double *restrict q_d_out, double *restrict Omega_a_out, double *restrict Omega_b_out,
    double *restrict Omega_d_out)
{
    const double c_a = motion->c_a;
    const double c_b = motion->c_b;
    const double c_d = motion->c_d;
    const double A_a = motion->A_a;
    const double A_b = motion->A_b;
    const double A_d = motion->A_d;
    const double K = motion->K;
    const double k_1 = motion->k_1;
    const double k_c = motion->k_c;
    const double epsilon = motion->epsilon;
    const double sigma = motion->sigma;
    const double chi = motion->chi;
    const double tau = motion->tau;
    const double p_0 = motion->p_0;
    const double p_a = motion->p_a;
    const double p_b = motion->p_b;
    const double p_d = motion->p_d;
    const double unit = motion->unit;
    for (size_t i = 0; i < n; i++) {
        const double s = s_in[i];
        const double c = c_in[i];
        const double X_im = X_im_in[i];
        const double X_re = X_re_in[i];
        const double d = d_in[i];
        const double common_1 = s * s; /* fact: definition descended.sn, definition descended.cn, descended.dn; DLMF 22.7.2, DLMF 22.7.3, DLMF 22.7.4 */
        const double common_2 = fused(k_1, common_1, 1.0); /* fact: definition descended.sn, definition descended.cn, descended.dn; DLMF 22.7.2, DLMF 22.7.3, DLMF 22.7.4 */
        const double sn = (1.0 + k_1) * s / common_2; /* fact: definition descended.sn; DLMF 22.7.2 */
        const double cn = c * d / common_2; /* fact: definition descended.cn; DLMF 22.7.3 */
        const double dn = fused(c, c, 2.0 * k_c / (1.0 + k_c) * common_1) / common_2; /* fact: descended.dn; DLMF 22.7.4 */
        const double inner_a = sigma * A_a * dn; /* fact: definition regular.Omega_a; (10) */
        const double inner_b = chi * A_b * sn; /* fact: definition regular.Omega_b; (10) */
        const double inner_d = chi * tau * A_d * cn; /* fact: definition regular.Omega_d; (10) */
        const double M_a = c_a * inner_a; /* fact: definition attitude.M_a; (8) */
        const double M_b = c_b * inner_b; /* fact: definition attitude.M_b; (8) */
        const double M_d = c_d * inner_d; /* fact: definition attitude.M_d; (8) */
        const double common_3 = 2.0 * K; /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double nu = sqrt(common_3 * fused(sigma, M_a, K)); /* fact: attitude.nu; (27) */
        const double s_0 = nu / common_3; /* fact: definition attitude.s_0; (27) */
        const double s_b = sigma * epsilon * M_d / nu; /* fact: definition attitude.s_b; (28) */
        const double s_d = -sigma * epsilon * M_b / nu; /* fact: definition attitude.s_d; (28) */
        const double qbar_0 = X_re * s_0; /* fact: definition attitude.qbar_0; (18), (25) */
        const double qbar_a = sigma * X_im * s_0; /* fact: definition attitude.qbar_a; (18), (25) */
        const double common_4 = epsilon * sigma * X_im; /* fact: definition attitude.qbar_b, definition attitude.qbar_d; (18), (25) */
        const double qbar_b = fused(X_re, s_b, -(common_4 * s_d)); /* fact: definition attitude.qbar_b; (18), (25) */
        const double qbar_d = fused(X_re, s_d, common_4 * s_b); /* fact: definition attitude.qbar_d; (18), (25) */
        const double q_0 = fused(-p_d, qbar_d, fused(-p_b, qbar_b, fused(p_0, qbar_0, -(p_a * qbar_a)))); /* fact: definition attitude.q_0; (37) */
        const double q_a = fused(epsilon, fused(p_b, qbar_d, -(p_d * qbar_b)), fused(p_0, qbar_a, p_a * qbar_0)); /* fact: definition attitude.q_a; (37) */
        const double q_b = fused(epsilon, fused(p_d, qbar_a, -(p_a * qbar_d)), fused(p_0, qbar_b, p_b * qbar_0)); /* fact: definition attitude.q_b; (37) */
        const double q_d = fused(epsilon, fused(p_a, qbar_b, -(p_b * qbar_a)), fused(p_0, qbar_d, p_d * qbar_0)); /* fact: definition attitude.q_d; (37) */
        const double Omega_a = unit * inner_a; /* arithmetic */
        const double Omega_b = unit * inner_b; /* arithmetic */
        const double Omega_d = unit * inner_d; /* arithmetic */
        q_0_out[i] = q_0;
        q_a_out[i] = q_a;
        q_b_out[i] = q_b;
        q_d_out[i] = q_d;
        Omega_a_out[i] = Omega_a;
        Omega_b_out[i] = Omega_b;
        Omega_d_out[i] = Omega_d;
    }
}

/* The constants of a motion on the hyperbolic branch, from `_initial_state`. */
static FLAT void hyperbolic_constants(const lanes *restrict lane, hyperbolic_lanes *restrict motion)
{
    for (size_t i = 0; i < LANES; i++) {
        const double_double K = {lane->K_hi[i], lane->K_lo[i]};
        const double_double A_a = {lane->A_a_hi[i], lane->A_a_lo[i]};
        const double_double A_b = {lane->A_b_hi[i], lane->A_b_lo[i]};
        const double_double A_d = {lane->A_d_hi[i], lane->A_d_lo[i]};
        const double_double B_a = {lane->B_a_hi[i], lane->B_a_lo[i]};
        const double_double B_d = {lane->B_d_hi[i], lane->B_d_lo[i]};
        const double_double k_c = {lane->k_c_hi[i], lane->k_c_lo[i]};
        const double_double k_1 = {lane->k_1_hi[i], lane->k_1_lo[i]};
        const double_double kc_1 = {lane->kc_1_hi[i], lane->kc_1_lo[i]};
        const double_double m_c = {lane->m_c_hi[i], lane->m_c_lo[i]};
        const double_double mu = {lane->mu_hi[i], lane->mu_lo[i]};
        const double_double n = {lane->n_hi[i], lane->n_lo[i]};
        const double_double H = {lane->H_hi[i], lane->H_lo[i]};
        const double_double s = {lane->s_hi[i], lane->s_lo[i]};
        const double_double c = {lane->c_hi[i], lane->c_lo[i]};
        const double_double d = {lane->d_hi[i], lane->d_lo[i]};
        const double_double c_a = {lane->c_a_hi[i], lane->c_a_lo[i]};
        const double_double c_b = {lane->c_b_hi[i], lane->c_b_lo[i]};
        const double_double c_d = {lane->c_d_hi[i], lane->c_d_lo[i]};
        const double_double Omega_a = {lane->Omega_a_hi[i], lane->Omega_a_lo[i]};
        const double_double Omega_b = {lane->Omega_b_hi[i], lane->Omega_b_lo[i]};
        const double_double Omega_d = {lane->Omega_d_hi[i], lane->Omega_d_lo[i]};
        const double_double q_0 = {lane->q_0_hi[i], lane->q_0_lo[i]};
        const double_double q_a = {lane->q_a_hi[i], lane->q_a_lo[i]};
        const double_double q_b = {lane->q_b_hi[i], lane->q_b_lo[i]};
        const double_double q_d = {lane->q_d_hi[i], lane->q_d_lo[i]};
        const double epsilon = lane->epsilon[i];
        const double sigma = lane->sigma[i];
        const double rho = lane->rho[i];
        const double chi = lane->chi[i];
        const double unit = lane->unit[i];
        const double_double l_1 = kc_1; /* classical: DLMF 22.7.1 */
        const double_double lc_1 = k_1; /* classical: DLMF 22.7.1 */
        const double_double common_1 = dd_add_dx(1.0, lc_1); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_2 = dd_div_xx(l_1, common_1); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double l_2 = dd_mul_xx(common_2, common_2); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_1 = dd_sqrt(lc_1); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double lc_2 = dd_div_xx(dd_mul_dx(2.0, root_1), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_3 = dd_add_dx(1.0, lc_2); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_4 = dd_div_xx(l_2, common_3); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double l_3 = dd_mul_xx(common_4, common_4); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_2 = dd_sqrt(lc_2); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double lc_3 = dd_div_xx(dd_mul_dx(2.0, root_2), common_3); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_5 = dd_add_dx(1.0, lc_3); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_6 = dd_div_xx(l_3, common_5); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double l_4 = dd_mul_xx(common_6, common_6); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_3 = dd_sqrt(lc_3); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double lc_4 = dd_div_xx(dd_mul_dx(2.0, root_3), common_5); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_7 = dd_div_xx(l_4, dd_add_dx(1.0, lc_4)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double l_5 = dd_mul_xx(common_7, common_7); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_k = dd_sqrt(k_1); /* fact: theta_form.root_k; (27) */
        const double_double x = dd_div_xx(B_d, dd_mul_xx(root_k, dd_add_xx(K, B_a))); /* fact: definition theta_form.x; (28) */
        const double_double common_8 = dd_mul_xx(x, x); /* fact: theta_form.y, definition pi_near.g; DLMF 22.6.1, (36) */
        const double_double y = dd_sqrt(dd_add_dx(1.0, common_8)); /* fact: theta_form.y; DLMF 22.6.1 */
        const double_double common_9 = dd_mul_xx(k_1, x); /* fact: theta_form.z, definition pi_near.g; DLMF 22.6.1, (36) */
        const double_double z = dd_sqrt(dd_add_dx(1.0, dd_mul_xx(common_9, common_9))); /* fact: theta_form.z; DLMF 22.6.1 */
        const double_double size_s = dd_size(s); /* classical: DLMF 22.4.3 */
        const double_double common_10 = dd_mul_xx(c, c); /* fact: pi_near.T_size; DLMF 22.4.3, (36) */
        const double near = dd_rounded(common_10); /* classical: DLMF 22.4.3 */
        const double_double common_11 = dd_mul_xx(s, s); /* fact: pi_near.T_size; DLMF 22.4.3, (36) */
        const double far = dd_rounded(dd_mul_xx(kc_1, common_11)); /* classical: DLMF 22.4.3 */
        const double_double above = dd_choose(far, near, size_s, c); /* classical: DLMF 22.4.3 */
        const double_double common_12 = dd_mul_xx(kc_1, size_s); /* classical: DLMF 22.4.3, DLMF 22.4(iii) */
        const double_double below = dd_choose(far, near, c, common_12); /* classical: DLMF 22.4.3 */
        const double_double xi = dd_div_xx(above, below); /* classical: DLMF 22.6.7 */
        double_double K_c, sin_b, cos_b, Y_b;
        ladder(kc_1, k_1, dd_of(0.0), dd_of(1.0), dd_of(1.0), kc_1, xi, &K_c, &sin_b, &cos_b, &Y_b); /* classical: DLMF 19.8.12 */
        const double_double gc = dd_div_xx(pi, dd_mul_dx(2.0, K_c)); /* arithmetic */
        const double_double common_13 = dd_sub_dx(1.0, n); /* classical: DLMF 19.8.6 */
        double_double K_1, total;
        complete(kc_1, common_13, &K_1, &total); /* classical: DLMF 19.8.6 */
        const double_double characteristic = n; /* arithmetic */
        const double_double j = dd_div_xx(total, dd_mul_dx(2.0, common_13)); /* classical: DLMF 19.8.6 */
        const double_double common_14 = dd_mul_xx(z, z); /* fact: definition pi_near.delta, definition pi_near.g_1, definition pi_near.g_2, pi_near.T_size; (36) */
        const double_double delta = dd_div_xx(m_c, common_14); /* fact: definition pi_near.delta; (36) */
        const double_double n_2 = dd_sub_dx(1.0, delta); /* fact: definition pi_near.n_2; (36) */
        const double_double Lambda = dd_div_xx(H, K); /* fact: definition pi_near.Lambda; (36) */
        const double_double g = dd_div_xx(dd_mul_xx(dd_mul_xx(common_9, y), z), dd_add_dx(1.0, dd_mul_xx(k_1, common_8))); /* fact: definition pi_near.g; (36) */
        const double_double g_1 = dd_div_xx(dd_mul_xx(g, m_c), dd_mul_xx(dd_add_dx(1.0, k_1), common_14)); /* fact: definition pi_near.g_1; (36) */
        const double_double common_15 = dd_mul_xx(dd_mul_xx(dd_mul_xx(k_1, k_1), x), y); /* fact: definition pi_near.g_2, definition pi_near.slope; (36) */
        const double_double g_2 = dd_div_xx(dd_mul_xx(common_15, m_c), dd_mul_xx(common_14, z)); /* fact: definition pi_near.g_2; (36) */
        const double_double h_2 = dd_mul_xx(g_1, dd_add_xx(k_1, n_2)); /* fact: definition pi_near.h_2; (36) */
        const double_double slope = common_15; /* fact: definition pi_near.slope; (36) */
        const double_double alpha = dd_mul_xx(dd_mul_xx(g, K_1), dd_sub_dx(1.0, dd_mul_xx(dd_sub_xx(k_1, n), j))); /* fact: definition pi_near.alpha; (36) */
        const double_double Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
        const double_double common_16 = dd_mul_xx(dd_mul_xx(delta, k_1), x); /* classical: DLMF 19.36.1 */
        const double_double spread = dd_mul_xx(n_2, dd_mul_xx(common_16, common_16)); /* classical: DLMF 19.36.1 */
        const double kc_d = dd_rounded(kc_1); /* classical: DLMF 22.4(i) */
        const double_double period = dd_choose(kc_d, 0.0, dd_of(0.0), dd_mul_xx(dd_mul_dx(2.0, K_1), gc)); /* classical: DLMF 22.4(i) */
        const double period_far = choose(kc_d, 0.0, never, dd_rounded(period)); /* classical: DLMF 22.4(i) */
        const double period_d = dd_rounded(dd_choose(kc_d, 0.0, dd_of(1.0), period)); /* classical: DLMF 22.4(i) */
        const double period_inverse = choose(kc_d, 0.0, 0.0, 1.0 / period_d); /* classical: DLMF 22.4(i) */
        const double_double cosh_y = dd_sqrt(dd_add_dx(1.0, dd_mul_xx(Y_b, Y_b))); /* classical: DLMF 4.35.11 */
        const double_double y_b = logarithm(dd_add_xx(Y_b, cosh_y)); /* classical: DLMF 4.37.16 */
        const double_double y_size = dd_choose(far, near, y_b, dd_sub_xx(dd_div_xd(period, 2.0), y_b)); /* classical: DLMF 22.4.3 */
        const double side = choose(0.0, dd_rounded(s), 1.0, -1.0); /* classical: DLMF 22.4(i) */
        const double_double y0 = dd_mul_dx(side, y_size); /* arithmetic */
        const double_double y_rate = dd_mul_xx(mu, gc); /* arithmetic */
        const double_double jump = dd_div_xx(dd_mul_dx(-2.0 * rho, alpha), pi); /* classical: DLMF 19.2.7 */
        const double near_s = dd_rounded(dd_choose(far, near, size_s, dd_div_xx(c, d))); /* classical: DLMF 22.4(iii) */
        const double near_c = dd_rounded(dd_choose(far, near, c, dd_div_xx(common_12, d))); /* classical: DLMF 22.4(iii) */
        const double near_d = dd_rounded(dd_choose(far, near, d, dd_div_xx(kc_1, d))); /* classical: DLMF 22.4(iii) */
        const double cosine = choose(near_c, least_c, least_c, near_c); /* classical: DLMF 22.4(iii) */
        const double path = fused(cosine, cosine, dd_rounded(delta) * (near_s * near_s)); /* classical: DLMF 19.25.14 */
        const double third = third_kind(near_s, cosine, near_d, path, dd_rounded(spread)); /* classical: DLMF 19.25.14 */
        const double_double w = dd_div_xx(y_b, gc); /* arithmetic */
        const double_double common_17 = dd_mul_xx(g_1, w); /* arithmetic */
        const double_double from_crossing = dd_add_xx(common_17, dd_mul_xd(g_2, third)); /* arithmetic */
        const double_double from_saddle = dd_sub_xx(alpha, dd_add_xx(common_17, dd_mul_xd(h_2, third))); /* arithmetic */
        const double_double rest = dd_choose(far, near, from_crossing, from_saddle); /* arithmetic */
        const double_double start_rest = dd_mul_dx(side, rest); /* arithmetic */
        const double_double T_size = dd_sqrt(dd_mul_xx(dd_mul_xx(common_14, dd_sub_dx(1.0, dd_mul_xx(n, common_11))), dd_add_xx(common_10, dd_mul_xx(delta, common_11)))); /* fact: pi_near.T_size; (36) */
        const double_double T_re = dd_div_xx(dd_mul_xx(z, d), T_size); /* fact: definition arctangent.T_re; (36) */
        const double_double T_im = dd_div_xx(dd_mul_xx(dd_mul_xx(dd_mul_dx(-rho, slope), s), c), T_size); /* fact: definition arctangent.T_im; (36) */
        const double_double start_re = dd_choose(far, near, T_re, dd_of(1.0)); /* arithmetic */
        const double_double start_im = dd_choose(far, near, T_im, dd_of(0.0)); /* arithmetic */
        const double_double M_a = dd_mul_xx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_xx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_xx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double_double common_18 = dd_mul_dx(2.0, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double_double nu = dd_sqrt(dd_mul_xx(common_18, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
        const double_double s_0 = dd_div_xx(nu, common_18); /* fact: definition attitude.s_0; (27) */
        const double_double s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
        const double_double s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
        const double_double qbar_0 = dd_mul_xx(start_re, s_0); /* fact: definition attitude.qbar_0; (18), (25) */
        const double_double qbar_a = dd_mul_xx(dd_mul_dx(sigma, start_im), s_0); /* fact: definition attitude.qbar_a; (18), (25) */
        const double_double common_19 = dd_mul_dx(epsilon * sigma, start_im); /* fact: definition attitude.qbar_b, definition attitude.qbar_d; (18), (25) */
        const double_double qbar_b = dd_sub_xx(dd_mul_xx(start_re, s_b), dd_mul_xx(common_19, s_d)); /* fact: definition attitude.qbar_b; (18), (25) */
        const double_double qbar_d = dd_add_xx(dd_mul_xx(start_re, s_d), dd_mul_xx(common_19, s_b)); /* fact: definition attitude.qbar_d; (18), (25) */
        const double_double p_0 = dd_add_xx(dd_add_xx(dd_add_xx(dd_mul_xx(q_0, qbar_0), dd_mul_xx(q_a, qbar_a)), dd_mul_xx(q_b, qbar_b)), dd_mul_xx(q_d, qbar_d)); /* fact: attitude.p_0; (37) */
        const double_double p_a = dd_add_xx(dd_sub_xx(dd_mul_xx(q_a, qbar_0), dd_mul_xx(q_0, qbar_a)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_d, qbar_b), dd_mul_xx(q_b, qbar_d)))); /* fact: attitude.p_a; (37) */
        const double_double p_b = dd_add_xx(dd_sub_xx(dd_mul_xx(q_b, qbar_0), dd_mul_xx(q_0, qbar_b)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_a, qbar_d), dd_mul_xx(q_d, qbar_a)))); /* fact: attitude.p_b; (37) */
        const double_double p_d = dd_add_xx(dd_sub_xx(dd_mul_xx(q_d, qbar_0), dd_mul_xx(q_0, qbar_d)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_b, qbar_a), dd_mul_xx(q_a, qbar_b)))); /* fact: attitude.p_d; (37) */
        motion->y_rate_hi[i] = y_rate.hi;
        motion->y_rate_lo[i] = y_rate.lo;
        motion->y0_hi[i] = y0.hi;
        motion->y0_lo[i] = y0.lo;
        motion->period_hi[i] = period.hi;
        motion->period_lo[i] = period.lo;
        motion->Lambda_rate_hi[i] = Lambda_rate.hi;
        motion->Lambda_rate_lo[i] = Lambda_rate.lo;
        motion->jump_hi[i] = jump.hi;
        motion->jump_lo[i] = jump.lo;
        motion->period_far[i] = period_far;
        motion->period_inverse[i] = period_inverse;
        motion->l_2[i] = dd_rounded(l_2);
        motion->l_3[i] = dd_rounded(l_3);
        motion->l_4[i] = dd_rounded(l_4);
        motion->l_5[i] = dd_rounded(l_5);
        motion->gc[i] = dd_rounded(gc);
        motion->kc_1[i] = dd_rounded(kc_1);
        motion->m_c[i] = dd_rounded(m_c);
        motion->rho[i] = rho;
        motion->g_1[i] = dd_rounded(g_1);
        motion->g_2[i] = dd_rounded(g_2);
        motion->h_2[i] = dd_rounded(h_2);
        motion->alpha[i] = dd_rounded(alpha);
        motion->delta[i] = dd_rounded(delta);
        motion->spread[i] = dd_rounded(spread);
        motion->slope[i] = dd_rounded(slope);
        motion->z[i] = dd_rounded(z);
        motion->characteristic[i] = dd_rounded(characteristic);
        motion->start_rest[i] = dd_rounded(start_rest);
        motion->c_a[i] = dd_rounded(c_a);
        motion->c_b[i] = dd_rounded(c_b);
        motion->c_d[i] = dd_rounded(c_d);
        motion->A_a[i] = dd_rounded(A_a);
        motion->A_b[i] = dd_rounded(A_b);
        motion->A_d[i] = dd_rounded(A_d);
        motion->K[i] = dd_rounded(K);
        motion->k_1[i] = dd_rounded(k_1);
        motion->k_c[i] = dd_rounded(k_c);
        motion->epsilon[i] = epsilon;
        motion->sigma[i] = sigma;
        motion->chi[i] = chi;
        motion->tau[i] = tau;
        motion->p_0[i] = dd_rounded(p_0);
        motion->p_a[i] = dd_rounded(p_a);
        motion->p_b[i] = dd_rounded(p_b);
        motion->p_d[i] = dd_rounded(p_d);
        motion->unit[i] = unit;
    }
}

/* Angles of the hyperbolic branch at t + t_lo. */
static void hyperbolic_angles(const torque_free_pi_hyperbolic *motion, size_t n, const double *restrict t_in,
    const double *restrict t_lo_in, double *restrict s_out, double *restrict c_out,
    double *restrict X_im_out, double *restrict X_re_out, double *restrict d_out)
{
    const double y_rate_hi = motion->y_rate_hi;
    const double y_rate_lo = motion->y_rate_lo;
    const double y0_hi = motion->y0_hi;
    const double y0_lo = motion->y0_lo;
    const double period_hi = motion->period_hi;
    const double period_lo = motion->period_lo;
    const double Lambda_rate_hi = motion->Lambda_rate_hi;
    const double Lambda_rate_lo = motion->Lambda_rate_lo;
    const double jump_hi = motion->jump_hi;
    const double jump_lo = motion->jump_lo;
    const double period_far = motion->period_far;
    const double period_inverse = motion->period_inverse;
    const double l_2 = motion->l_2;
    const double l_3 = motion->l_3;
    const double l_4 = motion->l_4;
    const double l_5 = motion->l_5;
    const double gc = motion->gc;
    const double kc_1 = motion->kc_1;
    const double m_c = motion->m_c;
    const double rho = motion->rho;
    const double g_1 = motion->g_1;
    const double g_2 = motion->g_2;
    const double h_2 = motion->h_2;
    const double alpha = motion->alpha;
    const double delta = motion->delta;
    const double spread = motion->spread;
    const double slope = motion->slope;
    const double z = motion->z;
    const double characteristic = motion->characteristic;
    const double start_rest = motion->start_rest;
    for (size_t i = 0; i < n; i++) {
        const double t = t_in[i];
        const double t_lo = t_lo_in[i];
        const double p_y = y_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double p_y_error = product_error(y_rate_hi, t, p_y) + fused(y_rate_lo, t, fused(y_rate_hi, t_lo, y0_lo)); /* arithmetic: Dekker 1971 */
        const double periods = nearest((p_y + y0_hi) * period_inverse); /* classical: DLMF 22.4(i) */
        const double back = period_hi * periods; /* arithmetic: Dekker 1971 */
        const double back_error = fused(period_lo, periods, product_error(period_hi, periods, back)); /* arithmetic: Dekker 1971 */
        const double ahead = p_y + -back; /* arithmetic: Knuth 4.2.2 */
        const double ahead_other = ahead - p_y; /* arithmetic: Knuth 4.2.2 */
        const double ahead_error = p_y - (ahead - ahead_other) + (-back - ahead_other); /* arithmetic: Knuth 4.2.2 */
        const double y_near = ahead + y0_hi; /* arithmetic: Knuth 4.2.2 */
        const double y_near_other = y_near - ahead; /* arithmetic: Knuth 4.2.2 */
        const double y_near_error = ahead - (y_near - y_near_other) + (y0_hi - y_near_other); /* arithmetic: Knuth 4.2.2 */
        const double y = y_near + (y_near_error + (ahead_error + (p_y_error - back_error))); /* classical: DLMF 22.4(i) */
        const double side = choose(0.0, y, 1.0, -1.0); /* classical: DLMF 22.4(i) */
        const double flip = alternating(periods); /* classical: DLMF 22.4(i) */
        const double depth = fabs(y); /* classical: DLMF 22.4(i) */
        const double quarter = period_far / 4.0; /* classical: DLMF 22.4(i) */
        const double nearer = choose(depth, quarter, depth, fused(2.0, quarter, -depth)); /* classical: DLMF 22.4(iii) */
        const double bounded = choose(nearer, deepest, nearer, deepest); /* classical: DLMF 4.28 */
        const double falling = exponential(-bounded); /* classical: DLMF 4.28.1 */
        const double x_5 = fused(-falling, falling, 1.0) / (2.0 * falling); /* classical: DLMF 4.28.1 */
        const double inside_4 = fused(-l_5, x_5 * x_5, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x_4 = (1.0 + l_5) * x_5 / inside_4; /* fact: definition landen.x; DLMF 22.7.2 */
        const double inside_3 = fused(-l_4, x_4 * x_4, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x_3 = (1.0 + l_4) * x_4 / inside_3; /* fact: definition landen.x; DLMF 22.7.2 */
        const double inside_2 = fused(-l_3, x_3 * x_3, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x_2 = (1.0 + l_3) * x_3 / inside_2; /* fact: definition landen.x; DLMF 22.7.2 */
        const double inside = fused(-l_2, x_2 * x_2, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x = (1.0 + l_2) * x_2 / inside; /* fact: definition landen.x; DLMF 22.7.2 */
        const double common_1 = x * x; /* classical: DLMF 22.6.1 */
        const double size_x = sqrt(1.0 + common_1); /* classical: DLMF 22.6.1 */
        const double near_c = 1.0 / size_x; /* classical: DLMF 22.6.1 */
        const double near_size = x * near_c; /* classical: DLMF 22.6.1 */
        const double near_d = near_c * sqrt(fused(m_c, common_1, 1.0)); /* classical: DLMF 22.6.1 */
        const double common_2 = near_c * near_c; /* fact: pi_near.T_size; DLMF 19.25.14, (36) */
        const double path = fused(delta, near_size * near_size, common_2); /* classical: DLMF 19.25.14 */
        const double third = third_kind(near_size, near_c, near_d, path, spread); /* classical: DLMF 19.25.14 */
        const double w = bounded / gc; /* arithmetic */
        const double common_3 = g_1 * w; /* arithmetic */
        const double from_crossing = fused(g_2, third, common_3); /* arithmetic */
        const double from_saddle = alpha - fused(h_2, third, common_3); /* arithmetic */
        const double rest = choose(depth, quarter, from_crossing, from_saddle); /* arithmetic */
        const double near_s = side * near_size; /* arithmetic */
        const double common_4 = near_s * near_s; /* fact: pi_near.T_size; (36) */
        const double T_size = sqrt(z * z * fused(-characteristic, common_4, 1.0) * fused(delta, common_4, common_2)); /* fact: pi_near.T_size; (36) */
        const double T_re = z * near_d / T_size; /* fact: definition arctangent.T_re; (36) */
        const double T_im = -rho * slope * near_s * near_c / T_size; /* fact: definition arctangent.T_im; (36) */
        const double L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
        const double L_whole = nearest(L); /* classical: DLMF 4.16 */
        const double L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double j = jump_hi * periods; /* arithmetic: Dekker 1971 */
        const double j_error = fused(jump_lo, periods, product_error(jump_hi, periods, j)); /* arithmetic: Dekker 1971 */
        const double j_whole = nearest(j); /* classical: DLMF 4.16 */
        const double j_rest = j - j_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double turned = L_rest + j_rest; /* arithmetic: Knuth 4.2.2 */
        const double turned_other = turned - L_rest; /* arithmetic: Knuth 4.2.2 */
        const double turned_error = L_rest - (turned - turned_other) + (j_rest - turned_other); /* arithmetic: Knuth 4.2.2 */
        const double turned_whole = nearest(turned); /* classical: DLMF 4.16 */
        const double turned_rest = turned - turned_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double turns = turned_rest + (turned_error + (L_error + j_error)); /* classical: DLMF 4.16 */
        const double whole = L_whole + (j_whole + turned_whole); /* classical: DLMF 4.16 */
        const double psi_turns = turns - rho * fused(side, rest, -start_rest) / pi_hi; /* arithmetic */
        const double psi_whole = nearest(psi_turns); /* classical: DLMF 4.16 */
        const double psi_rest = psi_turns - psi_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double psi_all = whole + psi_whole; /* classical: DLMF 4.16 */
        const double psi_square = psi_rest * psi_rest; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double psi_sign = alternating(psi_all); /* classical: DLMF 4.16 */
        const double turn_im = psi_sign * fused(psi_rest, pi_hi, psi_rest * fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double turn_re = psi_sign * fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, fused(psi_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        const double arc_re = choose(depth, quarter, T_re, 1.0); /* arithmetic */
        const double arc_im = choose(depth, quarter, T_im, 0.0); /* arithmetic */
        const double X_re = fused(turn_re, arc_re, -(turn_im * arc_im)); /* fact: definition pi_near.cos_half_psi; (18) */
        const double X_im = fused(turn_re, arc_im, turn_im * arc_re); /* fact: definition pi_near.sin_half_psi; (18) */
        const double over_d = 1.0 / near_d; /* classical: DLMF 22.4(iii) */
        const double size_s = choose(depth, quarter, near_size, near_c * over_d); /* classical: DLMF 22.4(iii) */
        const double size_c = choose(depth, quarter, near_c, kc_1 * near_size * over_d); /* classical: DLMF 22.4(iii) */
        const double d = choose(depth, quarter, near_d, kc_1 * over_d); /* classical: DLMF 22.4(iii) */
        const double s = flip * (side * size_s); /* classical: DLMF 22.4(i) */
        const double c = flip * size_c; /* classical: DLMF 22.4(i) */
        s_out[i] = s;
        c_out[i] = c;
        X_im_out[i] = X_im;
        X_re_out[i] = X_re;
        d_out[i] = d;
    }
}

/* The state on the hyperbolic branch, from `_hyperbolic_angles`. */
static void hyperbolic_state(const torque_free_pi_hyperbolic *motion, size_t n, const double *restrict s_in,
    const double *restrict c_in, const double *restrict X_im_in,
    const double *restrict X_re_in, const double *restrict d_in,
    double *restrict q_0_out, double *restrict q_a_out, double *restrict q_b_out,
    double *restrict q_d_out, double *restrict Omega_a_out, double *restrict Omega_b_out,
    double *restrict Omega_d_out)
{
    const double c_a = motion->c_a;
    const double c_b = motion->c_b;
    const double c_d = motion->c_d;
    const double A_a = motion->A_a;
    const double A_b = motion->A_b;
    const double A_d = motion->A_d;
    const double K = motion->K;
    const double k_1 = motion->k_1;
    const double k_c = motion->k_c;
    const double epsilon = motion->epsilon;
    const double sigma = motion->sigma;
    const double chi = motion->chi;
    const double tau = motion->tau;
    const double p_0 = motion->p_0;
    const double p_a = motion->p_a;
    const double p_b = motion->p_b;
    const double p_d = motion->p_d;
    const double unit = motion->unit;
    for (size_t i = 0; i < n; i++) {
        const double s = s_in[i];
        const double c = c_in[i];
        const double X_im = X_im_in[i];
        const double X_re = X_re_in[i];
        const double d = d_in[i];
        const double common_1 = s * s; /* fact: definition descended.sn, definition descended.cn, descended.dn; DLMF 22.7.2, DLMF 22.7.3, DLMF 22.7.4 */
        const double common_2 = fused(k_1, common_1, 1.0); /* fact: definition descended.sn, definition descended.cn, descended.dn; DLMF 22.7.2, DLMF 22.7.3, DLMF 22.7.4 */
        const double sn = (1.0 + k_1) * s / common_2; /* fact: definition descended.sn; DLMF 22.7.2 */
        const double cn = c * d / common_2; /* fact: definition descended.cn; DLMF 22.7.3 */
        const double dn = fused(c, c, 2.0 * k_c / (1.0 + k_c) * common_1) / common_2; /* fact: descended.dn; DLMF 22.7.4 */
        const double inner_a = sigma * A_a * dn; /* fact: definition regular.Omega_a; (10) */
        const double inner_b = chi * A_b * sn; /* fact: definition regular.Omega_b; (10) */
        const double inner_d = chi * tau * A_d * cn; /* fact: definition regular.Omega_d; (10) */
        const double M_a = c_a * inner_a; /* fact: definition attitude.M_a; (8) */
        const double M_b = c_b * inner_b; /* fact: definition attitude.M_b; (8) */
        const double M_d = c_d * inner_d; /* fact: definition attitude.M_d; (8) */
        const double common_3 = 2.0 * K; /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double nu = sqrt(common_3 * fused(sigma, M_a, K)); /* fact: attitude.nu; (27) */
        const double s_0 = nu / common_3; /* fact: definition attitude.s_0; (27) */
        const double s_b = sigma * epsilon * M_d / nu; /* fact: definition attitude.s_b; (28) */
        const double s_d = -sigma * epsilon * M_b / nu; /* fact: definition attitude.s_d; (28) */
        const double qbar_0 = X_re * s_0; /* fact: definition attitude.qbar_0; (18), (25) */
        const double qbar_a = sigma * X_im * s_0; /* fact: definition attitude.qbar_a; (18), (25) */
        const double common_4 = epsilon * sigma * X_im; /* fact: definition attitude.qbar_b, definition attitude.qbar_d; (18), (25) */
        const double qbar_b = fused(X_re, s_b, -(common_4 * s_d)); /* fact: definition attitude.qbar_b; (18), (25) */
        const double qbar_d = fused(X_re, s_d, common_4 * s_b); /* fact: definition attitude.qbar_d; (18), (25) */
        const double q_0 = fused(-p_d, qbar_d, fused(-p_b, qbar_b, fused(p_0, qbar_0, -(p_a * qbar_a)))); /* fact: definition attitude.q_0; (37) */
        const double q_a = fused(epsilon, fused(p_b, qbar_d, -(p_d * qbar_b)), fused(p_0, qbar_a, p_a * qbar_0)); /* fact: definition attitude.q_a; (37) */
        const double q_b = fused(epsilon, fused(p_d, qbar_a, -(p_a * qbar_d)), fused(p_0, qbar_b, p_b * qbar_0)); /* fact: definition attitude.q_b; (37) */
        const double q_d = fused(epsilon, fused(p_a, qbar_b, -(p_b * qbar_a)), fused(p_0, qbar_d, p_d * qbar_0)); /* fact: definition attitude.q_d; (37) */
        const double Omega_a = unit * inner_a; /* arithmetic */
        const double Omega_b = unit * inner_b; /* arithmetic */
        const double Omega_d = unit * inner_d; /* arithmetic */
        q_0_out[i] = q_0;
        q_a_out[i] = q_a;
        q_b_out[i] = q_b;
        q_d_out[i] = q_d;
        Omega_a_out[i] = Omega_a;
        Omega_b_out[i] = Omega_b;
        Omega_d_out[i] = Omega_d;
    }
}

/* The axis and the rate of a motion with constant rates. */
static void steady_constants(double_double Omega1, double_double Omega2, double_double Omega3, double_double p0,
    double_double p1, double_double p2, double_double p3, torque_free_pi_steady *motion)
{
    const double_double omega = dd_sqrt(dd_add_xx(dd_add_xx(dd_mul_xx(Omega1, Omega1), dd_mul_xx(Omega2, Omega2)), dd_mul_xx(Omega3, Omega3))); /* fact: steady.omega; (3) */
    const double_double axis1 = dd_div_xx(Omega1, omega); /* fact: definition steady.axis1; (3) */
    const double_double axis2 = dd_div_xx(Omega2, omega); /* fact: definition steady.axis2; (3) */
    const double_double axis3 = dd_div_xx(Omega3, omega); /* fact: definition steady.axis3; (3) */
    const double_double Lambda_rate = dd_div_xx(omega, dd_mul_dx(2.0, pi)); /* arithmetic */
    motion->Lambda_rate_hi = Lambda_rate.hi;
    motion->Lambda_rate_lo = Lambda_rate.lo;
    motion->axis1 = dd_rounded(axis1);
    motion->axis2 = dd_rounded(axis2);
    motion->axis3 = dd_rounded(axis3);
    motion->p0 = dd_rounded(p0);
    motion->p1 = dd_rounded(p1);
    motion->p2 = dd_rounded(p2);
    motion->p3 = dd_rounded(p3);
}

/* Angles of the steady branch at t + t_lo. */
static void steady_angles(const torque_free_pi_steady *motion, size_t n, const double *restrict t_in,
    const double *restrict t_lo_in, double *restrict X_im_out, double *restrict X_re_out)
{
    const double Lambda_rate_hi = motion->Lambda_rate_hi;
    const double Lambda_rate_lo = motion->Lambda_rate_lo;
    for (size_t i = 0; i < n; i++) {
        const double t = t_in[i];
        const double t_lo = t_lo_in[i];
        const double L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
        const double L_whole = nearest(L); /* classical: DLMF 4.16 */
        const double L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double L_turns = L_rest + L_error; /* classical: DLMF 4.16 */
        const double L_square = L_turns * L_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double L_sign = alternating(L_whole); /* classical: DLMF 4.16 */
        const double X_im = L_sign * fused(L_turns, pi_hi, L_turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        X_im_out[i] = X_im;
        X_re_out[i] = X_re;
    }
}

/* The attitude from `_steady_angles`. */
static void steady_state(const torque_free_pi_steady *motion, size_t n, const double *restrict X_im_in,
    const double *restrict X_re_in, double *restrict q0_out, double *restrict q1_out,
    double *restrict q2_out, double *restrict q3_out)
{
    const double axis1 = motion->axis1;
    const double axis2 = motion->axis2;
    const double axis3 = motion->axis3;
    const double p0 = motion->p0;
    const double p1 = motion->p1;
    const double p2 = motion->p2;
    const double p3 = motion->p3;
    for (size_t i = 0; i < n; i++) {
        const double X_im = X_im_in[i];
        const double X_re = X_re_in[i];
        const double cos_half_theta = X_re; /* fact: reading steady.cos_half_theta; (3) */
        const double sin_half_theta = X_im; /* fact: reading steady.sin_half_theta; (3) */
        const double r1 = sin_half_theta * axis1; /* fact: definition steady.r1; (37) */
        const double r2 = sin_half_theta * axis2; /* fact: definition steady.r2; (37) */
        const double r3 = sin_half_theta * axis3; /* fact: definition steady.r3; (37) */
        const double q0 = fused(-p3, r3, fused(-p2, r2, fused(p0, cos_half_theta, -(p1 * r1)))); /* fact: definition steady.q0; (37) */
        const double q1 = fused(-p3, r2, fused(p2, r3, fused(p0, r1, p1 * cos_half_theta))); /* fact: definition steady.q1; (37) */
        const double q2 = fused(-p1, r3, fused(p3, r1, fused(p0, r2, p2 * cos_half_theta))); /* fact: definition steady.q2; (37) */
        const double q3 = fused(-p2, r1, fused(p1, r2, fused(p0, r3, p3 * cos_half_theta))); /* fact: definition steady.q3; (37) */
        q0_out[i] = q0;
        q1_out[i] = q1;
        q2_out[i] = q2;
        q3_out[i] = q3;
    }
}

/* Tests of the arithmetic of this very build, which the compiler's options can spoil: a `volatile` zero is
   in all numbers, so that no compiler can compute the outcome. */

static int is_double_double(double_double x, double hi, double lo)
{
    return fabs(x.hi - hi) <= 0.0 && fabs(x.lo - lo) <= 1e-30;
}

/* Return 1 where the compiler itself fuses no product with a sum, or where the bits were not chosen. */
static int bits_hold(void)
{
    const volatile double zero = 0.0;
    const double more = zero + 1.000000000931322574615478515625, less = zero + 0.999999999068677425384521484375;
    return !BITS_ARE_CHOSEN || fabs(more * less - (zero + 1.0)) <= 0.0;
}

/* Return 1 where sums and products are rounded once, to nearest, and no low part is lost. */
static int sums_hold(void)
{
    const volatile double zero = 0.0;
    const double one = zero + 1.0, many = zero + 49.0, part = zero + 0.02040816326530612;
    const double tiny = zero + 8.673617379884035e-19;
    const double_double third = {one * over_3.hi, one * over_3.lo}, seventh = {one * over_7.hi, one * over_7.lo};
    return bits_hold() && is_double_double(two_sum(one, tiny), 1.0, 8.673617379884035e-19) &&
           is_double_double(two_sum(-tiny, one), 1.0, -8.673617379884035e-19) &&
           is_double_double(two_product(part, many), 0.9999999999999999, 3.122502256758253e-17) &&
           is_double_double(dd_mul_xx(third, third), over_9.hi, over_9.lo) &&
           is_double_double(dd_mul_xx(third, dd_mul_dx(one, over_5)), over_15.hi, over_15.lo) &&
           is_double_double(dd_mul_xd(seventh, many), 7.0, 0.0);
}

/* Return 1 where a difference of products has all its digits: clang's -ffp-contract=fast fuses sums
   with products across functions, so that low parts are counted twice. */
static int differences_hold(void)
{
    static const double given[] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596,
                                   0.15335179025447007, 0.03588181116623288};
    const volatile double zero = 0.0;
    double_double x[5];
    for (int k = 0; k < 5; k++)
        x[k] = dd_of(zero + given[k]);
    const double_double above = dd_add_xx(x[0], dd_neg(x[1])), below = dd_add_xx(x[1], dd_neg(x[2]));
    return is_double_double(discriminant_dd(x[0], x[2], above, below, x[3], x[4]), 0.004108897986419382,
                   -6.277847770376781e-21);
}

/* Return 1 where quotients and roots have all their digits: y (x/y) is not x, nor a root's square its
   radicand.  Compilers that assume so are wrong in one quotient of five, some of which are here. */
static int quotients_hold(void)
{
    static const double quotients[][4] = {
        {7.0, 3.0, 2.3333333333333335, -1.4802973661668753e-16},
        {3.0, 5.0, 0.6, 2.2204460492503132e-17},
        {7.0, 25.0, 0.28, -2.6645352591003756e-17},
        {15.0, 13.0, 1.1538461538461537, 1.0248212535001446e-16},
        {15.0, 22.0, 0.6818181818181818, 5.0464682937507114e-17},
        {13.0, 23.0, 0.5652173913043478, 4.344350965924526e-17}};
    const volatile double zero = 0.0;
    const double_double root = dd_sqrt(dd_of(zero + 2.0));
    int holds = is_double_double(root, 1.4142135623730951, -9.667293313452913e-17);
    for (size_t k = 0; k < sizeof quotients / sizeof *quotients; k++) {
        const double *known = quotients[k], x = zero + known[0], y = zero + known[1];
        holds &= is_double_double(dd_div_xd(dd_of(x), y), known[2], known[3]);
        holds &= is_double_double(dd_div_dx(x, dd_of(y)), known[2], known[3]);
    }
    return holds;
}

/* Return 1 where the loop over times loses no turns: at t = 2^45 - 3 + i both angles, (t + 1)/3 and t/3 half
   turns, are multiples of sixty degrees, and their whole turns and all low parts count. */
static int angles_hold(void)
{
    static const double cosines[] = {1.0, 0.5, -0.5, -1.0, -0.5, 0.5};
    enum { TIMES = 8 };
    const volatile double from = 35184372088829.0;
    enum { COSINE = TIMES, TURNED = 3 * TIMES };
    const size_t s = TIMES;
    double t[TIMES], t_lo[TIMES], to[6 * TIMES];
    torque_free_pi_circular motion;
    int holds = 1;
    memset(&motion, 0, sizeof motion);
    motion.v_rate_hi = motion.Lambda_rate_hi = motion.v_hi = over_3.hi;
    motion.v_rate_lo = motion.Lambda_rate_lo = motion.v_lo = over_3.lo;
    for (int i = 0; i < TIMES; i++) {
        t[i] = from + (double)i;
        t_lo[i] = 0.0;
    }
    circular_angles(&motion, TIMES, t, t_lo, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s);
    for (int i = 0; i < TIMES; i++) {
        holds &= fabs(to[COSINE + i] - cosines[i % 6]) <= 1e-15;
        holds &= fabs(to[TURNED + i] - cosines[(i + 5) % 6]) <= 1e-15;
    }
    return holds;
}

static int is_rounded_once(void)
{
    return sums_hold() && differences_hold() && quotients_hold() && angles_hold();
}

static const double negligible = 3.8725919148493183e-121; /* 2^-400, rates below this share of the largest are taken for zero */
static const double decisive = 8.470329472543003e-22; /* 2^-70, share of a tilt; rates that cause less may be taken for zero */
static const double min_discriminant = 1.1830521861667747e-271; /* 2^-900, E_b in inner units; below it, motions are on the separatrix */
static const double tolerated = 8.673617379884035e-19; /* 2^-60, error of such motions, as a share of the momentum */
static const double min_moment_ratio = 6.223015277861142e-61; /* 2^-200, ratio of two principal moments */
static const double max_circular = 0.5; /* 2^-1, k_1^2 on the circular branch; above it, the hyperbolic one */
static const double max_angle = 70368744177664.0; /* 2^46, |omega0 t|, rad */
static const double max_rate = 1.0463951242053392e+298; /* 2^990, a rate, rad/s; exact products with it do not overflow */
#define BLOCK ((size_t)TORQUE_FREE_PI_BLOCK)

/* The mark of a prepared motion: a number that memory hardly has by chance. */
enum { PREPARED = 0x7f4a7c15 };

/* Return 1 for moments that a body can have, up to rounding: the largest is at most the sum of the
   others, or that sum as a double, or beyond it by 2^-50 of the smallest. */
static int can_exist(const double_double c[3])
{
#ifdef ALLOW_NONPHYSICAL
    (void)c;
    return 1;
#else
    int high = 0;
    for (int k = 1; k < 3; k++)
        if (c[k].hi > c[high].hi || (c[k].hi >= c[high].hi && c[k].lo > c[high].lo))
            high = k;
    const double_double one = c[(high + 1) % 3], other = c[(high + 2) % 3], total = dd_add_xx(one, other);
    const double_double beyond = two_sum(c[high].hi - total.hi, c[high].lo - total.lo);
    const double allowed = 8.881784197001252e-16 * (one.hi < other.hi ? one.hi : other.hi);
    return c[high].hi < total.hi || (c[high].hi <= total.hi && c[high].lo <= 0.0) || beyond.hi < allowed ||
           (beyond.hi <= allowed && beyond.lo <= 0.0);
#endif
}

/* Exponent of the largest, so that x 2^-exponent is below 2; 0 for zeros. */
static int exponent_of(size_t n, const double *x)
{
    double largest = 0.0;
    int e;
    for (size_t k = 0; k < n; k++)
        largest = fabs(x[k]) > largest ? fabs(x[k]) : largest;
    (void)frexp(largest, &e);
    return e - 1;
}

/* x 2^n, by `ldexp` where 2^n is no normal double. */
static double scaled_by(double x, int n)
{
    return n >= -1022 && n <= 1023 ? x * power_of_two((double)n) : ldexp(x, n);
}

static double_double scaled(double_double x, int n)
{
    const double_double y = {scaled_by(x.hi, n), scaled_by(x.lo, n)};
    return y;
}

static int all_finite(size_t n, const double *x)
{
    for (size_t k = 0; k < n; k++)
        if (!isfinite(x[k]))
            return 0;
    return 1;
}

static int is_zero(double_double x) { return !(x.hi < 0.0 || x.hi > 0.0); }

/* c_j - c_k of two different axes; apart holds the differences of each moment and the next in turn. */
static double_double difference(const double_double apart[3], int j, int k)
{
    return k == (j + 1) % 3 ? apart[j] : dd_neg(apart[k]);
}

/* Sort the axes by their moments, largest first; equal ones keep their order. */
static void sorted(const double_double apart[3], int axis[3])
{
    for (int k = 0; k < 3; k++)
        axis[k] = k;
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < 2; k++)
            if (difference(apart, axis[k], axis[k + 1]).hi < 0.0) {
                const int first = axis[k];
                axis[k] = axis[k + 1];
                axis[k + 1] = first;
            }
}

/* 1 or -1 where a is the axis of largest or smallest moment, 0 where rates are constant; the axes are
   sorted by their moments. */
static double side_of(const double_double apart[3], const double_double omega[3], const int axis[3], double E_2)
{
    const int j = axis[0], k = axis[1], l = axis[2];
    return circulation(!is_zero(difference(apart, j, k)), !is_zero(difference(apart, j, l)),
                       !is_zero(difference(apart, k, l)), !is_zero(omega[j]), !is_zero(omega[k]),
                       !is_zero(omega[l]), E_2);
}

/* E_b to all digits of a double_double, in exact arithmetic where its terms cancel. */
static double_double discriminant_of(const double_double c[3], const double_double apart[3], const double_double omega[3], const int axis[3])
{
    const double_double c_a = c[axis[0]], c_b = c[axis[1]], c_d = c[axis[2]];
    const double_double c_ab = difference(apart, axis[0], axis[1]), c_bd = difference(apart, axis[1], axis[2]);
    const double_double zero = {0.0, 0.0};
    const double rates[2] = {omega[axis[0]].hi, omega[axis[2]].hi};
    const int scale = exponent_of(2, rates);
    const double_double a = scaled(omega[axis[0]], -scale), d = scaled(omega[axis[2]], -scale);
    const double_double over = discriminant_dd(c_a, c_d, c_ab, c_bd, a, zero);
    const double_double under = discriminant_dd(c_a, c_d, c_ab, c_bd, zero, d);
    const double_double sum = dd_add_xx(over, under);
    if (fabs(sum.hi) > (over.hi - under.hi) / 1024.0)
        return scaled(sum, 2 * scale);
    const exact moment_b = exact_of(c_b.hi);
    const exact above = exact_sub_xx(exact_of(c_a.hi), moment_b);
    const exact below = exact_sub_xx(moment_b, exact_of(c_d.hi));
    return scaled(exact_to_dd(discriminant_exact(exact_of(c_a.hi), exact_of(c_d.hi), above, below,
                                             exact_of(a.hi), exact_of(d.hi))),
                  2 * scale);
}

static void steady_init(torque_free_pi_motion *motion, const double_double omega[3], const double_double q[4])
{
    double_double rates[3] = {omega[0], omega[1], omega[2]};
    const int at_rest = is_zero(omega[0]) && is_zero(omega[1]) && is_zero(omega[2]);
    if (at_rest)
        rates[0] = dd_of(1.0);
    motion->branch = 0;
    steady_constants(rates[0], rates[1], rates[2], q[0], q[1], q[2], q[3], &motion->of.steady);
    if (at_rest)
        motion->unit = motion->of.steady.Lambda_rate_hi = motion->of.steady.Lambda_rate_lo = 0.0;
}

/* Shorten the time domain of nonphysical bodies, which can speed up a lot after t = 0. */
static void limit(torque_free_pi_motion *motion, double rate, double other)
{
    const double largest = fabs(rate) > fabs(other) ? fabs(rate) : fabs(other);
    if (largest > 16.0)
        motion->max_angle = fmin(motion->max_angle, 16.0 * max_angle / largest);
}

/* Return 1 where no constant of a motion and no rate, up to its amplitude, overflows. */
static int is_held(double unit, const double *amplitude, size_t n, const double *constants)
{
    for (int k = 0; k < 3; k++)
        if (!(amplitude[k] * unit <= max_rate))
            return 0;
    return all_finite(n, constants);
}

/* Copy lane i of the constants of a branch to a motion; return a code. */
static int take(torque_free_pi_motion *motion, const lanes *lane, size_t i, const double *rows, size_t held)
{
    const double amplitude[3] = {lane->A_a_hi[i], lane->A_b_hi[i], lane->A_d_hi[i]};
    double *constants = (double *)&motion->of;
    for (size_t k = 0; k < held; k++)
        constants[k] = rows[k * LANES + i];
    if (motion->branch == 1)
        limit(motion, motion->of.circular.v_rate_hi, motion->of.circular.Lambda_rate_hi);
    else
        limit(motion, motion->of.hyperbolic.y_rate_hi, motion->of.hyperbolic.Lambda_rate_hi);
    return is_held(motion->unit, amplitude, held, constants) ? TORQUE_FREE_PI_OK : TORQUE_FREE_PI_RATES;
}

/* Write the numbers that the constants of a motion are computed from to lane i. */
#define PUT(name, value) (lane->name##_hi[i] = (value).hi, lane->name##_lo[i] = (value).lo)

static void put(lanes *lane, size_t i, const torque_free_pi_motion *motion, const double_double c[3],
                const double_double apart[3], const double_double omega[3], const double_double q[4], double_double E_b)
{
    const int a = motion->axis[0], b = motion->axis[1], d = motion->axis[2];
    PUT(c_a, c[a]), PUT(c_b, c[b]), PUT(c_d, c[d]);
    PUT(c_ab, difference(apart, a, b)), PUT(c_ad, difference(apart, a, d)), PUT(c_bd, difference(apart, b, d));
    PUT(Omega_a, omega[a]), PUT(Omega_b, omega[b]), PUT(Omega_d, omega[d]), PUT(E_b, E_b);
    PUT(q_0, q[0]), PUT(q_a, q[1 + a]), PUT(q_b, q[1 + b]), PUT(q_d, q[1 + d]);
    lane->axis_a[i] = a, lane->axis_b[i] = b, lane->axis_d[i] = d;
    lane->unit[i] = motion->unit;
}

/* Copy a used lane to all that are not used, so that unused lanes raise no exceptions. */
static void repeat(lanes *lane, const int own[LANES])
{
    double *row = (double *)lane;
    size_t from = 0;
    while (!own[from])
        from++;
    for (size_t k = 0; k < sizeof *lane / sizeof *row; k += LANES)
        for (size_t i = 0; i < LANES; i++)
            row[k + i] = own[i] ? row[k + i] : row[k + from];
}

/* Compute the constants of those of n motions that are on one branch, from the lanes of `initial_state`. */
static void branch_init(const lanes *lane, int branch, size_t n, torque_free_pi_motion *motion, int *code)
{
    lanes alike = *lane;
    union {
        circular_lanes circular;
        hyperbolic_lanes hyperbolic;
    } of;
    int own[LANES], count = 0, others = 0;
    for (size_t i = 0; i < LANES; i++) {
        own[i] = i < n && motion[i].branch == branch;
        count += own[i];
        others += i < n && motion[i].branch && !own[i];
    }
    if (!count)
        return;
    if (others)
        repeat(&alike, own);
    if (branch == 1)
        circular_constants(&alike, &of.circular);
    else
        hyperbolic_constants(&alike, &of.hyperbolic);
    const size_t held = branch == 1 ? sizeof(torque_free_pi_circular) : sizeof(torque_free_pi_hyperbolic);
    for (size_t i = 0; i < n; i++)
        if (own[i])
            code[i] = take(&motion[i], lane, i, (const double *)&of, held / sizeof(double));
}

/* Compute the constants of n motions that `begin` wrote to lanes, and their codes; steady ones have theirs. */
static void moving_init(lanes *lane, size_t n, torque_free_pi_motion *motion, int *code)
{
    int own[LANES], count = 0;
    for (size_t i = 0; i < LANES; i++) {
        own[i] = i < n && motion[i].branch;
        count += own[i];
    }
    if (!count)
        return;
    if (count < LANES)
        repeat(lane, own);
    initial_state(lane);
    for (size_t i = 0; i < n; i++)
        if (own[i])
            motion[i].branch = lane->k_1_hi[i] * lane->k_1_hi[i] <= max_circular ? 1 : 2;
    branch_init(lane, 1, n, motion, code);
    branch_init(lane, 2, n, motion, code);
}

/* log2(x), x >= 0, without an exception for zero. */
static double log2_of(double x) { return x > 0.0 ? log2(x) : -HUGE_VAL; }

/* log2(2^x + 2^y); both may be minus infinity. */
static double log2_sum(double x, double y)
{
    const double most = x > y ? x : y, other = x > y ? y : x;
    return isfinite(most) ? most + log2(1.0 + exp2(other - most)) : most;
}

/* Follow the separatrix, or spin about the middle axis, up to a time, where E_b is too faint, or where
   rates taken for zero could decide when that spin turns over.

   With X = sqrt(c_a |c_a - c_b|) Omega_a, Z = sqrt(c_d |c_b - c_d|) Omega_d Euler's equations are
   X' = k Omega_b Z, Z' = k Omega_b X, but for signs.  So X + Z and X - Z, whose product is E_b, grow
   no faster than exp(lambda t), lambda being k times the largest |Omega_b|; of the separatrix one is
   zero, of the spin both are.  What of them is not zero may grow to 2^-60 of the momentum. */
static void follow(torque_free_pi_motion *motion, const double_double c[3], const double_double apart[3], double_double omega[3],
                   const double_double given[3], double_double *E_b, int is_faint)
{
    const int *axis = motion->axis;
    const double c_a = c[axis[0]].hi, c_b = c[axis[1]].hi, c_d = c[axis[2]].hi;
    const double over = fabs(difference(apart, axis[0], axis[1]).hi);
    const double under = fabs(difference(apart, axis[1], axis[2]).hi);
    const double largest = c_a > c_d ? c_a : c_d, smallest = c_a > c_d ? c_d : c_a;
    const double weight[2] = {0.5 * log2_of(c_a * over), 0.5 * log2_of(c_d * under)};
    double part[2], gone = -HUGE_VAL, left = -HUGE_VAL, momentum = 0.0;
    for (int k = 0; k < 2; k++) {
        part[k] = weight[k] + log2_of(fabs(given[axis[2 * k]].hi));
        if (is_zero(omega[axis[2 * k]]))
            gone = log2_sum(gone, part[k]);
        else
            left = log2_sum(left, part[k]);
    }
    for (int k = 0; k < 3; k++)
        momentum = fmax(momentum, c[k].hi * fabs(given[k].hi));
    const double size = log2_sum(part[0], part[1]), distance = log2_of(fabs(E_b->hi));
    const int is_spin = gone > left + log2(decisive) || (is_faint && distance > 2.0 * size + log2(decisive));
    if (!is_spin && !is_faint)
        return;
    const double rate_b = given[axis[1]].hi, rate_d = given[axis[2]].hi;
    const double growth = sqrt(over / c_a * (under / c_d) * (rate_b * rate_b) +
                               under / c_b * ((over + under) / c_a) * (rate_d * rate_d));
    const double slow = fmin(0.0, log2_of(growth) + log2(smallest / largest));
    const double room = fmin(weight[0], weight[1]) + log2(momentum / largest) + slow -
                        (is_spin ? size : distance - size);
    const double bits = log2(tolerated) + room;
    motion->max_angle = bits > 0.0 ? fmin(log(2.0) * bits / growth, max_angle) : 0.0;
    motion->blurred = motion->max_angle < max_angle;
    *E_b = dd_of(0.0);
    for (int k = 0; k < 3 && is_spin; k += 2)
        omega[axis[k]] = dd_of(0.0);
}

/* Copy the numbers that sensitivities are computed from to the motion. */
static void keep(torque_free_pi_motion *motion, const double_double c[3], const double_double apart[3],
                 const double_double omega[3], double_double E_b)
{
    for (int k = 0; k < 10; k++) {
        const double_double x = k < 3 ? c[k] : k < 6 ? apart[k - 3] : k < 9 ? omega[k - 6] : E_b;
        motion->given[2 * k] = x.hi;
        motion->given[2 * k + 1] = x.lo;
    }
}

/* Set all of a motion but the constants of its branch, and write what these are computed from to lane i.
   c, apart (differences of each moment and the next in turn), the rates `given` and q are in inner
   units. */
static void begin(torque_free_pi_motion *motion, lanes *lane, size_t i, const double_double c[3],
                  const double_double apart[3], const double_double given[3], const double_double q[4],
                  const double_double *known, double unit)
{
    double_double omega[3], length = dd_mul_xx(q[0], q[0]), unit_q[4];
    memset(motion, 0, sizeof *motion);
    motion->prepared = PREPARED;
    for (int k = 0; k < 3; k++) {
        omega[k] = fabs(given[k].hi) < negligible ? dd_of(0.0) : given[k];
        length = dd_add_xx(length, dd_mul_xx(q[k + 1], q[k + 1]));
    }
    length = dd_sqrt(length);
    motion->unit = unit;
    motion->max_angle = max_angle;
    for (int k = 0; k < 4; k++) {
        unit_q[k] = dd_div_xx(q[k], length);
        motion->q0[k] = dd_rounded(unit_q[k]);
    }
    for (int k = 0; k < 3; k++)
        motion->omega0[k] = given[k].hi * unit;
    sorted(apart, motion->axis);
    double_double discriminant = known ? *known : discriminant_of(c, apart, omega, motion->axis);
    const int distinct = !is_zero(apart[0]) && !is_zero(apart[1]) && !is_zero(apart[2]);
    const int faint = !is_zero(discriminant) && fabs(discriminant.hi) < min_discriminant;
    int lost = 0;
    for (int k = 0; k < 3; k += 2)
        lost |= is_zero(omega[motion->axis[k]]) && !is_zero(given[motion->axis[k]]);
    if (distinct && (lost || faint))
        follow(motion, c, apart, omega, given, &discriminant, faint);
    motion->moment_unit = 1.0;
    keep(motion, c, apart, omega, discriminant);
    const double side = side_of(apart, omega, motion->axis, discriminant.hi);
    if (side < 0.0) {
        const int first = motion->axis[0];
        motion->axis[0] = motion->axis[2];
        motion->axis[2] = first;
    }
    motion->branch = side < 0.0 || side > 0.0;
    if (motion->branch)
        put(lane, i, motion, c, apart, omega, unit_q, discriminant);
    else
        steady_init(motion, omega, unit_q);
}

/* Check doubles and begin a motion with them; return a code. */
static int begin_doubles(torque_free_pi_motion *motion, lanes *lane, size_t i, const double inertia[3],
                         const double omega0[3], const double attitude0[4])
{
    double_double c[3], apart[3], omega[3], q[4];
    double smallest = inertia[0];
    motion->branch = 0;
    if (!all_finite(3, inertia) || !all_finite(3, omega0) || !all_finite(4, attitude0))
        return TORQUE_FREE_PI_NOT_FINITE;
    for (int k = 1; k < 3; k++)
        smallest = inertia[k] < smallest ? inertia[k] : smallest;
    if (!(smallest > 0.0))
        return TORQUE_FREE_PI_INERTIA;
    const int c_scale = exponent_of(3, inertia), scale = exponent_of(3, omega0);
    const int q_scale = exponent_of(4, attitude0);
    int is_zero_attitude = 1;
    for (int k = 0; k < 3; k++) {
        c[k] = dd_of(scaled_by(inertia[k], -c_scale));
        omega[k] = dd_of(scaled_by(omega0[k], -scale));
        /* Numbers other than zero stay so. */
        if (is_zero(omega[k]) && !is_zero(dd_of(omega0[k])))
            omega[k] = dd_of(copysign(4.9406564584124654e-324, omega0[k]));
    }
    if (!can_exist(c))
        return TORQUE_FREE_PI_NONPHYSICAL;
    if (scaled_by(smallest, -c_scale) < min_moment_ratio)
        return TORQUE_FREE_PI_THIN;
    for (int k = 0; k < 4; k++) {
        q[k] = dd_of(scaled_by(attitude0[k], -q_scale));
        is_zero_attitude = is_zero_attitude && is_zero(q[k]);
    }
    if (is_zero_attitude)
        return TORQUE_FREE_PI_ATTITUDE;
    /* Differences of doubles are pairs exactly. */
    for (int k = 0; k < 3; k++)
        apart[k] = two_sum(c[k].hi, -c[(k + 1) % 3].hi);
    begin(motion, lane, i, c, apart, omega, q, NULL, scaled_by(1.0, scale));
    for (int k = 0; k < 3; k++)
        motion->omega0[k] = omega0[k];
    motion->moment_unit = scaled_by(1.0, c_scale);
    return TORQUE_FREE_PI_OK;
}

/* Finish one motion that was begun, and return its code. */
static int end(torque_free_pi_motion *motion, torque_free_pi_motion *made, lanes *lane)
{
    int code = TORQUE_FREE_PI_OK;
    if (!is_rounded_once())
        return TORQUE_FREE_PI_ARITHMETIC;
    moving_init(lane, 1, made, &code);
    if (code == TORQUE_FREE_PI_OK)
        *motion = *made;
    return code;
}

int torque_free_pi_motion_init(torque_free_pi_motion *motion, const double inertia[3], const double omega0[3],
                          const double attitude0[4])
{
    torque_free_pi_motion made;
    lanes lane;
    memset(&lane, 0, sizeof lane);
    const int code = begin_doubles(&made, &lane, 0, inertia, omega0, attitude0);
    return code == TORQUE_FREE_PI_OK ? end(motion, &made, &lane) : code;
}

int torque_free_pi_motion_init_double_doubles(torque_free_pi_motion *motion, const double inertia[3][2],
                                const double differences[3][2], const double omega0[3][2],
                                const double attitude0[4][2], const double discriminant[2], double unit)
{
    double_double c[3], apart[3], omega[3], q[4];
    for (int k = 0; k < 4; k++) {
        const double_double one = {attitude0[k][0], attitude0[k][1]};
        q[k] = one;
    }
    for (int k = 0; k < 3; k++) {
        const double_double moment = {inertia[k][0], inertia[k][1]}, rate = {omega0[k][0], omega0[k][1]};
        const double_double above = {differences[k][0], differences[k][1]};
        c[k] = moment;
        apart[k] = above;
        omega[k] = rate;
        if (!all_finite(2, inertia[k]) || !all_finite(2, differences[k]) || !all_finite(2, omega0[k]))
            return TORQUE_FREE_PI_NOT_FINITE;
        if (!(moment.hi > 0.0))
            return TORQUE_FREE_PI_INERTIA;
        if (moment.hi < min_moment_ratio || moment.hi > 4.0)
            return TORQUE_FREE_PI_THIN;
        if (fabs(rate.hi) > 4.0)
            return TORQUE_FREE_PI_RATES;
    }
    if (!can_exist(c))
        return TORQUE_FREE_PI_NONPHYSICAL;
    if (!all_finite(8, &attitude0[0][0]) || !all_finite(2, discriminant) || !isfinite(unit))
        return TORQUE_FREE_PI_NOT_FINITE;
    if (!(unit > 0.0))
        return TORQUE_FREE_PI_RATES;
    if (is_zero(q[0]) && is_zero(q[1]) && is_zero(q[2]) && is_zero(q[3]))
        return TORQUE_FREE_PI_ATTITUDE;
    const double_double known = {discriminant[0], discriminant[1]};
    torque_free_pi_motion made;
    lanes lane;
    memset(&lane, 0, sizeof lane);
    begin(&made, &lane, 0, c, apart, omega, q, &known, unit);
    return end(motion, &made, &lane);
}

/* Scale times to inner units; return 1 if all are within the domain, and set *zero if one is zero. */
static int scaled_times(const torque_free_pi_motion *motion, size_t n, const double *restrict t,
                        double *restrict inner, int *zero)
{
    const double unit = motion->unit, last = motion->max_angle;
    int bad = 0, zeros = 0;
    for (size_t i = 0; i < n; i++) {
        inner[i] = unit * t[i];
        bad |= !(fabs(inner[i]) <= last);
        zeros |= !(t[i] < 0.0 || t[i] > 0.0);
    }
    *zero = zeros;
    return !bad;
}

static void interleaved(size_t n, const double *restrict a, const double *restrict b,
                        const double *restrict c, double *restrict rows)
{
    for (size_t i = 0; i < n; i++) {
        rows[3 * i] = a[i];
        rows[3 * i + 1] = b[i];
        rows[3 * i + 2] = c[i];
    }
}

static void interleaved4(size_t n, const double *restrict a, const double *restrict b,
                         const double *restrict c, const double *restrict d, double *restrict rows)
{
    for (size_t i = 0; i < n; i++) {
        rows[4 * i] = a[i];
        rows[4 * i + 1] = b[i];
        rows[4 * i + 2] = c[i];
        rows[4 * i + 3] = d[i];
    }
}

/* Compute n states from the angles, in rows s apart: two on the steady branch, at most six on the
   others; `out` has room for seven. */
static void block_states(const torque_free_pi_motion *motion, size_t n, size_t s, const double *restrict in,
                         double *restrict out, double *restrict q, double *restrict omega)
{
    const int *axis = motion->axis;
    double *row[7];
    if (motion->branch == 0) {
        steady_state(&motion->of.steady, n, in, in + s, out, out + s, out + 2 * s, out + 3 * s);
        for (size_t i = 0; i < n; i++)
            for (int k = 0; k < 3; k++)
                omega[3 * i + (size_t)k] = motion->omega0[k];
        interleaved4(n, out, out + s, out + 2 * s, out + 3 * s, q);
        return;
    }
    row[0] = out;
    for (size_t k = 0; k < 3; k++) {
        row[1 + axis[k]] = out + (1 + k) * s;
        row[4 + axis[k]] = out + (4 + k) * s;
    }
    if (motion->branch == 1)
        circular_state(&motion->of.circular, n, in, in + s, in + 2 * s, in + 3 * s, in + 4 * s,
                       out, out + s, out + 2 * s, out + 3 * s, out + 4 * s, out + 5 * s, out + 6 * s);
    else
        hyperbolic_state(&motion->of.hyperbolic, n, in, in + s, in + 2 * s, in + 3 * s, in + 4 * s,
                         out, out + s, out + 2 * s, out + 3 * s, out + 4 * s, out + 5 * s, out + 6 * s);
    interleaved4(n, row[0], row[1], row[2], row[3], q);
    interleaved(n, row[4], row[5], row[6], omega);
}

/* Write the angles at the inner times t + t_lo, in rows s apart. */
static void block_angles(const torque_free_pi_motion *motion, size_t n, size_t s, const double *restrict t,
                         const double *restrict t_lo, double *restrict to)
{
    if (motion->branch == 0)
        steady_angles(&motion->of.steady, n, t, t_lo, to, to + s);
    else if (motion->branch == 1)
        circular_angles(&motion->of.circular, n, t, t_lo, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s);
    else
        hyperbolic_angles(&motion->of.hyperbolic, n, t, t_lo, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s);
}

/* Prefetch the cache lines that the next block of rows will be written to. */
static void fetch(const double *q, const double *omega)
{
#ifdef __GNUC__
    for (size_t i = 0; i < 4 * BLOCK; i += 8)
        __builtin_prefetch(q + i, 1);
    for (size_t i = 0; i < 3 * BLOCK; i += 8)
        __builtin_prefetch(omega + i, 1);
#else
    (void)q, (void)omega;
#endif
}

/* Write the exact initial state of a motion. */
static void at_initial_state(const torque_free_pi_motion *motion, double *q, double *omega)
{
    for (int k = 0; k < 4; k++)
        q[k] = motion->q0[k];
    for (int k = 0; k < 3; k++)
        omega[k] = motion->omega0[k];
}

/* Return the code for times at which a motion has no states. */
static int refusal(const torque_free_pi_motion *motion, size_t n, const double *t)
{
    if (!all_finite(n, t))
        return TORQUE_FREE_PI_NOT_FINITE;
    return motion->blurred ? TORQUE_FREE_PI_SEPARATRIX : TORQUE_FREE_PI_TIME;
}

static void no_states(size_t n, double *q, double *omega)
{
    for (size_t i = 0; i < 4 * n; i++)
        q[i] = (double)NAN;
    for (size_t i = 0; i < 3 * n; i++)
        omega[i] = (double)NAN;
}

/* Write the states at n times; late times are refused, or have states of NaN where `lenient`. */
static int states_at(const torque_free_pi_motion *motion, size_t n, const double *t, double *q, double *omega,
                     int lenient)
{
    double by_time[6 * BLOCK], out[7 * BLOCK], inner[BLOCK], rest[BLOCK];
    int zero;
    for (size_t i = 0; i < n && !lenient; i += BLOCK)
        if (!scaled_times(motion, n - i < BLOCK ? n - i : BLOCK, t + i, inner, &zero))
            return refusal(motion, n, t);
    for (size_t k = 0; k < BLOCK; k++)
        rest[k] = 0.0;
    int refused = 0;
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i < BLOCK ? n - i : BLOCK;
        const int near = scaled_times(motion, count, t + i, inner, &zero);
        for (size_t k = 0; !near && k < count; k++)
            inner[k] = fabs(inner[k]) <= motion->max_angle ? inner[k] : 0.0;
        if (n - i >= 2 * BLOCK)
            fetch(q + 4 * (i + BLOCK), omega + 3 * (i + BLOCK));
        block_angles(motion, count, BLOCK, inner, rest, by_time);
        block_states(motion, count, BLOCK, by_time, out, q + 4 * i, omega + 3 * i);
        for (size_t k = 0; zero && k < count; k++)
            if (!(t[i + k] < 0.0 || t[i + k] > 0.0))
                at_initial_state(motion, q + 4 * (i + k), omega + 3 * (i + k));
        for (size_t k = 0; !near && k < count; k++)
            if (!(fabs(motion->unit * t[i + k]) <= motion->max_angle))
                no_states(1, q + 4 * (i + k), omega + 3 * (i + k));
        refused |= !near;
    }
    return refused ? refusal(motion, n, t) : TORQUE_FREE_PI_OK;
}

int torque_free_pi_states_at(const torque_free_pi_motion *motion, size_t n, const double *t, double *q,
                          double *omega)
{
    return motion->prepared == PREPARED ? states_at(motion, n, t, q, omega, 0) : TORQUE_FREE_PI_UNPREPARED;
}

/* Write one state, which needs no block. */
int torque_free_pi_state_at(const torque_free_pi_motion *motion, double t, double q[4], double omega[3])
{
    const double rest = 0.0;
    double by_time[6], out[7], inner;
    int zero;
    if (motion->prepared != PREPARED)
        return TORQUE_FREE_PI_UNPREPARED;
    if (!scaled_times(motion, 1, &t, &inner, &zero))
        return refusal(motion, 1, &t);
    if (zero) {
        at_initial_state(motion, q, omega);
        return TORQUE_FREE_PI_OK;
    }
    block_angles(motion, 1, 1, &inner, &rest, by_time);
    block_states(motion, 1, 1, by_time, out, q, omega);
    return TORQUE_FREE_PI_OK;
}

/* Sines and cosines of a + b. */
static void turned(size_t n, double sin_a, double cos_a, const double *restrict sin_b,
                   const double *restrict cos_b, double *restrict sine, double *restrict cosine)
{
    for (size_t i = 0; i < n; i++) {
        sine[i] = fused(sin_a, cos_b[i], cos_a * sin_b[i]);
        cosine[i] = fused(cos_a, cos_b[i], -(sin_a * sin_b[i]));
    }
}

/* Sines and cosines of both angles at the times k step, k = 0 ... BLOCK - 1, as from zero. */
static void grid_table(const torque_free_pi_motion *motion, double step, double *restrict table)
{
    double t[BLOCK], t_lo[BLOCK];
    torque_free_pi_motion from_zero = *motion;
    if (motion->branch == 1)
        from_zero.of.circular.v_hi = from_zero.of.circular.v_lo = 0.0;
    for (size_t k = 0; k < BLOCK; k++) {
        const double_double time = two_product((double)k, step);
        t[k] = time.hi;
        t_lo[k] = time.lo;
    }
    block_angles(&from_zero, BLOCK, BLOCK, t, t_lo, table);
}

/* Write the angles at n times, each `every`-th of the grid from number `first` on. */
static void grid_angles(const torque_free_pi_motion *motion, double start, double step, size_t first,
                        size_t every, size_t n, double *restrict by_time)
{
    double t[BLOCK], t_lo[BLOCK];
    for (size_t i = 0; i < n; i++) {
        const double_double time = dd_add_xd(two_product((double)(first + i * every), step), start);
        t[i] = time.hi;
        t_lo[i] = time.lo;
    }
    block_angles(motion, n, BLOCK, t, t_lo, by_time);
}

/* Write n <= BLOCK^2 states from number `first` on: angles are evaluated once in a block, and turned. */
static void grid_states(const torque_free_pi_motion *motion, double start, double step, size_t first, size_t n,
                        const double *restrict table, double *restrict q, double *restrict omega)
{
    double base[6 * BLOCK], by_time[4 * BLOCK], out[7 * BLOCK];
    const size_t rows = motion->branch == 0 ? 2 : 4;
    grid_angles(motion, start, step, first, BLOCK, (n + BLOCK - 1) / BLOCK, base);
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i < BLOCK ? n - i : BLOCK, k = i / BLOCK;
        if (n - i >= 2 * BLOCK)
            fetch(q + 4 * (i + BLOCK), omega + 3 * (i + BLOCK));
        for (size_t s = 0; s < rows * BLOCK; s += 2 * BLOCK)
            turned(count, base[s + k], base[s + BLOCK + k], table + s, table + s + BLOCK, by_time + s,
                   by_time + s + BLOCK);
        block_states(motion, count, BLOCK, by_time, out, q + 4 * i, omega + 3 * i);
    }
}

/* Write the states of a grid where angles are more than sines and cosines. */
static void grid_states_one_by_one(const torque_free_pi_motion *motion, double start, double step, size_t first,
                                   size_t n, double *restrict q, double *restrict omega)
{
    double by_time[6 * BLOCK], out[7 * BLOCK];
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i < BLOCK ? n - i : BLOCK;
        if (n - i >= 2 * BLOCK)
            fetch(q + 4 * (i + BLOCK), omega + 3 * (i + BLOCK));
        grid_angles(motion, start, step, first + i, 1, count, by_time);
        block_states(motion, count, BLOCK, by_time, out, q + 4 * i, omega + 3 * i);
    }
}

/* Return the index of the first of n samples, from number `first` on, that is at t = 0; n if there is none. */
static size_t grid_zero(double start, double step, size_t first, size_t n)
{
    const int stands = is_zero(dd_of(step));
    const double k = stands ? (double)first : nearest(-start / step);
    const double_double t = dd_add_xd(two_product(k, step), start);
    const double place = k - (double)first;
    return place >= 0.0 && place < (double)n && fabs(t.hi) <= 0.0 ? (size_t)place : n;
}

int torque_free_pi_states_on_grid(const torque_free_pi_motion *motion, double start, double step, size_t first,
                               size_t n, double *q, double *omega)
{
    double table[6 * BLOCK];
    /* Sample number 0 does not depend on the step, however large. */
    const double inner = motion->unit * start, inner_step = first + n > 1 ? motion->unit * step : 0.0;
    const double begin = inner + inner_step * (double)first;
    const double last = inner + inner_step * (double)(n > 0 ? first + n - 1 : first);
    const double given[2] = {start, first + n > 1 ? step : 0.0};
    const size_t most = BLOCK * BLOCK;
    if (motion->prepared != PREPARED)
        return TORQUE_FREE_PI_UNPREPARED;
    if (!(fabs(inner) <= motion->max_angle && fabs(begin) <= motion->max_angle && fabs(last) <= motion->max_angle))
        return refusal(motion, 2, given);
    if (motion->branch >= 1) {
        grid_states_one_by_one(motion, inner, inner_step, first, n, q, omega);
    } else {
        grid_table(motion, inner_step, table);
        for (size_t i = 0; i < n; i += most)
            grid_states(motion, inner, inner_step, first + i, n - i < most ? n - i : most, table, q + 4 * i,
                        omega + 3 * i);
    }
    for (size_t i = grid_zero(start, step, first, n); i < n; i += is_zero(dd_of(step)) ? 1 : n)
        at_initial_state(motion, q + 4 * i, omega + 3 * i);
    return TORQUE_FREE_PI_OK;
}

/* Prepare the motions of at most as many bodies as there are lanes, with codes; return how many. */
static size_t several_init(torque_free_pi_motion motion[LANES], int code[LANES], lanes *lane, int rounded, size_t bodies,
                           const double *inertia, const double *omega0, const double *attitude0)
{
    const size_t count = bodies < LANES ? bodies : LANES;
    for (size_t i = 0; i < count; i++) {
        code[i] = begin_doubles(&motion[i], lane, i, inertia + 3 * i, omega0 + 3 * i, attitude0 + 4 * i);
        if (code[i] == TORQUE_FREE_PI_OK && !rounded)
            code[i] = TORQUE_FREE_PI_ARITHMETIC;
    }
    moving_init(lane, count, motion, code);
    return count;
}

/* Write the states of one of many bodies; late times have states of NaN where `lenient`. */
static int states_of(const torque_free_pi_motion *motion, size_t n, const double *t, double *q, double *omega,
                     int lenient)
{
    if (n != 1)
        return states_at(motion, n, t, q, omega, lenient);
    const int code = torque_free_pi_state_at(motion, *t, q, omega);
    if (code != TORQUE_FREE_PI_OK && lenient)
        no_states(1, q, omega);
    return code;
}

int torque_free_pi_propagate(size_t bodies, const double *inertia, const double *omega0,
                          const double *attitude0, size_t n, const double *t, size_t stride,
                          double *q, double *omega, int *codes, size_t *failed)
{
    torque_free_pi_motion motion[LANES];
    int code[LANES];
    lanes lane;
    memset(&lane, 0, sizeof lane);
    const int rounded = is_rounded_once();
    for (size_t first = 0; first < bodies; first += LANES) {
        const size_t count = several_init(motion, code, &lane, rounded, bodies - first, inertia + 3 * first,
                                          omega0 + 3 * first, attitude0 + 4 * first);
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            double *q_k = q + 4 * n * k, *omega_k = omega + 3 * n * k;
            if (code[i] == TORQUE_FREE_PI_OK)
                code[i] = states_of(&motion[i], n, t + stride * k, q_k, omega_k, codes != NULL);
            else if (codes)
                no_states(n, q_k, omega_k);
            if (codes) {
                codes[k] = code[i];
            } else if (code[i] != TORQUE_FREE_PI_OK) {
                *failed = k;
                return code[i];
            }
        }
    }
    return TORQUE_FREE_PI_OK;
}

double torque_free_pi_last_time(const torque_free_pi_motion *motion)
{
    if (motion->prepared != PREPARED)
        return (double)NAN;
    return motion->unit > 0.0 ? fmin(motion->max_angle / motion->unit, DBL_MAX) : DBL_MAX;
}

size_t torque_free_pi_motion_size(void) { return sizeof(torque_free_pi_motion); }

const char *torque_free_pi_digest(void) { return "8a3bd110c75d7502fbd8ee9d1cea21a5b9d910f1a2654766f305598e7a2eeadc"; }

const char *torque_free_pi_message(int code)
{
    switch (code) {
    case TORQUE_FREE_PI_OK: return "success";
    case TORQUE_FREE_PI_NOT_FINITE: return "every number must be finite";
    case TORQUE_FREE_PI_INERTIA: return "inertia: principal moments must be positive";
    case TORQUE_FREE_PI_THIN: return "inertia: principal moments differ by more than binary64 can follow";
    case TORQUE_FREE_PI_ATTITUDE: return "attitude0: a zero quaternion is no attitude";
    case TORQUE_FREE_PI_SEPARATRIX: return "t: nearer to the separatrix than binary64 can follow so long";
    case TORQUE_FREE_PI_TIME: return "t: beyond |omega| t = 2^46 rad the angle is lost in binary64";
    case TORQUE_FREE_PI_RATES: return "omega0: rates beyond what binary64 can hold";
    case TORQUE_FREE_PI_ARITHMETIC: return "arithmetic: sums are reordered or not rounded to nearest";
    case TORQUE_FREE_PI_GROWTH: return "t: on the way to spin about the middle axis squares of changes leave binary64";
    case TORQUE_FREE_PI_NONPHYSICAL: return "inertia: no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)";
    case TORQUE_FREE_PI_UNPREPARED: return "motion: torque_free_pi_motion_init has not made it";
    default: return "no such code";
    }
}

const char *torque_free_pi_field(int code)
{
    switch (code) {
    case TORQUE_FREE_PI_INERTIA: return "inertia";
    case TORQUE_FREE_PI_THIN: return "inertia";
    case TORQUE_FREE_PI_ATTITUDE: return "attitude0";
    case TORQUE_FREE_PI_SEPARATRIX: return "t";
    case TORQUE_FREE_PI_TIME: return "t";
    case TORQUE_FREE_PI_RATES: return "omega0";
    case TORQUE_FREE_PI_ARITHMETIC: return "arithmetic";
    case TORQUE_FREE_PI_GROWTH: return "t";
    case TORQUE_FREE_PI_NONPHYSICAL: return "inertia";
    case TORQUE_FREE_PI_UNPREPARED: return "motion";
    default: return "";
    }
}

const char *torque_free_pi_rule(int code)
{
    switch (code) {
    case TORQUE_FREE_PI_OK: return "success";
    case TORQUE_FREE_PI_NOT_FINITE: return "every number must be finite";
    case TORQUE_FREE_PI_INERTIA: return "principal moments must be positive";
    case TORQUE_FREE_PI_THIN: return "principal moments differ by more than binary64 can follow";
    case TORQUE_FREE_PI_ATTITUDE: return "a zero quaternion is no attitude";
    case TORQUE_FREE_PI_SEPARATRIX: return "nearer to the separatrix than binary64 can follow so long";
    case TORQUE_FREE_PI_TIME: return "beyond |omega| t = 2^46 rad the angle is lost in binary64";
    case TORQUE_FREE_PI_RATES: return "rates beyond what binary64 can hold";
    case TORQUE_FREE_PI_ARITHMETIC: return "sums are reordered or not rounded to nearest";
    case TORQUE_FREE_PI_GROWTH: return "on the way to spin about the middle axis squares of changes leave binary64";
    case TORQUE_FREE_PI_NONPHYSICAL: return "no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)";
    case TORQUE_FREE_PI_UNPREPARED: return "torque_free_pi_motion_init has not made it";
    default: return "no such code";
    }
}
