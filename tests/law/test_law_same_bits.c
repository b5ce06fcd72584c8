// luding and eepa give the same bits whatever the instruction set.

#include "support/bed.h"
#include "support/bits.h"

#define STEPS 1500

/** Every branch of the code: luding, eepa with a constant pull, with patches of all exponents.
 */
static void cohesive_laws(scene *self)
{
    clod_case_contact c = contact_ore();
    c.restitution = 0.5;
    c.law = CLOD_LAW_EEPA;
    c.k_adh = 0.0;
    c.pull_off_force = 0.01;
    c.surface_energy = 200.0;
    scene_law(self, 0, 0, &c);
    c.coulomb = CLOD_COULOMB_FORCE;
    c.surface_energy = 0.0;
    c.k_adh = 3.56e8;
    scene_law(self, 0, 1, &c);
    c.k_adh = 0.0;
    c.surface_energy = 100.0;
    c.exponent = 1.2;
    c.k1 = 2e7;
    c.k2 = 6e7;
    scene_law(self, 0, 2, &c);
    c.exponent = 1.0;
    c.k1 = 1e6;
    c.k2 = 3e6;
    scene_law(self, 1, 1, &c);
    c.law = CLOD_LAW_LUDING;
    c.k_adh = 8e5;
    c.plasticity_depth = 0.002;
    c.coulomb = CLOD_COULOMB_ADHESIVE;
    scene_law(self, 1, 2, &c);
    scene_law(self, 2, 2, &c);
}

static void run_bed(scene *s, bed_kind kind, clod_step_options options)
{
    clod_status status = {0};
    bed_init(s, kind, 1);
    cohesive_laws(s);
    scene_start_with(s, options);
    scene_run(s, STEPS);
    assert_true(clod_step_export(&s->step, &status));
}

static void compare(clod_step_options options)
{
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene a, b;
        run_bed(&a, (bed_kind)kind, (clod_step_options){.threads = 1, .simd = "scalar"});
        assert_true(a.state.contact_count > a.state.grains.count / 4); // worth comparing
        run_bed(&b, (bed_kind)kind, options);
        check_same_bits(&a.state, &b.state);
        scene_end(&a);
        scene_end(&b);
    }
}

static void compare_sets(const char *simd)
{
    if (clod_kernel_choose(simd) == NULL) {
        print_message("this machine has no %s: not compared\n", simd);
        skip();
    }
    compare((clod_step_options){.threads = 1, .simd = simd});
}

static void avx2_gives_the_bits_of_scalar(void **state)
{
    (void)state;
    compare_sets("avx2");
}

static void avx512_gives_the_bits_of_scalar(void **state)
{
    (void)state;
    compare_sets("avx512");
}

static void neon_gives_the_bits_of_scalar(void **state)
{
    (void)state;
    compare_sets("neon");
}

static void two_threads_give_the_bits_of_one(void **state)
{
    (void)state;
    compare((clod_step_options){.threads = 2});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(avx2_gives_the_bits_of_scalar),
        cmocka_unit_test(avx512_gives_the_bits_of_scalar),
        cmocka_unit_test(neon_gives_the_bits_of_scalar),
        cmocka_unit_test(two_threads_give_the_bits_of_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
