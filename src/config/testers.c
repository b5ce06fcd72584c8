#include "config/testers.h"

#include <math.h>
#include <stdio.h>

#include "base/given.h"
#include "config/check.h"

// ---- ring_shear

static bool has_ring_shear(const clod_case *from)
{
    return from->ring_shear.present;
}

static clod_tester_materials ring_shear_materials(const clod_case *from)
{
    const clod_case_ring_shear *cell = &from->ring_shear;
    return (clod_tester_materials){
        cell->grain_material, {cell->side_material, cell->base_material, cell->lid_material}};
}

static const clod_case_programme *ring_shear_programme(const clod_case *from)
{
    return &from->ring_shear.programme;
}

static double ring_shear_damping(const clod_case *from)
{
    return from->ring_shear.lid_damping;
}

static double ring_shear_stress(const clod_case *from)
{
    return from->ring_shear.programme.preshear_stress;
}

// ---- jenike

static bool has_jenike(const clod_case *from)
{
    return from->jenike.present;
}

static clod_tester_materials jenike_materials(const clod_case *from)
{
    const clod_case_jenike *cell = &from->jenike;
    return (clod_tester_materials){
        cell->grain_material, {cell->side_material, cell->base_material, cell->lid_material}};
}

static const clod_case_programme *jenike_programme(const clod_case *from)
{
    return &from->jenike.programme;
}

static double jenike_damping(const clod_case *from)
{
    return from->jenike.lid_damping;
}

static double jenike_stress(const clod_case *from)
{
    return from->jenike.programme.preshear_stress;
}

// ---- uniaxial

static bool has_uniaxial(const clod_case *from)
{
    return from->uniaxial.present;
}

static clod_tester_materials uniaxial_materials(const clod_case *from)
{
    const clod_case_uniaxial *cell = &from->uniaxial;
    return (clod_tester_materials){
        cell->grain_material, {cell->side_material, cell->base_material, cell->lid_material}};
}

static double uniaxial_damping(const clod_case *from)
{
    return from->uniaxial.lid_damping;
}

static double largest(const double *stresses, size_t count)
{
    double stress = 0.0;
    for (size_t k = 0; k < count; k++) {
        stress = fmax(stress, stresses[k]);
    }
    return stress;
}

static double uniaxial_stress(const clod_case *from)
{
    return largest(from->uniaxial.consolidation_stresses,
                   from->uniaxial.consolidation_stress_count);
}

// ---- wall_friction

static bool has_wall_friction(const clod_case *from)
{
    return from->wall_friction.present;
}

static clod_tester_materials wall_friction_materials(const clod_case *from)
{
    const clod_case_wall_friction *cell = &from->wall_friction;
    return (clod_tester_materials){
        cell->grain_material, {cell->side_material, cell->plate_material, cell->lid_material}};
}

static double wall_friction_damping(const clod_case *from)
{
    return from->wall_friction.lid_damping;
}

static double wall_friction_stress(const clod_case *from)
{
    return largest(from->wall_friction.wall_stresses, from->wall_friction.wall_stress_count);
}

// ---- contact_bench

static bool has_contact_bench(const clod_case *from)
{
    return from->contact_bench.present;
}

static clod_tester_materials contact_bench_materials(const clod_case *from)
{
    return (clod_tester_materials){from->contact_bench.material_1,
                                   {from->contact_bench.material_2}};
}

const clod_config_tester CLOD_CONFIG_TESTER[CLOD_CASE_KINDS] = {
    [CLOD_CASE_RING_SHEAR] = {.key = "ring_shear",
                              .cell = true,
                              .present = has_ring_shear,
                              .materials = ring_shear_materials,
                              .programme = ring_shear_programme,
                              .stress = ring_shear_stress,
                              .lid_damping = ring_shear_damping,
                              .check = clod_check_ring_shear},
    [CLOD_CASE_JENIKE] = {.key = "jenike",
                          .cell = true,
                          .present = has_jenike,
                          .materials = jenike_materials,
                          .programme = jenike_programme,
                          .stress = jenike_stress,
                          .lid_damping = jenike_damping,
                          .check = clod_check_jenike},
    [CLOD_CASE_UNIAXIAL] = {.key = "uniaxial",
                            .cell = true,
                            .present = has_uniaxial,
                            .materials = uniaxial_materials,
                            .stress = uniaxial_stress,
                            .lid_damping = uniaxial_damping,
                            .check = clod_check_uniaxial},
    [CLOD_CASE_WALL_FRICTION] = {.key = "wall_friction",
                                 .cell = true,
                                 .present = has_wall_friction,
                                 .materials = wall_friction_materials,
                                 .stress = wall_friction_stress,
                                 .lid_damping = wall_friction_damping,
                                 .check = clod_check_wall_friction},
    [CLOD_CASE_CONTACT_BENCH] = {.key = "contact_bench",
                                 .present = has_contact_bench,
                                 .materials = contact_bench_materials,
                                 .check = clod_check_contact_bench},
};

bool clod_case_has(const clod_case *self, clod_case_kind kind)
{
    CLOD_NEED(self);
    const clod_config_tester *row = &CLOD_CONFIG_TESTER[kind];
    return row->key != NULL ? row->present(self)
                            : self->grains_count > 0 || self->stage_count > 0;
}

clod_case_kind clod_case_kind_of(const clod_case *self)
{
    CLOD_NEED(self);
    clod_case_kind beside = CLOD_CASE_FREE;
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_config_tester *row = &CLOD_CONFIG_TESTER[k];
        const bool present = row->key != NULL && row->present(self);
        if (present && row->cell) {
            return (clod_case_kind)k;
        }
        beside = present ? (clod_case_kind)k : beside;
    }
    return clod_case_has(self, CLOD_CASE_FREE) ? CLOD_CASE_FREE : beside;
}

bool clod_config_begins_empty(const clod_case *self)
{
    return clod_case_kind_of(self) == CLOD_CASE_FREE && self->grains_count == 0 &&
           self->stage_count > 0;
}

const clod_config_tester *clod_config_tester_of(const clod_case *from)
{
    return &CLOD_CONFIG_TESTER[clod_case_kind_of(from)];
}

const char *clod_case_tester(const clod_case *self)
{
    CLOD_NEED(self);
    const clod_config_tester *row = clod_config_tester_of(self);
    return row->cell ? row->key : NULL;
}

const clod_case_programme *clod_case_shear(const clod_case *self)
{
    CLOD_NEED(self);
    const clod_config_tester *tester = clod_config_tester_of(self);
    return tester->programme != NULL ? tester->programme(self) : NULL;
}

double clod_case_tester_stress(const clod_case *self)
{
    CLOD_NEED(self);
    const clod_config_tester *tester = clod_config_tester_of(self);
    return tester->stress != NULL ? tester->stress(self) : 0.0;
}

void clod_config_tester_keys(char text[CLOD_CONFIG_TESTER_KEYS])
{
    int used = 0;
    text[0] = '\0';
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_config_tester *row = &CLOD_CONFIG_TESTER[k];
        if (row->cell) {
            used += snprintf(text + used, CLOD_CONFIG_TESTER_KEYS - (size_t)used, "%s%s",
                             used > 0 ? ", " : "", row->key);
        }
    }
}
