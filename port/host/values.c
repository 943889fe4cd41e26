/* SPDX-License-Identifier: MIT */
#include "values.h"

#include "number.h"

#include <math.h>
#include <string.h>

bool value_expected(host_problem *problem, const char *what) {
    return problem_set(problem, 0, "%s", what);
}

bool value_real(const char *text, double least, double most, double *value) {
    return number_real(text, strlen(text), value) && *value >= least && *value <= most;
}

bool value_pair(const char *text, int64_t *first, int64_t *second) {
    const char *cross = strchr(text, 'x');
    return cross != NULL && number_integer(text, (size_t)(cross - text), first) &&
           number_integer(cross + 1, strlen(cross + 1), second);
}

bool value_vector(const char *text, size_t length, glint_vector *vector, host_problem *problem) {
    double values[3];
    bool ok = number_list(text, length, ',', 3, values);
    for (int i = 0; ok && i < 3; i++) {
        ok = fabs(values[i]) <= NUMBER_Q16_MAX;
    }
    if (!ok) {
        return value_expected(problem, "takes x,y,z, each from -32767 to 32767");
    }
    vector->x = number_q16(values[0]);
    vector->y = number_q16(values[1]);
    vector->z = number_q16(values[2]);
    return true;
}

bool value_direction(const char *text, size_t length, glint_vector *vector, host_problem *problem) {
    return value_vector(text, length, vector, problem) &&
           (vector->x != 0 || vector->y != 0 || vector->z != 0 ||
            value_expected(problem, "takes a direction, and this one's length is 0"));
}

bool value_colour(const char *text, size_t length, glint_colour *colour, host_problem *problem) {
    double values[3];
    bool ok = number_list(text, length, ',', 3, values);
    if (!ok && number_list(text, length, ',', 1, values)) {
        values[1] = values[2] = values[0];
        ok = true;
    }
    for (int i = 0; ok && i < 3; i++) {
        ok = values[i] >= 0 && values[i] <= 16;
    }
    if (!ok) {
        return value_expected(problem, "takes r,g,b or one grey level, each from 0 to 16");
    }
    colour->r = number_q16(values[0]);
    colour->g = number_q16(values[1]);
    colour->b = number_q16(values[2]);
    return true;
}
