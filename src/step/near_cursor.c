#include "step/near_cursor.h"

#include "base/lower_bound.h"
#include "base/memory.h"
#include "step/near_parts.h"
#include "step/near_walk.h"

/** Key behind all others. */
#define AT_END UINT64_MAX

clod_near_format clod_near_format_of(const clod_near *self, const clod_near_blocks *list)
{
    return list == &self->pairs
               ? (clod_near_format){sizeof(clod_contact_block), offsetof(clod_contact_block, j),
                                    offsetof(clod_contact_block, history)}
               : (clod_near_format){sizeof(clod_wall_block), offsetof(clod_wall_block, shape),
                                    offsetof(clod_wall_block, history)};
}

static const clod_history *history_of(const char *block, clod_near_format format)
{
    return (const clod_history *)(const void *)(block + format.history);
}

/** (i, partner) of a lane, in one number that ascends with them. */
static uint64_t key_of(const char *block, clod_near_format format, size_t lane)
{
    const int32_t *i = (const int32_t *)(const void *)block; // first in both kinds of block
    const int32_t *partner = (const int32_t *)(const void *)(block + format.partner);
    return (uint64_t)(uint32_t)i[lane] << 32 | (uint32_t)partner[lane];
}

/** From where it is on to the first contact that touches. */
static void settle(clod_near_source *self, clod_near_format format)
{
    for (; self->at < self->end; self->at++) {
        const char *block = self->block + self->at / CLOD_LANES * format.size;
        const size_t lane = self->at % CLOD_LANES;
        if (clod_history_is_there(history_of(block, format), (int)lane)) {
            self->key = key_of(block, format, lane);
            return;
        }
    }
    self->key = AT_END;
}

/** Take contacts [begin, end) of a group in. */
static void add_source(clod_near_cursor *self, size_t group, size_t begin, size_t end)
{
    if (begin == end) { // an empty list has no blocks at all
        return;
    }
    const clod_near_format format = clod_near_format_of(self->near, self->list);
    const size_t first = self->list->group_start[group] * format.size;
    const size_t page = CLOD_MEMORY_HUGE_PAGE;
    clod_near_source source = {.block = (const char *)self->list->block + first,
                               .at = begin,
                               .end = end,
                               .given = (first + begin / CLOD_LANES * format.size + page - 1) /
                                        page * page};
    settle(&source, format);
    if (source.key != AT_END) {
        self->source[self->sources++] = source;
    }
}

/** Contacts of one law between grains, those of a part as i. */
static void add_pairs(clod_near_cursor *self, int part, int32_t law)
{
    const clod_near *near = self->near;
    const size_t within = clod_near_group(near, part, law);
    add_source(self, within, 0, near->pairs.group_count[within]);
    const size_t k = (size_t)law * (size_t)near->parts + (size_t)part;
    const size_t *start = near->between.run_start;
    for (size_t r = start[k]; r < start[k + 1]; r++) {
        const clod_near_run *run = &near->between.run[r];
        add_source(self, clod_near_group_between(near, run->later, law), run->begin, run->end);
    }
}

/** Contacts of one law with walls. */
static void add_walls(clod_near_cursor *self, int part, int32_t law)
{
    for (int form = 0; form < CLOD_FORMS; form++) {
        const size_t group = clod_near_wall_group(self->near, part, law, (clod_wall_form)form);
        add_source(self, group, 0, self->near->walls.group_count[group]);
    }
}

clod_near_cursor clod_near_cursor_begin(const clod_near *near, const clod_near_blocks *list,
                                        int part)
{
    clod_near_cursor self = {.near = near,
                             .list = list,
                             .source = near->source + (size_t)part * clod_near_sources(near)};
    for (int32_t law = 0; law < near->laws; law++) {
        if (list == &near->pairs) {
            add_pairs(&self, part, law);
        } else {
            add_walls(&self, part, law);
        }
    }
    return self;
}

bool clod_near_cursor_next(clod_near_cursor *self)
{
    clod_near_source *least = self->source;
    for (int32_t k = 1; k < self->sources; k++) {
        least = self->source[k].key < least->key ? &self->source[k] : least;
    }
    if (self->sources == 0 || least->key == AT_END) {
        return false;
    }
    const clod_near_format format = clod_near_format_of(self->near, self->list);
    self->block = least->block + least->at / CLOD_LANES * format.size;
    self->lane = (int)(least->at++ % CLOD_LANES);
    settle(least, format);
    return true;
}

void clod_near_cursor_name(const clod_near_cursor *self, const clod_wall_rows *walls,
                           clod_contact *to)
{
    if (self->list == &self->near->pairs) {
        const clod_contact_block *block = self->block;
        to->i = block->i[self->lane];
        to->j = block->j[self->lane];
        to->shape = -1;
    } else {
        const clod_wall_block *block = self->block;
        to->i = block->i[self->lane];
        to->j = block->wall[self->lane];
        to->shape = block->shape[self->lane] / CLOD_SHAPE_ROWS - walls->first_shape[to->j];
    }
}

void clod_near_cursor_copy(const clod_near_cursor *self, const clod_wall_rows *walls,
                           clod_contact *to)
{
    clod_near_cursor_name(self, walls, to);
    const clod_near_format format = clod_near_format_of(self->near, self->list);
    clod_history_get(history_of(self->block, format), self->lane, to->history);
}

void clod_near_cursor_release(const clod_near_cursor *self)
{
    const clod_near_format format = clod_near_format_of(self->near, self->list);
    const char *array = self->list->block;
    for (int32_t k = 0; k < self->sources; k++) {
        clod_near_source *source = &self->source[k];
        const size_t read =
            (size_t)(source->block - array) + source->at / CLOD_LANES * format.size;
        source->given = clod_near_give_back(
            self->list->block, self->list->capacity * format.size, source->given, read);
    }
}

/** A contact of a group, by halving. */
static const clod_history *find_in(const clod_near_blocks *list, clod_near_format format,
                                   size_t group, uint64_t key, int *lane)
{
    if (list->group_count[group] == 0) { // an empty list has no blocks at all
        return NULL;
    }
    const char *blocks = (const char *)list->block + list->group_start[group] * format.size;
    clod_lower_bound in = {0, list->group_count[group]};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        const char *block = blocks + middle / CLOD_LANES * format.size;
        clod_lower_bound_halve(&in, key_of(block, format, middle % CLOD_LANES) < key);
    }
    if (in.low == list->group_count[group]) {
        return NULL;
    }
    const char *block = blocks + in.low / CLOD_LANES * format.size;
    *lane = (int)(in.low % CLOD_LANES);
    const clod_history *history = history_of(block, format);
    const bool there = key_of(block, format, in.low % CLOD_LANES) == key;
    return there && clod_history_is_there(history, *lane) ? history : NULL;
}

const clod_history *clod_near_find(const clod_near *self, const clod_near_blocks *list,
                                   int32_t i, int32_t partner, int *lane)
{
    const clod_near_format format = clod_near_format_of(self, list);
    const uint64_t key = (uint64_t)(uint32_t)i << 32 | (uint32_t)partner;
    const int part = clod_near_part_of(self, i);
    const bool wall = list == &self->walls;
    const int later = wall ? part : clod_near_part_of(self, partner);
    const int forms = wall ? CLOD_FORMS : 1;
    const clod_history *found = NULL;
    for (int k = 0; k < self->laws * forms && found == NULL; k++) {
        const int32_t law = k / forms;
        const size_t group =
            wall            ? clod_near_wall_group(self, part, law, (clod_wall_form)(k % forms))
            : later == part ? clod_near_group(self, part, law)
                            : clod_near_group_between(self, later, law);
        found = find_in(list, format, group, key, lane);
    }
    return found;
}
