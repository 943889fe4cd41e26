/* SPDX-License-Identifier: MIT */
/**
 * @file gltf_data.c
 * Text and GLB, extensions, buffers and accessors of glTF.
 */
#include "gltf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Most numbers of an accessor, and of all that are read: several primitives may read one. */
#define NUMBERS_MAX (16 * (size_t)OBJ_ITEMS_MAX)
#define READ_MAX (64 * (size_t)OBJ_ITEMS_MAX)

/** Bytes of a GLB file's header, and of a chunk's (4.4). */
#define GLB_HEADER_SIZE 12
#define GLB_CHUNK_HEADER_SIZE 8

static bool fail_at(gltf_file *file, const char *kind, size_t number, const char *why) {
    return reader_fail(file->base, "%s %zu %s", kind, number, why);
}

/* ---- Files ------------------------------------------------------------------------------------------------------ */

static gltf_list make_list(const gltf_file *file, const char *name) {
    const json_value *array = json_member(file->root, name);
    gltf_list list = {NULL, json_count(array)};
    list.items = memory_new(list.count, sizeof *list.items); /* NOLINT(bugprone-sizeof-expression): of pointers */
    const json_value *item = json_first(array);
    for (size_t i = 0; i < list.count; i++) {
        list.items[i] = item;
        item = json_next(item);
    }
    return list;
}

/** Finds the chunks of a GLB file: its text, and its binary one, which may be missing. */
static bool find_chunks(gltf_file *file, const char **text, size_t *length) {
    const uint8_t *data = file->base->data;
    const size_t size = file->base->size;
    size_t at = GLB_HEADER_SIZE;
    if (size < GLB_HEADER_SIZE || reader_unsigned(data + 4, 4) != 2) {
        return reader_fail(file->base, "GLB of another version than 2 is not read");
    }
    for (int i = 0; i < 2 && size - at >= GLB_CHUNK_HEADER_SIZE; i++) {
        const size_t chunk = (size_t)reader_unsigned(data + at, 4);
        const uint8_t *kind = data + at + 4;
        at += GLB_CHUNK_HEADER_SIZE;
        if (chunk > size - at) {
            return reader_fail(file->base, "the file is cut off: a chunk has %zu bytes, %zu are left", chunk,
                               size - at);
        }
        if (i == 0 && memcmp(kind, "JSON", 4) == 0) {
            *text = (const char *)data + at;
            *length = chunk;
            while (*length > 0 && (*text)[*length - 1] == '\0') { /* padding by some exporters */
                --*length;
            }
        } else if (i == 1 && memcmp(kind, "BIN\0", 4) == 0) {
            file->chunk = data + at;
            file->chunk_size = chunk;
        }
        at += chunk;
    }
    return *text != NULL || reader_fail(file->base, "the file is cut off: GLB without a chunk of text");
}

/** Says whether an extension's name is one of a list, or begins with one that ends by '_'. */
static bool is_listed(const json_value *name, const char *const list[]) {
    for (size_t i = 0; list[i] != NULL; i++) {
        const size_t length = strlen(list[i]);
        if (json_is(name, list[i]) || (list[i][length - 1] == '_' && name->type == JSON_STRING &&
                                       name->length > length && memcmp(name->start, list[i], length) == 0)) {
            return true;
        }
    }
    return false;
}

/** Refuses what must be understood and is not; warns of what is used and changes how the model looks. */
static bool check_extensions(gltf_file *file) {
    static const char *const followed[] = {"KHR_mesh_quantization",
                                           "KHR_materials_unlit",
                                           "KHR_materials_emissive_strength",
                                           "KHR_materials_pbrSpecularGlossiness",
                                           "FB_ngon_encoding",
                                           NULL};
    static const char *const told_elsewhere[] = {
        "KHR_lights_punctual", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_xmp_", "KHR_xmp", NULL};
    static const char *const looks[] = {"KHR_materials_", NULL};
    const json_value *required = json_member(file->root, "extensionsRequired");
    const json_value *used = json_member(file->root, "extensionsUsed");
    char quote[PROBLEM_QUOTE_SIZE];
    const json_value *name = json_first(required);
    for (size_t i = 0; i < json_count(required); i++) {
        if (!is_listed(name, followed) && !is_listed(name, told_elsewhere) && !is_listed(name, looks)) {
            return reader_fail(file->base, "the file requires '%s', which is not read",
                               problem_quote(quote, name->start, name->length));
        }
        name = json_next(name);
    }
    name = json_first(used);
    for (size_t i = 0; i < json_count(used); i++) {
        if (!is_listed(name, followed) && !is_listed(name, told_elsewhere)) {
            reader_warn(file->base, "the extension '%s' is not followed",
                        problem_quote(quote, name->start, name->length));
        }
        name = json_next(name);
    }
    return true;
}

bool gltf_open(gltf_file *file, model_reader *base) {
    const char *text = (const char *)base->data;
    size_t length = base->size;
    memset(file, 0, sizeof *file);
    file->base = base;
    if (length >= 4 && memcmp(text, "glTF", 4) == 0) {
        text = NULL;
        if (!find_chunks(file, &text, &length)) {
            return false;
        }
    }
    if (!json_parse(text, length, &file->document, base->problem)) {
        return false;
    }
    file->root = file->document.values;
    char *version = json_text(json_member(json_member(file->root, "asset"), "version"));
    const bool known = strncmp(version, "2.", 2) == 0;
    free(version);
    if (!known) {
        return reader_fail(base, "not glTF of version 2");
    }
    file->nodes = make_list(file, "nodes");
    file->meshes = make_list(file, "meshes");
    file->skins = make_list(file, "skins");
    file->materials = make_list(file, "materials");
    file->accessors = make_list(file, "accessors");
    file->views = make_list(file, "bufferViews");
    file->textures = make_list(file, "textures");
    file->images = make_list(file, "images");
    file->samplers = make_list(file, "samplers");
    file->pictures = memory_new(file->images.count, sizeof *file->pictures);
    file->buffer_count = json_count(json_member(file->root, "buffers"));
    file->buffers = memory_new(file->buffer_count, sizeof *file->buffers);
    file->has_buffer = memory_new(file->buffer_count, sizeof *file->has_buffer);
    file->used = memory_new(file->materials.count + 1, sizeof *file->used);
    return check_extensions(file);
}

void gltf_close(gltf_file *file) {
    for (size_t i = 0; i < file->buffer_count; i++) {
        free(file->buffers[i].data);
    }
    free(file->buffers);
    free(file->has_buffer);
    free(file->used);
    free(file->nodes.items);
    free(file->meshes.items);
    free(file->skins.items);
    free(file->materials.items);
    free(file->accessors.items);
    free(file->views.items);
    free(file->textures.items);
    free(file->images.items);
    free(file->samplers.items);
    free(file->pictures);
    json_free(&file->document);
}

const json_value *gltf_item(gltf_file *file, const gltf_list *list, const json_value *object, const char *member,
                            size_t *number) {
    size_t place;
    if (!json_whole(json_member(object, member), &place) || place >= list->count) {
        reader_fail(file->base, "'%s' is missing, or names what is not there", member);
        return NULL;
    }
    if (number != NULL) {
        *number = place;
    }
    return list->items[place];
}

/* ---- Buffers ---------------------------------------------------------------------------------------------------- */

/** The value of a digit of base 64, or -1. */
static int digit_of(char c) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *found = c != '\0' ? strchr(digits, c) : NULL;
    return found != NULL ? (int)(found - digits) : -1;
}

static bool decode_base64(const char *text, host_bytes *bytes) {
    uint32_t bits = 0;
    int count = 0;
    for (; *text != '\0' && *text != '='; text++) {
        const int digit = digit_of(*text);
        if (digit < 0) {
            return false;
        }
        bits = bits << 6 | (uint32_t)digit;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes_add(bytes, (uint8_t)(bits >> count));
        }
    }
    return true;
}

void gltf_unescape(char *uri) {
    char *to = uri;
    for (const char *from = uri; *from != '\0'; from++) {
        char digits[3] = {from[0] == '%' ? from[1] : '\0', from[0] == '%' && from[1] != '\0' ? from[2] : '\0', '\0'};
        char *end;
        const long value = strtol(digits, &end, 16);
        const bool escaped = digits[1] != '\0' && *end == '\0' && value > ' ' - 1;
        *to++ = escaped ? (char)value : *from;
        from += escaped ? 2 : 0;
    }
    *to = '\0';
}

/** Reads a file of the model's folder. */
static bool read_beside(gltf_file *file, const char *name, host_bytes *bytes) {
    const char *model = file->base->path;
    const size_t folder = (size_t)(path_base_name(model) - model);
    char quote[PROBLEM_QUOTE_SIZE];
    host_problem problem;
    problem_quote(quote, name, strlen(name));
    if (!path_is_inside(name)) {
        return reader_fail(file->base, "the buffer '%s' is not in the model's folder", quote);
    }
    char *path = memory_new(folder + strlen(name) + 1, 1);
    memcpy(path, model, folder);
    strcpy(path + folder, name);
    if (!bytes_read_file(bytes, path, OBJ_FILE_MAX, &problem)) {
        memset(bytes, 0, sizeof *bytes);
        free(path);
        return reader_fail(file->base, "the buffer '%s' %s", quote, problem.text);
    }
    host_materials *materials = file->base->materials;
    materials->libraries = memory_grow(materials->libraries, &materials->library_capacity, materials->library_count,
                                       sizeof *materials->libraries);
    host_library *library = &materials->libraries[materials->library_count++];
    library->path = path;
    library->hash = bytes_hash(bytes->data, bytes->count);
    library->warnings.count = 0;
    return true;
}

static bool read_buffer(gltf_file *file, size_t number) {
    const json_value *buffer = json_first(json_member(file->root, "buffers"));
    for (size_t i = 0; i < number; i++) {
        buffer = json_next(buffer);
    }
    host_bytes *bytes = &file->buffers[number];
    const json_value *uri = json_member(buffer, "uri");
    if (uri == NULL) {
        if (number > 0 || file->chunk == NULL) {
            return fail_at(file, "buffer", number, "has neither a uri nor a chunk of GLB");
        }
        bytes->data = memory_new(file->chunk_size, 1);
        memcpy(bytes->data, file->chunk, file->chunk_size);
        bytes->count = file->chunk_size;
        return true;
    }
    char *text = json_text(uri);
    bool ok;
    if (strncmp(text, "data:", 5) == 0) {
        const char *comma = strstr(text, ";base64,");
        ok = (comma != NULL && decode_base64(comma + 8, bytes)) ||
             fail_at(file, "buffer", number, "has a data URI that is not of base 64");
    } else {
        gltf_unescape(text);
        ok = read_beside(file, text, bytes);
    }
    free(text);
    return ok;
}

/** Finds the bytes of the view that an object names, and its stride, if it has one. @return null with a problem */
static const uint8_t *find_view(gltf_file *file, const json_value *object, size_t *size, size_t *stride) {
    size_t number = 0;
    size_t buffer = 0;
    size_t start = 0;
    size_t length = 0;
    const json_value *view = gltf_item(file, &file->views, object, "bufferView", &number);
    if (view == NULL) {
        return NULL;
    }
    json_whole(json_member(view, "byteOffset"), &start);
    json_whole(json_member(view, "byteStride"), stride);
    if (!json_whole(json_member(view, "byteLength"), &length) || !json_whole(json_member(view, "buffer"), &buffer) ||
        buffer >= file->buffer_count) {
        fail_at(file, "view", number, "has no length, or no buffer");
        return NULL;
    }
    if (!file->has_buffer[buffer]) {
        file->has_buffer[buffer] = true;
        if (!read_buffer(file, buffer)) {
            return NULL;
        }
    }
    const host_bytes *bytes = &file->buffers[buffer];
    if (bytes->data == NULL || start > bytes->count || length > bytes->count - start) {
        reader_fail(file->base, "buffer %zu is cut off: it has %zu bytes, view %zu ends at %zu", buffer, bytes->count,
                    number, start + length);
        return NULL;
    }
    *size = length;
    return bytes->data + start;
}

/**
 * Finds where the elements of an accessor, or of a part of a sparse one, begin in its view.
 * @param left set to the bytes of the view from there on
 * @return null with a problem
 */
static const uint8_t *find_elements(gltf_file *file, const json_value *object, size_t *left, size_t *stride) {
    size_t offset = 0;
    size_t length = 0;
    const uint8_t *bytes = find_view(file, object, &length, stride);
    if (bytes == NULL) {
        return NULL;
    }
    json_whole(json_member(object, "byteOffset"), &offset);
    *left = offset < length ? length - offset : 0;
    return bytes + (offset < length ? offset : length);
}

bool gltf_read_image(gltf_file *file, const json_value *image, host_bytes *bytes) {
    char *uri = json_text(json_member(image, "uri"));
    const char *comma = strstr(uri, ";base64,");
    size_t size = 0;
    size_t stride;
    bool ok = true;
    memset(bytes, 0, sizeof *bytes);
    if (uri[0] != '\0') {
        ok = (comma != NULL && decode_base64(comma + 8, bytes)) ||
             reader_fail(file->base, "an image has a data URI that is not of base64");
    } else {
        const uint8_t *from = find_view(file, image, &size, &stride);
        ok = from != NULL;
        bytes->data = memory_new(size + 1, 1);
        bytes->count = bytes->capacity = ok ? size : 0;
        memcpy(bytes->data, ok ? from : bytes->data, bytes->count);
    }
    free(uri);
    return ok;
}

/* ---- Accessors -------------------------------------------------------------------------------------------------- */

/** A type of components. */
typedef struct component {
    size_t size;
    char kind;   /* i for integers, u for unsigned ones, f for floating point */
    double full; /* what normalised integers are divided by (3.11) */
} component;

static const component *find_component(const json_value *object) {
    static const component types[] = {{1, 'i', 127}, {1, 'u', 255},          {2, 'i', 32767}, {2, 'u', 65535},
                                      {0, 0, 0},     {4, 'u', 4294967295.0}, {4, 'f', 1}};
    size_t number = 0;
    json_whole(json_member(object, "componentType"), &number);
    return number >= 5120 && number <= 5126 && number != 5124 ? &types[number - 5120] : NULL;
}

static size_t width_of(const json_value *accessor) {
    static const struct {
        const char *name;
        size_t width;
    } types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (json_is(json_member(accessor, "type"), types[i].name)) {
            return types[i].width;
        }
    }
    return 0;
}

static double decode(const component *type, const uint8_t *bytes, bool normalised) {
    if (type->kind == 'f') {
        return reader_float(bytes);
    }
    const double bits = (double)reader_unsigned(bytes, type->size);
    const double half = ldexp(1, (int)(8 * type->size - 1));
    const double value = type->kind == 'i' && bits >= half ? bits - 2 * half : bits;
    return normalised ? fmax(value / type->full, -1) : value;
}

/** Reads elements that stand one after another. @param places where each goes among the values; null for their order */
static bool read_elements(gltf_file *file, const json_value *object, const component *type, bool normalised,
                          size_t count, const gltf_numbers *places, gltf_numbers *numbers) {
    const size_t size = type->size * numbers->width;
    size_t stride = size;
    size_t left;
    if (count == 0) {
        return true;
    }
    const uint8_t *bytes = find_elements(file, object, &left, &stride);
    if (bytes == NULL) {
        return false;
    }
    if (stride < size || stride > 255) {
        return reader_fail(file->base, "a view has a stride of %zu bytes, its elements %zu", stride, size);
    }
    if (left < size || (left - size) / stride < count - 1) {
        return reader_fail(file->base, "a view is too short for the %zu elements of its accessor", count);
    }
    for (size_t i = 0; i < count; i++) {
        const double place = places != NULL ? places->values[i] : (double)i;
        if (!(place < (double)numbers->count)) {
            return reader_fail(file->base, "a sparse accessor names element %.0f of %zu", place, numbers->count);
        }
        double *to = numbers->values + (size_t)place * numbers->width;
        for (size_t j = 0; j < numbers->width; j++) {
            to[j] = decode(type, bytes + i * stride + j * type->size, normalised);
        }
    }
    return true;
}

/** Replaces some elements (3.6.2.3). */
static bool read_sparse(gltf_file *file, const json_value *sparse, const component *type, bool normalised,
                        gltf_numbers *numbers) {
    const json_value *indices = json_member(sparse, "indices");
    const component *index_type = find_component(indices);
    gltf_numbers places = {NULL, 0, 1};
    if (!json_whole(json_member(sparse, "count"), &places.count) || places.count > numbers->count ||
        index_type == NULL || index_type->kind != 'u') {
        return reader_fail(file->base, "a sparse accessor has no right count or indices");
    }
    places.values = memory_new(places.count, sizeof *places.values);
    const bool ok =
        read_elements(file, indices, index_type, false, places.count, NULL, &places) &&
        read_elements(file, json_member(sparse, "values"), type, normalised, places.count, &places, numbers);
    free(places.values);
    return ok;
}

bool gltf_read_numbers(gltf_file *file, const json_value *object, const char *member, size_t least, size_t most,
                       gltf_numbers *numbers) {
    size_t number;
    numbers->values = NULL;
    const json_value *accessor = gltf_item(file, &file->accessors, object, member, &number);
    if (accessor == NULL) {
        return false;
    }
    const component *type = find_component(accessor);
    const json_value *sparse = json_member(accessor, "sparse");
    const bool normalised = json_true(json_member(accessor, "normalized"));
    numbers->width = width_of(accessor);
    if (type == NULL || numbers->width < least || numbers->width > most ||
        !json_whole(json_member(accessor, "count"), &numbers->count)) {
        return fail_at(file, "accessor", number, "has no count, or not a type that its use takes");
    }
    if (numbers->count > NUMBERS_MAX / numbers->width ||
        numbers->count * numbers->width > READ_MAX - file->read_count) {
        return fail_at(file, "accessor", number, "has more numbers than are read");
    }
    file->read_count += numbers->count * numbers->width;
    numbers->values = memory_new(numbers->count * numbers->width, sizeof *numbers->values);
    if ((json_member(accessor, "bufferView") != NULL &&
         !read_elements(file, accessor, type, normalised, numbers->count, NULL, numbers)) ||
        (sparse != NULL && !read_sparse(file, sparse, type, normalised, numbers))) {
        free(numbers->values);
        numbers->values = NULL;
        return false;
    }
    return true;
}
