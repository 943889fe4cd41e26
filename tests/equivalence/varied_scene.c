/* SPDX-License-Identifier: MIT */
#include "varied_scene.h"

#include "every_format.h"
#include "stability/random_layers.h"

/* Multiplicative hashing (Knuth). */
uint32_t varied_pick(uint64_t seed, uint32_t use, uint32_t count) {
    const uint32_t hash = ((uint32_t)seed * 16 + use) * 2654435761u;
    return (uint32_t)((uint64_t)hash * count >> 32);
}

/* Changes what a random scene leaves as it is most often: format, evaluation, flags, camera and number of lights. */
static void vary(random_scene *s, uint64_t seed) {
    const glint_evaluation *const evaluations[3] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    if (varied_pick(seed, 5, 2))
        s->format = every_format[varied_pick(seed, 6, FORMAT_COUNT)];
    for (uint32_t i = 0; i < s->scene.object_count; i++) {
        if (varied_pick(seed, 7, 2))
            s->objects[i].evaluation = evaluations[varied_pick(seed + i, 8, 3)];
        if (varied_pick(seed, 9, 6) == 0)
            s->materials[i].model = &glint_model_unlit;
        if (varied_pick(seed, 10, 4) == 0)
            s->materials[i].flags = varied_pick(seed + i, 11, 4);
    }
    if (varied_pick(seed, 12, 8) == 0) {
        s->scene.camera.projection = &glint_orthographic;
        s->scene.camera.view_height = GLINT_ONE + (glint_q16)varied_pick(seed, 13, 8 * GLINT_ONE);
    }
    if (varied_pick(seed, 14, 4) == 0)
        s->scene.light_count = s->scene.light_count > 1 ? 1 : 0;
}

/* One in four is large. */
void varied_scene_make(varied_scene *to, uint64_t seed) {
    random_scene *const any = &to->any;
    large_scene *const large = &to->large;
    const int is_large = seed % 4 == 0;
    if (is_large) {
        large_scene_make(large, seed / 4);
    } else {
        random_scene_make_in(any, (unsigned)(seed % RANDOM_TEXTURED_REGION), seed);
        vary(any, seed);
        if (seed % 3 == 1)
            random_scene_wear(any, seed);
    }
    source random = {~seed * 3};
    if (seed % 5 > 2 && is_large)
        random_layers_add(&large->scene, large->objects, large->materials, &large->fog, &random);
    else if (seed % 5 > 2)
        random_layers_add(&any->scene, any->objects, any->materials, &any->fog, &random);
    to->seed = seed;
    to->kind = is_large ? large_kind_names[large->kind] : random_regions[any->region].name;
    to->is_closed = is_large && large->is_closed && seed % 5 <= 2;
    to->width = is_large ? large->width : any->width;
    to->height = is_large ? large->height : any->height;
    to->format = is_large ? large->format : any->format;
    to->scene = is_large ? large->scene : any->scene;
}

picture_options varied_scene_options(const varied_scene *s) {
    picture_options how = {.gamma = varied_pick(s->seed, 3, 4) ? NULL : glint_gamma_srgb};
    if (s->seed % 5 > 2)
        how.layers = &glint_layers;
    if (s->seed % 5 == 4)
        how.background = (glint_painter){picture_paint_pattern, (void *)(uintptr_t)s->format};
    if (s->seed % 7 == 2 && s->width <= GLINT_SIZE_MAX / 2 && s->height <= GLINT_SIZE_MAX / 2)
        how.samples = &glint_samples_2x2;
    return how;
}
