#include "analysis/burden.h"

#include <math.h>

double clod_burden_width(double belt_width)
{
    const double width = belt_width <= 2.0 ? 0.9 * belt_width - 0.05 : belt_width - 0.25;
    return fmax(width, 0.0);
}

clod_burden_section clod_burden_of(const clod_burden_belt *belt, double width, double surcharge)
{
    const double middle = fmin(belt->middle_roll, width);
    const double wings = width - middle; // both of them
    const double across = middle + wings * cos(belt->idler_angle);
    return (clod_burden_section){.heap = across * across * tan(surcharge) / 6.0,
                                 .trough = (middle + 0.5 * wings * cos(belt->idler_angle)) *
                                           0.5 * wings * sin(belt->idler_angle)};
}
