// Checkpoints written slab by slab from a running step: the same file as from a list of all
// contacts, for any threads and order of rows, without memory for the grains.

#include "output/checkpoint.h"
#include "output/hdf.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"
#include "support/shuffled.h"

#include "temp_folder.h"

#define STEPS 3000
#define MANY (5 * CLOD_HDF_SLAB + 7) // more than fit into slabs
#define MANY_CONTACTS (3 * MANY)
#define MOST_KB 10000 // a slab of contacts, of a column, a chunk, and what HDF5 keeps

/** Write a checkpoint of a step from its blocks into a fresh file, and get it; owned. */
static char *store(void **folder, scene *s, size_t *size)
{
    clod_status status;
    clod_step_reader reader;
    const clod_contact_source from = clod_step_contacts(&s->step, &reader);
    clod_bed_view view;
    const clod_bed_source bed = clod_bed_source_of(&view, &s->state, &from);
    assert_true(clod_checkpoint_write(temp_folder(folder), "restart", &s->state, &bed, NULL, 0,
                                      NULL, &status));
    char *bytes = temp_read(folder, "restart_a.h5", size);
    char path[PATH_MAX];
    unlink(temp_path(path, folder, "restart_a.h5"));
    return bytes;
}

/** Compare and free. */
static void check_same_files(char *one, size_t one_size, char *two, size_t two_size)
{
    assert_int_equal(one_size, two_size);
    assert_memory_equal(one, two, one_size);
    clod_memory_free(two);
}

static void the_file_depends_on_no_threads_and_no_order(void **folder)
{
    for (int kind = 0; kind < BED_KINDS; kind++) {
        clod_status status;
        size_t size, other_size;
        scene whole;
        bed_init(&whole, (bed_kind)kind, 4);
        scene_start(&whole);
        scene_run(&whole, STEPS);
        char *bytes = store(folder, &whole, &size);
        assert_true(clod_step_export(&whole.step, &status));
        assert_true(clod_checkpoint_write(temp_folder(folder), "list", &whole.state, NULL, NULL,
                                          0, NULL, &status));
        char *list = temp_read(folder, "list_a.h5", &other_size);
        check_same_files(bytes, size, list, other_size);
        char path[PATH_MAX];
        unlink(temp_path(path, folder, "list_a.h5"));
        for (int threads = 2; threads <= 4; threads += sanitized() ? 2 : 1) {
            scene again;
            bed_init(&again, (bed_kind)kind, 4);
            scene_start_with(&again, (clod_step_options){.threads = threads});
            scene_run(&again, STEPS);
            char *its = store(folder, &again, &other_size);
            check_same_files(bytes, size, its, other_size);
            scene_end(&again);
            scene now = whole;
            now.laws.law = now.law;
            now.state = shuffled(&whole.state, (uint64_t)threads);
            scene_start_with(&now, (clod_step_options){.threads = threads});
            its = store(folder, &now, &other_size);
            check_same_files(bytes, size, its, other_size);
            scene_end(&now);
        }
        clod_memory_free(bytes);
        scene_end(&whole);
    }
}

/** A state of many grains and contacts, all different. */
static clod_state many(void)
{
    clod_status status;
    clod_state state = {.dt = 1e-6, .time = 1e-3, .step = 1000, .adhesion = 1.0};
    for (uint64_t g = 0; g < MANY; g++) {
        const double row[4] = {(double)g, 1.0, 2.0, 0.6}, speed[3] = {0.0, (double)g, 0.0};
        assert_true(
            clod_grains_add(&state.grains, row, speed, speed, 2500.0, 0, MANY - g, &status));
    }
    state.contacts = clod_memory_alloc(MANY_CONTACTS, sizeof *state.contacts);
    state.contact_count = state.contact_capacity = MANY_CONTACTS;
    for (size_t c = 0; c < MANY_CONTACTS; c++) {
        clod_contact *contact = &state.contacts[c];
        *contact = (clod_contact){
            .i = (int32_t)(c / 3), .j = (int32_t)((c / 3 + c % 3 + 1) % MANY), .shape = -1};
        contact->history[1] = (double)c;
        contact->history[7] = -(double)c;
        if (contact->i > contact->j) {
            clod_contact_turn(contact);
        }
    }
    return state;
}

static void many_grains_come_back_bit_for_bit(void **folder)
{
    clod_status status;
    char notice[512];
    clod_state state = many(), found = {0};
    assert_true(clod_checkpoint_write(temp_folder(folder), "restart", &state, NULL, NULL, 0,
                                      NULL, &status));
    assert_true(clod_checkpoint_read(temp_folder(folder), "restart", &found, NULL, 0, NULL,
                                     notice, sizeof notice, &status));
    assert_true(bits_same_grains(&found.grains, &state.grains));
    assert_true(bits_same_contacts(&found, &state));
    clod_state_fini(&state);
    clod_state_fini(&found);
}

/** A line of /proc/self/status [kB]. */
static long memory(const char *line)
{
    char text[256];
    long kilobytes = -1;
    FILE *file = fopen("/proc/self/status", "r");
    while (file != NULL && fgets(text, sizeof text, file) != NULL) {
        if (strncmp(text, line, strlen(line)) == 0) {
            kilobytes = strtol(text + strlen(line), NULL, 10);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return kilobytes;
}

static void writing_takes_no_memory_for_the_grains(void **folder)
{
    if (sanitized()) {
        skip(); // what is free again stays with it
    }
    clod_status status;
    clod_state state = many();
    for (int again = 0; again < 3; again++) {
        const long before = memory("VmRSS:");
        FILE *reset = fopen("/proc/self/clear_refs", "w"); // 5: the largest memory begins anew
        if (reset == NULL || fputs("5", reset) < 0 || fclose(reset) != 0) {
            skip();
        }
        assert_true(clod_checkpoint_write(temp_folder(folder), "restart", &state, NULL, NULL, 0,
                                          NULL, &status));
        const long most = memory("VmHWM:");
        print_message("%ld kB more than %ld kB\n", most - before, before);
        assert_in_range(most - before, 0, MOST_KB);
    }
    clod_state_fini(&state);
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(the_file_depends_on_no_threads_and_no_order),
        FOLDER_TEST(many_grains_come_back_bit_for_bit),
        FOLDER_TEST(writing_takes_no_memory_for_the_grains),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
