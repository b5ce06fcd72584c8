#include "analysis/preshear.h"

#include <stdbool.h>

/** Whether two points are of one seed and one preshear stress. */
static bool same_test(const clod_locus_point *a, const clod_locus_point *b)
{
    return a->seed == b->seed && a->sigma_p == b->sigma_p;
}

/** Whether two points tell the same of their preshear. */
static bool same_result(const clod_locus_point *a, const clod_locus_point *b)
{
    const bool both = a->rho_inside > 0.0 && b->rho_inside > 0.0; // else one does not tell it
    return a->tau_p == b->tau_p && a->tau_p_error == b->tau_p_error && a->rho_b == b->rho_b &&
           a->rho_b_error == b->rho_b_error && (!both || a->rho_inside == b->rho_inside);
}

void clod_preshear_find(const clod_locus_point *points, size_t count, size_t *first)
{
    for (size_t i = 0; i < count; i++) {
        first[i] = i;
        bool shared = true;
        for (size_t k = 0; k < count; k++) {
            if (same_test(&points[i], &points[k])) {
                first[i] = k < first[i] ? k : first[i];
                shared = shared && same_result(&points[i], &points[k]);
            }
        }
        first[i] = shared ? first[i] : i;
    }
}
