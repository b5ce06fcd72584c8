#pragma once
/**
 * @file check.h
 * Checks across keys, after every key has been read by itself.
 */

#include "config/load.h"

/** Check a whole case whose keys have been read; complete what follows from them. */
void clod_check_case(clod_loader *loader, clod_case *self);

/** Checks of every tester that is there (check_tester.c). */
void clod_check_tester(clod_loader *loader, clod_case *self);

/** What the checks of all testers share (check_tester.c): radii of the grains of `section`;
 *  weight of a solid of some height, as dense as filling assumes [Pa]; gravity of a `cell`. */
void clod_check_tester_radius(clod_loader *loader, const char *section, double mean, double min,
                              double max);
double clod_check_tester_weight(const clod_case *self, const char *material, double fraction,
                                double height);
void clod_check_tester_gravity(clod_loader *loader, const clod_case *self, const char *cell);

/** Weight of the solid above a shear plane [Pa], and in words where it is. */
typedef struct clod_check_above {
    double weight;
    const char *where;
} clod_check_above;

/** Checks of the programme of the shear tester `section` (check_programme.c). */
void clod_check_programme(clod_loader *loader, const char *section,
                          const clod_case_programme *programme, const clod_check_above *above);

/** Checks of the section of one tester (check_tester.c); rows in testers.c. */
void clod_check_ring_shear(clod_loader *loader, const clod_case *self);
void clod_check_jenike(clod_loader *loader, const clod_case *self);
void clod_check_uniaxial(clod_loader *loader, const clod_case *self);
void clod_check_wall_friction(clod_loader *loader,
                              const clod_case *self); // check_wall_friction.c
void clod_check_contact_bench(clod_loader *loader, const clod_case *self);

/** Checks of grains, walls, stages and domain (check_run.c). */
void clod_check_run(clod_loader *loader, clod_case *self);

/** Checks of a group of grains with an inlet; `path` is that of the group (check_inlet.c). */
void clod_check_inlet(clod_loader *loader, const char *path, const clod_case *self,
                      const clod_case_grains *grains);

/** Complain when a region is empty; `path` is that of what has it (check_region.c). */
bool clod_check_region(clod_loader *loader, const char *path, const clod_case_region *region);

/** Complain when nothing of a region is in the domain, or when it reaches beyond a periodic side:
 *  grains there would count twice. `path` as above. */
bool clod_check_region_place(clod_loader *loader, const clod_case *self, const char *path,
                             const clod_case_region *region);

/** Whether streams that come in have room, once each group is right (check_stream.c). */
void clod_check_streams(clod_loader *loader, const clod_case *self);

/** Solid fraction of a stream that random places without overlap still allow, with some ease. */
#define CLOD_CHECK_DENSE 0.25

/**
 * Solid fraction at the bottom of the region of an inlet whose grains come at rest and fall out of it, with all that
 * come at rest in the same space: grains from all heights pass there, each at sqrt(2 g y) after y, so volume flow
 * times sqrt(2 h/g) over the volume, h the region's height along gravity. It is half as much again as the mean.
 * @param index  of the group
 * @return       infinite without gravity
 */
double clod_check_rest_fraction(const clod_case *self, size_t index);

/** Bytes of the text of clod_check_falls_back. */
#define CLOD_CHECK_BACK_TEXT 240

/** Whether grains of an inlet are thrown upwards so slowly that they turn inside their region and fall back
 *  through it; and how far they rise, and the speed that would do (check_stream.c, region_clear.h). */
bool clod_check_falls_back(const clod_case *self, size_t index,
                           char text[CLOD_CHECK_BACK_TEXT]);

/** Check the face that grains come through, and complete it (check_region.c). */
bool clod_check_face(clod_loader *loader, const char *path, clod_case_grains *grains);

/** Checks of the outlets (check_outlet.c). */
void clod_check_outlets(clod_loader *loader, const clod_case *self);

/** Checks of the gauges, and of the time from which means count (check_gauge.c). */
void clod_check_gauges(clod_loader *loader, const clod_case *self);

/** Checks of the fields (check_field.c). */
void clod_check_fields(clod_loader *loader, const clod_case *self);

/** Checks of mixing indices and angles of repose (check_mixing.c). */
void clod_check_mixing(clod_loader *loader, const clod_case *self);

/** Checks of clumps, build-up and the map of histories (check_clumps.c). */
void clod_check_clumps(clod_loader *loader, const clod_case *self);

/** Checks of a shape that is a belt; `path` is that of the shape (check_belt.c). */
void clod_check_belt(clod_loader *loader, const char *path, const clod_case_shape *shape);

/** Checks of the walls alone (check_run.c). */
void clod_check_walls(clod_loader *loader, const clod_case *self);

/** Whether a wall oscillates across the axis of its load, if it has both: the servo moves it along
 *  that axis, and nothing else may do so at will (check_run.c). */
bool clod_check_sways_across(const clod_case_wall *wall);

/** Complain about keys that the table says have no effect in this case (check_unused.c). */
void clod_check_unused(clod_loader *loader, const clod_case *self);

/** Whether grains of material a or b can meet the other. */
bool clod_check_pair_needed(const clod_case *self, int a, int b);

/** Complain at a path, or at the deepest part of it that was written. */
void clod_check_fail(clod_loader *loader, const char *path, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/**
 * "; did you mean feed?" when a wall's name is near to `name`, else "; walls are feed, chute".
 *
 * @param belts  only walls that have a belt
 * @param text   [size] [out]
 * @return       text
 */
const char *clod_check_walls_text(const clod_case *self, const char *name, bool belts,
                                  char *text, size_t size);

/** Whether a shape of the wall is a belt. */
bool clod_check_has_belt(const clod_case_wall *wall);

/** Whether a path was written in the case. */
bool clod_check_has(const clod_loader *loader, const char *path);

/** The one of two paths that was written; the first when both were, or none. */
const char *clod_check_written(const clod_loader *loader, const char *first,
                               const char *second);

/** Of a stress: two that differ by no more are one, for a lid holds its stress no better. */
#define CLOD_CHECK_APART 0.01

/**
 * Complain about the first value of the list at `path` that is one that stands there already.
 *
 * @param values  [count]
 * @param apart   values no further apart are the same [Pa]
 * @param same    what comes of two that are the same
 */
void clod_check_apart(clod_loader *loader, const char *path, const double *values, size_t count,
                      double apart, const char *same);

/** Complain when `name`, written at `path`, is not a material. */
void clod_check_material(clod_loader *loader, const clod_case *self, const char *path,
                         const char *name);
