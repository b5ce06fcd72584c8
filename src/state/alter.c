#include "state/alter.h"

#include <string.h>

#include "base/memory.h"

/** Move the rows of an array to their new places; NULL is fine. */
static void drop_rows(void *array, size_t count, size_t size, const int32_t *rank)
{
    char *rows = array;
    for (size_t g = 0; rows != NULL && g < count; g++) {
        if (rank[g] >= 0 && (size_t)rank[g] != g) {
            memcpy(rows + (size_t)rank[g] * size, rows + g * size, size);
        }
    }
}

/** Contacts of grains that stay, by their new rows. */
static void drop_contacts(clod_state *self, const int32_t *rank)
{
    const size_t pairs = self->contact_count - self->wall_contact_count;
    size_t kept = 0, kept_walls = 0;
    for (size_t k = 0; k < self->contact_count; k++) {
        clod_contact contact = self->contacts[k];
        const bool wall = k >= pairs;
        contact.i = rank[contact.i];
        contact.j = wall ? contact.j : rank[contact.j];
        if (contact.i >= 0 && contact.j >= 0) {
            self->contacts[kept++] = contact;
            kept_walls += wall;
        }
    }
    self->contact_count = kept;
    self->wall_contact_count = kept_walls;
}

void clod_state_drop_grains(clod_state *self, const int32_t *rank)
{
    clod_grains *grains = &self->grains;
    const size_t n = grains->count;
    drop_contacts(self, rank);
    drop_rows(grains->position, n, sizeof *grains->position, rank);
    drop_rows(grains->velocity, n, sizeof *grains->velocity, rank);
    drop_rows(grains->angular_velocity, n, sizeof *grains->angular_velocity, rank);
    drop_rows(grains->load, n, sizeof *grains->load, rank);
    drop_rows(grains->before, n, sizeof *grains->before, rank);
    drop_rows(grains->id, n, sizeof *grains->id, rank);
    drop_rows(grains->material, n, sizeof *grains->material, rank);
    size_t left = 0;
    for (size_t g = 0; g < n; g++) {
        left += rank[g] >= 0;
    }
    grains->count = left;
    clod_grains_pad(grains);
}

void clod_state_drop_contacts(clod_state *self, const uint8_t *keep)
{
    const size_t pairs = self->contact_count - self->wall_contact_count;
    size_t kept = 0, kept_walls = 0;
    for (size_t k = 0; k < self->contact_count; k++) {
        if (keep[k] != 0) {
            self->contacts[kept++] = self->contacts[k];
            kept_walls += k >= pairs;
        }
    }
    self->contact_count = kept;
    self->wall_contact_count = kept_walls;
}

void clod_state_drop_wall(clod_state *self, int32_t wall)
{
    clod_walls *walls = &self->walls;
    const size_t pairs = self->contact_count - self->wall_contact_count;
    size_t kept = pairs;
    for (size_t k = pairs; k < self->contact_count; k++) {
        clod_contact contact = self->contacts[k];
        if (contact.j != wall) {
            contact.j -= contact.j > wall ? 1 : 0;
            self->contacts[kept++] = contact;
        }
    }
    self->contact_count = kept;
    self->wall_contact_count = kept - pairs;
    clod_memory_free(walls->wall[wall].shapes);
    walls->count--;
    memmove(&walls->wall[wall], &walls->wall[wall + 1],
            (size_t)(walls->count - wall) * sizeof *walls->wall);
}

bool clod_state_add_walls(clod_state *self, clod_wall *walls, size_t count, clod_status *status)
{
    const size_t old = (size_t)self->walls.count;
    clod_wall *grown = clod_memory_grow(self->walls.wall, old, old + count, sizeof *grown);
    if (grown == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu walls", old + count);
    }
    self->walls.wall = grown;
    for (size_t w = 0; w < count; w++) {
        grown[old + w] = walls[w];
        walls[w].shapes = NULL;
        walls[w].shape_count = 0;
    }
    self->walls.count = (int32_t)(old + count);
    return true;
}
