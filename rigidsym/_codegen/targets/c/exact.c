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

