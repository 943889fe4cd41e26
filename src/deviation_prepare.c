/* SPDX-License-Identifier: MIT */
/* Fast lighting, once a frame: a material's tables of colour, and the limits that keep linear lighting's error small.
 */
#include "light.h"
#include "quadratic.h"

/* A highlight ends where it is 2^-9 of one: below 1/8 of a level of 63 at weight 1. */
#define CUT_BITS 9

/* Steps of error that turn may make, in 1/32, Q12: 9/32, and 1/3 with what an entry of the diffuse table is too coarse
 * for (find_limits). */
#define TURN_LIMIT (9u << 12)
#define TURN_AND_TABLE ((32u << 12) / 3)

/* Of an error budget, Q12, kept for what linear lighting errs without one: half a level, with highlights a whole one.
 */
#define KEPT 32
#define KEPT_SPECULAR 64

/* Binary logarithm of the specular table's entries for each node that is computed; it is linear between them. */
#define NODE_BITS 3

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

static int serves(const glint_frame *frame, const glint_shading *shading, const glint_object *object) {
    const glint_material *material = object->material;
    return has_simple_light(frame->scene, shading) && !frame->config.gamma &&
           (!object->evaluation || object->evaluation->lit_at == GLINT_LIT_AT_FRAGMENTS) && !object->mesh->colours &&
           !object->mesh->colours565 && material->flags == 0 &&
           (material->model->lobe == GLINT_LOBE_NONE ||
            (material->model->lobe == GLINT_LOBE_HALF_VECTOR && material->shininess >= 2 * GLINT_ONE));
}

int glint_deviation_serves(const glint_frame *frame, const glint_object *object) {
    return serves(frame, glint_shading_of(frame, object->material), object);
}

/* A quarter of the error budget, less what is kept for the errors that linear lighting has without one; all Q12. */
static uint32_t find_share(const glint_shading *shading, uint32_t kept) {
    return shading->spare > kept ? (shading->spare - kept) / 4 : 0;
}

/* sin^2 where the highlight ends, Q30; 0 when it never shows. */
static uint32_t find_cut(const glint_shading *shading) {
    uint32_t weight = largest_weight(glint_weights_shown(shading)->specular);
    if (!shading->has_specular)
        return 0;
    /* 2^(12 - CUT_BITS), Q12, and a share of the error budget need not show */
    const int32_t grant =
        glint_log2(((1u << (12 - CUT_BITS)) + find_share(shading, KEPT)) << 15) - glint_log2(1u << (27 - CUT_BITS));
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

/* Bytes of the diffuse tables. */
#define DIFFUSE_BYTES (GLINT_DIFFUSE_ENTRIES * (sizeof(uint32_t) + sizeof(uint16_t)))

static size_t tables_size(uint32_t specular) {
    return GLINT_ALIGNED(DIFFUSE_BYTES + specular * sizeof(uint32_t));
}

void glint_deviation_need(const glint_frame *frame, const glint_shading *shading, size_t *least, size_t *tables) {
    if (!serves_some(frame, shading))
        return;
    *least += GLINT_ALIGNED(sizeof(glint_deviation));
    *tables += tables_size(specular_entries(shading, find_cut(shading)));
}

/* A colour, Q23 times 31, 63 and 31, as a word. */
static uint32_t spread(const uint32_t level[3]) {
    return (level[0] >> 18) << 10 | (level[1] >> 19) << 21 | level[2] >> 19;
}

/* Half of what `spread` cuts off. */
static const uint32_t spread_half[3] = {1 << 17, 1 << 18, 1 << 18};

static const uint32_t levels[3] = {31, 63, 31};

static inline uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

/* A colour that changes by `step` from entry to entry, up to `most`. */
typedef struct ramp {
    uint32_t level[3], step[3], most[3];
} ramp;

/* Its first `count` words. */
static void fill(const ramp *r, uint32_t *words, uint32_t count) {
    uint32_t red = r->level[0], green = r->level[1], blue = r->level[2];
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t level[3] = {red, green, blue};
        words[i] = spread(level);
        red = least(red + r->step[0], r->most[0]);
        green = least(green + r->step[1], r->most[1]);
        blue = least(blue + r->step[2], r->most[2]);
    }
}

/* Ambient and diffuse light over N.L in 256 steps, the first at its middle; where no light shows, `ambient`. */
static void diffuse_ramp(const glint_shading *shading, ramp *r) {
    const uint32_t *const weight = glint_weights_shown(shading)->diffuse;
    for (int c = 0; c < 3; c++) {
        const uint32_t ambient = least(shading->ambient[c], 1u << 23);
        r->step[c] = weight[c] * levels[c] << 3; /* Q12 to Q23, 256 steps; below 2^26 */
        r->most[c] = (levels[c] << 23) + (1 << 22) + spread_half[c];
        r->level[c] = ambient * levels[c] + (1 << 22) + (shading->lights ? spread_half[c] : 0) + r->step[c] / 2;
        r->level[c] = least(r->level[c], r->most[c]);
    }
}

static uint32_t diffuse_word(const glint_shading *shading, uint32_t index) {
    ramp r;
    diffuse_ramp(shading, &r);
    for (int c = 0; c < 3; c++) {
        uint64_t level = r.level[c] + (uint64_t)r.step[c] * index;
        r.level[c] = level > r.most[c] ? r.most[c] : (uint32_t)level;
    }
    return spread(r.level);
}

/* Highlight at node i, clamped at 1 in each channel; Q23 times 31, 63 and 31. */
static void highlight(const glint_shading *shading, uint32_t i, uint32_t level[3]) {
    const glint_deviation *deviation = shading->deviation;
    const uint32_t *const weight = glint_weights_shown(shading)->specular;
    const unsigned bits = 31 - glint_leading_zeros(deviation->specular_end >> (15 + NODE_BITS)); /* of their number */
    uint32_t power = glint_power_at(&shading->power, (uint32_t)((uint64_t)deviation->sine_square_end * i >> bits));
    for (int c = 0; c < 3; c++) {
        uint32_t amount = power * weight[c] >> 4;
        level[c] = least(amount, 1u << 23) * levels[c];
    }
}

/* From a node of the highlight to the next, the first entry at its middle; downwards modulo 2^32. */
static void highlight_ramp(const uint32_t here[3], const uint32_t next[3], ramp *r) {
    for (int c = 0; c < 3; c++) {
        const int32_t change = (int32_t)(next[c] - here[c]);
        r->step[c] = (uint32_t)glint_shift_right(change, NODE_BITS);
        r->level[c] = here[c] + (uint32_t)glint_shift_right(change, NODE_BITS + 1) + spread_half[c];
        r->most[c] = UINT32_MAX;
    }
}

static uint32_t highlight_word(const glint_shading *shading, uint32_t index) {
    uint32_t here[3], next[3];
    ramp r;
    highlight(shading, index >> NODE_BITS, here);
    highlight(shading, (index >> NODE_BITS) + 1, next);
    highlight_ramp(here, next, &r);
    for (int c = 0; c < 3; c++)
        r.level[c] += r.step[c] * (index & ((1 << NODE_BITS) - 1));
    return spread(r.level);
}

uint32_t glint_deviation_pixel(const glint_shading *shading, int32_t cosine, uint32_t square) {
    if (cosine <= 0)
        return shading->deviation->ambient;
    uint32_t word = diffuse_word(shading, (uint32_t)cosine >> 22);
    if (square < shading->deviation->specular_end)
        word = glint_spread_clamp(word + highlight_word(shading, square >> 15));
    return glint_spread_pack(word);
}

static void fill_specular(const glint_shading *shading, uint32_t *words, uint32_t entries) {
    uint32_t here[3], next[3];
    highlight(shading, 0, here);
    for (uint32_t i = 0; i < entries >> NODE_BITS; i++) {
        ramp r;
        highlight(shading, i + 1, next);
        highlight_ramp(here, next, &r);
        fill(&r, words + (i << NODE_BITS), 1 << NODE_BITS);
        for (int c = 0; c < 3; c++)
            here[c] = next[c];
    }
}

/* What tables leave is enough to draw any scene. */
typedef char tables_leave_room[DIFFUSE_BYTES >= GLINT_LEAST_ROOM ? 1 : -1];

/* The tables, if they leave as much room as they take; nothing is to be done where the last frame left them. */
static void make_tables(glint_memory *memory, glint_deviation *deviation, const glint_shading *shading) {
    const uint32_t entries = deviation->specular_end >> 15, *const kept = deviation->diffuse;
    const size_t size = tables_size(entries);
    ramp r;
    deviation->diffuse = 0;
    if (memory->high - GLINT_ALIGNED(memory->low) < 2 * size)
        return;
    uint32_t *const specular = glint_take(memory, size), *const diffuse = specular + entries;
    uint16_t *pixels = (uint16_t *)(void *)(diffuse + GLINT_DIFFUSE_ENTRIES);
    deviation->specular = specular;
    deviation->diffuse = diffuse;
    deviation->diffuse_pixel = pixels;
    if (diffuse == kept)
        return;
    if (entries)
        fill_specular(shading, specular, entries);
    diffuse_ramp(shading, &r);
    fill(&r, diffuse, GLINT_DIFFUSE_ENTRIES);
    for (uint32_t i = 0; i < GLINT_DIFFUSE_ENTRIES; i++)
        pixels[i] = (uint16_t)glint_spread_pack(deviation->diffuse[i]);
}

/* ---- What fits ---- */

/* Digit by digit: `root` is twice what is found, times the digit at `bit`, and x what is left. */
uint32_t glint_square_root(uint64_t x) {
    uint64_t root = 0, bit = (uint64_t)1 << (x >> 32 ? 62 : 30);
    while (bit > x)
        bit >>= 2;
    for (; bit; bit >>= 2) {
        const uint64_t more = root + bit;
        root >>= 1;
        if (x >= more) {
            x -= more;
            root += bit;
        }
    }
    return (uint32_t)root;
}

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
        largest = weight[c] * levels[c] > largest ? weight[c] * levels[c] : largest;
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
static int32_t find_extent(const glint_frame *frame, const glint_shading *shading, uint32_t weight, uint64_t grant) {
    uint64_t focal = (uint32_t)at_most((uint64_t)(uint32_t)frame->view->focal >> 9, 1 << 19); /* sixteenths */
    uint64_t slope = glint_highlight_slope(shading->material->shininess);                     /* Q8 */
    uint64_t extent = glint_square_root((focal * focal * 10 << 20) / (weight * slope + 1));
    return at_most(extent * glint_square_root((4096 + grant * 5 / 3) << 12) >> 12, INT32_MAX);
}

/* Q38 levels, in 1/32. An entry of the diffuse table is the level to within 1/512 of the weight, up to a weight of 1.
 */
static uint64_t turn_limit(uint64_t grant, uint32_t diffuse) {
    const uint32_t coarse = least(diffuse, levels[1] << 12) / 16;
    return (least(TURN_LIMIT, TURN_AND_TABLE - coarse) + 32 * grant) << 26;
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
static void find_limits(const glint_frame *frame, glint_deviation *deviation, const glint_shading *shading) {
    const uint32_t diffuse = weight_in_levels(glint_weights_shown(shading)->diffuse);
    const uint32_t specular = weight_in_levels(glint_weights_shown(shading)->specular);
    const uint64_t grant = find_share(shading, KEPT) * levels[1];
    const uint64_t highlight = find_share(shading, KEPT_SPECULAR) * levels[1];
    deviation->turn = at_most(turn_limit(grant, diffuse) / diffuse, 1 << 26);
    deviation->turn_specular =
        at_most(turn_limit(highlight, diffuse) / turning_levels(shading, diffuse, specular), 1 << 26);
    deviation->extent = deviation->local_viewer ? find_extent(frame, shading, specular, highlight) : INT32_MAX;
    deviation->slant =
        (uint32_t)at_most((uint32_t)deviation->side *
                              (4 * glint_highlight_share(shading->material->shininess) + 2 * highlight) / specular,
                          0xffff);
    if (!shading->spare) /* else the budget is what counts */
        deviation->extent = at_most((uint64_t)(uint32_t)deviation->extent, most_extent(frame));
    deviation->even = shading->lights ? at_most((2 * grant << 14) / diffuse, INT16_MAX) : INT16_MAX;
}

static void prepare_rays(glint_deviation *deviation, const glint_frame *frame) {
    /* focal is twice the length in pixels, Q12: half of it in sixteenths is focal 2^-9 */
    uint64_t scale = ((uint64_t)GLINT_DEVIATION_RAY_Z << (16 + 9)) / (uint32_t)frame->view->focal;
    deviation->ray_scale = at_most(scale, INT32_MAX);
    deviation->ray_limit = INT32_MAX / deviation->ray_scale;
    deviation->center_x = frame->config.width * 8;
    deviation->center_y = frame->config.height * 8;
    deviation->ray_right = (uint32_t)deviation->center_x + (uint32_t)deviation->ray_limit;
    deviation->ray_bottom = (uint32_t)deviation->ray_limit - (uint32_t)deviation->center_y;
    deviation->ray_span = 2 * (uint32_t)deviation->ray_limit;
    deviation->ray_start = 0u - (uint32_t)deviation->ray_limit * (uint32_t)deviation->ray_scale;
    deviation->local_viewer = frame->view->local_viewer;
}

/* Where no light shows, one from straight behind leaves what is seen dark. */
static void prepare_light(glint_deviation *deviation, const glint_view *view, const glint_shading *shading) {
    static const glint_prepared_light behind = {.direction = {0, 0, -GLINT_UNIT}};
    const glint_prepared_light *light = shading->lights ? &view->lights[shown_light(shading)] : &behind;
    for (int c = 0; c < 3; c++) {
        deviation->light[c] = light->direction[c];
        deviation->long_light[c] = deviation->light[c] + glint_shift_right(deviation->light[c] + (1 << 12), 13);
        deviation->wide_light[c] = deviation->light[c] * (1 << 15) + (1 << 14);
        deviation->half_vector[c] = light->half_vector[c];
    }
}

static void prepare_highlight(glint_deviation *deviation, const glint_shading *shading) {
    const int16_t *h = deviation->half_vector;
    const int has_half_vector = deviation->local_viewer || (h[0] | h[1] | h[2]);
    const uint32_t cut = has_half_vector ? find_cut(shading) : 0, entries = specular_entries(shading, cut);
    deviation->sine_square_end = cut;
    deviation->specular_end = entries << 15;
    if (!cut) {
        deviation->local_viewer = 0;
        return;
    }
    /* e is Q14; where its square is the cut, that of the scaled one is the table's end */
    deviation->scale = (int32_t)glint_square_root(((uint64_t)entries << 49) / cut);
    deviation->scaled_half = (deviation->scale >> 1) + (1 << 15);
    deviation->side = (int32_t)glint_square_root(deviation->specular_end) + (deviation->scale >> 14) + 2;
    deviation->side_diagonal = (deviation->side * 23171 >> 14) + 1;
    deviation->sides[0] = ((1 << 15) - (uint32_t)deviation->side) * 0x10001;
    deviation->sides[1] = ((1 << 15) - (uint32_t)deviation->side_diagonal / 2 - 1) * 0x10001;
    deviation->cut = (int32_t)glint_square_root(cut >> 2) + 4; /* more than rounding takes */
    deviation->cut_diagonal = (deviation->cut * 23171 >> 14) + 1;
    deviation->reach = at_most((uint64_t)(GLINT_DEVIATION_REACH << 16) / (uint32_t)deviation->scale - 1, INT16_MAX);
    deviation->within = UINT32_MAX >> 1 >> glint_leading_zeros((uint32_t)deviation->reach + 1);
}

static void prepare_ambient(glint_deviation *deviation, const glint_shading *shading) {
    uint32_t level[3];
    for (int c = 0; c < 3; c++)
        level[c] = least(shading->ambient[c], 1u << 23) * levels[c] + (1 << 22);
    deviation->ambient = (uint16_t)glint_spread_pack(spread(level));
}

/* All but the tables; `diffuse` tells where the last frame left those. */
static glint_status prepare(glint_frame *frame, glint_shading *shading) {
    const glint_deviation *last = shading->changed ? 0 : shading->deviation;
    shading->deviation = 0;
    if (!serves_some(frame, shading))
        return GLINT_OK;
    glint_deviation *deviation = glint_take(&frame->memory, sizeof *deviation);
    if (!deviation)
        return GLINT_ERROR_ARENA;
    *deviation = (glint_deviation){.diffuse = last == deviation ? last->diffuse : 0};
    shading->deviation = deviation;
    prepare_rays(deviation, frame);
    prepare_light(deviation, frame->view, shading);
    prepare_ambient(deviation, shading);
    prepare_highlight(deviation, shading);
    find_limits(frame, deviation, shading);
    glint_quadratic_prepare(deviation, frame, shading);
    return GLINT_OK;
}

glint_status glint_deviation_prepare(glint_frame *frame) {
    glint_shading *const shadings = (glint_shading *)frame->shading;
    glint_status status = GLINT_OK;
    for (uint32_t i = 0; i < frame->shading_count && status == GLINT_OK; i++)
        status = prepare(frame, &shadings[i]);
    /* tables may take what is left once every material has what it must have */
    for (uint32_t i = 0; i < frame->shading_count && status == GLINT_OK; i++)
        if (shadings[i].deviation)
            make_tables(&frame->memory, (glint_deviation *)shadings[i].deviation, &shadings[i]);
    return status;
}
