#include "calibrate/sobol.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_qrng.h>

#include "base/assert.h"

bool clod_sobol_fill(size_t dimensions, size_t count, double *points)
{
    CLOD_ASSERT(dimensions >= 1 && dimensions <= CLOD_SOBOL_MOST);
    gsl_set_error_handler_off(); // GSL's own ends the program
    gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, (unsigned)dimensions);
    if (sequence == NULL) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        gsl_qrng_get(sequence, points + i * dimensions);
    }
    gsl_qrng_free(sequence);
    return true;
}
