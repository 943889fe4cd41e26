// SPDX-License-Identifier: MIT
// A pyramid that turns on a monochrome SSD1306 of 128x64 pixels, at the board's I2C. Takes some 12 KB of RAM.
#include <Wire.h>

#include <glint.h>

const uint8_t ADDRESS = 0x3c;

// ---- The panel

static int sendCommands(const uint8_t *bytes, size_t count) {
    Wire.beginTransmission(ADDRESS);
    Wire.write((uint8_t)0x00); // commands follow
    Wire.write(bytes, count);
    return Wire.endTransmission();
}

static int startPanel() {
    // 64 lines, charge pump, rows of pages, mirrored as modules are, contrast, display on
    static const uint8_t start[] = {0xae, 0xa8, 63, 0x8d, 0x14, 0x20, 0x00, 0xa1, 0xc8, 0xda, 0x12, 0x81, 0xcf, 0xaf};

    delay(100);
    Wire.begin();
    Wire.setClock(400000);
    return sendCommands(start, sizeof start);
}

// glint calls this for each finished tile: pages of 8 rows, a byte for each column. In portions that Wire's buffer
// holds.
static int sendTile(void *, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const uint8_t window[6] = {0x21, (uint8_t)x,       (uint8_t)(x + width - 1),
                               0x22, (uint8_t)(y / 8), (uint8_t)((y + height - 1) / 8)};
    int failed = sendCommands(window, sizeof window);

    for (int page = 0; page < height / 8 && !failed; page++) {
        for (int column = 0; column < width && !failed; column += 8) {
            Wire.beginTransmission(ADDRESS);
            Wire.write((uint8_t)0x40); // pixels follow
            Wire.write((const uint8_t *)pixels + page * 8 * stride + column, 8);
            failed = Wire.endTransmission();
        }
    }
    return failed;
}

// ---- The scene

#define GREY(level) GLINT_COLOUR(level, level, level)

static const int16_t points[4][3] = {{0, 32767, 0}, {-32767, -16384, 0}, {32767, -16384, 0}, {0, 0, 32767}};
static const uint16_t sides[4][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}; // counter-clockwise from outside
static const glint_mesh pyramid = {points, points /* as normals */, sides, 4, 4, {0, 0, 0}, GREY(1), 0, 0, 0, 0};
static const glint_material clay = {&glint_model_blinn_phong, GREY(0.1), GREY(0.6), GREY(0.4), GLINT_Q16(32), 0};
static uint32_t arena[2048];

static glint_light sun;
static glint_object object;
static glint_scene scene;
static glint_config config;
static glint_renderer renderer;

static bool begin() {
    sun = glint_sun(GLINT_VECTOR(1, -1, -1), GREY(1));
    object.mesh = &pyramid;
    object.material = &clay;
    object.evaluation = &glint_per_fragment;
    scene.camera = glint_camera_default();
    scene.camera.field_of_view = 40 * GLINT_ONE;
    scene.ambient = GREY(1);
    scene.lights = &sun;
    scene.light_count = 1;
    scene.objects = &object;
    scene.object_count = 1;
    config.width = 128;
    config.height = 64;
    config.format = &glint_format_mono_pages_dithered;
    config.flush.begin = sendTile;
    config.arena = arena;
    config.arena_size = sizeof arena;
    return glint_init(&renderer, &config) == GLINT_OK;
}

void setup() {
    if (startPanel() || !begin())
        for (;;)
            delay(1000);
}

void loop() {
    static glint_q16 degrees = 0;

    object.pose = glint_pose_rotate_y(degrees);
    degrees = degrees < GLINT_Q16(355) ? degrees + GLINT_Q16(5) : 0;
    glint_render(&renderer, &scene);
}
