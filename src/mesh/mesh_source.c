#include "mesh/mesh_source.h"

#include <string.h>
#include <strings.h>

#include "base/memory.h"
#include "base/room.h"
#include "base/text.h"

#define SLOTS 16384 ///< of the table of names, four times as many as parts

static const struct {
    const char *extension;
    bool (*check)(clod_mesh_source *self, clod_status *status);
} FORMATS[] = {
    {"stl", clod_mesh_stl_check},
    {"obj", clod_mesh_obj_check},
    {"ply", clod_mesh_ply_check},
};

#define FORMAT_COUNT (sizeof FORMATS / sizeof FORMATS[0])

static bool fail_memory(const clod_mesh_source *self, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", self->path);
}

bool clod_mesh_source_init(clod_mesh_source *self, const char *path, clod_status *status)
{
    *self = (clod_mesh_source){.path = path};
    const char *dot = strrchr(path, '.');
    for (size_t f = 0; dot != NULL && f < FORMAT_COUNT; f++) {
        if (strcasecmp(dot + 1, FORMATS[f].extension) == 0) {
            self->extension = FORMATS[f].extension;
            return true;
        }
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        "%s: the name must end in .stl, .obj or .ply, which tells the format "
        "of a mesh file; export the geometry as one of them",
        path);
}

bool clod_mesh_source_check(clod_mesh_source *self, clod_status *status)
{
    if (self->length == 0) {
        return clod_status_fail(status, CLOD_USAGE, "%s: the file is empty", self->path);
    }
    self->slots = clod_memory_alloc(SLOTS, sizeof *self->slots);
    if (self->slots == NULL) {
        return fail_memory(self, status);
    }
    for (size_t f = 0; f < FORMAT_COUNT; f++) {
        if (strcmp(self->extension, FORMATS[f].extension) == 0 &&
            !FORMATS[f].check(self, status)) {
            return false;
        }
    }
    for (size_t p = 0; p < self->part_count; p++) { // now that no name is looked for any more
        clod_text_printable(self->parts[p].name);
    }
    return self->facets > 0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: there is no facet in the file; export surfaces as triangles",
                            self->path);
}

/** Slot of a name, or the free one where it belongs. */
static uint32_t *find_slot(const clod_mesh_source *self, const char *name, size_t length)
{
    uint32_t hash = 2166136261u; // FNV-1a
    for (size_t i = 0; i < length; i++) {
        hash = (hash ^ (unsigned char)name[i]) * 16777619u;
    }
    for (size_t at = hash % SLOTS;; at = (at + 1) % SLOTS) {
        const uint32_t slot = self->slots[at];
        if (slot == 0 || (strlen(self->parts[slot - 1].name) == length &&
                          memcmp(self->parts[slot - 1].name, name, length) == 0)) {
            return &self->slots[at];
        }
    }
}

static bool add_part(clod_mesh_source *self, const char *name, size_t length,
                     clod_status *status)
{
    if (self->part_count == CLOD_MESH_PARTS_MOST) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: the file has more than %d named parts; export fewer groups", self->path,
            CLOD_MESH_PARTS_MOST);
    }
    if (!clod_room_for_one(&self->parts, &self->part_room, self->part_count,
                           sizeof *self->parts)) {
        return fail_memory(self, status);
    }
    char *copy = clod_memory_alloc(length + 1, 1);
    if (copy == NULL) {
        return fail_memory(self, status);
    }
    memcpy(copy, name, length);
    self->parts[self->part_count++].name = copy;
    return true;
}

static bool add_run(clod_mesh_source *self, uint32_t part, clod_status *status)
{
    clod_mesh_run *last = self->run_count > 0 ? &self->runs[self->run_count - 1] : NULL;
    if (last != NULL && last->facets == 0) {
        last->part = part;
        return true;
    }
    if (last != NULL && last->part == part) {
        return true;
    }
    if (!clod_room_for_one(&self->runs, &self->run_room, self->run_count, sizeof *self->runs)) {
        return fail_memory(self, status);
    }
    self->runs[self->run_count++] = (clod_mesh_run){part, 0};
    return true;
}

bool clod_mesh_source_part(clod_mesh_source *self, const char *name, size_t length, size_t line,
                           clod_status *status)
{
    if (length > CLOD_MESH_NAME_MOST) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s:%zu: the name of the part has %zu bytes; at most %d are read: rename it",
            self->path, line, length, CLOD_MESH_NAME_MOST);
    }
    uint32_t *slot = find_slot(self, name, length);
    if (*slot == 0) {
        if (!add_part(self, name, length, status)) {
            return false;
        }
        *slot = (uint32_t)self->part_count;
    }
    return add_run(self, *slot - 1, status);
}

bool clod_mesh_source_add(clod_mesh_source *self, size_t triangles, clod_status *status)
{
    if (self->run_count == 0 && !clod_mesh_source_part(self, "", 0, 0, status)) {
        return false;
    }
    if (triangles > CLOD_MESH_FACETS_MOST - self->facets) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: the file has more than %d facets; a mesh for grains needs "
                                "no facets smaller than they are: export it coarser, or in "
                                "several files",
                                self->path, CLOD_MESH_FACETS_MOST);
    }
    self->facets += triangles;
    self->runs[self->run_count - 1].facets += triangles;
    return true;
}

void clod_mesh_source_fini(clod_mesh_source *self)
{
    for (size_t p = 0; p < self->part_count; p++) {
        clod_memory_free(self->parts[p].name);
    }
    clod_memory_free(self->parts);
    clod_memory_free(self->slots);
    clod_memory_free(self->runs);
    clod_memory_free(self->bytes);
    *self = (clod_mesh_source){0};
}
