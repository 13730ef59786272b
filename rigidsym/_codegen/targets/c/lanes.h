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

/* Write columns as rows, as many as whole registers hold, and return how many: gcc shuffles three times
   as many registers of AVX2 as it needs to. */
#if defined(__AVX2__) && !defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>

static INLINED size_t shuffled(size_t n, const double *restrict a, const double *restrict b,
                               const double *restrict c, double *restrict rows)
{
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        const __m256d x = _mm256_loadu_pd(a + i), y = _mm256_loadu_pd(b + i), z = _mm256_loadu_pd(c + i);
        const __m256d xy = _mm256_unpacklo_pd(x, y), yz = _mm256_unpackhi_pd(y, z);
        const __m256d zx = _mm256_shuffle_pd(z, x, 10);
        _mm256_storeu_pd(rows + 3 * i, _mm256_permute2f128_pd(xy, zx, 0x20));
        _mm256_storeu_pd(rows + 3 * i + 4, _mm256_blend_pd(yz, xy, 12));
        _mm256_storeu_pd(rows + 3 * i + 8, _mm256_permute2f128_pd(zx, yz, 0x31));
    }
    return i;
}

static INLINED size_t shuffled4(size_t n, const double *restrict a, const double *restrict b,
                                const double *restrict c, const double *restrict d, double *restrict rows)
{
    size_t i = 0;
    for (; i + 2 <= n; i += 2) {
        const __m256d ac = _mm256_set_m128d(_mm_loadu_pd(c + i), _mm_loadu_pd(a + i));
        const __m256d bd = _mm256_set_m128d(_mm_loadu_pd(d + i), _mm_loadu_pd(b + i));
        _mm256_storeu_pd(rows + 4 * i, _mm256_unpacklo_pd(ac, bd));
        _mm256_storeu_pd(rows + 4 * i + 4, _mm256_unpackhi_pd(ac, bd));
    }
    return i;
}
#else
#define shuffled(n, a, b, c, rows) ((size_t)0)
#define shuffled4(n, a, b, c, d, rows) ((size_t)0)
#endif
