/* SPDX-License-Identifier: MIT */
#include "contract.h"

#include "glint_extras.h"
#include "level_set.h"
#include "library_geometry.h"
#include "lighting.h"
#include "picture.h"
#include "reference.h"
#include "weights.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GATE (4.6 / 32768)

/* All objects that are not blended. */
#define ALL UINT32_MAX

/* The scene as the library drew it, and as the reference sees it: its light and its normals. */
typedef struct views {
    int width, height;
    const glint_scene *scene;
    uint32_t only; /* the object that is seen alone, or ALL */
    reference_lights lights;
    library_geometry geometry;
    picture shaded;
    uint16_t *depth;                          /* of the library */
    reference_image light, normal, shortened; /* the last is not 0 where a corner has a short L + V */
} views;

/* ---- Short sums ---------------------------------------------------------------------------------------------- */

static int is_per_fragment(const glint_object *object) {
    return object->evaluation == NULL || object->evaluation == &glint_per_fragment;
}

/* Is L + V too short to tell its direction? */
static int is_short(const views *all, const double towards[3], const double place[3], double least) {
    const int local = all->scene->viewer == GLINT_VIEWER_LOCAL;
    double view[3];
    double sum[3];
    for (int axis = 0; axis < 3; axis++)
        view[axis] = local ? -place[axis] : axis == 2;
    reference_normalise(view);
    for (int axis = 0; axis < 3; axis++)
        sum[axis] = towards[axis] + view[axis];
    return sqrt(reference_dot(sum, sum)) < least;
}

/* The unit vector from a place towards a light. */
static void find_towards(const views *all, uint32_t light, const double place[3], double towards[3]) {
    reference_find_way(&all->scene->lights[light], &all->lights, light, place, towards);
    reference_normalise(towards);
}

/* Is L + V of any light too short at a vertex or facet, whose light is found there? */
static int has_short(const views *all, uint32_t index, const double place[3]) {
    const glint_object *object = &all->scene->objects[index];
    int found = 0;
    if (is_per_fragment(object) || object->material->model != &glint_model_blinn_phong)
        return 0;
    for (uint32_t light = 0; light < all->scene->light_count; light++) {
        double towards[3];
        find_towards(all, light, place, towards);
        found |= is_short(all, towards, place, CONTRACT_SHORT);
    }
    return found;
}

/* ---- What the reference sees beside light: as unlit colours of the vertices ------------------------------------ */

static uint8_t encode(double value) {
    return (uint8_t)lrint(127.5 + 127.5 * fmax(-1, fmin(1, value)));
}

static void see(const views *all, const reference_image *image, const glint_scene *scene) {
    const reference_position *const *const positions = (const reference_position *const *)all->geometry.positions;
    if (all->only == ALL)
        reference_render(image, scene, positions);
    else
        reference_render_object(image, scene, all->only, positions);
}

/* What vertices are painted with: unit normals, or whether L + V is too short where light is found there. */
typedef enum painted { PAINTED_NORMAL, PAINTED_SHORT } painted;

static void paint_vertices(const views *all, uint32_t object, painted what, uint8_t (*colours)[3]) {
    for (uint32_t i = 0; i < all->scene->objects[object].mesh->vertex_count; i++) {
        reference_vertex vertex = reference_transform(all->scene, object, i, all->width, all->height);
        const uint8_t is_short = what == PAINTED_SHORT && has_short(all, object, vertex.place) ? 255 : 0;
        for (int axis = 0; axis < 3; axis++)
            colours[i][axis] = what == PAINTED_NORMAL ? encode(vertex.normal[axis]) : is_short;
    }
}

static void render_painted(const views *all, painted what, const reference_image *image) {
    static glint_object objects[LIBRARY_OBJECTS_MAX];
    static glint_material paints[LIBRARY_OBJECTS_MAX]; /* with the holes of textures */
    static glint_mesh meshes[LIBRARY_OBJECTS_MAX];
    uint8_t(*colours[LIBRARY_OBJECTS_MAX])[3];
    glint_scene scene = *all->scene;
    for (uint32_t i = 0; i < scene.object_count; i++) {
        objects[i] = scene.objects[i];
        meshes[i] = *objects[i].mesh;
        colours[i] = calloc(meshes[i].vertex_count, sizeof *colours[i]);
        if (colours[i] == NULL)
            abort();
        paint_vertices(all, i, what, colours[i]);
        meshes[i].colours = (const uint8_t(*)[3])colours[i];
        meshes[i].colours565 = NULL;
        objects[i].mesh = &meshes[i];
        paints[i] = *objects[i].material;
        paints[i].model = &glint_model_unlit;
        paints[i].diffuse = (glint_colour){GLINT_ONE, GLINT_ONE, GLINT_ONE};
        objects[i].material = &paints[i];
        objects[i].evaluation = NULL;
    }
    scene.objects = objects;
    see(all, image, &scene);
    for (uint32_t i = 0; i < scene.object_count; i++)
        free(colours[i]);
}

/* Length of the interpolated normal, to within 0.014: colours have 8 bits. */
static double normal_length(const views *all, size_t at) {
    const double *colour = all->normal.pixels[at].plain;
    double square = 0;
    for (int axis = 0; axis < 3; axis++)
        square += (2 * colour[axis] - 1) * (2 * colour[axis] - 1);
    return sqrt(square);
}

/* ---- Pixels -------------------------------------------------------------------------------------------------- */

static double wanted_level(const double colour[3], const glint_format *format, int channel) {
    double value = colour[channel];
    if (picture_channels(format) == 1)
        value = 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2];
    return value * picture_level_max(format, channel);
}

/* The place seen in a pixel, in camera space. */
static void find_place(const views *all, int x, int y, double inverse_w, double place[3]) {
    const double half_angle = reference_real(all->scene->camera.field_of_view) * 3.14159265358979323846 / 360;
    const double focal = 0.5 * all->height / tan(half_angle);
    if (all->scene->camera.projection) { /* then it is how far before REFERENCE_FAR */
        const double pixel = all->scene->camera.view_height / 65536.0 / all->height;
        place[0] = (x + 0.5 - 0.5 * all->width) * pixel;
        place[1] = (0.5 * all->height - y - 0.5) * pixel;
        place[2] = inverse_w - REFERENCE_FAR;
        return;
    }
    place[0] = (x + 0.5 - 0.5 * all->width) / focal / inverse_w;
    place[1] = (0.5 * all->height - y - 0.5) / focal / inverse_w;
    place[2] = -1 / inverse_w;
}

/* Is a spot's soft edge too narrow for unit vectors of 15 bits, and the direction, if there is one, within it? */
static int is_narrow(const views *all, uint32_t light, const double *towards) {
    const glint_light *spot = &all->scene->lights[light];
    const double degree = 3.14159265358979323846 / 180;
    const double inner = cos(reference_real(spot->inner) * degree);
    const double outer = cos(reference_real(spot->outer) * degree);
    if (spot->type != &glint_light_spot || inner - outer >= CONTRACT_NARROW)
        return 0;
    double cosine = towards ? -reference_dot(all->lights.direction[light], towards) : inner;
    return cosine <= inner + GATE && cosine >= outer - GATE;
}

/* Is a light so near that snapping, or 1/w of vertices, moves N.L by more than the bound leaves? (contract.h, "next to
 * it") */
static int is_next_to(const views *all, uint32_t light, const double place[3]) {
    const double half_angle = reference_real(all->scene->camera.field_of_view) * 3.14159265358979323846 / 360;
    const double tall = all->scene->camera.projection ? reference_real(all->scene->camera.view_height)
                                                      : -2 * place[2] * tan(half_angle);
    const double left = weights_slack(0, all->shaded.format) / picture_level_max(all->shaded.format, 1),
                 snapped = tall / all->height / 16 / (4 * left),
                 deep = all->scene->camera.projection ? 0 : -place[2] / 65536 / left;
    double way[3];
    if (all->scene->lights[light].type == &glint_light_directional)
        return 0;
    reference_find_way(&all->scene->lights[light], &all->lights, light, place, way);
    return sqrt(reference_dot(way, way)) < fmax(snapped, deep);
}

/* By which rule does the last bit of a light's direction decide? */
static contract_rule find_light_rule(const views *all, const glint_object *object, const double place[3]) {
    for (uint32_t light = 0; light < all->scene->light_count; light++) {
        double towards[3];
        find_towards(all, light, place, towards);
        if (is_narrow(all, light, is_per_fragment(object) ? towards : NULL))
            return CONTRACT_NARROW_EDGE;
        if (is_next_to(all, light, place))
            return CONTRACT_NEXT_TO;
        if (is_per_fragment(object) && object->material->model == &glint_model_blinn_phong &&
            is_short(all, towards, place, CONTRACT_SHORT_HALF))
            return CONTRACT_SHORT_SUM;
    }
    return CONTRACT_JUDGED;
}

/* What changes, at most, from a pixel to the next of the same object: light in steps, and 1/w. */
typedef struct change {
    double light, inverse_w;
} change;

static change find_change(const views *all, int x, int y) {
    const size_t at = (size_t)y * (size_t)all->width + (size_t)x;
    const reference_pixel *here = &all->light.pixels[at];
    change largest = {0, 0};
    for (int i = 0; i < 9; i++) {
        int column = x + i % 3 - 1;
        int row = y + i / 3 - 1;
        if (column < 0 || row < 0 || column >= all->width || row >= all->height)
            continue;
        const size_t next = (size_t)row * (size_t)all->width + (size_t)column;
        const reference_pixel *there = &all->light.pixels[next];
        if (!there->covered || there->object != here->object)
            continue;
        largest.inverse_w = fmax(largest.inverse_w, fabs(there->nearest - here->nearest));
        for (int channel = 0; channel < picture_channels(all->shaded.format); channel++)
            largest.light = fmax(largest.light, fabs(wanted_level(there->plain, all->shaded.format, channel) -
                                                     wanted_level(here->plain, all->shaded.format, channel)));
    }
    return largest;
}

/* Does what clipping rounds, 1.5/16 of a pixel, decide on the light, or on which surface is nearer? */
static int is_rounded(const views *all, int x, int y) {
    const reference_pixel *here = &all->light.pixels[(size_t)y * (size_t)all->width + (size_t)x];
    const change largest = find_change(all, x, y);
    return (here->rounded[0] && largest.light * 1.5 / 16 > 0.25) ||
           ((here->rounded[0] || here->rounded[1]) && here->nearest - here->second < largest.inverse_w * 1.5 / 16);
}

/* Are the two nearest surfaces so close that rounding decides which is nearer? */
static int are_close(const views *all, const reference_pixel *here, int x, int y) {
    const double apart = here->nearest - here->second;
    return here->second > 0 &&
           (apart * all->geometry.depth_scale < JUDGE_CLOSE_STEPS || apart < find_change(all, x, y).inverse_w / 64);
}

/* Does 1/w have too few bits there, and do they matter? */
static int is_far(const views *all, const glint_object *object, const reference_pixel *wanted) {
    return !all->scene->camera.projection && object->evaluation != &glint_per_facet &&
           wanted->nearest * all->geometry.depth_scale * CONTRACT_FAR < 65536;
}

/* Adds a pixel to those of its depth. Depths are cut off to whole steps. */
static void add_depth(const views *all, size_t at, double worst, contract_result *result) {
    const double wanted = all->light.pixels[at].nearest * all->geometry.depth_scale;
    const double place = fmax(0, fmin(CONTRACT_DEPTHS - 1, floor(log2(65536 / wanted))));
    contract_depth *const depth = &result->depths[(int)place];
    depth->pixels++;
    depth->sum += worst;
    depth->worst = fmax(depth->worst, worst);
    depth->apart += fabs(wanted / (all->depth[at] - 0.5) - 1);
}

static void judge_distance(const views *all, int x, int y, double bound, contract_rule rule, contract_result *result) {
    const size_t at = (size_t)y * (size_t)all->width + (size_t)x;
    const reference_pixel *wanted = &all->light.pixels[at];
    const double threshold = picture_threshold(all->shaded.format, x, y);
    const int channels = picture_channels(all->shaded.format);
    double levels[3], found[3], worst = 0;
    int steps = 0, most[3];
    for (int channel = 0; channel < channels; channel++) {
        most[channel] = picture_level_max(all->shaded.format, channel);
        found[channel] = picture_level(&all->shaded, x, y, channel) + 0.5 - threshold;
    }
    (void)reference_find_wanted(wanted, channels, most, found, levels);
    for (int channel = 0; channel < channels; channel++) {
        const double level = levels[channel];
        int stored = picture_level(&all->shaded, x, y, channel);
        int off = abs(stored - (int)floor(level + threshold));
        worst = fmax(worst, fabs(stored + 0.5 - threshold - level));
        steps = off > steps ? off : steps;
    }
    if (!all->scene->camera.projection && (rule == CONTRACT_JUDGED || rule == CONTRACT_DISTANT))
        add_depth(all, at, worst, result);
    if (rule != CONTRACT_JUDGED) {
        result->excused += worst > bound || steps > 1;
        return;
    }
    result->found.not_fine += worst > bound;
    result->found.over_one += steps > 1;
    result->found.over_two += steps > 2;
    if (worst / bound > result->worst_share) {
        result->worst_share = worst / bound;
        result->bound = bound;
        result->found.worst = worst;
        result->worst_x = x;
        result->worst_y = y;
    }
}

/* By which rule is a covered pixel left out? */
static contract_rule find_rule(const views *all, const glint_object *object, int x, int y) {
    const size_t at = (size_t)y * (size_t)all->width + (size_t)x;
    const reference_pixel *wanted = &all->light.pixels[at];
    double place[3];
    if (wanted->uncertain)
        return CONTRACT_UNCERTAIN;
    if (wanted->unsettled)
        return CONTRACT_UNSETTLED;
    if (wanted->grazing < GATE)
        return CONTRACT_GATED;
    if (are_close(all, wanted, x, y))
        return CONTRACT_CLOSE;
    if (all->shortened.pixels[at].plain[0] > 0 || (is_per_fragment(object) && normal_length(all, at) < CONTRACT_SHORT))
        return CONTRACT_SHORT_SUM;
    find_place(all, x, y, wanted->nearest, place);
    const contract_rule rule = find_light_rule(all, object, place);
    if (rule == CONTRACT_JUDGED && is_rounded(all, x, y))
        return CONTRACT_ROUNDED;
    return rule == CONTRACT_JUDGED && is_far(all, object, wanted) ? CONTRACT_DISTANT : rule;
}

static void judge_pixel(const views *all, int x, int y, contract_result *result) {
    const size_t at = (size_t)y * (size_t)all->width + (size_t)x;
    if (!all->light.pixels[at].covered)
        return;
    const glint_object *object = &all->scene->objects[all->light.pixels[at].object];
    const double bound = weights_bound(weights_sum(all->scene, object->material), all->shaded.format);
    const contract_rule rule = find_rule(all, object, x, y);
    result->pixels[rule]++;
    if (rule != CONTRACT_UNCERTAIN && rule != CONTRACT_UNSETTLED && rule != CONTRACT_GATED && rule != CONTRACT_CLOSE)
        judge_distance(all, x, y, bound, rule, result);
}

static reference_image open_image(int width, int height) {
    reference_image image = {.width = width, .height = height};
    image.pixels = malloc((size_t)width * (size_t)height * sizeof *image.pixels);
    if (image.pixels == NULL)
        abort();
    return image;
}

static void see_all(const views *all) {
    see(all, &all->light, all->scene);
    render_painted(all, PAINTED_NORMAL, &all->normal);
    render_painted(all, PAINTED_SHORT, &all->shortened);
}

static views open_views(const glint_scene *scene, int width, int height, const glint_format *format) {
    views all = {.width = width, .height = height, .scene = scene, .only = ALL};
    all.shaded = picture_open(width, height, format);
    all.depth = calloc((size_t)width * (size_t)height, sizeof *all.depth);
    if (all.depth == NULL)
        abort();
    all.light = open_image(width, height);
    all.normal = open_image(width, height);
    all.shortened = open_image(width, height);
    return all;
}

static void close_views(views *all) {
    library_geometry_close(&all->geometry);
    picture_close(&all->shaded);
    free(all->depth);
    free(all->light.pixels);
    free(all->normal.pixels);
    free(all->shortened.pixels);
}

/* Looks at each pixel with its own object's bound; counts anew what was over a bound. */
static void look_closely(views *all, contract_result *result) {
    glint_config config = picture_config(&all->shaded, NULL);
    library_geometry_open(&all->geometry, &config, all->scene);
    picture_render(&all->shaded, all->scene, &(picture_options){.depth = all->depth}, NULL);
    reference_prepare_lights(&all->lights, all->scene, all->height);
    see_all(all);
    result->found.not_fine = result->found.over_one = result->found.over_two = 0;
    result->worst_share = result->found.worst = 0;
    for (int y = 0; y < all->height; y++) {
        for (int x = 0; x < all->width; x++)
            judge_pixel(all, x, y, result);
    }
}

/* ---- Blending and fog ------------------------------------------------------------------------------------------ */

/* What one colour may be off before it is stored: its levels have 15 bits, which is 1/128 of 255 levels. */
#define FLAT_SLACK (1.0 / 128)

/* What a pixel may show after the objects drawn so far. */
typedef struct blended_pixel {
    level_set levels, background; /* of what is drawn, and of what was painted before */
    double nearest;               /* of what is not blended */
    contract_rule rule;           /* by which it is left out */
} blended_pixel;

static int is_blended(const glint_scene *scene) {
    int blends = scene->fog != NULL;
    for (uint32_t i = 0; i < scene->object_count; i++)
        blends |= scene->objects[i].material->blend != GLINT_BLEND_NONE;
    return blends;
}

/* Nodes so many fogs apart tell nothing of where it begins and ends: they are cut off three fogs from either end. */
#define THIN 2

/*
 * How far is fog off at a depth along the camera's axis? It is interpolated between nodes, 8 to each octave of depth:
 * by at most an eighth of the squared way from one to the next times the largest second derivative between them.
 */
static double find_fog_slack(const views *all, double w) {
    const glint_fog *const fog = all->scene->fog;
    const double range = reference_real(fog->end) - reference_real(fog->start),
                 start = reference_real(fog->start) / range, scale = all->geometry.depth_scale * range;
    const int is_squared = fog->type == &glint_fog_squared;
    if (all->scene->camera.projection) { /* there are 8 octaves of depth */
        const double depth = fmin(65535, fmax(1, (all->geometry.farthest - w) * all->geometry.depth_scale));
        const double way = exp2(floor(log2(depth))) / 8 / scale;
        return way > THIN ? 1 : depth < 260 ? fmin(1, 260 / scale) : is_squared ? way * way / 4 : 0;
    }
    if (w * 128 < reference_real(fog->end))
        return reference_fog(fog, reference_real(fog->end) / 128);
    const double farther = 9.0 / 8 * w / range; /* depth is 1/w: there the next node may be */
    return farther / 8 > THIN ? 1 : farther * (is_squared ? 6 * fmax(0, farther - start) + 2 * start : 2) / 512;
}

/* Opacity is rounded to nearest, to 1/256, and in formats of 16 bits this to 1/32. */
static double round_opacity(double opacity, const level_place *at) {
    const double fine = floor(opacity * 256 + 0.5) / 256;
    return at->coarse > 0 ? floor(fine / at->coarse + 0.5) * at->coarse : fine;
}

/* A part that fog changes may be rounded either way, by half a step. */
static level_share round_either_way(level_share part, double step) {
    return (level_share){fmax(0, part.least - step / 2), fmin(1, part.most + step / 2)};
}

/* Which part of a surface is seen through fog? Depth is stored in whole steps, and is off by up to two. */
static level_share find_visible(const views *all, double nearest) {
    const glint_fog *const fog = all->scene->fog;
    const double scale = all->geometry.depth_scale, step = JUDGE_CLOSE_STEPS / scale;
    const int is_parallel = all->scene->camera.projection != NULL;
    const double near = is_parallel ? REFERENCE_FAR - nearest - step : 1 / (nearest + step);
    const double far = is_parallel ? REFERENCE_FAR - nearest + step : nearest > step ? 1 / (nearest - step) : INFINITY;
    const double slack = find_fog_slack(all, is_parallel ? REFERENCE_FAR - nearest : 1 / nearest);
    const level_share visible = {1 - reference_fog(fog, far) - slack, 1 - reference_fog(fog, near) + slack};
    return round_either_way(visible, 1.0 / 256);
}

static void add_fog(const views *all, const level_place *at, const level_set *background, double nearest,
                    level_set *levels) {
    const glint_fog *const fog = all->scene->fog;
    const reference_pixel thick = {.colour = {fmin(1, reference_real(fog->colour.r)),
                                              fmin(1, reference_real(fog->colour.g)),
                                              fmin(1, reference_real(fog->colour.b))}};
    level_set fades;
    level_set_surface(&fades, at, &thick, FLAT_SLACK);
    const level_share visible = round_either_way(find_visible(all, nearest), at->coarse);
    level_set_mix(levels, at, fog->to_background ? background : &fades,
                  (level_share){1 - visible.most, 1 - visible.least}, 0);
}

/* Draws the surface of one object over a pixel. */
static void blend_surface(const views *all, const level_place *at, const reference_pixel *seen, int is_painted,
                          blended_pixel *to) {
    const glint_fog *const fog = all->scene->fog;
    const glint_material *const material = all->scene->objects[all->only].material;
    const int adds = material->blend == GLINT_BLEND_ADD;
    const double opacity = reference_real(material->opacity);
    level_share part = {round_opacity(opacity, at), round_opacity(opacity, at)};
    level_set levels;
    level_set_surface(&levels, at, seen, weights_slack(weights_sum(all->scene, material), all->shaded.format));
    if (fog && (adds || (is_painted && fog->to_background))) {
        const level_share visible = find_visible(all, seen->nearest);
        const double whole = floor(opacity * 256 + 0.5) / 256;
        part = round_either_way((level_share){whole * visible.least, whole * visible.most}, 1.0 / 256);
        part = round_either_way(part, at->coarse);
    } else if (fog)
        add_fog(all, at, &to->background, seen->nearest, &levels);
    level_set_mix(&to->levels, at, &levels, part, adds);
}

/* Draws what is not blended: objects, those that cover a part of the pixels too, and fog over them. */
static void begin_pixel(const views *all, const picture *background, int x, int y, blended_pixel *to,
                        contract_result *result) {
    const size_t number = (size_t)y * (size_t)all->width + (size_t)x;
    const reference_pixel *const seen = &all->light.pixels[number];
    const level_place at = level_place_of(all->shaded.format, x, y);
    int level[3];
    for (int channel = 0; channel < at.channels; channel++)
        level[channel] = picture_level(background, x, y, channel);
    *to = (blended_pixel){.nearest = seen->nearest, .rule = seen->uncertain ? CONTRACT_UNCERTAIN : CONTRACT_JUDGED};
    level_set_known(&to->background, &at, level);
    to->levels = to->background;
    result->found.covered += seen->covered;
    if (seen->uncertain)
        return;
    result->found.missed += seen->covered != (all->depth[number] > 0);
    if (!seen->covered)
        return;
    const glint_material *const material = all->scene->objects[seen->object].material;
    to->rule = find_rule(all, &all->scene->objects[seen->object], x, y);
    level_set_surface(&to->levels, &at, seen, weights_slack(weights_sum(all->scene, material), all->shaded.format));
    if (all->scene->fog)
        add_fog(all, &at, &to->background, seen->nearest, &to->levels);
}

/* Draws the object that is seen alone over a pixel, where it is nearer than what is not blended. */
static void blend_pixel(const views *all, int x, int y, int is_painted, blended_pixel *to) {
    const reference_pixel *const seen = &all->light.pixels[(size_t)y * (size_t)all->width + (size_t)x];
    const level_place at = level_place_of(all->shaded.format, x, y);
    const double apart = seen->nearest - to->nearest;
    contract_rule rule = seen->uncertain ? CONTRACT_UNCERTAIN : CONTRACT_JUDGED;
    if (seen->covered && to->nearest > 0 &&
        fabs(apart) < fmax(JUDGE_CLOSE_STEPS / all->geometry.depth_scale, find_change(all, x, y).inverse_w / 64))
        rule = CONTRACT_CLOSE;
    else if (seen->covered && apart > 0) {
        rule = find_rule(all, &all->scene->objects[all->only], x, y);
        blend_surface(all, &at, seen, is_painted, to);
    }
    if (to->rule == CONTRACT_JUDGED)
        to->rule = rule;
}

static void judge_blended_pixel(const views *all, int x, int y, const blended_pixel *pixel, contract_result *result) {
    const level_place at = level_place_of(all->shaded.format, x, y);
    const contract_rule rule =
        pixel->rule == CONTRACT_JUDGED && !pixel->levels.count ? CONTRACT_UNSETTLED : pixel->rule;
    int level[3];
    for (int channel = 0; channel < at.channels; channel++)
        level[channel] = picture_level(&all->shaded, x, y, channel);
    result->pixels[rule]++;
    if (rule != CONTRACT_JUDGED)
        return;
    const int steps = level_set_distance(&pixel->levels, &at, level);
    result->found.judged++;
    result->found.not_fine += steps > 0;
    result->found.over_one += steps > 1;
    result->found.over_two += steps > 2;
    if (steps > 0)
        result->worst_share = fmax(result->worst_share, 1 + steps);
    if (steps > result->found.worst) {
        result->found.worst = steps;
        result->worst_x = x;
        result->worst_y = y;
    }
}

static void judge_blended(views *all, const picture_options *how, blended_pixel *pixels, contract_result *result) {
    glint_scene empty = *all->scene;
    uint32_t layers[LIBRARY_OBJECTS_MAX];
    picture background = picture_open(all->width, all->height, all->shaded.format);
    const int is_painted = how->background.paint != NULL, count = all->width * all->height;
    const uint32_t layer_count = reference_find_layers(all->scene, layers);
    empty.object_count = 0;
    empty.fog = NULL;
    result->found.status = picture_render(&background, &empty, how, NULL);
    reference_prepare_lights(&all->lights, all->scene, all->height);
    see_all(all);
    for (int i = 0; i < count; i++)
        begin_pixel(all, &background, i % all->width, i / all->width, &pixels[i], result);
    for (uint32_t layer = 0; layer < layer_count; layer++) {
        all->only = layers[layer];
        see_all(all);
        for (int i = 0; i < count; i++)
            blend_pixel(all, i % all->width, i / all->width, is_painted, &pixels[i]);
    }
    for (int i = 0; i < count; i++)
        judge_blended_pixel(all, i % all->width, i / all->width, &pixels[i], result);
    picture_close(&background);
}

void contract_judge_blended(const glint_scene *scene, int width, int height, const glint_format *format,
                            const picture_options *how, contract_result *result) {
    views all = open_views(scene, width, height, format);
    picture_options options = *how;
    blended_pixel *const pixels = malloc((size_t)width * (size_t)height * sizeof *pixels);
    if (pixels == NULL)
        abort();
    options.layers = &glint_layers;
    options.depth = all.depth;
    const glint_config config = picture_config(&all.shaded, &options);
    *result = (contract_result){.is_fine = picture_level_max(format, 0) == 255};
    result->found.status = library_geometry_open(&all.geometry, &config, scene);
    if (result->found.status == GLINT_OK)
        result->found.status = picture_render(&all.shaded, scene, &options, NULL);
    if (result->found.status == GLINT_OK)
        judge_blended(&all, how, pixels, result);
    free(pixels);
    close_views(&all);
}

/* ---- Scenes -------------------------------------------------------------------------------------------------- */

/* The strictest of the objects' bounds: a scene that keeps to it need not be looked at closely. */
static double strictest_bound(const glint_scene *scene, const glint_format *format) {
    double least = INFINITY;
    for (uint32_t i = 0; i < scene->object_count; i++)
        least = fmin(least, weights_bound(weights_sum(scene, scene->objects[i].material), format));
    return least;
}

/* Judges by the strictest bound, all rules but those of judge.h aside. */
static void judge_first(const glint_scene *scene, int width, int height, const glint_format *format,
                        contract_result *result) {
    const judge_task task = {.scene = scene,
                             .width = width,
                             .height = height,
                             .format = format,
                             .leave_out_gates = 1,
                             .fine = strictest_bound(scene, format)};
    *result = (contract_result){.bound = task.fine, .is_fine = picture_level_max(format, 0) == 255};
    judge(&task, &result->found);
    result->worst_share = result->found.worst / task.fine;
    result->worst_x = result->found.worst_x;
    result->worst_y = result->found.worst_y;
}

void contract_judge_closely(const glint_scene *scene, int width, int height, const glint_format *format,
                            contract_result *result) {
    if (is_blended(scene)) {
        contract_judge_blended(scene, width, height, format, &(picture_options){0}, result);
        return;
    }
    judge_first(scene, width, height, format, result);
    if (result->found.status != GLINT_OK)
        return;
    views all = open_views(scene, width, height, format);
    look_closely(&all, result);
    close_views(&all);
}

void contract_judge(const glint_scene *scene, int width, int height, const glint_format *format,
                    contract_result *result) {
    if (!is_blended(scene))
        judge_first(scene, width, height, format, result);
    if (is_blended(scene) || result->found.not_fine + result->found.over_one > 0)
        contract_judge_closely(scene, width, height, format, result);
}

int contract_holds(const contract_result *result) {
    return result->is_fine ? judgement_keeps_fine_contract(&result->found) : judgement_keeps_contract(&result->found);
}
