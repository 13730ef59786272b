/* Return codes; 0 is success. */
enum {
@codes@
};

/* The constants of a body; written by torque_free_body_init, read by torque_free_step. */
typedef struct {
    int axis[3];  /* by moments of inertia, the largest first */
    int prepared; /* a mark that torque_free_body_init has written the struct */
    double epsilon, moments[3], alphas[6], squares[6];
} torque_free_body;

/* The constants of a body.  inertia: principal moments about the body axes, kg m^2, positive.
   Functions that take moments refuse those that no body can have, beyond rounding, as
   TORQUE_FREE_STEP_NONPHYSICAL, unless the source is compiled with -DALLOW_NONPHYSICAL.  Returns a code
   above. */
int torque_free_body_init(torque_free_body *body, const double inertia[3]);

/* The free motion after dt (s), in place: q[4], scalar first, body to inertial, of any length but
   zero, becomes a unit quaternion, continuous in the double cover; omega[3], body rates in rad/s.
   Returns a code above; a call that fails writes nothing. */
int torque_free_step(const torque_free_body *body, double q[4], double omega[3], double dt);

/* One step of each of n bodies of moments inertia[n][3], in lanes: q[n][4] and omega[n][3] to q_after[n][4]
   and omega_after[n][3], which may be q and omega themselves, and overlap nothing else.  Body k has
   the moments at inertia + k inertia_stride and the time dt[k dt_stride]: strides are 3 and 1, or 0
   where all have the same.  A body has the same bits wherever it stands among others.  The first
   body that is refused ends the call: its number is left in *failed, its code is returned, and bodies
   LANES or more before it are done. */
int torque_free_steps(size_t n, const double *inertia, size_t inertia_stride, const double *q,
                      const double *omega, const double *dt, size_t dt_stride, double *q_after,
                      double *omega_after, size_t *failed);

/* sizeof(torque_free_body), and the digest of the header and the source, for callers of a shared library. */
size_t torque_free_body_size(void);
const char *torque_free_step_digest(void);

/* The message of a code, in one line: the field and its rule. */
const char *torque_free_step_message(int code);

/* The field of the input that a code is about, "" for none, and the rule that it breaks. */
const char *torque_free_step_field(int code);
const char *torque_free_step_rule(int code);
