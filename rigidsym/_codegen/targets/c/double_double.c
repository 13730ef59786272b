/* Extended numbers need every operation rounded to double once, and none reordered.  Not every option
   that breaks this shows in a macro: torque_free_motion_init looks, too. */
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
