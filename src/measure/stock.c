#include "measure/stock.h"

#include <math.h>

#include "base/memory.h"
#include "parallel/exact.h"

/** Sums of the grains of one material. */
typedef struct stock_sums {
    clod_exact radius;
    double least;
    int64_t count;
} stock_sums;

static bool add(const clod_survey_question *question, const clod_survey_part *here,
                clod_status *status)
{
    (void)status;
    const clod_grains *grains = &here->state->grains;
    stock_sums *sums = question->sums;
    for (size_t g = 0; g < grains->count; g++) {
        if (clod_survey_has(here, g)) {
            stock_sums *of = &sums[grains->material[g]];
            const double radius = grains->position[g][3];
            of->least = of->count == 0 ? radius : fmin(of->least, radius);
            of->count++;
            clod_exact_add(&of->radius, radius);
        }
    }
    return true;
}

static void merge(const clod_survey_question *question, void *into, const void *from)
{
    (void)question;
    stock_sums *mine = into;
    const stock_sums *other = from;
    if (other->count > 0) {
        mine->least = mine->count == 0 ? other->least : fmin(mine->least, other->least);
        mine->count += other->count;
        clod_exact_merge(&mine->radius, &other->radius);
    }
}

const clod_survey_way CLOD_STOCK_WAY = {.add = add, .merge = merge, .unit = sizeof(stock_sums)};

bool clod_stock_take(clod_stock *stock, size_t materials, const clod_survey *survey,
                     clod_status *status)
{
    stock_sums *sums = clod_memory_alloc(materials + 1, sizeof *sums); // all zero
    const clod_survey_question question = {
        .kind = CLOD_SURVEY_STOCK, .sums = sums, .sums_bytes = materials * sizeof *sums};
    bool good = sums != NULL ||
                clod_status_fail(status, CLOD_FAILED, "no memory for the sizes of grains");
    good = good && clod_survey_ask(survey, &question, status);
    for (size_t m = 0; good && m < materials; m++) {
        stock[m] = (clod_stock){(double)sums[m].count, sums[m].least,
                                clod_exact_value(&sums[m].radius)};
    }
    clod_memory_free(sums);
    return good;
}
