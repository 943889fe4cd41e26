/* SPDX-License-Identifier: MIT */
/* Prints tests/image/pixel_table.h: what suite `pixels` holds pictures against. */
#include "pixel_sums.h"

#include <stdio.h>

int main(void) {
    /* REUSE-IgnoreStart */
    puts("/* SPDX-License-Identifier: MIT */\n"
         "/* Made by `make figures`; not to be edited: what every picture came to when it was made. */\n"
         "/* clang-format off */\n"
         "#ifndef GLINT_PIXEL_TABLE_H\n#define GLINT_PIXEL_TABLE_H\n\n#include <stdint.h>\n\n"
         "static const uint32_t pixel_table[] = {");
    /* REUSE-IgnoreEnd */
    for (unsigned i = 0; i < pixel_sums_count; i++) {
        uint32_t found;
        if (!pixel_sums_draw(i, &found)) {
            fprintf(stderr, "%s: a scene is refused\n", pixel_sums_name(i));
            return 1;
        }
        printf("    0x%08xu, /* %s */\n", (unsigned)found, pixel_sums_name(i));
    }
    puts("};\n\n#endif");
    return 0;
}
