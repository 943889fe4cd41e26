/* SPDX-License-Identifier: MIT */
/* Checks a configuration and a scene, all but the indices of its meshes, before a frame begins. */
#include "../blend/blend.h"
#include "../light/shading.h"
#include "../light/wear.h"
#include "../pixel/format.h"
#include "frame.h"

/* ---- Configurations ---- */

/* Puts the default in place of 0. @return whether it is a valid tile width or height */
static GLINT_NOINLINE int complete_tile_size(uint16_t *size) {
    if (!*size)
        *size = GLINT_TILE_DEFAULT;
    return *size >= 8 && *size <= GLINT_TILE_MAX && (*size & (*size - 1)) == 0;
}

glint_status glint_check_config(glint_config *config) {
    if (!config->format)
        return GLINT_ERROR_NULL;
    if (config->width < 1 || config->width > GLINT_SIZE_MAX || config->height < 1 || config->height > GLINT_SIZE_MAX)
        return GLINT_ERROR_SIZE;
    if (!complete_tile_size(&config->tile_width) || !complete_tile_size(&config->tile_height))
        return GLINT_ERROR_TILE;
    const int is_large = config->width > GLINT_SIZE_MAX / 2 || config->height > GLINT_SIZE_MAX / 2 ||
                         config->tile_width > GLINT_TILE_MAX / 2 || config->tile_height > GLINT_TILE_MAX / 2;
    return config->samples && is_large ? GLINT_ERROR_SAMPLES : GLINT_OK;
}

glint_status glint_check_region(glint_config *config) {
    glint_rectangle *const region = &config->region;
    const uint8_t *const edge = config->format->edge;
    if (!(region->x | region->y | region->width | region->height)) {
        region->width = (int16_t)config->width;
        region->height = (int16_t)config->height;
    }
    const int32_t right = region->x + region->width, bottom = region->y + region->height;
    if ((region->x | region->y | (region->width - 1) | (region->height - 1) | (config->width - right) |
         (config->height - bottom)) < 0)
        return GLINT_ERROR_REGION;
    const int32_t across = region->x | (right < config->width ? right : 0),
                  down = region->y | (bottom < config->height ? bottom : 0);
    return (across & edge[0]) | (down & edge[1]) ? GLINT_ERROR_REGION : GLINT_OK;
}

/* ---- Scenes ---- */

/* A channel below 0 is far above the largest when unsigned. */
static int colour_is_valid(const glint_colour *colour) {
    const uint32_t most = GLINT_COLOUR_MAX;
    return (uint32_t)colour->r <= most && (uint32_t)colour->g <= most && (uint32_t)colour->b <= most;
}

/* Checks attributes in place of arrays. The function that does it is linked with any type. */
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

/* This is out of line, which is less code than branches across the loop over objects. */
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

static glint_status check_material(const glint_config *config, const glint_material *material) {
    if (!material || !material->model)
        return GLINT_ERROR_NULL;
    if (!colour_is_valid(&material->ambient) || !colour_is_valid(&material->diffuse) ||
        !colour_is_valid(&material->specular))
        return GLINT_ERROR_COLOUR;
    if (material->flags >= 2 * GLINT_MATERIAL_BILINEAR)
        return GLINT_ERROR_FLAGS;
    if (material->blend) {
        const glint_status status = config->layers ? config->layers->check(material) : GLINT_ERROR_LAYERS;
        if (status != GLINT_OK)
            return status;
    }
    return material->shininess < 0 ? GLINT_ERROR_SHININESS : GLINT_OK;
}

/* Checks a texture. The function that does it is linked with any type. */
static glint_status check_texture(const glint_object *object) {
    const glint_texture_type *type = object->material->texture->type;
    return type ? type->stage->check(object->material, object->mesh) : GLINT_ERROR_NULL;
}

/* Checks that an object names where it is lit. An object of one colour need not. */
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
            status = check_material(config, scene->objects[i].material);
        if (status == GLINT_OK && scene->objects[i].material->texture)
            status = check_texture(&scene->objects[i]);
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
    glint_status status = check_lights(scene);
    if (status == GLINT_OK && scene->fog)
        status = scene->fog->type ? scene->fog->type->check(config, scene->fog) : GLINT_ERROR_NULL;
    return status == GLINT_OK ? check_objects(config, scene) : status;
}

/* ---- Sentences ---- */

const char *glint_strerror(int status) {
    static const char *const sentences[] = {
        "no error",
        "a required pointer is null",
        "width or height is not from 1 to 1024",
        "tile width or height is not 8, 16, 32 or 64",
        "the arena is too small for this scene",
        "the camera's axes, field of view, view height or near plane are not valid",
        "more than 8 lights",
        "a light's direction has length 0",
        "a colour, or a light's times a material's, is not from 0 to 16",
        "a shininess exponent is below 0",
        "a mesh's numbers of vertices or triangles, its extent or its clusters are not valid",
        "a triangle refers to a vertex that its mesh does not have",
        "an object's pose is singular",
        "an object is too far from the camera or too large",
        "the flush callback reported a failure",
        "the viewer is neither infinite nor local",
        "an attenuation coefficient is below 0",
        "a spot's cone is wider inside than outside, or not from 0 to 180 degrees",
        "a generator has too few divisions, a size not above 0, or too little room",
        "a number of former versions",
        "a mesh's or a material's flags have an unknown bit",
        "the memory of pixels is smaller than glint_pixels_need tells, or not aligned as a pointer is",
        "a region is not on the screen or panel, or its edges divide a byte of the format",
        "the background or overlay callback reported a failure",
        "the panel's bus took no byte, or did not fall idle, in time",
        "the panel's bus reported a failed transfer",
        "the panel does not take pixels of this size, or its bus no words",
        "the panel's controller cannot turn the picture so",
        "a layout's type does not serve its attribute",
        "a layout's stride is less than its type takes, or not aligned as that is, or its data are not",
        "a texture's width or height is no power of two up to 1024, its key no texel, or its mesh lacks coordinates",
        "a material's blend is unknown, or its opacity is not from 0 to 1",
        "a material blends, or fog fades to a painted background, and the configuration has no layers",
        "fog does not end behind its start, or starts in front of the eye",
        "with samples, width or height is above 512, or a tile's above 32",
        "a line's width is not from 0 to 64 pixels",
    };
    const int count = (int)(sizeof sentences / sizeof *sentences);
    return status > 0 || status <= -count ? "unknown status" : sentences[-status];
}
