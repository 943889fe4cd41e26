/* SPDX-License-Identifier: MIT */
/*
 * Contracts by which callees stand in a caller's proof. Each is proven of the callee's body by a driver of its name;
 * what is admitted instead says what it stands on. Those of static functions are beside their drivers.
 */
#ifndef GLINT_CONTRACTS_H
#define GLINT_CONTRACTS_H

#include "../../src/fast/fast.h"
#include "../../src/frame/cull.h"
#include "../../src/frame/frame.h"
#include "../../src/light/colour.h"
#include "../../src/light/evaluation.h"
#include "../../src/light/point.h"
#include "../../src/pixel/format.h"
#include "../../src/raster/runs.h"

/* A component of a unit vector: up to 32764 + 2.3. a . b of two, one of which may be a vertex's normal: up to 2^15
 * (32764 + 2.3). */
#define ANY_COMPONENT ((int16_t)ANY(-32767, 32767))
#define COSINE_MOST 0x3fff8000

/* A cone's cosine: GLINT_UNIT^2, and what its axis may be longer. */
#define CONE_MOST (1073479696 + 80000)

/*@ requires 0x10000000 <= c <= 0xC0000000;
    assigns \result \from c;
    ensures 18892 <= \result <= 65525; */
static inline int32_t glint_inverse_root(uint32_t c);

/*@ requires x >= 0x80000000;
    assigns \result \from x;
    ensures 0x7e000000 <= \result <= 0xffffffff; */
uint32_t glint_reciprocal(uint32_t x);

/*@ requires x <= 0x80000000;
    assigns \result \from x;
    ensures -0x80000000 <= \result <= 0;
    ensures x < 1 || \result >= -0x7c100000;
    ensures x < 0x40000 || \result >= -0x34100000;
    ensures x > 0x40000 || \result <= -0x33c00000; */
int32_t glint_log2(uint32_t x);

/* A root of 2n bits has n; by its first bit. */
#define ROOT(n) \
    ((x >= ((uint64_t)1 << 2 * (n)) || \result < (1 << (n))) && (x < ((uint64_t)1 << 2 * (n)) || \result >= (1 << (n))))

/*@ assigns \result \from x;
    ensures ROOT(1) && ROOT(2) && ROOT(3) && ROOT(4) && ROOT(5) && ROOT(6) && ROOT(7) && ROOT(8);
    ensures ROOT(9) && ROOT(10) && ROOT(11) && ROOT(12) && ROOT(13) && ROOT(14) && ROOT(15) && ROOT(16);
    ensures ROOT(17) && ROOT(18) && ROOT(19) && ROOT(20) && ROOT(21) && ROOT(22) && ROOT(23) && ROOT(24);
    ensures ROOT(25) && ROOT(26) && ROOT(27) && ROOT(28) && ROOT(29) && ROOT(30) && ROOT(31); */
uint32_t glint_square_root(uint64_t x);

/*@ requires y <= 0;
    assigns \result \from y;
    ensures \result <= 0x40000000; */
uint32_t glint_exp2(int32_t y);

/*@ requires x <= 0x80000000;
    requires p >= 0;
    assigns \result \from x, p;
    ensures \result <= 0x40000000; */
uint32_t glint_power(uint32_t x, int32_t p);

/* Stands on `numbers`, which takes every phase at which the sine is no further from 1 than its error. */
/*@ assigns \result \from phase;
    admit ensures -0x40000000 <= \result <= 0x40000000; */
int32_t glint_sine(uint32_t phase);

/*@ assigns \result \from degrees; */
uint32_t glint_phase(int32_t degrees);

/*@ assigns \result \from degrees;
    ensures -65536 <= \result <= 65536; */
glint_q16 glint_sin(glint_q16 degrees);

/*@ assigns \result \from degrees;
    ensures -65536 <= \result <= 65536; */
glint_q16 glint_cos(glint_q16 degrees);

/* Stands on |x| <= |(x, y, z)|, so that rounding leaves at most 32764 + 2.3, and on rounding, which
 * turns no sign: `numbers` tries 3 million vectors. */
/*@ requires \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from x, y, z;
    ensures \initialized(out + (0 .. 2));
    admit ensures -32767 <= out[0] <= 32767 && -32767 <= out[1] <= 32767 && -32767 <= out[2] <= 32767;
    admit ensures z < 0 || out[2] >= 0; */
void glint_unit(int32_t x, int32_t y, int32_t z, int16_t out[3]);

/* Stands on the same: glint_unit is this. */
/*@ requires \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from x, y, z;
    ensures \initialized(out + (0 .. 2));
    admit ensures -32767 <= out[0] <= 32767 && -32767 <= out[1] <= 32767 && -32767 <= out[2] <= 32767; */
static inline void glint_unit_inline(int32_t x, int32_t y, int32_t z, int16_t out[3]);

/* Stands on |a . b| <= |a| |b| (Cauchy, 1821) of unit vectors, at most 32764 + 2.3 long, or 2^15 as a vertex's normal.
 */
/*@ requires \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2));
    assigns \result \from indirect: a[0 .. 2], indirect: b[0 .. 2];
    admit ensures -0x3fff8000 <= \result <= 0x3fff8000; */
static inline int32_t glint_dot(const int16_t a[3], const int16_t b[3]);

/* Stands on directions that are at most 2.4 longer or shorter than GLINT_UNIT: suites `numbers` and `point`. */
/*@ requires \valid_read(unit + (0 .. 2));
    assigns \result \from indirect: unit[0 .. 2];
    admit ensures -160000 <= \result <= 160000; */
static inline int32_t glint_square_excess(const int16_t unit[3]);

/*@ requires \valid_read(light) && \valid_read(direction + (0 .. 2));
    assigns \result \from indirect: *light, indirect: direction[0 .. 2];
    ensures -0x40010000 <= \result <= 0x40010000; */
static inline int32_t glint_cone_cosine(const glint_prepared_light *light, const int16_t direction[3]);

/* Stands on an error of at most 3.1e-6, 3.3 steps: `make domains` takes every w. */
/*@ requires 0x10000000 <= w <= 0x30000000;
    assigns \result \from w;
    admit ensures 0x1000000000000 / w - 4 <= \result <= 0x1000000000000 / w + 4; */
static inline uint32_t glint_inverse(uint32_t w);

/* Stands on the magnitudes of a row and its translation, which sum up to less than 3 2^28: `numbers` tries a million
 * transforms. */
/*@ requires \valid_read(row);
    requires -0x8000 <= x <= 0x7fff && -0x8000 <= y <= 0x7fff && -0x8000 <= z <= 0x7fff;
    requires -0x40000000 < t < 0x40000000;
    assigns \result \from *row, x, y, z, t;
    admit ensures -0x30000000 <= \result <= 0x30000000; */
static inline int32_t glint_row_times_whole(const glint_row_whole *row, int32_t x, int32_t y, int32_t z, int32_t t);

/* Stands on a value between two nodes, both of which are at most 2^15: `make domains` takes every sine. */
/*@ requires \valid_read(table) && \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2));
    requires cosine > 0;
    assigns \result \from indirect: *table, indirect: a[0 .. 2], indirect: b[0 .. 2], indirect: cosine;
    admit ensures \result <= 0x8000; */
uint32_t glint_specular_power(const glint_power_table *table, const int16_t a[3], const int16_t b[3], int32_t cosine);

/*@ requires \valid_read(in + (0 .. 2)) && \valid(out + (0 .. 2));
    assigns \result, out[0 .. 2] \from in[0 .. 2];
    ensures 0 <= \result <= 34;
    ensures \initialized(out + (0 .. 2));
    ensures \subset(out[0 .. 2], (-0x40000000 .. 0x3fffffff)); */
unsigned glint_reduce(const int64_t in[3], int32_t out[3]);

/*@ requires \valid_read(view) && \valid(out + (0 .. 2));
    assigns \result, out[0 .. 2] \from *view, world;
    ensures \result == 0 || \result == 1;
    ensures \initialized(out + (0 .. 2));
    ensures \subset(out[0 .. 2], (-32767 .. 32767)); */
int glint_direction_to_camera(const glint_view *view, glint_vector world, int16_t out[3]);

#define LIT(i) (fragments->count <= (i) || \initialized(&fragments->colour[i][0..2]))

/*@ requires 1 <= fragments->count <= GLINT_FRAGMENTS_MAX;
    requires \initialized(&fragments->normal[0 .. fragments->count - 1][0 .. 2]);
    requires \subset(fragments->normal[0 .. fragments->count - 1][0 .. 2], (-32767 .. 32767));
    requires has_surface == 0 || \initialized(&fragments->surface[0 .. fragments->count - 1][0 .. 2]);
    requires has_surface == 0 || \subset(fragments->surface[0 .. fragments->count - 1][0 .. 2], (0 .. 32767));
    assigns fragments->colour[0 .. 8][0 .. 2] \from indirect: *frame, indirect: *fragments, indirect: *shading;
    ensures LIT(0) && LIT(1) && LIT(2) && LIT(3) && LIT(4) && LIT(5) && LIT(6) && LIT(7) && LIT(8); */
void glint_light_all(const glint_frame *frame, glint_fragments *fragments, const glint_shading *shading,
                     int has_surface);

/* Stands on the shift, by as many bits as the largest has above 30: glint_reduce, which shifts so, is proven. */
/*@ requires 1 <= count <= 3;
    requires \initialized(sum + (0 .. 2));
    requires \subset(sum[0 .. 2], (-count * 0x30000000 .. count * 0x30000000));
    assigns ray[0 .. 2], *inverse_w \from indirect: *transform, indirect: *view, indirect: sum[0 .. 2], indirect: count;
    ensures \initialized(ray + (0 .. 2)) && \initialized(inverse_w);
    admit ensures \subset(ray[0 .. 2], (-0x40000000 .. 0x40000000)) && *inverse_w >= 0; */
void glint_ray(const glint_transform *transform, const glint_view *view, const int64_t sum[3], int32_t count,
               int32_t ray[3], int32_t *inverse_w);

/*@ assigns \result \from indirect: *view, indirect: *shading;
    ensures \result == 0 || \result == 1; */
int glint_needs_rays(const glint_view *view, const glint_shading *shading);

/*@ requires \initialized(&colour[0 .. 2]) && \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from indirect: colour[0 .. 2];
    ensures \initialized(out + (0 .. 2));
    ensures \subset(out[0 .. 2], (0 .. 32767)); */
void glint_clamp_colour(const uint32_t colour[3], int16_t out[3]);

/* Fragments up to number i have places in a part's tile. */
#define PLACED(fragments, i)                                                          \
    (\valid_read((fragments)->part) && \initialized(&(fragments)->part->x) &&                            \
     \initialized(&(fragments)->part->y) && -4096 <= (fragments)->part->x <= 4096 && \
        -4096 <= (fragments)->part->y <= 4096 && \initialized(&(fragments)->column[0..(i)]) &&            \
     \initialized(&(fragments)->row[0..(i)]))

/*@ requires i < fragments->count <= GLINT_FRAGMENTS_MAX;
    requires PLACED(fragments, i);
    requires \initialized(&fragments->inverse_w[i]);
    requires fragments->inverse_w[i] >= 0;
    requires fragments->scale <= 30;
    requires \valid_read(planes + (0 .. 2)) && \valid(out + (0 .. 2));
    assigns out[0 .. 2] \from indirect: *fragments, i, indirect: planes[0 .. 2];
    ensures \initialized(out + (0 .. 2));
    ensures \subset(out[0 .. 2], (0 .. 32767)); */
void glint_resolve_colour(const glint_fragments *fragments, uint32_t i, const glint_plane planes[3], int16_t out[3]);

/* A channel before it is clamped, in levels or not; a plane's value at a pixel may lie beyond its corners'. */
#define CHANNEL_LEAST (-(1 << 27))
#define CHANNEL_MOST (15 << 27)
#define ANY_CHANNEL ANY(CHANNEL_LEAST, CHANNEL_MOST)

/*@ requires \initialized(&colour[0 .. 2]) && \valid(channel + (0 .. 2));
    assigns channel[0 .. 2] \from colour[0 .. 2];
    ensures \initialized(channel + (0 .. 2));
    ensures \subset(channel[0 .. 2], (0 .. 0x78000000)); */
static inline void glint_channels_of(const uint32_t colour[3], int32_t channel[3]);

/*@ requires 1 <= count <= 64;
    requires \valid_read(config);
    requires \initialized(&colour[0 .. count - 1][0 .. 2]);
    requires config->gamma != \null || \subset(colour[0 .. count - 1][0 .. 2], (-0x8000000 .. 0x78000000));
    assigns colour[0 .. count - 1][0 .. 2] \from *config, colour[0 .. count - 1][0 .. 2];
    ensures \initialized(&colour[0 .. count - 1][0 .. 2]);
    ensures \subset(colour[0 .. count - 1][0 .. 2], (-0x8000000 .. 0x78000000)); */
void glint_finish_colours(const glint_config *config, int32_t (*colour)[3], uint32_t count);

/*@ requires 1 <= fragments->count <= GLINT_FRAGMENTS_MAX;
    requires \initialized(&fragments->inverse_w[0 .. fragments->count - 1]);
    requires \subset(fragments->inverse_w[0 .. fragments->count - 1], (0 .. 0x7fffffff));
    requires PLACED(fragments, fragments->count - 1);
    requires \initialized(&fragments->scale) && fragments->scale <= 30;
    requires \valid_read(fragments->attributes);
    assigns fragments->colour[0 .. 8][0 .. 2] \from indirect: *frame, indirect: *fragments, indirect: *draw;
    ensures LIT(0) && LIT(1) && LIT(2) && LIT(3) && LIT(4) && LIT(5) && LIT(6) && LIT(7) && LIT(8); */
void glint_shade(const glint_frame *frame, glint_fragments *fragments, const glint_draw *draw);

/* Stands on spans inside their tile, as PROOF(glint_is_visible) takes them. The image tests under ASan. */
/*@ requires \valid_read(part);
    assigns \result \from indirect: *frame, indirect: *workspace, indirect: *part;
    ensures \result == 0 || \result == 1; */
static inline int glint_is_visible(const glint_frame *frame, const glint_workspace *workspace, const glint_part *part);

/*@ requires \valid(transform) && \valid_read(view) && \valid_read(config) && \valid_read(object);
    assigns \result, *transform \from indirect: *view, indirect: *config, indirect: *object;
    ensures \result == GLINT_OK || \result == GLINT_ERROR_POSE || \result == GLINT_ERROR_RANGE;
    ensures \result != GLINT_OK || (\initialized(&transform->visible) && \initialized(&transform->skipped)); */
glint_status glint_transform_prepare(glint_transform *transform, const glint_view *view, const glint_config *config,
                                     const glint_object *object);

/*@ requires \valid_read(transform) && \valid_read(view);
    assigns \result \from *transform, *view;
    ensures 0x1000 <= \result <= 0x200000000000000; */
int64_t glint_transform_nearest(const glint_transform *transform, const glint_view *view);

#endif
