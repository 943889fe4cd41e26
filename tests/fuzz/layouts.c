/* SPDX-License-Identifier: MIT */
/* Layouts in place of arrays that a scene's meshes have: of every type, with strides, and now and then wrong. */
#include "drawing.h"

#include <string.h>

/* How one thing is stored: bytes of it, and whether it has to lie on even addresses. */
typedef struct storing {
    const glint_attribute_type *type;
    uint32_t size;
    int is_even;
    void (*store)(uint8_t *to, const void *from);
} storing;

static void store_three_words(uint8_t *to, const void *from) {
    memcpy(to, from, 6);
}

static void store_two_words(uint8_t *to, const void *from) {
    memcpy(to, from, 4);
}

static void store_word(uint8_t *to, const void *from) {
    memcpy(to, from, 2);
}

static void store_three_bytes(uint8_t *to, const void *from) {
    memcpy(to, from, 3);
}

/* The high bytes of three words. */
static void store_high_bytes(uint8_t *to, const void *from) {
    const int16_t *const words = from;
    for (int i = 0; i < 3; i++)
        to[i] = (uint8_t)((uint16_t)words[i] >> 8);
}

static void store_two_high_bytes(uint8_t *to, const void *from) {
    const int16_t *const words = from;
    for (int i = 0; i < 2; i++)
        to[i] = (uint8_t)((uint16_t)words[i] >> 8);
}

static void store_low_bytes(uint8_t *to, const void *from) {
    const uint16_t *const words = from;
    for (int i = 0; i < 3; i++)
        to[i] = (uint8_t)words[i];
}

/* Moves an array of `count` things of `size` bytes into an attribute. @return what holds it; the array is gone */
static void *move(source *s, const storing *how, const void *array, size_t size, uint32_t count,
                  glint_mesh_attribute *to) {
    const uint32_t stride = how->size + (how->is_even ? 2 : 1) * below(s, 4), used = stride ? stride : how->size;
    const size_t bytes = (size_t)used * (count - 1) + how->size;
    uint8_t *const memory = memset(allocate(bytes), 0, bytes); /* what lies between may be read with another stride */
    for (uint32_t i = 0; i < count; i++)
        how->store(memory + (size_t)used * i, (const uint8_t *)array + size * i);
    *to = (glint_mesh_attribute){how->type, memory, stride == how->size && below(s, 2) ? 0 : stride};
    free((void *)(uintptr_t)array);
    return memory;
}

static void spoil(source *s, glint_mesh_layout *layout) {
    glint_mesh_attribute *const each[4] = {&layout->positions, &layout->normals, &layout->triangles, &layout->colours};
    glint_mesh_attribute *const one = each[below(s, 4)];
    switch (below(s, 3)) {
    case 0:
        one->type = below(s, 2) ? &glint_attribute_rgb565 : NULL;
        break;
    case 1:
        one->stride = 1;
        break;
    default:
        one->data = NULL;
        break;
    }
}

static void take_layout(source *s, glint_mesh *mesh, glint_mesh_layout *layout, void *stored[4]) {
    const storing positions[2] = {{&glint_attribute_int16, 6, 1, store_three_words},
                                  {&glint_attribute_int8, 3, 0, store_high_bytes}},
                  normals[4] = {positions[0],
                                positions[1],
                                {&glint_attribute_octahedral16, 4, 1, store_two_words},
                                {&glint_attribute_octahedral8, 2, 0, store_two_high_bytes}},
                  triangles[2] = {{&glint_attribute_uint16, 6, 1, store_three_words},
                                  {&glint_attribute_uint8, 3, 0, store_low_bytes}},
                  colours[2] = {{&glint_attribute_rgb888, 3, 0, store_three_bytes},
                                {&glint_attribute_rgb565, 2, 1, store_word}};
    const uint32_t which = below(s, 16), vertices = mesh->vertex_count;
    if (!which)
        return;
    mesh->layout = layout;
    if (which & 1) {
        stored[0] = move(s, &positions[below(s, 2)], mesh->positions, 6, vertices, &layout->positions);
        mesh->positions = NULL;
    }
    if (which & 2) {
        stored[1] = move(s, &normals[below(s, 4)], mesh->normals, 6, vertices, &layout->normals);
        mesh->normals = NULL;
    }
    if (which & 4) {
        stored[2] = move(s, &triangles[vertices <= 256 && below(s, 2)], mesh->triangles, 6, mesh->triangle_count,
                         &layout->triangles);
        mesh->triangles = NULL;
    }
    if (which & 8 && mesh->colours) {
        stored[3] = move(s, &colours[0], mesh->colours, 3, vertices, &layout->colours);
        mesh->colours = NULL;
    } else if (which & 8 && mesh->colours565) {
        stored[3] = move(s, &colours[1], mesh->colours565, 2, vertices, &layout->colours);
        mesh->colours565 = NULL;
    }
}

void take_layouts(source *s, drawing *d, int is_sound) {
    for (int i = 0; i < DRAWING_MESHES; i++) {
        take_layout(s, &d->meshes[i], &d->layouts[i], d->stored[i]);
        if (!is_sound && one_in(s, 16))
            spoil(s, &d->layouts[i]);
    }
}
