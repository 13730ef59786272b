#include "torque_free_single_step.h"

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
static const torque_free_pair unity = {1.0f, 0.0f}; /* 1 */
static const float pi_hi = 3.1415927410125732f; /* pi */
static const float pi_lo = -8.742277657347586e-08f; /* pi - pi_hi */
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
static const float min_moment_ratio = 9.5367431640625e-07f; /* 2^-20, ratio of two principal moments */
static const float max_step = 8.0f; /* 2^3, |omega dt|, rad */
static const float splitter = 4097.0f; /* 2^12 + 1 */
static const float rounder = 12582912.0f; /* 3 2^22; in n + 3 2^22 the last bits are those of the whole number n, |n| < 2^22 */
enum { sign_place = 31 }; /* the place of the sign among the bits */
static const uint32_t one_bits = 1065353216; /* the bits of 1 */
enum { PREPARED = 2135587861 }; /* the mark of a prepared body: a number that memory hardly has by chance */
/* Return a + b exactly, for |a| >= |b| (Dekker). */
static torque_free_pair quick_sum(float a, float b)
{
    const float s = a + b;
    const float c = s - a;
    const torque_free_pair result = {s, b - c};
    return result;
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

/* The coefficients of Euler's equations, and their products. */
static void step_body(torque_free_pair c_a, torque_free_pair c_b, torque_free_pair c_d, torque_free_pair c_ab,
    torque_free_pair c_ad, torque_free_pair c_bd, float epsilon, torque_free_pair *alpha_a_out,
    torque_free_pair *alpha_b_out, torque_free_pair *alpha_d_out, torque_free_pair *l_a_out,
    torque_free_pair *l_b_out, torque_free_pair *l_d_out)
{
    const torque_free_pair alpha_a = dd_div_xx(dd_mul_dx(epsilon, c_bd), c_a); /* fact: definition step.alpha_a; (10) */
    const torque_free_pair alpha_b = dd_div_xx(dd_mul_dx(-epsilon, c_ad), c_b); /* fact: definition step.alpha_b; (10) */
    const torque_free_pair alpha_d = dd_div_xx(dd_mul_dx(epsilon, c_ab), c_d); /* fact: definition step.alpha_d; (10) */
    const torque_free_pair l_a = dd_div_xx(dd_mul_xx(c_ab, c_ad), dd_mul_xx(c_b, c_d)); /* fact: definition step.l_a; (10) */
    const torque_free_pair l_b = dd_div_xx(dd_mul_xx(c_ab, c_bd), dd_mul_xx(c_a, c_d)); /* fact: definition step.l_b; (10) */
    const torque_free_pair l_d = dd_div_xx(dd_mul_xx(c_ad, c_bd), dd_mul_xx(c_a, c_b)); /* fact: definition step.l_d; (10) */
    *alpha_a_out = alpha_a;
    *alpha_b_out = alpha_b;
    *alpha_d_out = alpha_d;
    *l_a_out = l_a;
    *l_b_out = l_b;
    *l_d_out = l_d;
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

/* Return x + y. */
static torque_free_pair dd_add_xx(torque_free_pair x, torque_free_pair y)
{
    const torque_free_pair s = two_sum(x.hi, y.hi);
    const torque_free_pair t = two_sum(x.lo, y.lo);
    const torque_free_pair v = quick_sum(s.hi, s.lo + t.hi);
    return quick_sum(v.hi, v.lo + t.lo);
}

/* Return x + y. */
static torque_free_pair dd_add_xd(torque_free_pair x, float y)
{
    const torque_free_pair s = two_sum(x.hi, y);
    return quick_sum(s.hi, s.lo + x.lo);
}

/* Return -x. */
static torque_free_pair dd_neg(torque_free_pair x)
{
    const torque_free_pair result = {-x.hi, -x.lo};
    return result;
}

/* Return x - y. */
static torque_free_pair dd_sub_xx(torque_free_pair x, torque_free_pair y)
{
    return dd_add_xx(x, dd_neg(y));
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

/* Momentum, its projection, frequencies, rate of psi; X and Y at the shortest time. */
static void step_start(torque_free_pair c_a, torque_free_pair c_b, torque_free_pair c_d, torque_free_pair l_a,
    torque_free_pair l_b, torque_free_pair l_d, torque_free_pair Omega_a0, torque_free_pair Omega_b0,
    torque_free_pair Omega_d0, float t, float epsilon, float sigma, torque_free_pair *h_out,
    torque_free_pair *e_1_out, torque_free_pair *e_2_out, torque_free_pair *K_out,
    torque_free_pair *Lambda_rate_out, torque_free_pair *X_out, torque_free_pair *Y_out,
    torque_free_pair *z_re_out, torque_free_pair *z_im_out, torque_free_pair *zr_re_out,
    torque_free_pair *zr_im_out)
{
    const torque_free_pair c_ab = dd_sub_xx(c_a, c_b); /* fact: definition step.c_ab; (10) */
    const torque_free_pair c_ad = dd_sub_xx(c_a, c_d); /* fact: definition step.c_ad; (10) */
    const torque_free_pair c_bd = dd_sub_xx(c_b, c_d); /* fact: definition step.c_bd; (10) */
    const torque_free_pair M_a0 = dd_mul_xx(c_a, Omega_a0); /* fact: step.M_a0; (8) */
    const torque_free_pair M_b0 = dd_mul_xx(c_b, Omega_b0); /* fact: step.M_b0; (8) */
    const torque_free_pair M_d0 = dd_mul_xx(c_d, Omega_d0); /* fact: step.M_d0; (8) */
    const torque_free_pair K = dd_sqrt(dd_add_xx(dd_add_xx(dd_mul_xx(M_a0, M_a0), dd_mul_xx(M_b0, M_b0)), dd_mul_xx(M_d0, M_d0))); /* fact: step.K; (6), (15) */
    const torque_free_pair common_1 = dd_mul_xx(Omega_b0, Omega_b0); /* fact: step.h, step.e_1, definition step.H_0; (10), (6) */
    const torque_free_pair common_2 = dd_mul_xx(common_1, l_b); /* fact: step.h, step.e_1; (10) */
    const torque_free_pair common_3 = dd_mul_xx(Omega_d0, Omega_d0); /* fact: step.h, step.e_1, definition step.H_0; (10), (6) */
    const torque_free_pair common_4 = dd_mul_xx(common_3, l_d); /* fact: step.h, step.e_1; (10) */
    const torque_free_pair h = dd_div_xd(dd_add_xx(common_2, common_4), 4.0f); /* fact: step.h; (10) */
    const torque_free_pair common_5 = dd_mul_xx(Omega_a0, Omega_a0); /* fact: step.e_1, definition step.H_0; (10), (6) */
    const torque_free_pair e_1 = dd_sub_xx(dd_add_xx(dd_mul_xx(common_5, l_a), dd_div_xd(common_2, 2.0f)), dd_div_xd(common_4, 2.0f)); /* fact: step.e_1; (10) */
    const torque_free_pair e_2 = dd_mul_xx(h, h); /* fact: definition step.e_2; (10) */
    const torque_free_pair H_0 = dd_div_xd(dd_add_xx(dd_add_xx(dd_mul_xx(c_a, common_5), dd_mul_xx(c_b, common_1)), dd_mul_xx(c_d, common_3)), 2.0f); /* fact: definition step.H_0; (6) */
    const torque_free_pair common_6 = dd_add_xx(K, dd_mul_dx(sigma, M_a0)); /* fact: definition step.psi_0, definition step.z_re, definition step.z_im, step.zr_re, step.zr_im; (33), (34), (27) */
    const torque_free_pair psi_0 = dd_div_xx(dd_add_xx(dd_mul_dx(2.0f, H_0), dd_mul_xx(dd_mul_xd(K, sigma), Omega_a0)), common_6); /* fact: definition step.psi_0; (33), (34) */
    const torque_free_pair z_re = dd_div_xx(M_d0, common_6); /* fact: definition step.z_re; (27) */
    const torque_free_pair z_im = dd_div_xx(dd_mul_dx(epsilon * sigma, M_b0), common_6); /* fact: definition step.z_im; (27) */
    const torque_free_pair common_7 = dd_mul_dx(epsilon, Omega_b0); /* fact: step.zr_re, step.zr_im; (27) */
    const torque_free_pair zr_re = dd_div_xx(dd_mul_xx(common_7, dd_sub_xx(dd_mul_xx(Omega_a0, c_ab), dd_mul_xx(dd_mul_xx(dd_mul_dx(sigma, Omega_d0), c_bd), z_re))), common_6); /* fact: step.zr_re; (27) */
    const torque_free_pair zr_im = dd_div_xx(dd_mul_xx(dd_mul_dx(-sigma, Omega_d0), dd_add_xx(dd_mul_xx(Omega_a0, c_ad), dd_mul_xx(dd_mul_xx(common_7, c_bd), z_im))), common_6); /* fact: step.zr_im; (27) */
    const torque_free_pair Lambda_rate = dd_div_xx(psi_0, dd_mul_dx(2.0f, pi)); /* arithmetic */
    const float first_t = t * (1.0f / 128.0f); /* arithmetic */
    const float common_8 = first_t * first_t; /* classical: DLMF 22.10.1 */
    const float a_1 = dd_rounded(e_1) * common_8; /* classical: DLMF 22.10.1 */
    const float a_2 = dd_rounded(e_2) * (common_8 * common_8); /* classical: DLMF 22.10.1 */
    const float common_9 = a_1 * -1.0f; /* classical: DLMF 22.10.1 */
    const float common_10 = a_1 * -11.0f; /* classical: DLMF 22.10.1 */
    const float more_X = fused(a_2, 1.0f / 10.0f + common_10 / 420.0f, fused(a_1, fused(a_1, 1.0f / 120.0f + common_9 / 5040.0f, -1.0f / 6.0f), 0.0f)); /* classical: DLMF 22.10.1 */
    const float more_Y = fused(a_2, 1.0f / 2.0f + common_10 / 60.0f, fused(a_1, fused(a_1, 1.0f / 24.0f + common_9 / 720.0f, -1.0f / 2.0f), 0.0f)); /* classical: DLMF 22.10.1 */
    const torque_free_pair X = dd_mul_dx(first_t, dd_add_xd(unity, more_X)); /* classical: DLMF 22.10.1 */
    const torque_free_pair Y = dd_add_xd(unity, more_Y); /* classical: DLMF 22.10.1 */
    *h_out = h;
    *e_1_out = e_1;
    *e_2_out = e_2;
    *K_out = K;
    *Lambda_rate_out = Lambda_rate;
    *X_out = X;
    *Y_out = Y;
    *z_re_out = z_re;
    *z_im_out = z_im;
    *zr_re_out = zr_re;
    *zr_im_out = zr_im;
}

/* psi/2 at the shortest time, without its linear part. */
static void step_first(float h, float e_1, float e_2, float X, float z_re, float z_im,
    float zr_re, float zr_im, float *W_re_out, float *W_im_out)
{
    const float nu_re = h * fused(z_im, z_im, -(z_re * z_re)); /* fact: definition turn.nu_re; (27), (36) */
    const float nu_im = -2.0f * h * z_re * z_im; /* fact: definition turn.nu_im; (27), (36) */
    const float rate_re = h * fused(z_im, zr_im, -(z_re * zr_re)); /* fact: definition turn.rate_re; (27), (36) */
    const float rate_im = h * fused(-z_re, zr_im, -(z_im * zr_re)); /* fact: definition turn.rate_im; (27), (36) */
    const float common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36), DLMF 18.12.11 */
    const float G_re = fused(-common_1, nu_re, 1.0f); /* fact: definition turn.G_re; (27), (36) */
    const float G_im = -common_1 * nu_im; /* fact: definition turn.G_im; (27), (36) */
    const float square_X = common_1; /* classical: DLMF 18.12.11 */
    const float d_0 = 1.0f; /* classical: DLMF 18.12.11 */
    const float d_1 = e_1 / 2.0f; /* classical: DLMF 18.12.11 */
    const float d_2 = fused(3.0f / 4.0f, e_1 * d_1, -(1.0f / 2.0f * (e_2 * d_0))); /* classical: DLMF 18.12.11 */
    const float c_0_re = 1.0f; /* classical: DLMF 18.12.11 */
    const float c_0_im = 0.0f; /* classical: DLMF 18.12.11 */
    const float c_1_re = d_1 + fused(nu_re, c_0_re, -(nu_im * c_0_im)); /* classical: DLMF 18.12.11 */
    const float c_1_im = fused(nu_re, c_0_im, nu_im * c_0_re); /* classical: DLMF 18.12.11 */
    const float c_2_re = d_2 + fused(nu_re, c_1_re, -(nu_im * c_1_im)); /* classical: DLMF 18.12.11 */
    const float c_2_im = fused(nu_re, c_1_im, nu_im * c_1_re); /* classical: DLMF 18.12.11 */
    const float common_2 = X * square_X; /* classical: DLMF 18.12.11 */
    const float common_3 = 1.0f / 3.0f; /* classical: DLMF 18.12.11 */
    const float common_4 = 1.0f / 5.0f; /* classical: DLMF 18.12.11 */
    const float common_5 = square_X * (1.0f / 7.0f); /* classical: DLMF 18.12.11 */
    const float J_re = common_2 * fused(common_3, c_0_re, square_X * fused(common_4, c_1_re, common_5 * c_2_re)); /* classical: DLMF 18.12.11 */
    const float J_im = common_2 * fused(common_3, c_0_im, square_X * fused(common_4, c_1_im, common_5 * c_2_im)); /* classical: DLMF 18.12.11 */
    const float chi = fused(rate_re, J_im, rate_im * J_re); /* arithmetic */
    const float common_6 = chi * chi; /* classical: DLMF 4.19.2, DLMF 4.19.1 */
    const float E_re = fused(-(common_6 / 2.0f), 1.0f - common_6 / 12.0f, 1.0f); /* classical: DLMF 4.19.2 */
    const float E_im = chi * fused(-(common_6 / 6.0f), 1.0f - common_6 / 20.0f, 1.0f); /* classical: DLMF 4.19.1 */
    const float R = sqrtf(fused(G_re, G_re, G_im * G_im)); /* fact: thirds.R; (36) */
    const float N = sqrtf(2.0f * R * (R + G_re)); /* fact: thirds.N; (36) */
    const float U_re = (G_re + R) / N; /* fact: definition thirds.U_re; (33), (34) */
    const float U_im = -G_im / N; /* fact: definition thirds.U_im; (33), (34) */
    const float P_re = E_re; /* fact: definition thirds.P_re; (33), (34) */
    const float P_im = E_im; /* fact: definition thirds.P_im; (33), (34) */
    const float W_re = fused(U_re, P_re, -(U_im * P_im)); /* fact: definition thirds.cos_half_psi; (33), (34) */
    const float W_im = fused(U_re, P_im, U_im * P_re); /* fact: definition thirds.sin_half_psi; (33), (34) */
    *W_re_out = W_re;
    *W_im_out = W_im;
}

/* Return x + y. */
static torque_free_pair dd_add_dx(float x, torque_free_pair y)
{
    return dd_add_xd(y, x);
}

/* Return x - y. */
static torque_free_pair dd_sub_dx(float x, torque_free_pair y)
{
    return dd_add_xd(dd_neg(y), x);
}

/* X and Y at twice the time. */
static void step_doubled(torque_free_pair X, torque_free_pair Y, torque_free_pair e_1, torque_free_pair e_2,
    torque_free_pair *X_next_out, torque_free_pair *Y_next_out)
{
    const torque_free_pair common_1 = dd_mul_xx(X, X); /* fact: definition doubling.inside, definition doubling.Y_next; (10) */
    const torque_free_pair common_2 = dd_mul_xx(e_2, dd_mul_xx(dd_mul_xx(common_1, X), X)); /* fact: definition doubling.inside, definition doubling.Y_next; (10) */
    const torque_free_pair inside = dd_sub_dx(1.0f, common_2); /* fact: definition doubling.inside; (10) */
    const torque_free_pair X_next = dd_div_xx(dd_mul_xx(dd_mul_dx(2.0f, X), Y), inside); /* fact: definition doubling.X_next; (10) */
    const torque_free_pair Y_next = dd_sub_dx(1.0f, dd_div_xx(dd_mul_xx(dd_mul_dx(2.0f, common_1), dd_add_xx(dd_mul_xx(dd_mul_dx(-4.0f, e_2), common_1), dd_mul_xx(e_1, dd_add_dx(1.0f, common_2)))), dd_mul_xx(inside, inside))); /* fact: definition doubling.Y_next; (10) */
    *X_next_out = X_next;
    *Y_next_out = Y_next;
}

/* The momentum's projection at the time of X and Y. */
static void step_projected(float h, float z_re, float z_im, float zr_re, float zr_im, float X,
    float Y, float *w_re_out, float *w_im_out)
{
    const float nu_re = h * fused(z_im, z_im, -(z_re * z_re)); /* fact: definition turn.nu_re; (27), (36) */
    const float nu_im = -2.0f * h * z_re * z_im; /* fact: definition turn.nu_im; (27), (36) */
    const float common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
    const float G_re = fused(-common_1, nu_re, 1.0f); /* fact: definition turn.G_re; (27), (36) */
    const float G_im = -common_1 * nu_im; /* fact: definition turn.G_im; (27), (36) */
    const float square = fused(G_re, G_re, G_im * G_im); /* fact: definition turn.square; (27), (36) */
    const float F_re = fused(X, zr_re, Y * z_re); /* fact: definition turn.F_re; (27), (36) */
    const float F_im = fused(X, zr_im, Y * z_im); /* fact: definition turn.F_im; (27), (36) */
    const float w_re = fused(G_re, F_re, G_im * F_im) / square; /* fact: definition turn.w_re; (27), (36) */
    const float w_im = fused(G_re, F_im, -(G_im * F_re)) / square; /* fact: definition turn.w_im; (27), (36) */
    *w_re_out = w_re;
    *w_im_out = w_im;
}

/* psi/2 at twice the time, without its linear part. */
static void step_second_half(float h, float X, float w_re, float w_im, float W_re, float W_im,
    float *W_next_re_out, float *W_next_im_out)
{
    const float nu_re = h * fused(w_im, w_im, -(w_re * w_re)); /* fact: definition turn.nu_re; (27), (36) */
    const float nu_im = -2.0f * h * w_re * w_im; /* fact: definition turn.nu_im; (27), (36) */
    const float common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
    const float G_re = fused(-common_1, nu_re, 1.0f); /* fact: definition turn.G_re; (27), (36) */
    const float G_im = -common_1 * nu_im; /* fact: definition turn.G_im; (27), (36) */
    const float R = sqrtf(fused(G_re, G_re, G_im * G_im)); /* fact: second_half.R; (36) */
    const float V_re = fused(G_re, W_re, G_im * W_im) / R; /* fact: definition second_half.V_re; (33), (34) */
    const float V_im = fused(G_re, W_im, -(G_im * W_re)) / R; /* fact: definition second_half.V_im; (33), (34) */
    const float W_next_re = fused(W_re, V_re, -(W_im * V_im)); /* fact: definition thirds.P_re; (33), (34) */
    const float W_next_im = fused(W_re, V_im, W_im * V_re); /* fact: definition thirds.P_im; (33), (34) */
    *W_next_re_out = W_next_re;
    *W_next_im_out = W_next_im;
}

/* The momentum's projection in extended precision, for the last doublings. */
static void step_last_projected(torque_free_pair h, torque_free_pair z_re, torque_free_pair z_im,
    torque_free_pair zr_re, torque_free_pair zr_im, torque_free_pair X, torque_free_pair Y,
    torque_free_pair *v_re_out, torque_free_pair *v_im_out)
{
    const torque_free_pair nu_re = dd_mul_xx(h, dd_sub_xx(dd_mul_xx(z_im, z_im), dd_mul_xx(z_re, z_re))); /* fact: definition turn.nu_re; (27), (36) */
    const torque_free_pair nu_im = dd_mul_xx(dd_mul_xx(dd_mul_dx(-2.0f, h), z_re), z_im); /* fact: definition turn.nu_im; (27), (36) */
    const torque_free_pair common_1 = dd_mul_xx(X, X); /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
    const torque_free_pair G_re = dd_sub_dx(1.0f, dd_mul_xx(common_1, nu_re)); /* fact: definition turn.G_re; (27), (36) */
    const torque_free_pair G_im = dd_mul_xx(dd_neg(common_1), nu_im); /* fact: definition turn.G_im; (27), (36) */
    const torque_free_pair square = dd_add_xx(dd_mul_xx(G_re, G_re), dd_mul_xx(G_im, G_im)); /* fact: definition turn.square; (27), (36) */
    const torque_free_pair F_re = dd_add_xx(dd_mul_xx(X, zr_re), dd_mul_xx(Y, z_re)); /* fact: definition turn.F_re; (27), (36) */
    const torque_free_pair F_im = dd_add_xx(dd_mul_xx(X, zr_im), dd_mul_xx(Y, z_im)); /* fact: definition turn.F_im; (27), (36) */
    const torque_free_pair v_re = dd_div_xx(dd_add_xx(dd_mul_xx(G_re, F_re), dd_mul_xx(G_im, F_im)), square); /* fact: definition turn.w_re; (27), (36) */
    const torque_free_pair v_im = dd_div_xx(dd_sub_xx(dd_mul_xx(G_re, F_im), dd_mul_xx(G_im, F_re)), square); /* fact: definition turn.w_im; (27), (36) */
    *v_re_out = v_re;
    *v_im_out = v_im;
}

/* psi/2 at twice the time from extended numbers, for the last doublings. */
static void step_last_second_half(torque_free_pair h, torque_free_pair X, torque_free_pair v_re,
    torque_free_pair v_im, float W_re, float W_im, float *W_next_re_out, float *W_next_im_out)
{
    const torque_free_pair nu_re = dd_mul_xx(h, dd_sub_xx(dd_mul_xx(v_im, v_im), dd_mul_xx(v_re, v_re))); /* fact: definition turn.nu_re; (27), (36) */
    const torque_free_pair nu_im = dd_mul_xx(dd_mul_xx(dd_mul_dx(-2.0f, h), v_re), v_im); /* fact: definition turn.nu_im; (27), (36) */
    const torque_free_pair common_1 = dd_mul_xx(X, X); /* fact: definition turn.G_re, definition turn.G_im; (27), (36) */
    const torque_free_pair G_re = dd_sub_dx(1.0f, dd_mul_xx(common_1, nu_re)); /* fact: definition turn.G_re; (27), (36) */
    const torque_free_pair G_im = dd_mul_xx(dd_neg(common_1), nu_im); /* fact: definition turn.G_im; (27), (36) */
    const torque_free_pair R = dd_sqrt(dd_add_xx(dd_mul_xx(G_re, G_re), dd_mul_xx(G_im, G_im))); /* fact: second_half.R; (36) */
    const torque_free_pair V_re = dd_div_xx(dd_add_xx(dd_mul_xd(G_re, W_re), dd_mul_xd(G_im, W_im)), R); /* fact: definition second_half.V_re; (33), (34) */
    const torque_free_pair V_im = dd_div_xx(dd_sub_xx(dd_mul_xd(G_re, W_im), dd_mul_xd(G_im, W_re)), R); /* fact: definition second_half.V_im; (33), (34) */
    const torque_free_pair W_next_re = dd_sub_xx(dd_mul_dx(W_re, V_re), dd_mul_dx(W_im, V_im)); /* fact: definition thirds.P_re; (33), (34) */
    const torque_free_pair W_next_im = dd_add_xx(dd_mul_dx(W_re, V_im), dd_mul_dx(W_im, V_re)); /* fact: definition thirds.P_im; (33), (34) */
    *W_next_re_out = dd_rounded(W_next_re);
    *W_next_im_out = dd_rounded(W_next_im);
}

/* The rates after the step. */
static void step_rates(torque_free_pair X, torque_free_pair Y, torque_free_pair h, torque_free_pair alpha_a,
    torque_free_pair alpha_b, torque_free_pair alpha_d, torque_free_pair l_d, torque_free_pair Omega_a0,
    torque_free_pair Omega_b0, torque_free_pair Omega_d0, torque_free_pair *Omega_a_out,
    torque_free_pair *Omega_b_out, torque_free_pair *Omega_d_out)
{
    const torque_free_pair common_1 = dd_mul_xx(X, X); /* fact: definition step.f, definition step.g, step.room; (10) */
    const torque_free_pair common_2 = dd_mul_xx(common_1, h); /* fact: definition step.f, definition step.g; (10) */
    const torque_free_pair f = dd_add_dx(1.0f, common_2); /* fact: definition step.f; (10) */
    const torque_free_pair g = dd_sub_dx(1.0f, common_2); /* fact: definition step.g; (10) */
    const torque_free_pair room = dd_add_xx(dd_mul_xx(g, g), dd_mul_xx(dd_mul_xx(l_d, dd_mul_xx(Omega_d0, Omega_d0)), common_1)); /* fact: step.room; (10) */
    const torque_free_pair Omega_a = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_a0, f), g), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_a, Omega_b0), Omega_d0), X), Y)), room); /* fact: step.Omega_a; (5), (10) */
    const torque_free_pair Omega_b = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_b0, g), Y), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_b, Omega_a0), Omega_d0), f), X)), room); /* fact: step.Omega_b; (5), (10) */
    const torque_free_pair Omega_d = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_d0, f), Y), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_d, Omega_a0), Omega_b0), g), X)), room); /* fact: step.Omega_d; (5), (10) */
    *Omega_a_out = Omega_a;
    *Omega_b_out = Omega_b;
    *Omega_d_out = Omega_d;
}

/* The shortest rotation that takes the momentum at the start to its axis. */
static void step_shortest_before(torque_free_pair K, torque_free_pair Omega_a0, torque_free_pair Omega_b0,
    torque_free_pair Omega_d0, float c_a, float c_b, float c_d, float epsilon, float sigma,
    float *s_0_out, float *s_b_out, float *s_d_out)
{
    const torque_free_pair M_a = dd_mul_dx(c_a, Omega_a0); /* fact: definition attitude.M_a; (8) */
    const torque_free_pair M_b = dd_mul_dx(c_b, Omega_b0); /* fact: definition attitude.M_b; (8) */
    const torque_free_pair M_d = dd_mul_dx(c_d, Omega_d0); /* fact: definition attitude.M_d; (8) */
    const torque_free_pair common_1 = dd_mul_dx(2.0f, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
    const torque_free_pair nu = dd_sqrt(dd_mul_xx(common_1, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
    const torque_free_pair s_0 = dd_div_xx(nu, common_1); /* fact: definition attitude.s_0; (27) */
    const torque_free_pair s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
    const torque_free_pair s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
    *s_0_out = dd_rounded(s_0);
    *s_b_out = dd_rounded(s_b);
    *s_d_out = dd_rounded(s_d);
}

/* The constant left factor of the attitude. */
static void step_front(float s_0, float s_b, float s_d, float q_0, float q_a, float q_b,
    float q_d, float epsilon, float *p_0_out, float *p_a_out, float *p_b_out, float *p_d_out)
{
    const float qbar_0 = s_0; /* fact: definition attitude.qbar_0; (18), (25) */
    const float qbar_a = 0.0f; /* fact: definition attitude.qbar_a; (18), (25) */
    const float qbar_b = s_b; /* fact: definition attitude.qbar_b; (18), (25) */
    const float qbar_d = s_d; /* fact: definition attitude.qbar_d; (18), (25) */
    const float p_0 = fused(q_d, qbar_d, fused(q_b, qbar_b, fused(q_0, qbar_0, q_a * qbar_a))); /* fact: attitude.p_0; (37) */
    const float p_a = fused(epsilon, fused(q_d, qbar_b, -(q_b * qbar_d)), fused(q_a, qbar_0, -(q_0 * qbar_a))); /* fact: attitude.p_a; (37) */
    const float p_b = fused(epsilon, fused(q_a, qbar_d, -(q_d * qbar_a)), fused(q_b, qbar_0, -(q_0 * qbar_b))); /* fact: attitude.p_b; (37) */
    const float p_d = fused(epsilon, fused(q_b, qbar_a, -(q_a * qbar_b)), fused(q_d, qbar_0, -(q_0 * qbar_d))); /* fact: attitude.p_d; (37) */
    *p_0_out = p_0;
    *p_a_out = p_a;
    *p_b_out = p_b;
    *p_d_out = p_d;
}

/* The shortest rotation that takes the momentum after the step to its axis. */
static void step_shortest(torque_free_pair K, torque_free_pair Omega_a, torque_free_pair Omega_b,
    torque_free_pair Omega_d, float c_a, float c_b, float c_d, float epsilon, float sigma,
    float *s_0_out, float *s_b_out, float *s_d_out)
{
    const torque_free_pair M_a = dd_mul_dx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
    const torque_free_pair M_b = dd_mul_dx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
    const torque_free_pair M_d = dd_mul_dx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
    const torque_free_pair common_1 = dd_mul_dx(2.0f, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
    const torque_free_pair nu = dd_sqrt(dd_mul_xx(common_1, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
    const torque_free_pair s_0 = dd_div_xx(nu, common_1); /* fact: definition attitude.s_0; (27) */
    const torque_free_pair s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
    const torque_free_pair s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
    *s_0_out = dd_rounded(s_0);
    *s_b_out = dd_rounded(s_b);
    *s_d_out = dd_rounded(s_d);
}

/* Return the nearest whole number, for |x| < 2^51. */
static float nearest(float x)
{
    const float shifted = x + rounder;
    return shifted - rounder;
}

/* Return (-1)^n for a whole number n: its last bit becomes the sign of 1. */
static float alternating(float n)
{
    return from_bits(one_bits | (bits_of(n + rounder) << sign_place));
}

/* The attitude after the step. */
static void step_attitude(float t, float Lambda_rate_hi, float Lambda_rate_lo, float W_re,
    float W_im, float s_0, float s_b, float s_d, float p_0, float p_a, float p_b, float p_d,
    float epsilon, float sigma, float *q_0_out, float *q_a_out, float *q_b_out,
    float *q_d_out)
{
    const float L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
    const float L_error = fused(Lambda_rate_lo, t, product_error(Lambda_rate_hi, t, L)); /* arithmetic: Dekker 1971 */
    const float L_whole = nearest(L); /* classical: DLMF 4.16 */
    const float L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
    const float L_turns = L_rest + L_error; /* classical: DLMF 4.16 */
    const float L_square = L_turns * L_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
    const float L_sign = alternating(L_whole); /* classical: DLMF 4.16 */
    const float X_im = L_sign * fused(L_turns, pi_hi, L_turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_4, sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
    const float X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_4, cosine_3), cosine_2), cosine_1), cosine_0), 1.0f); /* classical: DLMF 4.19.2 */
    const float turn_re = fused(X_re, W_re, -(X_im * W_im)); /* fact: definition thirds.P_re; (33), (34) */
    const float turn_im = fused(X_re, W_im, X_im * W_re); /* fact: definition thirds.P_im; (33), (34) */
    const float qbar_0 = turn_re * s_0; /* fact: definition attitude.qbar_0; (18), (25) */
    const float qbar_a = sigma * turn_im * s_0; /* fact: definition attitude.qbar_a; (18), (25) */
    const float common_1 = epsilon * sigma * turn_im; /* fact: definition attitude.qbar_b, definition attitude.qbar_d; (18), (25) */
    const float qbar_b = fused(turn_re, s_b, -(common_1 * s_d)); /* fact: definition attitude.qbar_b; (18), (25) */
    const float qbar_d = fused(turn_re, s_d, common_1 * s_b); /* fact: definition attitude.qbar_d; (18), (25) */
    const float q_0 = fused(-p_d, qbar_d, fused(-p_b, qbar_b, fused(p_0, qbar_0, -(p_a * qbar_a)))); /* fact: definition attitude.q_0; (37) */
    const float q_a = fused(epsilon, fused(p_b, qbar_d, -(p_d * qbar_b)), fused(p_0, qbar_a, p_a * qbar_0)); /* fact: definition attitude.q_a; (37) */
    const float q_b = fused(epsilon, fused(p_d, qbar_a, -(p_a * qbar_d)), fused(p_0, qbar_b, p_b * qbar_0)); /* fact: definition attitude.q_b; (37) */
    const float q_d = fused(epsilon, fused(p_a, qbar_b, -(p_b * qbar_a)), fused(p_0, qbar_d, p_d * qbar_0)); /* fact: definition attitude.q_d; (37) */
    *q_0_out = q_0;
    *q_a_out = q_a;
    *q_b_out = q_b;
    *q_d_out = q_d;
}

/* Return a float as an extended number. */
static torque_free_pair dd_of(float a)
{
    const torque_free_pair result = {a, 0.0f};
    return result;
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

/* Return the largest size of three numbers. */
static float largest_of(float x, float y, float z)
{
    const float larger = fabsf(y) >= fabsf(z) ? fabsf(y) : fabsf(z);
    return fabsf(x) >= larger ? fabsf(x) : larger;
}

/* Return the largest size of a quaternion's components. */
static float size_of(const float q[4])
{
    const float larger = largest_of(q[1], q[2], q[3]);
    return fabsf(q[0]) >= larger ? fabsf(q[0]) : larger;
}

/* Return the exponent to scale by, 0 for moderate numbers and for what is not finite. The highest
   powers of moderate rates, for binary32 the 22nd, do not overflow. */
static int scale(float largest)
{
    const int is_moderate = largest >= 1.0f / 1024.0f && largest <= 1024.0f;
    return is_moderate || !isfinite(largest) ? 0 : exponent_of(largest);
}

/* Return x 2^power, and x itself where the power is 0. */
static float times_power(float x, int power)
{
    return power != 0 ? ldexpf(x, power) : x;
}

/* Return the exponent that takes moments to their inner units. */
static int moment_scale(const float inertia[3])
{
    return -scale(largest_of(inertia[0], inertia[1], inertia[2]));
}

/* Return True for moments that a body can have, up to rounding. */
static int is_possible(const float c[3])
{
    torque_free_pair moments[3];
    for (size_t k = 0; k < 3; k++) {
        moments[k].hi = c[k];
        moments[k].lo = 0.0f;
    }
    return can_exist(moments);
}

/* Check the moments of a body, and these in inner units; return a code. */
static int body_code(const float inertia[3], const float c[3])
{
    const float largest = largest_of(inertia[0], inertia[1], inertia[2]);
    const float less = inertia[1] <= inertia[2] ? inertia[1] : inertia[2];
    const float smallest = inertia[0] <= less ? inertia[0] : less;
    const int is_number = !isnan(inertia[0] + inertia[1] + inertia[2]);
    const int is_positive = inertia[0] > 0.0f && inertia[1] > 0.0f && inertia[2] > 0.0f;
    const float divisor = is_positive ? largest : 1.0f;
    return !is_positive ? (is_number ? TORQUE_FREE_SINGLE_STEP_INERTIA : TORQUE_FREE_SINGLE_STEP_NOT_FINITE) : (!isfinite(largest) ? TORQUE_FREE_SINGLE_STEP_NOT_FINITE : (!(ALLOW_NONPHYSICAL || is_possible(c)) ? TORQUE_FREE_SINGLE_STEP_NONPHYSICAL : (smallest / divisor < min_moment_ratio ? TORQUE_FREE_SINGLE_STEP_THIN : TORQUE_FREE_SINGLE_STEP_OK)));
}

/* Return the axes by their moments, the largest first, and 1, or -1 where they are left-handed. Of
   equal moments, that of the axis next in turn is first. */
static void order_of(const float inertia[3], int *first_out, int *second_out, int *third_out,
    float *epsilon_out)
{
    const int above = inertia[0] >= inertia[2] ? 0 : 2;
    const int below = inertia[1] >= inertia[2] ? 1 : 2;
    const int first = inertia[0] >= inertia[1] ? above : below;
    const int one = (first + 1) % 3;
    const int other = (first + 2) % 3;
    const int is_turned = inertia[one] < inertia[other];
    const int second = is_turned ? other : one;
    const int third = is_turned ? one : other;
    const float epsilon = is_turned ? -1.0f : 1.0f;
    *first_out = first;
    *second_out = second;
    *third_out = third;
    *epsilon_out = epsilon;
}

/* Check an attitude, rates and a time; return a code. */
static int state_code(const float q[4], const float omega[3], float dt)
{
    float sum = dt;
    for (size_t k = 0; k < 3; k++) {
        sum += 0.0f * omega[k] + 0.0f * q[1 + k];
    }
    const int is_number = isfinite(sum + 0.0f * q[0]);
    return !is_number ? TORQUE_FREE_SINGLE_STEP_NOT_FINITE : (size_of(q) > 0.0f ? TORQUE_FREE_SINGLE_STEP_OK : TORQUE_FREE_SINGLE_STEP_ATTITUDE);
}

/* Return the exponent that scales rates, whether nothing turns, and the scaled time. */
static void scaled_time(const float omega[3], float dt, int *power_out, int *is_still_out,
    float *t_out)
{
    const float largest = largest_of(omega[0], omega[1], omega[2]);
    const int power = scale(largest);
    const int is_still = !(largest > 0.0f && fabsf(dt) > 0.0f);
    const float t = is_still ? 0.0f : times_power(dt, power);
    *power_out = power;
    *is_still_out = is_still;
    *t_out = t;
}

/* Return the scaled rates in the order of axes, for a body at rest those of a spin. At rest the
   momentum has no direction to divide by. */
static void scaled_rates(const int axis[3], const float omega[3], int power, float *a_out,
    float *b_out, float *d_out)
{
    const int is_turning = largest_of(omega[0], omega[1], omega[2]) > 0.0f;
    const float a = is_turning ? times_power(omega[axis[0]], -power) : 1.0f;
    const float b = times_power(omega[axis[1]], -power);
    const float d = times_power(omega[axis[2]], -power);
    *a_out = a;
    *b_out = b;
    *d_out = d;
}

/* Return a quaternion times a power of two, so that squares neither overflow nor vanish. */
static void scaled_attitude(const float q[4], float *result_1_out, float *result_2_out,
    float *result_3_out, float *result_4_out)
{
    const int power = -scale(size_of(q));
    *result_1_out = times_power(q[0], power);
    *result_2_out = times_power(q[1], power);
    *result_3_out = times_power(q[2], power);
    *result_4_out = times_power(q[3], power);
}

/* Return True where a step turns by no more than the largest angle. */
static int is_short(float a, float b, float d, float t)
{
    return sqrtf(a * a + b * b + d * d) * fabsf(t) <= max_step;
}

/* Return True where the momentum circulates about the axis of smallest moment. That is where K^2 <
   2 H c_b. */
static int is_under(float l_a, float l_d, float a, float d)
{
    return l_a * a * a < l_d * d * d;
}

/* Return x over the root of a square, with little more error than one rounding. */
static float divided(float x, float over, float more)
{
    const float y = x * over;
    return y + (product_error(x, over, y) + x * more);
}

/* Normalise a quaternion. */
static void unit(float q_0, float q_a, float q_b, float q_d, float *result_1_out,
    float *result_2_out, float *result_3_out, float *result_4_out)
{
    const torque_free_pair first = dd_add_xx(two_product(q_0, q_0), two_product(q_a, q_a));
    const torque_free_pair square = dd_add_xx(first, dd_add_xx(two_product(q_b, q_b), two_product(q_d, q_d)));
    const float over = 1.0f / sqrtf(square.hi);
    const torque_free_pair rest = dd_sub_dx(1.0f, dd_mul_xx(square, two_product(over, over)));
    const float more = over * (rest.hi + rest.lo) / 2.0f;
    *result_1_out = divided(q_0, over, more);
    *result_2_out = divided(q_a, over, more);
    *result_3_out = divided(q_b, over, more);
    *result_4_out = divided(q_d, over, more);
}

/* Round a pair up or down, to the nearer float more often; chance is between -1/2 and 1/2. */
static float dithered(torque_free_pair x, float chance)
{
    const float size = fabsf(x.hi);
    const float next = size + size * 5.960465188081798e-08f;
    return x.hi + (x.lo + chance * (next - size));
}

/* Round rates up or down at random, by the attitude's last digits. Rounded to nearest, a slow
   motion's rates would err one way for long. */
static void stochastic(float q_0, float q_a, float q_b, torque_free_pair a, torque_free_pair b,
    torque_free_pair d, float *result_1_out, float *result_2_out, float *result_3_out)
{
    const uint32_t one = bits_of(q_0);
    const uint32_t two = bits_of(q_a);
    const uint32_t three = bits_of(q_b);
    const uint32_t turned = ((two << 10) | (two >> 22)) ^ ((three << 20) | (three >> 12));
    uint32_t mixed = (one ^ turned) * UINT32_C(0x9e3779b9);
    mixed = (mixed ^ (mixed >> 16)) * UINT32_C(0xd6e8feb9);
    mixed ^= mixed >> 16;
    const float for_a = from_bits(UINT32_C(0x3f800000) | ((mixed >> 22) << 13)) - 1.5f;
    const float for_b = from_bits(UINT32_C(0x3f800000) | (((mixed << 10) >> 22) << 13)) - 1.5f;
    const float for_d = from_bits(UINT32_C(0x3f800000) | (((mixed << 20) >> 22) << 13)) - 1.5f;
    *result_1_out = dithered(a, for_a);
    *result_2_out = dithered(b, for_b);
    *result_3_out = dithered(d, for_d);
}

/* Return True where a state is finite. Nonphysical bodies can turn much faster than at the start.
   */
static int is_finite_state(float q_0, float q_a, float q_b, float q_d, float a,
    float b, float d)
{
    return isfinite(q_0 + q_a + q_b + q_d + a + b + d);
}

/* Return the place of each axis in the order of axes, whose ends are swapped if `is_turned`. */
static void places(const int axis[3], int is_turned, int *result_1_out, int *result_2_out,
    int *result_3_out)
{
    const int first = is_turned ? axis[2] : axis[0];
    *result_1_out = first == 0 ? 0 : (axis[1] == 0 ? 1 : 2);
    *result_2_out = first == 1 ? 0 : (axis[1] == 1 ? 1 : 2);
    *result_3_out = first == 2 ? 0 : (axis[1] == 2 ? 1 : 2);
}

int torque_free_single_body_init(torque_free_single_body *body, const float inertia[3])
{
    const int power = moment_scale(inertia);
    float c[3];
    for (size_t k = 0; k < 3; k++) {
        c[k] = times_power(inertia[k], power);
    }
    const int code = body_code(inertia, c);
    if (code != TORQUE_FREE_SINGLE_STEP_OK) {
        return code;
    }
    int first;
    int second;
    int third;
    float epsilon;
    order_of(inertia, &first, &second, &third, &epsilon);
    const float c_a = c[first];
    const float c_b = c[second];
    const float c_d = c[third];
    const torque_free_pair c_ab = two_sum(c_a, -c_b);
    const torque_free_pair c_ad = two_sum(c_a, -c_d);
    const torque_free_pair c_bd = two_sum(c_b, -c_d);
    torque_free_pair alpha_a;
    torque_free_pair alpha_b;
    torque_free_pair alpha_d;
    torque_free_pair l_a;
    torque_free_pair l_b;
    torque_free_pair l_d;
    step_body(dd_of(c_a), dd_of(c_b), dd_of(c_d), c_ab, c_ad, c_bd, epsilon, &alpha_a, &alpha_b, &alpha_d, &l_a, &l_b, &l_d);
    body->axis[0] = first;
    body->axis[1] = second;
    body->axis[2] = third;
    body->epsilon = epsilon;
    body->moments[0] = c_a;
    body->moments[1] = c_b;
    body->moments[2] = c_d;
    body->alphas[0] = alpha_a;
    body->alphas[1] = alpha_b;
    body->alphas[2] = alpha_d;
    body->squares[0] = l_a;
    body->squares[1] = l_b;
    body->squares[2] = l_d;
    body->prepared = PREPARED;
    return TORQUE_FREE_SINGLE_STEP_OK;
}

/* Return the attitude and the rates after a time, about the axes a, b, d. */
static void moved(float c_a, float c_b, float c_d, torque_free_pair alpha_a, torque_free_pair alpha_b,
    torque_free_pair alpha_d, torque_free_pair l_a, torque_free_pair l_b, torque_free_pair l_d, float q_0,
    float q_a, float q_b, float q_d, float Omega_a0, float Omega_b0, float Omega_d0, float t,
    float epsilon, float sigma, float *unit_0_out, float *unit_a_out, float *unit_b_out,
    float *unit_d_out, float *rate_a_out, float *rate_b_out, float *rate_d_out)
{
    torque_free_pair h;
    torque_free_pair e_1;
    torque_free_pair e_2;
    torque_free_pair K;
    torque_free_pair Lambda_rate;
    torque_free_pair X;
    torque_free_pair Y;
    torque_free_pair z_re;
    torque_free_pair z_im;
    torque_free_pair zr_re;
    torque_free_pair zr_im;
    step_start(dd_of(c_a), dd_of(c_b), dd_of(c_d), l_a, l_b, l_d, dd_of(Omega_a0), dd_of(Omega_b0), dd_of(Omega_d0), t, epsilon, sigma, &h, &e_1, &e_2, &K, &Lambda_rate, &X, &Y, &z_re, &z_im, &zr_re, &zr_im);
    float W_re;
    float W_im;
    step_first(h.hi, e_1.hi, e_2.hi, X.hi, z_re.hi, z_im.hi, zr_re.hi, zr_im.hi, &W_re, &W_im);
    for (size_t k = 0; k < 7; k++) {
        if (k < 7 - 0) {
            float w_re;
            float w_im;
            step_projected(h.hi, z_re.hi, z_im.hi, zr_re.hi, zr_im.hi, X.hi, Y.hi, &w_re, &w_im);
            step_second_half(h.hi, X.hi, w_re, w_im, W_re, W_im, &W_re, &W_im);
        } else {
            torque_free_pair v_re;
            torque_free_pair v_im;
            step_last_projected(h, z_re, z_im, zr_re, zr_im, X, Y, &v_re, &v_im);
            step_last_second_half(h, X, v_re, v_im, W_re, W_im, &W_re, &W_im);
        }
        step_doubled(X, Y, e_1, e_2, &X, &Y);
    }
    torque_free_pair Omega_a;
    torque_free_pair Omega_b;
    torque_free_pair Omega_d;
    step_rates(X, Y, h, alpha_a, alpha_b, alpha_d, l_d, dd_of(Omega_a0), dd_of(Omega_b0), dd_of(Omega_d0), &Omega_a, &Omega_b, &Omega_d);
    float s_0;
    float s_b;
    float s_d;
    step_shortest_before(K, dd_of(Omega_a0), dd_of(Omega_b0), dd_of(Omega_d0), c_a, c_b, c_d, epsilon, sigma, &s_0, &s_b, &s_d);
    float p_0;
    float p_a;
    float p_b;
    float p_d;
    step_front(s_0, s_b, s_d, q_0, q_a, q_b, q_d, epsilon, &p_0, &p_a, &p_b, &p_d);
    step_shortest(K, Omega_a, Omega_b, Omega_d, c_a, c_b, c_d, epsilon, sigma, &s_0, &s_b, &s_d);
    float turn_0;
    float turn_a;
    float turn_b;
    float turn_d;
    step_attitude(t, Lambda_rate.hi, Lambda_rate.lo, W_re, W_im, s_0, s_b, s_d, p_0, p_a, p_b, p_d, epsilon, sigma, &turn_0, &turn_a, &turn_b, &turn_d);
    float unit_0;
    float unit_a;
    float unit_b;
    float unit_d;
    unit(turn_0, turn_a, turn_b, turn_d, &unit_0, &unit_a, &unit_b, &unit_d);
    float rate_a;
    float rate_b;
    float rate_d;
    stochastic(unit_0, unit_a, unit_b, Omega_a, Omega_b, Omega_d, &rate_a, &rate_b, &rate_d);
    *unit_0_out = unit_0;
    *unit_a_out = unit_a;
    *unit_b_out = unit_b;
    *unit_d_out = unit_d;
    *rate_a_out = rate_a;
    *rate_b_out = rate_b;
    *rate_d_out = rate_d;
}

int torque_free_single_step(const torque_free_single_body *body, float q[4], float omega[3],
    float dt)
{
    if (body->prepared != PREPARED) {
        return TORQUE_FREE_SINGLE_STEP_UNPREPARED;
    }
    const int code = state_code(q, omega, dt);
    if (code != TORQUE_FREE_SINGLE_STEP_OK) {
        return code;
    }
    int power;
    int is_still;
    float t;
    scaled_time(omega, dt, &power, &is_still, &t);
    float first;
    float second;
    float third;
    scaled_rates(body->axis, omega, power, &first, &second, &third);
    if (!is_short(first, second, third, t)) {
        return TORQUE_FREE_SINGLE_STEP_ANGLE;
    }
    float given[4];
    scaled_attitude(q, &given[0], &given[1], &given[2], &given[3]);
    if (is_still) {
        unit(given[0], given[1], given[2], given[3], &q[0], &q[1], &q[2], &q[3]);
        return TORQUE_FREE_SINGLE_STEP_OK;
    }
    /* The axis a is that of largest moment, or of smallest where K^2 < 2 H c_b. */
    const int is_turned = is_under(body->squares[0].hi, body->squares[2].hi, first, third);
    const size_t a = is_turned ? 2 : 0;
    const size_t d = is_turned ? 0 : 2;
    const float rate_a = is_turned ? third : first;
    const float rate_d = is_turned ? first : third;
    float parts[3];
    float rates[3];
    float q_0;
    moved(body->moments[a], body->moments[1], body->moments[d], body->alphas[a], body->alphas[1], body->alphas[d], body->squares[a], body->squares[1], body->squares[d], given[0], given[1 + body->axis[a]], given[1 + body->axis[1]], given[1 + body->axis[d]], rate_a, second, rate_d, t, is_turned ? -body->epsilon : body->epsilon, rate_a < 0.0f ? -1.0f : 1.0f, &q_0, &parts[0], &parts[1], &parts[2], &rates[0], &rates[1], &rates[2]);
    if (!is_finite_state(q_0, parts[0], parts[1], parts[2], rates[0], rates[1], rates[2])) {
        return TORQUE_FREE_SINGLE_STEP_ANGLE;
    }
    int place_1;
    int place_2;
    int place_3;
    places(body->axis, is_turned, &place_1, &place_2, &place_3);
    q[0] = q_0;
    q[1] = parts[place_1];
    q[2] = parts[place_2];
    q[3] = parts[place_3];
    omega[0] = times_power(rates[place_1], power);
    omega[1] = times_power(rates[place_2], power);
    omega[2] = times_power(rates[place_3], power);
    return TORQUE_FREE_SINGLE_STEP_OK;
}

const char *torque_free_single_step_digest(void)
{
    return "2cd8d91b9c80a605b058dbfe0173b4a2fcab6b571eb74316655b1e78a40ff56e";
}

