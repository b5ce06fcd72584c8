/**
 * libFuzzer target: no CSV file of grains may crash its reader, and what is refused is refused
 * with a message.
 */
#define _GNU_SOURCE // memfd_create

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "setup/grains_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** What was read: numbers that are numbers, sizes above 0, materials that there are. */
static void check_grains(const clod_grains *grains, const clod_case *from)
{
    for (size_t g = 0; g < grains->count; g++) {
        if (!(grains->position[g][3] > 0.0) || grains->material[g] >= from->material_count ||
            !isfinite(grains->position[g][0]) || !isfinite(grains->velocity[g][0])) {
            abort();
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static clod_status status;
    static int file = -1;
    static char path[64], ore[] = "ore", steel[] = "steel";
    if (file < 0) {
        file = memfd_create("grains", 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    }
    if (ftruncate(file, 0) != 0 || pwrite(file, data, size, 0) != (ssize_t)size) {
        abort();
    }
    clod_case_material materials[] = {{.name = ore, .density = 2500.0},
                                      {.name = steel, .density = 7800.0}};
    const clod_case from = {.materials = materials, .material_count = 2};
    const clod_case_grains group = {.file = path, .material = ore};
    clod_grains grains = {0};
    uint64_t next_id = 1;
    status.text[0] = '\0';
    if (clod_grains_file_read(&from, &group, &next_id, &grains, &status)) {
        check_grains(&grains, &from);
    } else if (status.text[0] == '\0') {
        abort();
    }
    clod_grains_fini(&grains);
    return 0;
}
