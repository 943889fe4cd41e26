/* SPDX-License-Identifier: MIT */
/*
 * The judge of images (tests/image/judge.h), which remembers. What it says follows from the task, the scene and what
 * the library drew: where a mutant draws all of that bit for bit as the library did, the reference need not be drawn
 * again. GLINT_JUDGED names the file of what is known; GLINT_JUDGED_ADD, where it is set, says to add to it.
 */
#define judge judge_anew
#include "image/judge.c" /* NOLINT(bugprone-suspicious-include): its functions draw what is looked at here */
#undef judge

#include "every_format.h"
#include "lighting.h"

#include <stdio.h>

/* ---- What a judgement follows from --------------------------------------------------------------------------- */

static void add_bytes(uint64_t *sum, const void *bytes, size_t size) {
    for (size_t at = 0; at < size; at += 8) {
        uint64_t word = 0;
        memcpy(&word, (const char *)bytes + at, size - at < 8 ? size - at : 8);
        *sum = (*sum ^ word) * 0x9e3779b97f4a7c15u;
        *sum ^= *sum >> 32;
    }
}

static void add_number(uint64_t *sum, int64_t number) {
    add_bytes(sum, &number, sizeof number);
}

/* Addresses differ from run to run: which of those the reference tells apart. */
static void add_which(uint64_t *sum, const void *one, const void *const *of, unsigned count) {
    unsigned which = 0;
    while (which < count && of[which] != one)
        which++;
    add_number(sum, which);
}

#define ADD(sum, value) add_bytes(sum, &(value), sizeof(value))
#define ADD_WHICH(sum, one, of) add_which(sum, one, of, (unsigned)(sizeof(of) / sizeof *(of)))

static void add_mesh(uint64_t *sum, const glint_mesh *mesh) {
    ADD(sum, mesh->vertex_count);
    ADD(sum, mesh->triangle_count);
    ADD(sum, mesh->offset);
    ADD(sum, mesh->extent);
    ADD(sum, mesh->flags);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        double found[3][3];
        reference_mesh_position(mesh, i, found[0]);
        reference_mesh_normal(mesh, i, found[1]);
        reference_mesh_colour(mesh, i, found[2]);
        ADD(sum, found);
    }
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t corners[3];
        reference_mesh_corners(mesh, i, corners);
        ADD(sum, corners);
    }
}

static void add_object(uint64_t *sum, const glint_object *object) {
    static const void *const models[] = {&glint_model_lambert, &glint_model_phong, &glint_model_blinn_phong,
                                         &glint_model_unlit};
    static const void *const evaluations[] = {&glint_per_facet, &glint_per_vertex};
    ADD_WHICH(sum, object->evaluation, evaluations);
    ADD_WHICH(sum, object->material->model, models);
    ADD(sum, object->material->ambient);
    ADD(sum, object->material->diffuse);
    ADD(sum, object->material->specular);
    ADD(sum, object->material->shininess);
    ADD(sum, object->material->flags);
    ADD(sum, object->pose);
    ADD(sum, object->hidden);
    add_mesh(sum, object->mesh);
}

static void add_light(uint64_t *sum, const glint_light *light) {
    static const void *const types[] = {&glint_light_directional, &glint_light_point, &glint_light_spot};
    const glint_q16 numbers[] = {light->linear, light->quadratic, light->inner, light->outer};
    ADD_WHICH(sum, light->type, types);
    ADD(sum, light->position);
    ADD(sum, light->direction);
    ADD(sum, light->diffuse);
    ADD(sum, light->specular);
    ADD(sum, numbers);
}

static void add_scene(uint64_t *sum, const glint_scene *scene) {
    ADD(sum, scene->camera.pose);
    ADD(sum, scene->camera.field_of_view);
    ADD(sum, scene->camera.near_plane);
    ADD(sum, scene->camera.view_height);
    add_number(sum, scene->camera.projection != NULL);
    add_number(sum, scene->viewer);
    ADD(sum, scene->background);
    ADD(sum, scene->ambient);
    add_number(sum, scene->light_count);
    add_number(sum, scene->object_count);
    for (uint32_t i = 0; i < scene->light_count; i++)
        add_light(sum, &scene->lights[i]);
    for (uint32_t i = 0; i < scene->object_count; i++)
        add_object(sum, &scene->objects[i]);
}

static void add_task(uint64_t *sum, const judge_task *task) {
    const void *formats[FORMAT_COUNT];
    for (unsigned i = 0; i < FORMAT_COUNT; i++)
        formats[i] = every_format[i];
    ADD_WHICH(sum, task->format, formats);
    ADD(sum, task->width);
    ADD(sum, task->height);
    ADD(sum, task->leave_out_gates);
    ADD(sum, task->fine);
    ADD(sum, task->fine_of);
}

static void add_geometry(uint64_t *sum, const library_geometry *geometry, const glint_scene *scene) {
    ADD(sum, geometry->depth_scale);
    for (uint32_t i = 0; i < scene->object_count; i++)
        add_bytes(sum, geometry->positions[i], scene->objects[i].mesh->vertex_count * sizeof **geometry->positions);
}

/* All that the library draws for a judgement. @return 0 when it refuses */
static int add_drawn(uint64_t *sum, const judge_task *task) {
    picture shaded = picture_open(task->width, task->height, task->format);
    picture coverage = picture_open(task->width, task->height, &glint_format_grey8);
    picture_options options = {0};
    const glint_config config = picture_config(&shaded, &options);
    library_geometry geometry;
    const int drawn = library_geometry_open(&geometry, &config, task->scene) == GLINT_OK &&
                      picture_render(&shaded, task->scene, NULL, NULL) == GLINT_OK &&
                      render_coverage(&coverage, task->scene) == GLINT_OK;
    if (drawn) {
        add_geometry(sum, &geometry, task->scene);
        add_bytes(sum, shaded.bytes, shaded.size);
        add_bytes(sum, coverage.bytes, coverage.size);
    }
    library_geometry_close(&geometry);
    picture_close(&shaded);
    picture_close(&coverage);
    return drawn;
}

/* ---- What is known ------------------------------------------------------------------------------------------- */

typedef struct known {
    uint64_t sum;
    judgement found;
} known;

#define KNOWN_MOST (1 << 15)

static known table[KNOWN_MOST];

/* Where a sum's judgement stands, or would; a sum of 0 marks room. */
static known *place_of(uint64_t sum) {
    known *at = &table[sum % KNOWN_MOST];
    while (at->sum && at->sum != sum)
        at = at == &table[KNOWN_MOST - 1] ? table : at + 1;
    return at;
}

static void read_known(void) {
    static int is_read;
    known one;
    FILE *file = is_read++ ? NULL : fopen(getenv("GLINT_JUDGED"), "rb");
    while (file && fread(&one, sizeof one, 1, file) == 1)
        *place_of(one.sum) = one;
    if (file)
        fclose(file);
}

static void keep(const known *one) {
    FILE *file = fopen(getenv("GLINT_JUDGED"), "ab");
    if (!file || fwrite(one, sizeof *one, 1, file) != 1 || fclose(file))
        abort();
    *place_of(one->sum) = *one;
}

void judge(const judge_task *task, judgement *total) {
    known one = {0};
    read_known();
    add_task(&one.sum, task);
    add_scene(&one.sum, task->scene);
    if (!add_drawn(&one.sum, task)) {
        judge_anew(task, total);
        return;
    }
    const known *const at = place_of(one.sum);
    if (at->sum) {
        judgement_add(total, &at->found);
        return;
    }
    judge_anew(task, &one.found);
    if (getenv("GLINT_JUDGED_ADD"))
        keep(&one);
    judgement_add(total, &one.found);
}
