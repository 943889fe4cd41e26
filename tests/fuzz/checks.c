/* SPDX-License-Identifier: MIT */
#include "checks.h"

#include "quantise.h"

#include <math.h>
#include <string.h>

void check_problem(const host_problem *problem) {
    require(problem->text[0] != '\0' && strlen(problem->text) < sizeof problem->text);
    for (const char *c = problem->text; *c != '\0'; c++) {
        require(*c >= ' ' && *c <= '~');
    }
}

void check_warnings(const host_warnings *warnings, size_t least_line) {
    require(warnings->count <= PROBLEM_WARNINGS_MAX);
    for (size_t i = 0; i < warnings->count; i++) {
        check_problem(&warnings->list[i]);
        require(warnings->list[i].line >= least_line && strncmp(warnings->list[i].text, "warning: ", 9) == 0);
    }
}

static void check_colour(const double colour[3]) {
    for (int i = 0; i < 3; i++) {
        require(colour[i] >= 0 && colour[i] <= MTL_COLOUR_MAX);
    }
}

void check_materials(const mtl_library *library) {
    for (size_t i = 0; i < library->count; i++) {
        const mtl_material *material = &library->list[i];
        check_colour(material->ambient);
        check_colour(material->diffuse);
        check_colour(material->specular);
        check_colour(material->emission);
        require(material->shininess >= 0 && material->shininess <= MTL_SHININESS_MAX);
        require(material->illumination >= 0 && material->illumination <= 2 && material->name != NULL);
    }
}

static void check_corners(const host_mesh *mesh) {
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const mesh_corner corner = mesh->triangles[i / 3][i % 3];
        require(corner.position < mesh->position_count && corner.normal < mesh->normal_count);
        const double *normal = mesh->normals[corner.normal];
        const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        require(length > 0.999999 && length < 1.000001);
    }
}

static void check_piece(const glint_mesh *piece) {
    require(piece->vertex_count >= 1 && piece->vertex_count <= 65536 && piece->triangle_count >= 1);
    require(piece->extent.x >= 0 && piece->extent.y >= 0 && piece->extent.z >= 0);
    for (uint32_t i = 0; i < 3 * piece->triangle_count; i++) {
        require(piece->triangles[i / 3][i % 3] < piece->vertex_count);
    }
    for (uint32_t i = 0; i < 3 * piece->vertex_count; i++) {
        require(piece->positions[i / 3][i % 3] >= -32767 && piece->normals[i / 3][i % 3] >= -32767);
    }
}

static void check_clusters(const glint_mesh *piece) {
    const glint_clusters *clusters = piece->clusters;
    uint32_t triangles = 0;
    uint32_t vertices = 0;
    for (uint32_t i = 0; i < clusters->count; i++) {
        triangles += clusters->list[i].triangles;
        vertices += clusters->list[i].vertices;
    }
    for (uint32_t i = 0, count = quantised_borrowers(clusters); i < count; i++) {
        require(clusters->borrowers[i] < clusters->count);
    }
    require(triangles == piece->triangle_count && vertices == piece->vertex_count);
}

static void check_quantised(const host_mesh *mesh) {
    host_problem problem = {0, ""};
    quantised_mesh quantised;
    if (!quantise(mesh, 0, NULL, &quantised, &problem)) {
        check_problem(&problem);
        return;
    }
    require(quantised.triangle_count + quantised.dropped_count == mesh->triangle_count);
    quantised_cluster(&quantised);
    for (size_t i = 0; i < quantised.piece_count; i++) {
        check_piece(&quantised.pieces[i]);
        if (quantised.pieces[i].clusters != NULL) {
            check_clusters(&quantised.pieces[i]);
        }
    }
    quantised_free(&quantised);
}

void check_mesh(host_mesh *mesh) {
    require(mesh->colour_count == 0 || mesh->colour_count == mesh->position_count);
    mesh_make_normals(mesh, &(mesh_normal_rule){40, false, MESH_BY_ANGLE});
    check_corners(mesh);
    mesh_check_topology(mesh);
    check_quantised(mesh);
    mesh_make_normals(mesh, &(mesh_normal_rule){30, true, MESH_BY_AREA});
    check_corners(mesh);
    mesh_repair_winding(mesh);
    check_corners(mesh);
    const mesh_winding winding = mesh_check_winding(mesh);
    require(winding.mixed_parts <= winding.one_sided_parts && winding.one_sided_parts <= winding.part_count);
}
