// Compiled once per instruction set: CLOD_SIMD_SUFFIX names it, CLOD_SIMD_<SET> selects it. The
// sets called ..._fused may contract m x + a into one instruction, which clod's kernels do by
// name only.
#include "machine_set.h"

#include "simd/simd.h"

#define CHAINS 12 ///< enough for the latency of all units, few enough for 16 registers

/** One number that depends on all chains, so that none is left out. */
static double sum(const vreal x[CHAINS])
{
    double lanes[CLOD_WIDTH];
    double total = 0.0;
    for (int k = 0; k < CHAINS; k++) {
        vreal_store(lanes, x[k]);
        total += lanes[0];
    }
    return total;
}

static void start(vreal x[CHAINS])
{
    for (int k = 0; k < CHAINS; k++) {
        x[k] = vreal_set(1.1 + 0.07 * k);
    }
}

static double multiply_add(int64_t rounds)
{
    vreal x[CHAINS];
    start(x);
    const vreal m = vreal_set(0.999);
    const vreal a = vreal_set(0.0013);
    for (int64_t r = 0; r < rounds; r++) {
        for (int k = 0; k < CHAINS; k++) {
            x[k] = x[k] * m + a;
        }
    }
    return sum(x);
}

static double divide(int64_t rounds)
{
    vreal x[CHAINS];
    start(x);
    const vreal a = vreal_set(1.37);
    for (int64_t r = 0; r < rounds; r++) {
        for (int k = 0; k < CHAINS; k++) {
            x[k] = a / x[k];
        }
    }
    return sum(x);
}

static double root(int64_t rounds)
{
    vreal x[CHAINS];
    start(x);
    const vreal a = vreal_set(1.37);
    for (int64_t r = 0; r < rounds; r++) {
        for (int k = 0; k < CHAINS; k++) {
            x[k] = vreal_sqrt(x[k] + a);
        }
    }
    return sum(x);
}

static void update(double *a, const double *b, size_t count)
{
    const vreal s = vreal_set(0.4);
    for (size_t k = 0; k < count; k += CLOD_WIDTH) {
        vreal_store(&a[k], vreal_load(&a[k]) + s * vreal_load(&b[k]));
    }
}

#define SET_NAME_OF(suffix) bench_machine_##suffix
#define SET_NAME(suffix) SET_NAME_OF(suffix)
#define SET_TEXT_OF(suffix) #suffix
#define SET_TEXT(suffix) SET_TEXT_OF(suffix)

extern const bench_machine_set SET_NAME(CLOD_SIMD_SUFFIX);
const bench_machine_set SET_NAME(CLOD_SIMD_SUFFIX) = {
    .name = SET_TEXT(CLOD_SIMD_SUFFIX),
    .multiply_add = multiply_add,
    .divide = divide,
    .root = root,
    .operations = CHAINS * CLOD_WIDTH,
    .update = update,
};
