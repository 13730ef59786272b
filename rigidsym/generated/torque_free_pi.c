#include "torque_free_pi.h"
#include "torque_free_arithmetic.h"

/* How many states are computed side by side; each takes about 240 bytes of stack on a grid. */
#ifndef TORQUE_FREE_PI_BLOCK
#define TORQUE_FREE_PI_BLOCK 64
#endif
#define BLOCK ((size_t)TORQUE_FREE_PI_BLOCK)

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

/* Write columns as rows, as many as whole registers hold, and return how many: gcc shuffles three times
   as many registers of AVX2 as it needs to. */
#if defined(__AVX2__) && !defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>

static INLINED size_t shuffled(size_t n, const double *restrict a, const double *restrict b,
                               const double *restrict c, double *restrict rows)
{
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        const __m256d x = _mm256_loadu_pd(a + i), y = _mm256_loadu_pd(b + i), z = _mm256_loadu_pd(c + i);
        const __m256d xy = _mm256_unpacklo_pd(x, y), yz = _mm256_unpackhi_pd(y, z);
        const __m256d zx = _mm256_shuffle_pd(z, x, 10);
        _mm256_storeu_pd(rows + 3 * i, _mm256_permute2f128_pd(xy, zx, 0x20));
        _mm256_storeu_pd(rows + 3 * i + 4, _mm256_blend_pd(yz, xy, 12));
        _mm256_storeu_pd(rows + 3 * i + 8, _mm256_permute2f128_pd(zx, yz, 0x31));
    }
    return i;
}

static INLINED size_t shuffled4(size_t n, const double *restrict a, const double *restrict b,
                                const double *restrict c, const double *restrict d, double *restrict rows)
{
    size_t i = 0;
    for (; i + 2 <= n; i += 2) {
        const __m256d ac = _mm256_set_m128d(_mm_loadu_pd(c + i), _mm_loadu_pd(a + i));
        const __m256d bd = _mm256_set_m128d(_mm_loadu_pd(d + i), _mm_loadu_pd(b + i));
        _mm256_storeu_pd(rows + 4 * i, _mm256_unpacklo_pd(ac, bd));
        _mm256_storeu_pd(rows + 4 * i + 4, _mm256_unpackhi_pd(ac, bd));
    }
    return i;
}
#else
#define shuffled(n, a, b, c, rows) ((size_t)0)
#define shuffled4(n, a, b, c, d, rows) ((size_t)0)
#endif
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
static const double negligible = 3.8725919148493183e-121; /* 2^-400, rates below this share of the largest are taken for zero */
static const double decisive = 8.470329472543003e-22; /* 2^-70, share of a tilt; rates that cause less may be taken for zero */
static const double min_discriminant = 1.1830521861667747e-271; /* 2^-900, E_b in inner units; below it, motions are on the separatrix */
static const double tolerated = 8.673617379884035e-19; /* 2^-60, error of such motions, as a share of the momentum */
static const double min_moment_ratio = 6.223015277861142e-61; /* 2^-200, ratio of two principal moments */
static const double max_circular = 0.5; /* 2^-1, k_1^2 on the circular branch; above it, the hyperbolic one */
static const double max_angle = 70368744177664.0; /* 2^46, |omega0 t|, rad */
static const double max_rate = 1.0463951242053392e+298; /* 2^990, a rate, rad/s; exact products with it do not overflow */
enum { CODES = 12 };
static const char UNKNOWN[13] = "no such code";
static const char MESSAGES[CODES][112] = {"success", "every number must be finite", "inertia: principal moments must be positive", "inertia: principal moments differ by more than binary64 can follow", "attitude0: a zero quaternion is no attitude", "t: nearer to the separatrix than binary64 can follow so long", "t: beyond |omega| t = 2^46 rad the angle is lost in binary64", "omega0: rates beyond what binary64 can hold", "arithmetic: sums are reordered or not rounded to nearest", "t: on the way to spin about the middle axis squares of changes leave binary64", "inertia: no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)", "motion: torque_free_pi_motion_init has not made it"};
static const char FIELDS[CODES][11] = {"", "", "inertia", "inertia", "attitude0", "t", "t", "omega0", "arithmetic", "t", "inertia", "motion"};
static const char RULES[CODES][103] = {"success", "every number must be finite", "principal moments must be positive", "principal moments differ by more than binary64 can follow", "a zero quaternion is no attitude", "nearer to the separatrix than binary64 can follow so long", "beyond |omega| t = 2^46 rad the angle is lost in binary64", "rates beyond what binary64 can hold", "sums are reordered or not rounded to nearest", "on the way to spin about the middle axis squares of changes leave binary64", "no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)", "torque_free_pi_motion_init has not made it"};
enum { TIMES = 8 }; /* times that `angles_hold` computes */
static const double difference_cases[5] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596, 0.15335179025447007, 0.03588181116623288}; /* three moments and two rates */
static const double known_cosines[6] = {1.0, 0.5, -0.5, -1.0, -0.5, 0.5}; /* those of multiples of sixty degrees */
enum { PREPARED = 2135587861 };

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
/* Sum of non-overlapping doubles, smallest first; 32 hold any value of `discriminant`. */
typedef struct {
    size_t count;
    double part[32];
} exact;
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
static double_double discriminant_dd(double_double c_a, double_double c_d, double_double c_ab,
    double_double c_bd, double_double Omega_a, double_double Omega_d)
{
    const double_double E_b = dd_sub_xx(dd_mul_xx(dd_mul_xx(c_a, c_ab), dd_mul_xx(Omega_a, Omega_a)), dd_mul_xx(dd_mul_xx(c_d, c_bd), dd_mul_xx(Omega_d, Omega_d))); /* fact: regular.E_b; (6), (15) */
    return E_b;
}

/* Add a double to the parts of an exact number, and return how many there are then. */
static size_t grown(double *restrict part, size_t count, double a)
{
    size_t kept = 0;
    double rest = a;
    for (size_t i = 0; i < count; i++) {
        const double_double s = two_sum(rest, part[i]);
        if (s.lo < 0.0 || s.lo > 0.0) {
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
            const double_double p = two_product(x.part[i], y.part[j]);
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
static INLINED double circulation(double c_12, double c_13, double c_23, double Omega_1,
    double Omega_2, double Omega_3, double E_2)
{
    const double c_1 = 1.0 + c_13; /* fact: definition sorted_body.c_1 */
    const double c_2 = 1.0 + c_23; /* fact: definition sorted_body.c_2 */
    const double common_1 = Omega_3 * Omega_3; /* fact: definition sorted_body.E_1, definition sorted_body.turning, definition sorted_body.off_middle */
    const double common_2 = Omega_2 * Omega_2; /* fact: definition sorted_body.E_1, definition sorted_body.E_3, definition sorted_body.turning */
    const double E_1 = fused(c_13, common_1, common_2 * c_12 * c_2); /* fact: definition sorted_body.E_1 */
    const double common_3 = Omega_1 * Omega_1; /* fact: definition sorted_body.E_3, definition sorted_body.turning, definition sorted_body.off_middle */
    const double E_3 = fused(c_13 * common_3, c_1, c_23 * common_2 * c_2); /* fact: definition sorted_body.E_3 */
    const double turning = common_3 + common_2 + common_1; /* fact: definition sorted_body.turning */
    const double off_middle = common_3 + common_1; /* fact: definition sorted_body.off_middle */
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
        const double_double kappa = dd_div_xx(dd_mul_xx(dd_mul_xx(dd_mul_dx(2.0, E_a), A_a), k_1), dd_mul_xx(mu, common_13)); /* fact: descended.kappa; (34) */
        const double_double sn = dd_div_xx(dd_mul_dx(chi, Omega_b), A_b); /* fact: regular.sn; (12) */
        const double_double cn = dd_div_xx(dd_mul_dx(chi * tau, Omega_d), A_d); /* fact: regular.cn; (12) */
        const double_double dn = dd_div_xx(dd_mul_dx(sigma, Omega_a), A_a); /* fact: regular.dn; (12) */
        const double_double B_a = common_11; /* fact: theta_form.B_a; (27) */
        const double_double B_d = common_10; /* fact: theta_form.B_d; (28) */
        const double_double root_kc = dd_sqrt(k_c); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_1 = dd_div_xx(dd_mul_dx(2.0, root_kc), common_8); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_14 = dd_add_dx(1.0, dn); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
        const double_double common_15 = dd_mul_xx(common_14, dd_add_dx(1.0, k_1)); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
        const double_double s = dd_div_xx(dd_mul_dx(2.0, sn), common_15); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
        const double_double v = dd_sqrt(dd_mul_xx(common_15, dd_add_xx(k_c, dn))); /* fact: landen.v; DLMF 22.7.4 */
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
static void landen(double_double k, double_double kc, double_double s, double_double c,
    double_double d, double_double r, double_double Y, double_double *k_next_out,
    double_double *kc_next_out, double_double *s_next_out, double_double *c_next_out,
    double_double *d_next_out, double_double *r_next_out, double_double *Y_next_out)
{
    const double_double common_1 = dd_add_dx(1.0, kc); /* fact: landen.k_next, definition landen.kc_next, landen.r_next; DLMF 22.7.1 */
    const double_double common_2 = dd_mul_xx(common_1, common_1); /* fact: landen.k_next, landen.r_next; DLMF 22.7.1 */
    const double_double k_next = dd_div_xx(dd_mul_xx(k, k), common_2); /* fact: landen.k_next; DLMF 22.7.1 */
    const double_double root_kc = dd_sqrt(kc); /* fact: landen.root_kc; DLMF 22.7.1 */
    const double_double kc_next = dd_div_xx(dd_mul_dx(2.0, root_kc), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1 */
    const double_double common_3 = dd_add_dx(1.0, d); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const double_double common_4 = dd_add_dx(1.0, k_next); /* fact: landen.s_next, landen.v, landen.S, landen.Y_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4, DLMF 22.7.2 */
    const double_double common_5 = dd_mul_xx(common_3, common_4); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
    const double_double s_next = dd_div_xx(dd_mul_dx(2.0, s), common_5); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
    const double_double v = dd_sqrt(dd_mul_xx(common_5, dd_add_xx(kc, d))); /* fact: landen.v; DLMF 22.7.4 */
    const double_double c_next = dd_div_xx(dd_mul_dx(2.0, c), v); /* fact: landen.c_next; DLMF 22.7.2 to 22.7.4 */
    const double_double d_next = dd_div_xx(v, common_3); /* fact: landen.d_next; DLMF 22.7.2 to 22.7.4 */
    const double_double r_next = dd_div_xx(dd_mul_xx(k, r), common_2); /* fact: landen.r_next; DLMF 22.7.1 */
    const double_double S = dd_sqrt(dd_add_xx(dd_mul_xx(common_4, common_4), dd_mul_xx(dd_mul_dx(4.0, r_next), dd_mul_xx(Y, Y)))); /* fact: landen.S; DLMF 22.7.2 */
    const double_double Y_next = dd_div_xx(dd_mul_dx(2.0, Y), dd_add_xx(common_4, S)); /* fact: landen.Y_next; DLMF 22.7.2 */
    *k_next_out = k_next;
    *kc_next_out = kc_next;
    *s_next_out = s_next;
    *c_next_out = c_next;
    *d_next_out = d_next;
    *r_next_out = r_next;
    *Y_next_out = Y_next;
}

/* K(k^2), and the descended s, c and Y; 5 steps leave k^2 < 2^-106 of (0, 1/2]. */
static void ladder(double_double k, double_double kc, double_double s, double_double c,
    double_double d, double_double r, double_double Y, double_double *K0_out, double_double *s5_out,
    double_double *c5_out, double_double *Y5_out)
{
    double_double k1;
    double_double kc1;
    double_double s1;
    double_double c1;
    double_double d1;
    double_double r1;
    double_double Y1;
    landen(k, kc, s, c, d, r, Y, &k1, &kc1, &s1, &c1, &d1, &r1, &Y1); /* classical: DLMF 22.7.2 */
    double_double k2;
    double_double kc2;
    double_double s2;
    double_double c2;
    double_double d2;
    double_double r2;
    double_double Y2;
    landen(k1, kc1, s1, c1, d1, r1, Y1, &k2, &kc2, &s2, &c2, &d2, &r2, &Y2); /* classical: DLMF 22.7.2 */
    double_double k3;
    double_double kc3;
    double_double s3;
    double_double c3;
    double_double d3;
    double_double r3;
    double_double Y3;
    landen(k2, kc2, s2, c2, d2, r2, Y2, &k3, &kc3, &s3, &c3, &d3, &r3, &Y3); /* classical: DLMF 22.7.2 */
    double_double k4;
    double_double kc4;
    double_double s4;
    double_double c4;
    double_double d4;
    double_double r4;
    double_double Y4;
    landen(k3, kc3, s3, c3, d3, r3, Y3, &k4, &kc4, &s4, &c4, &d4, &r4, &Y4); /* classical: DLMF 22.7.2 */
    double_double k5;
    double_double kc5;
    double_double s5;
    double_double c5;
    double_double d5;
    double_double r5;
    double_double Y5;
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
static void complete(double_double kc, double_double path, double_double *K_out,
    double_double *total_out)
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
        const double_double common_1 = dd_mul_xx(k_1, k_1); /* fact: landen.k_next; DLMF 22.7.1, DLMF 19.36.1 */
        const double_double common_2 = dd_add_dx(1.0, kc_1); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double k_2 = dd_div_xx(common_1, dd_mul_xx(common_2, common_2)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_1 = dd_sqrt(kc_1); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_2 = dd_div_xx(dd_mul_dx(2.0, root_1), common_2); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_3 = dd_add_dx(1.0, kc_2); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double k_3 = dd_div_xx(dd_mul_xx(k_2, k_2), dd_mul_xx(common_3, common_3)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_2 = dd_sqrt(kc_2); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_3 = dd_div_xx(dd_mul_dx(2.0, root_2), common_3); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_4 = dd_add_dx(1.0, kc_3); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double k_4 = dd_div_xx(dd_mul_xx(k_3, k_3), dd_mul_xx(common_4, common_4)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_3 = dd_sqrt(kc_3); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_4 = dd_div_xx(dd_mul_dx(2.0, root_3), common_4); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_5 = dd_add_dx(1.0, kc_4); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double k_5 = dd_div_xx(dd_mul_xx(k_4, k_4), dd_mul_xx(common_5, common_5)); /* fact: landen.k_next; DLMF 22.7.1 */
        double_double K_1;
        double_double sin_v;
        double_double cos_v;
        double_double shift;
        ladder(k_1, kc_1, s, c, d, k_1, dd_of(0.0), &K_1, &sin_v, &cos_v, &shift); /* classical: DLMF 19.8.12 */
        const double_double v = half_turns(sin_v, cos_v); /* classical: DLMF 4.24.3 */
        const double_double two_K = dd_mul_dx(2.0, K_1); /* classical: DLMF 22.4(i) */
        const double_double v_rate = dd_div_xx(mu, two_K); /* arithmetic */
        const double_double u_start = dd_mul_xx(two_K, v); /* arithmetic */
        const double_double common_6 = dd_sub_dx(1.0, n); /* classical: DLMF 19.8.6, DLMF 19.36.1 */
        double_double quarter;
        double_double total;
        complete(kc_1, common_6, &quarter, &total); /* classical: DLMF 19.8.6 */
        const double_double characteristic = n; /* arithmetic */
        const double_double j = dd_div_xx(total, dd_mul_dx(2.0, common_6)); /* classical: DLMF 19.8.6 */
        const double_double Lambda = dd_div_xd(dd_add_xx(psi_0, dd_mul_xx(dd_mul_xx(kappa, mu), j)), 2.0); /* fact: definition pi_form.Lambda; (33), (34) */
        const double_double Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
        const double_double spread = dd_mul_xx(dd_mul_xx(dd_neg(n), common_6), dd_sub_xx(common_1, n)); /* classical: DLMF 19.36.1 */
        const double path = dd_rounded(dd_sub_dx(1.0, dd_mul_xx(n, dd_mul_xx(s, s)))); /* classical: DLMF 19.25.14 */
        const double J_0 = third_kind(dd_rounded(s), dd_rounded(c), dd_rounded(d), path, dd_rounded(spread)); /* classical: DLMF 19.25.14 */
        const double_double rest_0 = dd_div_xd(dd_mul_xx(kappa, dd_sub_dx(J_0, dd_mul_xx(j, u_start))), 2.0); /* fact: definition pi_form.rest_0; (36) */
        const double_double M_a = dd_mul_xx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_xx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_xx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double_double common_7 = dd_mul_dx(2.0, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double_double nu = dd_sqrt(dd_mul_xx(common_7, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
        const double_double s_0 = dd_div_xx(nu, common_7); /* fact: definition attitude.s_0; (27) */
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
static void circular_angles(const torque_free_pi_circular *motion, size_t n,
    const double *restrict t_in, const double *restrict t_lo_in, double *restrict s_out,
    double *restrict c_out, double *restrict X_im_out, double *restrict X_re_out,
    double *restrict d_out)
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
        const double common_1 = s_5 * s_5 * k_5; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_2 = 1.0 + common_1; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s_4 = s_5 * (1.0 + k_5) / common_2; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c_4 = c_5 / common_2; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d_4 = (1.0 - common_1) / common_2; /* fact: definition landen.d; DLMF 22.7.2 */
        const double common_3 = s_4 * s_4 * k_4; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_4 = 1.0 + common_3; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s_3 = s_4 * (1.0 + k_4) / common_4; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c_3 = c_4 * d_4 / common_4; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d_3 = (1.0 - common_3) / common_4; /* fact: definition landen.d; DLMF 22.7.2 */
        const double common_5 = s_3 * s_3 * k_3; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_6 = 1.0 + common_5; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s_2 = s_3 * (1.0 + k_3) / common_6; /* fact: definition landen.s; DLMF 22.7.2 */
        const double c_2 = c_3 * d_3 / common_6; /* fact: definition landen.c; DLMF 22.7.2 */
        const double d_2 = (1.0 - common_5) / common_6; /* fact: definition landen.d; DLMF 22.7.2 */
        const double common_7 = s_2 * s_2 * k_2; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double common_8 = 1.0 + common_7; /* fact: definition landen.s, definition landen.c, definition landen.d; DLMF 22.7.2 */
        const double s = s_2 * (1.0 + k_2) / common_8; /* fact: definition landen.s; DLMF 22.7.2 */
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
static void circular_state(const torque_free_pi_circular *motion, size_t n,
    const double *restrict s_in, const double *restrict c_in, const double *restrict X_im_in,
    const double *restrict X_re_in, const double *restrict d_in, double *restrict q_0_out,
    double *restrict q_a_out, double *restrict q_b_out, double *restrict q_d_out,
    double *restrict Omega_a_out, double *restrict Omega_b_out, double *restrict Omega_d_out)
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
        const double common_2 = fused(k_1, common_1, 1.0); /* fact: definition descended.sn, definition descended.cn; DLMF 22.7.2, DLMF 22.7.3 */
        const double sn = s * (1.0 + k_1) / common_2; /* fact: definition descended.sn; DLMF 22.7.2 */
        const double cn = c * d / common_2; /* fact: definition descended.cn; DLMF 22.7.3 */
        const double dn = fused(c, c, common_1 * (2.0 * k_c / (1.0 + k_c))) / fused(common_1, k_1, 1.0); /* fact: descended.dn; DLMF 22.7.4 */
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
        const double_double l_2 = dd_div_xx(dd_mul_xx(l_1, l_1), dd_mul_xx(common_1, common_1)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_1 = dd_sqrt(lc_1); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double lc_2 = dd_div_xx(dd_mul_dx(2.0, root_1), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_2 = dd_add_dx(1.0, lc_2); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double l_3 = dd_div_xx(dd_mul_xx(l_2, l_2), dd_mul_xx(common_2, common_2)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_2 = dd_sqrt(lc_2); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double lc_3 = dd_div_xx(dd_mul_dx(2.0, root_2), common_2); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_3 = dd_add_dx(1.0, lc_3); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1 */
        const double_double l_4 = dd_div_xx(dd_mul_xx(l_3, l_3), dd_mul_xx(common_3, common_3)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_3 = dd_sqrt(lc_3); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double lc_4 = dd_div_xx(dd_mul_dx(2.0, root_3), common_3); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_4 = dd_add_dx(1.0, lc_4); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double l_5 = dd_div_xx(dd_mul_xx(l_4, l_4), dd_mul_xx(common_4, common_4)); /* fact: landen.k_next; DLMF 22.7.1 */
        const double_double root_k = dd_sqrt(k_1); /* fact: theta_form.root_k; (27) */
        const double_double x = dd_div_xx(B_d, dd_mul_xx(root_k, dd_add_xx(K, B_a))); /* fact: definition theta_form.x; (28) */
        const double_double common_5 = dd_mul_xx(x, x); /* fact: theta_form.y, definition pi_near.g; DLMF 22.6.1, (36) */
        const double_double y = dd_sqrt(dd_add_dx(1.0, common_5)); /* fact: theta_form.y; DLMF 22.6.1 */
        const double_double common_6 = dd_mul_xx(k_1, x); /* fact: theta_form.z, definition pi_near.g; DLMF 22.6.1, (36) */
        const double_double z = dd_sqrt(dd_add_dx(1.0, dd_mul_xx(common_6, common_6))); /* fact: theta_form.z; DLMF 22.6.1 */
        const double_double size_s = dd_size(s); /* classical: DLMF 22.4.3 */
        const double_double common_7 = dd_mul_xx(c, c); /* fact: pi_near.T_size; DLMF 22.4.3, (36) */
        const double near = dd_rounded(common_7); /* classical: DLMF 22.4.3 */
        const double_double common_8 = dd_mul_xx(s, s); /* fact: pi_near.T_size; DLMF 22.4.3, (36) */
        const double far = dd_rounded(dd_mul_xx(kc_1, common_8)); /* classical: DLMF 22.4.3 */
        const double_double above = dd_choose(far, near, size_s, c); /* classical: DLMF 22.4.3 */
        const double_double common_9 = dd_mul_xx(kc_1, size_s); /* classical: DLMF 22.4.3, DLMF 22.4(iii) */
        const double_double below = dd_choose(far, near, c, common_9); /* classical: DLMF 22.4.3 */
        const double_double xi = dd_div_xx(above, below); /* classical: DLMF 22.6.7 */
        double_double K_c;
        double_double sin_b;
        double_double cos_b;
        double_double Y_b;
        ladder(kc_1, k_1, dd_of(0.0), dd_of(1.0), dd_of(1.0), kc_1, xi, &K_c, &sin_b, &cos_b, &Y_b); /* classical: DLMF 19.8.12 */
        const double_double gc = dd_div_xx(pi, dd_mul_dx(2.0, K_c)); /* arithmetic */
        const double_double common_10 = dd_sub_dx(1.0, n); /* classical: DLMF 19.8.6 */
        double_double K_1;
        double_double total;
        complete(kc_1, common_10, &K_1, &total); /* classical: DLMF 19.8.6 */
        const double_double characteristic = n; /* arithmetic */
        const double_double j = dd_div_xx(total, dd_mul_dx(2.0, common_10)); /* classical: DLMF 19.8.6 */
        const double_double common_11 = dd_mul_xx(z, z); /* fact: definition pi_near.delta, definition pi_near.g_1, definition pi_near.g_2, pi_near.T_size; (36) */
        const double_double delta = dd_div_xx(m_c, common_11); /* fact: definition pi_near.delta; (36) */
        const double_double n_2 = dd_sub_dx(1.0, delta); /* fact: definition pi_near.n_2; (36) */
        const double_double Lambda = dd_div_xx(H, K); /* fact: definition pi_near.Lambda; (36) */
        const double_double g = dd_div_xx(dd_mul_xx(dd_mul_xx(common_6, y), z), dd_add_dx(1.0, dd_mul_xx(k_1, common_5))); /* fact: definition pi_near.g; (36) */
        const double_double g_1 = dd_div_xx(dd_mul_xx(g, m_c), dd_mul_xx(common_11, dd_add_dx(1.0, k_1))); /* fact: definition pi_near.g_1; (36) */
        const double_double common_12 = dd_mul_xx(dd_mul_xx(dd_mul_xx(k_1, k_1), x), y); /* fact: definition pi_near.g_2, definition pi_near.slope; (36) */
        const double_double g_2 = dd_div_xx(dd_mul_xx(common_12, m_c), dd_mul_xx(common_11, z)); /* fact: definition pi_near.g_2; (36) */
        const double_double h_2 = dd_mul_xx(g_1, dd_add_xx(k_1, n_2)); /* fact: definition pi_near.h_2; (36) */
        const double_double slope = common_12; /* fact: definition pi_near.slope; (36) */
        const double_double alpha = dd_mul_xx(dd_mul_xx(g, K_1), dd_sub_dx(1.0, dd_mul_xx(j, dd_sub_xx(k_1, n)))); /* fact: definition pi_near.alpha; (36) */
        const double_double Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
        const double_double common_13 = dd_mul_xx(dd_mul_xx(delta, k_1), x); /* classical: DLMF 19.36.1 */
        const double_double spread = dd_mul_xx(n_2, dd_mul_xx(common_13, common_13)); /* classical: DLMF 19.36.1 */
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
        const double near_c = dd_rounded(dd_choose(far, near, c, dd_div_xx(common_9, d))); /* classical: DLMF 22.4(iii) */
        const double near_d = dd_rounded(dd_choose(far, near, d, dd_div_xx(kc_1, d))); /* classical: DLMF 22.4(iii) */
        const double cosine = choose(near_c, least_c, least_c, near_c); /* classical: DLMF 22.4(iii) */
        const double path = fused(cosine, cosine, dd_rounded(delta) * (near_s * near_s)); /* classical: DLMF 19.25.14 */
        const double third = third_kind(near_s, cosine, near_d, path, dd_rounded(spread)); /* classical: DLMF 19.25.14 */
        const double_double w = dd_div_xx(y_b, gc); /* arithmetic */
        const double_double common_14 = dd_mul_xx(g_1, w); /* arithmetic */
        const double_double from_crossing = dd_add_xx(common_14, dd_mul_xd(g_2, third)); /* arithmetic */
        const double_double from_saddle = dd_sub_xx(alpha, dd_add_xx(common_14, dd_mul_xd(h_2, third))); /* arithmetic */
        const double_double rest = dd_choose(far, near, from_crossing, from_saddle); /* arithmetic */
        const double_double start_rest = dd_mul_dx(side, rest); /* arithmetic */
        const double_double T_size = dd_sqrt(dd_mul_xx(dd_mul_xx(common_11, dd_sub_dx(1.0, dd_mul_xx(n, common_8))), dd_add_xx(common_7, dd_mul_xx(delta, common_8)))); /* fact: pi_near.T_size; (36) */
        const double_double T_re = dd_div_xx(dd_mul_xx(z, d), T_size); /* fact: definition arctangent.T_re; (36) */
        const double_double T_im = dd_div_xx(dd_mul_xx(dd_mul_xx(dd_mul_dx(-rho, slope), s), c), T_size); /* fact: definition arctangent.T_im; (36) */
        const double_double start_re = dd_choose(far, near, T_re, dd_of(1.0)); /* arithmetic */
        const double_double start_im = dd_choose(far, near, T_im, dd_of(0.0)); /* arithmetic */
        const double_double M_a = dd_mul_xx(c_a, Omega_a); /* fact: definition attitude.M_a; (8) */
        const double_double M_b = dd_mul_xx(c_b, Omega_b); /* fact: definition attitude.M_b; (8) */
        const double_double M_d = dd_mul_xx(c_d, Omega_d); /* fact: definition attitude.M_d; (8) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double_double common_15 = dd_mul_dx(2.0, K); /* fact: attitude.nu, definition attitude.s_0; (27) */
        const double_double nu = dd_sqrt(dd_mul_xx(common_15, dd_add_xx(K, dd_mul_dx(sigma, M_a)))); /* fact: attitude.nu; (27) */
        const double_double s_0 = dd_div_xx(nu, common_15); /* fact: definition attitude.s_0; (27) */
        const double_double s_b = dd_div_xx(dd_mul_dx(sigma * epsilon, M_d), nu); /* fact: definition attitude.s_b; (28) */
        const double_double s_d = dd_div_xx(dd_mul_dx(-sigma * epsilon, M_b), nu); /* fact: definition attitude.s_d; (28) */
        const double_double qbar_0 = dd_mul_xx(start_re, s_0); /* fact: definition attitude.qbar_0; (18), (25) */
        const double_double qbar_a = dd_mul_xx(dd_mul_dx(sigma, start_im), s_0); /* fact: definition attitude.qbar_a; (18), (25) */
        const double_double common_16 = dd_mul_dx(epsilon * sigma, start_im); /* fact: definition attitude.qbar_b, definition attitude.qbar_d; (18), (25) */
        const double_double qbar_b = dd_sub_xx(dd_mul_xx(start_re, s_b), dd_mul_xx(common_16, s_d)); /* fact: definition attitude.qbar_b; (18), (25) */
        const double_double qbar_d = dd_add_xx(dd_mul_xx(start_re, s_d), dd_mul_xx(common_16, s_b)); /* fact: definition attitude.qbar_d; (18), (25) */
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
static void hyperbolic_angles(const torque_free_pi_hyperbolic *motion, size_t n,
    const double *restrict t_in, const double *restrict t_lo_in, double *restrict s_out,
    double *restrict c_out, double *restrict X_im_out, double *restrict X_re_out,
    double *restrict d_out)
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
        const double inside_4 = fused(-(x_5 * x_5), l_5, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x_4 = x_5 * (1.0 + l_5) / inside_4; /* fact: definition landen.x; DLMF 22.7.2 */
        const double inside_3 = fused(-(x_4 * x_4), l_4, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x_3 = x_4 * (1.0 + l_4) / inside_3; /* fact: definition landen.x; DLMF 22.7.2 */
        const double inside_2 = fused(-(x_3 * x_3), l_3, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x_2 = x_3 * (1.0 + l_3) / inside_2; /* fact: definition landen.x; DLMF 22.7.2 */
        const double inside = fused(-(x_2 * x_2), l_2, 1.0); /* fact: definition landen.inside; DLMF 22.7.2 */
        const double x = x_2 * (1.0 + l_2) / inside; /* fact: definition landen.x; DLMF 22.7.2 */
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
static void hyperbolic_state(const torque_free_pi_hyperbolic *motion, size_t n,
    const double *restrict s_in, const double *restrict c_in, const double *restrict X_im_in,
    const double *restrict X_re_in, const double *restrict d_in, double *restrict q_0_out,
    double *restrict q_a_out, double *restrict q_b_out, double *restrict q_d_out,
    double *restrict Omega_a_out, double *restrict Omega_b_out, double *restrict Omega_d_out)
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
        const double common_2 = fused(k_1, common_1, 1.0); /* fact: definition descended.sn, definition descended.cn; DLMF 22.7.2, DLMF 22.7.3 */
        const double sn = s * (1.0 + k_1) / common_2; /* fact: definition descended.sn; DLMF 22.7.2 */
        const double cn = c * d / common_2; /* fact: definition descended.cn; DLMF 22.7.3 */
        const double dn = fused(c, c, common_1 * (2.0 * k_c / (1.0 + k_c))) / fused(common_1, k_1, 1.0); /* fact: descended.dn; DLMF 22.7.4 */
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
static void steady_constants(double_double Omega1, double_double Omega2, double_double Omega3,
    double_double p0, double_double p1, double_double p2, double_double p3,
    torque_free_pi_steady *motion)
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

/* Return True where a difference of products has all its digits. clang's -ffp-contract=fast fuses
   sums with products across functions, so that low parts are counted twice. */
static int differences_hold(void)
{
    const double zero = hidden(0.0);
    double_double x[5];
    for (size_t k = 0; k < 5; k++) {
        x[k] = dd_of(zero + difference_cases[k]);
    }
    const double_double above = dd_sub_xx(x[0], x[1]);
    const double_double below = dd_sub_xx(x[1], x[2]);
    const double_double found = discriminant_dd(x[0], x[2], above, below, x[3], x[4]);
    return is_double_double(found, 0.004108897986419382, -6.277847770376781e-21);
}

/* Return True where the loop over times loses no turns. At t = 2^45 - 3 + i both angles, (t + 1)/3
   and t/3 half turns, are multiples of sixty degrees, and their whole turns and all low parts
   count. */
static int angles_hold(void)
{
    const double start = hidden(35184372088829.0);
    double t[TIMES];
    double t_lo[TIMES];
    double to[6 * TIMES];
    torque_free_pi_circular motion;
    memset(&motion, 0, sizeof(torque_free_pi_circular));
    motion.v_rate_hi = over_3.hi;
    motion.v_rate_lo = over_3.lo;
    motion.Lambda_rate_hi = over_3.hi;
    motion.Lambda_rate_lo = over_3.lo;
    motion.v_hi = over_3.hi;
    motion.v_lo = over_3.lo;
    for (size_t i = 0; i < TIMES; i++) {
        t[i] = start + (double)i;
        t_lo[i] = 0.0;
    }
    circular_angles(&motion, TIMES, t, t_lo, to, to + TIMES, to + 2 * TIMES, to + 3 * TIMES, to + 4 * TIMES);
    int holds = 1;
    for (size_t i = 0; i < TIMES; i++) {
        const double cosine = to[TIMES + i];
        const double turned_cosine = to[3 * TIMES + i];
        holds = holds && fabs(cosine - known_cosines[i % 6]) <= 1e-15;
        holds = holds && fabs(turned_cosine - known_cosines[(i + 5) % 6]) <= 1e-15;
    }
    return holds;
}

/* Return True where this build's arithmetic passes all tests. */
static int is_rounded_once(void)
{
    return sums_hold() && differences_hold() && quotients_hold() && angles_hold();
}

/* Return a double as an exact number. */
static exact exact_of(double a)
{
    exact x;
    x.count = 1;
    x.part[0] = a;
    return x;
}

/* Return the discriminant of doubles, as a pair rounded from its exact value. */
static double_double exact_discriminant(double c_a, double c_b, double c_d, double Omega_a,
    double Omega_d)
{
    const exact above = exact_sub_xx(exact_of(c_a), exact_of(c_b));
    const exact below = exact_sub_xx(exact_of(c_b), exact_of(c_d));
    const exact E_b = discriminant_exact(exact_of(c_a), exact_of(c_d), above, below, exact_of(Omega_a), exact_of(Omega_d));
    double_double total = {0.0, 0.0};
    for (size_t i = 0; i < E_b.count; i++) {
        total = dd_add_xd(total, E_b.part[i]);
    }
    return total;
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

/* Return True for zero of either sign. */
static INLINED int is_zero(double x)
{
    return !(x < 0.0 || x > 0.0);
}

/* Return x 2^n, by `ldexp` where 2^n is no normal double. */
static INLINED double scaled_by(double x, int n)
{
    return n >= -1022 && n <= 1023 ? x * power_of_two((double)n) : ldexp(x, n);
}

/* Return x 2^n. */
static INLINED double_double scaled(double_double x, int n)
{
    const double_double result = {scaled_by(x.hi, n), scaled_by(x.lo, n)};
    return result;
}

/* Return the exponent e of the largest size, so that x 2^-e is below 2; -1 for zeros. */
static int scale_of(double x, double y, double z)
{
    const double first = fabs(x) >= fabs(y) ? fabs(x) : fabs(y);
    const double largest = first >= fabs(z) ? first : fabs(z);
    return exponent_of(largest) - 1;
}

/* Return the exponent of a quaternion's largest component; -1 for zeros. */
static int scale_of_attitude(const double q[4])
{
    const double first = fabs(q[0]) >= fabs(q[1]) ? fabs(q[0]) : fabs(q[1]);
    return scale_of(first, q[2], q[3]);
}

/* Return x 2^n, or the least double of its sign where that is zero but x is not. */
static double scaled_rate(double x, int n)
{
    const double y = scaled_by(x, n);
    const double smallest = x < 0.0 ? -5e-324 : 5e-324;
    return is_zero(y) && !is_zero(x) ? smallest : y;
}

/* Return the code of the first rule that finite numbers of a body break, or OK. c: the moments in
   inner units. */
static int broken_rule(const double inertia[3], const double_double c[3], const double attitude0[4])
{
    const double smaller = inertia[0] <= inertia[1] ? inertia[0] : inertia[1];
    const double smallest = smaller <= inertia[2] ? smaller : inertia[2];
    const double thinner = c[0].hi <= c[1].hi ? c[0].hi : c[1].hi;
    const double thinnest = thinner <= c[2].hi ? thinner : c[2].hi;
    const int no_attitude = is_zero(attitude0[0]) && is_zero(attitude0[1]) && is_zero(attitude0[2]) && is_zero(attitude0[3]);
    const int attitude = no_attitude ? TORQUE_FREE_PI_ATTITUDE : TORQUE_FREE_PI_OK;
    const int thin = thinnest < min_moment_ratio ? TORQUE_FREE_PI_THIN : attitude;
    const int nonphysical = ALLOW_NONPHYSICAL || can_exist(c) ? thin : TORQUE_FREE_PI_NONPHYSICAL;
    return smallest > 0.0 ? nonphysical : TORQUE_FREE_PI_INERTIA;
}

/* Return a quaternion divided by its length. */
static void normalised(const double_double q[4], double_double *q_0_out, double_double *q_1_out,
    double_double *q_2_out, double_double *q_3_out)
{
    const double_double square = dd_add_xx(dd_add_xx(dd_add_xx(dd_mul_xx(q[0], q[0]), dd_mul_xx(q[1], q[1])), dd_mul_xx(q[2], q[2])), dd_mul_xx(q[3], q[3]));
    const double_double length = dd_sqrt(square);
    const double_double q_0 = dd_div_xx(q[0], length);
    const double_double q_1 = dd_div_xx(q[1], length);
    const double_double q_2 = dd_div_xx(q[2], length);
    const double_double q_3 = dd_div_xx(q[3], length);
    *q_0_out = q_0;
    *q_1_out = q_1;
    *q_2_out = q_2;
    *q_3_out = q_3;
}

/* Return a rate, or zero where it is negligible beside the largest. */
static INLINED double_double not_negligible(double_double rate)
{
    const double_double zero = {0.0, 0.0};
    return fabs(rate.hi) < negligible ? zero : rate;
}

/* Return True if all rates are zero. */
static int is_at_rest(const double_double omega[3])
{
    return is_zero(omega[0].hi) && is_zero(omega[1].hi) && is_zero(omega[2].hi);
}

/* Return c_j - c_k of two different axes. */
static INLINED double_double difference(const double_double apart[3], int j, int k)
{
    return k == (j + 1) % 3 ? apart[j] : dd_neg(apart[k]);
}

/* Return two axes, that of the larger moment first; equal ones keep their order. */
static INLINED void ordered(const double_double apart[3], int j, int k, int *first_out,
    int *second_out)
{
    const int swaps = difference(apart, j, k).hi < 0.0;
    const int first = swaps ? k : j;
    const int second = swaps ? j : k;
    *first_out = first;
    *second_out = second;
}

/* Return the axes by their moments, largest first; equal ones keep their order. */
static void sorted_axes(const double_double apart[3], int *a_out, int *b_out, int *d_out)
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
static double mark(double_double x)
{
    return is_zero(x.hi) ? 0.0 : 1.0;
}

/* Return 1 or -1 where a is the axis of largest or smallest moment, 0 where rates are constant. The
   axes are sorted by their moments. */
static double side_of(const double_double apart[3], const double_double omega[3], int a, int b,
    int d, double E_b)
{
    return circulation(mark(difference(apart, a, b)), mark(difference(apart, a, d)), mark(difference(apart, b, d)), mark(omega[a]), mark(omega[b]), mark(omega[d]), E_b);
}

/* Return E_b to all digits of a pair, from exact arithmetic where its terms cancel. */
static double_double discriminant_of(const double_double c[3], const double_double apart[3],
    const double_double omega[3], int a, int b, int d)
{
    const double_double c_ab = difference(apart, a, b);
    const double_double c_bd = difference(apart, b, d);
    const double_double zero = {0.0, 0.0};
    const int scale = scale_of(omega[a].hi, omega[d].hi, 0.0);
    const double_double rate_a = scaled(omega[a], -scale);
    const double_double rate_d = scaled(omega[d], -scale);
    const double_double over = discriminant_dd(c[a], c[d], c_ab, c_bd, rate_a, zero);
    const double_double under = discriminant_dd(c[a], c[d], c_ab, c_bd, zero, rate_d);
    double_double E_b = dd_add_xx(over, under);
    if (!(fabs(E_b.hi) > (over.hi - under.hi) / 1024.0) && !is_zero(over.hi)) {
        E_b = exact_discriminant(c[a].hi, c[b].hi, c[d].hi, rate_a.hi, rate_d.hi);
    }
    return scaled(E_b, 2 * scale);
}

/* Return log2(x), x >= 0, without an exception for zero. */
static double log2_of(double x)
{
    return x > 0.0 ? log2(x) : -HUGE_VAL;
}

/* Return log2(2^x + 2^y); both may be minus infinity. */
static double log2_sum(double x, double y)
{
    const double most = x >= y ? x : y;
    const double other = x <= y ? x : y;
    return isfinite(most) ? most + log2(1.0 + exp2(other - most)) : most;
}

/* Return whether a motion is replaced by another, whether by spin, and its last time. A separatrix
   motion replaces a motion whose E_b is too faint. Spin about the middle axis replaces a motion for
   which rates taken for zero could decide when that spin turns over. The last time is that up to
   which the replacement is close enough. With X = sqrt(c_a |c_a - c_b|) Omega_a, Z = sqrt(c_d |c_b
   - c_d|) Omega_d Euler's equations are X' = k Omega_b Z, Z' = k Omega_b X, up to signs. So X + Z
   and X - Z, whose product is E_b, grow no faster than exp(lambda t), where lambda is k times the
   largest |Omega_b|. One of them is zero on the separatrix, and both are zero in spin. Those that
   are not zero may grow to the share `tolerated` of the momentum. Logarithms have base 2: the
   numbers themselves leave the range of binary64. */
static void follow(const double_double c[3], const double_double apart[3],
    const double_double given[3], const double_double omega[3], int a, int b, int d, double E_b,
    int is_faint, int *follows_out, int *spins_out, double *last_out)
{
    const double c_a = c[a].hi;
    const double c_b = c[b].hi;
    const double c_d = c[d].hi;
    const double rate_b = given[b].hi;
    const double rate_d = given[d].hi;
    const double over = fabs(difference(apart, a, b).hi);
    const double under = fabs(difference(apart, b, d).hi);
    const double largest = c_a >= c_d ? c_a : c_d;
    const double smallest = c_a <= c_d ? c_a : c_d;
    const double weight_a = 0.5 * log2_of(c_a * over);
    const double weight_d = 0.5 * log2_of(c_d * under);
    const double part_a = weight_a + log2_of(fabs(given[a].hi));
    const double part_d = weight_d + log2_of(fabs(rate_d));
    const int loses_a = is_zero(omega[a].hi);
    const int loses_d = is_zero(omega[d].hi);
    const double gone = log2_sum(loses_a ? part_a : -HUGE_VAL, loses_d ? part_d : -HUGE_VAL);
    const double left = log2_sum(loses_a ? -HUGE_VAL : part_a, loses_d ? -HUGE_VAL : part_d);
    const double momentum_0 = c[0].hi * fabs(given[0].hi);
    const double momentum_1 = c[1].hi * fabs(given[1].hi);
    const double momentum_2 = c[2].hi * fabs(given[2].hi);
    const double larger = momentum_0 >= momentum_1 ? momentum_0 : momentum_1;
    const double momentum = larger >= momentum_2 ? larger : momentum_2;
    const double whole = log2_sum(part_a, part_d);
    const double distance = log2_of(fabs(E_b));
    const int spins = gone > left + log2(decisive) || (is_faint && distance > 2.0 * whole + log2(decisive));
    const double growth = sqrt(over / c_a * (under / c_d) * (rate_b * rate_b) + under / c_b * ((over + under) / c_a) * (rate_d * rate_d));
    const double speed = log2_of(growth) + log2(smallest / largest);
    const double slow = 0.0 <= speed ? 0.0 : speed;
    const double room = (weight_a <= weight_d ? weight_a : weight_d) + log2(momentum / largest) + slow - (spins ? whole : distance - whole);
    const double doublings = log2(tolerated) + room;
    const double until = doublings > 0.0 ? log(2.0) * doublings / growth : 0.0;
    const double close = until <= max_angle ? until : max_angle;
    const int follows = spins || is_faint;
    const double last = follows ? close : max_angle;
    *follows_out = follows;
    *spins_out = spins;
    *last_out = last;
}

/* Return a motion's last time, and the rates and E_b that it is computed from until then. given:
   the rates; omega: the same but for negligible ones, which are zero. */
static void course(const double_double c[3], const double_double apart[3],
    const double_double given[3], const double_double omega[3], int a, int b, int d,
    double_double E_b, double *last_out, double_double *omega_0_out, double_double *omega_1_out,
    double_double *omega_2_out, double_double *found_out)
{
    const int is_asymmetric = !(is_zero(apart[0].hi) || is_zero(apart[1].hi) || is_zero(apart[2].hi));
    const int is_faint = !is_zero(E_b.hi) && fabs(E_b.hi) < min_discriminant;
    const int loses_a = is_zero(omega[a].hi) && !is_zero(given[a].hi);
    const int loses_d = is_zero(omega[d].hi) && !is_zero(given[d].hi);
    const double_double zero = {0.0, 0.0};
    int follows = 0;
    int spins = 0;
    double last = max_angle;
    if (is_asymmetric && (is_faint || loses_a || loses_d)) {
        follow(c, apart, given, omega, a, b, d, E_b.hi, is_faint, &follows, &spins, &last);
    }
    const double_double omega_0 = spins && b != 0 ? zero : omega[0];
    const double_double omega_1 = spins && b != 1 ? zero : omega[1];
    const double_double omega_2 = spins && b != 2 ? zero : omega[2];
    const double_double found = follows ? zero : E_b;
    *last_out = last;
    *omega_0_out = omega_0;
    *omega_1_out = omega_1;
    *omega_2_out = omega_2;
    *found_out = found;
}

/* Return the last time, earlier for nonphysical bodies that speed up a lot after t = 0. */
static double limit(double last, double rate, double other)
{
    const double larger = fabs(rate) >= fabs(other) ? fabs(rate) : fabs(other);
    const double largest = larger >= 16.0 ? larger : 16.0;
    const double earlier = 16.0 * max_angle / largest;
    return last <= earlier ? last : earlier;
}

/* Return True if no rate, up to its amplitude, overflows. */
static int is_held(double unit, double A_a, double A_b, double A_d)
{
    return A_a * unit <= max_rate && A_b * unit <= max_rate && A_d * unit <= max_rate;
}

/* Return True if n doubles are finite. */
static int all_finite(size_t n, const double *restrict x)
{
    for (size_t k = 0; k < n; k++) {
        if (!isfinite(x[k])) {
            return 0;
        }
    }
    return 1;
}

/* Compute the constants of a motion with constant rates. */
static void steady_init(torque_free_pi_motion *motion, const double_double omega[3],
    const double_double q[4])
{
    const int at_rest = is_at_rest(omega);
    const double_double one = {1.0, 0.0};
    const double_double first = at_rest ? one : omega[0];
    motion->branch = 0;
    steady_constants(first, omega[1], omega[2], q[0], q[1], q[2], q[3], &motion->of.steady);
    if (at_rest) {
        motion->unit = 0.0;
        motion->of.steady.Lambda_rate_hi = 0.0;
        motion->of.steady.Lambda_rate_lo = 0.0;
    }
}

/* Write a pair to lane i. */
static void put_pair(double *restrict high, double *restrict low, size_t i, double_double x)
{
    high[i] = x.hi;
    low[i] = x.lo;
}

/* Write the numbers that the constants of a motion are computed from to lane i. */
static void put(lanes *lane, size_t i, const torque_free_pi_motion *motion, const double_double c[3],
    const double_double apart[3], const double_double omega[3], const double_double q[4],
    double_double E_b)
{
    const int a = motion->axis[0];
    const int b = motion->axis[1];
    const int d = motion->axis[2];
    put_pair(lane->c_a_hi, lane->c_a_lo, i, c[a]);
    put_pair(lane->c_b_hi, lane->c_b_lo, i, c[b]);
    put_pair(lane->c_d_hi, lane->c_d_lo, i, c[d]);
    put_pair(lane->c_ab_hi, lane->c_ab_lo, i, difference(apart, a, b));
    put_pair(lane->c_ad_hi, lane->c_ad_lo, i, difference(apart, a, d));
    put_pair(lane->c_bd_hi, lane->c_bd_lo, i, difference(apart, b, d));
    put_pair(lane->Omega_a_hi, lane->Omega_a_lo, i, omega[a]);
    put_pair(lane->Omega_b_hi, lane->Omega_b_lo, i, omega[b]);
    put_pair(lane->Omega_d_hi, lane->Omega_d_lo, i, omega[d]);
    put_pair(lane->E_b_hi, lane->E_b_lo, i, E_b);
    put_pair(lane->q_0_hi, lane->q_0_lo, i, q[0]);
    put_pair(lane->q_a_hi, lane->q_a_lo, i, q[1 + a]);
    put_pair(lane->q_b_hi, lane->q_b_lo, i, q[1 + b]);
    put_pair(lane->q_d_hi, lane->q_d_lo, i, q[1 + d]);
    lane->axis_a[i] = (double)a;
    lane->axis_b[i] = (double)b;
    lane->axis_d[i] = (double)d;
    lane->unit[i] = motion->unit;
}

/* Copy a used lane of a row to all that are not used. */
static void spread(double *restrict row, const double own[LANES], size_t used)
{
    const double other = row[used];
    for (size_t i = 0; i < LANES; i++) {
        row[i] = own[i] > 0.0 ? row[i] : other;
    }
}

/* Copy a used lane to all that are not used, so that unused lanes raise no exceptions. */
static void repeat(lanes *lane, const int own[LANES])
{
    size_t used = 0;
    double mask[LANES];
    for (size_t i = 0; i < LANES; i++) {
        used = own[LANES - 1 - i] ? LANES - 1 - i : used;
        mask[i] = own[i] ? 1.0 : 0.0;
    }
    spread(lane->c_a_hi, mask, used);
    spread(lane->c_a_lo, mask, used);
    spread(lane->c_b_hi, mask, used);
    spread(lane->c_b_lo, mask, used);
    spread(lane->c_d_hi, mask, used);
    spread(lane->c_d_lo, mask, used);
    spread(lane->c_ab_hi, mask, used);
    spread(lane->c_ab_lo, mask, used);
    spread(lane->c_ad_hi, mask, used);
    spread(lane->c_ad_lo, mask, used);
    spread(lane->c_bd_hi, mask, used);
    spread(lane->c_bd_lo, mask, used);
    spread(lane->Omega_a_hi, mask, used);
    spread(lane->Omega_a_lo, mask, used);
    spread(lane->Omega_b_hi, mask, used);
    spread(lane->Omega_b_lo, mask, used);
    spread(lane->Omega_d_hi, mask, used);
    spread(lane->Omega_d_lo, mask, used);
    spread(lane->E_b_hi, mask, used);
    spread(lane->E_b_lo, mask, used);
    spread(lane->axis_a, mask, used);
    spread(lane->axis_b, mask, used);
    spread(lane->axis_d, mask, used);
    spread(lane->K_hi, mask, used);
    spread(lane->K_lo, mask, used);
    spread(lane->A_a_hi, mask, used);
    spread(lane->A_a_lo, mask, used);
    spread(lane->A_b_hi, mask, used);
    spread(lane->A_b_lo, mask, used);
    spread(lane->A_d_hi, mask, used);
    spread(lane->A_d_lo, mask, used);
    spread(lane->B_a_hi, mask, used);
    spread(lane->B_a_lo, mask, used);
    spread(lane->B_d_hi, mask, used);
    spread(lane->B_d_lo, mask, used);
    spread(lane->k_c_hi, mask, used);
    spread(lane->k_c_lo, mask, used);
    spread(lane->k_1_hi, mask, used);
    spread(lane->k_1_lo, mask, used);
    spread(lane->kc_1_hi, mask, used);
    spread(lane->kc_1_lo, mask, used);
    spread(lane->m_c_hi, mask, used);
    spread(lane->m_c_lo, mask, used);
    spread(lane->mu_hi, mask, used);
    spread(lane->mu_lo, mask, used);
    spread(lane->psi_0_hi, mask, used);
    spread(lane->psi_0_lo, mask, used);
    spread(lane->n_hi, mask, used);
    spread(lane->n_lo, mask, used);
    spread(lane->kappa_hi, mask, used);
    spread(lane->kappa_lo, mask, used);
    spread(lane->H_hi, mask, used);
    spread(lane->H_lo, mask, used);
    spread(lane->s_hi, mask, used);
    spread(lane->s_lo, mask, used);
    spread(lane->c_hi, mask, used);
    spread(lane->c_lo, mask, used);
    spread(lane->d_hi, mask, used);
    spread(lane->d_lo, mask, used);
    spread(lane->epsilon, mask, used);
    spread(lane->sigma, mask, used);
    spread(lane->rho, mask, used);
    spread(lane->chi, mask, used);
    spread(lane->q_0_hi, mask, used);
    spread(lane->q_0_lo, mask, used);
    spread(lane->q_a_hi, mask, used);
    spread(lane->q_a_lo, mask, used);
    spread(lane->q_b_hi, mask, used);
    spread(lane->q_b_lo, mask, used);
    spread(lane->q_d_hi, mask, used);
    spread(lane->q_d_lo, mask, used);
    spread(lane->unit, mask, used);
}

/* Compute the constants of those of n motions that are on one branch. lane: what `initial_state`
   has written. */
static void branch_init(const lanes *lane, int branch, size_t n,
    torque_free_pi_motion *restrict motion, int *restrict code)
{
    lanes alike;
    alike = *lane;
    int own[LANES];
    int is_any = 0;
    int are_others = 0;
    for (size_t i = 0; i < LANES; i++) {
        own[i] = i < n && motion[i].branch == branch;
        is_any = is_any || own[i];
        are_others = are_others || (i < n && motion[i].branch != 0 && !own[i]);
    }
    if (!is_any) {
        return;
    }
    if (are_others) {
        repeat(&alike, own);
    }
    if (branch == 1) {
        circular_lanes circular;
        circular_constants(&alike, &circular);
        for (size_t i = 0; i < n; i++) {
            if (own[i]) {
                int holds = 1;
                motion[i].of.circular.v_rate_hi = circular.v_rate_hi[i];
                holds = holds && isfinite(circular.v_rate_hi[i]);
                motion[i].of.circular.v_rate_lo = circular.v_rate_lo[i];
                holds = holds && isfinite(circular.v_rate_lo[i]);
                motion[i].of.circular.v_hi = circular.v_hi[i];
                holds = holds && isfinite(circular.v_hi[i]);
                motion[i].of.circular.v_lo = circular.v_lo[i];
                holds = holds && isfinite(circular.v_lo[i]);
                motion[i].of.circular.Lambda_rate_hi = circular.Lambda_rate_hi[i];
                holds = holds && isfinite(circular.Lambda_rate_hi[i]);
                motion[i].of.circular.Lambda_rate_lo = circular.Lambda_rate_lo[i];
                holds = holds && isfinite(circular.Lambda_rate_lo[i]);
                motion[i].of.circular.k_2 = circular.k_2[i];
                holds = holds && isfinite(circular.k_2[i]);
                motion[i].of.circular.k_3 = circular.k_3[i];
                holds = holds && isfinite(circular.k_3[i]);
                motion[i].of.circular.k_4 = circular.k_4[i];
                holds = holds && isfinite(circular.k_4[i]);
                motion[i].of.circular.k_5 = circular.k_5[i];
                holds = holds && isfinite(circular.k_5[i]);
                motion[i].of.circular.characteristic = circular.characteristic[i];
                holds = holds && isfinite(circular.characteristic[i]);
                motion[i].of.circular.spread = circular.spread[i];
                holds = holds && isfinite(circular.spread[i]);
                motion[i].of.circular.kappa = circular.kappa[i];
                holds = holds && isfinite(circular.kappa[i]);
                motion[i].of.circular.j = circular.j[i];
                holds = holds && isfinite(circular.j[i]);
                motion[i].of.circular.two_K = circular.two_K[i];
                holds = holds && isfinite(circular.two_K[i]);
                motion[i].of.circular.rest_0 = circular.rest_0[i];
                holds = holds && isfinite(circular.rest_0[i]);
                motion[i].of.circular.c_a = circular.c_a[i];
                holds = holds && isfinite(circular.c_a[i]);
                motion[i].of.circular.c_b = circular.c_b[i];
                holds = holds && isfinite(circular.c_b[i]);
                motion[i].of.circular.c_d = circular.c_d[i];
                holds = holds && isfinite(circular.c_d[i]);
                motion[i].of.circular.A_a = circular.A_a[i];
                holds = holds && isfinite(circular.A_a[i]);
                motion[i].of.circular.A_b = circular.A_b[i];
                holds = holds && isfinite(circular.A_b[i]);
                motion[i].of.circular.A_d = circular.A_d[i];
                holds = holds && isfinite(circular.A_d[i]);
                motion[i].of.circular.K = circular.K[i];
                holds = holds && isfinite(circular.K[i]);
                motion[i].of.circular.k_1 = circular.k_1[i];
                holds = holds && isfinite(circular.k_1[i]);
                motion[i].of.circular.k_c = circular.k_c[i];
                holds = holds && isfinite(circular.k_c[i]);
                motion[i].of.circular.epsilon = circular.epsilon[i];
                holds = holds && isfinite(circular.epsilon[i]);
                motion[i].of.circular.sigma = circular.sigma[i];
                holds = holds && isfinite(circular.sigma[i]);
                motion[i].of.circular.chi = circular.chi[i];
                holds = holds && isfinite(circular.chi[i]);
                motion[i].of.circular.tau = circular.tau[i];
                holds = holds && isfinite(circular.tau[i]);
                motion[i].of.circular.p_0 = circular.p_0[i];
                holds = holds && isfinite(circular.p_0[i]);
                motion[i].of.circular.p_a = circular.p_a[i];
                holds = holds && isfinite(circular.p_a[i]);
                motion[i].of.circular.p_b = circular.p_b[i];
                holds = holds && isfinite(circular.p_b[i]);
                motion[i].of.circular.p_d = circular.p_d[i];
                holds = holds && isfinite(circular.p_d[i]);
                motion[i].of.circular.unit = circular.unit[i];
                holds = holds && isfinite(circular.unit[i]);
                motion[i].max_angle = limit(motion[i].max_angle, circular.v_rate_hi[i], circular.Lambda_rate_hi[i]);
                code[i] = holds ? TORQUE_FREE_PI_OK : TORQUE_FREE_PI_RATES;
            }
        }
    } else {
        hyperbolic_lanes hyperbolic;
        hyperbolic_constants(&alike, &hyperbolic);
        for (size_t i = 0; i < n; i++) {
            if (own[i]) {
                int holds = 1;
                motion[i].of.hyperbolic.y_rate_hi = hyperbolic.y_rate_hi[i];
                holds = holds && isfinite(hyperbolic.y_rate_hi[i]);
                motion[i].of.hyperbolic.y_rate_lo = hyperbolic.y_rate_lo[i];
                holds = holds && isfinite(hyperbolic.y_rate_lo[i]);
                motion[i].of.hyperbolic.y0_hi = hyperbolic.y0_hi[i];
                holds = holds && isfinite(hyperbolic.y0_hi[i]);
                motion[i].of.hyperbolic.y0_lo = hyperbolic.y0_lo[i];
                holds = holds && isfinite(hyperbolic.y0_lo[i]);
                motion[i].of.hyperbolic.period_hi = hyperbolic.period_hi[i];
                holds = holds && isfinite(hyperbolic.period_hi[i]);
                motion[i].of.hyperbolic.period_lo = hyperbolic.period_lo[i];
                holds = holds && isfinite(hyperbolic.period_lo[i]);
                motion[i].of.hyperbolic.Lambda_rate_hi = hyperbolic.Lambda_rate_hi[i];
                holds = holds && isfinite(hyperbolic.Lambda_rate_hi[i]);
                motion[i].of.hyperbolic.Lambda_rate_lo = hyperbolic.Lambda_rate_lo[i];
                holds = holds && isfinite(hyperbolic.Lambda_rate_lo[i]);
                motion[i].of.hyperbolic.jump_hi = hyperbolic.jump_hi[i];
                holds = holds && isfinite(hyperbolic.jump_hi[i]);
                motion[i].of.hyperbolic.jump_lo = hyperbolic.jump_lo[i];
                holds = holds && isfinite(hyperbolic.jump_lo[i]);
                motion[i].of.hyperbolic.period_far = hyperbolic.period_far[i];
                holds = holds && isfinite(hyperbolic.period_far[i]);
                motion[i].of.hyperbolic.period_inverse = hyperbolic.period_inverse[i];
                holds = holds && isfinite(hyperbolic.period_inverse[i]);
                motion[i].of.hyperbolic.l_2 = hyperbolic.l_2[i];
                holds = holds && isfinite(hyperbolic.l_2[i]);
                motion[i].of.hyperbolic.l_3 = hyperbolic.l_3[i];
                holds = holds && isfinite(hyperbolic.l_3[i]);
                motion[i].of.hyperbolic.l_4 = hyperbolic.l_4[i];
                holds = holds && isfinite(hyperbolic.l_4[i]);
                motion[i].of.hyperbolic.l_5 = hyperbolic.l_5[i];
                holds = holds && isfinite(hyperbolic.l_5[i]);
                motion[i].of.hyperbolic.gc = hyperbolic.gc[i];
                holds = holds && isfinite(hyperbolic.gc[i]);
                motion[i].of.hyperbolic.kc_1 = hyperbolic.kc_1[i];
                holds = holds && isfinite(hyperbolic.kc_1[i]);
                motion[i].of.hyperbolic.m_c = hyperbolic.m_c[i];
                holds = holds && isfinite(hyperbolic.m_c[i]);
                motion[i].of.hyperbolic.rho = hyperbolic.rho[i];
                holds = holds && isfinite(hyperbolic.rho[i]);
                motion[i].of.hyperbolic.g_1 = hyperbolic.g_1[i];
                holds = holds && isfinite(hyperbolic.g_1[i]);
                motion[i].of.hyperbolic.g_2 = hyperbolic.g_2[i];
                holds = holds && isfinite(hyperbolic.g_2[i]);
                motion[i].of.hyperbolic.h_2 = hyperbolic.h_2[i];
                holds = holds && isfinite(hyperbolic.h_2[i]);
                motion[i].of.hyperbolic.alpha = hyperbolic.alpha[i];
                holds = holds && isfinite(hyperbolic.alpha[i]);
                motion[i].of.hyperbolic.delta = hyperbolic.delta[i];
                holds = holds && isfinite(hyperbolic.delta[i]);
                motion[i].of.hyperbolic.spread = hyperbolic.spread[i];
                holds = holds && isfinite(hyperbolic.spread[i]);
                motion[i].of.hyperbolic.slope = hyperbolic.slope[i];
                holds = holds && isfinite(hyperbolic.slope[i]);
                motion[i].of.hyperbolic.z = hyperbolic.z[i];
                holds = holds && isfinite(hyperbolic.z[i]);
                motion[i].of.hyperbolic.characteristic = hyperbolic.characteristic[i];
                holds = holds && isfinite(hyperbolic.characteristic[i]);
                motion[i].of.hyperbolic.start_rest = hyperbolic.start_rest[i];
                holds = holds && isfinite(hyperbolic.start_rest[i]);
                motion[i].of.hyperbolic.c_a = hyperbolic.c_a[i];
                holds = holds && isfinite(hyperbolic.c_a[i]);
                motion[i].of.hyperbolic.c_b = hyperbolic.c_b[i];
                holds = holds && isfinite(hyperbolic.c_b[i]);
                motion[i].of.hyperbolic.c_d = hyperbolic.c_d[i];
                holds = holds && isfinite(hyperbolic.c_d[i]);
                motion[i].of.hyperbolic.A_a = hyperbolic.A_a[i];
                holds = holds && isfinite(hyperbolic.A_a[i]);
                motion[i].of.hyperbolic.A_b = hyperbolic.A_b[i];
                holds = holds && isfinite(hyperbolic.A_b[i]);
                motion[i].of.hyperbolic.A_d = hyperbolic.A_d[i];
                holds = holds && isfinite(hyperbolic.A_d[i]);
                motion[i].of.hyperbolic.K = hyperbolic.K[i];
                holds = holds && isfinite(hyperbolic.K[i]);
                motion[i].of.hyperbolic.k_1 = hyperbolic.k_1[i];
                holds = holds && isfinite(hyperbolic.k_1[i]);
                motion[i].of.hyperbolic.k_c = hyperbolic.k_c[i];
                holds = holds && isfinite(hyperbolic.k_c[i]);
                motion[i].of.hyperbolic.epsilon = hyperbolic.epsilon[i];
                holds = holds && isfinite(hyperbolic.epsilon[i]);
                motion[i].of.hyperbolic.sigma = hyperbolic.sigma[i];
                holds = holds && isfinite(hyperbolic.sigma[i]);
                motion[i].of.hyperbolic.chi = hyperbolic.chi[i];
                holds = holds && isfinite(hyperbolic.chi[i]);
                motion[i].of.hyperbolic.tau = hyperbolic.tau[i];
                holds = holds && isfinite(hyperbolic.tau[i]);
                motion[i].of.hyperbolic.p_0 = hyperbolic.p_0[i];
                holds = holds && isfinite(hyperbolic.p_0[i]);
                motion[i].of.hyperbolic.p_a = hyperbolic.p_a[i];
                holds = holds && isfinite(hyperbolic.p_a[i]);
                motion[i].of.hyperbolic.p_b = hyperbolic.p_b[i];
                holds = holds && isfinite(hyperbolic.p_b[i]);
                motion[i].of.hyperbolic.p_d = hyperbolic.p_d[i];
                holds = holds && isfinite(hyperbolic.p_d[i]);
                motion[i].of.hyperbolic.unit = hyperbolic.unit[i];
                holds = holds && isfinite(hyperbolic.unit[i]);
                motion[i].max_angle = limit(motion[i].max_angle, hyperbolic.y_rate_hi[i], hyperbolic.Lambda_rate_hi[i]);
                code[i] = holds ? TORQUE_FREE_PI_OK : TORQUE_FREE_PI_RATES;
            }
        }
    }
    for (size_t i = 0; i < n; i++) {
        if (own[i] && !is_held(motion[i].unit, lane->A_a_hi[i], lane->A_b_hi[i], lane->A_d_hi[i])) {
            code[i] = TORQUE_FREE_PI_RATES;
        }
    }
}

/* Compute the constants of n motions that `begin` wrote to lanes, and their codes. Steady motions
   have their constants. */
static void moving_init(lanes *lane, size_t n, torque_free_pi_motion *restrict motion,
    int *restrict code)
{
    int own[LANES];
    size_t count = 0;
    for (size_t i = 0; i < LANES; i++) {
        own[i] = i < n && motion[i].branch != 0;
        count += own[i] ? 1 : 0;
    }
    if (count == 0) {
        return;
    }
    if (count < LANES) {
        repeat(lane, own);
    }
    initial_state(lane);
    for (size_t i = 0; i < n; i++) {
        if (own[i]) {
            motion[i].branch = lane->k_1_hi[i] * lane->k_1_hi[i] <= max_circular ? 1 : 2;
        }
    }
    branch_init(lane, 1, n, motion, code);
    branch_init(lane, 2, n, motion, code);
}

/* Copy the numbers that sensitivities are computed from to the motion. */
static void keep(torque_free_pi_motion *motion, const double_double c[3], const double_double apart[3],
    const double_double omega[3], double_double E_b)
{
    for (size_t k = 0; k < 3; k++) {
        motion->given[2 * k] = c[k].hi;
        motion->given[2 * k + 1] = c[k].lo;
        motion->given[6 + 2 * k] = apart[k].hi;
        motion->given[7 + 2 * k] = apart[k].lo;
        motion->given[12 + 2 * k] = omega[k].hi;
        motion->given[13 + 2 * k] = omega[k].lo;
    }
    motion->given[18] = E_b.hi;
    motion->given[19] = E_b.lo;
}

/* Set all of a motion but the constants of its branch, which are computed from lane i. c, apart
   (differences of each moment and the next in turn), the rates `given` and q are in inner units;
   known: E_b, where `is_known`. */
static void begin(torque_free_pi_motion *motion, lanes *lane, size_t i, const double_double c[3],
    const double_double apart[3], const double_double given[3], const double_double q[4],
    int is_known, double_double known, double unit)
{
    memset(motion, 0, sizeof(torque_free_pi_motion));
    motion->prepared = PREPARED;
    motion->unit = unit;
    motion->moment_unit = 1.0;
    double_double omega[3];
    for (size_t k = 0; k < 3; k++) {
        omega[k] = not_negligible(given[k]);
        motion->omega0[k] = given[k].hi * unit;
    }
    double_double turn[4];
    normalised(q, &turn[0], &turn[1], &turn[2], &turn[3]);
    for (size_t k = 0; k < 4; k++) {
        motion->q0[k] = dd_rounded(turn[k]);
    }
    int a;
    int b;
    int d;
    sorted_axes(apart, &a, &b, &d);
    double_double found = known;
    if (!is_known) {
        found = discriminant_of(c, apart, omega, a, b, d);
    }
    double last;
    double_double omega_0;
    double_double omega_1;
    double_double omega_2;
    double_double E_b;
    course(c, apart, given, omega, a, b, d, found, &last, &omega_0, &omega_1, &omega_2, &E_b);
    omega[0] = omega_0;
    omega[1] = omega_1;
    omega[2] = omega_2;
    motion->max_angle = last;
    motion->blurred = last < max_angle ? 1 : 0;
    keep(motion, c, apart, omega, E_b);
    const double side = side_of(apart, omega, a, b, d, E_b.hi);
    motion->axis[0] = side < 0.0 ? d : a;
    motion->axis[1] = b;
    motion->axis[2] = side < 0.0 ? a : d;
    motion->branch = side < 0.0 || side > 0.0 ? 1 : 0;
    if (motion->branch == 0) {
        steady_init(motion, omega, turn);
    } else {
        put(lane, i, motion, c, apart, omega, turn, E_b);
    }
}

/* Check doubles and begin a motion with them; return a code. */
static int begin_doubles(torque_free_pi_motion *motion, lanes *lane, size_t i, const double inertia[3],
    const double omega0[3], const double attitude0[4])
{
    motion->branch = 0;
    if (!(all_finite(3, inertia) && all_finite(3, omega0) && all_finite(4, attitude0))) {
        return TORQUE_FREE_PI_NOT_FINITE;
    }
    const int c_scale = scale_of(inertia[0], inertia[1], inertia[2]);
    const int scale = scale_of(omega0[0], omega0[1], omega0[2]);
    const int q_scale = scale_of_attitude(attitude0);
    double_double c[3];
    double_double apart[3];
    double_double omega[3];
    double_double q[4];
    for (size_t k = 0; k < 3; k++) {
        c[k].hi = scaled_by(inertia[k], -c_scale);
        c[k].lo = 0.0;
        omega[k].hi = scaled_rate(omega0[k], -scale);
        omega[k].lo = 0.0;
    }
    const int code = broken_rule(inertia, c, attitude0);
    if (code != TORQUE_FREE_PI_OK) {
        return code;
    }
    for (size_t k = 0; k < 4; k++) {
        q[k].hi = scaled_by(attitude0[k], -q_scale);
        q[k].lo = 0.0;
    }
    /* Differences of doubles are pairs exactly. */
    for (size_t k = 0; k < 3; k++) {
        apart[k] = two_sum(c[k].hi, -c[(k + 1) % 3].hi);
    }
    begin(motion, lane, i, c, apart, omega, q, 0, q[0], scaled_by(1.0, scale));
    for (size_t k = 0; k < 3; k++) {
        motion->omega0[k] = omega0[k];
    }
    motion->moment_unit = scaled_by(1.0, c_scale);
    return TORQUE_FREE_PI_OK;
}

/* Finish one motion that was begun, and return its code. */
static int end(torque_free_pi_motion *motion, torque_free_pi_motion *restrict made, lanes *lane)
{
    int code[1];
    code[0] = TORQUE_FREE_PI_OK;
    if (!is_rounded_once()) {
        return TORQUE_FREE_PI_ARITHMETIC;
    }
    moving_init(lane, 1, made, code);
    if (code[0] == TORQUE_FREE_PI_OK) {
        *motion = made[0];
    }
    return code[0];
}

int torque_free_pi_motion_init(torque_free_pi_motion *motion, const double inertia[3],
    const double omega0[3], const double attitude0[4])
{
    torque_free_pi_motion made[1];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const int code = begin_doubles(&made[0], &lane, 0, inertia, omega0, attitude0);
    if (code != TORQUE_FREE_PI_OK) {
        return code;
    }
    return end(motion, made, &lane);
}

int torque_free_pi_motion_init_double_doubles(torque_free_pi_motion *motion, const double inertia[3][2],
    const double differences[3][2], const double omega0[3][2], const double attitude0[4][2],
    const double discriminant[2], double unit)
{
    double_double c[3];
    double_double apart[3];
    double_double omega[3];
    double_double q[4];
    int are_finite = isfinite(discriminant[0]) && isfinite(discriminant[1]) && isfinite(unit);
    for (size_t k = 0; k < 3; k++) {
        c[k].hi = inertia[k][0];
        c[k].lo = inertia[k][1];
        apart[k].hi = differences[k][0];
        apart[k].lo = differences[k][1];
        omega[k].hi = omega0[k][0];
        omega[k].lo = omega0[k][1];
        if (!(isfinite(c[k].hi) && isfinite(c[k].lo))) {
            return TORQUE_FREE_PI_NOT_FINITE;
        }
        if (!(isfinite(apart[k].hi) && isfinite(apart[k].lo))) {
            return TORQUE_FREE_PI_NOT_FINITE;
        }
        if (!(isfinite(omega[k].hi) && isfinite(omega[k].lo))) {
            return TORQUE_FREE_PI_NOT_FINITE;
        }
        if (!(c[k].hi > 0.0)) {
            return TORQUE_FREE_PI_INERTIA;
        }
        if (c[k].hi < min_moment_ratio || c[k].hi > 4.0) {
            return TORQUE_FREE_PI_THIN;
        }
        if (fabs(omega[k].hi) > 4.0) {
            return TORQUE_FREE_PI_RATES;
        }
    }
    if (!can_exist(c)) {
        return TORQUE_FREE_PI_NONPHYSICAL;
    }
    int is_turned = 0;
    for (size_t k = 0; k < 4; k++) {
        q[k].hi = attitude0[k][0];
        q[k].lo = attitude0[k][1];
        are_finite = are_finite && isfinite(q[k].hi) && isfinite(q[k].lo);
        is_turned = is_turned || !is_zero(q[k].hi);
    }
    if (!are_finite) {
        return TORQUE_FREE_PI_NOT_FINITE;
    }
    if (!(unit > 0.0)) {
        return TORQUE_FREE_PI_RATES;
    }
    if (!is_turned) {
        return TORQUE_FREE_PI_ATTITUDE;
    }
    torque_free_pi_motion made[1];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const double_double known = {discriminant[0], discriminant[1]};
    begin(&made[0], &lane, 0, c, apart, omega, q, 1, known, unit);
    return end(motion, made, &lane);
}

/* Scale times to inner units. Return whether all are within the domain, and whether one is zero. */
static void scaled_times(const torque_free_pi_motion *motion, size_t n, const double *restrict t,
    double *restrict inner, int *near_out, int *has_zero_out)
{
    const double unit = motion->unit;
    const double last = motion->max_angle;
    /* Counts as wide as a double: vectors of comparisons need not be narrowed then. */
    size_t late = 0;
    size_t zeros = 0;
    for (size_t i = 0; i < n; i++) {
        inner[i] = unit * t[i];
        late += fabs(inner[i]) <= last ? 0 : 1;
        zeros += is_zero(t[i]) ? 1 : 0;
    }
    const int near = late == 0;
    const int has_zero = zeros > 0;
    *near_out = near;
    *has_zero_out = has_zero;
}

/* Write three columns as n rows, the first ones by shuffles where a target has these. */
static void interleaved(size_t n, const double *restrict a, const double *restrict b,
    const double *restrict c, double *restrict rows)
{
    const size_t done = shuffled(n, a, b, c, rows);
    for (size_t i = done; i < n; i++) {
        rows[3 * i] = a[i];
        rows[3 * i + 1] = b[i];
        rows[3 * i + 2] = c[i];
    }
}

/* Write four columns as n rows, the first ones by shuffles where a target has these. */
static void interleaved4(size_t n, const double *restrict a, const double *restrict b,
    const double *restrict c, const double *restrict d, double *restrict rows)
{
    const size_t done = shuffled4(n, a, b, c, d, rows);
    for (size_t i = done; i < n; i++) {
        rows[4 * i] = a[i];
        rows[4 * i + 1] = b[i];
        rows[4 * i + 2] = c[i];
        rows[4 * i + 3] = d[i];
    }
}

/* Compute n states from the angles, in rows s apart. The steady branch has two rows of angles, the
   others have at most six; `to` has room for seven. */
static void block_states(const torque_free_pi_motion *motion, size_t n, size_t s,
    const double *restrict angles, double *restrict to, double *restrict q, double *restrict omega)
{
    if (motion->branch == 0) {
        steady_state(&motion->of.steady, n, angles, angles + s, to, to + s, to + 2 * s, to + 3 * s);
        for (size_t i = 0; i < n; i++) {
            for (size_t k = 0; k < 3; k++) {
                omega[3 * i + k] = motion->omega0[k];
            }
        }
        interleaved4(n, to, to + s, to + 2 * s, to + 3 * s, q);
        return;
    }
    if (motion->branch == 1) {
        circular_state(&motion->of.circular, n, angles, angles + s, angles + 2 * s, angles + 3 * s, angles + 4 * s, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s, to + 5 * s, to + 6 * s);
    } else {
        hyperbolic_state(&motion->of.hyperbolic, n, angles, angles + s, angles + 2 * s, angles + 3 * s, angles + 4 * s, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s, to + 5 * s, to + 6 * s);
    }
    /* Where the row of each body axis begins. */
    size_t at[3];
    for (size_t k = 0; k < 3; k++) {
        at[motion->axis[k]] = (1 + k) * s;
    }
    interleaved4(n, to, to + at[0], to + at[1], to + at[2], q);
    interleaved(n, to + (3 * s + at[0]), to + (3 * s + at[1]), to + (3 * s + at[2]), omega);
}

/* Write the angles at the inner times t + t_lo, in rows s apart. */
static void block_angles(const torque_free_pi_motion *motion, size_t n, size_t s,
    const double *restrict t, const double *restrict t_lo, double *restrict to)
{
    if (motion->branch == 0) {
        steady_angles(&motion->of.steady, n, t, t_lo, to, to + s);
    } else if (motion->branch == 1) {
        circular_angles(&motion->of.circular, n, t, t_lo, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s);
    } else {
        hyperbolic_angles(&motion->of.hyperbolic, n, t, t_lo, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s);
    }
}

/* Prefetch the cache lines that the next block will be written to, where n states are left. */
static void fetch(size_t n, const double *restrict q, const double *restrict omega)
{
    if (n >= 2 * BLOCK) {
        PREFETCH(q + 4 * BLOCK, 4 * BLOCK);
        PREFETCH(omega + 3 * BLOCK, 3 * BLOCK);
    }
}

/* Write the exact initial state of a motion. */
static void at_initial_state(const torque_free_pi_motion *motion, double *restrict q,
    double *restrict omega)
{
    for (size_t k = 0; k < 4; k++) {
        q[k] = motion->q0[k];
    }
    for (size_t k = 0; k < 3; k++) {
        omega[k] = motion->omega0[k];
    }
}

/* Return the code for times at which a motion has no states. */
static int refusal(const torque_free_pi_motion *motion, int are_finite)
{
    if (!are_finite) {
        return TORQUE_FREE_PI_NOT_FINITE;
    }
    return motion->blurred != 0 ? TORQUE_FREE_PI_SEPARATRIX : TORQUE_FREE_PI_TIME;
}

/* Write n states of NaN. */
static void no_states(size_t n, double *restrict q, double *restrict omega)
{
    for (size_t i = 0; i < 4 * n; i++) {
        q[i] = ((double)NAN);
    }
    for (size_t i = 0; i < 3 * n; i++) {
        omega[i] = ((double)NAN);
    }
}

int torque_free_pi_state_at(const torque_free_pi_motion *motion, double t, double q[4], double omega[3])
{
    double by_time[6];
    double to[7];
    double inner[1];
    double rest[1];
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_PI_UNPREPARED;
    }
    inner[0] = motion->unit * t;
    rest[0] = 0.0;
    if (!(fabs(inner[0]) <= motion->max_angle)) {
        return refusal(motion, isfinite(t));
    }
    if (is_zero(t)) {
        at_initial_state(motion, q, omega);
        return TORQUE_FREE_PI_OK;
    }
    block_angles(motion, 1, 1, inner, rest, by_time);
    block_states(motion, 1, 1, by_time, to, q, omega);
    return TORQUE_FREE_PI_OK;
}

/* Write the states at n times. Late times are refused, or have states of NaN where `lenient`. */
static int unrefused_states(const torque_free_pi_motion *motion, size_t n, const double *restrict t,
    double *restrict q, double *restrict omega, int lenient)
{
    double by_time[6 * BLOCK];
    double to[7 * BLOCK];
    double inner[BLOCK];
    double rest[BLOCK];
    int is_refused = 0;
    if (!lenient) {
        for (size_t i = 0; i < n; i += BLOCK) {
            int near;
            int zero;
            scaled_times(motion, n - i <= BLOCK ? n - i : BLOCK, t + i, inner, &near, &zero);
            if (!near) {
                return refusal(motion, all_finite(n, t));
            }
        }
    }
    for (size_t k = 0; k < BLOCK; k++) {
        rest[k] = 0.0;
    }
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i <= BLOCK ? n - i : BLOCK;
        int near;
        int zero;
        scaled_times(motion, count, t + i, inner, &near, &zero);
        if (!near) {
            is_refused = 1;
            for (size_t k = 0; k < count; k++) {
                inner[k] = fabs(inner[k]) <= motion->max_angle ? inner[k] : 0.0;
            }
        }
        fetch(n - i, q + 4 * i, omega + 3 * i);
        block_angles(motion, count, BLOCK, inner, rest, by_time);
        block_states(motion, count, BLOCK, by_time, to, q + 4 * i, omega + 3 * i);
        if (zero) {
            for (size_t k = 0; k < count; k++) {
                if (is_zero(t[i + k])) {
                    at_initial_state(motion, q + 4 * (i + k), omega + 3 * (i + k));
                }
            }
        }
        if (!near) {
            for (size_t k = 0; k < count; k++) {
                if (!(fabs(motion->unit * t[i + k]) <= motion->max_angle)) {
                    no_states(1, q + 4 * (i + k), omega + 3 * (i + k));
                }
            }
        }
    }
    if (is_refused) {
        return refusal(motion, all_finite(n, t));
    }
    return TORQUE_FREE_PI_OK;
}

int torque_free_pi_states_at(const torque_free_pi_motion *motion, size_t n, const double *t, double *q,
    double *omega)
{
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_PI_UNPREPARED;
    }
    return unrefused_states(motion, n, t, q, omega, 0);
}

/* Write the sines and cosines of a + b. */
static void turned(size_t n, double sin_a, double cos_a, const double *restrict sin_b,
    const double *restrict cos_b, double *restrict sine, double *restrict cosine)
{
    for (size_t i = 0; i < n; i++) {
        sine[i] = fused(sin_a, cos_b[i], cos_a * sin_b[i]);
        cosine[i] = fused(cos_a, cos_b[i], -(sin_a * sin_b[i]));
    }
}

/* Write the sines and cosines of both angles in a block of a grid from t = 0, as from zero. */
static void grid_table(const torque_free_pi_motion *motion, double step, double *restrict table)
{
    double t[BLOCK];
    double t_lo[BLOCK];
    torque_free_pi_motion from_zero;
    from_zero = *motion;
    if (motion->branch == 1) {
        from_zero.of.circular.v_hi = 0.0;
        from_zero.of.circular.v_lo = 0.0;
    }
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
    double t[BLOCK];
    double t_lo[BLOCK];
    for (size_t i = 0; i < n; i++) {
        const double_double time = dd_add_xd(two_product((double)(first + i * every), step), start);
        t[i] = time.hi;
        t_lo[i] = time.lo;
    }
    block_angles(motion, n, BLOCK, t, t_lo, by_time);
}

/* Write n <= BLOCK^2 states from number `first` on. Angles are evaluated once in a block, and
   turned. */
static void grid_states(const torque_free_pi_motion *motion, double start, double step, size_t first,
    size_t n, const double *restrict table, double *restrict q, double *restrict omega)
{
    double base[6 * BLOCK];
    double by_time[4 * BLOCK];
    double to[7 * BLOCK];
    const size_t angles = motion->branch == 0 ? 2 * BLOCK : 4 * BLOCK;
    grid_angles(motion, start, step, first, BLOCK, (n + BLOCK - 1) / BLOCK, base);
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i <= BLOCK ? n - i : BLOCK;
        const size_t k = i / BLOCK;
        fetch(n - i, q + 4 * i, omega + 3 * i);
        for (size_t s = 0; s < angles; s += 2 * BLOCK) {
            turned(count, base[s + k], base[s + BLOCK + k], table + s, table + (s + BLOCK), by_time + s, by_time + (s + BLOCK));
        }
        block_states(motion, count, BLOCK, by_time, to, q + 4 * i, omega + 3 * i);
    }
}

/* Write the states of a grid where angles are more than sines and cosines. */
static void grid_states_one_by_one(const torque_free_pi_motion *motion, double start, double step,
    size_t first, size_t n, double *restrict q, double *restrict omega)
{
    double by_time[6 * BLOCK];
    double to[7 * BLOCK];
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t count = n - i <= BLOCK ? n - i : BLOCK;
        fetch(n - i, q + 4 * i, omega + 3 * i);
        grid_angles(motion, start, step, first + i, 1, count, by_time);
        block_states(motion, count, BLOCK, by_time, to, q + 4 * i, omega + 3 * i);
    }
}

/* Return the index of the first of n samples that is at t = 0, or n. */
static size_t grid_zero(double start, double step, size_t first, size_t n)
{
    const double k = is_zero(step) ? (double)first : nearest(-start / step);
    const double_double t = dd_add_xd(two_product(k, step), start);
    const double place = k - (double)first;
    if (place >= 0.0 && place < (double)n && fabs(t.hi) <= 0.0) {
        return (size_t)place;
    }
    return n;
}

int torque_free_pi_states_on_grid(const torque_free_pi_motion *motion, double start, double step,
    size_t first, size_t n, double *q, double *omega)
{
    double table[6 * BLOCK];
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_PI_UNPREPARED;
    }
    /* Sample number 0 does not depend on the step, however large. */
    const double used = first + n > 1 ? step : 0.0;
    const double inner = motion->unit * start;
    const double inner_step = motion->unit * used;
    const double begin = inner + inner_step * (double)first;
    const double end = inner + inner_step * (double)(n > 0 ? first + n - 1 : first);
    const double last = motion->max_angle;
    if (!(fabs(inner) <= last && fabs(begin) <= last && fabs(end) <= last)) {
        return refusal(motion, isfinite(start) && isfinite(used));
    }
    if (motion->branch >= 1) {
        grid_states_one_by_one(motion, inner, inner_step, first, n, q, omega);
    } else {
        grid_table(motion, inner_step, table);
        for (size_t i = 0; i < n; i += BLOCK * BLOCK) {
            const size_t count = n - i <= BLOCK * BLOCK ? n - i : BLOCK * BLOCK;
            grid_states(motion, inner, inner_step, first + i, count, table, q + 4 * i, omega + 3 * i);
        }
    }
    const size_t every = is_zero(step) ? 1 : n;
    for (size_t i = grid_zero(start, step, first, n); i < n; i += every) {
        at_initial_state(motion, q + 4 * i, omega + 3 * i);
    }
    return TORQUE_FREE_PI_OK;
}

/* Prepare the motions of as many bodies as there are lanes, with codes; return how many. */
static size_t several_init(torque_free_pi_motion *restrict motion, int *restrict code, lanes *lane,
    int rounds_once, size_t bodies, const double *restrict inertia, const double *restrict omega0,
    const double *restrict attitude0)
{
    const size_t count = bodies <= LANES ? bodies : LANES;
    for (size_t i = 0; i < count; i++) {
        code[i] = begin_doubles(&motion[i], lane, i, inertia + 3 * i, omega0 + 3 * i, attitude0 + 4 * i);
        if (code[i] == TORQUE_FREE_PI_OK && !rounds_once) {
            code[i] = TORQUE_FREE_PI_ARITHMETIC;
        }
    }
    moving_init(lane, count, motion, code);
    return count;
}

/* Write the states of one of many bodies; late times have states of NaN where `lenient`. */
static int states_of(const torque_free_pi_motion *motion, size_t n, const double *restrict t,
    double *restrict q, double *restrict omega, int lenient)
{
    if (n != 1) {
        return unrefused_states(motion, n, t, q, omega, lenient);
    }
    const int code = torque_free_pi_state_at(motion, t[0], q, omega);
    if (code != TORQUE_FREE_PI_OK && lenient) {
        no_states(1, q, omega);
    }
    return code;
}

int torque_free_pi_propagate(size_t bodies, const double *inertia, const double *omega0,
    const double *attitude0, size_t n, const double *t, size_t stride, double *q, double *omega,
    int *codes /* or NULL */, size_t *failed)
{
    torque_free_pi_motion motions[LANES];
    int code[LANES];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const int lenient = codes != NULL;
    const int rounds_once = is_rounded_once();
    for (size_t first = 0; first < bodies; first += LANES) {
        const size_t count = several_init(motions, code, &lane, rounds_once, bodies - first, inertia + 3 * first, omega0 + 3 * first, attitude0 + 4 * first);
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            if (code[i] == TORQUE_FREE_PI_OK) {
                code[i] = states_of(&motions[i], n, t + stride * k, q + 4 * n * k, omega + 3 * n * k, lenient);
            } else if (lenient) {
                no_states(n, q + 4 * n * k, omega + 3 * n * k);
            }
            if (codes != NULL) {
                codes[k] = code[i];
            } else if (code[i] != TORQUE_FREE_PI_OK) {
                failed[0] = k;
                return code[i];
            }
        }
    }
    return TORQUE_FREE_PI_OK;
}

double torque_free_pi_last_time(const torque_free_pi_motion *motion)
{
    const double longest = 1.7976931348623157e+308;
    if (motion->prepared != PREPARED) {
        return ((double)NAN);
    }
    if (!(motion->unit > 0.0)) {
        return longest;
    }
    const double last = motion->max_angle / motion->unit;
    return last <= longest ? last : longest;
}

size_t torque_free_pi_motion_size(void)
{
    return sizeof(torque_free_pi_motion);
}

const char *torque_free_pi_message(int code)
{
    return code >= 0 && code < CODES ? MESSAGES[code] : UNKNOWN;
}

const char *torque_free_pi_field(int code)
{
    return code >= 0 && code < CODES ? FIELDS[code] : "";
}

const char *torque_free_pi_rule(int code)
{
    return code >= 0 && code < CODES ? RULES[code] : UNKNOWN;
}

const char *torque_free_pi_digest(void)
{
    return "06f516f1c465f43dcf94dbf5fcc470badf892ad6f5666c64346cf851ce221e9d";
}

