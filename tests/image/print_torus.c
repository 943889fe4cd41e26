/* SPDX-License-Identifier: MIT */
/* Prints tests/unit/torus.h: a small torus as constant data, for tests without libm. */
#include "bench.h"

#include <stdio.h>

static void print_triples(const char *declaration, uint32_t count, const int16_t (*triples)[3]) {
    printf("static const %s[%u][3] = {\n", declaration, (unsigned)count);
    for (uint32_t i = 0; i < count; i++) {
        const char *end = i % 4 == 3 || i + 1 == count ? "\n" : " ";
        printf("%s{%d, %d, %d},%s", i % 4 == 0 ? "    " : "", triples[i][0], triples[i][1], triples[i][2], end);
    }
    puts("};");
}

int main(void) {
    static bench_mesh torus;
    static int16_t triangles[BENCH_TRIANGLES_MAX][3];
    bench_build_mesh(&torus, BENCH_TORUS, 12, 6);
    for (uint32_t i = 0; i < 3 * torus.mesh.triangle_count; i++)
        triangles[i / 3][i % 3] = (int16_t)torus.triangles[i / 3][i % 3];
    /* REUSE-IgnoreStart */
    puts("/* SPDX-License-Identifier: MIT */\n/* Made by `make figures`; not to be edited. */\n/* clang-format off "
         "*/");
    /* REUSE-IgnoreEnd */
    puts("#ifndef GLINT_UNIT_TORUS_H\n#define GLINT_UNIT_TORUS_H\n\n#include <stdint.h>\n");
    print_triples("int16_t torus_positions", torus.mesh.vertex_count, torus.mesh.positions);
    print_triples("int16_t torus_normals", torus.mesh.vertex_count, torus.mesh.normals);
    print_triples("uint16_t torus_triangles", torus.mesh.triangle_count, (const int16_t(*)[3])triangles);
    printf("static const int32_t torus_extent[3] = {%d, %d, %d};\n", (int)torus.mesh.extent.x, (int)torus.mesh.extent.y,
           (int)torus.mesh.extent.z);
    puts("\n#endif");
    return 0;
}
