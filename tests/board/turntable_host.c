/* SPDX-License-Identifier: MIT */
/* Writes what the turntable's panel must show to DIRECTORY/<model>-<frame>.pgm, with the panel's 16 greys as 0 to 15.
 */
#include "frames.h"

#include <stdio.h>

static int write_image(const char *path, const frame_image *image) {
    FILE *file = fopen(path, "wb");
    int failed;

    if (!file) {
        return 1;
    }
    fprintf(file, "P5\n%d %d\n15\n", TURNTABLE_WIDTH, TURNTABLE_HEIGHT);
    for (size_t i = 0; i < image->row_bytes * TURNTABLE_HEIGHT; i++) {
        fputc(image->pixels[i] >> 4, file);
        fputc(image->pixels[i] & 15, file);
    }
    failed = ferror(file);
    return fclose(file) != 0 || failed;
}

static int draw(const char *directory, turntable_model model, uint32_t frame) {
    const frame_options options = {&glint_format_grey4, 0, 0, 0};
    static frame_image image;
    char path[512];
    const glint_status status = frame_draw(&image, model, frame, &options);

    snprintf(path, sizeof path, "%s/%s-%u.pgm", directory, turntable_name(model), (unsigned)frame);
    if (status != GLINT_OK) {
        fprintf(stderr, "%s: %s\n", path, glint_strerror(status));
        return 1;
    }
    return write_image(path, &image);
}

int main(int argc, char **argv) {
    int failed = argc != 2;

    for (uint32_t i = 0; !failed && i < TURNTABLE_MODELS * TURNTABLE_FRAMES; i++) {
        failed = draw(argv[1], (turntable_model)(i / TURNTABLE_FRAMES), i % TURNTABLE_FRAMES);
    }
    return failed;
}
