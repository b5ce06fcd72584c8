#include "state/shape_kinds.h"

#include "base/assert.h"

static const clod_shape_kind_row SHAPES[CLOD_SHAPE_KINDS] = {
    [CLOD_SHAPE_PLANE] = {.endless = true},
    [CLOD_SHAPE_DISC] = {.flat = true},
    [CLOD_SHAPE_ANNULUS] = {.flat = true},
    [CLOD_SHAPE_CYLINDER] = {.shell = true, .straight = true},
    [CLOD_SHAPE_CONE] = {.shell = true},
    [CLOD_SHAPE_BOX] = {.solid = true, .boxed = true},
    [CLOD_SHAPE_BAR] = {.solid = true, .boxed = true},
    [CLOD_SHAPE_MESH] = {.faceted = true, .boxed = true},
    [CLOD_SHAPE_CONVEYOR] = {.faceted = true, .boxed = true, .conveyor = true},
};

const clod_shape_kind_row *clod_shape_kinds_row(clod_shape_kind kind)
{
    CLOD_ASSERT((unsigned)kind < CLOD_SHAPE_KINDS);
    return &SHAPES[kind];
}
