#include "step/team.h"

#include <omp.h>

void clod_team_run(clod_step *self, void (*work)(clod_step *self, int part))
{
    bool alone = false;
#pragma omp parallel num_threads(self->threads)
    if (omp_get_num_threads() == self->threads) {
        work(self, omp_get_thread_num());
    } else if (omp_get_thread_num() == 0) {
        alone = true;
    }
    if (alone) {
        self->threads = 1;
        clod_barrier_init(&self->barrier, 1, 1);
        work(self, 0);
    }
}
