#include "output/checkpoint_give.h"

#include "base/memory.h"
#include "output/checkpoint_columns.h"

static size_t slab_rows(size_t left)
{
    return left < CLOD_HDF_SLAB ? left : CLOD_HDF_SLAB;
}

/** Rows of a state from `first` on as a state of their own, in which nothing is owned. */
static clod_state rows_from(const clod_state *state, size_t first, size_t count, bool built)
{
    clod_state rows = {.grains = clod_grains_view(&state->grains, first, count)};
    if (built) {
        rows.build_position = state->build_position + first;
    }
    return rows;
}

static bool give_grains(clod_hdf *hdf, clod_state *state, size_t total,
                        const clod_bed_taker *taker, clod_status *status)
{
    const bool built = clod_hdf_rows(hdf, "grains/build_position") > 0;
    bool good = true;
    for (size_t first = 0; good && first < total; first += CLOD_HDF_SLAB) {
        clod_checkpoint_columns columns;
        const size_t kept = state->grains.count, count = slab_rows(total - first);
        if (!clod_grains_reserve(&state->grains, kept + count, status)) {
            return false;
        }
        const clod_state rows = rows_from(state, kept, count, built);
        clod_checkpoint_columns_of_grains(&columns, &rows);
        for (size_t c = 0; c < columns.count; c++) {
            clod_hdf_get_rows(hdf, &columns.column[c], first, total);
        }
        state->grains.count = kept + count;
        good = clod_hdf_has_failed(hdf) || taker->grains(taker->context, state, kept, status);
    }
    return good;
}

/** Contacts on their way. */
typedef struct slab {
    clod_contact *contacts;  ///< [CLOD_HDF_SLAB] owned
    uint64_t (*partners)[2]; ///< of each; owned
    const char *path;        ///< of the file
} slab;

static bool fail_to_fit(const char *path, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED,
                            "%s holds contacts of walls that it does not have. Start over with "
                            "--fresh.",
                            path);
}

/** Whether a contact is one of two grains, or of a grain and a shape of a wall that is there. */
static bool fits(const clod_walls *walls, const clod_contact *contact,
                 const uint64_t partners[2], bool pair)
{
    if (pair) {
        return contact->shape == -1 && partners[0] != partners[1];
    }
    return partners[1] < (uint64_t)walls->count && contact->shape >= 0 &&
           contact->shape < walls->wall[partners[1]].shape_count;
}

/** Read and give contacts from row `first` on, up to a slab of them. */
static bool give_slab(clod_hdf *hdf, const clod_state *state, const slab *self, size_t first,
                      size_t count, const clod_bed_taker *taker, clod_status *status)
{
    const size_t total = state->contact_count;
    const uint64_t(*partners)[2] = (const uint64_t(*)[2])self->partners;
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_contacts(&columns, self->contacts, partners, count);
    for (size_t c = 0; c < columns.count; c++) {
        clod_hdf_get_rows(hdf, &columns.column[c], first, total);
    }
    bool fit = true;
    for (size_t c = 0; fit && c < count && !clod_hdf_has_failed(hdf); c++) {
        const bool pair = first + c < total - state->wall_contact_count;
        fit = fits(&state->walls, &self->contacts[c], partners[c], pair);
    }
    return (fit || fail_to_fit(self->path, status)) &&
           (clod_hdf_has_failed(hdf) ||
            taker->contacts(taker->context, self->contacts, partners, count, status));
}

static bool give_contacts(clod_hdf *hdf, clod_state *state, const clod_bed_taker *taker,
                          const char *path, clod_status *status)
{
    const clod_hdf_column walls =
        clod_checkpoint_columns_wall_count(&state->wall_contact_count);
    clod_hdf_get(hdf, &walls);
    const size_t total = state->contact_count;
    const size_t most = slab_rows(total);
    slab self = {.contacts = clod_memory_alloc(most + 1, sizeof *self.contacts),
                 .partners = clod_memory_alloc(most + 1, sizeof *self.partners),
                 .path = path};
    bool good =
        (self.contacts != NULL && self.partners != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "No memory for the contacts of a checkpoint.");
    good = good && (clod_hdf_has_failed(hdf) || state->wall_contact_count <= total ||
                    fail_to_fit(path, status));
    for (size_t first = 0; good && first < total; first += CLOD_HDF_SLAB) {
        good = give_slab(hdf, state, &self, first, slab_rows(total - first), taker, status);
    }
    clod_memory_free(self.contacts);
    clod_memory_free(self.partners);
    return good;
}

bool clod_checkpoint_give(clod_hdf *hdf, clod_state *state, const clod_bed_taker *taker,
                          const char *path, clod_status *status)
{
    const size_t grains = clod_hdf_rows(hdf, "grains/id");
    state->contact_count = clod_hdf_rows(hdf, "contacts/shape");
    const bool good = give_grains(hdf, state, grains, taker, status) &&
                      give_contacts(hdf, state, taker, path, status);
    state->contact_count = state->wall_contact_count = 0; // they are elsewhere
    return good;
}
