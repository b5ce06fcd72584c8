// Stage near: whether motion has used a skin up, so that a list must be made anew.
#include <math.h>

#include "step/remake.h"
#include "step/spread.h"

/** What a near list costs for each grain, over what a pair costs in a step (docs/adr/0020). */
#define LIST_COST 47.0
/** What a contact with a wall costs in a step over one of grains. */
#define WALL_COST 4.0
/** The thinnest skin, as a fraction of the smallest radius: next to no pairs. */
#define NEAR_LEAST 1e-3

double clod_step_thin_skin(const clod_step *self, double speed)
{
    const clod_neighbour *wide = &self->neighbour;
    const double closing = 2.0 * speed * self->state->dt;
    const double pairs = (double)wide->pairs.count + WALL_COST * (double)wide->walls.count;
    const double grains = (double)self->state->grains.count;
    // pairs within a skin are taken to grow with it
    const double best = sqrt(LIST_COST * grains * closing * wide->skin / fmax(pairs, 1.0));
    return fmin(fmax(NEAR_LEAST * wide->radius_min, best), wide->skin);
}

/** Every thread takes the same decision from the same numbers; all make the lists. */
void clod_step_near(clod_step *self, int part)
{
    clod_step_thread *mine = &self->thread[part];
    double speed2 = 0.0;
    bool finite = true;
    for (int t = 0; t < self->threads; t++) {
        speed2 = fmax(speed2, self->thread[t].max_speed2);
        finite &= self->thread[t].finite;
    }
    mine->all_finite = finite;
    const double speed = sqrt(speed2);
    mine->build_motion += speed * self->state->dt;
    mine->near_motion += speed * self->state->dt;
    const bool again = 2.0 * mine->build_motion > self->neighbour.skin;
    const bool thin = 2.0 * mine->near_motion > self->near.skin;
    const size_t grains =
        self->spread == NULL ? self->state->grains.count : self->spread->bed.count;
    const bool empty = grains == 0; // the next change makes lists
    if (!finite || empty || !(again || thin)) { // what is not finite cannot be sorted
        return;
    }
    if (part == 0) {
        clod_remake_begin(self, again, speed);
    }
    clod_barrier_wait(&self->barrier);
    clod_remake_lists(self, part);
    mine->near_motion = 0.0;
    mine->build_motion = again ? 0.0 : mine->build_motion;
}
