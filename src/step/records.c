#include "step/records.h"

#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/room.h"
#include "state/ids.h"
#include "state/limits.h"
#include "step/neighbour.h"

/** All that belongs to a grain. */
static int columns_of(const clod_state *state, clod_row_column columns[CLOD_ROW_COLUMNS + 1])
{
    const int count = clod_neighbour_columns(&state->grains, columns);
    const size_t place = sizeof *state->build_position;
    columns[count] = (clod_row_column){(char *)state->build_position, place, place};
    return count + 1;
}

void clod_records_put_grain(clod_bytes *to, const clod_state *state, size_t row)
{
    clod_row_column columns[CLOD_ROW_COLUMNS + 1];
    const int count = columns_of(state, columns);
    for (int k = 0; k < count; k++) {
        clod_bytes_put(to, columns[k].array + row * columns[k].stride, columns[k].size);
    }
}

bool clod_records_reserve(clod_state *state, size_t rows, clod_status *status)
{
    const size_t before = state->grains.capacity;
    if (!clod_grains_reserve(&state->grains, rows, status)) {
        return false;
    }
    if (state->build_position != NULL && state->grains.capacity == before) {
        return true;
    }
    const size_t known = state->build_position != NULL ? before : 0;
    double(*grown)[4] = clod_memory_grow(state->build_position, known, state->grains.capacity,
                                         sizeof *state->build_position);
    if (grown == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", rows);
    }
    state->build_position = grown;
    state->build_capacity = state->grains.capacity;
    return true;
}

bool clod_records_get_grains(const clod_bytes *from, clod_state *state, clod_status *status)
{
    clod_row_column columns[CLOD_ROW_COLUMNS + 1];
    int count = columns_of(state, columns);
    size_t record = columns[0].size;
    for (int k = 1; k < count; k++) {
        record += columns[k].size;
    }
    const size_t rows = from->count / record;
    CLOD_ASSERT(rows * record == from->count);
    if (!clod_records_reserve(state, state->grains.count + rows, status)) {
        return false;
    }
    count = columns_of(state, columns); // the rows may lie elsewhere
    const char *at = from->data;
    for (size_t g = state->grains.count; g < state->grains.count + rows; g++) {
        for (int k = 0; k < count; k++) {
            memcpy(columns[k].array + g * columns[k].stride, at, columns[k].size);
            at += columns[k].size;
        }
    }
    state->grains.count += rows;
    return true;
}

const char *clod_records_get_grain(const char *at, clod_state *state, size_t row)
{
    clod_row_column columns[CLOD_ROW_COLUMNS + 1];
    const int count = columns_of(state, columns);
    for (int k = 0; k < count; k++) {
        memcpy(columns[k].array + row * columns[k].stride, at, columns[k].size);
        at += columns[k].size;
    }
    return at;
}

/** A contact on its way. */
typedef struct contact_record {
    uint64_t id[2]; ///< of the grains; of a wall its number
    int64_t shape;
    double history[CLOD_HISTORY_NUMBERS];
} contact_record;

_Static_assert(sizeof(contact_record) == CLOD_RECORDS_CONTACT, "a record has no gaps");

void clod_records_put_known(clod_bytes *to, const clod_contact *contact,
                            const uint64_t partners[2])
{
    contact_record record = {{partners[0], partners[1]}, contact->shape, {0.0}};
    memcpy(record.history, contact->history, sizeof record.history);
    clod_bytes_put(to, &record, sizeof record);
}

void clod_records_put_contact(clod_bytes *to, const clod_grains *grains,
                              const clod_contact *contact)
{
    const bool pair = contact->shape < 0;
    const uint64_t partners[2] = {
        grains->id[contact->i], pair ? grains->id[contact->j] : (uint64_t)(uint32_t)contact->j};
    clod_records_put_known(to, contact, partners);
}

void clod_records_get_contact(const char *at, clod_contact *contact, uint64_t partners[2])
{
    contact_record record;
    memcpy(&record, at, sizeof record);
    *contact = (clod_contact){.i = -1, .j = -1, .shape = (int32_t)record.shape};
    memcpy(contact->history, record.history, sizeof record.history);
    memcpy(partners, record.id, sizeof record.id);
}

/** Records of pairs, or of walls, behind the contacts that are there. */
static void get_list(const clod_bytes *from, bool walls, const clod_ids *rows,
                     clod_state *state, clod_separated *separated)
{
    for (size_t at = 0; at < from->count; at += sizeof(contact_record)) {
        contact_record record;
        memcpy(&record, from->data + at, sizeof record);
        if ((record.shape >= 0) != walls) {
            continue;
        }
        const int64_t i = clod_ids_row(rows, record.id[0]);
        const int64_t j = walls ? (int64_t)record.id[1] : clod_ids_row(rows, record.id[1]);
        if (i < 0 || j < 0) {
            *separated = (clod_separated){true, record.id[0]};
            continue;
        }
        clod_contact *contact = &state->contacts[state->contact_count++];
        *contact = (clod_contact){(int32_t)i, (int32_t)j, (int32_t)record.shape, {0.0}};
        memcpy(contact->history, record.history, sizeof record.history);
        state->wall_contact_count += walls;
    }
}

bool clod_records_get_contacts(const clod_bytes *from, clod_state *state,
                               clod_separated *separated, clod_status *status)
{
    const size_t count = from->count / sizeof(contact_record);
    CLOD_ASSERT(count * sizeof(contact_record) == from->count);
    clod_ids rows = {0};
    *separated = (clod_separated){0};
    state->contact_count = state->wall_contact_count = 0;
    if (!clod_limits_contacts(count, status) ||
        !clod_ids_init(&rows, state->grains.id, state->grains.count, status)) {
        return false;
    }
    const bool room = clod_room_for(&state->contacts, &state->contact_capacity, count,
                                    sizeof *state->contacts);
    if (room) {
        get_list(from, false, &rows, state, separated);
        get_list(from, true, &rows, state, separated);
    } else {
        clod_status_fail(status, CLOD_FAILED, "no memory for %zu contacts", count);
    }
    clod_ids_fini(&rows);
    return room;
}
