/* SPDX-License-Identifier: MIT */
/* Suns: prepares materials under directional lights, and chooses what draws each triangle. suns.h */
#include "suns.h"

#include "../geometry/draw.h"
#include "../geometry/geometry.h"
#include "../pixel/format.h"
#include "../raster/small.h"
#include "evaluation.h"
#include "lamps.h"
#include "wear.h"

/* ---- Triangles ---- */

/* Quadratics do not serve triangles with slopes, Q14, from this on: these are up to two pixels wide. They do not pay
 * for triangles of up to four pixels: twice their area, in sixteenths squared, has these leading zeros. */
#define MOST_SLOPE (1 << 13)
#define SMALL_ZEROS 21

/* Returns whether all vertices of a triangle have normals and terms. */
static inline int is_lit(const glint_row_walk *walk) {
    const glint_vertex *const *v = walk->triangle.corners;
    return v[0]->flags & v[1]->flags & v[2]->flags & GLINT_VERTEX_LIT;
}

/* Returns whether a triangle is so small or narrow that its pixels are lit one by one. */
static inline int is_small(const glint_row_walk *walk) {
    const glint_slopes *s = &walk->slopes;
    return walk->corners.area.zeros >= SMALL_ZEROS ||
           (glint_magnitude_bits(s->x1) | glint_magnitude_bits(s->x2) | glint_magnitude_bits(s->y1) |
            glint_magnitude_bits(s->y2)) >= MOST_SLOPE;
}

/* Copies the numbers that spans of one light use at each pixel. */
static inline void begin_one_light(const glint_row_walk *walk, glint_sun_triangle *t) {
    const glint_lit_sun *lit = t->lit;
    t->ramp = lit->sun->ramp;
    t->gloss = lit->gloss ? lit->sun->gloss : 0;
    t->shift = t->suns->shift;
    t->dark = t->suns->dark;
    t->z_dx = (uint32_t)walk->z.dx;
    t->from_depth = (uintptr_t)walk->pixels - (uintptr_t)walk->depth;
    t->light_dx = lit->light.x;
    t->square_bend = 2 * t->normal.xx;
    if (lit->gloss) {
        t->half_bend = 2 * lit->half.xx;
        if (t->suns->is_mirror)
            t->light_view_bend = 2 * lit->light_view.xx;
    }
}

/* Sets a corner and its terms. */
static inline void set_corner(const glint_row_walk *walk, glint_sun_triangle *t, int k, const glint_vertex *v) {
    t->corners[k] = v;
    t->terms[k] = walk->draw->terms + (size_t)(v - walk->draw->vertices) * t->suns->terms;
}

/* Sets the corners, in the order of slopes. */
static inline void set_corners(const glint_row_walk *walk, glint_sun_triangle *t) {
    set_corner(walk, t, 0, walk->from_top[0]);
    set_corner(walk, t, 1, walk->from_top[1]);
    set_corner(walk, t, 2, walk->from_top[2]);
}

/* Sets a surface's own colours. @return 0 if they are not linear on the screen */
static GLINT_NOINLINE int begin_own(const glint_row_walk *walk, glint_sun_triangle *t) {
    const uint8_t *order = glint_corner_order(walk->corners.top);
    glint_slopes s = walk->slopes;
    for (int k = 0; k < 3; k++)
        t->own_at[k] = walk->triangle.extra[order[k]];
    if (!glint_bend_slopes(walk, &s, t->own_at[0], t->own_at[1], t->own_at[2]))
        return 0;
    glint_begin_own(t, &s);
    return 1;
}

/* Returns whether one light on a texture can be drawn in one loop. */
static inline int is_plain_texture(const glint_row_walk *walk, const glint_sun_triangle *t) {
    return walk->draw->texture && !walk->draw->extra && t->lit->is_plain && !t->suns->is_mirror;
}

/* Chooses the function that draws the spans of a visible triangle. @return null if suns do not serve the triangle */
static inline glint_draw_span *choose_span(glint_row_walk *walk, glint_sun_triangle *t) {
    const glint_suns *suns = t->suns;
    const int is_own = walk->draw->extra || walk->draw->texture,
              has_own = is_own && suns->has_own && (!walk->draw->extra || begin_own(walk, t)),
              is_listed = (is_own && !has_own) || suns->is_fine, is_tiny = is_small(walk);
    if (!is_lit(walk) || (is_tiny && (is_listed || (suns->terms && !suns->bend))))
        return 0;
    set_corners(walk, t);
    if (is_tiny) {
        glint_begin_small_suns(walk, t);
        return has_own ? glint_draw_small_suns : suns->small;
    }
    if (!glint_begin_sun_normals(walk, t) || !glint_begin_suns(walk, t) || (is_listed && suns->is_mirror))
        return 0;
    if (is_listed)
        return t->least < 4 * GLINT_LEAST_NORMAL + t->change / 2 ? 0 : glint_begin_fine_suns(walk);
    if (!t->count && suns->is_rounded && !has_own) {
        walk->packed = glint_spread_pack(suns->dark);
        return walk->frame->config.format->flat_span;
    }
    /* In the loop of one light, the index of a sine below 0 is no entry's where N'.N' is a quarter or more. */
    if (t->count != 1 || t->least < 2 * GLINT_LEAST_NORMAL + t->change / 2 ||
        !(has_own ? is_plain_texture(walk, t) : suns->spans != 0))
        return glint_draw_sun_list;
    begin_one_light(walk, t);
    if (has_own) {
        glint_draw_span *const sun = walk->draw->texture->type->stage->choose_sun(walk);
        return sun ? sun : glint_draw_sun_list;
    }
    return !t->lit->gloss ? suns->spans->matt : suns->is_mirror ? suns->spans->mirror : suns->spans->half;
}

/* Draws a triangle that is visible and has slopes. @return 0 if suns do not serve it */
static GLINT_HOT GLINT_NOINLINE int draw_visible(glint_row_walk *walk, glint_begun begun) {
    glint_sun_triangle *const t = walk->suns;
    t->suns = walk->draw->shading->suns;
    t->count = 0;
    glint_find_slopes(&walk->corners, &walk->slopes);
    walk->draw_span = choose_span(walk, t);
    if (!walk->draw_span)
        return 0;
    glint_leave_holes(walk);
    glint_walk_begun(walk, begun);
    if (walk->list->count)
        glint_light_listed(walk);
    return 1;
}

/* Draws a triangle in one colour if its normals are the same, no highlight is visible on it, and the format cuts words
 * off. @return 0 if it is another triangle */
static GLINT_NOINLINE int draw_one_colour(glint_row_walk *walk, glint_begun begun) {
    const glint_vertex *const *v = walk->triangle.corners;
    const glint_suns *suns = walk->draw->shading->suns;
    const int16_t *a = v[0]->attribute, *b = v[1]->attribute, *c = v[2]->attribute;
    uint32_t word;
    if (a[1] != b[1] || a[2] != b[2] || a[0] != c[0] || a[1] != c[1] || a[2] != c[2] || !is_lit(walk) ||
        !suns->is_rounded || suns->is_fine || walk->draw->extra || (walk->draw->texture && !suns->has_own) ||
        glint_is_deep(&walk->triangle) || !glint_find_one_word(walk, &word))
        return 0;
    if (walk->draw->texture) {
        walk->draw->texture->type->stage->draw_even(walk, begun, word - suns->half_level);
        return 1;
    }
    walk->packed = glint_spread_pack(word);
    glint_walk_flat(walk, begun);
    return 1;
}

/* Draws a triangle by suns, or by lamps if suns do not serve it. */
static void draw_suns(glint_row_walk *walk) {
    const glint_begun begun = glint_begin_triangle(walk);
    const glint_vertex *const *v = walk->triangle.corners;
    if (begun == GLINT_NO_ROWS || (v[0]->attribute[0] == v[1]->attribute[0] && draw_one_colour(walk, begun)) ||
        (begun == GLINT_IS_SMALL && walk->has_slopes && !glint_find_visible_row(walk)))
        return;
    walk->list->count = 0;
    if (!walk->has_slopes || !draw_visible(walk, begun))
        glint_draw_lamps(walk);
}

/* ---- Materials ---- */

static uint32_t count_lights(uint32_t lights) {
    uint32_t count = 0;
    for (; lights; lights >>= 1)
        count += lights & 1;
    return count;
}

static size_t vertex_size(const glint_shading *shading) {
    return count_lights(shading->has_specular) * sizeof(glint_sun_term);
}

/* Tables over sin^2 serve highlights from this exponent on. */
#define LEAST_EXPONENT (2 * GLINT_ONE)

/* Returns whether packed words are too coarse for the frame's pixels. */
static int is_fine(const glint_frame *frame) {
    return frame->config.gamma || !frame->config.format->store_spread;
}

/* Returns whether a material takes the larger of its ambient and all other light, and has ambient light. */
static int takes_most(const glint_shading *shading) {
    return shading->material->flags & GLINT_MATERIAL_MAX_WITH_AMBIENT &&
           (shading->ambient[0] | shading->ambient[1] | shading->ambient[2]);
}

/* Returns whether words serve surfaces of a material with colours of their own: these multiply the sum of ambient and
 * diffuse light, which must not exceed 1, as words are clamped there. */
static GLINT_NOINLINE int has_own_words(const glint_frame *frame, const glint_shading *shading) {
    if (is_fine(frame) || takes_most(shading))
        return 0;
    for (int c = 0; c < 3; c++) {
        uint32_t sum = shading->ambient[c] < 1u << 24 ? shading->ambient[c] : 1u << 24;
        for (uint32_t i = 0; shading->lights >> i; i++)
            if (shading->lights >> i & 1)
                sum += shading->weights[i].diffuse[c] << 11;
        if (sum > (1u << 23) + (1u << 14))
            return 0;
    }
    return 1;
}

/* Returns whether sun_fine.c serves a material: it has no highlights of Phong. */
static int material_lists(const glint_shading *shading) {
    return !shading->has_specular || shading->material->model->lobe != GLINT_LOBE_MIRROR;
}

/* Returns whether suns serve a material: all its lights are directional, and tables have its highlights. */
static int serves_material(const glint_frame *frame, const glint_shading *shading) {
    const glint_material *material = shading->material;
    if (!shading->lights || (is_fine(frame) && !material_lists(shading)))
        return 0;
    for (uint32_t i = 0; shading->lights >> i; i++)
        if (shading->lights >> i & 1 && frame->scene->lights[i].type != &glint_light_directional)
            return 0;
    return !shading->has_specular ||
           (material->shininess >= LEAST_EXPONENT && material->model->lobe != GLINT_LOBE_OTHER);
}

/* Has the surface of an object colours of its own, by its mesh or by a texture? */
static int has_own_colours(const glint_object *object) {
    return glint_has_colours(object->mesh) || object->material->texture != 0;
}

/* Returns whether suns serve an object of a material. */
static int serves(const glint_frame *frame, const glint_shading *shading, const glint_object *object) {
    return object->evaluation && object->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS &&
           (!has_own_colours(object) || material_lists(shading) || has_own_words(frame, shading)) &&
           serves_material(frame, shading);
}

/* Returns whether suns serve at least one object of a material. */
static int serves_some(const glint_frame *frame, const glint_shading *shading) {
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        const glint_object *object = &frame->scene->objects[i];
        if (object->material == shading->material && serves(frame, shading, object))
            return 1;
    }
    return 0;
}

/* Returns whether packed words serve an object of a material: one with colours of its own, or one without. */
static GLINT_NOINLINE int has_words_of(const glint_frame *frame, const glint_shading *shading, int is_own) {
    for (uint32_t i = 0; i < frame->scene->object_count && !is_fine(frame); i++) {
        const glint_object *object = &frame->scene->objects[i];
        if (object->material == shading->material && has_own_colours(object) == is_own &&
            (!is_own || has_own_words(frame, shading)) && serves(frame, shading, object))
            return 1;
    }
    return 0;
}

static int has_words(const glint_frame *frame, const glint_shading *shading) {
    return has_words_of(frame, shading, 0) || has_words_of(frame, shading, 1);
}

/* Adds the bytes that suns of a material need, and those of its tables. */
static void need(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables) {
    if (!serves_some(frame, shading))
        return;
    *least += GLINT_SUNS_SIZE(count_lights(shading->lights));
    for (uint32_t i = 0; shading->lights >> i; i++) {
        const glint_drawn_sun sun = {.shines = shading->has_specular >> i & 1};
        if (shading->lights >> i & 1 && has_words(frame, shading))
            *tables += GLINT_ALIGNED(glint_ramps_size(&sun));
    }
}

/* Sets the suns of a material, except the tables; `ramp` is where the last frame left them. */
static glint_status prepare_material(glint_frame *frame, glint_shading *shading) {
    const glint_view *view = frame->view;
    const glint_suns *last = shading->changed ? 0 : shading->suns;
    const uint32_t flags = shading->material->flags, count = count_lights(shading->lights);
    shading->suns = 0;
    if (!serves_some(frame, shading))
        return GLINT_OK;
    glint_suns *suns = glint_take(&frame->memory, GLINT_SUNS_SIZE(count));
    if (!suns)
        return GLINT_ERROR_ARENA;
    const uint8_t is_mirror = shading->material->model->lobe == GLINT_LOBE_MIRROR;
    const int has_own = has_words_of(frame, shading, 1),
              is_ungated = flags & GLINT_MATERIAL_SPECULAR_UNGATED && shading->has_specular;
    const uint32_t sum_mask = count > 1 || takes_most(shading) || is_ungated || has_own ||
                                      frame->config.format->sun_spans == GLINT_SPANS_OF_ANY
                                  ? UINT32_MAX
                                  : 0;
    const int is_left = last == suns && suns->is_mirror == is_mirror && suns->sum_mask == sum_mask;
    shading->suns = suns;
    suns->count = count;
    suns->is_mirror = is_mirror;
    suns->is_fine = !has_words(frame, shading);
    suns->bits = (uint8_t)(frame->config.gamma ? 8 : glint_green_bits(frame->config.format));
    suns->takes_most = (uint8_t)takes_most(shading);
    suns->has_own = (uint8_t)has_own;
    suns->gate = is_ungated ? INT32_MIN : 0;
    suns->sum_mask = sum_mask;
    suns->terms = count_lights(shading->has_specular);
    suns->is_local = view->local_viewer;
    suns->is_rounded = frame->config.format->sun_spans != GLINT_SPANS_OF_ANY;
    suns->is_plain = 0;
    suns->spans = 0;
    suns->small = glint_draw_small_suns;
    suns->ray_limit = GLINT_MOST_RAY * (1 << 15) / view->ray_scale;
    suns->ray_z = (int32_t)glint_shift_right64(glint_product(view->focal, view->ray_scale) + (1 << 23), 24);
    glint_drawn_sun *sun = suns->suns;
    for (uint32_t i = 0; shading->lights >> i; i++) {
        if (!(shading->lights >> i & 1))
            continue;
        if (!is_left)
            sun->ramp = 0;
        sun->gloss = 0;
        sun->number = i;
        sun->shines = shading->has_specular >> i & 1;
        for (int c = 0; c < 3; c++)
            sun->light[c] = view->lights[i].direction[c] + glint_shift_right(view->lights[i].direction[c], 13);
        sun++;
    }
    glint_ramps_prepare(suns, shading);
    return GLINT_OK;
}

/* Makes a material's tables, if enough room is left behind them to draw the scene. */
static void make_tables(glint_frame *frame, const glint_shading *shading, glint_suns *suns) {
    static const glint_sun_spans *const *const spans[] = {0, &glint_spans_of_rgb565, &glint_spans_of_rgb565_be};
    suns->is_plain = suns->sum_mask != 0;
    for (glint_drawn_sun *sun = suns->suns, *end = sun + suns->count; sun != end; sun++) {
        const uint32_t *const before = sun->ramp;
        const size_t size = glint_ramps_size(sun);
        sun->ramp = 0;
        if (frame->memory.high - GLINT_ALIGNED(frame->memory.low) >= size + glint_room_behind_tables(size))
            glint_ramps_make(shading, sun, glint_take(&frame->memory, size), before);
        else
            suns->is_plain = 0;
    }
    if (suns->sum_mask || !suns->suns->ramp)
        return;
    suns->spans = *spans[frame->config.format->sun_spans];
    if (suns->suns->shines && !suns->is_mirror)
        suns->small = suns->spans->small;
}

static glint_status prepare(glint_frame *frame) {
    glint_shading *const shadings = (glint_shading *)frame->shading;
    glint_status status = GLINT_OK;
    for (uint32_t i = 0; i < frame->shading_count && status == GLINT_OK; i++)
        status = prepare_material(frame, &shadings[i]);
    /* tables come last, as materials can do without them */
    for (uint32_t i = 0; i < frame->shading_count && status == GLINT_OK; i++)
        if (shadings[i].suns && !shadings[i].suns->is_fine)
            make_tables(frame, &shadings[i], (glint_suns *)shadings[i].suns);
    return status;
}

static const glint_evaluation evaluation = {.lit_at = GLINT_LIT_AT_FRAGMENTS,
                                            .light = glint_light_sun_vertices,
                                            .draw_triangle = draw_suns,
                                            .vertex_size = vertex_size};

const glint_suns_stage glint_suns_of_lights = {&evaluation, serves, prepare, need};

/* Lighting at every fragment by any lights, with the normal interpolated and made unit (Phong, 1975). It is defined in
 * this file so that suns are linked with programs that use both this evaluation and directional lights. */
const glint_evaluation glint_per_fragment = {.lit_at = GLINT_LIT_AT_FRAGMENTS,
                                             .is_costly = 1,
                                             .light = glint_transform_normals,
                                             .draw_triangle = glint_draw_lamps};
