// The contacts of a step as a source for those who write or measure them.
#include <math.h>

#include "law/law_cycle.h"
#include "step/contact_force.h"
#include "step/near_reader.h"

static size_t next_of_blocks(void *context, clod_contact *to, size_t room)
{
    clod_step_reader *self = context;
    return clod_near_reader_next(&self->blocks, to, room);
}

/** Count them on a first way along the blocks. */
static void begin_blocks(void *context, size_t *pairs, size_t *walls)
{
    clod_step_reader *self = context;
    clod_near *near = &self->step->near;
    *pairs = *walls = 0;
    for (int p = 0; p < near->parts; p++) {
        clod_near_gather_count(near, p);
        *pairs += near->gathered[p].pairs;
        *walls += near->gathered[p].walls;
    }
    self->blocks = clod_near_reader_begin(near, &self->step->walls);
}

const clod_law *clod_step_law_of(const clod_step *self, const clod_contact *contact,
                                 double *r_star)
{
    const clod_grains *grains = &self->state->grains;
    const double a = grains->position[contact->i][3];
    int32_t partner;
    *r_star = a;
    if (contact->shape >= 0) {
        partner = clod_wall_material(&self->state->walls.wall[contact->j], contact->shape);
    } else {
        const double b = grains->position[contact->j][3];
        *r_star = a * b / (a + b);
        partner = grains->material[contact->j];
    }
    return &self->laws->law[clod_laws_index(self->laws, grains->material[contact->i], partner)];
}

static clod_contact_strength strength_of(const void *laws, const clod_contact *contact)
{
    double r_star;
    const clod_law *law = clod_step_law_of(laws, contact, &r_star);
    const double memory = contact->history[CLOD_HISTORY[CLOD_HISTORY_PLASTIC].first];
    const double pressed = clod_law_cycle_pressed(law, memory);
    return (clod_contact_strength){clod_law_cycle_pull(law, r_star, pressed).force,
                                   fmax(0.0, clod_law_cycle_force(law, r_star, pressed))};
}

clod_contact_source clod_step_contacts(clod_step *self, clod_step_reader *reader)
{
    *reader = (clod_step_reader){.step = self};
    clod_contact_source source = {
        .context = reader, .begin = begin_blocks, .next = next_of_blocks};
    if (!self->near.made) { // then the state has them
        source = clod_contact_source_of(&reader->list, self->state);
    }
    source.laws = self;
    source.strength = strength_of;
    source.gain = clod_step_gain_of;
    source.force = clod_step_force_of;
    source.carrier = clod_step_carrier_of;
    return source;
}
