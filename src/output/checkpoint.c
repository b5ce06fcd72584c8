#include "output/checkpoint.h"

#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/version.h"
#include "output/checkpoint_columns.h"
#include "output/checkpoint_contacts.h"
#include "output/checkpoint_file.h"
#include "output/checkpoint_give.h"
#include "output/checkpoint_rows.h"
#include "output/checkpoint_walls.h"
#include "output/folder_files.h"
#include "output/hdf.h"
#include "state/limits.h"

static clod_hdf_column part_column(const clod_checkpoint_part *part, char name[NAME_MAX])
{
    snprintf(name, NAME_MAX, "parts/%s", part->name);
    return (clod_hdf_column){.name = name,
                             .type = CLOD_HDF_U8,
                             .components = 1,
                             .rows = part->size,
                             .data = part->data,
                             .stride = 1};
}

static void put_columns(clod_hdf *hdf, const clod_state *state)
{
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_list(&columns, state);
    clod_checkpoint_columns_put(&columns, hdf);
}

static void put_attributes(clod_hdf *hdf, const clod_state *state)
{
    const int64_t format = CLOD_CHECKPOINT_FORMAT;
    clod_hdf_put_ints(hdf, "/", "clod_checkpoint_format", &format, 1);
    clod_hdf_put_text(hdf, "/", "clod_version", clod_version_text());
    clod_hdf_put_ints(hdf, "/", "step", &state->step, 1);
    clod_hdf_put_real(hdf, "/", "time_s", state->time);
}

static void put_parts(clod_hdf *hdf, const clod_checkpoint_part *parts, size_t part_count)
{
    for (size_t p = 0; p < part_count; p++) {
        char name[NAME_MAX];
        const clod_hdf_column part = part_column(&parts[p], name);
        clod_hdf_put(hdf, &part);
    }
}

static void put_case(clod_hdf *hdf, const char *case_text)
{
    if (case_text != NULL && case_text[0] != '\0') {
        const size_t length = strlen(case_text);
        const clod_hdf_column text = {.name = "case",
                                      .type = CLOD_HDF_TEXT,
                                      .components = length,
                                      .rows = 1,
                                      .data = case_text,
                                      .stride = length};
        clod_hdf_put(hdf, &text);
    }
}

/** Everything that changes in a run but the rows of grains and contacts, which get their places; the bed has
 *  begun. */
static bool put_state(clod_hdf *hdf, const clod_state *state, const clod_bed_source *bed,
                      clod_bed_layout *layout, clod_status *status)
{
    put_attributes(hdf, state);
    put_columns(hdf, state);
    return clod_checkpoint_rows_reserve(hdf, state, bed, layout, status) &&
           clod_checkpoint_walls_put(hdf, &state->walls, status);
}

/** What a checkpoint has beside a state. */
typedef struct beside {
    const clod_checkpoint_part *parts;
    size_t part_count;
    const char *case_text;
} beside;

/** Fill a draft with all but its head. */
static bool fill(const clod_folder_draft *draft, const clod_state *state,
                 const clod_bed_source *bed, const beside *more, uint64_t *bytes,
                 clod_status *status)
{
    clod_bed_layout layout = {.grain_columns = 0};
    const clod_hdf_place place = {draft->folder, draft->name, draft->descriptor,
                                  CLOD_CHECKPOINT_HEAD_BYTES};
    clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_EXACT, status);
    if (hdf == NULL) {
        return false;
    }
    bool good = bed->begin(bed->context, (clod_bed_wants){0}, &layout.all, status) &&
                put_state(hdf, state, bed, &layout, status);
    put_parts(hdf, more->parts, more->part_count);
    put_case(hdf, more->case_text);
    clod_status finishing; // an error before it is the one to tell
    good = clod_hdf_finish(&hdf, bytes, good ? status : &finishing) && good;
    good = good && clod_checkpoint_rows_write(draft, bed, &layout, status);
    bed->end(bed->context);
    return good;
}

bool clod_checkpoint_write(const clod_folder *folder, const char *stem, const clod_state *state,
                           const clod_bed_source *bed, const clod_checkpoint_part *parts,
                           size_t part_count, const char *case_text, clod_status *status)
{
    clod_checkpoint_file files[2];
    clod_bed_view view;
    const clod_bed_source own = clod_bed_source_of(&view, state, NULL);
    bed = bed != NULL ? bed : &own;
    const bool found = clod_checkpoint_file_find(files, folder, stem, false, bed, status);
    clod_checkpoint_file_release(files);
    if (!found) {
        return false;
    }
    const int last = clod_checkpoint_file_newest(files);
    const int target = last == -1 ? 0 : 1 - last;
    clod_folder_draft draft;
    if (!clod_folder_draft_begin(&draft, folder, files[target].name, status)) {
        return false;
    }
    clod_checkpoint_head head = {
        .format = CLOD_CHECKPOINT_FORMAT,
        .sequence = last == -1 ? 1 : files[last].head.sequence + 1,
        .step = state->step,
        .time = state->time,
        .case_hash = clod_checkpoint_file_case_hash(case_text),
    };
    const beside more = {parts, part_count, case_text};
    const bool good = fill(&draft, state, bed, &more, &head.bytes, status) &&
                      clod_checkpoint_file_seal(&draft, &head, bed, status);
    return clod_folder_draft_end(&draft, good, status);
}

/** Forget what is not in the file, and make room for what there is of walls. */
static bool make_room(clod_hdf *hdf, clod_state *state, clod_status *status)
{
    clod_memory_free(state->build_position);
    clod_memory_free(state->build_walls);
    clod_memory_free(state->contacts);
    state->build_position = NULL;
    state->build_walls = NULL;
    state->contacts = NULL;
    state->grains.count = 0;
    state->contact_count = state->contact_capacity = state->wall_contact_count = 0;
    state->planes = (clod_planes){0};
    const size_t planes = clod_hdf_rows(hdf, CLOD_CHECKPOINT_PLANES);
    state->planes.count = (int32_t)(planes < CLOD_PLANES ? planes : CLOD_PLANES);
    if (clod_hdf_rows(hdf, "walls/build_angle") > 0) { // without grains: no rows
        state->build_walls =
            clod_memory_alloc((size_t)state->walls.count, sizeof *state->build_walls);
        if (state->build_walls == NULL) {
            return clod_status_fail(status, CLOD_FAILED, "No memory for %d walls.",
                                    (int)state->walls.count);
        }
    }
    return clod_hdf_rows(hdf, "grains/clump_since") == 0 ||
           clod_grains_keep_clumps(&state->grains, status);
}

/** Make room for the rows of the file and set the counts. */
static bool make_rows(clod_hdf *hdf, clod_state *state, clod_status *status)
{
    const size_t grains = clod_hdf_rows(hdf, "grains/id");
    const size_t contacts = clod_hdf_rows(hdf, "contacts/shape");
    if (!clod_limits_contacts(contacts, status) ||
        !clod_grains_reserve(&state->grains, grains, status)) {
        return false;
    }
    state->grains.count = grains;
    state->contact_count = contacts;
    state->contact_capacity = contacts;
    bool good = true;
    if (state->build_walls != NULL || clod_hdf_rows(hdf, "grains/build_position") > 0) {
        good = clod_state_reserve_build(state);
    }
    if (contacts > 0) {
        state->contacts = clod_memory_alloc(contacts, sizeof *state->contacts);
        good = good && state->contacts != NULL;
    }
    return good || clod_status_fail(status, CLOD_FAILED,
                                    "No memory for a checkpoint of %zu grains.", grains);
}

/** Read every column and part but those of grains and contacts. */
static void get_columns(clod_hdf *hdf, const clod_state *state,
                        const clod_checkpoint_wanted *wanted)
{
    clod_checkpoint_columns columns;
    clod_checkpoint_columns_list(&columns, state);
    clod_checkpoint_columns_get(&columns, hdf);
    for (size_t p = 0; p < wanted->part_count; p++) {
        char name[NAME_MAX];
        const clod_hdf_column part = part_column(&wanted->parts[p], name);
        clod_hdf_get(hdf, &part);
    }
}

/** Read grains and contacts into the state. */
static bool get_bed(clod_hdf *hdf, clod_state *state, const char *path, clod_status *status)
{
    clod_checkpoint_columns columns;
    if (!make_rows(hdf, state, status)) {
        return false;
    }
    clod_checkpoint_columns_of_grains(&columns, state);
    clod_checkpoint_columns_get(&columns, hdf);
    return clod_checkpoint_contacts_get(hdf, state, path, status);
}

/** Grains and contacts, to who takes them, or into the state. */
static bool get_or_give(clod_hdf *hdf, clod_state *state, const clod_bed_taker *taker,
                        const char *path, clod_status *status)
{
    bool takes = false;
    if (taker != NULL && !clod_hdf_has_failed(hdf) &&
        !taker->begin(taker->context, state, clod_hdf_rows(hdf, "grains/id"), &takes, status)) {
        return false;
    }
    return takes ? clod_checkpoint_give(hdf, state, taker, path, status)
                 : get_bed(hdf, state, path, status);
}

/** End reading; false, with what was wrong. */
static bool end_reading(clod_hdf **hdf, const char *path, clod_status *status)
{
    const bool outside = clod_hdf_fails_outside(*hdf);
    clod_status reading;
    if (clod_hdf_end_reading(hdf, &reading)) {
        return true;
    }
    if (outside) {
        *status = reading;
        return false;
    }
    return clod_status_fail(status, CLOD_FAILED,
                            "%s is whole but does not hold what this clod needs: %s Start over "
                            "with --fresh.",
                            path, reading.text);
}

/** Fill state and parts from a whole file. */
static bool restore(const clod_folder *folder, const clod_checkpoint_file *file,
                    clod_state *state, const clod_checkpoint_wanted *wanted,
                    clod_status *status)
{
    const clod_hdf_place place = {folder, file->name, file->descriptor,
                                  CLOD_CHECKPOINT_HEAD_BYTES};
    clod_hdf *hdf = clod_hdf_open(&place, file->head.bytes, status);
    if (hdf == NULL) {
        return false;
    }
    bool good = clod_checkpoint_walls_get(hdf, &state->walls, file->path, status) &&
                make_room(hdf, state, status);
    if (good) {
        get_columns(hdf, state, wanted);
        good = get_or_give(hdf, state, wanted->taker, file->path, status);
    }
    if (good) {
        clod_grains_pad(&state->grains);
    }
    clod_status reading;
    const bool read = end_reading(&hdf, file->path, &reading);
    if (!read) { // what could not be read looks different
        *status = reading;
    }
    return good && read;
}

/** Say why neither file can be used. */
static bool fail_without(const clod_checkpoint_file files[2], clod_status *status)
{
    if (!files[0].there && !files[1].there) {
        return clod_status_fail(status, CLOD_FAILED,
                                "There is no checkpoint to go on from: neither %s nor %s is "
                                "there. Start over with --fresh.",
                                files[0].path, files[1].path);
    }
    char texts[2][sizeof files[0].path + sizeof files[0].reason + 32] = {"", ""};
    for (int f = 0; f < 2; f++) {
        if (files[f].there) {
            snprintf(texts[f], sizeof texts[f], "%s cannot be used: %s.\n", files[f].path,
                     files[f].reason);
        }
    }
    return clod_status_fail(status, CLOD_FAILED,
                            "%s%sThere is no other checkpoint to go on from. Start over with "
                            "--fresh.",
                            texts[0], texts[1]);
}

/** Whether the newest whole file belongs to this program and this case. */
static bool check_origin(const clod_checkpoint_file *file, const char *case_text,
                         clod_status *status)
{
    if (file->head.format != CLOD_CHECKPOINT_FORMAT) {
        return clod_status_fail(status, CLOD_FAILED,
                                "%s has checkpoint format %" PRId64 ", this clod reads format "
                                "%d. Go on with the clod that wrote it, or start over with "
                                "--fresh.",
                                file->path, file->head.format, CLOD_CHECKPOINT_FORMAT);
    }
    if (case_text != NULL &&
        clod_checkpoint_file_case_hash(case_text) != file->head.case_hash) {
        return clod_status_fail(status, CLOD_USAGE,
                                "The case has changed since %s was written (step %" PRId64
                                ", time %.9g s); a run cannot go on with another case. Write "
                                "to another folder with -o, or start over with --fresh.",
                                file->path, file->head.step, file->head.time);
    }
    return true;
}

bool clod_checkpoint_get(const clod_folder *folder, const char *stem, clod_state *state,
                         const clod_checkpoint_wanted *wanted, char *notice, size_t notice_size,
                         clod_status *status)
{
    if (notice_size > 0) {
        notice[0] = '\0';
    }
    clod_checkpoint_file files[2];
    if (!clod_checkpoint_file_find(files, folder, stem, true, NULL, status)) {
        clod_checkpoint_file_release(files);
        return false;
    }
    const int last = clod_checkpoint_file_newest(files);
    bool done = false;
    if (last == -1) {
        fail_without(files, status);
    } else if (check_origin(&files[last], wanted->case_text, status)) {
        done = restore(folder, &files[last], state, wanted, status);
    }
    const clod_checkpoint_file *bad = &files[1 - (last == -1 ? 0 : last)];
    if (done && bad->there && !bad->whole) {
        snprintf(notice, notice_size,
                 "%s cannot be used: %s. Going on from %s, step %" PRId64 ", time %.9g s.",
                 bad->path, bad->reason, files[last].path, files[last].head.step,
                 files[last].head.time);
    }
    clod_checkpoint_file_release(files);
    return done;
}

// two more parameters than usual, all of them its own:
// NOLINTNEXTLINE(readability-function-size)
bool clod_checkpoint_read(const clod_folder *folder, const char *stem, clod_state *state,
                          clod_checkpoint_part *parts, size_t part_count, const char *case_text,
                          char *notice, size_t notice_size, clod_status *status)
{
    const clod_checkpoint_wanted wanted = {
        .parts = parts, .part_count = part_count, .case_text = case_text};
    return clod_checkpoint_get(folder, stem, state, &wanted, notice, notice_size, status);
}
