#include "state/part_labels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "state/wear.h"

/** A surface of a wall. */
typedef struct labelled {
    const char *plain;              ///< its cleaned name; NULL: it has none
    char *to;                       ///< [CLOD_SURFACE_LABEL] where its label goes
    int32_t shape, face;            ///< of the wall, from 1
    bool twice;                     ///< another one has the same cleaned name
    char label[CLOD_SURFACE_LABEL]; ///< of one that is there twice
} labelled;

/** The surfaces of a wall: all by number, and the named ones in the order of their names. */
typedef struct labels {
    size_t count, named;
    labelled *of;       ///< [count]
    labelled **by_name; ///< [named]
} labels;

char clod_part_labels_clean(char of)
{
    if ((unsigned char)of < ' ' || strchr(",;\"[]", of) != NULL) {
        return '_';
    }
    return of;
}

static int compare_names(const void *left, const void *right)
{
    const labelled *a = *(labelled *const *)left, *b = *(labelled *const *)right;
    return strcmp(a->plain, b->plain);
}

static int compare(const void *left, const void *right)
{
    const labelled *a = *(labelled *const *)left, *b = *(labelled *const *)right;
    const int order = compare_names(left, right);
    return order != 0 ? order : (a->face > b->face) - (a->face < b->face);
}

/** Note the parts of a mesh, with their cleaned names as labels. */
static void note_mesh(labels *self, clod_surface *surface, int32_t shape, int32_t face)
{
    for (size_t p = 0; p < surface->part_count; p++) {
        labelled *of = &self->of[face + (int32_t)p];
        *of = (labelled){.shape = shape, .face = face + (int32_t)p + 1};
        const char *from = surface->part_name[p];
        char *to = surface->part_label[p];
        size_t at = 0;
        for (; from[at] != '\0'; at++) {
            to[at] = clod_part_labels_clean(from[at]);
        }
        to[at] = '\0';
        if (at > 0) {
            of->plain = of->to = to;
            self->by_name[self->named++] = of;
        }
    }
}

static void note_wall(labels *self, clod_wall *wall)
{
    int32_t number = 0;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        clod_shape *shape = &wall->shapes[s];
        const bool begins = clod_shape_begins_mesh(shape);
        number += shape->surface == NULL || begins;
        if (begins) {
            note_mesh(self, shape->surface, number, shape->face);
        }
    }
    qsort(self->by_name, self->named, sizeof *self->by_name, compare);
}

/** Whether a surface without a name is called so: by its number. */
static bool is_number(const labels *self, const char *label)
{
    const size_t digits = strspn(label, "0123456789");
    const long number = digits < 10 && label[digits] == '\0' ? strtol(label, NULL, 10) : 0;
    return number > 0 && (size_t)number <= self->count && label[0] != '0' &&
           self->of[number - 1].plain == NULL;
}

/** Find those that share their names. */
static void find_twice(labels *self)
{
    for (size_t k = 0; k < self->named; k++) {
        labelled *of = self->by_name[k];
        labelled *before = k > 0 ? self->by_name[k - 1] : NULL;
        if (before != NULL && strcmp(before->plain, of->plain) == 0) {
            before->twice = of->twice = true;
        } else {
            of->twice = is_number(self, of->plain);
        }
    }
}

/** Whether a label is the cleaned name of a surface, or that of one of the first `made`: two that do not end as "NAME
 *  (2)" does begin with different shapes or go on with different names. */
static bool is_taken(const labels *self, const char *label, size_t made)
{
    labelled asked = {.plain = label};
    labelled *const key = &asked;
    bool taken =
        bsearch(&key, self->by_name, self->named, sizeof *self->by_name, compare_names) != NULL;
    const bool may_be = label[strlen(label) - 1] == ')';
    for (size_t k = 0; may_be && k < made && !taken; k++) {
        taken = self->by_name[k]->twice && strcmp(self->by_name[k]->label, label) == 0;
    }
    return taken;
}

/** Labels of those that share their names; in the order of names, so that equal ones follow. */
static void tell_apart(const labels *self)
{
    int number = 0; // behind the label
    for (size_t k = 0; k < self->named; k++) {
        labelled *of = self->by_name[k];
        const labelled *before = k > 0 ? self->by_name[k - 1] : NULL;
        const bool goes_on = before != NULL && before->shape == of->shape &&
                             strcmp(before->plain, of->plain) == 0;
        number = goes_on ? number : 0;
        while (of->twice && (of->label[0] == '\0' || is_taken(self, of->label, k))) {
            number++;
            char more[16] = "";
            if (number > 1) {
                snprintf(more, sizeof more, " (%d)", number);
            }
            snprintf(of->label, sizeof of->label, "%d.%s%s", (int)of->shape, of->plain, more);
        }
    }
    for (size_t k = 0; k < self->named; k++) {
        if (self->by_name[k]->twice) {
            memcpy(self->by_name[k]->to, self->by_name[k]->label, CLOD_SURFACE_LABEL);
        }
    }
}

bool clod_part_labels_make(clod_wall *wall)
{
    clod_wear_number(wall);
    const size_t count = (size_t)clod_wear_faces(wall);
    labels self = {.count = count,
                   .of = clod_memory_alloc(count + 1, sizeof *self.of),
                   .by_name = clod_memory_alloc(count + 1, sizeof *self.by_name)};
    const bool good = self.of != NULL && self.by_name != NULL;
    if (good) {
        note_wall(&self, wall);
        find_twice(&self);
        tell_apart(&self);
    }
    clod_memory_free(self.of);
    clod_memory_free(self.by_name);
    return good;
}

bool clod_part_labels_asked(const clod_surface *surface, size_t part, const char *text)
{
    return strcmp(surface->part_name[part], text) == 0 ||
           strcmp(surface->part_label[part], text) == 0;
}
