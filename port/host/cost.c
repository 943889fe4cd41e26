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

size_t cost_cores(void) {
    return sizeof cores / sizeof cores[0];
}

bool cost_find(const frame_counts *counts, size_t index, cost_figures *figures) {
    const cost_core *core = &cores[index];
    if (counts->stats.passes != 1) {
        return false;
    }
    figures->core = core->name;
    figures->mhz = core->mhz;
    figures->instructions = core->instructions >= 0 ? sum_of(counts, core->instructions) : -1;
    figures->cycles = core->cycles >= 0 ? sum_of(counts, core->cycles) : -1;
    return true;
}

void cost_print(const frame_counts *counts) {
    cost_figures figures;
    if (counts->stats.passes != 1) {
        puts("model none for more than one pass");
        return;
    }
    puts("model not validated on silicon: docs/cost.md");
    for (size_t i = 0; i < cost_cores(); i++) {
        if (cost_find(counts, i, &figures) && figures.instructions >= 0) {
            printf("instructions_%s %.0f\n", figures.core, rounded(figures.instructions));
        }
    }
    for (size_t i = 0; i < cost_cores(); i++) {
        if (cost_find(counts, i, &figures) && figures.cycles >= 0) {
            printf("ms_%s_%dmhz %.6g\n", figures.core, figures.mhz, rounded(figures.cycles / (1e3 * figures.mhz)));
        }
    }
}
