#include "@header@"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
#define restrict __restrict
#endif

/* What loops call has to be in them, or they are not vectorised; not every module calls all. */
#ifdef __GNUC__
#define INLINED inline __attribute__((always_inline, unused))
#else
#define INLINED inline
#endif
