/* SPDX-License-Identifier: MIT */
/* Terms, once a frame: what a material makes of the frame's lights. */
#include "../fast/fast.h"
#include "../frame/arena.h"
#include "../geometry/layout.h"
#include "../light/evaluation.h"
#include "../pixel/format.h"
#include "terms.h"

/* Exponents below this have lobes of the cosine. */
#define WIDE (7 * GLINT_ONE)

/* Error of polynomials in levels, Q8, for each 1 that the weights of a channel add up to, but at least 1. */
#define LIMIT 51

/* Where weights add up to more than this, errors do not grow with them: pixels are to stay within a step. */
#define MOST_WEIGHT 4

/*
 * Most of it for quadratics, which are given twice as much: their bound counts with all lights from one side, and with
 * highlights in one place. What light in sums is off by counts on its own: lights from one side there are. So does each
 * highlight: a step off is 3/2 of a level, of which rounding takes half and tables an eighth.
 */
#define MOST_OF_QUADRATICS 320
#define MOST_OF_SUMS 112
#define MOST_OF_ONE 224

/* Bits that a squared deviation has where narrow lobes end: deviations reach four times as far. */
#define LOBE_BITS 24

static int32_t largest_of(const uint16_t v[3]) {
    return glint_most_of(v[0], v[1], v[2]);
}

/* Bits of levels that errors are counted in: those of a format's channels, of four bits or fewer 6. */
static unsigned level_bits(const glint_format *format, int c) {
    return format->channel[c] == 0 ? 8 : format->channel[c] < 5 ? 6 : format->channel[c];
}

/* A weight, Q12, in levels, as glint_to_levels does it; and what it makes, levels in Q8. */
static uint16_t in_levels(const glint_config *config, uint32_t weight, int c) {
    const unsigned bits = config->gamma ? 0 : config->format->channel[c];
    return (uint16_t)(bits ? weight - ((weight + (1u << bits >> 1)) >> bits) : weight);
}

static uint32_t levels_of(const glint_format *format, const uint32_t weight[3]) {
    uint32_t most = 0;
    for (int c = 0; c < 3; c++) {
        const uint32_t levels = weight[c] << level_bits(format, c) >> 4;
        most = levels > most ? levels : most;
    }
    return most;
}

static void set_weights(const glint_frame *frame, const glint_shading *shading, glint_light_terms *terms) {
    const glint_config *config = &frame->config;
    for (int c = 0; c < 3; c++) {
        const unsigned bits = config->gamma ? 0 : config->format->channel[c];
        const int32_t ambient = (int32_t)(shading->ambient[c] << (GLINT_CHANNEL_BITS - 23));
        terms->half[c] = bits ? 1 << (GLINT_CHANNEL_BITS - 1 - bits) : 0;
        terms->ambient[c] = glint_to_levels(ambient, bits) - terms->half[c];
    }
    const uint32_t ambient[3] = {shading->ambient[0] >> 11, shading->ambient[1] >> 11, shading->ambient[2] >> 11};
    terms->ambient_levels = levels_of(config->format, ambient);
    for (uint32_t i = 0; i < frame->scene->light_count; i++) {
        const glint_weights *weights = &shading->weights[i];
        for (int c = 0; c < 3; c++) {
            terms->diffuse[i][c] = in_levels(config, weights->diffuse[c], c);
            terms->specular[i][c] = in_levels(config, weights->specular[c], c);
        }
        terms->diffuse_levels[i] = levels_of(config->format, weights->diffuse);
        terms->specular_levels[i] = levels_of(config->format, weights->specular);
    }
}

/* Is light of these weights of one chroma, that of the light that weighs most? Then finds each light's share. */
static int find_chroma(uint32_t lights, const uint16_t weight[][3], int32_t chroma[3],
                       int32_t share[GLINT_LIGHTS_MAX]) {
    int32_t whole = 0;
    chroma[0] = chroma[1] = chroma[2] = 0;
    for (uint32_t i = 0; lights >> i; i++) {
        if (!(lights >> i & 1) || largest_of(weight[i]) <= whole)
            continue;
        whole = largest_of(weight[i]);
        for (int c = 0; c < 3; c++)
            chroma[c] = weight[i][c];
    }
    for (uint32_t i = 0; lights >> i; i++) {
        share[i] = whole ? (int32_t)(((uint32_t)largest_of(weight[i]) << 15) / (uint32_t)whole) : 0;
        for (int c = 0; c < 3 && lights >> i & 1; c++) {
            const int32_t apart = weight[i][c] - (int32_t)((uint32_t)chroma[c] * (uint32_t)share[i] >> 15);
            if (apart > 1 || apart < -1)
                return 0;
        }
    }
    return 1;
}

/* The sum of all light that shows, Q12, in its largest channel; with ambient light or without. */
static uint32_t find_total(const glint_frame *frame, const glint_shading *shading, int with_ambient) {
    uint32_t total = 0;
    for (int c = 0; c < 3; c++) {
        uint32_t sum = with_ambient ? shading->ambient[c] >> 11 : 0;
        for (uint32_t i = 0; i < frame->scene->light_count; i++)
            if (shading->lights >> i & 1)
                sum += shading->weights[i].diffuse[c] +
                       (shading->has_specular >> i & 1 ? shading->weights[i].specular[c] : 0);
        total = sum > total ? sum : total;
    }
    return total;
}

/* Has an object of the material a surface of its own colours? */
static int has_surface(const glint_frame *frame, const glint_material *material) {
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        const glint_object *object = &frame->scene->objects[i];
        if (object->material == material && glint_has_colours(object->mesh))
            return 1;
    }
    return 0;
}

/* Bits of a sum, Q15. */
static unsigned bits_of(uint32_t total) {
    return 32 - glint_leading_zeros(total >> 15);
}

/* Bits of the largest sum of channels, highlights included. Where surfaces have colours, these hold ambient light. */
static unsigned find_sum_bits(const glint_frame *frame, const glint_shading *shading) {
    return bits_of(find_total(frame, shading, has_surface(frame, shading->material)) << 3);
}

/* Of many weak lights shares add up to more than channels do: a chroma of some of them keeps sums within these bits. */
static void gather_shares(const glint_shading *shading, glint_light_terms *terms) {
    uint32_t total = 0;
    for (uint32_t i = 0; shading->lights >> i; i++)
        total += shading->lights >> i & 1 ? (uint32_t)terms->share[i] : 0;
    const unsigned bits = bits_of(total), up = bits > terms->sum_bits ? bits - terms->sum_bits : 0;
    for (uint32_t i = 0; shading->lights >> i && up; i++)
        terms->share[i] >>= up;
    for (int c = 0; c < 3; c++)
        terms->chroma[c] *= 1 << up;
}

/* How light and gloss become colours: those of surfaces without colours of their own. */
static void set_mix(const glint_material *material, glint_light_terms *terms) {
    glint_mix *const mix = &terms->mix;
    mix->has_least = (material->flags & GLINT_MATERIAL_MAX) != 0;
    for (int c = 0; c < 3; c++) {
        mix->least[c] = terms->ambient[c] + terms->half[c];
        mix->base[c] = mix->has_least ? terms->half[c] : mix->least[c];
        mix->light[c] = terms->chroma[c] << terms->sum_bits;
    }
}

/* What need not show of a highlight: 1/8 of a level, Q8. Of all together it is twice that. */
#define FAINT 32

/* The levels that decide on where highlights end, Q8: of the brightest, or half of all if they lie in one place. */
static uint32_t find_lobe_levels(const glint_frame *frame, const glint_shading *shading,
                                 const glint_light_terms *terms) {
    uint32_t brightest = 0, all = 0;
    for (uint32_t i = 0; i < frame->scene->light_count; i++) {
        const uint32_t one = shading->has_specular >> i & 1 ? terms->specular_levels[i] : 0;
        brightest = one > brightest ? one : brightest;
        all += one;
    }
    return brightest > all / 2 ? brightest : all / 2;
}

/* sin^2 where highlights of so many levels fall below what need not show, Q30; 0 where none shows. */
static uint32_t find_lobe_cut(uint32_t levels, glint_q16 shininess) {
    if (levels <= FAINT)
        return 0;
    const int64_t faint = glint_log2(FAINT << 10) - (int64_t)glint_log2(levels << 10); /* Q26 */
    return (1u << 30) - glint_exp2((int32_t)((2 * faint * (1 << 16)) / shininess));
}

/* x^p, Q30, of x from 1/2 to 1 at interval i's start, or at the last's end beyond that. */
static int32_t power_at(uint32_t i, int32_t exponent) {
    const uint32_t last = i < GLINT_COSINE_HALF ? i : GLINT_COSINE_HALF;
    return (int32_t)glint_power((1u << 30) + last * ((1u << 30) / GLINT_COSINE_HALF), exponent);
}

/* Powers of the cosine. A chord lies above or below a curve by an eighth of its bend: nodes share half of it. */
static void fill_cosine(uint16_t cosine[GLINT_COSINE_VALUES], int32_t exponent) {
    int32_t before = 0, here = power_at(0, exponent);
    for (uint32_t i = 0; i <= GLINT_COSINE_HALF; i++) {
        const int32_t next = power_at(i + 1, exponent);
        const int32_t bend = i > 0 && i < GLINT_COSINE_HALF ? (before - here) + (next - here) : 0;
        cosine[i] = (uint16_t)((here - bend / 16 + (1 << 14)) >> 15);
        before = here;
        here = next;
    }
    for (uint32_t i = 0; i < 31; i++)
        cosine[GLINT_COSINE_HALF + 1 + i] = (uint16_t)((glint_power(1u << 31 >> i, exponent) + (1u << 14)) >> 15);
}

/* 1.12 sqrt(p), Q4, of p in Q16.16, from 3 on. */
static uint32_t find_lobe_spread(int32_t shininess) {
    if (shininess < 3 * GLINT_ONE)
        return 0;
    return (glint_square_root((uint32_t)shininess) * 287 >> 12) + 1;
}

static void set_lobes(const glint_frame *frame, const glint_shading *shading, glint_light_terms *terms) {
    terms->lobe_is_wide = shading->shininess < WIDE;
    terms->spread = find_lobe_spread(shading->shininess);
    terms->lobe_has_strip = shading->shininess < GLINT_ONE && shading->shininess;
    if (terms->lobe_is_wide) {
        terms->lobes = shading->has_specular;
        terms->lobe_shift = terms->lobe_end = 0;
        terms->lobe_cut = terms->lobe_diagonal = terms->crest = 0;
        fill_cosine(terms->cosine, shading->shininess);
        terms->slope =
            (uint32_t)glint_most(shading->shininess, 2 * GLINT_ONE) / 384; /* 2/3 of p: of 0.041 it makes 0.0275 */
        return;
    }
    const uint32_t cut = find_lobe_cut(find_lobe_levels(frame, shading, terms), shading->shininess);
    const unsigned bits = 32 - glint_leading_zeros(cut);
    terms->lobes = cut ? shading->has_specular : 0;
    terms->lobe_shift = bits < LOBE_BITS + 2 ? (LOBE_BITS + 2 - bits) / 2 : 0;
    terms->lobe_end = cut >> 2 << 2 * terms->lobe_shift;
    terms->lobe_cut = (int32_t)glint_square_root(terms->lobe_end) + 2;
    terms->lobe_diagonal = (terms->lobe_cut * 23171 >> 14) + 1;
    terms->slope = glint_highlight_slope(shading->shininess);
    const uint32_t crest = glint_square_root(((uint64_t)1 << 44) / (uint32_t)shading->shininess) + 1; /* Q14 */
    terms->crest = (int32_t)(crest << terms->lobe_shift);
}

/* Where a vertex keeps what: terms.c. */
static void place_numbers(const glint_frame *frame, const glint_shading *shading, glint_light_terms *terms) {
    uint32_t at = terms->channels + GLINT_KEPT;
    terms->shown = terms->placed = terms->cones = 0;
    for (uint32_t i = 0; i < frame->scene->light_count; i++) {
        const glint_light_type *type = frame->scene->lights[i].type;
        const uint32_t side = shading->lights >> i & 1, lobe = terms->lobes >> i & 1;
        const uint32_t has_cone = side && type->has_cone, has_position = type->illuminate != 0,
                       has_strength = side & has_position, is_near = side & (has_position | lobe);
        const uint32_t kept = side << GLINT_SIDE | has_cone << GLINT_CONE | has_strength << GLINT_STRENGTH |
                              lobe << GLINT_LOBE_X | (lobe & (uint32_t)!terms->lobe_is_wide) << GLINT_LOBE_Y |
                              is_near << GLINT_NEARNESS;
        terms->shown += side;
        terms->placed |= (uint32_t)(type->illuminate != 0) << i;
        terms->cones |= (uint32_t)(type->has_cone != 0) << i;
        for (uint32_t kind = 0; kind < GLINT_NUMBERS; kind++) {
            terms->at[i][kind] = (uint8_t)(kept >> kind & 1 ? at : 0);
            at += kept >> kind & 1;
        }
    }
    terms->stride = at;
}

/* Is an object of the material lit at nodes, but for those that fast lighting serves? */
static int is_wanted(const glint_frame *frame, const glint_material *material) {
    const glint_fast *fast = frame->config.format->fast;
    for (uint32_t i = 0; i < frame->scene->object_count; i++) {
        const glint_object *object = &frame->scene->objects[i];
        if (object->material == material && object->evaluation && object->evaluation->nodes &&
            (!fast || !fast->serves(frame, object)))
            return 1;
    }
    return 0;
}

/* Can the material's light be held in sums, below 15? */
static int fits(const glint_shading *shading, uint32_t total) {
    const glint_model *model = shading->material->model;
    return (model->lobe != GLINT_LOBE_OTHER || !model->light) && total < 15 << 12;
}

/* Has a light that shows a position? Bounds know no such light whose rays are not the eye's. */
static int has_placed_light(const glint_frame *frame, const glint_shading *shading) {
    for (uint32_t i = 0; shading->lights >> i; i++)
        if (shading->lights >> i & 1 && frame->scene->lights[i].type->illuminate)
            return 1;
    return 0;
}

static int find_light_terms(const glint_frame *frame, const glint_shading *shading, glint_light_terms *terms) {
    const uint32_t total = find_total(frame, shading, 0); /* ambient light has no error */
    if (!is_wanted(frame, shading->material) || !fits(shading, find_total(frame, shading, 1)) ||
        (frame->view->is_parallel && has_placed_light(frame, shading)))
        return 0;
    terms->pixel = (uint32_t)(((uint64_t)1 << 39) / (uint32_t)frame->view->focal);
    set_weights(frame, shading, terms);
    const int is_mono =
        find_chroma(shading->lights, (const uint16_t(*)[3])terms->diffuse, terms->chroma, terms->share) &&
        find_chroma(shading->has_specular, (const uint16_t(*)[3])terms->specular, terms->mix.gloss, terms->gloss_share);
    terms->channels = is_mono ? 1 : 3;
    terms->sum_bits = find_sum_bits(frame, shading);
    if (terms->channels == 1)
        gather_shares(shading, terms);
    set_mix(shading->material, terms);
    set_lobes(frame, shading, terms);
    terms->limit = LIMIT * (uint32_t)glint_least(glint_most((int32_t)total, 1 << 12), MOST_WEIGHT << 12) >> 12;
    terms->most = (uint32_t)glint_least(2 * (int32_t)terms->limit, MOST_OF_QUADRATICS);
    terms->most_of_sums = (uint32_t)glint_least((int32_t)terms->most, MOST_OF_SUMS);
    terms->most_of_one = (uint32_t)glint_least((int32_t)terms->most, MOST_OF_ONE);
    place_numbers(frame, shading, terms);
    return 1;
}

size_t glint_terms_measure(const glint_frame *frame, const glint_shading *shading) {
    glint_light_terms terms;
    return find_light_terms(frame, shading, &terms) ? terms.stride * sizeof(int16_t) : 0;
}

glint_status glint_terms_prepare(glint_frame *frame) {
    glint_shading *const shadings = (glint_shading *)frame->shading;
    size_t most = 0;
    for (uint32_t i = 0; i < frame->shading_count; i++) {
        glint_shading *shading = &shadings[i];
        shading->terms = 0;
        shading->node_size = 0;
        const size_t before = frame->memory.low;
        glint_light_terms *terms = glint_take(&frame->memory, sizeof *terms);
        if (!terms)
            return GLINT_ERROR_ARENA;
        if (!find_light_terms(frame, shading, terms)) {
            frame->memory.low = before;
            continue;
        }
        shading->terms = terms;
        shading->node_size = terms->stride * sizeof(int16_t);
        most = shading->node_size > most ? shading->node_size : most;
    }
    frame->least_room += GLINT_ALIGNED(3 * most);
    return GLINT_OK;
}
