/* SPDX-License-Identifier: MIT */
/* Prints the regions as rows of docs/stability.md. */
#include "region.h"

#include <math.h>
#include <stdio.h>

/* Two decimals, but whole numbers as they are. */
static void print_figure(double figure) {
    if (figure == floor(figure))
        printf("%.0f", figure);
    else
        printf("%.2f", figure);
}

static void print_row(const region *row) {
    region_figures figures = {0};
    row->measure(&figures);
    printf("| %s | %s | ", row->name, row->plain);
    print_figure(figures.plain);
    printf(" %s | ", row->unit);
    print_figure(figures.library[0]);
    if (figures.bound[0] > 0)
        printf(" of %.2f", figures.bound[0]);
    printf(" | ");
    print_figure(figures.library[1]);
    if (figures.bound[1] > 0)
        printf(" of %.2f", figures.bound[1]);
    printf(" | %s |\n", row->does);
}

int main(void) {
    puts("| region | plain method | its error | RGB888 | RGB565 | what the library does |");
    puts("| --- | --- | --- | --- | --- | --- |");
    for (unsigned i = 0; region_at(i); i++)
        print_row(region_at(i));
    return 0;
}
