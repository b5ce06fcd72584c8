#include "picture/camera.h"

#define UPRIGHT 0.9999 ///< a direction whose z is beyond this looks along z

clod_camera clod_camera_make(clod_vec3 eye, clod_vec3 direction, double angle, double aspect)
{
    const clod_vec3 ahead = clod_vec3_unit(direction);
    const clod_vec3 zenith =
        fabs(ahead.z) > UPRIGHT ? (clod_vec3){0.0, 1.0, 0.0} : (clod_vec3){0.0, 0.0, 1.0};
    const clod_vec3 right = clod_vec3_unit(clod_vec3_cross(ahead, zenith));
    const double half = tan(0.5 * angle);
    return (clod_camera){.eye = eye,
                         .right = right,
                         .up = clod_vec3_cross(right, ahead),
                         .ahead = ahead,
                         .half_width = half * aspect,
                         .half_height = half};
}

double clod_camera_project(const clod_camera *self, clod_vec3 point, double *x, double *y)
{
    const clod_vec3 arm = clod_vec3_sub(point, self->eye);
    const double depth = clod_vec3_dot(arm, self->ahead);
    *x = clod_vec3_dot(arm, self->right) / (depth * self->half_width);
    *y = clod_vec3_dot(arm, self->up) / (depth * self->half_height);
    return depth;
}

/** Note how far a sphere at (across, depth) of the camera's axes is beyond an edge of slope t. */
static void note(double *bound, double across, double depth, double t, double radius)
{
    *bound = fmax(*bound, across - t * depth + radius * sqrt(1.0 + t * t));
}

void clod_camera_bound(const clod_camera *self, clod_camera_bounds *bounds, clod_vec3 center,
                       double radius)
{
    const double x = clod_vec3_dot(center, self->right);
    const double y = clod_vec3_dot(center, self->up);
    const double z = clod_vec3_dot(center, self->ahead);
    note(&bounds->right, x, z, self->half_width, radius);
    note(&bounds->left, -x, z, self->half_width, radius);
    note(&bounds->top, y, z, self->half_height, radius);
    note(&bounds->bottom, -y, z, self->half_height, radius);
}

/*
 * With the eye at (x, y, z) of the camera's axes an edge plane through it of slope t leaves a
 * sphere inside when bound <= x - t z (right), -x - t z (left) and so on. Left and right added:
 * z <= -(left + right) / 2 t. The nearest eye takes the smaller z of both directions and stands
 * in the middle of what the other direction leaves.
 */
void clod_camera_fit(clod_camera *self, const clod_camera_bounds *bounds)
{
    if (!(bounds->right > -HUGE_VAL)) {
        return; // nothing to be seen
    }
    const double z = fmin(-0.5 * (bounds->left + bounds->right) / self->half_width,
                          -0.5 * (bounds->bottom + bounds->top) / self->half_height);
    const double x = 0.5 * (bounds->right - bounds->left);
    const double y = 0.5 * (bounds->top - bounds->bottom);
    const clod_vec3 eye = clod_vec3_scale(self->right, x);
    self->eye = clod_vec3_axpy(clod_vec3_axpy(eye, y, self->up), z, self->ahead);
}
