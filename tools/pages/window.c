/* SPDX-License-Identifier: MIT */
/*
 * Draws the picture of docs/view.md: window DIRECTORY
 * It is the window's canvas, after keys, without a window.
 */
#include "window.h"
#include "basics.h"
#include "png.h"

#include <stdio.h>
#include <stdlib.h>

/** As large as the window opens. */
enum { WIDTH = 3 * 320 + 2 * WINDOW_MARGIN + WINDOW_SIDE, HEIGHT = 3 * 240 + 2 * WINDOW_MARGIN + 40 };

static int write_canvas(const label_picture *canvas, const char *path) {
    host_bytes file = {NULL, 0, 0};
    host_problem problem;
    png_encode(&file, canvas->pixels, canvas->width, canvas->height, 3);
    const int failed = !bytes_write_file(&file, path, &problem);
    if (failed) {
        problem_print(path, &problem);
    }
    free(file.data);
    return failed;
}

int main(int count, char *arguments[]) {
    static window_state state;
    static const char keys[] = "D";
    host_settings settings;
    host_problem problem;
    char path[1000];
    if (count != 2) {
        return 1;
    }
    settings_default(&settings);
    settings.format = framebuffer_find_format("rgb565", NULL);
    window_init(&state, &settings);
    if (!window_open(&state, "phong-lighting:ring", &problem)) {
        problem_print(NULL, &problem);
        return 1;
    }
    for (const char *key = keys; *key != '\0'; key++) {
        window_key(&state, *key, false);
    }
    const label_picture canvas = {memory_new((size_t)WIDTH * HEIGHT, 3), WIDTH, HEIGHT, 3};
    window_draw(&state, &canvas);
    snprintf(path, sizeof path, "%s/view.png", arguments[1]);
    const int failed = write_canvas(&canvas, path);
    free(canvas.pixels);
    window_free(&state);
    return failed;
}
