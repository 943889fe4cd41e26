/* SPDX-License-Identifier: MIT */
/** @file i2c.h The OLED's bus on the LM3S811 evaluation board. */
#ifndef GLINT_LM3S811EVB_I2C_H
#define GLINT_LM3S811EVB_I2C_H

#include <stdint.h>

/** Sets up the I2C master and its pins: from a core at core_hz, a bus of at most bus_hz. */
void lm3s_i2c_start(uint32_t core_hz, uint32_t bus_hz);

#endif
