/* SPDX-License-Identifier: MIT */
#include "shown.h"

static const example_scene *const scenes[] = {&example_three_spheres, &example_teapot, &example_phong_lighting};

/* Appends `text` at `length`. @return the new length */
static size_t append(char *name, size_t length, const char *text) {
    for (; *text != '\0' && length + 1 < SHOWN_NAME_SIZE; text++) {
        name[length++] = *text;
    }
    name[length] = '\0';
    return length;
}

int shown_find(shown_frame *shown, uint32_t index) {
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        const uint32_t frames = scenes[i]->frames < SHOWN_FRAMES ? scenes[i]->frames : SHOWN_FRAMES;
        const uint32_t count = scenes[i]->variant_count * frames;

        if (index < count) {
            shown->scene = scenes[i];
            shown->variant = index / frames;
            shown->frame = index % frames * scenes[i]->frames / 3;
            const size_t length = append(shown->name, append(shown->name, 0, shown->scene->name), "-");
            append(shown->name, length, shown->scene->variants[shown->variant].name);
            return 1;
        }
        index -= count;
    }
    return 0;
}
