/* SPDX-License-Identifier: MIT */
/*
 * Draws the pictures of docs/compose.md, docs/black.md and docs/meshes.md: pictures DIRECTORY
 * They are what a panel of 16 bits shows.
 */
#include "basics.h"
#include "compose/compose.h"
#include "framebuffer.h"
#include "lines/lines.h"
#include "meshes/torus576.h"
#include "moving/moving.h"
#include "png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t arena[(256 << 10) / sizeof(uint32_t)];

/* Writes and frees a picture. @return 0, or 1 with a message */
static int write_file(host_bytes *file, const char *directory, const char *name) {
    host_problem problem;
    char path[1000];

    snprintf(path, sizeof path, "%s/%s.png", directory, name);
    const int failed = !bytes_write_file(file, path, &problem);
    if (failed) {
        problem_print(path, &problem);
    }
    free(file->data);
    return failed;
}

/* @return 0, or 1 with a message */
static int write_picture(const framebuffer *target, const char *directory, const char *name) {
    uint8_t *const pixels = framebuffer_expand(target);
    host_bytes file = {0};

    png_encode(&file, pixels, target->width, target->height, target->format->channels);
    free(pixels);
    return write_file(&file, directory, name);
}

static int tell(const char *name, glint_status status) {
    if (status != GLINT_OK) {
        fprintf(stderr, "%s: %s\n", name, glint_strerror(status));
    }
    return status != GLINT_OK;
}

/* ---- Beside a user interface ---- */

static int draw_compose(const char *directory) {
    framebuffer target;

    framebuffer_init(&target, &glint_format_rgb565_be, COMPOSE_WIDTH, COMPOSE_HEIGHT);
    int failed = 0;
    for (int i = 0; i < 2 && !failed; i++) { /* the clock's second picture is a region */
        failed = tell("compose", compose_draw(framebuffer_flush(&target), arena, sizeof arena, i * 8));
    }
    failed = failed || write_picture(&target, directory, "compose");
    framebuffer_free(&target);
    return failed;
}

/* ---- Lines ---- */

static int draw_lines(const char *directory) {
    framebuffer target;

    framebuffer_init(&target, &glint_format_rgb565, 320, 240);
    const glint_config config = {.width = 320,
                                 .height = 240,
                                 .format = &glint_format_rgb565,
                                 .flush = framebuffer_flush(&target),
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    const int failed = tell("lines", lines_draw(&config)) || write_picture(&target, directory, "lines");
    framebuffer_free(&target);
    return failed;
}

/* ---- Meshes that change ---- */

#define MOVING_FRAMES 24

/* Frames of one renderer, which keeps its arena, as an animation. */
static int draw_moving(const char *directory) {
    framebuffer target;
    glint_renderer renderer;
    uint8_t *frames[MOVING_FRAMES] = {0};

    framebuffer_init(&target, &glint_format_rgb565, 320, 160);
    const glint_config config = {.width = 320,
                                 .height = 160,
                                 .format = &glint_format_rgb565,
                                 .flush = framebuffer_flush(&target),
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1};
    int failed = tell("moving", glint_init(&renderer, &config));
    for (int i = 0; i < MOVING_FRAMES && !failed; i++) {
        failed = tell("moving", moving_draw(&renderer, i * 360 / MOVING_FRAMES));
        frames[i] = framebuffer_expand(&target);
    }
    if (!failed) {
        const png_movie movie = {frames, MOVING_FRAMES, 1, 12};
        host_bytes file = {0};
        png_encode_movie(&file, &movie, target.width, target.height, target.format->channels);
        failed = write_file(&file, directory, "moving");
    }
    for (int i = 0; i < MOVING_FRAMES; i++) {
        free(frames[i]);
    }
    framebuffer_free(&target);
    return failed;
}

/* ---- Why a picture is black ---- */

#define WIDTH 160
#define HEIGHT 120

/* A torus that is sound until something is spoilt. */
typedef struct patient {
    glint_mesh mesh;
    glint_material material;
    glint_light light;
    glint_object object;
    glint_scene scene;
} patient;

static int16_t inward[24 * 12][3];
static uint16_t reversed[576][3];

static void sound(patient *p) {
    (void)p;
}

static void no_light(patient *p) {
    p->scene.light_count = 0;
}

static void from_behind(patient *p) {
    p->light.direction = (glint_vector){-GLINT_ONE / 3, 0, GLINT_ONE};
}

static void turned_normals(patient *p) {
    for (uint32_t i = 0; i < p->mesh.vertex_count; i++) {
        for (int c = 0; c < 3; c++) {
            inward[i][c] = (int16_t)-p->mesh.normals[i][c];
        }
    }
    p->mesh.normals = (const int16_t(*)[3])inward;
}

static void inside_out(patient *p) {
    for (uint32_t i = 0; i < p->mesh.triangle_count; i++) {
        for (int c = 0; c < 3; c++) {
            reversed[i][c] = p->mesh.triangles[i][2 - c];
        }
    }
    p->mesh.triangles = (const uint16_t(*)[3])reversed;
}

static void cut_open(patient *p) {
    p->scene.camera.near_plane = GLINT_Q16(3.5);
}

static void tiny(patient *p) {
    p->mesh.extent.x /= 16;
    p->mesh.extent.y /= 16;
    p->mesh.extent.z /= 16;
}

static const struct spoilt {
    const char *name;
    void (*spoil)(patient *p);
    int swaps_bytes;
} spoilt[] = {
    {"sound", sound, 0},
    {"no-light", no_light, 0},
    {"from-behind", from_behind, 0},
    {"turned-normals", turned_normals, 0},
    {"inside-out", inside_out, 0},
    {"cut-open", cut_open, 0},
    {"tiny", tiny, 0},
    {"swapped-bytes", sound, 1},
};

static void build(patient *p) {
    *p = (patient){.mesh = torus576_mesh};
    p->mesh.clusters = NULL;
    p->material =
        glint_material_paint(&glint_model_blinn_phong, (glint_colour){GLINT_Q16(0.8), GLINT_Q16(0.4), GLINT_Q16(0.1)},
                             GLINT_Q16(0.15), GLINT_Q16(30));
    p->light = (glint_light){.type = &glint_light_directional,
                             .direction = {GLINT_Q16(-0.5), GLINT_Q16(-0.7), -GLINT_ONE},
                             .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                             .specular = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
    p->object = (glint_object){.mesh = &p->mesh,
                               .material = &p->material,
                               .evaluation = &glint_per_fragment,
                               .pose = glint_pose_rotate_x(GLINT_Q16(-50))};
    p->scene = (glint_scene){.camera = {glint_pose_translate(0, 0, GLINT_Q16(4)), GLINT_Q16(45), GLINT_Q16(0.1)},
                             .viewer = GLINT_VIEWER_LOCAL,
                             .background = {GLINT_Q16(0.02), GLINT_Q16(0.03), GLINT_Q16(0.08)},
                             .lights = &p->light,
                             .light_count = 1,
                             .objects = &p->object,
                             .object_count = 1};
}

static void swap_bytes(framebuffer *target) {
    for (size_t i = 0; i < target->height * target->row_bytes; i += 2) {
        const uint8_t first = target->rows[i];

        target->rows[i] = target->rows[i + 1];
        target->rows[i + 1] = first;
    }
}

static int draw_spoilt(const struct spoilt *one, const char *directory) {
    static patient p;
    framebuffer target;
    glint_renderer renderer;

    framebuffer_init(&target, &glint_format_rgb565, WIDTH, HEIGHT);
    const glint_config config = {.width = WIDTH,
                                 .height = HEIGHT,
                                 .format = &glint_format_rgb565,
                                 .flush = framebuffer_flush(&target),
                                 .arena = arena,
                                 .arena_size = sizeof arena};
    build(&p);
    one->spoil(&p);
    glint_status status = glint_init(&renderer, &config);
    if (status == GLINT_OK) {
        status = glint_render(&renderer, &p.scene);
    }
    if (one->swaps_bytes) {
        swap_bytes(&target);
    }
    const int failed = tell(one->name, status) || write_picture(&target, directory, one->name);
    framebuffer_free(&target);
    return failed;
}

int main(int argc, char **argv) {
    int failed = argc != 2;

    if (!failed) {
        failed = draw_compose(argv[1]) || draw_lines(argv[1]) || draw_moving(argv[1]);
    }
    for (size_t i = 0; i < sizeof spoilt / sizeof *spoilt && !failed; i++) {
        failed = draw_spoilt(&spoilt[i], argv[1]);
    }
    return failed;
}
