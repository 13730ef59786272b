/* Motions and times from arbitrary bits: each is refused by a code, or its states are finite, with
   |q| = 1 to 1e-15 and no exception but inexact and underflow on the way; and many at once have the
   bits and codes of each alone.  Prints how often each
   code came back; the exit status is 1 where something broke the rule.  Arguments: how many, seed. */
#include "torque_free.h"

#include <fenv.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CODES = 12, TIMES = 6, BODIES = 11 };
typedef double source(void);

static uint64_t state;
static long counts[CODES], broken;

static uint64_t next(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static double of_bits(void)
{
    const uint64_t bits = next();
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static double within(int exponents)
{
    const int e = (int)(next() % (2 * (uint64_t)exponents + 1)) - exponents;
    const double size = ldexp(1.0 + (double)(next() >> 12) * 0x1p-52, e);
    return next() % 2 ? size : -size;
}

static double of_any_size(void) { return within(1070); }
static double of_wide_size(void) { return within(130); }
static double of_usual_size(void) { return within(3); }

static double special(void)
{
    static const double values[] = {
        0.0, -0.0, 1.0, -1.0, 2.0, 3.0, 0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp+1023, HUGE_VAL,
        -HUGE_VAL, (double)NAN, 0x1p-200, 0x1.fffffffffffffp-201, 0x1p-300, 0x1p-400, 0x1.fffffffffffffp-401,
        0x1.0000000000001p+0, 0x1.fffffffffffffp-1, 0x1p+46, 0x1p+1020};
    return values[next() % (sizeof values / sizeof *values)];
}

/* Mostly positive; sometimes within a few last digits of the one before. */
static void inertia_from(source *one, double c[3])
{
    for (int k = 0; k < 3; k++) {
        c[k] = next() % 8 ? fabs(one()) : one();
        if (k && next() % 8 == 0)
            c[k] = c[k - 1] * (1.0 + 0x1p-52 * (double)(next() % 4));
    }
}

static int all_finite(int n, const double *x)
{
    for (int k = 0; k < n; k++)
        if (!isfinite(x[k]))
            return 0;
    return 1;
}

static int is_state(const double q[4], const double omega[3])
{
    const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    return all_finite(4, q) && all_finite(3, omega) && fabs(norm - 1.0) <= 2e-15;
}

/* Exceptions that a comparison with a signalling NaN raises are the input's. */
static int is_quiet(void) { return !fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); }

static void complain(const char *what, const double given[10], double t)
{
    printf("%s at t = %a:", what, t);
    for (int k = 0; k < 10; k++)
        printf(" %a", given[k]);
    printf("\n");
    broken++;
}

static void try_times(const torque_free_motion *motion, source *one, const double given[10])
{
    const double rate = fabs(given[3]) + fabs(given[4]) + fabs(given[5]);
    for (int k = 0; k < TIMES; k++) {
        double q[4], omega[3];
        const double t = k == 0 ? 0.0 : k < 3 ? one() : within(40) / rate;
        feclearexcept(FE_ALL_EXCEPT);
        const int code = torque_free_state_at(motion, t, q, omega);
        counts[code]++;
        if (code == TORQUE_FREE_OK && !is_state(q, omega))
            complain("no state", given, t);
        if (code == TORQUE_FREE_OK && !is_quiet())
            complain("an exception", given, t);
    }
}

static void try_motion(source *inertia, source *one)
{
    double given[10];
    torque_free_motion motion;
    inertia_from(inertia, given);
    for (int k = 3; k < 10; k++)
        given[k] = one();
    feclearexcept(FE_ALL_EXCEPT);
    const int code = torque_free_motion_init(&motion, given, given + 3, given + 6);
    if (code == TORQUE_FREE_OK && !is_quiet())
        complain("an exception", given, 0.0);
    if (code == TORQUE_FREE_OK)
        try_times(&motion, one, given);
    else
        counts[code]++;
}

/* Bodies of which some are refused, on all branches. */
static void try_batch(source *one)
{
    double inertia[BODIES][3], omega0[BODIES][3], attitude0[BODIES][4], t[BODIES], q[BODIES][4], omega[BODIES][3];
    int codes[BODIES];
    size_t failed;
    for (int k = 0; k < BODIES; k++) {
        inertia_from(one, inertia[k]);
        for (int j = 0; j < 3; j++)
            omega0[k][j] = next() % 8 ? one() : 0.0;
        for (int j = 0; j < 4; j++)
            attitude0[k][j] = one();
        t[k] = within(3) / fabs(omega0[k][0]);
    }
    torque_free_propagate(BODIES, *inertia, *omega0, *attitude0, 1, t, 1, *q, *omega, codes, &failed);
    for (int k = 0; k < BODIES; k++) {
        torque_free_motion motion;
        double own_q[4], own_omega[3];
        int code = torque_free_motion_init(&motion, inertia[k], omega0[k], attitude0[k]);
        if (code == TORQUE_FREE_OK)
            code = torque_free_state_at(&motion, t[k], own_q, own_omega);
        const int same = code || (!memcmp(own_q, q[k], sizeof own_q) && !memcmp(own_omega, omega[k], sizeof own_omega));
        if (code != codes[k] || !same) {
            printf("body %d has code %d of %d, or other bits: %a\n", k, codes[k], code, t[k]);
            broken++;
        }
    }
}

int main(int count, char **arguments)
{
    source *const sources[] = {of_bits, of_any_size, of_wide_size, of_usual_size, special};
    const long motions = count > 1 ? atol(arguments[1]) : 1000;
    state = 88172645463325252u + (count > 2 ? strtoul(arguments[2], NULL, 10) : 0);
    for (long k = 0; k < motions; k++) {
        source *const one = sources[next() % 5];
        try_motion(next() % 4 ? one : of_usual_size, one);
        if (k % 64 == 0)
            try_batch(one);
    }
    for (int k = 0; k < CODES; k++)
        printf("%ld ", counts[k]);
    return broken > 0;
}
