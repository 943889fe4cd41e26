/* SPDX-License-Identifier: MIT */
/** @file math.h What the host program and the reference use of it: exact functions here, the others the browser's. */
#ifndef GLINT_WEB_MATH_H
#define GLINT_WEB_MATH_H

#define HUGE_VAL __builtin_huge_val()
#define INFINITY __builtin_inff()
#define isfinite(x) __builtin_isfinite(x)

static inline double fabs(double x) {
    return __builtin_fabs(x);
}

static inline double sqrt(double x) {
    return __builtin_sqrt(x);
}

static inline double floor(double x) {
    return __builtin_floor(x);
}

static inline double ceil(double x) {
    return __builtin_ceil(x);
}

static inline double trunc(double x) {
    return __builtin_trunc(x);
}

static inline double fmin(double a, double b) {
    return b < a || a != a ? b : a;
}

static inline double fmax(double a, double b) {
    return b > a || a != a ? b : a;
}

/* Halves away from zero, also where x + 1/2 would round up. */
static inline double round(double x) {
    const double whole = trunc(x);
    return fabs(x - whole) >= 0.5 ? whole + __builtin_copysign(1.0, x) : whole;
}

/* As on hosts with a long of 64 bits, within the range of this one's 32. */
static inline long lround(double x) {
    return (long)round(x);
}

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double pow(double x, double y);
double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double cbrt(double x);
double hypot(double x, double y);

#endif
