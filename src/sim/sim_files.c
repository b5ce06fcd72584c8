// Checkpoints and snapshots of a simulation, in the formats of a run.
#include "base/memory.h"
#include "output/checkpoint.h"
#include "output/folder.h"
#include "output/snapshot.h"
#include "sim/identity.h"
#include "sim/job_store.h"
#include "sim/sim.h"

/** Text to which the checkpoints of a case belong; owned, NULL after a failure. */
static char *make_identity(const clod_case *from, clod_status *status)
{
    char *complete = clod_identity_complete(from, status);
    if (complete == NULL) {
        return NULL;
    }
    char *identity = clod_identity_text(complete);
    clod_memory_free(complete);
    if (identity == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for the text of the case");
    }
    return identity;
}

bool clod_sim_write_checkpoint(clod_sim *self, const char *folder, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(folder, status) ||
        !clod_sim_settle(self, status)) {
        return false;
    }
    clod_step_bed view;
    const clod_bed_source bed = clod_step_bed_source(&self->step, &view);
    const clod_checkpoint_part measures = {"measures", self->measures, self->measures_size};
    const size_t count = self->measures != NULL;
    char *identity = make_identity(self->from, status);
    clod_folder *open = identity != NULL ? clod_folder_open(folder, status) : NULL;
    const bool ok = open != NULL && clod_checkpoint_write(open, "restart", &self->state, &bed,
                                                          &measures, count, identity, status);
    clod_folder_close(&open);
    clod_memory_free(identity);
    return ok;
}

/** Whether every mesh of a state has its facets, which are not in checkpoints. */
static bool has_meshes(const clod_state *state, clod_status *status)
{
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            if (clod_shape_lacks_facets(&wall->shapes[s])) {
                return clod_status_fail(status, CLOD_USAGE,
                                        "the checkpoint has the mesh of wall '%s', which this "
                                        "simulation has not: it was removed. Read it into a "
                                        "new simulation of the case",
                                        wall->name);
            }
        }
    }
    return true;
}

/** Fill an empty state from a checkpoint of the same case; meshes are those of `self`.
 *  `measures` [measures_size] are filled when the series is open. */
static bool read_state(const clod_sim *self, const char *folder, const char *stem,
                       clod_state *state, void *measures, clod_status *status)
{
    char notice[1024];
    clod_checkpoint_part part = {"measures", measures, self->measures_size};
    const size_t count = self->measures != NULL;
    char *identity = make_identity(self->from, status);
    clod_folder *open = identity != NULL ? clod_folder_look(folder, status) : NULL;
    const bool ok = open != NULL &&
                    clod_walls_copy(&state->walls, &self->state.walls, status) &&
                    clod_checkpoint_read(open, stem, state, &part, count, identity, notice,
                                         sizeof notice, status) &&
                    has_meshes(state, status);
    clod_folder_close(&open);
    clod_memory_free(identity);
    return ok;
}

bool clod_sim_read_checkpoint(clod_sim *self, const char *folder, const char *part,
                              clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(folder, status)) {
        return false;
    }
    char stem[CLOD_JOB_STEM];
    clod_state state = {.build_motion = -1.0};
    clod_job_stem(part != NULL ? part : "run", "", stem);
    void *measures = clod_memory_alloc(1, self->measures_size + 1);
    if (measures == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to read %s", folder);
    }
    if (!read_state(self, folder, stem, &state, measures, status)) {
        clod_memory_free(measures);
        clod_state_fini(&state);
        return false;
    }
    if (self->measures != NULL) {
        memcpy(self->measures, measures, self->measures_size);
    }
    clod_memory_free(measures);
    clod_sim_recall(self);
    self->written = false;
    clod_step_fini(&self->step);
    clod_state_fini(&self->state);
    self->state = state;
    self->row_is_old = true; // it may have other walls
    return clod_sim_take_up(self, status);
}

bool clod_sim_write_snapshot(clod_sim *self, const char *folder, bool contacts,
                             clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(folder, status) ||
        !clod_sim_settle(self, status)) {
        return false;
    }
    clod_step_bed view;
    const clod_bed_source bed = clod_step_bed_source(&self->step, &view);
    clod_folder *open = clod_folder_open(folder, status);
    clod_snapshot_film film = {0};
    const bool ok =
        open != NULL && clod_snapshot_write(open, "run", self->state.step, &self->state, &bed,
                                            contacts, &film, status);
    clod_folder_close(&open);
    return ok;
}
