// A bed run with contacts.soften has the bits of one whose stiffnesses were divided by hand, the
// automatic step among them (docs/theory/softening.md); the quotients are exact.

#include <string.h>

#include "support/sim_made.h"

/** Fifty grains thrown at a floor and each other; `contacts` holds the law, `modulus` E. */
#define CASE(modulus, contacts)                                                                \
    "materials: {ore: {density: 2500 kg/m3, youngs_modulus: " modulus                          \
    ", poissons_ratio: 0.25}}\n"                                                               \
    "contacts: {" contacts "}\n"                                                               \
    "stages: [{name: fall, duration: 1 s}]\n"                                                  \
    "walls:\n"                                                                                 \
    "  floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], "                   \
    "normal: [0, 0, 1]}}]}\n"                                                                  \
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 90 mm],\n"                         \
    "  periodic: [true, true, false]}\n"                                                       \
    "grains:\n"                                                                                \
    "  - {material: ore, count: 50, velocity: [0 m/s, 0 m/s, -2 m/s],\n"                       \
    "     radius: {distribution: uniform, min: 1.9 mm, max: 2.1 mm}, region: {box: {\n"        \
    "     min: [0 mm, 0 mm, 2.1 mm], max: [20 mm, 20 mm, 25 mm]}}}\n"

#define LAW(law, k1, k2, k_adh, more)                                                          \
    "default: {law: " law ", exponent: 1.5, k1: " k1 " N/m^1.5, k2: " k2                       \
    " N/m^1.5, k_adh: " k_adh " N/m^1.5, friction: 0.35, rolling: epsd2,\n"                    \
    "  rolling_friction: 0.3" more "}"
#define LUDING(k1, k2, k_adh)                                                                  \
    "default: {law: luding, k1: " k1 " N/m, k2: " k2 " N/m, k_adh: " k_adh                     \
    " N/m, plasticity_depth: 0.05}"
#define HERTZ "default: {law: hertz, friction: 0.3, rolling: epsd, rolling_friction: 0.1}"

static const struct {
    const char *softened, *by_hand;
} PAIRS[] = {
    {CASE("70 GPa", "soften: 100, " LAW("mepa", "4.75e8", "2.37e9", "3.56e8", "")),
     CASE("70 GPa", LAW("mepa", "4.75e6", "2.37e7", "3.56e6", ""))},
    {CASE("70 GPa",
          LAW("mepa", "4.75e8", "2.37e9", "3.56e8", ", tangential: literal") ", soften: 100"),
     CASE("70 GPa", LAW("mepa", "4.75e6", "2.37e7", "3.56e6", ", tangential: literal"))},
    {CASE("70 GPa",
          "soften: 100, " LAW("eepa", "4.75e8", "2.37e9", "3.56e8", ", pull_off_force: 2 mN")),
     CASE("70 GPa", LAW("eepa", "4.75e6", "2.37e7", "3.56e6", ", pull_off_force: 2 mN"))},
    {CASE("70 GPa", "soften: 10, " LUDING("1e6", "5e6", "1e6")),
     CASE("70 GPa", LUDING("1e5", "5e5", "1e5"))},
    {CASE("70 GPa", "soften: 10, default: {law: hooke, k1: 1e6 N/m}"),
     CASE("70 GPa", "default: {law: hooke, k1: 1e5 N/m}")},
    {CASE("70 GPa", "soften: 100, " HERTZ), CASE("700e6 Pa", HERTZ)},
};

static void a_run_has_the_bits_of_one_softened_by_hand(void **state)
{
    (void)state;
    static const char *const FIELDS[] = {"position", "velocity", "angular_velocity", "force"};
    for (size_t p = 0; p < sizeof PAIRS / sizeof PAIRS[0]; p++) {
        clod_sim *soft = sim_made(PAIRS[p].softened, 1);
        clod_sim *hand = sim_made(PAIRS[p].by_hand, 1);
        clod_sim_bed bed;
        CHECK(clod_sim_advance(soft, 20000, &status));
        CHECK(clod_sim_advance(hand, 20000, &status));
        assert_true(clod_sim_time(soft) == clod_sim_time(hand));
        CHECK(clod_sim_measure(soft, &bed, &status));
        assert_true(bed.pairs > 5);
        for (size_t f = 0; f < sizeof FIELDS / sizeof FIELDS[0]; f++) {
            const clod_sim_view a = sim_view(soft, FIELDS[f]);
            const clod_sim_view b = sim_view(hand, FIELDS[f]);
            assert_int_equal(a.rows, b.rows);
            for (size_t g = 0; g < a.rows; g++) {
                const char *x = (const char *)a.data + g * a.stride;
                const char *y = (const char *)b.data + g * b.stride;
                if (memcmp(x, y, 3 * sizeof(double)) != 0) {
                    fail_msg("pair %zu: %s of row %zu differs", p, FIELDS[f], g);
                }
            }
        }
        clod_sim_destroy(&soft);
        clod_sim_destroy(&hand);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_run_has_the_bits_of_one_softened_by_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
