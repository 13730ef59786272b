/* Print a line of hashes for each stratum of the motions on stdin: of states, steps, and sensitivities.
   `rigidsym.validate._same_bits` describes the motions and the hashes. */
#include "torque_free.h"
#include "torque_free_step.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GIVEN = 11, TIMES = 32 };

static uint64_t states, steps, sensitivities;

static void add(uint64_t *hash, size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++) {
        uint64_t bits = UINT64_C(0x7ff8000000000000);
        if (!isnan(x[i]))
            memcpy(&bits, &x[i], sizeof bits);
        *hash = (*hash ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
        *hash ^= *hash >> 32;
    }
}

/* Add the states of one motion: inertia (3), omega0 (3), q0 (4), the time of a step, and n times. */
static int add_motion(size_t n, double *x)
{
    static double q[4 * TIMES], omega[3 * TIMES], by[54 * TIMES], by_time[6 * TIMES];
    const double *t = x + GIVEN;
    torque_free_motion motion;
    size_t failed;
    int code = torque_free_motion_init(&motion, x, x + 3, x + 6);
    if (!code)
        code = torque_free_states_at(&motion, n, t, q, omega);
    if (code)
        return code;
    add(&states, 4 * n, q), add(&states, 3 * n, omega);
    code = torque_free_states_with_sensitivity(&motion, n, t, q, omega, by, by + 27 * n, by_time, by_time + 3 * n);
    if (code && code != TORQUE_FREE_GROWTH)
        return code;
    add(&sensitivities, 54 * n, by), add(&sensitivities, 6 * n, by_time);
    code = torque_free_steps(1, x, 3, x + 6, x + 3, x + 10, 1, q, omega, &failed);
    if (code)
        return code;
    add(&steps, 4, q), add(&steps, 3, omega);
    return 0;
}

static void print(const char *stratum)
{
    if (*stratum)
        printf("%016llx %016llx %016llx %s\n", (unsigned long long)states, (unsigned long long)steps,
               (unsigned long long)sensitivities, stratum);
    states = steps = sensitivities = 0;
}

int main(void)
{
    char line[1024], stratum[64] = "";
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = 0;
        if (line[0] == '=') {
            print(stratum);
            strncpy(stratum, line + 2, sizeof stratum - 1);
        } else {
            double x[GIVEN + TIMES];
            size_t n = 0;
            for (char *next, *at = line; n < GIVEN + TIMES; at = next, n++) {
                const uint64_t bits = strtoull(at, &next, 16);
                if (next == at)
                    break;
                memcpy(&x[n], &bits, sizeof bits);
            }
            if (n <= GIVEN || add_motion(n - GIVEN, x))
                return 1;
        }
    }
    print(stratum);
    return 0;
}
