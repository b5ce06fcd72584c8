#include "hopper/words.h"

#include <stdio.h>
#include <string.h>

#define DEGREES 57.295779513082323

void clod_words_verdict(const clod_hopper_found *found, char text[CLOD_WORDS_MOST])
{
    static const char *const WORDS[CLOD_HOPPER_OUTCOMES] = {
        [CLOD_HOPPER_FLOWS] = "Mass flow, and no cohesive arch above the critical outlet.",
        [CLOD_HOPPER_NO_ARCH] =
            ("Mass flow. The strength nowhere reaches the stress of an arch: no cohesive arch "
             "at any outlet. Particles and the flow rate decide about its size."),
        [CLOD_HOPPER_ARCHES] =
            ("The strength stays above the stress of an arch, at every stress or beyond some "
             "stress: no outlet is large enough, the solid cannot flow by gravity."),
        [CLOD_HOPPER_FUNNEL] =
            ("Funnel flow: the solid does not slide along this wall. A smoother or a steeper "
             "one may help; otherwise see the rathole."),
        [CLOD_HOPPER_UNSETTLED] = "No critical state was found; see the warnings.",
    };
    const clod_hopper_design *at = &found->design;
    if (at->outcome == CLOD_HOPPER_UNPROVEN) {
        snprintf(
            text, CLOD_WORDS_MOST,
            "Not known to be mass flow: a wedge steeper than %.1f deg is, this one has %.1f "
            "deg. If a chart for wedges allows that, no cohesive arch stands %s.",
            DEGREES * at->limit, DEGREES * at->half_angle,
            at->outlet > 0.0 ? "above the critical outlet" : "at any outlet");
    } else {
        snprintf(text, CLOD_WORDS_MOST, "%s", WORDS[at->outcome]);
    }
}

void clod_words_shares(const clod_hopper_found *found, char text[CLOD_WORDS_MOST])
{
    static const char *const WORDS[CLOD_HOPPER_OUTCOMES] = {
        [CLOD_HOPPER_FLOWS] = "with a critical outlet",
        [CLOD_HOPPER_NO_ARCH] = "without an arch",
        [CLOD_HOPPER_ARCHES] = "arching at any outlet",
        [CLOD_HOPPER_FUNNEL] = "in funnel flow",
        [CLOD_HOPPER_UNSETTLED] = "not settled",
        [CLOD_HOPPER_UNPROVEN] = "not known to be mass flow"};
    text[0] = '\0';
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        if (found->share[k] > 0.0) {
            const size_t used = strlen(text);
            snprintf(text + used, CLOD_WORDS_MOST - used, "%s%.1f %% %s", used > 0 ? ", " : "",
                     100.0 * found->share[k], WORDS[k]);
        }
    }
}
