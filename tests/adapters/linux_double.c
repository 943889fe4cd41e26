/* SPDX-License-Identifier: MIT */
/*
 * A framebuffer and a DRM device of doubles: the linker puts open, ioctl, mmap, munmap, close and libdrm's functions in
 * their place (--wrap, and names of the library itself, which is not linked).
 */
#include "adapters.h"

#include <adapters/glint_linux.h>
#include <errno.h>
#include <linux/fb.h>
#include <stdarg.h>
#include <string.h>
#include <sys/mman.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

enum { FILE_NUMBER = 77, PITCH = 2 * ADAPTED_WIDTH + 64, HANDLE = 5, BUFFER = 9, OFFSET = 4096 };

static struct {
    int open, mapped, is_shown;
    unsigned bits;
    int fails; /* with EINVAL: 1 adding a framebuffer, 2 showing it */
    uint8_t memory[PITCH * ADAPTED_HEIGHT];
} device;

int __wrap_open(const char *path, int flags, ...);
int __wrap_close(int file);
int __wrap_ioctl(int file, unsigned long request, ...);
void *__wrap_mmap(void *address, size_t size, int protection, int flags, int file, off_t offset);
int __wrap_munmap(void *address, size_t size);

int __wrap_open(const char *path, int flags, ...) {
    (void)flags;
    if (strcmp(path, "/dev/fb0") != 0 && strcmp(path, "/dev/dri/card0") != 0) {
        errno = ENOENT;
        return -1;
    }
    device.open++;
    return FILE_NUMBER;
}

int __wrap_close(int file) {
    CHECK_EQUAL(file, FILE_NUMBER);
    device.open--;
    return 0;
}

int __wrap_ioctl(int file, unsigned long request, ...) {
    va_list arguments;

    va_start(arguments, request);
    void *const to = va_arg(arguments, void *);
    va_end(arguments);
    CHECK_EQUAL(file, FILE_NUMBER);
    if (request == FBIOGET_VSCREENINFO) {
        struct fb_var_screeninfo *const shape = to;

        memset(shape, 0, sizeof *shape);
        shape->xres = ADAPTED_WIDTH;
        shape->yres = ADAPTED_HEIGHT;
        shape->bits_per_pixel = device.bits;
        return 0;
    }
    if (request == FBIOGET_FSCREENINFO) {
        struct fb_fix_screeninfo *const memory = to;

        memset(memory, 0, sizeof *memory);
        memory->line_length = PITCH;
        return 0;
    }
    errno = ENOTTY;
    return -1;
}

void *__wrap_mmap(void *address, size_t size, int protection, int flags, int file, off_t offset) {
    (void)address, (void)offset;
    CHECK_EQUAL(file, FILE_NUMBER);
    CHECK_EQUAL(size, PITCH * ADAPTED_HEIGHT);
    CHECK(protection == (PROT_READ | PROT_WRITE) && flags == MAP_SHARED);
    device.mapped++;
    return device.memory;
}

int __wrap_munmap(void *address, size_t size) {
    CHECK(address == device.memory && size == PITCH * ADAPTED_HEIGHT);
    device.mapped--;
    return 0;
}

/* ---- libdrm: two connectors, the second with a screen, driven by the second controller ---- */

static uint32_t connector_ids[2] = {20, 21}, controllers[2] = {30, 31}, encoders[1] = {40};
static drmModeModeInfo modes[2] = {{.hdisplay = ADAPTED_WIDTH, .vdisplay = ADAPTED_HEIGHT}, {.hdisplay = 640}};
static int held; /* what has yet to be freed */

drmModeResPtr drmModeGetResources(int fd) {
    static drmModeRes all = {
        .count_crtcs = 2, .crtcs = controllers, .count_connectors = 2, .connectors = connector_ids};

    CHECK_EQUAL(fd, FILE_NUMBER);
    held++;
    return &all;
}

drmModeConnectorPtr drmModeGetConnector(int fd, uint32_t id) {
    static drmModeConnector connector;

    (void)fd;
    held++;
    connector = (drmModeConnector){.connector_id = id,
                                   .connection = id == 21 ? DRM_MODE_CONNECTED : DRM_MODE_DISCONNECTED,
                                   .count_modes = 2,
                                   .modes = modes,
                                   .count_encoders = 1,
                                   .encoders = encoders};
    return &connector;
}

drmModeEncoderPtr drmModeGetEncoder(int fd, uint32_t id) {
    static drmModeEncoder encoder;

    (void)fd;
    held++;
    encoder = (drmModeEncoder){.encoder_id = id, .possible_crtcs = 2};
    return &encoder;
}

void drmModeFreeResources(drmModeResPtr ptr) {
    (void)ptr;
    held--;
}

void drmModeFreeConnector(drmModeConnectorPtr ptr) {
    (void)ptr;
    held--;
}

void drmModeFreeEncoder(drmModeEncoderPtr ptr) {
    (void)ptr;
    held--;
}

int drmModeCreateDumbBuffer(int fd, uint32_t width, uint32_t height, uint32_t bpp, uint32_t flags, uint32_t *handle,
                            uint32_t *pitch, uint64_t *size) {
    CHECK(fd == FILE_NUMBER && width == ADAPTED_WIDTH && height == ADAPTED_HEIGHT && bpp == 16 && flags == 0);
    *handle = HANDLE;
    *pitch = PITCH;
    *size = PITCH * ADAPTED_HEIGHT;
    return 0;
}

static int failure(int number) {
    errno = EINVAL;
    return device.fails == number ? -1 : 0;
}

int drmModeAddFB(int fd, uint32_t width, uint32_t height, uint8_t depth, uint8_t bpp, uint32_t pitch,
                 uint32_t bo_handle, uint32_t *buf_id) {
    CHECK(fd == FILE_NUMBER && width == ADAPTED_WIDTH && height == ADAPTED_HEIGHT && depth == 16 && bpp == 16);
    CHECK(pitch == PITCH && bo_handle == HANDLE);
    *buf_id = BUFFER;
    return failure(1);
}

int drmModeMapDumbBuffer(int fd, uint32_t handle, uint64_t *offset) {
    CHECK(fd == FILE_NUMBER && handle == HANDLE);
    *offset = OFFSET;
    return 0;
}

/* As libdrm declares it. NOLINTNEXTLINE(readability-non-const-parameter) */
int drmModeSetCrtc(int fd, uint32_t crtcId, uint32_t bufferId, uint32_t x, uint32_t y, uint32_t *connectors, int count,
                   drmModeModeInfoPtr mode) {
    CHECK(fd == FILE_NUMBER && crtcId == 31 && bufferId == BUFFER && x == 0 && y == 0);
    CHECK(count == 1 && connectors[0] == 21 && mode->hdisplay == ADAPTED_WIDTH);
    device.is_shown = device.fails != 2;
    return failure(2);
}

/* ---- The cases ---- */

static void check_shown(adapter_linux_screen *screen) {
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565);
    const glint_config config = adapted_config(&glint_format_rgb565, adapter_linux_flush(screen), 0);
    int wrong = 0;

    CHECK_EQUAL(screen->width, ADAPTED_WIDTH);
    CHECK_EQUAL(screen->height, ADAPTED_HEIGHT);
    CHECK_EQUAL(adapted_draw(&config), GLINT_OK);
    for (size_t y = 0; y < ADAPTED_HEIGHT; y++)
        wrong += memcmp(device.memory + y * PITCH, expected + y * 2 * ADAPTED_WIDTH, 2 * ADAPTED_WIDTH) != 0;
    CHECK_EQUAL(wrong, 0);
    adapter_linux_close(screen);
    CHECK_EQUAL(screen->file, -1);
    CHECK_EQUAL(device.open, 0);
    CHECK_EQUAL(device.mapped, 0);
}

void linux_fb_shows_the_scene(void) {
    adapter_linux_screen screen;

    memset(&device, 0, sizeof device);
    device.bits = 16;
    CHECK_EQUAL(adapter_linux_open_fb(&screen, "/dev/nothing"), ENOENT);
    CHECK_EQUAL(adapter_linux_open_fb(&screen, "/dev/fb0"), 0);
    check_shown(&screen);
}

void linux_fb_of_32_bits_is_refused(void) {
    adapter_linux_screen screen;

    memset(&device, 0, sizeof device);
    device.bits = 32;
    CHECK_EQUAL(adapter_linux_open_fb(&screen, "/dev/fb0"), ENOTSUP);
    CHECK_EQUAL(screen.file, -1);
    CHECK_EQUAL(device.open, 0);
}

void linux_drm_shows_the_scene(void) {
    adapter_linux_screen screen;

    memset(&device, 0, sizeof device);
    CHECK_EQUAL(adapter_linux_open_drm(&screen, "/dev/dri/card0"), 0);
    CHECK(device.is_shown);
    CHECK_EQUAL(held, 0);
    check_shown(&screen);
}

void linux_drm_error_leaves_nothing_open(void) {
    adapter_linux_screen screen;

    for (int stage = 1; stage <= 2; stage++) {
        memset(&device, 0, sizeof device);
        device.fails = stage;
        CHECK_EQUAL(adapter_linux_open_drm(&screen, "/dev/dri/card0"), EINVAL);
        CHECK_EQUAL(screen.file, -1);
        CHECK_EQUAL(device.open, 0);
        CHECK_EQUAL(device.mapped, 0);
        CHECK_EQUAL(held, 0);
    }
}
