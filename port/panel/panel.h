/* SPDX-License-Identifier: MIT */
/**
 * @file panel.h
 * What all panels share: start-up from a const description, and glint's flush callbacks. A panel sends its window, then
 * the pixels in it, and no byte more.
 *
 *     static const glint_panel panel = {&glint_panel_ssd0323, &bus};
 *     glint_panel_start(&panel);
 *     config.width = glint_panel_width(&panel);
 *     config.height = glint_panel_height(&panel);
 *     config.format = glint_panel_format(&panel);
 *     config.flush = glint_panel_flush(&panel);
 *
 * After an error of the bus, glint_panel_start makes the panel ready for the next frame, whatever state it was left in.
 * An error within a frame ends that with GLINT_ERROR_FLUSH, and stands in glint_stats.flush_error.
 */
#ifndef GLINT_PANEL_H
#define GLINT_PANEL_H

#include "bus.h"
#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How far the picture is turned on the glass, clockwise. Width and height change places at 90 and 270. */
typedef enum glint_panel_rotation {
    GLINT_PANEL_0 = 0,
    GLINT_PANEL_90 = 1,
    GLINT_PANEL_180 = 2,
    GLINT_PANEL_270 = 3
} glint_panel_rotation;

/**
 * An element of a start-up sequence, which is a string of bytes: GLINT_PANEL_SEND(n) and n bytes, the command first;
 * GLINT_PANEL_DELAY(ms); and GLINT_PANEL_END.
 */
#define GLINT_PANEL_END 0
#define GLINT_PANEL_SEND(count) (count)                     /**< 1 to 127 bytes. */
#define GLINT_PANEL_DELAY(milliseconds) 128, (milliseconds) /**< 0 to 255 ms. */

typedef struct glint_panel glint_panel;

/** What panels of one family have in common. */
typedef struct glint_panel_family {
    /** After the start-up sequence: sets rotation, pixel format and colours, and switches the display on. */
    glint_status (*set_up)(const glint_panel *panel);
    /**
     * Sets the rectangle of the picture that pixels go to, inclusive; on return the panel expects pixels. Null where
     * there is `send_pages`.
     */
    glint_status (*window)(const glint_panel *panel, int left, int top, int right, int bottom);
    /** A sequence that brings a panel without a reset line from any state to one in which it can be started. */
    const uint8_t *recover;
    /** Parameters of a command go with D/C low, as the command itself; otherwise high. */
    int parameters_are_commands;
    /**
     * Where a window is no more than a page: starts to send a rectangle, page by page, in place of `window` and the
     * bus's `begin`. The last page may still be on its way on return. Null elsewhere.
     */
    glint_status (*send_pages)(const glint_panel *panel, int x, int y, int width, int height, const uint8_t *pixels,
                               size_t stride);
} glint_panel_family;

/* How a glass lies on its controller, and what it shows. */
#define GLINT_PANEL_MIRRORED_X 1u /**< Columns of the memory run from right to left. */
#define GLINT_PANEL_MIRRORED_Y 2u /**< Rows run from the bottom up. */
#define GLINT_PANEL_BGR 4u        /**< The colours of a pixel lie blue, green, red. */
#define GLINT_PANEL_INVERTED 8u   /**< Dark where the controller means light: it is told to invert. */
#define GLINT_PANEL_ROUND 16u     /**< A disc: what lies outside is not sent. */
#define GLINT_PANEL_PAGES 32u     /**< A byte is a column of 8 rows: windows begin and end on multiples of 8. */
#define GLINT_PANEL_UPRIGHT 64u   /**< It cannot be turned. */

/** A kind of panel, const data. */
typedef struct glint_panel_type {
    const glint_panel_family *family;     /**< What it has in common with others. */
    const glint_format *format;           /**< What its memory takes, if nothing else is asked for. */
    const glint_format *format_turned;    /**< The same at 90 and 270 degrees; null where it is no other. */
    const uint8_t *start;                 /**< Start-up sequence, from reset to a panel that set_up may switch on. */
    uint16_t width, height;               /**< Of the glass, pixels, unturned. */
    uint16_t memory_width, memory_height; /**< Of the controller's memory; rows, as far as they are driven. */
    uint16_t left, top;                   /**< The memory's first column and row that the glass shows. */
    uint8_t glass;                        /**< GLINT_PANEL_MIRRORED_X and so on. */
    uint8_t bits[3];                      /**< Sizes of pixels that it takes; 0 where it takes fewer than three. */
    uint8_t reset_low_ms;                 /**< How long reset is held. */
    uint8_t reset_wait_ms;                /**< From the end of reset to the first command. */
    uint32_t clock_max;                   /**< Highest bus clock, Hz. */
} glint_panel_type;

/** A panel on a bus. Owned by the caller; not written. Fields left out are right for the panel as it is. */
struct glint_panel {
    const glint_panel_type *type;  /**< What kind. */
    const glint_bus *bus;          /**< What it hangs on. */
    glint_panel_rotation rotation; /**< How its picture is turned. */
    const glint_format *format;    /**< Null for the type's: what glint draws, as 12-bit or dithered pixels. */
    int has_words;                 /**< `format` is of words in the core's byte order, for bus->begin_words. */
};

/** Width of the picture as it is turned. @param panel whose @return pixels */
uint16_t glint_panel_width(const glint_panel *panel);

/** Height of the picture as it is turned. @param panel whose @return pixels */
uint16_t glint_panel_height(const glint_panel *panel);

/** What to draw with. @param panel for which @return the format */
const glint_format *glint_panel_format(const glint_panel *panel);

/**
 * Resets the panel, sends its start-up sequence and switches it on.
 * @param panel which
 * @return GLINT_ERROR_FORMAT or GLINT_ERROR_ROTATION before anything is sent, or what the bus returns
 */
glint_status glint_panel_start(const glint_panel *panel);

/**
 * Does any pixel of a rectangle lie on the glass? Others need not be drawn; glint_panel_begin does not send them.
 * @param panel whose glass
 * @param x,y,width,height the rectangle
 * @return 1 or 0
 */
int glint_panel_shows(const glint_panel *panel, int x, int y, int width, int height);

/**
 * Starts to send pixels of the panel's format to a rectangle; glint_panel_wait must follow.
 * @param panel where to
 * @param x,y,width,height the rectangle
 * @param pixels the one at x, y
 * @param stride bytes from row to row
 * @return GLINT_ERROR_REGION before anything is sent, or what the bus returns
 */
glint_status glint_panel_begin(const glint_panel *panel, int x, int y, int width, int height, const void *pixels,
                               size_t stride);

/** Returns when the pixels are sent. @param panel which @return what the bus returns */
glint_status glint_panel_wait(const glint_panel *panel);

/** The callbacks with which glint draws to a panel. @param panel which must outlive them @return the callbacks */
glint_flush glint_panel_flush(const glint_panel *panel);

/* ---- For families of panels ---- */

/** How a controller has to count so that the picture stands as it is turned. */
typedef struct glint_panel_axes {
    uint8_t exchanged;          /**< The picture's rows run along the memory's columns. */
    uint8_t mirror_x, mirror_y; /**< The memory's columns, its rows, are counted backwards. */
    uint16_t first_x, first_y;  /**< Where the picture begins, in the controller's addresses, as exchanged. */
} glint_panel_axes;

/** How a panel's controller has to count. @param panel which @return the axes */
glint_panel_axes glint_panel_find_axes(const glint_panel *panel);

/** Sends a command and its parameters. @param panel where to @param bytes,count which @return what the bus returns */
glint_status glint_panel_send(const glint_panel *panel, const uint8_t *bytes, size_t count);

/** Bits of a pixel. @param panel whose @return bits */
unsigned glint_panel_pixel_bits(const glint_panel *panel);

#ifdef __cplusplus
}
#endif

#endif
