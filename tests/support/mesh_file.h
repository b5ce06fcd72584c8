#pragma once
/**
 * @file mesh_file.h
 * Meshes that tests write as files: facets by corners [m], in STL as text, with all digits.
 */

#include <limits.h>
#include <stdio.h>

#include "support/check.h"

/** A file of facets that is being written. */
typedef struct mesh_file {
    char path[PATH_MAX];
    FILE *file;
} mesh_file;

static inline mesh_file mesh_file_open(const char *folder, const char *name)
{
    mesh_file self = {.file = NULL};
    snprintf(self.path, sizeof self.path, "%s/%s.stl", folder, name);
    self.file = fopen(self.path, "w");
    assert_non_null(self.file);
    fprintf(self.file, "solid made\n");
    return self;
}

static inline void mesh_file_facet(mesh_file *self, const double a[3], const double b[3],
                                   const double c[3])
{
    const double *corners[] = {a, b, c};
    fprintf(self->file, "facet normal 0 0 0\nouter loop\n");
    for (int k = 0; k < 3; k++) {
        fprintf(self->file, "vertex %.9g %.9g %.9g\n", corners[k][0], corners[k][1],
                corners[k][2]);
    }
    fprintf(self->file, "endloop\nendfacet\n");
}

/** The parallelogram from `at` along u and v in n by m pieces of two facets. */
static inline void mesh_file_sheet(mesh_file *self, const double at[3], const double u[3],
                                   const double v[3], int n, int m)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < m; j++) {
            double p[4][3];
            for (int k = 0; k < 4; k++) {
                const double x = (double)(i + (k == 1 || k == 2)) / n;
                const double y = (double)(j + (k == 2 || k == 3)) / m;
                for (int a = 0; a < 3; a++) {
                    p[k][a] = at[a] + x * u[a] + y * v[a];
                }
            }
            mesh_file_facet(self, p[0], p[1], p[2]);
            mesh_file_facet(self, p[0], p[2], p[3]);
        }
    }
}

static inline void mesh_file_close(mesh_file *self)
{
    fprintf(self->file, "endsolid made\n");
    assert_int_equal(fclose(self->file), 0);
}
