/**
 * The echo of a case is complete and loads again to the same structs and the same echo.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

#include "clod/case.h"
#include "clod/schema.h"
#include "support/case_of.h"

/** The echo of a case, read again, must be the same in every bit that the echo holds. */
static void check_echo(clod_case *made)
{
    char *echo = clod_case_echo(made);
    assert_non_null(echo);
    static clod_status status;
    clod_case *again =
        clod_case_parse("elsewhere/echo.yaml", echo, strlen(echo), NULL, 0, &status);
    if (again == NULL) {
        fail_msg("%s\n%s", status.text, echo);
    }
    assert_memory_equal(&made->time, &again->time, sizeof made->time);
    assert_memory_equal(&made->output, &again->output, sizeof made->output);
    const size_t n = made->material_count;
    assert_int_equal(n, again->material_count);
    assert_memory_equal(made->pairs, again->pairs, n * n * sizeof *made->pairs);
    assert_int_equal(made->wall_count, again->wall_count);
    for (size_t i = 0; i < made->wall_count; i++) {
        assert_int_equal(made->walls[i].shape_count, again->walls[i].shape_count);
        assert_memory_equal(made->walls[i].shapes, again->walls[i].shapes,
                            made->walls[i].shape_count * sizeof *made->walls[i].shapes);
        const size_t from = offsetof(clod_case_wall, velocity);
        assert_memory_equal((char *)&made->walls[i] + from, (char *)&again->walls[i] + from,
                            sizeof made->walls[i] - from);
    }
    assert_int_equal(made->grains_count, again->grains_count);
    for (size_t i = 0; i < made->grains_count; i++) {
        const size_t from = offsetof(clod_case_grains, sieve_count);
        assert_memory_equal((char *)&made->grains[i] + from, (char *)&again->grains[i] + from,
                            offsetof(clod_case_grains, file) - from);
        assert_int_equal(made->grains[i].sizes, again->grains[i].sizes);
        assert_memory_equal(&made->grains[i].radius_mean, &again->grains[i].radius_mean,
                            4 * sizeof(double));
    }
    const size_t from = offsetof(clod_case_ring_shear, inner_radius);
    const size_t to = offsetof(clod_case_ring_shear, programme.shear_stresses);
    assert_memory_equal((char *)&made->ring_shear + from, (char *)&again->ring_shear + from,
                        to - from);
    assert_memory_equal(made->gravity, again->gravity, sizeof made->gravity);
    char *second = clod_case_echo(again);
    assert_string_equal(echo, second);
    clod_schema_free(echo);
    clod_schema_free(second);
    clod_case_destroy(&again);
}

static void echo_loads_again_to_the_same_case(void **state)
{
    (void)state;
    static const char *const CASES[] = {"copper-ore-5", "copper-ore-8", "copper-ore-uniaxial",
                                        "free-run", "contact-bench"};
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        char path[512];
        snprintf(path, sizeof path, CLOD_SOURCE_DIR "/cases/%s/case.yaml", CASES[i]);
        clod_case *made = case_in(path, NULL, 0);
        check_echo(made);
        clod_case_destroy(&made);
    }
    static const char *const GOOD[] = {"everything", "inherited", "laws"};
    for (size_t i = 0; i < sizeof GOOD / sizeof GOOD[0]; i++) {
        char path[512];
        snprintf(path, sizeof path, CLOD_SOURCE_DIR "/tests/config/good/%s.yaml", GOOD[i]);
        clod_case *made = case_in(path, NULL, 0);
        check_echo(made);
        clod_case_destroy(&made);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(echo_loads_again_to_the_same_case),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
