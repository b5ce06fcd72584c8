#pragma once
/**
 * @file ring_states.h
 * Fabricated states of a ring shear test: what the walls feel is prescribed, look by look.
 */

#include <stdio.h>
#include <string.h>

#include "support/cell_state.h"
#include "support/check.h"
#include "tester/ring_shear.h"

// A cell with round numbers: 50 to 100 mm, so that
//   A = pi (0.1^2 - 0.05^2) = 0.0235619 m2,
//   r_m = (2/3)(0.1^3 - 0.05^3)/(0.1^2 - 0.05^2) = 0.0777778 m (docs/theory/ring-shear.md).
#define AREA 0.023561944901923448
#define MEAN_RADIUS 0.07777777777777778
#define DT 1e-5
#define LID_START 0.06
#define BAR_HEIGHT 0.006
#define PRESHEAR 10e3
#define SPEED 0.03
#define GRAIN_MASS 2.0

typedef struct cell {
    clod_case from;
    clod_state state;
    clod_wall wall[3];
    clod_shape shape[4];
    cell_grains grains;
    clod_ring_shear test;
    double row[CLOD_RING_SHEAR_COLUMNS];
} cell;

static cell now;

/** Four grains of 0.5 kg: three below the tips of the lid's bars, one above. */
static inline int make_cell(void **context)
{
    static const char *const NAMES[] = {"trough", "sides", "lid"};
    (void)context;
    memset(&now, 0, sizeof now);
    now.from.ring_shear = (clod_case_ring_shear){.present = true,
                                                 .inner_radius = 0.05,
                                                 .outer_radius = 0.1,
                                                 .bar_height = BAR_HEIGHT,
                                                 .lid_mass = 1.0,
                                                 .programme.preshear_stress = PRESHEAR,
                                                 .programme.speed = SPEED,
                                                 .programme.block_displacement = 1e-3,
                                                 .programme.steady_blocks = 3,
                                                 .programme.steady_tolerance = 0.02,
                                                 .programme.preshear_max = 20e-3,
                                                 .fill_max = 0.6,
                                                 .settle_max = 0.3,
                                                 .programme.shear_max = 5e-3,
                                                 .programme.beyond_peak = 1e-3,
                                                 .programme.peak_window = 0.2e-3};
    for (int w = 0; w < 3; w++) {
        snprintf(now.wall[w].name, sizeof now.wall[w].name, "%s", NAMES[w]);
        now.wall[w].shapes = &now.shape[w];
        now.wall[w].shape_count = 1;
    }
    now.wall[1].shape_count = 2;
    now.wall[2].shapes = &now.shape[3];
    now.shape[0] = (clod_shape){.kind = CLOD_SHAPE_BAR, .half = {0.02, 0.001, 0.003}};
    now.shape[1] = (clod_shape){.kind = CLOD_SHAPE_CYLINDER, .outer = 0.05};
    now.shape[2] = (clod_shape){.kind = CLOD_SHAPE_CYLINDER, .outer = 0.1};
    now.shape[3] = (clod_shape){.kind = CLOD_SHAPE_ANNULUS, .center = {0.0, 0.0, LID_START}};
    now.wall[2].load = CLOD_LOAD_STRESS;
    // the lid comes to 0.045 with tips at 0.039
    cell_state_make(&now.state, &now.grains, 0.036, GRAIN_MASS, now.wall, 3, DT);
    clod_ring_shear_begin(&now.test, &now.from, &now.state);
    return 0;
}

/** Advance by the planned steps under a stress at the lid and a shear stress, then look. */
static inline bool look(double lid_stress, double shear_stress)
{
    const int64_t steps = clod_ring_shear_plan(&now.test, &now.state);
    const double n = (double)steps;
    const double torque = shear_stress * AREA * MEAN_RADIUS * n;
    assert_true(steps > 0);
    for (int w = 0; w < 3; w++) {
        now.wall[w].sum_steps += steps;
        now.wall[w].shift.z += now.wall[w].velocity.z * n * DT;
    }
    now.wall[2].sum_force.z += lid_stress * AREA * n;
    now.wall[2].sum_torque.z += torque;
    now.wall[0].sum_force.z -= (lid_stress * AREA + GRAIN_MASS * 9.81) * n;
    now.wall[0].sum_torque.z -= 0.75 * torque; // whatever the shares of trough and sides
    now.wall[1].sum_torque.z -= 0.25 * torque;
    now.state.step += steps;
    return clod_ring_shear_sample(&now.test, &now.state, now.row);
}

/** Look until a phase is left; the number of looks, at most `most`. */
static inline int look_while(clod_ring_shear_phase phase, double lid_stress,
                             double shear_stress, int most)
{
    int looks = 0;
    while (now.test.phase == phase && looks < most) {
        look(lid_stress, shear_stress);
        looks++;
    }
    assert_int_not_equal(now.test.phase, phase);
    return looks;
}

static inline void go_to_preshear(void)
{
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 1000);
    look_while(CLOD_RING_SHEAR_LOWER, 0.1 * PRESHEAR, 0.0, 1000);
    look_while(CLOD_RING_SHEAR_CONSOLIDATE, PRESHEAR, 0.0, 1000);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_PRESHEAR);
}

static inline void go_to_the_end_of_preshear(void)
{
    go_to_preshear();
    look_while(CLOD_RING_SHEAR_PRESHEAR, PRESHEAR, 6e3, 100000);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
}

/** The shear stress is gone in the first look: hardly braked yet. */
static inline void go_to_the_end_of_reversal(void)
{
    go_to_the_end_of_preshear();
    clod_ring_shear_reverse(&now.test, &now.state);
    look_while(CLOD_RING_SHEAR_REVERSE, PRESHEAR, -1.0, 10);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
}
