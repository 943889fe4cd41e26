// SPDX-License-Identifier: MIT
// A torus that turns on an ILI9341 of 320x240 pixels, at the board's SPI. Takes some 20 KB of RAM.
#include <SPI.h>

#include <glint_extras.h>

// Wiring, beside SCK and MOSI; reset is tied to the board's own.
const int PIN_SELECT = 10, PIN_DATA = 9;
const SPISettings BUS(10000000, MSBFIRST, SPI_MODE0);

// ---- The panel

static void sendCommand(uint8_t command, const uint8_t *bytes, size_t count) {
    digitalWrite(PIN_DATA, LOW);
    SPI.transfer(command);
    digitalWrite(PIN_DATA, HIGH);
    for (size_t i = 0; i < count; i++)
        SPI.transfer(bytes[i]);
}

static void startPanel() {
    static const uint8_t turned = 0x28, bits16 = 0x55;

    pinMode(PIN_SELECT, OUTPUT);
    pinMode(PIN_DATA, OUTPUT);
    digitalWrite(PIN_SELECT, HIGH);
    SPI.begin();
    delay(120);
    SPI.beginTransaction(BUS);
    digitalWrite(PIN_SELECT, LOW);
    sendCommand(0x01, 0, 0); // software reset
    delay(120);
    sendCommand(0x11, 0, 0); // out of sleep
    delay(120);
    sendCommand(0x36, &turned, 1);
    sendCommand(0x3a, &bits16, 1);
    sendCommand(0x29, 0, 0); // display on
    digitalWrite(PIN_SELECT, HIGH);
    SPI.endTransaction();
}

static void sendRange(uint8_t command, int first, int last) {
    const uint8_t bytes[4] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};

    sendCommand(command, bytes, 4);
}

// glint calls this for each finished tile. What SPI.transfer sends it overwrites, so it gets copies of rows.
static int sendTile(void *, int x, int y, int width, int height, const void *pixels, size_t stride) {
    static uint8_t line[2 * 64];

    SPI.beginTransaction(BUS);
    digitalWrite(PIN_SELECT, LOW);
    sendRange(0x2a, x, x + width - 1);
    sendRange(0x2b, y, y + height - 1);
    sendCommand(0x2c, 0, 0);
    for (int row = 0; row < height; row++) {
        const uint8_t *from = (const uint8_t *)pixels + row * stride;

        for (int i = 0; i < 2 * width; i++)
            line[i] = from[i];
        SPI.transfer(line, 2 * width);
    }
    digitalWrite(PIN_SELECT, HIGH);
    SPI.endTransaction();
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

    copper.model = &glint_model_blinn_phong;
    copper.ambient = GLINT_COLOUR(0.08, 0.04, 0.02);
    copper.diffuse = GLINT_COLOUR(0.6, 0.28, 0.12);
    copper.specular = GLINT_COLOUR(0.6, 0.4, 0.3);
    copper.shininess = 40 * GLINT_ONE;
    sun = glint_sun(GLINT_VECTOR(-0.5, -0.8, -0.7), GLINT_COLOUR(1, 1, 1));
    object.mesh = &torus;
    object.material = &copper;
    object.evaluation = &glint_per_fragment;
    scene.camera = glint_camera_default();
    scene.ambient = GLINT_COLOUR(1, 1, 1);
    scene.lights = &sun;
    scene.light_count = 1;
    scene.objects = &object;
    scene.object_count = 1;
    config.width = 320;
    config.height = 240;
    config.format = &glint_format_rgb565_be;
    config.flush.begin = sendTile;
    config.arena = arena;
    config.arena_size = sizeof arena;
    config.keeps_arena = 1;
    return glint_generate_torus(&torus, &room, 16, 8, GLINT_ONE, GLINT_Q16(0.42)) == GLINT_OK &&
           glint_init(&renderer, &config) == GLINT_OK;
}

void setup() {
    startPanel();
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
