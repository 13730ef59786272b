/* States of motions: a line of input holds inertia[3], omega0[3], attitude0[4], the number of times
   and the times; a line of output holds the code and, where it is 0, q and omega at each time.
   Numbers are hexadecimal, so that none is rounded on the way. */
#include "torque_free.h"

#include <stdio.h>

enum { MOST = 64 };

static int read_numbers(size_t n, double *x)
{
    for (size_t k = 0; k < n; k++)
        if (scanf("%lf", x + k) != 1)
            return 0;
    return 1;
}

static void print_numbers(size_t n, const double *x)
{
    for (size_t k = 0; k < n; k++)
        printf(" %a", x[k]);
}

int main(void)
{
    double given[10], t[MOST], q[4 * MOST], omega[3 * MOST];
    torque_free_motion motion;
    size_t n;
    while (read_numbers(10, given)) {
        if (scanf("%zu", &n) != 1 || n > MOST || !read_numbers(n, t))
            return 1;
        int code = torque_free_motion_init(&motion, given, given + 3, given + 6);
        if (!code)
            code = torque_free_states_at(&motion, n, t, q, omega);
        printf("%d", code);
        for (size_t k = 0; !code && k < n; k++) {
            print_numbers(4, q + 4 * k);
            print_numbers(3, omega + 3 * k);
        }
        printf("\n");
    }
    return 0;
}
