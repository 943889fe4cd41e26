/* SPDX-License-Identifier: MIT */
/* A frame: clear, and then object by object. */
#include "draw.h"
#include "number.h"

/* Fills memory, 64 bytes at a time. */
static void fill(void *to, uint32_t word, uint32_t bytes) {
    uint32_t *out = to;
    uint32_t *const blocks_end = out + bytes / 64 * 16, *const end = out + bytes / 4;

#if defined __ARM_FP && __ARM_FP & 4
    float value;
    __builtin_memcpy(&value, &word, sizeof value);
    register float s0 __asm__("s0") = value, s1 __asm__("s1") = value, s2 __asm__("s2") = value,
                      s3 __asm__("s3") = value, s4 __asm__("s4") = value, s5 __asm__("s5") = value,
                      s6 __asm__("s6") = value, s7 __asm__("s7") = value, s8 __asm__("s8") = value,
                      s9 __asm__("s9") = value, s10 __asm__("s10") = value, s11 __asm__("s11") = value,
                      s12 __asm__("s12") = value, s13 __asm__("s13") = value, s14 __asm__("s14") = value,
                      s15 __asm__("s15") = value;
    while (out != blocks_end) {
        __asm__ volatile("vstmia %0!, {s0-s15}"
                         : "+r"(out)
                         : "t"(s0), "t"(s1), "t"(s2), "t"(s3), "t"(s4), "t"(s5), "t"(s6), "t"(s7), "t"(s8), "t"(s9),
                           "t"(s10), "t"(s11), "t"(s12), "t"(s13), "t"(s14), "t"(s15)
                         : "memory");
    }
#else
    while (out != blocks_end) {
        *out++ = word;
    }
#endif
    while (out != end) {
        *out++ = word;
    }
}

static void clear(const float_screen *screen, const glint_colour *background) {
    const uint32_t count = screen->width * screen->height;
    const uint32_t pixel = float_pixel(triple(float_of(background->r) * FLOAT_RED + FLOAT_HALF_RED,
                                              float_of(background->g) * FLOAT_GREEN + FLOAT_HALF_GREEN,
                                              float_of(background->b) * FLOAT_BLUE + FLOAT_HALF_BLUE));

    fill(screen->colour, pixel << 16 | pixel, 2 * count);
    if (count % 2) {
        screen->colour[count - 1] = (uint16_t)pixel;
    }
    fill(screen->depth, 0, 4 * count);
}

static float_kernel *choose(const float_draw *draw) {
    const float_surface *surface = &draw->surface;
    const uint32_t positional = surface->points + surface->spots, count = surface->directional + positional;

    if (draw->facets || (surface->model == FLOAT_UNLIT && !(surface->options & FLOAT_COLOURS))) {
        return float_draw_flat;
    }
    if (surface->model == FLOAT_UNLIT || draw->object->evaluation == &glint_per_vertex) {
        return float_draw_interpolated;
    }
    return count == 1 && surface->directional ? float_choose_directional(draw)
           : count == 1 && surface->points    ? float_choose_point(draw)
           : count == 1                       ? float_choose_spot(draw)
                                              : float_choose_many(draw);
}

static void draw_side(float_draw *draw, float_whereabouts where) {
    float_cull(draw, where);
    if (draw->count) {
        float_light_all(draw);
        choose(draw)(draw);
    }
}

static void draw_object(float_frame *frame, const glint_object *object) {
    float_draw draw = {.frame = frame, .object = object, .side = 1};

    if (object->mesh->vertex_count > FLOAT_VERTICES_MAX || object->mesh->triangle_count > FLOAT_TRIANGLES_MAX) {
        return;
    }
    float_prepare_object(&draw);
    const float_whereabouts where = float_locate(&draw);
    if (where == FLOAT_OUTSIDE) {
        return;
    }
    float_prepare_surface(frame, &draw);
    float_transform(&draw, where);
    draw_side(&draw, where);
    if (object->mesh->flags & GLINT_MESH_DOUBLE_SIDED) {
        draw.side = -1;
        draw.front = -draw.front;
        draw_side(&draw, where);
    }
}

void float_render(const float_screen *screen, float_memory *memory, const glint_scene *scene) {
    float_frame frame = {.screen = screen, .memory = memory, .scene = scene};

    float_prepare_frame(&frame);
    clear(screen, &scene->background);
    for (uint32_t i = 0; i < scene->object_count; i++) {
        draw_object(&frame, &scene->objects[i]);
    }
}
