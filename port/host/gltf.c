/* SPDX-License-Identifier: MIT */
/**
 * @file gltf.c
 * Nodes, skins and meshes of glTF 2.0. Section numbers are the specification's.
 */
#include "gltf.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Most sets of joints and weights of a vertex, 4 of each in a set. */
#define SETS_MAX 4

#define NO_NODE SIZE_MAX

/** An affine transform: 3 rows of 4. */
typedef struct placement {
    double m[3][4];
} placement;

typedef struct gltf_scene {
    gltf_file file;
    placement *places; /* of the nodes, in the scene */
    size_t *parents;
    bool *is_placed, *is_drawn;
    size_t *stack;
    size_t other_count; /* points and lines */
} gltf_scene;

/** A primitive while it is added. */
typedef struct gltf_primitive {
    gltf_scene *scene;
    gltf_numbers positions, normals, colours, textures, indices;
    gltf_numbers joints[SETS_MAX], weights[SETS_MAX];
    size_t set_count;
    const placement *place; /* the node's... */
    const placement *bones; /* ...or, of a skin, the joints' */
    size_t bone_count;
    mesh_corner *corners; /* of the vertices; the position is one more than its number, 0 for none yet */
    bool *is_mirrored;
} gltf_primitive;

/* ---- Transforms ------------------------------------------------------------------------------------------------- */

static const placement identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

static placement combine(const placement *outer, const placement *inner) {
    placement result;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 4; column++) {
            double sum = column == 3 ? outer->m[row][3] : 0;
            for (int i = 0; i < 3; i++) {
                sum += outer->m[row][i] * inner->m[i][column];
            }
            result.m[row][column] = sum;
        }
    }
    return result;
}

/** Computes the cofactors, which take normals as the inverse transpose does. @return the determinant */
static double cofactors(const placement *place, double normal[3][3]) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double *a = place->m[(i + 1) % 3];
            const double *b = place->m[(i + 2) % 3];
            normal[i][j] = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
        }
    }
    return place->m[0][0] * normal[0][0] + place->m[0][1] * normal[0][1] + place->m[0][2] * normal[0][2];
}

/** A matrix of 16 numbers, column after column. */
static placement from_columns(const double columns[16]) {
    placement place;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 4; column++) {
            place.m[row][column] = columns[4 * column + row];
        }
    }
    return place;
}

static void read_values(const json_value *object, const char *name, double *values, size_t count) {
    const json_value *array = json_member(object, name);
    const json_value *item = json_first(array);
    for (size_t i = 0; i < count && i < json_count(array); i++) {
        values[i] = json_number(item, values[i]);
        item = json_next(item);
    }
}

/** A node's own transform (3.5.3): a matrix, or a scale, then a rotation by a quaternion, then a translation. */
static placement place_locally(const json_value *node) {
    double columns[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double move[3] = {0, 0, 0};
    double scale[3] = {1, 1, 1};
    double q[4] = {0, 0, 0, 1};
    if (json_member(node, "matrix") != NULL) {
        read_values(node, "matrix", columns, 16);
        return from_columns(columns);
    }
    read_values(node, "translation", move, 3);
    read_values(node, "scale", scale, 3);
    read_values(node, "rotation", q, 4);
    const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double x = length > 0 ? q[0] / length : 0;
    const double y = length > 0 ? q[1] / length : 0;
    const double z = length > 0 ? q[2] / length : 0;
    const double w = length > 0 ? q[3] / length : 1;
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    placement place;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            place.m[row][column] = turn[row][column] * scale[column];
        }
        place.m[row][3] = move[row];
    }
    return place;
}

/* ---- Nodes ------------------------------------------------------------------------------------------------------ */

/** Notes the parent of each node: at most one (3.5.2). */
static bool find_parents(gltf_scene *scene) {
    const gltf_list *nodes = &scene->file.nodes;
    for (size_t i = 0; i < nodes->count; i++) {
        scene->parents[i] = NO_NODE;
    }
    for (size_t i = 0; i < nodes->count; i++) {
        const json_value *children = json_member(nodes->items[i], "children");
        const json_value *child = json_first(children);
        for (size_t j = 0; j < json_count(children); j++) {
            size_t number;
            if (!json_whole(child, &number) || number >= nodes->count || scene->parents[number] != NO_NODE) {
                return reader_fail(scene->file.base, "node %zu has a child that is not there, or is another's", i);
            }
            scene->parents[number] = i;
            child = json_next(child);
        }
    }
    return true;
}

/** Pushes a node's children on the stack, the last one first. @return the stack's new size */
static size_t push_children(gltf_scene *scene, size_t node, size_t count) {
    const json_value *children = json_member(scene->file.nodes.items[node], "children");
    const json_value *child = json_first(children);
    const size_t more = json_count(children);
    for (size_t i = 0; i < more; i++) {
        json_whole(child, &scene->stack[count + more - 1 - i]);
        child = json_next(child);
    }
    return count + more;
}

/** Computes the transforms of all nodes that a node without parent leads to: those of a loop stay as they are. */
static void place_nodes(gltf_scene *scene) {
    const gltf_list *nodes = &scene->file.nodes;
    for (size_t root = 0; root < nodes->count; root++) {
        size_t count = 0;
        if (scene->parents[root] == NO_NODE) {
            scene->stack[count++] = root;
        }
        while (count > 0) {
            const size_t node = scene->stack[--count];
            const size_t parent = scene->parents[node];
            const placement own = place_locally(nodes->items[node]);
            scene->places[node] = parent == NO_NODE ? own : combine(&scene->places[parent], &own);
            scene->is_placed[node] = true;
            count = push_children(scene, node, count);
        }
    }
}

/* ---- Vertices --------------------------------------------------------------------------------------------------- */

/** The transform of a vertex: its node's, or the mean of its joints' (3.7.3.3), whose weights are made to sum to 1. */
static bool place_vertex(const gltf_primitive *primitive, size_t vertex, placement *place) {
    double sum = 0;
    *place = *primitive->place;
    if (primitive->bones == NULL || primitive->set_count == 0) {
        return true;
    }
    placement blended = {{{0}}};
    for (size_t i = 0; i < 4 * primitive->set_count; i++) {
        const double joint = primitive->joints[i / 4].values[4 * vertex + i % 4];
        const double weight = primitive->weights[i / 4].values[4 * vertex + i % 4];
        if (!(weight > 0)) {
            continue;
        }
        if (!(joint >= 0 && joint < (double)primitive->bone_count)) {
            return reader_fail(primitive->scene->file.base, "a vertex names joint %.0f of %zu", joint,
                               primitive->bone_count);
        }
        sum += weight;
        for (int j = 0; j < 12; j++) {
            blended.m[j / 4][j % 4] += weight * primitive->bones[(size_t)joint].m[j / 4][j % 4];
        }
    }
    for (int j = 0; sum > 0 && j < 12; j++) {
        place->m[j / 4][j % 4] = blended.m[j / 4][j % 4] / sum;
    }
    return true;
}

/** Adds a vertex to the mesh, unless it is there. */
static bool add_vertex(gltf_primitive *primitive, size_t vertex) {
    model_reader *base = primitive->scene->file.base;
    mesh_corner *corner = &primitive->corners[vertex];
    placement place;
    double turn[3][3];
    double position[3];
    double normal[3] = {0, 0, 0};
    if (corner->position != 0) {
        return true;
    }
    if (!place_vertex(primitive, vertex, &place)) {
        return false;
    }
    const double sign = cofactors(&place, turn) < 0 ? -1 : 1;
    const double *from = primitive->positions.values + 3 * vertex;
    for (int row = 0; row < 3; row++) {
        const double *m = place.m[row];
        position[row] = m[0] * from[0] + m[1] * from[1] + m[2] * from[2] + m[3];
        for (int i = 0; primitive->normals.values != NULL && i < 3; i++) {
            normal[row] += sign * turn[row][i] * primitive->normals.values[3 * vertex + (size_t)i];
        }
    }
    const gltf_numbers *colours = &primitive->colours;
    if (!reader_add_position(base, position,
                             colours->values != NULL ? colours->values + colours->width * vertex : NULL)) {
        return false;
    }
    primitive->is_mirrored[vertex] = sign < 0;
    corner->position = (uint32_t)base->mesh->position_count;
    corner->normal = reader_add_normal(base, normal);
    if (primitive->textures.values != NULL) {
        const double *at = primitive->textures.values + 2 * vertex;
        corner->texture = mesh_add_texture(base->mesh, at[0], at[1]);
    }
    return true;
}

/** Adds a triangle, the other way round where it is mirrored. */
static bool add_triangle(gltf_primitive *primitive, const size_t places[3]) {
    model_reader *base = primitive->scene->file.base;
    size_t vertices[3];
    for (int i = 0; i < 3; i++) {
        const double index =
            primitive->indices.values != NULL ? primitive->indices.values[places[i]] : (double)places[i];
        if (!(index >= 0 && index < (double)primitive->positions.count)) {
            return reader_fail(base, "a triangle names vertex %.0f of %zu", index, primitive->positions.count);
        }
        vertices[i] = (size_t)index;
        if (!add_vertex(primitive, vertices[i])) {
            return false;
        }
    }
    for (int i = 0; i < 3; i++) {
        const size_t vertex = vertices[primitive->is_mirrored[vertices[0]] ? 2 - i : i];
        mesh_corner corner = primitive->corners[vertex];
        corner.position--;
        reader_add_corner(base, corner);
    }
    return reader_end_face(base, primitive->normals.values == NULL);
}

/** Adds triangles as a list, a strip or a fan (3.7.2.1). */
static bool add_triangles(gltf_primitive *primitive, size_t mode) {
    const size_t count = primitive->indices.values != NULL ? primitive->indices.count : primitive->positions.count;
    for (size_t i = 0; i + 2 < count; i += mode == 4 ? 3 : 1) {
        const size_t list[3] = {i, i + 1, i + 2};
        const size_t strip[3] = {i, i + 1 + i % 2, i + 2 - i % 2};
        const size_t fan[3] = {i + 1, i + 2, 0};
        if (!add_triangle(primitive, mode == 4 ? list : mode == 5 ? strip : fan)) {
            return false;
        }
    }
    return true;
}

/* ---- Primitives ------------------------------------------------------------------------------------------------- */

/** Reads an attribute that may be missing: its values are null then. */
static bool read_attribute(gltf_primitive *primitive, const json_value *attributes, const char *name, size_t least,
                           size_t most, gltf_numbers *numbers) {
    gltf_file *file = &primitive->scene->file;
    if (json_member(attributes, name) == NULL) {
        return true;
    }
    if (!gltf_read_numbers(file, attributes, name, least, most, numbers)) {
        return false;
    }
    return numbers->count == primitive->positions.count || primitive->positions.values == NULL ||
           reader_fail(file->base, "%s has %zu elements, POSITION %zu", name, numbers->count,
                       primitive->positions.count);
}

/** Adds morph targets by the weights that the file gives them (3.7.2.2). */
static bool morph(gltf_primitive *primitive, const json_value *targets, const json_value *weights, const char *name,
                  gltf_numbers *numbers) {
    const json_value *target = json_first(targets);
    const json_value *weight = json_first(weights);
    for (size_t i = 0; i < json_count(targets) && i < json_count(weights) && numbers->values != NULL; i++) {
        const double factor = json_number(weight, 0);
        gltf_numbers moves = {NULL, 0, 3};
        if (fabs(factor) > 0) {
            const bool ok = read_attribute(primitive, target, name, 3, 3, &moves);
            for (size_t j = 0; ok && moves.values != NULL && j < 3 * numbers->count; j++) {
                numbers->values[j] += factor * moves.values[j];
            }
            free(moves.values);
            if (!ok) {
                return false;
            }
        }
        target = json_next(target);
        weight = json_next(weight);
    }
    return true;
}

static bool read_joints(gltf_primitive *primitive, const json_value *attributes) {
    static const char *const names[SETS_MAX][2] = {
        {"JOINTS_0", "WEIGHTS_0"}, {"JOINTS_1", "WEIGHTS_1"}, {"JOINTS_2", "WEIGHTS_2"}, {"JOINTS_3", "WEIGHTS_3"}};
    while (primitive->set_count < SETS_MAX && json_member(attributes, names[primitive->set_count][0]) != NULL &&
           json_member(attributes, names[primitive->set_count][1]) != NULL) {
        const size_t set = primitive->set_count;
        if (!read_attribute(primitive, attributes, names[set][0], 4, 4, &primitive->joints[set]) ||
            !read_attribute(primitive, attributes, names[set][1], 4, 4, &primitive->weights[set])) {
            return false;
        }
        primitive->set_count++;
    }
    return true;
}

static bool read_primitive(gltf_primitive *primitive, const json_value *object, const json_value *weights) {
    gltf_file *file = &primitive->scene->file;
    const json_value *attributes = json_member(object, "attributes");
    const json_value *targets = json_member(object, "targets");
    char set[32];
    snprintf(set, sizeof set, "TEXCOORD_%zu", gltf_texture_set(file, object));
    if (!read_attribute(primitive, attributes, "POSITION", 3, 3, &primitive->positions) ||
        !read_attribute(primitive, attributes, "NORMAL", 3, 3, &primitive->normals) ||
        !read_attribute(primitive, attributes, "COLOR_0", 3, 4, &primitive->colours) ||
        !read_attribute(primitive, attributes, set, 2, 2, &primitive->textures) ||
        !morph(primitive, targets, weights, "POSITION", &primitive->positions) ||
        !morph(primitive, targets, weights, "NORMAL", &primitive->normals) ||
        (primitive->bones != NULL && !read_joints(primitive, attributes)) ||
        (json_member(object, "indices") != NULL &&
         !gltf_read_numbers(file, object, "indices", 1, 1, &primitive->indices))) {
        return false;
    }
    primitive->corners = memory_new(primitive->positions.count, sizeof *primitive->corners);
    primitive->is_mirrored = memory_new(primitive->positions.count, sizeof *primitive->is_mirrored);
    return gltf_use_material(file, object, &file->base->mesh->material);
}

static void free_primitive(gltf_primitive *primitive) {
    for (size_t i = 0; i < SETS_MAX; i++) {
        free(primitive->joints[i].values);
        free(primitive->weights[i].values);
    }
    free(primitive->positions.values);
    free(primitive->normals.values);
    free(primitive->colours.values);
    free(primitive->textures.values);
    free(primitive->indices.values);
    free(primitive->corners);
    free(primitive->is_mirrored);
}

/** Computes where a skin's joints take vertices: each joint's transform after its inverse bind matrix. */
static bool place_bones(gltf_scene *scene, const json_value *skin, placement **bones, size_t *count) {
    gltf_file *file = &scene->file;
    const json_value *joints = json_member(skin, "joints");
    const json_value *joint = json_first(joints);
    gltf_numbers inverse = {NULL, 0, 16};
    *count = json_count(joints);
    if (json_member(skin, "inverseBindMatrices") != NULL &&
        !gltf_read_numbers(file, skin, "inverseBindMatrices", 16, 16, &inverse)) {
        return false;
    }
    bool ok = inverse.values == NULL || inverse.count >= *count ||
              reader_fail(file->base, "a skin has fewer inverse bind matrices than joints");
    *bones = memory_new(*count, sizeof **bones);
    for (size_t i = 0; ok && i < *count; i++) {
        size_t node;
        ok = (json_whole(joint, &node) && node < file->nodes.count && scene->is_placed[node]) ||
             reader_fail(file->base, "a skin has a joint that is not there");
        if (ok) {
            const placement bind = inverse.values != NULL ? from_columns(inverse.values + 16 * i) : identity;
            (*bones)[i] = combine(&scene->places[node], &bind);
        }
        joint = json_next(joint);
    }
    free(inverse.values);
    return ok;
}

/** Adds the primitives of a node's mesh. */
static bool add_mesh(gltf_scene *scene, size_t number, const json_value *mesh, const placement *bones,
                     size_t bone_count) {
    const json_value *node = scene->file.nodes.items[number];
    const json_value *weights = json_member(json_member(node, "weights") != NULL ? node : mesh, "weights");
    const json_value *primitives = json_member(mesh, "primitives");
    const json_value *object = json_first(primitives);
    for (size_t i = 0; i < json_count(primitives); i++) {
        size_t mode = 4;
        json_whole(json_member(object, "mode"), &mode);
        if (mode < 4 || mode > 6) {
            scene->other_count++;
        } else {
            gltf_primitive primitive = {.scene = scene, .place = &scene->places[number]};
            primitive.bones = bones;
            primitive.bone_count = bone_count;
            const bool ok = read_primitive(&primitive, object, weights) && add_triangles(&primitive, mode);
            free_primitive(&primitive);
            if (!ok) {
                return false;
            }
        }
        object = json_next(object);
    }
    return true;
}

/** Starts the object of a node: its name is the node's, the mesh's, or the node's number. */
static void start_object(gltf_file *file, size_t number, const json_value *mesh) {
    const json_value *name = json_member(file->nodes.items[number], "name");
    char *text = json_text(name != NULL ? name : json_member(mesh, "name"));
    char digits[24];
    snprintf(digits, sizeof digits, "%zu", number);
    const char *shown = text[0] != '\0' ? text : digits;
    reader_start_object(file->base, shown, strlen(shown));
    free(text);
}

/** Adds a node's mesh as an object. */
static bool add_node(gltf_scene *scene, size_t number) {
    gltf_file *file = &scene->file;
    const json_value *node = file->nodes.items[number];
    placement *bones = NULL;
    size_t bone_count = 0;
    if (!scene->is_placed[number]) {
        return reader_fail(file->base, "node %zu is below itself", number);
    }
    if (json_member(node, "mesh") == NULL) {
        return true;
    }
    const json_value *mesh = gltf_item(file, &file->meshes, node, "mesh", NULL);
    const json_value *skin = NULL;
    if (mesh == NULL ||
        (json_member(node, "skin") != NULL && (skin = gltf_item(file, &file->skins, node, "skin", NULL)) == NULL)) {
        return false;
    }
    start_object(file, number, mesh);
    const bool ok = (skin == NULL || place_bones(scene, skin, &bones, &bone_count)) &&
                    add_mesh(scene, number, mesh, bones, bone_count);
    free(bones);
    return ok;
}

/* ---- Scenes ----------------------------------------------------------------------------------------------------- */

/** Adds a node and all below it, a node before its children. */
static bool add_tree(gltf_scene *scene, size_t root) {
    size_t count = 1;
    scene->stack[0] = root;
    while (count > 0) {
        const size_t node = scene->stack[--count];
        if (scene->is_drawn[node]) {
            continue;
        }
        scene->is_drawn[node] = true;
        if (!add_node(scene, node)) {
            return false;
        }
        count = push_children(scene, node, count);
    }
    return true;
}

/** Adds the nodes of the scene that the file names, of its first one or, where it has none, all. */
static bool add_scene(gltf_scene *scene) {
    gltf_file *file = &scene->file;
    gltf_list scenes = {NULL, json_count(json_member(file->root, "scenes"))};
    size_t number = 0;
    json_whole(json_member(file->root, "scene"), &number);
    for (size_t i = 0; scenes.count == 0 && i < file->nodes.count; i++) {
        if (scene->parents[i] == NO_NODE && !add_tree(scene, i)) {
            return false;
        }
    }
    if (scenes.count == 0) {
        return true;
    }
    if (number >= scenes.count) {
        return reader_fail(file->base, "scene %zu is not there", number);
    }
    if (scenes.count > 1) {
        reader_warn(file->base, "of %zu scenes only scene %zu is read", scenes.count, number);
    }
    const json_value *chosen = json_first(json_member(file->root, "scenes"));
    for (size_t i = 0; i < number; i++) {
        chosen = json_next(chosen);
    }
    const json_value *roots = json_member(chosen, "nodes");
    const json_value *root = json_first(roots);
    for (size_t i = 0; i < json_count(roots); i++) {
        size_t node;
        if (!json_whole(root, &node) || node >= file->nodes.count) {
            return reader_fail(file->base, "a scene has a node that is not there");
        }
        if (!add_tree(scene, node)) {
            return false;
        }
        root = json_next(root);
    }
    return true;
}

/** Warns of what a file has and a mesh has not. */
static void warn_of_the_rest(gltf_scene *scene) {
    const json_value *root = scene->file.root;
    const json_value *lights =
        json_member(json_member(json_member(root, "extensions"), "KHR_lights_punctual"), "lights");
    const struct {
        const char *what;
        size_t count;
    } rest[] = {{"animations", json_count(json_member(root, "animations"))},
                {"cameras", json_count(json_member(root, "cameras"))},
                {"lights", json_count(lights)},
                {"points and lines", scene->other_count}};
    for (size_t i = 0; i < sizeof rest / sizeof rest[0]; i++) {
        if (rest[i].count > 0) {
            reader_warn(scene->file.base, "%s are skipped (%zu)", rest[i].what, rest[i].count);
        }
    }
    gltf_warn_of_materials(&scene->file);
}

bool gltf_read(model_reader *base) {
    gltf_scene scene = {.other_count = 0};
    bool ok = gltf_open(&scene.file, base);
    if (ok) {
        const size_t count = scene.file.nodes.count;
        scene.places = memory_new(count, sizeof *scene.places);
        scene.parents = memory_new(count, sizeof *scene.parents);
        scene.is_placed = memory_new(count, sizeof *scene.is_placed);
        scene.is_drawn = memory_new(count, sizeof *scene.is_drawn);
        scene.stack = memory_new(count + 1, sizeof *scene.stack);
        ok = find_parents(&scene);
    }
    if (ok) {
        place_nodes(&scene);
        ok = add_scene(&scene);
    }
    if (ok) {
        warn_of_the_rest(&scene);
    }
    free(scene.places);
    free(scene.parents);
    free(scene.is_placed);
    free(scene.is_drawn);
    free(scene.stack);
    gltf_close(&scene.file);
    return ok;
}
