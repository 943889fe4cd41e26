/* SPDX-License-Identifier: MIT */
#include "undropped.h"

#include "deviation.h"
#include "light.h"
#include "setup.h"

undropped_drops undropped;

/* ---- Models -------------------------------------------------------------------------------------------------- */

/* The power and whether the library looks it up. */
typedef uint32_t (*lobe)(const glint_power_table *table, const glint_prepared_light *source, const int16_t normal[3],
                         const int16_t light[3], const int16_t view[3], int *is_inside);

static uint32_t half_vector_lobe(const glint_power_table *table, const glint_prepared_light *source,
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

static uint32_t mirrored_lobe(const glint_power_table *table, const glint_prepared_light *source,
                              const int16_t normal[3], const int16_t light[3], const int16_t view[3], int *is_inside) {
    const int32_t cosine = glint_dot(normal, light);
    const int32_t twice = glint_shift_right(cosine + glint_shift_right(cosine, 12), 14);
    int32_t r[3];
    int16_t mirrored[3];
    (void)source;
    for (int c = 0; c < 3; c++)
        r[c] = glint_shift_right(twice * normal[c], 15) - light[c];
    glint_unit(r[0], r[1], r[2], mirrored);
    const int32_t along = glint_dot(mirrored, view);
    *is_inside = glint_in_window(table, along);
    return along > 0 ? glint_specular_power(table, mirrored, view, along) : glint_power_of_zero(table);
}

static void light_fragment(const glint_shading *shading, uint32_t index, const glint_view *view,
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
    undropped.facing_away += !is_lit;
    if (!specular)
        return;
    uint32_t power = specular(&shading->power, has_position || view->local_viewer ? 0 : source, normal, light,
                              fragments->view[i], &is_inside);
    power = is_lit ? power * strength >> 15 : 0;
    glint_add_light(fragments->colour[i], power, shading->weights[index].specular);
    undropped.out_of_reach += is_lit && !strength;
    undropped.no_highlight += is_lit && strength && !is_inside;
}

static void light_all(const glint_shading *shading, uint32_t index, const glint_view *view, glint_fragments *fragments,
                      int has_surface, lobe specular) {
    const glint_prepared_light *source = &view->lights[index];
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

static void prepare(glint_shading *shading, uint32_t largest_specular) {
    undropped.no_specular += !largest_specular;
    shading->lights = shading->has_specular = UINT32_MAX;
    glint_prepare_specular(shading, largest_specular ? largest_specular : 1);
}

static void prepare_lambert(glint_shading *shading, uint32_t largest_specular) {
    (void)largest_specular;
    shading->lights = UINT32_MAX;
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

static uint32_t square_of_high_half(const glint_plane *plane, int32_t x, int32_t y) {
    const int32_t high = glint_shift_right(glint_plane_at(plane, x, y), 16);
    return (uint32_t)(high * high);
}

static void draw_pixels(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                        const glint_part *part, const glint_deviation_planes *planes) {
    for (uint32_t row = part->top; row < part->bottom; row++) {
        for (uint32_t column = part->spans[row].left; column < part->spans[row].right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << frame->tile_shift_x) + column;
            const uint32_t here = ((uint32_t)glint_plane_at(&part->depth, x, y) + (1u << 15)) >> 15;
            if (here <= workspace->depth[offset])
                continue;
            workspace->depth[offset] = (uint16_t)here;
            const uint32_t square = square_of_high_half(&planes->x, x, y) + square_of_high_half(&planes->y, x, y);
            ((uint16_t *)workspace->pixels)[offset] =
                (uint16_t)glint_deviation_pixel(draw->shading, glint_plane_at(&planes->cosine, x, y), square);
        }
    }
}

/* What the library draws with its highlight is drawn by the library; all else with all that it left out. */
static void draw_undropped(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part) {
    glint_deviation_planes planes;
    const glint_deviation_kind kind = glint_deviation_begin(draw, triangle, part, &planes);
    if (kind == GLINT_DEVIATION_UNFIT || kind == GLINT_DEVIATION_SPECULAR) {
        glint_format_rgb565.fast->draw(frame, workspace, draw, triangle, part);
        return;
    }
    const int16_t *const terms[3] = {draw->terms[triangle->corners[0] - draw->vertices],
                                     draw->terms[triangle->corners[1] - draw->vertices],
                                     draw->terms[triangle->corners[2] - draw->vertices]};
    if (kind == GLINT_DEVIATION_AMBIENT)
        begin_plane(&planes.cosine, part, terms, 0);
    begin_plane(&planes.x, part, terms, 1);
    begin_plane(&planes.y, part, terms, 2);
    undropped.parts_ambient += kind == GLINT_DEVIATION_AMBIENT;
    undropped.parts_matt += kind != GLINT_DEVIATION_AMBIENT && draw->shading->deviation->specular_end;
    draw_pixels(frame, workspace, draw, part, &planes);
}

const glint_format *undropped_format(const glint_format *format) {
    static glint_fast fast;
    static glint_format twin;
    if (format != &glint_format_rgb565)
        return format;
    fast = *format->fast;
    fast.draw = draw_undropped;
    twin = *format;
    twin.fast = &fast;
    return &twin;
}
