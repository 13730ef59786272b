#include "torque_free_step.h"

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


/* How many bodies are computed side by side. */
#ifndef LANES
#define LANES 16
#endif

/* Extended numbers need every operation rounded to double once, and none reordered.  Not every option
   that breaks this shows in a macro: torque_free_body_init looks, too. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "torque_free_step.c: -ffast-math reorders sums that must not be; compile without it"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "torque_free_step.c: -ffinite-math-only takes the checks of inputs away; compile without it"
#elif defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)
#error "torque_free_step.c: sums must round to double; on 32-bit x86 compile with -msse2 -mfpmath=sse"
#elif FLT_RADIX != 2 || DBL_MANT_DIG != 53
#error "torque_free_step.c: a double must be a binary64 number"
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
static const double_double pi = {3.141592653589793, 1.2246467991473532e-16}; /* pi */
static const double_double unity = {1.0, 0.0}; /* 1 */
static const double pi_hi = 3.141592653589793; /* pi */
static const double pi_lo = 1.2246467991473532e-16; /* pi - pi_hi */
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
    double epsilon[LANES];
    double alpha_a_hi[LANES];
    double alpha_a_lo[LANES];
    double alpha_b_hi[LANES];
    double alpha_b_lo[LANES];
    double alpha_d_hi[LANES];
    double alpha_d_lo[LANES];
    double l_a_hi[LANES];
    double l_a_lo[LANES];
    double l_b_hi[LANES];
    double l_b_lo[LANES];
    double l_d_hi[LANES];
    double l_d_lo[LANES];
    double Omega_a0_hi[LANES];
    double Omega_a0_lo[LANES];
    double Omega_b0_hi[LANES];
    double Omega_b0_lo[LANES];
    double Omega_d0_hi[LANES];
    double Omega_d0_lo[LANES];
    double t[LANES];
    double sigma[LANES];
    double h_hi[LANES];
    double h_lo[LANES];
    double e_1_hi[LANES];
    double e_1_lo[LANES];
    double e_2_hi[LANES];
    double e_2_lo[LANES];
    double K_hi[LANES];
    double K_lo[LANES];
    double Lambda_rate_hi[LANES];
    double Lambda_rate_lo[LANES];
    double X_hi[LANES];
    double X_lo[LANES];
    double Y_hi[LANES];
    double Y_lo[LANES];
    double z_re_hi[LANES];
    double z_re_lo[LANES];
    double z_im_hi[LANES];
    double z_im_lo[LANES];
    double zr_re_hi[LANES];
    double zr_re_lo[LANES];
    double zr_im_hi[LANES];
    double zr_im_lo[LANES];
    double W_re[LANES];
    double W_im[LANES];
    double X_next_hi[LANES];
    double X_next_lo[LANES];
    double Y_next_hi[LANES];
    double Y_next_lo[LANES];
    double w_re[LANES];
    double w_im[LANES];
    double W_next_re[LANES];
    double W_next_im[LANES];
    double v_re_hi[LANES];
    double v_re_lo[LANES];
    double v_im_hi[LANES];
    double v_im_lo[LANES];
    double Omega_a_hi[LANES];
    double Omega_a_lo[LANES];
    double Omega_b_hi[LANES];
    double Omega_b_lo[LANES];
    double Omega_d_hi[LANES];
    double Omega_d_lo[LANES];
    double s_0[LANES];
    double s_b[LANES];
    double s_d[LANES];
    double q_0[LANES];
    double q_a[LANES];
    double q_b[LANES];
    double q_d[LANES];
    double p_0[LANES];
    double p_a[LANES];
    double p_b[LANES];
    double p_d[LANES];
    double q0[LANES];
    double q1[LANES];
    double q2[LANES];
    double q3[LANES];
    double u1[LANES];
    double u2[LANES];
    double u3[LANES];
    double b1[LANES];
    double b2[LANES];
    double b3[LANES];
    double k[LANES];
    double m1[LANES];
    double m2[LANES];
    double m3[LANES];
    double Q11[LANES];
    double Q22[LANES];
    double Q33[LANES];
    double Q23[LANES];
    double Q13[LANES];
    double Q12[LANES];
    double T1[LANES];
    double T2[LANES];
    double T3[LANES];
    double turned[LANES];
} lanes;

/* The coefficients of Euler's equations, and their products. */
static void step_body(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double c_a = {x->c_a_hi[i], x->c_a_lo[i]};
        const double_double c_b = {x->c_b_hi[i], x->c_b_lo[i]};
        const double_double c_d = {x->c_d_hi[i], x->c_d_lo[i]};
        const double_double c_ab = {x->c_ab_hi[i], x->c_ab_lo[i]};
        const double_double c_ad = {x->c_ad_hi[i], x->c_ad_lo[i]};
        const double_double c_bd = {x->c_bd_hi[i], x->c_bd_lo[i]};
        const double epsilon = x->epsilon[i];
        const double_double alpha_a = dd_div_xx(dd_mul_dx(epsilon, c_bd), c_a); /* fact: definition step.alpha_a; (10) */
        const double_double alpha_b = dd_div_xx(dd_mul_dx(-epsilon, c_ad), c_b); /* fact: definition step.alpha_b; (10) */
        const double_double alpha_d = dd_div_xx(dd_mul_dx(epsilon, c_ab), c_d); /* fact: definition step.alpha_d; (10) */
        const double_double l_a = dd_div_xx(dd_mul_xx(c_ab, c_ad), dd_mul_xx(c_b, c_d)); /* fact: definition step.l_a; (10) */
        const double_double l_b = dd_div_xx(dd_mul_xx(c_ab, c_bd), dd_mul_xx(c_a, c_d)); /* fact: definition step.l_b; (10) */
        const double_double l_d = dd_div_xx(dd_mul_xx(c_ad, c_bd), dd_mul_xx(c_a, c_b)); /* fact: definition step.l_d; (10) */
        x->alpha_a_hi[i] = alpha_a.hi;
        x->alpha_a_lo[i] = alpha_a.lo;
        x->alpha_b_hi[i] = alpha_b.hi;
        x->alpha_b_lo[i] = alpha_b.lo;
        x->alpha_d_hi[i] = alpha_d.hi;
        x->alpha_d_lo[i] = alpha_d.lo;
        x->l_a_hi[i] = l_a.hi;
        x->l_a_lo[i] = l_a.lo;
        x->l_b_hi[i] = l_b.hi;
        x->l_b_lo[i] = l_b.lo;
        x->l_d_hi[i] = l_d.hi;
        x->l_d_lo[i] = l_d.lo;
    }
}

/* Momentum, its projection, frequencies, rate of psi; X and Y at the shortest time. */
static void step_start(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double c_a = {x->c_a_hi[i], x->c_a_lo[i]};
        const double_double c_b = {x->c_b_hi[i], x->c_b_lo[i]};
        const double_double c_d = {x->c_d_hi[i], x->c_d_lo[i]};
        const double_double l_a = {x->l_a_hi[i], x->l_a_lo[i]};
        const double_double l_b = {x->l_b_hi[i], x->l_b_lo[i]};
        const double_double l_d = {x->l_d_hi[i], x->l_d_lo[i]};
        const double_double Omega_a0 = {x->Omega_a0_hi[i], x->Omega_a0_lo[i]};
        const double_double Omega_b0 = {x->Omega_b0_hi[i], x->Omega_b0_lo[i]};
        const double_double Omega_d0 = {x->Omega_d0_hi[i], x->Omega_d0_lo[i]};
        const double t = x->t[i];
        const double epsilon = x->epsilon[i];
        const double sigma = x->sigma[i];
        const double_double c_ab = dd_sub_xx(c_a, c_b); /* fact: definition step.c_ab; (10) */
        const double_double c_ad = dd_sub_xx(c_a, c_d); /* fact: definition step.c_ad; (10) */
        const double_double c_bd = dd_sub_xx(c_b, c_d); /* fact: definition step.c_bd; (10) */
        const double_double M_a0 = dd_mul_xx(c_a, Omega_a0); /* fact: step.M_a0; (8) */
        const double_double M_b0 = dd_mul_xx(c_b, Omega_b0); /* fact: step.M_b0; (8) */
        const double_double M_d0 = dd_mul_xx(c_d, Omega_d0); /* fact: step.M_d0; (8) */
        const double_double K = dd_sqrt(dd_add_xx(dd_add_xx(dd_mul_xx(M_a0, M_a0), dd_mul_xx(M_b0, M_b0)), dd_mul_xx(M_d0, M_d0))); /* fact: step.K; (6), (15) */
        const double_double common_1 = dd_mul_xx(Omega_b0, Omega_b0); /* fact: step.h, step.e_1, definition step.H_0; (10), (6) */
        const double_double common_2 = dd_mul_xx(l_b, common_1); /* fact: step.h, step.e_1; (10) */
        const double_double common_3 = dd_mul_xx(Omega_d0, Omega_d0); /* fact: step.h, step.e_1, definition step.H_0; (10), (6) */
        const double_double common_4 = dd_mul_xx(l_d, common_3); /* fact: step.h, step.e_1; (10) */
        const double_double h = dd_div_xd(dd_add_xx(common_2, common_4), 4.0); /* fact: step.h; (10) */
        const double_double common_5 = dd_mul_xx(Omega_a0, Omega_a0); /* fact: step.e_1, definition step.H_0; (10), (6) */
        const double_double e_1 = dd_add_xx(dd_mul_xx(l_a, common_5), dd_div_xd(dd_sub_xx(common_2, common_4), 2.0)); /* fact: step.e_1; (10) */
        const double_double e_2 = dd_mul_xx(h, h); /* fact: definition step.e_2; (10) */
        const double_double H_0 = dd_div_xd(dd_add_xx(dd_add_xx(dd_mul_xx(c_a, common_5), dd_mul_xx(c_b, common_1)), dd_mul_xx(c_d, common_3)), 2.0); /* fact: definition step.H_0; (6) */
        const double_double common_6 = dd_add_xx(K, dd_mul_dx(sigma, M_a0)); /* fact: definition step.psi_0, definition step.z_re, definition step.z_im, step.zr_re, step.zr_im; (33), (34), (27) */
        const double_double psi_0 = dd_div_xx(dd_add_xx(dd_mul_dx(2.0, H_0), dd_mul_xx(dd_mul_xd(K, sigma), Omega_a0)), common_6); /* fact: definition step.psi_0; (33), (34) */
        const double_double z_re = dd_div_xx(M_d0, common_6); /* fact: definition step.z_re; (27) */
        const double_double z_im = dd_div_xx(dd_mul_dx(sigma * epsilon, M_b0), common_6); /* fact: definition step.z_im; (27) */
        const double_double zr_re = dd_div_xx(dd_mul_xx(dd_mul_dx(epsilon, Omega_b0), dd_sub_xx(dd_mul_xx(c_ab, Omega_a0), dd_mul_xx(dd_mul_xx(dd_mul_dx(sigma, c_bd), Omega_d0), z_re))), common_6); /* fact: step.zr_re; (27) */
        const double_double zr_im = dd_div_xx(dd_mul_xx(dd_mul_dx(-sigma, Omega_d0), dd_add_xx(dd_mul_xx(c_ad, Omega_a0), dd_mul_xx(dd_mul_xx(dd_mul_dx(epsilon, c_bd), Omega_b0), z_im))), common_6); /* fact: step.zr_im; (27) */
        const double_double Lambda_rate = dd_div_xx(psi_0, dd_mul_dx(2.0, pi)); /* arithmetic */
        const double first_t = t * (1.0 / 32.0); /* arithmetic */
        const double common_7 = first_t * first_t; /* classical: DLMF 22.10.1 */
        const double a_1 = dd_rounded(e_1) * common_7; /* classical: DLMF 22.10.1 */
        const double a_2 = dd_rounded(e_2) * (common_7 * common_7); /* classical: DLMF 22.10.1 */
        const double common_8 = 1.0 / 120.0; /* classical: DLMF 22.10.1 */
        const double common_9 = a_1 * -1.0; /* classical: DLMF 22.10.1 */
        const double common_10 = a_1 * -24911.0; /* classical: DLMF 22.10.1 */
        const double common_11 = a_1 * -258821.0; /* classical: DLMF 22.10.1 */
        const double common_12 = a_1 * -13511.0; /* classical: DLMF 22.10.1 */
        const double more_X = fused(a_2, fused(a_2, fused(a_2, 11.0 / 15600.0 + common_12 / 36036000.0, fused(a_1, fused(a_1, 9481.0 / 14414400.0 + common_11 / 3027024000.0, -307.0 / 92400.0), common_8)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, 8303.0 / 518918400.0 + common_10 / 36324288000.0, -461.0 / 1663200.0), 17.0 / 5040.0), -11.0 / 420.0), 1.0 / 10.0)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, 1.0 / 6227020800.0 + common_9 / 1307674368000.0, -1.0 / 39916800.0), 1.0 / 362880.0), -1.0 / 5040.0), common_8), -1.0 / 6.0), 0.0)); /* classical: DLMF 22.10.1 */
        const double more_Y = fused(a_2, fused(a_2, fused(a_2, 11.0 / 1200.0 + common_12 / 2402400.0, fused(a_1, fused(a_1, 9481.0 / 1108800.0 + common_11 / 201801600.0, -307.0 / 8400.0), 3.0 / 40.0)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, 8303.0 / 39916800.0 + common_10 / 2421619200.0, -461.0 / 151200.0), 17.0 / 560.0), -11.0 / 60.0), 1.0 / 2.0)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, 1.0 / 479001600.0 + common_9 / 87178291200.0, -1.0 / 3628800.0), 1.0 / 40320.0), -1.0 / 720.0), 1.0 / 24.0), -1.0 / 2.0), 0.0)); /* classical: DLMF 22.10.1 */
        const double_double X = dd_mul_dx(first_t, dd_add_xd(unity, more_X)); /* classical: DLMF 22.10.1 */
        const double_double Y = dd_add_xd(unity, more_Y); /* classical: DLMF 22.10.1 */
        x->h_hi[i] = h.hi;
        x->h_lo[i] = h.lo;
        x->e_1_hi[i] = e_1.hi;
        x->e_1_lo[i] = e_1.lo;
        x->e_2_hi[i] = e_2.hi;
        x->e_2_lo[i] = e_2.lo;
        x->K_hi[i] = K.hi;
        x->K_lo[i] = K.lo;
        x->Lambda_rate_hi[i] = Lambda_rate.hi;
        x->Lambda_rate_lo[i] = Lambda_rate.lo;
        x->X_hi[i] = X.hi;
        x->X_lo[i] = X.lo;
        x->Y_hi[i] = Y.hi;
        x->Y_lo[i] = Y.lo;
        x->z_re_hi[i] = z_re.hi;
        x->z_re_lo[i] = z_re.lo;
        x->z_im_hi[i] = z_im.hi;
        x->z_im_lo[i] = z_im.lo;
        x->zr_re_hi[i] = zr_re.hi;
        x->zr_re_lo[i] = zr_re.lo;
        x->zr_im_hi[i] = zr_im.hi;
        x->zr_im_lo[i] = zr_im.lo;
    }
}

/* psi/2 at the shortest time, without its linear part. */
static void step_first(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double h = x->h_hi[i];
        const double e_1 = x->e_1_hi[i];
        const double e_2 = x->e_2_hi[i];
        const double X = x->X_hi[i];
        const double z_re = x->z_re_hi[i];
        const double z_im = x->z_im_hi[i];
        const double zr_re = x->zr_re_hi[i];
        const double zr_im = x->zr_im_hi[i];
        const double nu_re = h * fused(z_im, z_im, -(z_re * z_re)); /* fact: definition turn.nu_re; (27), (36) */
        const double nu_im = -2.0 * h * z_re * z_im; /* fact: definition turn.nu_im; (27), (36) */
        const double rate_re = h * fused(z_im, zr_im, -(z_re * zr_re)); /* fact: definition turn.rate_re; (27), (36) */
        const double rate_im = -h * fused(z_re, zr_im, z_im * zr_re); /* fact: definition turn.rate_im; (27), (36) */
        const double common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36), DLMF 18.12.11 */
        const double G_re = fused(-nu_re, common_1, 1.0); /* fact: definition turn.G_re; (27), (36) */
        const double G_im = -nu_im * common_1; /* fact: definition turn.G_im; (27), (36) */
        const double square_X = common_1; /* classical: DLMF 18.12.11 */
        const double d_0 = 1.0; /* classical: DLMF 18.12.11 */
        const double d_1 = e_1 / 2.0; /* classical: DLMF 18.12.11 */
        const double common_2 = 3.0 / 4.0; /* classical: DLMF 18.12.11 */
        const double d_2 = fused(common_2, e_1 * d_1, -(1.0 / 2.0 * (e_2 * d_0))); /* classical: DLMF 18.12.11 */
        const double common_3 = 5.0 / 6.0; /* classical: DLMF 18.12.11 */
        const double d_3 = fused(common_3, e_1 * d_2, -(2.0 / 3.0 * (e_2 * d_1))); /* classical: DLMF 18.12.11 */
        const double common_4 = 7.0 / 8.0; /* classical: DLMF 18.12.11 */
        const double d_4 = fused(common_4, e_1 * d_3, -(common_2 * (e_2 * d_2))); /* classical: DLMF 18.12.11 */
        const double common_5 = 9.0 / 10.0; /* classical: DLMF 18.12.11 */
        const double d_5 = fused(common_5, e_1 * d_4, -(4.0 / 5.0 * (e_2 * d_3))); /* classical: DLMF 18.12.11 */
        const double d_6 = fused(11.0 / 12.0, e_1 * d_5, -(common_3 * (e_2 * d_4))); /* classical: DLMF 18.12.11 */
        const double d_7 = fused(13.0 / 14.0, e_1 * d_6, -(6.0 / 7.0 * (e_2 * d_5))); /* classical: DLMF 18.12.11 */
        const double d_8 = fused(15.0 / 16.0, e_1 * d_7, -(common_4 * (e_2 * d_6))); /* classical: DLMF 18.12.11 */
        const double d_9 = fused(17.0 / 18.0, e_1 * d_8, -(8.0 / 9.0 * (e_2 * d_7))); /* classical: DLMF 18.12.11 */
        const double d_10 = fused(19.0 / 20.0, e_1 * d_9, -(common_5 * (e_2 * d_8))); /* classical: DLMF 18.12.11 */
        const double d_11 = fused(21.0 / 22.0, e_1 * d_10, -(10.0 / 11.0 * (e_2 * d_9))); /* classical: DLMF 18.12.11 */
        const double c_0_re = 1.0; /* classical: DLMF 18.12.11 */
        const double c_0_im = 0.0; /* classical: DLMF 18.12.11 */
        const double c_1_re = d_1 + fused(nu_re, c_0_re, -(nu_im * c_0_im)); /* classical: DLMF 18.12.11 */
        const double c_1_im = fused(nu_re, c_0_im, nu_im * c_0_re); /* classical: DLMF 18.12.11 */
        const double c_2_re = d_2 + fused(nu_re, c_1_re, -(nu_im * c_1_im)); /* classical: DLMF 18.12.11 */
        const double c_2_im = fused(nu_re, c_1_im, nu_im * c_1_re); /* classical: DLMF 18.12.11 */
        const double c_3_re = d_3 + fused(nu_re, c_2_re, -(nu_im * c_2_im)); /* classical: DLMF 18.12.11 */
        const double c_3_im = fused(nu_re, c_2_im, nu_im * c_2_re); /* classical: DLMF 18.12.11 */
        const double c_4_re = d_4 + fused(nu_re, c_3_re, -(nu_im * c_3_im)); /* classical: DLMF 18.12.11 */
        const double c_4_im = fused(nu_re, c_3_im, nu_im * c_3_re); /* classical: DLMF 18.12.11 */
        const double c_5_re = d_5 + fused(nu_re, c_4_re, -(nu_im * c_4_im)); /* classical: DLMF 18.12.11 */
        const double c_5_im = fused(nu_re, c_4_im, nu_im * c_4_re); /* classical: DLMF 18.12.11 */
        const double c_6_re = d_6 + fused(nu_re, c_5_re, -(nu_im * c_5_im)); /* classical: DLMF 18.12.11 */
        const double c_6_im = fused(nu_re, c_5_im, nu_im * c_5_re); /* classical: DLMF 18.12.11 */
        const double c_7_re = d_7 + fused(nu_re, c_6_re, -(nu_im * c_6_im)); /* classical: DLMF 18.12.11 */
        const double c_7_im = fused(nu_re, c_6_im, nu_im * c_6_re); /* classical: DLMF 18.12.11 */
        const double c_8_re = d_8 + fused(nu_re, c_7_re, -(nu_im * c_7_im)); /* classical: DLMF 18.12.11 */
        const double c_8_im = fused(nu_re, c_7_im, nu_im * c_7_re); /* classical: DLMF 18.12.11 */
        const double c_9_re = d_9 + fused(nu_re, c_8_re, -(nu_im * c_8_im)); /* classical: DLMF 18.12.11 */
        const double c_9_im = fused(nu_re, c_8_im, nu_im * c_8_re); /* classical: DLMF 18.12.11 */
        const double c_10_re = d_10 + fused(nu_re, c_9_re, -(nu_im * c_9_im)); /* classical: DLMF 18.12.11 */
        const double c_10_im = fused(nu_re, c_9_im, nu_im * c_9_re); /* classical: DLMF 18.12.11 */
        const double c_11_re = d_11 + fused(nu_re, c_10_re, -(nu_im * c_10_im)); /* classical: DLMF 18.12.11 */
        const double c_11_im = fused(nu_re, c_10_im, nu_im * c_10_re); /* classical: DLMF 18.12.11 */
        const double common_6 = X * square_X; /* classical: DLMF 18.12.11 */
        const double common_7 = 1.0 / 3.0; /* classical: DLMF 18.12.11 */
        const double common_8 = 1.0 / 5.0; /* classical: DLMF 18.12.11 */
        const double common_9 = 1.0 / 7.0; /* classical: DLMF 18.12.11 */
        const double common_10 = 1.0 / 9.0; /* classical: DLMF 18.12.11 */
        const double common_11 = 1.0 / 11.0; /* classical: DLMF 18.12.11 */
        const double common_12 = 1.0 / 13.0; /* classical: DLMF 18.12.11 */
        const double common_13 = 1.0 / 15.0; /* classical: DLMF 18.12.11 */
        const double common_14 = 1.0 / 17.0; /* classical: DLMF 18.12.11 */
        const double common_15 = 1.0 / 19.0; /* classical: DLMF 18.12.11 */
        const double common_16 = 1.0 / 21.0; /* classical: DLMF 18.12.11 */
        const double common_17 = 1.0 / 23.0; /* classical: DLMF 18.12.11 */
        const double common_18 = square_X * (1.0 / 25.0); /* classical: DLMF 18.12.11 */
        const double J_re = common_6 * fused(common_7, c_0_re, square_X * fused(common_8, c_1_re, square_X * fused(common_9, c_2_re, square_X * fused(common_10, c_3_re, square_X * fused(common_11, c_4_re, square_X * fused(common_12, c_5_re, square_X * fused(common_13, c_6_re, square_X * fused(common_14, c_7_re, square_X * fused(common_15, c_8_re, square_X * fused(common_16, c_9_re, square_X * fused(common_17, c_10_re, common_18 * c_11_re))))))))))); /* classical: DLMF 18.12.11 */
        const double J_im = common_6 * fused(common_7, c_0_im, square_X * fused(common_8, c_1_im, square_X * fused(common_9, c_2_im, square_X * fused(common_10, c_3_im, square_X * fused(common_11, c_4_im, square_X * fused(common_12, c_5_im, square_X * fused(common_13, c_6_im, square_X * fused(common_14, c_7_im, square_X * fused(common_15, c_8_im, square_X * fused(common_16, c_9_im, square_X * fused(common_17, c_10_im, common_18 * c_11_im))))))))))); /* classical: DLMF 18.12.11 */
        const double chi = fused(rate_re, J_im, rate_im * J_re); /* arithmetic */
        const double common_19 = chi * chi; /* classical: DLMF 4.19.2, DLMF 4.19.1 */
        const double E_re = fused(-(common_19 / 2.0), 1.0 - common_19 / 12.0, 1.0); /* classical: DLMF 4.19.2 */
        const double E_im = chi * fused(-(common_19 / 6.0), 1.0 - common_19 / 20.0, 1.0); /* classical: DLMF 4.19.1 */
        const double R = sqrt(fused(G_re, G_re, G_im * G_im)); /* fact: thirds.R; (36) */
        const double common_20 = R + G_re; /* fact: thirds.N, definition thirds.U_re; (36), (33), (34) */
        const double N = sqrt(2.0 * R * common_20); /* fact: thirds.N; (36) */
        const double U_re = common_20 / N; /* fact: definition thirds.U_re; (33), (34) */
        const double U_im = -G_im / N; /* fact: definition thirds.U_im; (33), (34) */
        const double P_re = E_re; /* fact: definition thirds.P_re; (33), (34) */
        const double P_im = E_im; /* fact: definition thirds.P_im; (33), (34) */
        const double W_re = fused(P_re, U_re, -(P_im * U_im)); /* fact: definition thirds.cos_half_psi; (33), (34) */
        const double W_im = fused(P_re, U_im, P_im * U_re); /* fact: definition thirds.sin_half_psi; (33), (34) */
        x->W_re[i] = W_re;
        x->W_im[i] = W_im;
    }
}

/* X and Y at twice the time. */
static void step_doubled(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double X = {x->X_hi[i], x->X_lo[i]};
        const double_double Y = {x->Y_hi[i], x->Y_lo[i]};
        const double_double e_1 = {x->e_1_hi[i], x->e_1_lo[i]};
        const double_double e_2 = {x->e_2_hi[i], x->e_2_lo[i]};
        const double_double common_1 = dd_mul_xx(X, X); /* fact: definition doubling.inside, definition doubling.Y_next; (10) */
        const double_double common_2 = dd_mul_xx(e_2, dd_mul_xx(dd_mul_xx(common_1, X), X)); /* fact: definition doubling.inside, definition doubling.Y_next; (10) */
        const double_double inside = dd_sub_dx(1.0, common_2); /* fact: definition doubling.inside; (10) */
        const double_double X_next = dd_div_xx(dd_mul_xx(dd_mul_dx(2.0, X), Y), inside); /* fact: definition doubling.X_next; (10) */
        const double_double Y_next = dd_sub_dx(1.0, dd_div_xx(dd_mul_xx(dd_mul_dx(2.0, common_1), dd_sub_xx(dd_mul_xx(e_1, dd_add_dx(1.0, common_2)), dd_mul_xx(dd_mul_dx(4.0, e_2), common_1))), dd_mul_xx(inside, inside))); /* fact: definition doubling.Y_next; (10) */
        x->X_next_hi[i] = X_next.hi;
        x->X_next_lo[i] = X_next.lo;
        x->Y_next_hi[i] = Y_next.hi;
        x->Y_next_lo[i] = Y_next.lo;
    }
}

/* The momentum's projection at the time of X and Y. */
static void step_projected(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double h = x->h_hi[i];
        const double z_re = x->z_re_hi[i];
        const double z_im = x->z_im_hi[i];
        const double zr_re = x->zr_re_hi[i];
        const double zr_im = x->zr_im_hi[i];
        const double X = x->X_hi[i];
        const double Y = x->Y_hi[i];
        const double nu_re = h * fused(z_im, z_im, -(z_re * z_re)); /* fact: definition turn.nu_re; (27), (36) */
        const double nu_im = -2.0 * h * z_re * z_im; /* fact: definition turn.nu_im; (27), (36) */
        const double common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
        const double G_re = fused(-nu_re, common_1, 1.0); /* fact: definition turn.G_re; (27), (36) */
        const double G_im = -nu_im * common_1; /* fact: definition turn.G_im; (27), (36) */
        const double square = fused(G_re, G_re, G_im * G_im); /* fact: definition turn.square; (27), (36) */
        const double F_re = fused(z_re, Y, zr_re * X); /* fact: definition turn.F_re; (27), (36) */
        const double F_im = fused(z_im, Y, zr_im * X); /* fact: definition turn.F_im; (27), (36) */
        const double w_re = fused(F_re, G_re, F_im * G_im) / square; /* fact: definition turn.w_re; (27), (36) */
        const double w_im = fused(F_im, G_re, -(F_re * G_im)) / square; /* fact: definition turn.w_im; (27), (36) */
        x->w_re[i] = w_re;
        x->w_im[i] = w_im;
    }
}

/* psi/2 at twice the time, without its linear part. */
static void step_second_half(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double h = x->h_hi[i];
        const double X = x->X_hi[i];
        const double w_re = x->w_re[i];
        const double w_im = x->w_im[i];
        const double W_re = x->W_re[i];
        const double W_im = x->W_im[i];
        const double nu_re = h * fused(w_im, w_im, -(w_re * w_re)); /* fact: definition turn.nu_re; (27), (36) */
        const double nu_im = -2.0 * h * w_re * w_im; /* fact: definition turn.nu_im; (27), (36) */
        const double common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
        const double G_re = fused(-nu_re, common_1, 1.0); /* fact: definition turn.G_re; (27), (36) */
        const double G_im = -nu_im * common_1; /* fact: definition turn.G_im; (27), (36) */
        const double R = sqrt(fused(G_re, G_re, G_im * G_im)); /* fact: second_half.R; (36) */
        const double V_re = fused(W_re, G_re, W_im * G_im) / R; /* fact: definition second_half.V_re; (33), (34) */
        const double V_im = fused(W_im, G_re, -(W_re * G_im)) / R; /* fact: definition second_half.V_im; (33), (34) */
        const double W_next_re = fused(W_re, V_re, -(W_im * V_im)); /* fact: definition thirds.P_re; (33), (34) */
        const double W_next_im = fused(W_re, V_im, W_im * V_re); /* fact: definition thirds.P_im; (33), (34) */
        x->W_next_re[i] = W_next_re;
        x->W_next_im[i] = W_next_im;
    }
}

/* The momentum's projection in extended precision, for the last doublings. */
static void step_last_projected(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double h = {x->h_hi[i], x->h_lo[i]};
        const double_double z_re = {x->z_re_hi[i], x->z_re_lo[i]};
        const double_double z_im = {x->z_im_hi[i], x->z_im_lo[i]};
        const double_double zr_re = {x->zr_re_hi[i], x->zr_re_lo[i]};
        const double_double zr_im = {x->zr_im_hi[i], x->zr_im_lo[i]};
        const double_double X = {x->X_hi[i], x->X_lo[i]};
        const double_double Y = {x->Y_hi[i], x->Y_lo[i]};
        const double_double nu_re = dd_mul_xx(h, dd_sub_xx(dd_mul_xx(z_im, z_im), dd_mul_xx(z_re, z_re))); /* fact: definition turn.nu_re; (27), (36) */
        const double_double nu_im = dd_mul_xx(dd_mul_xx(dd_mul_dx(-2.0, h), z_re), z_im); /* fact: definition turn.nu_im; (27), (36) */
        const double_double common_1 = dd_mul_xx(X, X); /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
        const double_double G_re = dd_sub_dx(1.0, dd_mul_xx(nu_re, common_1)); /* fact: definition turn.G_re; (27), (36) */
        const double_double G_im = dd_mul_xx(dd_neg(nu_im), common_1); /* fact: definition turn.G_im; (27), (36) */
        const double_double square = dd_add_xx(dd_mul_xx(G_re, G_re), dd_mul_xx(G_im, G_im)); /* fact: definition turn.square; (27), (36) */
        const double_double F_re = dd_add_xx(dd_mul_xx(z_re, Y), dd_mul_xx(zr_re, X)); /* fact: definition turn.F_re; (27), (36) */
        const double_double F_im = dd_add_xx(dd_mul_xx(z_im, Y), dd_mul_xx(zr_im, X)); /* fact: definition turn.F_im; (27), (36) */
        const double_double v_re = dd_div_xx(dd_add_xx(dd_mul_xx(F_re, G_re), dd_mul_xx(F_im, G_im)), square); /* fact: definition turn.w_re; (27), (36) */
        const double_double v_im = dd_div_xx(dd_sub_xx(dd_mul_xx(F_im, G_re), dd_mul_xx(F_re, G_im)), square); /* fact: definition turn.w_im; (27), (36) */
        x->v_re_hi[i] = v_re.hi;
        x->v_re_lo[i] = v_re.lo;
        x->v_im_hi[i] = v_im.hi;
        x->v_im_lo[i] = v_im.lo;
    }
}

/* psi/2 at twice the time from extended numbers, for the last doublings. */
static void step_last_second_half(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double h = {x->h_hi[i], x->h_lo[i]};
        const double_double X = {x->X_hi[i], x->X_lo[i]};
        const double_double v_re = {x->v_re_hi[i], x->v_re_lo[i]};
        const double_double v_im = {x->v_im_hi[i], x->v_im_lo[i]};
        const double W_re = x->W_re[i];
        const double W_im = x->W_im[i];
        const double_double nu_re = dd_mul_xx(h, dd_sub_xx(dd_mul_xx(v_im, v_im), dd_mul_xx(v_re, v_re))); /* fact: definition turn.nu_re; (27), (36) */
        const double_double nu_im = dd_mul_xx(dd_mul_xx(dd_mul_dx(-2.0, h), v_re), v_im); /* fact: definition turn.nu_im; (27), (36) */
        const double_double common_1 = dd_mul_xx(X, X); /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
        const double_double G_re = dd_sub_dx(1.0, dd_mul_xx(nu_re, common_1)); /* fact: definition turn.G_re; (27), (36) */
        const double_double G_im = dd_mul_xx(dd_neg(nu_im), common_1); /* fact: definition turn.G_im; (27), (36) */
        const double_double R = dd_sqrt(dd_add_xx(dd_mul_xx(G_re, G_re), dd_mul_xx(G_im, G_im))); /* fact: second_half.R; (36) */
        const double_double V_re = dd_div_xx(dd_add_xx(dd_mul_dx(W_re, G_re), dd_mul_dx(W_im, G_im)), R); /* fact: definition second_half.V_re; (33), (34) */
        const double_double V_im = dd_div_xx(dd_sub_xx(dd_mul_dx(W_im, G_re), dd_mul_dx(W_re, G_im)), R); /* fact: definition second_half.V_im; (33), (34) */
        const double_double W_next_re = dd_sub_xx(dd_mul_dx(W_re, V_re), dd_mul_dx(W_im, V_im)); /* fact: definition thirds.P_re; (33), (34) */
        const double_double W_next_im = dd_add_xx(dd_mul_dx(W_re, V_im), dd_mul_dx(W_im, V_re)); /* fact: definition thirds.P_im; (33), (34) */
        x->W_next_re[i] = dd_rounded(W_next_re);
        x->W_next_im[i] = dd_rounded(W_next_im);
    }
}

/* The rates after the step. */
static void step_rates(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double X = {x->X_hi[i], x->X_lo[i]};
        const double_double Y = {x->Y_hi[i], x->Y_lo[i]};
        const double_double h = {x->h_hi[i], x->h_lo[i]};
        const double_double alpha_a = {x->alpha_a_hi[i], x->alpha_a_lo[i]};
        const double_double alpha_b = {x->alpha_b_hi[i], x->alpha_b_lo[i]};
        const double_double alpha_d = {x->alpha_d_hi[i], x->alpha_d_lo[i]};
        const double_double l_d = {x->l_d_hi[i], x->l_d_lo[i]};
        const double_double Omega_a0 = {x->Omega_a0_hi[i], x->Omega_a0_lo[i]};
        const double_double Omega_b0 = {x->Omega_b0_hi[i], x->Omega_b0_lo[i]};
        const double_double Omega_d0 = {x->Omega_d0_hi[i], x->Omega_d0_lo[i]};
        const double_double common_1 = dd_mul_xx(X, X); /* fact: definition step.f, definition step.g, step.room; (10) */
        const double_double common_2 = dd_mul_xx(h, common_1); /* fact: definition step.f, definition step.g; (10) */
        const double_double f = dd_add_dx(1.0, common_2); /* fact: definition step.f; (10) */
        const double_double g = dd_sub_dx(1.0, common_2); /* fact: definition step.g; (10) */
        const double_double room = dd_add_xx(dd_mul_xx(g, g), dd_mul_xx(dd_mul_xx(l_d, dd_mul_xx(Omega_d0, Omega_d0)), common_1)); /* fact: step.room; (10) */
        const double_double Omega_a = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_a0, f), g), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_a, Omega_b0), Omega_d0), X), Y)), room); /* fact: step.Omega_a; (5), (10) */
        const double_double Omega_b = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_b0, g), Y), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_b, Omega_d0), Omega_a0), f), X)), room); /* fact: step.Omega_b; (5), (10) */
        const double_double Omega_d = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_d0, f), Y), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_d, Omega_a0), Omega_b0), g), X)), room); /* fact: step.Omega_d; (5), (10) */
        x->Omega_a_hi[i] = Omega_a.hi;
        x->Omega_a_lo[i] = Omega_a.lo;
        x->Omega_b_hi[i] = Omega_b.hi;
        x->Omega_b_lo[i] = Omega_b.lo;
        x->Omega_d_hi[i] = Omega_d.hi;
        x->Omega_d_lo[i] = Omega_d.lo;
    }
}

/* The shortest rotation that takes the momentum at the start to its axis. */
static void step_shortest_before(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double K = {x->K_hi[i], x->K_lo[i]};
        const double_double Omega_a0 = {x->Omega_a0_hi[i], x->Omega_a0_lo[i]};
        const double_double Omega_b0 = {x->Omega_b0_hi[i], x->Omega_b0_lo[i]};
        const double_double Omega_d0 = {x->Omega_d0_hi[i], x->Omega_d0_lo[i]};
        const double c_a = x->c_a_hi[i];
        const double c_b = x->c_b_hi[i];
        const double c_d = x->c_d_hi[i];
        const double epsilon = x->epsilon[i];
        const double sigma = x->sigma[i];
        const double_double M_a = dd_mul_dx(c_a, Omega_a0); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_dx(c_b, Omega_b0); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_dx(c_d, Omega_d0); /* fact: definition attitude.M_d; (8) */
        const double_double common_1 = dd_mul_dx(2.0, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double_double nu = dd_sqrt(dd_mul_xx(common_1, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
        const double_double s_0 = dd_div_xx(nu, common_1); /* fact: definition attitude.s_0; (27) */
        const double_double s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
        const double_double s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
        x->s_0[i] = dd_rounded(s_0);
        x->s_b[i] = dd_rounded(s_b);
        x->s_d[i] = dd_rounded(s_d);
    }
}

/* The constant left factor of the attitude. */
static void step_front(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double s_0 = x->s_0[i];
        const double s_b = x->s_b[i];
        const double s_d = x->s_d[i];
        const double q_0 = x->q_0[i];
        const double q_a = x->q_a[i];
        const double q_b = x->q_b[i];
        const double q_d = x->q_d[i];
        const double epsilon = x->epsilon[i];
        const double qbar_0 = s_0; /* fact: definition attitude.qbar_0; (18), (25) */
        const double qbar_a = 0.0; /* fact: definition attitude.qbar_a; (18), (25) */
        const double qbar_b = s_b; /* fact: definition attitude.qbar_b; (18), (25) */
        const double qbar_d = s_d; /* fact: definition attitude.qbar_d; (18), (25) */
        const double p_0 = fused(q_d, qbar_d, fused(q_b, qbar_b, fused(q_0, qbar_0, q_a * qbar_a))); /* fact: attitude.p_0; (37) */
        const double p_a = fused(epsilon, fused(q_d, qbar_b, -(q_b * qbar_d)), fused(q_a, qbar_0, -(q_0 * qbar_a))); /* fact: attitude.p_a; (37) */
        const double p_b = fused(epsilon, fused(q_a, qbar_d, -(q_d * qbar_a)), fused(q_b, qbar_0, -(q_0 * qbar_b))); /* fact: attitude.p_b; (37) */
        const double p_d = fused(epsilon, fused(q_b, qbar_a, -(q_a * qbar_b)), fused(q_d, qbar_0, -(q_0 * qbar_d))); /* fact: attitude.p_d; (37) */
        x->p_0[i] = p_0;
        x->p_a[i] = p_a;
        x->p_b[i] = p_b;
        x->p_d[i] = p_d;
    }
}

/* The shortest rotation that takes the momentum after the step to its axis. */
static void step_shortest(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double_double K = {x->K_hi[i], x->K_lo[i]};
        const double_double Omega_a = {x->Omega_a_hi[i], x->Omega_a_lo[i]};
        const double_double Omega_b = {x->Omega_b_hi[i], x->Omega_b_lo[i]};
        const double_double Omega_d = {x->Omega_d_hi[i], x->Omega_d_lo[i]};
        const double c_a = x->c_a_hi[i];
        const double c_b = x->c_b_hi[i];
        const double c_d = x->c_d_hi[i];
        const double epsilon = x->epsilon[i];
        const double sigma = x->sigma[i];
        const double_double M_a = dd_mul_dx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_dx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_dx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
        const double_double common_1 = dd_mul_dx(2.0, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double_double nu = dd_sqrt(dd_mul_xx(common_1, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
        const double_double s_0 = dd_div_xx(nu, common_1); /* fact: definition attitude.s_0; (27) */
        const double_double s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
        const double_double s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
        x->s_0[i] = dd_rounded(s_0);
        x->s_b[i] = dd_rounded(s_b);
        x->s_d[i] = dd_rounded(s_d);
    }
}

/* The attitude after the step. */
static void step_attitude(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double t = x->t[i];
        const double Lambda_rate_hi = x->Lambda_rate_hi[i];
        const double Lambda_rate_lo = x->Lambda_rate_lo[i];
        const double W_re = x->W_re[i];
        const double W_im = x->W_im[i];
        const double s_0 = x->s_0[i];
        const double s_b = x->s_b[i];
        const double s_d = x->s_d[i];
        const double p_0 = x->p_0[i];
        const double p_a = x->p_a[i];
        const double p_b = x->p_b[i];
        const double p_d = x->p_d[i];
        const double epsilon = x->epsilon[i];
        const double sigma = x->sigma[i];
        const double L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double L_error = fused(Lambda_rate_lo, t, product_error(Lambda_rate_hi, t, L)); /* arithmetic: Dekker 1971 */
        const double L_whole = nearest(L); /* classical: DLMF 4.16 */
        const double L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double L_turns = L_rest + L_error; /* classical: DLMF 4.16 */
        const double L_square = L_turns * L_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double L_sign = alternating(L_whole); /* classical: DLMF 4.16 */
        const double X_im = L_sign * fused(L_turns, pi_hi, L_turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        const double turn_re = fused(X_re, W_re, -(X_im * W_im)); /* fact: definition thirds.P_re; (33), (34) */
        const double turn_im = fused(X_re, W_im, X_im * W_re); /* fact: definition thirds.P_im; (33), (34) */
        const double qbar_0 = turn_re * s_0; /* fact: definition attitude.qbar_0; (18), (25) */
        const double qbar_a = sigma * turn_im * s_0; /* fact: definition attitude.qbar_a; (18), (25) */
        const double common_1 = epsilon * sigma * turn_im; /* fact: definition attitude.qbar_b, definition attitude.qbar_d; (18), (25) */
        const double qbar_b = fused(turn_re, s_b, -(common_1 * s_d)); /* fact: definition attitude.qbar_b; (18), (25) */
        const double qbar_d = fused(turn_re, s_d, common_1 * s_b); /* fact: definition attitude.qbar_d; (18), (25) */
        const double q_0 = fused(-p_d, qbar_d, fused(-p_b, qbar_b, fused(p_0, qbar_0, -(p_a * qbar_a)))); /* fact: definition attitude.q_0; (37) */
        const double q_a = fused(epsilon, fused(p_b, qbar_d, -(p_d * qbar_b)), fused(p_0, qbar_a, p_a * qbar_0)); /* fact: definition attitude.q_a; (37) */
        const double q_b = fused(epsilon, fused(p_d, qbar_a, -(p_a * qbar_d)), fused(p_0, qbar_b, p_b * qbar_0)); /* fact: definition attitude.q_b; (37) */
        const double q_d = fused(epsilon, fused(p_a, qbar_b, -(p_b * qbar_a)), fused(p_0, qbar_d, p_d * qbar_0)); /* fact: definition attitude.q_d; (37) */
        x->q_0[i] = q_0;
        x->q_a[i] = q_a;
        x->q_b[i] = q_b;
        x->q_d[i] = q_d;
    }
}

/* The torque that a vector in space exerts, and a torque fixed in the body. */
static void step_kick(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double q0 = x->q0[i];
        const double q1 = x->q1[i];
        const double q2 = x->q2[i];
        const double q3 = x->q3[i];
        const double u1 = x->u1[i];
        const double u2 = x->u2[i];
        const double u3 = x->u3[i];
        const double b1 = x->b1[i];
        const double b2 = x->b2[i];
        const double b3 = x->b3[i];
        const double k = x->k[i];
        const double m1 = x->m1[i];
        const double m2 = x->m2[i];
        const double m3 = x->m3[i];
        const double Q11 = x->Q11[i];
        const double Q22 = x->Q22[i];
        const double Q33 = x->Q33[i];
        const double Q23 = x->Q23[i];
        const double Q13 = x->Q13[i];
        const double Q12 = x->Q12[i];
        const double w1 = 2.0 * fused(u2, q3, -(u3 * q2)); /* fact: definition kick.w1; (3) */
        const double w2 = 2.0 * fused(u3, q1, -(u1 * q3)); /* fact: definition kick.w2; (3) */
        const double w3 = 2.0 * fused(u1, q2, -(u2 * q1)); /* fact: definition kick.w3; (3) */
        const double v1 = fused(q0, w1, u1) + fused(w2, q3, -(w3 * q2)); /* fact: definition kick.v1; (3) */
        const double v2 = fused(q0, w2, u2) + fused(w3, q1, -(w1 * q3)); /* fact: definition kick.v2; (3) */
        const double v3 = fused(q0, w3, u3) + fused(w1, q2, -(w2 * q1)); /* fact: definition kick.v3; (3) */
        const double g1 = fused(Q13, v3, fused(Q11, v1, Q12 * v2)) - m1; /* fact: definition kick.g1; (3) */
        const double g2 = fused(Q23, v3, fused(Q12, v1, Q22 * v2)) - m2; /* fact: definition kick.g2; (3) */
        const double g3 = fused(Q33, v3, fused(Q13, v1, Q23 * v2)) - m3; /* fact: definition kick.g3; (3) */
        const double T1 = fused(k, v1, b1) + fused(v2, g3, -(v3 * g2)); /* fact: definition kick.T1; (3) */
        const double T2 = fused(k, v2, b2) + fused(v3, g1, -(v1 * g3)); /* fact: definition kick.T2; (3) */
        const double T3 = fused(k, v3, b3) + fused(v1, g2, -(v2 * g1)); /* fact: definition kick.T3; (3) */
        x->T1[i] = T1;
        x->T2[i] = T2;
        x->T3[i] = T3;
    }
}

static const double min_moment_ratio = 6.223015277861142e-61; /* 2^-200, ratio of two principal moments */
static const double max_step = 8.0; /* 2^3, |omega dt|, rad */

/* Return the exponent to scale by, 0 from 2^-40 to 2^40: there the highest powers of rates, the 22nd, do
   not overflow. */
static double scale(double largest)
{
    int exponent;
    if (largest >= 9.094947017729282e-13 && largest <= 1099511627776.0)
        return 0.0;
    frexp(largest, &exponent);
    return (double)exponent;
}

static double largest_of(const double x[3]) { return fmax(fabs(x[0]), fmax(fabs(x[1]), fabs(x[2]))); }

/* The mark of a prepared body: a number that memory hardly has by chance. */
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

/* Check moments and write them to lane i, the largest first; return a code. */
static int set_body(lanes *x, size_t i, const double *inertia, int axis[3])
{
    const double largest = largest_of(inertia), least = fmin(inertia[0], fmin(inertia[1], inertia[2]));
    if (!(inertia[0] > 0.0 && inertia[1] > 0.0 && inertia[2] > 0.0))
        return isnan(inertia[0] + inertia[1] + inertia[2]) ? TORQUE_FREE_STEP_NOT_FINITE : TORQUE_FREE_STEP_INERTIA;
    if (!(largest <= DBL_MAX))
        return TORQUE_FREE_STEP_NOT_FINITE;
    const int exponent = -(int)scale(largest);
    const double_double c[3] = {dd_of(ldexp(inertia[0], exponent)), dd_of(ldexp(inertia[1], exponent)),
                                dd_of(ldexp(inertia[2], exponent))};
    if (!can_exist(c))
        return TORQUE_FREE_STEP_NONPHYSICAL;
    if (least / largest < min_moment_ratio)
        return TORQUE_FREE_STEP_THIN;
    const int first = inertia[0] >= inertia[1] ? (inertia[0] >= inertia[2] ? 0 : 2) : (inertia[1] >= inertia[2] ? 1 : 2);
    const int one = (first + 1) % 3, other = (first + 2) % 3, turned = inertia[one] < inertia[other];
    axis[0] = first;
    axis[1] = turned ? other : one;
    axis[2] = turned ? one : other;
    const double c_a = c[axis[0]].hi, c_b = c[axis[1]].hi, c_d = c[axis[2]].hi;
    const double_double ab = two_sum(c_a, -c_b), ad = two_sum(c_a, -c_d), bd = two_sum(c_b, -c_d);
    x->c_a_hi[i] = c_a, x->c_a_lo[i] = 0.0, x->c_b_hi[i] = c_b, x->c_b_lo[i] = 0.0;
    x->c_d_hi[i] = c_d, x->c_d_lo[i] = 0.0, x->c_ab_hi[i] = ab.hi, x->c_ab_lo[i] = ab.lo;
    x->c_ad_hi[i] = ad.hi, x->c_ad_lo[i] = ad.lo, x->c_bd_hi[i] = bd.hi, x->c_bd_lo[i] = bd.lo;
    x->epsilon[i] = turned ? -1.0 : 1.0;
    return TORQUE_FREE_STEP_OK;
}

static void get_body(const lanes *x, torque_free_body *body)
{
    const double moments[] = {x->c_a_hi[0], x->c_b_hi[0], x->c_d_hi[0]};
    const double alphas[] = {x->alpha_a_hi[0], x->alpha_a_lo[0], x->alpha_b_hi[0],
                             x->alpha_b_lo[0], x->alpha_d_hi[0], x->alpha_d_lo[0]};
    const double squares[] = {x->l_a_hi[0], x->l_a_lo[0], x->l_b_hi[0], x->l_b_lo[0], x->l_d_hi[0], x->l_d_lo[0]};
    memcpy(body->moments, moments, sizeof moments);
    memcpy(body->alphas, alphas, sizeof alphas);
    memcpy(body->squares, squares, sizeof squares);
    body->epsilon = x->epsilon[0];
}

static void put_body(lanes *x, size_t i, const torque_free_body *body)
{
    const double *alphas = body->alphas, *squares = body->squares;
    x->c_a_hi[i] = body->moments[0], x->c_b_hi[i] = body->moments[1], x->c_d_hi[i] = body->moments[2];
    x->c_a_lo[i] = x->c_b_lo[i] = x->c_d_lo[i] = 0.0;
    x->alpha_a_hi[i] = alphas[0], x->alpha_a_lo[i] = alphas[1], x->alpha_b_hi[i] = alphas[2];
    x->alpha_b_lo[i] = alphas[3], x->alpha_d_hi[i] = alphas[4], x->alpha_d_lo[i] = alphas[5];
    x->l_a_hi[i] = squares[0], x->l_a_lo[i] = squares[1], x->l_b_hi[i] = squares[2];
    x->l_b_lo[i] = squares[3], x->l_d_hi[i] = squares[4], x->l_d_lo[i] = squares[5];
    x->epsilon[i] = body->epsilon;
}

/* The given state of a lane, the exponent that scales its rates, and 1 where nothing turns. */
typedef struct {
    int axis[3], exponent, still;
    double q[4], omega[3];
} scaling;

static int set_state(lanes *x, size_t i, const int axis[3], const double *q, const double *omega, double dt,
                     scaling *of)
{
    const double largest = largest_of(omega), size = fmax(fabs(q[0]), largest_of(q + 1));
    double sum = dt;
    for (int k = 0; k < 3; k++)
        sum += 0.0 * omega[k] + 0.0 * q[1 + k];
    if (!(fabs(sum + 0.0 * q[0]) <= DBL_MAX))
        return TORQUE_FREE_STEP_NOT_FINITE;
    if (!(size > 0.0))
        return TORQUE_FREE_STEP_ATTITUDE;
    of->still = !(largest > 0.0 && fabs(dt) > 0.0);
    of->exponent = largest > 0.0 ? (int)scale(largest) : 0;
    memcpy(of->axis, axis, sizeof of->axis);
    double rates[3], attitude[4];
    for (int k = 0; k < 3; k++)
        rates[k] = of->exponent ? ldexp(omega[axis[k]], -of->exponent) : omega[axis[k]];
    const int less = -(int)scale(size);
    attitude[0] = less ? ldexp(q[0], less) : q[0];
    for (int k = 0; k < 3; k++)
        attitude[1 + k] = less ? ldexp(q[1 + axis[k]], less) : q[1 + axis[k]];
    x->t[i] = of->exponent ? ldexp(dt, of->exponent) : dt;
    if (of->still)
        x->t[i] = 0.0;
    if (!(largest > 0.0))
        rates[0] = 1.0;
    memcpy(of->omega, omega, sizeof of->omega);
    of->q[0] = attitude[0];
    for (int k = 0; k < 3; k++)
        of->q[1 + axis[k]] = attitude[1 + k];
    x->Omega_a0_hi[i] = rates[0], x->Omega_b0_hi[i] = rates[1], x->Omega_d0_hi[i] = rates[2];
    x->Omega_a0_lo[i] = x->Omega_b0_lo[i] = x->Omega_d0_lo[i] = 0.0;
    x->q_0[i] = attitude[0], x->q_a[i] = attitude[1], x->q_b[i] = attitude[2], x->q_d[i] = attitude[3];
    const double squared = rates[0] * rates[0] + rates[1] * rates[1] + rates[2] * rates[2];
    return sqrt(squared) * fabs(x->t[i]) <= max_step ? TORQUE_FREE_STEP_OK : TORQUE_FREE_STEP_ANGLE;
}

#define SWAP_IF(turned, one, other)                                                                       \
    do {                                                                                                  \
        const double first = (one), second = (other);                                                     \
        (one) = (turned) ? second : first;                                                                \
        (other) = (turned) ? first : second;                                                              \
    } while (0)

/* Choose the axis a: that of largest moment, or of smallest where K^2 < 2 H c_b. */
static void circulating(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const double over = x->l_a_hi[i] * x->Omega_a0_hi[i] * x->Omega_a0_hi[i];
        const double under = x->l_d_hi[i] * x->Omega_d0_hi[i] * x->Omega_d0_hi[i];
        const int turned = over < under;
        const double sign = turned ? -1.0 : 1.0;
        SWAP_IF(turned, x->Omega_a0_hi[i], x->Omega_d0_hi[i]);
        SWAP_IF(turned, x->c_a_hi[i], x->c_d_hi[i]);
        SWAP_IF(turned, x->alpha_a_hi[i], x->alpha_d_hi[i]);
        SWAP_IF(turned, x->alpha_a_lo[i], x->alpha_d_lo[i]);
        SWAP_IF(turned, x->l_a_hi[i], x->l_d_hi[i]);
        SWAP_IF(turned, x->l_a_lo[i], x->l_d_lo[i]);
        SWAP_IF(turned, x->q_a[i], x->q_d[i]);
        x->epsilon[i] *= sign;
        x->turned[i] = sign;
        x->sigma[i] = x->Omega_a0_hi[i] < 0.0 ? -1.0 : 1.0;
    }
}

/* Replace X, Y and W by their values at twice the time. */
static void advance(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        x->X_hi[i] = x->X_next_hi[i];
        x->X_lo[i] = x->X_next_lo[i];
        x->Y_hi[i] = x->Y_next_hi[i];
        x->Y_lo[i] = x->Y_next_lo[i];
        x->W_re[i] = x->W_next_re[i];
        x->W_im[i] = x->W_next_im[i];
    }
}

/* x over the root of a square, with little more error than one rounding. */
static INLINED double divided(double x, double over, double more)
{
    const double y = x * over;
    return y + (product_error(x, over, y) + x * more);
}

/* Normalise a quaternion. */
static INLINED void divide(double *q_0, double *q_a, double *q_b, double *q_d)
{
    const double_double first = dd_add_xx(two_product(*q_0, *q_0), two_product(*q_a, *q_a));
    const double_double square = dd_add_xx(first, dd_add_xx(two_product(*q_b, *q_b), two_product(*q_d, *q_d)));
    const double over = 1.0 / sqrt(square.hi);
    const double_double rest = dd_sub_dx(1.0, dd_mul_xx(square, two_product(over, over)));
    const double more = over * (rest.hi + rest.lo) / 2.0;
    *q_0 = divided(*q_0, over, more);
    *q_a = divided(*q_a, over, more);
    *q_b = divided(*q_b, over, more);
    *q_d = divided(*q_d, over, more);
}

static void normalised(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++)
        divide(&x->q_0[i], &x->q_a[i], &x->q_b[i], &x->q_d[i]);
}

/* x rounded up or down, to the nearer double more often: chance is between -1/2 and 1/2. */
static INLINED double dithered(double hi, double lo, double chance)
{
    const double size = fabs(hi), next = size + size * 1.1102230246251568e-16;
    return hi + (lo + chance * (next - size));
}

/* Round rates up or down at random, by the attitude's last digits: rounded to nearest, a slow motion's
   rates would err one way for long. */
static void rounded(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const uint64_t one = bits_of(x->q_0[i]), two = bits_of(x->q_a[i]), three = bits_of(x->q_b[i]);
        uint64_t mixed = (one ^ (two << 21 | two >> 43) ^ (three << 42 | three >> 22)) * UINT64_C(0x9e3779b97f4a7c15);
        mixed = (mixed ^ mixed >> 32) * UINT64_C(0xd6e8feb86659fd93);
        mixed ^= mixed >> 32;
        const double a = from_bits(UINT64_C(0x3ff0000000000000) | mixed >> 44 << 32) - 1.5;
        const double b = from_bits(UINT64_C(0x3ff0000000000000) | mixed << 20 >> 44 << 32) - 1.5;
        const double d = from_bits(UINT64_C(0x3ff0000000000000) | mixed << 40 >> 44 << 32) - 1.5;
        x->Omega_a_hi[i] = dithered(x->Omega_a_hi[i], x->Omega_a_lo[i], a);
        x->Omega_b_hi[i] = dithered(x->Omega_b_hi[i], x->Omega_b_lo[i], b);
        x->Omega_d_hi[i] = dithered(x->Omega_d_hi[i], x->Omega_d_lo[i], d);
    }
}

static void move(size_t n, lanes *x)
{
    circulating(n, x);
    step_start(n, x);
    step_first(n, x);
    for (int k = 0; k < 5; k++) {
        if (k < 5 - 2) {
            step_projected(n, x);
            step_second_half(n, x);
        } else {
            step_last_projected(n, x);
            step_last_second_half(n, x);
        }
        step_doubled(n, x);
        advance(n, x);
    }
    step_rates(n, x);
    step_shortest_before(n, x);
    step_front(n, x);
    step_shortest(n, x);
    step_attitude(n, x);
    normalised(n, x);
    rounded(n, x);
}

/* Return 1 where the state is finite: nonphysical bodies can turn much faster than at the start. */
static int is_held(const lanes *x, size_t i)
{
    const double sum = x->q_0[i] + x->q_a[i] + x->q_b[i] + x->q_d[i];
    return fabs(sum + x->Omega_a_hi[i] + x->Omega_b_hi[i] + x->Omega_d_hi[i]) <= DBL_MAX;
}

static void get_state(const lanes *x, size_t i, const scaling *of, double *q, double *omega)
{
    if (of->still) {
        memcpy(q, of->q, sizeof of->q);
        divide(q, q + 1, q + 2, q + 3);
        memcpy(omega, of->omega, sizeof of->omega);
        return;
    }
    const int a = x->turned[i] < 0.0 ? 2 : 0, d = 2 - a;
    const double rates[3] = {x->Omega_a_hi[i], x->Omega_b_hi[i], x->Omega_d_hi[i]};
    const double parts[3] = {x->q_a[i], x->q_b[i], x->q_d[i]};
    const int axis[3] = {of->axis[a], of->axis[1], of->axis[d]};
    q[0] = x->q_0[i];
    for (int k = 0; k < 3; k++) {
        q[1 + axis[k]] = parts[k];
        omega[axis[k]] = of->exponent ? ldexp(rates[k], of->exponent) : rates[k];
    }
}

static const double_double over_3 = {0.3333333333333333, 1.850371707708594e-17};
static const double_double over_5 = {0.2, -1.1102230246251566e-17};
static const double_double over_7 = {0.14285714285714285, 7.93016446160826e-18};
static const double_double over_9 = {0.1111111111111111, 6.1679056923619804e-18};
static const double_double over_15 = {0.06666666666666667, 9.251858538542971e-19};

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

/* Return 1 where the constants of a body, and a doubling, have all their digits: clang's
   -ffp-contract=fast fuses sums with products across functions, so that low parts are counted twice. */
static int lanes_hold(void)
{
    static const double given[] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596,
                                   0.15335179025447007};
    const volatile double zero = 0.0;
    double inertia[3];
    int axis[3];
    lanes x;
    for (int k = 0; k < 3; k++)
        inertia[k] = zero + given[k];
    if (set_body(&x, 0, inertia, axis) != TORQUE_FREE_STEP_OK)
        return 0;
    x.X_hi[0] = inertia[0], x.Y_hi[0] = inertia[1], x.e_1_hi[0] = inertia[2], x.e_2_hi[0] = zero + given[3];
    x.X_lo[0] = x.Y_lo[0] = x.e_1_lo[0] = x.e_2_lo[0] = zero;
    step_body(1, &x);
    step_doubled(1, &x);
    const double_double l_a = {x.l_a_hi[0], x.l_a_lo[0]}, l_b = {x.l_b_hi[0], x.l_b_lo[0]};
    const double_double X = {x.X_next_hi[0], x.X_next_lo[0]}, Y = {x.Y_next_hi[0], x.Y_next_lo[0]};
    return is_double_double(l_a, 0.5265630116004512, 2.0259269896901686e-17) && is_double_double(l_b, 0.11906636935098612, 4.186140756463748e-18) && is_double_double(X, 0.7309683706206017, -5.138891903440856e-18) &&
           is_double_double(Y, 0.9450906240536523, 1.3279045143746525e-17);
}

static int is_rounded_once(void) { return sums_hold() && quotients_hold() && lanes_hold(); }

/* Compute the constants of a body, without testing the arithmetic of this build. */
static int body_init(torque_free_body *body, const double inertia[3])
{
    lanes x;
    int axis[3];
    const int code = set_body(&x, 0, inertia, axis);
    if (code != TORQUE_FREE_STEP_OK)
        return code;
    step_body(1, &x);
    get_body(&x, body);
    memcpy(body->axis, axis, sizeof axis);
    body->prepared = PREPARED;
    return TORQUE_FREE_STEP_OK;
}

int torque_free_body_init(torque_free_body *body, const double inertia[3])
{
    torque_free_body made;
    const int code = body_init(&made, inertia);
    if (code != TORQUE_FREE_STEP_OK)
        return code;
    if (!is_rounded_once())
        return TORQUE_FREE_STEP_ARITHMETIC;
    *body = made;
    return TORQUE_FREE_STEP_OK;
}

int torque_free_step(const torque_free_body *body, double q[4], double omega[3], double dt)
{
    lanes x;
    scaling of;
    if (body->prepared != PREPARED)
        return TORQUE_FREE_STEP_UNPREPARED;
    const int code = set_state(&x, 0, body->axis, q, omega, dt, &of);
    if (code != TORQUE_FREE_STEP_OK)
        return code;
    put_body(&x, 0, body);
    move(1, &x);
    if (!is_held(&x, 0))
        return TORQUE_FREE_STEP_ANGLE;
    get_state(&x, 0, &of, q, omega);
    return TORQUE_FREE_STEP_OK;
}

int torque_free_steps(size_t n, const double *inertia, size_t inertia_stride, const double *q,
                      const double *omega, const double *dt, size_t dt_stride, double *q_after,
                      double *omega_after, size_t *failed)
{
    torque_free_body body;
    lanes x;
    scaling of[LANES];
    int axis[LANES][3], code;
    *failed = 0;
    if (n && inertia_stride && !is_rounded_once())
        return TORQUE_FREE_STEP_ARITHMETIC;
    if (n && !inertia_stride && (code = torque_free_body_init(&body, inertia)) != TORQUE_FREE_STEP_OK)
        return code;
    for (size_t begin = 0; begin < n; begin += LANES) {
        const size_t count = n - begin < LANES ? n - begin : LANES;
        for (size_t i = 0; i < LANES; i++) {
            /* Lanes beyond the last body repeat it. */
            const size_t k = begin + (i < count ? i : count - 1);
            code = TORQUE_FREE_STEP_OK;
            if (inertia_stride)
                code = set_body(&x, i, inertia + k * inertia_stride, axis[i]);
            else
                put_body(&x, i, &body);
            const int *order = inertia_stride ? axis[i] : body.axis;
            if (code == TORQUE_FREE_STEP_OK)
                code = set_state(&x, i, order, q + 4 * k, omega + 3 * k, dt[k * dt_stride], &of[i]);
            if (code != TORQUE_FREE_STEP_OK) {
                *failed = k;
                return code;
            }
        }
        if (inertia_stride)
            step_body(LANES, &x);
        move(LANES, &x);
        for (size_t i = 0; i < count; i++) {
            if (!is_held(&x, i)) {
                *failed = begin + i;
                return TORQUE_FREE_STEP_ANGLE;
            }
            get_state(&x, i, &of[i], q_after + 4 * (begin + i), omega_after + 3 * (begin + i));
        }
    }
    return TORQUE_FREE_STEP_OK;
}

size_t torque_free_body_size(void) { return sizeof(torque_free_body); }

const char *torque_free_step_digest(void) { return "0f127980bb2e127aac32609014a78475a8f3df799580728095f7450cf1b7fbc1"; }

const char *torque_free_step_message(int code)
{
    switch (code) {
    case TORQUE_FREE_STEP_OK: return "success";
    case TORQUE_FREE_STEP_NOT_FINITE: return "every number must be finite";
    case TORQUE_FREE_STEP_INERTIA: return "inertia: principal moments must be positive";
    case TORQUE_FREE_STEP_THIN: return "inertia: principal moments differ by more than binary64 can follow";
    case TORQUE_FREE_STEP_ATTITUDE: return "q: a zero quaternion is no attitude";
    case TORQUE_FREE_STEP_ANGLE: return "dt: |omega dt| must be at most 8 rad";
    case TORQUE_FREE_STEP_ARITHMETIC: return "arithmetic: sums are reordered or not rounded to nearest";
    case TORQUE_FREE_STEP_NONPHYSICAL: return "inertia: no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)";
    case TORQUE_FREE_STEP_UNPREPARED: return "body: torque_free_body_init has not made it";
    default: return "no such code";
    }
}

const char *torque_free_step_field(int code)
{
    switch (code) {
    case TORQUE_FREE_STEP_INERTIA: return "inertia";
    case TORQUE_FREE_STEP_THIN: return "inertia";
    case TORQUE_FREE_STEP_ATTITUDE: return "q";
    case TORQUE_FREE_STEP_ANGLE: return "dt";
    case TORQUE_FREE_STEP_ARITHMETIC: return "arithmetic";
    case TORQUE_FREE_STEP_NONPHYSICAL: return "inertia";
    case TORQUE_FREE_STEP_UNPREPARED: return "body";
    default: return "";
    }
}

const char *torque_free_step_rule(int code)
{
    switch (code) {
    case TORQUE_FREE_STEP_OK: return "success";
    case TORQUE_FREE_STEP_NOT_FINITE: return "every number must be finite";
    case TORQUE_FREE_STEP_INERTIA: return "principal moments must be positive";
    case TORQUE_FREE_STEP_THIN: return "principal moments differ by more than binary64 can follow";
    case TORQUE_FREE_STEP_ATTITUDE: return "a zero quaternion is no attitude";
    case TORQUE_FREE_STEP_ANGLE: return "|omega dt| must be at most 8 rad";
    case TORQUE_FREE_STEP_ARITHMETIC: return "sums are reordered or not rounded to nearest";
    case TORQUE_FREE_STEP_NONPHYSICAL: return "no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)";
    case TORQUE_FREE_STEP_UNPREPARED: return "torque_free_body_init has not made it";
    default: return "no such code";
    }
}

/* Mean anomaly = E - e sin E for |mean| <= pi, by Newton's method from pi on the side of the mean
   anomaly, from where it comes down without passing (Charles and Tatum, Celestial Mechanics and
   Dynamical Astronomy 69, 357-372, 1998). */
static double elliptic_anomaly(double mean, double e)
{
    double anomaly = copysign(3.141592653589793, mean);
    for (int k = 0; k < 60; k++) {
        const double change = (anomaly - e * sin(anomaly) - mean) / (1.0 - e * cos(anomaly));
        anomaly -= change;
        if (fabs(change) <= 1e-15 * fabs(anomaly))
            break;
    }
    return anomaly;
}

/* Mean anomaly = e sinh F - F, from the far side of the root. */
static double hyperbolic_anomaly(double mean, double e)
{
    double anomaly = asinh(mean / (e - 1.0));
    for (int k = 0; k < 60; k++) {
        const double change = (e * sinh(anomaly) - anomaly - mean) / (e * cosh(anomaly) - 1.0);
        anomaly -= change;
        if (fabs(change) <= 1e-15 * fabs(anomaly))
            break;
    }
    return anomaly;
}

/* The vector from the mass point to the body, times sqrt(3 mu/r^5). */
static void seen_from(const torque_free_orbit *orbit, double t, double u[3])
{
    const double e = orbit->eccentricity, a = orbit->semi_major;
    const double mean = orbit->mean_motion * (t - orbit->epoch);
    double along, across;
    if (e < 1.0) {
        const double turned = remainder(mean, 6.283185307179586);
        const double anomaly = e > 0.0 ? elliptic_anomaly(turned, e) : turned;
        along = a * (cos(anomaly) - e);
        across = a * sqrt(1.0 - e * e) * sin(anomaly);
    } else {
        const double anomaly = hyperbolic_anomaly(mean, e);
        along = a * (e - cosh(anomaly));
        across = a * sqrt(e * e - 1.0) * sinh(anomaly);
    }
    const double r = hypot(along, across);
    const double strong = sqrt(orbit->strength / r) / (r * r);
    for (int k = 0; k < 3; k++)
        u[k] = strong * (along * orbit->along[k] + across * orbit->across[k]);
}

/* Bodies side by side with their states; results do not depend on the lane. */
typedef struct {
    size_t count;
    torque_free_body bodies[LANES];
    double inertia[LANES][3], q[LANES][4], omega[LANES][3];
} pushed;

static void set_vector(lanes *x, size_t i, const double u[3])
{
    x->u1[i] = u[0], x->u2[i] = u[1], x->u3[i] = u[2];
}

static void set_torque(lanes *x, size_t i, const double c[13])
{
    x->b1[i] = c[0], x->b2[i] = c[1], x->b3[i] = c[2], x->k[i] = c[3];
    x->m1[i] = c[4], x->m2[i] = c[5], x->m3[i] = c[6];
    x->Q11[i] = c[7], x->Q22[i] = c[8], x->Q33[i] = c[9];
    x->Q23[i] = c[10], x->Q13[i] = c[11], x->Q12[i] = c[12];
}

static int drifted(lanes *x, pushed *of, double dt, size_t *failed)
{
    scaling as[LANES];
    for (size_t i = 0; i < of->count; i++) {
        put_body(x, i, &of->bodies[i]);
        const int code = set_state(x, i, of->bodies[i].axis, of->q[i], of->omega[i], dt, &as[i]);
        if (code != TORQUE_FREE_STEP_OK) {
            *failed = i;
            return code;
        }
    }
    move(of->count, x);
    for (size_t i = 0; i < of->count; i++) {
        if (!is_held(x, i)) {
            *failed = i;
            return TORQUE_FREE_STEP_ANGLE;
        }
        get_state(x, i, &as[i], of->q[i], of->omega[i]);
    }
    return TORQUE_FREE_STEP_OK;
}

static void add_more(lanes *x, const pushed *of, const torque_free_torque *torque, double t)
{
    for (size_t i = 0; i < of->count; i++) {
        double sum[3] = {x->T1[i], x->T2[i], x->T3[i]};
        torque->more(t, of->q[i], sum, torque->data);
        x->T1[i] = sum[0], x->T2[i] = sum[1], x->T3[i] = sum[2];
    }
}

static void kicked(lanes *x, pushed *of, const torque_free_torque *torque, double t, double dt)
{
    if (torque->orbit) {
        double u[3];
        seen_from(torque->orbit, t, u);
        for (size_t i = 0; i < of->count; i++)
            set_vector(x, i, u);
    }
    for (size_t i = 0; i < of->count; i++)
        x->q0[i] = of->q[i][0], x->q1[i] = of->q[i][1], x->q2[i] = of->q[i][2], x->q3[i] = of->q[i][3];
    step_kick(of->count, x);
    if (torque->more)
        add_more(x, of, torque, t);
    for (size_t i = 0; i < of->count; i++) {
        of->omega[i][0] += dt * (x->T1[i] / of->inertia[i][0]);
        of->omega[i][1] += dt * (x->T2[i] / of->inertia[i][1]);
        of->omega[i][2] += dt * (x->T3[i] / of->inertia[i][2]);
    }
}

/* All steps of some bodies. */
static int advanced(lanes *x, pushed *of, const torque_free_splitting *method,
                    const torque_free_torque *torque, double begin, double step, size_t first,
                    size_t last, size_t *failed)
{
    double pending = 0.0;
    for (size_t k = first; k < last; k++) {
        double into = 0.0;
        for (size_t part = 0; part < method->count; part++) {
            const int code = drifted(x, of, (pending + method->drifts[part]) * step, failed);
            if (code != TORQUE_FREE_STEP_OK)
                return code;
            pending = 0.0;
            into += method->drifts[part];
            kicked(x, of, torque, begin + ((double)k + into) * step, method->kicks[part] * step);
        }
        pending = method->drifts[method->count];
    }
    return first < last ? drifted(x, of, pending * step, failed) : TORQUE_FREE_STEP_OK;
}

int torque_free_integrate(size_t n, const double *inertia, size_t inertia_stride,
                          const torque_free_splitting *method, const torque_free_torque *torque,
                          double begin, double step, size_t first, size_t last, double *q,
                          double *omega, size_t *failed)
{
    lanes x;
    pushed of;
    *failed = 0;
    if (n && !is_rounded_once())
        return TORQUE_FREE_STEP_ARITHMETIC;
    for (size_t start = 0; start < n; start += LANES) {
        const size_t count = n - start < LANES ? n - start : LANES;
        /* One body goes alone; lanes beyond the last of several repeat it. */
        of.count = count > 1 ? LANES : 1;
        for (size_t i = 0; i < of.count; i++) {
            const size_t k = start + (i < count ? i : count - 1);
            const int code = body_init(&of.bodies[i], inertia + k * inertia_stride);
            if (code != TORQUE_FREE_STEP_OK) {
                *failed = k;
                return code;
            }
            memcpy(of.inertia[i], inertia + k * inertia_stride, sizeof of.inertia[i]);
            memcpy(of.q[i], q + 4 * k, sizeof of.q[i]);
            memcpy(of.omega[i], omega + 3 * k, sizeof of.omega[i]);
            set_torque(&x, i, torque->coefficients + k * torque->coefficients_stride);
            if (!torque->orbit)
                set_vector(&x, i, torque->vector + k * torque->vector_stride);
        }
        const int code = advanced(&x, &of, method, torque, begin, step, first, last, failed);
        if (code != TORQUE_FREE_STEP_OK) {
            *failed = start + (*failed < count ? *failed : count - 1);
            return code;
        }
        memcpy(q + 4 * start, of.q, count * sizeof of.q[0]);
        memcpy(omega + 3 * start, of.omega, count * sizeof of.omega[0]);
    }
    return TORQUE_FREE_STEP_OK;
}
