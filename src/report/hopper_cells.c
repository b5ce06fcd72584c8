#include "report/hopper_cells.h"

#include <math.h>

#include "output/series.h"
#include "report/html.h"

const int CLOD_HOPPER_CELLS_SHAPES[CLOD_HOPPER_SHAPES] = {CLOD_RADIAL_CONE, CLOD_RADIAL_WEDGE};

const clod_hopper_field CLOD_HOPPER_CELLS_HOLES[CLOD_HOPPER_HOLES] = {
    [CLOD_HOPPER_EMPTYING] = {"emptying_m", "diameter, emptying (least)", "mm", 1e3, 1.0, 1,
                              NULL},
    [CLOD_HOPPER_FILLING] = {"filling_m", "diameter, after filling (most)", "mm", 1e3, 1.0, 1,
                             NULL},
};

const char *clod_hopper_cells_shape(int shape)
{
    return shape == CLOD_RADIAL_CONE ? "Cone, round outlet"
                                     : "Wedge, slot at least 3 times as long";
}

void clod_hopper_cells_text(char text[48], const clod_hopper_field *how, double value)
{
    if (isnan(value)) {
        snprintf(text, 48, "-");
    } else if (isinf(value)) {
        snprintf(text, 48, "%s", how->zero != NULL ? how->zero : "infinite");
    } else if (value == 0.0 && how->zero != NULL) {
        snprintf(text, 48, "%s", how->zero);
    } else {
        snprintf(text, 48, "%.*f", how->digits, how->scale * value);
    }
}

void clod_hopper_cells_begin(FILE *out, const char *tag, const clod_hopper_field *how,
                             double value)
{
    char full[CLOD_SERIES_NUMBER];
    if (isfinite(value)) {
        clod_series_number(full, how->json * value);
        fprintf(out, "<%s title=\"%s\">", tag, full);
    } else {
        fprintf(out, "<%s>", tag);
    }
}

void clod_hopper_cells_put(FILE *out, const clod_hopper_field *how, double value)
{
    char text[48];
    clod_hopper_cells_text(text, how, value);
    clod_hopper_cells_begin(out, "td", how, value);
    fprintf(out, "%s</td>", text);
}

const clod_hopper_property *clod_hopper_cells_value(const clod_hopper_case *from, int curve)
{
    const clod_hopper_property *const PROPERTY[CLOD_SOLID_CURVES] = {
        [CLOD_SOLID_PHI_E] = &from->phi_e,
        [CLOD_SOLID_PHI_T] = &from->phi_t,
        [CLOD_SOLID_RHO] = &from->rho,
        [CLOD_SOLID_WALL] = &from->wall};
    const clod_hopper_property *property = PROPERTY[curve];
    return property != NULL && property->present && property->file == NULL ? property : NULL;
}
