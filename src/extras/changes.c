/* SPDX-License-Identifier: MIT */
/* This flush leaves out tiles that are, pixel for pixel, as they were sent last. Parts of tiles are always sent. */
#include "../frame/frame.h"

/* Computes two independent sums of 32 bits. Each step is one to one, so that tiles that differ in a single word never
 * agree. The multipliers are those of xxHash (Collet, 2012). */
static glint_tile_signature sign(const glint_word *words, size_t count) {
    uint32_t a = 0, b = 0, first = 0x9e3779b1u, second = 0x85ebca77u;
    GLINT_OPAQUE(first); /* gcc would make shifts and sums of them for ARMv6-M, 15 instructions a product */
    GLINT_OPAQUE(second);
    for (const glint_word *end = words + count; words < end; words++) {
        a = (a ^ *words) * first;
        a ^= a >> 16;
        b = (b + *words) * second;
        b ^= b >> 15;
    }
    return (glint_tile_signature){a, b | 1}; /* no tile that has not been sent has this signature */
}

/* Is a rectangle all that the screen shows of a tile? */
static int is_whole(const glint_change_filter *filter, int x, int y, int width, int height) {
    return x % filter->tile_width == 0 && y % filter->tile_height == 0 &&
           width == glint_least(filter->tile_width, filter->width - x) &&
           height == glint_least(filter->tile_height, filter->height - y);
}

static int begin_changes(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    glint_change_filter *filter = context;
    const int of_x = x - filter->left, of_y = y - filter->top;
    const uint32_t tile = (uint32_t)of_y / filter->tile_height * filter->columns + (uint32_t)of_x / filter->tile_width;
    glint_tile_signature *last = &filter->signatures[tile];
    if (!is_whole(filter, of_x, of_y, width, height)) {
        *last = (glint_tile_signature){0, 0};
        filter->sending = 0;
        filter->is_part = 1;
        const int failed = filter->flush.begin(filter->flush.context, x, y, width, height, pixels, stride);
        filter->sent += !failed;
        return failed;
    }
    filter->is_part = 0;
    const glint_tile_signature now = sign(pixels, stride * filter->tile_height / sizeof(glint_word));
    if (now.a == last->a && now.b == last->b) {
        filter->unchanged++;
        return 0;
    }
    filter->sending = last;
    *last = (glint_tile_signature){0, 0}; /* this stays until the tile is sent */
    int failed = filter->flush.begin(filter->flush.context, x, y, width, height, pixels, stride);
    if (!failed && filter->flush.wait)
        filter->pending = now;
    else if (!failed)
        *last = now;
    if (failed || !filter->flush.wait)
        filter->sending = 0;
    filter->sent += !failed;
    return failed;
}

static int wait_for_changes(void *context) {
    glint_change_filter *filter = context;
    if (!filter->sending)
        return filter->is_part ? filter->flush.wait(filter->flush.context) : 0;
    int failed = filter->flush.wait(filter->flush.context);
    if (!failed)
        *filter->sending = filter->pending;
    filter->sending = 0;
    return failed;
}

uint32_t glint_tile_signature_count(const glint_config *config) {
    if (!config)
        return 0;
    glint_config full = *config;
    if (glint_check_config(&full) != GLINT_OK)
        return 0;
    return (uint32_t)((full.width + full.tile_width - 1) / full.tile_width) *
           (uint32_t)((full.height + full.tile_height - 1) / full.tile_height);
}

glint_status glint_change_filter_init(glint_change_filter *filter, glint_tile_signature *signatures,
                                      const glint_config *config) {
    if (!filter)
        return GLINT_ERROR_NULL;
    *filter = (glint_change_filter){0};
    if (!signatures || !config || !config->flush.begin)
        return GLINT_ERROR_NULL;
    glint_config full = *config;
    glint_status status = glint_check_config(&full);
    if (status != GLINT_OK)
        return status;
    *filter = (glint_change_filter){.flush = full.flush,
                                    .signatures = signatures,
                                    .columns = (uint16_t)((full.width + full.tile_width - 1) / full.tile_width),
                                    .tile_width = full.tile_width,
                                    .tile_height = full.tile_height,
                                    .width = full.width,
                                    .height = full.height,
                                    .left = full.left,
                                    .top = full.top,
                                    .count = glint_tile_signature_count(&full)};
    glint_change_filter_forget(filter);
    return GLINT_OK;
}

void glint_change_filter_forget(glint_change_filter *filter) {
    for (uint32_t i = 0; i < filter->count; i++)
        filter->signatures[i] = (glint_tile_signature){0, 0};
}

glint_flush glint_change_filter_flush(glint_change_filter *filter) {
    if (!filter->flush.begin)
        return (glint_flush){0, 0, 0};
    return (glint_flush){begin_changes, filter->flush.wait ? wait_for_changes : 0, filter};
}
