/* SPDX-License-Identifier: MIT */
/**
 * @file fuzz_obj.c
 * The reader of OBJ on any bytes (libFuzzer): it either reports one problem, or gives warnings and a mesh that normals
 * can be made for and that quantises into meshes, with clusters, as the library documents them.
 */
#include "checks.h"
#include "model.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    host_mesh mesh;
    obj_materials materials;
    host_warnings warnings;
    host_problem problem = {0, ""};
    if (!obj_read((const char *)data, size, &mesh, &materials, &warnings, &problem)) {
        check_problem(&problem);
        require(problem.line >= 1);
        return 0;
    }
    check_warnings(&warnings, 1);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        require(mesh.materials[i] <= materials.used.count);
    }
    obj_materials_free(&materials);
    check_mesh(&mesh);
    mesh_free(&mesh);
    return 0;
}
