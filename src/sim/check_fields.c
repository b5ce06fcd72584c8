#include "sim/check_fields.h"

#include <math.h>

#include "sim/fields.h"

#define CONTACTS 2.5          ///< contacts for each grain
#define CELL_TIME 0.05e-6     ///< s: a grain or contact and a cell of the cube about its kernel
#define MEAN_TIME 0.05e-6     ///< s: into a mean over a region
#define POINT_BYTES 832.0     ///< sums of a cell during a sample (measure/continuum_sums.c)
#define NUMBER_BYTES 8.0      ///< of a value of a cell
#define CORNERS_ON_DISK 150.0 ///< of a cell's corners and their numbers

/** Seconds of one sample. */
static double sample_time(const clod_case_field *field, double grains)
{
    const double met = grains * (1.0 + CONTACTS);
    return field->cell > 0.0 ? met * CELL_TIME * pow(2.0 * field->width / field->cell, 3.0)
                             : met * MEAN_TIME;
}

clod_check_fields_cost clod_check_fields_of(const clod_case *from, double grains, double step,
                                            double duration, double pictures)
{
    clod_check_fields_cost all = {0};
    const clod_steady_time steady = clod_steady_time_of(from, 0.0, step);
    for (size_t k = 0; k < from->field_count; k++) {
        const clod_case_field *field = &from->fields[k];
        const bool grid = field->cell > 0.0;
        const clod_continuum made = clod_fields_make(field);
        const double points = (double)clod_continuum_points(&made);
        const double sampled =
            grid ? clod_steady_time_within(&steady, 0.0, duration) : duration;
        const double files = grid ? 1.0 + (field->frames ? pictures : 0.0) : 0.0;
        const double frames = grid && field->frames ? pictures : 0.0;
        const double samples = sampled / fmax(field->interval, step) + frames;
        all.clock += samples * sample_time(field, grains);
        all.memory +=
            points * (POINT_BYTES + (grid ? CLOD_CONTINUUM_SUMS * NUMBER_BYTES : 0.0));
        all.disk += files * points * (CLOD_CONTINUUM_NUMBERS * NUMBER_BYTES + CORNERS_ON_DISK);
        all.columns += grid ? 0.0 : CLOD_CONTINUUM_NUMBERS;
    }
    return all;
}
