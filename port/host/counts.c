/* SPDX-License-Identifier: MIT */
#include "counts.h"

#include "fast/fast.h"
#include "framebuffer.h"
#include "light/evaluation.h"
#include "light/fragments.h"
#include "nodes/shapes.h"
#include "pixel/format.h"
#include "watch.h"

/* The library's functions, and what is called in their place. */
#define WATCHED(function) extern __typeof__(function) __real_##function, __wrap_##function
/* Those that watch.c calls. */
#define LED(function) extern __typeof__(function) __wrap_##function
LED(glint_render_tile);
WATCHED(glint_light_all);
LED(glint_gathering_store);
LED(glint_nodes_light);
LED(glint_draw_facet);
LED(glint_draw_lit);
LED(glint_terms_begin);
LED(glint_shape_begin);
LED(glint_terms_draw_part);
WATCHED(glint_polynomial_begin);
WATCHED(glint_prepare_shading);
WATCHED(glint_fast_make_tables);

/* Of the frame that is drawn. */
static frame_counts now;

static void count(int item, uint32_t number) {
    now.of[item] += number;
}

int __wrap_glint_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile) {
    count(COUNTS_cleared, (uint32_t)frame->config.tile_width * frame->config.tile_height);
    return watch_render_tile(frame, workspace, tile);
}

/* Counts lights at points: a kind each, and highlights. */
static void count_lights(const glint_view *view, uint32_t points, uint32_t lights, uint32_t lobes, int directional) {
    for (uint32_t i = 0; i < view->light_count; i++) {
        const glint_light_type *type = view->lights[i].type;
        const int kind = type->has_cone ? 2 : type->illuminate ? 1 : 0;
        count(directional + kind, lights >> i & 1 ? points : 0);
        count(directional + 3, lobes >> i & 1 ? points : 0);
    }
}

void __wrap_glint_light_all(const glint_frame *frame, glint_fragments *fragments, const glint_shading *shading,
                            int has_surface) {
    count(COUNTS_lit, fragments->count);
    count_lights(frame->view, fragments->count, shading->lights, shading->has_specular, COUNTS_lit_by_directional);
    __real_glint_light_all(frame, fragments, shading, has_surface);
}

void __wrap_glint_gathering_store(const glint_gathering *gathering) {
    count(COUNTS_stored, gathering->fragments->count);
    watch_gathering_store(gathering);
}

void __wrap_glint_draw_facet(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                             const glint_triangle *triangle, const glint_part *part) {
    count(COUNTS_facet_part, 1);
    watch_draw_facet(frame, workspace, draw, triangle, part);
}

void __wrap_glint_draw_lit(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part) {
    count(COUNTS_corner_part, 1);
    count(COUNTS_corner_row, part->bottom - part->top);
    watch_draw_lit(frame, workspace, draw, triangle, part);
}

void __wrap_glint_nodes_light(const glint_frame *frame, const glint_shading *shading, glint_fragments *at,
                              uint32_t lights, uint32_t lobes, int tells, glint_node *const nodes[]) {
    count(COUNTS_node, at->count);
    count_lights(frame->view, at->count, lights, lobes, COUNTS_node_by_directional);
    watch_nodes_light(frame, shading, at, lights, lobes, tells, nodes);
}

/* Counts what a part is drawn by, unless the format's own loop does that. */
static void count_terms(const glint_terms *terms, const glint_part *part) {
    const uint32_t pixels = glint_covered_by(part);
    uint32_t sides = 0, lobes = 0;
    if (terms->is_fused) {
        return;
    }
    for (uint32_t i = 0; i < terms->apart_count; i++) {
        sides += terms->apart[i].kinds >> GLINT_SIDE & 1;
        lobes += terms->apart[i].kinds >> GLINT_LOBE_X & 1;
    }
    count(COUNTS_term_row, part->bottom - part->top);
    count(COUNTS_term_pixel, pixels);
    count(COUNTS_length_pixel, terms->is_over_length ? pixels : 0);
    count(COUNTS_side_pixel, pixels * sides);
    count(COUNTS_lobe_pixel, pixels * lobes);
    count(COUNTS_wide_lobe_pixel, terms->light->lobe_is_wide ? pixels * lobes : 0);
    count(COUNTS_surface_pixel, terms->has_surface ? pixels : 0);
}

int __wrap_glint_terms_begin(const glint_frame *frame, const glint_draw *draw, const glint_triangle *triangle,
                             const glint_part *part, glint_terms *terms, glint_polynomials *polynomials,
                             glint_reach *reach) {
    const int fits = watch_terms_begin(frame, draw, triangle, part, terms, polynomials, reach);
    count(COUNTS_region, 1);
    if (fits) {
        count(COUNTS_curved_region, terms->is_curved);
        count(COUNTS_polynomial, terms->end);
    }
    return fits;
}

int __wrap_glint_shape_begin(const glint_frame *frame, const glint_draw *draw, const glint_shape *shape,
                             glint_node *const nodes[], glint_terms *terms, glint_polynomials *polynomials) {
    const int fits = watch_shape_begin(frame, draw, shape, nodes, terms, polynomials);
    count(COUNTS_shape, 1);
    count(COUNTS_polynomial, fits ? terms->end : 0);
    return fits;
}

void __wrap_glint_terms_draw_part(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                  const glint_triangle *triangle, const glint_part *part, const glint_terms *terms,
                                  const glint_polynomials *polynomials) {
    count_terms(terms, part);
    watch_terms_draw_part(frame, workspace, draw, triangle, part, terms, polynomials);
}

glint_status __wrap_glint_prepare_shading(const glint_frame *frame, glint_shading *shading,
                                          const glint_material *material) {
    const glint_status status = __real_glint_prepare_shading(frame, shading, material);
    count(COUNTS_material, status == GLINT_OK && shading->changed);
    return status;
}

void __wrap_glint_fast_make_tables(glint_frame *frame, glint_fast_terms *fast, const glint_shading *shading) {
    count(COUNTS_fast_material, shading->changed != 0);
    __real_glint_fast_make_tables(frame, fast, shading);
}

void __wrap_glint_polynomial_begin(glint_quadratic *q, const glint_barycentric *barycentric, const int32_t a[3],
                                   const int32_t bulge[3]) {
    count(COUNTS_quadratic, 1);
    __real_glint_polynomial_begin(q, barycentric, a, bulge);
}

/* Pixels of fast lighting where it stores words. */
static double spread_pixels(const glint_format *format) {
    return !format->fast || !format->fast->stores_spread
               ? 0
               : now.of[COUNTS_ambient_pixel] + now.of[COUNTS_diffuse_pixel] + now.of[COUNTS_gated_pixel] +
                     now.of[COUNTS_specular_pixel] + now.of[COUNTS_curved_diffuse_pixel] +
                     now.of[COUNTS_curved_specular_pixel];
}

/* Counts pixels that are stored in a way of their own. */
static void count_format(const glint_config *config) {
    const glint_format *format = config->format;
    const framebuffer_format *known = framebuffer_find_format(NULL, format);
    const int is_dithered = known && known->dithered == format;
    const double even = now.of[COUNTS_even_pixel], spread = spread_pixels(format),
                 lit = now.of[COUNTS_general_pixel] + now.of[COUNTS_channels_pixel] + spread;
    now.of[COUNTS_spread_pixel] += spread;
    now.of[COUNTS_gamma_pixel] += config->gamma ? lit : 0;
    now.of[COUNTS_dithered_pixel] += is_dithered ? lit : 0;
    now.of[COUNTS_dithered_even_pixel] += is_dithered ? even : 0;
    now.of[COUNTS_grey_pixel] += !format->channel[1] ? lit + (is_dithered ? even : 0) : 0;
    now.of[COUNTS_packed_pixel] += format->bits % 8 ? lit + even : 0;
}

/* Adds what the frame's statistics tell. */
static void count_stats(const glint_scene *scene, const glint_config *config, const glint_stats *stats) {
    /* the item of each kernel's parts; that of their pixels follows */
    static const int parts[GLINT_KERNEL_CHANNELS] = {
        COUNTS_general_part,  COUNTS_ambient_part,        COUNTS_diffuse_part,         COUNTS_gated_part,
        COUNTS_specular_part, COUNTS_curved_diffuse_part, COUNTS_curved_specular_part, COUNTS_even_part};
    count(COUNTS_frame, 1);
    count(COUNTS_object, scene->object_count - stats->hidden);
    count(COUNTS_vertex, stats->vertices);
    count(COUNTS_triangle, stats->triangles);
    count(COUNTS_shown, stats->triangles - stats->facing_away - stats->outside);
    count(COUNTS_reference, stats->references);
    count(COUNTS_tile, stats->tiles);
    count(COUNTS_byte, (uint32_t)glint_row_bytes(config->format, config->width) * config->height);
    for (int kernel = 0; kernel < GLINT_KERNEL_CHANNELS; kernel++) {
        count(parts[kernel], stats->drawn[kernel].parts);
        count(parts[kernel] + 1, stats->drawn[kernel].covered);
    }
    count(COUNTS_channels_pixel, stats->drawn[GLINT_KERNEL_CHANNELS].covered);
    if (scene->viewer == GLINT_VIEWER_LOCAL) {
        count(COUNTS_curved_local_part, stats->drawn[GLINT_KERNEL_CURVED_SPECULAR].parts);
    }
}

glint_status counts_render(glint_renderer *renderer, const glint_scene *scene, frame_counts *counts) {
    now = (frame_counts){.stats = {0}};
    const glint_status status = glint_render(renderer, scene);
    now.stats = renderer->stats;
    if (status == GLINT_OK) {
        count_stats(scene, &renderer->config, &renderer->stats);
        count_format(&renderer->config);
    }
    *counts = now;
    return status;
}
