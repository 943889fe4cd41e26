/* SPDX-License-Identifier: MIT */
#include "import.h"

#ifdef HOST_WITH_JPEG

#include "../png.h"

#include <stdio.h> /* before libjpeg's header, which does not include it */
#include <stdlib.h>

#include <jpeglib.h>

#include <jerror.h>

/** Ends the program with libjpeg's message, or with our limit on sides, which libjpeg's own of 65500 is above. */
static void give_up(j_common_ptr common) {
    const struct jpeg_decompress_struct *reader = (j_decompress_ptr)common;
    char text[JMSG_LENGTH_MAX];
    if (reader->image_width > PICTURE_SIDE_MAX || reader->image_height > PICTURE_SIDE_MAX) {
        fprintf(stderr, "it has %ux%u pixels: at most %ux%u are read\n", reader->image_width, reader->image_height,
                PICTURE_SIDE_MAX, PICTURE_SIDE_MAX);
    } else {
        common->err->format_message(common, text);
        fprintf(stderr, "%s\n", text);
    }
    exit(1);
}

/** Takes a warning, whose level is -1, for an error: pixels are missing or wrong. Bytes between segments harm none. */
static void judge_message(j_common_ptr common, int level) {
    if (level < 0 && common->err->msg_code != JWRN_EXTRANEOUS_DATA) {
        give_up(common);
    }
}

const char *jpeg_print(void) {
    struct jpeg_decompress_struct reader;
    struct jpeg_error_mgr errors;
    reader.err = jpeg_std_error(&errors);
    errors.error_exit = give_up;
    errors.emit_message = judge_message;
    jpeg_create_decompress(&reader);
    jpeg_stdio_src(&reader, stdin);
    jpeg_read_header(&reader, TRUE);
    if (reader.image_width > PICTURE_SIDE_MAX || reader.image_height > PICTURE_SIDE_MAX) {
        give_up((j_common_ptr)&reader);
    }
    if (reader.jpeg_color_space == JCS_CMYK || reader.jpeg_color_space == JCS_YCCK) {
        return "its colours are those of print (CMYK): save it as RGB";
    }
    reader.out_color_space = JCS_RGB;
    jpeg_start_decompress(&reader);
    JSAMPARRAY row = reader.mem->alloc_sarray((j_common_ptr)&reader, JPOOL_IMAGE, 3 * reader.output_width, 1);
    const unsigned sides[] = {reader.output_width, reader.output_height};
    for (int i = 0; i < 4; i++) {
        putchar((int)(sides[i / 2] >> (i % 2 == 0 ? 8 : 0) & 0xFF));
    }
    while (reader.output_scanline < reader.output_height) {
        jpeg_read_scanlines(&reader, row, 1);
        fwrite(row[0], 3, reader.output_width, stdout);
    }
    jpeg_finish_decompress(&reader);
    jpeg_destroy_decompress(&reader);
    return fflush(stdout) == 0 && !ferror(stdout) ? NULL : "its output cannot be written";
}

#else

const char *jpeg_print(void) {
    return "glint-import was built without JPEG: install libjpeg-dev, and run make host again";
}

#endif
