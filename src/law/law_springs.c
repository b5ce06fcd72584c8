#include "law/law_springs.h"

#include "base/assert.h"

const char *const CLOD_LAW_SPRINGS_TANGENTIAL[] = {
    [CLOD_TANGENTIAL_TANGENT] = "tangent", [CLOD_TANGENTIAL_LITERAL] = "literal", NULL};

const char *const CLOD_LAW_SPRINGS_ROLLING[] = {[CLOD_ROLLING_NONE] = "none",
                                                [CLOD_ROLLING_CDT] = "cdt",
                                                [CLOD_ROLLING_EPSD] = "epsd",
                                                [CLOD_ROLLING_EPSD2] = "epsd2",
                                                NULL};

static double of_tangent(const clod_law *law, double loading)
{
    return law->tangent_ratio * loading;
}

static double of_k1(const clod_law *law, double loading)
{
    (void)loading;
    return law->literal_stiffness;
}

static const clod_law_springs_tangential_row TANGENTIAL[] = {
    [CLOD_TANGENTIAL_TANGENT] = {.stiffness = of_tangent},
    [CLOD_TANGENTIAL_LITERAL] = {.takes_k1 = true, .stiffness = of_k1},
};

static double of_epsd(const clod_law *law, double loading)
{
    return law->epsd_ratio * loading;
}

static const clod_law_springs_rolling_row ROLLING[] = {
    [CLOD_ROLLING_NONE] = {0},
    [CLOD_ROLLING_CDT] = {.resists = true},
    [CLOD_ROLLING_EPSD] = {.resists = true, .dash_pot = true, .stiffness = of_epsd},
    [CLOD_ROLLING_EPSD2] = {.resists = true, .stiffness = clod_law_springs_tangential},
};

const clod_law_springs_tangential_row *clod_law_springs_tangential_row_of(int model)
{
    CLOD_ASSERT(model >= 0 && model < (int)(sizeof TANGENTIAL / sizeof *TANGENTIAL));
    return &TANGENTIAL[model];
}

const clod_law_springs_rolling_row *clod_law_springs_rolling_row_of(int model)
{
    CLOD_ASSERT(model >= 0 && model < (int)(sizeof ROLLING / sizeof *ROLLING));
    return &ROLLING[model];
}

double clod_law_springs_tangential(const clod_law *law, double loading)
{
    return TANGENTIAL[law->tangential].stiffness(law, loading);
}

double clod_law_springs_rolling(const clod_law *law, double loading)
{
    const clod_law_springs_rolling_row *row = &ROLLING[law->rolling];
    return row->stiffness != NULL ? row->stiffness(law, loading) : 0.0;
}
