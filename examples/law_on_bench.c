// A contact law tried before it is used: loaded and unloaded on the bench, the force of each
// step beside the closed form k1 d^n of loading.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <clod/contact_bench.h>

#define K1 4.75e8
#define EXPONENT 1.5

static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "contacts:\n"
    "  ore-ore: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "    k_adh: 3.56e8 N/m^1.5, restitution: 1, friction: 0.35}\n"
    "contact_bench:\n"
    "  material_1: ore\n"
    "  material_2: ore\n"
    "  radius_1: 3.175 mm\n"
    "  radius_2: 3.175 mm\n"
    "  legs: [{overlap: 3 um}, {overlap: 0 um}]\n";

/** The largest difference so far, relative to the closed form. */
static bool compare(void *context, const clod_contact_bench_row *row, clod_status *status)
{
    double *worst = context;
    (void)status;
    if (row->branch == CLOD_BRANCH_LOADING && row->overlap > 0.0) {
        const double expected = K1 * pow(row->overlap, EXPONENT);
        *worst = fmax(*worst, fabs(row->force / expected - 1.0));
    }
    return true;
}

int main(void)
{
    static clod_status status;
    clod_contact_bench_summary summary = {0};
    double worst = 0.0;
    clod_case *from = clod_case_parse("bench.yaml", CASE, strlen(CASE), NULL, 0, &status);
    const bool ok =
        from != NULL && clod_contact_bench_run(from, compare, &worst, &summary, &status);
    clod_case_destroy(&from);
    if (!ok) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    const double pull = -summary.f_min / summary.f_max;
    printf("loading within %.1e of k1 d^n; pull-off %.4f of the load, closed form %.4f\n",
           worst, pull, summary.pull_off_force);
    return worst > 1e-9 || fabs(pull / summary.pull_off_force - 1.0) > 0.01;
}
