/* SPDX-License-Identifier: MIT */
#include "panel.h"

static int send_command(const glint_panel *panel, const uint8_t *bytes, size_t count) {
    const glint_bus *bus = panel->bus;
    int status;

    if (panel->type->family->parameters_are_commands || count == 1) {
        return bus->command(bus->context, bytes, count);
    }
    status = bus->command(bus->context, bytes, 1);
    return status ? status : bus->data(bus->context, bytes + 1, count - 1);
}

static void reset(const glint_panel *panel) {
    const glint_bus *bus = panel->bus;

    if (bus->reset) {
        bus->reset(bus->context, 1);
        bus->delay(bus->context, panel->type->reset_low_ms);
        bus->reset(bus->context, 0);
    }
    bus->delay(bus->context, panel->type->reset_wait_ms);
}

int glint_panel_start(const glint_panel *panel) {
    const glint_bus *bus = panel->bus;
    const uint8_t *step = panel->type->start;

    reset(panel);
    while (*step != GLINT_PANEL_END) {
        const size_t count = *step++;
        if (count & 128u) {
            bus->delay(bus->context, *step++);
        } else {
            const int status = send_command(panel, step, count);
            if (status) {
                return status;
            }
            step += count;
        }
    }
    if (bus->backlight) {
        bus->backlight(bus->context, 1);
    }
    return GLINT_PANEL_OK;
}

static int window_fits(const glint_panel_type *type, int x, int y, int width, int height) {
    const int step = type->pixels_per_byte;

    return x >= 0 && y >= 0 && width > 0 && height > 0 && width <= type->width - x && height <= type->height - y &&
           x % step == 0 && width % step == 0;
}

int glint_panel_begin(const glint_panel *panel, int x, int y, int width, int height, const void *pixels,
                      size_t stride) {
    const glint_panel_type *type = panel->type;
    const glint_bus *bus = panel->bus;
    int status;

    if (!window_fits(type, x, y, width, height)) {
        return GLINT_PANEL_ERROR_WINDOW;
    }
    status = type->family->window(bus, x, y, x + width - 1, y + height - 1);
    if (status) {
        return status;
    }
    return bus->begin(bus->context, pixels, glint_row_bytes(type->format, (uint32_t)width), (size_t)height, stride);
}

int glint_panel_wait(const glint_panel *panel) {
    return panel->bus->wait ? panel->bus->wait(panel->bus->context) : GLINT_PANEL_OK;
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
