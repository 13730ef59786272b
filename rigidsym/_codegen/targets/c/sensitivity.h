/* Inputs that states change with, to be added up; columns are in this order. */
enum {
    TORQUE_FREE_BY_ATTITUDE0 = 1, /* three: a small turn at t = 0, in space */
    TORQUE_FREE_BY_OMEGA0 = 2,    /* three: the rates at t = 0 */
    TORQUE_FREE_BY_INERTIA = 4,   /* three: the principal moments */
    TORQUE_FREE_BY_T = 8,         /* the time, which has arrays of its own */
    TORQUE_FREE_BY_ALL = 15
};

/* The states at n times t[n] (s), as torque_free_states_at has them, and their changes with the inputs.
   attitude[n][3][9]: a small turn eta in space, rad: the matrix from body to space changes by [eta] times
   itself.  rates[n][3][9]: the body rates.  Their columns: the small turn at t = 0, omega0 and the
   principal moments.  attitude_t[n][3], rates_t[n][3]: both by the time.  No arrays overlap; numbers beyond
   binary64 are infinite.  Returns a code as torque_free_states_at does, or TORQUE_FREE_GROWTH with states
   at all times and changes that are NaN at some. */
int torque_free_states_with_sensitivity(const torque_free_motion *motion, size_t n, const double *t, double *q,
                                        double *omega, double *attitude, double *rates, double *attitude_t,
                                        double *rates_t);

/* States and changes at n times of each of many bodies, as torque_free_propagate has them: q[bodies][n][4] to
   rates_t[bodies][n][3], none of which overlap.  Where codes is not NULL, refused times have states
   of NaN, and changes are NaN at these times and at those where they leave binary64; a body with such a
   time has code TORQUE_FREE_GROWTH, whatever else it has. */
int torque_free_propagate_with_sensitivity(size_t bodies, const double *inertia, const double *omega0,
                                           const double *attitude0, size_t n, const double *t, size_t stride,
                                           double *q, double *omega, double *attitude, double *rates,
                                           double *attitude_t, double *rates_t, int *codes /* or NULL */,
                                           size_t *failed);

/* Both with the changes in `columns` alone, a sum of the inputs above: attitude[n][3][m] and
   rates[n][3][m] have three columns for each of the first three that is in it, attitude_t and rates_t are
   written where TORQUE_FREE_BY_T is.  TORQUE_FREE_GROWTH is about these columns alone. */
int torque_free_states_with_columns(const torque_free_motion *motion, size_t n, const double *t, int columns,
                                    double *q, double *omega, double *attitude /* or NULL */,
                                    double *rates /* or NULL */, double *attitude_t /* or NULL */,
                                    double *rates_t /* or NULL */);
int torque_free_propagate_with_columns(size_t bodies, const double *inertia, const double *omega0,
                                       const double *attitude0, size_t n, const double *t, size_t stride,
                                       int columns, double *q, double *omega, double *attitude /* or NULL */,
                                       double *rates /* or NULL */, double *attitude_t /* or NULL */,
                                       double *rates_t /* or NULL */, int *codes /* or NULL */, size_t *failed);
