#pragma once
/**
 * @file random_state.h
 * A state whose every number is different, and its comparison field by field.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/random.h"
#include "state/state.h"
#include "state/wear.h"

#define RANDOM_STATE_GRAINS 37
#define RANDOM_STATE_WALLS 3
#define RANDOM_STATE_CONTACTS 50

typedef struct random_source {
    uint64_t seed, draw;
} random_source;

static inline double random_real(random_source *source)
{
    return clod_random_uniform(source->seed, CLOD_RANDOM_TEST, 0, source->draw++) * 20.0 - 10.0;
}

static inline int random_int(random_source *source)
{
    return (int)(random_real(source) * 1e6);
}

static inline void random_reals(random_source *source, void *to, size_t count)
{
    double *values = to;
    for (size_t v = 0; v < count; v++) {
        values[v] = random_real(source);
    }
}

/** Everything of a shape; kinds and sides are numbers that there are. */
static inline void random_shape(random_source *source, clod_shape *shape)
{
    shape->kind = (clod_shape_kind)(abs(random_int(source)) % CLOD_SHAPE_KINDS);
    shape->side = (clod_side)(abs(random_int(source)) % 2);
    shape->material = random_int(source);
    random_reals(source, &shape->center, 3);
    random_reals(source, shape->axis, 9);
    random_reals(source, &shape->inner, 1);
    random_reals(source, &shape->outer, 1);
    random_reals(source, shape->half, 3);
    random_reals(source, &shape->belt.velocity, 3);
    random_reals(source, &shape->belt.direction, 3);
    random_reals(source, &shape->belt.speed, 1);
    random_reals(source, &shape->belt.spin, 1);
    random_reals(source, &shape->belt.spin_axis, 3);
    random_reals(source, &shape->belt.spin_point, 3);
    random_reals(source, &shape->archard, 1);
    random_reals(source, &shape->finnie, 1);
}

/** Everything of a wall but its name. */
static inline void random_wall(random_source *source, clod_wall *wall)
{
    wall->material = (uint16_t)random_int(source);
    random_reals(source, &wall->velocity, 3);
    random_reals(source, &wall->surface_velocity, 3);
    random_reals(source, &wall->spin, 1);
    random_reals(source, &wall->spin_axis, 3);
    random_reals(source, &wall->spin_point, 3);
    random_reals(source, &wall->shift, 3);
    random_reals(source, &wall->angle, 1);
    random_reals(source, &wall->orientation, 4);
    random_reals(source, &wall->travel, 3);
    random_reals(source, &wall->turned, 1);
    wall->load = (clod_load_kind)(random_int(source) & 1) + CLOD_LOAD_FORCE;
    random_reals(source, &wall->load_axis, 3);
    random_reals(source, &wall->load_force, 1);
    random_reals(source, &wall->area, 1);
    random_reals(source, &wall->mass, 1);
    random_reals(source, &wall->damping, 1);
    random_reals(source, &wall->servo_velocity, 1);
    random_reals(source, &wall->force, 3);
    random_reals(source, &wall->torque, 3);
    random_reals(source, &wall->power, 1);
    random_reals(source, &wall->belt_power, 1);
    wall->sum_steps = random_int(source);
    random_reals(source, &wall->sum_force, 3);
    random_reals(source, &wall->sum_torque, 3);
    random_reals(source, &wall->sum_power, 1);
    random_reals(source, &wall->oscillation, sizeof wall->oscillation / sizeof(double));
    random_reals(source, &wall->sway_velocity, 3);
    random_reals(source, &wall->sway_spin, 1);
    for (int32_t s = 0; s < wall->shape_count; s++) {
        random_shape(source, &wall->shapes[s]);
    }
    random_reals(source, &wall->wear_since, 1);
    random_reals(source, &wall->wear_row, 1);
    if (wall->wear != NULL) {
        random_reals(source, wall->wear, (size_t)(wall->wear_rows * CLOD_WEAR_SUMS));
    }
    clod_wall_find_symmetry(wall);
}

static inline void random_grain(random_source *source, clod_grains *grains, size_t g)
{
    random_reals(source, grains->position[g], 4);
    random_reals(source, grains->velocity[g], 4);
    random_reals(source, grains->angular_velocity[g], 4);
    random_reals(source, grains->load[g], 3);
    random_reals(source, grains->load[g] + 4, 3);
    grains->id[g] = (uint64_t)1 << 60 | (uint64_t)random_int(source);
    grains->material[g] = (uint16_t)random_int(source);
}

/** Walls with names and room for shapes, nothing else. */
static inline void random_state_walls(clod_state *state)
{
    state->walls.count = RANDOM_STATE_WALLS;
    state->walls.wall = clod_memory_alloc(RANDOM_STATE_WALLS, sizeof(clod_wall));
    for (int w = 0; w < RANDOM_STATE_WALLS; w++) {
        clod_wall *wall = &state->walls.wall[w];
        snprintf(wall->name, sizeof wall->name, "wall number %d", w);
        wall->shape_count = w + 1;
        wall->shapes = clod_memory_alloc((size_t)w + 1, sizeof(clod_shape));
        if (w % 2 == 0) { // the others have none
            wall->wear_places = clod_wear_number(wall);
            wall->wear_rows = clod_wear_rows(wall, wall->wear_places);
            wall->wear = clod_memory_alloc((size_t)wall->wear_rows, sizeof *wall->wear);
        }
    }
}

/** A full state; the same for the same seed. */
static inline clod_state random_state(uint64_t seed)
{
    clod_status status;
    random_source source = {seed, 0};
    clod_state state = {0};
    random_state_walls(&state);
    assert_true(clod_grains_reserve(&state.grains, RANDOM_STATE_GRAINS, &status));
    state.grains.count = RANDOM_STATE_GRAINS;
    state.build_position =
        clod_memory_alloc(state.grains.capacity, sizeof *state.build_position);
    for (size_t g = 0; g < state.grains.count; g++) {
        random_grain(&source, &state.grains, g);
        random_reals(&source, state.build_position[g], 4);
    }
    clod_grains_pad(&state.grains);
    for (int w = 0; w < RANDOM_STATE_WALLS; w++) {
        random_wall(&source, &state.walls.wall[w]);
    }
    state.build_walls = clod_memory_alloc(RANDOM_STATE_WALLS, sizeof *state.build_walls);
    random_reals(&source, state.build_walls,
                 (size_t)CLOD_WALL_POSE_NUMBERS * RANDOM_STATE_WALLS);
    random_reals(&source, state.domain.min, 3);
    random_reals(&source, state.domain.max, 3);
    state.domain.periodic[1] = true;
    state.domain.removes = true;
    state.domain.outlets = CLOD_OUTLETS;
    random_reals(&source, state.domain.outlet, (size_t)CLOD_OUTLETS * CLOD_OUTLET_NUMBERS);
    random_reals(&source, state.grains.birth, state.grains.count);
    clod_status lacking;
    assert_true(clod_grains_keep_clumps(&state.grains, &lacking));
    for (size_t g = 0; g < state.grains.count; g++) {
        state.grains.clump[g].since = random_real(&source);
        state.grains.clump[g].seen = random_int(&source);
    }
    for (int k = 0; k <= CLOD_CLUMP_CLASSES; k++) {
        state.exchange.left_clumps[k] = random_int(&source);
    }
    state.exchange.residence_since = random_real(&source);
    state.exchange.residence_least = random_real(&source);
    state.exchange.residence_most = random_real(&source);
    state.exchange.residence = random_real(&source);
    state.exchange.residence_squared = random_real(&source);
    for (int b = 0; b < CLOD_TIME_CLASSES; b++) {
        state.exchange.residence_count[b] = random_int(&source);
    }
    for (int f = 0; f < CLOD_EXITS; f++) {
        state.exchange.left[f] = random_int(&source);
    }
    random_reals(&source, state.exchange.left_mass, CLOD_EXITS);
    random_reals(&source, state.exchange.left_energy, CLOD_EXITS);
    state.exchange.added = random_int(&source);
    state.exchange.removed = random_int(&source);
    state.exchange.added_mass = random_real(&source);
    state.exchange.removed_mass = random_real(&source);
    state.ledger.exchanged = random_real(&source);
    random_reals(&source, state.gravity, 3);
    state.dt = random_real(&source);
    state.time = random_real(&source);
    state.step = (int64_t)1 << 40 | random_int(&source);
    state.adhesion = random_real(&source);
    state.build_motion = random_real(&source);
    state.build_skin = random_real(&source);
    state.contact_count = state.contact_capacity = RANDOM_STATE_CONTACTS;
    state.wall_contact_count = 11;
    state.contacts = clod_memory_alloc(RANDOM_STATE_CONTACTS, sizeof(clod_contact));
    for (size_t c = 0; c < state.contact_count; c++) {
        clod_contact *contact = &state.contacts[c];
        const bool pair = c + state.wall_contact_count < state.contact_count;
        contact->i = abs(random_int(&source)) % (RANDOM_STATE_GRAINS - 1);
        const int later = RANDOM_STATE_GRAINS - 1 - contact->i; // rows behind i
        contact->j = pair ? contact->i + 1 + abs(random_int(&source)) % later
                          : abs(random_int(&source)) % RANDOM_STATE_WALLS;
        contact->shape =
            pair ? -1 : abs(random_int(&source)) % state.walls.wall[contact->j].shape_count;
        random_reals(&source, contact->history, 8);
    }
    // values that only an exact copy keeps
    state.grains.velocity[0][0] = -0.0;
    state.grains.velocity[1][0] = 4.9406564584124654e-324; // smallest number above zero
    state.grains.load[0][0] = -HUGE_VAL;
    return state;
}

/** Compare two shapes bit for bit but for their padding. */
static inline void assert_shapes_equal(const clod_shape *x, const clod_shape *y)
{
    assert_int_equal(x->kind, y->kind);
    assert_int_equal(x->material, y->material);
    assert_int_equal(x->symmetric, y->symmetric);
    assert_int_equal(x->side, y->side);
    assert_memory_equal(&x->belt, &y->belt, sizeof x->belt);
    assert_memory_equal(&x->archard, &y->archard, sizeof x->archard);
    assert_memory_equal(&x->finnie, &y->finnie, sizeof x->finnie);
    const size_t numbers = offsetof(clod_shape, center);
    assert_memory_equal((const char *)x + numbers, (const char *)y + numbers,
                        offsetof(clod_shape, side) - numbers);
}

/** Compare bit for bit; clod_contact and clod_wall are compared without their padding. */
static inline void assert_states_equal(const clod_state *a, const clod_state *b)
{
    const size_t n = a->grains.count;
    assert_int_equal(n, b->grains.count);
    assert_memory_equal(a->grains.position, b->grains.position, n * sizeof *a->grains.position);
    assert_memory_equal(a->grains.velocity, b->grains.velocity, n * sizeof *a->grains.velocity);
    assert_memory_equal(a->grains.angular_velocity, b->grains.angular_velocity,
                        n * sizeof *a->grains.angular_velocity);
    assert_memory_equal(a->grains.load, b->grains.load, n * sizeof *a->grains.load);
    assert_memory_equal(a->grains.id, b->grains.id, n * sizeof *a->grains.id);
    assert_memory_equal(a->grains.material, b->grains.material, n * sizeof(uint16_t));
    assert_memory_equal(a->grains.birth, b->grains.birth, n * sizeof *a->grains.birth);
    for (size_t g = 0; g < n; g++) {
        assert_memory_equal(&a->grains.clump[g].since, &b->grains.clump[g].since,
                            sizeof(double));
        assert_int_equal(a->grains.clump[g].seen, b->grains.clump[g].seen);
    }
    assert_memory_equal(a->build_position, b->build_position, n * sizeof *a->build_position);
    assert_memory_equal(a->build_walls, b->build_walls,
                        RANDOM_STATE_WALLS * sizeof *a->build_walls);
    assert_memory_equal(&a->exchange, &b->exchange, sizeof a->exchange);
    assert_memory_equal(&a->ledger, &b->ledger, sizeof a->ledger);
    assert_int_equal(a->domain.removes, b->domain.removes);
    assert_int_equal(a->domain.outlets, b->domain.outlets);
    assert_memory_equal(a->domain.outlet, b->domain.outlet, sizeof a->domain.outlet);
    assert_int_equal(a->walls.count, b->walls.count);
    for (int w = 0; w < a->walls.count; w++) {
        const clod_wall *x = &a->walls.wall[w];
        const clod_wall *y = &b->walls.wall[w];
        assert_string_equal(x->name, y->name);
        assert_int_equal(x->material, y->material);
        assert_int_equal(x->shape_count, y->shape_count);
        assert_int_equal(x->load, y->load);
        const size_t motion = offsetof(clod_wall, velocity);
        assert_memory_equal((const char *)x + motion, (const char *)y + motion,
                            offsetof(clod_wall, load) - motion);
        const size_t load = offsetof(clod_wall, load_axis);
        assert_memory_equal((const char *)x + load, (const char *)y + load,
                            offsetof(clod_wall, wear) - load);
        assert_int_equal(x->wear == NULL, y->wear == NULL);
        if (x->wear != NULL) {
            assert_memory_equal(x->wear, y->wear, (size_t)x->wear_rows * sizeof *x->wear);
        }
        for (int32_t s = 0; s < x->shape_count; s++) {
            assert_shapes_equal(&x->shapes[s], &y->shapes[s]);
        }
    }
    assert_memory_equal(&a->domain, &b->domain, offsetof(clod_domain, periodic) + 3);
    assert_memory_equal(a->gravity, b->gravity, sizeof a->gravity);
    const size_t scalars = offsetof(clod_state, dt);
    assert_memory_equal((const char *)a + scalars, (const char *)b + scalars,
                        offsetof(clod_state, build_position) - scalars);
    assert_memory_equal(&a->build_motion, &b->build_motion, sizeof a->build_motion);
    assert_memory_equal(&a->build_skin, &b->build_skin, sizeof a->build_skin);
    assert_int_equal(a->contact_count, b->contact_count);
    assert_int_equal(a->wall_contact_count, b->wall_contact_count);
    for (size_t c = 0; c < a->contact_count; c++) {
        const clod_contact *x = &a->contacts[c];
        const clod_contact *y = &b->contacts[c];
        assert_int_equal(x->i, y->i);
        assert_int_equal(x->j, y->j);
        assert_int_equal(x->shape, y->shape);
        assert_memory_equal(x->history, y->history, sizeof x->history);
    }
}

/** A state with walls of its own, which reading replaces. */
static inline clod_state bare_state(void)
{
    clod_state state = {0};
    random_state_walls(&state);
    return state;
}
