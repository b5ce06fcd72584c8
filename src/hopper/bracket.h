#pragma once
/**
 * @file bracket.h
 * Rounds to a stress within bounds that close in, for design.c and critical.c: each round says on which
 * side of it the stress lies and where it would go next, and bounds keep it from going in circles.
 */

#include <math.h>
#include <stdbool.h>

#define CLOD_BRACKET_LOWEST 1e-9 ///< Pa: bounds that no state has
#define CLOD_BRACKET_HIGHEST 1e12

/** Where to look next, and within which bounds: the stress lies between low and high. */
typedef struct clod_bracket {
    double sigma_1, low, high; ///< Pa
    bool halved; ///< sigma_1 is from the bounds, not where the last round would go
} clod_bracket;

static inline clod_bracket clod_bracket_from(double first)
{
    return (clod_bracket){first, CLOD_BRACKET_LOWEST, CLOD_BRACKET_HIGHEST, false};
}

/** The stress is larger than the one looked at, or else smaller. */
static inline void clod_bracket_narrow(clod_bracket *self, bool larger)
{
    *(larger ? &self->low : &self->high) = self->sigma_1;
}

static inline void clod_bracket_halve(clod_bracket *self)
{
    self->sigma_1 = sqrt(self->low * self->high);
    self->halved = true;
}

/** Go on to a stress, or between the bounds where it is beyond them; the one looked at may stay. */
static inline void clod_bracket_go(clod_bracket *self, double next)
{
    self->halved = !(next > self->low && next < self->high) && next != self->sigma_1;
    if (self->halved) {
        clod_bracket_halve(self);
    } else {
        self->sigma_1 = next;
    }
}
