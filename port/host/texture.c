/* SPDX-License-Identifier: MIT */
/**
 * @file texture.c
 * Pictures into textures: sizes by a box filter, palettes by median cut (Heckbert, 1982), refined by Lloyd's rounds.
 */
#include "texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Colours of RGB565. */
#define CELLS 65536

/** A hole's texel of RGB565, which no other texel has. */
#define KEY_RGB565 0xF81Fu

/** Rounds of Lloyd's: each moves the colours of a palette to the means of what is nearest to them. */
#define LLOYD_ROUNDS 4

#define NO_CODE UINT16_MAX

const char *const texture_type_names[] = {"auto", "rgb565", "grey8", "palette256", "palette16", NULL};

/** A picture's texels, and how they are stored. */
typedef struct texture_coder {
    const host_picture *picture;
    size_t count;
    double cutoff;
    bool has_holes;
    texture_type type;
    uint32_t *weights;     /* texels of each colour of RGB565 */
    uint16_t palette[256]; /* of so many colours */
    uint32_t colours;
    uint16_t *nearest; /* of each colour of RGB565 its number in the palette, or NO_CODE */
} texture_coder;

/* ---- Sizes ------------------------------------------------------------------------------------------------------ */

/** Returns the power of two that is nearest to a side by its ratio. */
static uint32_t nearest_power(uint32_t side) {
    uint32_t power = 1;
    while (2 * power * power <= side * side) {
        power *= 2;
    }
    return power;
}

/** Computes a texel: the mean of a rectangle of the picture, colours weighing by their alpha. */
static void average(const host_picture *from, const double low[2], const double high[2], uint8_t to[4]) {
    double sums[4] = {0, 0, 0, 0};
    double area = 0;
    for (uint32_t y = (uint32_t)low[1]; y < from->height && y < high[1]; y++) {
        const double rows = fmin(high[1], y + 1.0) - fmax(low[1], y);
        for (uint32_t x = (uint32_t)low[0]; x < from->width && x < high[0]; x++) {
            const uint8_t *pixel = from->pixels[(size_t)y * from->width + x];
            const double weight = rows * (fmin(high[0], x + 1.0) - fmax(low[0], x));
            area += weight;
            sums[3] += weight * pixel[3];
            for (int i = 0; i < 3; i++) {
                sums[i] += weight * pixel[3] * pixel[i];
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        to[i] = (uint8_t)(sums[3] > 0 ? lround(sums[i] / sums[3]) : 0);
    }
    to[3] = (uint8_t)(area > 0 ? lround(sums[3] / area) : 0);
}

/** Makes a picture of another size; without a cutoff alpha is left out. The caller frees its pixels. */
static host_picture resample(const host_picture *picture, double cutoff, uint32_t width, uint32_t height) {
    host_picture to = {memory_new((size_t)width * height, sizeof *to.pixels), width, height};
    const size_t count = (size_t)picture->width * picture->height;
    for (size_t i = 0; !(cutoff > 0) && i < count; i++) {
        picture->pixels[i][3] = 255;
    }
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            const double step[2] = {(double)picture->width / width, (double)picture->height / height};
            const double low[2] = {x * step[0], y * step[1]};
            const double high[2] = {(x + 1) * step[0], (y + 1) * step[1]};
            average(picture, low, high, to.pixels[(size_t)y * width + x]);
        }
    }
    return to;
}

/* ---- Colours ---------------------------------------------------------------------------------------------------- */

static uint16_t to_565(const int colour[3]) {
    static const int full[3] = {31, 63, 31};
    uint32_t levels[3];
    for (int i = 0; i < 3; i++) {
        levels[i] = (uint32_t)((colour[i] * full[i] + 127) / 255);
    }
    return (uint16_t)(levels[0] << 11 | levels[1] << 5 | levels[2]);
}

/** Finds the levels, from 0 to 255, that the library gives a colour. */
static void from_565(uint32_t colour, int levels[3]) {
    const uint32_t red = colour >> 11;
    const uint32_t green = colour >> 5 & 63;
    const uint32_t blue = colour & 31;
    levels[0] = (int)(red << 3 | red >> 2);
    levels[1] = (int)(green << 2 | green >> 4);
    levels[2] = (int)(blue << 3 | blue >> 2);
}

static bool is_hole(const texture_coder *coder, size_t texel) {
    return coder->picture->pixels[texel][3] < 255 * coder->cutoff;
}

static void colour_of(const texture_coder *coder, size_t texel, int colour[3]) {
    for (int i = 0; i < 3; i++) {
        colour[i] = coder->picture->pixels[texel][i];
    }
}

/** Weighs the colours of all texels that are no holes. */
static void weigh(texture_coder *coder) {
    coder->weights = memory_new(CELLS, sizeof *coder->weights);
    coder->nearest = memory_new(CELLS, sizeof *coder->nearest);
    for (size_t i = 0; i < coder->count; i++) {
        int colour[3];
        colour_of(coder, i, colour);
        if (is_hole(coder, i)) {
            coder->has_holes = true;
        } else {
            coder->weights[to_565(colour)]++;
        }
    }
}

/* ---- Palettes --------------------------------------------------------------------------------------------------- */

/** A box of colours, part of a list. */
typedef struct colour_box {
    size_t first, end;
    double spread; /* sum of squared distances from the mean along the axis where that is largest */
    int axis;
    double mean[3];
} colour_box;

static void measure_box(const texture_coder *coder, const uint16_t *list, colour_box *box) {
    double weights = 0;
    double sums[3] = {0, 0, 0};
    double squares[3] = {0, 0, 0};
    for (size_t i = box->first; i < box->end; i++) {
        const double weight = coder->weights[list[i]];
        int levels[3];
        from_565(list[i], levels);
        weights += weight;
        for (int axis = 0; axis < 3; axis++) {
            sums[axis] += weight * levels[axis];
            squares[axis] += weight * levels[axis] * levels[axis];
        }
    }
    box->spread = 0;
    for (int axis = 0; axis < 3; axis++) {
        box->mean[axis] = sums[axis] / weights;
        const double spread = squares[axis] - sums[axis] * box->mean[axis];
        if (box->end - box->first > 1 && spread > box->spread) {
            box->spread = spread;
            box->axis = axis;
        }
    }
}

/** Finds the level that parts a box at the median of its texels, so that both parts have colours. */
static int find_cut(const texture_coder *coder, const uint16_t *list, const colour_box *box) {
    uint32_t weights[256] = {0};
    uint32_t all = 0;
    int edge[3];
    from_565(list[box->first], edge);
    int low = edge[box->axis];
    int high = edge[box->axis];
    for (size_t i = box->first; i < box->end; i++) {
        int levels[3];
        from_565(list[i], levels);
        const int level = levels[box->axis];
        weights[level] += coder->weights[list[i]];
        all += coder->weights[list[i]];
        low = level < low ? level : low;
        high = level > high ? level : high;
    }
    uint32_t below = weights[low];
    int cut = low + 1;
    while (cut < high && below + weights[cut] <= all / 2) {
        below += weights[cut++];
    }
    return cut;
}

/** Parts a box: what is below the cut stays. */
static void cut_box(const texture_coder *coder, uint16_t *list, colour_box *box, colour_box *upper) {
    const int cut = find_cut(coder, list, box);
    size_t end = box->first;
    *upper = *box;
    for (size_t i = box->first; i < box->end; i++) {
        int levels[3];
        from_565(list[i], levels);
        if (levels[box->axis] < cut) {
            const uint16_t colour = list[i];
            list[i] = list[end];
            list[end++] = colour;
        }
    }
    box->end = upper->first = end;
    measure_box(coder, list, box);
    measure_box(coder, list, upper);
}

static uint16_t round_colour(const double mean[3]) {
    const int colour[3] = {(int)lround(mean[0]), (int)lround(mean[1]), (int)lround(mean[2])};
    return to_565(colour);
}

/** Finds the number of the palette's colour that is nearest to one of RGB565. */
static uint16_t find_nearest(texture_coder *coder, uint16_t colour) {
    int levels[3];
    int least = INT32_MAX;
    from_565(colour, levels);
    if (coder->nearest[colour] != NO_CODE) {
        return coder->nearest[colour];
    }
    for (uint32_t i = 0; i < coder->colours; i++) {
        int other[3];
        int square = 0;
        from_565(coder->palette[i], other);
        for (int axis = 0; axis < 3; axis++) {
            square += (levels[axis] - other[axis]) * (levels[axis] - other[axis]);
        }
        if (square < least) {
            least = square;
            coder->nearest[colour] = (uint16_t)i;
        }
    }
    return coder->nearest[colour];
}

static void forget_nearest(texture_coder *coder) {
    memset(coder->nearest, 0xFF, CELLS * sizeof *coder->nearest);
}

/** Moves each colour of the palette to the mean of those that are nearest to it. */
static void refine(texture_coder *coder, const uint16_t *list, size_t count) {
    double sums[256][4];
    memset(sums, 0, sizeof sums);
    for (size_t i = 0; i < count; i++) {
        double *sum = sums[find_nearest(coder, list[i])];
        int levels[3];
        from_565(list[i], levels);
        sum[3] += coder->weights[list[i]];
        for (int axis = 0; axis < 3; axis++) {
            sum[axis] += (double)coder->weights[list[i]] * levels[axis];
        }
    }
    for (uint32_t i = 0; i < coder->colours; i++) {
        const double mean[3] = {sums[i][0] / sums[i][3], sums[i][1] / sums[i][3], sums[i][2] / sums[i][3]};
        coder->palette[i] = sums[i][3] > 0 ? round_colour(mean) : coder->palette[i];
    }
    forget_nearest(coder);
}

/** Makes a palette of at most `most` colours. */
static void make_palette(texture_coder *coder, uint32_t most) {
    uint16_t *list = memory_new(CELLS, sizeof *list);
    colour_box boxes[256];
    size_t count = 0;
    for (uint32_t i = 0; i < CELLS; i++) {
        if (coder->weights[i] > 0) {
            list[count++] = (uint16_t)i;
        }
    }
    coder->colours = 1;
    boxes[0] = (colour_box){.end = count};
    if (count > 0) {
        measure_box(coder, list, &boxes[0]);
    }
    while (coder->colours < most) {
        uint32_t widest = 0;
        for (uint32_t i = 1; i < coder->colours; i++) {
            widest = boxes[i].spread > boxes[widest].spread ? i : widest;
        }
        if (!(boxes[widest].spread > 0)) {
            break;
        }
        cut_box(coder, list, &boxes[widest], &boxes[coder->colours]);
        coder->colours++;
    }
    memset(coder->palette, 0, sizeof coder->palette);
    for (uint32_t i = 0; i < coder->colours; i++) {
        coder->palette[i] = round_colour(boxes[i].mean);
    }
    forget_nearest(coder);
    for (int i = 0; i < LLOYD_ROUNDS; i++) {
        refine(coder, list, count);
    }
    free(list);
}

/* ---- Codes ------------------------------------------------------------------------------------------------------ */

static uint32_t palette_size(texture_type type) {
    return type == TEXTURE_PALETTE16 ? 16 : type == TEXTURE_PALETTE256 ? 256 : 0;
}

/** Returns the texel that holes have, as it is stored. */
static uint32_t key_of(texture_type type) {
    return type == TEXTURE_RGB565 ? KEY_RGB565 : type == TEXTURE_GREY8 ? 0 : palette_size(type) - 1;
}

/** Finds the texel of a colour, as it is stored, and the levels that it has. */
static uint32_t encode(texture_coder *coder, const int colour[3], int levels[3]) {
    const uint16_t rounded = to_565(colour);
    if (coder->type == TEXTURE_GREY8) {
        const int luma = (299 * colour[0] + 587 * colour[1] + 114 * colour[2] + 500) / 1000; /* ITU-R BT.601 */
        const int least = coder->has_holes ? 1 : 0;
        levels[0] = levels[1] = levels[2] = luma < least ? least : luma;
        return (uint32_t)levels[0];
    }
    if (coder->type == TEXTURE_RGB565) {
        const uint32_t code = coder->has_holes && rounded == KEY_RGB565 ? KEY_RGB565 - 1 : rounded;
        from_565(code, levels);
        return code;
    }
    const uint32_t code = find_nearest(coder, rounded);
    from_565(coder->palette[code], levels);
    return code;
}

static void choose_type(texture_coder *coder, texture_type type) {
    coder->type = type;
    if (palette_size(type) > 0) {
        make_palette(coder, palette_size(type) - (coder->has_holes ? 1 : 0));
    }
}

static double measure_error(texture_coder *coder) {
    double sum = 0;
    size_t seen = 0;
    for (size_t i = 0; i < coder->count; i++) {
        int colour[3];
        int levels[3];
        colour_of(coder, i, colour);
        encode(coder, colour, levels);
        for (int axis = 0; axis < 3 && !is_hole(coder, i); axis++) {
            sum += (colour[axis] - levels[axis]) * (colour[axis] - levels[axis]);
            seen++;
        }
    }
    return seen > 0 ? sum / (double)seen : 0;
}

static size_t size_of(const texture_coder *coder, texture_type type) {
    const size_t bits = type == TEXTURE_RGB565 ? 16 : type == TEXTURE_PALETTE16 ? 4 : 8;
    return (coder->count * bits + 7) / 8 + 2 * (size_t)palette_size(type);
}

/** Chooses the smallest type that is near enough. */
static void choose_smallest(texture_coder *coder) {
    static const texture_type types[] = {TEXTURE_PALETTE16, TEXTURE_GREY8, TEXTURE_PALETTE256};
    texture_type best = TEXTURE_RGB565;
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (size_of(coder, types[i]) < size_of(coder, best)) {
            choose_type(coder, types[i]);
            best = measure_error(coder) <= TEXTURE_ERROR_MAX ? types[i] : best;
        }
    }
    choose_type(coder, best);
}

/** Adds a part of an error to a texel of the row or of the next one. */
static void spread(double (*errors)[3], long x, long width, const double error[3], double part) {
    for (int axis = 0; x >= 0 && x < width && axis < 3; axis++) {
        errors[x][axis] += part * error[axis];
    }
}

/** Finds the codes of all texels, row after row; the caller frees them. */
static uint16_t *encode_all(texture_coder *coder, bool dithers) {
    const long width = (long)coder->picture->width;
    uint16_t *codes = memory_new(coder->count, sizeof *codes);
    double(*here)[3] = memory_new((size_t)width, sizeof *here);
    double(*below)[3] = memory_new((size_t)width, sizeof *below);
    for (size_t i = 0; i < coder->count; i++) {
        const long x = (long)(i % (size_t)width);
        int wanted[3];
        int levels[3];
        double error[3];
        if (x == 0) {
            memcpy(here, below, (size_t)width * sizeof *here);
            memset(below, 0, (size_t)width * sizeof *below);
        }
        if (is_hole(coder, i)) {
            codes[i] = (uint16_t)key_of(coder->type);
            continue;
        }
        for (int axis = 0; axis < 3; axis++) {
            const double sum = coder->picture->pixels[i][axis] + here[x][axis];
            wanted[axis] = (int)lround(fmax(0, fmin(255, sum))); /* else errors add up where no colour is near */
        }
        codes[i] = (uint16_t)encode(coder, wanted, levels);
        for (int axis = 0; axis < 3; axis++) {
            error[axis] = dithers ? wanted[axis] - levels[axis] : 0;
        }
        spread(here, x + 1, width, error, 7.0 / 16);
        spread(below, x - 1, width, error, 3.0 / 16);
        spread(below, x, width, error, 5.0 / 16);
        spread(below, x + 1, width, error, 1.0 / 16);
    }
    free(here);
    free(below);
    return codes;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

/** Packs codes as the type stores them; the caller frees them. */
static const void *pack(const texture_coder *coder, uint16_t *codes) {
    if (coder->type == TEXTURE_RGB565) {
        return codes;
    }
    uint8_t *bytes = memory_new(coder->count, 1);
    for (size_t i = 0; i < coder->count; i++) {
        if (coder->type == TEXTURE_PALETTE16) {
            bytes[i / 2] = (uint8_t)(bytes[i / 2] | codes[i] << (i % 2 == 0 ? 4 : 0));
        } else {
            bytes[i] = (uint8_t)codes[i];
        }
    }
    free(codes);
    return bytes;
}

/** Makes the smaller levels of a texture. */
static void make_levels(texture_coder *coder, const texture_options *options, host_texture *made) {
    const host_picture *whole = coder->picture;
    for (glint_texture *larger = &made->texture; larger->width > 1 || larger->height > 1;) {
        glint_texture *level = &made->levels[made->level_count++];
        *level = *larger;
        level->width = (uint16_t)((larger->width + 1) / 2);
        level->height = (uint16_t)((larger->height + 1) / 2);
        const host_picture texels = resample(whole, coder->cutoff, level->width, level->height);
        coder->picture = &texels;
        coder->count = (size_t)level->width * level->height;
        level->texels = pack(coder, encode_all(coder, options->dither));
        made->size += size_of(coder, coder->type) - 2 * (size_t)palette_size(coder->type);
        coder->picture = whole;
        free(texels.pixels);
        larger->smaller = level;
        larger = level;
    }
}

static host_texture *make_texture(texture_coder *coder, const texture_options *options) {
    static const glint_texture_type *const types[] = {NULL, &glint_texture_rgb565, &glint_texture_grey8,
                                                      &glint_texture_palette256, &glint_texture_palette16};
    host_texture *made = memory_new(1, sizeof *made);
    weigh(coder);
    if (options->type == TEXTURE_AUTO) {
        choose_smallest(coder);
    } else {
        choose_type(coder, options->type);
    }
    made->type = coder->type;
    made->error = measure_error(coder);
    made->size = size_of(coder, coder->type);
    made->cutoff = coder->cutoff;
    made->texture.type = types[coder->type];
    made->texture.width = (uint16_t)coder->picture->width;
    made->texture.height = (uint16_t)coder->picture->height;
    made->texture.texels = pack(coder, encode_all(coder, options->dither));
    if (palette_size(coder->type) > 0) {
        uint16_t *palette = memory_new(palette_size(coder->type), sizeof *palette);
        memcpy(palette, coder->palette, palette_size(coder->type) * sizeof *palette);
        made->texture.palette = palette;
    }
    if (coder->has_holes) {
        made->texture.flags = GLINT_TEXTURE_HAS_KEY;
        made->texture.key = (uint16_t)key_of(coder->type);
    }
    if (options->levels) {
        make_levels(coder, options, made);
    }
    free(coder->weights);
    free(coder->nearest);
    return made;
}

host_texture *texture_make(const host_picture *picture, double cutoff, const texture_options *options) {
    uint32_t width = nearest_power(picture->width);
    uint32_t height = nearest_power(picture->height);
    const uint32_t most = options->side > 0 ? options->side : TEXTURE_SIDE_MAX;
    while (width > most || height > most) {
        width = width > 1 ? width / 2 : 1;
        height = height > 1 ? height / 2 : 1;
    }
    const host_picture texels = resample(picture, cutoff, width, height);
    texture_coder coder = {.picture = &texels, .count = (size_t)width * height, .cutoff = cutoff};
    host_texture *made = make_texture(&coder, options);
    free(texels.pixels);
    return made;
}

void texture_free(host_texture *texture) {
    /* The library sees them as const; they are this module's own. */
    free((void *)(uintptr_t)texture->texture.texels);
    free((void *)(uintptr_t)texture->texture.palette);
    for (size_t i = 0; i < texture->level_count; i++) {
        free((void *)(uintptr_t)texture->levels[i].texels);
    }
    free(texture->name);
    free(texture);
}

size_t texture_items(const glint_texture *texture) {
    const size_t count = (size_t)texture->width * texture->height;
    return texture->type == &glint_texture_palette16 ? (count + 1) / 2 : count;
}
