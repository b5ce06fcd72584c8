#include "measure/continuum_sums.h"

#include <math.h>
#include <string.h>

#include "measure/lucy.h"

#define BLOCKS CLOD_CONTINUUM_BLOCKS
#define COLUMNS (BLOCKS * CLOD_FIXED_COLUMNS)
/** Blocks of grains and of contacts. */
#define GRAIN_BLOCKS ((CLOD_CONTINUUM_GRAIN_SUMS + CLOD_FIXED_COLUMNS - 1) / CLOD_FIXED_COLUMNS)
#define CONTACT_BLOCK (CLOD_CONTINUUM_CONTACT / CLOD_FIXED_COLUMNS)

clod_continuum_sums clod_continuum_sums_of(const clod_continuum *field,
                                           clod_continuum_point *points)
{
    return (clod_continuum_sums){
        .field = field,
        .weight = field->cell > 0.0 ? 0.0 : 1.0 / clod_continuum_volume(&field->region),
        .point = points};
}

static void carry(clod_continuum_point *point)
{
    for (int b = 0; b < BLOCKS; b++) {
        clod_fixed_carry(&point->sum[b]);
    }
    point->addends = 0;
}

/** Add columns [8 first, 8 last) with a weight. */
static void add(clod_continuum_point *to, const double sum[COLUMNS], double weight, int first,
                int last)
{
    for (int b = first; b < last; b++) {
        double addend[CLOD_FIXED_COLUMNS];
        for (int c = 0; c < CLOD_FIXED_COLUMNS; c++) {
            addend[c] = weight * sum[b * CLOD_FIXED_COLUMNS + c];
        }
        clod_fixed_add(&to->sum[b], addend);
    }
    if (++to->addends == CLOD_FIXED_ADDENDS) {
        carry(to);
    }
}

/** Cells whose middles may be in a box, along each axis; none: last < first. */
typedef struct range {
    int64_t first[3], last[3];
} range;

static range range_of(const clod_continuum *field, const double low[3], const double high[3],
                      double reach)
{
    range self;
    for (int a = 0; a < 3; a++) {
        const double begin = (low[a] - reach - field->region.low[a]) / field->cell - 0.5;
        const double end = (high[a] + reach - field->region.low[a]) / field->cell - 0.5;
        self.first[a] = (int64_t)fmax(0.0, ceil(fmin(begin, (double)field->cells[a])));
        self.last[a] = (int64_t)fmin((double)field->cells[a] - 1.0, floor(fmax(end, -1.0)));
    }
    return self;
}

/** The next cell of a range behind `at`; false behind the last. */
static bool next_cell(const range *self, int64_t at[3])
{
    for (int a = 0; a < 3; a++) {
        if (++at[a] <= self->last[a]) {
            return true;
        }
        at[a] = self->first[a];
    }
    return false;
}

static bool begin_cells(const range *self, int64_t at[3])
{
    memcpy(at, self->first, sizeof self->first);
    return self->first[0] <= self->last[0] && self->first[1] <= self->last[1] &&
           self->first[2] <= self->last[2];
}

/** A cell with its middle. */
static clod_continuum_point *cell_at(const clod_continuum_sums *self, const int64_t at[3],
                                     double middle[3])
{
    const clod_continuum *field = self->field;
    for (int a = 0; a < 3; a++) {
        middle[a] = field->region.low[a] + field->cell * ((double)at[a] + 0.5);
    }
    return &self->point[(at[2] * field->cells[1] + at[1]) * field->cells[0] + at[0]];
}

static double square_between(const double a[3], const double b[3])
{
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        square += (a[d] - b[d]) * (a[d] - b[d]);
    }
    return square;
}

/** Add columns [8 first, 8 last) of what is at one place. */
static void add_at(clod_continuum_sums *self, const double at[3], const double sum[COLUMNS],
                   int first, int last)
{
    const clod_continuum *field = self->field;
    if (field->cell == 0.0) {
        if (clod_outlet_has(&field->region, at)) {
            add(self->point, sum, self->weight, first, last);
        }
        return;
    }
    const range cells = range_of(field, at, at, field->width);
    int64_t k[3];
    for (bool more = begin_cells(&cells, k); more; more = next_cell(&cells, k)) {
        double middle[3];
        clod_continuum_point *to = cell_at(self, k, middle);
        const double weight = clod_lucy(field->width, square_between(at, middle));
        if (weight > 0.0) {
            add(to, sum, weight, first, last);
        }
    }
}

void clod_continuum_sums_grain(clod_continuum_sums *self, const double at[3], const double *sum)
{
    double all[COLUMNS] = {0};
    memcpy(all, sum, CLOD_CONTINUUM_GRAIN_SUMS * sizeof *sum);
    add_at(self, at, all, 0, GRAIN_BLOCKS);
}

/** Spread a branch over a grid. */
static void spread(clod_continuum_sums *self, const double from[3], const double to[3],
                   const double stress[COLUMNS])
{
    const double width = self->field->width;
    const clod_lucy_line line = clod_lucy_line_of(from, to);
    double low[3], high[3];
    for (int a = 0; a < 3; a++) {
        low[a] = fmin(from[a], to[a]);
        high[a] = fmax(from[a], to[a]);
    }
    const range cells = range_of(self->field, low, high, width);
    int64_t k[3];
    for (bool more = begin_cells(&cells, k); more; more = next_cell(&cells, k)) {
        double middle[3];
        clod_continuum_point *at = cell_at(self, k, middle);
        const double weight = clod_lucy_along(width, &line, middle);
        if (weight > 0.0) {
            add(at, stress, weight, CONTACT_BLOCK, BLOCKS);
        }
    }
}

void clod_continuum_sums_branch(clod_continuum_sums *self, const double from[3],
                                const double to[3], const double force[3])
{
    double stress[COLUMNS] = {0}, way[3], middle[3], f[3], b[3];
    for (int a = 0; a < 3; a++) {
        way[a] = to[a] - from[a];
        middle[a] = from[a] + 0.5 * way[a];
    }
    clod_continuum_turn(self->field, middle, force, f);
    clod_continuum_turn(self->field, middle, way, b);
    for (int k = 0; k < 9; k++) {
        stress[CLOD_CONTINUUM_CONTACT + k] = f[k / 3] * b[k % 3];
    }
    if (self->field->cell > 0.0) {
        spread(self, from, to, stress);
        return;
    }
    const double share = clod_continuum_share(&self->field->region, from, to);
    if (share > 0.0) {
        add(self->point, stress, share * self->weight, CONTACT_BLOCK, BLOCKS);
    }
}

void clod_continuum_sums_push(clod_continuum_sums *self, const double at[3],
                              const double force[3])
{
    double push[COLUMNS] = {0}, f[3];
    clod_continuum_turn(self->field, at, force, f);
    for (int a = 0; a < 3; a++) {
        push[CLOD_CONTINUUM_WALL_FORCE + a] = f[a] * self->field->scale;
    }
    add_at(self, at, push, CONTACT_BLOCK, BLOCKS);
}

bool clod_continuum_sums_reached(const clod_continuum_sums *self, const double low[3],
                                 const double high[3])
{
    bool reached = true;
    const clod_outlet *region = &self->field->region;
    const double reach = self->field->cell > 0.0 ? self->field->width : 0.0;
    for (int a = 0; a < 3; a++) {
        const double end =
            self->field->cell > 0.0
                ? region->low[a] + self->field->cell * (double)self->field->cells[a]
                : region->high[a];
        reached = reached && high[a] + reach >= region->low[a] && low[a] - reach <= end;
    }
    return reached;
}

void clod_continuum_sums_end(clod_continuum_sums *self)
{
    const int64_t points = clod_continuum_points(self->field);
    for (int64_t p = 0; p < points; p++) {
        carry(&self->point[p]);
    }
}

void clod_continuum_sums_merge(clod_continuum_point *into, const clod_continuum_point *from)
{
    for (int b = 0; b < BLOCKS; b++) {
        clod_fixed_merge(&into->sum[b], &from->sum[b]);
    }
}

void clod_continuum_sums_take(const clod_continuum_point *point, int64_t points,
                              double (*to)[CLOD_CONTINUUM_SUMS])
{
    for (int64_t p = 0; p < points; p++) {
        double all[COLUMNS];
        for (int b = 0; b < BLOCKS; b++) {
            clod_fixed_value(&point[p].sum[b], &all[b * CLOD_FIXED_COLUMNS]);
        }
        for (int c = 0; c < CLOD_CONTINUUM_SUMS; c++) {
            to[p][c] += all[c];
        }
    }
}
