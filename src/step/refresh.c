// Stage near: when motion has used a skin up, make the near list anew, or rebuild everything.
#include <math.h>

#include "state/alter.h"
#include "step/change.h"

/**
 * What a near list costs, over what the pairs within a skin of one smallest radius cost in a
 * step (docs/adr/0020).
 */
#define NEAR_COST 3.0
/** The thinnest skin, as a fraction of the smallest radius: next to no pairs. */
#define NEAR_LEAST 1e-3

double clod_step_thin_skin(const clod_step *self, double speed)
{
    const double radius = self->neighbour.radius_min;
    const double closing = 2.0 * speed * self->state->dt;
    const double skin = fmax(NEAR_LEAST * radius, sqrt(NEAR_COST * closing * radius));
    return fmin(skin, self->neighbour.skin);
}

/** Histories into the state; the near list is no more. */
static bool take_out(clod_step *self)
{
    return clod_near_gather(&self->near, self->state, &self->walls, true, &self->status);
}

/** And into the blocks of a list with this skin. */
static bool put_back(clod_step *self, double skin)
{
    if (!clod_near_make(&self->near, &self->neighbour, self->state, self->laws, &self->walls,
                        skin, &self->status)) {
        return false;
    }
    clod_step_list_feeling(self);
    return true;
}

static void refresh(clod_step *self, double speed)
{
    self->failed = !take_out(self) || !put_back(self, clod_step_thin_skin(self, speed));
    self->refreshes++;
}

/** Grains that have left through an open side go, with what they carried. */
static void let_go(clod_step *self, size_t leavers)
{
    if (leavers > 0) {
        clod_state_drop_grains(self->state, self->neighbour.rank);
        clod_neighbour_size(&self->neighbour, self->state);
    }
}

static void rebuild(clod_step *self, double speed)
{
    const size_t leavers = clod_change_find_leavers(self);
    const double before = leavers > 0 ? clod_change_balance(self) : 0.0;
    self->failed = !take_out(self);
    if (!self->failed) {
        let_go(self, leavers);
        self->failed =
            !clod_neighbour_sort(&self->neighbour, self->state, &self->status) ||
            !clod_neighbour_build(&self->neighbour, self->state, self->laws, &self->status) ||
            !put_back(self, clod_step_thin_skin(self, speed));
    }
    if (leavers > 0 && !self->failed) {
        self->state->ledger.exchanged += clod_change_balance(self) - before;
    }
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
            rebuild(self, speed);
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
