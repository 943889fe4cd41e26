/* SPDX-License-Identifier: MIT */
/*
 * What methods are off by, as rows of CSV: `accuracy` prints how many methods there are, `accuracy N` measures method N
 * over its whole domain and fails when it is off by other than its descriptor states; `accuracy header` prints the
 * columns' names.
 */
#include "judge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int print_rows(const method *m) {
    const method_problem *problem = m->problem;
    int failed = 0;
    for (uint32_t point = 0; point < problem->point_count; point++) {
        if (!method_takes(m, point)) {
            continue;
        }
        const method_errors e = method_measure(m, point, 1);
        char p[16] = "";
        if (problem->point_count > 1) {
            (void)snprintf(p, sizeof p, "%g", problem->points[point] / 65536.0);
        }
        printf("%s,%s,%s,%s,%.4g,%.4g,%s,%llu,%s\n", problem->kind, m->name, m->variant, p, e.largest,
               sqrt(e.squares / (double)e.samples), problem->domain, (unsigned long long)e.samples,
               m->shipped ? "shipped" : "");
        const double stated = m->error[point] / 1000.0;
        if (e.largest > stated || e.largest < 0.95 * stated - 0.002) {
            (void)fprintf(stderr, "%s, %s, %s, p %s: off by %.4f, stated %.3f\n", problem->kind, m->name, m->variant, p,
                          e.largest, stated);
            failed = 1;
        }
    }
    return failed;
}

int main(int argc, char **argv) {
    const char *last = argc > 1 ? argv[argc - 1] : "";
    if (argc < 2) {
        printf("%u\n", (unsigned)methods_count());
        return 0;
    }
    if (strcmp(last, "header") == 0) {
        printf("kind,name,variant,p,max_error_lsb8,rms_error_lsb8,domain,samples,shipped\n");
        return 0;
    }
    const unsigned long index = strtoul(last, NULL, 10);
    if (index >= methods_count()) {
        return 2;
    }
    return print_rows(methods_get((uint32_t)index));
}
