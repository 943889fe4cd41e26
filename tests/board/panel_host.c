/* SPDX-License-Identifier: MIT */
/*
 * Writes what the panel must show to DIRECTORY/<name>-<frame>.pgm, with the panel's 16 greys as 0 to 15, and prints
 * their names: panel_host turntable|scenes DIRECTORY.
 */
#include "firmware/shown.h"
#include "frames.h"

#include <stdio.h>
#include <string.h>

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

static int keep(const char *directory, const char *name, uint32_t frame, glint_status status,
                const frame_image *image) {
    char path[512];

    snprintf(path, sizeof path, "%s/%s-%u.pgm", directory, name, (unsigned)frame);
    if (status != GLINT_OK) {
        fprintf(stderr, "%s: %s\n", path, glint_strerror(status));
        return 1;
    }
    printf("%s-%u\n", name, (unsigned)frame);
    return write_image(path, image);
}

static int draw_turntable(const char *directory) {
    const frame_options options = {&glint_format_grey4, 0, 0, 0};
    static frame_image image;
    int failed = 0;

    for (int model = 0; model < TURNTABLE_MODELS; model++) {
        for (uint32_t frame = 0; frame < TURNTABLE_FRAMES; frame++) {
            const glint_status status = frame_draw(&image, (turntable_model)model, frame, &options);
            failed |= keep(directory, turntable_name((turntable_model)model), frame, status, &image);
        }
    }
    return failed;
}

static int draw_scenes(const char *directory) {
    const frame_options options = {&glint_format_grey4_dithered, 0, 0, 0};
    static frame_image image;
    static example_stage stage;
    shown_frame shown;
    int failed = 0;

    for (uint32_t i = 0; shown_find(&shown, i); i++) {
        shown.scene->build(&stage, shown.variant, shown.frame);
        failed |= keep(directory, shown.name, shown.frame, frame_draw_scene(&image, &stage.scene, &options), &image);
    }
    return failed;
}

int main(int argc, char **argv) {
    if (argc != 3) {
        return 1;
    }
    return strcmp(argv[1], "scenes") == 0 ? draw_scenes(argv[2]) : draw_turntable(argv[2]);
}
