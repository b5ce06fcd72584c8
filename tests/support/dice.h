#pragma once
/**
 * @file dice.h
 * Random numbers for tests: SplitMix64 (Steele, Lea, Flood 2014), nothing of clod's own.
 */

#include <math.h>
#include <stdint.h>

typedef struct dice {
    uint64_t state;
} dice;

static inline uint64_t dice_bits(dice *self)
{
    uint64_t z = (self->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** Uniform between low and high. */
static inline double dice_real(dice *self, double low, double high)
{
    return low + (high - low) * ((double)(dice_bits(self) >> 11) * 0x1p-53);
}

/** 0 .. count - 1 */
static inline int dice_pick(dice *self, int count)
{
    return (int)(dice_bits(self) % (uint64_t)count);
}

/** A random direction. */
static inline void dice_direction(dice *self, double to[3])
{
    const double z = dice_real(self, -1.0, 1.0);
    const double turn = dice_real(self, -M_PI, M_PI);
    const double flat = sqrt(1.0 - z * z);
    to[0] = flat * cos(turn);
    to[1] = flat * sin(turn);
    to[2] = z;
}
