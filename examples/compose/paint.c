/* SPDX-License-Identifier: MIT */
#include "paint.h"

static int least(int a, int b) {
    return a < b ? a : b;
}

static int most(int a, int b) {
    return a > b ? a : b;
}

void paint_rectangle(const glint_tile *tile, int x, int y, int width, int height, uint32_t colour) {
    const int left = most(x - tile->x, 0), right = least(x + width - tile->x, tile->width);
    const int top = most(y - tile->y, 0), bottom = least(y + height - tile->y, tile->height);

    for (int row = top; row < bottom; row++) {
        uint8_t *const pixels = (uint8_t *)tile->pixels + (size_t)row * tile->stride;

        for (int column = left; column < right; column++) {
            pixels[2 * column] = (uint8_t)(colour >> 8);
            pixels[2 * column + 1] = (uint8_t)colour;
        }
    }
}

/* Rows of 3 bits from the top, the left one highest. */
static const uint16_t digits[10] = {075557, 026227, 071747, 071717, 055711, 074717, 074757, 071122, 075757, 075717};
static const uint16_t capitals[26] = {025755, 065656, 034443, 065556, 074647, 074644, 034553, 055755, 072227,
                                      011153, 055655, 044447, 057755, 065555, 025552, 065644, 025563, 065655,
                                      034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247};

static uint32_t letter_of(char c) {
    if (c >= '0' && c <= '9')
        return digits[c - '0'];
    return c >= 'A' && c <= 'Z' ? capitals[c - 'A'] : 0;
}

void paint_text(const glint_tile *tile, int x, int y, int scale, uint32_t colour, const char *text) {
    for (; *text; text++, x += PAINT_LETTER_STEP * scale)
        for (int i = 0; i < PAINT_LETTER_WIDTH * PAINT_LETTER_HEIGHT; i++)
            if (letter_of(*text) >> (14 - i) & 1)
                paint_rectangle(tile, x + i % PAINT_LETTER_WIDTH * scale, y + i / PAINT_LETTER_WIDTH * scale, scale,
                                scale, colour);
}
