/* SPDX-License-Identifier: MIT */
/* Finds why a scene is not drawn, or why its picture is black. */
#include "../frame/frame.h"
#include "../light/shading.h"
#include "../pixel/format.h"

/* ---- What is said ---- */

/* A sentence is about the frame, an object or a light. */
typedef struct subject {
    int32_t object, light;
} subject;

static const subject the_frame = {-1, -1};

static glint_status say(glint_report *report, glint_status status, subject about, const char *sentence) {
    *report = (glint_report){.status = status, .sentence = sentence, .object = about.object, .light = about.light};
    return status;
}

/* Adds a remark on a scene that can be drawn, unless there is one. */
static void remark(glint_report *report, subject about, const char *sentence) {
    if (*report->sentence)
        return;
    report->sentence = sentence;
    report->object = about.object;
    report->light = about.light;
}

/* ---- Configurations ---- */

static const char *name_null(const glint_config *config) {
    return !config->format        ? "config->format is null: name one, such as &glint_format_rgb565"
           : !config->flush.begin ? "config->flush.begin is null: it is what takes the finished tiles"
                                  : "config->arena is null: point it to arena_size bytes of memory";
}

static glint_status check_memory(const glint_config *config, const glint_need *need, glint_report *report) {
    const size_t pixels = config->pixels ? glint_pixels_need(config) : 0;
    if (config->pixels && config->pixels_size < pixels) {
        say(report, GLINT_ERROR_PIXELS, the_frame,
            "config->pixels has too few bytes: glint_pixels_need tells how many");
        report->bytes = pixels - config->pixels_size;
        return report->status;
    }
    if (config->arena_size < need->least) {
        say(report, GLINT_ERROR_ARENA, the_frame,
            "the arena has too few bytes for this scene: smaller tiles or fewer materials take less");
        report->bytes = need->least - config->arena_size;
    }
    return report->status;
}

/* ---- Parts of a scene ---- */

/* Is there neither an array nor an attribute in place of it? */
static int is_missing(const void *array, const glint_mesh_attribute *attribute) {
    return !array && (!attribute->type || !attribute->data);
}

static const char *name_null_of_object(const glint_object *object) {
    static const glint_mesh_layout none = {{0}, {0}, {0}, {0}};
    const glint_mesh *const mesh = object->mesh;
    const glint_mesh_layout *const layout = mesh && mesh->layout ? mesh->layout : &none;
    return !mesh                                             ? "an object's mesh is null"
           : is_missing(mesh->positions, &layout->positions) ? "a mesh's positions are null"
           : is_missing(mesh->normals, &layout->normals)     ? "a mesh's normals are null"
           : is_missing(mesh->triangles, &layout->triangles) ? "a mesh's triangles are null"
           : layout->colours.type && !layout->colours.data   ? "a layout's colours are null"
           : !object->material                               ? "an object's material is null"
           : !object->material->model ? "a material's model is null: name one, such as &glint_model_blinn_phong"
                                      : "an object's evaluation is null: name one, such as &glint_per_fragment";
}

static const char *name_of_camera(const glint_camera *camera) {
    const int is_parallel = camera->projection != 0;
    return is_parallel && !camera->projection->is_valid(camera) ? "the orthographic camera's view height, the screen's "
                                                                  "in units, is below 1/256: GLINT_Q16(4) shows 4 units"
           : !is_parallel && camera->field_of_view < GLINT_ONE && camera->field_of_view > 0
               ? "the camera's field of view is below 1 degree: is it GLINT_Q16(60), not 60?"
           : !is_parallel && (camera->field_of_view < GLINT_ONE || camera->field_of_view > 170 * GLINT_ONE)
               ? "the camera's field of view is not from 1 to 170 degrees"
           : camera->near_plane <= 0
               ? "the camera's near plane is not above 0: GLINT_Q16(0.1) serves most scenes"
               : "the camera's axes are not unit and perpendicular: its pose has no scale; begin with "
                 "glint_pose_identity or glint_camera_look_at";
}

/* Returns the error of a scene with one light or object, or with none. */
static glint_status status_of(const glint_config *config, const glint_scene *scene, const glint_light *light,
                              const glint_object *object) {
    glint_scene part = *scene;
    glint_need need;
    part.lights = light ? light : scene->lights;
    part.light_count = light ? 1 : object ? scene->light_count : 0;
    part.objects = object;
    part.object_count = object != 0;
    return glint_arena_need(config, &part, &need);
}

/* Finds the first part of a scene that causes an error. Parts with other errors are passed over. */
static glint_status find_error(const glint_config *config, const glint_scene *scene, glint_status error,
                               glint_report *report) {
    if (scene->object_count && !scene->objects)
        return say(report, error, the_frame, "scene->objects is null");
    glint_status status = status_of(config, scene, 0, 0);
    if (status == error)
        return say(report, status, the_frame,
                   status == GLINT_ERROR_CAMERA ? name_of_camera(&scene->camera) : glint_strerror(status));
    if (scene->light_count > GLINT_LIGHTS_MAX)
        return say(report, GLINT_ERROR_LIGHTS, the_frame, glint_strerror(GLINT_ERROR_LIGHTS));
    if (scene->light_count && !scene->lights)
        return say(report, error, the_frame, "scene->lights is null");
    for (uint32_t i = 0; i < scene->light_count; i++) {
        status = status_of(config, scene, &scene->lights[i], 0);
        if (status == error)
            return say(report, status, (subject){-1, (int32_t)i},
                       status == GLINT_ERROR_NULL ? "a light's type is null: name one, such as &glint_light_directional"
                                                  : glint_strerror(status));
    }
    for (uint32_t i = 0; i < scene->object_count; i++) {
        status = status_of(config, scene, 0, &scene->objects[i]);
        if (status == error)
            return say(report, status, (subject){(int32_t)i, -1},
                       status == GLINT_ERROR_NULL ? name_null_of_object(&scene->objects[i]) : glint_strerror(status));
    }
    return say(report, error, the_frame, glint_strerror(error));
}

/* ---- What looks wrong ---- */

/* A number below this that is not 0 was hardly meant: it is too small for a fraction in Q16.16, and probably an
 * integer. */
#define HARDLY_MEANT 512

static int is_hardly_meant(glint_q16 x) {
    return x && x > -HARDLY_MEANT && x < HARDLY_MEANT;
}

static int is_black(const glint_colour *colour) {
    return !(colour->r | colour->g | colour->b);
}

/* Is the brightest channel so small that it was hardly meant? */
static int is_hardly_meant_colour(const glint_colour *colour) {
    return is_hardly_meant(glint_most_of(colour->r, colour->g, colour->b));
}

static int is_place_hardly_meant(const glint_q16 place[3]) {
    int some = 0;
    for (int i = 0; i < 3; i++) {
        if (place[i] && !is_hardly_meant(place[i]))
            return 0;
        some |= place[i] != 0;
    }
    return some;
}

static int is_pose_hardly_meant(const glint_pose *pose) {
    const glint_q16 place[3] = {pose->m[0][3], pose->m[1][3], pose->m[2][3]};
    int scale = 0;
    for (int i = 0; i < 9; i++)
        scale |= pose->m[i / 3][i % 3] && !is_hardly_meant(pose->m[i / 3][i % 3]);
    return is_place_hardly_meant(place) || !scale;
}

/* Is an object left out of a scene that can be drawn, as it is hidden or skipped? */
static int is_left_out(const glint_config *config, const glint_scene *scene, const glint_object *object) {
    glint_config strict = *config;
    strict.skips_degenerate = 0;
    return object->hidden || (config->skips_degenerate && status_of(&strict, scene, 0, object) != GLINT_OK);
}

/* Remarks on numbers that look like integers in place of Q16.16. */
static void remark_numbers(const glint_config *config, const glint_scene *scene, glint_report *report) {
    const glint_pose *const eye = &scene->camera.pose;
    const glint_q16 place[3] = {eye->m[0][3], eye->m[1][3], eye->m[2][3]};
    if (is_place_hardly_meant(place))
        remark(report, the_frame, "the camera stands less than 1/128 from the origin: is it GLINT_Q16(4), not 4?");
    for (uint32_t i = 0; i < scene->object_count; i++) {
        const glint_object *const object = &scene->objects[i];
        const subject about = {(int32_t)i, -1};
        if (is_left_out(config, scene, object))
            continue;
        if (is_pose_hardly_meant(&object->pose))
            remark(report, about,
                   "an object's pose moves it by less than 1/128, or makes it that small: is it GLINT_Q16(4), not 4?");
        if (is_hardly_meant(object->mesh->extent.x | object->mesh->extent.y | object->mesh->extent.z))
            remark(report, about, "a mesh's extent is below 1/128: is it GLINT_Q16(1), not 1?");
        if (is_hardly_meant(object->material->shininess))
            remark(report, about, "a material's shininess is below 1/128: is it GLINT_Q16(32), not 32?");
        if (is_hardly_meant_colour(&object->material->diffuse) || is_hardly_meant_colour(&object->material->ambient))
            remark(report, about, "a material's colour is below 1/128: is it GLINT_Q16(1), not 1?");
    }
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const glint_light *const light = &scene->lights[i];
        const glint_q16 at[3] = {light->position.x, light->position.y, light->position.z};
        const subject about = {-1, (int32_t)i};
        if (is_hardly_meant_colour(&light->diffuse))
            remark(report, about, "a light's colour is below 1/128: is it GLINT_Q16(1), not 1?");
        if (light->type->has_place && is_place_hardly_meant(at))
            remark(report, about, "a light stands less than 1/128 from the origin: is it GLINT_Q16(4), not 4?");
    }
}

/* Remarks on why no object is visible. */
static void remark_nothing(const glint_config *config, const glint_scene *scene, const glint_stats *stats,
                           glint_report *report) {
    uint32_t hidden = 0;
    for (uint32_t i = 0; i < scene->object_count; i++)
        hidden += scene->objects[i].hidden != 0;
    if (hidden == scene->object_count)
        remark(report, the_frame, scene->object_count ? "all objects are hidden" : "the scene has no objects");
    if (stats->skipped && stats->hidden == scene->object_count)
        remark(report, the_frame,
               "no object is left: some are skipped, as their poses are singular or their meshes empty, and the camera "
               "sees no other");
    remark_numbers(config, scene, report);
    if (stats->hidden == scene->object_count)
        remark(report, the_frame,
               "the camera sees no object: all are beside what it sees, or behind it. It looks along its -z axis; "
               "glint_camera_look_at points it at something");
    if (stats->facing_away && stats->facing_away + stats->outside == stats->triangles)
        remark(
            report, the_frame,
            "all triangles face away: front faces are counter-clockwise seen from outside, and an eye within a solid "
            "sees no face of it. GLINT_MESH_DOUBLE_SIDED draws both sides");
    remark(report, the_frame, "all triangles lie outside of the screen, or between the centres of its pixels");
}

/* Remarks on why visible objects are black. */
static void remark_black(const glint_config *config, const glint_scene *scene, glint_report *report) {
    uint32_t bright = 0, reflects = 0;
    for (uint32_t i = 0; i < scene->light_count; i++)
        bright += !is_black(&scene->lights[i].diffuse) || !is_black(&scene->lights[i].specular);
    for (uint32_t i = 0; i < scene->object_count; i++)
        reflects += !is_black(&scene->objects[i].material->diffuse) || !is_black(&scene->objects[i].material->ambient);
    if (!bright && is_black(&scene->ambient))
        remark(report, the_frame,
               scene->light_count ? "all lights are black, and scene->ambient too"
                                  : "there is no light: give the scene one, or ambient light");
    if (!reflects)
        remark(report, the_frame, "all materials are black");
    remark_numbers(config, scene, report);
    remark(
        report, the_frame,
        "no light reaches what shows: a directional light's direction is the way it travels, normals point outwards, "
        "and where no light falls materials show ambient light alone");
}

/* ---- A frame that is not sent ---- */

/* 8 pixels have at most so many bytes. */
#define BYTES_OF_8 24

typedef struct tally {
    const glint_config *config;
    uint32_t shown; /* pixels */
    int is_lit;     /* whether a pixel of the frame is not black */
} tally;

/* Finds the bytes of black, which output tables may make any colour, of 8 x 8 pixels: dithered, it repeats then. */
static void find_black(const glint_config *config, uint8_t black[8 * BYTES_OF_8]) {
    int32_t none = 0;
    GLINT_OPAQUE(none); /* otherwise compilers store two zeros from a register of the FPU */
    int32_t colour[1][3] = {{none, none, none}};
    glint_finish_colours(config, colour, 1);
    config->format->fill(black, 3, 8, colour[0]);
}

static int send_nothing(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static int look(void *context, const glint_tile *tile) {
    tally *const sum = context;
    const glint_format *const format = sum->config->format;
    const uint32_t bytes_of_8 = format->edge[1] ? 8 : format->bits; /* of 8 pixels of a row, or of a page */
    uint8_t black[8 * BYTES_OF_8];
    find_black(sum->config, black);
    for (int y = 0; y < tile->height; y++) {
        const uint8_t *const bytes = (const uint8_t *)tile->pixels + (size_t)y * tile->stride;
        const uint8_t *const row = black + (format->edge[1] ? 0 : ((uint32_t)(tile->y + y) & 7) * bytes_of_8);
        const size_t first = ((uint32_t)tile->x & 7) * bytes_of_8 / 8;
        const size_t count = !format->edge[1]             ? (size_t)tile->width * format->bits / 8
                             : (y & format->edge[1]) == 0 ? (size_t)tile->width
                                                          : 0;
        for (size_t i = 0; i < count; i++)
            sum->is_lit |= bytes[i] != row[(first + i) % bytes_of_8];
        for (int x = 0; x < tile->width; x++)
            sum->shown += tile->depth[(size_t)y * tile->depth_stride + (size_t)x] != 0;
    }
    return 0;
}

/* Begins a renderer that sends nothing. */
static GLINT_NOINLINE glint_status begin_look(glint_renderer *renderer, const glint_config *config, tally *sum) {
    glint_config as = *config;
    as.flush = (glint_flush){.begin = send_nothing};
    as.background.paint = 0;
    as.overlay = (glint_painter){look, sum};
    sum->config = config;
    return glint_init(renderer, &as);
}

/* Draws the scene on black, and sends nothing. @param is_lit whether a pixel is not black */
static GLINT_NOINLINE glint_status look_at_frame(const glint_config *config, const glint_scene *scene,
                                                 glint_report *report, glint_stats *stats, int *is_lit) {
    glint_scene on_black = *scene;
    glint_renderer renderer;
    tally sum = {0};
    on_black.background = (glint_colour){0, 0, 0};
    glint_status status = begin_look(&renderer, config, &sum);
    if (status == GLINT_OK)
        status = glint_render(&renderer, &on_black);
    *stats = renderer.stats;
    *is_lit = sum.is_lit;
    report->shown = status == GLINT_OK ? sum.shown : 0;
    return status;
}

/* Draws the scene, and says what looks wrong. */
static glint_status remark_frame(const glint_config *config, const glint_scene *scene, glint_report *report) {
    glint_stats stats;
    int is_lit;
    const glint_status status = look_at_frame(config, scene, report, &stats, &is_lit);
    if (status != GLINT_OK)
        return say(report, status, the_frame, glint_strerror(status));
    if (!report->shown && !is_lit) /* what is blended leaves no depth */
        remark_nothing(config, scene, &stats, report);
    else if (!is_lit)
        remark_black(config, scene, report);
    else
        remark_numbers(config, scene, report);
    return GLINT_OK;
}

/* Returns what a configuration is refused with. */
static GLINT_NOINLINE glint_status try_config(const glint_config *config) {
    glint_renderer renderer;
    return glint_init(&renderer, config);
}

glint_status glint_check(const glint_config *config, const glint_scene *scene, glint_report *report) {
    glint_need need;
    if (!report)
        return GLINT_ERROR_NULL;
    if (!config || !scene)
        return say(report, GLINT_ERROR_NULL, the_frame, config ? "the scene is null" : "the configuration is null");
    const glint_status status = try_config(config);
    if (status != GLINT_OK && status != GLINT_ERROR_ARENA && status != GLINT_ERROR_PIXELS)
        return say(report, status, the_frame, status == GLINT_ERROR_NULL ? name_null(config) : glint_strerror(status));
    const glint_status error = glint_arena_need(config, scene, &need);
    if (error != GLINT_OK)
        return find_error(config, scene, error, report);
    say(report, GLINT_OK, the_frame, "");
    if (check_memory(config, &need, report) != GLINT_OK)
        return report->status;
    return remark_frame(config, scene, report);
}
