/* SPDX-License-Identifier: MIT */
#include "stage.h"

#include <string.h>

/* Bytes of the largest array of a mesh. */
#define ARRAY_MOST (256u << 10)

void attack_stage_open(attack_stage *stage) {
    for (int i = 0; i < DRAWING_MESHES; i++)
        for (int j = 0; j < STAGE_ARRAYS; j++)
            pages_open(&stage->arrays[i][j], ARRAY_MOST);
    pages_open(&stage->structures, sizeof(props));
    stage->now = pages_place(&stage->structures, sizeof(props), sizeof(void *), 1);
}

void attack_stage_close(attack_stage *stage) {
    for (int i = 0; i < DRAWING_MESHES; i++)
        for (int j = 0; j < STAGE_ARRAYS; j++)
            pages_close(&stage->arrays[i][j]);
    pages_close(&stage->structures);
}

/* ---- Arrays ---- */

/* Copies an array, or null, of elements aligned to `alignment`, into sealed pages. */
static const void *enclose(pages *into, const void *from, size_t size, size_t alignment, int at_end) {
    if (!from)
        return NULL;
    pages_unseal(into);
    void *const to = pages_place(into, size, alignment, at_end);
    memcpy(to, from, size);
    pages_seal(into);
    return to;
}

static size_t size_of(const glint_attribute_type *type) {
    return type == &glint_attribute_octahedral16                                               ? 4
           : type == &glint_attribute_octahedral8 || type == &glint_attribute_rgb565           ? 2
           : type == &glint_attribute_int16 || type == &glint_attribute_uint16 || type == NULL ? 6
                                                                                               : 3;
}

static void enclose_attribute(pages *into, glint_mesh_attribute *attribute, uint32_t count, int at_end) {
    const size_t size = size_of(attribute->type), stride = attribute->stride ? attribute->stride : size;
    attribute->data = enclose(into, attribute->data, stride * (count - 1) + size, size % 2 ? 1 : 2, at_end);
}

static void enclose_layout(pages into[4], glint_mesh *mesh, glint_mesh_layout *layout, int at_end) {
    glint_mesh_attribute *const each[4] = {&layout->positions, &layout->normals, &layout->triangles, &layout->colours};
    for (int i = 0; i < 4; i++)
        enclose_attribute(&into[i], each[i], i == 2 ? mesh->triangle_count : mesh->vertex_count, at_end);
}

static void enclose_clusters(pages into[2], glint_mesh *mesh, glint_clusters *clusters, int at_end) {
    size_t borrowers = 0;
    if (!mesh->clusters)
        return;
    *clusters = *mesh->clusters;
    for (uint32_t i = 0; i < clusters->count; i++)
        borrowers += clusters->list[i].borrowers;
    clusters->list = enclose(&into[0], clusters->list, clusters->count * sizeof *clusters->list, 2, at_end);
    clusters->borrowers = enclose(&into[1], clusters->borrowers, borrowers * sizeof(uint16_t), 2, at_end);
}

static void enclose_mesh(attack_stage *stage, const drawing *d, int which, int at_end) {
    pages *const into = stage->arrays[which];
    glint_mesh *const mesh = &stage->sound.meshes[which];
    const size_t vertices = mesh->vertex_count, triangles = mesh->triangle_count;
    mesh->positions = (const int16_t(*)[3])enclose(&into[0], mesh->positions, vertices * 6, 2, at_end);
    mesh->normals = (const int16_t(*)[3])enclose(&into[1], mesh->normals, vertices * 6, 2, at_end);
    mesh->triangles = (const uint16_t(*)[3])enclose(&into[2], mesh->triangles, triangles * 6, 2, at_end);
    mesh->colours = (const uint8_t(*)[3])enclose(&into[3], mesh->colours, vertices * 3, 1, at_end);
    mesh->colours565 = enclose(&into[4], mesh->colours565, vertices * 2, 2, at_end);
    stage->sound.layouts[which] = d->layouts[which];
    enclose_layout(&into[5], mesh, &stage->sound.layouts[which], at_end);
    enclose_clusters(&into[9], mesh, &stage->sound.clusters[which], at_end);
    mesh->layout = mesh->layout ? &stage->now->layouts[which] : NULL;
    mesh->clusters = mesh->clusters ? &stage->now->clusters[which] : NULL;
}

void attack_stage_take(attack_stage *stage, source *s, int is_usual) {
    drawing d;
    if (is_usual)
        take_usual_scene(s, &d, 1);
    else
        take_any_scene(s, &d);
    take_layouts(s, &d, 1);
    props *const sound = &stage->sound, *const now = stage->now;
    memset(sound, 0, sizeof *sound);
    memcpy(sound->meshes, d.meshes, sizeof d.meshes);
    memcpy(sound->materials, d.materials, sizeof d.materials);
    memcpy(sound->objects, d.objects, sizeof d.objects);
    memcpy(sound->lights, d.lights, sizeof sound->lights);
    sound->scene = d.scene;
    sound->scene.objects = now->objects;
    sound->scene.lights = now->lights;
    for (int i = 0; i < DRAWING_MESHES; i++)
        enclose_mesh(stage, &d, i, (int)below(s, 2));
    for (uint32_t i = 0; i < d.scene.object_count; i++) {
        sound->objects[i].mesh = &now->meshes[d.objects[i].mesh - d.meshes];
        sound->objects[i].material = &now->materials[d.objects[i].material - d.materials];
    }
    stage->is_loose = d.is_loose;
    free_drawing(&d);
    attack_stage_restore(stage);
}

void attack_stage_restore(attack_stage *stage) {
    pages_unseal(&stage->structures);
    memcpy(stage->now, &stage->sound, sizeof stage->sound);
    pages_seal(&stage->structures);
}

/* ---- What is spoilt ---- */

uint32_t attack_number(source *s, uint32_t old) {
    static const uint32_t extremes[] = {0,           1,        0xffffffffu, 0x80000000u, 0x7fffffffu, 0x80000001u,
                                        0x7ffffffeu, 0x10000,  0xffff0000u, 0x7fff,      0x8000,      0xffff,
                                        0x100000,    0x100001, 0xaa0000,    0xaa0001,    0x40000000u, 0xc0000000u};
    switch (below(s, 4)) {
    case 0:
        return old + (below(s, 2) ? 1 : 0xffffffffu);
    case 1:
        return (uint32_t)any(s);
    default:
        return extremes[below(s, sizeof extremes / sizeof *extremes)];
    }
}

/* One of the 32-bit numbers from `first` on. */
static void spoil_number(source *s, void *first, size_t bytes) {
    uint8_t *const at = (uint8_t *)first + 4 * below(s, (uint32_t)(bytes / 4));
    uint32_t number;
    memcpy(&number, at, sizeof number);
    number = attack_number(s, number);
    memcpy(at, &number, sizeof number);
}

/* Counts that lie are told by what the library may look at: no vertices, too many, or fewer than the arrays hold. */
static void spoil_mesh(source *s, glint_mesh *mesh, const glint_mesh *sound) {
    static const uint32_t counts[] = {0, 65537, 0x7fffffffu, 0x80000000u, 0xffffffffu};
    switch (below(s, 10)) {
    case 0:
        mesh->positions = NULL;
        break;
    case 1:
        mesh->normals = NULL;
        break;
    case 2:
        mesh->triangles = NULL;
        break;
    case 3:
        mesh->layout = NULL;
        break;
    case 4:
        mesh->vertex_count = below(s, 2) ? counts[below(s, 5)] : 1 + below(s, sound->vertex_count);
        break;
    case 5:
        mesh->triangle_count = below(s, 2) ? 0 : 1 + below(s, sound->triangle_count);
        break;
    case 6:
        mesh->flags = attack_number(s, mesh->flags);
        break;
    default:
        spoil_number(s, &mesh->offset, sizeof mesh->offset + sizeof mesh->extent);
        break;
    }
}

static void spoil_layout(source *s, glint_mesh_layout *layout) {
    static const glint_attribute_type *const types[] = {NULL,
                                                        &glint_attribute_int16,
                                                        &glint_attribute_int8,
                                                        &glint_attribute_octahedral16,
                                                        &glint_attribute_octahedral8,
                                                        &glint_attribute_rgb888,
                                                        &glint_attribute_rgb565};
    glint_mesh_attribute *const each[4] = {&layout->positions, &layout->normals, &layout->triangles, &layout->colours};
    glint_mesh_attribute *const one = each[below(s, 4)];
    switch (below(s, 3)) {
    case 0: /* one that takes no more bytes, or none that serves */
        one->type =
            one->type == &glint_attribute_int16 || one->type == &glint_attribute_uint16 ? types[below(s, 7)] : NULL;
        break;
    case 1:
        one->stride = below(s, 2) ? 1 : one->stride ? one->stride - 1 : 0;
        break;
    default:
        one->data = below(s, 2) && one->data ? (const uint8_t *)one->data + 1 : NULL;
        one->stride = one->data ? 1 : one->stride;
        break;
    }
}

static void spoil_clusters(source *s, glint_clusters *clusters) {
    static const uint32_t counts[] = {0, 65537, 0xffffffffu};
    switch (below(s, 4)) {
    case 0:
        clusters->count = counts[below(s, 3)];
        break;
    case 1:
        clusters->count -= clusters->count > 0 && clusters->count < 65536; /* never more than there are */
        break;
    case 2:
        clusters->list = NULL;
        break;
    default:
        clusters->borrowers = NULL;
        break;
    }
}

static void spoil_object(source *s, glint_object *object) {
    switch (below(s, 6)) {
    case 0:
        object->mesh = NULL;
        break;
    case 1:
        object->material = NULL;
        break;
    case 2:
        object->hidden = (uint8_t)take(s, 1);
        break;
    default:
        spoil_number(s, &object->pose, sizeof object->pose);
        break;
    }
}

static void spoil_scene(source *s, glint_scene *scene) {
    glint_camera *const camera = &scene->camera;
    switch (below(s, 9)) {
    case 0:
        scene->lights = NULL;
        break;
    case 1:
        scene->light_count = GLINT_LIGHTS_MAX + 1 + (uint32_t)take(s, 4) % 0xfffffff0u;
        break;
    case 2:
        scene->objects = NULL;
        break;
    case 3:
        scene->viewer = (glint_viewer)below(s, 3);
        break;
    case 4:
        spoil_number(s, &scene->background, sizeof scene->background + sizeof scene->ambient);
        break;
    case 5:
        camera->projection = &glint_orthographic;
        camera->view_height = (glint_q16)attack_number(s, GLINT_ONE);
        break;
    default:
        spoil_number(s, &camera->pose, sizeof camera->pose + 2 * sizeof(glint_q16)); /* angle and near plane too */
        break;
    }
}

static void spoil_light(source *s, glint_light *light) {
    if (one_in(s, 8))
        light->type = NULL;
    else if (one_in(s, 8))
        *(below(s, 2) ? &light->position : &light->direction) = (glint_vector){0, 0, 0};
    else
        spoil_number(s, &light->position, sizeof *light - offsetof(glint_light, position));
}

static void spoil_material(source *s, glint_material *material) {
    if (one_in(s, 8))
        material->model = NULL;
    else
        spoil_number(s, &material->ambient, offsetof(glint_material, flags) + 4 - offsetof(glint_material, ambient));
}

static void spoil_one(source *s, props *now, const props *sound) {
    const uint32_t which = below(s, DRAWING_MESHES);
    switch (below(s, 8)) {
    case 0:
        spoil_mesh(s, &now->meshes[which], &sound->meshes[which]);
        break;
    case 1:
        spoil_layout(s, &now->layouts[which]);
        break;
    case 2:
        spoil_clusters(s, &now->clusters[which]);
        break;
    case 3:
        spoil_material(s, &now->materials[below(s, DRAWING_OBJECTS)]);
        break;
    case 4:
        spoil_light(s, &now->lights[below(s, GLINT_LIGHTS_MAX)]);
        break;
    case 5:
        spoil_scene(s, &now->scene);
        break;
    default:
        spoil_object(s, &now->objects[below(s, DRAWING_OBJECTS)]);
        break;
    }
}

void attack_stage_spoil(attack_stage *stage, source *s) {
    pages_unseal(&stage->structures);
    for (uint32_t count = 1 + below(s, 3); count > 0; count--)
        spoil_one(s, stage->now, &stage->sound);
    pages_seal(&stage->structures);
}
