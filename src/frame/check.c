/* SPDX-License-Identifier: MIT */
/* Check: a scene, all but its meshes' indices, before a frame begins. */
#include "../geometry/layout.h"
#include "../light/shading.h"
#include "cull.h"
#include "frame.h"

/* Below 0 is far above the largest when unsigned. */
static int colour_is_valid(const glint_colour *colour) {
    const uint32_t most = GLINT_COLOUR_MAX;
    return (uint32_t)colour->r <= most && (uint32_t)colour->g <= most && (uint32_t)colour->b <= most;
}

/* Attributes in place of arrays. What checks them is linked with any type. */
static glint_status check_layout(const glint_mesh *mesh) {
    const glint_mesh_layout *layout = mesh->layout;
    const glint_attribute_type *const type = layout->positions.type   ? layout->positions.type
                                             : layout->normals.type   ? layout->normals.type
                                             : layout->triangles.type ? layout->triangles.type
                                                                      : layout->colours.type;
    if (type)
        return type->stage->check(mesh);
    return mesh->positions && mesh->normals && mesh->triangles ? GLINT_OK : GLINT_ERROR_NULL;
}

/* Out of line, which is less code than branches across the loop over objects. */
static GLINT_NOINLINE glint_status check_mesh(const glint_mesh *mesh, const glint_config *config) {
    if (!mesh)
        return GLINT_ERROR_NULL;
    if (config->skips_degenerate && glint_mesh_is_empty(mesh))
        return GLINT_OK;
    if ((!mesh->positions || !mesh->normals || !mesh->triangles) && !mesh->layout)
        return GLINT_ERROR_NULL;
    if (mesh->vertex_count - 1 >= 65536 || mesh->triangle_count < 1 ||
        (mesh->extent.x | mesh->extent.y | mesh->extent.z) < 0)
        return GLINT_ERROR_MESH;
    if (mesh->flags > GLINT_MESH_DOUBLE_SIDED)
        return GLINT_ERROR_FLAGS;
    if (mesh->layout) {
        const glint_status status = check_layout(mesh);
        if (status != GLINT_OK)
            return status;
    }
    const glint_cull *cull = glint_cull_of(mesh);
    return cull ? cull->check(mesh) : GLINT_OK;
}

static glint_status check_material(const glint_material *material) {
    if (!material || !material->model)
        return GLINT_ERROR_NULL;
    if (!colour_is_valid(&material->ambient) || !colour_is_valid(&material->diffuse) ||
        !colour_is_valid(&material->specular))
        return GLINT_ERROR_COLOUR;
    if (material->flags > (GLINT_MATERIAL_SPECULAR_UNGATED | GLINT_MATERIAL_MAX_WITH_AMBIENT))
        return GLINT_ERROR_FLAGS;
    return material->shininess < 0 ? GLINT_ERROR_SHININESS : GLINT_OK;
}

/* Checks that an object names where it is lit; an object of one colour need not. */
static glint_status check_evaluation(const glint_object *object) {
    const int needs = object->material->model->is_lit || glint_has_colours(object->mesh);
    return needs && !object->evaluation ? GLINT_ERROR_NULL : GLINT_OK;
}

static glint_status check_lights(const glint_scene *scene) {
    if (scene->light_count > GLINT_LIGHTS_MAX)
        return GLINT_ERROR_LIGHTS;
    if (scene->light_count && !scene->lights)
        return GLINT_ERROR_NULL;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        if (!scene->lights[i].type)
            return GLINT_ERROR_NULL;
        if (!colour_is_valid(&scene->lights[i].diffuse) || !colour_is_valid(&scene->lights[i].specular))
            return GLINT_ERROR_COLOUR;
    }
    return GLINT_OK;
}

static glint_status check_objects(const glint_config *config, const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        glint_status status = check_mesh(scene->objects[i].mesh, config);
        if (status == GLINT_OK)
            status = check_material(scene->objects[i].material);
        if (status == GLINT_OK)
            status = check_evaluation(&scene->objects[i]);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}

glint_status glint_check_scene(const glint_config *config, const glint_scene *scene) {
    if (scene->object_count && !scene->objects)
        return GLINT_ERROR_NULL;
    if (!glint_camera_is_valid(&scene->camera))
        return GLINT_ERROR_CAMERA;
    if (scene->viewer != GLINT_VIEWER_INFINITE && scene->viewer != GLINT_VIEWER_LOCAL)
        return GLINT_ERROR_VIEWER;
    if (!colour_is_valid(&scene->background) || !colour_is_valid(&scene->ambient))
        return GLINT_ERROR_COLOUR;
    const glint_status status = check_lights(scene);
    return status == GLINT_OK ? check_objects(config, scene) : status;
}
