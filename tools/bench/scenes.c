/* SPDX-License-Identifier: MIT */
/* Writes the benchmark scenes as constant data: what firmware without floating point includes. */
#include "bench/bench.h"

#include <stdio.h>

static bench_mesh mesh;

static void write_rows(const char *type, const char *name, const char *array, const int16_t (*rows)[3], uint32_t count) {
    printf("static const %s %s_%s[%u][3] = {\n", type, name, array, (unsigned)count);
    for (uint32_t i = 0; i < count; i++)
        printf("    {%d, %d, %d},\n", rows[i][0], rows[i][1], rows[i][2]);
    printf("};\n");
}

static void write_triangles(const char *name, const bench_mesh *m) {
    printf("static const uint16_t %s_triangles[%u][3] = {\n", name, (unsigned)m->mesh.triangle_count);
    for (uint32_t i = 0; i < m->mesh.triangle_count; i++)
        printf("    {%d, %d, %d},\n", m->triangles[i][0], m->triangles[i][1], m->triangles[i][2]);
    printf("};\n");
}

static void write_mesh(const char *name, const bench_mesh *m) {
    write_rows("int16_t", name, "positions", m->positions, m->mesh.vertex_count);
    write_rows("int16_t", name, "normals", m->normals, m->mesh.vertex_count);
    write_triangles(name, m);
    printf("static const glint_mesh %s_mesh = {%s_positions, %s_normals, %s_triangles, %u, %u,\n", name, name, name, name,
           (unsigned)m->mesh.vertex_count, (unsigned)m->mesh.triangle_count);
    printf("    {%d, %d, %d}, {%d, %d, %d}, 0};\n", m->mesh.offset.x, m->mesh.offset.y, m->mesh.offset.z,
           m->mesh.extent.x, m->mesh.extent.y, m->mesh.extent.z);
}

static void write_poses(const bench_definition *definition) {
    printf("static const glint_pose %s_poses[%d] = {\n", definition->name, BENCH_FRAMES);
    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        bench_scene scene;
        bench_build_scene(&scene, definition, &mesh, frame);
        printf("    {{");
        for (int i = 0; i < 3; i++) {
            const int32_t *row = scene.object.pose.m[i];
            printf("{%d, %d, %d, %d}%s", row[0], row[1], row[2], row[3], i < 2 ? ", " : "}},\n");
        }
    }
    printf("};\n");
}

int main(void) {
    printf("/* Made by tools/bench/scenes.c. */\n#include \"glint.h\"\n");
    for (int i = 0; i < BENCH_SCENES; i++) {
        const bench_definition *definition = &bench_definitions[i];
        bench_build_mesh(&mesh, definition->shape, definition->around, definition->along);
        write_mesh(definition->name, &mesh);
        write_poses(definition);
    }
    printf("static const struct {\n    const char *name;\n    const glint_mesh *mesh;\n    const glint_pose *poses;\n} "
           "bench_scenes[%d] = {\n",
           BENCH_SCENES);
    for (int i = 0; i < BENCH_SCENES; i++) {
        const char *name = bench_definitions[i].name;
        printf("    {\"%s\", &%s_mesh, %s_poses},\n", name, name, name);
    }
    printf("};\n#define BENCH_FRAMES %d\n", BENCH_FRAMES);
    return 0;
}
