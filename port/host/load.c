/* SPDX-License-Identifier: MIT */
#include "load.h"

#include "output.h"
#include "shapes.h"

#include <stdlib.h>
#include <string.h>

static bool load_mesh(const char *name, host_model *model, host_problem *problem) {
    const host_shape *shape = shape_find(name);
    memset(&model->materials, 0, sizeof model->materials);
    model->warnings.count = 0;
    if (shape != NULL) {
        model->hash = bytes_hash(name, strlen(name));
        return shape_make(shape, name, &model->mesh, problem);
    }
    host_bytes file;
    if (!bytes_read_file(&file, name, OBJ_FILE_MAX, problem)) {
        return false;
    }
    model->hash = bytes_hash(file.data, file.count);
    obj_materials named;
    const bool ok = obj_read((const char *)file.data, file.count, &model->mesh, &named, &model->warnings, problem);
    free(file.data);
    if (ok) {
        materials_load(name, &named, &model->mesh, &model->materials, &model->warnings);
        obj_materials_free(&named);
    }
    return ok;
}

bool load_model(const char *name, const load_options *options, host_model *model, host_problem *problem) {
    if (!load_mesh(name, model, problem)) {
        return false;
    }
    model->corner_count = 3 * model->mesh.triangle_count;
    model->given_normals = 0;
    for (size_t i = 0; i < model->corner_count; i++) {
        model->given_normals += model->mesh.triangles[i / 3][i % 3].normal != MESH_NO_NORMAL;
    }
    model->turned_count = options->repair ? mesh_repair_winding(&model->mesh) : 0;
    if (options->facets) {
        mesh_make_facet_normals(&model->mesh);
    } else {
        mesh_average_normals(&model->mesh, options->crease, options->weights);
    }
    return true;
}

void model_free(host_model *model) {
    mesh_free(&model->mesh);
    materials_free(&model->materials);
}
