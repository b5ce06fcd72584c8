#include "tester/inside.h"

#include <math.h>

#include "parallel/exact.h"

#define POINTS 10 ///< across a grain: 552 in it

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

static bool holds(const clod_inside *room, double x, double y, double z)
{
    const double from_axis = x - (z > room->plane ? room->shift : 0.0);
    const double r2 = from_axis * from_axis + y * y;
    return z > room->low && z < room->high && r2 > room->inner * room->inner &&
           r2 < room->outer * room->outer;
}

/** Place of a line of points across a grain, in radii. */
static double point_at(int k)
{
    return (2.0 * k + 1.0) / POINTS - 1.0;
}

/**
 * Share of a grain in the room, by a lattice of points in it. Whole grains by their centres would do for a wide
 * bed; in one of a few grains they lie in layers, and a room begins before a layer or behind it.
 */
static double share(const clod_inside *room, const double *grain)
{
    int in = 0;
    int all = 0;
    for (int k = 0; k < POINTS * POINTS * POINTS; k++) {
        const double x = point_at(k % POINTS);
        const double y = point_at(k / POINTS % POINTS);
        const double z = point_at(k / POINTS / POINTS);
        if (x * x + y * y + z * z < 1.0) {
            const double r = grain[3];
            all++;
            in += holds(room, grain[0] + r * x, grain[1] + r * y, grain[2] + r * z) ? 1 : 0;
        }
    }
    return (double)in / (double)all;
}

double clod_inside_density(const clod_inside *bed, const clod_state *state)
{
    const double diameter = mean_diameter(state);
    const clod_inside room = away_from_walls(bed, CLOD_INSIDE_APART * diameter);
    const double across = room.inner > 0.0 ? room.outer - room.inner : 2.0 * room.outer;
    if (!(across >= diameter && room.high - room.low >= diameter)) {
        return (double)NAN;
    }
    clod_exact sum = {0};
    for (size_t g = 0; g < state->grains.count; g++) {
        clod_exact_add(&sum,
                       share(&room, state->grains.position[g]) * state->grains.velocity[g][3]);
    }
    const double mass = clod_exact_value(&sum);
    const double area = M_PI * (room.outer * room.outer - room.inner * room.inner);
    return mass > 0.0 ? mass / (area * (room.high - room.low)) : (double)NAN;
}
