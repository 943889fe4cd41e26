/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <math.h>

/** Words of input or output that are dealt with together. */
enum { WORDS = 16384 };

/* Long loops sum up errors in a copy, which registers hold. */
typedef struct judged {
    const method *method;
    double p;
    const int32_t *in, *out;
    uint32_t count;
    method_errors *errors;
} judged;

static inline void note(method_errors *errors, double error) {
    const double size = fabs(error) * 255;
    errors->largest = size > errors->largest ? size : errors->largest;
    errors->squares += size * size;
    errors->samples++;
}

/* ---- Power ---- */

/* Against both ends of what rounds to the input. */
static void judge_cosine(const judged *j) {
    for (uint32_t i = 0; i < j->count; i++) {
        const double found = (double)j->out[i] / j->method->one;
        for (int end = -1; end <= 1; end += 2) {
            const double x = (j->in[i] + 0.5 * end) / 65536;
            note(j->errors, found - pow(x < 0 ? 0 : x > 1 ? 1 : x, j->p));
        }
    }
}

/* (1 - u)^q near where it was last computed, by three terms of its series: off by less than 1e-11. */
typedef struct series {
    int32_t at;
    double value, slope, bend;
} series;

static inline double series_power(series *s, int32_t u, double q) {
    const double step = 0x1p-30;
    if (s->at < 0 || u < s->at || u - s->at >= 64) {
        const double x = 1 - u * step;
        s->at = x > 0x1p-12 ? u : -1;
        s->value = pow(x, q);
        s->slope = x > 0 ? -q * s->value / x * step : 0;
        s->bend = x > 0 ? -(q - 1) * s->slope / x * step / 2 : 0;
        return s->value;
    }
    const double t = u - s->at;
    return s->value + t * (s->slope + t * s->bend);
}

/* Are the items in order, and is all that follows the first 0 and found so? Errors below 1e-10 are left out of the sum.
 */
static int is_beyond(const judged *j, double q) {
    int32_t any = 0;
    for (uint32_t i = 0; i < j->count; i++) {
        any |= j->out[i] | (j->in[i] < j->in[0]);
    }
    return any == 0 && pow(1 - j->in[0] * 0x1p-30, q) < 1e-10;
}

static void judge_complement(const judged *j, double q) {
    series s = {-1, 0, 0, 0};
    if (is_beyond(j, q)) {
        j->errors->samples += j->count;
        return;
    }
    method_errors errors = *j->errors;
    const double one = 1.0 / j->method->one;
    for (uint32_t i = 0; i < j->count; i++) {
        note(&errors, j->out[i] * one - series_power(&s, j->in[i], q));
    }
    *j->errors = errors;
}

static void judge_sine(const judged *j) {
    judge_complement(j, j->p / 2);
}

static void judge_chord(const judged *j) {
    judge_complement(j, j->p);
}

static void judge_vectors(const judged *j) {
    for (uint32_t i = 0; i < j->count; i++) {
        const double x = j->in[2 * i + 1], length = hypot(x, j->in[2 * i]);
        note(j->errors, (double)j->out[i] / j->method->one - pow(x / length, j->p));
    }
}

/* ---- Normalisation and division ---- */

static void judge_root(const judged *j) {
    method_errors errors = *j->errors;
    for (uint32_t i = 0; i < j->count; i++) {
        note(&errors, (double)j->out[i] / j->method->one / (32768 / sqrt(j->in[i])) - 1);
    }
    *j->errors = errors;
}

static void judge_unit(const judged *j) {
    for (uint32_t i = 0; i < j->count; i++) {
        const int32_t *in = j->in + 3 * i;
        const double length = sqrt((double)in[0] * in[0] + (double)in[1] * in[1] + (double)in[2] * in[2]);
        for (int c = 0; c < 3; c++) {
            note(j->errors, (double)j->out[3 * i + (uint32_t)c] / j->method->one - in[c] / length);
        }
    }
}

static void judge_quotients(const judged *j, uint32_t quotients, double scale) {
    for (uint32_t i = 0; i < j->count; i++) {
        const int32_t *in = j->in + (quotients + 1) * i;
        for (uint32_t c = 0; c < quotients; c++) {
            note(j->errors, (double)j->out[quotients * i + c] / j->method->one - scale * in[c] / in[quotients]);
        }
    }
}

static void judge_colour_over_w(const judged *j) {
    judge_quotients(j, 3, 2);
}

static void judge_position_over_w(const judged *j) {
    judge_quotients(j, 2, 1);
}

/* ---- Lighting ---- */

static void make_unit(double v[3]) {
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++) {
        v[i] /= length;
    }
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void judge_lighting(const judged *j) {
    const method_problem *problem = j->method->problem;
    double light[3] = {0.4, 0.6, 0.7};
    make_unit(light);
    double half[3] = {light[0], light[1], light[2] + 1};
    make_unit(half);
    for (uint32_t i = 0; i < j->count * problem->units; i++) {
        const int32_t *in = j->in + 6 * (i / problem->units);
        double normal[3];
        for (int c = 0; c < 3; c++) {
            normal[c] = in[c] + (double)in[3 + c] * (i % problem->units);
        }
        make_unit(normal);
        const double diffuse = fmax(0, dot(normal, light)), specular = pow(fmax(0, dot(normal, half)), j->p);
        for (int c = 0; c < 3; c++) {
            const double exact =
                (diffuse * methods_lighting_weights[0][c] + specular * methods_lighting_weights[1][c]) / 4096;
            note(j->errors, (double)j->out[3 * i + (uint32_t)c] / j->method->one - exact);
        }
    }
}

/* Two vectors that make a right-handed frame with a unit vector. */
static void find_tangents(const double v[3], double a[3], double b[3]) {
    const int least = fabs(v[0]) < 0.6 ? 0 : 1;
    for (int i = 0; i < 3; i++) {
        a[i] = (i == least) - v[least] * v[i];
    }
    make_unit(a);
    for (int i = 0; i < 3; i++) {
        b[i] = v[(i + 1) % 3] * a[(i + 2) % 3] - v[(i + 2) % 3] * a[(i + 1) % 3];
    }
}

/* The highlight by sin^2 with the half vector found, at eight normals around the true one on each of three rings. */
static void judge_highlight(const judged *j, const double half[3], const double found[3]) {
    static const double rings[3] = {0.5, 1, 1.5};
    double a[3], b[3];
    find_tangents(half, a, b);
    const double square = dot(found, found);
    for (int ring = 0; ring < 3; ring++) {
        const double sine = rings[ring] / sqrt(j->p), cosine = sqrt(1 - sine * sine), exact = pow(cosine, j->p);
        for (int k = 0; k < 8; k++) {
            const double turn = k * 0.78539816339744831, x = sine * cos(turn), y = sine * sin(turn);
            const double along = cosine * dot(half, found) + x * dot(a, found) + y * dot(b, found);
            const double u = square - along * along;
            note(j->errors, (along > 0 ? pow(u < 0 ? 1 : u > 1 ? 0 : 1 - u, j->p / 2) : 0) - exact);
        }
    }
}

static void judge_half_vector(const judged *j) {
    const uint32_t pixels = j->method->problem->units;
    for (uint32_t i = 0; i < j->count * pixels; i++) {
        const int32_t *in = j->in + 5 * (i / pixels), *out = j->out + 3 * i;
        const uint32_t pixel = i % pixels;
        double light[3] = {in[2], in[3], in[4]}, found[3];
        double half[3] = {METHOD_SCREEN_WIDTH - 1 - 2 * (in[0] + (int32_t)(pixel % METHOD_TILE)),
                          2 * (in[1] + (int32_t)(pixel / METHOD_TILE)) + 1 - METHOD_SCREEN_HEIGHT,
                          METHOD_FOCAL / 4096.0};
        make_unit(light);
        make_unit(half);
        for (int c = 0; c < 3; c++) {
            half[c] += light[c];
            found[c] = (double)out[c] / j->method->one;
        }
        make_unit(half);
        judge_highlight(j, half, found);
    }
}

/* ---- Colours and levels ---- */

static void judge_colour(const judged *j) {
    method_errors errors = *j->errors;
    const uint32_t(*weights)[3] = methods_colour_weights[methods_colour_clamps(j->method->problem)];
    for (uint32_t i = 0; i < j->count; i++) {
        const int32_t pixel = j->out[i];
        const double found[3] = {(pixel >> 11) / 31.0, (pixel >> 5 & 63) / 63.0, (pixel & 31) / 31.0};
        const double diffuse = j->in[2 * i] / 32768.0, specular = j->in[2 * i + 1] / 32768.0;
        for (int c = 0; c < 3; c++) {
            const double exact = (weights[0][c] + diffuse * weights[1][c] + specular * weights[2][c]) / 4096;
            note(&errors, found[c] - (exact < 1 ? exact : 1));
        }
    }
    *j->errors = errors;
}

static void judge_level(const judged *j) {
    method_errors errors = *j->errors;
    const uint32_t pixels = j->method->problem->units;
    for (uint32_t i = 0; i < j->count * pixels; i++) {
        const uint32_t item = i / pixels;
        note(&errors, (double)j->out[i] / j->method->one - j->in[item] / 8388608.0);
    }
    *j->errors = errors;
}

static void judge_mean_level(const judged *j) {
    method_errors errors = *j->errors;
    const uint32_t pixels = j->method->problem->units;
    for (uint32_t i = 0; i < j->count; i++) {
        int32_t sum = 0;
        for (uint32_t k = 0; k < pixels; k++) {
            sum += j->out[pixels * i + k];
        }
        note(&errors, (double)sum / pixels / j->method->one - j->in[i] / 8388608.0);
    }
    *j->errors = errors;
}

static void (*const judges[METHOD_QUANTITIES])(const judged *j) = {
    [METHOD_POWER_OF_COSINE] = judge_cosine,
    [METHOD_POWER_OF_SINE] = judge_sine,
    [METHOD_POWER_OF_CHORD] = judge_chord,
    [METHOD_POWER_OF_VECTORS] = judge_vectors,
    [METHOD_ROOT] = judge_root,
    [METHOD_UNIT_VECTOR] = judge_unit,
    [METHOD_COLOUR_OVER_W] = judge_colour_over_w,
    [METHOD_POSITION_OVER_W] = judge_position_over_w,
    [METHOD_LIGHTING] = judge_lighting,
    [METHOD_HALF_VECTOR] = judge_half_vector,
    [METHOD_COLOUR] = judge_colour,
    [METHOD_LEVEL] = judge_level,
    [METHOD_MEAN_LEVEL] = judge_mean_level,
};

int method_takes(const method *m, uint32_t point) {
    return m->problem->points[point] >= m->smallest;
}

method_errors method_measure(const method *m, uint32_t point, uint32_t stride) {
    static int32_t in[WORDS], out[WORDS];
    const method_problem *problem = m->problem;
    const uint32_t words = problem->in_words > problem->out_words ? problem->in_words : problem->out_words;
    method_errors errors = {0, 0, 0};
    judged j = {m, problem->points[point] / 65536.0, in, out, 0, &errors};
    if (m->prepare) {
        m->prepare(problem->points[point]);
    }
    for (uint64_t index = 0; index < problem->size;) {
        for (j.count = 0; j.count < WORDS / words && index < problem->size; j.count++) {
            if (problem->input) {
                problem->input(index, in + problem->in_words * j.count);
            } else {
                in[j.count] = (int32_t)index;
            }
            index = index + stride < problem->size || index == problem->size - 1 ? index + stride : problem->size - 1;
        }
        m->run(in, out, j.count);
        judges[problem->quantity](&j);
    }
    return errors;
}
