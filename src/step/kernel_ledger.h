#pragma once
/**
 * @file kernel_ledger.h
 * The contact loops with the energy ledger: the same forces, and what each contact turned into
 * heat; and what the contacts store. Included by kernel.c only.
 */

#include "law/law_energy.h"
#include "step/kernel_wall.h"

/** Velocities of grains one step ago: before the kick by the forces of then. */
typedef struct kernel_earlier {
    vreal3 velocity, spin;
} kernel_earlier;

static inline kernel_earlier kernel_earlier_of(const clod_kernel_view *view, const int32_t *i)
{
    int32_t force[CLOD_WIDTH], torque[CLOD_WIDTH];
    vreal v[4], w[4], f[4], t[4];
    for (int l = 0; l < CLOD_WIDTH; l++) { // a load row is two rows of four
        force[l] = 2 * i[l];
        torque[l] = 2 * i[l] + 1;
    }
    vreal_load_rows(v, view->velocity, i);
    vreal_load_rows(w, view->angular_velocity, i);
    vreal_load_rows(f, (const double(*)[4])view->before, force);
    vreal_load_rows(t, (const double(*)[4])view->before, torque);
    const vreal push = view->dt / v[3];
    const vreal twist = view->dt * w[3];
    return (kernel_earlier){{v[0] - push * f[0], v[1] - push * f[1], v[2] - push * f[2]},
                            {w[0] - twist * t[0], w[1] - twist * t[1], w[2] - twist * t[2]}};
}

/** A grain-grain contact one step ago: the overlap of then in the directions of today. */
static inline clod_law_motion kernel_contact_before(const clod_law_motion *now, double dt)
{
    clod_law_motion before = *now;
    const vreal distance = now->arm_i + now->arm_j;
    const vreal3 apart = vreal3_scale(now->normal, distance);
    const vreal3 then = vreal3_axpy(apart, vreal_set(-dt), now->velocity);
    before.overlap = now->overlap + distance - vreal_sqrt(vreal3_dot(then, then));
    return before;
}

/** A wall contact one step ago; the wall is flat enough for one step. */
static inline clod_law_motion kernel_wall_before(const clod_law_motion *now, double dt)
{
    clod_law_motion before = *now;
    before.overlap = now->overlap + dt * vreal3_dot(now->velocity, now->normal);
    return before;
}

static inline void kernel_store_dissipated(clod_dissipation_block *dissipated, int lane,
                                           clod_law_dissipation s)
{
    vreal_store(&dissipated->plastic[lane], s.plastic);
    vreal_store(&dissipated->dash_pot[lane], s.dash_pot);
    vreal_store(&dissipated->friction[lane], s.friction);
    vreal_store(&dissipated->rolling[lane], s.rolling);
    vreal_store(&dissipated->lag[lane], s.lag);
}

/** What contacts dissipate between two states of motion, before their history moves on. */
static inline void kernel_dissipate(const clod_law *law, const clod_law_motion *before,
                                    const clod_law_motion *now, double dt,
                                    clod_history *history, clod_dissipation_block *dissipated,
                                    int lane)
{
    const clod_law_memory memory = clod_law_memory_load(history, lane);
    clod_law_memory after = memory;
    const clod_law_result result = clod_law_contact(law, now, dt, &after);
    kernel_store_dissipated(dissipated, lane,
                            clod_law_dissipate(law, now, &result, &after, before, &memory, dt));
}

/** What a block of grain-grain contacts dissipates in this step. */
static void kernel_contact_dissipate(const clod_kernel_view *view, const clod_law *law,
                                     clod_contact_block *block,
                                     clod_dissipation_block *dissipated)
{
    for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
        const int32_t *i = &block->i[lane];
        const int32_t *j = &block->j[lane];
        const clod_law_motion now = kernel_contact_motion(view, law, i, j);
        const kernel_earlier a = kernel_earlier_of(view, i);
        const kernel_earlier b = kernel_earlier_of(view, j);
        clod_law_motion before = kernel_contact_before(&now, view->dt);
        before.velocity = vreal3_sub(a.velocity, b.velocity);
        before.spin_i = a.spin;
        before.spin_j = b.spin;
        kernel_dissipate(law, &before, &now, view->dt, &block->history, dissipated, lane);
    }
}

/** The same for a block of wall contacts; a wall keeps its velocity over the step. */
static void kernel_wall_dissipate(const clod_kernel_view *view, const clod_law *law,
                                  clod_wall_form form, clod_wall_block *block,
                                  clod_dissipation_block *dissipated)
{
    for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
        const int32_t *i = &block->i[lane];
        const kernel_wall_meeting meeting = kernel_wall_meet(view, form, block, lane);
        const clod_law_motion now = meeting.motion;
        const kernel_earlier a = kernel_earlier_of(view, i);
        clod_law_motion before = kernel_wall_before(&now, view->dt);
        before.velocity = vreal3_sub(a.velocity, meeting.velocity);
        before.spin_i = a.spin;
        kernel_dissipate(law, &before, &now, view->dt, &block->history, dissipated, lane);
    }
}

static inline void kernel_store_stored(clod_stored_block *to, int lane, clod_law_stored s)
{
    vreal_store(&to->normal[lane], s.normal);
    vreal_store(&to->sliding[lane], s.sliding);
    vreal_store(&to->rolling[lane], s.rolling);
}

static void kernel_contact_stored(const clod_kernel_view *view, const clod_law *law,
                                  clod_contact_block *block, clod_stored_block *stored)
{
    for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
        const clod_law_motion now =
            kernel_contact_motion(view, law, &block->i[lane], &block->j[lane]);
        const clod_law_memory memory = clod_law_memory_load(&block->history, lane);
        kernel_store_stored(stored, lane,
                            clod_law_stored_energy(law, now.overlap, now.r_star, &memory));
    }
}

static void kernel_wall_stored(const clod_kernel_view *view, const clod_law *law,
                               clod_wall_form form, clod_wall_block *block,
                               clod_stored_block *stored)
{
    for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
        const clod_law_motion now = kernel_wall_meet(view, form, block, lane).motion;
        const clod_law_memory memory = clod_law_memory_load(&block->history, lane);
        kernel_store_stored(stored, lane,
                            clod_law_stored_energy(law, now.overlap, now.r_star, &memory));
    }
}
