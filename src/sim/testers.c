#include "sim/testers.h"

#include "base/assert.h"
#include "sim/free_run.h"
#include "sim/ring_run.h"
#include "sim/uniaxial_run.h"
#include "sim/wall_shear_run.h"

static const clod_tester_row ROWS[CLOD_CASE_KINDS] = {
    [CLOD_CASE_FREE] = {.run = clod_free_run,
                        .try_origin = clod_free_try_origin,
                        .first = &CLOD_FREE_TRIAL,
                        .batches = clod_check_free_batches},
    [CLOD_CASE_RING_SHEAR] = {.run = clod_ring_run,
                              .try_origin = clod_ring_try_origin,
                              .first = &CLOD_RING_TESTER,
                              .cell = clod_shear_cell_ring,
                              .look = clod_check_shear_look,
                              .batches = clod_check_shear_batches,
                              .warn = clod_check_ring_warn,
                              .stress = "preshear stress",
                              .write = clod_check_ring_write,
                              .put = clod_check_ring_put},
    [CLOD_CASE_JENIKE] = {.run = clod_ring_run,
                          .try_origin = clod_ring_try_origin,
                          .first = &CLOD_RING_TESTER,
                          .cell = clod_shear_cell_jenike,
                          .look = clod_check_shear_look,
                          .batches = clod_check_shear_batches,
                          .warn = clod_check_jenike_warn,
                          .stress = "preshear stress",
                          .write = clod_check_jenike_write,
                          .put = clod_check_shear_put},
    [CLOD_CASE_UNIAXIAL] = {.run = clod_uniaxial_run,
                            .try_origin = clod_uniaxial_try_origin,
                            .first = &CLOD_UNIAXIAL_TESTER,
                            .look = clod_check_uniaxial_look,
                            .batches = clod_check_uniaxial_batches,
                            .warn = clod_check_uniaxial_warn,
                            .stress = "largest stress",
                            .write = clod_check_uniaxial_write,
                            .put = clod_check_uniaxial_put},
    [CLOD_CASE_WALL_FRICTION] = {.run = clod_wall_shear_run,
                                 .try_origin = clod_wall_shear_try_origin,
                                 .first = &CLOD_WALL_SHEAR_TESTER,
                                 .look = clod_check_wall_look,
                                 .batches = clod_check_wall_batches,
                                 .warn = clod_check_wall_warn,
                                 .stress = "largest wall normal stress",
                                 .write = clod_check_wall_write,
                                 .put = clod_check_wall_put},
    [CLOD_CASE_CONTACT_BENCH] = {.run = NULL}, // clod contact runs it
};

const clod_tester_row *clod_testers_row(clod_case_kind kind)
{
    CLOD_ASSERT((unsigned)kind < CLOD_CASE_KINDS);
    return &ROWS[kind];
}

const clod_tester_row *clod_testers_of(const clod_case *from)
{
    return clod_testers_row(clod_case_kind_of(from));
}
