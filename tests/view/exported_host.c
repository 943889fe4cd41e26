/* SPDX-License-Identifier: MIT */
/* Draws a scene as the window exported it, with the arena that it was drawn with there: exported_host OUT.png */
#include "basics.h"
#include "framebuffer.h"
#include "png.h"

#include EXPORTED_HEADER

#include <stdio.h>
#include <stdlib.h>

int main(int count, char *arguments[]) {
    framebuffer target;
    glint_renderer renderer;
    host_bytes file = {NULL, 0, 0};
    host_problem problem;
    glint_config config = EXPORTED_CONFIG;

    framebuffer_init(&target, config.format, config.width, config.height);
    config.flush = framebuffer_flush(&target);
    config.arena = malloc(config.arena_size);
    if (count != 2 || glint_init(&renderer, &config) != GLINT_OK ||
        glint_render(&renderer, &EXPORTED_SCENE) != GLINT_OK) {
        return 1;
    }
    uint8_t *picture = framebuffer_expand(&target);
    png_encode(&file, picture, target.width, target.height, target.format->channels);
    const int failed = !bytes_write_file(&file, arguments[1], &problem);
    printf("passes %lu\n", (unsigned long)renderer.stats.passes);
    free(picture);
    free(file.data);
    free(config.arena);
    framebuffer_free(&target);
    return failed;
}
