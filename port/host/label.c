/* SPDX-License-Identifier: MIT */
#include "label.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* ---- Font ------------------------------------------------------------------------------------------------------- */

/** Pixels of a glyph; the last row holds descenders. */
#define GLYPH_WIDTH 5
#define GLYPH_HEIGHT 8

/** From a glyph to the next one and from a line to the next one: a pixel lies between them. */
#define COLUMN LABEL_COLUMN
#define LINE LABEL_LINE

/** Printable ASCII from the space on, and a box, 16 glyphs in a strip. */
static const char *const font[6][GLYPH_HEIGHT] = {
    {
        "        #    # #   # #    #   ##  #  ##     #      #   #                                      #",
        "        #    # #   # #   #### ##  # #  #    #     #     #     #     #                         #",
        "        #         ##### # #      #  # #          #       #  # # #   #                        # ",
        "        #          # #   ###    #    #           #       #   ###  #####       #####         #  ",
        "        #         #####   # #  #    # # #        #       #  # # #   #                      #   ",
        "                   # #  ####  #  ## #  #          #     #     #     #     #          ##   #    ",
        "        #          # #    #   #  ##  ## #          #   #                  #          ##   #    ",
        "                                                                         #                     ",
    },
    {
        " ###    #    ###   ###     #  #####   ##  #####  ###   ###                 #         #     ### ",
        "#   #  ##   #   # #   #   ##  #      #        # #   # #   #               #           #   #   #",
        "#  ##   #       #     #  # #  ####  #        #  #   # #   #  ##    ##    #    #####    #      #",
        "# # #   #     ##    ##  #  #      # ####    #    ###   ####  ##    ##   #               #   ## ",
        "##  #   #    #        # #####     # #   #   #   #   #     #              #    #####    #    #  ",
        "#   #   #   #     #   #    #  #   # #   #  #    #   #    #   ##    ##     #           #        ",
        " ###   ###  #####  ###     #   ###   ###   #     ###   ##    ##     #      #         #      #  ",
        "                                                                   #                           ",
    },
    {
        " ###   ###  ####   ###  ####  ##### #####  ###  #   #  ###    ### #   # #     #   # #   #  ### ",
        "#   # #   # #   # #   # #   # #     #     #   # #   #   #      #  #  #  #     ## ## ##  # #   #",
        "# ### #   # #   # #     #   # #     #     #     #   #   #      #  # #   #     # # # ##  # #   #",
        "# # # ##### ####  #     #   # ####  ####  # ### #####   #      #  ##    #     # # # # # # #   #",
        "# ### #   # #   # #     #   # #     #     #   # #   #   #      #  # #   #     #   # #  ## #   #",
        "#     #   # #   # #   # #   # #     #     #   # #   #   #   #  #  #  #  #     #   # #  ## #   #",
        " ###  #   # ####   ###  ####  ##### #      ###  #   #  ###   ##   #   # ##### #   # #   #  ### ",
        "                                                                                               ",
    },
    {
        "####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####  ###  #      ###    #        ",
        "#   # #   # #   # #       #   #   # #   # #   # #   # #   #     #  #    #        #   # #       ",
        "#   # #   # #   # #       #   #   # #   # #   #  # #   # #     #   #     #       #  #   #      ",
        "####  #   # ####   ###    #   #   # #   # # # #   #     #     #    #      #      #             ",
        "#     # # # # #       #   #   #   #  # #  # # #  # #    #    #     #       #     #             ",
        "#     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #      #        #    #             ",
        "#      ## # #   # ####    #    ###    #   #   # #   #   #   #####  ###      #  ###             ",
        "                                                                                          #####",
    },
    {
        " #          #               #         ##        #       #      #  #      ##                    ",
        "  #         #               #        #  #       #                 #       #                    ",
        "       ###  ####   ###   ####  ###   #     #### ####   ##     ##  #  #    #   ## #  ####   ### ",
        "          # #   # #     #   # #   # ###   #   # #   #   #      #  # #     #   # # # #   # #   #",
        "       #### #   # #     #   # #####  #    #   # #   #   #      #  ##      #   # # # #   # #   #",
        "      #   # #   # #     #   # #      #     #### #   #   #      #  # #     #   # # # #   # #   #",
        "       #### ####   ###   ####  ###   #        # #   #  ###  #  #  #  #   ###  # # # #   #  ### ",
        "                                           ###               ##                                ",
    },
    {
        "                         #                                           #    #    #          #####",
        "                         #                                          #     #     #         #   #",
        "####   #### # ##   #### ###   #   # #   # #   # #   # #   # #####   #     #     #    ## # #   #",
        "#   # #   # ##    #      #    #   # #   # #   #  # #  #   #    #   #      #      #  # ##  #   #",
        "#   # #   # #      ###   #    #   #  # #  # # #   #   #   #   #     #     #     #         #   #",
        "####   #### #         #  #  # #   #  # #  # # #  # #   ####  #      #     #     #         #   #",
        "#         # #     ####    ##   ####   #    # #  #   #     # #####    #    #    #          #####",
        "#         #                                            ###                                     ",
    },
};

static bool has_pixel(char character, int x, int y) {
    const int code = character >= ' ' && character <= '~' ? character - ' ' : 0x7F - ' ';
    return font[code / 16][y][code % 16 * COLUMN + x] == '#';
}

/* ---- Pixels ----------------------------------------------------------------------------------------------------- */

typedef struct point {
    int x, y;
} point;

static int within(int value, int least, int most) {
    return value < least ? least : value > most ? most : value;
}

void label_fill(const label_picture *picture, int x, int y, int width, int height, const uint8_t *colour) {
    const int left = within(x, 0, (int)picture->width);
    const int right = within(x + width, 0, (int)picture->width);
    const int top = within(y, 0, (int)picture->height);
    const int bottom = within(y + height, 0, (int)picture->height);
    for (int row = top; row < bottom; row++) {
        uint8_t *at = picture->pixels + ((size_t)row * picture->width + (size_t)left) * picture->channels;
        for (int column = left; column < right; column++, at += picture->channels) {
            memcpy(at, colour, picture->channels);
        }
    }
}

/** The same with a level of grey. */
static void fill(const label_picture *picture, point corner, int width, int height, uint8_t level) {
    const uint8_t colour[3] = {level, level, level};
    label_fill(picture, corner.x, corner.y, width, height, colour);
}

/** Fills the square about a pixel that reaches `radius` pixels from it. */
static void fill_square(const label_picture *picture, point middle, int radius, uint8_t level) {
    const point corner = {middle.x - radius, middle.y - radius};
    fill(picture, corner, 2 * radius + 1, 2 * radius + 1, level);
}

/* ---- Labels ----------------------------------------------------------------------------------------------------- */

/** A text's plate and how many characters its longest line has. */
typedef struct label_plate {
    point corner;
    int width, height, longest;
} label_plate;

/** Where the middle of the pixel (x, y) of a picture of width x height lies in a picture of another size. */
static point place(const label_picture *picture, int x, int y, int width, int height) {
    const int64_t across = (2 * (int64_t)x + 1 - width) * picture->height + (int64_t)picture->width * height;
    const int64_t down = (2 * (int64_t)y + 1) * picture->height;
    const point there = {(int)(across / (2 * height)), (int)(down / (2 * height))};
    return there;
}

/** The plate of a text about a middle, moved inside; one that is larger than the picture keeps its beginning. */
static label_plate make_plate(const label_picture *picture, const char *text, point middle) {
    label_plate made = {.height = LINE + 1};
    int length = 0;
    for (; *text != '\0'; text++) {
        length = *text == '\n' ? 0 : length + 1;
        made.height += *text == '\n' ? LINE : 0;
        made.longest = length > made.longest ? length : made.longest;
    }
    made.width = made.longest * COLUMN + 1;
    const int right = (int)picture->width - made.width;
    const int bottom = (int)picture->height - made.height;
    made.corner.x = within(middle.x - made.width / 2, 0, right > 0 ? right : 0);
    made.corner.y = within(middle.y - made.height / 2, 0, bottom > 0 ? bottom : 0);
    return made;
}

void label_text(const label_picture *picture, const char *text, int x, int y, int scale, const uint8_t *colour) {
    for (; *text != '\0'; text++, x += COLUMN * scale) {
        for (int i = 0; i < GLYPH_WIDTH * GLYPH_HEIGHT; i++) {
            if (has_pixel(*text, i % GLYPH_WIDTH, i / GLYPH_WIDTH)) {
                label_fill(picture, x + i % GLYPH_WIDTH * scale, y + i / GLYPH_WIDTH * scale, scale, scale, colour);
            }
        }
    }
}

static void draw_line_of_text(const label_picture *picture, const char *text, int length, point corner) {
    static const uint8_t white[3] = {255, 255, 255};
    for (int i = 0; i < length; i++) {
        const char character[2] = {text[i], '\0'};
        label_text(picture, character, corner.x + i * COLUMN, corner.y, 1, white);
    }
}

/** Draws a text with its plate, each line in the middle. */
static void draw_text(const label_picture *picture, const char *text, const label_plate *plate) {
    fill(picture, plate->corner, plate->width, plate->height, 0);
    point at = {0, plate->corner.y + 1};
    while (*text != '\0') {
        const int length = (int)strcspn(text, "\n");
        at.x = plate->corner.x + 1 + (plate->longest - length) * COLUMN / 2;
        draw_line_of_text(picture, text, length, at);
        text += length + (text[length] == '\n');
        at.y += LINE;
    }
}

/** i / steps of a distance, rounded to nearest. */
static int part_of(int distance, int i, int steps) {
    const int64_t twice = 2 * (int64_t)distance * i;
    return (int)((twice + (distance < 0 ? -steps : steps)) / (2 * (int64_t)steps));
}

/** Draws a line of squares with a larger one at its end. */
static void draw_line(const label_picture *picture, point from, point to, int radius, uint8_t level) {
    const int across = abs(to.x - from.x);
    const int down = abs(to.y - from.y);
    const int steps = across > down ? across : down;
    for (int i = 0; i < steps; i++) {
        const point at = {from.x + part_of(to.x - from.x, i, steps), from.y + part_of(to.y - from.y, i, steps)};
        fill_square(picture, at, radius, level);
    }
    fill_square(picture, to, radius + 1, level);
}

/** Draws the line from a plate's middle to where it leads. */
static void draw_leader(const label_picture *picture, const label_plate *plate, point to) {
    const point from = {plate->corner.x + plate->width / 2, plate->corner.y + plate->height / 2};
    draw_line(picture, from, to, 1, 0);
    draw_line(picture, from, to, 0, 255);
}

void label_draw(const label_picture *picture, const example_label *labels, uint32_t count, uint16_t width,
                uint16_t height) {
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t i = 0; i < count; i++) {
            const example_label *label = &labels[i];
            const point middle = place(picture, label->x, label->y, width, height);
            const label_plate plate = make_plate(picture, label->text, middle);
            if (pass == 1) {
                draw_text(picture, label->text, &plate);
            } else if (label->to_x != 0 || label->to_y != 0) {
                draw_leader(picture, &plate, place(picture, label->to_x, label->to_y, width, height));
            }
        }
    }
}
