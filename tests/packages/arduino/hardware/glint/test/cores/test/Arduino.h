/* SPDX-License-Identifier: MIT */
/* Of Arduino's interface, what the sketches call; by its public reference. */
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stddef.h>
#include <stdint.h>

enum { LOW = 0, HIGH = 1 };
enum { INPUT = 0, OUTPUT = 1 };
enum BitOrder { LSBFIRST = 0, MSBFIRST = 1 };

extern "C" {
void pinMode(int pin, int mode);
void digitalWrite(int pin, int value);
void delay(unsigned long milliseconds);
}

void setup();
void loop();

#endif
