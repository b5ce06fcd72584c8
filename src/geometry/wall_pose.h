#pragma once
/**
 * @file wall_pose.h
 * Where a wall is at one moment: from space into the frame in which its shapes were given, and
 * back.
 */

#include "state/walls.h"

typedef struct clod_wall_pose {
    clod_vec3 origin;      ///< m, the spin point in space: spin_point + shift
    clod_vec3 point;       ///< m, the spin point in the frame
    double rotation[3][3]; ///< from the frame to space
    bool stays;            ///< the frame is that of space; false: that is not known
} clod_wall_pose;

/** The pose at angle 0. Threads: pure. */
static inline clod_wall_pose clod_wall_pose_at_rest(const clod_wall *wall)
{
    clod_wall_pose pose = {.origin = clod_vec3_add(wall->spin_point, wall->shift),
                           .point = wall->spin_point};
    clod_quat_matrix(clod_wall_orientation(wall), pose.rotation);
    return pose;
}

/** Pose of a wall now; turned by exactly nothing when its angle is 0. Threads: pure. */
static inline clod_wall_pose clod_wall_pose_now(const clod_wall *wall)
{
    const double u[3] = {wall->spin_axis.x, wall->spin_axis.y, wall->spin_axis.z};
    const double c = cos(wall->angle);
    const double s = sin(wall->angle);
    const double cross[3][3] = {{0.0, -u[2], u[1]}, {u[2], 0.0, -u[0]}, {-u[1], u[0], 0.0}};
    const clod_wall_pose rest = clod_wall_pose_at_rest(wall);
    double turn[3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) { // Rodrigues: c 1 + s [u]x + (1 - c) u u^T
            const double diagonal = i == j ? c : 0.0;
            turn[i][j] = diagonal + s * cross[i][j] + (1.0 - c) * u[i] * u[j];
        }
    }
    clod_wall_pose pose = rest;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            pose.rotation[i][j] = turn[i][0] * rest.rotation[0][j] +
                                  turn[i][1] * rest.rotation[1][j] +
                                  turn[i][2] * rest.rotation[2][j];
        }
    }
    return pose;
}

/** Whether the frame is that of space: the wall has never moved. */
static inline bool clod_wall_pose_stays(const clod_wall_pose *pose)
{
    bool stays = pose->origin.x == pose->point.x && pose->origin.y == pose->point.y &&
                 pose->origin.z == pose->point.z;
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            stays &= pose->rotation[a][b] == (a == b ? 1.0 : 0.0);
        }
    }
    return stays;
}

/** A point of space in the wall's frame [m]. */
static inline clod_vec3 clod_wall_to_frame(const clod_wall_pose *pose, clod_vec3 p)
{
    if (pose->stays) {
        return p;
    }
    const double(*r)[3] = pose->rotation;
    const clod_vec3 d = clod_vec3_sub(p, pose->origin);
    return (clod_vec3){pose->point.x + r[0][0] * d.x + r[1][0] * d.y + r[2][0] * d.z,
                       pose->point.y + r[0][1] * d.x + r[1][1] * d.y + r[2][1] * d.z,
                       pose->point.z + r[0][2] * d.x + r[1][2] * d.y + r[2][2] * d.z};
}

/** A direction given in the wall's frame, in space. */
static inline clod_vec3 clod_wall_to_space(const clod_wall_pose *pose, clod_vec3 d)
{
    if (pose->stays) {
        return d;
    }
    const double(*r)[3] = pose->rotation;
    return (clod_vec3){r[0][0] * d.x + r[0][1] * d.y + r[0][2] * d.z,
                       r[1][0] * d.x + r[1][1] * d.y + r[1][2] * d.z,
                       r[2][0] * d.x + r[2][1] * d.y + r[2][2] * d.z};
}

/** A point given in the wall's frame, in space [m]. */
static inline clod_vec3 clod_wall_point_to_space(const clod_wall_pose *pose, clod_vec3 p)
{
    const clod_vec3 arm = clod_wall_to_space(pose, clod_vec3_sub(p, pose->point));
    return clod_vec3_add(pose->origin, arm);
}
