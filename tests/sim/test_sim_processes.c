// A simulation of the library computes in its own process: under mpirun it must be asked for.
#include <stdlib.h>
#include <string.h>

#include "clod/sim.h"
#include "support/check.h"

static const char TEXT[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0}}\n"
    "time: {step: 1e-5 s, design_stress: 1 kPa}\n"
    "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"
    "stages: [{name: fall, duration: 1 s}]\n";

/** Whether it can be made; `text` begins the reason if not. */
static bool can_be_made(const clod_sim_options *options, const char *reason)
{
    clod_status status = {0};
    clod_sim *sim = clod_sim_create_from_text("case.yaml", TEXT, options, &status);
    const bool made = sim != NULL;
    if (!made) {
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, reason));
    }
    clod_sim_destroy(&sim);
    return made;
}

static void several_processes_must_be_meant(void **state)
{
    (void)state;
    static const char REASON[] = "3 processes were started together";
    const clod_sim_options each = {.each_process = true};
    setenv("OMPI_COMM_WORLD_SIZE", "3", 1);
    assert_false(can_be_made(NULL, REASON));
    assert_false(can_be_made(&(clod_sim_options){0}, REASON));
    assert_true(can_be_made(&each, ""));
    setenv("OMPI_COMM_WORLD_SIZE", "1", 1);
    assert_true(can_be_made(NULL, ""));
    unsetenv("OMPI_COMM_WORLD_SIZE");
    assert_true(can_be_made(NULL, ""));
    setenv("PMI_SIZE", "3", 1); // MPICH, Intel
    assert_false(can_be_made(NULL, REASON));
    unsetenv("PMI_SIZE");
    setenv("SLURM_STEP_NUM_TASKS", "3", 1); // a batch script, and a program that srun started
    assert_true(can_be_made(NULL, ""));
    setenv("PMIX_RANK", "0", 1);
    assert_false(can_be_made(NULL, REASON));
    unsetenv("SLURM_STEP_NUM_TASKS"); // started by somebody who does not say how many there are
    assert_false(can_be_made(NULL, "several processes were started together"));
    assert_true(can_be_made(&each, ""));
    unsetenv("PMIX_RANK");
    setenv("OMPI_COMM_WORLD_SIZE", "many", 1);
    assert_false(can_be_made(NULL, "several processes were started together"));
    unsetenv("OMPI_COMM_WORLD_SIZE");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(several_processes_must_be_meant),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
