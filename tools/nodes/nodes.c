/* SPDX-License-Identifier: MIT */
/*
 * Pictures of light at nodes, as the library decided it while it drew example scenes: `nodes nodes.svg` writes where
 * nodes lie, `nodes ways.svg` how each pixel was lit. The scenes' objects are lit per node.
 */
#include "memory.h"
#include "picture.h"
#include "scenes/scenes.h"
#include "watch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Ways of light at nodes: those before WAY_CORNERS. */
enum { WAYS_SHOWN = WAY_CORNERS };

/* A way's colour, until the next call. */
static const char *colour_of(way how) {
    static char text[8];
    const uint8_t *colour = watch_looks[how].colour;
    snprintf(text, sizeof text, "#%02x%02x%02x", colour[0], colour[1], colour[2]);
    return text;
}

/* ---- Scenes ---- */

/* A variant of an example scene, and what was seen of it. */
typedef struct shot {
    watched seen;
    picture image;
} shot;

static const example_scene *find(const char *scene, const char *variant, uint32_t *number) {
    for (int i = 0; i < EXAMPLE_SCENES; i++)
        for (uint32_t j = 0; j < example_scenes[i]->variant_count; j++)
            if (strcmp(example_scenes[i]->name, scene) == 0 &&
                strcmp(example_scenes[i]->variants[j].name, variant) == 0) {
                *number = j;
                return example_scenes[i];
            }
    fprintf(stderr, "no %s:%s\n", scene, variant);
    exit(1);
}

/* Draws a variant of an example scene; ends the program where there is none. */
static shot shoot(const char *scene, const char *variant) {
    static example_stage stage;
    uint32_t number;
    const example_scene *found = find(scene, variant, &number);
    const size_t pixels = (size_t)found->width * found->height;
    shot taken = {{found->width, found->height, memory_new(pixels, 1), NULL, NULL, 0},
                  picture_open(found->width, found->height, &glint_format_rgb565)};
    taken.seen.owners = memory_new(pixels, sizeof *taken.seen.owners);
    taken.seen.areas = memory_new(WATCH_AREAS_MAX, sizeof *taken.seen.areas);
    found->build(&stage, number, 0);
    watch_into(&taken.seen);
    if (picture_render(&taken.image, &stage.scene, NULL, NULL) != GLINT_OK) {
        fprintf(stderr, "%s:%s is refused\n", scene, variant);
        exit(1);
    }
    watch_into(NULL);
    return taken;
}

static void discard(shot *taken) {
    picture_close(&taken->image);
    free(taken->seen.ways);
    free(taken->seen.owners);
    free(taken->seen.areas);
}

/* ---- SVG ---- */

static void begin(int width, int height, const char *title) {
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n", width,
           height, width, height);
    printf("<!-- Written by `make nodes`, not to be edited. -->\n<title>%s</title>\n", title);
    puts("<style>.paper{fill:#fcfcfb}.n,.m{stroke:#000;stroke-width:.08}.n{fill:#fff}.m{fill:#ffd54a}"
         "text{fill:#24292f;font:12px DejaVu Sans,Verdana,Helvetica,Arial,sans-serif}"
         "@media (prefers-color-scheme: dark){.paper{fill:#161b22}text{fill:#e6edf3}}</style>");
    printf("<rect class=\"paper\" width=\"%d\" height=\"%d\"/>\n", width, height);
}

static void text(int x, int y, const char *anchor, const char *words) {
    printf("<text x=\"%d\" y=\"%d\" text-anchor=\"%s\">%s</text>\n", x, y, anchor, words);
}

static void swatch(int x, int y, const char *colour) {
    printf("<rect x=\"%d\" y=\"%d\" width=\"14\" height=\"14\" fill=\"%s\"/>\n", x, y, colour);
}

/* ---- Ways: how each pixel was lit ---- */

static const struct {
    const char *scene, *variant;
} shown[] = {{"phong-lighting", "plain"}, {"phong-lighting", "ring"}, {"three-spheres", "phong"},
             {"teapot", "fragment"},      {"halloween", "night"},     {"surfaces", "ungated"}};
enum { SHOWN = sizeof shown / sizeof shown[0], ACROSS = 3, GAP = 16, PANEL_WIDTH = 320, PANEL_HEIGHT = 240, LINE = 20 };

/* One path of all pixels of a way, run by run. */
static void print_way(const watched *seen, way how) {
    const int width = seen->width;
    printf("<path fill=\"%s\" d=\"", colour_of(how));
    for (int y = 0; y < seen->height; y++) {
        const uint8_t *row = seen->ways + y * width;
        for (int x = 0, end; x < width; x = end) {
            for (end = x + 1; end < width && row[end] == row[x];)
                end++;
            if (row[x] == how)
                printf("M%d %dh%dv1h-%dz", x, y, end - x, end - x);
        }
    }
    puts("\"/>");
}

static void count_ways(const watched *seen, long counts[WAYS]) {
    memset(counts, 0, WAYS * sizeof counts[0]);
    for (int i = 0; i < seen->width * seen->height; i++)
        counts[seen->ways[i]]++;
}

/* A picture's panel. */
static void print_panel(const watched *seen, int i, const long counts[WAYS]) {
    const int left = GAP + i % ACROSS * (PANEL_WIDTH + GAP), top = 28 + i / ACROSS * (PANEL_HEIGHT + 36);
    char title[80];
    snprintf(title, sizeof title, "%s:%s", shown[i].scene, shown[i].variant);
    text(left, top - 7, "start", title);
    printf("<g transform=\"translate(%d %d)\" shape-rendering=\"crispEdges\">\n", left, top);
    printf("<rect width=\"%d\" height=\"%d\"/>\n", seen->width, seen->height);
    for (int how = WAY_FAST; how < WAYS_SHOWN; how++)
        if (counts[how])
            print_way(seen, (way)how);
    puts("</g>");
}

/* Percent of all pixels that are lit. */
static void print_share(int x, int y, const long counts[WAYS], int how) {
    char share[48];
    long lit = 0;
    for (int i = WAY_FAST; i < WAYS; i++)
        lit += counts[i];
    const long tenths = (2000 * counts[how] + lit) / (2 * lit);
    snprintf(share, sizeof share, "%ld.%ld", tenths / 10, tenths % 10);
    text(x, y, "end", counts[how] ? share : "-");
}

static void print_table(int top, long counts[SHOWN][WAYS]) {
    text(GAP, top, "start", "% of the pixels that show an object, lit by");
    for (int i = 0; i < SHOWN; i++)
        text(440 + 112 * i, top, "end", shown[i].scene);
    for (int i = 0; i < SHOWN; i++)
        text(440 + 112 * i, top + 16, "end", shown[i].variant);
    for (int how = WAY_FAST; how < WAYS_SHOWN; how++) {
        const int y = top + 18 + LINE * how;
        swatch(GAP, y - 11, colour_of((way)how));
        text(GAP + 22, y, "start", watch_looks[how].name);
        for (int i = 0; i < SHOWN; i++)
            print_share(440 + 112 * i, y, counts[i], how);
    }
}

static void draw_ways(void) {
    long counts[SHOWN][WAYS];
    const int bottom = 28 + SHOWN / ACROSS * (PANEL_HEIGHT + 36);
    begin(GAP + ACROSS * (PANEL_WIDTH + GAP), bottom + 28 + LINE * WAYS_SHOWN, "How pixels are lit, in RGB565");
    for (int i = 0; i < SHOWN; i++) {
        shot taken = shoot(shown[i].scene, shown[i].variant);
        count_ways(&taken.seen, counts[i]);
        print_panel(&taken.seen, i, counts[i]);
        discard(&taken);
    }
    print_table(bottom, counts);
    puts("</svg>");
}

/* ---- Nodes: where they lie ---- */

/* A part of a picture, each of its pixels `scale` wide. */
typedef struct crop {
    const char *scene, *variant, *title;
    int left, top, width, height, scale;
} crop;

static const crop crops[] = {
    {"teapot", "fragment", "teapot:fragment, triangles by their own nodes", 192, 80, 42, 42, 12},
    {"phong-lighting", "near", "phong-lighting:near, squares of the lattice", 168, 144, 63, 63, 8},
};
enum { CROPS = sizeof crops / sizeof crops[0], CROP_SIZE = 504, CROP_PIXELS = 63 * 63 };

static unsigned colour_at(const picture *image, int x, int y) {
    unsigned colour = 0;
    for (int c = 0; c < 3; c++)
        colour = colour << 8 | (unsigned)(255 * picture_level(image, x, y, c) / picture_level_max(image->format, c));
    return colour;
}

/* All pixels of one colour. */
static void print_colour(const unsigned *colours, const crop *of, unsigned colour) {
    printf("<path fill=\"#%06x\" d=\"", colour);
    for (int y = 0; y < of->height; y++)
        for (int x = 0, end; x < of->width; x = end) {
            const unsigned *row = colours + y * of->width;
            for (end = x + 1; end < of->width && row[end] == row[x];)
                end++;
            if (row[x] == colour)
                printf("M%d %dh%dv1h-%dz", of->left + x, of->top + y, end - x, end - x);
        }
    puts("\"/>");
}

static void print_pixels(const picture *image, const crop *of) {
    static unsigned colours[CROP_PIXELS];
    for (int i = 0; i < of->width * of->height; i++)
        colours[i] = colour_at(image, of->left + i % of->width, of->top + i / of->width);
    for (int i = 0, before; i < of->width * of->height; i++) {
        for (before = 0; colours[before] != colours[i];)
            before++;
        if (before == i)
            print_colour(colours, of, colours[i]);
    }
}

/* Which areas light pixels of a crop. */
static void find_areas(const watched *seen, const crop *of, uint8_t *is_shown) {
    for (int y = of->top; y < of->top + of->height; y++)
        for (int x = of->left; x < of->left + of->width; x++) {
            const int owner = seen->owners[y * seen->width + x];
            if (owner >= 0)
                is_shown[owner] = 1;
        }
}

static void print_single(const watched *seen, const crop *of) {
    printf("<path fill=\"%s\" fill-opacity=\"0.45\" d=\"", colour_of(WAY_ONE_BY_ONE));
    for (int y = of->top; y < of->top + of->height; y++)
        for (int x = of->left; x < of->left + of->width; x++)
            if (seen->ways[y * seen->width + x] == WAY_ONE_BY_ONE)
                printf("M%d %dh1v1h-1z", x, y);
    puts("\"/>");
}

/* Sixteenths as a decimal number of pixels. */
static void print_place(const char *before, int sixteenths) {
    const int thousandths = sixteenths * 1000 / 16, size = thousandths < 0 ? -thousandths : thousandths;
    printf("%s%s%d.%03d", before, thousandths < 0 ? "-" : "", size / 1000, size % 1000);
}

static void print_outline(const lit_area *area) {
    printf("<path fill=\"none\" stroke=\"#ffffff\" stroke-opacity=\"0.7\" stroke-width=\"0.1\" d=\"");
    for (int i = 0; i < 3; i++) {
        print_place(i ? "L" : "M", area->corners[i].x);
        print_place(" ", area->corners[i].y);
    }
    puts("z\"/>");
}

static void print_square(const lit_area *area) {
    printf("<path fill=\"none\" stroke=\"%s\" stroke-width=\"0.25\" d=\"",
           colour_of(area->size == 16  ? WAY_SQUARES_16
                     : area->size == 8 ? WAY_SQUARES_8
                                       : WAY_SQUARES_4));
    print_place("M", area->nodes[0].x - 8);
    print_place(" ", area->nodes[0].y - 8);
    printf("h%dv%dh-%dz\"/>\n", area->size, area->size, area->size);
}

/* The mark of a triangle in its middle: which polynomials it has. */
static void print_mark(const lit_area *area, way how) {
    printf("<circle r=\"0.4\" fill=\"%s\"", colour_of(how));
    print_place(" cx=\"", (area->corners[0].x + area->corners[1].x + area->corners[2].x) / 3);
    print_place("\" cy=\"", (area->corners[0].y + area->corners[1].y + area->corners[2].y) / 3);
    puts("\"/>");
}

static int is_inside(const crop *of, node_place at) {
    return at.x >= 16 * of->left && at.x <= 16 * (of->left + of->width) && at.y >= 16 * of->top &&
           at.y <= 16 * (of->top + of->height);
}

static void print_nodes(const crop *of, const lit_area *area) {
    for (int i = 0; i < area->node_count; i++) {
        if (!is_inside(of, area->nodes[i]))
            continue;
        const int is_corner = area->size || i < 3;
        printf("<circle class=\"%s\" r=\"%s\"", is_corner ? "n" : "m", is_corner ? ".32" : ".24");
        print_place(" cx=\"", area->nodes[i].x);
        print_place("\" cy=\"", area->nodes[i].y);
        puts("\"/>");
    }
}

/* The way of a triangle that was lit by its own nodes. */
static way way_of(const watched *seen, int area) {
    for (int i = 0; i < seen->width * seen->height; i++)
        if (seen->owners[i] == area && seen->ways[i] != WAY_ONE_BY_ONE)
            return (way)seen->ways[i];
    return WAY_ONE_BY_ONE;
}

/* Is an area the first of its triangle that is shown? */
static int is_first(const watched *seen, const uint8_t *is_shown, int area) {
    for (int i = 0; i < area; i++)
        if (is_shown[i] &&
            memcmp(seen->areas[i].corners, seen->areas[area].corners, sizeof seen->areas[i].corners) == 0)
            return 0;
    return 1;
}

static void print_areas(const watched *seen, const crop *of) {
    static uint8_t is_shown[WATCH_AREAS_MAX];
    memset(is_shown, 0, sizeof is_shown);
    find_areas(seen, of, is_shown);
    for (int i = 0; i < seen->area_count; i++)
        if (is_shown[i] && is_first(seen, is_shown, i))
            print_outline(&seen->areas[i]);
    for (int i = 0; i < seen->area_count; i++)
        if (is_shown[i] && seen->areas[i].size)
            print_square(&seen->areas[i]);
    for (int i = 0; i < seen->area_count; i++) {
        const lit_area *area = &seen->areas[i];
        if (!is_shown[i] || (!area->size && !is_first(seen, is_shown, i)))
            continue;
        if (!area->size && area->node_count)
            print_mark(area, way_of(seen, i));
        print_nodes(of, area);
    }
}

static void print_crop(const crop *of, int i) {
    shot taken = shoot(of->scene, of->variant);
    const int left = GAP + i * (CROP_SIZE + GAP);
    text(left, 21, "start", of->title);
    printf("<svg x=\"%d\" y=\"28\" width=\"%d\" height=\"%d\" viewBox=\"%d %d %d %d\">\n", left, of->width * of->scale,
           of->height * of->scale, of->left, of->top, of->width, of->height);
    puts("<g shape-rendering=\"crispEdges\">");
    print_pixels(&taken.image, of);
    print_single(&taken.seen, of);
    puts("</g>");
    print_areas(&taken.seen, of);
    puts("</svg>");
    discard(&taken);
}

/* What marks mean. */
static void print_key(int top) {
    static const way keys[] = {WAY_PLANES,    WAY_QUADRATICS, WAY_OVER_LENGTH, WAY_SQUARES_16,
                               WAY_SQUARES_8, WAY_SQUARES_4,  WAY_ONE_BY_ONE};
    for (int i = 0; i < (int)(sizeof keys / sizeof keys[0]); i++) {
        const way how = keys[i];
        const int x = GAP + i / 3 * 260, y = top + i % 3 * LINE;
        swatch(x, y - 11, colour_of(how));
        text(x + 22, y, "start", watch_looks[how].name);
    }
    printf("<circle cx=\"%d\" cy=\"%d\" r=\"4\" fill=\"#ffffff\" stroke=\"#000000\"/>\n", GAP + 787, top - 4);
    text(GAP + 802, top, "start", "node: a corner, or of a square");
    printf("<circle cx=\"%d\" cy=\"%d\" r=\"3\" fill=\"#ffd54a\" stroke=\"#000000\"/>\n", GAP + 787, top - 4 + LINE);
    text(GAP + 802, top + LINE, "start", "node: the middle of an edge");
}

static void draw_nodes(void) {
    const int bottom = 28 + CROP_SIZE + 24;
    begin(GAP + CROPS * (CROP_SIZE + GAP), bottom + 3 * LINE, "Where nodes lie");
    for (int i = 0; i < CROPS; i++)
        print_crop(&crops[i], i);
    print_key(bottom);
    puts("</svg>");
}

int main(int count, char *words[]) {
    if (count == 2 && strcmp(words[1], "nodes.svg") == 0)
        draw_nodes();
    else if (count == 2 && strcmp(words[1], "ways.svg") == 0)
        draw_ways();
    else
        return 2;
    return ferror(stdout) || fflush(stdout);
}
