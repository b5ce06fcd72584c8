#include "step/crew_bricks.h"

static int largest_factor(int number)
{
    int largest = 1;
    for (int f = 2; number > 1; f++) {
        while (number % f == 0) {
            largest = f;
            number /= f;
        }
    }
    return largest;
}

void clod_crew_bricks(const clod_domain_box *box, int ranks, int32_t bricks[3])
{
    for (int a = 0; a < 3; a++) {
        bricks[a] = 1;
    }
    while (ranks > 1) {
        int longest = 0;
        double most = 0.0;
        for (int a = 0; a < 3; a++) {
            const double edge = (box->high[a] - box->low[a]) / bricks[a];
            if (edge > most) {
                most = edge;
                longest = a;
            }
        }
        const int factor = largest_factor(ranks);
        bricks[longest] *= factor;
        ranks /= factor;
    }
}

int clod_crew_brick_of(const clod_domain_box *box, const int32_t bricks[3],
                       const double place[4])
{
    int32_t at[3];
    for (int a = 0; a < 3; a++) {
        const double turn =
            (place[a] - box->low[a]) * (bricks[a] / (box->high[a] - box->low[a]));
        at[a] = (int32_t)fmin(fmax(turn, 0.0), bricks[a] - 1.0);
    }
    return (at[2] * bricks[1] + at[1]) * bricks[0] + at[0];
}

clod_domain_box clod_crew_brick(const clod_domain_box *box, const int32_t bricks[3], int rank)
{
    const int32_t at[3] = {rank % bricks[0], rank / bricks[0] % bricks[1],
                           rank / bricks[0] / bricks[1]};
    clod_domain_box brick;
    for (int a = 0; a < 3; a++) {
        const double edge = (box->high[a] - box->low[a]) / bricks[a];
        brick.low[a] = box->low[a] + at[a] * edge;
        brick.high[a] = brick.low[a] + edge;
    }
    return brick;
}
