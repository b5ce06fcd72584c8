#pragma once
/**
 * @file wall_facets.h
 * Patches of meshes in the rows of walls: where other shapes have their geometry, a patch has the
 * pose of its wall, by which points of space come into the frame of its facets.
 *
 *   row 0          x y z [m] of the wall's origin in space, CLOD_WALL_MESH
 *   row 1 to 3     a row of the rotation from the frame to space; x, y, z [m] of the origin in
 *                  the frame
 */

#include "geometry/wall_closest.h"
#include "geometry/wall_pose.h"

/** Put a pose into the rows of a patch. */
static inline void clod_wall_facets_put(const clod_wall_pose *pose, double (*row)[4])
{
    const double point[3] = {pose->point.x, pose->point.y, pose->point.z};
    clod_vec3_put(row[0], pose->origin);
    row[0][3] = CLOD_WALL_MESH;
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            row[1 + a][b] = pose->rotation[a][b];
        }
        row[1 + a][3] = point[a];
    }
}

/** The pose in the rows of a patch. */
static inline clod_wall_pose clod_wall_facets_pose(const double (*row)[4])
{
    clod_wall_pose pose = {.origin = clod_vec3_of(row[0]),
                           .point = {row[1][3], row[2][3], row[3][3]}};
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            pose.rotation[a][b] = row[1 + a][b];
        }
    }
    pose.stays = clod_wall_pose_stays(&pose);
    return pose;
}
