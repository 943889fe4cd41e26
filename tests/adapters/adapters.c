/* SPDX-License-Identifier: MIT */
/*
 * Each adapter of examples/adapters/ against doubles of the interface that it serves: what arrives there is, byte for
 * byte, what the same scene looks like without an adapter.
 */
#include "adapters.h"

#include <meshes/torus576.h>
#include <string.h>

#define RGB(r, g, b) \
    { GLINT_Q16(r), GLINT_Q16(g), GLINT_Q16(b) }

const glint_scene *adapted_scene(void) {
    static const glint_material copper = {&glint_model_blinn_phong, RGB(0.1, 0.1, 0.1), RGB(0.7, 0.4, 0.2),
                                          RGB(0.4, 0.4, 0.4), GLINT_Q16(24)};
    static const glint_light lamp = {
        &glint_light_directional, {0, 0, 0}, RGB(0.5, -0.8, -0.7), RGB(1, 1, 1), RGB(1, 1, 1)};
    static glint_object torus = {.mesh = &torus576_mesh, .material = &copper, .evaluation = &glint_per_fragment};
    static glint_scene scene = {.viewer = GLINT_VIEWER_LOCAL,
                                .background = RGB(0.1, 0.2, 0.4),
                                .ambient = RGB(1, 1, 1),
                                .lights = &lamp,
                                .light_count = 1,
                                .objects = &torus,
                                .object_count = 1};

    torus.pose = glint_pose_rotate_x(GLINT_Q16(-40));
    scene.camera.field_of_view = GLINT_Q16(45);
    scene.camera.near_plane = GLINT_Q16(0.1);
    scene.camera.pose = glint_pose_translate(0, 0, GLINT_Q16(4));
    return &scene;
}

glint_config adapted_config(const glint_format *format, glint_flush flush, int number) {
    static uint32_t arenas[2][16384];

    return (glint_config){.width = ADAPTED_WIDTH,
                          .height = ADAPTED_HEIGHT,
                          .format = format,
                          .flush = flush,
                          .arena = arenas[number],
                          .arena_size = sizeof arenas[number]};
}

glint_status adapted_draw(const glint_config *config) {
    glint_renderer renderer;
    const glint_status status = glint_init(&renderer, config);

    return status == GLINT_OK ? glint_render(&renderer, adapted_scene()) : status;
}

static int to_memory(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    adapted_memory *const memory = context;
    const size_t pitch = glint_row_bytes(memory->format, ADAPTED_WIDTH);
    const int is_paged = memory->format == &glint_format_mono_pages;

    memory->sent++;
    if (memory->refuses && memory->sent >= memory->refuses)
        return memory->refuses;
    if (is_paged) {
        for (int page = 0; page < height / 8; page++)
            memcpy(memory->bytes + (size_t)(y / 8 + page) * ADAPTED_WIDTH + x,
                   (const uint8_t *)pixels + (size_t)page * 8 * stride, (size_t)width);
        return 0;
    }
    for (int row = 0; row < height; row++)
        memcpy(memory->bytes + (size_t)(y + row) * pitch + glint_row_bytes(memory->format, (uint32_t)x),
               (const uint8_t *)pixels + (size_t)row * stride, glint_row_bytes(memory->format, (uint32_t)width));
    return 0;
}

glint_flush adapted_flush(adapted_memory *memory) {
    return (glint_flush){.begin = to_memory, .context = memory};
}

const uint8_t *adapted_expected(const glint_format *format) {
    static uint8_t bytes[ADAPTED_BYTES];
    adapted_memory memory = {format, bytes, 0, 0};
    const glint_config config = adapted_config(format, adapted_flush(&memory), 0);
    int differs = 0;

    memset(bytes, 0, sizeof bytes);
    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    for (size_t i = 1; i < glint_row_bytes(format, ADAPTED_WIDTH) * ADAPTED_HEIGHT; i++)
        differs += bytes[i] != bytes[0];
    CHECK(differs > 100); /* something shows */
    return bytes;
}

static const test_case cases[] = {
    TEST_CASE(lvgl_canvas_shows_the_scene),
    TEST_CASE(lvgl_alpha_shows_what_objects_cover),
    TEST_CASE(lvgl_areas_are_the_whole),
    TEST_CASE(lvgl_waits_for_what_lies_behind),
    TEST_CASE(lvgl_area_elsewhere_draws_nothing),
    TEST_CASE(lvgl_canvas_that_does_not_fit_is_refused),
    TEST_CASE(lvgl_layers_show_the_model),
    TEST_CASE(lvgl_layer_that_cannot_be_drawn_is_refused),
    TEST_CASE(zephyr_is_sent_the_scene),
    TEST_CASE(zephyr_error_is_kept),
    TEST_CASE(u8x8_is_sent_the_scene),
    TEST_CASE(u8x8_error_ends_the_frame),
    TEST_CASE(tft_espi_is_sent_the_scene),
    TEST_CASE(stm32_hal_sends_by_dma),
    TEST_CASE(stm32_hal_gives_a_dead_bus_up),
    TEST_CASE(linux_fb_shows_the_scene),
    TEST_CASE(linux_fb_of_32_bits_is_refused),
    TEST_CASE(linux_drm_shows_the_scene),
    TEST_CASE(linux_drm_error_leaves_nothing_open),
    TEST_CASE(freertos_tasks_share_a_panel),
    TEST_CASE(freertos_error_ends_its_frame_only),
};

int test_main(void (*write)(const char *text)) {
    return test_run(write, cases, TEST_COUNT(cases));
}
