/* SPDX-License-Identifier: MIT */
/* Changes: a flush that leaves out tiles which are, pixel for pixel, what was sent last; parts of tiles are sent. */
#include "../math/numeric.h"
#include "../scene/config.h"
#include "arena.h"

/*
 * Two independent sums of 32 bits, each step of which is one to one, so that tiles that differ in a single word never
 * agree. Multipliers of xxHash (Collet, 2012).
 */
static glint_signature sign(const glint_word *words, size_t count) {
    uint32_t a = 0, b = 0, first = 0x9e3779b1u, second = 0x85ebca77u;
    GLINT_OPAQUE(first); /* for ARMv6-M gcc would make shifts and sums of them, 15 instructions a product */
    GLINT_OPAQUE(second);
    for (const glint_word *end = words + count; words < end; words++) {
        a = (a ^ *words) * first;
        a ^= a >> 16;
        b = (b + *words) * second;
        b ^= b >> 15;
    }
    return (glint_signature){a, b | 1}; /* never that of a tile not sent yet */
}

/* Is it all that the screen shows of a tile? */
static int is_whole(const glint_changes *changes, int x, int y, int width, int height) {
    return x % changes->tile_width == 0 && y % changes->tile_height == 0 &&
           width == glint_least(changes->tile_width, changes->width - x) &&
           height == glint_least(changes->tile_height, changes->height - y);
}

static int begin_changes(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    glint_changes *changes = context;
    const int of_x = x - changes->left, of_y = y - changes->top;
    const uint32_t tile =
        (uint32_t)of_y / changes->tile_height * changes->columns + (uint32_t)of_x / changes->tile_width;
    glint_signature *last = &changes->signatures[tile];
    if (!is_whole(changes, of_x, of_y, width, height)) {
        *last = (glint_signature){0, 0};
        changes->sending = 0;
        changes->is_part = 1;
        const int failed = changes->flush.begin(changes->flush.context, x, y, width, height, pixels, stride);
        changes->sent += !failed;
        return failed;
    }
    changes->is_part = 0;
    const glint_signature now = sign(pixels, stride * changes->tile_height / sizeof(glint_word));
    if (now.a == last->a && now.b == last->b) {
        changes->unchanged++;
        return 0;
    }
    changes->sending = last;
    *last = (glint_signature){0, 0}; /* until it is sent */
    int failed = changes->flush.begin(changes->flush.context, x, y, width, height, pixels, stride);
    if (!failed && changes->flush.wait)
        changes->pending = now;
    else if (!failed)
        *last = now;
    if (failed || !changes->flush.wait)
        changes->sending = 0;
    changes->sent += !failed;
    return failed;
}

static int wait_for_changes(void *context) {
    glint_changes *changes = context;
    if (!changes->sending)
        return changes->is_part ? changes->flush.wait(changes->flush.context) : 0;
    int failed = changes->flush.wait(changes->flush.context);
    if (!failed)
        *changes->sending = changes->pending;
    changes->sending = 0;
    return failed;
}

uint32_t glint_changes_count(const glint_config *config) {
    if (!config)
        return 0;
    glint_config full = *config;
    if (glint_check_config(&full) != GLINT_OK)
        return 0;
    return (uint32_t)((full.width + full.tile_width - 1) / full.tile_width) *
           (uint32_t)((full.height + full.tile_height - 1) / full.tile_height);
}

glint_status glint_changes_init(glint_changes *changes, glint_signature *signatures, const glint_config *config) {
    if (!changes)
        return GLINT_ERROR_NULL;
    *changes = (glint_changes){0};
    if (!signatures || !config || !config->flush.begin)
        return GLINT_ERROR_NULL;
    glint_config full = *config;
    glint_status status = glint_check_config(&full);
    if (status != GLINT_OK)
        return status;
    *changes = (glint_changes){.flush = full.flush,
                               .signatures = signatures,
                               .columns = (uint16_t)((full.width + full.tile_width - 1) / full.tile_width),
                               .tile_width = full.tile_width,
                               .tile_height = full.tile_height,
                               .width = full.width,
                               .height = full.height,
                               .left = full.left,
                               .top = full.top,
                               .count = glint_changes_count(&full)};
    glint_changes_forget(changes);
    return GLINT_OK;
}

void glint_changes_forget(glint_changes *changes) {
    for (uint32_t i = 0; i < changes->count; i++)
        changes->signatures[i] = (glint_signature){0, 0};
}

glint_flush glint_changes_flush(glint_changes *changes) {
    if (!changes->flush.begin)
        return (glint_flush){0, 0, 0};
    return (glint_flush){begin_changes, changes->flush.wait ? wait_for_changes : 0, changes};
}
