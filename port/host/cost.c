/* SPDX-License-Identifier: MIT */
#include "cost.h"

#include <math.h>
#include <stdio.h>

/** A core: its clock, and the columns of prices that hold its instructions and its cycles; -1 for none. */
typedef struct cost_core {
    const char *name;
    int mhz, instructions, cycles;
} cost_core;

#include "prices.h"

typedef char cost_has_all_prices[sizeof prices / sizeof prices[0] == COUNTS ? 1 : -1];

/* Of a frame that follows others in an arena that is kept: what is made of materials is there. */
static double sum_of(const frame_counts *counts, int column) {
    double sum = 0;
    for (int item = 0; item < COUNTS; item++) {
        sum += item == COUNTS_material || item == COUNTS_fast_material ? 0 : counts->of[item] * prices[item][column];
    }
    return sum;
}

/* To three digits: a model tells no more. */
static double rounded(double value) {
    const double unit = value > 0 ? pow(10, floor(log10(value)) - 2) : 1;
    return round(value / unit) * unit;
}

void cost_print(const frame_counts *counts) {
    if (counts->stats.passes != 1) {
        puts("model none for more than one pass");
        return;
    }
    puts("model not validated on silicon: docs/cost.md");
    for (size_t i = 0; i < sizeof cores / sizeof cores[0]; i++) {
        if (cores[i].instructions >= 0) {
            printf("instructions_%s %.0f\n", cores[i].name, rounded(sum_of(counts, cores[i].instructions)));
        }
    }
    for (size_t i = 0; i < sizeof cores / sizeof cores[0]; i++) {
        if (cores[i].cycles >= 0) {
            printf("ms_%s_%dmhz %.6g\n", cores[i].name, cores[i].mhz,
                   rounded(sum_of(counts, cores[i].cycles) / (1e3 * cores[i].mhz)));
        }
    }
}
