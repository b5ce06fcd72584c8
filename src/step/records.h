#pragma once
/**
 * @file records.h
 * Grains and contacts as bytes that another rank, of the same program, unpacks: a grain with all
 * its columns and its place at the last rebuild, a contact by the ids of its grains.
 *
 * Threads  one per buffer.   Test  tests/step/test_ranks.c
 */

#include "base/bytes.h"
#include "state/state.h"

/** Room for so many rows, those of the last rebuild too; what is there stays. False without
 *  memory. */
bool clod_records_reserve(clod_state *state, size_t rows, clod_status *status);

/** Append a grain. */
void clod_records_put_grain(clod_bytes *to, const clod_state *state, size_t row);

/** Append a contact; `grains` are those of its rows. */
void clod_records_put_contact(clod_bytes *to, const clod_grains *grains,
                              const clod_contact *contact);

/** The same of one whose rows are not known, but its partners: ids of both grains, or of the grain and
 *  the number of its wall. */
void clod_records_put_known(clod_bytes *to, const clod_contact *contact,
                            const uint64_t partners[2]);

/** Grains behind those that the state has; both must keep the same columns. False without memory. */
bool clod_records_get_grains(const clod_bytes *from, clod_state *state, clod_status *status);

/** A record of a grain into a row of a state that has room for it; where the next one begins. */
const char *clod_records_get_grain(const char *at, clod_state *state, size_t row);

/** Bytes of the record of a contact. */
#define CLOD_RECORDS_CONTACT (3 * sizeof(uint64_t) + CLOD_HISTORY_NUMBERS * sizeof(double))

/** A record of a contact: its rows are not known, but the ids of its grains, or of its grain and the
 *  number of its wall. */
void clod_records_get_contact(const char *at, clod_contact *contact, uint64_t partners[2]);

/** Whether a contact has come without one of its grains: then these are far from each other. */
typedef struct clod_separated {
    bool any;
    uint64_t id; ///< of its first grain
} clod_separated;

/**
 * Contacts in place of those that the state has, with its rows; pairs before walls, otherwise in
 * the order of the records, each met as its first grain meets its second.
 *
 * @param separated  [out] contacts without one of their grains are left out
 * @return      false without memory
 */
bool clod_records_get_contacts(const clod_bytes *from, clod_state *state,
                               clod_separated *separated, clod_status *status);
