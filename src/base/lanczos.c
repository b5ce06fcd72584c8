#include "base/lanczos.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

#define MOST 400       ///< products
#define LOOK 8         ///< products between two looks at the eigenvalue
#define PRECISION 1e-7 ///< change of the eigenvalue between two looks, twice in a row
#define NOTHING 1e-14  ///< of the largest row: the next vector is rounding alone
#define HALVINGS 60

/** The tridiagonal matrix: diagonal, and what is beside it. */
typedef struct tridiagonal {
    double diagonal[MOST], beside[MOST];
    int count;
} tridiagonal;

bool clod_lanczos_init(clod_lanczos *self, size_t size)
{
    *self = (clod_lanczos){.size = size,
                           .start = clod_memory_alloc(size + 1, sizeof(double)),
                           .now = clod_memory_alloc(size + 1, sizeof(double)),
                           .before = clod_memory_alloc(size + 1, sizeof(double)),
                           .product = clod_memory_alloc(size + 1, sizeof(double))};
    return self->start != NULL && self->now != NULL && self->before != NULL &&
           self->product != NULL;
}

void clod_lanczos_fini(clod_lanczos *self)
{
    clod_memory_free(self->start);
    clod_memory_free(self->now);
    clod_memory_free(self->before);
    clod_memory_free(self->product);
    *self = (clod_lanczos){0};
}

static double dot(size_t size, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t k = 0; k < size; k++) {
        sum += a[k] * b[k];
    }
    return sum;
}

/** Whether all eigenvalues lie below x: all pivots of T - x are negative. */
static bool all_below(const tridiagonal *t, double x)
{
    double pivot = t->diagonal[0] - x;
    for (int k = 1; k < t->count && pivot < 0.0; k++) {
        pivot = t->diagonal[k] - x - t->beside[k - 1] * t->beside[k - 1] / pivot;
    }
    return pivot < 0.0;
}

/** Bound of all eigenvalues: Gershgorin's. */
static double row_bound(const tridiagonal *t)
{
    double most = 0.0;
    for (int k = 0; k < t->count; k++) {
        const double left = k > 0 ? fabs(t->beside[k - 1]) : 0.0;
        const double right = k + 1 < t->count ? fabs(t->beside[k]) : 0.0;
        most = fmax(most, t->diagonal[k] + left + right);
    }
    return most;
}

static double largest_of(const tridiagonal *t)
{
    double low = 0.0, high = row_bound(t);
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        if (all_below(t, middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return 0.5 * (low + high);
}

/** The next row of the tridiagonal matrix, and the next vector; false: there is none. */
static bool advance(clod_lanczos *self, const void *matrix, clod_lanczos_product product,
                    tridiagonal *t)
{
    const size_t size = self->size;
    const int k = t->count++;
    const double beside = k > 0 ? t->beside[k - 1] : 0.0;
    product(matrix, self->now, self->product);
    for (size_t c = 0; c < size; c++) {
        self->product[c] -= beside * self->before[c];
    }
    t->diagonal[k] = dot(size, self->product, self->now);
    for (size_t c = 0; c < size; c++) {
        self->product[c] -= t->diagonal[k] * self->now[c];
    }
    t->beside[k] = sqrt(dot(size, self->product, self->product));
    if (!(t->beside[k] > NOTHING * row_bound(t))) {
        return false;
    }
    for (size_t c = 0; c < size; c++) {
        self->before[c] = self->now[c];
        self->now[c] = self->product[c] / t->beside[k];
    }
    return true;
}

double clod_lanczos_largest(clod_lanczos *self, const void *matrix,
                            clod_lanczos_product product)
{
    const double length = sqrt(dot(self->size, self->start, self->start));
    if (!(length > 0.0)) {
        return 0.0;
    }
    for (size_t c = 0; c < self->size; c++) {
        self->now[c] = self->start[c] / length;
    }
    memset(self->before, 0, self->size * sizeof(double));
    tridiagonal t = {.count = 0};
    double found = 0.0;
    int still = 0;
    while (still < 2 && t.count < MOST && advance(self, matrix, product, &t)) {
        if (t.count % LOOK == 0) {
            const double last = found;
            found = largest_of(&t);
            still = fabs(found - last) <= PRECISION * found ? still + 1 : 0;
        }
    }
    return isfinite(t.diagonal[t.count - 1]) ? largest_of(&t) : (double)NAN;
}
