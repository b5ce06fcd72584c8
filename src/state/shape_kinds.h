#pragma once
/**
 * @file shape_kinds.h
 * Shapes of walls as others see them, the case file too: one row for each clod_shape_kind. Others
 * ask the row, not which kind it is. The keys of a shape are in src/config/params_shape.c.
 */

#include <stdbool.h>

#include "clod/case.h"

struct clod_shape;

/** A rule between the keys of a shape that its section breaks. */
typedef struct clod_shape_fault {
    const char *key;  ///< "kind.key"; NULL: no rule is broken
    const char *text; ///< what is wrong with it, for the user
} clod_shape_fault;

/** What closest points are computed by (geometry/wall_closest.h): contacts of one form lie
 *  together. */
typedef enum clod_wall_form {
    CLOD_FORM_PLANE,
    CLOD_FORM_BOX,   ///< box, bar
    CLOD_FORM_SHELL, ///< disc, annulus, cylinder, cone
    CLOD_FORM_MESH,  ///< facets: found before the kernels run (step/touch.h)
    CLOD_FORMS
} clod_wall_form;

/** A shape is endless, solid, faceted, flat or a shell; those without a box are round about
 *  axis[2]. */
typedef struct clod_shape_kind_row {
    clod_wall_form form;
    bool endless;  ///< one-sided, without an edge
    bool solid;    ///< a box along axis[] with half sizes half[]
    bool boxed;    ///< within the box along axis[] with half sizes half[]
    bool faceted;  ///< facets of a mesh: clod_shape.surface
    bool conveyor; ///< its mesh is not in a file: clod makes it (setup/belt.h)
    bool flat;     ///< across its axis, between the radii inner and outer
    bool shell;    ///< along its axis, with the grains on one `side`
    bool straight; ///< radius outer from foot to top; else inner at the top
    bool file;     ///< its facets are read from a file of the user's
    /** Sizes and axes of the shape, of round ones the third axis only, from its keys. NULL: it is
     *  made from facets. */
    void (*make)(const clod_case_shape *from, struct clod_shape *shape);
    /** Area [m2] of its surface; NULL: it has no bound, or is that of facets. */
    double (*area)(const struct clod_shape *shape);
    /** The first rule between its keys that is broken; NULL: there are none here (those of belts
     *  are in src/config/check_belt.c). */
    clod_shape_fault (*fault)(const clod_case_shape *from);
} clod_shape_kind_row;

/**
 * Row of a kind of shape.
 *
 * Errors  none.   Threads  pure.   Test  tests/state/test_shape_kinds.c
 */
const clod_shape_kind_row *clod_shape_kinds_row(clod_shape_kind kind);
