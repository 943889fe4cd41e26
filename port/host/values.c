/* SPDX-License-Identifier: MIT */
#include "values.h"

#include "basics.h"

#include <math.h>
#include <string.h>

bool value_pair(const char *text, uint16_t most, uint16_t *first, uint16_t *second) {
    const char *cross = strchr(text, 'x');
    int64_t values[2];
    if (cross == NULL || !number_integer(text, (size_t)(cross - text), &values[0]) ||
        !number_integer(cross + 1, strlen(cross + 1), &values[1]) || values[0] < 1 || values[0] > most ||
        values[1] < 1 || values[1] > most) {
        return false;
    }
    *first = (uint16_t)values[0];
    *second = (uint16_t)values[1];
    return true;
}

bool value_vector(const char *text, size_t length, glint_vector *vector, host_problem *problem) {
    double values[3];
    bool ok = number_list(text, length, ',', 3, values);
    for (int i = 0; ok && i < 3; i++) {
        ok = fabs(values[i]) <= NUMBER_Q16_MAX;
    }
    if (!ok) {
        return problem_set(problem, 0, "takes x,y,z, each from -32767 to 32767");
    }
    *vector = (glint_vector){number_q16(values[0]), number_q16(values[1]), number_q16(values[2])};
    return true;
}

bool value_direction(const char *text, size_t length, glint_vector *vector, host_problem *problem) {
    return value_vector(text, length, vector, problem) &&
           (vector->x != 0 || vector->y != 0 || vector->z != 0 ||
            problem_set(problem, 0, "takes a direction, and this one's length is 0"));
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
        return problem_set(problem, 0, "takes r,g,b or one grey level, each from 0 to 16");
    }
    *colour = (glint_colour){number_q16(values[0]), number_q16(values[1]), number_q16(values[2])};
    return true;
}

/* ---- Lights ----------------------------------------------------------------------------------------------------- */

static bool parse_cone(const char *text, size_t length, glint_light *light, host_problem *problem) {
    double degrees[2];
    if (!number_list(text, length, ',', 2, degrees) || degrees[0] < 0 || degrees[1] > 180) {
        return problem_set(problem, 0, "takes a cone inner,outer in degrees from 0 to 180");
    }
    if (degrees[0] > degrees[1]) {
        return problem_set(problem, 0, "takes a cone that is not wider inside than outside");
    }
    light->inner = number_q16(degrees[0]);
    light->outer = number_q16(degrees[1]);
    return true;
}

static bool parse_attenuation(const char *text, size_t length, glint_q16 *coefficient, host_problem *problem) {
    double value;
    if (!number_real(text, length, &value) || value < 0 || value > NUMBER_Q16_MAX) {
        return problem_set(problem, 0, "takes attenuation from 0 to 32767");
    }
    *coefficient = number_q16(value);
    return true;
}

/** Parses a field of a kind: place or direction, axis, cone, colour, k1, k2. Fields from 3 on are those of all kinds.
 */
static bool parse_field(size_t field, const char *text, size_t length, glint_light *light, host_problem *problem) {
    switch (field) {
    case 0:
        if (light->type != &glint_light_directional) {
            return value_vector(text, length, &light->position, problem);
        }
        if (!value_direction(text, length, &light->direction, problem)) { /* from where it comes */
            return false;
        }
        light->direction = (glint_vector){-light->direction.x, -light->direction.y, -light->direction.z};
        return true;
    case 1:
        return value_direction(text, length, &light->direction, problem);
    case 2:
        return parse_cone(text, length, light, problem);
    case 3:
        return value_colour(text, length, &light->diffuse, problem);
    default:
        return parse_attenuation(text, length, field == 4 ? &light->linear : &light->quadratic, problem);
    }
}

bool value_light(const char *text, glint_light *light, host_problem *problem) {
    static const struct {
        const char *name;
        const glint_light_type *type;
        size_t least, most; /* fields */
        const char *takes;
    } kinds[] = {
        {"dir:", &glint_light_directional, 1, 2, "takes dir:x,y,z[:r,g,b]"},
        {"point:", &glint_light_point, 1, 4, "takes point:x,y,z[:r,g,b[:k1[:k2]]]"},
        {"spot:", &glint_light_spot, 3, 6, "takes spot:x,y,z:ax,ay,az:inner,outer[:r,g,b[:k1[:k2]]]"},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        const size_t skipped = strlen(kinds[i].name);
        if (strncmp(text, kinds[i].name, skipped) != 0) {
            continue;
        }
        size_t count = 1;
        for (const char *c = text + skipped; *c != '\0'; c++) {
            count += *c == ':';
        }
        if (count < kinds[i].least || count > kinds[i].most) {
            return problem_set(problem, 0, "%s", kinds[i].takes);
        }
        glint_light made = {.type = kinds[i].type, .diffuse = {GLINT_ONE, GLINT_ONE, GLINT_ONE}};
        text += skipped;
        for (size_t j = 0; j < count; j++) {
            const size_t length = strcspn(text, ":");
            if (!parse_field(j < kinds[i].least ? j : j - kinds[i].least + 3, text, length, &made, problem)) {
                return false;
            }
            text += length + 1;
        }
        made.specular = made.diffuse;
        *light = made;
        return true;
    }
    return problem_set(problem, 0, "takes dir:, point: or spot: and what the help says");
}

/* ---- Words that were meant ----------------------------------------------------------------------------------------
 */

/** Bytes of a word that count. */
#define WORD_MAX 32

static size_t least(size_t a, size_t b) {
    return a < b ? a : b;
}

size_t nearest_distance(const char *word, size_t length, const char *other) {
    const size_t across = least(length, WORD_MAX);
    const size_t down = least(strlen(other), WORD_MAX);
    size_t row[WORD_MAX + 1]; /* distances of the word's beginnings from a beginning of the other */
    for (size_t i = 0; i <= across; i++) {
        row[i] = i;
    }
    for (size_t j = 1; j <= down; j++) {
        size_t corner = row[0];
        row[0] = j;
        for (size_t i = 1; i <= across; i++) {
            const size_t changed = corner + (word[i - 1] != other[j - 1]);
            corner = row[i];
            row[i] = least(changed, least(row[i], row[i - 1]) + 1);
        }
    }
    return row[across];
}

int nearest_is_meant(size_t length, size_t distance) {
    return 3 * distance <= length;
}
