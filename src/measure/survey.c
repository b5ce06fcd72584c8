#include "measure/survey.h"

#include "measure/clumps_look.h"
#include "measure/contacts.h"
#include "measure/continuum_pass.h"
#include "measure/gauge_pass.h"
#include "measure/mixing_grid.h"
#include "measure/repose.h"
#include "measure/resting_mass.h"
#include "measure/stock.h"
#include "measure/strength_grid.h"

const clod_survey_way *clod_survey_way_of(clod_survey_kind kind)
{
    static const clod_survey_way *const WAY[] = {
        [CLOD_SURVEY_MOTION] = &CLOD_MEASURE_MOTION_WAY,
        [CLOD_SURVEY_CONTACTS] = &CLOD_MEASURE_CONTACTS_WAY,
        [CLOD_SURVEY_GAUGES] = &CLOD_GAUGE_PASS_WAY,
        [CLOD_SURVEY_CONTINUUM] = &CLOD_CONTINUUM_PASS_WAY,
        [CLOD_SURVEY_MIXING] = &CLOD_MIXING_GRID_WAY,
        [CLOD_SURVEY_MIXING_MASS] = &CLOD_MIXING_GRID_MASS_WAY,
        [CLOD_SURVEY_STOCK] = &CLOD_STOCK_WAY,
        [CLOD_SURVEY_STRENGTH] = &CLOD_STRENGTH_GRID_WAY,
        [CLOD_SURVEY_CLUMPS] = &CLOD_CLUMPS_LOOK_WAY,
        [CLOD_SURVEY_RESTING] = &CLOD_RESTING_MASS_WAY,
        [CLOD_SURVEY_REPOSE] = &CLOD_REPOSE_WAY,
        [CLOD_SURVEY_REPOSE_CENTER] = &CLOD_REPOSE_CENTER_WAY,
    };
    return WAY[kind];
}

clod_survey clod_survey_of(const clod_state *state, const clod_contact_source *contacts)
{
    return (clod_survey){.state = state, .contacts = contacts};
}

bool clod_survey_ask(const clod_survey *self, const clod_survey_question *question,
                     clod_status *status)
{
    if (self->ask != NULL) {
        return self->ask(self->context, question, status);
    }
    const clod_survey_part all = {.state = self->state, .contacts = self->contacts};
    return clod_survey_way_of(question->kind)->add(question, &all, status);
}
