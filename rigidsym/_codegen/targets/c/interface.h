/* Return codes; 0 is success.  A call for one body that fails writes nothing. */
enum {
@codes@
};

/* The constants of one motion; written by torque_free_motion_init, read by all others. */
typedef struct {
    int branch;          /* 0 steady, 1 circular, 2 hyperbolic */
    int axis[3];         /* the body axes a, b, d */
    int blurred;         /* 1 where later times are refused as TORQUE_FREE_SEPARATRIX */
    int prepared;        /* a mark that torque_free_motion_init has written the struct */
    double unit;         /* a power of two, 1/s: inner times are unit t; 0 at rest */
    double max_angle;     /* the largest inner time */
    double q0[4];        /* attitude at t = 0 */
    double omega0[3];    /* body rates at t = 0, rad/s */
    union {
@branches@
    } of;
    double moment_unit;  /* a power of two, kg m^2: inner moments are times this */
    double given[20];    /* moments, their differences, rates and E_b, all inner, in pairs */
} torque_free_motion;

/* The constants of a motion.  inertia: principal moments about the body axes, kg m^2, positive;
   omega0: body rates at t = 0, rad/s; attitude0: quaternion at t = 0, scalar first, body to
   inertial, of any length but zero.  Functions that take moments refuse those that no body can
   have, beyond rounding, as TORQUE_FREE_NONPHYSICAL, unless the source is compiled with
   -DALLOW_NONPHYSICAL.  Returns a code above. */
int torque_free_motion_init(torque_free_motion *motion, const double inertia[3], const double omega0[3],
                          const double attitude0[4]);

/* The constants of a motion from numbers known beyond binary64, each the sum of two doubles {hi, lo}.
   The largest moment and the largest rate should be between 1/2 and 4.  Numbers that pairs would lose
   by subtraction are arguments, right to all digits of a double_double: differences, moments 0 less 1,
   1 less 2 and 2 less 0, and discriminant, K^2 - 2 H c_b, b the middle axis, whose sign decides the
   regime.  Rates are times `unit` rad/s, a power of two. */
int torque_free_motion_init_double_doubles(torque_free_motion *motion, const double inertia[3][2],
                                const double differences[3][2], const double omega0[3][2],
                                const double attitude0[4][2], const double discriminant[2], double unit);

/* The state at time t (s): q[4], unit, body to inertial, continuous in the double cover from
   attitude0 on, and omega[3], body rates in rad/s.  Returns 0,
   TORQUE_FREE_NOT_FINITE, TORQUE_FREE_TIME, TORQUE_FREE_SEPARATRIX or, as all functions below,
   TORQUE_FREE_UNPREPARED. */
int torque_free_state_at(const torque_free_motion *motion, double t, double q[4], double omega[3]);

/* The states at n times t[n] (s), in any order: q[n][4] and omega[n][3], row by row, which must
   not overlap each other or t.  Returns a code as torque_free_state_at does. */
int torque_free_states_at(const torque_free_motion *motion, size_t n, const double *t, double *q,
                          double *omega);

/* The n states at start + k step, k = first, first + 1, ..., exactly these times; first + n <= 2^53.
   Sines are evaluated once in 64 samples, but near the separatrix.  A grid in parts, each begun at a
   multiple of 64, has the same bits as the whole. */
int torque_free_states_on_grid(const torque_free_motion *motion, double start, double step, size_t first,
                               size_t n, double *q, double *omega);

/* A motion and n states for each of many bodies: inertia[bodies][3], omega0[bodies][3],
   attitude0[bodies][4] and t[n] to q[bodies][n][4] and omega[bodies][n][3], none of which overlap.
   Times of body k are t[k stride], t[k stride + 1], ...: stride is 0 where all have the same, n where
   t is t[bodies][n].
   codes[bodies]: the code of each body; refused bodies and times have states of NaN, and 0 is
   returned.  Where codes is NULL, the first body that is refused ends the call: its number is left
   in *failed, its code is returned, and the states of the bodies before it are written. */
int torque_free_propagate(size_t bodies, const double *inertia, const double *omega0,
                          const double *attitude0, size_t n, const double *t, size_t stride,
                          double *q, double *omega, int *codes /* or NULL */, size_t *failed);

/* The largest |t| (s) that a motion has states for; NaN where it was not prepared. */
double torque_free_last_time(const torque_free_motion *motion);

/* sizeof(torque_free_motion), and the digest of the header and the source, for callers of a shared library. */
size_t torque_free_motion_size(void);
const char *torque_free_digest(void);

/* The message of a code, in one line: the field and its rule. */
const char *torque_free_message(int code);

/* The field of the input that a code is about, "" for none, and the rule that it breaks. */
const char *torque_free_field(int code);
const char *torque_free_rule(int code);
