#include "base/random.h"

#include <Random123/philox.h>
#include <math.h>

double clod_random_uniform(uint64_t seed, clod_random_purpose purpose, uint64_t item,
                           uint64_t draw)
{
    const philox4x64_key_t key = {{seed, (uint64_t)purpose}};
    const philox4x64_ctr_t counter = {{item, draw, 0, 0}};
    const philox4x64_ctr_t bits = philox4x64(counter, key);
    return (double)(bits.v[0] >> 12) * 0x1p-52 + 0x1p-53; // exact, so never 0 and never 1
}

double clod_random_normal(uint64_t seed, clod_random_purpose purpose, uint64_t item,
                          uint64_t draw)
{
    const double u = clod_random_uniform(seed, purpose, item, draw);
    const double v = clod_random_uniform(seed, purpose, item, draw + 1);
    return sqrt(-2.0 * log(u)) * cos(2.0 * M_PI * v);
}
