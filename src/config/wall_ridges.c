#include "config/wall_ridges.h"

#include <math.h>

#include "config/wall_cells.h"

#define STRIPS 256 ///< across a ridge, of the sum of its volume
#define PAUSE 0.05 ///< s at full speed: ramp of the load and looks at it, more than they take
#define SLEW 3.0   ///< m/s2 with which the plate comes to its speed (tester/wall_shear.c)
#define MOST 1e15  ///< ridges that are counted: a spacing of next to nothing has more

/** Radius at which a uniform shear stress has its torque [m]. */
static double mean_radius(const clod_case_wall_friction *test)
{
    const double ri = clod_wall_cell_inner(test), ro = test->outer_radius;
    return 2.0 / 3.0 * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri);
}

double clod_wall_ridges_way(const clod_case_wall_friction *test)
{
    const double changes = PAUSE * test->speed + test->speed * test->speed / SLEW;
    const double each = test->shear_max + 2.0 * test->block_displacement + changes;
    return (double)test->wall_stress_count * each;
}

/** The plate of a straight cell reaches as far behind the specimen as it moves: whole cells, a power
 *  of two of them, so that other stresses as a rule have the same plate (--from). */
static double reserve(const clod_case_wall_friction *test)
{
    double length = 2.0 * test->outer_radius;
    const double way = clod_wall_ridges_way(test);
    while (length < way) {
        length *= 2.0;
    }
    return length;
}

/** Height of a ridge at a distance y from its middle [m]. */
static double height_at(const clod_wall_ridges *self, double y)
{
    const double run = 0.5 * (self->width - self->crest);
    const double in = 0.5 * self->width - fabs(y);
    return in >= run ? self->height : self->height * in / run;
}

/** Volume of the ridges of a ring between its walls [m3]: lengths differ across a ridge. */
static double volume_in_ring(const clod_wall_ridges *self, const clod_case_wall_friction *test)
{
    const double ri = clod_wall_cell_inner(test), ro = test->outer_radius;
    double sum = 0.0;
    for (int k = 0; k < STRIPS; k++) {
        const double y = self->width * (((double)k + 0.5) / STRIPS - 0.5);
        sum += height_at(self, y) * (sqrt(ro * ro - y * y) - sqrt(ri * ri - y * y));
    }
    return (double)self->count * sum * self->width / STRIPS;
}

static void lay_in_ring(clod_wall_ridges *self, const clod_case_wall_friction *test)
{
    const double ri = clod_wall_cell_inner(test), ro = test->outer_radius;
    const double round_way = 2.0 * M_PI * mean_radius(test);
    self->count = (int64_t)fmin(MOST, fmax(3.0, round(round_way / self->spacing)));
    self->spacing = round_way / (double)self->count;
    const double half = M_PI / (double)self->count;
    self->room = 2.0 * ri * sin(half);
    self->width = self->width > 0.0 ? self->width : self->room;
    self->from = sqrt(fmax(ri * ri - 0.25 * self->width * self->width, 0.0));
    self->to = ro / cos(half); // corners beyond the wall, so that their chords reach it
    self->volume = self->width <= self->room ? volume_in_ring(self, test) : 0.0;
}

static void lay_straight(clod_wall_ridges *self, const clod_case_wall_friction *test)
{
    const double reach = test->outer_radius + self->spacing;
    self->count = (int64_t)fmin(MOST, ceil((2.0 * reach + reserve(test)) / self->spacing));
    self->room = self->spacing;
    self->width = self->width > 0.0 ? self->width : self->room;
    self->to = reach;
    self->from = self->to - (double)self->count * self->spacing;
    self->volume = clod_wall_cell_area(test) * 0.5 * self->height *
                   (self->width + self->crest) / self->spacing;
}

clod_wall_ridges clod_wall_ridges_of(const clod_case_wall_friction *test)
{
    const clod_case_ridges *given = &test->plate_ridges;
    clod_wall_ridges self = {.spacing = given->spacing,
                             .height = given->height,
                             .width = given->width,
                             .crest = given->crest};
    if (!(given->height > 0.0)) {
        return (clod_wall_ridges){0};
    }
    if (clod_wall_cell_of(test)->turns) {
        lay_in_ring(&self, test);
    } else {
        lay_straight(&self, test);
    }
    self.flank = atan2(2.0 * self.height, self.width - self.crest);
    return self;
}

double clod_wall_ridges_roughness(const clod_wall_ridges *self, double diameter)
{
    const double run = 0.5 * (self->width - self->crest);
    return self->height * (diameter < run ? diameter / run : 1.0) / diameter;
}

double clod_wall_ridges_sink_depth(const clod_wall_ridges *self, double radius)
{
    const double edge = 0.5 * (self->spacing - self->crest); // of a crest, from the middle
    const double foot = 0.5 * (self->spacing - self->width);
    const double sine = sin(self->flank), cosine = cos(self->flank);
    const double touches = radius * sine; // where the ball meets a flank
    double centre = radius;               // on the floor
    if (edge < radius) {
        centre = fmax(centre, self->height + sqrt(radius * radius - edge * edge));
    }
    if (touches >= foot && touches <= edge) {
        centre = fmax(centre, (radius - foot * sine) / cosine);
    }
    return fmax(self->height + radius - centre, 0.0);
}
