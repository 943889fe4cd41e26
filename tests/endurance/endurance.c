/* SPDX-License-Identifier: MIT */
#include "endurance.h"

#include "byte_order.h"
#include "scenes/scenes.h"
#include "text.h"

/** Most variants of a scene. */
#define VARIANTS_MAX 64

/** Frames of a revolution of a scene that does not move by itself. */
#define TURNS 24

static uint32_t arena[(64 << 10) / sizeof(uint32_t)];

static example_stage stage;

/* FNV-1a (Fowler, Noll and Vo) over all that is sent, the same whichever byte of a pixel the core stores first. */
static struct {
    uint32_t sum;
    size_t flip;
} sent;

static int add_pixels(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const size_t row_bytes = (size_t)width * 2;
    (void)context;
    sent.sum = (sent.sum ^ (uint32_t)(x << 16 | y)) * 16777619u;
    for (int row = 0; row < height; row++) {
        const uint8_t *const bytes = (const uint8_t *)pixels + (size_t)row * stride;
        for (size_t i = 0; i < row_bytes; i++)
            sent.sum = (sent.sum ^ bytes[i ^ sent.flip]) * 16777619u;
    }
    return 0;
}

/* Every object turns about its own y axis. */
static void turn_objects(glint_q16 degrees) {
    const glint_pose turn = glint_pose_rotate_y(degrees);
    for (uint32_t i = 0; i < stage.scene.object_count; i++)
        stage.objects[i].pose = glint_pose_then(&turn, &stage.objects[i].pose);
}

/* @return the revolution's number of frames, or 0 where one failed */
static uint32_t draw_revolution(glint_renderer *renderer, const example_scene *scene, uint32_t variant) {
    const uint32_t frames = scene->frames > 1 ? scene->frames : TURNS;
    sent.sum = 2166136261u;
    for (uint32_t frame = 0; frame < frames; frame++) {
        scene->build(&stage, variant, scene->frames > 1 ? frame : 0);
        if (scene->frames == 1)
            turn_objects((glint_q16)frame * (360 / TURNS) * GLINT_ONE);
        example_fit(&stage, scene, ENDURANCE_WIDTH, ENDURANCE_HEIGHT);
        if (glint_render(renderer, &stage.scene) != GLINT_OK)
            return 0;
    }
    return frames;
}

static void write_pair(void (*write)(const char *text), const char *name, uint32_t number) {
    char text[64];
    write(text_join(text, sizeof text, name, number));
}

static void write_revolution(void (*write)(const char *text), const example_scene *scene, uint32_t variant,
                             const char *what) {
    write(scene->name);
    write(" ");
    write(scene->variants[variant].name);
    write(what);
    write_pair(write, "", sent.sum);
    write("\n");
}

static uint32_t firsts[EXAMPLE_SCENES][VARIANTS_MAX];

/* Draws a revolution of each scene. @return how many frames; 0 where one failed */
static uint32_t draw_round(glint_renderer *renderer, uint32_t round, uint32_t *differing,
                           void (*write)(const char *text)) {
    uint32_t drawn = 0;
    for (uint32_t i = 0; i < EXAMPLE_SCENES; i++) {
        const example_scene *const scene = example_scenes[i];
        const uint32_t variants = scene->variant_count < VARIANTS_MAX ? scene->variant_count : VARIANTS_MAX;
        const uint32_t variant = round % variants, frames = draw_revolution(renderer, scene, variant);
        if (!frames) {
            write_revolution(write, scene, variant, ": failed after");
            return 0;
        }
        if (round < variants) {
            firsts[i][variant] = sent.sum;
            write_revolution(write, scene, variant, ":");
        } else if (sent.sum != firsts[i][variant]) {
            ++*differing;
            write_revolution(write, scene, variant, ": DIFFERS:");
        }
        drawn += frames;
    }
    return drawn;
}

uint32_t endurance_run(uint32_t frames, void (*write)(const char *text)) {
    const glint_config config = {.width = ENDURANCE_WIDTH,
                                 .height = ENDURANCE_HEIGHT,
                                 .format = &glint_format_rgb565,
                                 .flush = {.begin = add_pixels},
                                 .arena = arena,
                                 .arena_size = sizeof arena,
                                 .keeps_arena = 1,
                                 .layers = &glint_layers};
    static glint_renderer renderer;
    uint32_t drawn = 0, rounds = 0, differing = 0;
    if (glint_init(&renderer, &config) != GLINT_OK)
        return 1;
    sent.flip = byte_order_flip_of(config.format);
    while (drawn < frames) {
        const uint32_t more = draw_round(&renderer, rounds++, &differing, write);
        if (!more)
            return differing + 1;
        drawn += more;
        if (rounds % 8 == 0) { /* so that a slow board is known to be alive */
            write_pair(write, "frames", drawn);
            write("\n");
        }
    }
    write_pair(write, "frames", drawn);
    write_pair(write, ", rounds", rounds);
    write_pair(write, ", differing", differing);
    write("\n");
    return differing;
}
