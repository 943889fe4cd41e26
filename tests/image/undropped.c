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
    glint_prepare_specular(shading, largest_specular ? largest_specular : 1);
}

static const glint_model twin_of_lambert = {0, light_lambert, GLINT_LOBE_NONE};
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

/* Planes of N.L and of the deviation, which is 2^down times as large. */
typedef struct wide_planes {
    glint_plane cosine, x, y;
    unsigned down;
} wide_planes;

static int32_t scaled(const glint_deviation *deviation, int32_t e, unsigned down) {
    return (int32_t)glint_shift_right64((int64_t)e * deviation->scale, down);
}

/* Planes of a triangle anywhere, the back of the highlight too: the library's reach only so far. */
static void begin_wide(const glint_draw *draw, const glint_triangle *triangle, const glint_part *part,
                       wide_planes *planes) {
    const glint_deviation *deviation = draw->shading->deviation;
    const int16_t *lit[3];
    uint64_t bits = 0;
    for (int i = 0; i < 3; i++) {
        lit[i] = draw->terms[triangle->corners[i] - draw->vertices];
        for (int c = 1; c < 3; c++)
            bits |= glint_magnitude64((int64_t)lit[i][c] * deviation->scale);
    }
    planes->down = glint_bits64(bits) > 29 ? glint_bits64(bits) - 29 : 0;
    const unsigned down = planes->down;
    glint_plane_begin(&planes->cosine, &part->gradients, lit[0][0] * (1 << 15), lit[1][0] * (1 << 15),
                      lit[2][0] * (1 << 15));
    glint_plane_begin(&planes->x, &part->gradients, scaled(deviation, lit[0][1], down),
                      scaled(deviation, lit[1][1], down), scaled(deviation, lit[2][1], down));
    glint_plane_begin(&planes->y, &part->gradients, scaled(deviation, lit[0][2], down),
                      scaled(deviation, lit[1][2], down), scaled(deviation, lit[2][2], down));
}

static uint32_t square_at(const wide_planes *planes, int32_t x, int32_t y) {
    const int64_t ex = glint_plane_at(&planes->x, x, y), ey = glint_plane_at(&planes->y, x, y);
    const unsigned down = 2 * planes->down;
    const uint64_t square = (uint64_t)(ex * ex + ey * ey);
    const uint64_t whole = down < 32 ? square >> (32 - down) : square;
    return whole < UINT32_MAX ? (uint32_t)whole : UINT32_MAX;
}

static void draw_pixels(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                        const glint_part *part, const glint_plane *cosine, const wide_planes *planes) {
    for (uint32_t row = part->top; row < part->bottom; row++) {
        for (uint32_t column = part->spans[row].left; column < part->spans[row].right; column++) {
            const int32_t x = part->x + (int32_t)column, y = part->y + (int32_t)row;
            const uint32_t offset = (row << frame->tile_shift_x) + column;
            const uint32_t here = ((uint32_t)glint_plane_at(&part->depth, x, y) + (1u << 15)) >> 15;
            if (here <= workspace->depth[offset])
                continue;
            workspace->depth[offset] = (uint16_t)here;
            const uint32_t square = planes ? square_at(planes, x, y) : UINT32_MAX;
            ((uint16_t *)workspace->pixels)[offset] =
                (uint16_t)glint_deviation_pixel(draw->shading, glint_plane_at(cosine, x, y), square);
        }
    }
}

/* What the library draws with its highlight is drawn by the library; all else with all that it left out. */
static void draw_undropped(const glint_frame *frame, glint_workspace *workspace, const glint_draw *draw,
                           const glint_triangle *triangle, const glint_part *part) {
    const glint_deviation *deviation = draw->shading->deviation;
    glint_deviation_planes planes;
    wide_planes wide;
    const glint_deviation_kind kind = glint_deviation_begin(draw, triangle, part, &planes);
    if (kind == GLINT_DEVIATION_UNFIT || kind == GLINT_DEVIATION_SPECULAR) {
        glint_format_rgb565.fast->draw(frame, workspace, draw, triangle, part);
        return;
    }
    begin_wide(draw, triangle, part, &wide);
    undropped.parts_ambient += kind == GLINT_DEVIATION_AMBIENT;
    undropped.parts_matt += kind != GLINT_DEVIATION_AMBIENT && deviation->specular_end;
    draw_pixels(frame, workspace, draw, part, kind == GLINT_DEVIATION_AMBIENT ? &wide.cosine : &planes.cosine,
                deviation->specular_end ? &wide : 0);
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
