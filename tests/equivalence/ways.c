/* SPDX-License-Identifier: MIT */
#include "ways.h"

#include "every_format.h"
#include "glint_extras.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TILES_MAX 1024

/* Takes a number below `limit` from a choice (Numerical Recipes). */
static uint32_t take(uint32_t *choice, uint32_t limit) {
    *choice = *choice * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)(*choice >> 8) * limit >> 24);
}

static void *allocate(size_t size) {
    void *const memory = malloc(size ? size : 1);
    if (memory == NULL) {
        fputs("out of memory\n", stderr);
        exit(1);
    }
    return memory;
}

/* The least arena, that of one pass, or any between. */
static size_t take_arena(uint32_t *choice, const glint_need *need) {
    const uint32_t share = take(choice, 4);
    return share == 0 ? need->least : share == 1 ? need->one_pass : picture_arena(need, take(choice, 257));
}

/* Aligned anyhow. */
static int in_any_arena(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    const glint_need need = picture_need(wanted, scene, how);
    picture_options options = *how;
    options.arena_size = take_arena(&choice, &need);
    options.skew = (uint8_t)take(&choice, 8);
    return picture_draws_same(wanted, scene, &options, NULL);
}

static int in_any_tiles(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    picture_options options = *how;
    const uint32_t sizes = how->samples ? 3 : 4; /* up to 32 or 64 */
    options.tile_width = (uint16_t)(8u << take(&choice, sizes));
    options.tile_height = (uint16_t)(8u << take(&choice, sizes));
    options.waits = (uint8_t)take(&choice, 2);
    return in_any_arena(wanted, scene, &options, choice);
}

/* Takes part of a side, from one step to another or to the side's end. */
static void take_part(uint32_t *choice, int side, int step, int16_t *from, int16_t *size) {
    const uint32_t steps = ((uint32_t)side + (uint32_t)step - 1) / (uint32_t)step, first = take(choice, steps);
    const int end = step * (int)(first + 1 + take(choice, steps - first));
    *from = (int16_t)(step * (int)first);
    *size = (int16_t)((end < side ? end : side) - *from);
}

/* Of edges that divide no byte. */
static int in_any_region(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    const size_t bits = glint_row_bytes(wanted->format, 8);
    const int is_paged = format_is_paged(wanted->format);
    picture_options options = *how;
    take_part(&choice, wanted->width,
              bits % 8 == 0 || is_paged ? 1
              : bits == 1               ? 8
                                        : 2,
              &options.region.x, &options.region.width);
    take_part(&choice, wanted->height, is_paged ? 8 : 1, &options.region.y, &options.region.height);
    return in_any_tiles(wanted, scene, &options, choice);
}

/* ---- Frames before ---- */

/* The scene without its first object, under another light. */
static glint_scene other_scene(const glint_scene *scene) {
    glint_scene other = *scene;
    other.ambient.g /= 2;
    if (scene->object_count) {
        other.objects++;
        other.object_count--;
    }
    return other;
}

/* Once and again by a renderer that keeps its arena, after a frame of another scene. */
static int after_frames(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    const glint_scene other = other_scene(scene);
    picture_options options = *how;
    options.keeps_arena = 1;
    const glint_need need = picture_need(wanted, scene, &options);
    options.arena_size = take_arena(&choice, &need);
    options.before = take(&choice, 4) ? &other : scene;
    return picture_draws_same(wanted, scene, &options, NULL);
}

/* Opens a renderer that draws into `image` with an arena of its own. */
static glint_status open_renderer(glint_renderer *renderer, glint_config *config, const glint_scene *scene,
                                  uint32_t *choice) {
    glint_need need;
    const glint_status status = glint_arena_need(config, scene, &need);
    if (status != GLINT_OK)
        return status;
    config->arena_size = take_arena(choice, &need);
    config->arena = allocate(config->arena_size);
    return glint_init(renderer, config);
}

/*
 * On a screen that is sent changes alone, after a frame of another scene; once more nothing changes. After a region of
 * the other scene the frame becomes whole again.
 */
static int by_changes(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    const glint_rectangle part = {(int16_t)(8 * take(&choice, 2)), (int16_t)(8 * take(&choice, 2)), 8, 8};
    const glint_scene other = other_scene(scene);
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    glint_config config = picture_config(&got, how);
    glint_renderer renderer;
    glint_change_filter changes;
    glint_tile_signature *const signatures = allocate(glint_tile_signature_count(&config) * sizeof *signatures);
    int right = glint_change_filter_init(&changes, signatures, &config) == GLINT_OK;
    config.flush = glint_change_filter_flush(&changes);
    right = right && open_renderer(&renderer, &config, scene, &choice) == GLINT_OK;
    if (right)
        (void)glint_render(&renderer, &other); /* it may need more arena */
    for (int frame = 0; frame < 3 && right; frame++) {
        const int calls = got.calls;
        right = glint_render(&renderer, scene) == GLINT_OK && !got.sending && picture_equal(wanted, &got) &&
                (frame != 1 || got.calls == calls);
        if (frame == 1)
            (void)glint_render_region(&renderer, &other, &part);
    }
    free(config.arena);
    free(signatures);
    picture_close(&got);
    return right;
}

/* ---- Memory and order ---- */

/* With pixels apart from the arena, in just as much memory as they need. */
static int with_pixels_apart(const picture *wanted, const glint_scene *scene, const picture_options *how,
                             uint32_t choice) {
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    glint_config config = picture_config(&got, how);
    glint_renderer renderer;
    config.pixels_size = glint_pixels_need(&config);
    void *const pixels = config.pixels = allocate(config.pixels_size);
    const int right = open_renderer(&renderer, &config, scene, &choice) == GLINT_OK &&
                      glint_render(&renderer, scene) == GLINT_OK && picture_is_complete(&got) &&
                      picture_equal(wanted, &got);
    free(config.arena);
    free(pixels);
    picture_close(&got);
    return right;
}

/* Draws the tiles of a pass in any order, each with one of two workspaces: so do two cores. */
static int draw_pass(glint_frame *frame, glint_workspace workspaces[2], picture *to, uint32_t *choice) {
    static uint16_t order[TILES_MAX];
    const uint32_t count = (uint32_t)frame->tile_end - frame->tile_first, which = take(choice, 2);
    int right = count <= TILES_MAX;
    for (uint32_t i = 0; i < count && right; i++) { /* shuffled as it grows (Durstenfeld, 1964) */
        const uint32_t at = take(choice, i + 1);
        order[i] = order[at];
        order[at] = (uint16_t)(frame->tile_first + i);
    }
    for (uint32_t i = 0; i < count && right; i++) {
        glint_workspace *const by =
            &workspaces[count > 1 ? (i + which) % 2 : 0]; /* a tile alone may take more passes */
        int at[4];
        if (!glint_render_tile(frame, by, order[i]))
            continue;
        glint_tile_rectangle(frame, order[i], &at[0], &at[1], &at[2], &at[3]);
        right = !picture_put(to, at, by->pixels, by->stride);
    }
    return right;
}

static int in_any_order(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    glint_config config = picture_config(&got, how);
    const glint_need need = picture_need(wanted, scene, how);
    glint_frame frame = {0};
    glint_workspace workspaces[2];
    config.arena_size = take_arena(&choice, &need);
    config.arena = allocate(config.arena_size);
    const size_t size = glint_workspace_size(&config);
    void *const memory[2] = {allocate(size), allocate(size)};
    for (int i = 0; i < 2; i++)
        glint_workspace_init(&workspaces[i], &config, memory[i]);
    int status = glint_frame_begin(&frame, &config, scene);
    while (status >= 0 && (status = glint_frame_next_pass(&frame)) > 0)
        if (!draw_pass(&frame, workspaces, &got, &choice))
            status = GLINT_ERROR_FLUSH;
    const int right = status == 0 && picture_is_complete(&got) && picture_equal(wanted, &got);
    for (int i = 0; i < 2; i++)
        free(memory[i]);
    free(config.arena);
    picture_close(&got);
    return right;
}

/* With layers, whether the scene has any or not. */
static int with_layers(const picture *wanted, const glint_scene *scene, const picture_options *how, uint32_t choice) {
    picture_options options = *how;
    options.layers = &glint_layers;
    return in_any_tiles(wanted, scene, &options, choice);
}

const way ways[] = {
    {"any arena", in_any_arena},          {"any tiles", in_any_tiles},          {"any region", in_any_region},
    {"tiles in any order", in_any_order}, {"after other frames", after_frames}, {"changes alone", by_changes},
    {"pixels apart", with_pixels_apart},  {"with layers", with_layers},
};
const unsigned way_count = sizeof ways / sizeof ways[0];
