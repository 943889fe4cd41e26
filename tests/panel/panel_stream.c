/* SPDX-License-Identifier: MIT */
/*
 * What a recorded bus stream puts on the glass: panel_stream [-r DEGREES] MODULE PICTURE.ppm < stream
 *
 *     C 2a           bytes with D/C low, hexadecimal, any number in a line
 *     D 00 10        bytes with D/C high
 *     T 120000       microseconds that pass
 *     H 10000000     the bus clock from here on, Hz
 *     R 1            reset is pulled low; R 0: let go
 *     P FILE.ppm     writes the picture as it is here
 *     # anything     a comment
 *
 * -r turns the picture back by as much as the driver turned it. Complaints go to stdout, one a line. Exit status: 0,
 * 1 when the model complained, 2 when the stream or the arguments are wrong.
 */
#include "panel_model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STATUS_COMPLAINED = 1, STATUS_WRONG = 2 };

typedef struct stream {
    panel_model *model;
    int quarters; /* the picture stands turned by so many quarter turns, clockwise */
    unsigned long line;
} stream;

/* ---- Pictures --------------------------------------------------------------------------------------------------- */

/* Where pixel (x, y) of the picture, turned back, lies on the glass. */
static const uint8_t *find_pixel(const panel_picture *glass, int quarters, int x, int y) {
    const int across[4] = {x, glass->width - 1 - y, glass->width - 1 - x, y};
    const int down[4] = {y, x, glass->height - 1 - y, glass->height - 1 - x};

    return glass->rgb + ((size_t)down[quarters] * (size_t)glass->width + (size_t)across[quarters]) * 3;
}

static int write_picture(const stream *from, const char *path) {
    const panel_picture *glass = panel_model_picture(from->model);
    const int width = from->quarters % 2 ? glass->height : glass->width;
    const int height = from->quarters % 2 ? glass->width : glass->height;
    FILE *file = fopen(path, "wb");
    int failed = file == NULL;

    if (file != NULL) {
        failed = fprintf(file, "P6\n%d %d\n255\n", width, height) < 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                failed |= fwrite(find_pixel(glass, from->quarters, x, y), 1, 3, file) != 3;
            }
        }
        failed |= fclose(file) != 0;
    }
    if (failed) {
        fprintf(stderr, "%s: cannot be written\n", path);
    }
    return failed;
}

/* ---- The stream ------------------------------------------------------------------------------------------------- */

static int complain_about_line(const stream *from, const char *what) {
    fprintf(stderr, "line %lu: %s\n", from->line, what);
    return 1;
}

static int take_bytes(const stream *from, const char *text, void (*take)(panel_model *model, uint8_t byte)) {
    char *end;

    for (;; text = end) {
        const unsigned long byte = strtoul(text, &end, 16);
        if (end == text) {
            return text[strspn(text, " \t\r\n")] == '\0' ? 0 : complain_about_line(from, "not bytes in hexadecimal");
        }
        if (byte > 255) {
            return complain_about_line(from, "not a byte");
        }
        take(from->model, (uint8_t)byte);
    }
}

static int take_number(const stream *from, const char *text, unsigned long long most, unsigned long long *number) {
    char *end;

    *number = strtoull(text, &end, 10);
    if (end == text || end[strspn(end, " \t\r\n")] != '\0' || *number > most) {
        return complain_about_line(from, "not a number in its range");
    }
    return 0;
}

static int take_line(const stream *from, char *line) {
    char *rest = line + 1;
    unsigned long long number = 0;
    int failed = 0;

    switch (line[0]) {
    case 'C':
        return take_bytes(from, rest, panel_model_command);
    case 'D':
        return take_bytes(from, rest, panel_model_data);
    case 'T':
        failed = take_number(from, rest, UINT32_MAX, &number);
        panel_model_delay(from->model, number * 1000);
        return failed;
    case 'H':
        failed = take_number(from, rest, UINT32_MAX, &number);
        panel_model_clock(from->model, (uint32_t)number);
        return failed;
    case 'R':
        failed = take_number(from, rest, 1, &number);
        panel_model_reset(from->model, number != 0);
        return failed;
    case 'P':
        rest += strspn(rest, " \t");
        rest[strcspn(rest, "\r\n")] = '\0';
        return write_picture(from, rest);
    default:
        return line[strspn(line, " \t\r\n")] == '\0' || line[0] == '#' ? 0
                                                                       : complain_about_line(from, "not understood");
    }
}

static int take_stream(stream *from) {
    static char line[1 << 20];

    while (fgets(line, sizeof line, stdin) != NULL) {
        from->line++;
        if (strlen(line) == sizeof line - 1) {
            return complain_about_line(from, "too long");
        }
        if (take_line(from, line)) {
            return 1;
        }
    }
    panel_model_finish(from->model);
    return 0;
}

/* ---- Report ----------------------------------------------------------------------------------------------------- */

static int report(const panel_model *model) {
    panel_note notes[PANEL_NOTES_MAX];
    const unsigned count = panel_model_notes(model, notes);
    const unsigned all = panel_model_all_complaints(model);

    for (unsigned i = 0; i < count; i++) {
        printf("byte %llu, command %02x: %s\n", (unsigned long long)notes[i].byte, notes[i].command,
               panel_complaint_text(notes[i].complaint));
    }
    if (all > count) {
        printf("and %u more\n", all - count);
    }
    printf("%llu bytes, %llu pixels, %u complaints\n", (unsigned long long)panel_model_bytes(model),
           (unsigned long long)panel_model_pixels(model), all);
    return all > 0 ? STATUS_COMPLAINED : 0;
}

static int usage(void) {
    fputs("panel_stream [-r 0|90|180|270] MODULE PICTURE.ppm < stream\nmodules:", stderr);
    for (unsigned i = 0; panel_module_name(i) != NULL; i++) {
        fprintf(stderr, " %s", panel_module_name(i));
    }
    fputs("\n", stderr);
    return STATUS_WRONG;
}

int main(int count, char **arguments) {
    static const char *const turns[4] = {"0", "90", "180", "270"};
    stream from = {NULL, 0, 0};
    int status = STATUS_WRONG;

    if (count == 5 && strcmp(arguments[1], "-r") == 0) {
        while (from.quarters < 4 && strcmp(arguments[2], turns[from.quarters]) != 0) {
            from.quarters++;
        }
        arguments += 2;
        count -= 2;
    }
    if (count != 3 || from.quarters == 4) {
        return usage();
    }
    from.model = panel_model_begin(arguments[1]);
    if (from.model == NULL) {
        return usage();
    }
    if (!take_stream(&from) && !write_picture(&from, arguments[2])) {
        status = report(from.model);
    }
    panel_model_end(from.model);
    return status;
}
