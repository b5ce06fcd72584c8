#pragma once
/**
 * @file sim_trace.h
 * All that a program sees of a simulation as lines of text, every bit of it: two simulations are the
 * same when their lines are.
 */

#include <stdio.h>
#include <stdlib.h>

#include "support/sim_made.h"

typedef struct sim_trace {
    FILE *out;
    char *text; ///< once it is closed; free
    size_t size;
} sim_trace;

static inline void trace_open(sim_trace *self)
{
    self->out = open_memstream(&self->text, &self->size);
    assert_non_null(self->out);
}

static inline void trace_numbers(sim_trace *self, const char *what, const double *number,
                                 size_t count)
{
    fprintf(self->out, "%s", what);
    for (size_t k = 0; k < count; k++) {
        fprintf(self->out, " %a", number[k]);
    }
    fputc('\n', self->out);
}

/** Every array, row by row. */
static inline void trace_arrays(sim_trace *self, clod_sim *sim)
{
    for (size_t a = 0; a < clod_sim_array_count(); a++) {
        const clod_sim_view view = sim_view(sim, clod_sim_array_name(a));
        assert_int_equal(view.rows, clod_sim_grain_count(sim));
        for (size_t g = 0; g < view.rows; g++) {
            const char *row = (const char *)view.data + g * view.stride;
            if (view.type == CLOD_SIM_F64) {
                trace_numbers(self, view.name, clod_sim_row(&view, g), view.components);
            } else if (view.type == CLOD_SIM_U64) {
                fprintf(self->out, "%s %llu\n", view.name,
                        *(const unsigned long long *)(const void *)row);
            } else {
                fprintf(self->out, "%s %d\n", view.name, *(const uint16_t *)(const void *)row);
            }
        }
    }
}

static inline void trace_contact(sim_trace *self, const clod_sim_contact *c)
{
    fprintf(self->out,
            "contact %llu %llu rows %zu %zu wall %d %d:", (unsigned long long)c->id_1,
            (unsigned long long)c->id_2, c->row_1, c->row_2, (int)c->wall, (int)c->shape);
    trace_numbers(self, "", &c->plastic, (sizeof *c - offsetof(clod_sim_contact, plastic)) / 8);
}

/** All contacts, and each asked for by its identity. */
static inline void trace_contacts(sim_trace *self, clod_sim *sim)
{
    const clod_sim_contact *contacts;
    size_t count;
    CHECK(clod_sim_contacts(sim, &contacts, &count, &status));
    for (size_t k = 0; k < count; k++) {
        const clod_sim_contact c = contacts[k];
        clod_sim_contact one;
        bool found;
        trace_contact(self, &c);
        CHECK(c.wall < 0 ? clod_sim_contact_of(sim, c.id_2, c.id_1, &one, &found, &status)
                         : clod_sim_wall_contact_of(sim, c.id_1, c.wall, c.shape, &one, &found,
                                                    &status));
        assert_true(found);
        trace_contact(self, &one);
    }
}

static inline void trace_walls(sim_trace *self, clod_sim *sim)
{
    for (int32_t w = 0; w < clod_sim_wall_count(sim); w++) {
        clod_sim_wall wall;
        CHECK(clod_sim_wall_look(sim, w, &wall, &status));
        fprintf(self->out, "wall %s\n", wall.name);
        trace_numbers(self, "position", wall.position, 3);
        trace_numbers(self, "orientation", wall.orientation, 4);
        trace_numbers(self, "material velocity", wall.material_velocity, 3);
        trace_numbers(self, "force", wall.force, 3);
        trace_numbers(self, "torque", wall.torque, 3);
        trace_numbers(self, "mean force", wall.mean_force, 3);
        trace_numbers(self, "mean torque", wall.mean_torque, 3);
        trace_numbers(self, "power, mean, angle, load",
                      (const double[]){wall.power, wall.mean_power, wall.angle, wall.load}, 4);
    }
}

/** Numbers of the whole bed. */
static inline void trace_sums(sim_trace *self, clod_sim *sim)
{
    clod_sim_energy energy;
    clod_sim_bed bed;
    clod_sim_exchange exchange;
    clod_sim_ledger ledger;
    CHECK(clod_sim_energies(sim, &energy, &status));
    CHECK(clod_sim_measure(sim, &bed, &status));
    CHECK(clod_sim_exchange_look(sim, &exchange, &status));
    trace_numbers(self, "energies", &energy.translation, 6);
    fprintf(self->out, "pairs %zu walls %zu\n", bed.pairs, bed.walls);
    trace_numbers(self, "bed", &bed.coordination, 4);
    fprintf(self->out, "added %lld removed %lld walls %lld\n", (long long)exchange.added,
            (long long)exchange.removed, (long long)exchange.walls_removed);
    for (int f = 0; f < CLOD_SIM_SIDES; f++) {
        const clod_sim_left *left = &exchange.left[f];
        trace_numbers(self, "left",
                      (const double[]){(double)left->grains, left->mass, left->energy}, 3);
    }
    if (clod_sim_ledger_look(sim, &ledger, &status)) {
        trace_numbers(self, "ledger", &ledger.plastic, 8);
    }
    trace_numbers(self, "time", (const double[]){clod_sim_time(sim), clod_sim_dt(sim)}, 2);
    fprintf(self->out, "step %lld\n", (long long)clod_sim_step(sim));
}

/** All of these. */
static inline void trace_all(sim_trace *self, clod_sim *sim, const char *when)
{
    fprintf(self->out, "---- %s\n", when);
    trace_arrays(self, sim);
    trace_contacts(self, sim);
    trace_walls(self, sim);
    trace_sums(self, sim);
}

/** A row of the series. */
static inline void trace_row(sim_trace *self, clod_sim *sim)
{
    const clod_sim_column *columns;
    size_t count;
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    for (size_t k = 0; k < count; k++) {
        trace_numbers(self, columns[k].name, &columns[k].value, 1);
    }
}

/** Bytes of a file. */
static inline void trace_file(sim_trace *self, const char *path)
{
    FILE *in = fopen(path, "rb");
    uint64_t hash = 14695981039346656037u, bytes = 0; // FNV-1a
    int c;
    assert_non_null(in);
    while ((c = fgetc(in)) != EOF) {
        hash = (hash ^ (uint64_t)c) * 1099511628211u;
        bytes++;
    }
    fclose(in);
    fprintf(self->out, "file %s: %llu bytes, hash %llx\n", strrchr(path, '/') + 1,
            (unsigned long long)bytes, (unsigned long long)hash);
}

static inline void trace_close(sim_trace *self)
{
    assert_int_equal(fclose(self->out), 0);
}

/** The first line that differs is named, with the heading above it. */
static inline void trace_same(const sim_trace *a, const sim_trace *b, int ranks)
{
    const char *p = a->text, *q = b->text, *heading = "";
    while (*p != '\0' || *q != '\0') {
        const size_t m = strcspn(p, "\n"), n = strcspn(q, "\n");
        if (strncmp(p, "----", 4) == 0) {
            heading = p;
        }
        if (m != n || memcmp(p, q, m) != 0) {
            fail_msg("%d ranks, %.*s: '%.*s' in place of '%.*s'", ranks,
                     (int)strcspn(heading, "\n"), heading, (int)n, q, (int)m, p);
        }
        p += m + (p[m] != '\0');
        q += n + (q[n] != '\0');
    }
}
