#pragma once
/**
 * @file cell_state.h
 * The fabricated state of a tester's cell: what its procedure asks of grains and walls, and no more.
 */

#include "state/state.h"

#define CELL_GRAINS 4

/** What grains of a cell are stored in; columns are position, radius and velocity, mass. */
typedef struct cell_grains {
    double place[CELL_GRAINS][4], motion[CELL_GRAINS][4];
} cell_grains;

/**
 * Walls, and four grains of 3 mm of which one is the highest.
 *
 * @param highest  height of its centre [m]
 * @param mass     of all grains [kg]
 */
static inline void cell_state_make(clod_state *self, cell_grains *grains, double highest,
                                   double mass, clod_wall *walls, int32_t count, double dt)
{
    self->walls.wall = walls;
    self->walls.count = count;
    self->grains.position = grains->place;
    self->grains.velocity = grains->motion;
    self->grains.count = CELL_GRAINS;
    for (int g = 0; g < CELL_GRAINS; g++) {
        grains->place[g][2] = g < CELL_GRAINS - 1 ? 0.01 : highest;
        grains->place[g][3] = 0.003;
        grains->motion[g][3] = mass / CELL_GRAINS;
    }
    self->gravity[2] = -9.81;
    self->dt = dt;
    self->adhesion = 0.1;
}
