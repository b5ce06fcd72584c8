#include "state/limits.h"

static bool check(size_t count, size_t most, const char *what, clod_status *status)
{
    return count <= most ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%zu %s are too many: this clod can count %zu; take fewer or larger "
               "grains",
               count, what, most);
}

bool clod_limits_grains(size_t count, clod_status *status)
{
    return check(count, CLOD_LIMITS_GRAINS, "grains", status);
}

bool clod_limits_pairs(size_t count, clod_status *status)
{
    return check(count, CLOD_LIMITS_PAIRS, "pairs of grains near each other", status);
}

bool clod_limits_wall_pairs(size_t count, clod_status *status)
{
    return check(count, CLOD_LIMITS_WALL_PAIRS, "pairs of a grain near a wall", status);
}

bool clod_limits_contacts(size_t count, clod_status *status)
{
    return check(count, CLOD_LIMITS_CONTACTS, "contacts", status);
}
