/* SPDX-License-Identifier: MIT */
/* Where the calls go: text that `make panel-stream` reads, or nowhere. */
#ifndef TEST_BUS_H
#define TEST_BUS_H

#include <stddef.h>
#include <stdint.h>

/** @param kind 'C' or 'D' */
void bus_write(char kind, const uint8_t *bytes, size_t count);

/** Is the pin that sketches wire to the panel's D/C high? */
int bus_data_is_high();

#endif
