/* SPDX-License-Identifier: MIT */
/* Spots. */
#include "proof.h"

#include "../../src/light/spot.c"
#include "ranges.h"

/*@ requires \valid_read(light) && \valid(fragments);
    requires fragments->count == 1;
    assigns fragments->light[0][0 .. 2], fragments->strength[0] \from indirect: *light, indirect: *fragments;
    ensures \initialized(&fragments->light[0][0 .. 2]) && \initialized(&fragments->strength[0]);
    ensures \subset(fragments->light[0][0 .. 2], (-32767 .. 32767));
    ensures fragments->strength[0] <= 0x8000; */
void glint_point_illuminate(const glint_prepared_light *light, glint_fragments *fragments);

/* Any cosine, any rounded vector. */
PROOF(glint_excess) {
    const int32_t excess = glint_excess(ANY(-0x3fff8000, 0x3fff8000), ANY(-160000, 160000));
    /*@ assert -80000 <= excess <= 80000; */
}

/* Any direction, any axis. @contract glint_dot glint_square_excess */
PROOF(glint_cone_cosine) {
    glint_prepared_light light;
    int16_t direction[3];
    for (int i = 0; i < 3; i++)
        light.direction[i] = direction[i] = ANY_COMPONENT;
    const int32_t cosine = glint_cone_cosine(&light, direction);
    /*@ assert -0x40010000 <= cosine <= 0x40010000; */
}

/* Stands on past slope <= 2^30, for past is at most the width that slope is the inverse of; and then on 3 t^2 - 2 t^3,
 * which rises from 0 to 1. The spots of the image tests, under UBSan too. */
/*@ requires 0 <= past;
    requires 0 <= slope <= 0x40000000;
    assigns \result \from past, slope;
    admit ensures \result <= 0x8000; */
static uint32_t smooth_step(int32_t past, int32_t slope);

/* Any angle. @contract glint_phase glint_sine */
PROOF(cosine_of) {
    cosine_of(ANY_INT);
}

/* Any angles and axis, the outer one no less. @contract glint_phase glint_sine glint_square_excess
 * @unreached 1 leading zeros of 0 */
PROOF(prepare_edge) {
    glint_light light;
    glint_prepared_light prepared;
    light.inner = ANY(0, 180 * GLINT_ONE);
    light.outer = ANY(0, 180 * GLINT_ONE);
    for (int i = 0; i < 3; i++)
        prepared.direction[i] = ANY_COMPONENT;
    prepare_edge(&light, &prepared);
}

/*@ requires \valid_read(light) && \valid(prepared);
    assigns prepared->spot \from indirect: *light, indirect: prepared->direction[0 .. 2]; */
static void prepare_edge(const glint_light *light, glint_prepared_light *prepared);

/* Any angles, attenuation, axis and camera. @contract glint_phase glint_sine glint_direction_to_camera prepare_edge */
PROOF(prepare_spot) {
    glint_view view;
    glint_light light;
    glint_prepared_light prepared;
    any_view(&view);
    light.axis = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    light.inner = ANY_INT;
    light.outer = ANY_INT;
    light.linear = ANY_INT;
    light.quadratic = ANY_INT;
    prepare_spot(&light, &prepared, &view);
}

/* past from 0 to 2^16 - 1, by parts of a quarter of its bits, and slopes of up to 2^30 / past. */
PROOF(smooth_step) {
    smooth_step(0, ANY(0, 1 << 30));
    FOR_PARTS(past, 1, 3) {
        smooth_step((int32_t)past, ANY(0, (1 << 30) / (int32_t)past));
    }
    FOR_PARTS(bits, 0, 13) {
        FOR_PARTS(quarter, 4, 7) {
            const int32_t past = (int32_t)quarter << bits;
            smooth_step(ANY(past, past + (1 << bits) - 1), ANY(0, (1 << 30) / past));
        }
    }
}

/* Any cone and any fragment. @contract glint_point_illuminate glint_cone_cosine smooth_step */
PROOF(illuminate_spot) {
    glint_prepared_light light;
    glint_fragments fragments;
    light.spot.cosine_inner = ANY(-CONE_MOST, CONE_MOST);
    light.spot.cosine_outer = ANY(-CONE_MOST, CONE_MOST);
    light.spot.slope = ANY(0, 1 << 30);
    light.spot.shift = ANY_UNSIGNED(0, 15);
    for (int i = 0; i < 3; i++)
        light.direction[i] = ANY_COMPONENT;
    fragments.count = 1;
    illuminate_spot(&light, &fragments);
    //@ assert fragments.strength[0] <= 0x8000;
}

/* ---- Objects that a cone misses ---- */

/*
 * Not proven: sight: products of 32 bits and 33 in 64, and shifts by as many bits as they have beyond 13. Suite `point`
 * under UBSan.
 */

/* Stands on these shifts. */
/*@ requires \valid_read(light) && \valid_read(view) && \valid_read(object) && \valid(to);
    assigns *to \from indirect: *light, indirect: *view, indirect: *object;
    ensures \initialized(&to->way[0 .. 2]) && \initialized(&to->half[0 .. 2][0 .. 2]);
    admit ensures \subset(to->way[0 .. 2], (-8192 .. 8192)); */
static void sight(const glint_light *light, const glint_view *view, const glint_object *object, sighted *to);

/*@ assigns \result \from half[0 .. 2][0 .. 2]; */
static uint32_t square_of_radius(const int32_t half[3][3]);

static glint_mesh mesh;
static glint_object object = {.mesh = &mesh};

/* Anywhere, of any size, turned and scaled in any way; any camera. */
static void any_object(glint_light *light, glint_view *view) {
    any_view(view);
    light->vector = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    light->outer = ANY_INT;
    mesh.offset = (glint_vector){ANY_INT, ANY_INT, ANY_INT};
    mesh.extent = (glint_vector){ANY(0, INT32_MAX), ANY(0, INT32_MAX), ANY(0, INT32_MAX)};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            object.pose.m[i][j] = ANY_INT;
}

/* Any halves of 13 bits. */
PROOF(square_of_radius) {
    int32_t half[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            half[i][j] = ANY(-8192, 8192);
    square_of_radius((const int32_t(*)[3])half);
}

/* Any object, any cone. @contract glint_phase glint_sine glint_square_root sight square_of_radius */
PROOF(misses_cone) {
    glint_view view;
    glint_light light;
    glint_prepared_light prepared;
    any_object(&light, &view);
    for (int i = 0; i < 3; i++)
        prepared.direction[i] = (int16_t)ANY(-32767, 32767);
    misses_cone(&light, &prepared, &view, &object);
}
