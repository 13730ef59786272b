#include "torque_free_step.h"
#include "torque_free_arithmetic.h"

/* How many bodies are computed side by side. */
#ifndef LANES
#define LANES 16
#endif
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
static const double min_moment_ratio = 6.223015277861142e-61; /* 2^-200, ratio of two principal moments */
static const double max_step = 8.0; /* 2^3, |omega dt|, rad */
enum { CODES = 9 };
static const char UNKNOWN[13] = "no such code";
static const char MESSAGES[CODES][112] = {"success", "every number must be finite", "inertia: principal moments must be positive", "inertia: principal moments differ by more than binary64 can follow", "q: a zero quaternion is no attitude", "dt: |omega dt| must be at most 8 rad", "arithmetic: sums are reordered or not rounded to nearest", "inertia: no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)", "body: torque_free_body_init has not made it"};
static const char FIELDS[CODES][11] = {"", "", "inertia", "inertia", "q", "dt", "arithmetic", "inertia", "body"};
static const char RULES[CODES][103] = {"success", "every number must be finite", "principal moments must be positive", "principal moments differ by more than binary64 can follow", "a zero quaternion is no attitude", "|omega dt| must be at most 8 rad", "sums are reordered or not rounded to nearest", "no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)", "torque_free_body_init has not made it"};
static const double lane_cases[4] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596, 0.15335179025447007}; /* three moments, which also serve as elapsed functions, and a constant */
enum { PREPARED = 2135587861 }; /* the mark of a prepared body: a number that memory hardly has by chance */

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
/* The given state of a lane, the exponent that scales its rates, and whether nothing turns. */
typedef struct {
    int axis[3];
    int power;
    int is_still;
    double q[4];
    double omega[3];
} scaling;
/* Bodies side by side with their states; results do not depend on the lane. */
typedef struct {
    size_t count;
    torque_free_body bodies[LANES];
    double inertia[LANES][3];
    double q[LANES][4];
    double omega[LANES][3];
} pushed;
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
        const double_double common_2 = dd_mul_xx(common_1, l_b); /* fact: step.h, step.e_1; (10) */
        const double_double common_3 = dd_mul_xx(Omega_d0, Omega_d0); /* fact: step.h, step.e_1, definition step.H_0; (10), (6) */
        const double_double common_4 = dd_mul_xx(common_3, l_d); /* fact: step.h, step.e_1; (10) */
        const double_double h = dd_div_xd(dd_add_xx(common_2, common_4), 4.0); /* fact: step.h; (10) */
        const double_double common_5 = dd_mul_xx(Omega_a0, Omega_a0); /* fact: step.e_1, definition step.H_0; (10), (6) */
        const double_double e_1 = dd_sub_xx(dd_add_xx(dd_mul_xx(common_5, l_a), dd_div_xd(common_2, 2.0)), dd_div_xd(common_4, 2.0)); /* fact: step.e_1; (10) */
        const double_double e_2 = dd_mul_xx(h, h); /* fact: definition step.e_2; (10) */
        const double_double H_0 = dd_div_xd(dd_add_xx(dd_add_xx(dd_mul_xx(c_a, common_5), dd_mul_xx(c_b, common_1)), dd_mul_xx(c_d, common_3)), 2.0); /* fact: definition step.H_0; (6) */
        const double_double common_6 = dd_add_xx(K, dd_mul_dx(sigma, M_a0)); /* fact: definition step.psi_0, definition step.z_re, definition step.z_im, step.zr_re, step.zr_im; (33), (34), (27) */
        const double_double psi_0 = dd_div_xx(dd_add_xx(dd_mul_dx(2.0, H_0), dd_mul_xx(dd_mul_xd(K, sigma), Omega_a0)), common_6); /* fact: definition step.psi_0; (33), (34) */
        const double_double z_re = dd_div_xx(M_d0, common_6); /* fact: definition step.z_re; (27) */
        const double_double z_im = dd_div_xx(dd_mul_dx(epsilon * sigma, M_b0), common_6); /* fact: definition step.z_im; (27) */
        const double_double common_7 = dd_mul_dx(epsilon, Omega_b0); /* fact: step.zr_re, step.zr_im; (27) */
        const double_double zr_re = dd_div_xx(dd_mul_xx(common_7, dd_sub_xx(dd_mul_xx(Omega_a0, c_ab), dd_mul_xx(dd_mul_xx(dd_mul_dx(sigma, Omega_d0), c_bd), z_re))), common_6); /* fact: step.zr_re; (27) */
        const double_double zr_im = dd_div_xx(dd_mul_xx(dd_mul_dx(-sigma, Omega_d0), dd_add_xx(dd_mul_xx(Omega_a0, c_ad), dd_mul_xx(dd_mul_xx(common_7, c_bd), z_im))), common_6); /* fact: step.zr_im; (27) */
        const double_double Lambda_rate = dd_div_xx(psi_0, dd_mul_dx(2.0, pi)); /* arithmetic */
        const double first_t = t * (1.0 / 32.0); /* arithmetic */
        const double common_8 = first_t * first_t; /* classical: DLMF 22.10.1 */
        const double a_1 = dd_rounded(e_1) * common_8; /* classical: DLMF 22.10.1 */
        const double a_2 = dd_rounded(e_2) * (common_8 * common_8); /* classical: DLMF 22.10.1 */
        const double common_9 = 1.0 / 120.0; /* classical: DLMF 22.10.1 */
        const double common_10 = a_1 * -1.0; /* classical: DLMF 22.10.1 */
        const double common_11 = a_1 * -24911.0; /* classical: DLMF 22.10.1 */
        const double common_12 = a_1 * -258821.0; /* classical: DLMF 22.10.1 */
        const double common_13 = a_1 * -13511.0; /* classical: DLMF 22.10.1 */
        const double more_X = fused(a_2, fused(a_2, fused(a_2, 11.0 / 15600.0 + common_13 / 36036000.0, fused(a_1, fused(a_1, 9481.0 / 14414400.0 + common_12 / 3027024000.0, -307.0 / 92400.0), common_9)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, 8303.0 / 518918400.0 + common_11 / 36324288000.0, -461.0 / 1663200.0), 17.0 / 5040.0), -11.0 / 420.0), 1.0 / 10.0)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, 1.0 / 6227020800.0 + common_10 / 1307674368000.0, -1.0 / 39916800.0), 1.0 / 362880.0), -1.0 / 5040.0), common_9), -1.0 / 6.0), 0.0)); /* classical: DLMF 22.10.1 */
        const double more_Y = fused(a_2, fused(a_2, fused(a_2, 11.0 / 1200.0 + common_13 / 2402400.0, fused(a_1, fused(a_1, 9481.0 / 1108800.0 + common_12 / 201801600.0, -307.0 / 8400.0), 3.0 / 40.0)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, 8303.0 / 39916800.0 + common_11 / 2421619200.0, -461.0 / 151200.0), 17.0 / 560.0), -11.0 / 60.0), 1.0 / 2.0)), fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, fused(a_1, 1.0 / 479001600.0 + common_10 / 87178291200.0, -1.0 / 3628800.0), 1.0 / 40320.0), -1.0 / 720.0), 1.0 / 24.0), -1.0 / 2.0), 0.0)); /* classical: DLMF 22.10.1 */
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
        const double rate_im = h * fused(-z_re, zr_im, -(z_im * zr_re)); /* fact: definition turn.rate_im; (27), (36) */
        const double common_1 = X * X; /* fact: definition turn.G_re, definition turn.G_im; (27), (36), DLMF 18.12.11 */
        const double G_re = fused(-common_1, nu_re, 1.0); /* fact: definition turn.G_re; (27), (36) */
        const double G_im = -common_1 * nu_im; /* fact: definition turn.G_im; (27), (36) */
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
        const double N = sqrt(2.0 * R * (R + G_re)); /* fact: thirds.N; (36) */
        const double U_re = (G_re + R) / N; /* fact: definition thirds.U_re; (33), (34) */
        const double U_im = -G_im / N; /* fact: definition thirds.U_im; (33), (34) */
        const double P_re = E_re; /* fact: definition thirds.P_re; (33), (34) */
        const double P_im = E_im; /* fact: definition thirds.P_im; (33), (34) */
        const double W_re = fused(U_re, P_re, -(U_im * P_im)); /* fact: definition thirds.cos_half_psi; (33), (34) */
        const double W_im = fused(U_re, P_im, U_im * P_re); /* fact: definition thirds.sin_half_psi; (33), (34) */
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
        const double_double Y_next = dd_sub_dx(1.0, dd_div_xx(dd_mul_xx(dd_mul_dx(2.0, common_1), dd_add_xx(dd_mul_xx(dd_mul_dx(-4.0, e_2), common_1), dd_mul_xx(e_1, dd_add_dx(1.0, common_2)))), dd_mul_xx(inside, inside))); /* fact: definition doubling.Y_next; (10) */
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
        const double G_re = fused(-common_1, nu_re, 1.0); /* fact: definition turn.G_re; (27), (36) */
        const double G_im = -common_1 * nu_im; /* fact: definition turn.G_im; (27), (36) */
        const double square = fused(G_re, G_re, G_im * G_im); /* fact: definition turn.square; (27), (36) */
        const double F_re = fused(X, zr_re, Y * z_re); /* fact: definition turn.F_re; (27), (36) */
        const double F_im = fused(X, zr_im, Y * z_im); /* fact: definition turn.F_im; (27), (36) */
        const double w_re = fused(G_re, F_re, G_im * F_im) / square; /* fact: definition turn.w_re; (27), (36) */
        const double w_im = fused(G_re, F_im, -(G_im * F_re)) / square; /* fact: definition turn.w_im; (27), (36) */
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
        const double G_re = fused(-common_1, nu_re, 1.0); /* fact: definition turn.G_re; (27), (36) */
        const double G_im = -common_1 * nu_im; /* fact: definition turn.G_im; (27), (36) */
        const double R = sqrt(fused(G_re, G_re, G_im * G_im)); /* fact: second_half.R; (36) */
        const double V_re = fused(G_re, W_re, G_im * W_im) / R; /* fact: definition second_half.V_re; (33), (34) */
        const double V_im = fused(G_re, W_im, -(G_im * W_re)) / R; /* fact: definition second_half.V_im; (33), (34) */
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
        const double_double G_re = dd_sub_dx(1.0, dd_mul_xx(common_1, nu_re)); /* fact: definition turn.G_re; (27), (36) */
        const double_double G_im = dd_mul_xx(dd_neg(common_1), nu_im); /* fact: definition turn.G_im; (27), (36) */
        const double_double square = dd_add_xx(dd_mul_xx(G_re, G_re), dd_mul_xx(G_im, G_im)); /* fact: definition turn.square; (27), (36) */
        const double_double F_re = dd_add_xx(dd_mul_xx(X, zr_re), dd_mul_xx(Y, z_re)); /* fact: definition turn.F_re; (27), (36) */
        const double_double F_im = dd_add_xx(dd_mul_xx(X, zr_im), dd_mul_xx(Y, z_im)); /* fact: definition turn.F_im; (27), (36) */
        const double_double v_re = dd_div_xx(dd_add_xx(dd_mul_xx(G_re, F_re), dd_mul_xx(G_im, F_im)), square); /* fact: definition turn.w_re; (27), (36) */
        const double_double v_im = dd_div_xx(dd_sub_xx(dd_mul_xx(G_re, F_im), dd_mul_xx(G_im, F_re)), square); /* fact: definition turn.w_im; (27), (36) */
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
        const double_double G_re = dd_sub_dx(1.0, dd_mul_xx(common_1, nu_re)); /* fact: definition turn.G_re; (27), (36) */
        const double_double G_im = dd_mul_xx(dd_neg(common_1), nu_im); /* fact: definition turn.G_im; (27), (36) */
        const double_double R = dd_sqrt(dd_add_xx(dd_mul_xx(G_re, G_re), dd_mul_xx(G_im, G_im))); /* fact: second_half.R; (36) */
        const double_double V_re = dd_div_xx(dd_add_xx(dd_mul_xd(G_re, W_re), dd_mul_xd(G_im, W_im)), R); /* fact: definition second_half.V_re; (33), (34) */
        const double_double V_im = dd_div_xx(dd_sub_xx(dd_mul_xd(G_re, W_im), dd_mul_xd(G_im, W_re)), R); /* fact: definition second_half.V_im; (33), (34) */
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
        const double_double common_2 = dd_mul_xx(common_1, h); /* fact: definition step.f, definition step.g; (10) */
        const double_double f = dd_add_dx(1.0, common_2); /* fact: definition step.f; (10) */
        const double_double g = dd_sub_dx(1.0, common_2); /* fact: definition step.g; (10) */
        const double_double room = dd_add_xx(dd_mul_xx(g, g), dd_mul_xx(dd_mul_xx(l_d, dd_mul_xx(Omega_d0, Omega_d0)), common_1)); /* fact: step.room; (10) */
        const double_double Omega_a = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_a0, f), g), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_a, Omega_b0), Omega_d0), X), Y)), room); /* fact: step.Omega_a; (5), (10) */
        const double_double Omega_b = dd_div_xx(dd_add_xx(dd_mul_xx(dd_mul_xx(Omega_b0, g), Y), dd_mul_xx(dd_mul_xx(dd_mul_xx(dd_mul_xx(alpha_b, Omega_a0), Omega_d0), f), X)), room); /* fact: step.Omega_b; (5), (10) */
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
        const double w1 = 2.0 * fused(q3, u2, -(q2 * u3)); /* fact: definition kick.w1; (3) */
        const double w2 = 2.0 * fused(q1, u3, -(q3 * u1)); /* fact: definition kick.w2; (3) */
        const double w3 = 2.0 * fused(q2, u1, -(q1 * u2)); /* fact: definition kick.w3; (3) */
        const double v1 = fused(-q2, w3, fused(q3, w2, fused(q0, w1, u1))); /* fact: definition kick.v1; (3) */
        const double v2 = fused(-q3, w1, fused(q1, w3, fused(q0, w2, u2))); /* fact: definition kick.v2; (3) */
        const double v3 = fused(-q1, w2, fused(q2, w1, fused(q0, w3, u3))); /* fact: definition kick.v3; (3) */
        const double g1 = fused(v3, Q13, fused(v2, Q12, fused(v1, Q11, -m1))); /* fact: definition kick.g1; (3) */
        const double g2 = fused(v3, Q23, fused(v2, Q22, fused(v1, Q12, -m2))); /* fact: definition kick.g2; (3) */
        const double g3 = fused(v3, Q33, fused(v2, Q23, fused(v1, Q13, -m3))); /* fact: definition kick.g3; (3) */
        const double T1 = fused(-v3, g2, fused(v2, g3, fused(k, v1, b1))); /* fact: definition kick.T1; (3) */
        const double T2 = fused(-v1, g3, fused(v3, g1, fused(k, v2, b2))); /* fact: definition kick.T2; (3) */
        const double T3 = fused(-v2, g1, fused(v1, g2, fused(k, v3, b3))); /* fact: definition kick.T3; (3) */
        x->T1[i] = T1;
        x->T2[i] = T2;
        x->T3[i] = T3;
    }
}

/* Return x 2^power, and x itself where the power is 0. */
static INLINED double times_power(double x, int power)
{
    return power != 0 ? ldexp(x, power) : x;
}

/* Return the largest size of three numbers. */
static double largest_of(double x, double y, double z)
{
    const double larger = fabs(y) >= fabs(z) ? fabs(y) : fabs(z);
    return fabs(x) >= larger ? fabs(x) : larger;
}

/* Return the exponent to scale by, 0 for moderate numbers and for what is not finite. The highest
   powers of moderate rates, for binary64 the 22nd, do not overflow. */
static int scale(double largest)
{
    const int is_moderate = largest >= 1.0 / 1099511627776.0 && largest <= 1099511627776.0;
    return is_moderate || !isfinite(largest) ? 0 : exponent_of(largest);
}

/* Return the exponent that takes moments to their inner units. */
static int moment_scale(const double inertia[3])
{
    return -scale(largest_of(inertia[0], inertia[1], inertia[2]));
}

/* Return True if x > y. */
static INLINED int is_above(double_double x, double_double y)
{
    return x.hi > y.hi || (x.hi >= y.hi && x.lo > y.lo);
}

/* Return True for moments that a body can have, up to rounding. The largest is at most the sum of
   the others, or that sum as a double, or beyond it by 2^-50 of the smallest. */
static int can_exist(const double_double c[3])
{
    const int second = is_above(c[1], c[0]) ? 1 : 0;
    const int high = is_above(c[2], c[second]) ? 2 : second;
    const double_double one = c[(high + 1) % 3];
    const double_double other = c[(high + 2) % 3];
    const double_double most = c[high];
    const double_double total = dd_add_xx(one, other);
    const double_double beyond = two_sum(most.hi - total.hi, most.lo - total.lo);
    const double allowed = 8.881784197001252e-16 * (one.hi <= other.hi ? one.hi : other.hi);
    return ALLOW_NONPHYSICAL || most.hi < total.hi || (most.hi <= total.hi && most.lo <= 0.0) || beyond.hi < allowed || (beyond.hi <= allowed && beyond.lo <= 0.0);
}

/* Return True for moments that a body can have, up to rounding. */
static int is_possible(const double c[3])
{
    double_double moments[3];
    for (size_t k = 0; k < 3; k++) {
        moments[k].hi = c[k];
        moments[k].lo = 0.0;
    }
    return can_exist(moments);
}

/* Check the moments of a body, and these in inner units; return a code. */
static int body_code(const double inertia[3], const double c[3])
{
    const double largest = largest_of(inertia[0], inertia[1], inertia[2]);
    const double less = inertia[1] <= inertia[2] ? inertia[1] : inertia[2];
    const double smallest = inertia[0] <= less ? inertia[0] : less;
    const int is_number = !isnan(inertia[0] + inertia[1] + inertia[2]);
    const int is_positive = inertia[0] > 0.0 && inertia[1] > 0.0 && inertia[2] > 0.0;
    const double divisor = is_positive ? largest : 1.0;
    return !is_positive ? (is_number ? TORQUE_FREE_STEP_INERTIA : TORQUE_FREE_STEP_NOT_FINITE) : (!isfinite(largest) ? TORQUE_FREE_STEP_NOT_FINITE : (!(ALLOW_NONPHYSICAL || is_possible(c)) ? TORQUE_FREE_STEP_NONPHYSICAL : (smallest / divisor < min_moment_ratio ? TORQUE_FREE_STEP_THIN : TORQUE_FREE_STEP_OK)));
}

/* Return the axes by their moments, the largest first, and 1, or -1 where they are left-handed. Of
   equal moments, that of the axis next in turn is first. */
static void order_of(const double inertia[3], int *first_out, int *second_out, int *third_out,
    double *epsilon_out)
{
    const int above = inertia[0] >= inertia[2] ? 0 : 2;
    const int below = inertia[1] >= inertia[2] ? 1 : 2;
    const int first = inertia[0] >= inertia[1] ? above : below;
    const int one = (first + 1) % 3;
    const int other = (first + 2) % 3;
    const int is_turned = inertia[one] < inertia[other];
    const int second = is_turned ? other : one;
    const int third = is_turned ? one : other;
    const double epsilon = is_turned ? -1.0 : 1.0;
    *first_out = first;
    *second_out = second;
    *third_out = third;
    *epsilon_out = epsilon;
}

/* Check moments and write them to lane i, the largest first; return a code. */
static int set_body(lanes *x, size_t i, const double inertia[3], int axis[3])
{
    const int power = moment_scale(inertia);
    double c[3];
    for (size_t k = 0; k < 3; k++) {
        c[k] = times_power(inertia[k], power);
    }
    const int code = body_code(inertia, c);
    if (code != TORQUE_FREE_STEP_OK) {
        return code;
    }
    order_of(inertia, &axis[0], &axis[1], &axis[2], &x->epsilon[i]);
    const double c_a = c[axis[0]];
    const double c_b = c[axis[1]];
    const double c_d = c[axis[2]];
    const double_double ab = two_sum(c_a, -c_b);
    const double_double ad = two_sum(c_a, -c_d);
    const double_double bd = two_sum(c_b, -c_d);
    x->c_a_hi[i] = c_a;
    x->c_a_lo[i] = 0.0;
    x->c_b_hi[i] = c_b;
    x->c_b_lo[i] = 0.0;
    x->c_d_hi[i] = c_d;
    x->c_d_lo[i] = 0.0;
    x->c_ab_hi[i] = ab.hi;
    x->c_ab_lo[i] = ab.lo;
    x->c_ad_hi[i] = ad.hi;
    x->c_ad_lo[i] = ad.lo;
    x->c_bd_hi[i] = bd.hi;
    x->c_bd_lo[i] = bd.lo;
    return TORQUE_FREE_STEP_OK;
}

/* Return True where the constants of a body, and a doubling, have all their digits. clang's -ffp-
   contract=fast fuses sums with products across functions, so that low parts are counted twice. */
static int lanes_hold(void)
{
    const double zero = hidden(0.0);
    double inertia[3];
    int axis[3];
    lanes x;
    for (size_t k = 0; k < 3; k++) {
        inertia[k] = zero + lane_cases[k];
    }
    if (set_body(&x, 0, inertia, axis) != TORQUE_FREE_STEP_OK) {
        return 0;
    }
    x.X_hi[0] = inertia[0];
    x.Y_hi[0] = inertia[1];
    x.e_1_hi[0] = inertia[2];
    x.e_2_hi[0] = zero + lane_cases[3];
    x.X_lo[0] = zero;
    x.Y_lo[0] = zero;
    x.e_1_lo[0] = zero;
    x.e_2_lo[0] = zero;
    step_body(1, &x);
    step_doubled(1, &x);
    const double_double l_a = {x.l_a_hi[0], x.l_a_lo[0]};
    const double_double l_b = {x.l_b_hi[0], x.l_b_lo[0]};
    const double_double X = {x.X_next_hi[0], x.X_next_lo[0]};
    const double_double Y = {x.Y_next_hi[0], x.Y_next_lo[0]};
    return is_double_double(l_a, 0.5265630116004512, 2.0259269896901686e-17) && is_double_double(l_b, 0.11906636935098612, 4.186140756463748e-18) && is_double_double(X, 0.7309683706206017, -5.138891903440856e-18) && is_double_double(Y, 0.9450906240536523, 1.3279045143746525e-17);
}

/* Return True where this build's arithmetic passes all tests. */
static int is_rounded_once(void)
{
    return sums_hold() && quotients_hold() && lanes_hold();
}

/* Return the largest size of a quaternion's components. */
static double size_of(const double q[4])
{
    const double larger = largest_of(q[1], q[2], q[3]);
    return fabs(q[0]) >= larger ? fabs(q[0]) : larger;
}

/* Check an attitude, rates and a time; return a code. */
static int state_code(const double q[4], const double omega[3], double dt)
{
    double sum = dt;
    for (size_t k = 0; k < 3; k++) {
        sum += 0.0 * omega[k] + 0.0 * q[1 + k];
    }
    const int is_number = isfinite(sum + 0.0 * q[0]);
    return !is_number ? TORQUE_FREE_STEP_NOT_FINITE : (size_of(q) > 0.0 ? TORQUE_FREE_STEP_OK : TORQUE_FREE_STEP_ATTITUDE);
}

/* Return the exponent that scales rates, whether nothing turns, and the scaled time. */
static void scaled_time(const double omega[3], double dt, int *power_out, int *is_still_out,
    double *t_out)
{
    const double largest = largest_of(omega[0], omega[1], omega[2]);
    const int power = scale(largest);
    const int is_still = !(largest > 0.0 && fabs(dt) > 0.0);
    const double t = is_still ? 0.0 : times_power(dt, power);
    *power_out = power;
    *is_still_out = is_still;
    *t_out = t;
}

/* Return the scaled rates in the order of axes, for a body at rest those of a spin. At rest the
   momentum has no direction to divide by. */
static void scaled_rates(const int axis[3], const double omega[3], int power, double *a_out,
    double *b_out, double *d_out)
{
    const int is_turning = largest_of(omega[0], omega[1], omega[2]) > 0.0;
    const double a = is_turning ? times_power(omega[axis[0]], -power) : 1.0;
    const double b = times_power(omega[axis[1]], -power);
    const double d = times_power(omega[axis[2]], -power);
    *a_out = a;
    *b_out = b;
    *d_out = d;
}

/* Return a quaternion times a power of two, so that squares neither overflow nor vanish. */
static void scaled_attitude(const double q[4], double *result_1_out, double *result_2_out,
    double *result_3_out, double *result_4_out)
{
    const int power = -scale(size_of(q));
    *result_1_out = times_power(q[0], power);
    *result_2_out = times_power(q[1], power);
    *result_3_out = times_power(q[2], power);
    *result_4_out = times_power(q[3], power);
}

/* Return True where a step turns by no more than the largest angle. */
static int is_short(double a, double b, double d, double t)
{
    return sqrt(a * a + b * b + d * d) * fabs(t) <= max_step;
}

/* Return True where the momentum circulates about the axis of smallest moment. That is where K^2 <
   2 H c_b. */
static INLINED int is_under(double l_a, double l_d, double a, double d)
{
    return l_a * a * a < l_d * d * d;
}

/* Return two numbers, in the other order where `is_turned`. */
static INLINED void swapped(int is_turned, double one, double other, double *result_1_out,
    double *result_2_out)
{
    *result_1_out = is_turned ? other : one;
    *result_2_out = is_turned ? one : other;
}

/* Return x over the root of a square, with little more error than one rounding. */
static INLINED double divided(double x, double over, double more)
{
    const double y = x * over;
    return y + (product_error(x, over, y) + x * more);
}

/* Normalise a quaternion. */
static INLINED void unit(double q_0, double q_a, double q_b, double q_d, double *result_1_out,
    double *result_2_out, double *result_3_out, double *result_4_out)
{
    const double_double first = dd_add_xx(two_product(q_0, q_0), two_product(q_a, q_a));
    const double_double square = dd_add_xx(first, dd_add_xx(two_product(q_b, q_b), two_product(q_d, q_d)));
    const double over = 1.0 / sqrt(square.hi);
    const double_double rest = dd_sub_dx(1.0, dd_mul_xx(square, two_product(over, over)));
    const double more = over * (rest.hi + rest.lo) / 2.0;
    *result_1_out = divided(q_0, over, more);
    *result_2_out = divided(q_a, over, more);
    *result_3_out = divided(q_b, over, more);
    *result_4_out = divided(q_d, over, more);
}

/* Round a pair up or down, to the nearer double more often; chance is between -1/2 and 1/2. */
static INLINED double dithered(double_double x, double chance)
{
    const double size = fabs(x.hi);
    const double next = size + size * 1.1102230246251568e-16;
    return x.hi + (x.lo + chance * (next - size));
}

/* Round rates up or down at random, by the attitude's last digits. Rounded to nearest, a slow
   motion's rates would err one way for long. */
static INLINED void stochastic(double q_0, double q_a, double q_b, double_double a, double_double b,
    double_double d, double *result_1_out, double *result_2_out, double *result_3_out)
{
    const uint64_t one = bits_of(q_0);
    const uint64_t two = bits_of(q_a);
    const uint64_t three = bits_of(q_b);
    const uint64_t turned = ((two << 21) | (two >> 43)) ^ ((three << 42) | (three >> 22));
    uint64_t mixed = (one ^ turned) * UINT64_C(0x9e3779b97f4a7c15);
    mixed = (mixed ^ (mixed >> 32)) * UINT64_C(0xd6e8feb86659fd93);
    mixed ^= mixed >> 32;
    const double for_a = from_bits(UINT64_C(0x3ff0000000000000) | ((mixed >> 44) << 32)) - 1.5;
    const double for_b = from_bits(UINT64_C(0x3ff0000000000000) | (((mixed << 20) >> 44) << 32)) - 1.5;
    const double for_d = from_bits(UINT64_C(0x3ff0000000000000) | (((mixed << 40) >> 44) << 32)) - 1.5;
    *result_1_out = dithered(a, for_a);
    *result_2_out = dithered(b, for_b);
    *result_3_out = dithered(d, for_d);
}

/* Return True where a state is finite. Nonphysical bodies can turn much faster than at the start.
   */
static INLINED int is_finite_state(double q_0, double q_a, double q_b, double q_d, double a,
    double b, double d)
{
    return isfinite(q_0 + q_a + q_b + q_d + a + b + d);
}

/* Return the place of each axis in the order of axes, whose ends are swapped if `is_turned`. */
static INLINED void places(const int axis[3], int is_turned, int *result_1_out, int *result_2_out,
    int *result_3_out)
{
    const int first = is_turned ? axis[2] : axis[0];
    *result_1_out = first == 0 ? 0 : (axis[1] == 0 ? 1 : 2);
    *result_2_out = first == 1 ? 0 : (axis[1] == 1 ? 1 : 2);
    *result_3_out = first == 2 ? 0 : (axis[1] == 2 ? 1 : 2);
}

/* Copy the constants of the body in lane 0. */
static void get_body(const lanes *x, torque_free_body *body)
{
    body->epsilon = x->epsilon[0];
    body->moments[0] = x->c_a_hi[0];
    body->moments[1] = x->c_b_hi[0];
    body->moments[2] = x->c_d_hi[0];
    body->alphas[0] = x->alpha_a_hi[0];
    body->alphas[1] = x->alpha_a_lo[0];
    body->alphas[2] = x->alpha_b_hi[0];
    body->alphas[3] = x->alpha_b_lo[0];
    body->alphas[4] = x->alpha_d_hi[0];
    body->alphas[5] = x->alpha_d_lo[0];
    body->squares[0] = x->l_a_hi[0];
    body->squares[1] = x->l_a_lo[0];
    body->squares[2] = x->l_b_hi[0];
    body->squares[3] = x->l_b_lo[0];
    body->squares[4] = x->l_d_hi[0];
    body->squares[5] = x->l_d_lo[0];
}

/* Write the constants of a body to lane i. */
static void put_body(lanes *x, size_t i, const torque_free_body *body)
{
    x->epsilon[i] = body->epsilon;
    x->c_a_hi[i] = body->moments[0];
    x->c_b_hi[i] = body->moments[1];
    x->c_d_hi[i] = body->moments[2];
    x->c_a_lo[i] = 0.0;
    x->c_b_lo[i] = 0.0;
    x->c_d_lo[i] = 0.0;
    x->alpha_a_hi[i] = body->alphas[0];
    x->alpha_a_lo[i] = body->alphas[1];
    x->alpha_b_hi[i] = body->alphas[2];
    x->alpha_b_lo[i] = body->alphas[3];
    x->alpha_d_hi[i] = body->alphas[4];
    x->alpha_d_lo[i] = body->alphas[5];
    x->l_a_hi[i] = body->squares[0];
    x->l_a_lo[i] = body->squares[1];
    x->l_b_hi[i] = body->squares[2];
    x->l_b_lo[i] = body->squares[3];
    x->l_d_hi[i] = body->squares[4];
    x->l_d_lo[i] = body->squares[5];
}

/* Check a state and a time, and write them to lane i, scaled; return a code. The axes of `of` are
   set before. */
static int set_state(lanes *x, size_t i, const double q[4], const double omega[3], double dt,
    scaling *of)
{
    const int code = state_code(q, omega, dt);
    if (code != TORQUE_FREE_STEP_OK) {
        return code;
    }
    memcpy(of->omega, omega, 3 * sizeof(double));
    scaled_time(omega, dt, &of->power, &of->is_still, &x->t[i]);
    scaled_attitude(q, &of->q[0], &of->q[1], &of->q[2], &of->q[3]);
    double a;
    double b;
    double d;
    scaled_rates(of->axis, omega, of->power, &a, &b, &d);
    x->Omega_a0_hi[i] = a;
    x->Omega_b0_hi[i] = b;
    x->Omega_d0_hi[i] = d;
    x->Omega_a0_lo[i] = 0.0;
    x->Omega_b0_lo[i] = 0.0;
    x->Omega_d0_lo[i] = 0.0;
    x->q_0[i] = of->q[0];
    x->q_a[i] = of->q[1 + of->axis[0]];
    x->q_b[i] = of->q[1 + of->axis[1]];
    x->q_d[i] = of->q[1 + of->axis[2]];
    return is_short(a, b, d, x->t[i]) ? TORQUE_FREE_STEP_OK : TORQUE_FREE_STEP_ANGLE;
}

/* Choose the axis a: that of largest moment, or of smallest where K^2 < 2 H c_b. */
static void circulating(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        const int turned = is_under(x->l_a_hi[i], x->l_d_hi[i], x->Omega_a0_hi[i], x->Omega_d0_hi[i]);
        const double sign = turned ? -1.0 : 1.0;
        swapped(turned, x->Omega_a0_hi[i], x->Omega_d0_hi[i], &x->Omega_a0_hi[i], &x->Omega_d0_hi[i]);
        swapped(turned, x->c_a_hi[i], x->c_d_hi[i], &x->c_a_hi[i], &x->c_d_hi[i]);
        swapped(turned, x->alpha_a_hi[i], x->alpha_d_hi[i], &x->alpha_a_hi[i], &x->alpha_d_hi[i]);
        swapped(turned, x->alpha_a_lo[i], x->alpha_d_lo[i], &x->alpha_a_lo[i], &x->alpha_d_lo[i]);
        swapped(turned, x->l_a_hi[i], x->l_d_hi[i], &x->l_a_hi[i], &x->l_d_hi[i]);
        swapped(turned, x->l_a_lo[i], x->l_d_lo[i], &x->l_a_lo[i], &x->l_d_lo[i]);
        swapped(turned, x->q_a[i], x->q_d[i], &x->q_a[i], &x->q_d[i]);
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

/* Normalise the attitudes of all lanes. */
static void normalise(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        unit(x->q_0[i], x->q_a[i], x->q_b[i], x->q_d[i], &x->q_0[i], &x->q_a[i], &x->q_b[i], &x->q_d[i]);
    }
}

/* Round the rates of all lanes up or down at random. */
static void round_rates(size_t n, lanes *x)
{
    for (size_t i = 0; i < n; i++) {
        stochastic(x->q_0[i], x->q_a[i], x->q_b[i], dd_pair(x->Omega_a_hi[i], x->Omega_a_lo[i]), dd_pair(x->Omega_b_hi[i], x->Omega_b_lo[i]), dd_pair(x->Omega_d_hi[i], x->Omega_d_lo[i]), &x->Omega_a_hi[i], &x->Omega_b_hi[i], &x->Omega_d_hi[i]);
    }
}

/* Compute the states of n lanes after their times. */
static void move(size_t n, lanes *x)
{
    circulating(n, x);
    step_start(n, x);
    step_first(n, x);
    for (size_t k = 0; k < 5; k++) {
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
    normalise(n, x);
    round_rates(n, x);
}

/* Return True where the state of lane i is finite. */
static int is_held(const lanes *x, size_t i)
{
    return is_finite_state(x->q_0[i], x->q_a[i], x->q_b[i], x->q_d[i], x->Omega_a_hi[i], x->Omega_b_hi[i], x->Omega_d_hi[i]);
}

/* Copy the state of lane i, in the given order of axes; a body at rest keeps its state. */
static void get_state(const lanes *x, size_t i, const scaling *of, double q[4], double omega[3])
{
    if (of->is_still) {
        unit(of->q[0], of->q[1], of->q[2], of->q[3], &q[0], &q[1], &q[2], &q[3]);
        memcpy(omega, of->omega, 3 * sizeof(double));
        return;
    }
    double parts[3] = {x->q_a[i], x->q_b[i], x->q_d[i]};
    double rates[3] = {x->Omega_a_hi[i], x->Omega_b_hi[i], x->Omega_d_hi[i]};
    int first;
    int second;
    int third;
    places(of->axis, x->turned[i] < 0.0, &first, &second, &third);
    q[0] = x->q_0[i];
    q[1] = parts[first];
    q[2] = parts[second];
    q[3] = parts[third];
    omega[0] = times_power(rates[first], of->power);
    omega[1] = times_power(rates[second], of->power);
    omega[2] = times_power(rates[third], of->power);
}

/* Compute the constants of a body without testing this build's arithmetic; return a code. */
static int body_constants(torque_free_body *body, const double inertia[3])
{
    lanes x;
    const int code = set_body(&x, 0, inertia, body->axis);
    if (code != TORQUE_FREE_STEP_OK) {
        return code;
    }
    step_body(1, &x);
    get_body(&x, body);
    body->prepared = PREPARED;
    return TORQUE_FREE_STEP_OK;
}

int torque_free_body_init(torque_free_body *body, const double inertia[3])
{
    torque_free_body made;
    const int code = body_constants(&made, inertia);
    if (code != TORQUE_FREE_STEP_OK) {
        return code;
    }
    if (!is_rounded_once()) {
        return TORQUE_FREE_STEP_ARITHMETIC;
    }
    *body = made;
    return TORQUE_FREE_STEP_OK;
}

int torque_free_step(const torque_free_body *body, double q[4], double omega[3], double dt)
{
    lanes x;
    scaling of;
    if (body->prepared != PREPARED) {
        return TORQUE_FREE_STEP_UNPREPARED;
    }
    memcpy(of.axis, body->axis, 3 * sizeof(int));
    const int code = set_state(&x, 0, q, omega, dt, &of);
    if (code != TORQUE_FREE_STEP_OK) {
        return code;
    }
    put_body(&x, 0, body);
    move(1, &x);
    if (!is_held(&x, 0)) {
        return TORQUE_FREE_STEP_ANGLE;
    }
    get_state(&x, 0, &of, q, omega);
    return TORQUE_FREE_STEP_OK;
}

int torque_free_steps(size_t n, const double *inertia, size_t inertia_stride, const double *q,
    const double *omega, const double *dt, size_t dt_stride, double *q_after, double *omega_after,
    size_t *failed)
{
    torque_free_body alike;
    lanes x;
    scaling of[LANES];
    int code = TORQUE_FREE_STEP_OK;
    failed[0] = 0;
    if (n == 0) {
        return TORQUE_FREE_STEP_OK;
    }
    if (inertia_stride == 0) {
        code = torque_free_body_init(&alike, inertia);
    } else if (!is_rounded_once()) {
        code = TORQUE_FREE_STEP_ARITHMETIC;
    }
    if (code != TORQUE_FREE_STEP_OK) {
        return code;
    }
    for (size_t begin = 0; begin < n; begin += LANES) {
        const size_t count = n - begin < LANES ? n - begin : LANES;
        for (size_t i = 0; i < LANES; i++) {
            /* Lanes beyond the last body repeat it. */
            const size_t k = begin + (i < count ? i : count - 1);
            if (inertia_stride != 0) {
                code = set_body(&x, i, inertia + k * inertia_stride, of[i].axis);
            } else {
                put_body(&x, i, &alike);
                memcpy(of[i].axis, alike.axis, 3 * sizeof(int));
            }
            if (code == TORQUE_FREE_STEP_OK) {
                code = set_state(&x, i, q + 4 * k, omega + 3 * k, dt[k * dt_stride], &of[i]);
            }
            if (code != TORQUE_FREE_STEP_OK) {
                failed[0] = k;
                return code;
            }
        }
        if (inertia_stride != 0) {
            step_body(LANES, &x);
        }
        move(LANES, &x);
        for (size_t i = 0; i < count; i++) {
            if (!is_held(&x, i)) {
                failed[0] = begin + i;
                return TORQUE_FREE_STEP_ANGLE;
            }
            get_state(&x, i, &of[i], q_after + 4 * (begin + i), omega_after + 3 * (begin + i));
        }
    }
    return TORQUE_FREE_STEP_OK;
}

size_t torque_free_body_size(void)
{
    return sizeof(torque_free_body);
}

/* Solve mean anomaly = E - e sin E for |mean| <= pi. Newton's method comes from pi on the side of
   the mean anomaly, from where it comes down without passing (Charles and Tatum, Celestial
   Mechanics and Dynamical Astronomy 69, 357-372, 1998). */
static double elliptic_anomaly(double mean, double e)
{
    double anomaly = copysign(3.141592653589793, mean);
    for (size_t _ = 0; _ < 60; _++) {
        const double change = (anomaly - e * sin(anomaly) - mean) / (1.0 - e * cos(anomaly));
        anomaly -= change;
        if (fabs(change) <= 1e-15 * fabs(anomaly)) {
            break;
        }
    }
    return anomaly;
}

/* Solve mean anomaly = e sinh F - F, from the far side of the root. */
static double hyperbolic_anomaly(double mean, double e)
{
    double anomaly = asinh(mean / (e - 1.0));
    for (size_t _ = 0; _ < 60; _++) {
        const double change = (e * sinh(anomaly) - anomaly - mean) / (e * cosh(anomaly) - 1.0);
        anomaly -= change;
        if (fabs(change) <= 1e-15 * fabs(anomaly)) {
            break;
        }
    }
    return anomaly;
}

/* Write the vector from the mass point to the body, times sqrt(3 mu/r^5). */
static void seen_from(const torque_free_orbit *orbit, double t, double u[3])
{
    const double e = orbit->eccentricity;
    const double a = orbit->semi_major;
    const double mean = orbit->mean_motion * (t - orbit->epoch);
    double along;
    double across;
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
    for (size_t k = 0; k < 3; k++) {
        u[k] = strong * (along * orbit->along[k] + across * orbit->across[k]);
    }
}

/* Write the vector that a torque depends on to lane i. */
static void set_vector(lanes *x, size_t i, const double *restrict u)
{
    x->u1[i] = u[0];
    x->u2[i] = u[1];
    x->u3[i] = u[2];
}

/* Write the coefficients of a torque to lane i. */
static void set_torque(lanes *x, size_t i, const double *restrict c)
{
    x->b1[i] = c[0];
    x->b2[i] = c[1];
    x->b3[i] = c[2];
    x->k[i] = c[3];
    x->m1[i] = c[4];
    x->m2[i] = c[5];
    x->m3[i] = c[6];
    x->Q11[i] = c[7];
    x->Q22[i] = c[8];
    x->Q33[i] = c[9];
    x->Q23[i] = c[10];
    x->Q13[i] = c[11];
    x->Q12[i] = c[12];
}

/* Compute the free motion of some bodies; return a code, and the body that is refused. */
static void drifted(lanes *x, pushed *of, double dt, int *OK_out, size_t *i_out)
{
    scaling scales[LANES];
    for (size_t i = 0; i < of->count; i++) {
        put_body(x, i, &of->bodies[i]);
        memcpy(scales[i].axis, of->bodies[i].axis, 3 * sizeof(int));
        const int code = set_state(x, i, of->q[i], of->omega[i], dt, &scales[i]);
        if (code != TORQUE_FREE_STEP_OK) {
            *OK_out = code;
            *i_out = i;
            return;
        }
    }
    move(of->count, x);
    for (size_t i = 0; i < of->count; i++) {
        if (!is_held(x, i)) {
            *OK_out = TORQUE_FREE_STEP_ANGLE;
            *i_out = i;
            return;
        }
        get_state(x, i, &scales[i], of->q[i], of->omega[i]);
    }
    *OK_out = TORQUE_FREE_STEP_OK;
    *i_out = 0;
}

/* Add the torque that a caller's function computes. */
static void add_more(lanes *x, const pushed *of, const torque_free_torque *torque, double t)
{
    for (size_t i = 0; i < of->count; i++) {
        double sum[3] = {x->T1[i], x->T2[i], x->T3[i]};
        torque->more(t, of->q[i], sum, torque->data);
        x->T1[i] = sum[0];
        x->T2[i] = sum[1];
        x->T3[i] = sum[2];
    }
}

/* Change rates by what a torque at time t does to them in dt. */
static void kicked(lanes *x, pushed *of, const torque_free_torque *torque, double t, double dt)
{
    if (torque->orbit != NULL) {
        double u[3];
        seen_from(torque->orbit, t, u);
        for (size_t i = 0; i < of->count; i++) {
            set_vector(x, i, u);
        }
    }
    for (size_t i = 0; i < of->count; i++) {
        x->q0[i] = of->q[i][0];
        x->q1[i] = of->q[i][1];
        x->q2[i] = of->q[i][2];
        x->q3[i] = of->q[i][3];
    }
    step_kick(of->count, x);
    if (torque->more != NULL) {
        add_more(x, of, torque, t);
    }
    for (size_t i = 0; i < of->count; i++) {
        of->omega[i][0] += dt * (x->T1[i] / of->inertia[i][0]);
        of->omega[i][1] += dt * (x->T2[i] / of->inertia[i][1]);
        of->omega[i][2] += dt * (x->T3[i] / of->inertia[i][2]);
    }
}

/* Compute all steps of some bodies; return a code, and the body that is refused. */
static void advanced(lanes *x, pushed *of, const torque_free_splitting *method,
    const torque_free_torque *torque, double begin, double step, size_t first, size_t last,
    int *code_out, size_t *failed_out)
{
    int code = TORQUE_FREE_STEP_OK;
    size_t failed = 0;
    double pending = 0.0;
    for (size_t k = first; k < last; k++) {
        double into = 0.0;
        for (size_t part = 0; part < method->count; part++) {
            drifted(x, of, (pending + method->drifts[part]) * step, &code, &failed);
            if (code != TORQUE_FREE_STEP_OK) {
                *code_out = code;
                *failed_out = failed;
                return;
            }
            pending = 0.0;
            into += method->drifts[part];
            kicked(x, of, torque, begin + ((double)k + into) * step, method->kicks[part] * step);
        }
        pending = method->drifts[method->count];
    }
    if (first < last) {
        drifted(x, of, pending * step, &code, &failed);
    }
    *code_out = code;
    *failed_out = failed;
}

int torque_free_integrate(size_t n, const double *inertia, size_t inertia_stride,
    const torque_free_splitting *method, const torque_free_torque *torque, double begin,
    double step, size_t first, size_t last, double *q, double *omega, size_t *failed)
{
    lanes x;
    pushed of;
    failed[0] = 0;
    if (n != 0 && !is_rounded_once()) {
        return TORQUE_FREE_STEP_ARITHMETIC;
    }
    for (size_t start = 0; start < n; start += LANES) {
        const size_t count = n - start < LANES ? n - start : LANES;
        /* One body goes alone; lanes beyond the last of several repeat it. */
        of.count = count > 1 ? LANES : 1;
        for (size_t i = 0; i < of.count; i++) {
            const size_t k = start + (i < count ? i : count - 1);
            const int code = body_constants(&of.bodies[i], inertia + k * inertia_stride);
            if (code != TORQUE_FREE_STEP_OK) {
                failed[0] = k;
                return code;
            }
            memcpy(of.inertia[i], inertia + k * inertia_stride, 3 * sizeof(double));
            memcpy(of.q[i], q + 4 * k, 4 * sizeof(double));
            memcpy(of.omega[i], omega + 3 * k, 3 * sizeof(double));
            set_torque(&x, i, torque->coefficients + k * torque->coefficients_stride);
            if (torque->orbit == NULL) {
                set_vector(&x, i, torque->vector + k * torque->vector_stride);
            }
        }
        int ended;
        size_t lane;
        advanced(&x, &of, method, torque, begin, step, first, last, &ended, &lane);
        if (ended != TORQUE_FREE_STEP_OK) {
            failed[0] = start + (lane < count ? lane : count - 1);
            return ended;
        }
        for (size_t i = 0; i < count; i++) {
            for (size_t j = 0; j < 4; j++) {
                q[4 * (start + i) + j] = of.q[i][j];
            }
            for (size_t j = 0; j < 3; j++) {
                omega[3 * (start + i) + j] = of.omega[i][j];
            }
        }
    }
    return TORQUE_FREE_STEP_OK;
}

const char *torque_free_step_message(int code)
{
    return code >= 0 && code < CODES ? MESSAGES[code] : UNKNOWN;
}

const char *torque_free_step_field(int code)
{
    return code >= 0 && code < CODES ? FIELDS[code] : "";
}

const char *torque_free_step_rule(int code)
{
    return code >= 0 && code < CODES ? RULES[code] : UNKNOWN;
}

const char *torque_free_step_digest(void)
{
    return "ce9f500576af1f0b7f38e09ae2bfdfd3ebaa7758b8f7540cdde7effe0ebb6ccd";
}

