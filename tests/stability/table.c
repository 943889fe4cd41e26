/* SPDX-License-Identifier: MIT */
/* Prints the regions as CSV: what docs/stability.md says of them, and its chart shows. */
#include "region.h"

#include <math.h>
#include <stdio.h>

/* Two decimals, but whole numbers as they are. */
static void print_figure(double figure) {
    if (figure == floor(figure))
        printf(",%.0f", figure);
    else
        printf(",%.2f", figure);
}

/* Texts have commas, and no quotation marks. */
static void print_row(const region *row, const char *topic) {
    region_figures figures = {0};
    row->measure(&figures);
    printf("%s,\"%s\",\"%s\",\"%s\"", topic, row->name, row->plain, row->unit);
    print_figure(figures.plain);
    for (int format = 0; format < 2; format++) {
        print_figure(figures.library[format]);
        printf(",%.2f", figures.bound[format]);
    }
    printf(",\"%s\"\n", row->does);
}

int main(void) {
    puts("topic,region,plain_method,unit,plain,rgb888,rgb888_bound,rgb565,rgb565_bound,does");
    const char *topic;
    const region *row;
    for (unsigned i = 0; (row = region_at(i, &topic)); i++)
        print_row(row, topic);
    return 0;
}
