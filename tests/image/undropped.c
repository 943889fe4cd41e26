/* SPDX-License-Identifier: MIT */
#include "undropped.h"

#include "fast/fast_draw.h"
#include "light/model.h"
#include "pixel/format.h"

undropped_drops undropped;

/* Firmware counts instructions instead. */
#if __STDC_HOSTED__
#define COUNT(drop, happened) (undropped.drop += (happened) != 0)
#else
#define COUNT(drop, happened) ((void)(happened))
#endif

/* A highlight's radius that leaves nothing outside. */
#define EVERYWHERE (1 << 28)

/* ---- Models -------------------------------------------------------------------------------------------------- */

/* The power and whether the library looks it up. */
typedef uint32_t (*lobe)(const glint_power_table *table, const glint_prepared_light *source, const int16_t normal[3],
                         const int16_t light[3], const int16_t view[3], int *is_inside);

static inline uint32_t half_vector_lobe(const glint_power_table *table, const glint_prepared_light *source,
                                        const int16_t normal[3], const int16_t light[3], const int16_t view[3],
                                        int *is_inside) {
    const int32_t sum[3] = {light[0] + view[0], light[1] + view[1], light[2] + view[2]};
    int16_t found[3];
    const int16_t *half_vector = source ? source->half_vector : found;
    if (!source && normal[0] * sum[0] + normal[1] * sum[1] + normal[2] * sum[2] <= 0)
        return glint_power_of_zero(table);
    if (!source)
        glint_unit(sum[0], sum[1], sum[2], found);
    const int32_t cosine = glint_dot(normal, half_vector);
    *is_inside = glint_in_window(table, cosine);
    return cosine > 0 ? glint_specular_power(table, normal, half_vector, cosine) : glint_power_of_zero(table);
}

static inline uint32_t mirrored_lobe(const glint_power_table *table, const glint_prepared_light *source,
                                     const int16_t normal[3], const int16_t light[3], const int16_t view[3],
                                     int *is_inside) {
    int16_t mirrored[3];
    (void)source;
    glint_mirror(glint_dot(normal, light), normal, light, mirrored);
    const int32_t along = glint_dot(mirrored, view);
    *is_inside = glint_in_window(table, along);
    return along > 0 ? glint_specular_power(table, mirrored, view, along) : glint_power_of_zero(table);
}

static inline void light_fragment(const glint_shading *shading, uint32_t index, const glint_view *view,
                                  glint_fragments *fragments, int has_surface, lobe specular, uint32_t i) {
    const glint_prepared_light *source = &view->lights[index];
    const int has_position = source->type->illuminate != 0;
    const int16_t *normal = fragments->normal[i], *light = has_position ? fragments->light[i] : source->direction;
    const uint32_t strength = has_position ? fragments->strength[i] : 1u << 15;
    const int32_t cosine = glint_dot(normal, light);
    const int is_lit = cosine > 0 || shading->material->flags & GLINT_MATERIAL_UNGATED;
    int is_inside = 1;
    uint32_t diffuse = cosine > 0 ? (uint32_t)(cosine + glint_shift_right(cosine, 12)) >> 15 : 0;
    diffuse = diffuse * strength >> 15;
    if (has_surface)
        glint_add_surface(fragments->colour[i], diffuse, fragments->surface[i], shading->weights[index].diffuse);
    else
        glint_add_light(fragments->colour[i], diffuse, shading->weights[index].diffuse);
    COUNT(lightings, 1);
    COUNT(facing_away, !is_lit);
    if (!specular)
        return;
    uint32_t power = specular(&shading->power, has_position || view->local_viewer ? 0 : source, normal, light,
                              fragments->view[i], &is_inside);
    power = is_lit ? power * strength >> 15 : 0;
    glint_add_light(fragments->colour[i], power, shading->weights[index].specular);
    COUNT(out_of_reach, is_lit && !strength);
    COUNT(no_highlight, is_lit && strength && !is_inside);
}

static inline void light_all(const glint_shading *shading, uint32_t index, const glint_view *view,
                             glint_fragments *fragments, int has_surface, lobe specular) {
    const glint_prepared_light *source = &view->lights[index];
    fragments->is_gated = 0;
    if (source->type->illuminate)
        source->type->illuminate(source, fragments);
    for (uint32_t i = 0; i < fragments->count; i++)
        light_fragment(shading, index, view, fragments, has_surface, specular, i);
}

static void light_lambert(const glint_shading *shading, uint32_t index, const glint_view *view,
                          glint_fragments *fragments, int has_surface) {
    light_all(shading, index, view, fragments, has_surface, 0);
}

static void light_phong(const glint_shading *shading, uint32_t index, const glint_view *view,
                        glint_fragments *fragments, int has_surface) {
    light_all(shading, index, view, fragments, has_surface, mirrored_lobe);
}

static void light_blinn_phong(const glint_shading *shading, uint32_t index, const glint_view *view,
                              glint_fragments *fragments, int has_surface) {
    light_all(shading, index, view, fragments, has_surface, half_vector_lobe);
}

/* Bit i: the scene of the last twin has a light i. */
static uint32_t lights_there;

/* Where no more than one light shows, fast lighting asks which. */
static void show_all_lights(glint_shading *shading) {
    if (shading->lights & (shading->lights - 1))
        shading->lights = lights_there;
}

static void prepare(glint_shading *shading, uint32_t largest_specular) {
    COUNT(no_specular, !largest_specular);
    show_all_lights(shading);
    shading->has_specular = lights_there;
    glint_prepare_specular(shading, largest_specular ? largest_specular : 1);
}

static void prepare_lambert(glint_shading *shading, uint32_t largest_specular) {
    (void)largest_specular;
    show_all_lights(shading);
    shading->has_specular = 0;
}

static const glint_model twin_of_lambert = {prepare_lambert, light_lambert, GLINT_LOBE_NONE};
static const glint_model twin_of_phong = {prepare, light_phong, GLINT_LOBE_OTHER};
static const glint_model twin_of_blinn_phong = {prepare, light_blinn_phong, GLINT_LOBE_HALF_VECTOR};

static const glint_model *twin_of(const glint_model *model) {
    return model == &glint_model_lambert       ? &twin_of_lambert
           : model == &glint_model_phong       ? &twin_of_phong
           : model == &glint_model_blinn_phong ? &twin_of_blinn_phong
                                               : model;
}

int undropped_make(undropped_scene *twin, const glint_scene *scene) {
    twin->scene = *scene;
    twin->scene.objects = twin->objects;
    lights_there = ((uint32_t)1 << scene->light_count) - 1;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (i == UNDROPPED_OBJECTS_MAX)
            return 0;
        uint32_t earlier = 0;
        while (scene->objects[earlier].material != scene->objects[i].material)
            earlier++;
        twin->objects[i] = scene->objects[i];
        twin->materials[i] = *scene->objects[i].material;
        twin->materials[i].model = twin_of(twin->materials[i].model);
        twin->objects[i].material = &twin->materials[earlier];
    }
    return 1;
}

/* ---- Kernels of RGB565 --------------------------------------------------------------------------------------- */

/* The plane of a term, its value in the high half. */
static void begin_plane(glint_plane *plane, const glint_part *part, const int16_t *const terms[3], int which) {
    glint_plane_begin(plane, &part->gradients, terms[0][which] * (1 << 16), terms[1][which] * (1 << 16),
                      terms[2][which] * (1 << 16));
}

/* The loop of highlights where N.L may be below 0: such light is found, and thrown away. */
static void draw_gated(const glint_fast_spans *s, const glint_fast_terms *fast, const glint_fast_planes *planes) {
    const glint_part *part = s->of.part;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const int32_t x = part->x + part->spans[row].left, y = part->y + (int32_t)row;
        uint32_t z = (uint32_t)glint_plane_at(&part->depth, x, y) + GLINT_DEPTH_BIAS;
        uint32_t level = (uint32_t)glint_plane_at(&planes->cosine, x, y);
        uint32_t e_x = (uint32_t)glint_plane_at(&planes->x, x, y), e_y = (uint32_t)glint_plane_at(&planes->y, x, y);
        uint32_t offset = (row << s->of.shift) + part->spans[row].left;
        const uint32_t end = (row << s->of.shift) + part->spans[row].right;
        for (; offset < end; offset++) {
            if (glint_is_nearest((uint8_t *)(s->of.depth + offset), z)) {
                const int is_lit = (int32_t)level > 0;
                const uint32_t square = glint_high_square(e_x) + glint_high_square(e_y);
                uint32_t word = fast->diffuse[is_lit ? level >> 22 : 0];
                if (square < fast->specular_end)
                    word = glint_spread_clamp(word + fast->specular[square >> 15]);
                glint_put_565(s->of.pixels + 2 * offset, is_lit ? glint_spread_pack(word) : fast->ambient,
                              GLINT_STORES_565);
            }
            z += (uint32_t)part->depth.dx;
            level += (uint32_t)planes->cosine.dx;
            e_x += (uint32_t)planes->x.dx;
            e_y += (uint32_t)planes->y.dx;
        }
    }
}

/* Finds what the library leaves out where no highlight shows. */
static void begin_highlight(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part,
                            glint_fast_kind kind, glint_fast_planes *planes) {
    const int16_t *const terms[3] = {draw->terms[triangle->corners[0] - draw->vertices],
                                     draw->terms[triangle->corners[1] - draw->vertices],
                                     draw->terms[triangle->corners[2] - draw->vertices]};
    if (kind == GLINT_FAST_AMBIENT)
        begin_plane(&planes->cosine, part, terms, 0);
    if (kind == GLINT_FAST_EVEN)
        glint_begin_term(&planes->cosine, &part->gradients, glint_find_longer(glint_turn_of(triangle->corners)),
                         terms[0][0], terms[1][0], terms[2][0]);
    begin_plane(&planes->x, part, terms, 1);
    begin_plane(&planes->y, part, terms, 2);
    COUNT(parts_ambient, kind == GLINT_FAST_AMBIENT);
    COUNT(parts_matt, kind != GLINT_FAST_AMBIENT && draw->shading->fast->specular_end);
}

static GLINT_NOINLINE int draw_exactly(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                                       const glint_triangle *triangle, const glint_part *part) {
    return glint_draw_exactly(frame, workspace, draw, triangle, part, GLINT_STORES_565);
}

/* The loop of interpolated highlights where N.L may be below 0. */
static void draw_interpolated_gated(const glint_fast_spans *s, const glint_fast_terms *fast,
                                    const glint_interpolation *light) {
    const glint_part *part = s->of.part;
    for (uint32_t row = part->top; row < part->bottom; row++) {
        const int32_t x = part->x + part->spans[row].left, y = part->y + (int32_t)row;
        uint32_t z = (uint32_t)glint_plane_at(&part->depth, x, y) + GLINT_DEPTH_BIAS;
        glint_stride cosine = glint_stride_begin(&light->cosine, x, y);
        glint_stride e_x = glint_stride_begin(&light->x, x, y), e_y = glint_stride_begin(&light->y, x, y);
        uint32_t offset = (row << s->of.shift) + part->spans[row].left;
        const uint32_t end = (row << s->of.shift) + part->spans[row].right;
        for (; offset < end; offset++) {
            if (glint_is_nearest((uint8_t *)(s->of.depth + offset), z)) {
                const int is_lit = (int32_t)cosine.value > 0;
                const uint32_t square = glint_high_square(e_x.value) + glint_high_square(e_y.value);
                uint32_t word = fast->diffuse[is_lit ? cosine.value >> 22 : 0];
                if (square < fast->specular_end)
                    word = glint_spread_clamp(word + fast->specular[square >> 15]);
                glint_put_565(s->of.pixels + 2 * offset, is_lit ? glint_spread_pack(word) : fast->ambient,
                              GLINT_STORES_565);
            }
            z += (uint32_t)part->depth.dx;
            glint_stride_next(&cosine, &light->cosine);
            glint_stride_next(&e_x, &light->x);
            glint_stride_next(&e_y, &light->y);
        }
    }
}

/* What is interpolated, with its highlight where that fits. @return 0 for all else */
static int draw_interpolated(glint_workspace *workspace, const glint_fast_spans *spans, const glint_draw *draw,
                             const glint_triangle *triangle) {
    const glint_fast_terms *fast = draw->shading->fast;
    glint_interpolation light;
    const glint_exact_kind kind = glint_interpolate_begin(draw, triangle, spans->of.part, &light);
    if (kind == GLINT_EXACT_UNFIT)
        return 0;
    if (kind != GLINT_EXACT_DIFFUSE || !fast->specular_end || !glint_interpolate_highlight(draw, triangle, &light)) {
        glint_draw_interpolated(workspace, spans, draw->shading, &light, kind, GLINT_STORES_565);
        return 1;
    }
    COUNT(parts_interpolated, 1);
    if (!fast->diffuse)
        glint_draw_curved_without_tables(spans, draw->shading, 0, &light, 1, GLINT_STORES_565);
    else
        draw_interpolated_gated(spans, fast, &light);
    return 1;
}

/* Leaves nothing outside the highlight. */
static void widen_highlight(glint_fast_terms *fast) {
    fast->cut = fast->cut_diagonal = EVERYWHERE;
    fast->exact.cut = fast->exact.cut_diagonal = EVERYWHERE;
}

static void restore_highlight(glint_fast_terms *fast, const glint_fast_terms *kept) {
    fast->cut = kept->cut;
    fast->cut_diagonal = kept->cut_diagonal;
    fast->exact.cut = kept->exact.cut;
    fast->exact.cut_diagonal = kept->exact.cut_diagonal;
}

/* A square, with its highlight wherever it lies; as the library draws it where that is behind the half vector. */
static void draw_square(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                        const glint_triangle *triangle, const glint_part *part, const glint_part *cut,
                        glint_square square, glint_exact_light *light, glint_exact_kind whole) {
    glint_fast_terms *fast = (glint_fast_terms *)draw->shading->fast;
    const glint_fast_terms kept = *fast;
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, cut, GLINT_STORES_565);
    widen_highlight(fast);
    glint_exact_kind kind = glint_exact_bend(fast, triangle, part, &square, light);
    restore_highlight(fast, &kept);
    if (kind == GLINT_EXACT_SPECULAR) {
        glint_exact_light unused = *light;
        COUNT(squares_matt,
              whole == GLINT_EXACT_DIFFUSE || glint_exact_bend(fast, triangle, part, &square, &unused) != kind);
    } else {
        kind = whole == GLINT_EXACT_DIFFUSE ? whole : glint_exact_bend(fast, triangle, part, &square, light);
    }
    if (kind == GLINT_EXACT_UNFIT)
        glint_draw_any(frame, workspace, draw, triangle, cut);
    else
        glint_draw_curved_kind(workspace, &spans, draw->shading, light, kind, GLINT_STORES_565);
}

/* Is one half vector, known with its slope, enough for all of a triangle that is lit exactly? */
static int is_small(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part) {
    const glint_fast_terms *fast = draw->shading->fast;
    glint_exact_light light;
    glint_square square;
    glint_exact_square(fast, triangle, &square);
    if (glint_exact_begin(draw, triangle, part, &light) == GLINT_EXACT_SPECULAR)
        glint_exact_bend(fast, triangle, part, &square, &light);
    return square.is_small;
}

/* A square of that side, or its quarters where the library has these, or none: its half vector bends too much. */
static void draw_or_divide(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part, glint_square square, int32_t side,
                           glint_exact_light *light, glint_exact_kind whole) {
    const glint_fast_terms *fast = draw->shading->fast;
    const int is_divided = side > 1 << fast->exact.cell;
    const int32_t quarter = side / 4;
    glint_exact_light unused = *light;
    glint_part cut = *part;
    const glint_exact_kind kind = glint_exact_bend(fast, triangle, part, &square, &unused);
    if (!is_divided || (square.is_small && kind != GLINT_EXACT_UNFIT)) {
        if (glint_cut_square(&cut, part, &square, side / 2))
            draw_square(frame, workspace, draw, triangle, part, &cut, square, light, whole);
        return;
    }
    for (int i = 0; i < 4; i++) {
        const glint_square small = {square.x + (i & 1 ? quarter : -quarter), square.y + (i & 2 ? quarter : -quarter),
                                    6 * side, 1};
        if (glint_cut_square(&cut, part, &small, quarter))
            draw_square(frame, workspace, draw, triangle, part, &cut, small, light,
                        kind == GLINT_EXACT_DIFFUSE ? kind : whole);
    }
}

/* What the library draws square by square, or without highlight though too large for one half vector. @return 0 for
 * all else */
static int draw_squares(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                        const glint_triangle *triangle, const glint_part *part) {
    const glint_fast_terms *fast = draw->shading->fast;
    const int32_t cell = (int32_t)fast->exact.cell;
    const int32_t left = glint_shift_right(part->window.left, 4), top = glint_shift_right(part->window.top, 4);
    glint_exact_light light;
    glint_square square;
    if (!fast->local_viewer || is_small(draw, triangle, part) ||
        glint_exact_begin(draw, triangle, part, &light) != GLINT_EXACT_SPECULAR || cell < GLINT_EXACT_LEAST_CELL ||
        cell + light.size > GLINT_EXACT_MOST_TURN)
        return 0;
    const int32_t side = 1 << (cell + light.size < GLINT_EXACT_MOST_TURN ? cell + 1 : cell), half = side / 2;
    glint_exact_square(fast, triangle, &square);
    const glint_exact_kind whole = glint_exact_bend(fast, triangle, part, &square, &light);
    for (int32_t y = top & -side; y < top + part->window.height; y += side) {
        for (int32_t x = left & -side; x < left + part->window.width; x += side) {
            const glint_square here = {x + half, y + half, 12 * side, 1};
            draw_or_divide(frame, workspace, draw, triangle, part, here, side, &light, whole);
        }
    }
    return 1;
}

/*
 * What turns far, with its highlight drawn wherever it lies; but where the library itself cannot, behind the half
 * vector. What faces away all over keeps its one colour.
 */
static void draw_curved(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                        const glint_triangle *triangle, const glint_part *part) {
    glint_fast_terms *fast = (glint_fast_terms *)draw->shading->fast; /* it lies in the arena */
    const glint_fast_terms kept = *fast;
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, part, GLINT_STORES_565);
    int drawn = 0;
    if (draw_interpolated(workspace, &spans, draw, triangle) || draw_squares(frame, workspace, draw, triangle, part))
        return;
    if (fast->specular_end && (!fast->local_viewer || is_small(draw, triangle, part))) {
        widen_highlight(fast);
        drawn = draw_exactly(frame, workspace, draw, triangle, part);
        restore_highlight(fast, &kept);
    }
    if (!drawn && !draw_exactly(frame, workspace, draw, triangle, part))
        glint_draw_any(frame, workspace, draw, triangle, part);
}

static void draw_undropped(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part) {
    const glint_fast_terms *fast = draw->shading->fast;
    const glint_fast_spans spans = glint_fast_spans_of(frame, workspace, part, GLINT_STORES_565);
    glint_fast_planes planes;
    const glint_fast_kind kind = glint_fast_begin(draw, triangle, part, &planes);
    if (kind == GLINT_FAST_UNFIT) {
        draw_curved(frame, workspace, draw, triangle, part);
        return;
    }
    glint_triangle as_small = *triangle; /* where the library draws no highlight it is not stepped */
    if (kind != GLINT_FAST_SPECULAR) {
        begin_highlight(draw, triangle, part, kind, &planes);
        as_small.area = 0;
    }
    if (!fast->diffuse)
        glint_draw_without_tables(frame, workspace, draw, &as_small, part, &planes, GLINT_FAST_SPECULAR,
                                  GLINT_STORES_565);
    else if (as_small.area >= GLINT_LARGE_AREA)
        glint_draw_large(frame, workspace, draw, part, &planes, GLINT_STORES_565);
    else if (kind == GLINT_FAST_SPECULAR || kind == GLINT_FAST_DIFFUSE)
        glint_draw_highlight(&spans, fast, &planes, GLINT_STORES_565);
    else
        draw_gated(&spans, fast, &planes);
}

const glint_format *undropped_format(const glint_format *format) {
    static glint_fast fast;
    static glint_evaluation evaluation;
    static glint_format twin;
    if (format != &glint_format_rgb565)
        return format;
    fast = *format->fast;
    evaluation = *fast.evaluation;
    evaluation.kernel = draw_undropped;
    fast.evaluation = &evaluation;
    twin = *format;
    twin.fast = &fast;
    return &twin;
}
