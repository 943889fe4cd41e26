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

static void judge_sine(const judged *j) {
    const double q = j->p / 2;
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

/* ---- Normalisation ---- */

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

static void (*const judges[METHOD_QUANTITIES])(const judged *j) = {
    [METHOD_POWER_OF_COSINE] = judge_cosine,
    [METHOD_POWER_OF_SINE] = judge_sine,
    [METHOD_ROOT] = judge_root,
    [METHOD_UNIT_VECTOR] = judge_unit,
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
