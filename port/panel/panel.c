/* SPDX-License-Identifier: MIT */
#include "panel.h"

static int is_turned(const glint_panel *panel) {
    return panel->rotation == GLINT_PANEL_90 || panel->rotation == GLINT_PANEL_270;
}

/* ---- The picture ------------------------------------------------------------------------------------------------ */

uint16_t glint_panel_width(const glint_panel *panel) {
    return is_turned(panel) ? panel->type->height : panel->type->width;
}

uint16_t glint_panel_height(const glint_panel *panel) {
    return is_turned(panel) ? panel->type->width : panel->type->height;
}

const glint_format *glint_panel_format(const glint_panel *panel) {
    if (panel->format) {
        return panel->format;
    }
    return is_turned(panel) && panel->type->format_turned ? panel->type->format_turned : panel->type->format;
}

unsigned glint_panel_pixel_bits(const glint_panel *panel) {
    return (unsigned)glint_row_bytes(glint_panel_format(panel), 8); /* bytes of 8 pixels */
}

/* Turned by a quarter, the picture's x runs down the glass and its y to the left. */
glint_panel_axes glint_panel_find_axes(const glint_panel *panel) {
    const glint_panel_type *type = panel->type;
    const unsigned turns_x = panel->rotation == GLINT_PANEL_90 || panel->rotation == GLINT_PANEL_180;
    const unsigned turns_y = panel->rotation == GLINT_PANEL_180 || panel->rotation == GLINT_PANEL_270;
    glint_panel_axes axes;
    uint16_t column, row;

    axes.exchanged = (uint8_t)is_turned(panel);
    axes.mirror_x = (uint8_t)(((type->glass & GLINT_PANEL_MIRRORED_X) != 0) ^ turns_x);
    axes.mirror_y = (uint8_t)(((type->glass & GLINT_PANEL_MIRRORED_Y) != 0) ^ turns_y);
    column = (uint16_t)(axes.mirror_x ? type->memory_width - type->left - type->width : type->left);
    row = (uint16_t)(axes.mirror_y ? type->memory_height - type->top - type->height : type->top);
    axes.first_x = axes.exchanged ? row : column;
    axes.first_y = axes.exchanged ? column : row;
    return axes;
}

/* ---- Start ------------------------------------------------------------------------------------------------------ */

glint_status glint_panel_send(const glint_panel *panel, const uint8_t *bytes, size_t count) {
    const glint_bus *bus = panel->bus;
    glint_status status;

    if (panel->type->family->parameters_are_commands || count == 1) {
        return bus->command(bus->context, bytes, count);
    }
    status = bus->command(bus->context, bytes, 1);
    return status ? status : bus->data(bus->context, bytes + 1, count - 1);
}

static glint_status send_sequence(const glint_panel *panel, const uint8_t *step) {
    glint_status status = GLINT_OK;

    while (*step != GLINT_PANEL_END && !status) {
        const size_t count = *step++;
        if (count & 128u) {
            panel->bus->delay(panel->bus->context, *step++);
        } else {
            status = glint_panel_send(panel, step, count);
            step += count;
        }
    }
    return status;
}

static glint_status reset(const glint_panel *panel) {
    const glint_bus *bus = panel->bus;

    if (bus->reset) {
        bus->reset(bus->context, 1);
        bus->delay(bus->context, panel->type->reset_low_ms);
        bus->reset(bus->context, 0);
    }
    bus->delay(bus->context, panel->type->reset_wait_ms);
    return bus->reset ? GLINT_OK : send_sequence(panel, panel->type->family->recover);
}

static glint_status check(const glint_panel *panel) {
    const glint_panel_type *type = panel->type;
    const unsigned bits = glint_panel_pixel_bits(panel);

    if (panel->rotation != GLINT_PANEL_0 && (type->glass & GLINT_PANEL_UPRIGHT)) {
        return GLINT_ERROR_ROTATION;
    }
    if ((bits != type->bits[0] && bits != type->bits[1] && bits != type->bits[2]) ||
        (panel->has_words && (bits != 16 || !panel->bus->begin_words))) {
        return GLINT_ERROR_FORMAT;
    }
    return GLINT_OK;
}

glint_status glint_panel_start(const glint_panel *panel) {
    const glint_bus *bus = panel->bus;
    glint_status status = check(panel);

    if (!status) {
        status = reset(panel);
    }
    if (!status) {
        status = send_sequence(panel, panel->type->start);
    }
    if (!status) {
        status = panel->type->family->set_up(panel);
    }
    if (!status && bus->backlight) {
        bus->backlight(bus->context, 1);
    }
    return status;
}

/* ---- Pixels ----------------------------------------------------------------------------------------------------- */

/* Distance of `centre` from a span of `count` pixels from `first` on, both in half pixels; 0 inside. */
static int32_t distance(int32_t centre, int first, int count) {
    const int32_t low = 2 * first + 1, high = 2 * (first + count) - 1;

    return centre < low ? low - centre : centre > high ? centre - high : 0;
}

int glint_panel_shows(const glint_panel *panel, int x, int y, int width, int height) {
    const int32_t radius = panel->type->width; /* in half pixels, and where the centre is */
    int32_t across, down;

    if (!(panel->type->glass & GLINT_PANEL_ROUND)) {
        return 1;
    }
    across = distance(radius, x, width);
    down = distance(radius, y, height);
    return across * across + down * down <= radius * radius;
}

/* Pages of the picture lie along its rows as long as it is not turned by a quarter. */
static int has_pages(const glint_panel *panel) {
    return (panel->type->glass & GLINT_PANEL_PAGES) && !is_turned(panel);
}

/* Pixels that whole bytes hold. */
static int bytes_step(const glint_panel *panel) {
    const unsigned bits = glint_panel_pixel_bits(panel);

    return has_pages(panel) || bits % 8 == 0 ? 1 : bits == 1 ? 8 : 2;
}

static int window_fits(const glint_panel *panel, int x, int y, int width, int height) {
    const int step = bytes_step(panel), line = has_pages(panel) ? 8 : 1;

    return x >= 0 && y >= 0 && width > 0 && height > 0 && width <= glint_panel_width(panel) - x &&
           height <= glint_panel_height(panel) - y && x % step == 0 && y % line == 0 && height % line == 0;
}

/*
 * Columns to send so that rows are whole bytes: at the right edge of a glass of odd width, a column more, which the
 * memory has and the glass does not show. 0 when there is none.
 */
static int whole_width(const glint_panel *panel, int x, int width) {
    const glint_panel_type *type = panel->type;
    const int step = bytes_step(panel), whole = (width + step - 1) / step * step;
    const int memory = is_turned(panel) ? type->memory_height : type->memory_width;
    const int is_edge = x + width == glint_panel_width(panel);

    return whole == width || (is_edge && glint_panel_find_axes(panel).first_x + x + whole <= memory) ? whole : 0;
}

glint_status glint_panel_begin(const glint_panel *panel, int x, int y, int width, int height, const void *pixels,
                               size_t stride) {
    const glint_bus *bus = panel->bus;
    const int whole = window_fits(panel, x, y, width, height) ? whole_width(panel, x, width) : 0;
    glint_status status;

    if (whole == 0) {
        return GLINT_ERROR_REGION;
    }
    if (!glint_panel_shows(panel, x, y, width, height)) {
        return GLINT_OK;
    }
    if (panel->type->family->send_pages) {
        return panel->type->family->send_pages(panel, x, y, whole, height, pixels, stride);
    }
    status = panel->type->family->window(panel, x, y, x + whole - 1, y + height - 1);
    if (status) {
        return status;
    }
    if (has_pages(panel)) {
        return bus->begin(bus->context, pixels, (size_t)width, (size_t)height / 8, 8 * stride);
    }
    return (panel->has_words ? bus->begin_words : bus->begin)(
        bus->context, pixels, glint_row_bytes(glint_panel_format(panel), (uint32_t)whole), (size_t)height, stride);
}

glint_status glint_panel_wait(const glint_panel *panel) {
    return panel->bus->wait ? panel->bus->wait(panel->bus->context) : GLINT_OK;
}

static int flush_begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    return glint_panel_begin(context, x, y, width, height, pixels, stride);
}

static int flush_wait(void *context) {
    return glint_panel_wait(context);
}

glint_flush glint_panel_flush(const glint_panel *panel) {
    glint_flush flush = {flush_begin, flush_wait, NULL};

    flush.context = (void *)(uintptr_t)panel; /* the callbacks take it back as const */
    return flush;
}
