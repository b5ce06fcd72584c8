#include "setup/planes.h"

#include "base/vec3.h"
#include "setup/domain.h"

_Static_assert(CLOD_PLANES == CLOD_CASE_GAUGES, "every gauge may have a plane");

int clod_setup_planes_number(const clod_case *from, const clod_case_gauge *gauge)
{
    int number = 0;
    for (const clod_case_gauge *other = from->gauges; other < gauge; other++) {
        number += other->has_plane;
    }
    return gauge->has_plane ? number : -1;
}

void clod_setup_planes(const clod_case *from, clod_state *state)
{
    clod_planes *planes = &state->planes;
    *planes = (clod_planes){0};
    for (size_t k = 0; k < from->gauge_count; k++) { // so many were checked at load
        const clod_case_gauge *gauge = &from->gauges[k];
        if (gauge->has_plane) {
            const int axis = clod_vec3_nearest_axis(gauge->direction);
            planes->plane[planes->count++] =
                (clod_plane){.region = clod_setup_domain_region(&gauge->region),
                             .at = gauge->plane_at,
                             .axis = axis,
                             .sign = gauge->direction[axis] < 0.0 ? -1 : 1};
        }
    }
}
