#include "sim/balance.h"

#include <inttypes.h>
#include <math.h>

#include "analysis/prose.h"
#include "base/json.h"
#include "setup/grains.h"
#include "sim/exits.h"
#include "sim/steady_doubt.h"
#include "sim/warning_box.h"

/** Ways out, and removal by the run itself. */
#define WAYS (CLOD_EXITS + 1)

/** Whether grains can come or go. */
static bool is_open(const clod_case *from)
{
    return from->open == CLOD_OPEN_DELETE ||
           clod_setup_grains_coming(from) + from->outlet_count > 0;
}

/** Count what has come and gone, and what is there. */
static clod_balance_count count_of(const clod_state *state, const clod_measure_motion *bed)
{
    const clod_exchange *gone = &state->exchange;
    clod_balance_count self = {.time = state->time,
                               .mass_in = gone->added_mass,
                               .in = gone->added,
                               .mass_inside = bed->mass,
                               .inside = bed->grains};
    for (int e = 0; e < CLOD_EXITS; e++) {
        self.mass_out[e] = gone->left_mass[e];
        self.out[e] = gone->left[e];
    }
    self.mass_out[CLOD_EXITS] = gone->removed_mass;
    self.out[CLOD_EXITS] = gone->removed;
    return self;
}

static size_t balance_size(const clod_case *from)
{
    return is_open(from) ? sizeof(clod_balance) : 0;
}

/** Note the edges of blocks that are behind by now. */
static void note(clod_balance *self, const clod_free_moment *now)
{
    const int edges = clod_steady_time_edges(&now->steady, now->state->time);
    if (self->edges < edges) {
        const clod_measure_motion bed = clod_measure_motion_from(now->survey);
        const clod_balance_count count = count_of(now->state, &bed);
        while (self->edges < edges) {
            self->edge[self->edges++] = count;
        }
    }
}

static void balance_begin(void *memory, const clod_case *from, const clod_state *state,
                          const clod_free_start *bed)
{
    clod_balance *self = memory;
    if (is_open(from)) {
        const clod_measure_motion all = {.grains = bed->grains, .mass = bed->mass};
        self->start = count_of(state, &all);
        self->row = self->start;
    }
}

static bool balance_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)status;
    if (is_open(now->from)) {
        note(memory, now);
    }
    return true;
}

/** Steps to the next edge, or one of those before it. */
static int64_t balance_plan(const void *memory, const clod_case *from, const clod_state *state,
                            const clod_steady_time *steady)
{
    const clod_balance *self = memory;
    if (!is_open(from) || self->edges > CLOD_STEADY_BLOCKS) {
        return INT64_MAX;
    }
    const double at = steady->since + (double)self->edges * steady->block;
    const int64_t steps = clod_steady_time_steps(at, state->time, state->dt);
    return steps > 1 ? steps : 1;
}

/** The end of the run is seen here: after it nothing acts. */
static bool balance_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    return balance_act(memory, now, status);
}

// ---- what is told

/** Whether this way is told: an outlet, or a side that grains have left by, or can where there
 *  are no outlets. */
static bool is_way(const clod_case *from, const clod_balance_count *now, int way)
{
    if (way < CLOD_FACES) {
        return now->out[way] > 0 || (from->outlet_count == 0 && !from->periodic[way / 2] &&
                                     from->open == CLOD_OPEN_DELETE);
    }
    return way < CLOD_EXITS ? (size_t)(way - CLOD_FACES) < from->outlet_count
                            : now->out[CLOD_EXITS] > 0;
}

/** Whether a run of a case may tell this way: only programs remove grains. */
static bool may_be_way(const clod_case *from, int way)
{
    return way < CLOD_FACES ? from->open == CLOD_OPEN_DELETE && !from->periodic[way / 2]
                            : (size_t)(way - CLOD_FACES) < from->outlet_count;
}

/** Whether what goes this way has missed the one that was meant. */
static bool is_spillage(const clod_case *from, int way)
{
    if (way < CLOD_FACES) {
        return from->outlet_count > 0;
    }
    const size_t outlet = (size_t)(way - CLOD_FACES);
    return outlet < from->outlet_count && from->outlets[outlet].spillage;
}

/** What has come and gone since the beginning. */
static clod_balance_count since(const clod_balance_count *start, clod_balance_count self)
{
    self.in -= start->in;
    self.mass_in -= start->mass_in;
    for (int e = 0; e < WAYS; e++) {
        self.out[e] -= start->out[e];
        self.mass_out[e] -= start->mass_out[e];
    }
    return self;
}

/** Sums of ways out: of all of them, or only of spillage. */
static double sum_out(const clod_case *from, const clod_balance_count *now, bool only_spillage,
                      int64_t *grains)
{
    double mass = 0.0;
    *grains = 0;
    for (int e = 0; e < WAYS; e++) {
        if (!only_spillage || is_spillage(from, e)) {
            mass += now->mass_out[e];
            *grains += now->out[e];
        }
    }
    return mass;
}

/** Which flow. */
enum { FLOW_IN = WAYS, FLOW_OUT, FLOW_SPILLED, FLOW_STORED };

static double amount(const clod_case *from, const clod_balance_count *count, int flow)
{
    int64_t unused;
    return flow == FLOW_IN        ? count->mass_in
           : flow == FLOW_OUT     ? sum_out(from, count, false, &unused)
           : flow == FLOW_SPILLED ? sum_out(from, count, true, &unused)
           : flow == FLOW_STORED  ? count->mass_inside
                                  : count->mass_out[flow];
}

/** Between two moments [kg/s]; NAN when they are one. */
static double mean_flow(const clod_case *from, const clod_balance_count *first,
                        const clod_balance_count *last, int flow)
{
    return last->time > first->time ? (amount(from, last, flow) - amount(from, first, flow)) /
                                          (last->time - first->time)
                                    : (double)NAN;
}

/** Means of a flow in the blocks that are over [kg/s]; how many. */
static int blocks_of(const clod_balance *self, const clod_case *from, int flow, double *each)
{
    const int blocks = self->edges > 0 ? (int)self->edges - 1 : 0;
    for (int b = 0; b < blocks; b++) {
        each[b] = mean_flow(from, &self->edge[b], &self->edge[b + 1], flow);
    }
    return blocks;
}

/** Mean over the blocks, and their standard deviation [kg/s]; NAN without a whole block. */
static void flow_of(const clod_balance *self, const clod_case *from, int flow, double told[2])
{
    double each[CLOD_STEADY_BLOCKS];
    const int blocks = blocks_of(self, from, flow, each);
    told[0] = told[1] = (double)NAN;
    if (blocks > 0) {
        told[0] = mean_flow(from, &self->edge[0], &self->edge[blocks], flow);
        told[1] = clod_steady_time_deviation(each, blocks);
    }
}

static void put_line(FILE *out, const char *kind, const char *name, int64_t grains, double mass,
                     const double flow[2])
{
    char text[64];
    snprintf(text, sizeof text, "%s%s", kind, name);
    fprintf(out, "    %-19s %12" PRId64 " %14.6g", text, grains, mass);
    if (flow != NULL && !isnan(flow[0])) {
        fprintf(out, " %12.4g%s", flow[0], clod_prose_deviation(text, flow[0], flow[1]));
    }
    fprintf(out, "\n");
}

/** Grains and mass that are missing: what came and was there, less what left and is there. */
static double lost(const clod_case *from, const clod_balance *self,
                   const clod_balance_count *now, int64_t *grains)
{
    int64_t out;
    const double mass_out = sum_out(from, now, false, &out);
    *grains = self->start.inside + now->in - out - now->inside;
    return self->start.mass_inside + now->mass_in - mass_out - now->mass_inside;
}

/** Columns of the series: grains, the mass that is missing, flows since the last row. */
static const struct {
    const char *name;
    int flow; ///< or -1
} COLUMN[] = {{"balance.in [1]", -1},
              {"balance.out [1]", -1},
              {"balance.inside [1]", -1},
              {"balance.lost [1]", -1},
              {"balance.lost_mass [kg]", -1},
              {"balance_in.mass_flow [kg/s]", FLOW_IN},
              {"balance_out.mass_flow [kg/s]", FLOW_OUT},
              {"balance_spilled.mass_flow [kg/s]", FLOW_SPILLED}};

#define COLUMNS (sizeof COLUMN / sizeof *COLUMN)

static size_t balance_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return is_open(from) ? COLUMNS : 0;
}

static void balance_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                           size_t size)
{
    (void)from;
    (void)state;
    snprintf(text, size, "%s", COLUMN[k].name);
}

/** What was there at the start has come in too. */
static void balance_row(void *memory, const clod_free_moment *now, double *row)
{
    clod_balance *self = memory;
    if (!is_open(now->from)) {
        return;
    }
    const clod_balance_count all = count_of(now->state, now->motion);
    for (size_t k = 0; k < COLUMNS; k++) {
        if (COLUMN[k].flow >= 0) {
            row[k] = mean_flow(now->from, &self->row, &all, COLUMN[k].flow);
        }
    }
    self->row = all;
    const clod_balance_count count = since(&self->start, all);
    int64_t out, grains;
    sum_out(now->from, &count, false, &out);
    row[4] = lost(now->from, self, &count, &grains);
    row[0] = (double)(self->start.inside + count.in);
    row[1] = (double)out;
    row[2] = (double)count.inside;
    row[3] = (double)grains;
}

static void balance_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const clod_balance *self = memory;
    const clod_case *from = now->from;
    if (!is_open(from)) {
        return;
    }
    const clod_balance_count count = since(&self->start, self->row); // the last row is the end
    double flow[2];
    int64_t grains;
    fprintf(out, "  balance                     grains             kg");
    if (self->edges > 1) {
        const int blocks = (int)self->edges - 1;
        fprintf(out, "         kg/s, %.4g to %.4g s", self->edge[0].time,
                self->edge[blocks].time);
        if (blocks > 1) {
            fprintf(out, ", +- standard deviation of %d blocks", blocks);
        }
    }
    fprintf(out, "\n");
    put_line(out, "at the start", "", self->start.inside, self->start.mass_inside, NULL);
    flow_of(self, from, FLOW_IN, flow);
    put_line(out, "came in", "", count.in, count.mass_in, flow);
    for (int e = 0; e < WAYS; e++) {
        if (is_way(from, &count, e)) {
            flow_of(self, from, e, flow);
            put_line(out, is_spillage(from, e) ? "spilled " : "left ", clod_exits_name(from, e),
                     count.out[e], count.mass_out[e], flow);
        }
    }
    flow_of(self, from, FLOW_STORED, flow);
    put_line(out, "inside", "", count.inside, count.mass_inside, flow);
    const double mass = lost(from, self, &count, &grains);
    put_line(out, "lost", "", grains, mass, NULL);
}

/** Whether grains of this case can leave. */
static bool has_way_out(const clod_case *from)
{
    bool any = false;
    for (int e = 0; e < CLOD_EXITS; e++) {
        any |= may_be_way(from, e);
    }
    return any;
}

/** A stream that is fed is steady when as much leaves as comes in. Without a feed, or a way out, it is
 *  an emptying or a filling, and nobody thinks it steady. */
static void balance_warn(json_t *list, const void *memory, const clod_free_moment *now)
{
    const clod_balance *self = memory;
    const clod_case *from = now->from;
    double in[2], stored[2], block[CLOD_STEADY_BLOCKS];
    if (!is_open(from) || !has_way_out(from)) {
        return;
    }
    flow_of(self, from, FLOW_IN, in);
    flow_of(self, from, FLOW_STORED, stored);
    if (!(in[0] > 0.0)) { // NAN: no block is over
        return;
    }
    const int blocks = blocks_of(self, from, FLOW_STORED, block);
    if (clod_steady_doubt_not_zero(block, blocks, in[0])) {
        clod_warning_box_add(
            list,
            "Balance: what is inside %s by %.3g kg/s from %.4g to %.4g s, %.0f %% of what comes in: "
            "the run is not steady, nor are its means. Let the stages last longer, or give a later "
            "output.steady_since%s.",
            stored[0] > 0.0 ? "grows" : "falls", fabs(stored[0]), self->edge[0].time,
            self->edge[blocks].time, 100.0 * fabs(stored[0]) / in[0],
            stored[0] > 0.0 ? "; where it grows on, solid builds up" : "");
    } else {
        clod_steady_doubt_warn(list, "Balance: the flow out", "kg/s", block,
                               blocks_of(self, from, FLOW_OUT, block), &now->steady);
    }
}

static json_t *entry(const clod_balance *self, const clod_case *from, int64_t grains,
                     double mass, int flow)
{
    double told[2];
    flow_of(self, from, flow, told);
    return json_pack("{s:I, s:f, s:{s:o, s:o}}", "grains", (json_int_t)grains, "mass_kg", mass,
                     "flow_kg_per_s", "mean", clod_json_number(told[0]), "deviation",
                     clod_json_number(told[1]));
}

/** Of entry. */
#define ENTRY_PATHS "grains mass_kg flow_kg_per_s.mean flow_kg_per_s.deviation"

static void balance_paths(const clod_case *from, const clod_state *state,
                          clod_free_paths *paths)
{
    (void)state;
    clod_free_paths_add(paths, NULL, "since_s until_s");
    clod_free_paths_add(paths, "start", "grains mass_kg");
    clod_free_paths_add(paths, "in", ENTRY_PATHS);
    for (int e = 0; e < CLOD_EXITS; e++) {
        char key[64], before[72];
        if (may_be_way(from, e)) {
            snprintf(before, sizeof before, "out.%s", clod_exits_key(from, e, key, sizeof key));
            clod_free_paths_add(paths, before, ENTRY_PATHS);
        }
    }
    clod_free_paths_add(paths, "spillage", ENTRY_PATHS);
    clod_free_paths_add(paths, "inside", ENTRY_PATHS);
    clod_free_paths_add(paths, "lost", "grains mass_kg");
}

static json_t *balance_json(const void *memory, const clod_free_moment *now)
{
    const clod_balance *self = memory;
    const clod_case *from = now->from;
    const clod_balance_count count = since(&self->start, self->row);
    json_t *exits = json_object();
    char key[64];
    for (int e = 0; e < WAYS; e++) {
        if (is_way(from, &count, e)) {
            json_t *one = entry(self, from, count.out[e], count.mass_out[e], e);
            json_object_set_new(one, "spillage", json_boolean(is_spillage(from, e)));
            json_object_set_new(exits, clod_exits_key(from, e, key, sizeof key), one);
        }
    }
    int64_t spilled, grains;
    const double spilled_mass = sum_out(from, &count, true, &spilled);
    const double mass = lost(from, self, &count, &grains);
    const double nan = (double)NAN;
    const bool steady = self->edges > 1;
    return json_pack("{s:o, s:o, s:{s:I, s:f}, s:o, s:o, s:o, s:o, s:{s:I, s:f}}", "since_s",
                     clod_json_number(steady ? self->edge[0].time : nan), "until_s",
                     clod_json_number(steady ? self->edge[self->edges - 1].time : nan), "start",
                     "grains", (json_int_t)self->start.inside, "mass_kg",
                     self->start.mass_inside, "in",
                     entry(self, from, count.in, count.mass_in, FLOW_IN), "out", exits,
                     "spillage", entry(self, from, spilled, spilled_mass, FLOW_SPILLED),
                     "inside", entry(self, from, count.inside, count.mass_inside, FLOW_STORED),
                     "lost", "grains", (json_int_t)grains, "mass_kg", mass);
}

const clod_free_measure CLOD_MEASURE_BALANCE = {.key = "balance",
                                                .size = balance_size,
                                                .begin = balance_begin,
                                                .act = balance_act,
                                                .plan = balance_plan,
                                                .look = balance_look,
                                                .columns = balance_columns,
                                                .column = balance_column,
                                                .row = balance_row,
                                                .report = balance_report,
                                                .warn = balance_warn,
                                                .told = is_open,
                                                .paths = balance_paths,
                                                .json = balance_json};
