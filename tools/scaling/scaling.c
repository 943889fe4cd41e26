/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of frames as they grow, in triangles, pixels, lights and objects: for
 * tools/scaling/scaling.py. It writes a line for each frame,
 *     triangles,2304,INSTRUCTIONS
 * Objects stand side by side, or one behind another so that each covers the same pixels: what order is worth.
 */
#include "bench/counter.h"
#include "bench/framebuffer.h"
#include "glint_extras.h"

#include <bench_scenes.h>

#define WIDTH_MAX 640
#define HEIGHT_MAX 480
#define VERTICES_MAX 25088
#define TRIANGLES_MAX (2 * VERTICES_MAX)
#define OBJECTS_MAX 30

static int16_t positions[VERTICES_MAX][3], normals[VERTICES_MAX][3];
static uint16_t triangles[TRIANGLES_MAX][3];
static const glint_mesh_room room = {positions, normals, triangles, VERTICES_MAX, TRIANGLES_MAX};
static uint32_t arena[(3 << 19) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT_MAX][WIDTH_MAX];

/** Where objects are, and in which order they are drawn. */
typedef enum arrangement { ALONE, SIDE_BY_SIDE, NEAREST_FIRST, FARTHEST_FIRST } arrangement;

/** What one frame is made of. */
typedef struct workload {
    const char *sweep;
    uint32_t count; /**< What the sweep counts. */
    uint16_t around, along;
    uint16_t width, height;
    uint32_t lights, objects;
    arrangement arrangement;
} workload;

#define TRIANGLES(around, along) \
    { "triangles", 2u * (around) * (along), around, along, 320, 240, 1, 1, ALONE }
#define PIXELS(width, height) \
    { "pixels", (width) * (height##u), 48, 24, width, height, 1, 1, ALONE }
#define LIGHTS(count) \
    { "lights", count, 48, 24, 320, 240, count, 1, ALONE }
#define OBJECTS(count) \
    { "objects", count, 12, 8, 320, 240, 1, count, SIDE_BY_SIDE }

#define LAYER(sweep, count, lights, order) \
    { sweep, count, 48, 24, 320, 240, lights, count, order }
#define LAYERS(sweep, lights, order) \
    LAYER(sweep, 1, lights, order), LAYER(sweep, 2, lights, order), LAYER(sweep, 4, lights, order)

/* One directional light goes the fast way, two the general one. */
static const workload workloads[] = {
    TRIANGLES(10, 5),
    TRIANGLES(24, 12),
    TRIANGLES(48, 24),
    TRIANGLES(96, 48),
    TRIANGLES(144, 72),
    TRIANGLES(192, 96),
    TRIANGLES(224, 112),
    PIXELS(32, 32),
    PIXELS(64, 48),
    PIXELS(128, 96),
    PIXELS(160, 120),
    PIXELS(240, 180),
    PIXELS(320, 240),
    PIXELS(480, 360),
    PIXELS(640, 480),
    LIGHTS(1),
    LIGHTS(2),
    LIGHTS(3),
    LIGHTS(4),
    LIGHTS(6),
    LIGHTS(8),
    OBJECTS(1),
    OBJECTS(5),
    OBJECTS(10),
    OBJECTS(15),
    OBJECTS(20),
    OBJECTS(25),
    OBJECTS(30),
    LAYERS("nearest_first", 1, NEAREST_FIRST),
    LAYERS("farthest_first", 1, FARTHEST_FIRST),
    LAYERS("nearest_first_general", 2, NEAREST_FIRST),
    LAYERS("farthest_first_general", 2, FARTHEST_FIRST),
};

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

/* One torus as the benchmark has it, many small ones in rows of six, or ever larger ones as far behind. */
static void place_objects(glint_object *objects, const glint_mesh *mesh, uint32_t count, arrangement where) {
    const glint_pose turn = bench_scenes[0].poses[5];

    for (uint32_t i = 0; i < count; i++) {
        glint_pose *pose = &objects[i].pose;
        objects[i] =
            (glint_object){.mesh = mesh, .material = &bench_material, .evaluation = &glint_per_fragment, .pose = turn};
        if (where == SIDE_BY_SIDE) {
            pose->m[0][3] = ((int32_t)(i % 6) * 2 - 5) * GLINT_Q16(1.3);
            pose->m[1][3] = ((int32_t)(i / 6) * 2 - 4) * GLINT_Q16(1.3);
            pose->m[2][3] = -12 * GLINT_ONE;
        } else if (where != ALONE) {
            const uint32_t behind = where == NEAREST_FIRST ? i : count - 1 - i;
            for (int row = 0; row < 3; row++) {
                for (int column = 0; column < 4; column++) {
                    pose->m[row][column] += pose->m[row][column] * (int32_t)behind;
                }
            }
        }
    }
}

/* Lights around the view's axis, each a share of the brightness. */
static void place_lights(glint_light *lights, uint32_t count) {
    const glint_q16 share = GLINT_ONE / (int32_t)count;

    for (uint32_t i = 0; i < count; i++) {
        const glint_q16 angle = (int32_t)i * (360 / (int32_t)count) * GLINT_ONE;
        lights[i] = bench_light;
        lights[i].diffuse = lights[i].specular = (glint_colour){share, share, share};
        if (i > 0) {
            lights[i].direction = (glint_vector){-glint_cos(angle), -glint_sin(angle), -GLINT_ONE};
        }
    }
}

static glint_status draw(const workload *w, const glint_mesh *mesh, uint32_t *instructions) {
    static glint_object objects[OBJECTS_MAX];
    glint_light lights[GLINT_LIGHTS_MAX];
    glint_scene scene = {.viewer = GLINT_VIEWER_LOCAL,
                         .ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                         .lights = lights,
                         .light_count = w->lights,
                         .objects = objects,
                         .object_count = w->objects};
    glint_config config = {.width = w->width,
                           .height = w->height,
                           .format = &glint_format_rgb565,
                           .arena = arena,
                           .arena_size = sizeof arena};
    glint_renderer renderer;

    scene.camera.pose = glint_pose_identity();
    scene.camera.field_of_view = BENCH_FIELD_OF_VIEW;
    scene.camera.near_plane = BENCH_NEAR_PLANE;
    config.flush.begin = copy_tile;
    place_objects(objects, mesh, w->objects, w->arrangement);
    place_lights(lights, w->lights);
    const uint32_t start = counter_now();
    glint_status status = glint_init(&renderer, &config);
    if (status == GLINT_OK) {
        status = glint_render(&renderer, &scene);
    }
    *instructions = counter_ticks_since(start) * COUNTER_INSTRUCTIONS_PER_TICK;
    return status == GLINT_OK && renderer.stats.passes != 1 ? GLINT_ERROR_ARENA : status;
}

int main(void) {
    counter_start();
    for (uint32_t i = 0; i < sizeof workloads / sizeof workloads[0]; i++) {
        const workload *w = &workloads[i];
        glint_mesh mesh;
        uint32_t instructions = 0;
        glint_status status = glint_generate_torus(&mesh, &room, w->around, w->along, GLINT_ONE, GLINT_Q16(0.4));
        if (status == GLINT_OK) {
            status = draw(w, &mesh, &instructions);
        }
        if (status != GLINT_OK) {
            board_write(glint_strerror(status));
            board_write("\n");
            return 1;
        }
        board_write(w->sweep);
        board_write(",");
        write_number(w->count, ",");
        write_number(instructions, "\n");
    }
    return 0;
}
