/* Motions are prepared where numbers are rounded to nearest, and refused in other roundings. */
#include <fenv.h>
#include "torque_free.h"

int main(void)
{
    const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    const double moments[] = {1.0, 2.0, 2.5}, rates[] = {0.3, 0.5, -0.7};
    const double start[] = {1.0, 0.0, 0.0, 0.0};
    torque_free_motion motion;
    for (int k = 0; k < 4; k++)
        if (fesetround(modes[k]) ||
            torque_free_motion_init(&motion, moments, rates, start) !=
                (k ? TORQUE_FREE_ARITHMETIC : 0))
            return 1 + k;
    return 0;
}
