#pragma once
/**
 * @file picture_arguments.h
 * Values of options that all pictures have; a wrong one ends the program with its message.
 */

#include <argp.h>

#define CLOD_APP_PICTURE_WIDTH 1600
#define CLOD_APP_PICTURE_HEIGHT 1000

/** Number of a name in a list, or -1. */
int clod_app_picture_name(const char *name, const char *const *list, int count);

/** Read a whole number; `end` is what must follow it. -1: there is none, or it is too large. */
int clod_app_picture_whole(const char **text, char end, int most);

/** "1600x1000", in pixels. */
void clod_app_picture_size(struct argp_state *state, const char *text, int *width, int *height);

/** The name of a clod_picture_view. */
void clod_app_picture_view(struct argp_state *state, const char *text, int *view);

/** Refuse a file whose name has an ending that is not .png, since PNG is what is written. */
void clod_app_picture_png(struct argp_state *state, const char *option, const char *path);
