#include "measure/continuum.h"

#include <math.h>

#include "base/assert.h"
#include "base/cell_count.h"

const clod_continuum_value CLOD_CONTINUUM_VALUE[CLOD_CONTINUUM_VALUES] = {
    [CLOD_CONTINUUM_OF_DENSITY] = {"density", "kg/m3", "density_kg_per_m3", 0, 1},
    [CLOD_CONTINUUM_OF_SOLID] = {"solid_fraction", "1", "solid_fraction", 1, 1},
    [CLOD_CONTINUUM_OF_VELOCITY] = {"velocity", "m/s", "velocity_m_per_s", 2, 3},
    [CLOD_CONTINUUM_OF_TEMPERATURE] = {"temperature", "m2/s2", "temperature_m2_per_s2", 5, 1},
    [CLOD_CONTINUUM_OF_PRESSURE] = {"pressure", "Pa", "pressure_Pa", 6, 1},
    [CLOD_CONTINUUM_OF_CONTACT] = {"contact_stress", "Pa", "contact_stress_Pa", 7, 9},
    [CLOD_CONTINUUM_OF_KINETIC] = {"kinetic_stress", "Pa", "kinetic_stress_Pa", 16, 9},
    [CLOD_CONTINUUM_OF_WALL_FORCE] = {"wall_force", "N/m3", "wall_force_N_per_m3", 25, 3},
    [CLOD_CONTINUUM_OF_COORDINATION] = {"coordination", "1", "coordination", 28, 1},
    [CLOD_CONTINUUM_OF_RADIUS] = {"radius", "m", "radius_m", 29, 1},
};

const char *clod_continuum_component(const clod_continuum *self, int components, int number)
{
    static const char *const VECTOR[2][3] = {{"_x", "_y", "_z"}, {"_r", "_t", "_z"}};
    static const char *const TENSOR[2][9] = {
        {"_xx", "_xy", "_xz", "_yx", "_yy", "_yz", "_zx", "_zy", "_zz"},
        {"_rr", "_rt", "_rz", "_tr", "_tt", "_tz", "_zr", "_zt", "_zz"}};
    CLOD_ASSERT(number >= 0 && number < components);
    const int frame = self->cylindrical ? 1 : 0;
    return components == 9   ? TENSOR[frame][number]
           : components == 3 ? VECTOR[frame][number]
                             : "";
}

void clod_continuum_turn(const clod_continuum *self, const double at[3], const double vector[3],
                         double to[3])
{
    const double x = at[0] - self->region.middle[0], y = at[1] - self->region.middle[1];
    const double r = sqrt(x * x + y * y);
    const bool turned = self->cylindrical && r > 0.0;
    to[0] = turned ? (x * vector[0] + y * vector[1]) / r : vector[0];
    to[1] = turned ? (x * vector[1] - y * vector[0]) / r : vector[1];
    to[2] = vector[2];
}

double clod_continuum_volume(const clod_outlet *region)
{
    const double *low = region->low, *high = region->high;
    const double base =
        region->outer > 0.0
            ? M_PI * (region->outer * region->outer - region->inner * region->inner)
            : (high[0] - low[0]) * (high[1] - low[1]);
    return base * (high[2] - low[2]);
}

clod_continuum clod_continuum_make(const clod_outlet *region, double cell, double width)
{
    clod_continuum self = {
        .region = *region, .cell = cell, .width = width, .cells = {1, 1, 1}, .scale = width};
    if (cell == 0.0) {
        self.scale = cbrt(clod_continuum_volume(region));
        return self;
    }
    for (int a = 0; a < 3; a++) {
        self.cells[a] = (int64_t)clod_cell_count(region->high[a] - region->low[a], cell);
    }
    return self;
}

int64_t clod_continuum_points(const clod_continuum *self)
{
    return self->cells[0] * self->cells[1] * self->cells[2];
}

void clod_continuum_corner(const clod_continuum *self, int64_t cell, double corner[3])
{
    for (int a = 0; a < 3; a++) {
        corner[a] = self->region.low[a] + self->cell * (double)(cell % self->cells[a]);
        cell /= self->cells[a];
    }
}

// ---- lines in regions

/** A piece of a line, in shares of its length; none: end <= begin. */
typedef struct piece {
    double begin, end;
} piece;

static piece common(piece a, piece b)
{
    return (piece){fmax(a.begin, b.begin), fmin(a.end, b.end)};
}

static double length_of(piece a)
{
    return fmax(0.0, a.end - a.begin);
}

/** Piece of a line within a slab. */
static piece in_slab(double from, double way, double low, double high)
{
    if (way == 0.0) {
        return from >= low && from <= high ? (piece){0.0, 1.0} : (piece){0.0, 0.0};
    }
    const double a = (low - from) / way, b = (high - from) / way;
    return common((piece){0.0, 1.0}, (piece){fmin(a, b), fmax(a, b)});
}

/** Piece of a line within a circle about the axis, seen from above. */
static piece in_circle(const clod_outlet *region, const double from[3], const double to[3],
                       double radius)
{
    const double x = from[0] - region->middle[0], y = from[1] - region->middle[1];
    const double u = to[0] - from[0], v = to[1] - from[1];
    const double a = u * u + v * v, b = x * u + y * v, c = x * x + y * y - radius * radius;
    if (a == 0.0) {
        return c <= 0.0 ? (piece){0.0, 1.0} : (piece){0.0, 0.0};
    }
    const double root = b * b - a * c;
    if (!(root > 0.0)) {
        return (piece){0.0, 0.0};
    }
    return common((piece){0.0, 1.0}, (piece){(-b - sqrt(root)) / a, (-b + sqrt(root)) / a});
}

double clod_continuum_share(const clod_outlet *region, const double from[3], const double to[3])
{
    piece in = {0.0, 1.0};
    for (int a = 0; a < 3; a++) {
        in = common(in, in_slab(from[a], to[a] - from[a], region->low[a], region->high[a]));
    }
    if (region->outer == 0.0) {
        return length_of(in);
    }
    in = common(in, in_circle(region, from, to, region->outer));
    const piece hole = in_circle(region, from, to, region->inner);
    return length_of(in) - length_of(common(in, hole));
}

// ---- values

/** Kinetic stress [Pa] as a full tensor; its trace over three densities is the temperature. */
static void put_kinetic(const double *sums, double samples, double stress[9])
{
    static const int AT[9] = {0, 3, 4, 3, 1, 5, 4, 5, 2}; // of xx yy zz xy xz yz
    const double mass = sums[CLOD_CONTINUUM_MASS];
    const double *momentum = &sums[CLOD_CONTINUUM_MOMENTUM], *flux = &sums[CLOD_CONTINUUM_FLUX];
    for (int k = 0; k < 9; k++) {
        const double mean = mass > 0.0 ? momentum[k / 3] * momentum[k % 3] / mass : 0.0;
        const double stress_k = (flux[AT[k]] - mean) / samples;
        stress[k] = k % 4 == 0 ? fmax(0.0, stress_k) : stress_k; // a rounding below 0 is none
    }
}

void clod_continuum_values(const clod_continuum *self, const double *sums, double samples,
                           double *values)
{
    const double mass = sums[CLOD_CONTINUUM_MASS];
    const bool some = mass > 0.0;
    double *to[CLOD_CONTINUUM_VALUES];
    for (int v = 0; v < CLOD_CONTINUUM_VALUES; v++) {
        to[v] = values + CLOD_CONTINUUM_VALUE[v].first;
    }
    double *contact = to[CLOD_CONTINUUM_OF_CONTACT], *kinetic = to[CLOD_CONTINUUM_OF_KINETIC];
    put_kinetic(sums, samples, kinetic);
    for (int k = 0; k < 9; k++) {
        contact[k] = sums[CLOD_CONTINUUM_CONTACT + k] / samples;
    }
    for (int a = 0; a < 3; a++) {
        to[CLOD_CONTINUUM_OF_VELOCITY][a] =
            some ? sums[CLOD_CONTINUUM_MOMENTUM + a] / mass : (double)NAN;
        to[CLOD_CONTINUUM_OF_WALL_FORCE][a] =
            sums[CLOD_CONTINUUM_WALL_FORCE + a] / (self->scale * samples);
    }
    const double trace = kinetic[0] + kinetic[4] + kinetic[8];
    *to[CLOD_CONTINUUM_OF_DENSITY] = mass / samples;
    *to[CLOD_CONTINUUM_OF_SOLID] = sums[CLOD_CONTINUUM_VOLUME] / samples;
    *to[CLOD_CONTINUUM_OF_TEMPERATURE] = some ? trace * samples / (3.0 * mass) : (double)NAN;
    *to[CLOD_CONTINUUM_OF_PRESSURE] = (contact[0] + contact[4] + contact[8] + trace) / 3.0;
    *to[CLOD_CONTINUUM_OF_COORDINATION] =
        some ? sums[CLOD_CONTINUUM_PARTNERS] / sums[CLOD_CONTINUUM_NUMBER] : (double)NAN;
    *to[CLOD_CONTINUUM_OF_RADIUS] =
        some ? sums[CLOD_CONTINUUM_RADIUS] / sums[CLOD_CONTINUUM_VOLUME] : (double)NAN;
}
