#include "state/grains.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "state/limits.h"

#define PADDING 2

bool clod_grains_keep_before(clod_grains *self, clod_status *status)
{
    if (self->before == NULL) {
        self->before = clod_memory_alloc(self->capacity + 1, sizeof *self->before);
    }
    return self->before != NULL ||
           clod_status_fail(status, CLOD_FAILED, "no memory for the loads of %zu grains",
                            self->count);
}

bool clod_grains_keep_clumps(clod_grains *self, clod_status *status)
{
    if (self->clump != NULL) {
        return true;
    }
    self->clump = clod_memory_alloc(self->capacity + 1, sizeof *self->clump);
    if (self->clump == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the clumps of %zu grains",
                                self->count);
    }
    for (size_t g = 0; g < self->count; g++) {
        self->clump[g] = CLOD_GRAIN_CLUMP_NONE;
    }
    return true;
}

/** More rows for the columns that exist only when asked for. */
static bool grow_asked(clod_grains *self, size_t rows)
{
    bool good = true;
    if (self->clump != NULL) {
        void *clump = clod_memory_grow(self->clump, self->capacity, rows, sizeof *self->clump);
        self->clump = clump != NULL ? clump : self->clump;
        good = clump != NULL;
    }
    if (self->before != NULL) {
        void *before =
            clod_memory_grow(self->before, self->capacity, rows, sizeof *self->before);
        self->before = before != NULL ? before : self->before;
        good = good && before != NULL;
    }
    return good;
}

bool clod_grains_reserve(clod_grains *self, size_t count, clod_status *status)
{
    const size_t capacity = count + PADDING;
    if (capacity <= self->capacity) {
        return true;
    }
    if (!clod_limits_grains(count, status)) {
        return false;
    }
    const size_t old = self->capacity;
    // a file, a checkpoint or a copy asks for all of its grains at first
    const size_t rows = old == 0 ? capacity : capacity + capacity / 4;
    void *position = clod_memory_grow(self->position, old, rows, sizeof *self->position);
    void *velocity = clod_memory_grow(self->velocity, old, rows, sizeof *self->velocity);
    void *angular_velocity =
        clod_memory_grow(self->angular_velocity, old, rows, sizeof *self->angular_velocity);
    void *load = clod_memory_grow(self->load, old, rows, sizeof *self->load);
    void *id = clod_memory_grow(self->id, old, rows, sizeof *self->id);
    void *birth = clod_memory_grow(self->birth, old, rows, sizeof *self->birth);
    void *material = clod_memory_grow(self->material, old, rows, sizeof *self->material);
    self->position = position != NULL ? position : self->position;
    self->velocity = velocity != NULL ? velocity : self->velocity;
    self->angular_velocity =
        angular_velocity != NULL ? angular_velocity : self->angular_velocity;
    self->load = load != NULL ? load : self->load;
    self->id = id != NULL ? id : self->id;
    self->birth = birth != NULL ? birth : self->birth;
    self->material = material != NULL ? material : self->material;
    if (position == NULL || velocity == NULL || angular_velocity == NULL || load == NULL ||
        id == NULL || birth == NULL || material == NULL || !grow_asked(self, rows)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", count);
    }
    self->capacity = rows;
    clod_grains_pad(self);
    return true;
}

void clod_grains_set_size(clod_grains *self, size_t row, double radius, double density)
{
    const double mass = density * (4.0 / 3.0) * M_PI * radius * radius * radius;
    self->position[row][3] = radius;
    self->velocity[row][3] = mass;
    self->angular_velocity[row][3] = 1.0 / (0.4 * mass * radius * radius);
}

bool clod_grains_add(clod_grains *self, const double place[4], const double speed[3],
                     const double spin[3], double density, uint16_t material, uint64_t id,
                     clod_status *status)
{
    if (!clod_grains_reserve(self, self->count + 1, status)) {
        return false;
    }
    const size_t g = self->count++;
    memcpy(self->position[g], place, sizeof self->position[g]);
    memcpy(self->velocity[g], speed, 3 * sizeof(double));
    memcpy(self->angular_velocity[g], spin, 3 * sizeof(double));
    memset(self->load[g], 0, sizeof self->load[g]);
    clod_grains_set_size(self, g, place[3], density);
    self->id[g] = id;
    self->birth[g] = 0.0;
    self->material[g] = material;
    if (self->clump != NULL) {
        self->clump[g] = CLOD_GRAIN_CLUMP_NONE;
    }
    clod_grains_pad(self);
    return true;
}

clod_grains clod_grains_view(const clod_grains *self, size_t first, size_t count)
{
    return (clod_grains){.count = count,
                         .position = self->position + first,
                         .velocity = self->velocity + first,
                         .angular_velocity = self->angular_velocity + first,
                         .load = self->load + first,
                         .id = self->id + first,
                         .birth = self->birth + first,
                         .material = self->material + first,
                         .clump = self->clump != NULL ? self->clump + first : NULL};
}

void clod_grains_pad(clod_grains *self)
{
    for (size_t g = self->count; g < self->count + PADDING; g++) {
        const double x = (double)(g - self->count);
        memcpy(self->position[g], (double[4]){x, 0.0, 0.0, -1.0}, sizeof self->position[g]);
        memcpy(self->velocity[g], (double[4]){0.0, 0.0, 0.0, 1.0}, sizeof self->velocity[g]);
        memcpy(self->angular_velocity[g], (double[4]){0.0, 0.0, 0.0, 1.0},
               sizeof self->angular_velocity[g]);
        memset(self->load[g], 0, sizeof self->load[g]);
        self->material[g] = 0;
    }
}

bool clod_grains_copy(clod_grains *self, const clod_grains *from, clod_status *status)
{
    if (!clod_grains_reserve(self, from->count, status)) {
        return false;
    }
    const size_t n = from->count;
    if (n == 0) {
        return true;
    }
    self->count = n;
    memcpy(self->position, from->position, n * sizeof *self->position);
    memcpy(self->velocity, from->velocity, n * sizeof *self->velocity);
    memcpy(self->angular_velocity, from->angular_velocity, n * sizeof *self->angular_velocity);
    memcpy(self->load, from->load, n * sizeof *self->load);
    memcpy(self->id, from->id, n * sizeof *self->id);
    memcpy(self->birth, from->birth, n * sizeof *self->birth);
    memcpy(self->material, from->material, n * sizeof *self->material);
    if (from->clump != NULL) {
        if (!clod_grains_keep_clumps(self, status)) {
            return false;
        }
        memcpy(self->clump, from->clump, n * sizeof *self->clump);
    }
    clod_grains_pad(self);
    return true;
}

void clod_grains_fini(clod_grains *self)
{
    clod_memory_free(self->position);
    clod_memory_free(self->velocity);
    clod_memory_free(self->angular_velocity);
    clod_memory_free(self->load);
    clod_memory_free(self->before);
    clod_memory_free(self->id);
    clod_memory_free(self->birth);
    clod_memory_free(self->material);
    clod_memory_free(self->clump);
    *self = (clod_grains){0};
}
