#include "output/checkpoint_contacts.h"

#include "base/memory.h"
#include "output/checkpoint_columns.h"
#include "state/ids.h"

/** Partners of some contacts: ids of grains, or of a grain and the wall's number. */
typedef uint64_t (*partners_of)[2];

static bool fail_without_memory(size_t contacts, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED,
                            "No memory for the %zu contacts of a checkpoint.", contacts);
}

static size_t slab_rows(size_t total)
{
    return total < CLOD_HDF_SLAB ? total : CLOD_HDF_SLAB;
}

/** Rows of a contact from its partners; false: they are not there. */
static bool find_contact(const clod_state *state, const clod_ids *ids, size_t c,
                         const uint64_t partners[2])
{
    clod_contact *contact = &state->contacts[c];
    const bool pair = c < state->contact_count - state->wall_contact_count;
    const int64_t i = clod_ids_row(ids, partners[0]);
    if (!pair) {
        const bool there = partners[1] < (uint64_t)state->walls.count;
        const int32_t wall = there ? (int32_t)partners[1] : 0;
        contact->i = (int32_t)i;
        contact->j = wall;
        return i >= 0 && there && contact->shape >= 0 &&
               contact->shape < state->walls.wall[wall].shape_count;
    }
    const int64_t j = clod_ids_row(ids, partners[1]);
    contact->i = (int32_t)i;
    contact->j = (int32_t)j;
    if (i >= 0 && j >= 0 && i > j) { // rows stand in another order than they did
        clod_contact_turn(contact);
    }
    return i >= 0 && j >= 0 && i != j && contact->shape == -1;
}

/** Read a slab of contacts from row `first` on, and find their rows. */
static bool get_slab(clod_hdf *hdf, clod_state *state, partners_of partners,
                     const clod_ids *ids, size_t first)
{
    const size_t total = state->contact_count;
    const size_t count = slab_rows(total - first);
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_of_contacts(&columns, &state->contacts[first],
                                        (const uint64_t(*)[2])partners, count);
    for (size_t c = 0; c < columns.count; c++) {
        clod_hdf_get_rows(hdf, &columns.column[c], first, total);
    }
    bool fit = true;
    for (size_t c = 0; fit && c < count && !clod_hdf_has_failed(hdf); c++) {
        fit = find_contact(state, ids, first + c, partners[c]);
    }
    return fit;
}

bool clod_checkpoint_contacts_get(clod_hdf *hdf, clod_state *state, const char *path,
                                  clod_status *status)
{
    const clod_hdf_column wall_count =
        clod_checkpoint_columns_wall_count(&state->wall_contact_count);
    clod_hdf_get(hdf, &wall_count);
    clod_ids ids;
    partners_of partners =
        clod_memory_alloc(slab_rows(state->contact_count) + 1, sizeof *partners);
    if (partners == NULL) {
        return fail_without_memory(state->contact_count, status);
    }
    if (!clod_ids_init(&ids, state->grains.id, state->grains.count, status)) {
        clod_memory_free(partners);
        return false;
    }
    const bool failed = clod_hdf_has_failed(hdf); // then there are no ids to compare with
    bool fit = failed || (state->wall_contact_count <= state->contact_count &&
                          clod_ids_are_different(&ids));
    for (size_t c = 0; fit && c < state->contact_count; c += CLOD_HDF_SLAB) {
        fit = get_slab(hdf, state, partners, &ids, c);
    }
    clod_ids_fini(&ids);
    clod_memory_free(partners);
    return fit || clod_status_fail(status, CLOD_FAILED,
                                   "%s holds two grains of one id, or contacts of grains or "
                                   "walls that it does not have. Start over with --fresh.",
                                   path);
}
