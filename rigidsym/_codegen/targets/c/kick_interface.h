/* The direction of a body from a mass point on a Kepler orbit: mean motion (rad/s), a time at periapsis
   (s), eccentricity, which is not 1, size of the semi-major axis (m), 3 mu (m^3/s^2), and unit
   vectors, inertial axes, towards periapsis and a right angle on from there. */
typedef struct {
    double mean_motion, epoch, eccentricity, semi_major, strength, along[3], across[3];
} torque_free_orbit;

/* A torque of each body, b + k v + v x (Q v - m) in body axes, N m, with v what a vector u in space
   is there.  vector: u, inertial axes, of body k at vector + k vector_stride; on an orbit, where
   that is not null, u is that from the mass point times sqrt(3 mu/r^5).  coefficients: three b, k,
   three m, and Q11, Q22, Q33, Q23, Q13, Q12 of body k at coefficients + k coefficients_stride.
   Strides are 3 and 13, or 0 where all have the same.  more, where it is not null, adds another
   torque on a body of attitude q at a time, in body axes, and is called with data. */
typedef struct {
    const double *coefficients;
    size_t coefficients_stride;
    const double *vector;
    size_t vector_stride;
    const torque_free_orbit *orbit;
    void (*more)(double t, const double q[4], double torque[3], void *data);
    void *data;
} torque_free_torque;

/* A splitting method: drift, kick, drift ... kick, drift, as shares of a step.  There is one drift
   more than kicks, and the last is as long as the first. */
typedef struct {
    size_t count;
    const double *drifts, *kicks;
} torque_free_splitting;

/* The motion of n bodies under a torque from the time begin + first step to begin + last step (s),
   in place: q[n][4] and omega[n][3].  Free motions between kicks are steps, each of |omega dt| up to
   2^@max_step@ rad; those that meet are one.  Bodies with moments inertia as in torque_free_steps.
   The first body that is refused ends the call: its number is left in *failed, its code is returned,
   and that body and all after it are unchanged, except for bodies less than LANES away. */
int torque_free_integrate(size_t n, const double *inertia, size_t inertia_stride,
                          const torque_free_splitting *method, const torque_free_torque *torque,
                          double begin, double step, size_t first, size_t last, double *q,
                          double *omega, size_t *failed);
