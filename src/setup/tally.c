#include "setup/tally.h"

#include "base/memory.h"

bool clod_setup_tally_init(clod_setup_tally *self, const clod_case *from,
                           const clod_state *state, size_t grains, clod_status *status)
{
    *self = (clod_setup_tally){
        .bed = clod_setup_bed_begin(state, grains),
        .sizes = clod_memory_alloc(from->material_count + 1, sizeof *self->sizes)};
    return self->sizes != NULL ||
           clod_status_fail(status, CLOD_FAILED, "no memory for the time step");
}

void clod_setup_tally_add(clod_setup_tally *self, const clod_state *state, size_t first)
{
    for (size_t g = first; g < state->grains.count; g++) {
        clod_timestep_add(&self->sizes[state->grains.material[g]], 1.0,
                          state->grains.position[g][3]);
    }
    clod_setup_bed_add(&self->bed, state, first);
}

void clod_setup_tally_fini(clod_setup_tally *self)
{
    clod_memory_free(self->sizes);
    *self = (clod_setup_tally){0};
}
