// Stage near: when motion has used a skin up, make the near list anew, or rebuild everything.
#include <math.h>

#include "step/step.h"

/** Thin skin: at least this fraction of the smallest radius ... */
#define NEAR_FRACTION 0.01
/** ... and enough for about this many steps at the speed of now. */
#define NEAR_STEPS 40.0

/** Histories into the state. */
static bool take_out(clod_step *self)
{
    self->exported =
        clod_near_export(&self->near, &self->neighbour, self->state, self->laws, &self->status);
    return self->exported;
}

/** And into blocks again, those of a list with this skin. */
static bool put_back(clod_step *self, double skin)
{
    self->exported = !clod_near_make(&self->near, &self->neighbour, self->state, self->laws,
                                     &self->walls, skin, &self->status);
    return !self->exported;
}

static void refresh(clod_step *self, double speed)
{
    const double lasting = 2.0 * NEAR_STEPS * speed * self->state->dt;
    const double thin = NEAR_FRACTION * self->neighbour.radius_min;
    const double skin = fmin(fmax(thin, lasting), self->neighbour.skin);
    self->failed = !take_out(self) || !put_back(self, skin);
    self->refreshes++;
}

static void rebuild(clod_step *self)
{
    self->failed =
        !take_out(self) || !clod_neighbour_sort(&self->neighbour, self->state, &self->status) ||
        !clod_neighbour_build(&self->neighbour, self->state, self->laws, &self->status) ||
        !put_back(self, NEAR_FRACTION * self->neighbour.radius_min);
    self->rebuilds++;
}

/** Every thread takes the same decision from the same numbers; thread 0 does the work. */
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
    if (!finite || !(again || thin)) { // positions that are not finite cannot be sorted
        return;
    }
    clod_barrier_wait(&self->barrier);
    if (part == 0) {
        if (again) {
            rebuild(self);
        } else {
            refresh(self, speed);
        }
        self->view.wall_slots = self->near.wall_slots;
        self->view.lead = self->neighbour.lead;
    }
    clod_barrier_wait(&self->barrier);
    mine->near_motion = 0.0;
    mine->build_motion = again ? 0.0 : mine->build_motion;
}
