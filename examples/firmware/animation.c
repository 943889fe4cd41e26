/* SPDX-License-Identifier: MIT */
#include "animation.h"

#include "scenes/stage.h"

/* Which variant shows the scene best in colour. */
static const struct {
    const example_scene *scene;
    const char *variant;
} shown[] = {
    {&example_teapot, "fragment"},      {&example_three_spheres, "phong"}, {&example_surfaces, "metal"},
    {&example_phong_lighting, "orbit"}, {&example_shaders, "torus-50"},    {&example_halloween, "night"},
    {&example_still_life, "dusk"},
};

static int is_equal(const char *a, const char *b) {
    while (*a != '\0' && *a == *b) {
        a++, b++;
    }
    return *a == *b;
}

static uint32_t find_variant(const example_scene *scene, const char *name) {
    uint32_t variant = 0;

    while (variant + 1 < scene->variant_count && !is_equal(scene->variants[variant].name, name)) {
        variant++;
    }
    return variant;
}

/* Turns where directional lights shine, and where others stand, about the y axis. */
static void turn_lights(example_stage *stage, glint_q16 degrees) {
    const glint_q16 sine = glint_sin(degrees), cosine = glint_cos(degrees);

    for (uint32_t i = 0; i < stage->scene.light_count; i++) {
        glint_light *light = &stage->lights[i];
        glint_vector *turned = light->type == &glint_light_directional ? &light->direction : &light->position;
        const glint_vector from = *turned;

        turned->x = stage_multiply(from.x, cosine) + stage_multiply(from.z, sine);
        turned->z = stage_multiply(from.z, cosine) - stage_multiply(from.x, sine);
    }
}

const glint_format *animation_format(const glint_format *format) {
    return format == &glint_format_rgb565_be ? &glint_format_rgb565_be_dithered
           : format == &glint_format_rgb565  ? &glint_format_rgb565_dithered
                                             : format;
}

const example_scene *animation_build(example_stage *stage, uint32_t index, uint16_t width, uint16_t height) {
    const uint32_t number = index / ANIMATION_FRAMES, step = index % ANIMATION_FRAMES;

    if (number >= COUNT_OF(shown)) {
        return 0;
    }
    const example_scene *scene = shown[number].scene;
    scene->build(stage, find_variant(scene, shown[number].variant), step * scene->frames / ANIMATION_PERIOD);
    if (scene->frames == 1) {
        turn_lights(stage, (glint_q16)step * (360 / ANIMATION_PERIOD) * GLINT_ONE);
    }
    example_fit(stage, scene, width, height);
    return scene;
}
