/* SPDX-License-Identifier: MIT */
#include "glint_linux.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

/* What shows a mode: a connector, and the first controller that it can be driven by. */
typedef struct route {
    uint32_t connector, controller;
    drmModeModeInfo mode; /* the preferred one comes first */
} route;

static int find_route(int file, route *found) {
    drmModeRes *const all = drmModeGetResources(file);
    int is_found = 0;

    for (int i = 0; all && i < all->count_connectors && !is_found; i++) {
        drmModeConnector *const connector = drmModeGetConnector(file, all->connectors[i]);
        drmModeEncoder *const encoder = connector && connector->connection == DRM_MODE_CONNECTED &&
                                                connector->count_modes > 0 && connector->count_encoders > 0
                                            ? drmModeGetEncoder(file, connector->encoders[0])
                                            : NULL;

        for (int c = 0; encoder && c < all->count_crtcs && c < 32 && !is_found; c++)
            if (encoder->possible_crtcs >> c & 1) {
                *found = (route){connector->connector_id, all->crtcs[c], connector->modes[0]};
                is_found = 1;
            }
        if (encoder)
            drmModeFreeEncoder(encoder);
        if (connector)
            drmModeFreeConnector(connector);
    }
    if (all)
        drmModeFreeResources(all);
    return is_found ? 0 : ENODEV;
}

static int show(adapter_linux_screen *screen) {
    route to;
    uint32_t handle, pitch, buffer;
    uint64_t size, offset;

    if (find_route(screen->file, &to))
        return ENODEV;
    screen->width = to.mode.hdisplay;
    screen->height = to.mode.vdisplay;
    if (screen->width > GLINT_SIZE_MAX || screen->height > GLINT_SIZE_MAX)
        return ENOTSUP;
    if (drmModeCreateDumbBuffer(screen->file, screen->width, screen->height, 16, 0, &handle, &pitch, &size) ||
        drmModeAddFB(screen->file, screen->width, screen->height, 16, 16, pitch, handle, &buffer) ||
        drmModeMapDumbBuffer(screen->file, handle, &offset))
        return errno;
    screen->pitch = pitch;
    screen->size = size;
    screen->pixels = mmap(NULL, screen->size, PROT_READ | PROT_WRITE, MAP_SHARED, screen->file, (off_t)offset);
    if (screen->pixels == MAP_FAILED)
        return errno;
    if (drmModeSetCrtc(screen->file, to.controller, buffer, 0, 0, &to.connector, 1, &to.mode)) {
        const int error = errno;

        munmap(screen->pixels, screen->size);
        return error;
    }
    return 0;
}

int adapter_linux_open_drm(adapter_linux_screen *screen, const char *path) {
    screen->file = open(path, O_RDWR | O_CLOEXEC);
    if (screen->file < 0)
        return errno;
    const int error = show(screen);
    if (error) {
        close(screen->file);
        screen->file = -1;
    }
    return error;
}
