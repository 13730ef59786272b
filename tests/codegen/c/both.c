/* One motion at one time by the modules of both forms, in one programme. */
#include "torque_free.h"
#include "torque_free_pi.h"

#include <stdio.h>

static const double inertia[3] = {0.0109, 0.04, 0.0506}, omega0[3] = {0.05, 0.03, -0.02};
static const double attitude0[4] = {1, 0, 0, 0};

static void print(const double *q) { printf("%.17g %.17g %.17g %.17g\n", q[0], q[1], q[2], q[3]); }

int main(void)
{
    torque_free_motion motion;
    torque_free_pi_motion other;
    double q[4], omega[3];
    if (torque_free_motion_init(&motion, inertia, omega0, attitude0))
        return 1;
    if (torque_free_state_at(&motion, 180.0, q, omega))
        return 2;
    print(q);
    if (torque_free_pi_motion_init(&other, inertia, omega0, attitude0))
        return 1;
    if (torque_free_pi_state_at(&other, 180.0, q, omega))
        return 2;
    print(q);
    return 0;
}
