/* SPDX-License-Identifier: MIT */
/**
 * @file adapters.h
 * What the cases of all adapters share: a scene on a screen that tiles do not fit, as it looks without any adapter.
 */
#ifndef GLINT_TESTS_ADAPTERS_H
#define GLINT_TESTS_ADAPTERS_H

#include "harness.h"

#include <glint.h>

/** Multiples of 8, as u8x8 has it, and of no tile. */
enum { ADAPTED_WIDTH = 104, ADAPTED_HEIGHT = 72, ADAPTED_BYTES = ADAPTED_WIDTH * ADAPTED_HEIGHT * 3 };

/** A torus before a background, seen by a local viewer. */
const glint_scene *adapted_scene(void);

/** The configuration of a renderer: tiles of 32 x 32, an arena of its own for each of two `number`s. */
glint_config adapted_config(const glint_format *format, glint_flush flush, int number);

/** Draws the scene. */
glint_status adapted_draw(const glint_config *config);

/** Draws it into memory, rows packed, and returns that. */
const uint8_t *adapted_expected(const glint_format *format);

/** Flush that writes into memory of packed rows; its context is an adapted_memory. */
typedef struct adapted_memory {
    const glint_format *format;
    uint8_t *bytes;
    int refuses; /**< Returned from that many tiles on; 0 for never. */
    int sent;
} adapted_memory;
glint_flush adapted_flush(adapted_memory *memory);

/** The cases. */
void lvgl_canvas_shows_the_scene(void);
void lvgl_alpha_shows_what_objects_cover(void);
void lvgl_areas_are_the_whole(void);
void lvgl_waits_for_what_lies_behind(void);
void lvgl_area_elsewhere_draws_nothing(void);
void lvgl_canvas_that_does_not_fit_is_refused(void);
void lvgl_layers_show_the_model(void);
void lvgl_layer_that_cannot_be_drawn_is_refused(void);
void zephyr_is_sent_the_scene(void);
void zephyr_error_is_kept(void);
void u8x8_is_sent_the_scene(void);
void u8x8_error_ends_the_frame(void);
void tft_espi_is_sent_the_scene(void);
void stm32_hal_sends_by_dma(void);
void stm32_hal_gives_a_dead_bus_up(void);
void linux_fb_shows_the_scene(void);
void linux_fb_of_32_bits_is_refused(void);
void linux_drm_shows_the_scene(void);
void linux_drm_error_leaves_nothing_open(void);
void freertos_tasks_share_a_panel(void);
void freertos_error_ends_its_frame_only(void);

#endif
