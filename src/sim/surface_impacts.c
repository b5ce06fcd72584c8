#include "sim/surface_impacts.h"

#include <math.h>

#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "output/folder_files.h"
#include "output/series.h"
#include "state/wear.h"

#define DEGREES (180.0 / M_PI)
#define CLASS_DEGREES (90.0 / CLOD_IMPACT_ANGLES)

// ---- series

const char *const CLOD_SURFACE_IMPACTS_COLUMN[CLOD_SURFACE_IMPACTS_COLUMNS] = {
    "impact_angle [deg]", "impact_speed [m/s]"};

double *clod_surface_impacts_row(clod_impacts *self, double *row)
{
    const clod_impact_sums *now = &self->all, *last = &self->row;
    const double number = now->number - last->number; // 0: the means are NAN
    *row++ = DEGREES * (now->angle - last->angle) / number;
    *row++ = (now->speed - last->speed) / number;
    self->row = self->all;
    return row;
}

// ---- means

/** Mean and standard deviation over impacts, of which there is one at least. */
typedef struct spread {
    double mean, deviation;
} spread;

static spread spread_of(double number, double sum, double squares, double unit)
{
    const double mean = sum / number;
    return (spread){unit * mean, unit * sqrt(fmax(0.0, squares / number - mean * mean))};
}

/** Means of a surface. */
typedef struct means {
    spread angle, speed, normal; ///< deg, m/s, J
} means;

static means means_of(const clod_impact_sums *all)
{
    return (means){spread_of(all->number, all->angle, all->angle2, DEGREES),
                   spread_of(all->number, all->speed, all->speed2, 1.0),
                   spread_of(all->number, all->normal, all->normal2, 1.0)};
}

// ---- report

static void report_face(FILE *out, const clod_wall *wall, int32_t face)
{
    const clod_impact_sums *all = &clod_wear_impacts(wall, face)->all;
    if (all->number > 0.0) {
        const means of = means_of(all);
        char name[CLOD_WEAR_NAME];
        clod_wear_name(wall, face, name, sizeof name);
        fprintf(out, "  %-22s %9.0f %6.1f +- %4.1f %9.4g +- %-9.3g %9.4g +- %-9.3g\n", name,
                all->number, of.angle.mean, of.angle.deviation, of.speed.mean,
                of.speed.deviation, of.normal.mean, of.normal.deviation);
    }
}

void clod_surface_impacts_report(FILE *out, const clod_walls *walls)
{
    double number = 0.0;
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t f = 0; f < clod_wear_summed(&walls->wall[w]); f++) {
            number += clod_wear_impacts(&walls->wall[w], f)->all.number;
        }
    }
    if (number > 0.0) {
        fprintf(out, "  %-22s %9s %14s %22s %22s  +- of the impacts\n", "impacts", "number",
                "angle [deg]", "speed [m/s]", "normal energy [J]");
    }
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t f = 0; f < clod_wear_summed(&walls->wall[w]); f++) {
            report_face(out, &walls->wall[w], f);
        }
    }
}

// ---- summary

static json_t *class_json(const char *unit, double from, double to, clod_impact_class of)
{
    char low[16], high[16];
    snprintf(low, sizeof low, "from_%s", unit);
    snprintf(high, sizeof high, "to_%s", unit);
    return json_pack("{s:f, s:o, s:I, s:f, s:f}", low, from, high, clod_json_number(to),
                     "number", (json_int_t)of.number, "energy_J", of.energy, "normal_energy_J",
                     of.normal);
}

/** Of class_json. */
#define CLASS_PATHS "number energy_J normal_energy_J"

static json_t *spread_json(spread of)
{
    return json_pack("{s:f, s:f}", "mean", of.mean, "deviation", of.deviation);
}

void clod_surface_impacts_paths(clod_free_paths *paths, const char *faces)
{
    char before[96];
    snprintf(before, sizeof before, "%s.impacts", faces);
    clod_free_paths_add(paths, before,
                        "number energy_J normal_energy_J angle_deg.mean angle_deg.deviation "
                        "speed_m_per_s.mean speed_m_per_s.deviation each_normal_energy_J.mean "
                        "each_normal_energy_J.deviation");
    snprintf(before, sizeof before, "%s.impacts.by_angle.[0-%d]", faces,
             CLOD_IMPACT_ANGLES - 1);
    clod_free_paths_add(paths, before, "from_deg to_deg " CLASS_PATHS);
    snprintf(before, sizeof before, "%s.impacts.by_normal_energy.[0-%d]", faces,
             CLOD_IMPACT_ENERGIES - 1);
    clod_free_paths_add(paths, before, "from_J to_J " CLASS_PATHS);
}

json_t *clod_surface_impacts_json(const clod_impacts *self)
{
    const clod_impact_sums *all = &self->all;
    json_t *one = json_pack("{s:I, s:f, s:f}", "number", (json_int_t)all->number, "energy_J",
                            all->energy, "normal_energy_J", all->normal);
    if (all->number > 0.0) {
        const means of = means_of(all);
        json_object_set_new(one, "angle_deg", spread_json(of.angle));
        json_object_set_new(one, "speed_m_per_s", spread_json(of.speed));
        json_object_set_new(one, "each_normal_energy_J", spread_json(of.normal));
    }
    json_t *angles = json_array(), *energies = json_array();
    for (int a = 0; a < CLOD_IMPACT_ANGLES; a++) {
        json_array_append_new(angles,
                              class_json("deg", CLASS_DEGREES * a, CLASS_DEGREES * (a + 1),
                                         clod_impacts_at_angle(self, a)));
    }
    for (int e = 0; e < CLOD_IMPACT_ENERGIES; e++) {
        const clod_impact_class of = clod_impacts_with_energy(self, e);
        if (of.number > 0.0) {
            json_array_append_new(energies, class_json("J", clod_impacts_energy_from(e),
                                                       clod_impacts_energy_from(e + 1), of));
        }
    }
    json_object_set_new(one, "by_angle", angles);
    json_object_set_new(one, "by_normal_energy", energies);
    return one;
}

// ---- impacts.csv

/** Columns behind the name of the surface. */
#define COLUMNS 7

static void print_face(FILE *out, const clod_wall *wall, int32_t face)
{
    const clod_impacts *self = clod_wear_impacts(wall, face);
    char name[CLOD_WEAR_NAME];
    clod_wear_name(wall, face, name, sizeof name);
    for (int a = 0; a < CLOD_IMPACT_ANGLES; a++) {
        for (int e = 0; e < CLOD_IMPACT_ENERGIES; e++) {
            const clod_impact_class *of = &self->of[a][e];
            const double row[COLUMNS] = {CLASS_DEGREES * a,
                                         CLASS_DEGREES * (a + 1),
                                         clod_impacts_energy_from(e),
                                         clod_impacts_energy_from(e + 1),
                                         of->number,
                                         of->energy,
                                         of->normal};
            for (int c = 0; of->number > 0.0 && c < COLUMNS; c++) {
                char number[CLOD_SERIES_NUMBER];
                clod_series_number(number, row[c]);
                fprintf(out, "%s,%s%s", c == 0 ? name : "", number,
                        c + 1 < COLUMNS ? "" : "\n");
            }
        }
    }
}

/** Owned text of the table; NULL without memory. */
static char *make_table(const clod_walls *walls)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs("surface,angle_from [deg],angle_to [deg],normal_energy_from [J],normal_energy_to "
          "[J],impacts [1],energy [J],normal_energy [J]\n",
          out);
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t f = 0; f < clod_wear_summed(&walls->wall[w]); f++) {
            print_face(out, &walls->wall[w], f);
        }
    }
    return clod_text_close(&text);
}

bool clod_surface_impacts_write(const clod_folder *folder, const void *memory,
                                const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    if (!now->from->output.surfaces || now->state->walls.count == 0) {
        return true;
    }
    char *text = make_table(&now->state->walls);
    const bool good = clod_folder_write(folder, "impacts.csv", text, status);
    clod_memory_free(text);
    return good;
}
