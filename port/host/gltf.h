/* SPDX-License-Identifier: MIT */
/**
 * @file gltf.h
 * Parts of the reader of glTF 2.0: what its buffers hold, and its materials. Section numbers are the specification's.
 */
#ifndef GLINT_HOST_GLTF_H
#define GLINT_HOST_GLTF_H

#include "json.h"
#include "reader.h"

/** The items of an array at the top of the document. */
typedef struct gltf_list {
    const json_value **items;
    size_t count;
} gltf_list;

typedef struct gltf_file {
    model_reader *base;
    json_document document;
    const json_value *root;
    const uint8_t *chunk; /**< The binary chunk of a GLB file, or null. */
    size_t chunk_size;
    gltf_list nodes, meshes, skins, materials, accessors, views, textures, images, samplers;
    host_bytes *buffers; /**< Of each buffer, read when first asked for... */
    bool *has_buffer;    /**< ...which is told here. */
    size_t buffer_count;
    size_t *pictures;  /**< Of each image, its number among the materials' pictures; 0 for none yet. */
    uint32_t *used;    /**< Of each material, and of what has none, its number among those in use; 0 for none yet. */
    size_t read_count; /**< Numbers that were read of accessors, all together. */
} gltf_file;

/** Opens text or GLB: parses it, checks version and extensions. @return false with a problem; gltf_close either way */
bool gltf_open(gltf_file *file, model_reader *base);

void gltf_close(gltf_file *file);

/** The item that a member of an object names by its number; null with a problem when there is none such. */
const json_value *gltf_item(gltf_file *file, const gltf_list *list, const json_value *object, const char *member,
                            size_t *number);

/** Numbers of an accessor. */
typedef struct gltf_numbers {
    double *values; /**< `count` times `width`; free them. */
    size_t count, width;
} gltf_numbers;

/**
 * Reads an accessor (3.6.2), with sparse values and normalised integers.
 * @param member of `object`: the accessor's number
 * @param least, most how many components it may have
 * @return false with a problem; the values are then null
 */
bool gltf_read_numbers(gltf_file *file, const json_value *object, const char *member, size_t least, size_t most,
                       gltf_numbers *numbers);

/** Finds the number of a primitive's material for its triangles; it is added when it is new. @return false with a
 * problem */
bool gltf_use_material(gltf_file *file, const json_value *primitive, uint32_t *number);

/** Returns which set of texture coordinates a primitive's texture takes, by its number. */
size_t gltf_texture_set(gltf_file *file, const json_value *primitive);

/**
 * Reads an image within the file.
 * @param bytes set, of any format; the caller frees its data
 * @return false with a problem
 */
bool gltf_read_image(gltf_file *file, const json_value *image, host_bytes *bytes);

/** Replaces the percent escapes of a URI (RFC 3986, 2.1) in place. */
void gltf_unescape(char *uri);

/** Warns of what materials have and glint does not draw. */
void gltf_warn_of_materials(gltf_file *file);

#endif
