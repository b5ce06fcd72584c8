#include "parallel/exact.h"

#include <math.h>
#include <string.h>

#define CHUNK_BITS 32
#define CHUNK_MASK 0xffffffffLL
#define LOWEST (-1075) ///< exponent of the lowest bit
/** An addition puts less than 2^52 into a chunk: so many fit into its 63 bits. */
#define MOST_PENDING 2000

__extension__ typedef unsigned __int128 wide;

/** Carries go up; all chunks but the last are then at least 0 and below 2^32. */
static void propagate(clod_exact *self)
{
    for (int k = 0; k + 1 < CLOD_EXACT_CHUNKS; k++) {
        const int64_t low = self->chunk[k] & CHUNK_MASK;
        self->chunk[k + 1] += (self->chunk[k] - low) / (CHUNK_MASK + 1);
        self->chunk[k] = low;
    }
    self->pending = 0;
}

/** Infinity or NaN. */
static void note_special(clod_exact *self, double number)
{
    self->nan = self->nan || isnan(number);
    self->plus_infinity = self->plus_infinity || (!isnan(number) && number > 0.0);
    self->minus_infinity = self->minus_infinity || (!isnan(number) && number < 0.0);
}

void clod_exact_add(clod_exact *self, double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    const int biased = (int)(bits >> 52 & 0x7ff);
    if (biased == 0x7ff) {
        note_special(self, number);
        return;
    }
    const uint64_t fraction = bits & 0xfffffffffffffULL;
    const uint64_t mantissa = biased == 0 ? fraction : fraction | 1ULL << 52;
    const int exponent = biased == 0 ? 1 : biased; // the number is mantissa 2^(exponent - 1075)
    const int k = exponent / CHUNK_BITS;
    const int shift = exponent % CHUNK_BITS;
    const int64_t low = (int64_t)(mantissa << shift & CHUNK_MASK);
    const int64_t high = (int64_t)(mantissa >> (CHUNK_BITS - shift));
    const int64_t sign = bits >> 63 ? -1 : 1;
    self->chunk[k] += sign * low;
    self->chunk[k + 1] += sign * high;
    if (++self->pending == MOST_PENDING) {
        propagate(self);
    }
}

void clod_exact_merge(clod_exact *self, const clod_exact *other)
{
    clod_exact more = *other;
    propagate(&more);
    propagate(self);
    for (int k = 0; k < CLOD_EXACT_CHUNKS; k++) {
        self->chunk[k] += more.chunk[k];
    }
    self->pending = 1;
    self->nan = self->nan || more.nan;
    self->plus_infinity = self->plus_infinity || more.plus_infinity;
    self->minus_infinity = self->minus_infinity || more.minus_infinity;
}

void clod_exact_settle(clod_exact *self)
{
    propagate(self);
}

static int64_t chunk_at(const clod_exact *self, int k)
{
    return k < 0 ? 0 : self->chunk[k];
}

/** The magnitude of a sum that is above zero and propagated, rounded. */
static double round_sum(const clod_exact *self)
{
    int top = CLOD_EXACT_CHUNKS - 1;
    while (self->chunk[top] == 0) {
        top--;
    }
    if (top == CLOD_EXACT_CHUNKS - 1) {
        return HUGE_VAL;
    }
    // the three highest chunks have at least 65 bits of the sum: more than are kept
    const wide bits = (wide)chunk_at(self, top) << 2 * CHUNK_BITS |
                      (wide)chunk_at(self, top - 1) << CHUNK_BITS |
                      (wide)chunk_at(self, top - 2);
    bool more = false; // below those
    for (int k = 0; k < top - 2; k++) {
        more = more || self->chunk[k] != 0;
    }
    const int base = CHUNK_BITS * (top - 2) + LOWEST;
    int drop = 12; // bits that are not kept: of 65 at least 12
    while (bits >> drop >> 53 != 0) {
        drop++;
    }
    const int least = -1074 - base; // the last bit of the smallest numbers
    drop = drop > least ? drop : least;
    uint64_t kept = (uint64_t)(bits >> drop);
    const wide half = (wide)1 << (drop - 1);
    const wide rest = bits & (2 * half - 1);
    if (rest > half || (rest == half && (more || kept % 2 == 1))) {
        kept++;
    }
    return ldexp((double)kept, base + drop);
}

double clod_exact_value(const clod_exact *self)
{
    if (self->nan || (self->plus_infinity && self->minus_infinity)) {
        return (double)NAN;
    }
    if (self->plus_infinity || self->minus_infinity) {
        return self->plus_infinity ? HUGE_VAL : -HUGE_VAL;
    }
    clod_exact sum = *self;
    propagate(&sum);
    const bool negative = sum.chunk[CLOD_EXACT_CHUNKS - 1] < 0;
    bool zero = true;
    for (int k = 0; k < CLOD_EXACT_CHUNKS; k++) {
        zero = zero && sum.chunk[k] == 0;
        sum.chunk[k] = negative ? -sum.chunk[k] : sum.chunk[k];
    }
    if (zero) {
        return 0.0;
    }
    propagate(&sum);
    return negative ? -round_sum(&sum) : round_sum(&sum);
}
