/* SPDX-License-Identifier: MIT */
#include "i2c.h"

/* Control bytes: another one follows the next byte, or only data do; whether what follows is a command. */
enum { CONTROL_COMMAND = 0x80, CONTROL_DATA = 0x40 };

static glint_status finish(const glint_i2c *i2c, glint_status status) {
    const glint_status stopped = i2c->stop(i2c->context);

    return status ? status : stopped;
}

glint_status glint_i2c_command(void *context, const uint8_t *bytes, size_t count) {
    const glint_i2c *i2c = context;
    glint_status status = i2c->start(i2c->context, i2c->address, CONTROL_COMMAND);

    for (size_t i = 0; i < count && !status; i++) {
        const uint8_t pair[2] = {bytes[i], CONTROL_COMMAND};
        status = i2c->write(i2c->context, pair, i + 1 < count ? 2 : 1);
    }
    return finish(i2c, status);
}

glint_status glint_i2c_data(void *context, const uint8_t *bytes, size_t count) {
    return glint_i2c_begin(context, bytes, count, 1, count);
}

glint_status glint_i2c_begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t rows, size_t stride) {
    const glint_i2c *i2c = context;
    glint_status status = i2c->start(i2c->context, i2c->address, CONTROL_DATA);

    for (size_t row = 0; row < rows && !status; row++) {
        status = i2c->write(i2c->context, bytes + row * stride, row_bytes);
    }
    return finish(i2c, status);
}
