#pragma once
/**
 * @file figure.h
 * A figure as data: axes, curves, and a map of colours below them. Drawn by SVG (figure_svg.h), and
 * in the page by its scripts from the same numbers as JSON (figure_json.h).
 */

#include <stdbool.h>
#include <stddef.h>

#include "state/wear.h"

/** Colours that people with any colour vision tell apart (Okabe and Ito 2008), but yellow. */
#define CLOD_FIGURE_COLOURS 7
extern const char *const CLOD_FIGURE_COLOUR[CLOD_FIGURE_COLOURS];
#define CLOD_FIGURE_GREY (-1) ///< for what is not data: class borders, circles of reference
extern const char *const CLOD_FIGURE_GREY_COLOUR;

/** Rounds of the colours: lines of one style have other dashes, points other marks in each of them. */
#define CLOD_FIGURE_ROUNDS 4

/** Bytes of a name: that of any surface, and what a column measures of it. */
#define CLOD_FIGURE_NAME (CLOD_WEAR_NAME + 64)
#define CLOD_FIGURE_TITLE (CLOD_FIGURE_NAME + 96)

#define CLOD_FIGURE_MOST 2000 ///< points of a curve

typedef enum clod_figure_style {
    CLOD_FIGURE_LINE,
    CLOD_FIGURE_DASHED,
    CLOD_FIGURE_DOTTED,
    CLOD_FIGURE_DASH_DOT,
    CLOD_FIGURE_POINTS,
    CLOD_FIGURE_HOLLOW, ///< points with no filling
    CLOD_FIGURE_DOTS,   ///< small points, of which there are many
    CLOD_FIGURE_READ,   ///< points on a curve of their colour, with a black edge
    CLOD_FIGURE_VAGUE,  ///< the same with no filling, and an edge of their colour
    CLOD_FIGURE_THIN,   ///< a line that is thinner than those of data
    CLOD_FIGURE_ARROWS, ///< a line on a light edge, to be seen on any colour of a map
    CLOD_FIGURE_STYLES,
} clod_figure_style;

typedef struct clod_figure_curve {
    char name[CLOD_FIGURE_NAME]; ///< in the legend; "": not in it
    clod_figure_style style;
    int colour;    ///< below CLOD_FIGURE_COLOURS, or grey
    int round;     ///< below CLOD_FIGURE_ROUNDS
    double *x, *y; ///< [count] owned, as in the files; NaN: a gap
    double *error; ///< [count] owned: standard error of y; NULL: none
    size_t count;
} clod_figure_curve;

/** Numbers of the files are times `factor` in `unit`. */
typedef struct clod_figure_axis {
    char text[64];
    char unit[16]; ///< "": a plain number
    double factor;
} clod_figure_axis;

/** Numbers of equal cells over a rectangle, shown by colours (figure_map.h). */
typedef struct clod_figure_map {
    clod_figure_axis value; ///< what the colours tell
    size_t columns, rows;
    double low[2];      ///< lower left corner, as in the files
    double step[2];     ///< width and height of a cell
    double least, most; ///< what the first and the last colour stand for, as in the files
    double *number; ///< [rows * columns] owned, rows upwards; NaN: blank; NULL: there is no map
} clod_figure_map;

typedef struct clod_figure {
    char name[128];                ///< of its file: letters, digits and -
    char title[CLOD_FIGURE_TITLE]; ///< what it shows
    char note[400];                ///< a sentence below; "": none
    clod_figure_axis x, y;
    clod_figure_map map;       ///< below the curves; the axes are its edges
    bool equal;                ///< both axes have the same scale
    bool from_zero;            ///< both axes begin at 0
    bool log_x;                ///< the x axis is logarithmic; its numbers are above 0
    clod_figure_curve *curves; ///< [count] owned
    size_t count;
    char again
        [CLOD_FIGURE_NAME]; ///< the first curve in the legend that looks like an earlier one; "": none
    bool lost;              ///< there was no memory for something
} clod_figure;

/** An empty figure. */
void clod_figure_init(clod_figure *self, const char *name, const char *title);

/** Say what an axis shows. @param unit  of the page; the factor brings the files' numbers there */
void clod_figure_axis_set(clod_figure_axis *self, const char *text, const char *unit,
                          double factor);

/**
 * Add a curve of `count` points. Of more than CLOD_FIGURE_MOST only the least and the greatest y of
 * every group of neighbours are kept, and the ends.
 *
 * @param number  of the curve's colour, from 0 on: behind the last colour the next round begins, and
 *                behind the last round all come `again`; or CLOD_FIGURE_GREY
 * @param error  [count] standard errors of y, or NULL
 * Errors  `lost` is set.   Threads  one per figure.   Test  tests/report/test_figure.c
 */
void clod_figure_add(clod_figure *self, const char *name, clod_figure_style style, int number,
                     size_t count, const double *x, const double *y, const double *error);

/** Add the upper half of a circle about (centre, 0); nothing where it is not finite. */
void clod_figure_circle(clod_figure *self, const char *name, clod_figure_style style,
                        int number, double centre, double radius);

/**
 * Dashes of a curve in pixels, dash and gap by turns with blanks between; "": a solid line, or marks. No two
 * of the styles but grey and thin ones and of their rounds are alike.
 *
 * Threads pure.   Test  tests/report/test_figure.c
 */
const char *clod_figure_dashes(const clod_figure_curve *curve);

/** A sentence about curves that look like others, for legend and page; false: there are none. */
bool clod_figure_alike(const clod_figure *self, char text[256]);

/** The row before the first whose x is not 0: till then a test is filled and loaded in one place. */
size_t clod_figure_begin(const double *x, size_t rows);

/** Whether any curve has a point, or the map a number. */
bool clod_figure_shows(const clod_figure *self);

/** Free the content; an empty figure is fine. */
void clod_figure_fini(clod_figure *self);
