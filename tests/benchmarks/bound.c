/* The least that a state could cost on this machine: the sines and cosines of two angles that grow
   with time, by glibc's vector library, and 56 bytes written, in whole vectors, to two arrays.

       gcc -O3 -march=native -shared -fPIC bound.c -o bound.so -lmvec -lm

   Called by their names in the vector ABI, since gcc merges a sine and a cosine of one angle into a
   scalar call that it does not vectorise. */
#include <immintrin.h>
#include <stddef.h>

#define BOUND(name, vector, width, load, store, all, times, plus, sine, cosine)                     \
    vector sine(vector);                                                                            \
    vector cosine(vector);                                                                          \
    /* n is a multiple of the width; what is left over is not worth a sample in the time. */        \
    void name(size_t n, const double *t, double rate, double other, double *q, double *omega)       \
    {                                                                                               \
        const vector a = all(rate), b = all(other);                                                 \
        for (size_t i = 0; i + width <= n; i += width) {                                            \
            const vector time = load(t + i), v = times(a, time), w = times(b, time);                \
            const vector sin_v = sine(v), cos_v = cosine(v), sin_w = sine(w), cos_w = cosine(w);    \
            store(q + 4 * i, sin_v);                                                                \
            store(q + 4 * i + width, cos_v);                                                        \
            store(q + 4 * i + 2 * width, sin_w);                                                    \
            store(q + 4 * i + 3 * width, cos_w);                                                    \
            store(omega + 3 * i, plus(sin_v, sin_w));                                               \
            store(omega + 3 * i + width, plus(sin_v, cos_w));                                       \
            store(omega + 3 * i + 2 * width, plus(cos_v, sin_w));                                   \
        }                                                                                           \
    }

BOUND(bound_256, __m256d, 4, _mm256_loadu_pd, _mm256_storeu_pd, _mm256_set1_pd, _mm256_mul_pd,
      _mm256_add_pd, _ZGVdN4v_sin, _ZGVdN4v_cos)

#ifdef __AVX512F__
BOUND(bound_512, __m512d, 8, _mm512_loadu_pd, _mm512_storeu_pd, _mm512_set1_pd, _mm512_mul_pd,
      _mm512_add_pd, _ZGVeN8v_sin, _ZGVeN8v_cos)
#else
void bound_512(size_t n, const double *t, double rate, double other, double *q, double *omega)
{
    bound_256(n, t, rate, other, q, omega);
}
#endif
