/* SPDX-License-Identifier: MIT */
/* Everything that the library must not do, to see that the check finds it. Never linked. */

float planted_float(float x);
int planted_recursion(int depth);
int planted_global(void);
double planted_double(double x);

extern int outside(int x);

static int counter;

float planted_float(float x) {
    return x * 1.5f + 1.0f;
}

double planted_double(double x) {
    return x * 1.5;
}

/* The call's result is needed after it, so that it stays a call. */
int planted_recursion(int depth) { /* NOLINT(misc-no-recursion): planted */
    return depth == 0 ? 0 : outside(planted_recursion(depth - 1));
}

int planted_global(void) {
    return ++counter;
}

/* What a compiler leaves that drops the calls of a function. */
__attribute__((used)) static int planted_uncalled(int x) {
    return outside(x);
}
