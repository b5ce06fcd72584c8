#include "step/impact.h"

#include "base/lower_bound.h"

static int32_t grain_of(const clod_near_blocks *walls, size_t group, size_t number)
{
    const clod_wall_block *block =
        (const clod_wall_block *)walls->block + walls->group_start[group] + number / CLOD_LANES;
    return block->i[number % CLOD_LANES];
}

static const clod_rub_block *rub_of(const clod_near_blocks *walls, size_t group, size_t number)
{
    return &walls->rub[walls->group_start[group] + number / CLOD_LANES];
}

/** First contact of a group with a grain, or with one behind it. */
static size_t first_of(const clod_near_blocks *walls, size_t group, int32_t grain)
{
    clod_lower_bound in = {0, walls->group_count[group]};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, grain_of(walls, group, middle) < grain);
    }
    return in.low;
}

static bool is_one_way(const clod_rub_block *a, size_t i, const clod_rub_block *b, size_t j)
{
    double cosine = 0.0;
    for (int k = 0; k < 3; k++) {
        cosine += a->normal[k][i % CLOD_LANES] * b->normal[k][j % CLOD_LANES];
    }
    return cosine > CLOD_SURFACE_CRACK_COSINE;
}

/** Whether a contact that begins goes on from one of another group, or of its own. */
static bool goes_on(const clod_near_blocks *walls, size_t group, size_t number, size_t from)
{
    const clod_rub_block *rub = rub_of(walls, group, number);
    const int32_t grain = grain_of(walls, group, number);
    for (size_t c = first_of(walls, from, grain);
         c < walls->group_count[from] && grain_of(walls, from, c) == grain; c++) {
        const clod_rub_block *other = rub_of(walls, from, c);
        const double closed = other->closed[c % CLOD_LANES];
        const bool before = from < group || (from == group && c < number);
        if ((closed == 1.0 || (closed > 1.5 && before)) && is_one_way(rub, number, other, c)) {
            return true;
        }
    }
    return false;
}

bool clod_impact_begins(const clod_near *near, int part, size_t group, size_t number)
{
    bool begins = rub_of(&near->walls, group, number)->approach[number % CLOD_LANES] > 0.0;
    for (int32_t l = 0; begins && l < near->laws; l++) {
        for (int form = 0; begins && form < CLOD_FORMS; form++) {
            begins = !goes_on(&near->walls, group, number,
                              clod_near_wall_group(near, part, l, (clod_wall_form)form));
        }
    }
    return begins;
}
