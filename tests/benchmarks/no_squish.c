/* A free step of n bodies by rotations about one principal axis after the other, z/2 y/2 x y/2 z/2
   (Miller and others, J. Chemical Physics 116, 8649-8659): rows of q (4, n), momentum (3, n), and
   the inverse moments (3, n).  Arrays by component, so that -Ofast vectorises sines and cosines. */

#include <math.h>
#include <stddef.h>

static void turned(size_t n, const double *restrict over, double *restrict p, double *restrict m,
                   double *restrict l, double *restrict q_0, double *restrict q_p,
                   double *restrict q_m, double *restrict q_l, double dt)
{
    for (size_t i = 0; i < n; i++) {
        const double half = 0.5 * dt * over[i] * p[i];
        const double c = cos(half), s = sin(half);
        const double cosine = 1.0 - 2.0 * s * s, sine = 2.0 * s * c;
        const double m_i = m[i], l_i = l[i];
        const double w = q_0[i], x = q_p[i], y = q_m[i], z = q_l[i];
        m[i] = cosine * m_i + sine * l_i;
        l[i] = cosine * l_i - sine * m_i;
        q_0[i] = w * c - x * s;
        q_p[i] = x * c + w * s;
        q_m[i] = y * c + z * s;
        q_l[i] = z * c - y * s;
    }
}

void no_squish(size_t n, const double *over, double *q, double *momentum, double dt)
{
    static const struct { int axis; double part; } turns[] = {{2, 0.5}, {1, 0.5}, {0, 1.0}, {1, 0.5}, {2, 0.5}};
    /* Bodies at a time, so that they stay in the cache. */
    const size_t some = 512;
    for (size_t first = 0; first < n; first += some) {
        const size_t count = n - first < some ? n - first : some;
        for (int k = 0; k < 5; k++) {
            const int axis = turns[k].axis, after = (axis + 1) % 3, last = (axis + 2) % 3;
            turned(count, over + axis * n + first, momentum + axis * n + first, momentum + after * n + first,
                   momentum + last * n + first, q + first, q + (1 + axis) * n + first,
                   q + (1 + after) * n + first, q + (1 + last) * n + first, turns[k].part * dt);
        }
    }
}
