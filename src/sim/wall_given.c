#include "sim/wall_given.h"

#include <math.h>

#include "config/check.h"

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

static bool is_from_zero(double number)
{
    return number >= 0.0 && isfinite(number);
}

static bool is_finite(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

bool clod_wall_given_load(const clod_case_wall *wall, const char *function, clod_status *status)
{
    if (wall->load == CLOD_LOAD_NONE) {
        return true;
    }
    if (wall->load != CLOD_LOAD_FORCE && wall->load != CLOD_LOAD_STRESS) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: '%s' has a load of kind %d; give CLOD_LOAD_NONE, "
                                "CLOD_LOAD_FORCE or CLOD_LOAD_STRESS",
                                function, wall->name, wall->load);
    }
    const bool is_force = wall->load == CLOD_LOAD_FORCE;
    const double push = is_force ? wall->force : wall->stress;
    const bool good = is_from_zero(push) && is_from_zero(wall->area) &&
                      is_from_zero(wall->damping) && is_from_zero(wall->mass) &&
                      wall->mass > 0.0 && is_finite(wall->load_axis);
    return good ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: '%s' has a load of %g %s along (%g, %g, %g), area %g m2, "
                            "damping %g, mass %g kg; give finite numbers, none below 0, and a "
                            "mass above 0",
                            function, wall->name, push, is_force ? "N" : "Pa",
                            wall->load_axis[0], wall->load_axis[1], wall->load_axis[2],
                            wall->area, wall->damping, wall->mass);
}

bool clod_wall_given_oscillation(const clod_case_wall *wall, const char *function,
                                 clod_status *status)
{
    const clod_case_oscillation *o = &wall->oscillation;
    if (o->frequency == 0.0) {
        return true;
    }
    const bool good = is_from_zero(o->frequency) && is_from_zero(o->amplitude) &&
                      is_from_zero(o->angle) && o->amplitude + o->angle > 0.0 &&
                      isfinite(o->phase) && is_finite(o->direction);
    if (!good) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: '%s' oscillates with %g Hz, amplitude %g m along (%g, %g, %g), angle %g rad, "
            "phase %g rad; give finite numbers, frequency, amplitude and angle not below 0, and "
            "not both of the last 0",
            function, wall->name, o->frequency, o->amplitude, o->direction[0], o->direction[1],
            o->direction[2], o->angle, o->phase);
    }
    return clod_check_sways_across(wall) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: '%s' oscillates along the axis of its load, along which the "
                            "load alone moves the wall; give a direction across it",
                            function, wall->name);
}
