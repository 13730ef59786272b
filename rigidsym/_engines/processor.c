/* The code path of this processor, for libraries that are shipped with several.

Sources: AMD64 psABI, section "Micro-Architecture Levels"; Intel SDM, volume 2, CPUID and XGETBV.

A level counts only if the system saves its registers, as XGETBV says.  macOS enables those of AVX-512
at their first use, and is taken for one without them. */

#if defined(__x86_64__)
#include <cpuid.h>

static int has(unsigned int bits, unsigned int wanted)
{
    return (bits & wanted) == wanted;
}

/* Return 4, 3 or 1: the highest of the levels x86-64-v4, x86-64-v3 and x86-64 that can be used. */
int torque_free_processor_level(void)
{
    unsigned int a, b, c, d, state, upper;
    /* SSE3, SSSE3, FMA, CMPXCHG16B, SSE4.1, SSE4.2, MOVBE, POPCNT, OSXSAVE, AVX, F16C */
    const unsigned int first = 1u | 1u << 9 | 1u << 12 | 1u << 13 | 1u << 19 | 1u << 20 | 1u << 22
        | 1u << 23 | 1u << 27 | 1u << 28 | 1u << 29;
    if (!__get_cpuid(1, &a, &b, &c, &d) || !has(c, first)) {
        return 1;
    }
    __asm__ volatile("xgetbv" : "=a"(state), "=d"(upper) : "c"(0));
    /* LAHF, LZCNT */
    if (!has(state, 6u) || !__get_cpuid(0x80000001u, &a, &b, &c, &d) || !has(c, 1u | 1u << 5)) {
        return 1;
    }
    /* BMI1, AVX2, BMI2 */
    if (!__get_cpuid_count(7, 0, &a, &b, &c, &d) || !has(b, 1u << 3 | 1u << 5 | 1u << 8)) {
        return 1;
    }
    /* AVX512F, DQ, CD, BW, VL */
    const unsigned int wide = 1u << 16 | 1u << 17 | 1u << 28 | 1u << 30 | 1u << 31;
    return has(b, wide) && has(state, 0xe6u) ? 4 : 3;
}
#else
/* Return 0: other processors have one code path. */
int torque_free_processor_level(void)
{
    return 0;
}
#endif
