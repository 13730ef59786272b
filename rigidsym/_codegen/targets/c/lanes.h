/* How many states are computed side by side; each takes about 240 bytes of stack on a grid. */
#ifndef TORQUE_FREE_BLOCK
#define TORQUE_FREE_BLOCK 64
#endif
#define BLOCK ((size_t)TORQUE_FREE_BLOCK)

/* How many motions are prepared side by side, or one in as many lanes: what a register holds, but
   one where roots that report errors keep loops from being vectorised.  What these call has to be
   in them, too, which takes seconds to compile, and is in vain where addresses are checked. */
#ifndef TORQUE_FREE_LANES
#if !defined(__OPTIMIZE__) || !defined(__NO_MATH_ERRNO__)
#define TORQUE_FREE_LANES 1
#elif defined(__AVX512F__)
#define TORQUE_FREE_LANES 8
#elif defined(__AVX__)
#define TORQUE_FREE_LANES 4
#elif defined(__aarch64__)
#define TORQUE_FREE_LANES 2
#else
#define TORQUE_FREE_LANES 1
#endif
#endif
#define LANES TORQUE_FREE_LANES
#if LANES > 1 && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define FLAT __attribute__((flatten))
#else
#define FLAT
#endif
