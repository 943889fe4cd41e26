/* SPDX-License-Identifier: MIT */
/**
 * @file parse_light.c
 * The option --light: a kind and its fields, with colons between them; and the space that lights are in.
 */
#include "parsers.h"

#include "number.h"
#include "values.h"

#include <string.h>

/** Most fields after the kind: those of a spot. */
#define FIELDS_MAX 6

typedef struct light_field {
    const char *start;
    size_t length;
} light_field;

typedef struct light_kind {
    const char *name;
    const glint_light_type *type;
    size_t least, most; /* fields */
    const char *takes;
} light_kind;

static const light_kind kinds[] = {
    {"dir", &glint_light_directional, 1, 2, "takes dir:x,y,z[:r,g,b]"},
    {"point", &glint_light_point, 1, 4, "takes point:x,y,z[:r,g,b[:k1[:k2]]]"},
    {"spot", &glint_light_spot, 3, 6, "takes spot:x,y,z:ax,ay,az:inner,outer[:r,g,b[:k1[:k2]]]"},
};

/** Splits text at its colons. @return the number of fields, more than FIELDS_MAX when there are too many */
static size_t split_fields(const char *text, light_field fields[FIELDS_MAX]) {
    size_t count = 0;
    for (;;) {
        const size_t length = strcspn(text, ":");
        if (count == FIELDS_MAX) {
            return count + 1;
        }
        fields[count].start = text;
        fields[count++].length = length;
        if (text[length] == '\0') {
            return count;
        }
        text += length + 1;
    }
}

static bool parse_cone(light_field field, glint_light *light, host_problem *problem) {
    double degrees[2];
    if (!number_list(field.start, field.length, ',', 2, degrees) || degrees[0] < 0 || degrees[1] > 180) {
        return value_expected(problem, "takes a cone inner,outer in degrees from 0 to 180");
    }
    if (degrees[0] > degrees[1]) {
        return value_expected(problem, "takes a cone that is not wider inside than outside");
    }
    light->inner = number_q16(degrees[0]);
    light->outer = number_q16(degrees[1]);
    return true;
}

static bool parse_attenuation(light_field field, glint_q16 *coefficient, host_problem *problem) {
    double value;
    if (!number_real(field.start, field.length, &value) || value < 0 || value > NUMBER_Q16_MAX) {
        return value_expected(problem, "takes attenuation from 0 to 32767");
    }
    *coefficient = number_q16(value);
    return true;
}

/** What stands after the place and the cone: colour, k1, k2. */
static bool parse_strength(const light_field *fields, size_t count, glint_light *light, host_problem *problem) {
    light->diffuse = settings_grey(1);
    bool ok = count < 1 || value_colour(fields[0].start, fields[0].length, &light->diffuse, problem);
    ok = ok && (count < 2 || parse_attenuation(fields[1], &light->linear, problem));
    light->specular = light->diffuse;
    return ok && (count < 3 || parse_attenuation(fields[2], &light->quadratic, problem));
}

static bool parse_fields(const light_kind *kind, const light_field *fields, size_t count, glint_light *light,
                         host_problem *problem) {
    light->type = kind->type;
    if (kind->type == &glint_light_directional) {
        glint_vector from; /* no number of it is below -32767 */
        if (!value_direction(fields[0].start, fields[0].length, &from, problem)) {
            return false;
        }
        light->direction = (glint_vector){-from.x, -from.y, -from.z};
    } else if (!value_vector(fields[0].start, fields[0].length, &light->position, problem)) {
        return false;
    }
    if (kind->type == &glint_light_spot &&
        (!value_direction(fields[1].start, fields[1].length, &light->direction, problem) ||
         !parse_cone(fields[2], light, problem))) {
        return false;
    }
    return parse_strength(fields + kind->least, count - kind->least, light, problem);
}

bool parse_light(host_settings *settings, const char *text, host_problem *problem) {
    if (settings->light_count == GLINT_LIGHTS_MAX) {
        return value_expected(problem, "can be given 8 times at most");
    }
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        const size_t length = strlen(kinds[i].name);
        if (strncmp(text, kinds[i].name, length) != 0 || text[length] != ':') {
            continue;
        }
        light_field fields[FIELDS_MAX] = {{"", 0}};
        glint_light light = {.type = NULL};
        const size_t count = split_fields(text + length + 1, fields);
        if (count < kinds[i].least || count > kinds[i].most) {
            return value_expected(problem, kinds[i].takes);
        }
        if (!parse_fields(&kinds[i], fields, count, &light, problem)) {
            return false;
        }
        settings->lights[settings->light_count++] = light;
        return true;
    }
    return value_expected(problem, "takes dir:, point: or spot: and what the help says");
}

bool parse_camera_lights(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->camera_lights = true;
    return true;
}
