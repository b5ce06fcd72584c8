#include "analysis/mohr.h"

#include <math.h>

#define SHARE_MOST 0.75  // docs/theory/yield-locus.md, also of the next
#define SHARE_OF_TOP 0.9 // of what the top of the circle has

clod_mohr clod_mohr_steady(double c, double t, double sigma_p, double tau_p)
{
    const double length = sqrt(1.0 + t * t); // 1/cos phi
    const double locus = c + t * sigma_p;
    if (tau_p > locus) {
        return (clod_mohr){sigma_p + tau_p * t, tau_p * length, true};
    }
    const double centre =
        sigma_p + t * locus - length * sqrt((locus - tau_p) * (locus + tau_p));
    return (clod_mohr){centre, (c + t * centre) / length, false};
}

double clod_mohr_unconfined(double c, double t)
{
    return 2.0 * c * (t + sqrt(1.0 + t * t));
}

double clod_mohr_touch(double centre, double radius, double t)
{
    return centre - radius * t / sqrt(1.0 + t * t);
}

double clod_mohr_share(double c, double t, double sigma_p, double tau_p)
{
    const double locus = c + t * sigma_p;
    return locus > 0.0 ? tau_p / locus : (double)INFINITY;
}

double clod_mohr_share_least(double t)
{
    return fmin(SHARE_MOST, SHARE_OF_TOP / sqrt(1.0 + t * t));
}
