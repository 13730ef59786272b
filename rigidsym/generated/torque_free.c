#include "torque_free.h"
#include "torque_free_arithmetic.h"

/* How many states are computed side by side; each takes about 240 bytes of stack on a grid. */
#ifndef TORQUE_FREE_BLOCK
#define TORQUE_FREE_BLOCK 64
#endif
#define BLOCK ((size_t)TORQUE_FREE_BLOCK)

/* How many motions are prepared side by side, or one in as many lanes: what a register holds, but
   one where roots that report errors keep loops from being vectorised.  What these call has to be
   in them, too, which takes seconds to compile, and is in vain where addresses are checked. */
#ifndef TORQUE_FREE_LANES
#if !defined(__OPTIMIZE__) || !defined(__NO_MATH_ERRNO__)
#define TORQUE_FREE_LANES 1
#elif defined(__AVX512F__)
#define TORQUE_FREE_LANES 8
#elif defined(__AVX__)
#define TORQUE_FREE_LANES 4
#elif defined(__aarch64__)
#define TORQUE_FREE_LANES 2
#else
#define TORQUE_FREE_LANES 1
#endif
#endif
#define LANES TORQUE_FREE_LANES
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
static const double negligible = 3.8725919148493183e-121; /* 2^-400, rates below this share of the largest are taken for zero */
static const double decisive = 8.470329472543003e-22; /* 2^-70, share of a tilt; rates that cause less may be taken for zero */
static const double min_discriminant = 1.1830521861667747e-271; /* 2^-900, E_b in inner units; below it, motions are on the separatrix */
static const double tolerated = 8.673617379884035e-19; /* 2^-60, error of such motions, as a share of the momentum */
static const double min_moment_ratio = 6.223015277861142e-61; /* 2^-200, ratio of two principal moments */
static const double max_circular = 0.5; /* 2^-1, k_1^2 on the circular branch; above it, the hyperbolic one */
static const double max_real = 0.5; /* 2^-1, m for thetas of real elapsed time; above it, of imaginary time */
static const double max_angle = 70368744177664.0; /* 2^46, |omega0 t|, rad */
static const double max_rate = 1.0463951242053392e+298; /* 2^990, a rate, rad/s; exact products with it do not overflow */
enum { CODES = 12 };
static const char UNKNOWN[13] = "no such code";
static const char MESSAGES[CODES][112] = {"success", "every number must be finite", "inertia: principal moments must be positive", "inertia: principal moments differ by more than binary64 can follow", "attitude0: a zero quaternion is no attitude", "t: nearer to the separatrix than binary64 can follow so long", "t: beyond |omega| t = 2^46 rad the angle is lost in binary64", "omega0: rates beyond what binary64 can hold", "arithmetic: sums are reordered or not rounded to nearest", "t: on the way to spin about the middle axis squares of changes leave binary64", "inertia: no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)", "motion: torque_free_motion_init has not made it"};
static const char FIELDS[CODES][11] = {"", "", "inertia", "inertia", "attitude0", "t", "t", "omega0", "arithmetic", "t", "inertia", "motion"};
static const char RULES[CODES][103] = {"success", "every number must be finite", "principal moments must be positive", "principal moments differ by more than binary64 can follow", "a zero quaternion is no attitude", "nearer to the separatrix than binary64 can follow so long", "beyond |omega| t = 2^46 rad the angle is lost in binary64", "rates beyond what binary64 can hold", "sums are reordered or not rounded to nearest", "on the way to spin about the middle axis squares of changes leave binary64", "no body has a principal moment larger than the sum of the other two (-DALLOW_NONPHYSICAL lets it pass)", "torque_free_motion_init has not made it"};
enum { TIMES = 8 }; /* times that `angles_hold` computes */
static const double difference_cases[5] = {0.7260104308260092, 0.48196654854338067, 0.3559016780679596, 0.15335179025447007, 0.03588181116623288}; /* three moments and two rates */
static const double known_cosines[6] = {1.0, 0.5, -0.5, -1.0, -0.5, 0.5}; /* those of multiples of sixty degrees */
enum { PREPARED = 2135587861 };
enum { SENSITIVE = BLOCK < 32 ? BLOCK : 32 }; /* The number of sensitivities computed side by side: each needs about ninety doubles of stack. */
static const double unit_rows[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
static const double no_row[3] = {0.0, 0.0, 0.0};

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
    double k_1_hi[LANES];
    double k_1_lo[LANES];
    double kc_1_hi[LANES];
    double kc_1_lo[LANES];
    double mu_hi[LANES];
    double mu_lo[LANES];
    double psi_0_hi[LANES];
    double psi_0_lo[LANES];
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
    double T4_re_0[LANES];
    double T4_re_1[LANES];
    double T4_re_2[LANES];
    double T4_re_3[LANES];
    double T4_im_0[LANES];
    double T4_im_1[LANES];
    double T4_im_2[LANES];
    double T1_re_0[LANES];
    double T1_re_1[LANES];
    double T1_re_2[LANES];
    double T1_re_3[LANES];
    double T1_im_0[LANES];
    double T1_im_1[LANES];
    double T1_im_2[LANES];
    double T1_im_3[LANES];
    double even_0[LANES];
    double even_1[LANES];
    double even_2[LANES];
    double odd_0[LANES];
    double odd_1[LANES];
    double sine_even_0[LANES];
    double sine_even_1[LANES];
    double sine_even_2[LANES];
    double sine_odd_0[LANES];
    double sine_odd_1[LANES];
    double row_0_P4_re[LANES];
    double row_0_P4_im[LANES];
    double row_0_P1_re[LANES];
    double row_0_P1_im[LANES];
    double row_a_P4_re[LANES];
    double row_a_P4_im[LANES];
    double row_a_P1_re[LANES];
    double row_a_P1_im[LANES];
    double row_b_P4_re[LANES];
    double row_b_P4_im[LANES];
    double row_b_P1_re[LANES];
    double row_b_P1_im[LANES];
    double row_d_P4_re[LANES];
    double row_d_P4_im[LANES];
    double row_d_P1_re[LANES];
    double row_d_P1_im[LANES];
    double gain_a[LANES];
    double gain_b[LANES];
    double gain_d[LANES];
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
    double re_0[LANES];
    double re_1[LANES];
    double re_2[LANES];
    double re_3[LANES];
    double im_0[LANES];
    double im_1[LANES];
    double im_2[LANES];
    double im_3[LANES];
    double nome[LANES];
    double nome2[LANES];
    double nome4[LANES];
    double nome8[LANES];
    double nome12[LANES];
    double row_0_P4_re[LANES];
    double row_0_P4_im[LANES];
    double row_0_P1_re[LANES];
    double row_0_P1_im[LANES];
    double row_a_P4_re[LANES];
    double row_a_P4_im[LANES];
    double row_a_P1_re[LANES];
    double row_a_P1_im[LANES];
    double row_b_P4_re[LANES];
    double row_b_P4_im[LANES];
    double row_b_P1_re[LANES];
    double row_b_P1_im[LANES];
    double row_d_P4_re[LANES];
    double row_d_P4_im[LANES];
    double row_d_P1_re[LANES];
    double row_d_P1_im[LANES];
    double gain_a[LANES];
    double gain_b[LANES];
    double gain_d[LANES];
} hyperbolic_lanes;
/* Sum of non-overlapping doubles, smallest first; 32 hold any value of `discriminant`. */
typedef struct {
    size_t count;
    double part[32];
} exact;
/* The constants of sensitivities; axes are those with p >= r, where rates are constant, too. */
typedef struct {
    torque_free_along along;
    torque_free_columns columns;
    torque_free_turn turn;
    torque_free_real real;
    torque_free_imaginary imaginary;
    int axis[3];
    int is_real;
    int at_rest;
} sensitive;
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
        const double_double common_8 = dd_add_dx(1.0, k_c); /* fact: descended.k_1, descended.mu, definition landen.kc_next; DLMF 22.7.1, DLMF 22.7.2 */
        const double_double k_1 = dd_div_xx(m, dd_mul_xx(common_8, common_8)); /* fact: descended.k_1; DLMF 22.7.1 */
        const double_double mu = dd_div_xd(dd_mul_xx(lambda_, common_8), 2.0); /* fact: descended.mu; DLMF 22.7.2 */
        const double_double common_9 = dd_mul_xx(c_a, A_a); /* fact: descended.psi_0, theta_form.B_a; (33), (34), (27) */
        const double_double psi_0 = dd_div_xx(dd_add_xx(dd_mul_dx(2.0, H), dd_mul_xx(K, A_a)), dd_add_xx(K, common_9)); /* fact: descended.psi_0; (33), (34) */
        const double_double sn = dd_div_xx(dd_mul_dx(chi, Omega_b), A_b); /* fact: regular.sn; (12) */
        const double_double cn = dd_div_xx(dd_mul_dx(chi * tau, Omega_d), A_d); /* fact: regular.cn; (12) */
        const double_double dn = dd_div_xx(dd_mul_dx(sigma, Omega_a), A_a); /* fact: regular.dn; (12) */
        const double_double B_a = common_9; /* fact: theta_form.B_a; (27) */
        const double_double B_d = dd_mul_xx(c_d, A_d); /* fact: theta_form.B_d; (28) */
        const double_double root_kc = dd_sqrt(k_c); /* fact: landen.root_kc; DLMF 22.7.1 */
        const double_double kc_1 = dd_div_xx(dd_mul_dx(2.0, root_kc), common_8); /* fact: definition landen.kc_next; DLMF 22.7.1 */
        const double_double common_10 = dd_add_dx(1.0, dn); /* fact: landen.s_next, landen.v, landen.d_next; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
        const double_double common_11 = dd_mul_xx(common_10, dd_add_dx(1.0, k_1)); /* fact: landen.s_next, landen.v; DLMF 22.7.2 to 22.7.4, DLMF 22.7.4 */
        const double_double s = dd_div_xx(dd_mul_dx(2.0, sn), common_11); /* fact: landen.s_next; DLMF 22.7.2 to 22.7.4 */
        const double_double v = dd_sqrt(dd_mul_xx(common_11, dd_add_xx(k_c, dn))); /* fact: landen.v; DLMF 22.7.4 */
        const double_double c = dd_div_xx(dd_mul_dx(2.0, cn), v); /* fact: landen.c_next; DLMF 22.7.2 to 22.7.4 */
        const double_double d = dd_div_xx(v, common_10); /* fact: landen.d_next; DLMF 22.7.2 to 22.7.4 */
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
        lane->k_1_hi[i] = k_1.hi;
        lane->k_1_lo[i] = k_1.lo;
        lane->kc_1_hi[i] = kc_1.hi;
        lane->kc_1_lo[i] = kc_1.lo;
        lane->mu_hi[i] = mu.hi;
        lane->mu_lo[i] = mu.lo;
        lane->psi_0_hi[i] = psi_0.hi;
        lane->psi_0_lo[i] = psi_0.lo;
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

/* k/sqrt(q) where q is the nome of modulus k, kc its complement, k^2 <= 1/2. */
static double_double root_ratio(double_double k, double_double kc)
{
    const double_double root_kc = dd_sqrt(kc); /* classical: DLMF 19.8.12 */
    const double_double common_1 = dd_add_dx(1.0, kc); /* fact: landen.k_next, definition landen.kc_next; DLMF 22.7.1, DLMF 19.8.12, DLMF 20.9.1 */
    const double_double common_2 = dd_div_xx(k, common_1); /* fact: landen.k_next; DLMF 22.7.1, DLMF 19.8.12 */
    const double_double k_next = dd_mul_xx(common_2, common_2); /* fact: landen.k_next; DLMF 22.7.1, DLMF 19.8.12 */
    const double_double kc_next = dd_div_xx(dd_mul_dx(2.0, root_kc), common_1); /* fact: definition landen.kc_next; DLMF 22.7.1, DLMF 19.8.12 */
    const double_double root = dd_add_dx(1.0, dd_sqrt(kc_next)); /* classical: DLMF 20.9.1 */
    const double_double f = dd_mul_xx(dd_mul_xx(dd_mul_dx(2.0, dd_add_dx(1.0, kc_next)), root), root); /* classical: DLMF 20.9.1 */
    const double_double e = dd_div_xx(dd_mul_xx(k_next, k_next), f); /* classical: DLMF 20.9.1 */
    const double_double e2 = dd_mul_xx(e, e); /* classical: DLMF 20.9.1 */
    const double_double e4 = dd_mul_xx(e2, e2); /* classical: DLMF 20.9.1 */
    const double_double r = dd_div_xx(common_1, dd_sqrt(dd_sqrt(dd_div_xx(dd_add_dx(1.0, dd_mul_xx(e4, dd_add_dx(2.0, dd_mul_xx(e4, dd_add_dx(15.0, dd_mul_xd(e4, 150.0)))))), f)))); /* classical: DLMF 20.9.1 */
    return r;
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

/* The constants of a motion on the circular branch, from `_initial_state`. */
static FLAT void circular_constants(const lanes *restrict lane, circular_lanes *restrict motion)
{
    for (size_t i = 0; i < LANES; i++) {
        const double_double K = {lane->K_hi[i], lane->K_lo[i]};
        const double_double A_a = {lane->A_a_hi[i], lane->A_a_lo[i]};
        const double_double A_b = {lane->A_b_hi[i], lane->A_b_lo[i]};
        const double_double A_d = {lane->A_d_hi[i], lane->A_d_lo[i]};
        const double_double B_a = {lane->B_a_hi[i], lane->B_a_lo[i]};
        const double_double B_d = {lane->B_d_hi[i], lane->B_d_lo[i]};
        const double_double k_1 = {lane->k_1_hi[i], lane->k_1_lo[i]};
        const double_double kc_1 = {lane->kc_1_hi[i], lane->kc_1_lo[i]};
        const double_double mu = {lane->mu_hi[i], lane->mu_lo[i]};
        const double_double psi_0 = {lane->psi_0_hi[i], lane->psi_0_lo[i]};
        const double_double s = {lane->s_hi[i], lane->s_lo[i]};
        const double_double c = {lane->c_hi[i], lane->c_lo[i]};
        const double_double d = {lane->d_hi[i], lane->d_lo[i]};
        const double_double q_0 = {lane->q_0_hi[i], lane->q_0_lo[i]};
        const double_double q_a = {lane->q_a_hi[i], lane->q_a_lo[i]};
        const double_double q_b = {lane->q_b_hi[i], lane->q_b_lo[i]};
        const double_double q_d = {lane->q_d_hi[i], lane->q_d_lo[i]};
        const double epsilon = lane->epsilon[i];
        const double sigma = lane->sigma[i];
        const double rho = lane->rho[i];
        const double chi = lane->chi[i];
        const double unit = lane->unit[i];
        const double_double r = root_ratio(k_1, kc_1); /* classical: DLMF 20.9.1 */
        const double_double root_r = dd_sqrt(r); /* fact: scaling.root_r; (27) */
        const double_double Q = dd_div_xx(k_1, r); /* fact: scaling.Q; (27) */
        const double_double Y = dd_div_xx(B_d, dd_mul_xx(root_r, dd_add_xx(K, B_a))); /* fact: definition scaling.Y; (28) */
        double_double K_1;
        double_double sin_v;
        double_double cos_v;
        double_double Y_b;
        ladder(k_1, kc_1, s, c, d, r, Y, &K_1, &sin_v, &cos_v, &Y_b); /* classical: DLMF 19.8.12 */
        const double_double root_h = dd_sqrt(dd_add_xx(Q, dd_mul_xx(Y_b, Y_b))); /* fact: scaling.root_h; (28) */
        const double_double h_plus = dd_add_xx(Y_b, root_h); /* fact: scaling.h_plus; (28) */
        const double_double h_minus = dd_sub_xx(root_h, Y_b); /* fact: scaling.h_minus; (28) */
        const double_double g = dd_div_xx(pi, dd_mul_dx(2.0, K_1)); /* fact: reading theta_form.g; (10) */
        const double_double up1 = h_plus; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down1 = h_minus; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up1 = dd_mul_xx(h_plus, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down1 = dd_mul_xx(h_minus, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up2 = dd_mul_xx(up1, step_up1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up2 = dd_mul_xx(step_up1, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down2 = dd_mul_xx(down1, step_down1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down2 = dd_mul_xx(step_down1, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up3 = dd_mul_xx(up2, step_up2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up3 = dd_mul_xx(step_up2, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down3 = dd_mul_xx(down2, step_down2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down3 = dd_mul_xx(step_down2, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up4 = dd_mul_xx(up3, step_up3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up4 = dd_mul_xx(step_up3, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down4 = dd_mul_xx(down3, step_down3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down4 = dd_mul_xx(step_down3, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up5 = dd_mul_xx(up4, step_up4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up5 = dd_mul_xx(step_up4, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down5 = dd_mul_xx(down4, step_down4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down5 = dd_mul_xx(step_down4, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up6 = dd_mul_xx(up5, step_up5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up6 = dd_mul_xx(step_up5, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down6 = dd_mul_xx(down5, step_down5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down6 = dd_mul_xx(step_down5, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up7 = dd_mul_xx(up6, step_up6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up7 = dd_mul_xx(step_up6, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down7 = dd_mul_xx(down6, step_down6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down7 = dd_mul_xx(step_down6, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up8 = dd_mul_xx(up7, step_up7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up8 = dd_mul_xx(step_up7, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down8 = dd_mul_xx(down7, step_down7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down8 = dd_mul_xx(step_down7, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up9 = dd_mul_xx(up8, step_up8); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_up9 = dd_mul_xx(step_up8, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down9 = dd_mul_xx(down8, step_down8); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double step_down9 = dd_mul_xx(step_down8, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double up10 = dd_mul_xx(up9, step_up9); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double down10 = dd_mul_xx(down9, step_down9); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p1 = dd_add_xx(up1, down1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d1 = dd_sub_xx(up1, down1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p2 = dd_add_xx(up2, down2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d2 = dd_sub_xx(up2, down2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p3 = dd_add_xx(up3, down3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d3 = dd_sub_xx(up3, down3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p4 = dd_add_xx(up4, down4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d4 = dd_sub_xx(up4, down4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p5 = dd_add_xx(up5, down5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d5 = dd_sub_xx(up5, down5); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p6 = dd_add_xx(up6, down6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d6 = dd_sub_xx(up6, down6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p7 = dd_add_xx(up7, down7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d7 = dd_sub_xx(up7, down7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p8 = dd_add_xx(up8, down8); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d8 = dd_sub_xx(up8, down8); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double p10 = dd_add_xx(up10, down10); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double d10 = dd_sub_xx(up10, down10); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_1 = dd_mul_dx(4.0, d4); /* classical: DLMF 20.2.4, DLMF 20.2.1 */
        const double_double zeta = dd_div_xx(dd_mul_xx(g, dd_add_xx(dd_sub_xx(dd_add_xx(dd_sub_xx(dd_mul_dx(2.0, d2), common_1), dd_mul_dx(6.0, d6)), dd_mul_dx(8.0, d8)), dd_mul_dx(10.0, d10))), dd_sub_xx(dd_add_xx(dd_sub_xx(dd_add_xx(dd_sub_dx(1.0, p2), p4), p6), p8), p10)); /* classical: DLMF 20.2.4 */
        const double_double T4_re_0 = dd_sub_dx(1.0, p4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_re_1 = dd_add_xx(dd_neg(p2), dd_mul_dx(3.0, p6)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_re_2 = dd_mul_dx(2.0, p4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_re_3 = dd_mul_dx(-4.0, p6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_im_0 = dd_mul_dx(rho, dd_add_xx(dd_mul_dx(-2.0, d2), dd_mul_dx(2.0, d6))); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_im_1 = dd_mul_dx(rho, common_1); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_im_2 = dd_mul_dx(rho, dd_mul_dx(-8.0, d6)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_re_0 = dd_add_xx(dd_sub_xx(dd_sub_xx(p1, p3), p5), p7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_2 = dd_mul_dx(4.0, p7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_re_1 = dd_add_xx(dd_add_xx(dd_mul_dx(-2.0, p3), dd_mul_dx(2.0, p5)), common_2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_re_2 = dd_sub_xx(dd_mul_dx(4.0, p5), common_2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_re_3 = dd_mul_dx(-8.0, p7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_im_0 = dd_mul_dx(rho, dd_add_xx(dd_add_xx(dd_sub_xx(dd_neg(d1), d3), d5), d7)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_3 = dd_mul_dx(4.0, d7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_im_1 = dd_mul_dx(rho, dd_sub_xx(dd_add_xx(dd_mul_dx(2.0, d3), dd_mul_dx(2.0, d5)), common_3)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_im_2 = dd_mul_dx(rho, dd_sub_xx(dd_mul_dx(-4.0, d5), common_3)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T1_im_3 = dd_mul_dx(rho, dd_mul_dx(8.0, d7)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double Q2 = dd_mul_xx(Q, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double Q4 = dd_mul_xx(Q2, Q2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double Q6 = dd_mul_xx(Q4, Q2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_4 = dd_mul_xx(Q4, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.7.14 */
        const double_double Q9 = dd_mul_xx(common_4, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double Q12 = dd_mul_xx(Q6, Q6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double Q16 = dd_mul_xx(Q12, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double Q20 = dd_mul_xx(Q16, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_5 = dd_mul_dx(2.0, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
        const double_double common_6 = dd_mul_dx(2.0, Q16); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
        const double_double even_0 = dd_add_xx(dd_sub_dx(1.0, common_5), common_6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_7 = dd_mul_dx(16.0, Q16); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double even_1 = dd_sub_xx(dd_mul_dx(4.0, Q4), common_7); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double even_2 = common_7; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_8 = dd_mul_dx(2.0, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
        const double_double odd_0 = dd_sub_xx(common_8, dd_mul_dx(6.0, Q9)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double odd_1 = dd_mul_dx(8.0, Q9); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double sine_even_0 = dd_add_xx(dd_add_xx(dd_sub_xx(dd_sub_dx(1.0, Q2), Q6), Q12), Q20); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double common_9 = dd_mul_dx(4.0, Q12); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double sine_even_1 = dd_sub_xx(dd_sub_xx(dd_mul_dx(4.0, Q6), common_9), dd_mul_dx(12.0, Q20)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double sine_even_2 = dd_mul_dx(16.0, Q20); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double sine_odd_0 = dd_sub_xx(dd_add_xx(dd_add_xx(dd_mul_dx(-2.0, Q2), dd_mul_dx(2.0, Q6)), common_9), dd_mul_dx(4.0, Q20)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double sine_odd_1 = dd_add_xx(dd_mul_dx(-8.0, Q12), dd_mul_dx(8.0, Q20)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double two = dd_add_xx(dd_add_xx(dd_add_xx(dd_add_dx(1.0, Q2), Q6), Q12), Q20); /* classical: DLMF 20.2.2 */
        const double_double even_sum = dd_add_xx(dd_add_dx(1.0, common_5), common_6); /* classical: DLMF 20.2.3 */
        const double_double common_10 = dd_mul_dx(2.0, Q9); /* classical: DLMF 20.2.3 */
        const double_double odd_sum = dd_add_xx(dd_add_xx(common_8, common_10), dd_mul_xx(common_10, Q16)); /* classical: DLMF 20.2.3 */
        const double_double three = dd_add_xx(even_sum, odd_sum); /* classical: DLMF 20.2.3 */
        const double_double four = dd_sub_xx(even_sum, odd_sum); /* classical: DLMF 20.2.4 */
        const double_double h2_plus = dd_mul_xx(h_plus, h_plus); /* classical: DLMF 20.7.14 */
        const double_double h2_minus = dd_mul_xx(h_minus, h_minus); /* classical: DLMF 20.7.14 */
        const double_double side_plus = dd_mul_xx(h2_plus, dd_add_dx(1.0, dd_mul_xx(dd_mul_xx(Q2, h2_plus), dd_add_dx(1.0, dd_mul_xx(dd_mul_xx(Q4, h2_plus), dd_add_dx(1.0, dd_mul_xx(dd_mul_xx(Q6, h2_plus), dd_add_dx(1.0, dd_mul_xx(common_4, h2_plus))))))))); /* classical: DLMF 20.7.14 */
        const double_double side_minus = dd_mul_xx(h2_minus, dd_add_dx(1.0, dd_mul_xx(dd_mul_xx(Q2, h2_minus), dd_add_dx(1.0, dd_mul_xx(dd_mul_xx(Q4, h2_minus), dd_add_dx(1.0, dd_mul_xx(dd_mul_xx(Q6, h2_minus), dd_add_dx(1.0, dd_mul_xx(common_4, h2_minus))))))))); /* classical: DLMF 20.7.14 */
        const double_double watson = dd_add_xx(dd_add_dx(1.0, side_plus), side_minus); /* classical: DLMF 20.7.14 */
        const double_double Lambda = dd_add_xx(dd_div_xd(psi_0, 2.0), dd_mul_xx(dd_mul_dx(rho, mu), zeta)); /* fact: definition theta_form.Lambda; (33), (34) */
        const double_double Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
        const double_double v = half_turns(sin_v, cos_v); /* classical: DLMF 4.24.3 */
        const double_double v_rate = dd_div_xx(dd_mul_xx(mu, g), pi); /* arithmetic */
        const double_double x = dd_sub_dx(1.0, dd_mul_dx(2.0, dd_mul_xx(sin_v, sin_v))); /* classical: DLMF 4.21.27 */
        const double_double x2 = dd_mul_xx(x, x); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double_double T4_re = dd_add_xx(T4_re_0, dd_mul_xx(x, dd_add_xx(T4_re_1, dd_mul_xx(x, dd_add_xx(T4_re_2, dd_mul_xx(x, T4_re_3)))))); /* classical: DLMF 20.2.4 */
        const double_double T4_im = dd_mul_xx(dd_mul_xx(sin_v, cos_v), dd_add_xx(T4_im_0, dd_mul_xx(x, dd_add_xx(T4_im_1, dd_mul_xx(x, T4_im_2))))); /* classical: DLMF 20.2.4 */
        const double_double T1_re = dd_mul_xx(sin_v, dd_add_xx(T1_re_0, dd_mul_xx(x, dd_add_xx(T1_re_1, dd_mul_xx(x, dd_add_xx(T1_re_2, dd_mul_xx(x, T1_re_3))))))); /* classical: DLMF 20.2.1 */
        const double_double T1_im = dd_mul_xx(cos_v, dd_add_xx(T1_im_0, dd_mul_xx(x, dd_add_xx(T1_im_1, dd_mul_xx(x, dd_add_xx(T1_im_2, dd_mul_xx(x, T1_im_3))))))); /* classical: DLMF 20.2.1 */
        const double_double sum_even = dd_add_xx(even_0, dd_mul_xx(x2, dd_add_xx(even_1, dd_mul_xx(x2, even_2)))); /* classical: DLMF 20.2.4 */
        const double_double sum_odd = dd_mul_xx(x, dd_add_xx(odd_0, dd_mul_xx(x2, odd_1))); /* classical: DLMF 20.2.4 */
        const double_double theta4_v = dd_sub_xx(sum_even, sum_odd); /* classical: DLMF 20.2.4 */
        const double_double P4_re = T4_re; /* fact: definition theta_form.P4_re; (18) */
        const double_double P4_im = T4_im; /* fact: definition theta_form.P4_im; (18) */
        const double_double P1_re = T1_re; /* fact: definition theta_form.P1_re; (18) */
        const double_double P1_im = T1_im; /* fact: definition theta_form.P1_im; (18) */
        const double_double W = dd_mul_xx(theta4_v, watson); /* fact: reading theta_form.W; (1) */
        const double_double N = dd_sqrt(W); /* fact: theta_form.N_of_W; (1) */
        const double_double qbar_0 = dd_div_xx(P4_re, N); /* fact: theta_form.qbar_0; (18), (25) */
        const double_double qbar_a = dd_div_xx(dd_mul_dx(sigma, P4_im), N); /* fact: theta_form.qbar_a; (18), (25) */
        const double_double qbar_b = dd_div_xx(dd_mul_dx(chi, P1_im), N); /* fact: theta_form.qbar_b; (18), (25) */
        const double common_11 = -epsilon * sigma * chi; /* fact: theta_form.qbar_d, definition attitude.q_0, definition attitude.q_a, definition attitude.q_b, definition attitude.q_d; (18), (25), (37) */
        const double_double qbar_d = dd_div_xx(dd_mul_dx(common_11, P1_re), N); /* fact: theta_form.qbar_d; (18), (25) */
        const double_double p_0 = dd_add_xx(dd_add_xx(dd_add_xx(dd_mul_xx(q_0, qbar_0), dd_mul_xx(q_a, qbar_a)), dd_mul_xx(q_b, qbar_b)), dd_mul_xx(q_d, qbar_d)); /* fact: attitude.p_0; (37) */
        const double_double p_a = dd_add_xx(dd_sub_xx(dd_mul_xx(q_a, qbar_0), dd_mul_xx(q_0, qbar_a)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_d, qbar_b), dd_mul_xx(q_b, qbar_d)))); /* fact: attitude.p_a; (37) */
        const double_double p_b = dd_add_xx(dd_sub_xx(dd_mul_xx(q_b, qbar_0), dd_mul_xx(q_0, qbar_b)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_a, qbar_d), dd_mul_xx(q_d, qbar_a)))); /* fact: attitude.p_b; (37) */
        const double_double p_d = dd_add_xx(dd_sub_xx(dd_mul_xx(q_d, qbar_0), dd_mul_xx(q_0, qbar_d)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_b, qbar_a), dd_mul_xx(q_a, qbar_b)))); /* fact: attitude.p_d; (37) */
        const double_double over_N = dd_div_dx(1.0, dd_sqrt(watson)); /* classical: DLMF 20.7.14 */
        const double_double row_0_P4_re = dd_mul_xx(over_N, p_0); /* fact: definition attitude.q_0; (37) */
        const double_double row_0_P4_im = dd_mul_xx(over_N, dd_neg(dd_mul_xd(p_a, sigma))); /* fact: definition attitude.q_0; (37) */
        const double_double row_0_P1_re = dd_mul_xx(over_N, dd_neg(dd_mul_xd(p_d, common_11))); /* fact: definition attitude.q_0; (37) */
        const double_double row_0_P1_im = dd_mul_xx(over_N, dd_neg(dd_mul_xd(p_b, chi))); /* fact: definition attitude.q_0; (37) */
        const double_double row_a_P4_re = dd_mul_xx(over_N, p_a); /* fact: definition attitude.q_a; (37) */
        const double_double row_a_P4_im = dd_mul_xx(over_N, dd_mul_xd(p_0, sigma)); /* fact: definition attitude.q_a; (37) */
        const double_double row_a_P1_re = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_mul_xd(p_b, common_11))); /* fact: definition attitude.q_a; (37) */
        const double_double row_a_P1_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_neg(dd_mul_xd(p_d, chi)))); /* fact: definition attitude.q_a; (37) */
        const double_double row_b_P4_re = dd_mul_xx(over_N, p_b); /* fact: definition attitude.q_b; (37) */
        const double_double row_b_P4_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_mul_xd(p_d, sigma))); /* fact: definition attitude.q_b; (37) */
        const double_double row_b_P1_re = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_neg(dd_mul_xd(p_a, common_11)))); /* fact: definition attitude.q_b; (37) */
        const double_double row_b_P1_im = dd_mul_xx(over_N, dd_mul_xd(p_0, chi)); /* fact: definition attitude.q_b; (37) */
        const double_double row_d_P4_re = dd_mul_xx(over_N, p_d); /* fact: definition attitude.q_d; (37) */
        const double_double row_d_P4_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_neg(dd_mul_xd(p_b, sigma)))); /* fact: definition attitude.q_d; (37) */
        const double_double row_d_P1_re = dd_mul_xx(over_N, dd_mul_xd(p_0, common_11)); /* fact: definition attitude.q_d; (37) */
        const double_double row_d_P1_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_mul_xd(p_a, chi))); /* fact: definition attitude.q_d; (37) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double_double gain_a = dd_mul_xd(dd_mul_xx(dd_mul_dx(sigma, A_a), dd_div_xx(four, three)), unit); /* fact: definition regular.Omega_a; (10), DLMF 22.2.4 */
        const double_double gain_b = dd_mul_xd(dd_mul_xx(dd_mul_dx(chi, A_b), dd_div_xx(three, two)), unit); /* fact: definition regular.Omega_b; (10), DLMF 22.2.4 */
        const double_double gain_d = dd_mul_xd(dd_mul_xx(dd_mul_dx(chi * tau, A_d), dd_div_xx(four, two)), unit); /* fact: definition regular.Omega_d; (10), DLMF 22.2.4 */
        motion->v_rate_hi[i] = v_rate.hi;
        motion->v_rate_lo[i] = v_rate.lo;
        motion->v_hi[i] = v.hi;
        motion->v_lo[i] = v.lo;
        motion->Lambda_rate_hi[i] = Lambda_rate.hi;
        motion->Lambda_rate_lo[i] = Lambda_rate.lo;
        motion->T4_re_0[i] = dd_rounded(T4_re_0);
        motion->T4_re_1[i] = dd_rounded(T4_re_1);
        motion->T4_re_2[i] = dd_rounded(T4_re_2);
        motion->T4_re_3[i] = dd_rounded(T4_re_3);
        motion->T4_im_0[i] = dd_rounded(T4_im_0);
        motion->T4_im_1[i] = dd_rounded(T4_im_1);
        motion->T4_im_2[i] = dd_rounded(T4_im_2);
        motion->T1_re_0[i] = dd_rounded(T1_re_0);
        motion->T1_re_1[i] = dd_rounded(T1_re_1);
        motion->T1_re_2[i] = dd_rounded(T1_re_2);
        motion->T1_re_3[i] = dd_rounded(T1_re_3);
        motion->T1_im_0[i] = dd_rounded(T1_im_0);
        motion->T1_im_1[i] = dd_rounded(T1_im_1);
        motion->T1_im_2[i] = dd_rounded(T1_im_2);
        motion->T1_im_3[i] = dd_rounded(T1_im_3);
        motion->even_0[i] = dd_rounded(even_0);
        motion->even_1[i] = dd_rounded(even_1);
        motion->even_2[i] = dd_rounded(even_2);
        motion->odd_0[i] = dd_rounded(odd_0);
        motion->odd_1[i] = dd_rounded(odd_1);
        motion->sine_even_0[i] = dd_rounded(sine_even_0);
        motion->sine_even_1[i] = dd_rounded(sine_even_1);
        motion->sine_even_2[i] = dd_rounded(sine_even_2);
        motion->sine_odd_0[i] = dd_rounded(sine_odd_0);
        motion->sine_odd_1[i] = dd_rounded(sine_odd_1);
        motion->row_0_P4_re[i] = dd_rounded(row_0_P4_re);
        motion->row_0_P4_im[i] = dd_rounded(row_0_P4_im);
        motion->row_0_P1_re[i] = dd_rounded(row_0_P1_re);
        motion->row_0_P1_im[i] = dd_rounded(row_0_P1_im);
        motion->row_a_P4_re[i] = dd_rounded(row_a_P4_re);
        motion->row_a_P4_im[i] = dd_rounded(row_a_P4_im);
        motion->row_a_P1_re[i] = dd_rounded(row_a_P1_re);
        motion->row_a_P1_im[i] = dd_rounded(row_a_P1_im);
        motion->row_b_P4_re[i] = dd_rounded(row_b_P4_re);
        motion->row_b_P4_im[i] = dd_rounded(row_b_P4_im);
        motion->row_b_P1_re[i] = dd_rounded(row_b_P1_re);
        motion->row_b_P1_im[i] = dd_rounded(row_b_P1_im);
        motion->row_d_P4_re[i] = dd_rounded(row_d_P4_re);
        motion->row_d_P4_im[i] = dd_rounded(row_d_P4_im);
        motion->row_d_P1_re[i] = dd_rounded(row_d_P1_re);
        motion->row_d_P1_im[i] = dd_rounded(row_d_P1_im);
        motion->gain_a[i] = dd_rounded(gain_a);
        motion->gain_b[i] = dd_rounded(gain_b);
        motion->gain_d[i] = dd_rounded(gain_d);
    }
}

/* Angles of the circular branch at t + t_lo. */
static void circular_angles(const torque_free_circular *motion, size_t n,
    const double *restrict t_in, const double *restrict t_lo_in, double *restrict sin_v_out,
    double *restrict cos_v_out, double *restrict X_im_out, double *restrict X_re_out)
{
    const double v_rate_hi = motion->v_rate_hi;
    const double v_rate_lo = motion->v_rate_lo;
    const double v_hi = motion->v_hi;
    const double v_lo = motion->v_lo;
    const double Lambda_rate_hi = motion->Lambda_rate_hi;
    const double Lambda_rate_lo = motion->Lambda_rate_lo;
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
        const double v_square = v_turns * v_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double v_sign = alternating(v_whole); /* classical: DLMF 4.16 */
        const double sin_v = v_sign * fused(v_turns, pi_hi, v_turns * fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double cos_v = v_sign * fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, fused(v_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        const double L = Lambda_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double L_error = product_error(Lambda_rate_hi, t, L) + fused(Lambda_rate_lo, t, Lambda_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
        const double L_whole = nearest(L); /* classical: DLMF 4.16 */
        const double L_rest = L - L_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double L_turns = L_rest + L_error; /* classical: DLMF 4.16 */
        const double L_square = L_turns * L_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double L_sign = alternating(L_whole); /* classical: DLMF 4.16 */
        const double X_im = L_sign * fused(L_turns, pi_hi, L_turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        sin_v_out[i] = sin_v;
        cos_v_out[i] = cos_v;
        X_im_out[i] = X_im;
        X_re_out[i] = X_re;
    }
}

/* The state on the circular branch, from `_circular_angles`. */
static void circular_state(const torque_free_circular *motion, size_t n,
    const double *restrict sin_v_in, const double *restrict cos_v_in,
    const double *restrict X_im_in, const double *restrict X_re_in, double *restrict q_0_out,
    double *restrict q_a_out, double *restrict q_b_out, double *restrict q_d_out,
    double *restrict Omega_a_out, double *restrict Omega_b_out, double *restrict Omega_d_out)
{
    const double T4_re_0 = motion->T4_re_0;
    const double T4_re_1 = motion->T4_re_1;
    const double T4_re_2 = motion->T4_re_2;
    const double T4_re_3 = motion->T4_re_3;
    const double T4_im_0 = motion->T4_im_0;
    const double T4_im_1 = motion->T4_im_1;
    const double T4_im_2 = motion->T4_im_2;
    const double T1_re_0 = motion->T1_re_0;
    const double T1_re_1 = motion->T1_re_1;
    const double T1_re_2 = motion->T1_re_2;
    const double T1_re_3 = motion->T1_re_3;
    const double T1_im_0 = motion->T1_im_0;
    const double T1_im_1 = motion->T1_im_1;
    const double T1_im_2 = motion->T1_im_2;
    const double T1_im_3 = motion->T1_im_3;
    const double even_0 = motion->even_0;
    const double even_1 = motion->even_1;
    const double even_2 = motion->even_2;
    const double odd_0 = motion->odd_0;
    const double odd_1 = motion->odd_1;
    const double sine_even_0 = motion->sine_even_0;
    const double sine_even_1 = motion->sine_even_1;
    const double sine_even_2 = motion->sine_even_2;
    const double sine_odd_0 = motion->sine_odd_0;
    const double sine_odd_1 = motion->sine_odd_1;
    const double row_0_P4_re = motion->row_0_P4_re;
    const double row_0_P4_im = motion->row_0_P4_im;
    const double row_0_P1_re = motion->row_0_P1_re;
    const double row_0_P1_im = motion->row_0_P1_im;
    const double row_a_P4_re = motion->row_a_P4_re;
    const double row_a_P4_im = motion->row_a_P4_im;
    const double row_a_P1_re = motion->row_a_P1_re;
    const double row_a_P1_im = motion->row_a_P1_im;
    const double row_b_P4_re = motion->row_b_P4_re;
    const double row_b_P4_im = motion->row_b_P4_im;
    const double row_b_P1_re = motion->row_b_P1_re;
    const double row_b_P1_im = motion->row_b_P1_im;
    const double row_d_P4_re = motion->row_d_P4_re;
    const double row_d_P4_im = motion->row_d_P4_im;
    const double row_d_P1_re = motion->row_d_P1_re;
    const double row_d_P1_im = motion->row_d_P1_im;
    const double gain_a = motion->gain_a;
    const double gain_b = motion->gain_b;
    const double gain_d = motion->gain_d;
    for (size_t i = 0; i < n; i++) {
        const double sin_v = sin_v_in[i];
        const double cos_v = cos_v_in[i];
        const double X_im = X_im_in[i];
        const double X_re = X_re_in[i];
        const double x = fused(-2.0, sin_v * sin_v, 1.0); /* classical: DLMF 4.21.27 */
        const double x2 = x * x; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double T4_re = fused(x, fused(x, fused(x, T4_re_3, T4_re_2), T4_re_1), T4_re_0); /* classical: DLMF 20.2.4 */
        const double T4_im = sin_v * cos_v * fused(x, fused(x, T4_im_2, T4_im_1), T4_im_0); /* classical: DLMF 20.2.4 */
        const double T1_re = sin_v * fused(x, fused(x, fused(x, T1_re_3, T1_re_2), T1_re_1), T1_re_0); /* classical: DLMF 20.2.1 */
        const double T1_im = cos_v * fused(x, fused(x, fused(x, T1_im_3, T1_im_2), T1_im_1), T1_im_0); /* classical: DLMF 20.2.1 */
        const double sum_even = fused(x2, fused(x2, even_2, even_1), even_0); /* classical: DLMF 20.2.4 */
        const double sum_odd = x * fused(x2, odd_1, odd_0); /* classical: DLMF 20.2.4 */
        const double theta4_v = sum_even - sum_odd; /* classical: DLMF 20.2.4 */
        const double theta3_v = sum_even + sum_odd; /* classical: DLMF 20.2.3 */
        const double part_even = fused(x2, fused(x2, sine_even_2, sine_even_1), sine_even_0); /* classical: DLMF 20.2.1 */
        const double part_odd = x * fused(x2, sine_odd_1, sine_odd_0); /* classical: DLMF 20.2.1 */
        const double theta1_v = sin_v * (part_even + part_odd); /* classical: DLMF 20.2.1 */
        const double theta2_v = cos_v * (part_even - part_odd); /* classical: DLMF 20.2.2 */
        const double P4_re = fused(X_re, T4_re, -(X_im * T4_im)); /* fact: definition theta_form.P4_re; (18) */
        const double P4_im = fused(X_re, T4_im, X_im * T4_re); /* fact: definition theta_form.P4_im; (18) */
        const double P1_re = fused(X_re, T1_re, -(X_im * T1_im)); /* fact: definition theta_form.P1_re; (18) */
        const double P1_im = fused(X_re, T1_im, X_im * T1_re); /* fact: definition theta_form.P1_im; (18) */
        const double over = 1.0 / theta4_v; /* arithmetic */
        const double scale = sqrt(over); /* arithmetic */
        const double q_0 = scale * fused(row_0_P4_re, P4_re, fused(row_0_P4_im, P4_im, fused(row_0_P1_re, P1_re, row_0_P1_im * P1_im))); /* fact: definition attitude.q_0; (37) */
        const double q_a = scale * fused(row_a_P4_re, P4_re, fused(row_a_P4_im, P4_im, fused(row_a_P1_re, P1_re, row_a_P1_im * P1_im))); /* fact: definition attitude.q_a; (37) */
        const double q_b = scale * fused(row_b_P4_re, P4_re, fused(row_b_P4_im, P4_im, fused(row_b_P1_re, P1_re, row_b_P1_im * P1_im))); /* fact: definition attitude.q_b; (37) */
        const double q_d = scale * fused(row_d_P4_re, P4_re, fused(row_d_P4_im, P4_im, fused(row_d_P1_re, P1_re, row_d_P1_im * P1_im))); /* fact: definition attitude.q_d; (37) */
        const double Omega_a = gain_a * (theta3_v * over); /* fact: definition regular.Omega_a; (10) */
        const double Omega_b = gain_b * (theta1_v * over); /* fact: definition regular.Omega_b; (10) */
        const double Omega_d = gain_d * (theta2_v * over); /* fact: definition regular.Omega_d; (10) */
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
        const double_double k_1 = {lane->k_1_hi[i], lane->k_1_lo[i]};
        const double_double kc_1 = {lane->kc_1_hi[i], lane->kc_1_lo[i]};
        const double_double mu = {lane->mu_hi[i], lane->mu_lo[i]};
        const double_double psi_0 = {lane->psi_0_hi[i], lane->psi_0_lo[i]};
        const double_double s = {lane->s_hi[i], lane->s_lo[i]};
        const double_double c = {lane->c_hi[i], lane->c_lo[i]};
        const double_double q_0 = {lane->q_0_hi[i], lane->q_0_lo[i]};
        const double_double q_a = {lane->q_a_hi[i], lane->q_a_lo[i]};
        const double_double q_b = {lane->q_b_hi[i], lane->q_b_lo[i]};
        const double_double q_d = {lane->q_d_hi[i], lane->q_d_lo[i]};
        const double epsilon = lane->epsilon[i];
        const double sigma = lane->sigma[i];
        const double rho = lane->rho[i];
        const double chi = lane->chi[i];
        const double unit = lane->unit[i];
        const double_double root_k = dd_sqrt(k_1); /* fact: theta_form.root_k; (27) */
        const double_double x = dd_div_xx(B_d, dd_mul_xx(root_k, dd_add_xx(K, B_a))); /* fact: definition theta_form.x; (28) */
        const double_double y = dd_sqrt(dd_add_dx(1.0, dd_mul_xx(x, x))); /* fact: theta_form.y; DLMF 22.6.1 */
        const double_double common_1 = dd_mul_xx(k_1, x); /* fact: theta_form.z; DLMF 22.6.1 */
        const double_double z = dd_sqrt(dd_add_dx(1.0, dd_mul_xx(common_1, common_1))); /* fact: theta_form.z; DLMF 22.6.1 */
        const double_double s_beta = dd_div_xx(x, y); /* fact: definition theta_form.s_beta; DLMF 22.6.1 */
        const double_double c_beta = dd_div_dx(1.0, y); /* fact: definition theta_form.c_beta; DLMF 22.6.1 */
        const double_double d_beta = dd_div_xx(z, y); /* fact: definition theta_form.d_beta; DLMF 22.6.1 */
        const double_double r = root_ratio(kc_1, k_1); /* classical: DLMF 20.9.1 */
        const double_double root_nome = dd_div_xx(kc_1, r); /* classical: DLMF 20.9.1 */
        const double_double nome = dd_mul_xx(root_nome, root_nome); /* classical: DLMF 20.9.1 */
        const double_double size_s = dd_size(s); /* classical: DLMF 22.4.3 */
        const double near = dd_rounded(dd_mul_xx(c, c)); /* classical: DLMF 22.4.3 */
        const double far = dd_rounded(dd_mul_xx(kc_1, dd_mul_xx(s, s))); /* classical: DLMF 22.4.3 */
        const double_double above = dd_choose(far, near, size_s, c); /* classical: DLMF 22.4.3 */
        const double_double below = dd_choose(far, near, c, dd_mul_xx(kc_1, size_s)); /* classical: DLMF 22.4.3 */
        const double_double xi = dd_div_xx(above, below); /* classical: DLMF 22.6.7 */
        double_double K_c;
        double_double sin_a;
        double_double cos_a;
        double_double Y_b;
        ladder(kc_1, k_1, s_beta, c_beta, d_beta, kc_1, xi, &K_c, &sin_a, &cos_a, &Y_b); /* classical: DLMF 19.8.12 */
        const double_double gc = dd_div_xx(pi, dd_mul_dx(2.0, K_c)); /* fact: reading hyperbolic_form.gc; (10) */
        const double_double nome2 = dd_mul_xx(nome, nome); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double nome4 = dd_mul_xx(nome2, nome2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double nome6 = dd_mul_xx(nome4, nome2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double nome8 = dd_mul_xx(nome4, nome4); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double nome12 = dd_mul_xx(nome8, nome4); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double nome20 = dd_mul_xx(nome12, nome8); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double nome30 = dd_mul_xx(dd_mul_xx(nome20, nome8), nome2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double C_0 = cos_a; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double S_0 = sin_a; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double turn = dd_mul_dx(2.0, dd_sub_dx(1.0, dd_mul_dx(2.0, dd_mul_xx(sin_a, sin_a)))); /* classical: DLMF 4.21.27 */
        const double_double C_1 = dd_mul_xx(dd_sub_xd(turn, 1.0), C_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double S_1 = dd_mul_xx(dd_add_xd(turn, 1.0), S_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double C_2 = dd_sub_xx(dd_mul_xx(turn, C_1), C_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double S_2 = dd_sub_xx(dd_mul_xx(turn, S_1), S_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double C_3 = dd_sub_xx(dd_mul_xx(turn, C_2), C_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double S_3 = dd_sub_xx(dd_mul_xx(turn, S_2), S_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double C_4 = dd_sub_xx(dd_mul_xx(turn, C_3), C_2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double S_4 = dd_sub_xx(dd_mul_xx(turn, S_3), S_2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double C_5 = dd_sub_xx(dd_mul_xx(turn, C_4), C_3); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double S_5 = dd_sub_xx(dd_mul_xx(turn, S_4), S_3); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double zeta = dd_div_xx(dd_mul_xx(gc, dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(S_0, dd_mul_xx(dd_mul_dx(3.0, nome2), S_1)), dd_mul_xx(dd_mul_dx(5.0, nome6), S_2)), dd_mul_xx(dd_mul_dx(7.0, nome12), S_3)), dd_mul_xx(dd_mul_dx(9.0, nome20), S_4)), dd_mul_xx(dd_mul_dx(11.0, nome30), S_5))), dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(dd_add_xx(C_0, dd_mul_xx(nome2, C_1)), dd_mul_xx(nome6, C_2)), dd_mul_xx(nome12, C_3)), dd_mul_xx(nome20, C_4)), dd_mul_xx(nome30, C_5))); /* classical: DLMF 20.2.2 */
        const double_double re_0 = C_0; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double im_0 = dd_neg(dd_mul_dx(rho, S_0)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double re_1 = dd_mul_xx(nome, C_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double im_1 = dd_neg(dd_mul_xx(dd_mul_dx(rho, nome), S_1)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double re_2 = dd_mul_xx(nome4, C_2); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double im_2 = dd_neg(dd_mul_xx(dd_mul_dx(rho, nome4), S_2)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double re_3 = dd_mul_xx(dd_mul_xx(nome8, nome), C_3); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double im_3 = dd_neg(dd_mul_xx(dd_mul_xx(dd_mul_dx(rho, nome8), nome), S_3)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double two = dd_add_xx(dd_add_dx(1.0, nome4), nome12); /* classical: DLMF 20.2.2 */
        const double_double common_2 = dd_mul_dx(2.0, nome2); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
        const double_double common_3 = dd_mul_dx(2.0, nome8); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
        const double_double common_4 = dd_mul_xx(nome12, nome6); /* classical: DLMF 20.2.3, DLMF 20.2.4, DLMF 20.7.14 */
        const double_double common_5 = dd_mul_dx(2.0, common_4); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
        const double_double three = dd_add_xx(dd_add_xx(dd_add_dx(1.0, common_2), common_3), common_5); /* classical: DLMF 20.2.3 */
        const double_double four = dd_sub_xx(dd_add_xx(dd_sub_dx(1.0, common_2), common_3), common_5); /* classical: DLMF 20.2.4 */
        const double_double twice = dd_sub_xd(dd_mul_xx(turn, turn), 2.0); /* classical: DLMF 4.21.27 */
        const double_double twice2 = dd_sub_xd(dd_mul_xx(twice, twice), 2.0); /* classical: DLMF 4.21.27 */
        const double_double twice3 = dd_sub_xx(dd_mul_xx(twice, twice2), twice); /* classical: DLMF 4.21.27 */
        const double_double watson = dd_add_xx(dd_add_xx(dd_add_dx(1.0, dd_mul_xx(nome2, twice)), dd_mul_xx(nome8, twice2)), dd_mul_xx(common_4, twice3)); /* classical: DLMF 20.7.14 */
        const double_double Lambda = dd_add_xx(dd_div_xd(psi_0, 2.0), dd_mul_xx(dd_mul_dx(rho, mu), zeta)); /* fact: definition theta_form.Lambda; (33), (34) */
        const double_double Lambda_rate = dd_div_xx(Lambda, pi); /* arithmetic */
        const double nome_d = dd_rounded(nome); /* classical: DLMF 20.2.2 */
        const double_double period = dd_neg(logarithm(dd_choose(nome_d, 0.0, dd_of(1.0), nome))); /* classical: DLMF 20.2.2 */
        const double period_far = choose(nome_d, 0.0, never, dd_rounded(period)); /* classical: DLMF 20.2.7 */
        const double period_d = dd_rounded(dd_choose(nome_d, 0.0, dd_of(1.0), period)); /* classical: DLMF 20.2.7 */
        const double period_inverse = choose(nome_d, 0.0, 0.0, 1.0 / period_d); /* classical: DLMF 20.2.7 */
        const double_double cosh_y = dd_sqrt(dd_add_dx(1.0, dd_mul_xx(Y_b, Y_b))); /* classical: DLMF 4.35.11 */
        const double_double common_6 = dd_add_xx(Y_b, cosh_y); /* classical: DLMF 4.37.16 */
        const double_double y_b = logarithm(common_6); /* classical: DLMF 4.37.16 */
        const double_double y_size = dd_choose(far, near, y_b, dd_sub_xx(dd_div_xd(period, 2.0), y_b)); /* classical: DLMF 22.4.3 */
        const double side = choose(0.0, dd_rounded(s), 1.0, -1.0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double y0 = dd_mul_dx(side, y_size); /* arithmetic */
        const double_double y_rate = dd_mul_xx(mu, gc); /* arithmetic */
        const double_double e_near = dd_div_dx(1.0, dd_mul_xx(common_6, common_6)); /* classical: DLMF 4.37.16 */
        const double_double e_far = dd_div_xx(nome, e_near); /* classical: DLMF 20.2.2 */
        const double_double w = dd_choose(far, near, e_near, e_far); /* classical: DLMF 20.2.2 */
        const double_double p = dd_choose(far, near, e_far, e_near); /* classical: DLMF 20.2.2 */
        const double_double alpha = half_turns(sin_a, cos_a); /* classical: DLMF 4.24.3 */
        const double_double jump = dd_mul_dx(-2.0 * rho, alpha); /* classical: DLMF 20.2.7 */
        const double_double p2 = dd_mul_xx(p, p); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double qw = dd_mul_xx(nome, w); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double qw2 = dd_mul_xx(qw, qw); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double near_re_even = dd_add_xx(re_0, dd_mul_xx(p2, re_2)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double near_re_odd = dd_mul_xx(p, dd_add_xx(re_1, dd_mul_xx(p2, re_3))); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double far_re_even = dd_add_xx(re_0, dd_mul_xx(qw2, re_2)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double far_re_odd = dd_mul_xx(qw, dd_add_xx(re_1, dd_mul_xx(qw2, re_3))); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double near_im_even = dd_add_xx(im_0, dd_mul_xx(p2, im_2)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double near_im_odd = dd_mul_xx(p, dd_add_xx(im_1, dd_mul_xx(p2, im_3))); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double far_im_even = dd_add_xx(im_0, dd_mul_xx(qw2, im_2)); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double far_im_odd = dd_mul_xx(qw, dd_add_xx(im_1, dd_mul_xx(qw2, im_3))); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double T4_re = dd_add_xx(dd_add_xx(near_re_even, near_re_odd), dd_mul_xx(w, dd_add_xx(far_re_even, far_re_odd))); /* classical: DLMF 20.2.2 */
        const double_double T4_im = dd_mul_dx(side, dd_sub_xx(dd_add_xx(near_im_even, near_im_odd), dd_mul_xx(w, dd_add_xx(far_im_even, far_im_odd)))); /* classical: DLMF 20.2.2 */
        const double_double T1_re = dd_mul_dx(side, dd_sub_xx(dd_sub_xx(near_re_even, near_re_odd), dd_mul_xx(w, dd_sub_xx(far_re_even, far_re_odd)))); /* classical: DLMF 20.2.1 */
        const double_double T1_im = dd_add_xx(dd_sub_xx(near_im_even, near_im_odd), dd_mul_xx(w, dd_sub_xx(far_im_even, far_im_odd))); /* classical: DLMF 20.2.1 */
        const double_double w2 = dd_mul_xx(w, w); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double_double tall = dd_add_dx(1.0, dd_mul_xx(p2, dd_add_xx(nome2, dd_mul_xx(p2, nome8)))); /* classical: DLMF 20.2.2 */
        const double_double deep = dd_mul_xx(w2, dd_add_dx(1.0, dd_mul_xx(qw2, dd_add_xx(nome2, dd_mul_xx(qw2, nome8))))); /* classical: DLMF 20.2.2 */
        const double_double theta2_y = dd_add_xx(tall, deep); /* classical: DLMF 20.2.2 */
        const double_double P4_re = T4_re; /* fact: definition theta_form.P4_re; (18) */
        const double_double P4_im = T4_im; /* fact: definition theta_form.P4_im; (18) */
        const double_double P1_re = T1_re; /* fact: definition theta_form.P1_re; (18) */
        const double_double P1_im = T1_im; /* fact: definition theta_form.P1_im; (18) */
        const double_double W = dd_mul_xx(dd_mul_dx(2.0, theta2_y), watson); /* fact: reading hyperbolic_form.W; (1) */
        const double_double N = dd_sqrt(W); /* fact: theta_form.N_of_W; (1) */
        const double_double qbar_0 = dd_div_xx(P4_re, N); /* fact: theta_form.qbar_0; (18), (25) */
        const double_double qbar_a = dd_div_xx(dd_mul_dx(sigma, P4_im), N); /* fact: theta_form.qbar_a; (18), (25) */
        const double_double qbar_b = dd_div_xx(dd_mul_dx(chi, P1_im), N); /* fact: theta_form.qbar_b; (18), (25) */
        const double common_7 = -epsilon * sigma * chi; /* fact: theta_form.qbar_d, definition attitude.q_0, definition attitude.q_a, definition attitude.q_b, definition attitude.q_d; (18), (25), (37) */
        const double_double qbar_d = dd_div_xx(dd_mul_dx(common_7, P1_re), N); /* fact: theta_form.qbar_d; (18), (25) */
        const double_double p_0 = dd_add_xx(dd_add_xx(dd_add_xx(dd_mul_xx(q_0, qbar_0), dd_mul_xx(q_a, qbar_a)), dd_mul_xx(q_b, qbar_b)), dd_mul_xx(q_d, qbar_d)); /* fact: attitude.p_0; (37) */
        const double_double p_a = dd_add_xx(dd_sub_xx(dd_mul_xx(q_a, qbar_0), dd_mul_xx(q_0, qbar_a)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_d, qbar_b), dd_mul_xx(q_b, qbar_d)))); /* fact: attitude.p_a; (37) */
        const double_double p_b = dd_add_xx(dd_sub_xx(dd_mul_xx(q_b, qbar_0), dd_mul_xx(q_0, qbar_b)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_a, qbar_d), dd_mul_xx(q_d, qbar_a)))); /* fact: attitude.p_b; (37) */
        const double_double p_d = dd_add_xx(dd_sub_xx(dd_mul_xx(q_d, qbar_0), dd_mul_xx(q_0, qbar_d)), dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(q_b, qbar_a), dd_mul_xx(q_a, qbar_b)))); /* fact: attitude.p_d; (37) */
        const double_double over_N = dd_div_dx(1.0, dd_sqrt(dd_mul_dx(2.0, watson))); /* classical: DLMF 20.7.14 */
        const double_double row_0_P4_re = dd_mul_xx(over_N, p_0); /* fact: definition attitude.q_0; (37) */
        const double_double row_0_P4_im = dd_mul_xx(over_N, dd_neg(dd_mul_xd(p_a, sigma))); /* fact: definition attitude.q_0; (37) */
        const double_double row_0_P1_re = dd_mul_xx(over_N, dd_neg(dd_mul_xd(p_d, common_7))); /* fact: definition attitude.q_0; (37) */
        const double_double row_0_P1_im = dd_mul_xx(over_N, dd_neg(dd_mul_xd(p_b, chi))); /* fact: definition attitude.q_0; (37) */
        const double_double row_a_P4_re = dd_mul_xx(over_N, p_a); /* fact: definition attitude.q_a; (37) */
        const double_double row_a_P4_im = dd_mul_xx(over_N, dd_mul_xd(p_0, sigma)); /* fact: definition attitude.q_a; (37) */
        const double_double row_a_P1_re = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_mul_xd(p_b, common_7))); /* fact: definition attitude.q_a; (37) */
        const double_double row_a_P1_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_neg(dd_mul_xd(p_d, chi)))); /* fact: definition attitude.q_a; (37) */
        const double_double row_b_P4_re = dd_mul_xx(over_N, p_b); /* fact: definition attitude.q_b; (37) */
        const double_double row_b_P4_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_mul_xd(p_d, sigma))); /* fact: definition attitude.q_b; (37) */
        const double_double row_b_P1_re = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_neg(dd_mul_xd(p_a, common_7)))); /* fact: definition attitude.q_b; (37) */
        const double_double row_b_P1_im = dd_mul_xx(over_N, dd_mul_xd(p_0, chi)); /* fact: definition attitude.q_b; (37) */
        const double_double row_d_P4_re = dd_mul_xx(over_N, p_d); /* fact: definition attitude.q_d; (37) */
        const double_double row_d_P4_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_neg(dd_mul_xd(p_b, sigma)))); /* fact: definition attitude.q_d; (37) */
        const double_double row_d_P1_re = dd_mul_xx(over_N, dd_mul_xd(p_0, common_7)); /* fact: definition attitude.q_d; (37) */
        const double_double row_d_P1_im = dd_mul_xx(over_N, dd_mul_dx(epsilon, dd_mul_xd(p_a, chi))); /* fact: definition attitude.q_d; (37) */
        const double tau = -rho * epsilon * sigma; /* fact: definition regular.tau; (16), (17) */
        const double_double gain_a = dd_mul_xd(dd_mul_xx(dd_mul_dx(sigma, A_a), dd_div_xx(two, three)), unit); /* fact: definition regular.Omega_a; (10), DLMF 22.2.4 */
        const double_double gain_b = dd_mul_xd(dd_mul_xx(dd_mul_dx(chi, A_b), dd_div_xx(three, four)), unit); /* fact: definition regular.Omega_b; (10), DLMF 22.2.4 */
        const double_double gain_d = dd_mul_xd(dd_mul_xx(dd_mul_dx(chi * tau, A_d), dd_div_xx(two, four)), unit); /* fact: definition regular.Omega_d; (10), DLMF 22.2.4 */
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
        motion->re_0[i] = dd_rounded(re_0);
        motion->re_1[i] = dd_rounded(re_1);
        motion->re_2[i] = dd_rounded(re_2);
        motion->re_3[i] = dd_rounded(re_3);
        motion->im_0[i] = dd_rounded(im_0);
        motion->im_1[i] = dd_rounded(im_1);
        motion->im_2[i] = dd_rounded(im_2);
        motion->im_3[i] = dd_rounded(im_3);
        motion->nome[i] = dd_rounded(nome);
        motion->nome2[i] = dd_rounded(nome2);
        motion->nome4[i] = dd_rounded(nome4);
        motion->nome8[i] = dd_rounded(nome8);
        motion->nome12[i] = dd_rounded(nome12);
        motion->row_0_P4_re[i] = dd_rounded(row_0_P4_re);
        motion->row_0_P4_im[i] = dd_rounded(row_0_P4_im);
        motion->row_0_P1_re[i] = dd_rounded(row_0_P1_re);
        motion->row_0_P1_im[i] = dd_rounded(row_0_P1_im);
        motion->row_a_P4_re[i] = dd_rounded(row_a_P4_re);
        motion->row_a_P4_im[i] = dd_rounded(row_a_P4_im);
        motion->row_a_P1_re[i] = dd_rounded(row_a_P1_re);
        motion->row_a_P1_im[i] = dd_rounded(row_a_P1_im);
        motion->row_b_P4_re[i] = dd_rounded(row_b_P4_re);
        motion->row_b_P4_im[i] = dd_rounded(row_b_P4_im);
        motion->row_b_P1_re[i] = dd_rounded(row_b_P1_re);
        motion->row_b_P1_im[i] = dd_rounded(row_b_P1_im);
        motion->row_d_P4_re[i] = dd_rounded(row_d_P4_re);
        motion->row_d_P4_im[i] = dd_rounded(row_d_P4_im);
        motion->row_d_P1_re[i] = dd_rounded(row_d_P1_re);
        motion->row_d_P1_im[i] = dd_rounded(row_d_P1_im);
        motion->gain_a[i] = dd_rounded(gain_a);
        motion->gain_b[i] = dd_rounded(gain_b);
        motion->gain_d[i] = dd_rounded(gain_d);
    }
}

/* Angles of the hyperbolic branch at t + t_lo. */
static void hyperbolic_angles(const torque_free_hyperbolic *motion, size_t n,
    const double *restrict t_in, const double *restrict t_lo_in, double *restrict w_out,
    double *restrict p_out, double *restrict side_out, double *restrict flip_out,
    double *restrict X_im_out, double *restrict X_re_out)
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
    for (size_t i = 0; i < n; i++) {
        const double t = t_in[i];
        const double t_lo = t_lo_in[i];
        const double p_y = y_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double p_y_error = product_error(y_rate_hi, t, p_y) + fused(y_rate_lo, t, fused(y_rate_hi, t_lo, y0_lo)); /* arithmetic: Dekker 1971 */
        const double periods = nearest((p_y + y0_hi) * period_inverse); /* classical: DLMF 20.2.7 */
        const double back = period_hi * periods; /* arithmetic: Dekker 1971 */
        const double back_error = fused(period_lo, periods, product_error(period_hi, periods, back)); /* arithmetic: Dekker 1971 */
        const double ahead = p_y + -back; /* arithmetic: Knuth 4.2.2 */
        const double ahead_other = ahead - p_y; /* arithmetic: Knuth 4.2.2 */
        const double ahead_error = p_y - (ahead - ahead_other) + (-back - ahead_other); /* arithmetic: Knuth 4.2.2 */
        const double y_near = ahead + y0_hi; /* arithmetic: Knuth 4.2.2 */
        const double y_near_other = y_near - ahead; /* arithmetic: Knuth 4.2.2 */
        const double y_near_error = ahead - (y_near - y_near_other) + (y0_hi - y_near_other); /* arithmetic: Knuth 4.2.2 */
        const double y = y_near + (y_near_error + (ahead_error + (p_y_error - back_error))); /* classical: DLMF 20.2.7 */
        const double side = choose(0.0, y, 1.0, -1.0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double flip = alternating(periods); /* classical: DLMF 20.2.6 */
        const double depth = fabs(2.0 * y); /* classical: DLMF 20.2.2 */
        const double w = exponential(-depth); /* classical: DLMF 20.2.2 */
        const double p = exponential(depth - period_far); /* classical: DLMF 20.2.2 */
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
        const double L_square = turns * turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double L_sign = alternating(whole); /* classical: DLMF 4.16 */
        const double X_im = L_sign * fused(turns, pi_hi, turns * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double X_re = L_sign * fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, fused(L_square, cosine_7, cosine_6), cosine_5), cosine_4), cosine_3), cosine_2), cosine_1), cosine_0), 1.0); /* classical: DLMF 4.19.2 */
        w_out[i] = w;
        p_out[i] = p;
        side_out[i] = side;
        flip_out[i] = flip;
        X_im_out[i] = X_im;
        X_re_out[i] = X_re;
    }
}

/* The state on the hyperbolic branch, from `_hyperbolic_angles`. */
static void hyperbolic_state(const torque_free_hyperbolic *motion, size_t n,
    const double *restrict w_in, const double *restrict p_in, const double *restrict side_in,
    const double *restrict flip_in, const double *restrict X_im_in, const double *restrict X_re_in,
    double *restrict q_0_out, double *restrict q_a_out, double *restrict q_b_out,
    double *restrict q_d_out, double *restrict Omega_a_out, double *restrict Omega_b_out,
    double *restrict Omega_d_out)
{
    const double re_0 = motion->re_0;
    const double re_1 = motion->re_1;
    const double re_2 = motion->re_2;
    const double re_3 = motion->re_3;
    const double im_0 = motion->im_0;
    const double im_1 = motion->im_1;
    const double im_2 = motion->im_2;
    const double im_3 = motion->im_3;
    const double nome = motion->nome;
    const double nome2 = motion->nome2;
    const double nome4 = motion->nome4;
    const double nome8 = motion->nome8;
    const double nome12 = motion->nome12;
    const double row_0_P4_re = motion->row_0_P4_re;
    const double row_0_P4_im = motion->row_0_P4_im;
    const double row_0_P1_re = motion->row_0_P1_re;
    const double row_0_P1_im = motion->row_0_P1_im;
    const double row_a_P4_re = motion->row_a_P4_re;
    const double row_a_P4_im = motion->row_a_P4_im;
    const double row_a_P1_re = motion->row_a_P1_re;
    const double row_a_P1_im = motion->row_a_P1_im;
    const double row_b_P4_re = motion->row_b_P4_re;
    const double row_b_P4_im = motion->row_b_P4_im;
    const double row_b_P1_re = motion->row_b_P1_re;
    const double row_b_P1_im = motion->row_b_P1_im;
    const double row_d_P4_re = motion->row_d_P4_re;
    const double row_d_P4_im = motion->row_d_P4_im;
    const double row_d_P1_re = motion->row_d_P1_re;
    const double row_d_P1_im = motion->row_d_P1_im;
    const double gain_a = motion->gain_a;
    const double gain_b = motion->gain_b;
    const double gain_d = motion->gain_d;
    for (size_t i = 0; i < n; i++) {
        const double w = w_in[i];
        const double p = p_in[i];
        const double side = side_in[i];
        const double flip = flip_in[i];
        const double X_im = X_im_in[i];
        const double X_re = X_re_in[i];
        const double p2 = p * p; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double qw = nome * w; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double qw2 = qw * qw; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double near_re_even = fused(p2, re_2, re_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double near_re_odd = p * fused(p2, re_3, re_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double far_re_even = fused(qw2, re_2, re_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double far_re_odd = qw * fused(qw2, re_3, re_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double near_im_even = fused(p2, im_2, im_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double near_im_odd = p * fused(p2, im_3, im_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double far_im_even = fused(qw2, im_2, im_0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double far_im_odd = qw * fused(qw2, im_3, im_1); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double T4_re = fused(w, far_re_even + far_re_odd, near_re_even + near_re_odd); /* classical: DLMF 20.2.2 */
        const double T4_im = side * fused(-w, far_im_even + far_im_odd, near_im_even + near_im_odd); /* classical: DLMF 20.2.2 */
        const double T1_re = side * fused(-w, far_re_even - far_re_odd, near_re_even - near_re_odd); /* classical: DLMF 20.2.1 */
        const double T1_im = fused(w, far_im_even - far_im_odd, near_im_even - near_im_odd); /* classical: DLMF 20.2.1 */
        const double w2 = w * w; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double common_1 = p2 * nome8; /* classical: DLMF 20.2.2, DLMF 20.2.1 */
        const double tall = fused(p2, nome2 + common_1, 1.0); /* classical: DLMF 20.2.2 */
        const double common_2 = qw2 * nome8; /* classical: DLMF 20.2.2, DLMF 20.2.1 */
        const double deep = w2 * fused(qw2, nome2 + common_2, 1.0); /* classical: DLMF 20.2.2 */
        const double theta2_y = tall + deep; /* classical: DLMF 20.2.2 */
        const double theta1_y = side * fused(-w2, fused(qw2, common_2 - nome2, 1.0), fused(p2, common_1 - nome2, 1.0)); /* classical: DLMF 20.2.1 */
        const double common_3 = p2 * p2; /* classical: DLMF 20.2.3 */
        const double ends = fused(p2, fused(nome12, common_3, 1.0), w2 * nome2); /* classical: DLMF 20.2.3 */
        const double middle = fused(w2 * w2, nome8, fused(nome4, common_3, 1.0)); /* classical: DLMF 20.2.3 */
        const double theta3_y = 2.0 * (w * (middle + ends)); /* classical: DLMF 20.2.3 */
        const double theta4_y = 2.0 * (w * (middle - ends)); /* classical: DLMF 20.2.4 */
        const double P4_re = fused(X_re, T4_re, -(X_im * T4_im)); /* fact: definition theta_form.P4_re; (18) */
        const double P4_im = fused(X_re, T4_im, X_im * T4_re); /* fact: definition theta_form.P4_im; (18) */
        const double P1_re = fused(X_re, T1_re, -(X_im * T1_im)); /* fact: definition theta_form.P1_re; (18) */
        const double P1_im = fused(X_re, T1_im, X_im * T1_re); /* fact: definition theta_form.P1_im; (18) */
        const double over = 1.0 / theta2_y; /* arithmetic */
        const double scale = sqrt(over); /* arithmetic */
        const double q_0 = scale * fused(row_0_P4_re, P4_re, fused(row_0_P4_im, P4_im, flip * fused(row_0_P1_re, P1_re, row_0_P1_im * P1_im))); /* fact: definition attitude.q_0; (37) */
        const double q_a = scale * fused(row_a_P4_re, P4_re, fused(row_a_P4_im, P4_im, flip * fused(row_a_P1_re, P1_re, row_a_P1_im * P1_im))); /* fact: definition attitude.q_a; (37) */
        const double q_b = scale * fused(row_b_P4_re, P4_re, fused(row_b_P4_im, P4_im, flip * fused(row_b_P1_re, P1_re, row_b_P1_im * P1_im))); /* fact: definition attitude.q_b; (37) */
        const double q_d = scale * fused(row_d_P4_re, P4_re, fused(row_d_P4_im, P4_im, flip * fused(row_d_P1_re, P1_re, row_d_P1_im * P1_im))); /* fact: definition attitude.q_d; (37) */
        const double Omega_a = gain_a * (theta3_y * over); /* fact: definition regular.Omega_a; (10) */
        const double Omega_b = gain_b * (flip * theta1_y * over); /* fact: definition regular.Omega_b; (10) */
        const double Omega_d = gain_d * (flip * theta4_y * over); /* fact: definition regular.Omega_d; (10) */
        q_0_out[i] = q_0;
        q_a_out[i] = q_a;
        q_b_out[i] = q_b;
        q_d_out[i] = q_d;
        Omega_a_out[i] = Omega_a;
        Omega_b_out[i] = Omega_b;
        Omega_d_out[i] = Omega_d;
    }
}

/* p, r, p - r, sqrt(p), p or 1 to divide by, and the modulus with its complement. */
static void moduli(double_double c_a, double_double c_b, double_double c_d, double_double c_ab,
    double_double c_ad, double_double c_bd, double_double Omega_a0, double_double Omega_b0,
    double_double Omega_d0, double_double E_b, double axis_a, double axis_b, double axis_d,
    double_double *p_out, double_double *r_out, double_double *apart_out,
    double_double *lambda__out, double_double *divisor_out, double_double *modulus_out,
    double_double *complement_out)
{
    const double epsilon = (axis_b - axis_a) * (axis_d - axis_a) * (axis_d - axis_b) / 2.0; /* classical: Levi-Civita */
    const double_double alpha_a = dd_div_xx(dd_mul_dx(epsilon, c_bd), c_a); /* fact: definition coefficients.alpha_a; (5) */
    const double_double alpha_b = dd_div_xx(dd_mul_dx(-epsilon, c_ad), c_b); /* fact: definition coefficients.alpha_b; (5) */
    const double_double alpha_d = dd_div_xx(dd_mul_dx(epsilon, c_ab), c_d); /* fact: definition coefficients.alpha_d; (5) */
    const double_double tilt = dd_div_xx(dd_mul_dx(epsilon, E_b), dd_mul_xx(c_a, c_d)); /* fact: definition coefficients.tilt; (5) */
    const double_double k = dd_mul_xx(dd_mul_xx(alpha_a, alpha_d), dd_mul_xx(Omega_b0, Omega_b0)); /* fact: definition varied_rates.k; (5) */
    const double_double kappa_a = dd_mul_xx(dd_mul_xx(dd_neg(alpha_b), alpha_d), dd_mul_xx(Omega_a0, Omega_a0)); /* fact: definition varied_rates.kappa_a; (5) */
    const double_double kappa_d = dd_mul_xx(dd_mul_xx(dd_neg(alpha_a), alpha_b), dd_mul_xx(Omega_d0, Omega_d0)); /* fact: definition varied_rates.kappa_d; (5) */
    const double_double p = dd_add_xx(k, kappa_a); /* fact: definition varied_rates.p; (5) */
    const double_double r = dd_add_xx(k, kappa_d); /* fact: definition varied_rates.r; (5) */
    const double_double apart = dd_mul_xx(dd_neg(alpha_b), tilt); /* fact: definition varied_rates.apart; (5) */
    const double_double lambda_ = dd_sqrt(p); /* arithmetic */
    const double_double divisor = dd_choose(dd_rounded(p), 0.0, dd_of(1.0), p); /* arithmetic */
    const double_double modulus = dd_sqrt(dd_div_xx(r, divisor)); /* classical: DLMF 22.2.2 */
    const double_double complement = dd_sqrt(dd_choose(dd_rounded(p), 0.0, dd_of(1.0), dd_div_xx(apart, divisor))); /* classical: DLMF 19.2.8 */
    *p_out = p;
    *r_out = r;
    *apart_out = apart;
    *lambda__out = lambda_;
    *divisor_out = divisor;
    *modulus_out = modulus;
    *complement_out = complement;
}

/* Constants of `_along_state`; phases are known where p t^2 exceeds reach. */
static void along_constants(double_double c_a, double_double c_b, double_double c_d,
    double_double c_ab, double_double c_ad, double_double c_bd, double_double Omega_a0,
    double_double Omega_b0, double_double Omega_d0, double axis_a, double axis_b, double axis_d,
    double reach, torque_free_along *motion)
{
    const double epsilon = (axis_b - axis_a) * (axis_d - axis_a) * (axis_d - axis_b) / 2.0; /* classical: Levi-Civita */
    const double_double alpha_a = dd_div_xx(dd_mul_dx(epsilon, c_bd), c_a); /* fact: definition coefficients.alpha_a; (5) */
    const double_double alpha_b = dd_div_xx(dd_mul_dx(-epsilon, c_ad), c_b); /* fact: definition coefficients.alpha_b; (5) */
    const double_double alpha_d = dd_div_xx(dd_mul_dx(epsilon, c_ab), c_d); /* fact: definition coefficients.alpha_d; (5) */
    const double_double k = dd_mul_xx(dd_mul_xx(alpha_a, alpha_d), dd_mul_xx(Omega_b0, Omega_b0)); /* fact: definition varied_rates.k; (5) */
    const double_double kappa_a = dd_mul_xx(dd_mul_xx(dd_neg(alpha_b), alpha_d), dd_mul_xx(Omega_a0, Omega_a0)); /* fact: definition varied_rates.kappa_a; (5) */
    const double_double kappa_d = dd_mul_xx(dd_mul_xx(dd_neg(alpha_a), alpha_b), dd_mul_xx(Omega_d0, Omega_d0)); /* fact: definition varied_rates.kappa_d; (5) */
    const double_double p = dd_add_xx(k, kappa_a); /* fact: definition varied_rates.p; (5) */
    const double_double r = dd_add_xx(k, kappa_d); /* fact: definition varied_rates.r; (5) */
    const double_double alpha_b_there = dd_choose(dd_rounded(dd_size(alpha_b)), 0.0, dd_of(1.0), alpha_b); /* arithmetic */
    const double_double alpha_d_there = dd_choose(dd_rounded(dd_size(alpha_d)), 0.0, dd_of(1.0), alpha_d); /* arithmetic */
    const double_double Omega_a0_there = dd_choose(dd_rounded(dd_size(Omega_a0)), 0.0, dd_of(1.0), Omega_a0); /* arithmetic */
    const double_double p_there = dd_choose(dd_rounded(dd_size(p)), 0.0, dd_of(1.0), p); /* arithmetic */
    const double_double share = dd_div_dx(1.0, dd_mul_xx(dd_mul_xx(dd_mul_dx(2.0, alpha_b_there), alpha_d_there), Omega_a0_there)); /* fact: definition passing.share; (5) */
    const double_double half_over_p = dd_div_dx(1.0, dd_mul_dx(2.0, p_there)); /* fact: definition passing.half_over_p; (5) */
    motion->Omega_a0 = dd_rounded(Omega_a0);
    motion->Omega_b0 = dd_rounded(Omega_b0);
    motion->Omega_d0 = dd_rounded(Omega_d0);
    motion->alpha_a = dd_rounded(alpha_a);
    motion->alpha_b = dd_rounded(alpha_b);
    motion->alpha_d = dd_rounded(alpha_d);
    motion->k = dd_rounded(k);
    motion->kappa_a = dd_rounded(kappa_a);
    motion->kappa_d = dd_rounded(kappa_d);
    motion->p = dd_rounded(p);
    motion->r = dd_rounded(r);
    motion->share = dd_rounded(share);
    motion->half_over_p = dd_rounded(half_over_p);
    motion->reach = reach;
}

/* Derivatives of the rates where p and r grow equally, and where r alone grows. */
static void along_state(const torque_free_along *motion, size_t n, const double *restrict S_t_in,
    const double *restrict C_t_in, const double *restrict D_t_in, const double *restrict E_t_in,
    const double *restrict f_in, const double *restrict passed_in, const double *restrict turned_in,
    const double *restrict t_in, const double *restrict Omega_a_in,
    const double *restrict Omega_b_in, const double *restrict Omega_d_in, double *restrict over_out,
    double *restrict Omega_a_k_out, double *restrict Omega_b_k_out, double *restrict Omega_d_k_out,
    double *restrict Omega_a_r_out, double *restrict Omega_b_r_out, double *restrict Omega_d_r_out)
{
    const double Omega_a0 = motion->Omega_a0;
    const double Omega_b0 = motion->Omega_b0;
    const double Omega_d0 = motion->Omega_d0;
    const double alpha_a = motion->alpha_a;
    const double alpha_b = motion->alpha_b;
    const double alpha_d = motion->alpha_d;
    const double k = motion->k;
    const double kappa_a = motion->kappa_a;
    const double kappa_d = motion->kappa_d;
    const double p = motion->p;
    const double r = motion->r;
    const double share = motion->share;
    const double half_over_p = motion->half_over_p;
    const double reach = motion->reach;
    for (size_t i = 0; i < n; i++) {
        const double S_t = S_t_in[i];
        const double C_t = C_t_in[i];
        const double D_t = D_t_in[i];
        const double E_t = E_t_in[i];
        const double f = f_in[i];
        const double passed = passed_in[i];
        const double turned = turned_in[i];
        const double t = t_in[i];
        const double Omega_a = Omega_a_in[i];
        const double Omega_b = Omega_b_in[i];
        const double Omega_d = Omega_d_in[i];
        const double common_1 = D_t * D_t; /* fact: definition varied_rates.below, definition varied_rates.Omega_b_k; (5) */
        const double common_2 = S_t * S_t; /* fact: definition varied_rates.below, definition varied_rates.turning, definition varied_rates.S_k, definition varied_rates.Omega_a_k, definition varied_rates.Omega_b_k, definition varied_rates.Omega_a_r, definition passing.Omega_a_p; (5) */
        const double below = fused(common_2, kappa_d, common_1); /* fact: definition varied_rates.below; (5) */
        const double over = 1.0 / below; /* fact: definition varied_rates.over; (5) */
        const double leant = alpha_a * Omega_b0 * Omega_d0; /* fact: definition varied_rates.leant; (5) */
        const double common_3 = S_t * C_t; /* fact: definition varied_rates.turning, definition varied_rates.C_k, definition varied_rates.below_r; (5) */
        const double common_4 = 2.0 * D_t; /* fact: definition varied_rates.turning, definition varied_rates.D_r; (5) */
        const double common_5 = C_t * C_t; /* fact: definition varied_rates.turning, definition varied_rates.Omega_b_k; (5) */
        const double turning = over * (common_3 * fused(-Omega_a0, r, common_4 * k * Omega_a) / 2.0 + D_t * leant * fused(-common_2, p, common_5) / 2.0); /* fact: definition varied_rates.turning; (5) */
        const double common_6 = C_t * D_t * E_t; /* fact: definition varied_rates.S_k, definition varied_rates.below_k; (5) */
        const double common_7 = common_2 * S_t; /* fact: definition varied_rates.S_k, definition varied_rates.Omega_a_k, definition varied_rates.Omega_a_r, definition passing.Omega_a_p; (5) */
        const double S_k = (common_6 - common_7) / 2.0; /* fact: definition varied_rates.S_k; (5) */
        const double C_k = -S_t * fused(D_t * E_t, p, common_3) / 2.0; /* fact: definition varied_rates.C_k; (5) */
        const double D_k = -S_t * fused(S_t, D_t, C_t * E_t * r) / 2.0; /* fact: definition varied_rates.D_k; (5) */
        const double below_k = -S_t * fused(S_t, below, common_6 * k); /* fact: definition varied_rates.below_k; (5) */
        const double Omega_a_k = fused(E_t, turning, -(common_7 * C_t * over * leant / 2.0)); /* fact: definition varied_rates.Omega_a_k; (5) */
        const double common_8 = alpha_b * Omega_d0; /* fact: definition varied_rates.Omega_b_k, definition passing.Omega_b_p; (5) */
        const double common_9 = over * kappa_a; /* fact: definition varied_rates.Omega_b_k; (5) */
        const double common_10 = over * kappa_d; /* fact: definition varied_rates.Omega_b_k; (5) */
        const double common_11 = over * common_5; /* fact: definition varied_rates.Omega_b_k; (5) */
        const double Omega_b_k = fused(over * (common_8 * Omega_a0), fused(-S_t, over * below_k, S_k), -(Omega_b0 * S_t * E_t * fused((common_9 + common_10) * common_11, common_1, common_2 * fused(p * common_9, over * common_1, r * common_10 * common_11)) / 2.0)); /* fact: definition varied_rates.Omega_b_k; (5) */
        const double common_12 = alpha_d * Omega_a0 * Omega_b0; /* fact: definition varied_rates.Omega_d_k, definition varied_rates.Omega_d_r; (5) */
        const double Omega_d_k = over * fused(-Omega_d, below_k, fused(Omega_d0, C_k, common_12 * fused(S_t, D_k, D_t * S_k))); /* fact: definition varied_rates.Omega_d_k; (5) */
        const double S_r = -C_t * f / 2.0; /* fact: definition varied_rates.S_r; (5) */
        const double C_r = S_t * p * f / 2.0; /* fact: definition varied_rates.C_r; (5) */
        const double D_r = S_t * fused(C_t * r, f, -S_t) / common_4; /* fact: definition varied_rates.D_r; (5) */
        const double below_r = common_3 * k * f; /* fact: definition varied_rates.below_r; (5) */
        const double any_Omega_a_r = fused(-f, turning / D_t, common_7 * over * fused(C_t, leant, -(Omega_a0 * S_t * r / D_t)) / 2.0); /* fact: definition varied_rates.Omega_a_r; (5) */
        const double any_Omega_b_r = over * fused(-Omega_b, below_r, fused(Omega_b0, fused(C_t, D_r, D_t * C_r), alpha_b * Omega_a0 * Omega_d0 * S_r)); /* fact: definition varied_rates.Omega_b_r; (5) */
        const double any_Omega_d_r = over * fused(-Omega_d, below_r, fused(Omega_d0, C_r, common_12 * fused(S_t, D_r, D_t * S_r))); /* fact: definition varied_rates.Omega_d_r; (5) */
        const double Omega_a_there = choose(fabs(Omega_a), 0.0, 1.0, Omega_a); /* arithmetic */
        const double since = half_over_p * (t + passed); /* fact: definition passing.since; (5) */
        const double Omega_a_p = fused(alpha_a * Omega_b * Omega_d, since, fused(over, fused(D_t, share, common_7 * S_t * k * Omega_a_there), -Omega_a0 * share / Omega_a_there)); /* fact: definition passing.Omega_a_p; (5) */
        const double common_13 = S_t * over; /* fact: definition passing.Omega_b_p, definition passing.Omega_d_p; (5) */
        const double Omega_b_p = fused(alpha_b * Omega_a_there * Omega_d, since, common_13 * fused(S_t, Omega_b, common_8 * share)); /* fact: definition passing.Omega_b_p; (5) */
        const double Omega_d_p = fused(alpha_d * Omega_a_there * Omega_b, since, common_13 * fused(S_t, Omega_d, alpha_d * Omega_b0 * D_t * share)); /* fact: definition passing.Omega_d_p; (5) */
        const double lobe = choose(2.0, turned, 0.0, Omega_b * Omega_b0); /* arithmetic */
        const double crossed = choose(reach, p * (t * t), lobe, 1.0); /* arithmetic */
        const double Omega_a_r = choose(crossed, 0.0, Omega_a_k - Omega_a_p, any_Omega_a_r); /* arithmetic */
        const double Omega_b_r = choose(crossed, 0.0, Omega_b_k - Omega_b_p, any_Omega_b_r); /* arithmetic */
        const double Omega_d_r = choose(crossed, 0.0, Omega_d_k - Omega_d_p, any_Omega_d_r); /* arithmetic */
        over_out[i] = over;
        Omega_a_k_out[i] = Omega_a_k;
        Omega_b_k_out[i] = Omega_b_k;
        Omega_d_k_out[i] = Omega_d_k;
        Omega_a_r_out[i] = Omega_a_r;
        Omega_b_r_out[i] = Omega_b_r;
        Omega_d_r_out[i] = Omega_d_r;
    }
}

/* Constants of the rates' sensitivities. */
static void columns_constants(double_double c_a, double_double c_b, double_double c_d,
    double_double c_ab, double_double c_ad, double_double c_bd, double_double Omega_a0,
    double_double Omega_b0, double_double Omega_d0, double_double E_b, double axis_a, double axis_b,
    double axis_d, torque_free_columns *motion)
{
    const double epsilon = (axis_b - axis_a) * (axis_d - axis_a) * (axis_d - axis_b) / 2.0; /* classical: Levi-Civita */
    const double_double alpha_a = dd_div_xx(dd_mul_dx(epsilon, c_bd), c_a); /* fact: definition coefficients.alpha_a; (5) */
    const double_double alpha_b = dd_div_xx(dd_mul_dx(-epsilon, c_ad), c_b); /* fact: definition coefficients.alpha_b; (5) */
    const double_double alpha_d = dd_div_xx(dd_mul_dx(epsilon, c_ab), c_d); /* fact: definition coefficients.alpha_d; (5) */
    const double_double common_1 = dd_mul_xx(c_a, c_d); /* fact: definition coefficients.tilt, definition coefficients.tilt_by_c_a, definition coefficients.tilt_by_c_b, definition coefficients.tilt_by_c_d; (5) */
    const double_double tilt = dd_div_xx(dd_mul_dx(epsilon, E_b), common_1); /* fact: definition coefficients.tilt; (5) */
    const double_double alpha_a_by_c_a = dd_div_xx(dd_neg(alpha_a), c_a); /* fact: definition coefficients.alpha_a_by_c_a; (5) */
    const double_double alpha_a_by_c_b = dd_div_dx(epsilon, c_a); /* fact: definition coefficients.alpha_a_by_c_b; (5) */
    const double_double alpha_a_by_c_d = dd_div_dx(-epsilon, c_a); /* fact: definition coefficients.alpha_a_by_c_d; (5) */
    const double_double alpha_b_by_c_b = dd_div_xx(dd_neg(alpha_b), c_b); /* fact: definition coefficients.alpha_b_by_c_b; (5) */
    const double_double alpha_b_by_c_d = dd_div_dx(epsilon, c_b); /* fact: definition coefficients.alpha_b_by_c_d; (5) */
    const double_double alpha_b_by_c_a = dd_div_dx(-epsilon, c_b); /* fact: definition coefficients.alpha_b_by_c_a; (5) */
    const double_double alpha_d_by_c_d = dd_div_xx(dd_neg(alpha_d), c_d); /* fact: definition coefficients.alpha_d_by_c_d; (5) */
    const double_double alpha_d_by_c_a = dd_div_dx(epsilon, c_d); /* fact: definition coefficients.alpha_d_by_c_a; (5) */
    const double_double alpha_d_by_c_b = dd_div_dx(-epsilon, c_d); /* fact: definition coefficients.alpha_d_by_c_b; (5) */
    const double_double common_2 = dd_mul_xx(Omega_a0, Omega_a0); /* fact: definition coefficients.tilt_by_c_a, definition coefficients.tilt_by_c_b, definition varied_rates.g_a, definition varied_rates.kappa_a, definition varied_rates.kappa_by_c_a, definition varied_rates.kappa_by_c_b, definition varied_rates.kappa_by_c_d; (5) */
    const double_double tilt_by_c_a = dd_add_xx(dd_div_xx(dd_neg(tilt), c_a), dd_div_xx(dd_mul_xx(dd_mul_dx(epsilon, common_2), dd_add_xx(c_a, c_ab)), common_1)); /* fact: definition coefficients.tilt_by_c_a; (5) */
    const double_double common_3 = dd_mul_xx(Omega_d0, Omega_d0); /* fact: definition coefficients.tilt_by_c_b, definition coefficients.tilt_by_c_d, definition varied_rates.g_d, definition varied_rates.kappa_d, definition varied_rates.leant_by_c_a, definition varied_rates.leant_by_c_b, definition varied_rates.leant_by_c_d; (5) */
    const double_double tilt_by_c_b = dd_div_xx(dd_mul_dx(epsilon, dd_sub_xx(dd_mul_xx(dd_neg(c_a), common_2), dd_mul_xx(c_d, common_3))), common_1); /* fact: definition coefficients.tilt_by_c_b; (5) */
    const double_double tilt_by_c_d = dd_sub_xx(dd_div_xx(dd_neg(tilt), c_d), dd_div_xx(dd_mul_xx(dd_mul_dx(epsilon, common_3), dd_sub_xx(c_bd, c_d)), common_1)); /* fact: definition coefficients.tilt_by_c_d; (5) */
    const double_double common_4 = dd_mul_xx(Omega_b0, Omega_b0); /* fact: definition varied_rates.g_a, definition varied_rates.g_d, definition varied_rates.k, definition varied_rates.p_by_c_a, definition varied_rates.leant_by_c_a, definition varied_rates.p_by_c_b, definition varied_rates.leant_by_c_b, definition varied_rates.p_by_c_d, definition varied_rates.leant_by_c_d; (5) */
    const double_double g_a = dd_sub_xx(dd_mul_xx(alpha_a, common_4), dd_mul_xx(alpha_b, common_2)); /* fact: definition varied_rates.g_a; (5) */
    const double_double g_d = dd_sub_xx(dd_mul_xx(alpha_d, common_4), dd_mul_xx(alpha_b, common_3)); /* fact: definition varied_rates.g_d; (5) */
    const double_double k = dd_mul_xx(dd_mul_xx(alpha_a, alpha_d), common_4); /* fact: definition varied_rates.k; (5) */
    const double_double kappa_a = dd_mul_xx(dd_mul_xx(dd_neg(alpha_b), alpha_d), common_2); /* fact: definition varied_rates.kappa_a; (5) */
    const double_double kappa_d = dd_mul_xx(dd_mul_xx(dd_neg(alpha_a), alpha_b), common_3); /* fact: definition varied_rates.kappa_d; (5) */
    const double_double p = dd_add_xx(k, kappa_a); /* fact: definition varied_rates.p; (5) */
    const double_double apart = dd_mul_xx(dd_neg(alpha_b), tilt); /* fact: definition varied_rates.apart; (5) */
    const double_double p_by_Omega_a = dd_mul_xx(dd_mul_xx(dd_mul_dx(-2.0, alpha_b), alpha_d), Omega_a0); /* fact: definition varied_rates.p_by_Omega_a; (5) */
    const double_double p_by_Omega_b = dd_mul_xx(dd_mul_xx(dd_mul_dx(2.0, alpha_a), alpha_d), Omega_b0); /* fact: definition varied_rates.p_by_Omega_b; (5) */
    const double_double r_by_Omega_d = dd_mul_xx(dd_mul_xx(dd_mul_dx(-2.0, alpha_a), alpha_b), Omega_d0); /* fact: definition varied_rates.r_by_Omega_d; (5) */
    const double_double kappa_by_c_a = dd_mul_xx(dd_neg(common_2), dd_add_xx(dd_mul_xx(alpha_b, alpha_d_by_c_a), dd_mul_xx(alpha_d, alpha_b_by_c_a))); /* fact: definition varied_rates.kappa_by_c_a; (5) */
    const double_double common_5 = dd_mul_xx(common_4, dd_add_xx(dd_mul_xx(alpha_a, alpha_d_by_c_a), dd_mul_xx(alpha_d, alpha_a_by_c_a))); /* fact: definition varied_rates.p_by_c_a, definition varied_rates.leant_by_c_a; (5) */
    const double_double p_by_c_a = dd_add_xx(kappa_by_c_a, common_5); /* fact: definition varied_rates.p_by_c_a; (5) */
    const double_double apart_by_c_a = dd_sub_xx(dd_mul_xx(dd_neg(alpha_b), tilt_by_c_a), dd_mul_xx(alpha_b_by_c_a, tilt)); /* fact: definition varied_rates.apart_by_c_a; (5) */
    const double_double leant_by_c_a = dd_add_xx(common_5, dd_mul_xx(common_3, dd_add_xx(dd_mul_xx(alpha_a, alpha_b_by_c_a), dd_mul_xx(alpha_b, alpha_a_by_c_a)))); /* fact: definition varied_rates.leant_by_c_a; (5) */
    const double_double a_by_c_a = dd_mul_xx(dd_mul_xx(alpha_a_by_c_a, Omega_b0), Omega_d0); /* fact: definition varied_rates.a_by_c_a; (5) */
    const double_double b_by_c_a = dd_mul_xx(dd_mul_xx(alpha_b_by_c_a, Omega_a0), Omega_d0); /* fact: definition varied_rates.b_by_c_a; (5) */
    const double_double d_by_c_a = dd_mul_xx(dd_mul_xx(alpha_d_by_c_a, Omega_a0), Omega_b0); /* fact: definition varied_rates.d_by_c_a; (5) */
    const double_double kappa_by_c_b = dd_mul_xx(dd_neg(common_2), dd_add_xx(dd_mul_xx(alpha_b, alpha_d_by_c_b), dd_mul_xx(alpha_d, alpha_b_by_c_b))); /* fact: definition varied_rates.kappa_by_c_b; (5) */
    const double_double common_6 = dd_mul_xx(common_4, dd_add_xx(dd_mul_xx(alpha_a, alpha_d_by_c_b), dd_mul_xx(alpha_d, alpha_a_by_c_b))); /* fact: definition varied_rates.p_by_c_b, definition varied_rates.leant_by_c_b; (5) */
    const double_double p_by_c_b = dd_add_xx(kappa_by_c_b, common_6); /* fact: definition varied_rates.p_by_c_b; (5) */
    const double_double apart_by_c_b = dd_sub_xx(dd_mul_xx(dd_neg(alpha_b), tilt_by_c_b), dd_mul_xx(alpha_b_by_c_b, tilt)); /* fact: definition varied_rates.apart_by_c_b; (5) */
    const double_double leant_by_c_b = dd_add_xx(common_6, dd_mul_xx(common_3, dd_add_xx(dd_mul_xx(alpha_a, alpha_b_by_c_b), dd_mul_xx(alpha_b, alpha_a_by_c_b)))); /* fact: definition varied_rates.leant_by_c_b; (5) */
    const double_double a_by_c_b = dd_mul_xx(dd_mul_xx(alpha_a_by_c_b, Omega_b0), Omega_d0); /* fact: definition varied_rates.a_by_c_b; (5) */
    const double_double b_by_c_b = dd_mul_xx(dd_mul_xx(alpha_b_by_c_b, Omega_a0), Omega_d0); /* fact: definition varied_rates.b_by_c_b; (5) */
    const double_double d_by_c_b = dd_mul_xx(dd_mul_xx(alpha_d_by_c_b, Omega_a0), Omega_b0); /* fact: definition varied_rates.d_by_c_b; (5) */
    const double_double kappa_by_c_d = dd_mul_xx(dd_neg(common_2), dd_add_xx(dd_mul_xx(alpha_b, alpha_d_by_c_d), dd_mul_xx(alpha_d, alpha_b_by_c_d))); /* fact: definition varied_rates.kappa_by_c_d; (5) */
    const double_double common_7 = dd_mul_xx(common_4, dd_add_xx(dd_mul_xx(alpha_a, alpha_d_by_c_d), dd_mul_xx(alpha_d, alpha_a_by_c_d))); /* fact: definition varied_rates.p_by_c_d, definition varied_rates.leant_by_c_d; (5) */
    const double_double p_by_c_d = dd_add_xx(kappa_by_c_d, common_7); /* fact: definition varied_rates.p_by_c_d; (5) */
    const double_double apart_by_c_d = dd_sub_xx(dd_mul_xx(dd_neg(alpha_b), tilt_by_c_d), dd_mul_xx(alpha_b_by_c_d, tilt)); /* fact: definition varied_rates.apart_by_c_d; (5) */
    const double_double leant_by_c_d = dd_add_xx(common_7, dd_mul_xx(common_3, dd_add_xx(dd_mul_xx(alpha_a, alpha_b_by_c_d), dd_mul_xx(alpha_b, alpha_a_by_c_d)))); /* fact: definition varied_rates.leant_by_c_d; (5) */
    const double_double a_by_c_d = dd_mul_xx(dd_mul_xx(alpha_a_by_c_d, Omega_b0), Omega_d0); /* fact: definition varied_rates.a_by_c_d; (5) */
    const double_double b_by_c_d = dd_mul_xx(dd_mul_xx(alpha_b_by_c_d, Omega_a0), Omega_d0); /* fact: definition varied_rates.b_by_c_d; (5) */
    const double_double d_by_c_d = dd_mul_xx(dd_mul_xx(alpha_d_by_c_d, Omega_a0), Omega_b0); /* fact: definition varied_rates.d_by_c_d; (5) */
    const double_double alpha_divisor = dd_choose(dd_rounded(dd_size(alpha_b)), 0.0, dd_of(1.0), alpha_b); /* arithmetic */
    motion->Omega_a0 = dd_rounded(Omega_a0);
    motion->Omega_b0 = dd_rounded(Omega_b0);
    motion->Omega_d0 = dd_rounded(Omega_d0);
    motion->alpha_a = dd_rounded(alpha_a);
    motion->alpha_b = dd_rounded(alpha_b);
    motion->alpha_d = dd_rounded(alpha_d);
    motion->alpha_divisor = dd_rounded(alpha_divisor);
    motion->g_a = dd_rounded(g_a);
    motion->g_d = dd_rounded(g_d);
    motion->k = dd_rounded(k);
    motion->kappa_a = dd_rounded(kappa_a);
    motion->kappa_d = dd_rounded(kappa_d);
    motion->p = dd_rounded(p);
    motion->apart = dd_rounded(apart);
    motion->p_by_Omega_a = dd_rounded(p_by_Omega_a);
    motion->p_by_Omega_b = dd_rounded(p_by_Omega_b);
    motion->r_by_Omega_d = dd_rounded(r_by_Omega_d);
    motion->kappa_by_c_a = dd_rounded(kappa_by_c_a);
    motion->kappa_by_c_b = dd_rounded(kappa_by_c_b);
    motion->kappa_by_c_d = dd_rounded(kappa_by_c_d);
    motion->p_by_c_a = dd_rounded(p_by_c_a);
    motion->p_by_c_b = dd_rounded(p_by_c_b);
    motion->p_by_c_d = dd_rounded(p_by_c_d);
    motion->apart_by_c_a = dd_rounded(apart_by_c_a);
    motion->apart_by_c_b = dd_rounded(apart_by_c_b);
    motion->apart_by_c_d = dd_rounded(apart_by_c_d);
    motion->leant_by_c_a = dd_rounded(leant_by_c_a);
    motion->leant_by_c_b = dd_rounded(leant_by_c_b);
    motion->leant_by_c_d = dd_rounded(leant_by_c_d);
    motion->a_by_c_a = dd_rounded(a_by_c_a);
    motion->a_by_c_b = dd_rounded(a_by_c_b);
    motion->a_by_c_d = dd_rounded(a_by_c_d);
    motion->b_by_c_a = dd_rounded(b_by_c_a);
    motion->b_by_c_b = dd_rounded(b_by_c_b);
    motion->b_by_c_d = dd_rounded(b_by_c_d);
    motion->d_by_c_a = dd_rounded(d_by_c_a);
    motion->d_by_c_b = dd_rounded(d_by_c_b);
    motion->d_by_c_d = dd_rounded(d_by_c_d);
}

/* Derivatives of the rates, and integrals of the squares of rates. */
static void columns_state(const torque_free_columns *motion, size_t n,
    const double *restrict S_t_in, const double *restrict C_t_in, const double *restrict D_t_in,
    const double *restrict E_t_in, const double *restrict f_in, const double *restrict over_in,
    const double *restrict Omega_a_k_in, const double *restrict Omega_b_k_in,
    const double *restrict Omega_d_k_in, const double *restrict Omega_a_r_in,
    const double *restrict Omega_b_r_in, const double *restrict Omega_d_r_in,
    const double *restrict t_in, const double *restrict Omega_a_in,
    const double *restrict Omega_b_in, const double *restrict Omega_d_in,
    double *restrict Omega_a_by_Omega_a_out, double *restrict Omega_a_by_Omega_b_out,
    double *restrict Omega_a_by_Omega_d_out, double *restrict Omega_a_by_c_a_out,
    double *restrict Omega_a_by_c_b_out, double *restrict Omega_a_by_c_d_out,
    double *restrict Omega_b_by_Omega_a_out, double *restrict Omega_b_by_Omega_b_out,
    double *restrict Omega_b_by_Omega_d_out, double *restrict Omega_b_by_c_a_out,
    double *restrict Omega_b_by_c_b_out, double *restrict Omega_b_by_c_d_out,
    double *restrict Omega_d_by_Omega_a_out, double *restrict Omega_d_by_Omega_b_out,
    double *restrict Omega_d_by_Omega_d_out, double *restrict Omega_d_by_c_a_out,
    double *restrict Omega_d_by_c_b_out, double *restrict Omega_d_by_c_d_out,
    double *restrict excess_a_out, double *restrict excess_b_out, double *restrict excess_d_out)
{
    const double Omega_a0 = motion->Omega_a0;
    const double Omega_b0 = motion->Omega_b0;
    const double Omega_d0 = motion->Omega_d0;
    const double alpha_a = motion->alpha_a;
    const double alpha_b = motion->alpha_b;
    const double alpha_d = motion->alpha_d;
    const double alpha_divisor = motion->alpha_divisor;
    const double g_a = motion->g_a;
    const double g_d = motion->g_d;
    const double k = motion->k;
    const double kappa_a = motion->kappa_a;
    const double kappa_d = motion->kappa_d;
    const double p = motion->p;
    const double apart = motion->apart;
    const double p_by_Omega_a = motion->p_by_Omega_a;
    const double p_by_Omega_b = motion->p_by_Omega_b;
    const double r_by_Omega_d = motion->r_by_Omega_d;
    const double kappa_by_c_a = motion->kappa_by_c_a;
    const double kappa_by_c_b = motion->kappa_by_c_b;
    const double kappa_by_c_d = motion->kappa_by_c_d;
    const double p_by_c_a = motion->p_by_c_a;
    const double p_by_c_b = motion->p_by_c_b;
    const double p_by_c_d = motion->p_by_c_d;
    const double apart_by_c_a = motion->apart_by_c_a;
    const double apart_by_c_b = motion->apart_by_c_b;
    const double apart_by_c_d = motion->apart_by_c_d;
    const double leant_by_c_a = motion->leant_by_c_a;
    const double leant_by_c_b = motion->leant_by_c_b;
    const double leant_by_c_d = motion->leant_by_c_d;
    const double a_by_c_a = motion->a_by_c_a;
    const double a_by_c_b = motion->a_by_c_b;
    const double a_by_c_d = motion->a_by_c_d;
    const double b_by_c_a = motion->b_by_c_a;
    const double b_by_c_b = motion->b_by_c_b;
    const double b_by_c_d = motion->b_by_c_d;
    const double d_by_c_a = motion->d_by_c_a;
    const double d_by_c_b = motion->d_by_c_b;
    const double d_by_c_d = motion->d_by_c_d;
    for (size_t i = 0; i < n; i++) {
        const double S_t = S_t_in[i];
        const double C_t = C_t_in[i];
        const double D_t = D_t_in[i];
        const double E_t = E_t_in[i];
        const double f = f_in[i];
        const double over = over_in[i];
        const double Omega_a_k = Omega_a_k_in[i];
        const double Omega_b_k = Omega_b_k_in[i];
        const double Omega_d_k = Omega_d_k_in[i];
        const double Omega_a_r = Omega_a_r_in[i];
        const double Omega_b_r = Omega_b_r_in[i];
        const double Omega_d_r = Omega_d_r_in[i];
        const double t = t_in[i];
        const double Omega_a = Omega_a_in[i];
        const double Omega_b = Omega_b_in[i];
        const double Omega_d = Omega_d_in[i];
        const double common_1 = S_t * S_t; /* fact: definition varied_rates.Omega_a_by_Omega_a, definition varied_rates.Omega_b_by_Omega_a, definition varied_rates.Omega_d_by_Omega_a, definition varied_rates.Omega_a_by_Omega_b, definition varied_rates.Omega_a_by_Omega_d, definition varied_rates.Omega_a_by_c_a, definition varied_rates.Omega_b_by_c_a, definition varied_rates.Omega_d_by_c_a, definition varied_rates.Omega_a_by_c_b, definition varied_rates.Omega_b_by_c_b, definition varied_rates.Omega_d_by_c_b, definition varied_rates.Omega_a_by_c_d, definition varied_rates.Omega_b_by_c_d, definition varied_rates.Omega_d_by_c_d, definition spun.lag; (5) */
        const double common_2 = common_1 * S_t; /* fact: definition varied_rates.Omega_a_by_Omega_a, definition spun.lag; (5) */
        const double Omega_a_by_Omega_a = fused(p_by_Omega_a, Omega_a_k - Omega_a_r, fused(D_t, over, -(common_2 * S_t * k * Omega_a * (p_by_Omega_a * over)))); /* fact: definition varied_rates.Omega_a_by_Omega_a; (5) */
        const double common_3 = common_1 * p_by_Omega_a; /* fact: definition varied_rates.Omega_b_by_Omega_a, definition varied_rates.Omega_d_by_Omega_a; (5) */
        const double any_Omega_b_by_Omega_a = fused(p_by_Omega_a, Omega_b_k - Omega_b_r, over * fused(alpha_b * Omega_d0, S_t, -(common_3 * Omega_b))); /* fact: definition varied_rates.Omega_b_by_Omega_a; (5) */
        const double Omega_d_by_Omega_a = fused(p_by_Omega_a, Omega_d_k - Omega_d_r, over * fused(alpha_d * Omega_b0 * S_t, D_t, -(common_3 * Omega_d))); /* fact: definition varied_rates.Omega_d_by_Omega_a; (5) */
        const double common_4 = common_1 * Omega_a; /* fact: definition varied_rates.Omega_a_by_Omega_b, definition varied_rates.Omega_a_by_Omega_d, definition varied_rates.Omega_a_by_c_a, definition varied_rates.Omega_a_by_c_b, definition varied_rates.Omega_a_by_c_d; (5) */
        const double common_5 = common_4 / 2.0; /* fact: definition varied_rates.Omega_a_by_Omega_b, definition varied_rates.Omega_a_by_Omega_d; (5) */
        const double Omega_a_by_Omega_b = fused(p_by_Omega_b, Omega_a_k + common_5, alpha_a * Omega_d0 * S_t * C_t * over); /* fact: definition varied_rates.Omega_a_by_Omega_b; (5) */
        const double Omega_b_by_Omega_b = fused(p_by_Omega_b, Omega_b_k, C_t * D_t * over); /* fact: definition varied_rates.Omega_b_by_Omega_b; (5) */
        const double Omega_d_by_Omega_b = fused(p_by_Omega_b, Omega_d_k, alpha_d * Omega_a0 * S_t * D_t * over); /* fact: definition varied_rates.Omega_d_by_Omega_b; (5) */
        const double Omega_a_by_Omega_d = fused(r_by_Omega_d, Omega_a_r - common_5, alpha_a * Omega_b0 * S_t * C_t * over); /* fact: definition varied_rates.Omega_a_by_Omega_d; (5) */
        const double common_6 = alpha_b * Omega_a0; /* fact: definition varied_rates.Omega_b_by_Omega_d, definition spun.swung, definition spun.excess_spun; (5) */
        const double any_Omega_b_by_Omega_d = fused(r_by_Omega_d, Omega_b_r, common_6 * S_t * over); /* fact: definition varied_rates.Omega_b_by_Omega_d; (5) */
        const double Omega_d_by_Omega_d = fused(C_t, over, r_by_Omega_d * Omega_d_r); /* fact: definition varied_rates.Omega_d_by_Omega_d; (5) */
        const double common_7 = S_t * C_t; /* fact: definition varied_rates.Omega_a_by_c_a, definition varied_rates.Omega_a_by_c_b, definition varied_rates.Omega_a_by_c_d; (5) */
        const double common_8 = 2.0 * common_1 * k; /* fact: definition varied_rates.Omega_a_by_c_a, definition varied_rates.Omega_a_by_c_b, definition varied_rates.Omega_a_by_c_d; (5) */
        const double Omega_a_by_c_a = fused(p_by_c_a, Omega_a_k, -(apart_by_c_a * Omega_a_r)) + fused(common_7 * a_by_c_a, over, common_4 * fused(-common_8, kappa_by_c_a * over, leant_by_c_a) / 2.0); /* fact: definition varied_rates.Omega_a_by_c_a; (5) */
        const double common_9 = common_1 * kappa_by_c_a; /* fact: definition varied_rates.Omega_b_by_c_a, definition varied_rates.Omega_d_by_c_a; (5) */
        const double Omega_b_by_c_a = fused(over, fused(S_t, b_by_c_a, -(common_9 * Omega_b)), fused(p_by_c_a, Omega_b_k, -(apart_by_c_a * Omega_b_r))); /* fact: definition varied_rates.Omega_b_by_c_a; (5) */
        const double common_10 = S_t * D_t; /* fact: definition varied_rates.Omega_d_by_c_a, definition varied_rates.Omega_d_by_c_b, definition varied_rates.Omega_d_by_c_d; (5) */
        const double Omega_d_by_c_a = fused(over, fused(common_10, d_by_c_a, -(common_9 * Omega_d)), fused(p_by_c_a, Omega_d_k, -(apart_by_c_a * Omega_d_r))); /* fact: definition varied_rates.Omega_d_by_c_a; (5) */
        const double Omega_a_by_c_b = fused(p_by_c_b, Omega_a_k, -(apart_by_c_b * Omega_a_r)) + fused(common_7 * a_by_c_b, over, common_4 * fused(-common_8, kappa_by_c_b * over, leant_by_c_b) / 2.0); /* fact: definition varied_rates.Omega_a_by_c_b; (5) */
        const double common_11 = common_1 * kappa_by_c_b; /* fact: definition varied_rates.Omega_b_by_c_b, definition varied_rates.Omega_d_by_c_b; (5) */
        const double Omega_b_by_c_b = fused(over, fused(S_t, b_by_c_b, -(common_11 * Omega_b)), fused(p_by_c_b, Omega_b_k, -(apart_by_c_b * Omega_b_r))); /* fact: definition varied_rates.Omega_b_by_c_b; (5) */
        const double Omega_d_by_c_b = fused(over, fused(common_10, d_by_c_b, -(common_11 * Omega_d)), fused(p_by_c_b, Omega_d_k, -(apart_by_c_b * Omega_d_r))); /* fact: definition varied_rates.Omega_d_by_c_b; (5) */
        const double Omega_a_by_c_d = fused(p_by_c_d, Omega_a_k, -(apart_by_c_d * Omega_a_r)) + fused(common_7 * a_by_c_d, over, common_4 * fused(-common_8, kappa_by_c_d * over, leant_by_c_d) / 2.0); /* fact: definition varied_rates.Omega_a_by_c_d; (5) */
        const double common_12 = common_1 * kappa_by_c_d; /* fact: definition varied_rates.Omega_b_by_c_d, definition varied_rates.Omega_d_by_c_d; (5) */
        const double Omega_b_by_c_d = fused(over, fused(S_t, b_by_c_d, -(common_12 * Omega_b)), fused(p_by_c_d, Omega_b_k, -(apart_by_c_d * Omega_b_r))); /* fact: definition varied_rates.Omega_b_by_c_d; (5) */
        const double Omega_d_by_c_d = fused(over, fused(common_10, d_by_c_d, -(common_12 * Omega_d)), fused(p_by_c_d, Omega_d_k, -(apart_by_c_d * Omega_d_r))); /* fact: definition varied_rates.Omega_d_by_c_d; (5) */
        const double any_excess_b = fused(Omega_b0, fused(t, Omega_b - Omega_b0, Omega_b * (S_t - t)), E_t * g_a * g_d); /* fact: definition varied_rates.excess_b; (5) */
        const double b_divisor = choose(fabs(Omega_b), 0.0, 1.0, Omega_b); /* arithmetic */
        const double d_divisor = choose(fabs(alpha_d), 0.0, 1.0, alpha_d); /* arithmetic */
        const double middle_by_Omega_a = alpha_b * Omega_d_by_Omega_a * (Omega_d / b_divisor) / d_divisor; /* fact: definition middle_columns.middle_by_Omega_a; (5) */
        const double d_size = fabs(alpha_b * Omega_d); /* arithmetic */
        const double Omega_b_by_Omega_a = choose(d_size, fabs(alpha_d * Omega_b), middle_by_Omega_a, any_Omega_b_by_Omega_a); /* arithmetic */
        const double a_divisor = choose(fabs(alpha_a), 0.0, 1.0, alpha_a); /* arithmetic */
        const double middle_by_Omega_d = alpha_b * Omega_a_by_Omega_d * (Omega_a / b_divisor) / a_divisor; /* fact: definition middle_columns.middle_by_Omega_d; (5) */
        const double a_size = fabs(alpha_b * Omega_a); /* arithmetic */
        const double Omega_b_by_Omega_d = choose(a_size, fabs(alpha_a * Omega_b), middle_by_Omega_d, any_Omega_b_by_Omega_d); /* arithmetic */
        const double p_divisor = choose(fabs(p), 0.0, 1.0, p); /* arithmetic */
        const double C_ahead = choose(C_t, 0.0, 0.0, C_t); /* arithmetic */
        const double common_13 = common_6 * Omega_d0; /* fact: definition spun.swung, definition spun.excess_spun; (5) */
        const double common_14 = Omega_b0 * S_t; /* fact: definition spun.swung, definition spun.excess_spun; (5) */
        const double common_15 = C_ahead + D_t; /* fact: definition spun.swung, definition spun.lag; (5) */
        const double swung = S_t * over * (common_13 - common_14 * fused(C_ahead, kappa_d, D_t * kappa_a) / common_15); /* fact: definition spun.swung; (5) */
        const double lag = fused(S_t * C_ahead / D_t - t, kappa_a / p_divisor, apart * fused(-f, k / p_divisor, common_2 / common_15) / D_t); /* fact: definition spun.lag; (5) */
        const double common_16 = kappa_a + kappa_d; /* fact: definition spun.excess_spun; (5) */
        const double excess_spun = fused(E_t, common_13 * common_13, fused(common_14, swung, Omega_b0 * Omega_b0 * fused(E_t, common_16, lag))); /* fact: definition spun.excess_spun; (5) */
        const double spinning = choose(C_t, 0.0, 0.0, k); /* arithmetic */
        const double excess_b = choose(spinning, common_16, any_excess_b, excess_spun); /* arithmetic */
        const double excess_a = alpha_a * excess_b / alpha_divisor; /* fact: definition excesses.excess_a; (5) */
        const double excess_d = alpha_d * excess_b / alpha_divisor; /* fact: definition excesses.excess_d; (5) */
        Omega_a_by_Omega_a_out[i] = Omega_a_by_Omega_a;
        Omega_a_by_Omega_b_out[i] = Omega_a_by_Omega_b;
        Omega_a_by_Omega_d_out[i] = Omega_a_by_Omega_d;
        Omega_a_by_c_a_out[i] = Omega_a_by_c_a;
        Omega_a_by_c_b_out[i] = Omega_a_by_c_b;
        Omega_a_by_c_d_out[i] = Omega_a_by_c_d;
        Omega_b_by_Omega_a_out[i] = Omega_b_by_Omega_a;
        Omega_b_by_Omega_b_out[i] = Omega_b_by_Omega_b;
        Omega_b_by_Omega_d_out[i] = Omega_b_by_Omega_d;
        Omega_b_by_c_a_out[i] = Omega_b_by_c_a;
        Omega_b_by_c_b_out[i] = Omega_b_by_c_b;
        Omega_b_by_c_d_out[i] = Omega_b_by_c_d;
        Omega_d_by_Omega_a_out[i] = Omega_d_by_Omega_a;
        Omega_d_by_Omega_b_out[i] = Omega_d_by_Omega_b;
        Omega_d_by_Omega_d_out[i] = Omega_d_by_Omega_d;
        Omega_d_by_c_a_out[i] = Omega_d_by_c_a;
        Omega_d_by_c_b_out[i] = Omega_d_by_c_b;
        Omega_d_by_c_d_out[i] = Omega_d_by_c_d;
        excess_a_out[i] = excess_a;
        excess_b_out[i] = excess_b;
        excess_d_out[i] = excess_d;
    }
}

/* Constants of the elapsed time for m <= 1/2, from `_moduli`. */
static void real_constants(double_double p, double_double r, double_double apart,
    double_double lambda_, double_double divisor, double_double modulus, double_double complement,
    torque_free_real *motion)
{
    const double_double ratio = root_ratio(modulus, complement); /* classical: DLMF 20.9.1 */
    const double_double root_nome = dd_div_xx(modulus, ratio); /* classical: DLMF 20.9.1 */
    const double_double Q = dd_mul_xx(root_nome, root_nome); /* classical: DLMF 20.9.1 */
    const double_double Q2 = dd_mul_xx(Q, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double Q4 = dd_mul_xx(Q2, Q2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double Q6 = dd_mul_xx(Q4, Q2); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double common_1 = dd_mul_xx(Q4, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double Q9 = dd_mul_xx(common_1, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double Q12 = dd_mul_xx(Q6, Q6); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double Q16 = dd_mul_xx(Q12, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double Q20 = dd_mul_xx(Q16, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double common_2 = dd_mul_dx(2.0, Q4); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
    const double_double common_3 = dd_mul_dx(2.0, Q16); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
    const double_double even_0 = dd_add_xx(dd_sub_dx(1.0, common_2), common_3); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double common_4 = dd_mul_dx(16.0, Q16); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double even_1 = dd_sub_xx(dd_mul_dx(4.0, Q4), common_4); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double even_2 = common_4; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double common_5 = dd_mul_dx(2.0, Q); /* classical: DLMF 20.2.1, DLMF 20.2.4, DLMF 20.2.3 */
    const double_double odd_0 = dd_sub_xx(common_5, dd_mul_dx(6.0, Q9)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double odd_1 = dd_mul_dx(8.0, Q9); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double sine_even_0 = dd_add_xx(dd_add_xx(dd_sub_xx(dd_sub_dx(1.0, Q2), Q6), Q12), Q20); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double common_6 = dd_mul_dx(4.0, Q12); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double sine_even_1 = dd_sub_xx(dd_sub_xx(dd_mul_dx(4.0, Q6), common_6), dd_mul_dx(12.0, Q20)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double sine_even_2 = dd_mul_dx(16.0, Q20); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double sine_odd_0 = dd_sub_xx(dd_add_xx(dd_add_xx(dd_mul_dx(-2.0, Q2), dd_mul_dx(2.0, Q6)), common_6), dd_mul_dx(4.0, Q20)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double sine_odd_1 = dd_add_xx(dd_mul_dx(-8.0, Q12), dd_mul_dx(8.0, Q20)); /* classical: DLMF 20.2.1, DLMF 20.2.4 */
    const double_double two = dd_add_xx(dd_add_xx(dd_add_xx(dd_add_dx(1.0, Q2), Q6), Q12), Q20); /* classical: DLMF 20.2.2 */
    const double_double even_sum = dd_add_xx(dd_add_dx(1.0, common_2), common_3); /* classical: DLMF 20.2.3 */
    const double_double common_7 = dd_mul_dx(2.0, Q9); /* classical: DLMF 20.2.3 */
    const double_double odd_sum = dd_add_xx(dd_add_xx(common_5, common_7), dd_mul_xx(common_7, Q16)); /* classical: DLMF 20.2.3 */
    const double_double three = dd_add_xx(even_sum, odd_sum); /* classical: DLMF 20.2.3 */
    const double_double four = dd_sub_xx(even_sum, odd_sum); /* classical: DLMF 20.2.4 */
    const double_double g = dd_div_dx(1.0, dd_mul_xx(three, three)); /* classical: DLMF 20.9.2 */
    const double_double v_rate = dd_div_xx(dd_mul_xx(lambda_, g), pi); /* arithmetic */
    const double_double over_lambda = dd_div_dx(1.0, dd_sqrt(divisor)); /* classical: DLMF 22.2.4 */
    const double_double gain_S = dd_mul_xx(dd_div_xx(three, two), over_lambda); /* classical: DLMF 22.2.4 */
    const double_double gain_C = dd_div_xx(four, two); /* classical: DLMF 22.2.5 */
    const double_double gain_D = dd_div_xx(four, three); /* classical: DLMF 22.2.6 */
    const double_double Q_over_m = dd_div_dx(1.0, dd_mul_xx(ratio, ratio)); /* classical: DLMF 22.16.30 */
    const double_double Q8 = common_1; /* classical: DLMF 20.2.4 */
    const double_double per_square = dd_mul_xx(dd_mul_xx(Q_over_m, g), dd_mul_xx(over_lambda, over_lambda)); /* classical: DLMF 22.16.30 */
    const double_double common_8 = dd_mul_xx(Q, Q2); /* classical: DLMF 22.16.30, DLMF 20.2.4 */
    const double_double E_rate = dd_div_xx(dd_mul_xx(dd_mul_xx(dd_mul_dx(8.0, g), per_square), dd_add_xx(dd_sub_dx(1.0, dd_mul_dx(4.0, common_8)), dd_mul_dx(9.0, Q8))), four); /* classical: DLMF 22.16.30 */
    const double_double per_cube = dd_mul_xx(dd_mul_dx(4.0, per_square), over_lambda); /* classical: DLMF 22.16.30 */
    const double_double slope_0 = dd_mul_xx(per_cube, dd_sub_dx(1.0, dd_mul_dx(3.0, Q8))); /* classical: DLMF 20.2.4 */
    const double_double slope_1 = dd_neg(dd_mul_xx(dd_mul_dx(4.0, per_cube), common_8)); /* classical: DLMF 20.2.4 */
    const double_double slope_2 = dd_mul_xx(dd_mul_dx(12.0, per_cube), Q8); /* classical: DLMF 20.2.4 */
    const double p_d = dd_rounded(p); /* arithmetic */
    const double r_d = dd_rounded(r); /* arithmetic */
    const double apart_d = dd_rounded(apart); /* arithmetic */
    const double E_one = -4.0 * (p_d + r_d); /* classical: DLMF 22.10 */
    const double E_two = 6.0 * (p_d * r_d); /* classical: DLMF 22.10 */
    const double F_one = 4.0 * (r_d - apart_d); /* classical: DLMF 22.10 */
    const double F_two = -6.0 * (r_d * apart_d); /* classical: DLMF 22.10 */
    const double E_square_0 = 1.0; /* classical: DLMF 22.10 */
    const double common_9 = 1.0 / 3.0; /* classical: DLMF 22.10 */
    const double E_0 = common_9; /* classical: DLMF 22.10 */
    const double E_square_1 = E_one * E_square_0 / 12.0; /* classical: DLMF 22.10 */
    const double E_1 = E_square_1 / 5.0; /* classical: DLMF 22.10 */
    const double E_square_2 = fused(E_one, E_square_1, E_two * (E_square_0 * E_square_0)) / 30.0; /* classical: DLMF 22.10 */
    const double E_2 = E_square_2 / 7.0; /* classical: DLMF 22.10 */
    const double E_square_3 = fused(E_one, E_square_2, E_two * fused(E_square_0, E_square_1, E_square_1 * E_square_0)) / 56.0; /* classical: DLMF 22.10 */
    const double E_3 = E_square_3 / 9.0; /* classical: DLMF 22.10 */
    const double E_square_4 = fused(E_one, E_square_3, E_two * fused(E_square_2, E_square_0, fused(E_square_0, E_square_2, E_square_1 * E_square_1))) / 90.0; /* classical: DLMF 22.10 */
    const double E_4 = E_square_4 / 11.0; /* classical: DLMF 22.10 */
    const double E_square_5 = fused(E_one, E_square_4, E_two * fused(E_square_3, E_square_0, fused(E_square_2, E_square_1, fused(E_square_0, E_square_3, E_square_1 * E_square_2)))) / 132.0; /* classical: DLMF 22.10 */
    const double E_5 = E_square_5 / 13.0; /* classical: DLMF 22.10 */
    const double E_square_6 = fused(E_one, E_square_5, E_two * fused(E_square_4, E_square_0, fused(E_square_3, E_square_1, fused(E_square_2, E_square_2, fused(E_square_0, E_square_4, E_square_1 * E_square_3))))) / 182.0; /* classical: DLMF 22.10 */
    const double E_6 = E_square_6 / 15.0; /* classical: DLMF 22.10 */
    const double E_square_7 = fused(E_one, E_square_6, E_two * fused(E_square_5, E_square_0, fused(E_square_4, E_square_1, fused(E_square_3, E_square_2, fused(E_square_2, E_square_3, fused(E_square_0, E_square_5, E_square_1 * E_square_4)))))) / 240.0; /* classical: DLMF 22.10 */
    const double E_7 = E_square_7 / 17.0; /* classical: DLMF 22.10 */
    const double E_square_8 = fused(E_one, E_square_7, E_two * fused(E_square_6, E_square_0, fused(E_square_5, E_square_1, fused(E_square_4, E_square_2, fused(E_square_3, E_square_3, fused(E_square_2, E_square_4, fused(E_square_0, E_square_6, E_square_1 * E_square_5))))))) / 306.0; /* classical: DLMF 22.10 */
    const double E_8 = E_square_8 / 19.0; /* classical: DLMF 22.10 */
    const double E_square_9 = fused(E_one, E_square_8, E_two * fused(E_square_7, E_square_0, fused(E_square_6, E_square_1, fused(E_square_5, E_square_2, fused(E_square_4, E_square_3, fused(E_square_3, E_square_4, fused(E_square_2, E_square_5, fused(E_square_0, E_square_7, E_square_1 * E_square_6)))))))) / 380.0; /* classical: DLMF 22.10 */
    const double E_9 = E_square_9 / 21.0; /* classical: DLMF 22.10 */
    const double F_square_0 = 1.0; /* classical: DLMF 22.10 */
    const double F_0 = common_9; /* classical: DLMF 22.10 */
    const double F_square_1 = F_one * F_square_0 / 12.0; /* classical: DLMF 22.10 */
    const double F_1 = F_square_1 / 5.0; /* classical: DLMF 22.10 */
    const double F_square_2 = fused(F_one, F_square_1, F_two * (F_square_0 * F_square_0)) / 30.0; /* classical: DLMF 22.10 */
    const double F_2 = F_square_2 / 7.0; /* classical: DLMF 22.10 */
    const double F_square_3 = fused(F_one, F_square_2, F_two * fused(F_square_0, F_square_1, F_square_1 * F_square_0)) / 56.0; /* classical: DLMF 22.10 */
    const double F_3 = F_square_3 / 9.0; /* classical: DLMF 22.10 */
    const double F_square_4 = fused(F_one, F_square_3, F_two * fused(F_square_2, F_square_0, fused(F_square_0, F_square_2, F_square_1 * F_square_1))) / 90.0; /* classical: DLMF 22.10 */
    const double F_4 = F_square_4 / 11.0; /* classical: DLMF 22.10 */
    const double F_square_5 = fused(F_one, F_square_4, F_two * fused(F_square_3, F_square_0, fused(F_square_2, F_square_1, fused(F_square_0, F_square_3, F_square_1 * F_square_2)))) / 132.0; /* classical: DLMF 22.10 */
    const double F_5 = F_square_5 / 13.0; /* classical: DLMF 22.10 */
    const double F_square_6 = fused(F_one, F_square_5, F_two * fused(F_square_4, F_square_0, fused(F_square_3, F_square_1, fused(F_square_2, F_square_2, fused(F_square_0, F_square_4, F_square_1 * F_square_3))))) / 182.0; /* classical: DLMF 22.10 */
    const double F_6 = F_square_6 / 15.0; /* classical: DLMF 22.10 */
    const double F_square_7 = fused(F_one, F_square_6, F_two * fused(F_square_5, F_square_0, fused(F_square_4, F_square_1, fused(F_square_3, F_square_2, fused(F_square_2, F_square_3, fused(F_square_0, F_square_5, F_square_1 * F_square_4)))))) / 240.0; /* classical: DLMF 22.10 */
    const double F_7 = F_square_7 / 17.0; /* classical: DLMF 22.10 */
    const double F_square_8 = fused(F_one, F_square_7, F_two * fused(F_square_6, F_square_0, fused(F_square_5, F_square_1, fused(F_square_4, F_square_2, fused(F_square_3, F_square_3, fused(F_square_2, F_square_4, fused(F_square_0, F_square_6, F_square_1 * F_square_5))))))) / 306.0; /* classical: DLMF 22.10 */
    const double F_8 = F_square_8 / 19.0; /* classical: DLMF 22.10 */
    const double F_square_9 = fused(F_one, F_square_8, F_two * fused(F_square_7, F_square_0, fused(F_square_6, F_square_1, fused(F_square_5, F_square_2, fused(F_square_4, F_square_3, fused(F_square_3, F_square_4, fused(F_square_2, F_square_5, fused(F_square_0, F_square_7, F_square_1 * F_square_6)))))))) / 380.0; /* classical: DLMF 22.10 */
    const double F_9 = F_square_9 / 21.0; /* classical: DLMF 22.10 */
    motion->v_rate_hi = v_rate.hi;
    motion->v_rate_lo = v_rate.lo;
    motion->even_0 = dd_rounded(even_0);
    motion->even_1 = dd_rounded(even_1);
    motion->even_2 = dd_rounded(even_2);
    motion->odd_0 = dd_rounded(odd_0);
    motion->odd_1 = dd_rounded(odd_1);
    motion->sine_even_0 = dd_rounded(sine_even_0);
    motion->sine_even_1 = dd_rounded(sine_even_1);
    motion->sine_even_2 = dd_rounded(sine_even_2);
    motion->sine_odd_0 = dd_rounded(sine_odd_0);
    motion->sine_odd_1 = dd_rounded(sine_odd_1);
    motion->gain_S = dd_rounded(gain_S);
    motion->gain_C = dd_rounded(gain_C);
    motion->gain_D = dd_rounded(gain_D);
    motion->E_rate = dd_rounded(E_rate);
    motion->slope_0 = dd_rounded(slope_0);
    motion->slope_1 = dd_rounded(slope_1);
    motion->slope_2 = dd_rounded(slope_2);
    motion->p = dd_rounded(p);
    motion->apart = dd_rounded(apart);
    motion->E_0 = E_0;
    motion->E_1 = E_1;
    motion->E_2 = E_2;
    motion->E_3 = E_3;
    motion->E_4 = E_4;
    motion->E_5 = E_5;
    motion->E_6 = E_6;
    motion->E_7 = E_7;
    motion->E_8 = E_8;
    motion->E_9 = E_9;
    motion->F_0 = F_0;
    motion->F_1 = F_1;
    motion->F_2 = F_2;
    motion->F_3 = F_3;
    motion->F_4 = F_4;
    motion->F_5 = F_5;
    motion->F_6 = F_6;
    motion->F_7 = F_7;
    motion->F_8 = F_8;
    motion->F_9 = F_9;
}

/* Angles of the elapsed time t + t_lo for m <= 1/2. */
static void real_angles(const torque_free_real *motion, size_t n, const double *restrict t_in,
    const double *restrict t_lo_in, double *restrict sin_v_out, double *restrict cos_v_out)
{
    const double v_rate_hi = motion->v_rate_hi;
    const double v_rate_lo = motion->v_rate_lo;
    for (size_t i = 0; i < n; i++) {
        const double t = t_in[i];
        const double t_lo = t_lo_in[i];
        const double v = v_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double v_error = product_error(v_rate_hi, t, v) + fused(v_rate_lo, t, v_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
        const double v_whole = nearest(v); /* classical: DLMF 4.16 */
        const double v_rest = v - v_whole; /* arithmetic: DLMF 4.16, Sterbenz 1974 */
        const double v_turns = v_rest + v_error; /* classical: DLMF 4.16 */
        const double v_side = choose(0.0, v_rest, 1.0, -1.0); /* classical: DLMF 4.16 */
        const double v_left = fused(-v_side, v_error, 1.0 / 2.0 - fabs(v_rest)); /* classical: DLMF 4.21.10 */
        const double v_sign = alternating(v_whole); /* classical: DLMF 4.16 */
        const double v_turns_square = v_turns * v_turns; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double sin_v = v_sign * fused(v_turns, pi_hi, v_turns * fused(v_turns_square, fused(v_turns_square, fused(v_turns_square, fused(v_turns_square, fused(v_turns_square, fused(v_turns_square, fused(v_turns_square, fused(v_turns_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        const double v_left_square = v_left * v_left; /* classical: DLMF 4.19.1, DLMF 4.19.2 */
        const double cos_v = v_sign * fused(v_left, pi_hi, v_left * fused(v_left_square, fused(v_left_square, fused(v_left_square, fused(v_left_square, fused(v_left_square, fused(v_left_square, fused(v_left_square, fused(v_left_square, sine_7, sine_6), sine_5), sine_4), sine_3), sine_2), sine_1), sine_0), pi_lo)); /* classical: DLMF 4.19.1 */
        sin_v_out[i] = sin_v;
        cos_v_out[i] = cos_v;
    }
}

/* S_t, C_t, D_t, E_t and D_t F_t for m <= 1/2. */
static void real_state(const torque_free_real *motion, size_t n, const double *restrict sin_v_in,
    const double *restrict cos_v_in, const double *restrict t_in, double *restrict S_t_out,
    double *restrict C_t_out, double *restrict D_t_out, double *restrict E_t_out,
    double *restrict f_out, double *restrict passed_out, double *restrict turned_out)
{
    const double even_0 = motion->even_0;
    const double even_1 = motion->even_1;
    const double even_2 = motion->even_2;
    const double odd_0 = motion->odd_0;
    const double odd_1 = motion->odd_1;
    const double sine_even_0 = motion->sine_even_0;
    const double sine_even_1 = motion->sine_even_1;
    const double sine_even_2 = motion->sine_even_2;
    const double sine_odd_0 = motion->sine_odd_0;
    const double sine_odd_1 = motion->sine_odd_1;
    const double gain_S = motion->gain_S;
    const double gain_C = motion->gain_C;
    const double gain_D = motion->gain_D;
    const double E_rate = motion->E_rate;
    const double slope_0 = motion->slope_0;
    const double slope_1 = motion->slope_1;
    const double slope_2 = motion->slope_2;
    const double p = motion->p;
    const double apart = motion->apart;
    const double E_0 = motion->E_0;
    const double E_1 = motion->E_1;
    const double E_2 = motion->E_2;
    const double E_3 = motion->E_3;
    const double E_4 = motion->E_4;
    const double E_5 = motion->E_5;
    const double E_6 = motion->E_6;
    const double E_7 = motion->E_7;
    const double E_8 = motion->E_8;
    const double E_9 = motion->E_9;
    const double F_0 = motion->F_0;
    const double F_1 = motion->F_1;
    const double F_2 = motion->F_2;
    const double F_3 = motion->F_3;
    const double F_4 = motion->F_4;
    const double F_5 = motion->F_5;
    const double F_6 = motion->F_6;
    const double F_7 = motion->F_7;
    const double F_8 = motion->F_8;
    const double F_9 = motion->F_9;
    for (size_t i = 0; i < n; i++) {
        const double sin_v = sin_v_in[i];
        const double cos_v = cos_v_in[i];
        const double t = t_in[i];
        const double x = fused(-2.0, sin_v * sin_v, 1.0); /* classical: DLMF 4.21.27 */
        const double x2 = x * x; /* classical: DLMF 20.2.1, DLMF 20.2.4 */
        const double sum_even = fused(x2, fused(x2, even_2, even_1), even_0); /* classical: DLMF 20.2.4 */
        const double sum_odd = x * fused(x2, odd_1, odd_0); /* classical: DLMF 20.2.4 */
        const double theta4_v = sum_even - sum_odd; /* classical: DLMF 20.2.4 */
        const double theta3_v = sum_even + sum_odd; /* classical: DLMF 20.2.3 */
        const double part_even = fused(x2, fused(x2, sine_even_2, sine_even_1), sine_even_0); /* classical: DLMF 20.2.1 */
        const double part_odd = x * fused(x2, sine_odd_1, sine_odd_0); /* classical: DLMF 20.2.1 */
        const double theta1_v = sin_v * (part_even + part_odd); /* classical: DLMF 20.2.1 */
        const double theta2_v = cos_v * (part_even - part_odd); /* classical: DLMF 20.2.2 */
        const double over = 1.0 / theta4_v; /* arithmetic */
        const double t2 = t * t; /* classical: DLMF 22.10 */
        const double growth = p * t2; /* classical: DLMF 22.10 */
        const double S_t = choose(growth, 1.0 / 18014398509481984.0, t, gain_S * (theta1_v * over)); /* classical: DLMF 22.2.4 */
        const double C_t = gain_C * (theta2_v * over); /* classical: DLMF 22.2.5 */
        const double D_t = gain_D * (theta3_v * over); /* classical: DLMF 22.2.6 */
        const double E_far = fused(E_rate, t, -(2.0 * (sin_v * cos_v) * fused(x, fused(x, slope_2, slope_1), slope_0) * over)); /* classical: DLMF 22.16.30 */
        const double common_1 = t * t2; /* classical: DLMF 22.10 */
        const double E_near = common_1 * fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, E_9, E_8), E_7), E_6), E_5), E_4), E_3), E_2), E_1), E_0); /* classical: DLMF 22.10 */
        const double F_near = common_1 * fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, F_9, F_8), F_7), F_6), F_5), F_4), F_3), F_2), F_1), F_0); /* classical: DLMF 22.10 */
        const double common_2 = 1.0 / 16.0; /* classical: DLMF 22.16.30 */
        const double E_t = choose(growth, common_2, E_near, E_far); /* classical: DLMF 22.16.30 */
        const double F_far = fused(-S_t, C_t / D_t, fused(-p, E_t, t)) / apart; /* fact: definition elapsed_F.F_t; (10) */
        const double F_t = choose(growth, common_2, F_near, F_far); /* classical: DLMF 22.16.30 */
        const double f = D_t * F_t; /* fact: definition varied_rates.f; (5) */
        const double passed = 0.0; /* arithmetic */
        const double turned = 0.0; /* arithmetic */
        S_t_out[i] = S_t;
        C_t_out[i] = C_t;
        D_t_out[i] = D_t;
        E_t_out[i] = E_t;
        f_out[i] = f;
        passed_out[i] = passed;
        turned_out[i] = turned;
    }
}

/* Constants of the elapsed time for m > 1/2, from `_moduli`. */
static void imaginary_constants(double_double p, double_double r, double_double apart,
    double_double lambda_, double_double modulus, double_double complement, double_double y0,
    torque_free_imaginary *motion)
{
    const double_double ratio = root_ratio(complement, modulus); /* classical: DLMF 20.9.1 */
    const double_double root_nome = dd_div_xx(complement, ratio); /* classical: DLMF 20.9.1 */
    const double_double nome2 = dd_mul_xx(root_nome, root_nome); /* classical: DLMF 20.9.1 */
    const double_double nome4 = dd_mul_xx(nome2, nome2); /* classical: DLMF 20.2.2 */
    const double_double nome6 = dd_mul_xx(nome4, nome2); /* classical: DLMF 20.2.2 */
    const double_double nome8 = dd_mul_xx(nome4, nome4); /* classical: DLMF 20.2.2 */
    const double_double nome12 = dd_mul_xx(nome8, nome4); /* classical: DLMF 20.2.2 */
    const double_double nome16 = dd_mul_xx(nome8, nome8); /* classical: DLMF 20.2.2 */
    const double_double nome18 = dd_mul_xx(nome12, nome6); /* classical: DLMF 20.2.2 */
    const double_double nome32 = dd_mul_xx(nome16, nome16); /* classical: DLMF 20.2.2 */
    const double_double two = dd_add_xx(dd_add_xx(dd_add_dx(1.0, nome4), nome12), dd_mul_xx(nome12, nome12)); /* classical: DLMF 20.2.2 */
    const double_double common_1 = dd_mul_dx(2.0, nome2); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
    const double_double common_2 = dd_mul_dx(2.0, nome8); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
    const double_double common_3 = dd_mul_dx(2.0, nome18); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
    const double_double common_4 = dd_mul_dx(2.0, nome32); /* classical: DLMF 20.2.3, DLMF 20.2.4 */
    const double_double three = dd_add_xx(dd_add_xx(dd_add_xx(dd_add_dx(1.0, common_1), common_2), common_3), common_4); /* classical: DLMF 20.2.3 */
    const double_double four = dd_add_xx(dd_sub_xx(dd_add_xx(dd_sub_dx(1.0, common_1), common_2), common_3), common_4); /* classical: DLMF 20.2.4 */
    const double_double g = dd_div_dx(1.0, dd_mul_xx(three, three)); /* classical: DLMF 20.9.2 */
    const double_double y_rate = dd_mul_xx(lambda_, g); /* arithmetic */
    const double nome_d = dd_rounded(nome2); /* classical: DLMF 20.2.2 */
    const double_double period = dd_neg(logarithm(dd_choose(nome_d, 0.0, dd_of(1.0), nome2))); /* classical: DLMF 20.2.2 */
    const double period_far = choose(nome_d, 0.0, never, dd_rounded(period)); /* classical: DLMF 20.2.7 */
    const double period_d = dd_rounded(dd_choose(nome_d, 0.0, dd_of(1.0), period)); /* classical: DLMF 20.2.7 */
    const double period_inverse = choose(nome_d, 0.0, 0.0, 1.0 / period_d); /* classical: DLMF 20.2.7 */
    const double_double over_lambda = dd_div_dx(1.0, lambda_); /* classical: DLMF 22.2.4 */
    const double_double gain_S = dd_mul_xx(dd_div_xx(three, four), over_lambda); /* classical: DLMF 22.2.4 */
    const double_double gain_C = dd_div_xx(two, four); /* classical: DLMF 22.2.5 */
    const double_double gain_D = dd_div_xx(two, three); /* classical: DLMF 22.2.6 */
    const double_double scale = dd_div_xx(dd_mul_xx(dd_div_xx(dd_mul_dx(8.0, g), dd_mul_xx(ratio, ratio)), over_lambda), r); /* classical: DLMF 22.16.30 */
    const double_double f_gain = dd_mul_xx(scale, gain_D); /* classical: DLMF 22.16.30 */
    const double_double f_rate = dd_div_xx(dd_mul_xx(scale, dd_add_xx(dd_add_dx(1.0, dd_mul_dx(4.0, nome6)), dd_mul_dx(9.0, nome16))), three); /* classical: DLMF 22.16.30 */
    const double_double m_1 = dd_mul_xx(complement, complement); /* classical: DLMF 19.2.8 */
    const double_double m_safe = dd_choose(nome_d, 0.0, dd_of(1.0), m_1); /* classical: DLMF 22.16.30 */
    const double_double whole = dd_choose(nome_d, 0.0, dd_of(0.0), dd_div_xx(dd_mul_xx(dd_div_xx(dd_mul_dx(2.0, g), m_safe), over_lambda), r)); /* classical: DLMF 22.16.30 */
    const double_double f_period = dd_sub_xx(whole, dd_mul_xx(f_rate, period)); /* classical: DLMF 22.16.30 */
    const double_double passed_gain = dd_div_xd(dd_mul_xx(r, scale), 2.0); /* classical: DLMF 22.16.30 */
    const double_double passed_rate = dd_mul_xx(r, f_rate); /* classical: DLMF 22.16.30 */
    const double_double passed_period = dd_mul_xx(r, f_period); /* classical: DLMF 22.16.30 */
    const double_double z0 = dd_mul_dx(2.0, y0); /* classical: DLMF 20.7.12 */
    const double start = dd_rounded(z0); /* arithmetic */
    const double start_lo = dd_rounded(dd_sub_xd(z0, start)); /* arithmetic */
    const double period_rest = dd_rounded(dd_choose(nome_d, 0.0, dd_of(0.0), dd_sub_xd(period, period_far))); /* arithmetic */
    const double start_side = choose(0.0, start, 1.0, -1.0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
    const double start_depth = 2.0 * fabs(start); /* classical: DLMF 20.2.2 */
    const double start_more = 2.0 * (start_side * start_lo); /* classical: DLMF 20.2.2 */
    const double start_w2 = exponential(-start_depth) * (1.0 - start_more); /* classical: DLMF 20.2.2 */
    const double start_p2 = exponential(start_depth - period_far) * (1.0 + (start_more - period_rest)); /* classical: DLMF 20.2.2 */
    const double common_5 = start_w2 * start_w2; /* classical: DLMF 22.16.30, DLMF 20.2.3 */
    const double common_6 = start_p2 * start_p2; /* classical: DLMF 22.16.30, DLMF 20.2.3 */
    const double_double common_7 = dd_mul_xd(nome12, common_6); /* classical: DLMF 22.16.30, DLMF 20.2.3 */
    const double_double start_rise = dd_add_xx(dd_add_dx((1.0 - common_5) / 2.0, dd_sub_xx(dd_mul_xd(nome4, start_p2), dd_mul_xd(nome6, common_5 * start_w2))), dd_div_xd(dd_mul_dx(3.0, dd_sub_xx(common_7, dd_mul_xd(nome16, common_5 * common_5))), 2.0)); /* classical: DLMF 22.16.30 */
    const double_double start_theta = dd_add_xx(dd_add_xx(dd_add_dx(1.0, dd_mul_xd(nome4, common_6)), dd_mul_dx(common_5, nome8)), dd_add_xx(dd_mul_dx(start_p2, dd_add_dx(1.0, common_7)), dd_mul_dx(start_w2, dd_add_xx(nome2, dd_mul_xd(nome18, common_5))))); /* classical: DLMF 20.2.3 */
    const double_double passed_0 = dd_add_xx(dd_mul_xx(dd_mul_xd(passed_gain, start_side), dd_div_xx(start_rise, dd_mul_dx(start_w2, start_theta))), dd_mul_xd(dd_neg(passed_rate), start)); /* classical: DLMF 22.16.30 */
    const double p_d = dd_rounded(p); /* arithmetic */
    const double r_d = dd_rounded(r); /* arithmetic */
    const double apart_d = dd_rounded(apart); /* arithmetic */
    const double E_one = -4.0 * (p_d + r_d); /* classical: DLMF 22.10 */
    const double E_two = 6.0 * (p_d * r_d); /* classical: DLMF 22.10 */
    const double F_one = 4.0 * (r_d - apart_d); /* classical: DLMF 22.10 */
    const double F_two = -6.0 * (r_d * apart_d); /* classical: DLMF 22.10 */
    const double E_square_0 = 1.0; /* classical: DLMF 22.10 */
    const double common_8 = 1.0 / 3.0; /* classical: DLMF 22.10 */
    const double E_0 = common_8; /* classical: DLMF 22.10 */
    const double E_square_1 = E_one * E_square_0 / 12.0; /* classical: DLMF 22.10 */
    const double E_1 = E_square_1 / 5.0; /* classical: DLMF 22.10 */
    const double E_square_2 = fused(E_one, E_square_1, E_two * (E_square_0 * E_square_0)) / 30.0; /* classical: DLMF 22.10 */
    const double E_2 = E_square_2 / 7.0; /* classical: DLMF 22.10 */
    const double E_square_3 = fused(E_one, E_square_2, E_two * fused(E_square_0, E_square_1, E_square_1 * E_square_0)) / 56.0; /* classical: DLMF 22.10 */
    const double E_3 = E_square_3 / 9.0; /* classical: DLMF 22.10 */
    const double E_square_4 = fused(E_one, E_square_3, E_two * fused(E_square_2, E_square_0, fused(E_square_0, E_square_2, E_square_1 * E_square_1))) / 90.0; /* classical: DLMF 22.10 */
    const double E_4 = E_square_4 / 11.0; /* classical: DLMF 22.10 */
    const double E_square_5 = fused(E_one, E_square_4, E_two * fused(E_square_3, E_square_0, fused(E_square_2, E_square_1, fused(E_square_0, E_square_3, E_square_1 * E_square_2)))) / 132.0; /* classical: DLMF 22.10 */
    const double E_5 = E_square_5 / 13.0; /* classical: DLMF 22.10 */
    const double E_square_6 = fused(E_one, E_square_5, E_two * fused(E_square_4, E_square_0, fused(E_square_3, E_square_1, fused(E_square_2, E_square_2, fused(E_square_0, E_square_4, E_square_1 * E_square_3))))) / 182.0; /* classical: DLMF 22.10 */
    const double E_6 = E_square_6 / 15.0; /* classical: DLMF 22.10 */
    const double E_square_7 = fused(E_one, E_square_6, E_two * fused(E_square_5, E_square_0, fused(E_square_4, E_square_1, fused(E_square_3, E_square_2, fused(E_square_2, E_square_3, fused(E_square_0, E_square_5, E_square_1 * E_square_4)))))) / 240.0; /* classical: DLMF 22.10 */
    const double E_7 = E_square_7 / 17.0; /* classical: DLMF 22.10 */
    const double E_square_8 = fused(E_one, E_square_7, E_two * fused(E_square_6, E_square_0, fused(E_square_5, E_square_1, fused(E_square_4, E_square_2, fused(E_square_3, E_square_3, fused(E_square_2, E_square_4, fused(E_square_0, E_square_6, E_square_1 * E_square_5))))))) / 306.0; /* classical: DLMF 22.10 */
    const double E_8 = E_square_8 / 19.0; /* classical: DLMF 22.10 */
    const double E_square_9 = fused(E_one, E_square_8, E_two * fused(E_square_7, E_square_0, fused(E_square_6, E_square_1, fused(E_square_5, E_square_2, fused(E_square_4, E_square_3, fused(E_square_3, E_square_4, fused(E_square_2, E_square_5, fused(E_square_0, E_square_7, E_square_1 * E_square_6)))))))) / 380.0; /* classical: DLMF 22.10 */
    const double E_9 = E_square_9 / 21.0; /* classical: DLMF 22.10 */
    const double F_square_0 = 1.0; /* classical: DLMF 22.10 */
    const double F_0 = common_8; /* classical: DLMF 22.10 */
    const double F_square_1 = F_one * F_square_0 / 12.0; /* classical: DLMF 22.10 */
    const double F_1 = F_square_1 / 5.0; /* classical: DLMF 22.10 */
    const double F_square_2 = fused(F_one, F_square_1, F_two * (F_square_0 * F_square_0)) / 30.0; /* classical: DLMF 22.10 */
    const double F_2 = F_square_2 / 7.0; /* classical: DLMF 22.10 */
    const double F_square_3 = fused(F_one, F_square_2, F_two * fused(F_square_0, F_square_1, F_square_1 * F_square_0)) / 56.0; /* classical: DLMF 22.10 */
    const double F_3 = F_square_3 / 9.0; /* classical: DLMF 22.10 */
    const double F_square_4 = fused(F_one, F_square_3, F_two * fused(F_square_2, F_square_0, fused(F_square_0, F_square_2, F_square_1 * F_square_1))) / 90.0; /* classical: DLMF 22.10 */
    const double F_4 = F_square_4 / 11.0; /* classical: DLMF 22.10 */
    const double F_square_5 = fused(F_one, F_square_4, F_two * fused(F_square_3, F_square_0, fused(F_square_2, F_square_1, fused(F_square_0, F_square_3, F_square_1 * F_square_2)))) / 132.0; /* classical: DLMF 22.10 */
    const double F_5 = F_square_5 / 13.0; /* classical: DLMF 22.10 */
    const double F_square_6 = fused(F_one, F_square_5, F_two * fused(F_square_4, F_square_0, fused(F_square_3, F_square_1, fused(F_square_2, F_square_2, fused(F_square_0, F_square_4, F_square_1 * F_square_3))))) / 182.0; /* classical: DLMF 22.10 */
    const double F_6 = F_square_6 / 15.0; /* classical: DLMF 22.10 */
    const double F_square_7 = fused(F_one, F_square_6, F_two * fused(F_square_5, F_square_0, fused(F_square_4, F_square_1, fused(F_square_3, F_square_2, fused(F_square_2, F_square_3, fused(F_square_0, F_square_5, F_square_1 * F_square_4)))))) / 240.0; /* classical: DLMF 22.10 */
    const double F_7 = F_square_7 / 17.0; /* classical: DLMF 22.10 */
    const double F_square_8 = fused(F_one, F_square_7, F_two * fused(F_square_6, F_square_0, fused(F_square_5, F_square_1, fused(F_square_4, F_square_2, fused(F_square_3, F_square_3, fused(F_square_2, F_square_4, fused(F_square_0, F_square_6, F_square_1 * F_square_5))))))) / 306.0; /* classical: DLMF 22.10 */
    const double F_8 = F_square_8 / 19.0; /* classical: DLMF 22.10 */
    const double F_square_9 = fused(F_one, F_square_8, F_two * fused(F_square_7, F_square_0, fused(F_square_6, F_square_1, fused(F_square_5, F_square_2, fused(F_square_4, F_square_3, fused(F_square_3, F_square_4, fused(F_square_2, F_square_5, fused(F_square_0, F_square_7, F_square_1 * F_square_6)))))))) / 380.0; /* classical: DLMF 22.10 */
    const double F_9 = F_square_9 / 21.0; /* classical: DLMF 22.10 */
    motion->y_rate_hi = y_rate.hi;
    motion->y_rate_lo = y_rate.lo;
    motion->period_hi = period.hi;
    motion->period_lo = period.lo;
    motion->z0_hi = z0.hi;
    motion->z0_lo = z0.lo;
    motion->period_far = period_far;
    motion->period_inverse = period_inverse;
    motion->nome2 = dd_rounded(nome2);
    motion->nome4 = dd_rounded(nome4);
    motion->nome6 = dd_rounded(nome6);
    motion->nome8 = dd_rounded(nome8);
    motion->nome12 = dd_rounded(nome12);
    motion->nome16 = dd_rounded(nome16);
    motion->nome18 = dd_rounded(nome18);
    motion->gain_S = dd_rounded(gain_S);
    motion->gain_C = dd_rounded(gain_C);
    motion->gain_D = dd_rounded(gain_D);
    motion->f_gain = dd_rounded(f_gain);
    motion->f_rate = dd_rounded(f_rate);
    motion->f_period = dd_rounded(f_period);
    motion->p = dd_rounded(p);
    motion->apart = dd_rounded(apart);
    motion->passed_gain = dd_rounded(passed_gain);
    motion->passed_rate = dd_rounded(passed_rate);
    motion->passed_period = dd_rounded(passed_period);
    motion->passed_0 = dd_rounded(passed_0);
    motion->E_0 = E_0;
    motion->E_1 = E_1;
    motion->E_2 = E_2;
    motion->E_3 = E_3;
    motion->E_4 = E_4;
    motion->E_5 = E_5;
    motion->E_6 = E_6;
    motion->E_7 = E_7;
    motion->E_8 = E_8;
    motion->E_9 = E_9;
    motion->F_0 = F_0;
    motion->F_1 = F_1;
    motion->F_2 = F_2;
    motion->F_3 = F_3;
    motion->F_4 = F_4;
    motion->F_5 = F_5;
    motion->F_6 = F_6;
    motion->F_7 = F_7;
    motion->F_8 = F_8;
    motion->F_9 = F_9;
}

/* Angles of the elapsed time t + t_lo for m > 1/2. */
static void imaginary_angles(const torque_free_imaginary *motion, size_t n,
    const double *restrict t_in, const double *restrict t_lo_in, double *restrict w_out,
    double *restrict p2_out, double *restrict y_out, double *restrict side_out,
    double *restrict flip_out, double *restrict periods_out, double *restrict z_w2_out,
    double *restrict z_p2_out, double *restrict z_out, double *restrict z_side_out,
    double *restrict turns_out)
{
    const double y_rate_hi = motion->y_rate_hi;
    const double y_rate_lo = motion->y_rate_lo;
    const double period_hi = motion->period_hi;
    const double period_lo = motion->period_lo;
    const double z0_hi = motion->z0_hi;
    const double z0_lo = motion->z0_lo;
    const double period_far = motion->period_far;
    const double period_inverse = motion->period_inverse;
    for (size_t i = 0; i < n; i++) {
        const double t = t_in[i];
        const double t_lo = t_lo_in[i];
        const double p_y = y_rate_hi * t; /* arithmetic: Dekker 1971 */
        const double p_y_error = product_error(y_rate_hi, t, p_y) + fused(y_rate_lo, t, y_rate_hi * t_lo); /* arithmetic: Dekker 1971 */
        const double periods = nearest(p_y * period_inverse); /* classical: DLMF 20.2.7 */
        const double back = period_hi * periods; /* arithmetic: Dekker 1971 */
        const double back_error = fused(period_lo, periods, product_error(period_hi, periods, back)); /* arithmetic: Dekker 1971 */
        const double ahead = p_y + -back; /* arithmetic: Knuth 4.2.2 */
        const double ahead_other = ahead - p_y; /* arithmetic: Knuth 4.2.2 */
        const double ahead_error = p_y - (ahead - ahead_other) + (-back - ahead_other); /* arithmetic: Knuth 4.2.2 */
        const double y_rest = ahead_error + (p_y_error - back_error); /* classical: DLMF 20.2.7 */
        const double y = ahead + y_rest; /* classical: DLMF 20.2.7 */
        const double y_lo = ahead - y + y_rest; /* arithmetic: Knuth 4.2.2 */
        const double side = choose(0.0, y, 1.0, -1.0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double flip = alternating(periods); /* classical: DLMF 20.2.6 */
        const double depth = fabs(y); /* classical: DLMF 20.2.2 */
        const double more = side * y_lo; /* classical: DLMF 20.2.2 */
        const double w = exponential(-depth) * (1.0 - more); /* classical: DLMF 20.2.2 */
        const double p2 = exponential(fused(2.0, depth, -period_far)) * (1.0 + fused(2.0, more, -period_lo)); /* classical: DLMF 20.2.2 */
        const double turns = nearest((p_y + z0_hi) * period_inverse); /* classical: DLMF 20.2.7 */
        const double behind = period_hi * turns; /* arithmetic: Dekker 1971 */
        const double behind_error = fused(period_lo, turns, product_error(period_hi, turns, behind)); /* arithmetic: Dekker 1971 */
        const double beyond = p_y + -behind; /* arithmetic: Knuth 4.2.2 */
        const double beyond_other = beyond - p_y; /* arithmetic: Knuth 4.2.2 */
        const double beyond_error = p_y - (beyond - beyond_other) + (-behind - beyond_other); /* arithmetic: Knuth 4.2.2 */
        const double z_near = beyond + z0_hi; /* arithmetic: Knuth 4.2.2 */
        const double z_near_other = z_near - beyond; /* arithmetic: Knuth 4.2.2 */
        const double z_near_error = beyond - (z_near - z_near_other) + (z0_hi - z_near_other); /* arithmetic: Knuth 4.2.2 */
        const double z_rest = z_near_error + (beyond_error + (p_y_error + z0_lo - behind_error)); /* arithmetic */
        const double z = z_near + z_rest; /* classical: DLMF 20.2.7 */
        const double z_lo = z_near - z + z_rest; /* arithmetic: Knuth 4.2.2 */
        const double z_side = choose(0.0, z, 1.0, -1.0); /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double z_depth = 2.0 * fabs(z); /* classical: DLMF 20.2.2 */
        const double z_more = 2.0 * (z_side * z_lo); /* classical: DLMF 20.2.2 */
        const double z_w2 = exponential(-z_depth) * (1.0 - z_more); /* classical: DLMF 20.2.2 */
        const double z_p2 = exponential(z_depth - period_far) * (1.0 + (z_more - period_lo)); /* classical: DLMF 20.2.2 */
        w_out[i] = w;
        p2_out[i] = p2;
        y_out[i] = y;
        side_out[i] = side;
        flip_out[i] = flip;
        periods_out[i] = periods;
        z_w2_out[i] = z_w2;
        z_p2_out[i] = z_p2;
        z_out[i] = z;
        z_side_out[i] = z_side;
        turns_out[i] = turns;
    }
}

/* S_t, C_t, D_t, E_t, D_t F_t and the integral over the phase for m > 1/2. */
static void imaginary_state(const torque_free_imaginary *motion, size_t n,
    const double *restrict w_in, const double *restrict p2_in, const double *restrict y_in,
    const double *restrict side_in, const double *restrict flip_in,
    const double *restrict periods_in, const double *restrict z_w2_in,
    const double *restrict z_p2_in, const double *restrict z_in, const double *restrict z_side_in,
    const double *restrict turns_in, const double *restrict t_in, double *restrict S_t_out,
    double *restrict C_t_out, double *restrict D_t_out, double *restrict E_t_out,
    double *restrict f_out, double *restrict passed_out, double *restrict turned_out)
{
    const double nome2 = motion->nome2;
    const double nome4 = motion->nome4;
    const double nome6 = motion->nome6;
    const double nome8 = motion->nome8;
    const double nome12 = motion->nome12;
    const double nome16 = motion->nome16;
    const double nome18 = motion->nome18;
    const double gain_S = motion->gain_S;
    const double gain_C = motion->gain_C;
    const double gain_D = motion->gain_D;
    const double f_gain = motion->f_gain;
    const double f_rate = motion->f_rate;
    const double f_period = motion->f_period;
    const double p = motion->p;
    const double apart = motion->apart;
    const double passed_gain = motion->passed_gain;
    const double passed_rate = motion->passed_rate;
    const double passed_period = motion->passed_period;
    const double passed_0 = motion->passed_0;
    const double E_0 = motion->E_0;
    const double E_1 = motion->E_1;
    const double E_2 = motion->E_2;
    const double E_3 = motion->E_3;
    const double E_4 = motion->E_4;
    const double E_5 = motion->E_5;
    const double E_6 = motion->E_6;
    const double E_7 = motion->E_7;
    const double E_8 = motion->E_8;
    const double E_9 = motion->E_9;
    const double F_0 = motion->F_0;
    const double F_1 = motion->F_1;
    const double F_2 = motion->F_2;
    const double F_3 = motion->F_3;
    const double F_4 = motion->F_4;
    const double F_5 = motion->F_5;
    const double F_6 = motion->F_6;
    const double F_7 = motion->F_7;
    const double F_8 = motion->F_8;
    const double F_9 = motion->F_9;
    for (size_t i = 0; i < n; i++) {
        const double w = w_in[i];
        const double p2 = p2_in[i];
        const double y = y_in[i];
        const double side = side_in[i];
        const double flip = flip_in[i];
        const double periods = periods_in[i];
        const double z_w2 = z_w2_in[i];
        const double z_p2 = z_p2_in[i];
        const double z = z_in[i];
        const double z_side = z_side_in[i];
        const double turns = turns_in[i];
        const double t = t_in[i];
        const double common_1 = w * w; /* classical: DLMF 20.2.2, DLMF 20.2.1 */
        const double qw2 = nome2 * common_1; /* classical: DLMF 20.2.2 */
        const double w2 = common_1; /* classical: DLMF 20.2.1, DLMF 20.2.2 */
        const double tall = fused(p2, fused(p2, fused(p2, nome18, nome8), nome2), 1.0); /* classical: DLMF 20.2.2 */
        const double deep = w2 * fused(qw2, fused(qw2, fused(qw2, nome18, nome8), nome2), 1.0); /* classical: DLMF 20.2.2 */
        const double theta2_y = tall + deep; /* classical: DLMF 20.2.2 */
        const double tall_1 = fused(p2, fused(p2, fused(p2, -nome18, nome8), -nome2), 1.0); /* classical: DLMF 20.2.1 */
        const double deep_1 = w2 * fused(qw2, fused(qw2, fused(qw2, -nome18, nome8), -nome2), 1.0); /* classical: DLMF 20.2.1 */
        const double theta1_y = side * (tall_1 - deep_1); /* classical: DLMF 20.2.1 */
        const double common_2 = p2 * p2; /* classical: DLMF 20.2.3, DLMF 22.16.30 */
        const double common_3 = nome12 * common_2; /* classical: DLMF 20.2.3, DLMF 22.16.30 */
        const double common_4 = w2 * w2; /* classical: DLMF 20.2.3, DLMF 22.16.30 */
        const double ends = fused(p2, 1.0 + common_3, w2 * fused(nome18, common_4, nome2)); /* classical: DLMF 20.2.3 */
        const double middle = fused(common_4, nome8, fused(nome4, common_2, 1.0)); /* classical: DLMF 20.2.3 */
        const double theta3_y = 2.0 * (w * (middle + ends)); /* classical: DLMF 20.2.3 */
        const double theta4_y = 2.0 * (w * (middle - ends)); /* classical: DLMF 20.2.4 */
        const double over = 1.0 / theta2_y; /* arithmetic */
        const double t2 = t * t; /* classical: DLMF 22.10 */
        const double growth = p * t2; /* classical: DLMF 22.10 */
        const double S_near = t * sqrt(fabs(fused(3.0, E_0, t2 * fused(5.0, E_1, t2 * fused(7.0, E_2, t2 * fused(9.0, E_3, t2 * fused(11.0, E_4, t2 * fused(13.0, E_5, t2 * fused(15.0, E_6, t2 * fused(17.0, E_7, t2 * fused(19.0, E_8, t2 * 21.0 * E_9))))))))))); /* classical: DLMF 22.10 */
        const double common_5 = 1.0 / 16.0; /* classical: DLMF 22.2.4, DLMF 22.16.30 */
        const double S_t = choose(growth, common_5, S_near, gain_S * (flip * theta1_y * over)); /* classical: DLMF 22.2.4 */
        const double C_t = gain_C * (flip * theta4_y * over); /* classical: DLMF 22.2.5 */
        const double D_t = gain_D * (theta3_y * over); /* classical: DLMF 22.2.6 */
        const double rise = (1.0 - common_4) / 2.0 + fused(nome4, p2, -(nome6 * (common_4 * w2))) + 3.0 * fused(-nome16, common_4 * common_4, common_3) / 2.0; /* classical: DLMF 22.16.30 */
        const double f_far = fused(f_gain * side * (rise / w), over, D_t * fused(periods, f_period, -(f_rate * y))); /* classical: DLMF 22.16.30 */
        const double common_6 = t * t2; /* classical: DLMF 22.10 */
        const double E_near = common_6 * fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, E_9, E_8), E_7), E_6), E_5), E_4), E_3), E_2), E_1), E_0); /* classical: DLMF 22.10 */
        const double F_near = common_6 * fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, fused(t2, F_9, F_8), F_7), F_6), F_5), F_4), F_3), F_2), F_1), F_0); /* classical: DLMF 22.10 */
        const double f = choose(growth, common_5, D_t * F_near, f_far); /* classical: DLMF 22.16.30 */
        const double E_far = (fused(-S_t, C_t / D_t, t) - apart * f / D_t) / p; /* fact: definition elapsed_E.E_t; (10) */
        const double E_t = choose(growth, common_5, E_near, E_far); /* classical: DLMF 22.16.30 */
        const double common_7 = z_w2 * z_w2; /* classical: DLMF 22.16.30, DLMF 20.2.3 */
        const double common_8 = z_p2 * z_p2; /* classical: DLMF 22.16.30, DLMF 20.2.3 */
        const double common_9 = nome12 * common_8; /* classical: DLMF 22.16.30, DLMF 20.2.3 */
        const double z_rise = (1.0 - common_7) / 2.0 + fused(nome4, z_p2, -(nome6 * (common_7 * z_w2))) + 3.0 * fused(-nome16, common_7 * common_7, common_9) / 2.0; /* classical: DLMF 22.16.30 */
        const double z_theta = fused(common_7, nome8, fused(nome4, common_8, 1.0)) + fused(z_p2, 1.0 + common_9, z_w2 * fused(nome18, common_7, nome2)); /* classical: DLMF 20.2.3 */
        const double passed_z = fused(passed_gain * z_side, z_rise / (z_w2 * z_theta), fused(turns, passed_period, -(passed_rate * z))); /* classical: DLMF 22.16.30 */
        const double passed = passed_z - passed_0; /* classical: DLMF 22.16.30 */
        const double turned = fabs(turns); /* classical: DLMF 20.2.7 */
        S_t_out[i] = S_t;
        C_t_out[i] = C_t;
        D_t_out[i] = D_t;
        E_t_out[i] = E_t;
        f_out[i] = f;
        passed_out[i] = passed;
        turned_out[i] = turned;
    }
}

/* Constants of the attitude's sensitivities for a moving body. */
static void turn_constants(double c1, double c2, double c3, double c12, double c13, double c23,
    double Omega1_0, double Omega2_0, double Omega3_0, double p0, double p1, double p2, double p3,
    torque_free_turn *motion)
{
    const double common_1 = c1 * Omega1_0; /* fact: definition turned_columns_start.K_squared, definition turned_columns_start.n1_0; (3) */
    const double common_2 = c2 * Omega2_0; /* fact: definition turned_columns_start.K_squared, definition turned_columns_start.n2_0; (3) */
    const double common_3 = c3 * Omega3_0; /* fact: definition turned_columns_start.K_squared, definition turned_columns_start.n3_0; (3) */
    const double K_squared = fused(common_3, common_3, fused(common_1, common_1, common_2 * common_2)); /* fact: definition turned_columns_start.K_squared; (3) */
    const double per_K2 = 1.0 / K_squared; /* fact: definition turned_columns_start.per_K2; (3) */
    const double common_4 = p2 * p2; /* fact: definition turned_columns_start.P11, definition turned_columns_start.P33; (3) */
    const double common_5 = p3 * p3; /* fact: definition turned_columns_start.P11, definition turned_columns_start.P22; (3) */
    const double P11 = fused(-2.0, common_4 + common_5, 1.0); /* fact: definition turned_columns_start.P11; (3) */
    const double common_6 = p0 * p3; /* fact: definition turned_columns_start.P12, definition turned_columns_start.P21; (3) */
    const double common_7 = p1 * p2; /* fact: definition turned_columns_start.P12, definition turned_columns_start.P21; (3) */
    const double P12 = -2.0 * (common_6 - common_7); /* fact: definition turned_columns_start.P12; (3) */
    const double common_8 = p0 * p2; /* fact: definition turned_columns_start.P13, definition turned_columns_start.P31; (3) */
    const double common_9 = p1 * p3; /* fact: definition turned_columns_start.P13, definition turned_columns_start.P31; (3) */
    const double P13 = 2.0 * (common_8 + common_9); /* fact: definition turned_columns_start.P13; (3) */
    const double P21 = 2.0 * (common_6 + common_7); /* fact: definition turned_columns_start.P21; (3) */
    const double common_10 = p1 * p1; /* fact: definition turned_columns_start.P22, definition turned_columns_start.P33; (3) */
    const double P22 = fused(-2.0, common_10 + common_5, 1.0); /* fact: definition turned_columns_start.P22; (3) */
    const double common_11 = p0 * p1; /* fact: definition turned_columns_start.P23, definition turned_columns_start.P32; (3) */
    const double common_12 = p2 * p3; /* fact: definition turned_columns_start.P23, definition turned_columns_start.P32; (3) */
    const double P23 = -2.0 * (common_11 - common_12); /* fact: definition turned_columns_start.P23; (3) */
    const double P31 = -2.0 * (common_8 - common_9); /* fact: definition turned_columns_start.P31; (3) */
    const double P32 = 2.0 * (common_11 + common_12); /* fact: definition turned_columns_start.P32; (3) */
    const double P33 = fused(-2.0, common_10 + common_4, 1.0); /* fact: definition turned_columns_start.P33; (3) */
    const double n1_0 = common_1 * per_K2; /* fact: definition turned_columns_start.n1_0; (3) */
    const double n2_0 = common_2 * per_K2; /* fact: definition turned_columns_start.n2_0; (3) */
    const double n3_0 = common_3 * per_K2; /* fact: definition turned_columns_start.n3_0; (3) */
    const double l1 = fused(P13, n3_0, fused(P11, n1_0, P12 * n2_0)); /* fact: definition turned_columns_start.l1; (3) */
    const double l2 = fused(P23, n3_0, fused(P21, n1_0, P22 * n2_0)); /* fact: definition turned_columns_start.l2; (3) */
    const double l3 = fused(P33, n3_0, fused(P31, n1_0, P32 * n2_0)); /* fact: definition turned_columns_start.l3; (3) */
    const double B11 = fused(P12, n3_0, -(P13 * n2_0)); /* fact: definition turned_columns_start.B11; (3) */
    const double B12 = fused(P13, n1_0, -(P11 * n3_0)); /* fact: definition turned_columns_start.B12; (3) */
    const double B13 = fused(P11, n2_0, -(P12 * n1_0)); /* fact: definition turned_columns_start.B13; (3) */
    const double B21 = fused(P22, n3_0, -(P23 * n2_0)); /* fact: definition turned_columns_start.B21; (3) */
    const double B22 = fused(P23, n1_0, -(P21 * n3_0)); /* fact: definition turned_columns_start.B22; (3) */
    const double B23 = fused(P21, n2_0, -(P22 * n1_0)); /* fact: definition turned_columns_start.B23; (3) */
    const double B31 = fused(P32, n3_0, -(P33 * n2_0)); /* fact: definition turned_columns_start.B31; (3) */
    const double B32 = fused(P33, n1_0, -(P31 * n3_0)); /* fact: definition turned_columns_start.B32; (3) */
    const double B33 = fused(P31, n2_0, -(P32 * n1_0)); /* fact: definition turned_columns_start.B33; (3) */
    motion->c1 = c1;
    motion->c2 = c2;
    motion->c3 = c3;
    motion->c12 = c12;
    motion->c13 = c13;
    motion->c23 = c23;
    motion->Omega1_0 = Omega1_0;
    motion->Omega2_0 = Omega2_0;
    motion->Omega3_0 = Omega3_0;
    motion->per_K2 = per_K2;
    motion->l1 = l1;
    motion->l2 = l2;
    motion->l3 = l3;
    motion->B11 = B11;
    motion->B12 = B12;
    motion->B13 = B13;
    motion->B21 = B21;
    motion->B22 = B22;
    motion->B23 = B23;
    motion->B31 = B31;
    motion->B32 = B32;
    motion->B33 = B33;
}

/* Derivatives of the attitude by the inputs, and of the state by the time. */
static void turn_state(const torque_free_turn *motion, size_t n, const double *restrict q0_in,
    const double *restrict q1_in, const double *restrict q2_in, const double *restrict q3_in,
    const double *restrict Omega1_in, const double *restrict Omega2_in,
    const double *restrict Omega3_in, const double *restrict Omega1_by_Omega1_in,
    const double *restrict Omega1_by_Omega2_in, const double *restrict Omega1_by_Omega3_in,
    const double *restrict Omega1_by_c1_in, const double *restrict Omega1_by_c2_in,
    const double *restrict Omega1_by_c3_in, const double *restrict Omega2_by_Omega1_in,
    const double *restrict Omega2_by_Omega2_in, const double *restrict Omega2_by_Omega3_in,
    const double *restrict Omega2_by_c1_in, const double *restrict Omega2_by_c2_in,
    const double *restrict Omega2_by_c3_in, const double *restrict Omega3_by_Omega1_in,
    const double *restrict Omega3_by_Omega2_in, const double *restrict Omega3_by_Omega3_in,
    const double *restrict Omega3_by_c1_in, const double *restrict Omega3_by_c2_in,
    const double *restrict Omega3_by_c3_in, const double *restrict excess1_in,
    const double *restrict excess2_in, const double *restrict excess3_in,
    const double *restrict t_in, double *restrict eta1_by_Omega1_out,
    double *restrict eta1_by_Omega2_out, double *restrict eta1_by_Omega3_out,
    double *restrict eta1_by_c1_out, double *restrict eta1_by_c2_out,
    double *restrict eta1_by_c3_out, double *restrict eta2_by_Omega1_out,
    double *restrict eta2_by_Omega2_out, double *restrict eta2_by_Omega3_out,
    double *restrict eta2_by_c1_out, double *restrict eta2_by_c2_out,
    double *restrict eta2_by_c3_out, double *restrict eta3_by_Omega1_out,
    double *restrict eta3_by_Omega2_out, double *restrict eta3_by_Omega3_out,
    double *restrict eta3_by_c1_out, double *restrict eta3_by_c2_out,
    double *restrict eta3_by_c3_out, double *restrict eta1_by_t_out, double *restrict eta2_by_t_out,
    double *restrict eta3_by_t_out, double *restrict Omega1_by_t_out,
    double *restrict Omega2_by_t_out, double *restrict Omega3_by_t_out)
{
    const double c1 = motion->c1;
    const double c2 = motion->c2;
    const double c3 = motion->c3;
    const double c12 = motion->c12;
    const double c13 = motion->c13;
    const double c23 = motion->c23;
    const double Omega1_0 = motion->Omega1_0;
    const double Omega2_0 = motion->Omega2_0;
    const double Omega3_0 = motion->Omega3_0;
    const double per_K2 = motion->per_K2;
    const double l1 = motion->l1;
    const double l2 = motion->l2;
    const double l3 = motion->l3;
    const double B11 = motion->B11;
    const double B12 = motion->B12;
    const double B13 = motion->B13;
    const double B21 = motion->B21;
    const double B22 = motion->B22;
    const double B23 = motion->B23;
    const double B31 = motion->B31;
    const double B32 = motion->B32;
    const double B33 = motion->B33;
    for (size_t i = 0; i < n; i++) {
        const double q0 = q0_in[i];
        const double q1 = q1_in[i];
        const double q2 = q2_in[i];
        const double q3 = q3_in[i];
        const double Omega1 = Omega1_in[i];
        const double Omega2 = Omega2_in[i];
        const double Omega3 = Omega3_in[i];
        const double Omega1_by_Omega1 = Omega1_by_Omega1_in[i];
        const double Omega1_by_Omega2 = Omega1_by_Omega2_in[i];
        const double Omega1_by_Omega3 = Omega1_by_Omega3_in[i];
        const double Omega1_by_c1 = Omega1_by_c1_in[i];
        const double Omega1_by_c2 = Omega1_by_c2_in[i];
        const double Omega1_by_c3 = Omega1_by_c3_in[i];
        const double Omega2_by_Omega1 = Omega2_by_Omega1_in[i];
        const double Omega2_by_Omega2 = Omega2_by_Omega2_in[i];
        const double Omega2_by_Omega3 = Omega2_by_Omega3_in[i];
        const double Omega2_by_c1 = Omega2_by_c1_in[i];
        const double Omega2_by_c2 = Omega2_by_c2_in[i];
        const double Omega2_by_c3 = Omega2_by_c3_in[i];
        const double Omega3_by_Omega1 = Omega3_by_Omega1_in[i];
        const double Omega3_by_Omega2 = Omega3_by_Omega2_in[i];
        const double Omega3_by_Omega3 = Omega3_by_Omega3_in[i];
        const double Omega3_by_c1 = Omega3_by_c1_in[i];
        const double Omega3_by_c2 = Omega3_by_c2_in[i];
        const double Omega3_by_c3 = Omega3_by_c3_in[i];
        const double excess1 = excess1_in[i];
        const double excess2 = excess2_in[i];
        const double excess3 = excess3_in[i];
        const double t = t_in[i];
        const double common_1 = q2 * q2; /* fact: definition turned_columns.R11, definition turned_columns.R33; (3) */
        const double common_2 = q3 * q3; /* fact: definition turned_columns.R11, definition turned_columns.R22; (3) */
        const double R11 = fused(-2.0, common_1 + common_2, 1.0); /* fact: definition turned_columns.R11; (3) */
        const double common_3 = q0 * q3; /* fact: definition turned_columns.R12, definition turned_columns.R21; (3) */
        const double common_4 = q1 * q2; /* fact: definition turned_columns.R12, definition turned_columns.R21; (3) */
        const double R12 = -2.0 * (common_3 - common_4); /* fact: definition turned_columns.R12; (3) */
        const double common_5 = q0 * q2; /* fact: definition turned_columns.R13, definition turned_columns.R31; (3) */
        const double common_6 = q1 * q3; /* fact: definition turned_columns.R13, definition turned_columns.R31; (3) */
        const double R13 = 2.0 * (common_5 + common_6); /* fact: definition turned_columns.R13; (3) */
        const double R21 = 2.0 * (common_3 + common_4); /* fact: definition turned_columns.R21; (3) */
        const double common_7 = q1 * q1; /* fact: definition turned_columns.R22, definition turned_columns.R33; (3) */
        const double R22 = fused(-2.0, common_7 + common_2, 1.0); /* fact: definition turned_columns.R22; (3) */
        const double common_8 = q0 * q1; /* fact: definition turned_columns.R23, definition turned_columns.R32; (3) */
        const double common_9 = q2 * q3; /* fact: definition turned_columns.R23, definition turned_columns.R32; (3) */
        const double R23 = -2.0 * (common_8 - common_9); /* fact: definition turned_columns.R23; (3) */
        const double R31 = -2.0 * (common_5 - common_6); /* fact: definition turned_columns.R31; (3) */
        const double R32 = 2.0 * (common_8 + common_9); /* fact: definition turned_columns.R32; (3) */
        const double R33 = fused(-2.0, common_7 + common_1, 1.0); /* fact: definition turned_columns.R33; (3) */
        const double n1 = c1 * Omega1 * per_K2; /* fact: definition turned_columns.n1; (3) */
        const double n2 = c2 * Omega2 * per_K2; /* fact: definition turned_columns.n2; (3) */
        const double n3 = c3 * Omega3 * per_K2; /* fact: definition turned_columns.n3; (3) */
        const double X11 = fused(R12, n3, -(R13 * n2)); /* fact: definition turned_columns.X11; (3) */
        const double X12 = fused(R13, n1, -(R11 * n3)); /* fact: definition turned_columns.X12; (3) */
        const double X13 = fused(R11, n2, -(R12 * n1)); /* fact: definition turned_columns.X13; (3) */
        const double X21 = fused(R22, n3, -(R23 * n2)); /* fact: definition turned_columns.X21; (3) */
        const double X22 = fused(R23, n1, -(R21 * n3)); /* fact: definition turned_columns.X22; (3) */
        const double X23 = fused(R21, n2, -(R22 * n1)); /* fact: definition turned_columns.X23; (3) */
        const double X31 = fused(R32, n3, -(R33 * n2)); /* fact: definition turned_columns.X31; (3) */
        const double X32 = fused(R33, n1, -(R31 * n3)); /* fact: definition turned_columns.X32; (3) */
        const double X33 = fused(R31, n2, -(R32 * n1)); /* fact: definition turned_columns.X33; (3) */
        const double Y11 = c1 * X11; /* fact: definition turned_columns.Y11; (3) */
        const double Y12 = c2 * X12; /* fact: definition turned_columns.Y12; (3) */
        const double Y13 = c3 * X13; /* fact: definition turned_columns.Y13; (3) */
        const double Y21 = c1 * X21; /* fact: definition turned_columns.Y21; (3) */
        const double Y22 = c2 * X22; /* fact: definition turned_columns.Y22; (3) */
        const double Y23 = c3 * X23; /* fact: definition turned_columns.Y23; (3) */
        const double Y31 = c1 * X31; /* fact: definition turned_columns.Y31; (3) */
        const double Y32 = c2 * X32; /* fact: definition turned_columns.Y32; (3) */
        const double Y33 = c3 * X33; /* fact: definition turned_columns.Y33; (3) */
        const double common_10 = c1 * Omega1_0 * t; /* fact: definition turned_columns.eta1_by_Omega1, definition turned_columns.eta2_by_Omega1, definition turned_columns.eta3_by_Omega1; (3) */
        const double eta1_by_Omega1 = fused(common_10, l1, fused(c1, B11, -fused(Omega3_by_Omega1, Y13, fused(Omega1_by_Omega1, Y11, Omega2_by_Omega1 * Y12)))); /* fact: definition turned_columns.eta1_by_Omega1; (3) */
        const double eta2_by_Omega1 = fused(common_10, l2, fused(c1, B21, -fused(Omega3_by_Omega1, Y23, fused(Omega1_by_Omega1, Y21, Omega2_by_Omega1 * Y22)))); /* fact: definition turned_columns.eta2_by_Omega1; (3) */
        const double eta3_by_Omega1 = fused(common_10, l3, fused(c1, B31, -fused(Omega3_by_Omega1, Y33, fused(Omega1_by_Omega1, Y31, Omega2_by_Omega1 * Y32)))); /* fact: definition turned_columns.eta3_by_Omega1; (3) */
        const double common_11 = c2 * Omega2_0 * t; /* fact: definition turned_columns.eta1_by_Omega2, definition turned_columns.eta2_by_Omega2, definition turned_columns.eta3_by_Omega2; (3) */
        const double eta1_by_Omega2 = fused(common_11, l1, fused(c2, B12, -fused(Omega3_by_Omega2, Y13, fused(Omega1_by_Omega2, Y11, Omega2_by_Omega2 * Y12)))); /* fact: definition turned_columns.eta1_by_Omega2; (3) */
        const double eta2_by_Omega2 = fused(common_11, l2, fused(c2, B22, -fused(Omega3_by_Omega2, Y23, fused(Omega1_by_Omega2, Y21, Omega2_by_Omega2 * Y22)))); /* fact: definition turned_columns.eta2_by_Omega2; (3) */
        const double eta3_by_Omega2 = fused(common_11, l3, fused(c2, B32, -fused(Omega3_by_Omega2, Y33, fused(Omega1_by_Omega2, Y31, Omega2_by_Omega2 * Y32)))); /* fact: definition turned_columns.eta3_by_Omega2; (3) */
        const double common_12 = c3 * Omega3_0 * t; /* fact: definition turned_columns.eta1_by_Omega3, definition turned_columns.eta2_by_Omega3, definition turned_columns.eta3_by_Omega3; (3) */
        const double eta1_by_Omega3 = fused(common_12, l1, fused(c3, B13, -fused(Omega3_by_Omega3, Y13, fused(Omega1_by_Omega3, Y11, Omega2_by_Omega3 * Y12)))); /* fact: definition turned_columns.eta1_by_Omega3; (3) */
        const double eta2_by_Omega3 = fused(common_12, l2, fused(c3, B23, -fused(Omega3_by_Omega3, Y23, fused(Omega1_by_Omega3, Y21, Omega2_by_Omega3 * Y22)))); /* fact: definition turned_columns.eta2_by_Omega3; (3) */
        const double eta3_by_Omega3 = fused(common_12, l3, fused(c3, B33, -fused(Omega3_by_Omega3, Y33, fused(Omega1_by_Omega3, Y31, Omega2_by_Omega3 * Y32)))); /* fact: definition turned_columns.eta3_by_Omega3; (3) */
        const double eta1_by_c1 = fused(Omega1_0, B11, -fused(Omega3_by_c1, Y13, fused(Omega2_by_c1, Y12, fused(Omega1, X11, Omega1_by_c1 * Y11)))) - excess1 * l1 / 2.0; /* fact: definition turned_columns.eta1_by_c1; (3) */
        const double eta2_by_c1 = fused(Omega1_0, B21, -fused(Omega3_by_c1, Y23, fused(Omega2_by_c1, Y22, fused(Omega1, X21, Omega1_by_c1 * Y21)))) - excess1 * l2 / 2.0; /* fact: definition turned_columns.eta2_by_c1; (3) */
        const double eta3_by_c1 = fused(Omega1_0, B31, -fused(Omega3_by_c1, Y33, fused(Omega2_by_c1, Y32, fused(Omega1, X31, Omega1_by_c1 * Y31)))) - excess1 * l3 / 2.0; /* fact: definition turned_columns.eta3_by_c1; (3) */
        const double eta1_by_c2 = fused(Omega2_0, B12, -fused(Omega3_by_c2, Y13, fused(Omega2_by_c2, Y12, fused(Omega2, X12, Omega1_by_c2 * Y11)))) - excess2 * l1 / 2.0; /* fact: definition turned_columns.eta1_by_c2; (3) */
        const double eta2_by_c2 = fused(Omega2_0, B22, -fused(Omega3_by_c2, Y23, fused(Omega2_by_c2, Y22, fused(Omega2, X22, Omega1_by_c2 * Y21)))) - excess2 * l2 / 2.0; /* fact: definition turned_columns.eta2_by_c2; (3) */
        const double eta3_by_c2 = fused(Omega2_0, B32, -fused(Omega3_by_c2, Y33, fused(Omega2_by_c2, Y32, fused(Omega2, X32, Omega1_by_c2 * Y31)))) - excess2 * l3 / 2.0; /* fact: definition turned_columns.eta3_by_c2; (3) */
        const double eta1_by_c3 = fused(Omega3_0, B13, -fused(Omega3_by_c3, Y13, fused(Omega2_by_c3, Y12, fused(Omega3, X13, Omega1_by_c3 * Y11)))) - excess3 * l1 / 2.0; /* fact: definition turned_columns.eta1_by_c3; (3) */
        const double eta2_by_c3 = fused(Omega3_0, B23, -fused(Omega3_by_c3, Y23, fused(Omega2_by_c3, Y22, fused(Omega3, X23, Omega1_by_c3 * Y21)))) - excess3 * l2 / 2.0; /* fact: definition turned_columns.eta2_by_c3; (3) */
        const double eta3_by_c3 = fused(Omega3_0, B33, -fused(Omega3_by_c3, Y33, fused(Omega2_by_c3, Y32, fused(Omega3, X33, Omega1_by_c3 * Y31)))) - excess3 * l3 / 2.0; /* fact: definition turned_columns.eta3_by_c3; (3) */
        const double eta1_by_t = fused(Omega3, R13, fused(Omega1, R11, Omega2 * R12)); /* fact: definition turned_columns.eta1_by_t; (3) */
        const double eta2_by_t = fused(Omega3, R23, fused(Omega1, R21, Omega2 * R22)); /* fact: definition turned_columns.eta2_by_t; (3) */
        const double eta3_by_t = fused(Omega3, R33, fused(Omega1, R31, Omega2 * R32)); /* fact: definition turned_columns.eta3_by_t; (3) */
        const double Omega1_by_t = Omega2 * Omega3 * c23 / c1; /* fact: definition turned_columns.Omega1_by_t; (3) */
        const double Omega2_by_t = -Omega1 * Omega3 * c13 / c2; /* fact: definition turned_columns.Omega2_by_t; (3) */
        const double Omega3_by_t = Omega1 * Omega2 * c12 / c3; /* fact: definition turned_columns.Omega3_by_t; (3) */
        eta1_by_Omega1_out[i] = eta1_by_Omega1;
        eta1_by_Omega2_out[i] = eta1_by_Omega2;
        eta1_by_Omega3_out[i] = eta1_by_Omega3;
        eta1_by_c1_out[i] = eta1_by_c1;
        eta1_by_c2_out[i] = eta1_by_c2;
        eta1_by_c3_out[i] = eta1_by_c3;
        eta2_by_Omega1_out[i] = eta2_by_Omega1;
        eta2_by_Omega2_out[i] = eta2_by_Omega2;
        eta2_by_Omega3_out[i] = eta2_by_Omega3;
        eta2_by_c1_out[i] = eta2_by_c1;
        eta2_by_c2_out[i] = eta2_by_c2;
        eta2_by_c3_out[i] = eta2_by_c3;
        eta3_by_Omega1_out[i] = eta3_by_Omega1;
        eta3_by_Omega2_out[i] = eta3_by_Omega2;
        eta3_by_Omega3_out[i] = eta3_by_Omega3;
        eta3_by_c1_out[i] = eta3_by_c1;
        eta3_by_c2_out[i] = eta3_by_c2;
        eta3_by_c3_out[i] = eta3_by_c3;
        eta1_by_t_out[i] = eta1_by_t;
        eta2_by_t_out[i] = eta2_by_t;
        eta3_by_t_out[i] = eta3_by_t;
        Omega1_by_t_out[i] = Omega1_by_t;
        Omega2_by_t_out[i] = Omega2_by_t;
        Omega3_by_t_out[i] = Omega3_by_t;
    }
}

/* The axis and the rate of a motion with constant rates. */
static void steady_constants(double_double Omega1, double_double Omega2, double_double Omega3,
    double_double p0, double_double p1, double_double p2, double_double p3,
    torque_free_steady *motion)
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
static void steady_angles(const torque_free_steady *motion, size_t n, const double *restrict t_in,
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
static void steady_state(const torque_free_steady *motion, size_t n, const double *restrict X_im_in,
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
    torque_free_circular motion;
    memset(&motion, 0, sizeof(torque_free_circular));
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
    circular_angles(&motion, TIMES, t, t_lo, to, to + TIMES, to + 2 * TIMES, to + 3 * TIMES);
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
    const int attitude = no_attitude ? TORQUE_FREE_ATTITUDE : TORQUE_FREE_OK;
    const int thin = thinnest < min_moment_ratio ? TORQUE_FREE_THIN : attitude;
    const int nonphysical = ALLOW_NONPHYSICAL || can_exist(c) ? thin : TORQUE_FREE_NONPHYSICAL;
    return smallest > 0.0 ? nonphysical : TORQUE_FREE_INERTIA;
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
static void steady_init(torque_free_motion *motion, const double_double omega[3],
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
static void put(lanes *lane, size_t i, const torque_free_motion *motion, const double_double c[3],
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
    spread(lane->k_1_hi, mask, used);
    spread(lane->k_1_lo, mask, used);
    spread(lane->kc_1_hi, mask, used);
    spread(lane->kc_1_lo, mask, used);
    spread(lane->mu_hi, mask, used);
    spread(lane->mu_lo, mask, used);
    spread(lane->psi_0_hi, mask, used);
    spread(lane->psi_0_lo, mask, used);
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
    torque_free_motion *restrict motion, int *restrict code)
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
                motion[i].of.circular.T4_re_0 = circular.T4_re_0[i];
                holds = holds && isfinite(circular.T4_re_0[i]);
                motion[i].of.circular.T4_re_1 = circular.T4_re_1[i];
                holds = holds && isfinite(circular.T4_re_1[i]);
                motion[i].of.circular.T4_re_2 = circular.T4_re_2[i];
                holds = holds && isfinite(circular.T4_re_2[i]);
                motion[i].of.circular.T4_re_3 = circular.T4_re_3[i];
                holds = holds && isfinite(circular.T4_re_3[i]);
                motion[i].of.circular.T4_im_0 = circular.T4_im_0[i];
                holds = holds && isfinite(circular.T4_im_0[i]);
                motion[i].of.circular.T4_im_1 = circular.T4_im_1[i];
                holds = holds && isfinite(circular.T4_im_1[i]);
                motion[i].of.circular.T4_im_2 = circular.T4_im_2[i];
                holds = holds && isfinite(circular.T4_im_2[i]);
                motion[i].of.circular.T1_re_0 = circular.T1_re_0[i];
                holds = holds && isfinite(circular.T1_re_0[i]);
                motion[i].of.circular.T1_re_1 = circular.T1_re_1[i];
                holds = holds && isfinite(circular.T1_re_1[i]);
                motion[i].of.circular.T1_re_2 = circular.T1_re_2[i];
                holds = holds && isfinite(circular.T1_re_2[i]);
                motion[i].of.circular.T1_re_3 = circular.T1_re_3[i];
                holds = holds && isfinite(circular.T1_re_3[i]);
                motion[i].of.circular.T1_im_0 = circular.T1_im_0[i];
                holds = holds && isfinite(circular.T1_im_0[i]);
                motion[i].of.circular.T1_im_1 = circular.T1_im_1[i];
                holds = holds && isfinite(circular.T1_im_1[i]);
                motion[i].of.circular.T1_im_2 = circular.T1_im_2[i];
                holds = holds && isfinite(circular.T1_im_2[i]);
                motion[i].of.circular.T1_im_3 = circular.T1_im_3[i];
                holds = holds && isfinite(circular.T1_im_3[i]);
                motion[i].of.circular.even_0 = circular.even_0[i];
                holds = holds && isfinite(circular.even_0[i]);
                motion[i].of.circular.even_1 = circular.even_1[i];
                holds = holds && isfinite(circular.even_1[i]);
                motion[i].of.circular.even_2 = circular.even_2[i];
                holds = holds && isfinite(circular.even_2[i]);
                motion[i].of.circular.odd_0 = circular.odd_0[i];
                holds = holds && isfinite(circular.odd_0[i]);
                motion[i].of.circular.odd_1 = circular.odd_1[i];
                holds = holds && isfinite(circular.odd_1[i]);
                motion[i].of.circular.sine_even_0 = circular.sine_even_0[i];
                holds = holds && isfinite(circular.sine_even_0[i]);
                motion[i].of.circular.sine_even_1 = circular.sine_even_1[i];
                holds = holds && isfinite(circular.sine_even_1[i]);
                motion[i].of.circular.sine_even_2 = circular.sine_even_2[i];
                holds = holds && isfinite(circular.sine_even_2[i]);
                motion[i].of.circular.sine_odd_0 = circular.sine_odd_0[i];
                holds = holds && isfinite(circular.sine_odd_0[i]);
                motion[i].of.circular.sine_odd_1 = circular.sine_odd_1[i];
                holds = holds && isfinite(circular.sine_odd_1[i]);
                motion[i].of.circular.row_0_P4_re = circular.row_0_P4_re[i];
                holds = holds && isfinite(circular.row_0_P4_re[i]);
                motion[i].of.circular.row_0_P4_im = circular.row_0_P4_im[i];
                holds = holds && isfinite(circular.row_0_P4_im[i]);
                motion[i].of.circular.row_0_P1_re = circular.row_0_P1_re[i];
                holds = holds && isfinite(circular.row_0_P1_re[i]);
                motion[i].of.circular.row_0_P1_im = circular.row_0_P1_im[i];
                holds = holds && isfinite(circular.row_0_P1_im[i]);
                motion[i].of.circular.row_a_P4_re = circular.row_a_P4_re[i];
                holds = holds && isfinite(circular.row_a_P4_re[i]);
                motion[i].of.circular.row_a_P4_im = circular.row_a_P4_im[i];
                holds = holds && isfinite(circular.row_a_P4_im[i]);
                motion[i].of.circular.row_a_P1_re = circular.row_a_P1_re[i];
                holds = holds && isfinite(circular.row_a_P1_re[i]);
                motion[i].of.circular.row_a_P1_im = circular.row_a_P1_im[i];
                holds = holds && isfinite(circular.row_a_P1_im[i]);
                motion[i].of.circular.row_b_P4_re = circular.row_b_P4_re[i];
                holds = holds && isfinite(circular.row_b_P4_re[i]);
                motion[i].of.circular.row_b_P4_im = circular.row_b_P4_im[i];
                holds = holds && isfinite(circular.row_b_P4_im[i]);
                motion[i].of.circular.row_b_P1_re = circular.row_b_P1_re[i];
                holds = holds && isfinite(circular.row_b_P1_re[i]);
                motion[i].of.circular.row_b_P1_im = circular.row_b_P1_im[i];
                holds = holds && isfinite(circular.row_b_P1_im[i]);
                motion[i].of.circular.row_d_P4_re = circular.row_d_P4_re[i];
                holds = holds && isfinite(circular.row_d_P4_re[i]);
                motion[i].of.circular.row_d_P4_im = circular.row_d_P4_im[i];
                holds = holds && isfinite(circular.row_d_P4_im[i]);
                motion[i].of.circular.row_d_P1_re = circular.row_d_P1_re[i];
                holds = holds && isfinite(circular.row_d_P1_re[i]);
                motion[i].of.circular.row_d_P1_im = circular.row_d_P1_im[i];
                holds = holds && isfinite(circular.row_d_P1_im[i]);
                motion[i].of.circular.gain_a = circular.gain_a[i];
                holds = holds && isfinite(circular.gain_a[i]);
                motion[i].of.circular.gain_b = circular.gain_b[i];
                holds = holds && isfinite(circular.gain_b[i]);
                motion[i].of.circular.gain_d = circular.gain_d[i];
                holds = holds && isfinite(circular.gain_d[i]);
                motion[i].max_angle = limit(motion[i].max_angle, circular.v_rate_hi[i], circular.Lambda_rate_hi[i]);
                code[i] = holds ? TORQUE_FREE_OK : TORQUE_FREE_RATES;
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
                motion[i].of.hyperbolic.re_0 = hyperbolic.re_0[i];
                holds = holds && isfinite(hyperbolic.re_0[i]);
                motion[i].of.hyperbolic.re_1 = hyperbolic.re_1[i];
                holds = holds && isfinite(hyperbolic.re_1[i]);
                motion[i].of.hyperbolic.re_2 = hyperbolic.re_2[i];
                holds = holds && isfinite(hyperbolic.re_2[i]);
                motion[i].of.hyperbolic.re_3 = hyperbolic.re_3[i];
                holds = holds && isfinite(hyperbolic.re_3[i]);
                motion[i].of.hyperbolic.im_0 = hyperbolic.im_0[i];
                holds = holds && isfinite(hyperbolic.im_0[i]);
                motion[i].of.hyperbolic.im_1 = hyperbolic.im_1[i];
                holds = holds && isfinite(hyperbolic.im_1[i]);
                motion[i].of.hyperbolic.im_2 = hyperbolic.im_2[i];
                holds = holds && isfinite(hyperbolic.im_2[i]);
                motion[i].of.hyperbolic.im_3 = hyperbolic.im_3[i];
                holds = holds && isfinite(hyperbolic.im_3[i]);
                motion[i].of.hyperbolic.nome = hyperbolic.nome[i];
                holds = holds && isfinite(hyperbolic.nome[i]);
                motion[i].of.hyperbolic.nome2 = hyperbolic.nome2[i];
                holds = holds && isfinite(hyperbolic.nome2[i]);
                motion[i].of.hyperbolic.nome4 = hyperbolic.nome4[i];
                holds = holds && isfinite(hyperbolic.nome4[i]);
                motion[i].of.hyperbolic.nome8 = hyperbolic.nome8[i];
                holds = holds && isfinite(hyperbolic.nome8[i]);
                motion[i].of.hyperbolic.nome12 = hyperbolic.nome12[i];
                holds = holds && isfinite(hyperbolic.nome12[i]);
                motion[i].of.hyperbolic.row_0_P4_re = hyperbolic.row_0_P4_re[i];
                holds = holds && isfinite(hyperbolic.row_0_P4_re[i]);
                motion[i].of.hyperbolic.row_0_P4_im = hyperbolic.row_0_P4_im[i];
                holds = holds && isfinite(hyperbolic.row_0_P4_im[i]);
                motion[i].of.hyperbolic.row_0_P1_re = hyperbolic.row_0_P1_re[i];
                holds = holds && isfinite(hyperbolic.row_0_P1_re[i]);
                motion[i].of.hyperbolic.row_0_P1_im = hyperbolic.row_0_P1_im[i];
                holds = holds && isfinite(hyperbolic.row_0_P1_im[i]);
                motion[i].of.hyperbolic.row_a_P4_re = hyperbolic.row_a_P4_re[i];
                holds = holds && isfinite(hyperbolic.row_a_P4_re[i]);
                motion[i].of.hyperbolic.row_a_P4_im = hyperbolic.row_a_P4_im[i];
                holds = holds && isfinite(hyperbolic.row_a_P4_im[i]);
                motion[i].of.hyperbolic.row_a_P1_re = hyperbolic.row_a_P1_re[i];
                holds = holds && isfinite(hyperbolic.row_a_P1_re[i]);
                motion[i].of.hyperbolic.row_a_P1_im = hyperbolic.row_a_P1_im[i];
                holds = holds && isfinite(hyperbolic.row_a_P1_im[i]);
                motion[i].of.hyperbolic.row_b_P4_re = hyperbolic.row_b_P4_re[i];
                holds = holds && isfinite(hyperbolic.row_b_P4_re[i]);
                motion[i].of.hyperbolic.row_b_P4_im = hyperbolic.row_b_P4_im[i];
                holds = holds && isfinite(hyperbolic.row_b_P4_im[i]);
                motion[i].of.hyperbolic.row_b_P1_re = hyperbolic.row_b_P1_re[i];
                holds = holds && isfinite(hyperbolic.row_b_P1_re[i]);
                motion[i].of.hyperbolic.row_b_P1_im = hyperbolic.row_b_P1_im[i];
                holds = holds && isfinite(hyperbolic.row_b_P1_im[i]);
                motion[i].of.hyperbolic.row_d_P4_re = hyperbolic.row_d_P4_re[i];
                holds = holds && isfinite(hyperbolic.row_d_P4_re[i]);
                motion[i].of.hyperbolic.row_d_P4_im = hyperbolic.row_d_P4_im[i];
                holds = holds && isfinite(hyperbolic.row_d_P4_im[i]);
                motion[i].of.hyperbolic.row_d_P1_re = hyperbolic.row_d_P1_re[i];
                holds = holds && isfinite(hyperbolic.row_d_P1_re[i]);
                motion[i].of.hyperbolic.row_d_P1_im = hyperbolic.row_d_P1_im[i];
                holds = holds && isfinite(hyperbolic.row_d_P1_im[i]);
                motion[i].of.hyperbolic.gain_a = hyperbolic.gain_a[i];
                holds = holds && isfinite(hyperbolic.gain_a[i]);
                motion[i].of.hyperbolic.gain_b = hyperbolic.gain_b[i];
                holds = holds && isfinite(hyperbolic.gain_b[i]);
                motion[i].of.hyperbolic.gain_d = hyperbolic.gain_d[i];
                holds = holds && isfinite(hyperbolic.gain_d[i]);
                motion[i].max_angle = limit(motion[i].max_angle, hyperbolic.y_rate_hi[i], hyperbolic.Lambda_rate_hi[i]);
                code[i] = holds ? TORQUE_FREE_OK : TORQUE_FREE_RATES;
            }
        }
    }
    for (size_t i = 0; i < n; i++) {
        if (own[i] && !is_held(motion[i].unit, lane->A_a_hi[i], lane->A_b_hi[i], lane->A_d_hi[i])) {
            code[i] = TORQUE_FREE_RATES;
        }
    }
}

/* Compute the constants of n motions that `begin` wrote to lanes, and their codes. Steady motions
   have their constants. */
static void moving_init(lanes *lane, size_t n, torque_free_motion *restrict motion,
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
static void keep(torque_free_motion *motion, const double_double c[3], const double_double apart[3],
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
static void begin(torque_free_motion *motion, lanes *lane, size_t i, const double_double c[3],
    const double_double apart[3], const double_double given[3], const double_double q[4],
    int is_known, double_double known, double unit)
{
    memset(motion, 0, sizeof(torque_free_motion));
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
static int begin_doubles(torque_free_motion *motion, lanes *lane, size_t i, const double inertia[3],
    const double omega0[3], const double attitude0[4])
{
    motion->branch = 0;
    if (!(all_finite(3, inertia) && all_finite(3, omega0) && all_finite(4, attitude0))) {
        return TORQUE_FREE_NOT_FINITE;
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
    if (code != TORQUE_FREE_OK) {
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
    return TORQUE_FREE_OK;
}

/* Finish one motion that was begun, and return its code. */
static int end(torque_free_motion *motion, torque_free_motion *restrict made, lanes *lane)
{
    int code[1];
    code[0] = TORQUE_FREE_OK;
    if (!is_rounded_once()) {
        return TORQUE_FREE_ARITHMETIC;
    }
    moving_init(lane, 1, made, code);
    if (code[0] == TORQUE_FREE_OK) {
        *motion = made[0];
    }
    return code[0];
}

int torque_free_motion_init(torque_free_motion *motion, const double inertia[3],
    const double omega0[3], const double attitude0[4])
{
    torque_free_motion made[1];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const int code = begin_doubles(&made[0], &lane, 0, inertia, omega0, attitude0);
    if (code != TORQUE_FREE_OK) {
        return code;
    }
    return end(motion, made, &lane);
}

int torque_free_motion_init_double_doubles(torque_free_motion *motion, const double inertia[3][2],
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
            return TORQUE_FREE_NOT_FINITE;
        }
        if (!(isfinite(apart[k].hi) && isfinite(apart[k].lo))) {
            return TORQUE_FREE_NOT_FINITE;
        }
        if (!(isfinite(omega[k].hi) && isfinite(omega[k].lo))) {
            return TORQUE_FREE_NOT_FINITE;
        }
        if (!(c[k].hi > 0.0)) {
            return TORQUE_FREE_INERTIA;
        }
        if (c[k].hi < min_moment_ratio || c[k].hi > 4.0) {
            return TORQUE_FREE_THIN;
        }
        if (fabs(omega[k].hi) > 4.0) {
            return TORQUE_FREE_RATES;
        }
    }
    if (!can_exist(c)) {
        return TORQUE_FREE_NONPHYSICAL;
    }
    int is_turned = 0;
    for (size_t k = 0; k < 4; k++) {
        q[k].hi = attitude0[k][0];
        q[k].lo = attitude0[k][1];
        are_finite = are_finite && isfinite(q[k].hi) && isfinite(q[k].lo);
        is_turned = is_turned || !is_zero(q[k].hi);
    }
    if (!are_finite) {
        return TORQUE_FREE_NOT_FINITE;
    }
    if (!(unit > 0.0)) {
        return TORQUE_FREE_RATES;
    }
    if (!is_turned) {
        return TORQUE_FREE_ATTITUDE;
    }
    torque_free_motion made[1];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const double_double known = {discriminant[0], discriminant[1]};
    begin(&made[0], &lane, 0, c, apart, omega, q, 1, known, unit);
    return end(motion, made, &lane);
}

/* Scale times to inner units. Return whether all are within the domain, and whether one is zero. */
static void scaled_times(const torque_free_motion *motion, size_t n, const double *restrict t,
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
static void block_states(const torque_free_motion *motion, size_t n, size_t s,
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
        circular_state(&motion->of.circular, n, angles, angles + s, angles + 2 * s, angles + 3 * s, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s, to + 5 * s, to + 6 * s);
    } else {
        hyperbolic_state(&motion->of.hyperbolic, n, angles, angles + s, angles + 2 * s, angles + 3 * s, angles + 4 * s, angles + 5 * s, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s, to + 5 * s, to + 6 * s);
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
static void block_angles(const torque_free_motion *motion, size_t n, size_t s,
    const double *restrict t, const double *restrict t_lo, double *restrict to)
{
    if (motion->branch == 0) {
        steady_angles(&motion->of.steady, n, t, t_lo, to, to + s);
    } else if (motion->branch == 1) {
        circular_angles(&motion->of.circular, n, t, t_lo, to, to + s, to + 2 * s, to + 3 * s);
    } else {
        hyperbolic_angles(&motion->of.hyperbolic, n, t, t_lo, to, to + s, to + 2 * s, to + 3 * s, to + 4 * s, to + 5 * s);
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
static void at_initial_state(const torque_free_motion *motion, double *restrict q,
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
static int refusal(const torque_free_motion *motion, int are_finite)
{
    if (!are_finite) {
        return TORQUE_FREE_NOT_FINITE;
    }
    return motion->blurred != 0 ? TORQUE_FREE_SEPARATRIX : TORQUE_FREE_TIME;
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

int torque_free_state_at(const torque_free_motion *motion, double t, double q[4], double omega[3])
{
    double by_time[6];
    double to[7];
    double inner[1];
    double rest[1];
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_UNPREPARED;
    }
    inner[0] = motion->unit * t;
    rest[0] = 0.0;
    if (!(fabs(inner[0]) <= motion->max_angle)) {
        return refusal(motion, isfinite(t));
    }
    if (is_zero(t)) {
        at_initial_state(motion, q, omega);
        return TORQUE_FREE_OK;
    }
    block_angles(motion, 1, 1, inner, rest, by_time);
    block_states(motion, 1, 1, by_time, to, q, omega);
    return TORQUE_FREE_OK;
}

/* Write the states at n times. Late times are refused, or have states of NaN where `lenient`. */
static int unrefused_states(const torque_free_motion *motion, size_t n, const double *restrict t,
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
    return TORQUE_FREE_OK;
}

int torque_free_states_at(const torque_free_motion *motion, size_t n, const double *t, double *q,
    double *omega)
{
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_UNPREPARED;
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
static void grid_table(const torque_free_motion *motion, double step, double *restrict table)
{
    double t[BLOCK];
    double t_lo[BLOCK];
    torque_free_motion from_zero;
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
static void grid_angles(const torque_free_motion *motion, double start, double step, size_t first,
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
static void grid_states(const torque_free_motion *motion, double start, double step, size_t first,
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
static void grid_states_one_by_one(const torque_free_motion *motion, double start, double step,
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

int torque_free_states_on_grid(const torque_free_motion *motion, double start, double step,
    size_t first, size_t n, double *q, double *omega)
{
    double table[6 * BLOCK];
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_UNPREPARED;
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
    if (motion->branch >= 2) {
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
    return TORQUE_FREE_OK;
}

/* Prepare the motions of as many bodies as there are lanes, with codes; return how many. */
static size_t several_init(torque_free_motion *restrict motion, int *restrict code, lanes *lane,
    int rounds_once, size_t bodies, const double *restrict inertia, const double *restrict omega0,
    const double *restrict attitude0)
{
    const size_t count = bodies <= LANES ? bodies : LANES;
    for (size_t i = 0; i < count; i++) {
        code[i] = begin_doubles(&motion[i], lane, i, inertia + 3 * i, omega0 + 3 * i, attitude0 + 4 * i);
        if (code[i] == TORQUE_FREE_OK && !rounds_once) {
            code[i] = TORQUE_FREE_ARITHMETIC;
        }
    }
    moving_init(lane, count, motion, code);
    return count;
}

/* Write the states of one of many bodies; late times have states of NaN where `lenient`. */
static int states_of(const torque_free_motion *motion, size_t n, const double *restrict t,
    double *restrict q, double *restrict omega, int lenient)
{
    if (n != 1) {
        return unrefused_states(motion, n, t, q, omega, lenient);
    }
    const int code = torque_free_state_at(motion, t[0], q, omega);
    if (code != TORQUE_FREE_OK && lenient) {
        no_states(1, q, omega);
    }
    return code;
}

int torque_free_propagate(size_t bodies, const double *inertia, const double *omega0,
    const double *attitude0, size_t n, const double *t, size_t stride, double *q, double *omega,
    int *codes /* or NULL */, size_t *failed)
{
    torque_free_motion motions[LANES];
    int code[LANES];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const int lenient = codes != NULL;
    const int rounds_once = is_rounded_once();
    for (size_t first = 0; first < bodies; first += LANES) {
        const size_t count = several_init(motions, code, &lane, rounds_once, bodies - first, inertia + 3 * first, omega0 + 3 * first, attitude0 + 4 * first);
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            if (code[i] == TORQUE_FREE_OK) {
                code[i] = states_of(&motions[i], n, t + stride * k, q + 4 * n * k, omega + 3 * n * k, lenient);
            } else if (lenient) {
                no_states(n, q + 4 * n * k, omega + 3 * n * k);
            }
            if (codes != NULL) {
                codes[k] = code[i];
            } else if (code[i] != TORQUE_FREE_OK) {
                failed[0] = k;
                return code[i];
            }
        }
    }
    return TORQUE_FREE_OK;
}

double torque_free_last_time(const torque_free_motion *motion)
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

size_t torque_free_motion_size(void)
{
    return sizeof(torque_free_motion);
}

/* Return one of the numbers that a motion was made from. */
static double_double given_pair(const torque_free_motion *motion, size_t k)
{
    const double_double result = {motion->given[2 * k], motion->given[2 * k + 1]};
    return result;
}

/* Write the constants of sensitivities. */
static void sensitive_init(const torque_free_motion *motion, sensitive *made)
{
    double_double c[3];
    double_double apart_from_next[3];
    double_double omega[3];
    int axis[3];
    const double_double E_b = given_pair(motion, 9);
    int at_rest = 1;
    for (size_t k = 0; k < 3; k++) {
        c[k] = given_pair(motion, k);
        apart_from_next[k] = given_pair(motion, 3 + k);
        omega[k] = given_pair(motion, 6 + k);
        axis[k] = motion->axis[k];
        at_rest = at_rest && is_zero(omega[k].hi);
    }
    if (difference(apart_from_next, axis[0], axis[2]).hi * E_b.hi < 0.0) {
        axis[0] = motion->axis[2];
        axis[2] = motion->axis[0];
    }
    for (size_t k = 0; k < 3; k++) {
        made->axis[k] = axis[k];
    }
    made->at_rest = at_rest;
    const double_double c_a = c[axis[0]];
    const double_double c_b = c[axis[1]];
    const double_double c_d = c[axis[2]];
    const double_double c_ab = difference(apart_from_next, axis[0], axis[1]);
    const double_double c_ad = difference(apart_from_next, axis[0], axis[2]);
    const double_double c_bd = difference(apart_from_next, axis[1], axis[2]);
    const double_double Omega_a0 = omega[axis[0]];
    const double_double Omega_b0 = omega[axis[1]];
    const double_double Omega_d0 = omega[axis[2]];
    const double axis_a = (double)axis[0];
    const double axis_b = (double)axis[1];
    const double axis_d = (double)axis[2];
    /* The time at which a motion turns over is known on the hyperbolic branch alone; others hardly do.
       */
    const int turns_over = motion->branch == 2;
    const double reach = turns_over ? 1.0 : never;
    double_double y0 = {0.0, 0.0};
    if (turns_over) {
        y0.hi = motion->of.hyperbolic.y0_hi;
        y0.lo = motion->of.hyperbolic.y0_lo;
    }
    double_double p;
    double_double r;
    double_double apart;
    double_double lambda_;
    double_double divisor;
    double_double modulus;
    double_double complement;
    moduli(c_a, c_b, c_d, c_ab, c_ad, c_bd, Omega_a0, Omega_b0, Omega_d0, E_b, axis_a, axis_b, axis_d, &p, &r, &apart, &lambda_, &divisor, &modulus, &complement);
    along_constants(c_a, c_b, c_d, c_ab, c_ad, c_bd, Omega_a0, Omega_b0, Omega_d0, axis_a, axis_b, axis_d, reach, &made->along);
    columns_constants(c_a, c_b, c_d, c_ab, c_ad, c_bd, Omega_a0, Omega_b0, Omega_d0, E_b, axis_a, axis_b, axis_d, &made->columns);
    made->is_real = modulus.hi * modulus.hi <= max_real;
    if (made->is_real) {
        real_constants(p, r, apart, lambda_, divisor, modulus, complement, &made->real);
    } else {
        imaginary_constants(p, r, apart, lambda_, modulus, complement, y0, &made->imaginary);
    }
    if (!at_rest) {
        turn_constants(c[0].hi, c[1].hi, c[2].hi, difference(apart_from_next, 0, 1).hi, difference(apart_from_next, 0, 2).hi, difference(apart_from_next, 1, 2).hi, omega[0].hi, omega[1].hi, omega[2].hi, motion->q0[0], motion->q0[1], motion->q0[2], motion->q0[3], &made->turn);
    }
}

/* Write S_t, C_t, D_t, E_t, D_t F_t, the integral over the phase and its turns, in rows. */
static void elapsed(const sensitive *made, size_t n, const double *restrict t, double *restrict to)
{
    double angles[11 * SENSITIVE];
    double rest[SENSITIVE];
    for (size_t i = 0; i < n; i++) {
        rest[i] = 0.0;
    }
    if (made->is_real) {
        real_angles(&made->real, n, t, rest, angles, angles + SENSITIVE);
        real_state(&made->real, n, angles, angles + SENSITIVE, t, to, to + SENSITIVE, to + 2 * SENSITIVE, to + 3 * SENSITIVE, to + 4 * SENSITIVE, to + 5 * SENSITIVE, to + 6 * SENSITIVE);
    } else {
        imaginary_angles(&made->imaginary, n, t, rest, angles, angles + SENSITIVE, angles + 2 * SENSITIVE, angles + 3 * SENSITIVE, angles + 4 * SENSITIVE, angles + 5 * SENSITIVE, angles + 6 * SENSITIVE, angles + 7 * SENSITIVE, angles + 8 * SENSITIVE, angles + 9 * SENSITIVE, angles + 10 * SENSITIVE);
        imaginary_state(&made->imaginary, n, angles, angles + SENSITIVE, angles + 2 * SENSITIVE, angles + 3 * SENSITIVE, angles + 4 * SENSITIVE, angles + 5 * SENSITIVE, angles + 6 * SENSITIVE, angles + 7 * SENSITIVE, angles + 8 * SENSITIVE, angles + 9 * SENSITIVE, angles + 10 * SENSITIVE, t, to, to + SENSITIVE, to + 2 * SENSITIVE, to + 3 * SENSITIVE, to + 4 * SENSITIVE, to + 5 * SENSITIVE, to + 6 * SENSITIVE);
    }
}

/* Return True where the changes with an input are asked for. */
static INLINED int asks(uint64_t asked, int input)
{
    return (asked & (uint64_t)input) != 0;
}

/* Return the number of doubles of one state in `attitude` and in `rates`. */
static INLINED size_t width_of(uint64_t asked)
{
    const size_t first = asks(asked, TORQUE_FREE_BY_ATTITUDE0) ? 9 : 0;
    const size_t second = asks(asked, TORQUE_FREE_BY_OMEGA0) ? 9 : 0;
    const size_t third = asks(asked, TORQUE_FREE_BY_INERTIA) ? 9 : 0;
    return first + second + third;
}

/* Return the number of doubles of one state in `attitude_t` and in `rates_t`. */
static INLINED size_t width_t(uint64_t asked)
{
    return asks(asked, TORQUE_FREE_BY_T) ? 3 : 0;
}

/* Write three columns of each chosen group of a row. The groups are by the turn at t = 0, omega0
   and the moments. column: the six of the last two, SENSITIVE apart. */
static INLINED void put_row(uint64_t asked, double *restrict row, const double turn[3],
    const double *restrict column, double by_rate, double by_moment, double again)
{
    const size_t after = asks(asked, TORQUE_FREE_BY_ATTITUDE0) ? 3 : 0;
    const size_t last = after + (asks(asked, TORQUE_FREE_BY_OMEGA0) ? 3 : 0);
    for (size_t k = 0; k < 3; k++) {
        if (asks(asked, TORQUE_FREE_BY_ATTITUDE0)) {
            row[k] = turn[k];
        }
        if (asks(asked, TORQUE_FREE_BY_OMEGA0)) {
            row[after + k] = by_rate * column[k * SENSITIVE];
        }
        if (asks(asked, TORQUE_FREE_BY_INERTIA)) {
            row[last + k] = again * (by_moment * column[(3 + k) * SENSITIVE]);
        }
    }
}

/* Write the rows of n states. turned_by: 18 derivatives of the turn by omega0 and the moments, then
   six of turn and rates by the time; by: 18 derivatives of the rates. Rows of both are SENSITIVE
   apart. */
static INLINED void put_rows(uint64_t asked, const torque_free_motion *motion, size_t n,
    const double *restrict turned_by, const double *restrict by, double *restrict attitude,
    double *restrict rates, double *restrict attitude_t, double *restrict rates_t)
{
    const double unit = motion->unit;
    const double over = 1.0 / unit;
    const double over_moment = 1.0 / motion->moment_unit;
    /* A unit of rates over one of moments may leave binary64 where no rate by a moment does. */
    const double apart = (double)(exponent_of(unit) - exponent_of(motion->moment_unit));
    const double part = ldexp(1.0, (int)(0.5 * apart));
    const double rest = unit / part * over_moment;
    const size_t width = width_of(asked) / 3;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < 3; k++) {
            const size_t to = 3 * width * i + width * k;
            const size_t own = 6 * k * SENSITIVE + i;
            put_row(asked, attitude + to, unit_rows + 3 * k, turned_by + own, over, over_moment, 1.0);
            put_row(asked, rates + to, no_row, by + own, 1.0, part, rest);
        }
        if (asks(asked, TORQUE_FREE_BY_T)) {
            for (size_t k = 0; k < 3; k++) {
                attitude_t[3 * i + k] = unit * turned_by[(18 + k) * SENSITIVE + i];
                rates_t[3 * i + k] = unit * (unit * turned_by[(21 + k) * SENSITIVE + i]);
            }
        }
    }
}

/* Write the derivatives of n <= SENSITIVE states at inner times t. */
static void block_sensitivities(const torque_free_motion *motion, const sensitive *made,
    uint64_t asked, size_t n, const double *restrict t, const double *restrict q,
    const double *restrict omega, double *restrict attitude, double *restrict rates,
    double *restrict attitude_t, double *restrict rates_t)
{
    double functions[7 * SENSITIVE];
    double state[7 * SENSITIVE];
    double along[7 * SENSITIVE];
    double by[21 * SENSITIVE];
    double turned_by[24 * SENSITIVE];
    size_t place[21];
    const double over = 1.0 / motion->unit;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < 4; k++) {
            state[k * SENSITIVE + i] = q[4 * i + k];
        }
        for (size_t k = 0; k < 3; k++) {
            state[(4 + k) * SENSITIVE + i] = omega[3 * i + k] * over;
        }
    }
    /* Rows of derivatives by columns of axes a, b, d go where those of axes 1, 2, 3 are. */
    for (size_t x = 0; x < 3; x++) {
        const size_t rate = (size_t)made->axis[x];
        place[18 + x] = (18 + rate) * SENSITIVE;
        for (size_t y = 0; y < 3; y++) {
            const size_t column = 6 * rate + (size_t)made->axis[y];
            place[6 * x + y] = column * SENSITIVE;
            place[6 * x + 3 + y] = (column + 3) * SENSITIVE;
        }
    }
    const size_t Omega_a = (4 + (size_t)made->axis[0]) * SENSITIVE;
    const size_t Omega_b = (4 + (size_t)made->axis[1]) * SENSITIVE;
    const size_t Omega_d = (4 + (size_t)made->axis[2]) * SENSITIVE;
    elapsed(made, n, t, functions);
    along_state(&made->along, n, functions, functions + SENSITIVE, functions + 2 * SENSITIVE, functions + 3 * SENSITIVE, functions + 4 * SENSITIVE, functions + 5 * SENSITIVE, functions + 6 * SENSITIVE, t, state + Omega_a, state + Omega_b, state + Omega_d, along, along + SENSITIVE, along + 2 * SENSITIVE, along + 3 * SENSITIVE, along + 4 * SENSITIVE, along + 5 * SENSITIVE, along + 6 * SENSITIVE);
    columns_state(&made->columns, n, functions, functions + SENSITIVE, functions + 2 * SENSITIVE, functions + 3 * SENSITIVE, functions + 4 * SENSITIVE, along, along + SENSITIVE, along + 2 * SENSITIVE, along + 3 * SENSITIVE, along + 4 * SENSITIVE, along + 5 * SENSITIVE, along + 6 * SENSITIVE, t, state + Omega_a, state + Omega_b, state + Omega_d, by + place[0], by + place[1], by + place[2], by + place[3], by + place[4], by + place[5], by + place[6], by + place[7], by + place[8], by + place[9], by + place[10], by + place[11], by + place[12], by + place[13], by + place[14], by + place[15], by + place[16], by + place[17], by + place[18], by + place[19], by + place[20]);
    turn_state(&made->turn, n, state, state + SENSITIVE, state + 2 * SENSITIVE, state + 3 * SENSITIVE, state + 4 * SENSITIVE, state + 5 * SENSITIVE, state + 6 * SENSITIVE, by, by + SENSITIVE, by + 2 * SENSITIVE, by + 3 * SENSITIVE, by + 4 * SENSITIVE, by + 5 * SENSITIVE, by + 6 * SENSITIVE, by + 7 * SENSITIVE, by + 8 * SENSITIVE, by + 9 * SENSITIVE, by + 10 * SENSITIVE, by + 11 * SENSITIVE, by + 12 * SENSITIVE, by + 13 * SENSITIVE, by + 14 * SENSITIVE, by + 15 * SENSITIVE, by + 16 * SENSITIVE, by + 17 * SENSITIVE, by + 18 * SENSITIVE, by + 19 * SENSITIVE, by + 20 * SENSITIVE, t, turned_by, turned_by + SENSITIVE, turned_by + 2 * SENSITIVE, turned_by + 3 * SENSITIVE, turned_by + 4 * SENSITIVE, turned_by + 5 * SENSITIVE, turned_by + 6 * SENSITIVE, turned_by + 7 * SENSITIVE, turned_by + 8 * SENSITIVE, turned_by + 9 * SENSITIVE, turned_by + 10 * SENSITIVE, turned_by + 11 * SENSITIVE, turned_by + 12 * SENSITIVE, turned_by + 13 * SENSITIVE, turned_by + 14 * SENSITIVE, turned_by + 15 * SENSITIVE, turned_by + 16 * SENSITIVE, turned_by + 17 * SENSITIVE, turned_by + 18 * SENSITIVE, turned_by + 19 * SENSITIVE, turned_by + 20 * SENSITIVE, turned_by + 21 * SENSITIVE, turned_by + 22 * SENSITIVE, turned_by + 23 * SENSITIVE);
    /* All columns, the most frequent choice, without a test for each number. */
    if (asked == (uint64_t)TORQUE_FREE_BY_ALL) {
        put_rows((uint64_t)TORQUE_FREE_BY_ALL, motion, n, turned_by, by, attitude, rates, attitude_t, rates_t);
    } else {
        put_rows(asked, motion, n, turned_by, by, attitude, rates, attitude_t, rates_t);
    }
}

/* Write the derivatives of a body at rest, or of any body at t = 0. A body at rest begins to turn
   when given rates. */
static void plain_sensitivity(const torque_free_motion *motion, double t, uint64_t asked,
    double *restrict attitude, double *restrict rates)
{
    const double q_0 = motion->q0[0];
    /* gcc fuses the products of sums and differences in turn, whatever options say. */
    const double less_0 = hidden(-q_0);
    const double q_1 = motion->q0[1];
    const double q_2 = motion->q0[2];
    const double q_3 = motion->q0[3];
    double start[3][3];
    start[0][0] = 1.0 - 2.0 * (q_2 * q_2 + q_3 * q_3);
    start[0][1] = 2.0 * (q_1 * q_2 + less_0 * q_3);
    start[0][2] = 2.0 * (q_1 * q_3 + q_0 * q_2);
    start[1][0] = 2.0 * (q_1 * q_2 + q_0 * q_3);
    start[1][1] = 1.0 - 2.0 * (q_1 * q_1 + q_3 * q_3);
    start[1][2] = 2.0 * (q_2 * q_3 + less_0 * q_1);
    start[2][0] = 2.0 * (q_1 * q_3 + less_0 * q_2);
    start[2][1] = 2.0 * (q_2 * q_3 + q_0 * q_1);
    start[2][2] = 1.0 - 2.0 * (q_1 * q_1 + q_2 * q_2);
    size_t place = 0;
    for (size_t k = 0; k < 3; k++) {
        if (asks(asked, TORQUE_FREE_BY_ATTITUDE0)) {
            for (size_t j = 0; j < 3; j++) {
                attitude[place + j] = j == k ? 1.0 : 0.0;
                rates[place + j] = 0.0;
            }
            place += 3;
        }
        if (asks(asked, TORQUE_FREE_BY_OMEGA0)) {
            for (size_t j = 0; j < 3; j++) {
                attitude[place + j] = t * start[k][j];
                rates[place + j] = j == k ? 1.0 : 0.0;
            }
            place += 3;
        }
        if (asks(asked, TORQUE_FREE_BY_INERTIA)) {
            for (size_t j = 0; j < 3; j++) {
                attitude[place + j] = 0.0;
                rates[place + j] = 0.0;
            }
            place += 3;
        }
    }
}

/* Return True where one of n numbers is NaN. */
static int any_lost(size_t n, const double *restrict x)
{
    size_t lost = 0;
    for (size_t k = 0; k < n; k++) {
        lost += isnan(x[k]) ? 1 : 0;
    }
    return lost > 0;
}

/* Write n NaN. */
static void no_numbers(size_t n, double *restrict x)
{
    for (size_t k = 0; k < n; k++) {
        x[k] = ((double)NAN);
    }
}

/* Write NaN for all changes of n states. */
static void no_changes(size_t n, uint64_t asked, double *restrict attitude, double *restrict rates,
    double *restrict attitude_t, double *restrict rates_t)
{
    no_numbers(width_of(asked) * n, attitude);
    no_numbers(width_of(asked) * n, rates);
    no_numbers(width_t(asked) * n, attitude_t);
    no_numbers(width_t(asked) * n, rates_t);
}

/* Write n states and their sensitivities; late times have NaN where `lenient`. */
static int sensitivities_at(const torque_free_motion *motion, size_t n, const double *restrict t,
    uint64_t asked, double *restrict q, double *restrict omega, double *restrict attitude,
    double *restrict rates, double *restrict attitude_t, double *restrict rates_t, int lenient)
{
    const size_t width = width_of(asked);
    const size_t by_t = width_t(asked);
    sensitive made;
    double inner[SENSITIVE];
    if (motion->prepared != PREPARED) {
        return TORQUE_FREE_UNPREPARED;
    }
    int code = unrefused_states(motion, n, t, q, omega, lenient);
    if (code != TORQUE_FREE_OK && !lenient) {
        return code;
    }
    sensitive_init(motion, &made);
    for (size_t i = 0; i < n; i += SENSITIVE) {
        const size_t count = n - i <= (size_t)SENSITIVE ? n - i : (size_t)SENSITIVE;
        int near;
        int has_zero;
        scaled_times(motion, count, t + i, inner, &near, &has_zero);
        if (!near) {
            for (size_t k = 0; k < count; k++) {
                inner[k] = fabs(inner[k]) <= motion->max_angle ? inner[k] : 0.0;
            }
        }
        if (!made.at_rest) {
            block_sensitivities(motion, &made, asked, count, inner, q + 4 * i, omega + 3 * i, attitude + width * i, rates + width * i, attitude_t + by_t * i, rates_t + by_t * i);
        } else {
            for (size_t k = 0; k < by_t * count; k++) {
                attitude_t[by_t * i + k] = 0.0;
                rates_t[by_t * i + k] = 0.0;
            }
        }
        if (made.at_rest || has_zero) {
            for (size_t k = i; k < i + count; k++) {
                if (made.at_rest || is_zero(t[k])) {
                    plain_sensitivity(motion, t[k], asked, attitude + width * k, rates + width * k);
                }
            }
        }
        /* Look for lost numbers while the block is in the cache. */
        if (near && !any_lost(width * count, attitude + width * i) && !any_lost(width * count, rates + width * i)) {
            continue;
        }
        for (size_t k = i; k < i + count; k++) {
            const int late = !(fabs(motion->unit * t[k]) <= motion->max_angle);
            if (late || any_lost(width, attitude + width * k) || any_lost(width, rates + width * k)) {
                no_changes(1, asked, attitude + width * k, rates + width * k, attitude_t + by_t * k, rates_t + by_t * k);
                code = late ? code : TORQUE_FREE_GROWTH;
            }
        }
    }
    return code;
}

int torque_free_states_with_sensitivity(const torque_free_motion *motion, size_t n, const double *t,
    double *q, double *omega, double *attitude, double *rates, double *attitude_t, double *rates_t)
{
    return sensitivities_at(motion, n, t, (uint64_t)TORQUE_FREE_BY_ALL, q, omega, attitude, rates, attitude_t, rates_t, 0);
}

int torque_free_states_with_columns(const torque_free_motion *motion, size_t n, const double *t,
    int columns, double *q, double *omega, double *attitude /* or NULL */,
    double *rates /* or NULL */, double *attitude_t /* or NULL */, double *rates_t /* or NULL */)
{
    return sensitivities_at(motion, n, t, (uint64_t)columns, q, omega, attitude, rates, attitude_t, rates_t, 0);
}

int torque_free_propagate_with_columns(size_t bodies, const double *inertia, const double *omega0,
    const double *attitude0, size_t n, const double *t, size_t stride, int columns, double *q,
    double *omega, double *attitude /* or NULL */, double *rates /* or NULL */,
    double *attitude_t /* or NULL */, double *rates_t /* or NULL */, int *codes /* or NULL */,
    size_t *failed)
{
    const uint64_t asked = (uint64_t)columns;
    const size_t width = width_of(asked);
    const size_t by_t = width_t(asked);
    torque_free_motion made[LANES];
    int code[LANES];
    lanes lane;
    memset(&lane, 0, sizeof(lanes));
    const int rounded = is_rounded_once();
    for (size_t first = 0; first < bodies; first += LANES) {
        const size_t count = several_init(made, code, &lane, rounded, bodies - first, inertia + 3 * first, omega0 + 3 * first, attitude0 + 4 * first);
        for (size_t i = 0; i < count; i++) {
            const size_t k = first + i;
            const size_t from_ = n * k;
            if (code[i] == TORQUE_FREE_OK) {
                code[i] = sensitivities_at(&made[i], n, t + stride * k, asked, q + 4 * from_, omega + 3 * from_, attitude + width * from_, rates + width * from_, attitude_t + by_t * from_, rates_t + by_t * from_, codes != NULL);
            } else if (codes != NULL) {
                no_states(n, q + 4 * from_, omega + 3 * from_);
                no_changes(n, asked, attitude + width * from_, rates + width * from_, attitude_t + by_t * from_, rates_t + by_t * from_);
            }
            if (codes != NULL) {
                codes[k] = code[i];
            } else if (code[i] != TORQUE_FREE_OK) {
                failed[0] = k;
                return code[i];
            }
        }
    }
    return TORQUE_FREE_OK;
}

int torque_free_propagate_with_sensitivity(size_t bodies, const double *inertia,
    const double *omega0, const double *attitude0, size_t n, const double *t, size_t stride,
    double *q, double *omega, double *attitude, double *rates, double *attitude_t, double *rates_t,
    int *codes /* or NULL */, size_t *failed)
{
    return torque_free_propagate_with_columns(bodies, inertia, omega0, attitude0, n, t, stride, TORQUE_FREE_BY_ALL, q, omega, attitude, rates, attitude_t, rates_t, codes, failed);
}

const char *torque_free_message(int code)
{
    return code >= 0 && code < CODES ? MESSAGES[code] : UNKNOWN;
}

const char *torque_free_field(int code)
{
    return code >= 0 && code < CODES ? FIELDS[code] : "";
}

const char *torque_free_rule(int code)
{
    return code >= 0 && code < CODES ? RULES[code] : UNKNOWN;
}

const char *torque_free_digest(void)
{
    return "50a151230d5c62816e6eb527a698198c1fa3b1e751c8062a08e4850d1b368ccf";
}

