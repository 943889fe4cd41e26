/* SPDX-License-Identifier: MIT */
/*
 * Errors against the true smooth surface, over pixels that both cover: a torus of many triangles in double precision
 * stands in for it. Prints format, evaluation, triangles, root mean square and largest error in steps of 8 bits.
 */
#include "glint_extras.h"
#include "picture.h"
#include "reference.h"
#include "shading_scene.h"

#include <math.h>
#include <stdio.h>

#define VERTICES (SHADING_TRUE_AROUND * SHADING_TRUE_ALONG)

static int16_t positions[VERTICES][3], normals[VERTICES][3];
static uint16_t triangles[2 * VERTICES][3];
static const glint_mesh_room room = {positions, normals, triangles, VERTICES, 2 * VERTICES};
static reference_pixel truth[SHADING_WIDTH * SHADING_HEIGHT];

static int build_torus(glint_mesh *mesh, uint32_t around, uint32_t along) {
    return glint_generate_torus(mesh, &room, around, along, GLINT_ONE, GLINT_Q16(0.4)) == GLINT_OK;
}

/*
 * Outlines, where a coarse mesh shows background or another part of the surface: shading is not to blame.
 */
static int is_outline(const reference_pixel *true_pixel, const reference_pixel *of_mesh) {
    return !true_pixel->covered || !of_mesh->covered || fabs(of_mesh->nearest / true_pixel->nearest - 1) > 0.03;
}

/* Compares a picture with the truth where the mesh, in `covered`, and the truth both are. */
static void print_error(const picture *image, const reference_pixel *covered, const char *format,
                        const char *evaluation, uint32_t count) {
    double sum = 0, worst = 0;
    size_t samples = 0;
    for (int i = 0; i < SHADING_WIDTH * SHADING_HEIGHT; i++) {
        if (is_outline(&truth[i], &covered[i]))
            continue;
        for (int c = 0; c < 3; c++) {
            const int level = picture_level(image, i % SHADING_WIDTH, i / SHADING_WIDTH, c);
            const double error = 255 * fabs((double)level / picture_level_max(image->format, c) - truth[i].colour[c]);
            sum += error * error;
            worst = fmax(worst, error);
            samples++;
        }
    }
    printf("%s,%s,%u,%.3f,%.3f\n", format, evaluation, (unsigned)count, sqrt(sum / (double)samples), worst);
}

static int measure(size_t format, uint32_t around, uint32_t along) {
    static reference_pixel covered[SHADING_WIDTH * SHADING_HEIGHT];
    const reference_image image = {SHADING_WIDTH, SHADING_HEIGHT, covered};
    const picture_options options = {0};
    shading_scene s;
    glint_mesh mesh;
    if (!build_torus(&mesh, around, along))
        return 1;
    shading_build(&s, &mesh, &glint_per_fragment);
    reference_render(&image, &s.scene, NULL);
    for (size_t i = 0; i < SHADING_EVALUATIONS; i++) {
        picture drawn = picture_open(SHADING_WIDTH, SHADING_HEIGHT, shading_formats[format].format);
        shading_build(&s, &mesh, shading_evaluations[i].evaluation);
        if (picture_render(&drawn, &s.scene, &options, NULL) != GLINT_OK)
            return 1;
        print_error(&drawn, covered, shading_formats[format].name, shading_evaluations[i].name, mesh.triangle_count);
        picture_close(&drawn);
    }
    return 0;
}

int main(void) {
    const reference_image image = {SHADING_WIDTH, SHADING_HEIGHT, truth};
    shading_scene s;
    glint_mesh mesh;
    if (!build_torus(&mesh, SHADING_TRUE_AROUND, SHADING_TRUE_ALONG))
        return 1;
    puts("format,evaluation,triangles,rms,largest");
    shading_build(&s, &mesh, &glint_per_fragment);
    reference_render(&image, &s.scene, NULL);
    for (size_t format = 0; format < SHADING_FORMATS; format++)
        for (size_t i = 0; i < SHADING_SIZES; i++)
            if (measure(format, shading_sizes[i][0], shading_sizes[i][1]))
                return 1;
    return 0;
}
