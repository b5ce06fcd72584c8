#include "hopper/radial.h"

#include <math.h>
#include <stddef.h>

#include "hopper/ode.h"

#define STEEPEST (0.75 * M_PI) // psi at which the solid stands still
#define FIRST_STEP 1e-3        // rad
#define LEAST_Q 1e-5           // range of q on the axis that is searched
#define LEAST_WIDEST_Q 1e-4    // the same for the widest hopper
#define MOST_Q 1e3             // where nothing else bounds it
#define CLOSE 1e-2             // psi at the wall, in tolerances of a step
#define ROW 0.85               // of q to the next one, in the search for it
#define MOST_ROWS 4            // that the search goes on at once
#define STEEP 10.0             // rad: psi at the wall changes by less with log q (4.5 at most)
#define FLAT 0.1               // theta of the widest hopper, in tolerances of a step
#define STEEPER 4.0            // times that of the last two shots
#define CLOSE_Q 0.1            // relative, of q on the axis, in the same

/** What the equations know. */
typedef struct equations {
    double cone; ///< 1, for a wedge 0
    double s;    ///< sin phi_e
} equations;

/** q and psi as functions of theta: the equations of equilibrium, solved for q' and psi'. */
static clod_ode_pair rates(const void *context, double theta, clod_ode_pair y)
{
    const equations *self = context;
    const double cone = self->cone;
    const double s = self->s;
    const double q = y.a;
    if (theta == 0.0) { // the limit on the axis, where cot theta has no value
        const double turn =
            (q * (1.0 - (3.0 + 2.0 * cone) * s) + 1.0) / ((2.0 + 2.0 * cone) * q * s);
        return (clod_ode_pair){0.0, turn};
    }
    const double s2 = sin(2.0 * y.b);
    const double c2 = cos(2.0 * y.b);
    const double sine = sin(theta);
    const double cosine = cos(theta);
    const double cot = cosine / sine;
    const double radial =
        q * (1.0 + s * c2) + 2.0 * q * s * c2 + cone * q * s * (c2 - 1.0 + s2 * cot) + cosine;
    const double across = 3.0 * q * s * s2 + cone * q * s * (s2 - (1.0 + c2) * cot) - sine;
    // [s s2, 2 q s c2; 1 - s c2, 2 q s s2] (q', psi') = -(radial, across)
    const double determinant = 2.0 * q * s * (s - c2);
    return (clod_ode_pair){(2.0 * q * s * c2 * across - 2.0 * q * s * s2 * radial) /
                               determinant,
                           ((1.0 - s * c2) * radial - s * s2 * across) / determinant};
}

double clod_radial_beta(double phi_e, double phi_w)
{
    const double ratio = sin(phi_w) / sin(phi_e);
    const double beta = ratio < 1.0 ? 0.5 * (phi_w + asin(ratio)) : (double)NAN;
    return beta < STEEPEST - M_PI_2 ? beta : (double)NAN;
}

/** How psi goes with theta from a value of q on the axis. */
typedef struct path {
    double psi;     ///< at the end
    double q;       ///< there
    double highest; ///< psi on the way
    double crossed; ///< theta where psi last fell through the wall's; 0: nowhere
    bool stands;    ///< psi reached 135 degrees: the solid stands still beyond
} path;

/** Where in its next step, which ends at `after`, psi falls through `value`: false position, where an end that stays
 *  twice counts half (Illinois). */
static double pass(const clod_ode *from, const clod_ode *after, double value)
{
    double low = 0.0;
    double high = after->x - from->x;
    double above = from->y.b - value;
    double below = after->y.b - value;
    int side = 0; // that the last try fell on
    for (int i = 0; i < 60 && high - low > 1e-12 && below < 0.0; i++) {
        const double middle = (above * high - below * low) / (above - below);
        const double miss = clod_ode_try(from, middle, NULL).b - value;
        if (fabs(miss) < 1e-13) {
            return from->x + middle;
        }
        if (miss > 0.0) {
            below *= side > 0 ? 0.5 : 1.0;
            low = middle;
            above = miss;
        } else {
            above *= side < 0 ? 0.5 : 1.0;
            high = middle;
            below = miss;
        }
        side = miss > 0.0 ? 1 : -1;
    }
    return from->x + high;
}

/** Go from the axis to `end`, or to where the solid stands still or psi falls below the axis'. */
static path follow(const clod_radial *self, double q, double psi_w, double end)
{
    const equations known = {(double)self->shape, sin(self->phi_e)};
    clod_ode ode = {.rates = rates,
                    .context = &known,
                    .tolerance = self->tolerance,
                    .y = {q, M_PI_2},
                    .step = FIRST_STEP};
    path way = {.highest = M_PI_2};
    while (ode.x < end) {
        const clod_ode before = ode;
        if (!clod_ode_advance(&ode, end) || ode.y.b >= STEEPEST || !(ode.y.a > 0.0)) {
            way.stands = true;
            return way;
        }
        way.highest = fmax(way.highest, ode.y.b);
        if (before.y.b > psi_w && ode.y.b <= psi_w) {
            way.crossed = pass(&before, &ode, psi_w);
            break;
        }
        if (ode.y.b < M_PI_2) {
            break;
        }
    }
    way.psi = ode.y.b;
    way.q = ode.y.a;
    return way;
}

/**
 * The half angle at which this q on the axis fits the wall, on the wide side; where there is none,
 * a negative number that rises towards the values of q that have one.
 */
static double reach(const clod_radial *self, double q, double psi_w)
{
    const path way = follow(self, q, psi_w, CLOD_RADIAL_WIDEST);
    if (way.stands) {
        return -100.0 + log(q); // q is too small
    }
    if (way.crossed > 0.0) {
        return way.crossed;
    }
    return way.psi > psi_w ? CLOD_RADIAL_WIDEST + way.psi - psi_w : way.highest - psi_w;
}

/** The q above which psi falls from the axis on: its derivative there is zero. */
static double most_q(const clod_radial *self)
{
    const double above = (3.0 + 2.0 * (double)self->shape) * sin(self->phi_e) - 1.0;
    return above > 1.0 / MOST_Q ? 1.0 / above : MOST_Q;
}

/** A value of log q on the axis with how far it reaches. */
typedef struct reached {
    double x, theta;
} reached;

/** Where a parabola through three points has its top; not finite: they lie on a line. */
static double top_of(const reached *a, const reached *b, const reached *c)
{
    const double left = (b->x - a->x) * (b->theta - c->theta);
    const double right = (b->x - c->x) * (b->theta - a->theta);
    const double turn = left - right;
    return b->x - 0.5 * ((b->x - a->x) * left - (b->x - c->x) * right) / turn;
}

/** The q on the axis that reaches widest, over its logarithm: golden section, and parabolas where they
 *  close in faster (Brent, Algorithms for minimization without derivatives, 1973, ch. 5). */
static double widest(const clod_radial *self, double psi_w, double *theta)
{
    const double golden = 0.3819660112501051;
    const double close = 50.0 * self->tolerance;
    double low = log(LEAST_WIDEST_Q);
    double high = log(most_q(self));
    reached best = {low + golden * (high - low), 0.0};
    best.theta = reach(self, exp(best.x), psi_w);
    reached second = best;
    reached third = best;
    double move = 0.0;
    double before = 0.0; // the move before the last one
    const double flat = FLAT * self->tolerance;
    bool level = false; // so near the top that the last three reach equally far
    while (!level && fmax(best.x - low, high - best.x) > close) {
        double next = top_of(&second, &best, &third);
        const double last = before;
        before = move;
        if (!(fabs(next - best.x) < 0.5 * fabs(last)) || next <= low || next >= high) {
            before = best.x > 0.5 * (low + high) ? low - best.x : high - best.x;
            next = best.x + golden * before;
        }
        move = next - best.x;
        if (fabs(move) < 0.5 * close) {
            move = best.x > 0.5 * (low + high) ? -0.5 * close : 0.5 * close;
        }
        const reached at = {best.x + move, reach(self, exp(best.x + move), psi_w)};
        const bool better = at.theta >= best.theta;
        *((better ? at.x > best.x : at.x < best.x) ? &low : &high) = better ? best.x : at.x;
        if (better || at.theta >= second.theta || second.x == best.x) {
            third = second;
            second = better ? best : at;
            best = better ? at : best;
        } else if (at.theta >= third.theta || third.x == best.x || third.x == second.x) {
            third = at;
        }
        const bool three = second.x != best.x && third.x != best.x && third.x != second.x;
        level = three && best.theta - fmin(second.theta, third.theta) < flat;
    }
    *theta = fmin(CLOD_RADIAL_WIDEST, best.theta);
    return exp(best.x);
}

bool clod_radial_limit(const clod_radial *self, double *theta)
{
    const double beta = clod_radial_beta(self->phi_e, self->phi_w);
    *theta = 0.0;
    if (!(beta >= 0.0)) {
        return false;
    }
    widest(self, M_PI_2 + beta, theta);
    return *theta > 0.0;
}

/** What is sought: psi at `theta` equal to psi_w. */
typedef struct shot {
    const clod_radial *field;
    double psi_w, theta;
    double q; ///< on the axis, of the last shot
    path way; ///< of that
} shot;

/** A q on the axis with what it misses psi at the wall by. */
typedef struct
try {
    double q, miss;
}
try;

/** Psi at theta less psi at the wall; it falls as q on the axis rises. */
static try shoot(shot *self, double q)
{
    self->q = q;
    self->way = follow(self->field, q, -1.0, self->theta);
    return (try){q, (self->way.stands ? STEEPEST : self->way.psi) - self->psi_w};
}

/** A shot at the q of row k: rows go from the largest q downwards. */
static try shoot_row(shot *self, int k)
{
    return shoot(self, most_q(self->field) * pow(ROW, (double)k));
}

/** How many rows on from one that misses from below to look next: where a line through the last two
 *  would not miss. On a curve that bends down it is not too far, else bisection leads back. */
static int stride_of(const try *before, const try *at, int rows)
{
    const double rise = (at->miss - before->miss) / (double)rows;
    return rise > 0.0 ? (int)fmin(MOST_ROWS, fmax(1.0, -at->miss / rise)) : MOST_ROWS;
}

/** What the rows above one that misses from below tell. */
typedef enum climbed { FOUND, FALLS, NONE } climbed;

/**
 * Go up from a row that misses from below while the rows miss less, to one that does not miss.
 *
 * @param low, high  [out] on FOUND
 * @return           FALLS: the next row up misses more; NONE: no row up to the one that misses least fits
 */
static climbed climb(shot *self, int at, try here, try *low, try *high)
{
    climbed how = FALLS;
    for (int k = at - 1; k >= 0; k--) {
        const try next = shoot_row(self, k);
        if (here.miss >= 0.0 && next.miss < 0.0) {
            *low = here;
            *high = next;
            return FOUND;
        }
        if (here.miss < 0.0 && next.miss <= here.miss) {
            return how;
        }
        here = next;
        how = NONE;
    }
    return NONE;
}

/** Between a row that misses from below and one that does not, to neighbours. */
static bool part_rows(shot *self, int above, int k, bool stands, try *low, try *high)
{
    while (k - above > 1) {
        const int middle = (k + above) / 2;
        const try next = shoot_row(self, middle);
        if (next.miss >= 0.0) {
            k = middle;
            *low = next;
            stands = self->way.stands;
        } else {
            above = middle;
            *high = next;
        }
    }
    return !stands || climb(self, above, *high, low, high) != NONE;
}

/** From a row that does not miss from below up to one that does. @param high  [out] the row, if it does */
static bool step_up(shot *self, int k, try *low, try *high)
{
    *high = shoot_row(self, k);
    if (high->miss < 0.0 || self->way.stands) {
        return false;
    }
    while (high->miss >= 0.0 && k > 0) {
        *low = *high;
        *high = shoot_row(self, --k);
    }
    return true;
}

/** From the largest q downwards: the first row that psi at theta does not miss from below, and its
 *  neighbour above. Psi at theta rises to its largest, falls, and jumps up where the solid stands. */
static bool bracket(shot *self, double guess, try *low, try *high)
{
    const int last = (int)(log(LEAST_Q / most_q(self->field)) / log(ROW));
    int above = 0;
    int stride = MOST_ROWS;
    if (guess > 0.0) {
        above = (int)ceil(log(guess / most_q(self->field)) / log(ROW));
        above = above < 1 ? 1 : above;
        stride = 1;
        if (step_up(self, above, low, high)) {
            return true;
        }
    }
    if (guess <= 0.0 || self->way.stands) {
        above = 0;
        stride = MOST_ROWS;
        *high = shoot_row(self, 0);
    }
    for (int k = above; k < last;) {
        k = above + stride < last ? above + stride : last;
        *low = shoot_row(self, k);
        if (low->miss >= 0.0) {
            return part_rows(self, above, k, self->way.stands, low, high);
        }
        if (low->miss < high->miss && high->miss > M_PI_2 - self->psi_w) {
            return climb(self, k, *low, low, high) == FOUND;
        }
        stride = stride_of(high, low, k - above);
        above = k;
        *high = *low;
    }
    double theta; // close to the limit only a narrow range of q fits, which steps may miss
    *low = shoot(self, widest(self->field, self->psi_w, &theta));
    *high = shoot(self, most_q(self->field));
    return low->miss >= 0.0;
}

/** Where to shoot next, as a share of the way from the last shot to the one on the other side of psi_w: by an inverse
 *  parabola through three, where it surely closes in, or half way (Chandrupatla, Adv. Eng. Softw. 28, 1997, 145). */
static double share_of(const try *at, const try *across, const try *before)
{
    const double way = (at->q - across->q) / (before->q - across->q);
    const double rise = (at->miss - across->miss) / (before->miss - across->miss);
    if (!(rise * rise < way && (1.0 - rise) * (1.0 - rise) < 1.0 - way)) {
        return 0.5;
    }
    return at->miss / (across->miss - at->miss) * before->miss / (across->miss - before->miss) +
           (before->q - at->q) / (across->q - at->q) * at->miss / (before->miss - at->miss) *
               across->miss / (before->miss - across->miss);
}

/** Close in on the q between two others. Steps of other sizes make psi jump by about the tolerance as q changes, so
 *  what is far below that is noise. */
static void close_in(shot *self, try low, try high)
{
    const double close = CLOSE * self->field->tolerance;
    const double least = CLOSE_Q * self->field->tolerance;
    bool stands = low.miss == STEEPEST - self->psi_w;
    double steep =
        STEEP; // more than psi changes with log q below the last shot that missed from below
    try at = low;
    try across = high;
    double share = stands ? 0.5 : low.miss / (low.miss - high.miss);
    for (int i = 0; i < 100 && fabs(at.q - across.q) > least * at.q; i++) {
        const try *missed = at.miss < 0.0 ? &at : &across;
        if (stands && -missed->miss > steep * fabs(log(at.q / across.q))) {
            break; // there is none: psi jumps to where the solid stands
        }
        const double end = 0.5 * least * at.q / fabs(at.q - across.q);
        const try next =
            shoot(self, at.q + fmin(1.0 - end, fmax(end, share)) * (across.q - at.q));
        if (fabs(next.miss) < close) {
            break;
        }
        if (next.miss > 0.0) {
            stands = self->way.stands;
        } else {
            steep =
                fmin(STEEP, STEEPER * fabs(next.miss - missed->miss) / log(missed->q / next.q));
        }
        const bool same = (next.miss > 0.0) == (at.miss > 0.0);
        const try before = same ? at : across;
        across = same ? across : at;
        at = next;
        share = share_of(&at, &across, &before);
    }
}

bool clod_radial_solve(const clod_radial *self, double theta, clod_radial_wall *wall)
{
    return clod_radial_solve_near(self, theta, 0.0, wall);
}

bool clod_radial_solve_near(const clod_radial *self, double theta, double guess,
                            clod_radial_wall *wall)
{
    const double beta = clod_radial_beta(self->phi_e, self->phi_w);
    if (!(beta >= 0.0)) {
        return false;
    }
    shot one = {.field = self, .psi_w = M_PI_2 + beta, .theta = theta};
    try low = {0.0, 0.0};
    try high = low;
    if (!bracket(&one, guess, &low, &high)) {
        return false;
    }
    close_in(&one, low, high);
    const double s = sin(self->phi_e);
    wall->axis = one.q;
    wall->q = one.way.q;
    wall->sigma_1 = wall->q * (1.0 + s);
    wall->sigma_w = wall->q * (1.0 + s * cos(2.0 * beta));
    return !one.way.stands && fabs(one.way.psi - one.psi_w) < 1e-6;
}
