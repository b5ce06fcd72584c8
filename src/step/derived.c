#include "step/derived.h"

#include <math.h>

#include "base/memory.h"
#include "step/spread.h"

double clod_step_fastest(const clod_state *state)
{
    double speed2 = 0.0, walls = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *v = state->grains.velocity[g];
        speed2 = fmax(speed2, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        walls = fmax(walls, clod_wall_speed_bound(&state->walls.wall[w]));
    }
    return fmax(sqrt(speed2), walls);
}

void clod_step_set_view(clod_step *self)
{
    const clod_grains *grains = &self->state->grains;
    self->view =
        (clod_kernel_view){.position = (const double(*)[4])grains->position,
                           .velocity = (const double(*)[4])grains->velocity,
                           .angular_velocity = (const double(*)[4])grains->angular_velocity,
                           .before = (const double(*)[8])grains->before,
                           .load = grains->load,
                           .wall_sum = self->near.wall_sum,
                           .shape = (const double(*)[4])self->walls.shape,
                           .touch = (const double(*)[4])self->near.touch.row,
                           .lead = self->neighbour.lead,
                           .dt = self->view.dt,
                           .overlap_limit = self->view.overlap_limit};
    for (int a = 0; a < 3; a++) {
        const clod_domain *domain = &self->state->domain;
        if (domain->periodic[a]) {
            self->view.period[a] = domain->max[a] - domain->min[a];
            self->view.inverse_period[a] = 1.0 / self->view.period[a];
        }
    }
}

bool clod_step_derive(clod_step *self, clod_status *status)
{
    clod_grains_pad(&self->state->grains);
    clod_neighbour_size(&self->neighbour, self->state);
    clod_wall_rows_fini(&self->neighbour.build_rows); // made at the next rebuild
    clod_wall_rows_fini(&self->walls);
    clod_memory_free(self->moving);
    clod_memory_free(self->summed);
    clod_memory_free(self->placed);
    clod_memory_free(self->is_near);
    const size_t walls = (size_t)self->state->walls.count;
    size_t shapes = 0;
    self->near.wear = false;
    for (size_t w = 0; w < walls; w++) {
        shapes += (size_t)self->state->walls.wall[w].shape_count;
        self->near.wear |= self->state->walls.wall[w].wear != NULL;
    }
    self->moving = clod_memory_alloc(walls + 1, sizeof *self->moving);
    self->summed = clod_memory_alloc(walls + 1, sizeof *self->summed);
    self->placed = clod_memory_alloc(shapes + 1, sizeof *self->placed);
    self->is_near = clod_memory_alloc(shapes + 1, sizeof *self->is_near);
    self->walls_finite = true;
    if (self->moving == NULL || self->summed == NULL || self->placed == NULL ||
        self->is_near == NULL || !clod_wall_rows_init(&self->walls, &self->state->walls) ||
        !clod_outlet_shapes_list(&self->outlets, &self->state->walls)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the shapes of %d walls",
                                (int)self->state->walls.count);
    }
    return clod_neighbour_periods_fit(&self->state->domain, self->neighbour.radius_max, status);
}

bool clod_step_build_lists(clod_step *self, bool sort, clod_status *status)
{
    clod_state *state = self->state;
    const double speed = clod_step_fastest(state);
    if (sort) {
        clod_neighbour_choose_skin(&self->neighbour, state, speed);
    } else {
        self->neighbour.skin = state->build_skin;
    }
    const bool sorted = sort ? clod_neighbour_sort(&self->neighbour, state, status)
                             : clod_neighbour_sort_as_built(&self->neighbour, state, status);
    if (!clod_spread_agree(self->spread, sorted, status) ||
        (self->spread != NULL && !clod_spread_sorted(self, status))) {
        return false;
    }
    const bool built = clod_neighbour_build(&self->neighbour, state, self->laws, status);
    if (!clod_spread_agree(self->spread, built, status)) {
        return false;
    }
    if (self->spread != NULL) {
        clod_spread_leave_out(self->spread, &self->neighbour, state->grains.count);
    }
    const clod_near_job job = {.near = &self->near,
                               .neighbour = &self->neighbour,
                               .state = state,
                               .laws = self->laws,
                               .walls = &self->walls,
                               .skins = clod_step_skins(self, speed),
                               .runs = self->spread != NULL ? self->spread->runs : 1};
    if (!clod_spread_agree(self->spread, clod_near_make(&job, status), status)) {
        return false;
    }
    clod_step_begin_motion(self);
    clod_step_list_moving(self);
    clod_step_list_summed(self);
    clod_step_set_view(self);
    return true;
}
