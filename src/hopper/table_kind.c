#include "hopper/table_kind.h"

#include <stdint.h>

#include "analysis/measured_header.h"
#include "base/input.h"
#include "base/memory.h"

/** Kinds of tables, and the keys that they belong to. */
static const struct {
    const char *what, *key;
} KINDS[] = {
    [CLOD_MEASURED_OF_SHEAR] = {"shear points (sigma_pre, tau_pre, sigma_sh, tau_sh)",
                                "flow_function.shear_tests"},
    [CLOD_MEASURED_OF_WALL] = {"wall friction (sigma_w, tau_w)", "wall_friction.file"},
    [CLOD_MEASURED_OF_SIGMA_1] = {"a flow function or bulk densities (sigma_1)",
                                  "flow_function.file or bulk_density.file"},
};

/** @param path  NULL: the key is not given */
static bool is_of(const char *path, const char *key, clod_measured_stress takes,
                  const char *text, clod_status *status)
{
    char *table;
    size_t length;
    clod_status ignored = {0};
    if (path == NULL || !clod_input_read_regular(path, SIZE_MAX, &table, &length, &ignored)) {
        return true;
    }
    const clod_measured_stress found = clod_measured_stress_of(table, length);
    clod_memory_free(table);
    return found == CLOD_MEASURED_OF_NONE || found == takes ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: is a table of %s, which belongs in %s; %s takes %s.", path,
                            KINDS[found].what, KINDS[found].key, key, text);
}

bool clod_table_kind_check(const clod_hopper_case *from, clod_status *status)
{
    const char *shear = KINDS[CLOD_MEASURED_OF_SHEAR].what;
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
                 KINDS[CLOD_MEASURED_OF_WALL].what, status) &&
           is_of(from->phi_e.file, "effective_friction.file", CLOD_MEASURED_OF_SIGMA_1,
                 "sigma_1 and phi_e", status) &&
           is_of(from->phi_t.file, "static_friction.file", CLOD_MEASURED_OF_SIGMA_1,
                 "sigma_1 and phi_t", status) &&
           is_of(from->rho.file, "bulk_density.file", CLOD_MEASURED_OF_SIGMA_1,
                 "sigma_1 and rho_b", status);
}
