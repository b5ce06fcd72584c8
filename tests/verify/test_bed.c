// A bed that is looked at goes the way of the same case under `clod run`: stages, changes of
// walls, adhesion, rest.

#include "clod/run.h"
#include "measure/contacts.h"
#include "output/temp_folder.h"
#include "support/check.h"
#include "verify/bed.h"

#define ROWS 256
#define COLUMNS 11

static const char CASE[] =
    "title: Bed\n"
    "materials:\n"
    "  ore: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"
    "contacts:\n"
    "  default: {law: mepa, k1: 2e5 N/m^1.5, k2: 1e6 N/m^1.5, k_adh: 1e5 N/m^1.5}\n"
    "grains:\n"
    "  - material: ore\n"
    "    count: 60\n"
    "    radius: {distribution: uniform, min: 4 mm, max: 5 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [40 mm, 40 mm, 80 mm]}}\n"
    "walls:\n"
    "  box:\n"
    "    material: ore\n"
    "    shapes:\n"
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}\n"
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [1, 0, 0]}\n"
    "      - plane: {point: [40 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}\n"
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 1, 0]}\n"
    "      - plane: {point: [0 mm, 40 mm, 0 mm], normal: [0, -1, 0]}\n"
    "stages:\n"
    "  - {name: settle, duration: 1 s, adhesion: 10 %, rest: 20 mm/s}\n"
    "  - {name: belt, duration: 20 ms, walls: {box: {surface_velocity: 0.2 0 0 m/s}}}\n"
    "output: {series_interval: 2 ms}\n";

typedef struct track {
    double time[ROWS], energy[ROWS], force[ROWS]; ///< s, J, N; of every look
    size_t count;
    size_t belt; ///< looks in the second stage
} track;

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    (void)status;
    track *self = context;
    const clod_wall *box = &now->state.walls.wall[0];
    assert_true(self->count < ROWS);
    self->time[self->count] = now->state.time;
    self->energy[self->count] = clod_measure_motion_of(&now->state).kinetic_energy;
    self->force[self->count] = box->sum_force.z / (double)(box->sum_steps + !box->sum_steps);
    self->belt += clod_verify_bed_is_in(now, "belt");
    self->count++;
    return true;
}

/** The first columns of a row; false at the end. */
static bool read_row(FILE *in, double row[COLUMNS])
{
    char line[2048];
    char *at = line;
    if (fgets(line, sizeof line, in) == NULL) {
        return false;
    }
    for (int c = 0; c < COLUMNS; c++) {
        row[c] = strtod(at, &at);
        assert_true(*at == ',');
        at++;
    }
    return true;
}

/** Run a bed and the same case with clod run: the same rows. `force`: the column of the box's. */
static track compare(void **state, const char *text, int force)
{
    clod_status status = {CLOD_OK, ""};
    char path[PATH_MAX];
    track seen = {0};
    const clod_verify_bench bench = {*state, "bed", NULL, NULL};
    if (!clod_verify_bed_run(&bench, "small", text, look, &seen, &status)) {
        fail_msg("%s", status.text);
    }

    char *report = NULL;
    char out[PATH_MAX];
    clod_case *from =
        clod_case_load(temp_path(path, state, "cases/small/case.yaml"), NULL, 0, &status);
    const clod_run_options options = {.directory = temp_path(out, state, "run"), .threads = 1};
    assert_true(clod_run(from, &options, &report, &status));
    clod_run_free(report);
    clod_case_destroy(&from);

    FILE *in = fopen(temp_path(path, state, "run/series.csv"), "r");
    assert_non_null(fgets(path, sizeof path,
                          in)); // time, stage, energy, speed, those of grains, force x y z
    double row[COLUMNS];
    size_t rows = 0;
    while (read_row(in, row)) {
        rows++; // the first look is before the first row
        assert_true(rows < seen.count);
        check_relative(seen.time[rows], row[0], 1e-8);
        check_relative(seen.energy[rows], row[2], 1e-8);
        check_relative(seen.force[rows], row[force], 1e-8);
    }
    fclose(in);
    assert_int_equal(rows + 1, seen.count);
    return seen;
}

static void a_bed_goes_the_way_of_clod_run(void **state)
{
    const track seen = compare(state, CASE, 6);
    assert_int_equal(seen.belt, 10);              // 20 ms / 2 ms
    assert_true(seen.time[seen.count - 1] < 0.9); // it came to rest before its time was over
}

/** A grain of 4.2 g every 8 ms comes into an empty box. */
static void grains_come_as_in_clod_run(void **state)
{
    static const char TEXT[] =
        "title: Bed\n"
        "materials: {ore: {density: 2500 kg/m3}}\n"
        "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}\n"
        "time: {design_stress: 1 kPa}\n"
        "domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.2 m]}\n"
        "grains:\n"
        "  - material: ore\n"
        "    radius: {distribution: uniform, min: 7 mm, max: 8 mm}\n"
        "    inlet: {mass_flow: 0.5 kg/s}\n"
        "    region: {box: {min: [-50 mm, -50 mm, 30 mm], max: [50 mm, 50 mm, 80 mm]}}\n"
        "    velocity: [0 m/s, 0 m/s, -1 m/s]\n"
        "walls: {box: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}}\n"
        "stages: [{name: fill, duration: 0.1 s}]\n"
        "output: {series_interval: 2 ms}\n";
    const track seen = compare(state, TEXT, 10);
    assert_int_equal(seen.count, 51);
    assert_true(seen.energy[40] > 0.0 && seen.force[49] < 0.0);
}

static bool end(void *context, clod_verify_bed *now, clod_status *status)
{
    *(int64_t *)context = now->state.step;
    return now->state.step == 0 || clod_status_fail(status, CLOD_FAILED, "seen enough");
}

static void a_look_may_end_the_run(void **state)
{
    clod_status status;
    int64_t step = 0;
    const clod_verify_bench bench = {*state, "bed", NULL, NULL};
    assert_false(clod_verify_bed_run(&bench, "small", CASE, end, &step, &status));
    assert_string_equal(status.text, "seen enough");
    assert_true(step > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_bed_goes_the_way_of_clod_run, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(grains_come_as_in_clod_run, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_look_may_end_the_run, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
