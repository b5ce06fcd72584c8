/**
 * @file unit_stiffness.c
 * The unit N/m^n of a contact stiffness, which udunits cannot hold for a fractional n.
 */

#include "config/unit.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static double prefix_factor(const char **at)
{
    static const char PREFIXES[] = "kMG";
    static const double FACTORS[] = {1e3, 1e6, 1e9};
    const char *found = **at == '\0' ? NULL : strchr(PREFIXES, **at);
    if (found == NULL) {
        return 1.0;
    }
    (*at)++;
    return FACTORS[found - PREFIXES];
}

/** Parse "kN/mm^1.5" into the factor of N, of m, and the exponent. */
static bool split_stiffness(const char *unit, double *newton, bool *milli, double *exponent)
{
    const char *at = unit;
    *newton = prefix_factor(&at);
    if (at[0] != 'N' || at[1] != '/') {
        return false;
    }
    at += 2;
    *milli = at[0] == 'm' && at[1] == 'm';
    at += *milli ? 2 : 1;
    if (at[-1] != 'm') {
        return false;
    }
    *exponent = 1.0;
    if (*at == '^') {
        at = isdigit((unsigned char)at[1]) ? clod_unit_number(at + 1, exponent) : NULL;
    }
    return at != NULL && *at == '\0';
}

bool clod_unit_stiffness(const char *written, double exponent, double *value,
                         char message[CLOD_UNIT_MESSAGE])
{
    char example[32] = "N/m";
    if (exponent != 1.0) {
        snprintf(example, sizeof example, "N/m^%.10g", exponent);
    }
    if (written[0] == '\0') {
        if (*value == 0.0) {
            return true;
        }
        snprintf(message, CLOD_UNIT_MESSAGE,
                 "%.10g needs a unit of stiffness, for instance %.10g %s", *value, *value,
                 example);
        return false;
    }
    double newton = 1.0;
    double written_exponent = 1.0;
    bool milli = false;
    if (!split_stiffness(written, &newton, &milli, &written_exponent)) {
        snprintf(message, CLOD_UNIT_MESSAGE,
                 "\"%s\" is not a stiffness; with exponent %.10g write %.10g %s", written,
                 exponent, *value, example);
        return false;
    }
    if (fabs(written_exponent - exponent) > 1e-9) {
        snprintf(message, CLOD_UNIT_MESSAGE,
                 "%s does not go with exponent %.10g of this contact; write %s or change the "
                 "exponent",
                 written, exponent, example);
        return false;
    }
    *value *= newton * (milli ? pow(1000.0, exponent) : 1.0);
    return true;
}
