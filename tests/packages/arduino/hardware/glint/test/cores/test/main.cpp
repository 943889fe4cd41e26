/* SPDX-License-Identifier: MIT */
#include "Arduino.h"
#include "bus.h"

enum { PIN_DATA = 9, FRAMES = 3 };

static int is_high;

int bus_data_is_high() {
    return is_high;
}

void pinMode(int pin, int mode) {
    (void)pin;
    (void)mode;
}

void digitalWrite(int pin, int value) {
    if (pin == PIN_DATA)
        is_high = value;
}

#ifdef __arm__

void delay(unsigned long milliseconds) {
    (void)milliseconds;
}

void bus_write(char kind, const uint8_t *bytes, size_t count) {
    static volatile uint8_t last;

    for (size_t i = 0; i < count; i++)
        last = (uint8_t)(bytes[i] ^ kind);
}

extern "C" void *memset(void *to, int value, size_t count) {
    for (volatile uint8_t *at = (uint8_t *)to; count; count--)
        *at++ = (uint8_t)value;
    return to;
}

extern "C" void *memcpy(void *to, const void *from, size_t count) {
    volatile uint8_t *at = (uint8_t *)to;

    for (const uint8_t *next = (const uint8_t *)from; count; count--)
        *at++ = *next++;
    return to;
}

#else

#include <stdio.h>

void delay(unsigned long milliseconds) {
    printf("T %lu\n", milliseconds * 1000);
}

void bus_write(char kind, const uint8_t *bytes, size_t count) {
    if (count == 0)
        return;
    putchar(kind);
    for (size_t i = 0; i < count; i++)
        printf(" %02x", bytes[i]);
    putchar('\n');
}

#endif

/* A program may have its own. */
__attribute__((weak)) int main() {
    setup();
    for (int frame = 0; frame < FRAMES; frame++)
        loop();
    return 0;
}
