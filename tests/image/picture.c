/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "bayer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *allocate(size_t size) {
    void *memory = calloc(1, size ? size : 1);
    if (memory == NULL) {
        fputs("out of memory\n", stderr);
        exit(1);
    }
    return memory;
}

/* A page, 8 rows of a byte for each column, takes the place of 8 rows. */
static int is_paged(const picture *image) {
    return picture_undithered(image->format) == &glint_format_mono_pages;
}

picture picture_open(int width, int height, const glint_format *format) {
    picture image = {.width = width, .height = height, .format = format};
    image.stride = glint_row_bytes(format, (uint32_t)width);
    image.size = image.stride * (size_t)(is_paged(&image) ? (height + 7) / 8 * 8 : height);
    image.bytes = allocate(image.size);
    image.sent = allocate((size_t)width * (size_t)height);
    return image;
}

void picture_close(picture *image) {
    free(image->bytes);
    free(image->sent);
    *image = (picture){0};
}

/* Up to 255 times. */
static void count_sent(picture *image, int x, int y) {
    uint8_t *sent = &image->sent[(size_t)y * (size_t)image->width + (size_t)x];
    if (*sent < UINT8_MAX)
        ++*sent;
}

int picture_put(picture *image, const int rectangle[4], const void *pixels, size_t stride) {
    int x = rectangle[0];
    int y = rectangle[1];
    int width = rectangle[2];
    int height = rectangle[3];
    int step = is_paged(image) ? 8 : 1;
    size_t left = is_paged(image) ? (size_t)x : glint_row_bytes(image->format, (uint32_t)x);
    size_t length = is_paged(image) ? (size_t)width : glint_row_bytes(image->format, (uint32_t)width);
    if (x < 0 || y < 0 || width < 1 || height < 1 || x + width > image->width || y + height > image->height)
        return 1;
    for (int row = 0; row < height; row += step) {
        const uint8_t *source = (const uint8_t *)pixels + (size_t)row * stride;
        memcpy(image->bytes + (size_t)(y + row) * image->stride + left, source, length);
    }
    for (int row = 0; row < height; row++)
        for (int column = 0; column < width; column++)
            count_sent(image, x + column, y + row);
    return 0;
}

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const int rectangle[4] = {x, y, width, height};
    picture *const image = context;
    image->calls++;
    return image->sending || picture_put(image, rectangle, pixels, stride);
}

static int begin_only(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const int failed = begin(context, x, y, width, height, pixels, stride);
    ((picture *)context)->sending = 1;
    return failed;
}

static int wait(void *context) {
    picture *const image = context;
    const int failed = !image->sending;
    image->sending = 0;
    return failed;
}

glint_config picture_config(picture *image, const picture_options *options) {
    return (glint_config){
        .width = (uint16_t)image->width,
        .height = (uint16_t)image->height,
        .tile_width = options ? options->tile_width : 0,
        .tile_height = options ? options->tile_height : 0,
        .format = image->format,
        .gamma = options ? options->gamma : NULL,
        .skips_degenerate = options ? options->skips_degenerate : 0,
        .keeps_arena = options ? options->keeps_arena : 0,
        .region = options ? options->region : (glint_rectangle){0, 0, 0, 0},
        .background = options ? options->background : (glint_painter){NULL, NULL},
        .overlay = options ? options->overlay : (glint_painter){NULL, NULL},
        .layers = options ? options->layers : NULL,
        .samples = options ? options->samples : NULL,
        .flush = {options && options->waits ? begin_only : begin, options && options->waits ? wait : NULL, image}};
}

glint_need picture_need(const picture *image, const glint_scene *scene, const picture_options *options) {
    picture unused = *image;
    const glint_config config = picture_config(&unused, options);
    glint_need need;
    const glint_status status = glint_arena_need(&config, scene, &need);
    if (status != GLINT_OK) {
        fprintf(stderr, "no need: %s\n", glint_strerror(status));
        exit(1);
    }
    return need;
}

size_t picture_arena(const glint_need *need, uint32_t share) {
    return need->least + (need->one_pass - need->least) * share / 256;
}

int picture_count_empty(void *context, const glint_tile *tile) {
    uint32_t *const empty = context;
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++)
            *empty += tile->depth[(size_t)y * tile->depth_stride + (size_t)x] == 0;
    return 0;
}

int picture_paint_pattern(void *context, const glint_tile *tile) {
    const picture of = {.format = context};
    const int is_pages = is_paged(&of);
    const size_t left = is_pages ? (size_t)tile->x : glint_row_bytes(of.format, (uint32_t)tile->x),
                 length = is_pages ? (size_t)tile->width : glint_row_bytes(of.format, (uint32_t)tile->width);
    for (int row = 0; row < tile->height; row += is_pages ? 8 : 1)
        for (size_t i = 0; i < length; i++) /* multiplicative hashing (Knuth) */
            ((uint8_t *)tile->pixels)[(size_t)row * tile->stride + i] =
                (uint8_t)(((uint32_t)(left + i) * 40503u + (uint32_t)(tile->y + row) * 2246822519u) * 2654435761u >>
                          24);
    return 0;
}

/* Where the depth of tiles goes, and what else is painted over them. */
typedef struct depths {
    const picture_options *options;
    int width;
} depths;

static int keep_depth(void *context, const glint_tile *tile) {
    const depths *const to = context;
    const glint_painter *const over = &to->options->overlay;
    const int failed = over->paint ? over->paint(over->context, tile) : 0;
    for (int y = 0; y < tile->height; y++)
        memcpy(to->options->depth + (size_t)(tile->y + y) * (size_t)to->width + tile->x,
               tile->depth + (size_t)y * tile->depth_stride, (size_t)tile->width * sizeof *tile->depth);
    return failed;
}

glint_status picture_render(picture *image, const glint_scene *scene, const picture_options *options,
                            glint_stats *stats) {
    glint_config config = picture_config(image, options);
    depths to = {options, image->width};
    glint_renderer renderer;
    glint_need need;
    if (options && options->depth)
        config.overlay = (glint_painter){keep_depth, &to};
    config.arena_size = options ? options->arena_size : 0;
    glint_status status = config.arena_size ? GLINT_OK : glint_arena_need(&config, scene, &need);
    if (status != GLINT_OK)
        return status;
    if (!config.arena_size)
        config.arena_size = need.one_pass;
    const size_t skew = options ? options->skew : 0;
    uint8_t *const memory =
        malloc(config.arena_size + skew); /* its content is undefined: MSan sees what is read of it */
    if (!memory)
        return GLINT_ERROR_NULL;
    config.arena = memory + skew;
    status = glint_init(&renderer, &config);
    if (status == GLINT_OK && options && options->before)
        (void)glint_render(&renderer, options->before); /* it may need more arena */
    for (int frame = 0; frame <= config.keeps_arena && status == GLINT_OK; frame++) {
        memset(image->sent, 0, (size_t)image->width * (size_t)image->height);
        status = glint_render(&renderer, scene);
    }
    if (stats != NULL)
        *stats = renderer.stats;
    free(memory);
    return image->sending ? GLINT_ERROR_FLUSH : status;
}

/* Was each pixel of a region, or of the whole, sent once, and no other? */
static int is_sent_once(const picture *image, const glint_rectangle *part) {
    const int all = part->width == 0;
    for (int i = 0; i < image->width * image->height; i++) {
        const int x = i % image->width - part->x, y = i / image->width - part->y;
        if (image->sent[i] != (all || (x >= 0 && x < part->width && y >= 0 && y < part->height)))
            return 0;
    }
    return 1;
}

int picture_is_complete(const picture *image) {
    return is_sent_once(image, &(glint_rectangle){0, 0, 0, 0});
}

int picture_draws_same(const picture *whole, const glint_scene *scene, const picture_options *options,
                       glint_stats *stats) {
    static const picture_options usual;
    picture again = picture_open(whole->width, whole->height, whole->format);
    options = options ? options : &usual;
    memcpy(again.bytes, whole->bytes, whole->size);
    const int same = picture_render(&again, scene, options, stats) == GLINT_OK &&
                     is_sent_once(&again, &options->region) && picture_equal(&again, whole);
    picture_close(&again);
    return same;
}

int picture_equal(const picture *a, const picture *b) {
    return a->size == b->size && memcmp(a->bytes, b->bytes, a->size) == 0;
}

const glint_format *picture_undithered(const glint_format *format) {
    static const glint_format *const pairs[][2] = {{&glint_format_rgb565_dithered, &glint_format_rgb565},
                                                   {&glint_format_rgb565_be_dithered, &glint_format_rgb565_be},
                                                   {&glint_format_rgb888_dithered, &glint_format_rgb888},
                                                   {&glint_format_grey8_dithered, &glint_format_grey8},
                                                   {&glint_format_grey4_dithered, &glint_format_grey4},
                                                   {&glint_format_rgb444_dithered, &glint_format_rgb444},
                                                   {&glint_format_mono_dithered, &glint_format_mono},
                                                   {&glint_format_mono_pages_dithered, &glint_format_mono_pages}};
    if (format == &glint_format_rgb565 || format == &glint_format_rgb888 ||
        format == &glint_format_grey8) /* asked for each pixel of most suites */
        return format;
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        if (format == pairs[i][0])
            return pairs[i][1];
    }
    return format;
}

double picture_threshold(const glint_format *format, int x, int y) {
    return picture_undithered(format) == format ? 0.5 : bayer_threshold(x, y);
}

static int is_mono(const glint_format *kind) {
    return kind == &glint_format_mono || kind == &glint_format_mono_pages;
}

int picture_channels(const glint_format *format) {
    const glint_format *kind = picture_undithered(format);
    return kind == &glint_format_grey8 || kind == &glint_format_grey4 || is_mono(kind) ? 1 : 3;
}

int picture_level_max(const glint_format *format, int channel) {
    const glint_format *kind = picture_undithered(format);
    if (kind == &glint_format_rgb888 || kind == &glint_format_grey8)
        return 255;
    if (kind == &glint_format_grey4 || kind == &glint_format_rgb444)
        return 15;
    if (is_mono(kind))
        return 1;
    return channel == 1 ? 63 : 31;
}

/* Three channels of 4 bits each, in the order of their bits. */
static int level_of_444(const uint8_t *row, int x, int channel) {
    int nibble = 3 * x + channel;
    return nibble % 2 ? row[nibble / 2] & 15 : row[nibble / 2] >> 4;
}

/* Of 5, 6 and 5 bits. */
static int level_of_565(uint16_t word, int channel) {
    return channel == 0 ? word >> 11 : channel == 1 ? word >> 5 & 63 : word & 31;
}

int picture_level(const picture *image, int x, int y, int channel) {
    const glint_format *kind = picture_undithered(image->format);
    const uint8_t *row = image->bytes + (size_t)y * image->stride;
    uint16_t word = 0;
    if (kind == &glint_format_rgb565) {
        memcpy(&word, row + 2 * x, sizeof word);
        return level_of_565(word, channel);
    }
    if (kind == &glint_format_rgb888)
        return row[3 * x + channel];
    if (kind == &glint_format_grey8)
        return row[x];
    if (kind == &glint_format_grey4)
        return x % 2 ? row[x / 2] & 15 : row[x / 2] >> 4;
    if (kind == &glint_format_rgb444)
        return level_of_444(row, x, channel);
    if (kind == &glint_format_mono_pages)
        return image->bytes[(size_t)(y / 8 * 8) * image->stride + (size_t)x] >> y % 8 & 1;
    if (kind == &glint_format_mono)
        return row[x / 8] >> x % 8 & 1;
    return level_of_565((uint16_t)(row[2 * x] << 8 | row[2 * x + 1]), channel);
}
