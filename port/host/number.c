/* SPDX-License-Identifier: MIT */
#include "values.h"

#include <math.h>
#include <string.h>

/** Decimal digits kept: 10^18 fits 64 bits. */
#define DIGITS_MAX 18

/** Beyond this a double has over- or underflowed whatever its digits are. */
#define EXPONENT_MAX 400

typedef struct decimal {
    uint64_t digits;
    int kept;     /* digits in `digits`, leading zeros not counted */
    int exponent; /* of ten */
} decimal;

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

static void decimal_add_digit(decimal *number, char c, bool after_point) {
    const bool keep = number->kept < DIGITS_MAX;
    if (keep) {
        number->digits = number->digits * 10 + (uint64_t)(c - '0');
        number->kept += number->digits > 0;
    }
    /* A file may hold any number of digits: stop counting before the exponent could overflow. */
    if (after_point && keep && number->exponent > -EXPONENT_MAX * 2) {
        number->exponent--;
    } else if (!after_point && !keep && number->exponent < EXPONENT_MAX * 2) {
        number->exponent++;
    }
}

/** Reads digits with at most one point. @return where they end, or null when there is no digit. */
static const char *read_digits(const char *at, const char *end, decimal *number) {
    bool any = false;
    bool point = false;
    for (; at < end && (is_digit(*at) || (*at == '.' && !point)); at++) {
        if (*at == '.') {
            point = true;
        } else {
            decimal_add_digit(number, *at, point);
            any = true;
        }
    }
    return any ? at : NULL;
}

/** Reads an exponent after its letter. @return where it ends, or null when there is none. */
static const char *read_exponent(const char *at, const char *end, decimal *number) {
    const bool negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    int exponent = 0;
    const char *first = at;
    for (; at < end && is_digit(*at); at++) {
        exponent = exponent < EXPONENT_MAX * 4 ? exponent * 10 + (*at - '0') : exponent;
    }
    number->exponent += negative ? -exponent : exponent;
    return at > first ? at : NULL;
}

static double decimal_value(const decimal *number) {
    double value = (double)number->digits;
    int exponent = number->exponent;
    if (number->digits == 0 || exponent < -EXPONENT_MAX) {
        return 0.0;
    }
    exponent = exponent > EXPONENT_MAX ? EXPONENT_MAX : exponent;
    /* Powers of ten up to 22 are exact doubles, so that one step of it rounds once. */
    for (; exponent >= 22; exponent -= 22) {
        value *= 1e22;
    }
    for (; exponent <= -22; exponent += 22) {
        value /= 1e22;
    }
    double power = 1.0;
    for (int i = exponent < 0 ? -exponent : exponent; i > 0; i--) {
        power *= 10.0;
    }
    return exponent < 0 ? value / power : value * power;
}

bool number_real(const char *text, size_t length, double *value) {
    const char *at = text;
    const char *end = text + length;
    const bool negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    decimal number = {0, 0, 0};
    at = read_digits(at, end, &number);
    if (at != NULL && at < end && (*at == 'e' || *at == 'E')) {
        at = read_exponent(at + 1, end, &number);
    }
    if (at != end) {
        return false;
    }
    const double magnitude = decimal_value(&number);
    if (!isfinite(magnitude)) {
        return false;
    }
    *value = negative ? -magnitude : magnitude;
    return true;
}

bool number_integer(const char *text, size_t length, int64_t *value) {
    const size_t sign = length > 0 && text[0] == '-';
    if (length == sign || length - sign > 18) {
        return false;
    }
    int64_t magnitude = 0;
    for (size_t i = sign; i < length; i++) {
        if (!is_digit(text[i])) {
            return false;
        }
        magnitude = magnitude * 10 + (text[i] - '0');
    }
    *value = sign ? -magnitude : magnitude;
    return true;
}

bool number_list(const char *text, size_t length, char separator, size_t count, double *values) {
    for (size_t i = 0; i < count; i++) {
        const char *found = memchr(text, separator, length);
        const size_t part = found != NULL ? (size_t)(found - text) : length;
        if ((found == NULL) != (i + 1 == count) || !number_real(text, part, &values[i])) {
            return false;
        }
        text += part + (found != NULL);
        length -= part + (found != NULL);
    }
    return true;
}

glint_q16 number_q16(double value) {
    return (glint_q16)lround(value * 65536.0);
}

double number_from_q16(glint_q16 value) {
    return (double)value / 65536.0;
}

void number_from_vector(glint_vector vector, double values[3]) {
    values[0] = number_from_q16(vector.x);
    values[1] = number_from_q16(vector.y);
    values[2] = number_from_q16(vector.z);
}
