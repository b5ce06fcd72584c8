#include "tester/inside.h"

#include <math.h>

#include "parallel/exact.h"

static double mean_diameter(const clod_state *state)
{
    clod_exact sum = {0};
    for (size_t g = 0; g < state->grains.count; g++) {
        clod_exact_add(&sum, 2.0 * state->grains.position[g][3]);
    }
    return clod_exact_value(&sum) / (double)state->grains.count;
}

/** Bed without what is near its walls. */
static clod_inside away_from_walls(const clod_inside *bed, double gap)
{
    clod_inside room = *bed;
    room.inner += bed->inner > 0.0 ? gap : 0.0;
    room.outer -= gap;
    room.low += gap;
    room.high -= gap;
    return room;
}

static bool holds(const clod_inside *room, const double *position)
{
    const double x = position[0] - (position[2] > room->plane ? room->shift : 0.0);
    const double r2 = x * x + position[1] * position[1];
    return position[2] > room->low && position[2] < room->high &&
           r2 > room->inner * room->inner && r2 < room->outer * room->outer;
}

double clod_inside_density(const clod_inside *bed, const clod_state *state)
{
    const double diameter = mean_diameter(state);
    const clod_inside room = away_from_walls(bed, CLOD_INSIDE_APART * diameter);
    if (!(room.outer - room.inner >= diameter && room.high - room.low >= diameter)) {
        return (double)NAN;
    }
    clod_exact sum = {0};
    for (size_t g = 0; g < state->grains.count; g++) {
        const bool in = holds(&room, state->grains.position[g]);
        clod_exact_add(&sum, in ? state->grains.velocity[g][3] : 0.0);
    }
    const double mass = clod_exact_value(&sum);
    const double area = M_PI * (room.outer * room.outer - room.inner * room.inner);
    return mass > 0.0 ? mass / (area * (room.high - room.low)) : (double)NAN;
}
