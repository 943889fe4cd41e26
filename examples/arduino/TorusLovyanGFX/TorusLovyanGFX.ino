// SPDX-License-Identifier: MIT
// A torus that turns on a display of 320x240 pixels, through LovyanGFX, which knows many boards by itself: of ESP32,
// ESP32-S3, ESP8266 and others. A board that it does not know, such as one with RP2040, needs a class LGFX of its own.
// LovyanGFX's DMA sends a tile while the next one is drawn. Takes some 20 KB of RAM.
#define LGFX_AUTODETECT
#include <LovyanGFX.hpp>

#include <glint_extras.h>

static LGFX display;

// glint calls this for each finished tile. Its pixels have the high byte first, as the panel wants them: no swapping.
static int sendTile(void *, int x, int y, int width, int height, const void *pixels, size_t stride) {
    display.startWrite();
    display.setAddrWindow(x, y, width, height);
    for (int row = 0; row < height; row++)
        display.writePixelsDMA((const uint16_t *)((const uint8_t *)pixels + row * stride), width, false);
    return 0;
}

// glint calls this before it draws into these pixels again.
static int waitForTile(void *) {
    display.waitDMA();
    display.endWrite();
    return 0;
}

// ---- The scene

static int16_t positions[128][3], normals[128][3];
static uint16_t triangles[256][3];
static uint32_t arena[4096];

static glint_mesh torus;
static glint_material copper;
static glint_light sun;
static glint_object object;
static glint_scene scene;
static glint_config config;
static glint_renderer renderer;

static bool begin() {
    const glint_mesh_room room = {positions, normals, triangles, 128, 256};
    const glint_colour white = GLINT_COLOUR(1, 1, 1), paint = GLINT_COLOUR(0.6, 0.28, 0.12);

    copper = glint_material_paint(&glint_model_blinn_phong, paint, GLINT_ONE / 8, 40 * GLINT_ONE);
    sun = glint_sun(GLINT_VECTOR(-0.5, -0.8, -0.7), white);
    object = {&torus, &copper, glint_pose_identity(), &glint_per_fragment};
    scene = {glint_camera_default(), GLINT_VIEWER_INFINITE, {}, white, &sun, 1, &object, 1};
    config = {320, 240, 0, 0, &glint_format_rgb565_be, {sendTile, waitForTile, 0}, arena, sizeof arena};
    return glint_generate_torus(&torus, &room, 16, 8, GLINT_ONE, GLINT_Q16(0.42)) == GLINT_OK &&
           glint_init(&renderer, &config) == GLINT_OK;
}

void setup() {
    display.init();
    display.setRotation(1); // 320 wide, 240 high
    if (!begin())
        for (;;)
            delay(1000);
}

void loop() {
    static glint_q16 degrees = 0;
    const glint_pose tilt = glint_pose_rotate_x(GLINT_Q16(-50)), turn = glint_pose_rotate_y(degrees);

    object.pose = glint_pose_then(&tilt, &turn);
    degrees = degrees < GLINT_Q16(354) ? degrees + GLINT_Q16(6) : 0;
    glint_render(&renderer, &scene);
}
