/* SPDX-License-Identifier: MIT */
#include "contract.h"

#include "library_geometry.h"
#include "lighting.h"
#include "picture.h"
#include "reference.h"
#include "weights.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GATE (4.6 / 32768)

/* The scene as the library drew it, and as the reference sees it: its light, its objects and its normals. */
typedef struct views {
    int width, height;
    const glint_scene *scene;
    reference_lights lights;
    library_geometry geometry;
    picture shaded;
    reference_image light, object, normal, shortened; /* the last is not 0 where a corner has a short L + V */
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

static const glint_material paint = {.model = &glint_model_unlit, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};

static uint8_t encode(double value) {
    return (uint8_t)lrint(127.5 + 127.5 * fmax(-1, fmin(1, value)));
}

/* What vertices are painted with: the object's number, unit normals, or whether L + V is too short where light is found
 * there. */
typedef enum painted { PAINTED_NUMBER, PAINTED_NORMAL, PAINTED_SHORT } painted;

static void paint_vertices(const views *all, uint32_t object, painted what, uint8_t (*colours)[3]) {
    for (uint32_t i = 0; i < all->scene->objects[object].mesh->vertex_count; i++) {
        reference_vertex vertex = reference_transform(all->scene, object, i, all->width, all->height);
        const uint8_t is_short = what == PAINTED_SHORT && has_short(all, object, vertex.place) ? 255 : 0;
        for (int axis = 0; axis < 3; axis++)
            colours[i][axis] = what == PAINTED_NUMBER   ? (uint8_t)object
                               : what == PAINTED_NORMAL ? encode(vertex.normal[axis])
                                                        : is_short;
    }
}

static void render_painted(const views *all, painted what, const reference_image *image) {
    static glint_object objects[LIBRARY_OBJECTS_MAX];
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
        objects[i].material = &paint;
        objects[i].evaluation = NULL;
    }
    scene.objects = objects;
    reference_render(image, &scene, (const reference_position *const *)all->geometry.positions);
    for (uint32_t i = 0; i < scene.object_count; i++)
        free(colours[i]);
}

/* Length of the interpolated normal, to within 0.014: colours have 8 bits. */
static double normal_length(const views *all, size_t at) {
    const double *colour = all->normal.pixels[at].colour;
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

/* Is a light so near that snapping moves N.L by more than the bound leaves? (contract.h, "next to it") */
static int is_next_to(const views *all, uint32_t light, const double place[3]) {
    const double half_angle = reference_real(all->scene->camera.field_of_view) * 3.14159265358979323846 / 360;
    const double tall = all->scene->camera.projection ? reference_real(all->scene->camera.view_height)
                                                      : -2 * place[2] * tan(half_angle);
    const double left = 4 * weights_slack(0, all->shaded.format),
                 pixels = picture_level_max(all->shaded.format, 1) / (16 * left);
    double way[3];
    if (all->scene->lights[light].type == &glint_light_directional)
        return 0;
    reference_find_way(&all->scene->lights[light], &all->lights, light, place, way);
    return sqrt(reference_dot(way, way)) < pixels * tall / all->height;
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

/* The number of the object that is seen in a pixel. */
static long find_object(const views *all, size_t at) {
    return lrint(255 * all->object.pixels[at].colour[0]);
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
        if (!there->covered || find_object(all, next) != find_object(all, at))
            continue;
        largest.inverse_w = fmax(largest.inverse_w, fabs(there->nearest - here->nearest));
        for (int channel = 0; channel < picture_channels(all->shaded.format); channel++)
            largest.light = fmax(largest.light, fabs(wanted_level(there->colour, all->shaded.format, channel) -
                                                     wanted_level(here->colour, all->shaded.format, channel)));
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
    return apart * all->geometry.depth_scale < JUDGE_CLOSE_STEPS || apart < find_change(all, x, y).inverse_w / 64;
}

/* Does 1/w have too few bits there? */
static int is_far(const views *all, const reference_pixel *wanted) {
    return !all->scene->camera.projection && wanted->nearest * all->geometry.depth_scale * CONTRACT_FAR < 65536;
}

static void judge_distance(const views *all, int x, int y, double bound, int is_excused, contract_result *result) {
    const reference_pixel *wanted = &all->light.pixels[(size_t)y * (size_t)all->width + (size_t)x];
    const double threshold = picture_threshold(all->shaded.format, x, y);
    double worst = 0;
    int steps = 0;
    for (int channel = 0; channel < picture_channels(all->shaded.format); channel++) {
        double level = wanted_level(wanted->colour, all->shaded.format, channel);
        int stored = picture_level(&all->shaded, x, y, channel);
        int off = abs(stored - (int)floor(level + threshold));
        worst = fmax(worst, fabs(stored + 0.5 - threshold - level));
        steps = off > steps ? off : steps;
    }
    if (is_excused) {
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
    if (wanted->grazing < GATE)
        return CONTRACT_GATED;
    if (are_close(all, wanted, x, y))
        return CONTRACT_CLOSE;
    if (is_far(all, wanted))
        return CONTRACT_DISTANT;
    if (all->shortened.pixels[at].colour[0] > 0 || (is_per_fragment(object) && normal_length(all, at) < CONTRACT_SHORT))
        return CONTRACT_SHORT_SUM;
    find_place(all, x, y, wanted->nearest, place);
    const contract_rule rule = find_light_rule(all, object, place);
    if (rule == CONTRACT_JUDGED && is_rounded(all, x, y))
        return CONTRACT_ROUNDED;
    return rule;
}

static void judge_pixel(const views *all, int x, int y, contract_result *result) {
    const size_t at = (size_t)y * (size_t)all->width + (size_t)x;
    if (!all->light.pixels[at].covered)
        return;
    const glint_object *object = &all->scene->objects[find_object(all, at)];
    const double bound = weights_bound(weights_sum(all->scene, object->material), all->shaded.format);
    const contract_rule rule = find_rule(all, object, x, y);
    result->pixels[rule]++;
    if (rule != CONTRACT_UNCERTAIN && rule != CONTRACT_GATED && rule != CONTRACT_CLOSE)
        judge_distance(all, x, y, bound, rule != CONTRACT_JUDGED, result);
}

static reference_image open_image(int width, int height) {
    reference_image image = {.width = width, .height = height};
    image.pixels = malloc((size_t)width * (size_t)height * sizeof *image.pixels);
    if (image.pixels == NULL)
        abort();
    return image;
}

/* Looks at each pixel with its own object's bound; counts anew what was over a bound. */
static void look_closely(views *all, contract_result *result) {
    glint_config config = picture_config(&all->shaded, NULL);
    library_geometry_open(&all->geometry, &config, all->scene);
    picture_render(&all->shaded, all->scene, NULL, NULL);
    reference_prepare_lights(&all->lights, all->scene, all->height);
    reference_render(&all->light, all->scene, (const reference_position *const *)all->geometry.positions);
    render_painted(all, PAINTED_NUMBER, &all->object);
    render_painted(all, PAINTED_NORMAL, &all->normal);
    render_painted(all, PAINTED_SHORT, &all->shortened);
    result->found.not_fine = result->found.over_one = result->found.over_two = 0;
    result->worst_share = result->found.worst = 0;
    for (int y = 0; y < all->height; y++) {
        for (int x = 0; x < all->width; x++)
            judge_pixel(all, x, y, result);
    }
    library_geometry_close(&all->geometry);
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
    views all = {.width = width, .height = height, .scene = scene, .shaded = picture_open(width, height, format)};
    judge_first(scene, width, height, format, result);
    if (result->found.status == GLINT_OK) {
        all.light = open_image(width, height);
        all.object = open_image(width, height);
        all.normal = open_image(width, height);
        all.shortened = open_image(width, height);
        look_closely(&all, result);
        free(all.light.pixels);
        free(all.object.pixels);
        free(all.normal.pixels);
        free(all.shortened.pixels);
    }
    picture_close(&all.shaded);
}

void contract_judge(const glint_scene *scene, int width, int height, const glint_format *format,
                    contract_result *result) {
    judge_first(scene, width, height, format, result);
    if (result->found.not_fine + result->found.over_one > 0)
        contract_judge_closely(scene, width, height, format, result);
}

int contract_holds(const contract_result *result) {
    return result->is_fine ? judgement_keeps_fine_contract(&result->found) : judgement_keeps_contract(&result->found);
}
