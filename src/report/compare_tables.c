#include "report/compare_tables.h"

#include "base/memory.h"
#include "report/compare_seeds.h"
#include "report/shear.h"
#include "report/shear_points.h"
#include "report/shear_rows.h"
#include "report/uniaxial_rows.h"
#include "report/wall_page.h"

/** Subjects of a table: objects of runs by their place in each run, as the yield loci of several
 *  preshear stresses; behind them a laboratory's, and means. */
typedef struct subjects {
    clod_result_of *of; ///< [count] owned
    json_t **means;     ///< [mean_count] owned
    char (*names)[64];  ///< [mean_count] owned: how means are called
    size_t count, mean_count, room;
} subjects;

static const json_t *locus_of(const json_t *summary, size_t g)
{
    return clod_shear_locus(json_object_get(summary, "locus"), g);
}

static const json_t *strength_of(const json_t *summary, size_t g)
{
    return json_array_get(json_object_get(summary, "flow_function"), g);
}

static const json_t *wall_of(const json_t *summary, size_t g)
{
    const json_t *locus = json_object_get(summary, "wall_locus");
    return g == 0 && json_is_object(locus) ? locus : NULL;
}

static size_t objects_of(const json_t *summary, clod_compare_object get)
{
    size_t count = 0;
    while (get(summary, count) != NULL) {
        count++;
    }
    return count;
}

/** The means of a group: one for each object, if all its runs have as many. */
static bool add_means(subjects *self, const clod_compare_tables *tables,
                      const clod_run_files *runs, const clod_compare_seeds *seeds, size_t first)
{
    const clod_compare_object get = tables->get;
    const size_t size = clod_compare_seeds_size(seeds, first);
    const size_t each = size > 1 ? objects_of(runs[first].summary, get) : 0;
    const json_t **members = clod_memory_alloc(size + 1, sizeof *members);
    bool good = members != NULL;
    for (size_t g = 0; good && g < each; g++) {
        size_t found = 0;
        for (size_t k = first; k < seeds->count; k++) {
            const bool mine = seeds->group[k] == first;
            if (mine && objects_of(runs[k].summary, get) == each) {
                members[found++] = get(runs[k].summary, g);
            }
        }
        if (found == size) {
            const size_t m = self->mean_count;
            self->means[m] =
                clod_compare_seeds_mean(tables->rows, tables->row_count, members, size);
            clod_compare_seeds_name(seeds, first, self->names[m]);
            good = self->means[m] != NULL;
            self->mean_count++;
            self->of[self->count++] =
                (clod_result_of){.name = self->names[m], .from = self->means[m], .mean = true};
        }
    }
    clod_memory_free(members);
    return good;
}

static bool list_subjects(subjects *self, const clod_compare_tables *tables,
                          const clod_run_files *runs, const clod_compare_seeds *seeds,
                          const json_t *lab)
{
    const clod_compare_object get = tables->get;
    size_t room = lab != NULL ? objects_of(lab, get) + 1 : 1;
    for (size_t k = 0; k < seeds->count; k++) {
        room += 2 * objects_of(runs[k].summary, get);
    }
    self->of = clod_memory_alloc(room, sizeof *self->of);
    self->means = clod_memory_alloc(room, sizeof *self->means);
    self->names = clod_memory_alloc(room, sizeof *self->names);
    bool good = self->of != NULL && self->means != NULL && self->names != NULL;
    for (size_t k = 0; good && k < seeds->count; k++) {
        const json_t *one;
        for (size_t g = 0; (one = get(runs[k].summary, g)) != NULL; g++) {
            self->of[self->count++] = (clod_result_of){.name = runs[k].name, .from = one};
        }
    }
    for (size_t k = 0; good && k < seeds->count; k++) {
        good = add_means(self, tables, runs, seeds, k);
    }
    const json_t *one;
    for (size_t g = 0; good && (one = get(lab, g)) != NULL; g++) {
        self->of[self->count++] = (clod_result_of){.name = "laboratory", .from = one};
    }
    return good;
}

static void put_all(clod_writer out, const clod_compare_tables *tables, const subjects *all)
{
    size_t first = 0;
    for (size_t k = 0; k < tables->count; k++) {
        const clod_compare_table *one = &tables->table[k];
        if (one->title != NULL) {
            clod_writer_mark(out, "<h3>", "\n");
            clod_writer_text(out, one->title);
            clod_writer_mark(out, "</h3>\n", "\n");
        }
        clod_result_table_put(out, tables->rows + first, one->rows, all->of, all->count);
        if (one->note != NULL) {
            clod_writer_mark(out, "<p class=\"note\">", "");
            clod_writer_text(out, one->note);
            clod_writer_mark(out, "</p>\n", "\n");
        }
        first += one->rows;
    }
}

bool clod_compare_tables_put(clod_writer out, const clod_compare_tables *self,
                             const clod_run_files *runs, size_t count, const json_t *lab,
                             clod_status *status)
{
    subjects all = {.count = 0};
    clod_compare_seeds seeds;
    bool good = clod_compare_seeds_find(&seeds, runs, count, status);
    if (good && !list_subjects(&all, self, runs, &seeds, lab)) {
        good = clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    }
    if (good) {
        put_all(out, self, &all);
        if (all.mean_count > 0) {
            clod_compare_seeds_note(out, &seeds, runs);
        }
        clod_compare_seeds_twins(out, &seeds, runs);
    }
    for (size_t k = 0; k < all.mean_count; k++) {
        json_decref(all.means[k]);
    }
    clod_memory_free(all.of);
    clod_memory_free(all.means);
    clod_memory_free(all.names);
    clod_compare_seeds_fini(&seeds);
    return good;
}

/** Results that a test has one of for each run, and their key in the laboratory's column. */
typedef struct loci {
    const char *key;
    const clod_result_row *rows;
    size_t row_count;
    clod_compare_object get;
} loci;

static bool put_loci(clod_writer out, const loci *self, const clod_run_files *runs,
                     size_t count, const json_t *lab, clod_status *status)
{
    const clod_compare_table whole = {.rows = self->row_count};
    const clod_compare_tables tables = {&whole, 1, self->rows, self->row_count, self->get};
    json_t *beside = lab != NULL ? json_pack("{s:O}", self->key, lab) : NULL;
    const bool good =
        lab != NULL && beside == NULL
            ? clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.")
            : clod_compare_tables_put(out, &tables, runs, count, beside, status);
    json_decref(beside);
    return good;
}

bool clod_compare_tables_shear(clod_writer out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status)
{
    const loci own = {"locus", CLOD_SHEAR_ROWS, CLOD_SHEAR_ROW_COUNT, locus_of};
    for (size_t k = 0; k < count; k++) {
        clod_shear_points_preshear(&runs[k]);
    }
    json_t *beside = lab != NULL ? clod_shear_lab_beside(lab, runs, count) : NULL;
    const bool good =
        lab != NULL && beside == NULL
            ? clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.")
            : put_loci(out, &own, runs, count, beside, status);
    if (good) {
        clod_shear_lab_density(out, lab, runs, count);
    }
    json_decref(beside);
    return good;
}

bool clod_compare_tables_wall(clod_writer out, const clod_run_files *runs, size_t count,
                              const json_t *lab, clod_status *status)
{
    const loci own = {"wall_locus", CLOD_WALL_PAGE_ROWS, CLOD_WALL_PAGE_ROW_COUNT, wall_of};
    return put_loci(out, &own, runs, count, lab, status);
}

bool clod_compare_tables_uniaxial(clod_writer out, const clod_run_files *runs, size_t count,
                                  const json_t *lab, clod_status *status)
{
    const loci own = {"flow_function", CLOD_UNIAXIAL_ROWS, CLOD_UNIAXIAL_ROW_COUNT,
                      strength_of};
    (void)lab;
    return put_loci(out, &own, runs, count, NULL, status);
}
