/* SPDX-License-Identifier: MIT */
/**
 * @file ways.h
 * Ways to draw a scene: what is left out of it, and what that is allowed to change. Alike on the host, which counts
 * what was modelled, and on the boards, which count instructions.
 */
#ifndef CHART_WAYS_H
#define CHART_WAYS_H

#include "image/undropped.h"

typedef struct way {
    const char *name;
    int drops;            /**< Not 0: as the library draws; 0: by the twins that drop nothing. */
    int32_t error_budget; /**< Steps of an output channel. */
} way;

static const way ways[] = {
    {"undropped", 0, 0}, {"exact", 1, 0}, {"budget 1", 1, 1}, {"budget 2", 1, 2}, {"budget 4", 1, 4}};
#define WAYS (sizeof ways / sizeof *ways)

/** Of a scene: itself in that way, made in `room`, which is not to be moved. Null when it has too many objects. */
static inline const glint_scene *scene_in_way(const way *chosen, const glint_scene *scene, undropped_scene *room) {
    if (!chosen->drops)
        return undropped_make(room, scene) ? &room->scene : 0;
    room->scene = *scene;
    room->scene.error_budget = chosen->error_budget;
    return &room->scene;
}

/** The format that goes with it. */
static inline const glint_format *format_in_way(const way *chosen) {
    return chosen->drops ? &glint_format_rgb565 : undropped_format(&glint_format_rgb565);
}

/** The frame of an example scene that is drawn: past the middle of those that move. */
static inline uint32_t frame_in_middle(uint32_t frames) {
    return frames / 2;
}

/** Lights objects per fragment that are lit per node, as twins that drop nothing do: nodes look at the lights' terms.
 */
static inline void light_at_fragments(glint_object objects[], uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        if (objects[i].evaluation == &glint_per_node)
            objects[i].evaluation = &glint_per_fragment;
}

#endif
