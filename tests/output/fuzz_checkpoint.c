/**
 * libFuzzer target: a checkpoint whose bytes were changed, and its checksum with them, may not
 * crash clod. The input is a list of changes, each an offset (three bytes) and the new byte; so
 * it is about bytes that HDF5 understands, which chance would not reach.
 *
 * HDF5 1.10.8 itself does not withstand every file (docs/known-crashes.md): the checksum of a
 * checkpoint is what keeps damaged bytes away from it, and the first part here looks at that.
 */

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/checkpoint.h"
#include "output/checkpoint_file.h"
#include "output/file.h"
#include "output/folder.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
const char *__lsan_default_suppressions(void);

/** HDF5 1.10.8 loses some bytes when it refuses a file. */
const char *__lsan_default_suppressions(void)
{
    return "leak:libhdf5\n";
}

static char place[] = "/dev/shm/clod-fuzz-XXXXXX"; // in memory: files are brought to the disk
static clod_folder *folder;
static char path[64];
static char *whole; ///< a good checkpoint
static size_t whole_size;

static void remove_folder(void)
{
    clod_folder_close(&folder);
    unlink(path);
    rmdir(place);
}

/** A state of three grains that touch each other and a wall. */
static void make_state(clod_state *state, clod_wall *wall)
{
    static const double REST[3] = {0.0, 0.0, 0.0};
    clod_status status;
    *state = (clod_state){.dt = 1e-6, .time = 1e-3, .step = 1000, .adhesion = 1.0};
    *wall = (clod_wall){.name = "floor", .shape_count = 0};
    state->walls = (clod_walls){.count = 1, .wall = wall};
    for (uint64_t g = 0; g < 3; g++) {
        const double row[4] = {(double)g, 0.0, 0.0, 0.6};
        if (!clod_grains_add(&state->grains, row, REST, REST, 2500.0, 0, g + 1, &status)) {
            abort();
        }
    }
}

static void start(void)
{
    clod_state state;
    clod_wall wall;
    clod_status status;
    clod_contact contacts[] = {{.i = 0, .j = 1, .shape = -1},
                               {.i = 1, .j = 2, .shape = -1},
                               {.i = 0, .j = 0, .shape = 0}};
    void *bytes;
    if (mkdtemp(place) == NULL || atexit(remove_folder) != 0) {
        abort();
    }
    folder = clod_folder_look(place, &status);
    if (folder == NULL) {
        abort();
    }
    snprintf(path, sizeof path, "%s/restart_a.h5", place);
    make_state(&state, &wall);
    state.contacts = contacts;
    state.contact_count = 3;
    state.wall_contact_count = 1;
    if (!clod_checkpoint_write(folder, "restart", &state, NULL, 0, NULL, &status) ||
        !clod_file_read(path, &bytes, &whole_size, &status)) {
        abort();
    }
    whole = bytes;
    clod_grains_fini(&state.grains);
}

/** Read the file; what is read without an error must be fit to be used. */
static bool read_back(void)
{
    static clod_status status;
    char notice[512];
    clod_state state;
    clod_wall wall;
    make_state(&state, &wall);
    status.text[0] = '\0';
    const bool good = clod_checkpoint_read(folder, "restart", &state, NULL, 0, NULL, notice,
                                           sizeof notice, &status);
    for (size_t c = 0; good && c < state.contact_count; c++) {
        const clod_contact *contact = &state.contacts[c];
        const bool pair = c + state.wall_contact_count < state.contact_count;
        const size_t last = pair ? state.grains.count : (size_t)state.walls.count;
        if (contact->i < 0 || (size_t)contact->i >= state.grains.count || contact->j < 0 ||
            (size_t)contact->j >= last) {
            abort();
        }
    }
    if (!good && status.text[0] == '\0') {
        abort();
    }
    clod_grains_fini(&state.grains);
    clod_memory_free(state.contacts);
    clod_memory_free(state.build_place);
    clod_memory_free(state.build_walls);
    return good;
}

static void write_file(const char *bytes)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(bytes, 1, whole_size, file) != whole_size || fclose(file) != 0) {
        abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (whole == NULL) {
        start();
    }
    char *bytes = clod_memory_alloc(whole_size, 1);
    memcpy(bytes, whole, whole_size);
    for (size_t k = 0; k + 4 <= size; k += 4) {
        const size_t at = (size_t)data[k] << 16 | (size_t)data[k + 1] << 8 | data[k + 2];
        bytes[at % whole_size] = (char)data[k + 3];
    }
    const bool same = memcmp(bytes, whole, whole_size) == 0;
    write_file(bytes);
    if (read_back() != same) {
        abort(); // the checksum let a change through, or refused what is good
    }
    clod_checkpoint_head head = {.format = CLOD_CHECKPOINT_FORMAT,
                                 .bytes = whole_size - CLOD_CHECKPOINT_HEAD_BYTES};
    clod_checkpoint_file_print_head(bytes, &head, bytes + CLOD_CHECKPOINT_HEAD_BYTES);
    write_file(bytes);
    read_back();
    clod_memory_free(bytes);
    return 0;
}
