/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer target: a scene that users draw, as the library draws it, against the double-precision reference. A scene
 * that breaks the contract by more than it is known to be missed by ends the program. How much of its bound the worst
 * pixel takes counts as a feature, so that the corpus keeps the worst scenes, and further ones are made from those.
 */
#include "drawing.h"
#include "stability/contract.h"
#include "stability/weights.h"

#include <stdio.h>

#define FORMATS 4

/* Shares of the bound that are told apart: from 0 to 4, in sixteenths. */
#define SHARES 64
#define SHARES_IN_ONE 16

/* Of its bound, what a pixel may take where the contract is missed: docs/stability.md tells where it is, and which
 * scenes pass this too. */
#define KNOWN_SHARE 1.4

/* Sum of weights up to which the contract's bound is within its two steps by far. */
#define WEIGHTS_MAX 4

/* From a cone's full light to none, degrees. */
#define SOFT_EDGE (10 * GLINT_ONE)

/* What libFuzzer takes for coverage, and sets to 0 before each input. */
static uint8_t seen[FORMATS][SHARES] __attribute__((section("__libfuzzer_extra_counters")));

/* ---- Scene --------------------------------------------------------------------------------------------------- */

static glint_q16 clamp(glint_q16 value, glint_q16 least, glint_q16 most) {
    return value < least ? least : value > most ? most : value;
}

static void scale_colour(glint_colour *colour, double by) {
    colour->r = (glint_q16)(colour->r * by);
    colour->g = (glint_q16)(colour->g * by);
    colour->b = (glint_q16)(colour->b * by);
}

/* Of an object from the eye, along the axis where it is largest. */
static glint_q16 distance_of(const glint_object *object, const glint_camera *camera) {
    glint_q16 largest = 0;
    for (int row = 0; row < 3; row++) {
        const glint_q16 apart = abs(object->pose.m[row][3] - camera->pose.m[row][3]);
        largest = apart > largest ? apart : largest;
    }
    return largest;
}

/*
 * Where light jumps, by a light with a position: at its horizon, unless highlights shine through, and at a cone's hard
 * edge. The fragment's own position tells where, which is off by up to 2^-10 of its triangle's depth. @return whether
 * it has one
 */
static int soften(glint_light *light) {
    if (light->type == &glint_light_spot && light->outer < light->inner + SOFT_EDGE) {
        light->inner = clamp(light->inner, 0, 180 * GLINT_ONE - SOFT_EDGE);
        light->outer = light->inner + SOFT_EDGE;
    }
    return light->type != &glint_light_directional;
}

/*
 * Into what the contract is for: p from 1 to 1024, a near plane at a thousandth of the distances, which cuts
 * little: library and reference round what they cut on their own.
 */
static void tame(drawing *d) {
    glint_camera *camera = &d->scene.camera;
    int has_position = 0;
    camera->near_plane = 1;
    d->scene.background =
        (glint_colour){GLINT_ONE / 5, GLINT_ONE / 5 * 2, GLINT_ONE / 5}; /* not halfway between steps */
    for (uint32_t i = 0; i < d->scene.light_count; i++)
        has_position |= soften(&d->lights[i]);
    for (uint32_t i = 0; i < d->scene.object_count; i++) {
        glint_material *material = &d->materials[i];
        const glint_q16 nearest = distance_of(&d->objects[i], camera) / 1000;
        const double sum = weights_sum(&d->scene, material);
        camera->near_plane = camera->near_plane > nearest ? camera->near_plane : nearest;
        material->shininess = clamp(material->shininess, GLINT_ONE, 1024 * GLINT_ONE);
        material->flags |= has_position ? GLINT_MATERIAL_SPECULAR_UNGATED : 0;
        if (sum > WEIGHTS_MAX) {
            scale_colour(&material->diffuse, WEIGHTS_MAX / sum);
            scale_colour(&material->specular, WEIGHTS_MAX / sum);
        }
    }
}

/* ---- Judgement ----------------------------------------------------------------------------------------------- */

/* Prints what is worse than all before. */
static void keep(uint32_t format, const contract_result *result) {
    static double worst[FORMATS];
    static const char *const names[FORMATS] = {"RGB565", "RGB888", "grey8", "RGB444"};
    const double share = result->worst_share;
    const double place = share * SHARES_IN_ONE;
    seen[format][place < SHARES ? (int)place : SHARES - 1] = 1;
    if (share > worst[format]) {
        worst[format] = share;
        fprintf(stderr, "worst of %s: %.3f of the bound, %ld of %ld pixels beyond it\n", names[format], share,
                result->found.not_fine, result->found.covered);
    }
}

/* Does a scene keep the contract, or all of it but the number of pixels beyond their bound, and these by what is known?
 */
static int is_sound(const contract_result *result) {
    judgement steps = result->found;
    steps.not_fine = 0;
    return contract_holds(result) || (judgement_keeps_contract(&steps) && result->worst_share <= KNOWN_SHARE);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const glint_format *const formats[FORMATS] = {&glint_format_rgb565, &glint_format_rgb888,
                                                         &glint_format_grey8, &glint_format_rgb444};
    source s = {data, size};
    contract_result result;
    drawing d;
    const uint32_t format = below(&s, FORMATS);
    const int width = 16 + (int)below(&s, 64), height = 16 + (int)below(&s, 48);
    take_usual_scene(&s, &d, 0); /* clusters may drop triangles that rounding turns round */
    take_textures(&s, &d, 1);
    tame(&d);
    (void)take_layers(&s, &d, 1);
    contract_judge(&d.scene, width, height, formats[format], &result);
    if (result.found.status == GLINT_OK) {
        keep(format, &result);
        require(is_sound(&result));
    } else {
        require(result.found.status == GLINT_ERROR_RANGE);
    }
    free_drawing(&d);
    return 0;
}
