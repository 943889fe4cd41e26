/* SPDX-License-Identifier: MIT */
/* Fast lighting of vertices and triangles. */
#include "proof.h"

#include "../../src/fast/fast_begin.h"
#include "../../src/fast/fast_vertices.c"
#include "lit.h"
#include "pixels.h"
#include "plane.h"

/* Stands on ray_limit times ray_scale being below 2^31, and on V and L being unit; the image tests under UBSan. */
/*@ requires \valid(half_vector + (0 .. 2)) && \valid(view);
    assigns \result, half_vector[0 .. 2], *view \from indirect: *fast, x, y;
    ensures \result == 0 || \result == 1;
    ensures \initialized(half_vector + (0 .. 2)) && \initialized(&view->root) && \initialized(&view->half_root);
    admit ensures -32767 <= half_vector[0] <= 32767 && -32767 <= half_vector[1] <= 32767 && 0 <= half_vector[2] <=
   32767; */
static inline int glint_half_vector_inline(const glint_fast_terms *fast, int32_t x, int32_t y, int16_t half_vector[3],
                                           glint_view_vector *view);

/* Stands on |L . N| <= |L| |N| (Cauchy, 1821), 2^15 and rounding each. */
/*@ requires \valid_read(light + (0 .. 2)) && \valid_read(normal + (0 .. 2));
    assigns \result \from indirect: light[0 .. 2], indirect: normal[0 .. 2];
    admit ensures -0x40040000 <= \result <= 0x40040000; */
static inline int32_t find_cosine(const int32_t light[3], const int16_t normal[3]);

/* A vertex's normal, as suite `normals` proves it. */
/*@ requires \valid(vertex);
    assigns vertex->attribute[0 .. 2], vertex->flags \from indirect: *draw, *vertex;
    ensures \initialized(vertex->attribute + (0 .. 2)) && \initialized(&vertex->flags);
    admit ensures \forall integer i; 0 <= i <= 2 ==> -32767 <= vertex->attribute[i] <= 32767; */
void glint_transform_normal(const glint_draw *draw, glint_vertex *vertex);

/* Stands on a square being no less than 0; its size is proven by the normals' components. */
/*@ requires -32767 <= a <= 32767 && -32767 <= b <= 32767 && -32767 <= c <= 32767;
    assigns \result \from a, b, c;
    ensures \result <= 0x24006000;
    admit ensures \result >= 0; */
static inline int32_t glint_square_of_sum(int32_t a, int32_t b, int32_t c);

static const uint16_t triangles[1][3] = {{0, 1, 2}};
static glint_vertex vertices[3];
static int16_t terms[3][3];
static glint_fast_terms fast;
static glint_shading shading;
static glint_draw draw;

static void any_triangle(void) {
    for (int i = 0; i < 3; i++) {
        any_unit(vertices[i].attribute);
        vertices[i].x = (int16_t)ANY(-29000, 29000);
        vertices[i].y = (int16_t)ANY(-29000, 29000);
        vertices[i].inverse_w = ANY(0, 0x7fff0000);
        vertices[i].flags = (uint16_t)ANY(0, 0xffff);
    }
    draw.triangles = triangles;
    draw.vertices = vertices;
    draw.terms = terms;
    draw.shading = &shading;
    shading.fast = &fast;
}

/* Deviations have a scale of so many bits, and a reach that it keeps below GLINT_FAST_REACH. */
static void any_deviation(int bits) {
    const int32_t reach = (GLINT_FAST_REACH << 16) >> (bits - 1);
    any_unit(fast.half_vector);
    for (int c = 0; c < 3; c++)
        fast.long_light[c] = ANY(-32770, 32770);
    fast.half_vector[2] = (int16_t)ANY(0, 32767);
    fast.scale = ANY(1 << (bits - 1), (1 << bits) - 1);
    fast.reach = ANY(0, reach < INT16_MAX ? reach : INT16_MAX);
    fast.within = ANY_UNSIGNED(0, INT16_MAX);
    fast.scaled_half = (fast.scale >> 1) + (1 << 15);
    fast.sides[0] = ANY_UNSIGNED(0, UINT_MAX);
    fast.sides[1] = ANY_UNSIGNED(0, UINT_MAX);
    fast.specular_end = ANY_UNSIGNED(0, 1024) << 15;
    fast.lit = ANY(GLINT_LEAST_LIT, INT16_MAX);
    fast.unlit = ANY(INT16_MIN, 0);
}

/*
 * Any vertices, by the bits of what scales deviations.
 * @contract glint_half_vector_inline glint_transform_normal glint_dot find_cosine
 * @alarms 2 N.H + nz <= sqrt(2) UNIT where hz is 0, and 1 / (1 + hz) falls from there: the image tests under UBSan
 * @narrowing deviations are scaled modulo 2^32: right where they are within reach, as cut_off leaves them
 * @options -eva-slevel 0 -eva-min-loop-unroll 3
 */
PROOF(glint_fast_light) {
    any_triangle();
    FOR_PARTS(bits, 14, 30) {
        any_deviation((int)bits);
        fast.local_viewer = 0;
        glint_fast_light(0, &draw, 0, 0);
        fast.local_viewer = 1;
        glint_fast_light(0, &draw, 0, 0);
    }
}

/* N.L, Q30, of up to 1/32 more than 1, with tables and without. @contract glint_fast_word */
PROOF(glint_fast_even) {
    static uint16_t pixels[GLINT_DIFFUSE_ENTRIES];
    static uint32_t words[GLINT_DIFFUSE_ENTRIES];
    glint_fast_planes planes;
    planes.cosine.start = ANY(-GLINT_UNIT / 2 * 0x10800, GLINT_UNIT / 2 * 0x10800);
    shading.fast = &fast;
    shading.lights = ANY_UNSIGNED(0, 1);
    fast.diffuse_stored = pixels;
    fast.diffuse = ANY(0, 1) ? words : 0;
    glint_fast_even(&shading, &planes);
}

/* Any rows of any spans. @options -eva-slevel 0 */
PROOF(glint_fast_covered) {
    glint_part part;
    for (int i = 0; i < GLINT_TILE_MAX; i++) {
        part.spans[i].left = (uint8_t)ANY(0, GLINT_TILE_MAX);
        part.spans[i].right = (uint8_t)ANY(0, GLINT_TILE_MAX);
    }
    part.top = ANY_UNSIGNED(0, GLINT_TILE_MAX);
    part.bottom = ANY_UNSIGNED(0, GLINT_TILE_MAX);
    glint_fast_covered(&part);
}

/* Any three components. */
PROOF(glint_square_of_sum) {
    glint_square_of_sum(ANY_COMPONENT, ANY_COMPONENT, ANY_COMPONENT);
}

/* Any limits, any turn, any change of 1/w. */
PROOF(glint_fast_fits) {
    glint_w_range w;
    w.least = ANY_UNSIGNED(0, 0xffff);
    w.change = ANY_UNSIGNED(1, 0x10000);
    glint_fast_fits(ANY(0, 1 << 26), ANY(-(5 << 28), 1 << 30), w);
}

/* Corners up to 30,000 apart, sides of up to 64 pixels, 1/area of up to 1/32 more than 2^16. Both forms. */
PROOF(glint_term_slope_itself) {
    const int32_t d = 30000, s = 1 << 10, r = (1 << 16) + (1 << 11);
    glint_term_slope_whole(ANY(-d, d), ANY(-s, s), ANY(-d, d), ANY(-s, s), ANY(0, r));
    glint_term_slope_split(ANY(-d, d), ANY(-s, s), ANY(-d, d), ANY(-s, s), ANY(0, r));
}

/* A slope whose magnitude has so many bits, or up to so many. */
static int32_t any_slope(int bits, int exactly, int negative) {
    const int32_t magnitude = (int32_t)(exactly ? ANY_OF_BITS(bits) : ANY_UNSIGNED(0, (1u << bits) - 1));
    return negative ? -1 - magnitude : magnitude;
}

/*
 * Any slopes that fit, by their signs and by the bits of the first, the largest: an OR tells no places apart. Any
 * place.
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_square_begin) {
    FOR_PARTS(bits, 0, 27) {
        FOR_PARTS(signs, 0, 15) {
            glint_plane x, y;
            x.start = ANY_INT;
            y.start = ANY_INT;
            x.dx = any_slope(bits, 1, signs & 1);
            x.dy = any_slope(bits, 0, signs >> 1 & 1);
            y.dx = any_slope(bits, 0, signs >> 2 & 1);
            y.dy = any_slope(bits, 0, signs >> 3);
            glint_square_begin(&x, &y);
        }
    }
}

/* A triangle of any flags, limits of any material; a part of any gradients. */
static void any_part(glint_part *part, int narrow) {
    if (narrow)
        any_narrow(&part->gradients);
    else
        any_wide(&part->gradients);
    any_triangle();
    fast.turn = ANY(0, 1 << 26);
    fast.turn_specular = ANY(0, 1 << 26);
    fast.extent = ANY(0, INT32_MAX);
    fast.slant = ANY_UNSIGNED(0, 0xffff);
    fast.even = ANY(0, INT16_MAX);
}

/*
 * Any flags, any limits; N.L by parts of the first corner's, the others' up to 0.82 from it, which is how far normals
 * differ whose turn is at most 1.
 * @contract glint_plane_begin glint_square_of_sum
 * @narrowing planes are evaluated modulo 2^32: right wherever the true value fits
 */
PROOF(glint_fast_begin) {
    static glint_part part;
    static glint_fast_planes planes;
    glint_triangle triangle = {{&vertices[0], &vertices[1], &vertices[2]}, {0, 0, 0}, 0, 1, 0};
    FOR_PARTS(narrow, 0, 1) {
        any_part(&part, narrow);
        FOR_PARTS(i, -8, 7) {
            const int32_t first = i * 2048, last = first + 2047;
            terms[0][0] = (int16_t)ANY(first, last);
            for (int corner = 0; corner < 3; corner++) {
                if (corner)
                    terms[corner][0] = (int16_t)ANY(first - 13416, last + 13416);
                terms[corner][1] = (int16_t)ANY(-GLINT_FAST_REACH, GLINT_FAST_REACH);
                terms[corner][2] = (int16_t)ANY(-GLINT_FAST_REACH, GLINT_FAST_REACH);
            }
            glint_fast_begin(&draw, &triangle, &part, &planes);
        }
    }
}
