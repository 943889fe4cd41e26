/* SPDX-License-Identifier: MIT */
/* Frames and tiles, and which of them changed. */
#include "proof.h"

#include "../../src/frame/frame.c"
#include "../../src/frame/region.c"
#include "../../src/scene/config.c"
#undef wait
#include "../../src/frame/changes.c"
#include "contracts.h"

/*
 * Not proven: glint_frame_next, glint_arena_need, glint_arena_need_turned: counts of what a scene has, and of bytes,
 * unsigned. Suites `unit`, `identity` and `turned` under ASan and UBSan, and fuzzing.
 */

/*
 * Not proven: glint_raster, glint_render_tile, glint_render, glint_render_region, glint_tile_find,
 * glint_pick, glint_changes_flush: they call what is proven, on spans
 * and pixels inside a tile. The image tests and suites `identity`, `region`, `pick` and `changes` under ASan and UBSan,
 * and fuzzing.
 */

/*
 * Not proven: glint_prepare_view, glint_fast_prepare: once a frame, they call what is proven. Suites `unit`,
 * `models` and `drops` under ASan and UBSan, and fuzzing.
 */

static glint_format format;

static void any_config(glint_config *config) {
    config->width = (uint16_t)ANY(0, UINT16_MAX);
    config->height = (uint16_t)ANY(0, UINT16_MAX);
    config->tile_width = (uint16_t)ANY(0, UINT16_MAX);
    config->tile_height = (uint16_t)ANY(0, UINT16_MAX);
    format.bits = (uint8_t)ANY(1, 24);
    format.edge[0] = (uint8_t)ANY(0, 7);
    format.edge[1] = (uint8_t)ANY(0, 7);
    config->format = ANY(0, 1) ? &format : 0;
    config->region = (glint_rectangle){(int16_t)ANY(INT16_MIN, INT16_MAX), (int16_t)ANY(INT16_MIN, INT16_MAX),
                                       (int16_t)ANY(INT16_MIN, INT16_MAX), (int16_t)ANY(INT16_MIN, INT16_MAX)};
}

/* Any configuration. @unsigned */
PROOF(glint_check_config) {
    glint_config config;
    any_config(&config);
    if (glint_check_config(&config) == GLINT_OK)
        glint_row_bytes(config.format, config.tile_width);
}

/* Any configuration. @unreached 2 leading zeros of 0 */
PROOF(glint_frame_grid) {
    glint_frame frame;
    glint_config config = {0};
    any_config(&config);
    glint_frame_grid(&frame, &config, 0);
}

/* Any region of any screen, in any format. */
PROOF(glint_check_region) {
    glint_config config = {0};
    any_config(&config);
    if (glint_check_config(&config) == GLINT_OK)
        glint_check_region(&config);
}

/* Any tile of any region. */
PROOF(glint_tile_rectangle) {
    glint_frame frame;
    int x, y, width, height;
    frame.right = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.bottom = (uint16_t)ANY(1, GLINT_SIZE_MAX);
    frame.config.region.x = (int16_t)ANY(0, GLINT_SIZE_MAX - 1);
    frame.config.region.y = (int16_t)ANY(0, GLINT_SIZE_MAX - 1);
    FOR_PARTS(shift, 3, 6) {
        frame.tile_shift_x = frame.tile_shift_y = (uint8_t)shift;
        frame.config.tile_width = frame.config.tile_height = (uint16_t)(1 << shift);
        frame.tile_columns = (uint16_t)ANY(1, GLINT_SIZE_MAX >> shift);
        frame.first_column = (uint16_t)ANY(0, (GLINT_SIZE_MAX - 1) >> shift);
        frame.first_row = (uint16_t)ANY(0, (GLINT_SIZE_MAX - 1) >> shift);
        glint_tile_rectangle(&frame, ANY_UNSIGNED(0, 128 * 128 - 1), &x, &y, &width, &height);
    }
}

/* Any pixels of a tile. @options -eva-slevel 0 */
PROOF(sign) {
    static uint32_t pixels[GLINT_TILE_MAX * GLINT_TILE_MAX];
    Frama_C_make_unknown((char *)pixels, sizeof pixels);
    sign(pixels, ANY_UNSIGNED(0, GLINT_TILE_MAX * GLINT_TILE_MAX));
}
