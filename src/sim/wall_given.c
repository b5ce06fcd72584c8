#include "sim/wall_given.h"

#include <stdio.h>

#include "config/check.h"
#include "config/range.h"

/** Along z where there is none. */
static void default_direction(double direction[3], double z)
{
    if (direction[0] == 0.0 && direction[1] == 0.0 && direction[2] == 0.0) {
        direction[2] = z;
    }
}

clod_case_wall clod_wall_given_directions(const clod_case_wall *wall)
{
    clod_case_wall given = *wall;
    default_direction(given.spin_axis, 1.0);
    default_direction(given.load_axis, -1.0);
    default_direction(given.oscillation.direction, 1.0);
    return given;
}

bool clod_wall_given_holds(const clod_case_wall *wall, const char *function,
                           clod_status *status)
{
    if (wall->load != CLOD_LOAD_NONE && wall->load != CLOD_LOAD_FORCE &&
        wall->load != CLOD_LOAD_STRESS) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: '%s' has a load of kind %d; give CLOD_LOAD_NONE, "
                                "CLOD_LOAD_FORCE or CLOD_LOAD_STRESS",
                                function, wall->name, wall->load);
    }
    char what[160];
    snprintf(what, sizeof what, "%s: the wall '%s'", function, wall->name);
    if (!clod_range_holds(&CLOD_TABLE_WALL, wall, what, status)) {
        return false;
    }
    const clod_case_oscillation *o = &wall->oscillation;
    if (o->frequency != 0.0 && o->amplitude == 0.0 && o->angle == 0.0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: '%s' oscillates with %g Hz, but has neither an amplitude "
                                "nor an angle; give one of them or both",
                                function, wall->name, o->frequency);
    }
    return o->frequency == 0.0 || clod_check_sways_across(wall) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: '%s' oscillates along the axis of its load, along which the "
                            "load alone moves the wall; give a direction across it",
                            function, wall->name);
}
