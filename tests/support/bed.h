#pragma once
/**
 * @file bed.h
 * Beds in which everything happens at once: three materials with six different laws, rotating,
 * moving, loaded and periodic boundaries; some hundred grains that fall and are stirred.
 */

#include "support/dice.h"
#include "support/scene.h"

typedef enum bed_kind {
    BED_DRUM,    ///< cylinder, rotating bottom with a bar, loaded lid with a bar
    BED_SLIT,    ///< periodic along x and y, floor and moving lid
    BED_CLUSTER, ///< periodic everywhere, no walls
    BED_HOPPER,  ///< cylinder on a cone that shakes, turning bottom with a bar that swings
    BED_KINDS
} bed_kind;

/** Six laws: all kinds, exponents, Coulomb limits, stiffnesses and rolling models. */
static inline void bed_laws(scene *self)
{
    clod_case_contact c = contact_ore();
    c.restitution = 0.5;
    scene_law(self, 0, 0, &c); // mepa, n = 3/2, adhesive, epsd2
    c.exponent = 1.2;
    c.k1 = 2e7;
    c.k2 = 6e7;
    c.k_adh = 1e7;
    c.coulomb = CLOD_COULOMB_FORCE;
    c.rolling = CLOD_ROLLING_EPSD;
    c.rolling_damping = 0.3;
    scene_law(self, 0, 1, &c);
    c.exponent = 1.0;
    c.k1 = 1e6;
    c.k2 = 3e6;
    c.k_adh = 5e5;
    c.tangential = CLOD_TANGENTIAL_LITERAL;
    c.rolling = CLOD_ROLLING_CDT;
    scene_law(self, 0, 2, &c);
    c.law = CLOD_LAW_HOOKE;
    c.coulomb = CLOD_COULOMB_PAPER;
    c.tangential = CLOD_TANGENTIAL_TANGENT;
    c.rolling = CLOD_ROLLING_EPSD2;
    scene_law(self, 1, 1, &c);
    c.law = CLOD_LAW_HERTZ;
    c.rolling = CLOD_ROLLING_EPSD;
    scene_law(self, 1, 2, &c);
    c.rolling = CLOD_ROLLING_NONE;
    c.coulomb = CLOD_COULOMB_ADHESIVE;
    scene_law(self, 2, 2, &c);
}

static inline void bed_drum(scene *self)
{
    const clod_shape drum = shape_drum(-0.005, 0.0295, 0.2);
    scene_wall(self, "drum", drum)->material = 1;
    clod_shape disc = shape_floor(0.0);
    disc.kind = CLOD_SHAPE_ANNULUS;
    disc.inner = 0.0;
    disc.outer = 0.0295;
    clod_wall *base = scene_wall(self, "base", disc);
    base->shape_count = 2;
    base->shapes = clod_memory_grow(base->shapes, 1, 2, sizeof *base->shapes);
    base->shapes[1] = shape_box((clod_vec3){0.016, 0.0, 0.0015}, 0.012, 0.002, 0.0015);
    base->shapes[1].material = 1 + 1;
    base->shapes[1].belt = (clod_belt){.velocity = {0.1, 0.0, -0.05},
                                       .speed = 0.2,
                                       .direction = {0.0, 0.6, 0.8},
                                       .spin = 3.0,
                                       .spin_axis = {0.0, 1.0, 0.0},
                                       .spin_point = {0.01, 0.0, 0.0}};
    base->spin = 8.0;
    disc.center.z = 0.07;
    disc.axis[2].z = -1.0;
    disc.axis[0] = clod_vec3_scale(disc.axis[0], -1.0);
    clod_wall *lid = scene_wall(self, "lid", disc);
    lid->shape_count = 2;
    lid->shapes = clod_memory_grow(lid->shapes, 1, 2, sizeof *lid->shapes);
    lid->shapes[1] = shape_box((clod_vec3){-0.016, 0.0, 0.0685}, 0.012, 0.002, 0.0015);
    lid->material = 2;
    clod_wall_set_orientation(lid, clod_quat_about((clod_vec3){0.0, 0.0, 1.0}, 0.4));
    lid->load = CLOD_LOAD_FORCE;
    lid->load_force = 30.0;
    lid->load_axis = (clod_vec3){0.0, 0.0, -1.0};
    lid->mass = 0.05;
    lid->damping = 20.0;
    lid->spin = -3.0;
}

static inline void bed_slit(scene *self)
{
    for (int a = 0; a < 2; a++) {
        self->state.domain.periodic[a] = true;
        self->state.domain.min[a] = -0.02;
        self->state.domain.max[a] = 0.025;
    }
    scene_wall(self, "floor", shape_floor(0.0))->surface_velocity.y = 0.2;
    const clod_shape top =
        shape_plane((clod_vec3){0.0, 0.0, 0.07}, (clod_vec3){0.0, 0.0, -1.0});
    clod_wall *lid = scene_wall(self, "lid", top);
    lid->velocity = (clod_vec3){0.3, 0.0, -0.4};
    lid->material = 2;
}

static inline void bed_cluster(scene *self)
{
    for (int a = 0; a < 3; a++) {
        self->state.domain.periodic[a] = true;
        self->state.domain.min[a] = -0.02;
        self->state.domain.max[a] = a < 2 ? 0.025 : 0.06;
    }
    self->state.gravity[2] = 0.0;
}

static inline void bed_hopper(scene *self)
{
    scene_wall(self, "tube", shape_drum(0.012, 0.0295, 0.2))->material = 1;
    clod_wall *cone = scene_wall(self, "cone", shape_hopper(0.0, 0.024, 0.0295, 0.012));
    cone->oscillation = (clod_oscillation){
        .direction = {0.6, 0.0, 0.8}, .amplitude = 2e-4, .frequency = 900.0, .phase = 0.5};
    cone->velocity.z = -0.02;
    clod_shape disc = shape_floor(0.0);
    disc.kind = CLOD_SHAPE_DISC;
    disc.outer = 0.0295;
    clod_wall *base = scene_wall(self, "base", disc);
    base->shape_count = 2;
    base->shapes = clod_memory_grow(base->shapes, 1, 2, sizeof *base->shapes);
    base->shapes[1] = shape_box((clod_vec3){0.012, 0.0, 0.0015}, 0.009, 0.002, 0.0015);
    base->spin = 4.0;
    base->oscillation = (clod_oscillation){.angle = 0.1, .frequency = 400.0};
    base->material = 2;
    clod_wall_start(cone);
    clod_wall_start(base);
}

/** A bed of about 300 grains on a lattice with room between them, thrown at each other. */
static inline void bed_init(scene *self, bed_kind kind, uint64_t seed)
{
    const clod_case_contact ore = contact_ore();
    dice roll = {seed};
    scene_init(self, 1e-6, &ore);
    bed_laws(self);
    self->state.gravity[2] = -9.81;
    if (kind == BED_DRUM) {
        bed_drum(self);
    } else if (kind == BED_SLIT) {
        bed_slit(self);
    } else if (kind == BED_HOPPER) {
        bed_hopper(self);
    } else {
        bed_cluster(self);
    }
    for (int k = 0; k < 7 * 7 * 10; k++) {
        const double x = -0.019 + 0.0064 * (k % 7);
        const double y = -0.019 + 0.0064 * (k / 7 % 7);
        const double z = 0.0063 + 0.0064 * (k / 49);
        if ((kind == BED_DRUM && x * x + y * y > 0.026 * 0.026) ||
            (kind == BED_HOPPER && x * x + y * y > (z < 0.016 ? 4e-4 : 6.5e-4)) ||
            (kind == BED_CLUSTER && z > 0.05)) {
            continue;
        }
        const size_t g = scene_grain(self, x, y, z, dice_real(&roll, 2.6e-3, 3.1e-3));
        scene_move(self, g, dice_real(&roll, -1.0, 1.0), dice_real(&roll, -1.0, 1.0),
                   dice_real(&roll, -3.0, 0.5));
        scene_turn(self, g, dice_real(&roll, -99.0, 99.0), dice_real(&roll, -99.0, 99.0),
                   dice_real(&roll, -99.0, 99.0));
        self->state.grains.material[g] = (uint16_t)dice_pick(&roll, 3);
    }
}
