/* SPDX-License-Identifier: MIT */
/* Scenes of any values: what bounds and errors are tested with. */
#include "drawing.h"

#include <string.h>

#define VERTICES_MAX 40
#define TRIANGLES_MAX 30

static glint_vector any_vector(source *s) {
    glint_vector vector;
    vector.x = any(s);
    vector.y = any(s);
    vector.z = any(s);
    return vector;
}

/* One time in `odds` any number, else one from 0 to `most`. */
static glint_q16 likely(source *s, uint32_t odds, glint_q16 most) {
    if (below(s, odds) == 1)
        return any(s);
    return (glint_q16)((uint64_t)take(s, 2) * (uint32_t)most / 65535);
}

/* All of int16, or a few values of it, which makes degenerate triangles and ties. */
static int16_t (*take_triples(source *s, uint32_t count))[3] {
    static const int16_t few[8] = {-32768, -16384, -1, 0, 1, 8192, 16384, 32767};
    int16_t(*triples)[3] = allocate(count * sizeof *triples);
    int coarse = below(s, 4) == 1;
    uint32_t state = take(s, 3);
    for (uint32_t i = 0; i < count * 3; i++) {
        uint32_t bits = next_random(&state);
        triples[i / 3][i % 3] = coarse ? few[bits % 8] : (int16_t)bits;
    }
    return triples;
}

static uint16_t (*take_triangles(source *s, uint32_t count, uint32_t vertices))[3] {
    uint16_t(*triangles)[3] = allocate(count * sizeof *triangles);
    uint32_t state = take(s, 3);
    for (uint32_t i = 0; i < count * 3; i++)
        triangles[i / 3][i % 3] = (uint16_t)(next_random(&state) % vertices);
    if (below(s, 16) == 1) {
        uint16_t index = (uint16_t)take(s, 2);
        uint32_t triangle = below(s, count);
        triangles[triangle][below(s, 3)] = index;
    }
    return triangles;
}

/* Arrays of exactly the size that the mesh states, so that reading past them is seen. */
static void take_mesh(source *s, glint_mesh *mesh) {
    mesh->vertex_count = 1 + below(s, VERTICES_MAX);
    mesh->triangle_count = 1 + below(s, TRIANGLES_MAX);
    mesh->positions = (const int16_t(*)[3])take_triples(s, mesh->vertex_count);
    mesh->normals = (const int16_t(*)[3])take_triples(s, mesh->vertex_count);
    mesh->triangles = (const uint16_t(*)[3])take_triangles(s, mesh->triangle_count, mesh->vertex_count);
    mesh->extent.x = likely(s, 8, 4 * GLINT_ONE);
    mesh->extent.y = likely(s, 8, 4 * GLINT_ONE);
    mesh->extent.z = likely(s, 8, 4 * GLINT_ONE);
    if (below(s, 4) == 1)
        mesh->offset = any_vector(s);
    mesh->flags = below(s, 2);
    take_mesh_colours(s, mesh);
}

/* A part of what is left, the last time all of it; now and then something else. */
static uint16_t take_part(source *s, uint32_t *left, int last) {
    const uint32_t part = last ? *left : below(s, *left + 1);
    *left -= part;
    return (uint16_t)(below(s, 64) == 1 ? take(s, 2) : part);
}

/*
 * Clusters of nothing that belongs together: any of them may be dropped. @return 1 where some may look at vertices of
 * others unsaid: which are then drawn, and where, is not told
 */
static int take_clusters(source *s, glint_mesh *mesh) {
    const uint32_t choice = below(s, 4);
    const int is_loose = choice == 1;
    if (choice == 0)
        return 0;
    uint32_t triangles = mesh->triangle_count, vertices = mesh->vertex_count, borrower_count = 0;
    glint_clusters *clusters = allocate(sizeof *clusters);
    clusters->cull = &glint_cull_cones;
    clusters->count = 1 + below(s, 5);
    glint_cluster *list = allocate(clusters->count * sizeof *list);
    for (uint32_t i = 0; i < clusters->count; i++) {
        for (int j = 0; j < 3; j++)
            list[i].axis[j] = (int8_t)take(s, 1);
        list[i].spread = (uint8_t)take(s, 1);
        list[i].spread = (uint8_t)(list[i].spread >> below(s, 8));
        list[i].height = (int16_t)take(s, 2);
        list[i].triangles = take_part(s, &triangles, i + 1 == clusters->count);
        list[i].vertices = take_part(s, &vertices, i + 1 == clusters->count);
        list[i].borrowers = (uint16_t)(is_loose ? below(s, 4) : clusters->count);
        borrower_count += list[i].borrowers;
    }
    uint16_t *borrowers = allocate(borrower_count * sizeof *borrowers);
    for (uint32_t i = 0; i < borrower_count; i++)
        borrowers[i] = (uint16_t)(!is_loose          ? i % clusters->count
                                  : below(s, 8) == 1 ? take(s, 2)
                                                     : below(s, clusters->count));
    clusters->list = list;
    clusters->borrowers = borrowers;
    mesh->clusters = clusters;
    return is_loose;
}

static glint_pose take_pose(source *s) {
    glint_pose pose;
    if (below(s, 8) == 1) {
        for (int i = 0; i < 12; i++)
            pose.m[i / 4][i % 4] = any(s);
        return pose;
    }
    glint_q16 width = likely(s, 4, 2 * GLINT_ONE);
    glint_pose scaling = glint_pose_scale(width, likely(s, 4, 2 * GLINT_ONE), GLINT_ONE);
    glint_pose x = glint_pose_rotate_x(any(s));
    glint_pose y = glint_pose_rotate_y(any(s));
    glint_pose z = glint_pose_rotate_z(any(s));
    pose = glint_pose_then(&scaling, &x);
    pose = glint_pose_then(&pose, &y);
    pose = glint_pose_then(&pose, &z);
    pose.m[0][3] = any(s) / 16;
    pose.m[1][3] = any(s) / 16;
    pose.m[2][3] = (glint_q16)(0u - (uint32_t)likely(s, 4, 8 * GLINT_ONE)); /* the least stays as it is */
    return pose;
}

static glint_colour take_colour(source *s) {
    glint_colour colour;
    glint_q16 most = below(s, 8) == 1 ? GLINT_COLOUR_MAX : GLINT_ONE;
    colour.r = likely(s, 64, most);
    colour.g = likely(s, 64, most);
    colour.b = likely(s, 64, most);
    return colour;
}

static void take_camera(source *s, glint_camera *camera) {
    camera->pose = glint_pose_identity();
    if (below(s, 4) == 1) {
        glint_vector eye = any_vector(s);
        glint_vector at = any_vector(s);
        glint_camera_look_at(camera, eye, at, any_vector(s));
    }
    if (below(s, 32) == 1)
        camera->pose = take_pose(s);
    camera->field_of_view = likely(s, 16, 169 * GLINT_ONE) | GLINT_ONE;
    camera->near_plane = likely(s, 8, GLINT_ONE) | 1;
}

static glint_q16 negated(glint_q16 x) {
    return x == INT32_MIN ? INT32_MAX : -x;
}

static glint_vector opposite(glint_vector v) {
    return (glint_vector){negated(v.x), negated(v.y), negated(v.z)};
}

/* What lamps have beside the rest: mostly sound, so that frames are drawn. */
static void take_lamp(source *s, glint_light *light) {
    static const glint_light_type *const types[4] = {&glint_light_directional, &glint_light_point, &glint_light_spot,
                                                     &glint_light_point};
    light->type = types[below(s, 4)];
    if (light->type == &glint_light_directional)
        return;
    light->linear = likely(s, 32, GLINT_ONE);
    light->quadratic = likely(s, 32, GLINT_ONE);
    light->direction = any_vector(s);
    light->outer = likely(s, 32, 180 * GLINT_ONE);
    light->inner = below(s, 4) == 1 ? light->outer : likely(s, 32, light->outer < 0 ? 0 : light->outer);
}

static void take_lights(source *s, drawing *d) {
    d->scene.light_count = below(s, 32) == 1 ? GLINT_LIGHTS_MAX + 1 : below(s, GLINT_LIGHTS_MAX + 1);
    for (uint32_t i = 0; i < d->scene.light_count; i++) {
        take_lamp(s, &d->lights[i]);
        const glint_vector vector = any_vector(s);
        if (d->lights[i].type == &glint_light_directional)
            d->lights[i].direction = opposite(vector);
        else
            d->lights[i].position = vector;
        d->lights[i].diffuse = take_colour(s);
        d->lights[i].specular = take_colour(s);
    }
    d->scene.lights = d->lights;
}

static void take_objects(source *s, drawing *d) {
    static const glint_shading_model *const models[4] = {&glint_model_blinn_phong, &glint_model_phong,
                                                         &glint_model_lambert, &glint_model_unlit};
    const glint_evaluation *const evaluations[4] = {&glint_per_fragment, &glint_per_fragment, &glint_per_vertex,
                                                    &glint_per_facet};
    d->scene.object_count = below(s, DRAWING_OBJECTS + 1);
    for (uint32_t i = 0; i < d->scene.object_count; i++) {
        d->materials[i].model = models[below(s, 4)];
        d->materials[i].flags = below(s, 32) == 1 ? take(s, 4) : below(s, 4);
        d->materials[i].ambient = take_colour(s);
        d->materials[i].diffuse = take_colour(s);
        d->materials[i].specular = take_colour(s);
        d->materials[i].shininess = likely(s, 4, 64 * GLINT_ONE);
        d->objects[i] = (glint_object){0};
        d->objects[i].mesh = &d->meshes[below(s, DRAWING_MESHES)];
        d->objects[i].material = &d->materials[below(s, i + 1)];
        d->objects[i].evaluation = evaluations[below(s, 4)];
        d->objects[i].pose = take_pose(s);
    }
    d->scene.objects = d->objects;
}

void take_any_scene(source *s, drawing *d) {
    memset(d, 0, sizeof *d);
    take_camera(s, &d->scene.camera);
    d->scene.viewer = (glint_viewer)(below(s, 64) == 1 ? 2 : below(s, 2));
    d->scene.background = take_colour(s);
    d->scene.ambient = take_colour(s);
    for (int i = 0; i < DRAWING_MESHES; i++)
        take_mesh(s, &d->meshes[i]);
    take_objects(s, d);
    take_lights(s, d);
    for (int i = 0; i < DRAWING_MESHES; i++)
        d->is_loose |= take_clusters(s, &d->meshes[i]);
}
