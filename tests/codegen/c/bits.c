/* Print a hash of states, sensitivities, grids and steps of random bodies: one number for each set of bits. */
#include "torque_free.h"
#include "torque_free_step.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { BODIES = 500, TIMES = 8 };

static uint64_t state = UINT64_C(88172645463325252), hash = UINT64_C(1469598103934665603);

/* A number between 0 and 1 (Marsaglia's xorshift). */
static double drawn(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return ldexp((double)(state >> 11), -53);
}

/* Add bits to the hash (FNV-1a), in an order that no processor decides; every NaN counts alike. */
static void add(size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++) {
        uint64_t bits = UINT64_C(0x7ff8000000000000);
        if (!isnan(x[i]))
            memcpy(&bits, &x[i], sizeof bits);
        for (int k = 0; k < 64; k += 8)
            hash = (hash ^ (bits >> k & 255)) * UINT64_C(1099511628211);
    }
}

int main(void)
{
    for (int body = 0; body < BODIES; body++) {
        double c[3], omega0[3], q0[4], t[TIMES], dt;
        double q[4 * TIMES], omega[3 * TIMES], by_input[54 * TIMES], by_time[6 * TIMES];
        size_t failed;
        int code;
        for (int k = 0; k < 3; k++)
            c[k] = 1.0 + drawn();
        for (int k = 0; k < 3; k++)
            omega0[k] = 2.0 * drawn() - 1.0;
        for (int k = 0; k < 4; k++)
            q0[k] = 2.0 * drawn() - 1.0;
        if (body % 7 == 0)
            c[1] = c[0];
        if (body % 11 == 0)
            c[2] = c[1];
        omega0[0] *= body % 5 ? 1.0 : 1e-9;
        omega0[1] *= body % 13 ? 1.0 : 1e-12;
        for (int k = 0; k < TIMES; k++) {
            const double share = drawn() - 0.5;
            t[k] = ldexp(share, (int)(60.0 * drawn()) - 25);
        }
        if (torque_free_propagate_with_sensitivity(1, c, omega0, q0, TIMES, t, 0, q, omega, by_input,
                                                   by_input + 27 * TIMES, by_time, by_time + 3 * TIMES, &code, &failed))
            return 1;
        add(4 * TIMES, q), add(3 * TIMES, omega), add(54 * TIMES, by_input), add(6 * TIMES, by_time);
        dt = t[0] - t[1] < 0.0 ? 0.7 : -0.1;
        if (torque_free_steps(1, c, 3, q0, omega0, &dt, 0, q, omega, &failed))
            return (int)failed + 2;
        add(4, q), add(3, omega);
    }
    printf("%016llx\n", (unsigned long long)hash);
    return 0;
}
