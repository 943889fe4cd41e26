/* SPDX-License-Identifier: MIT */
#include "png.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

comparison compare_pictures(const uint8_t *pixels, uint32_t channels, const png_picture *other) {
    comparison found;
    uint64_t squares = 0;
    memset(&found, 0, sizeof found);
    found.pixels = other->width * other->height;
    found.channels = other->opaque ? 3 : 4;
    for (uint32_t i = 0; i < found.pixels; i++) {
        const uint8_t *own = pixels + (size_t)i * channels;
        const uint8_t drawn[4] = {own[0], own[1 % channels], own[2 % channels], 255};
        bool differs = false;
        for (uint32_t c = 0; c < found.channels; c++) {
            const uint32_t difference = (uint32_t)abs(drawn[c] - other->pixels[4 * (size_t)i + c]);
            found.largest[c] = difference > found.largest[c] ? difference : found.largest[c];
            squares += (uint64_t)difference * difference;
            differs = differs || difference > 0;
        }
        if (differs && found.different++ == 0) {
            found.first_x = i % other->width;
            found.first_y = i / other->width;
        }
    }
    found.squares = (double)squares / ((double)found.pixels * found.channels);
    return found;
}

double compare_psnr(const comparison *found) {
    return found->different > 0 ? 10 * log10(255.0 * 255.0 / found->squares) : HUGE_VAL;
}

void compare_print(const comparison *found) {
    printf("pixels_compared %lu\npixels_different %lu\nlargest_difference ", (unsigned long)found->pixels,
           (unsigned long)found->different);
    for (uint32_t c = 0; c < found->channels; c++) {
        printf("%s%lu", c > 0 ? "," : "", (unsigned long)found->largest[c]);
    }
    if (found->different == 0) {
        printf("\npsnr_db inf\nfirst_difference none\n");
        return;
    }
    printf("\npsnr_db %.3f\nfirst_difference %lu,%lu\n", compare_psnr(found), (unsigned long)found->first_x,
           (unsigned long)found->first_y);
}
