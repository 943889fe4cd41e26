/* SPDX-License-Identifier: MIT */
/* Writes the benchmark scenes as constant data, bench_scenes.h: what firmware without floating point includes. */
#include "bench/bench.h"
#include "quantise.h"

#include <stdio.h>

static bench_mesh mesh;

static void write_rows(const char *name, const char *array, const int16_t (*rows)[3], uint32_t count) {
    printf("static const int16_t %s_%s[%u][3] = {\n", name, array, (unsigned)count);
    for (uint32_t i = 0; i < count; i++) {
        printf("    {%d, %d, %d},\n", rows[i][0], rows[i][1], rows[i][2]);
    }
    printf("};\n");
}

static void write_triangles(const char *name, const bench_mesh *m) {
    printf("static const uint16_t %s_triangles[%u][3] = {\n", name, (unsigned)m->mesh.triangle_count);
    for (uint32_t i = 0; i < m->mesh.triangle_count; i++) {
        printf("    {%d, %d, %d},\n", m->triangles[i][0], m->triangles[i][1], m->triangles[i][2]);
    }
    printf("};\n");
}

static void write_clusters(const char *name, const glint_clusters *clusters) {
    uint32_t borrowers = 0;
    printf("static const glint_cluster %s_cluster_list[%u] = {\n", name, (unsigned)clusters->count);
    for (uint32_t i = 0; i < clusters->count; i++) {
        const glint_cluster *c = &clusters->list[i];
        printf("    {{%d, %d, %d}, %u, %d, %u, %u, %u},\n", c->axis[0], c->axis[1], c->axis[2], c->spread, c->height,
               c->triangles, c->vertices, c->borrowers);
        borrowers += c->borrowers;
    }
    printf("};\nstatic const uint16_t %s_borrowers[%u] = {\n", name, (unsigned)borrowers);
    for (uint32_t i = 0; i < borrowers; i++) {
        printf("    %u,\n", clusters->borrowers[i]);
    }
    printf("};\nstatic const glint_clusters %s_clusters = {&glint_cull_cones, %s_cluster_list, %s_borrowers, %u};\n",
           name, name, name, (unsigned)clusters->count);
}

static void write_vector(const char *field, int32_t x, int32_t y, int32_t z) {
    printf("    .%s = {%ld, %ld, %ld},\n", field, (long)x, (long)y, (long)z);
}

static void write_mesh(const char *name, const bench_mesh *m) {
    write_rows(name, "positions", m->positions, m->mesh.vertex_count);
    write_rows(name, "normals", m->normals, m->mesh.vertex_count);
    write_triangles(name, m);
    write_clusters(name, m->mesh.clusters);
    printf("static const glint_mesh %s_mesh = {\n    .positions = %s_positions,\n    .normals = %s_normals,\n"
           "    .triangles = %s_triangles,\n    .vertex_count = %u,\n    .triangle_count = %u,\n",
           name, name, name, name, (unsigned)m->mesh.vertex_count, (unsigned)m->mesh.triangle_count);
    write_vector("offset", m->mesh.offset.x, m->mesh.offset.y, m->mesh.offset.z);
    write_vector("extent", m->mesh.extent.x, m->mesh.extent.y, m->mesh.extent.z);
    printf("    .clusters = &%s_clusters,\n};\n", name);
}

static void write_poses(const bench_definition *definition) {
    printf("static const glint_pose %s_poses[%d] = {\n", definition->name, BENCH_FRAMES);
    for (int frame = 0; frame < BENCH_FRAMES; frame++) {
        bench_scene scene;
        bench_build_scene(&scene, definition, &mesh, frame);
        printf("    {{");
        for (int i = 0; i < 3; i++) {
            const glint_q16 *row = scene.object.pose.m[i];
            printf("{%ld, %ld, %ld, %ld}%s", (long)row[0], (long)row[1], (long)row[2], (long)row[3],
                   i < 2 ? ", " : "}},\n");
        }
    }
    printf("};\n");
}

static void write_colour(const char *field, glint_colour colour) {
    write_vector(field, colour.r, colour.g, colour.b);
}

/* What all scenes share. */
static void write_light_and_material(void) {
    bench_scene scene;

    bench_build_scene(&scene, &bench_definitions[0], &mesh, 0);
    printf("static const glint_material bench_material = {\n    .model = &glint_model_blinn_phong,\n");
    write_colour("ambient", scene.material.ambient);
    write_colour("diffuse", scene.material.diffuse);
    write_colour("specular", scene.material.specular);
    printf("    .shininess = %ld,\n};\n", (long)scene.material.shininess);
    printf("static const glint_light bench_light = {\n    .type = &glint_light_directional,\n");
    write_vector("direction", scene.light.direction.x, scene.light.direction.y, scene.light.direction.z);
    write_colour("diffuse", scene.light.diffuse);
    write_colour("specular", scene.light.specular);
    printf("};\n#define BENCH_FIELD_OF_VIEW %ld\n#define BENCH_NEAR_PLANE %ld\n#define BENCH_AMBIENT %ld\n",
           (long)scene.scene.camera.field_of_view, (long)scene.scene.camera.near_plane, (long)scene.scene.ambient.r);
}

int main(void) {
    printf("/* Made by tools/bench/scenes.c. */\n#include \"glint.h\"\n#define BENCH_FRAMES %d\n", BENCH_FRAMES);
    for (int i = 0; i < BENCH_SCENES; i++) {
        const bench_definition *definition = &bench_definitions[i];
        bench_build_mesh(&mesh, definition->shape, definition->around, definition->along);
        cluster_mesh(&mesh.mesh);
        write_mesh(definition->name, &mesh);
        write_poses(definition);
        cluster_free(&mesh.mesh);
    }
    write_light_and_material();
    printf("static const struct {\n    const char *name;\n    const glint_mesh *mesh;\n    const glint_pose *poses;\n} "
           "bench_scenes[%d] = {\n",
           BENCH_SCENES);
    for (int i = 0; i < BENCH_SCENES; i++) {
        const char *name = bench_definitions[i].name;
        printf("    {\"%s\", &%s_mesh, %s_poses},\n", name, name, name);
    }
    printf("};\n");
    return ferror(stdout) || fflush(stdout);
}
