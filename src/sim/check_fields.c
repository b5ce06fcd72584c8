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

/** Simulated time in which a grid is sampled [s]: a test samples all of it. */
static double grid_time(const clod_case *from, const clod_check_fields_run *run)
{
    const clod_steady_time steady = clod_steady_time_of(from, 0.0, run->step);
    return clod_case_tester(from) != NULL
               ? run->duration
               : clod_steady_time_within(&steady, 0.0, run->duration);
}

clod_check_fields_cost clod_check_fields_of(const clod_case *from,
                                            const clod_check_fields_run *run)
{
    clod_check_fields_cost all = {0};
    const bool test = clod_case_tester(from) != NULL;
    for (size_t k = 0; k < from->field_count; k++) {
        const clod_case_field *field = &from->fields[k];
        const bool grid = field->cell > 0.0;
        const clod_continuum made = clod_fields_make(field);
        const double points = (double)clod_continuum_points(&made);
        const double sampled = grid ? grid_time(from, run) : run->duration;
        const double frames = grid && field->frames ? run->pictures : 0.0;
        const double files = grid ? run->parts + frames : 0.0;
        const double due = sampled / fmax(field->interval, run->step);
        const double samples = frames + (test ? fmin(due, run->rows) : due);
        const double sums = grid ? points * CLOD_CONTINUUM_SUMS * NUMBER_BYTES : 0.0;
        all.clock += samples * sample_time(field, run->grains);
        all.memory += run->beside * points * POINT_BYTES + run->parts * sums;
        all.stored += sums;
        all.disk += files * points * (CLOD_CONTINUUM_NUMBERS * NUMBER_BYTES + CORNERS_ON_DISK);
        all.columns += grid ? 0.0 : CLOD_CONTINUUM_NUMBERS;
    }
    return all;
}
