/* SPDX-License-Identifier: MIT */
#include "glint.h"
#include "lcd.h"             /* yours: starts the panel, sends a command and its parameters, sends pixels */
#include "meshes/torus576.h" /* made by glint convert torus:24x12 */

/* Sends a finished tile to a panel such as ST7735, ST7789 or ILI9341: its columns, its rows, its pixels. */
static int take_tile(void *lcd, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const int right = x + width - 1, bottom = y + height - 1;
    const uint8_t columns[] = {(uint8_t)(x >> 8), (uint8_t)x, (uint8_t)(right >> 8), (uint8_t)right};
    const uint8_t rows[] = {(uint8_t)(y >> 8), (uint8_t)y, (uint8_t)(bottom >> 8), (uint8_t)bottom};
    int failed = lcd_send(lcd, 0x2a, columns, 4) || lcd_send(lcd, 0x2b, rows, 4) || lcd_send(lcd, 0x2c, rows, 0);
    for (int row = 0; row < height && !failed; row++)
        failed = lcd_pixels(lcd, (const uint8_t *)pixels + (size_t)row * stride, 2 * (size_t)width);
    return failed; /* not 0: the frame ends with GLINT_ERROR_FLUSH */
}

int main(void) {
    static uint32_t arena[8192];
    const glint_colour white = GLINT_COLOUR(1, 1, 1), amber = GLINT_COLOUR(1, 0.5, 0), black = GLINT_COLOUR(0, 0, 0);
    const glint_material wax = glint_material_paint(&glint_model_blinn_phong, amber, GLINT_ONE / 10, 32 * GLINT_ONE);
    const glint_vector down_right = GLINT_VECTOR(1, -1, -1);
    const glint_light sun = glint_sun(down_right, white);
    glint_object torus = {&torus576_mesh, &wax, glint_pose_identity(), &glint_per_fragment};
    const glint_scene scene = {glint_camera_default(), GLINT_VIEWER_INFINITE, black, white, &sun, 1, &torus, 1};
    const glint_flush flush = {take_tile, 0, lcd_start()};
    const glint_config config = {320, 240, 0, 0, &glint_format_rgb565_be, flush, arena, sizeof arena};
    glint_renderer renderer;
    glint_init(&renderer, &config); /* if that fails, glint_render does */
    for (int turn = 5; glint_render(&renderer, &scene) == GLINT_OK; turn += 5)
        torus.pose = glint_pose_rotate_x(turn % 360 * GLINT_ONE);
    return 1;
}
