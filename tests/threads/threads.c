/* SPDX-License-Identifier: MIT */
/*
 * Suite: two callers draw the tiles of one prepared frame at the same time and get the same bits as one caller.
 * Run under ThreadSanitizer. Built with SHARED_WORKSPACE they share what must not be shared, which it must report.
 */
#include "glint_extras.h"
#include "harness.h"
#include "picture.h"
#include "scenes.h"

#include <pthread.h>
#include <stdlib.h>

#define CALLERS 2

#define WIDTH 150
#define HEIGHT 101

/* One of those who draw: every second tile of a pass, so that a tile that takes several stays with its workspace. */
typedef struct caller {
    const glint_frame *frame;
    glint_workspace *workspace;
    picture *image;
    uint32_t number;
    int failed;
    pthread_t thread;
} caller;

static void *draw_tiles(void *context) {
    caller *self = context;
    for (uint32_t tile = self->frame->tile_first; tile < self->frame->tile_end; tile++) {
        int rectangle[4];
        if (tile % CALLERS != self->number || !glint_render_tile(self->frame, self->workspace, tile))
            continue;
        glint_tile_rectangle(self->frame, tile, &rectangle[0], &rectangle[1], &rectangle[2], &rectangle[3]);
        self->failed |= picture_put(self->image, rectangle, self->workspace->pixels, self->workspace->stride);
    }
    return NULL;
}

/* All callers at once. @return whether each could be started and put its tiles. */
static int draw_pass(caller callers[CALLERS]) {
    int started = 0, good = 1;
    for (; started < CALLERS; started++) {
        if (pthread_create(&callers[started].thread, NULL, draw_tiles, &callers[started]) != 0)
            break;
    }
    for (int i = 0; i < started; i++) {
        good &= pthread_join(callers[i].thread, NULL) == 0;
        good &= !callers[i].failed;
    }
    return good && started == CALLERS;
}

static void draw_together(const picture *wanted, const glint_scene *scene, const picture_options *options,
                          size_t arena_size) {
    picture got = picture_open(wanted->width, wanted->height, wanted->format);
    glint_config config = picture_config(&got, options);
    glint_workspace workspaces[CALLERS];
    void *memory[CALLERS];
    caller callers[CALLERS];
    glint_frame frame;
    config.arena_size = arena_size;
    config.arena = malloc(arena_size);
    for (uint32_t i = 0; i < CALLERS; i++) {
        memory[i] = malloc(glint_workspace_size(&config));
        CHECK(memory[i] != NULL);
        glint_workspace_init(&workspaces[i], &config, memory[i]);
        callers[i] = (caller){.frame = &frame, .workspace = &workspaces[i], .image = &got, .number = i};
    }
#ifdef SHARED_WORKSPACE
    callers[1].workspace = callers[0].workspace;
#endif
    int status = (int)glint_frame_begin(&frame, &config, scene);
    CHECK_EQUAL(status, GLINT_OK);
    while (status >= 0 && (status = glint_frame_next_pass(&frame)) > 0)
        CHECK(draw_pass(callers));
    CHECK_EQUAL(status, 0);
    CHECK(picture_is_complete(&got));
    CHECK(picture_equal(wanted, &got));
    for (uint32_t i = 0; i < CALLERS; i++)
        free(memory[i]);
    free(config.arena);
    picture_close(&got);
}

/* In one pass, in several, and in as many as the smallest arena takes. */
static void check_format(const glint_format *format) {
    for (unsigned i = 0; i < scene_count; i++) {
        test_scene scene;
        const picture_options options = {.tile_width = 16, .tile_height = 16};
        picture wanted = picture_open(WIDTH, HEIGHT, format);
        glint_config config = picture_config(&wanted, &options);
        glint_need need = {0};
        scene_build(&scene, &scene_definitions[i]);
        scene.scene.viewer = i % 2 ? GLINT_VIEWER_LOCAL : GLINT_VIEWER_INFINITE;
        CHECK_EQUAL(picture_render(&wanted, &scene.scene, &options, NULL), GLINT_OK);
        CHECK_EQUAL(glint_arena_need(&config, &scene.scene, &need), GLINT_OK);
        draw_together(&wanted, &scene.scene, &options, need.one_pass);
        draw_together(&wanted, &scene.scene, &options, need.least + (need.one_pass - need.least) / 3);
        draw_together(&wanted, &scene.scene, &options, need.least);
        picture_close(&wanted);
    }
}

static void same_bits_in_rgb565(void) {
    check_format(&glint_format_rgb565);
}

static void same_bits_in_rgb888(void) {
    check_format(&glint_format_rgb888);
}

int test_main(test_writer write) {
    static const test_case cases[] = {TEST_CASE(same_bits_in_rgb565), TEST_CASE(same_bits_in_rgb888)};
    return test_run(write, cases, TEST_COUNT(cases));
}
