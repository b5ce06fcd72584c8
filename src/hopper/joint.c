#include "hopper/joint.h"

#include <math.h>
#include <string.h>

#define ROUND_OFF                                                                              \
    1e-6 ///< of a variance: correlations are written with ten digits, and propagated to first order

/** The symmetric matrix of pairs. */
static double correlation_of(const double *correlation, size_t a, size_t b)
{
    static const size_t FIRST[CLOD_CURVE_JOINT] = {0, 3, 5, 6}; // pair of a with a + 1
    const size_t low = a < b ? a : b;
    const size_t high = a < b ? b : a;
    const double value = a == b ? 1.0 : correlation[FIRST[low] + high - low - 1];
    return isnan(value) ? 0.0 : value;
}

bool clod_joint_factor(const double error[CLOD_CURVE_JOINT],
                       const double correlation[CLOD_JOINT_PAIRS],
                       double part[CLOD_CURVE_JOINT][CLOD_CURVE_JOINT])
{
    double l[CLOD_CURVE_JOINT][CLOD_CURVE_JOINT] = {{0.0}}; // of the correlations
    for (size_t a = 0; a < CLOD_CURVE_JOINT; a++) {
        for (size_t b = 0; b <= a && error[a] > 0.0; b++) {
            double left = error[b] > 0.0 ? correlation_of(correlation, a, b) : 0.0;
            for (size_t k = 0; k < b; k++) {
                left -= l[a][k] * l[b][k];
            }
            const bool told = l[b][b] > 0.0 || a == b; // else b moves with those before it
            if (left < -ROUND_OFF && a == b) {
                return false;
            }
            if (!told && fabs(left) > sqrt(ROUND_OFF)) {
                return false;
            }
            if (a == b) {
                l[a][a] = left > ROUND_OFF ? sqrt(left) : 0.0;
            } else {
                l[a][b] = told ? left / l[b][b] : 0.0;
            }
        }
    }
    for (size_t a = 0; a < CLOD_CURVE_JOINT; a++) {
        for (size_t b = 0; b < CLOD_CURVE_JOINT; b++) {
            part[a][b] = error[a] * l[a][b];
        }
    }
    return true;
}

/** Errors of a row, and whether they are drawn together. */
static size_t errors_of(const clod_solid *solid, size_t row, bool *joint)
{
    static const int CURVES[] = {CLOD_SOLID_STRENGTH, CLOD_SOLID_PHI_E, CLOD_SOLID_PHI_T};
    size_t errors = 0;
    for (size_t k = 0; k < sizeof CURVES / sizeof CURVES[0]; k++) {
        const clod_curve *curve = &solid->curves[CURVES[k]];
        for (size_t i = 0; i < curve->count; i++) {
            const clod_curve_point *point = &curve->points[i];
            if (point->row == row && point->spread == NULL) {
                errors += point->y_error > 0.0 ? 1 : 0;
                errors += k == 0 && point->x_error > 0.0 ? 1 : 0;
                *joint = *joint || point->joint;
            }
        }
    }
    return errors;
}

clod_joint_rows clod_joint_count(const clod_solid *solid)
{
    clod_joint_rows self = {0, 0};
    for (size_t i = 0; i < solid->strength.count; i++) {
        bool joint = false;
        const size_t errors = errors_of(solid, solid->strength.points[i].row, &joint);
        self.together += errors > 1 && joint ? 1 : 0;
        self.apart += errors > 1 && !joint ? 1 : 0;
    }
    return self;
}
