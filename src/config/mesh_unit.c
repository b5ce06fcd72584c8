/**
 * @file mesh_unit.c
 * Lengths on the command line: the unit of a mesh file, the radius of a grain.
 */

#include <math.h>

#include "base/given.h"
#include "clod/mesh.h"
#include "config/unit.h"

bool clod_mesh_unit(const char *text, double *metres, clod_status *status)
{
    if (!CLOD_GIVEN(text, status) || !CLOD_GIVEN(metres, status)) {
        return false;
    }
    char message[CLOD_UNIT_MESSAGE];
    double value = 1.0;
    const char *unit = clod_unit_number(text, &value);
    if (unit == NULL) {
        unit = text;
        value = 1.0;
    }
    if (!clod_unit_convert(unit, "m", &value, message)) {
        return clod_status_fail(status, CLOD_USAGE, "%s: %s", text, message);
    }
    if (!(value > 0.0) || !isfinite(value)) {
        return clod_status_fail(status, CLOD_USAGE, "%s: a length above 0 is expected", text);
    }
    *metres = value;
    return true;
}
