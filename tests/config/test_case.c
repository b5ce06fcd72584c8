/**
 * What a good case file becomes: values, defaults, inheritance, overrides. Expected
 * values are those written in the file, converted by hand, and the defaults asked for in the
 * issue.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdbool.h>
#include <string.h>

#include "clod/case.h"
#include "clod/schema.h"
#include "support/case_of.h"

#define EVERYTHING CLOD_SOURCE_DIR "/tests/config/good/everything.yaml"

static void same(double value, double expected)
{
    const double error = value > expected ? value - expected : expected - value;
    const double size = expected < 0.0 ? -expected : expected;
    if (!(error <= 4e-16 * size)) {
        fail_msg("%.17g is not %.17g", value, expected);
    }
}

static void same3(const double value[3], double x, double y, double z)
{
    same(value[0], x);
    same(value[1], y);
    same(value[2], z);
}

static void materials_and_domain_are_read(void **state)
{
    (void)state;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    assert_string_equal(made->title, "Free");
    assert_string_equal(made->path, EVERYTHING);
    assert_non_null(strstr(made->text, "\ntitle: Free\nseed: 7\n"));
    assert_int_equal(made->seed, 7);
    assert_int_equal(made->material_count, 3);
    assert_string_equal(made->materials[0].name, "ore");
    same(made->materials[0].density, 2481.3);
    same(made->materials[0].youngs_modulus, 119e9);
    same(made->materials[0].poissons_ratio, 0.34);
    same(made->materials[2].youngs_modulus, 0.0);
    assert_int_equal(clod_case_material_index(made, "belt"), 2);
    assert_int_equal(clod_case_material_index(made, "sand"), -1);
    same3(made->gravity, 0.0, 0.0, -1.62);
    assert_true(made->has_domain);
    same3(made->domain_min, -0.1, -0.11, -0.01);
    same3(made->domain_max, 0.12, 0.13, 1.0);
    assert_true(made->periodic[0] && !made->periodic[1] && made->periodic[2]);
    assert_false(made->ring_shear.present);
    clod_case_destroy(&made);
    assert_null(made);
    clod_case_destroy(&made);
}

static void pairs_inherit_from_default(void **state)
{
    (void)state;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    const clod_case_contact *ore = clod_case_pair(made, 0, 0);
    assert_int_equal(ore->law, CLOD_LAW_MEPA);
    same(ore->exponent, 1.5);
    same(ore->k1, 4.75e8);
    same(ore->k2, 2.37e9);
    same(ore->k_adh, 3.56e8);
    same(ore->friction, 0.35);
    assert_int_equal(ore->coulomb, CLOD_COULOMB_ADHESIVE);
    assert_int_equal(ore->tangential, CLOD_TANGENTIAL_TANGENT);
    same(ore->tangential_ratio, 1.0);
    assert_int_equal(ore->rolling, CLOD_ROLLING_EPSD);
    same(ore->rolling_friction, 0.3);
    same(ore->rolling_damping, 0.3);

    const clod_case_contact *steel = clod_case_pair(made, 0, 1);
    assert_int_equal(steel->law, CLOD_LAW_HERTZ);
    same(steel->exponent, 1.5);
    same(steel->k1, 0.0);
    same(steel->k_adh, 0.0);
    same(steel->friction, 0.1);
    assert_int_equal(steel->rolling, CLOD_ROLLING_EPSD);
    assert_memory_equal(steel, clod_case_pair(made, 1, 0), sizeof *steel);

    const clod_case_contact *belt = clod_case_pair(made, 2, 0);
    assert_int_equal(belt->law, CLOD_LAW_HOOKE);
    same(belt->exponent, 1.0);
    same(belt->k1, 20e3);
    same(belt->k2, 20e3);
    same(belt->k_adh, 0.0);
    assert_int_equal(belt->rolling, CLOD_ROLLING_NONE);
    clod_case_destroy(&made);
}

static void grains_are_read(void **state)
{
    (void)state;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    assert_int_equal(made->grains_count, 3);
    const clod_case_grains *sieved = &made->grains[0];
    assert_int_equal(sieved->sizes, CLOD_SIZE_SIEVE);
    assert_int_equal(sieved->sieve_count, 2);
    same(sieved->sieve[1].size, 0.008);
    same(sieved->sieve[1].passing, 1.0);
    same(sieved->mass, 0.25);
    assert_int_equal(sieved->count, 0);
    assert_int_equal(sieved->region.kind, CLOD_REGION_ANNULUS);
    same3(sieved->region.center, 0.0, 0.0, 0.01);
    same(sieved->region.inner_radius, 0.05);
    same(sieved->region.height, 0.08);
    same3(sieved->velocity, 0.0, 0.0, -0.5);
    const clod_case_grains *uniform = &made->grains[1];
    assert_int_equal(uniform->sizes, CLOD_SIZE_UNIFORM);
    same(uniform->radius_max, 0.003);
    same(uniform->fill_height, 0.04);
    same(uniform->fill_fraction, 0.6);
    assert_int_equal(uniform->region.kind, CLOD_REGION_BOX);
    same3(uniform->region.max, 0.05, 0.05, 0.08);
    const char *file = made->grains[2].file;
    assert_string_equal(file, CLOD_SOURCE_DIR "/tests/config/good/grains.csv");
    clod_case_destroy(&made);
}

static void walls_and_stages_are_read(void **state)
{
    (void)state;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    assert_int_equal(made->wall_count, 2);
    const clod_case_wall *floor = &made->walls[0];
    static const int KINDS[] = {CLOD_SHAPE_PLANE, CLOD_SHAPE_CYLINDER, CLOD_SHAPE_BAR,
                                CLOD_SHAPE_DISC,  CLOD_SHAPE_ANNULUS,  CLOD_SHAPE_BOX,
                                CLOD_SHAPE_CONE};
    assert_int_equal(floor->shape_count, 7);
    for (size_t i = 0; i < 7; i++) {
        assert_int_equal(floor->shapes[i].kind, KINDS[i]);
    }
    same3(floor->shapes[0].normal, 0.0, 0.0, 1.0);
    assert_int_equal(floor->shapes[1].side, CLOD_SIDE_OUTSIDE);
    same(floor->shapes[1].length, 0.06);
    same3(floor->shapes[2].to, 0.1, 0.0, 0.0);
    same(floor->shapes[2].height, 0.00635);
    same3(floor->shapes[3].point, 0.0, 0.0, 0.001);
    same3(floor->shapes[3].normal, 0.0, 0.0, -2.0);
    same3(floor->shapes[5].size, 0.001, 0.002, 0.003);
    same3(floor->shapes[6].point, 0.0, 0.0, 0.005);
    same3(floor->shapes[6].axis, 0.0, 0.0, 2.0);
    same(floor->shapes[6].foot_radius, 0.0);
    same(floor->shapes[6].top_radius, 0.05);
    same(floor->shapes[6].length, 0.1);
    assert_int_equal(floor->shapes[6].side, CLOD_SIDE_OUTSIDE);
    same(floor->spin, 3.14159265358979323846);
    same(floor->oscillation.angle, 3.14159265358979323846);
    same(floor->oscillation.amplitude, 0.0);
    same(floor->oscillation.frequency, 0.5);
    same(floor->oscillation.phase, 0.0);
    assert_int_equal(floor->load, CLOD_LOAD_NONE);
    const clod_case_wall *lid = &made->walls[1];
    assert_string_equal(lid->name, "lid");
    assert_int_equal(lid->load, CLOD_LOAD_STRESS);
    same(lid->stress, 10e3);
    same(lid->area, 25e-4);
    same(lid->mass, 0.1);
    same(lid->damping, 0.5);
    same3(lid->load_axis, 0.0, 0.0, -1.0);
    same3(lid->surface_velocity, 1.5, 0.0, 0.0);
    same3(lid->oscillation.direction, 1.0, 1.0, 0.0);
    same(lid->oscillation.amplitude, 0.0005);
    same(lid->oscillation.angle, 0.0);
    same(lid->oscillation.frequency, 50.0);
    same(lid->oscillation.phase, -0.5 * 3.14159265358979323846);
    assert_int_equal(made->stage_count, 2);
    same(made->stages[0].adhesion, 0.1);
    same(made->stages[0].rest, 0.001);
    same(made->stages[1].adhesion, 1.0);
    const clod_case_wall_change *change = &made->stages[1].walls[0];
    assert_string_equal(change->name, "lid");
    assert_true(change->has_stress && change->has_spin);
    assert_false(change->has_force || change->has_velocity || change->has_surface_velocity);
    same(change->stress, 20e3);
    clod_case_destroy(&made);
}

static void defaults_of_time_output_and_bench(void **state)
{
    (void)state;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    same(made->time.step, 0.0);
    same(made->time.safety, 0.1);
    same(made->time.design_stress, 0.0);
    same(made->time.rayleigh_limit, 0.15);
    same(made->output.series_interval, 1e-3);
    same(made->output.snapshot_interval, 0.0);
    same(made->output.checkpoint_interval, 60.0);
    assert_false(made->output.contacts);
    assert_false(made->output.has_steady_since);
    assert_int_equal(made->gauge_count, 2);
    const clod_case_gauge *gauge = &made->gauges[0];
    same(gauge->direction[0], 2.0);
    same(gauge->across[1], -1.0);
    same(gauge->blocked.mass_above, 0.01);
    same(gauge->blocked.speed_below, 0.02);
    same(gauge->blocked.duration, 0.3);
    assert_int_equal(gauge->profile_bins, 20);
    assert_int_equal(gauge->trajectory_bins, 3);
    same(made->gauges[1].region.outer_radius, 0.05);
    const clod_case_contact_bench *bench = &made->contact_bench;
    assert_true(bench->present && bench->wall);
    same(bench->adhesion, 1.0);
    same(bench->legs[0].overlap, 3e-6);
    same(bench->legs[0].slip[1], -2e-6);
    same(bench->legs[0].roll, 3.14159265358979323846);
    assert_int_equal(bench->legs[0].steps, 10);
    clod_case_destroy(&made);
}

// docs/theory/copper-ore.md (Table 1) and 7 (RST-01).
static void copper_ore_is_that_of_the_paper(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        double k_adh, preshear, speed, preshear_max;
    } ORES[] = {
        {CLOD_SOURCE_DIR "/cases/copper-ore-5/case.yaml", 3.56e8, 54.8e3, 0.04, 14.27e-3},
        {CLOD_SOURCE_DIR "/cases/copper-ore-8/case.yaml", 5.93e8, 38.7e3, 0.036, 14.22e-3}};
    for (size_t i = 0; i < 2; i++) {
        clod_case *made = case_in(ORES[i].path, NULL, 0);
        const clod_case_ring_shear *ring = &made->ring_shear;
        assert_true(ring->present);
        const int ore = clod_case_material_index(made, ring->grain_material);
        const int side = clod_case_material_index(made, ring->side_material);
        const int base = clod_case_material_index(made, ring->base_material);
        const clod_case_contact *contact = clod_case_pair(made, ore, ore);
        same(made->materials[ore].density, 2481.3);
        same(contact->exponent, 1.5);
        same(contact->k1, 4.75e8);
        same(contact->k2, 2.37e9);
        same(contact->k_adh, ORES[i].k_adh);
        same(contact->friction, 0.35);
        same(contact->rolling_friction, 0.3);
        same(clod_case_pair(made, ore, side)->friction, 0.0);
        assert_int_equal(clod_case_pair(made, ore, side)->rolling, CLOD_ROLLING_NONE);
        same(clod_case_pair(made, ore, base)->friction, 0.7);
        same(ring->radius_mean, 3.175e-3);
        same(ring->radius_min, 2.85e-3);
        same(ring->radius_max, 3.49e-3);
        same(ring->programme.preshear_stress, ORES[i].preshear);
        assert_int_equal(ring->programme.shear_stress_count, 4);
        for (size_t k = 0; k < 4; k++) {
            same(ring->programme.shear_stresses[k], 0.2 * (double)(k + 1) * ORES[i].preshear);
        }
        same(ring->inner_radius, 0.05);
        same(ring->outer_radius, 0.1);
        same(ring->depth, 0.04);
        assert_int_equal(ring->bar_count, 20);
        same(ring->bar_height, 0.00635);
        same(ring->bar_width, 0.003);
        same(ring->lid_mass, 1.0);
        same(ring->programme.speed, ORES[i].speed);
        same(ring->fill_adhesion, 0.1);
        assert_int_equal(ring->programme.steady_blocks, 5);
        same(ring->programme.steady_tolerance, 0.02);
        same(ring->programme.block_displacement, 0.002);
        same(ring->programme.preshear_min, 0.012);
        same(ring->programme.preshear_max, ORES[i].preshear_max);
        same(ring->programme.shear_max, 0.01);
        same(ring->programme.beyond_peak, 0.002);
        same(ring->programme.peak_window, 0.001);
        assert_int_equal(ring->grain_count, 0);
        assert_int_equal(ring->programme.seeds, 1);
        clod_case_destroy(&made);
    }
}

static void overrides_replace_add_and_reach_into_lists(void **state)
{
    (void)state;
    const char *const overrides[] = {
        "seed=11",
        "ring_shear.preshear_stress=30 kPa",
        "ring_shear.shear_stresses=5 10 20 kPa",
        "ring_shear.shear_stresses.1=12 kPa",
        "time={step: 1e-7 s}",
        "contacts.ore-ore.friction=50 %",
        "ring_shear.radius={mean: 3 mm, sd: 0.1 mm, min: 2 mm, max: 4 mm}"};
    static clod_status status;
    const char *path = CLOD_SOURCE_DIR "/cases/copper-ore-5/case.yaml";
    // a text of numbers is a single value, so the fourth cannot reach into it
    assert_null(clod_case_load(path, overrides, 7, &status));
    assert_non_null(strstr(status.text, "--set ring_shear.shear_stresses.1=12 kPa: "));
    const char *const good[] = {
        overrides[0], overrides[1], "ring_shear.shear_stresses=[5 kPa, 10 kPa]",
        overrides[3], overrides[4], overrides[5],
        overrides[6]};
    clod_case *made = case_in(path, good, 7);
    assert_int_equal(made->seed, 11);
    same(made->ring_shear.programme.preshear_stress, 30e3);
    assert_int_equal(made->ring_shear.programme.shear_stress_count, 2);
    same(made->ring_shear.programme.shear_stresses[0], 5e3);
    same(made->ring_shear.programme.shear_stresses[1], 12e3);
    same(made->time.step, 1e-7);
    same(clod_case_pair(made, 0, 0)->friction, 0.5);
    same(clod_case_pair(made, 0, 0)->k1, 4.75e8);
    same(made->ring_shear.radius_max, 4e-3);
    clod_case_destroy(&made);
}

// JSON is YAML too: what a script writes goes through the same loader.
static void json_is_read(void **state)
{
    (void)state;
    static const char JSON[] =
        "{\"materials\": {\"ore\": {\"density\": \"2000 kg/m3\"}},\n"
        " \"contacts\": {\"ore-ore\": {\"law\": \"hooke\", \"k1\": \"1e5 N/m\"}},\n"
        " \"contact_bench\": {\"material_1\": \"ore\", \"material_2\": \"ore\",\n"
        "  \"radius_1\": \"3 mm\", \"radius_2\": \"3 mm\",\n"
        "  \"legs\": [{\"overlap\": \"1 um\"}]}}\n";
    clod_case *made = case_at("case.json", JSON, NULL, 0);
    same(made->materials[0].density, 2000.0);
    same(clod_case_pair(made, 0, 0)->k1, 1e5);
    clod_case_destroy(&made);
}

/** soften stands beside the pairs and goes to all of them; their values stay as given, also when
 *  the echo is read again. */
static void soften_leaves_values_as_given(void **state)
{
    (void)state;
    const char *const change = "contacts.soften=100";
    clod_case *made = case_in(CLOD_SOURCE_DIR "/cases/copper-ore-5/case.yaml", &change, 1);
    char *echo = clod_case_echo(made);
    clod_case *again = case_at("echo.yaml", echo, NULL, 0);
    assert_non_null(strstr(echo, "\n  soften: 100\n"));
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            if (clod_case_pair(made, a, b)->exponent > 0.0) {
                same(clod_case_pair(made, a, b)->soften, 100.0);
                same(clod_case_pair(again, a, b)->soften, 100.0);
                same(clod_case_pair(again, a, b)->k1, 4.75e8);
            }
        }
    }
    clod_schema_free(echo);
    clod_case_destroy(&again);
    clod_case_destroy(&made);
    made = case_in(CLOD_SOURCE_DIR "/cases/copper-ore-5/case.yaml", NULL, 0);
    same(made->soften, 1.0);
    clod_case_destroy(&made);
}

/** A key of default is right when one pair uses it; the others lose it (good/inherited.yaml).
 */
static void keys_of_default_go_where_they_have_an_effect(void **state)
{
    (void)state;
    clod_case *made = case_in(CLOD_SOURCE_DIR "/tests/config/good/inherited.yaml", NULL, 0);
    const clod_case_contact *ore = clod_case_pair(made, 0, 0);
    const clod_case_contact *steel = clod_case_pair(made, 0, 1);
    const clod_case_contact *belt = clod_case_pair(made, 0, 2);
    const clod_case_contact *glue = clod_case_pair(made, 0, 3);
    same(ore->rolling_friction, 0.4);
    same(ore->rolling_damping, 0.2);
    same(ore->tangential_ratio, 0.8);
    same(steel->rolling_friction, 0.4);
    same(steel->rolling_damping, 0.0);
    same(steel->tangential_ratio, 1.0); // hertz has Mindlin's
    same(belt->rolling_friction, 0.0);
    same(belt->tangential_ratio, 1.0); // literal is k1 itself
    same(glue->rolling_friction, 0.0);
    same(glue->tangential_ratio, 0.8);
    clod_case_destroy(&made);
}

/** good/laws.yaml: own keys of luding and eepa; other laws lose what they inherit of them. */
static void the_keys_of_luding_and_eepa_are_read(void **state)
{
    (void)state;
    clod_case *made = case_in(CLOD_SOURCE_DIR "/tests/config/good/laws.yaml", NULL, 0);
    const clod_case_contact *ore = clod_case_pair(made, 0, 0);
    assert_int_equal(ore->law, CLOD_LAW_EEPA);
    same(ore->exponent, 1.5);
    same(ore->k_adh, 3.56e8);
    same(ore->pull_off_force, 2e-3);
    same(ore->surface_energy, 0.0);
    same(ore->plasticity_depth, 0.0);
    const clod_case_contact *steel = clod_case_pair(made, 0, 1);
    assert_int_equal(steel->law, CLOD_LAW_LUDING);
    same(steel->exponent, 1.0);
    same(steel->k1, 1e5);
    same(steel->k2, 5e5);
    same(steel->k_adh, 2e4);
    same(steel->plasticity_depth, 0.05);
    same(steel->pull_off_force, 0.0);
    const clod_case_contact *belt = clod_case_pair(made, 0, 2);
    assert_int_equal(belt->law, CLOD_LAW_MEPA);
    same(belt->k_adh, 0.0);
    same(belt->pull_off_force, 0.0);
    const clod_case_contact *glue = clod_case_pair(made, 0, 3);
    assert_int_equal(glue->law, CLOD_LAW_EEPA);
    same(glue->k_adh, 0.0);
    same(glue->pull_off_force, 2e-3);
    same(glue->surface_energy, 0.5);
    assert_int_equal(glue->tangential, CLOD_TANGENTIAL_LITERAL);
    clod_case_destroy(&made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_and_domain_are_read),
        cmocka_unit_test(pairs_inherit_from_default),
        cmocka_unit_test(grains_are_read),
        cmocka_unit_test(walls_and_stages_are_read),
        cmocka_unit_test(defaults_of_time_output_and_bench),
        cmocka_unit_test(copper_ore_is_that_of_the_paper),
        cmocka_unit_test(overrides_replace_add_and_reach_into_lists),
        cmocka_unit_test(json_is_read),
        cmocka_unit_test(soften_leaves_values_as_given),
        cmocka_unit_test(keys_of_default_go_where_they_have_an_effect),
        cmocka_unit_test(the_keys_of_luding_and_eepa_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
