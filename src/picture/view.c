#include "picture/view.h"

#include <math.h>

#include "picture/picture.h"

clod_vec3 clod_view_direction(int view, const double low[3], const double high[3])
{
    static const double AZIMUTH = 22.0 * M_PI / 180.0;
    static const double ELEVATION = 18.0 * M_PI / 180.0;
    switch (view) {
    case CLOD_PICTURE_FRONT:
        return (clod_vec3){0.0, 1.0, 0.0};
    case CLOD_PICTURE_SIDE:
        return (clod_vec3){-1.0, 0.0, 0.0};
    case CLOD_PICTURE_TOP:
        return (clod_vec3){0.0, 0.0, -1.0};
    default:
        break;
    }
    const bool long_y = high[1] - low[1] > 1.2 * (high[0] - low[0]);
    const double turn = long_y ? AZIMUTH + 0.5 * M_PI : AZIMUTH;
    return (clod_vec3){-sin(turn) * cos(ELEVATION), cos(turn) * cos(ELEVATION),
                       -sin(ELEVATION)};
}
