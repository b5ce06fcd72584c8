#include "measure/repose.h"

#include <math.h>

#include "base/memory.h"
#include "parallel/exact.h"

/** Strips of a flank below which it has no angle. */
#define LEAST 3
/** Height of a cell that is no part of the surface [m]. */
#define OUTSIDE (-1.0)

// ---- centre

/** Sums of the grains in a region. */
typedef struct center_sums {
    clod_exact mass, moment[2];
} center_sums;

static bool add_center(const clod_survey_question *question, const clod_survey_part *here,
                       clod_status *status)
{
    (void)status;
    const clod_outlet *region = question->asked;
    const clod_grains *grains = &here->state->grains;
    center_sums *sums = question->sums;
    for (size_t g = 0; g < grains->count; g++) {
        const double m = grains->velocity[g][3];
        double p[4];
        clod_domain_place(&here->state->domain, grains->position[g], p);
        if (clod_survey_has(here, g) && clod_outlet_has(region, p)) {
            clod_exact_add(&sums->mass, m);
            clod_exact_add(&sums->moment[0], m * p[0]);
            clod_exact_add(&sums->moment[1], m * p[1]);
        }
    }
    return true;
}

static void merge_center(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    center_sums *mine = into;
    const center_sums *other = from;
    clod_exact_merge(&mine->mass, &other->mass);
    clod_exact_merge(&mine->moment[0], &other->moment[0]);
    clod_exact_merge(&mine->moment[1], &other->moment[1]);
}

const clod_survey_way CLOD_REPOSE_CENTER_WAY = {.add = add_center, .merge = merge_center};

bool clod_repose_center(const clod_outlet *region, const clod_survey *survey, double center[2],
                        clod_status *status)
{
    center_sums sums = {.mass = {.pending = 0}};
    const clod_survey_question question = {.kind = CLOD_SURVEY_REPOSE_CENTER,
                                           .asked = region,
                                           .asked_bytes = sizeof *region,
                                           .sums = &sums,
                                           .sums_bytes = sizeof sums};
    const bool good = clod_survey_ask(survey, &question, status);
    const double all = clod_exact_value(&sums.mass);
    for (int a = 0; a < 2; a++) {
        center[a] = all > 0.0 ? clod_exact_value(&sums.moment[a]) / all : 0.0;
    }
    return good;
}

// ---- surface

/** What is highest in and over a cell. */
typedef struct top_cell {
    double top;     ///< m, highest point of any grain; 0: none, or OUTSIDE
    double used;    ///< 1: some grain is there
    double outside; ///< 1: its middle is, so only grains in the cell count
} top_cell;

/** Strips, each cut into cells across. */
typedef struct strips {
    int64_t count;
    int64_t *first; ///< [count + 1] of the cells of each
    top_cell *cell; ///< [first[count]] borrowed
    double low[2];  ///< m, least along and across a slope
} strips;

static double along(const clod_repose *self, double x, double y)
{
    return self->direction[0] * x + self->direction[1] * y;
}

static double across(const clod_repose *self, double x, double y)
{
    return self->direction[0] * y - self->direction[1] * x;
}

/** Lengths of the region along and across a slope, or its farthest point from the axis [m]. */
static void measure_region(const clod_repose *self, strips *to, double length[2])
{
    const double *low = self->region.low, *high = self->region.high;
    double least[2] = {HUGE_VAL, HUGE_VAL}, most[2] = {-HUGE_VAL, -HUGE_VAL}, far = 0.0;
    for (int c = 0; c < 4; c++) {
        const double x = c % 2 == 0 ? low[0] : high[0], y = c < 2 ? low[1] : high[1];
        const double at[2] = {along(self, x, y), across(self, x, y)};
        for (int a = 0; a < 2; a++) {
            least[a] = fmin(least[a], at[a]);
            most[a] = fmax(most[a], at[a]);
        }
        far = fmax(far, hypot(x - self->center[0], y - self->center[1]));
    }
    for (int a = 0; a < 2; a++) {
        to->low[a] = least[a];
        length[a] = self->slope ? most[a] - least[a] : far;
    }
}

/** Cells of a strip: about as long as wide. */
static int64_t cells_of(const clod_repose *self, int64_t strip, double width)
{
    const double length = self->slope ? width / self->cell : 2.0 * M_PI * ((double)strip + 0.5);
    return (int64_t)fmax(1.0, floor(length));
}

/** Whether the middle of a cell is within the region, seen from above. */
static bool is_inside(const clod_repose *self, const strips *of, int64_t strip, int64_t cell)
{
    const int64_t cells = of->first[strip + 1] - of->first[strip];
    const double way = ((double)strip + 0.5) * self->cell;
    double p[3] = {0.0, 0.0, self->region.low[2]};
    if (self->slope) {
        const double *n = self->direction, u = of->low[0] + way;
        const double v = of->low[1] + ((double)cell + 0.5) * self->cell;
        p[0] = n[0] * u - n[1] * v;
        p[1] = n[1] * u + n[0] * v;
    } else {
        const double turn = 2.0 * M_PI * ((double)cell + 0.5) / (double)cells;
        p[0] = self->center[0] + way * cos(turn);
        p[1] = self->center[1] + way * sin(turn);
    }
    return clod_outlet_has(&self->region, p);
}

/** How the region is cut; false without memory. */
static bool strips_open(const clod_repose *self, strips *to)
{
    double length[2];
    *to = (strips){.count = 0};
    measure_region(self, to, length);
    to->count = 1 + (int64_t)floor(length[0] / self->cell);
    to->first = clod_memory_alloc((size_t)to->count + 1, sizeof *to->first);
    for (int64_t s = 0; to->first != NULL && s < to->count; s++) {
        to->first[s + 1] = to->first[s] + cells_of(self, s, length[1]);
    }
    return to->first != NULL;
}

static bool fail(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for the surface of a heap");
}

/** Cells that no grain is in or over yet. */
static void clear(const clod_repose *self, const strips *to)
{
    for (int64_t s = 0; s < to->count; s++) {
        for (int64_t c = to->first[s]; c < to->first[s + 1]; c++) {
            const bool inside = is_inside(self, to, s, c - to->first[s]);
            to->cell[c] = (top_cell){.top = inside ? 0.0 : OUTSIDE, .outside = !inside};
        }
    }
}

/** Where a grain is: along the slope or off the axis [m], and across it [m] or about it [1 turn]. */
typedef struct place {
    double way, across;
} place;

static place place_of(const clod_repose *self, const strips *in, const double p[4])
{
    if (self->slope) {
        return (place){along(self, p[0], p[1]) - in->low[0],
                       across(self, p[0], p[1]) - in->low[1]};
    }
    const double x = p[0] - self->center[0], y = p[1] - self->center[1];
    const double turn = atan2(y, x) / (2.0 * M_PI);
    return (place){hypot(x, y), turn - floor(turn)};
}

/** A grain in the cell that its centre is in: its top. */
static void add_top(const clod_repose *self, const strips *to, const double p[4], place at)
{
    const int64_t strip = (int64_t)fmin(floor(at.way / self->cell), (double)to->count - 1.0);
    const int64_t cells = to->first[strip + 1] - to->first[strip];
    const double column = at.across * (self->slope ? 1.0 / self->cell : (double)cells);
    const int64_t cell = (int64_t)fmin(fmax(column, 0.0), (double)cells - 1.0);
    top_cell *of = &to->cell[to->first[strip] + cell];
    of->top = fmax(of->top, p[2] + p[3] - self->region.low[2]);
    of->used = 1.0;
}

/** A grain over the middles of cells of one strip: its sphere's height there. */
static void add_over(const clod_repose *self, const strips *to, const double p[4], place at,
                     int64_t strip)
{
    const int64_t cells = to->first[strip + 1] - to->first[strip];
    const double off = ((double)strip + 0.5) * self->cell, r2 = p[3] * p[3];
    const double gap = off - at.way, twice = 2.0 * off * at.way;
    // cells in a unit of `across`, and half of the disc's chord in them
    const double many = self->slope ? 1.0 / self->cell : (double)cells;
    const double chord =
        self->slope ? sqrt(fmax(0.0, r2 - gap * gap))
                    : acos(fmax(-1.0, 1.0 - fmax(0.0, r2 - gap * gap) / twice)) / (2.0 * M_PI);
    int64_t first = (int64_t)ceil((at.across - chord) * many - 0.5);
    int64_t last = (int64_t)floor((at.across + chord) * many - 0.5);
    if (self->slope) {
        first = first > 0 ? first : 0;
        last = last < cells ? last : cells - 1;
    } else if (last >= first + cells) {
        last = first + cells - 1;
    }
    for (int64_t c = first; c <= last; c++) {
        const double side = ((double)c + 0.5) / many - at.across;
        const double half = sin(M_PI * side); // of the turn between them
        const double d2 = gap * gap + (self->slope ? side * side : 2.0 * twice * half * half);
        top_cell *of = &to->cell[to->first[strip] + (c + cells) % cells];
        if (d2 <= r2 && of->outside == 0.0) { // whatever came before
            of->top = fmax(of->top, p[2] + sqrt(r2 - d2) - self->region.low[2]);
            of->used = 1.0;
        }
    }
}

static void add_grain(const clod_repose *self, const strips *to, const double p[4])
{
    const place at = place_of(self, to, p);
    const double first = ceil((at.way - p[3]) / self->cell - 0.5);
    const double last = floor((at.way + p[3]) / self->cell - 0.5);
    add_top(self, to, p, at);
    for (double s = fmax(0.0, first); s <= fmin(last, (double)to->count - 1.0); s++) {
        add_over(self, to, p, at, (int64_t)s);
    }
}

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    const clod_repose *self = question->asked;
    const clod_state *state = here->state;
    strips surface;
    if (!strips_open(self, &surface)) {
        return fail(status);
    }
    surface.cell = question->sums;
    clear(self, &surface);
    for (size_t g = 0; g < state->grains.count; g++) {
        double p[4];
        clod_domain_place(&state->domain, state->grains.position[g], p);
        if (clod_survey_has(here, g) && clod_outlet_has(&self->region, p)) {
            add_grain(self, &surface, p);
        }
    }
    clod_memory_free(surface.first);
    return true;
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    top_cell *mine = into;
    const top_cell *other = from;
    mine->top = fmax(mine->top, other->top);
    mine->used = fmax(mine->used, other->used);
    mine->outside = other->outside;
}

const clod_survey_way CLOD_REPOSE_WAY = {.add = add, .merge = merge, .unit = sizeof(top_cell)};

/** Whether some grain is in or over a strip. */
static bool is_used(const strips *self, int64_t strip)
{
    bool used = false;
    for (int64_t c = self->first[strip]; c < self->first[strip + 1]; c++) {
        used = used || self->cell[c].used > 0.0;
    }
    return used;
}

/** Mean height of a strip: cells of the region without a grain in or over them are ground. */
static double height_of(const strips *self, int64_t strip)
{
    double sum = 0.0, cells = 0.0;
    for (int64_t c = self->first[strip]; c < self->first[strip + 1]; c++) {
        if (self->cell[c].top >= 0.0) {
            sum += self->cell[c].top;
            cells += 1.0;
        }
    }
    return sum / cells; // of a strip with a grain
}

/** Straight line through the strips between two heights. */
static void fit(const strips *self, double cell, double low, double high,
                clod_repose_angle *found)
{
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, n = 0.0;
    for (int pass = 0; pass < 2; pass++) { // means first
        for (int64_t s = 0; s < self->count; s++) {
            const double height = is_used(self, s) ? height_of(self, s) : OUTSIDE;
            const double at = ((double)s + 0.5) * cell;
            if (height < low || height > high) {
                continue;
            }
            if (pass == 0) {
                n += 1.0;
                x += at;
                y += height;
            } else {
                xx += (at - x / n) * (at - x / n);
                xy += (at - x / n) * (height - y / n);
                yy += (height - y / n) * (height - y / n);
            }
        }
    }
    found->strips = (int64_t)n;
    if (n >= LEAST) {
        const double slope = xy / xx;
        const double left = fmax(0.0, yy - slope * xy) / (n - 2.0);
        found->angle = atan(-slope);
        found->error = sqrt(left / xx) / (1.0 + slope * slope);
    }
}

/** The angle of a surface that is known. */
static void find(const clod_repose *self, const strips *surface, clod_repose_angle *found)
{
    for (int64_t s = 0; s < surface->count; s++) {
        if (is_used(surface, s)) {
            found->height = fmax(found->height, height_of(surface, s)); // NAN is less
        }
    }
    if (found->height > 0.0) {
        fit(surface, self->cell, self->from * found->height, self->to * found->height, found);
    }
}

bool clod_repose_find(const clod_repose *self, const clod_survey *survey,
                      clod_repose_angle *found, clod_status *status)
{
    strips surface;
    bool good = strips_open(self, &surface);
    const size_t cells = good ? (size_t)surface.first[surface.count] : 0;
    surface.cell = clod_memory_alloc(cells + 1, sizeof *surface.cell);
    good = (good && surface.cell != NULL) || fail(status);
    *found = (clod_repose_angle){(double)NAN, (double)NAN, (double)NAN, 0};
    const clod_survey_question question = {.kind = CLOD_SURVEY_REPOSE,
                                           .asked = self,
                                           .asked_bytes = sizeof *self,
                                           .sums = surface.cell,
                                           .sums_bytes = cells * sizeof *surface.cell};
    good = good && clod_survey_ask(survey, &question, status);
    if (good) {
        find(self, &surface, found);
    }
    clod_memory_free(surface.first);
    clod_memory_free(surface.cell);
    return good;
}
