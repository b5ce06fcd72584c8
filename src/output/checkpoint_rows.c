#include "output/checkpoint_rows.h"

#include <errno.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/room.h"
#include "output/checkpoint.h"
#include "output/checkpoint_file.h"
#include "output/file.h"

/** Contacts on their way. */
typedef struct slab {
    clod_contact *contacts; ///< [CLOD_HDF_SLAB] at most; owned
    uint64_t (
        *partners)[2]; ///< of each: ids of grains, or of a grain and the wall's number; owned
} slab;

static size_t slab_rows(size_t total)
{
    return total < CLOD_HDF_SLAB ? total : CLOD_HDF_SLAB;
}

static bool slab_init(slab *self, size_t rows, clod_status *status)
{
    self->partners = clod_memory_alloc(rows + 1, sizeof *self->partners);
    self->contacts = clod_memory_alloc(rows + 1, sizeof *self->contacts);
    return (self->partners != NULL && self->contacts != NULL) ||
           clod_status_fail(status, CLOD_FAILED, "No memory for the contacts of a checkpoint.");
}

static void slab_fini(slab *self)
{
    clod_memory_free(self->contacts);
    clod_memory_free(self->partners);
}

// ---- room

static void reserve(clod_hdf *hdf, const clod_checkpoint_columns *columns, size_t rows,
                    uint64_t *place)
{
    CLOD_ASSERT(columns->count <= CLOD_BED_COLUMNS);
    for (size_t c = 0; c < columns->count; c++) {
        clod_hdf_column column = columns->column[c];
        column.rows = rows;
        clod_hdf_reserve(hdf, &column, &place[c]);
        place[c] += CLOD_CHECKPOINT_HEAD_BYTES;
    }
}

bool clod_checkpoint_rows_reserve(clod_hdf *hdf, const clod_state *state,
                                  const clod_bed_source *bed, clod_bed_layout *layout,
                                  clod_status *status)
{
    clod_checkpoint_columns columns;
    clod_bed_slab some = {.rows = state};
    const size_t grains = layout->all.grains;
    if (grains > 0 && !bed->grains(bed->context, 0, 1, &some, status)) {
        return false;
    }
    clod_checkpoint_columns_of_grains(&columns, some.rows); // those that this bed has
    layout->grain_columns = columns.count;
    reserve(hdf, &columns, grains, layout->grain);
    slab none;
    const bool good = slab_init(&none, 0, status);
    if (good) {
        const clod_hdf_column walls = clod_checkpoint_columns_wall_count(&layout->all.walls);
        clod_hdf_put(hdf, &walls);
        clod_checkpoint_columns_of_contacts(&columns, none.contacts,
                                            (const uint64_t(*)[2])none.partners, 0);
        layout->contact_columns = columns.count;
        reserve(hdf, &columns, layout->all.pairs + layout->all.walls, layout->contact);
    }
    slab_fini(&none);
    return good;
}

// ---- rows

int clod_checkpoint_rows_put(int descriptor, const clod_checkpoint_columns *columns,
                             const uint64_t *place, size_t first, clod_bytes *packed)
{
    int error = 0;
    for (size_t c = 0; error == 0 && c < columns->count; c++) {
        const clod_hdf_column *column = &columns->column[c];
        const size_t row = clod_hdf_row_size(column), bytes = column->rows * row;
        if (!clod_room_for(&packed->data, &packed->capacity, bytes + 1, 1)) {
            return ENOMEM;
        }
        clod_hdf_pack(column, 0, column->rows, packed->data);
        error = clod_file_write_at(descriptor, place[c] + (uint64_t)first * row, packed->data,
                                   bytes);
    }
    return error;
}

static bool fail(const clod_folder_draft *draft, int error, clod_status *status)
{
    return clod_folder_fail(draft->folder, "write", draft->name, error, status);
}

static bool write_grains(const clod_folder_draft *draft, const clod_bed_source *bed,
                         const clod_bed_layout *layout, clod_bytes *packed, clod_status *status)
{
    clod_checkpoint_columns columns;
    const size_t total = layout->all.grains;
    bool good = true;
    for (size_t first = 0; good && first < total; first += CLOD_HDF_SLAB) {
        clod_bed_slab some;
        good = bed->grains(bed->context, first, slab_rows(total - first), &some, status);
        if (good) {
            clod_checkpoint_columns_of_grains(&columns, some.rows);
            const int error = clod_checkpoint_rows_put(draft->descriptor, &columns,
                                                       layout->grain, first, packed);
            good = error == 0 || fail(draft, error, status);
        }
    }
    return good;
}

static bool write_contacts(const clod_folder_draft *draft, const clod_bed_source *bed,
                           const clod_bed_layout *layout, clod_bytes *packed,
                           clod_status *status)
{
    clod_checkpoint_columns columns;
    const size_t total = layout->all.pairs + layout->all.walls;
    slab some;
    bool good = slab_init(&some, slab_rows(total), status);
    for (size_t first = 0, count = 0; good && first < total; first += count) {
        count = slab_rows(total);
        good = bed->contacts(bed->context, &count, some.contacts, some.partners, NULL, status);
        if (good) {
            CLOD_ASSERT(count > 0);
            clod_checkpoint_columns_of_contacts(&columns, some.contacts,
                                                (const uint64_t(*)[2])some.partners, count);
            const int error = clod_checkpoint_rows_put(draft->descriptor, &columns,
                                                       layout->contact, first, packed);
            good = error == 0 || fail(draft, error, status);
        }
    }
    slab_fini(&some);
    return good;
}

bool clod_checkpoint_rows_write(const clod_folder_draft *draft, const clod_bed_source *bed,
                                clod_bed_layout *layout, clod_status *status)
{
    bool done = false;
    if (bed->write != NULL && clod_checkpoint_file_name(draft, &layout->file) &&
        !bed->write(bed->context, layout, &done, status)) {
        return false;
    }
    clod_bytes packed = {0};
    const bool good = done || (write_grains(draft, bed, layout, &packed, status) &&
                               write_contacts(draft, bed, layout, &packed, status));
    clod_bytes_fini(&packed);
    return good;
}
