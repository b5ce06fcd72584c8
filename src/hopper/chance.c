#include "hopper/chance.h"

#include <float.h>
#include <math.h>

#define TERMS 500 // of the continued fraction, far more than it needs
#define TINY 1e-300

/** Q(n/2, x): a finite sum for whole n, from that of n = 1 or 2 on. */
static double of_chi_square(double x, size_t n)
{
    double term = n % 2 == 1 ? sqrt(x / M_PI) * exp(-x) * 2.0 : exp(-x);
    double sum = n % 2 == 1 ? erfc(sqrt(x)) : term;
    double at = n % 2 == 1 ? 1.5 : 1.0;
    if (n % 2 == 1) {
        sum += n > 1 ? term : 0.0;
    }
    for (size_t k = n % 2 == 1 ? 5 : 4; k <= n; k += 2, at += 1.0) {
        term *= x / at;
        sum += term;
    }
    return fmin(1.0, sum);
}

/** One step of Lentz's way to a continued fraction. */
static double step(double factor, double *c, double *d)
{
    *c = 1.0 + factor / *c;
    *d = 1.0 + factor * *d;
    *c = fabs(*c) < TINY ? TINY : *c;
    *d = 1.0 / (fabs(*d) < TINY ? TINY : *d);
    return *c * *d;
}

/** The continued fraction of the incomplete beta function, where it converges fast. */
static double fraction(double x, double a, double b)
{
    double c = 1.0;
    double d = 1.0 / (1.0 - (a + b) * x / (a + 1.0));
    double value = d;
    for (int m = 1; m < TERMS; m++) {
        const double odd = a + 2.0 * m;
        value *= step(m * (b - m) * x / ((odd - 1.0) * odd), &c, &d);
        const double change = step(-(a + m) * (a + b + m) * x / (odd * (odd + 1.0)), &c, &d);
        value *= change;
        if (fabs(change - 1.0) < DBL_EPSILON) {
            break;
        }
    }
    return value;
}

/** I_x(a, b), with y = 1 - x. */
static double incomplete_beta(double x, double y, double a, double b)
{
    if (x <= 0.0 || y <= 0.0) {
        return x <= 0.0 ? 0.0 : 1.0;
    }
    const double front = exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log(y));
    return x < (a + 1.0) / (a + b + 2.0) ? front * fraction(x, a, b) / a
                                         : 1.0 - front * fraction(y, b, a) / b;
}

double clod_chance_above(double chi_square, size_t freedom, size_t errors)
{
    if (errors == 0) {
        return of_chi_square(0.5 * chi_square, freedom);
    }
    const double m = (double)errors;
    const double all = m + chi_square; // m + n F
    return incomplete_beta(m / all, chi_square / all, 0.5 * m, 0.5 * (double)freedom);
}
