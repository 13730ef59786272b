/* The double-double arithmetic that all forms share, on rows {x.hi, x.lo, y.hi, y.lo} to rows
   {hi, lo}; `exact_parts` on rows {a, b, c, d} to rows of 32 parts of (a - b) (c d). */

#include "torque_free_arithmetic.h"

#include "exact_numbers.c"

enum { ADD_XX, ADD_XD, SUB_XX, MUL_XX, MUL_XD, DIV_XX, DIV_XD, ROOT, SUM, QUICK_SUM, PRODUCT };

void pairs(int operation, size_t n, const double *in, double *out);
void doubles(int operation, size_t n, const double *in, double *out);
void exact_parts(size_t n, const double *in, double *out);

void pairs(int operation, size_t n, const double *in, double *out)
{
    for (size_t i = 0; i < n; i++) {
        const double_double x = {in[4 * i], in[4 * i + 1]}, y = {in[4 * i + 2], in[4 * i + 3]};
        double_double z = {0.0, 0.0};
        switch (operation) {
        case ADD_XX: z = dd_add_xx(x, y); break;
        case ADD_XD: z = dd_add_xd(x, y.hi); break;
        case SUB_XX: z = dd_sub_xx(x, y); break;
        case MUL_XX: z = dd_mul_xx(x, y); break;
        case MUL_XD: z = dd_mul_xd(x, y.hi); break;
        case DIV_XX: z = dd_div_xx(x, y); break;
        case DIV_XD: z = dd_div_xd(x, y.hi); break;
        case ROOT: z = dd_sqrt(x); break;
        case SUM: z = two_sum(x.hi, y.hi); break;
        case QUICK_SUM: z = quick_sum(x.hi, y.hi); break;
        case PRODUCT: z = two_product(x.hi, y.hi); break;
        default: break;
        }
        out[2 * i] = z.hi;
        out[2 * i + 1] = z.lo;
    }
}

/* nearest, (-1)^n, 2^n, and the exponent of the pair's mantissa. */
void doubles(int operation, size_t n, const double *in, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = operation == 0   ? nearest(in[i])
                 : operation == 1 ? alternating(in[i])
                 : operation == 2 ? power_of_two(in[i])
                                  : dd_exponent(dd_of(in[i]));
}

void exact_parts(size_t n, const double *in, double *out)
{
    for (size_t i = 0; i < n; i++) {
        const double *x = in + 4 * i;
        const exact first = exact_sub_xx(exact_of(x[0]), exact_of(x[1]));
        const exact whole = exact_mul_xx(first, exact_mul_xx(exact_of(x[2]), exact_of(x[3])));
        for (int k = 0; k < 32; k++)
            out[32 * i + (size_t)k] = k < (int)whole.count ? whole.part[k] : 0.0;
    }
}
