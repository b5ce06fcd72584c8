#include "sim/check_testers.h"

#include <math.h>

#include "setup/begin.h"

/** Solid fraction of a cell that is filled at random: copper ore's has 0.287. */
#define LOOSE_FRACTION 0.29

double clod_check_inertia(const clod_check_subject *subject, double diameter, double rate,
                          double stress)
{
    const double density = subject->from->materials[subject->material].density;
    return rate * diameter * sqrt(density / stress);
}

bool clod_check_heights(const clod_check_subject *subject, double depth, double area,
                        clod_check_report *report, clod_status *status)
{
    const clod_grains *grains = &subject->state.grains;
    double full;
    if (!clod_begin_fill(subject->from, &full, status)) {
        return false;
    }
    report->full_grains = (size_t)full;
    report->height_aimed = depth * (double)report->grains / full;
    for (size_t g = 0; g < grains->count; g++) {
        const double *place = grains->position[g];
        report->height_loose = fmax(report->height_loose, place[2] + place[3]);
    }
    if (report->sampled > 0) {
        report->height_loose = report->solid_volume / (LOOSE_FRACTION * area);
    }
    report->across_depth = report->height_aimed / (2.0 * report->radius_mean);
    return true;
}
