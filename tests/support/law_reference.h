#pragma once
/**
 * @file law_reference.h
 * docs/theory once more, as printed: explicit branches and a stored maximum overlap instead of
 * the clamp, bisection instead of Newton, turns by sine and cosine, long double. Slow and
 * obvious; shares nothing with src/law.
 */

#include <math.h>
#include <string.h>

#include "clod/case.h"

typedef long double quad;

/** One contact's past: the largest power of the overlap that the branches remember. */
typedef struct ref_memory {
    quad most; ///< dmax^n as eq. (2) needs it
    quad tangent;
    quad spring[3], roll[3];
} ref_memory;

typedef struct ref_motion {
    quad overlap, normal[3], velocity[3], spin_i[3], spin_j[3];
    quad arm_i, arm_j, m_star, r_star, roll_inertia;
} ref_motion;

typedef struct ref_result {
    quad force[3], torque_i[3], torque_j[3];
    quad f_hys, f_t[3], roll[3], limit, stiffness, gamma_n;
} ref_result;

/** Parameters of a pair with hertz worked out for this contact's R*. */
typedef struct ref_law {
    quad n, k1, k2, k_adh, tangential, damping;
    quad r_star;       ///< m
    quad depth;        ///< luding: phi_f, else 0
    quad first, gamma; ///< eepa: f0 <= 0 [N] and surface energy [J/m2]
} ref_law;

static inline quad ref_dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void ref_cross(const quad a[3], const quad b[3], quad out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static const quad REF_PI = 3.14159265358979323846264338327950288L;

/** eepa: size of the largest pull of a contact with plastic overlap^n P, without f0. */
static inline quad ref_patch_pull(const ref_law *law, quad plastic)
{
    const quad dp = powl(plastic, 1.0L / law->n);
    const quad a = sqrtl(2.0L * law->r_star * dp); // radius of the plastic contact patch
    const quad pull = 1.5L * REF_PI * law->gamma * a;
    return pull < 0.5L * law->k2 * plastic ? pull : 0.5L * law->k2 * plastic;
}

/** eepa: the P whose largest pull lies at x = d^n, between x and 2 x. */
static inline quad ref_patch_plastic(const ref_law *law, quad x)
{
    quad low = x, high = 2.0L * x;
    for (int k = 0; k < 70; k++) {
        const quad middle = 0.5L * (low + high);
        const bool right = middle - ref_patch_pull(law, middle) / law->k2 < x;
        low = right ? middle : low;
        high = right ? high : middle;
    }
    return low;
}

/** Size of the largest pull at x = d^n, without f0: the pull-off line. */
static inline quad ref_pull(const ref_law *law, quad x)
{
    return law->gamma > 0.0L ? ref_patch_pull(law, ref_patch_plastic(law, x)) : law->k_adh * x;
}

/** Luding's branches with the stored maximum overlap; its k2 is that of before. */
static inline quad ref_luding(const ref_law *law, quad d, quad *most)
{
    const quad end = law->k2 / (law->k2 - law->k1) * law->depth * 2.0L * law->r_star;
    if (d > *most) {
        *most = d < end ? d : end;
    }
    const quad k = law->k1 + (law->k2 - law->k1) * *most / end;
    const quad f = k * (d - (1.0L - law->k1 / k) * *most);
    if (f < -law->k_adh * d) {
        *most = (k + law->k_adh) / (k - law->k1) * d;
        return -law->k_adh * d;
    }
    return f;
}

/**
 * Eq. (1)-(4) as printed; `most` is the stored maximum of d^n, forgotten along f3. f0 of eepa
 * comes on top of all branches.
 */
static inline quad ref_normal(const ref_law *law, quad x, quad *most)
{
    if (law->depth > 0.0L) {
        return ref_luding(law, x, most);
    }
    const quad share = 1.0L - law->k1 / law->k2; // dp^n = share dmax^n, where f2 meets f1
    const quad f1 = law->k1 * x;
    const quad f2 = law->k2 * (x - share * *most);
    const quad f3 = -ref_pull(law, x);
    if (f2 >= f1) {
        *most = x;
        return law->first + f1;
    }
    if (f3 >= f2) { // f2 = f3 here: the maximum that would have led to this point
        *most = (x - f3 / law->k2) / share;
        return law->first + f3;
    }
    return law->first + f2;
}

static inline bool ref_elastic(const clod_case_contact *c)
{
    return c->law == CLOD_LAW_HERTZ || c->law == CLOD_LAW_HOOKE;
}

static inline bool ref_literal(const clod_case_contact *c)
{
    return c->tangential == CLOD_TANGENTIAL_LITERAL && !ref_elastic(c);
}

static inline ref_law ref_law_of(const clod_case_contact *c, const clod_case_material *a,
                                 const clod_case_material *b, quad fraction, quad r_star,
                                 quad overlap)
{
    ref_law law = {.n = c->exponent,
                   .k1 = c->k1,
                   .k2 = c->k2,
                   .k_adh = fraction * (quad)c->k_adh,
                   .r_star = r_star};
    if (ref_elastic(c)) {
        law.k2 = law.k1;
        law.k_adh = 0.0L;
    } else if (c->law == CLOD_LAW_LUDING) {
        law.depth = c->plasticity_depth;
    } else if (c->law == CLOD_LAW_EEPA) {
        law.first = -fraction * (quad)c->pull_off_force;
        law.gamma = fraction * (quad)c->surface_energy;
    }
    if (c->law == CLOD_LAW_HERTZ) {
        const quad ea = a->youngs_modulus, eb = b->youngs_modulus;
        const quad na = a->poissons_ratio, nb = b->poissons_ratio;
        const quad ga = ea / (2.0L * (1.0L + na)), gb = eb / (2.0L * (1.0L + nb));
        const quad e_star = ea * eb / ((1.0L - na * na) * eb + (1.0L - nb * nb) * ea);
        const quad g_star = ga * gb / ((2.0L - na) * gb + (2.0L - nb) * ga);
        law.n = 1.5L;
        law.k1 = law.k2 = 4.0L * e_star * sqrtl(r_star) / 3.0L;
        law.tangential = 8.0L * g_star * sqrtl(r_star * overlap);
    } else if (ref_literal(c)) {
        law.tangential = law.k1;
    } else {
        law.tangential = (quad)c->tangential_ratio * law.n * law.k1 * powl(overlap, law.n - 1);
    }
    const quad l = logl((quad)c->restitution);
    // 1 for n = 1, sqrt(5/6) for n = 3/2 (docs/theory/damping.md)
    law.damping =
        -2.0L * l / sqrtl(l * l + REF_PI * REF_PI) * sqrtl((1.0L + 1.0L / law.n) / 2.0L);
    return law;
}

/** Into today's tangent plane: project, turn about the normal, restore the length, shrink. */
static inline void ref_carry(quad spring[3], const quad n[3], quad turn, quad soften)
{
    const quad length = sqrtl(ref_dot(spring, spring));
    const quad off = ref_dot(spring, n);
    quad flat[3], across[3];
    for (int c = 0; c < 3; c++) {
        flat[c] = spring[c] - off * n[c];
    }
    const quad left = sqrtl(ref_dot(flat, flat));
    ref_cross(n, flat, across);
    const quad angle = atanl(turn);
    for (int c = 0; c < 3; c++) {
        const quad turned = cosl(angle) * flat[c] + sinl(angle) * across[c];
        spring[c] = left > 0.0L ? turned / left * length * soften : 0.0L;
    }
}

/** Shorten a vector whose length times `scale` is beyond the limit. */
static inline void ref_shorten(quad vector[3], quad scale, quad limit)
{
    const quad length = scale * sqrtl(ref_dot(vector, vector));
    for (int c = 0; c < 3 && length > limit; c++) {
        vector[c] = vector[c] / length * limit;
    }
}

/** docs/theory/tangential.md: the spring is held to its limit, then the sum of spring and
 * dash-pot. */
static inline void ref_pull_back(quad spring[3], quad stiffness, quad dash_pot,
                                 const quad rate[3], quad limit, quad force[3])
{
    ref_shorten(spring, stiffness, limit);
    for (int c = 0; c < 3; c++) {
        force[c] = -stiffness * spring[c] - dash_pot * rate[c];
    }
    ref_shorten(force, 1.0L, limit);
}

static inline quad ref_measure(const clod_case_contact *c, const ref_law *law, quad x, quad f)
{
    if (c->coulomb == CLOD_COULOMB_PAPER) {
        return f > 0.0L ? f : 0.0L;
    }
    return c->coulomb == CLOD_COULOMB_FORCE ? fabsl(f) : f - law->first + ref_pull(law, x);
}

static inline void ref_rolling(const clod_case_contact *c, const ref_motion *m, quad measure,
                               quad dk, quad k_t, quad soften_t, quad soften, quad turn,
                               quad dt, ref_memory *memory, quad out[3])
{
    quad spin[3], off = 0.0L;
    for (int a = 0; a < 3; a++) {
        spin[a] = m->spin_i[a] - m->spin_j[a];
        off += spin[a] * m->normal[a];
    }
    for (int a = 0; a < 3; a++) {
        spin[a] -= off * m->normal[a];
    }
    const quad cap = (quad)c->rolling_friction * m->r_star * measure;
    if (c->rolling == CLOD_ROLLING_CDT) {
        const quad rate = sqrtl(ref_dot(spin, spin));
        for (int a = 0; a < 3; a++) {
            out[a] = rate > 0.0L ? -cap * spin[a] / rate : 0.0L;
        }
        return;
    }
    const bool dash_pot = c->rolling == CLOD_ROLLING_EPSD;
    const quad mu = c->rolling_friction;
    const quad k_r = m->r_star * m->r_star * (dash_pot ? 2.25L * mu * mu * dk : k_t);
    ref_carry(memory->roll, m->normal, turn, dash_pot ? soften : soften_t);
    for (int a = 0; a < 3; a++) {
        memory->roll[a] += dt * spin[a];
    }
    const quad c_r =
        dash_pot ? 2.0L * (quad)c->rolling_damping * sqrtl(m->roll_inertia * k_r) : 0.0L;
    ref_pull_back(memory->roll, k_r, c_r, spin, cap, out);
}

/** Velocity of i against j at the contact along the tangent plane (docs/theory/tangential.md).
 */
static inline quad ref_slip(const ref_motion *m, quad slip[3])
{
    quad arms[3], turn[3], v[3];
    for (int c = 0; c < 3; c++) {
        arms[c] = m->arm_i * m->spin_i[c] + m->arm_j * m->spin_j[c];
    }
    ref_cross(arms, m->normal, turn);
    for (int c = 0; c < 3; c++) {
        v[c] = m->velocity[c] - turn[c];
    }
    const quad v_n = ref_dot(v, m->normal);
    for (int c = 0; c < 3; c++) {
        slip[c] = v[c] - v_n * m->normal[c];
    }
    return v_n;
}

/** Force on i and torques on i and j of one contact; an open one forgets everything. */
static inline ref_result ref_contact(const clod_case_contact *c, const clod_case_material *a,
                                     const clod_case_material *b, quad fraction,
                                     const ref_motion *m, quad dt, ref_memory *memory)
{
    ref_result r;
    memset(&r, 0, sizeof r);
    if (!(m->overlap > 0.0L)) {
        memset(memory, 0, sizeof *memory);
        return r;
    }
    const ref_law law = ref_law_of(c, a, b, fraction, m->r_star, m->overlap);
    const quad x = powl(m->overlap, law.n);
    const quad dk = law.n * law.k1 * powl(m->overlap, law.n - 1.0L);
    r.f_hys = ref_normal(&law, x, &memory->most);
    quad slip[3], moment[3];
    const quad v_n = ref_slip(m, slip);
    r.gamma_n = law.damping * sqrtl(m->m_star * dk);
    const quad turn = dt * (ref_dot(m->spin_i, m->normal) + ref_dot(m->spin_j, m->normal)) / 2;
    const quad soften = memory->tangent < dk ? memory->tangent / dk : 1.0L;
    const quad soften_t = ref_literal(c) ? 1.0L : soften;
    const quad measure = ref_measure(c, &law, x, r.f_hys);
    ref_carry(memory->spring, m->normal, turn, soften_t);
    for (int k = 0; k < 3; k++) {
        memory->spring[k] += dt * slip[k];
    }
    r.limit = (quad)c->friction * measure;
    r.stiffness = law.tangential;
    ref_pull_back(memory->spring, law.tangential,
                  law.damping * sqrtl(m->m_star * law.tangential), slip, r.limit, r.f_t);
    if (c->rolling != CLOD_ROLLING_NONE) {
        ref_rolling(c, m, measure, dk, law.tangential, soften_t, soften, turn, dt, memory,
                    r.roll);
    }
    ref_cross(m->normal, r.f_t, moment);
    for (int k = 0; k < 3; k++) {
        r.force[k] = (r.f_hys - r.gamma_n * v_n) * m->normal[k] + r.f_t[k];
        r.torque_i[k] = -m->arm_i * moment[k] + r.roll[k];
        r.torque_j[k] = -m->arm_j * moment[k] - r.roll[k];
    }
    memory->tangent = dk;
    return r;
}
