/* SPDX-License-Identifier: MIT */
/* Objects that are not opaque, and fog: sound, or with any numbers. */
#include "drawing.h"

static glint_q16 take_opacity(source *s, int is_sound) {
    if (!is_sound && one_in(s, 16))
        return any(s);
    return below(s, 4) ? (glint_q16)take(s, 2) : GLINT_ONE;
}

static void take_fog(source *s, drawing *d, int is_sound) {
    static const glint_fog_type *const types[2] = {&glint_fog_linear, &glint_fog_squared};
    glint_fog *const fog = &d->fog;
    fog->type = is_sound || below(s, 32) ? types[below(s, 2)] : NULL;
    fog->colour.r = (glint_q16)take(s, 2);
    fog->colour.g = is_sound || below(s, 32) ? (glint_q16)take(s, 2) : any(s);
    fog->colour.b = (glint_q16)take(s, 2);
    fog->start = any(s);
    fog->end = any(s);
    fog->to_background = (uint8_t)below(s, 2);
    if (is_sound || below(s, 8)) {
        fog->start &= INT32_MAX >> 1;
        fog->end = fog->start + 1 + (fog->end & INT32_MAX >> 1);
    }
    d->scene.fog = fog;
}

int take_layers(source *s, drawing *d, int is_sound) {
    if (!below(s, 3))
        return 0;
    for (int i = 0; i < DRAWING_OBJECTS; i++) {
        d->materials[i].blend = (glint_blend)(is_sound || below(s, 32) ? below(s, 4) : take(s, 4));
        d->materials[i].opacity = take_opacity(s, is_sound);
        d->objects[i].order = (int16_t)(below(s, 4) ? 0 : take(s, 2));
    }
    if (below(s, 2))
        take_fog(s, d, is_sound);
    return is_sound || below(s, 8);
}
