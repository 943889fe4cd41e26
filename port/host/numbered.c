/* SPDX-License-Identifier: MIT */
#include "numbered.h"

#include "memory.h"

#include <stdio.h>
#include <string.h>

/** Most bytes of a number: digits that are asked for, or those of 32 bits, and the end. */
#define NUMBER_SIZE 16

/** The bytes of a conversion, from its percent on, and the digits it asks for; 0 bytes for none that is known. */
static size_t conversion(const char *text, uint32_t *digits) {
    *digits = 1;
    if (text[1] == 'd') {
        return 2;
    }
    if (text[1] != '0' || text[2] < '1' || text[2] > '9' || text[3] != 'd') {
        return 0;
    }
    *digits = (uint32_t)(text[2] - '0');
    return 4;
}

bool numbered_parse(numbered_name *name, const char *text, host_problem *problem) {
    numbered_name found = {text, false, 0, 0, 0};
    for (size_t i = 0; text[i] != '\0'; i++) {
        uint32_t digits;
        if (text[i] != '%') {
            continue;
        }
        if (text[i + 1] == '%') {
            i++;
            continue;
        }
        const size_t length = conversion(text + i, &digits);
        if (length == 0 || found.has_number) {
            return problem_set(problem, 0, "takes one %%d, or one %%03d for 3 digits (1 to 9), and %%%% for a percent");
        }
        found = (numbered_name){text, true, i, length, digits};
        i += length - 1;
    }
    *name = found;
    return true;
}

/** Copies a part of a name, percents undone. @return bytes written */
static size_t copy_part(char *to, const char *from, size_t length) {
    size_t written = 0;
    for (size_t i = 0; i < length; i++) {
        to[written++] = from[i];
        i += from[i] == '%'; /* the second of two */
    }
    return written;
}

char *numbered_make(const numbered_name *name, uint32_t number) {
    const size_t length = strlen(name->text);
    const size_t end = name->at + name->length;
    char *made = memory_new(length + NUMBER_SIZE, 1);
    size_t count = copy_part(made, name->text, name->at);
    if (name->has_number) {
        count += (size_t)snprintf(made + count, NUMBER_SIZE, "%0*lu", (int)name->digits, (unsigned long)number);
    }
    copy_part(made + count, name->text + end, length - end);
    return made;
}
