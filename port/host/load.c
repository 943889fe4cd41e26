/* SPDX-License-Identifier: MIT */
#include "model.h"

#include "basics.h"
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool load_obj(const char *name, const host_bytes *file, host_model *model, host_problem *problem) {
    obj_materials named;
    if (!obj_read((const char *)file->data, file->count, &model->mesh, &named, &model->warnings, problem)) {
        return false;
    }
    materials_load(name, &named, &model->mesh, &model->materials, &model->warnings);
    obj_materials_free(&named);
    return true;
}

static bool load_mesh(const char *name, const load_options *options, host_model *model, host_problem *problem) {
    const host_shape *shape = shape_find(name);
    memset(&model->materials, 0, sizeof model->materials);
    model->warnings.count = 0;
    model->error = 0;
    if (shape != NULL) {
        model->hash = bytes_hash(name, strlen(name));
        return shape_make(shape, name, &model->mesh, problem);
    }
    host_bytes file;
    if (!bytes_read_file(&file, name, OBJ_FILE_MAX, problem)) {
        return strpbrk(name, "./") == NULL ? shape_offer(problem) : false;
    }
    model->hash = bytes_hash(file.data, file.count);
    const bool is_own = reader_takes(name);
    const bool imported = !is_own && importer_takes(name);
    bool ok = true;
    if (is_own) {
        ok = reader_load(name, &file, &model->mesh, &model->materials, &model->warnings, problem);
    } else if (!imported) {
        ok = load_obj(name, &file, model, problem);
    }
    free(file.data);
    if (imported) {
        ok = importer_load(name, &options->import, &model->mesh, &model->materials, &model->warnings, problem);
    }
    return ok;
}

static void count_normals(host_model *model) {
    model->corner_count = 3 * model->mesh.triangle_count;
    model->given_normals = 0;
    for (size_t i = 0; i < model->corner_count; i++) {
        model->given_normals += model->mesh.triangles[i / 3][i % 3].normal != MESH_NO_NORMAL;
    }
}

/** Numbers the parts of the model by object and then material, and stores their numbers in the triangles. */
static bool number_parts(host_model *model, host_problem *problem) {
    host_mesh *mesh = &model->mesh;
    const size_t objects = model->materials.objects.count + 1;
    const size_t materials = model->materials.used_count + 1;
    uint32_t *numbers = memory_new(objects * materials, sizeof *numbers);
    uint32_t count = 0;
    bool ok = true;
    for (size_t i = 0; ok && i < mesh->triangle_count; i++) {
        ok = mesh->objects[i] < objects;
        numbers[ok ? mesh->objects[i] * materials + mesh->materials[i] : 0] = 1;
    }
    model->parts = memory_new(objects * materials, sizeof *model->parts);
    for (size_t i = 0; i < objects * materials; i++) {
        if (numbers[i] > 0) {
            model->parts[count] = (model_part){(uint32_t)(i / materials), (uint32_t)(i % materials)};
            numbers[i] = count++;
        }
    }
    for (size_t i = 0; ok && i < mesh->triangle_count; i++) {
        mesh->materials[i] = numbers[mesh->objects[i] * materials + mesh->materials[i]];
    }
    free(numbers);
    return ok || problem_set(problem, 0, "--objects: more than %d objects", OBJ_OBJECTS_MAX);
}

bool load_model(const char *name, const load_options *options, host_model *model, host_problem *problem) {
    const bool reduced = options->simplify > 0;
    host_mesh *mesh = &model->mesh;
    if (!load_mesh(name, options, model, problem)) {
        return false;
    }
    model->parts = NULL;
    if (!textures_load(name, options, mesh, &model->materials, &model->warnings, problem) ||
        (options->objects && !number_parts(model, problem))) {
        model_free(model);
        return false;
    }
    model->welded_count = options->weld >= 0 || reduced ? mesh_join(mesh, fmax(options->weld, 0)) : 0;
    count_normals(model);
    model->turned_count = options->repair ? mesh_repair_winding(mesh) : 0;
    if (!options->facets) {
        mesh_make_normals(mesh, &options->normals);
    }
    model->read_count = mesh->triangle_count;
    if (reduced && !mesh_simplify(mesh, options->simplify, &model->error, problem)) {
        model_free(model);
        return false;
    }
    if (options->facets) {
        mesh_make_facet_normals(mesh);
    }
    return true;
}

void model_free(host_model *model) {
    mesh_free(&model->mesh);
    materials_free(&model->materials);
    free(model->parts);
}
