#include "hopper/table_kind.h"

#include "analysis/measured_header.h"

/** Where tables belong. */
static const char *const KEYS[] = {
    [CLOD_MEASURED_OF_SHEAR] = "flow_function.shear_tests",
    [CLOD_MEASURED_OF_WALL] = "wall_friction.file",
    [CLOD_MEASURED_OF_SIGMA_1] = "flow_function.file or bulk_density.file",
    [CLOD_MEASURED_OF_REPOSE] = "a target of clod calibrate",
};

/** @param path  NULL: the key is not given */
static bool is_of(const char *path, const char *key, clod_measured_stress takes,
                  const char *text, clod_status *status)
{
    const clod_measured_stress found =
        path != NULL ? clod_measured_stress_in(path) : CLOD_MEASURED_OF_NONE;
    if (!clod_measured_header_check(path, found, status)) {
        return false;
    }
    return found == CLOD_MEASURED_OF_NONE || found == takes ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: is a table of %s, which belongs in %s; %s takes %s.", path,
                            CLOD_MEASURED_STRESS_NAMES[found], KEYS[found], key, text);
}

bool clod_table_kind_check(const clod_hopper_case *from, clod_status *status)
{
    const char *shear = CLOD_MEASURED_STRESS_NAMES[CLOD_MEASURED_OF_SHEAR];
    for (size_t k = 0; k < from->strength.test_count; k++) {
        if (!is_of(from->strength.tests[k].points, "flow_function.shear_tests",
                   CLOD_MEASURED_OF_SHEAR, shear, status)) {
            return false;
        }
    }
    return is_of(from->strength.file, "flow_function.file", CLOD_MEASURED_OF_SIGMA_1,
                 "a flow function (sigma_1, f_c)", status) &&
           is_of(from->strength.after_storage, "flow_function.after_storage",
                 CLOD_MEASURED_OF_SIGMA_1, "a flow function (sigma_1, f_c)", status) &&
           is_of(from->wall.file, "wall_friction.file", CLOD_MEASURED_OF_WALL,
                 CLOD_MEASURED_STRESS_NAMES[CLOD_MEASURED_OF_WALL], status) &&
           is_of(from->phi_e.file, "effective_friction.file", CLOD_MEASURED_OF_SIGMA_1,
                 "sigma_1 and phi_e", status) &&
           is_of(from->phi_t.file, "static_friction.file", CLOD_MEASURED_OF_SIGMA_1,
                 "sigma_1 and phi_t", status) &&
           is_of(from->rho.file, "bulk_density.file", CLOD_MEASURED_OF_SIGMA_1,
                 "sigma_1 and rho_b", status);
}
