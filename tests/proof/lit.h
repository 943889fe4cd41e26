/* SPDX-License-Identifier: MIT */
/**
 * @file lit.h
 * A material under lights of any kind, and fragments, over the whole of their ranges.
 */
#ifndef GLINT_LIT_H
#define GLINT_LIT_H

#include "../../src/light/model.h"
#include "ranges.h"

/* N.L is rounded up to 32775; times a weight of 16: what one light's diffuse or specular part adds to a colour. */
#define LIGHT_MOST ((32775u * (16u << 12)) >> 4)

/* Stands on the lengths of normals: those of vertices are within HALF_TOLERANCE of HALF_LENGTH, twice (geometry.c), or
 * made unit; or 0, and then the cosine is. Suite `nodes` takes such. */
/*@ requires -0x3fff8000 <= cosine <= 0x3fff8000 && \valid_read(n + (0 .. 2));
    assigns \result \from cosine, indirect: n[0 .. 2];
    admit ensures -0x10040 <= \result <= 0x10040; */
static inline int32_t glint_twice_over_square(int32_t cosine, const int16_t n[3]);

static void any_unit(int16_t v[3]) {
    for (int c = 0; c < 3; c++)
        v[c] = ANY_COMPONENT;
}

static void any_illuminate(const glint_prepared_light *light, glint_fragments *fragments) {
    (void)light;
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++) {
        any_unit(fragments->light[i]);
        fragments->strength[i] = (uint16_t)ANY(0, 1 << 15);
    }
}

static const glint_light_type far_light = {0, 0, 0}, near_light = {0, any_illuminate, 0};

/* Lights of one kind. */
static void any_lights(glint_view *view, const glint_light_type *type) {
    any_view(view);
    view->light_count = ANY_UNSIGNED(0, GLINT_LIGHTS_MAX);
    for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
        view->lights[i].type = type;
        any_unit(view->lights[i].direction);
        any_unit(view->lights[i].half_vector);
    }
}

static void any_shading(glint_shading *shading, glint_material *material) {
    material->flags = ANY_UNSIGNED(0, GLINT_MATERIAL_UNGATED | GLINT_MATERIAL_MAX);
    material->shininess = ANY(0, INT32_MAX);
    shading->material = material;
    shading->lights = ANY_UNSIGNED(0, 0xff);
    shading->has_specular = ANY_UNSIGNED(0, 0xff);
    shading->power.exponent = ANY(0, INT32_MAX);
    shading->power.cosine_square_floor = ANY(0, 1 << 15);
    for (int c = 0; c < 3; c++) {
        shading->ambient[c] = ANY_UNSIGNED(0, 16u << 23);
        for (int i = 0; i < GLINT_LIGHTS_MAX; i++) {
            shading->weights[i].diffuse[c] = ANY_UNSIGNED(0, 16u << 12);
            shading->weights[i].specular[c] = ANY_UNSIGNED(0, 16u << 12);
        }
    }
}

/* Fragments with normals, rays, and colours: their own from 0 to 1, what they are lit by from 0 to `most`. */
static void any_fragments(glint_fragments *fragments, uint32_t most) {
    fragments->count = ANY_UNSIGNED(1, GLINT_FRAGMENTS_MAX);
    fragments->away = ANY_UNSIGNED(0, 0xff);
    for (int i = 0; i < GLINT_FRAGMENTS_MAX; i++) {
        any_unit(fragments->normal[i]);
        any_unit(fragments->view[i]);
        for (int c = 0; c < 3; c++) {
            fragments->ray[i][c] = ANY(-(1 << 30), 1 << 30);
            fragments->surface[i][c] = (int16_t)ANY(0, GLINT_COLOUR_ONE);
            fragments->colour[i][c] = ANY_UNSIGNED(0, most);
        }
    }
}

/* One light of a model, of each kind, on any fragments, whose colours leave room for its two parts. */
#define PROVE_LIGHT(light)                                                                    \
    glint_view view;                                                                          \
    glint_material material;                                                                  \
    glint_shading shading;                                                                    \
    glint_fragments fragments;                                                                \
    any_shading(&shading, &material);                                                         \
    FOR_PARTS(kind, 0, 7) {                                                                   \
        any_fragments(&fragments, UINT_MAX - 2 * LIGHT_MOST);                                 \
        any_lights(&view, kind & 1 ? &near_light : &far_light);                               \
        view.local_viewer = kind >> 1 & 1;                                                    \
        light(&shading, ANY_UNSIGNED(0, GLINT_LIGHTS_MAX - 1), &view, &fragments, kind >> 2); \
    }

#endif
