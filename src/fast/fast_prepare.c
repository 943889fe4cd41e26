/* SPDX-License-Identifier: MIT */
/* Fast lighting, once a frame: which materials it serves, and the limits that keep linear lighting's error small. */
#include "../frame/arena.h"
#include "../geometry/layout.h"
#include "../light/evaluation.h"
#include "fast_exact.h"

/* A highlight ends where it is 2^-9 of one: below 1/8 of a level of 63 at weight 1. */
#define CUT_BITS 9

/* Steps of error that turn may make, in 1/32, Q12: 9/32, and 1/3 with what an entry of the diffuse table is too coarse
 * for (find_limits). */
#define TURN_LIMIT (9u << 12)
#define TURN_AND_TABLE ((32u << 12) / 3)

/* Of an error budget, Q12, kept for what linear lighting errs without one: half a level, with highlights a whole one.
 */
#define SPARED 32
#define SPARED_SPECULAR 64

/* N.L, Q14, at which rounding cannot light what faces away. */
#define UNLIT (-8)

/* N.L, Q14, that highlights may need: where it is more, too many triangles are lit one by one. */
#define MOST_LIT (1 << 13)

/* ---- Tables ---- */

static uint32_t largest_weight(const uint32_t weight[3]) {
    uint32_t largest = weight[0] > weight[1] ? weight[0] : weight[1];
    return largest > weight[2] ? largest : weight[2];
}

/* The number of the one light that shows, if one does. */
static uint32_t shown_light(const glint_shading *shading) {
    return 31 - glint_leading_zeros(shading->lights);
}

const glint_weights *glint_weights_shown(const glint_shading *shading) {
    static const glint_weights none = {{0}, {0}};
    return shading->lights ? &shading->weights[shown_light(shading)] : &none;
}

/* Do all lights that show come to one that has no position? */
static int has_simple_light(const glint_scene *scene, const glint_shading *shading) {
    return !shading->lights ||
           (!(shading->lights & (shading->lights - 1)) && !scene->lights[shown_light(shading)].type->illuminate);
}

/*
 * N.L, Q14, from which on a highlight adds to diffuse light: where that is above 0 everywhere, and where the larger of
 * all light and ambient light is taken, no less than ambient light in all channels. @return INT16_MAX where it never is
 */
static int32_t least_lit_of(const glint_shading *shading) {
    const glint_weights *const weights = glint_weights_shown(shading);
    int32_t most = GLINT_LEAST_LIT;
    if (!glint_takes_largest(shading) || !shading->has_specular)
        return most;
    for (int c = 0; c < 3; c++) {
        const uint32_t ambient = shading->ambient[c] < 1u << 23 ? shading->ambient[c] : 1u << 23, /* Q23 */
            diffuse = weights->diffuse[c] << 11, here = diffuse > ambient ? (ambient << 7) / (diffuse >> 7) : INT16_MAX;
        most = ambient ? glint_most(most, (int32_t)here + GLINT_LEAST_LIT) : most;
    }
    return glint_least(most, INT16_MAX);
}

static int serves(const glint_frame *frame, const glint_shading *shading, const glint_object *object) {
    const glint_material *material = object->material;
    return has_simple_light(frame->scene, shading) && !frame->config.gamma &&
           (!object->evaluation || object->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS) &&
           !glint_has_colours(object->mesh) && least_lit_of(shading) <= MOST_LIT &&
           (material->model->lobe == GLINT_LOBE_NONE ||
            (material->model->lobe == GLINT_LOBE_HALF_VECTOR && material->shininess >= 2 * GLINT_ONE));
}

int glint_fast_serves(const glint_frame *frame, const glint_object *object) {
    return serves(frame, glint_shading_of(frame, object->material), object);
}

/* A quarter of the error budget, less what is kept for the errors that linear lighting has without one; all Q12. */
static uint32_t find_share(const glint_shading *shading, uint32_t kept) {
    return shading->spare > kept ? (shading->spare - kept) / 4 : 0;
}

/* sin^2 where the highlight ends, Q30; 0 when it never shows. */
static uint32_t find_highlight_end(const glint_shading *shading) {
    uint32_t weight = largest_weight(glint_weights_shown(shading)->specular);
    if (!shading->has_specular)
        return 0;
    /* 2^(12 - CUT_BITS), Q12, and a share of the error budget need not show */
    const int32_t grant =
        glint_log2(((1u << (12 - CUT_BITS)) + find_share(shading, SPARED)) << 15) - glint_log2(1u << (27 - CUT_BITS));
    int64_t bits = (int64_t)glint_log2(weight << 15) + ((4 + CUT_BITS) << 26) - grant; /* Q26; weight is Q12 */
    if (bits <= 0)
        return 0;
    return (1u << 30) - glint_exp2((int32_t) - ((2 * bits << 16) / shading->material->shininess));
}

/* Entries of the specular table: at most about 1/3 of a level apart. */
static uint32_t specular_entries(const glint_shading *shading, uint32_t cut) {
    const uint32_t weight = largest_weight(glint_weights_shown(shading)->specular);
    return cut == 0 ? 0 : weight <= 1100 ? 256 : weight <= 1650 ? 512 : 1024;
}

static int serves_some(const glint_frame *frame, const glint_shading *shading) {
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        const glint_object *object = &frame->scene->objects[i];
        if (object->material == shading->material && serves(frame, shading, object))
            return 1;
    }
    return 0;
}

void glint_fast_need(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables) {
    if (!serves_some(frame, shading))
        return;
    *least += GLINT_ALIGNED(sizeof(glint_fast_terms));
    *tables += glint_fast_tables_size(frame->config.format, specular_entries(shading, find_highlight_end(shading)));
}

/* ---- What fits ---- */

uint32_t glint_highlight_slope(glint_q16 p) {
    const uint32_t root = glint_square_root((uint64_t)(uint32_t)p); /* Q8 */
    return (root * 156 >> 8) + (640u << 16) / ((uint32_t)p | 1);    /* 0.61 sqrt(p) + 2.5 / p */
}

uint32_t glint_highlight_share(glint_q16 p) {
    return p < 32 * GLINT_ONE ? glint_square_root((uint64_t)(uint32_t)p) * 724 >> 10 : 1 << 10;
}

/* Levels of 63 that a weight, Q12, makes; at least a little. */
static uint32_t weight_in_levels(const uint32_t weight[3]) {
    uint32_t largest = 1;
    for (int c = 0; c < 3; c++)
        largest = weight[c] * glint_fast_levels[c] > largest ? weight[c] * glint_fast_levels[c] : largest;
    return largest;
}

static int32_t at_most(uint64_t value, int32_t most) {
    return value < (uint64_t)most ? (int32_t)value : most;
}

/* Of triangles with a highlight, |dx| + |dy| in 28.4: a sixth of the screen's side. One that is larger errs in too many
 * of a frame's pixels at once. */
static int32_t most_extent(const glint_frame *frame) {
    return (int32_t)glint_square_root((uint64_t)(frame->config.width * frame->config.height) << 8) / 6;
}

/*
 * Across h = extent / focal length the half vector bends by up to 0.06 h^2 from a straight line: h^2 = 0.6 / (0.06
 * slope weight) costs 0.6 of a level at the highlight's steepest place.
 */
static int32_t find_linear_extent(const glint_frame *frame, const glint_shading *shading, uint32_t weight,
                                  uint64_t grant) {
    uint64_t focal = (uint32_t)at_most((uint64_t)(uint32_t)frame->view->focal >> 9, 1 << 19); /* sixteenths */
    uint64_t slope = glint_highlight_slope(shading->material->shininess);                     /* Q8 */
    uint64_t extent = glint_square_root((focal * focal * 10 << 20) / (weight * slope + 1));
    return at_most(extent * glint_square_root((4096 + grant * 5 / 3) << 12) >> 12, INT32_MAX);
}

/* Q38 levels, in 1/32. An entry of the diffuse table is the level to within 1/512 of the weight, up to a weight of 1.
 */
static uint64_t turn_limit(uint64_t grant, uint32_t diffuse) {
    const uint32_t coarse = diffuse < glint_fast_levels[1] << 12 ? diffuse / 16 : (glint_fast_levels[1] << 12) / 16;
    return ((TURN_LIMIT < TURN_AND_TABLE - coarse ? TURN_LIMIT : TURN_AND_TABLE - coarse) + 32 * grant) << 26;
}

/*
 * What lengthens both N.L and e by a part brightens diffuse light by as much, and dims the highlight by up to
 * 2 (1 - 2/p)^(p/2 - 1) times that, which is below 3/4 + 5/(2 p).
 */
static uint64_t turning_levels(const glint_shading *shading, uint32_t diffuse, uint32_t specular) {
    const uint64_t dimmed =
        ((uint64_t)specular * 3 + ((uint64_t)specular * 10 << 16) / ((uint32_t)shading->material->shininess | 1)) * 3 /
        8;
    return dimmed > diffuse + specular / 2 ? dimmed : diffuse + specular / 2;
}

/* An error budget is shared: a quarter each for turn, slant, extent and what is cut off the highlight; without one,
 * half for the change of N.L. */
static void find_limits(const glint_frame *frame, glint_fast_terms *fast, const glint_shading *shading) {
    const uint32_t diffuse = weight_in_levels(glint_weights_shown(shading)->diffuse);
    const uint32_t specular = weight_in_levels(glint_weights_shown(shading)->specular);
    const uint64_t grant = find_share(shading, SPARED) * glint_fast_levels[1];
    const uint64_t highlight = find_share(shading, SPARED_SPECULAR) * glint_fast_levels[1];
    fast->turn = at_most(turn_limit(grant, diffuse) / diffuse, 1 << 26);
    fast->turn_specular = at_most(turn_limit(highlight, diffuse) / turning_levels(shading, diffuse, specular), 1 << 26);
    fast->extent = fast->local_viewer ? find_linear_extent(frame, shading, specular, highlight) : INT32_MAX;
    fast->slant = (uint32_t)at_most(
        (uint32_t)fast->side * (4 * glint_highlight_share(shading->material->shininess) + 2 * highlight) / specular,
        0xffff);
    if (!shading->spare) /* else the budget is what counts */
        fast->extent = at_most((uint64_t)(uint32_t)fast->extent, most_extent(frame));
    fast->even = shading->lights ? at_most((2 * grant << 14) / diffuse, INT16_MAX) : INT16_MAX;
}

static void prepare_rays(glint_fast_terms *fast, const glint_frame *frame) {
    /* focal is twice the length in pixels, Q12: half of it in sixteenths is focal 2^-9 */
    uint64_t scale = ((uint64_t)GLINT_FAST_RAY_Z << (16 + 9)) / (uint32_t)frame->view->focal;
    fast->ray_scale = at_most(scale, INT32_MAX);
    fast->ray_limit = INT32_MAX / fast->ray_scale - 1; /* middles lie half a step further */
    fast->center_x = frame->config.width * 8;
    fast->center_y = frame->config.height * 8;
    fast->ray_right = (uint32_t)fast->center_x + (uint32_t)fast->ray_limit;
    fast->ray_bottom = (uint32_t)fast->ray_limit - (uint32_t)fast->center_y;
    fast->ray_span = 2 * (uint32_t)fast->ray_limit;
    fast->ray_start = 0u - (uint32_t)fast->ray_limit * (uint32_t)fast->ray_scale;
    fast->local_viewer = frame->view->local_viewer;
}

/* Where no light shows, one from straight behind leaves what is seen dark. */
static void prepare_light(glint_fast_terms *fast, const glint_view *view, const glint_shading *shading) {
    static const glint_prepared_light behind = {.direction = {0, 0, -GLINT_UNIT}};
    const glint_prepared_light *light = shading->lights ? &view->lights[shown_light(shading)] : &behind;
    for (int c = 0; c < 3; c++) {
        fast->light[c] = light->direction[c];
        fast->long_light[c] = fast->light[c] + glint_shift_right(fast->light[c] + (1 << 12), 13);
        fast->wide_light[c] = fast->light[c] * (1 << 15) + (1 << 14);
        fast->half_vector[c] = light->half_vector[c];
    }
}

static void prepare_highlight(glint_fast_terms *fast, const glint_shading *shading) {
    const int16_t *h = fast->half_vector;
    const int has_half_vector = fast->local_viewer || (h[0] | h[1] | h[2]);
    const uint32_t cut = has_half_vector ? find_highlight_end(shading) : 0, entries = specular_entries(shading, cut);
    fast->sine_square_end = cut;
    fast->specular_end = entries << 15;
    if (!cut) {
        fast->local_viewer = 0;
        return;
    }
    /* e is Q14; where its square is the cut, that of the scaled one is the table's end */
    fast->scale = (int32_t)glint_square_root(((uint64_t)entries << 49) / cut);
    fast->scaled_half = (fast->scale >> 1) + (1 << 15);
    fast->side = (int32_t)glint_square_root(fast->specular_end) + (fast->scale >> 14) + 2;
    fast->side_diagonal = (fast->side * 23171 >> 14) + 1;
    fast->sides[0] = ((1 << 15) - (uint32_t)fast->side) * 0x10001;
    fast->sides[1] = ((1 << 15) - (uint32_t)fast->side_diagonal / 2 - 1) * 0x10001;
    fast->cut = (int32_t)glint_square_root(cut >> 2) + 4; /* more than rounding takes */
    fast->cut_diagonal = (fast->cut * 23171 >> 14) + 1;
    fast->reach = at_most((uint64_t)(GLINT_FAST_REACH << 16) / (uint32_t)fast->scale - 1, INT16_MAX);
    fast->within = UINT32_MAX >> 1 >> glint_leading_zeros((uint32_t)fast->reach + 1);
}

/* All but the tables; `diffuse` tells where the last frame left those. */
static glint_status prepare_material(glint_frame *frame, glint_shading *shading) {
    const glint_fast_terms *last = shading->changed ? 0 : shading->fast;
    shading->fast = 0;
    if (!serves_some(frame, shading))
        return GLINT_OK;
    glint_fast_terms *fast = glint_take(&frame->memory, sizeof *fast);
    if (!fast)
        return GLINT_ERROR_ARENA;
    *fast = (glint_fast_terms){.diffuse = last == fast ? last->diffuse : 0,
                               .tables_sum = last == fast ? last->tables_sum : 0};
    shading->fast = fast;
    prepare_rays(fast, frame);
    prepare_light(fast, frame->view, shading);
    glint_fast_prepare_words(fast, frame->config.format, shading);
    prepare_highlight(fast, shading);
    fast->lit = (int16_t)least_lit_of(shading);
    fast->lit_exactly = shading->material->flags ? 2 * fast->lit : INT16_MIN;
    fast->unlit = fast->specular_end && shading->material->flags & GLINT_MATERIAL_UNGATED ? INT16_MIN : UNLIT;
    find_limits(frame, fast, shading);
    glint_exact_prepare(fast, frame, shading);
    return GLINT_OK;
}

glint_status glint_fast_prepare(glint_frame *frame) {
    glint_shading *const shadings = (glint_shading *)frame->shading;
    glint_status status = GLINT_OK;
    for (uint32_t i = 0; i < frame->shading_count && status == GLINT_OK; i++)
        status = prepare_material(frame, &shadings[i]);
    /* tables may take what is left once every material has what it must have */
    for (uint32_t i = 0; i < frame->shading_count && status == GLINT_OK; i++)
        if (shadings[i].fast)
            glint_fast_make_tables(frame, (glint_fast_terms *)shadings[i].fast, &shadings[i]);
    return status;
}
