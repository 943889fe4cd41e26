/* SPDX-License-Identifier: MIT */
#include "glint_linux.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

static int map(adapter_linux_screen *screen) {
    struct fb_var_screeninfo shape;
    struct fb_fix_screeninfo memory;

    if (ioctl(screen->file, FBIOGET_VSCREENINFO, &shape) || ioctl(screen->file, FBIOGET_FSCREENINFO, &memory))
        return errno;
    if (shape.bits_per_pixel != 16 || shape.xres > GLINT_SIZE_MAX || shape.yres > GLINT_SIZE_MAX)
        return ENOTSUP;
    screen->width = (uint16_t)shape.xres;
    screen->height = (uint16_t)shape.yres;
    screen->pitch = memory.line_length;
    screen->size = screen->pitch * shape.yres;
    screen->pixels = mmap(NULL, screen->size, PROT_READ | PROT_WRITE, MAP_SHARED, screen->file, 0);
    return screen->pixels == MAP_FAILED ? errno : 0;
}

int adapter_linux_open_fb(adapter_linux_screen *screen, const char *path) {
    screen->file = open(path, O_RDWR | O_CLOEXEC);
    if (screen->file < 0)
        return errno;
    const int error = map(screen);
    if (error) {
        close(screen->file);
        screen->file = -1;
    }
    return error;
}

void adapter_linux_close(adapter_linux_screen *screen) {
    munmap(screen->pixels, screen->size);
    close(screen->file);
    screen->file = -1;
}

static int copy_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    const adapter_linux_screen *const screen = context;

    for (int row = 0; row < height; row++)
        memcpy(screen->pixels + (size_t)(y + row) * screen->pitch + 2 * (size_t)x,
               (const uint8_t *)pixels + (size_t)row * stride, 2 * (size_t)width);
    return 0;
}

glint_flush adapter_linux_flush(adapter_linux_screen *screen) {
    return (glint_flush){.begin = copy_tile, .context = screen};
}
