/**
 * libFuzzer target: a damaged checkpoint is refused, and one that holds nonsense as well.
 *
 * The input is read twice. First as changes of a good file, each an offset (three bytes) and
 * the new byte: the checksum must find them. Then as the contacts of a state, which clod writes
 * and reads: contacts of grains that are not there must be refused.
 *
 * Bytes changed behind the checksum are not handed to HDF5 1.10.8, which crashes on some
 * (docs/known-crashes.md).
 */

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/checkpoint.h"
#include "output/file.h"
#include "output/folder.h"

enum { CONTACTS = 3 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
const char *__lsan_default_suppressions(void);

/** HDF5 1.10.8 loses some bytes when it refuses a file. */
const char *__lsan_default_suppressions(void)
{
    return "leak:libhdf5\n";
}

static char place[] = "/dev/shm/clod-fuzz-XXXXXX"; // in memory: files are brought to the disk
static clod_folder *folder;
static char path[64], other[64]; ///< the two files of a checkpoint
static char *whole;              ///< a good checkpoint
static size_t whole_size;

static void remove_folder(void)
{
    clod_folder_close(&folder);
    unlink(path);
    unlink(other);
    rmdir(place);
}

/** A state of three grains that touch each other and a wall. */
static void make_state(clod_state *state)
{
    static const double REST[3] = {0.0, 0.0, 0.0};
    clod_status status;
    *state = (clod_state){.dt = 1e-6, .time = 1e-3, .step = 1000, .adhesion = 1.0};
    clod_wall *wall = clod_memory_alloc(1, sizeof *wall);
    *wall = (clod_wall){
        .name = "floor", .shape_count = 1, .shapes = clod_memory_alloc(1, sizeof(clod_shape))};
    state->walls = (clod_walls){.count = 1, .wall = wall};
    for (uint64_t g = 0; g < 3; g++) {
        const double row[4] = {(double)g, 0.0, 0.0, 0.6};
        if (!clod_grains_add(&state->grains, row, REST, REST, 2500.0, 0, g + 1, &status)) {
            abort();
        }
    }
}

/** Write three grains with these contacts, the last `of_walls` of them with the wall. Rows 3
 * and 4 are of grains that the file does not have. */
static void write_state(clod_contact *contacts, size_t of_walls)
{
    clod_state state;
    clod_status status;
    make_state(&state);
    state.grains.id[3] = 100;
    state.grains.id[4] = UINT64_MAX;
    state.contacts = contacts;
    state.contact_count = CONTACTS;
    state.wall_contact_count = of_walls;
    if (!clod_checkpoint_write(folder, "restart", &state, NULL, NULL, 0, NULL, &status)) {
        abort();
    }
    clod_grains_fini(&state.grains);
    clod_walls_fini(&state.walls);
}

static void start(void)
{
    clod_status status;
    clod_contact contacts[CONTACTS] = {{.i = 0, .j = 1, .shape = -1},
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
    snprintf(other, sizeof other, "%s/restart_b.h5", place);
    write_state(contacts, 1);
    if (!clod_file_read(path, &bytes, &whole_size, &status)) {
        abort();
    }
    whole = bytes;
}

/** Whether these contacts are of the three grains, and the wall and its shape. */
static bool fits(const clod_contact *contacts, size_t of_walls)
{
    bool fit = of_walls <= CONTACTS;
    for (size_t c = 0; fit && c < CONTACTS; c++) {
        const clod_contact *k = &contacts[c];
        fit = k->i < 3 && (c + of_walls < CONTACTS ? k->j < 3 && k->i != k->j && k->shape == -1
                                                   : k->j == 0 && k->shape == 0);
    }
    return fit;
}

/** Whether the file is read; what refuses it must say why. */
static bool read_back(void)
{
    static clod_status status;
    char notice[512];
    clod_state state;
    make_state(&state);
    status.text[0] = '\0';
    const bool good = clod_checkpoint_read(folder, "restart", &state, NULL, 0, NULL, notice,
                                           sizeof notice, &status);
    if (!good && status.text[0] == '\0') {
        abort();
    }
    clod_state_fini(&state);
    return good;
}

/** Change bytes of the good file; the checksum lets no change through. */
static void try_changes(const uint8_t *data, size_t size)
{
    char *bytes = clod_memory_alloc(whole_size, 1);
    memcpy(bytes, whole, whole_size);
    for (size_t k = 0; k + 4 <= size; k += 4) {
        const size_t at = (size_t)data[k] << 16 | (size_t)data[k + 1] << 8 | data[k + 2];
        bytes[at % whole_size] = (char)data[k + 3];
    }
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(bytes, 1, whole_size, file) != whole_size || fclose(file) != 0) {
        abort();
    }
    if (read_back() != (memcmp(bytes, whole, whole_size) == 0)) {
        abort();
    }
    clod_memory_free(bytes);
}

/** A number near those that fit, from a byte: most of what is tried is just inside or outside.
 */
static int32_t number(uint8_t byte)
{
    return byte < 250 ? byte % 6 - 1 : byte % 2 == 0 ? INT32_MAX - byte : INT32_MIN + byte;
}

/** Contacts from the input, through clod's own writer. */
static void try_contacts(const uint8_t *data, size_t size)
{
    clod_contact contacts[CONTACTS];
    memset(contacts, 0, sizeof contacts);
    if (size < 1 + 3 * CONTACTS) {
        return;
    }
    const size_t of_walls = data[0] % (CONTACTS + 1);
    for (size_t c = 0; c < CONTACTS; c++) {
        contacts[c].i = data[1 + 3 * c] % 5;
        contacts[c].j = c + of_walls < CONTACTS ? data[2 + 3 * c] % 5 : number(data[2 + 3 * c]);
        contacts[c].shape = number(data[3 + 3 * c]);
        for (int h = 0; h < 8; h++) {
            contacts[c].history[h] = h % 2 == 0 ? NAN : 1e300 * data[1 + 3 * c];
        }
    }
    unlink(path);
    unlink(other);
    write_state(contacts, of_walls);
    if (read_back() != fits(contacts, of_walls)) {
        abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (whole == NULL) {
        start();
    }
    unlink(other);
    try_changes(data, size);
    try_contacts(data, size);
    return 0;
}
