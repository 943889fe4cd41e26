/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of whole frames of the benchmark scenes, clear and copy to a framebuffer in
 * memory included. It writes a line for each scene and variant,
 *     torus2304,320x240 local 32x32,INSTRUCTIONS,SMALLEST,BEST
 * the last two being the bytes of arena that the ten frames need on a panel that is sent one tile while the next is
 * drawn.
 */
#include "framebuffer.h"
#include "glint_extras.h"
#include "measure.h"

#include <bench_scenes.h>

/** The largest screen. */
#define WIDTH 320
#define HEIGHT 240

#define SCENES (sizeof bench_scenes / sizeof bench_scenes[0])

typedef struct variant {
    uint16_t width, height;
    glint_viewer viewer;
    uint16_t tile_width, tile_height;
    int changes; /* only tiles that changed since the last frame are copied */
    int anew;    /* nothing is kept from frame to frame */
    int plain;   /* meshes without clusters */
    int share;   /* so many sixteenths of the arena between the least and that of one pass; 0: all that there is */
    int samples; /* 2 x 2 a pixel */
} variant;

static const variant variants[] = {
    {320, 240, GLINT_VIEWER_LOCAL, 32, 32, 0},          {320, 240, GLINT_VIEWER_INFINITE, 32, 32, 0},
    {128, 64, GLINT_VIEWER_LOCAL, 32, 32, 0},           {320, 240, GLINT_VIEWER_LOCAL, 16, 16, 0},
    {320, 240, GLINT_VIEWER_LOCAL, 32, 16, 0},          {320, 240, GLINT_VIEWER_LOCAL, 64, 32, 0},
    {320, 240, GLINT_VIEWER_LOCAL, 64, 64, 0},          {320, 240, GLINT_VIEWER_LOCAL, 32, 32, 1},
    {320, 240, GLINT_VIEWER_LOCAL, 32, 32, 0, 1},       {128, 64, GLINT_VIEWER_LOCAL, 64, 64, 0},
    {320, 240, GLINT_VIEWER_LOCAL, 32, 32, 0, 0, 1},    {128, 64, GLINT_VIEWER_LOCAL, 32, 32, 0, 0, 1},
    {320, 240, GLINT_VIEWER_LOCAL, 32, 32, .share = 8}, {320, 240, GLINT_VIEWER_LOCAL, 32, 32, .share = 4},
    {320, 240, GLINT_VIEWER_LOCAL, 32, 32, .share = 1}, {320, 240, GLINT_VIEWER_LOCAL, 32, 32, .samples = 1},
};

static uint32_t arena[(1 << 20) / sizeof(uint32_t)];
static uint16_t framebuffer[HEIGHT][WIDTH];
static glint_tile_signature signatures[80];
static glint_change_filter changes;

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context;
    framebuffer_copy(&framebuffer[y][x], sizeof framebuffer[0], pixels, stride, 2 * (size_t)width, height);
    return 0;
}

/* A share of the arena that a scene takes. */
static glint_status share_arena(glint_config *config, const glint_scene *scene, int sixteenths) {
    glint_need need;
    const glint_status status = glint_arena_need(config, scene, &need);
    if (status == GLINT_OK) {
        config->arena_size = need.least + (need.one_pass - need.least) / 16 * (size_t)sixteenths;
    }
    return status;
}

static glint_status measure(glint_config *config, const glint_scene *scene, glint_object *object,
                            const glint_pose *poses, int share, measured *result) {
    glint_status status = GLINT_OK;
    glint_renderer renderer;

    for (int frame = 0; frame < BENCH_FRAMES && status == GLINT_OK; frame++) {
        object->pose = poses[frame];
        if (share && frame == 0) {
            status = share_arena(config, scene, share);
        }
        if (status == GLINT_OK) {
            status = measure_frame(config, scene, frame == 0, &renderer, result);
        }
    }
    return status;
}

static glint_status measure_variant(uint32_t which, const variant *v, measured *result) {
    glint_mesh mesh = *bench_scenes[which].mesh;
    glint_object object = {.mesh = &mesh, .material = &bench_material, .evaluation = &glint_per_fragment};
    glint_scene scene = {.viewer = v->viewer,
                         .ambient = {BENCH_AMBIENT, BENCH_AMBIENT, BENCH_AMBIENT},
                         .lights = &bench_light,
                         .light_count = 1,
                         .objects = &object,
                         .object_count = 1};
    glint_config config = {.width = v->width,
                           .height = v->height,
                           .tile_width = v->tile_width,
                           .tile_height = v->tile_height,
                           .format = &glint_format_rgb565,
                           .keeps_arena = !v->anew,
                           .arena = arena,
                           .arena_size = sizeof arena,
                           .samples = v->samples ? &glint_samples_2x2 : 0};

    if (v->plain) {
        mesh.clusters = 0;
    }
    scene.camera.pose = glint_pose_identity();
    scene.camera.field_of_view = BENCH_FIELD_OF_VIEW;
    scene.camera.near_plane = BENCH_NEAR_PLANE;
    config.flush.begin = copy_tile;
    if (v->changes && glint_tile_signature_count(&config) <= sizeof signatures / sizeof signatures[0]) {
        glint_change_filter_init(&changes, signatures, &config);
        config.flush = glint_change_filter_flush(&changes);
    }
    return measure(&config, &scene, &object, bench_scenes[which].poses, v->share, result);
}

static void report(const char *name, const variant *v, const measured *result) {
    board_write(name);
    board_write(",");
    write_number(v->width, "x");
    write_number(v->height, v->viewer == GLINT_VIEWER_LOCAL ? " local " : " infinite ");
    write_number(v->tile_width, "x");
    write_number(v->tile_height, v->changes      ? " changes,"
                                 : v->anew       ? " anew,"
                                 : v->plain      ? " plain,"
                                 : v->share == 8 ? " half,"
                                 : v->share == 4 ? " quarter,"
                                 : v->share      ? " sixteenth,"
                                 : v->samples    ? " samples,"
                                                 : ",");
    measure_write(result, BENCH_FRAMES);
}

int main(void) {
    counter_start();
    for (uint32_t scene = 0; scene < SCENES; scene++) {
        for (uint32_t i = 0; i < sizeof variants / sizeof variants[0]; i++) {
            measured result = {0};
            const glint_status status = measure_variant(scene, &variants[i], &result);
            if (status != GLINT_OK) {
                board_write(glint_strerror(status));
                board_write("\n");
                return 1;
            }
            report(bench_scenes[scene].name, &variants[i], &result);
        }
    }
    return 0;
}
