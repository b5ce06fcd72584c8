#include "setup/begin.h"

#include "setup/jenike_cell.h"
#include "setup/ring_cell.h"
#include "setup/state.h"
#include "setup/uniaxial_cell.h"

bool clod_begin_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status)
{
    if (from->ring_shear.present) {
        return clod_setup_ring_cell(from, seed, state, status);
    }
    if (from->jenike.present) {
        return clod_setup_jenike_cell(from, seed, state, status);
    }
    if (from->uniaxial.present) {
        return clod_setup_uniaxial_cell(from, seed, state, status);
    }
    return clod_setup_state(from, seed, state, status);
}
