/* SPDX-License-Identifier: MIT */
/**
 * @file view.c
 * From settings and a model to a scene: where the model is put, how it is framed and lit; and from a scene to pixels.
 */
#include "view.h"

#include "basics.h"
#include "quantise.h"
#include "values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** A model whose half side is less is too small for a camera in steps of 2^-16: 1/4096 of it is one. */
#define HALF_SIDE_MIN 0.0625

/** Least length that a power of ten scales to. */
#define LENGTH_MIN 0.3

static const double pi = 3.14159265358979323846;

/** The power of ten that takes a length to at least LENGTH_MIN and less than ten times that. */
static double power_of_ten(double length) {
    const double power = floor(log10(length / LENGTH_MIN));
    return power > 0 ? 1.0 / pow(10.0, power) : pow(10.0, -power);
}

/** The middle of a box. @return half its longest side */
static double measure_box(const double low[3], const double high[3], double middle[3]) {
    double half_side = 0;
    for (int axis = 0; axis < 3; axis++) {
        middle[axis] = low[axis] / 2 + high[axis] / 2;
        half_side = fmax(half_side, high[axis] / 2 - low[axis] / 2);
    }
    return half_side;
}

/** The largest coordinate of a box. */
static double farthest(const double low[3], const double high[3]) {
    double largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = fmax(largest, fmax(fabs(low[axis]), fabs(high[axis])));
    }
    return largest;
}

static void scale_model(host_model *model, const host_settings *settings) {
    double factors[3] = {settings->scale[0], settings->scale[1], settings->scale[2]};
    mesh_bounds(&model->mesh, model->low, model->high);
    const double largest = farthest(model->low, model->high);
    if (settings->scale_fit && largest > 0) {
        factors[0] = factors[1] = factors[2] = power_of_ten(largest);
    }
    mesh_scale(&model->mesh, factors);
}

void place_model(host_model *model, const host_settings *settings, bool turned) {
    if (settings->z_up) {
        mesh_turn(&model->mesh, 0, 0, -1);
    }
    if (settings->centre || settings->fit) {
        double middle[3];
        mesh_bounds(&model->mesh, model->low, model->high);
        measure_box(model->low, model->high, middle);
        mesh_move_to_origin(&model->mesh, middle);
    }
    scale_model(model, settings);
    for (int axis = 0; turned && axis < 3; axis++) {
        const double angle = number_from_q16(settings->rotate[axis]) * pi / 180.0;
        if (settings->rotate[axis] != 0) {
            mesh_turn(&model->mesh, axis, cos(angle), sin(angle));
        }
    }
    mesh_bounds(&model->mesh, model->low, model->high);
    model->fit = 1;
    model->note.text[0] = '\0';
}

/** Says whether a camera is to frame the model, and nothing on the command line is measured in the model's units. */
static bool is_framed(const host_settings *settings) {
    bool framed = !settings->eye_given && !settings->at_given && !settings->near_given;
    for (uint32_t i = 0; i < settings->light_count; i++) {
        framed = framed && settings->lights[i].type == &glint_light_directional;
    }
    return framed;
}

void place_to_fit(host_model *model, const host_settings *settings) {
    double middle[3];
    const double half_side = measure_box(model->low, model->high, middle);
    const double largest = farthest(model->low, model->high);
    const bool framed = is_framed(settings);
    const bool fits = largest <= QUANTISE_COORDINATE_MAX &&
                      (!framed || (half_side >= HALF_SIDE_MIN &&
                                   largest + view_framing_distance(settings, half_side) <= NUMBER_Q16_MAX));
    if (fits || !(half_side > 0)) {
        return;
    }
    model->fit = power_of_ten(half_side);
    const double factors[3] = {model->fit, model->fit, model->fit};
    mesh_move_to_origin(&model->mesh, middle);
    mesh_scale(&model->mesh, factors);
    problem_set(&model->note, model->mesh.farthest_line,
                "note: coordinates reach %.6g, sides %.6g: drawn at %.6g of its size, %.6g,%.6g,%.6g at the origin",
                largest, 2 * half_side, model->fit, middle[0], middle[1], middle[2]);
}

/* ---- A camera and its axes ----------------------------------------------------------------------------------------
 */

/** Degrees that a framing camera stands above the model's horizon, and to the right of its front. */
#define FRAME_ELEVATION 25.0
#define FRAME_AZIMUTH 30.0

/** Part of the view, per axis, that a framed model fills. */
#define FRAME_FILL 0.92

/** Farthest that a framing camera may stand; what it looks at must fit Q16.16 too. */
#define FRAME_EYE_MAX (NUMBER_Q16_MAX - FRAME_LOOK)

/** How far before itself a framing camera looks: far enough for a fine direction. */
#define FRAME_LOOK 16.0

typedef struct vector3 {
    double v[3];
} vector3;

/** Axes of a camera as unit vectors in world space. */
typedef struct frame_axes {
    vector3 right, up, back;
} frame_axes;

/** How far a model reaches in a camera's axes: largest sums of a coordinate along the screen and depth times slope. */
typedef struct frame_reach {
    double right, left, above, below;
    double nearest, farthest; /* along `back` */
} frame_reach;

static double dot(vector3 a, vector3 b) {
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

/** a x + b y. */
static vector3 combine(double a, vector3 x, double b, vector3 y) {
    const vector3 sum = {{a * x.v[0] + b * y.v[0], a * x.v[1] + b * y.v[1], a * x.v[2] + b * y.v[2]}};
    return sum;
}

static vector3 unit_length(vector3 a) {
    return combine(1.0 / sqrt(dot(a, a)), a, 0.0, a);
}

static vector3 cross(vector3 a, vector3 b) {
    const vector3 product = {
        {a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2], a.v[0] * b.v[1] - a.v[1] * b.v[0]}};
    return product;
}

static vector3 from_q16(glint_vector a) {
    vector3 vector = {{0, 0, 0}};
    number_from_vector(a, vector.v);
    return vector;
}

static glint_vector to_q16(vector3 a) {
    const glint_vector vector = {number_q16(a.v[0]), number_q16(a.v[1]), number_q16(a.v[2])};
    return vector;
}

/** A vector turned and scaled by a pose and, times `moved`, moved by it: 1 for points, 0 for directions. */
static vector3 transform(const glint_pose *pose, vector3 vector, double moved) {
    vector3 result;
    for (int row = 0; row < 3; row++) {
        result.v[row] = moved * number_from_q16(pose->m[row][3]);
        for (int column = 0; column < 3; column++) {
            result.v[row] += number_from_q16(pose->m[row][column]) * vector.v[column];
        }
    }
    return result;
}

/** The largest component's magnitude. */
static double reach_of(vector3 a) {
    return fmax(fabs(a.v[0]), fmax(fabs(a.v[1]), fabs(a.v[2])));
}

/* ---- Framing ---------------------------------------------------------------------------------------------------- */

/** A camera before the model, to the right and above: before is +z, or -y when up is near the z axis. */
static frame_axes framing_axes(glint_vector up) {
    const vector3 along_z = {{0, 0, 1}};
    const vector3 against_y = {{0, -1, 0}};
    const vector3 sky = unit_length(from_q16(up));
    const vector3 front = fabs(sky.v[2]) > 0.9 ? against_y : along_z;
    const vector3 before = unit_length(combine(1.0, front, -dot(front, sky), sky));
    const double around = FRAME_AZIMUTH * pi / 180.0;
    const vector3 level = combine(cos(around), before, sin(around), cross(sky, before));
    const double angle = FRAME_ELEVATION * pi / 180.0;
    frame_axes axes;
    axes.back = unit_length(combine(cos(angle), level, sin(angle), sky));
    axes.right = unit_length(cross(sky, axes.back));
    axes.up = cross(axes.back, axes.right);
    return axes;
}

static vector3 posed(const glint_pose *pose, const glint_mesh *mesh, uint32_t vertex) {
    vector3 position = {{0, 0, 0}};
    quantised_position(mesh, vertex, position.v);
    return transform(pose, position, 1.0);
}

/** Widens a reach to that of a model in a pose. */
static void measure(frame_reach *reach, const quantised_mesh *mesh, const glint_pose *pose, const frame_axes *axes,
                    double slope_x, double slope_y) {
    for (size_t piece = 0; piece < mesh->piece_count; piece++) {
        for (uint32_t i = 0; i < mesh->pieces[piece].vertex_count; i++) {
            const vector3 point = posed(pose, &mesh->pieces[piece], i);
            const double x = dot(point, axes->right);
            const double y = dot(point, axes->up);
            const double z = dot(point, axes->back);
            reach->right = fmax(reach->right, x + slope_x * z);
            reach->left = fmax(reach->left, -x + slope_x * z);
            reach->above = fmax(reach->above, y + slope_y * z);
            reach->below = fmax(reach->below, -y + slope_y * z);
            reach->nearest = fmax(reach->nearest, z);
            reach->farthest = fmin(reach->farthest, z);
        }
    }
}

/** The reach of a model as it stands, or of all frames of its turn. */
static frame_reach measure_all(host_view *view, const host_settings *settings, const quantised_mesh *mesh,
                               const frame_axes *axes, double slope_x, double slope_y) {
    const glint_pose *pose = &view->objects[0].pose;
    frame_reach reach = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL, HUGE_VAL};
    measure(&reach, mesh, pose, axes, slope_x, slope_y);
    for (uint32_t frame = settings->animate; frame-- > 1;) {
        view_turn(view, settings, frame);
        measure(&reach, mesh, pose, axes, slope_x, slope_y);
    }
    view_turn(view, settings, 0);
    return reach;
}

/**
 * Places the camera as near as it can stand with all vertices inside the view. In its axes, vertex p is inside when
 * |p.x - eye.x| <= slope (eye.z - p.z), and likewise for y: four half spaces for the eye.
 */
static bool frame_model(host_view *view, const host_settings *settings, const quantised_mesh *mesh,
                        host_problem *problem) {
    const frame_axes axes = framing_axes(settings->up);
    const double slope_y = FRAME_FILL * tan(number_from_q16(settings->field_of_view) * pi / 360.0);
    const double slope_x = slope_y * settings->width / settings->height;
    const double widens = settings->view_height > 0 ? 0.0 : 1.0; /* parallel rays do not */
    const frame_reach reach = measure_all(view, settings, mesh, &axes, widens * slope_x, widens * slope_y);
    const vector3 at = from_q16(settings->at);
    const double x = settings->at_given ? dot(at, axes.right) : (reach.right - reach.left) / 2;
    const double y = settings->at_given ? dot(at, axes.up) : (reach.above - reach.below) / 2;
    double z = fmax(fmax(reach.right - x, reach.left + x) / slope_x, fmax(reach.above - y, reach.below + y) / slope_y);
    /* A sharp tip may reach into the camera: keep off by a part of the depth, and by the near plane. */
    const double off = settings->near_given ? number_from_q16(settings->near_plane) * 1.01 : 1.0 / 1024.0;
    z = fmax(z, reach.nearest + fmax(off, 0.05 * (reach.nearest - reach.farthest)));
    const double gap = z - reach.nearest;
    if (!settings->near_given && gap / 2 < number_from_q16(settings->near_plane)) {
        view->scene.camera.near_plane = number_q16(gap / 2);
    }
    const vector3 eye = combine(1.0, combine(x, axes.right, y, axes.up), z, axes.back);
    if (reach_of(eye) > FRAME_EYE_MAX) {
        return problem_set(problem, 0, "the model is too large to be framed: give --eye");
    }
    const glint_status status = glint_camera_look_at(&view->scene.camera, to_q16(eye),
                                                     to_q16(combine(1.0, eye, -FRAME_LOOK, axes.back)), settings->up);
    return status == GLINT_OK || problem_set(problem, 0, "%s", glint_strerror(status));
}

double view_framing_distance(const host_settings *settings, double half_side) {
    const double slope_y = FRAME_FILL * tan(number_from_q16(settings->field_of_view) * pi / 360.0);
    const double slope = fmin(slope_y, slope_y * settings->width / settings->height);
    const double radius = sqrt(3.0) * half_side;
    return FRAME_LOOK + 1.2 * radius + 2.0 * radius / slope; /* a box's corners, to the side twice at most */
}

/* ---- Scenes ----------------------------------------------------------------------------------------------------- */

/** Lights a scene without --light: white from the upper left of the camera and half behind it; and weaker from the
 * right, without highlights, so that no side that the camera sees is black. */
static void place_default_lights(host_view *view) {
    static const vector3 directions[] = {{{0.5, -0.7, -0.7}}, {{-0.8, -0.1, -0.6}}};
    static const double levels[] = {1.0, 0.25};
    for (int i = 0; i < 2; i++) {
        view->lights[i] = (glint_light){.type = &glint_light_directional, .diffuse = settings_grey(levels[i])};
        view->lights[i].direction = to_q16(transform(&view->scene.camera.pose, directions[i], 0.0));
    }
    view->lights[0].specular = settings_grey(1);
    view->scene.light_count = 2;
}

/** A direction from camera space to world space. One too long for Q16.16 is halved: its length means nothing. */
static glint_vector turn_direction(const glint_pose *pose, glint_vector direction) {
    const vector3 world = transform(pose, from_q16(direction), 0.0);
    return to_q16(combine(reach_of(world) > NUMBER_Q16_MAX ? 0.5 : 1.0, world, 0.0, world));
}

/** Takes a light from camera space to world space. @return false with a problem when it then lies too far out */
static bool place_light(const glint_camera *camera, glint_light *light, host_problem *problem) {
    light->direction = turn_direction(&camera->pose, light->direction);
    if (light->type == &glint_light_directional) {
        return true;
    }
    const vector3 place = transform(&camera->pose, from_q16(light->position), 1.0);
    if (reach_of(place) > NUMBER_Q16_MAX) {
        return problem_set(problem, 0, "--camera-lights: a light lies beyond +-32767 in world space");
    }
    light->position = to_q16(place);
    return true;
}

static bool place_lights(host_view *view, const host_settings *settings, host_problem *problem) {
    memcpy(view->lights, settings->lights, sizeof view->lights);
    view->scene.lights = view->lights;
    view->scene.light_count = settings->light_count;
    for (uint32_t i = 0; settings->camera_lights && i < settings->light_count; i++) {
        if (!place_light(&view->scene.camera, &view->lights[i], problem)) {
            return false;
        }
    }
    if (settings->light_count == 0) {
        place_default_lights(view);
    }
    return true;
}

/** The model's pose as options say. */
static glint_pose standing_pose(const host_settings *settings) {
    const glint_pose about_x = glint_pose_rotate_x(settings->rotate[0]);
    const glint_pose about_y = glint_pose_rotate_y(settings->rotate[1]);
    const glint_pose about_z = glint_pose_rotate_z(settings->rotate[2]);
    const glint_pose turned = glint_pose_then(&about_x, &about_y);
    return glint_pose_then(&turned, &about_z);
}

/** The middle of the box of a model in a pose. */
static glint_vector find_middle(const quantised_mesh *mesh, const glint_pose *pose) {
    vector3 low = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}};
    vector3 high = {{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (size_t piece = 0; piece < mesh->piece_count; piece++) {
        for (uint32_t i = 0; i < mesh->pieces[piece].vertex_count; i++) {
            const vector3 point = posed(pose, &mesh->pieces[piece], i);
            for (int axis = 0; axis < 3; axis++) {
                low.v[axis] = fmin(low.v[axis], point.v[axis]);
                high.v[axis] = fmax(high.v[axis], point.v[axis]);
            }
        }
    }
    return to_q16(combine(0.5, low, 0.5, high));
}

static void place_objects(host_view *view, const host_settings *settings, const host_materials *materials,
                          const quantised_mesh *mesh) {
    view->materials = memory_new(materials->used_count + 1, sizeof *view->materials);
    for (size_t i = 0; i <= materials->used_count; i++) {
        view->materials[i] = settings_material(settings, materials_find(materials, (uint32_t)i));
    }
    const glint_pose pose = standing_pose(settings);
    view->objects = memory_new(mesh->piece_count, sizeof *view->objects);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        view->objects[i].mesh = &mesh->pieces[i];
        view->objects[i].material = &view->materials[mesh->materials[i]];
        view->objects[i].pose = pose;
        view->objects[i].evaluation = settings->evaluation;
    }
    view->scene.objects = view->objects;
    view->scene.object_count = (uint32_t)mesh->piece_count;
    if (settings->animate > 0) {
        view->middle = find_middle(mesh, &pose);
    }
}

static bool place_camera(host_view *view, const host_settings *settings, const quantised_mesh *mesh,
                         host_problem *problem) {
    glint_camera *camera = &view->scene.camera;
    camera->field_of_view = settings->field_of_view;
    camera->near_plane = settings->near_plane;
    camera->projection = settings->view_height > 0 ? &glint_orthographic : NULL;
    camera->view_height = settings->view_height;
    if (!settings->eye_given) {
        return frame_model(view, settings, mesh, problem);
    }
    const glint_status status = glint_camera_look_at(camera, settings->eye, settings->at, settings->up);
    return status == GLINT_OK || problem_set(problem, 0, "--eye, --at and --up lie on one line");
}

bool view_make(host_view *view, const host_settings *settings, const host_materials *materials,
               const quantised_mesh *mesh, host_problem *problem) {
    memset(view, 0, sizeof *view);
    place_objects(view, settings, materials, mesh);
    if (!place_camera(view, settings, mesh, problem) || !place_lights(view, settings, problem)) {
        view_free(view);
        return false;
    }
    view->scene.viewer = settings->viewer;
    view->scene.background = settings->background;
    view->scene.ambient = settings_grey(1);
    view->scene.fog = settings->fog_given ? &settings->fog : NULL;
    return true;
}

void view_free(host_view *view) {
    free(view->objects);
    free(view->materials);
    view->objects = NULL;
    view->materials = NULL;
}

void view_turn(host_view *view, const host_settings *settings, uint32_t frame) {
    const glint_vector middle = view->middle;
    glint_pose pose = standing_pose(settings);
    if (settings->animate > 0) {
        const glint_pose inwards = glint_pose_translate(-middle.x, -middle.y, -middle.z);
        const glint_pose turn = glint_pose_rotate(settings->up, number_q16(360.0 * frame / settings->animate));
        const glint_pose outwards = glint_pose_translate(middle.x, middle.y, middle.z);
        pose = glint_pose_then(&pose, &inwards);
        pose = glint_pose_then(&pose, &turn);
        pose = glint_pose_then(&pose, &outwards);
    }
    for (uint32_t i = 0; i < view->scene.object_count; i++) {
        view->objects[i].pose = pose;
    }
}

/* ---- Drawing ---------------------------------------------------------------------------------------------------- */

static glint_status draw(const glint_scene *scene, glint_config *config, glint_stats *stats) {
    glint_renderer renderer;
    config->arena = memory_new(config->arena_size, 1);
    glint_status status = glint_init(&renderer, config);
    if (status == GLINT_OK) {
        status = glint_render(&renderer, scene);
        *stats = renderer.stats;
    }
    free(config->arena);
    return status;
}

/** Returns whether an object that is drawn blends. */
static bool has_layers(const glint_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (!scene->objects[i].hidden && scene->objects[i].material->blend != GLINT_BLEND_NONE) {
            return true;
        }
    }
    return false;
}

/** Configures all but arena and flush. `tables` must outlive the configuration. */
static glint_config configure(const glint_scene *scene, const host_settings *settings,
                              uint16_t tables[3][GLINT_GAMMA_ENTRIES]) {
    glint_config config = {.width = settings->width, .height = settings->height};
    config.format = settings->dither ? settings->format->dithered : settings->format->format;
    config.tile_width = settings->tile_width;
    config.tile_height = settings->tile_height;
    config.layers = has_layers(scene) ? &glint_layers : NULL;
    config.samples = settings->samples;
    if (settings->gamma < 1 || settings->gamma > 1) {
        for (int i = 0; i < GLINT_GAMMA_ENTRIES; i++) {
            const double level = pow((double)i / (GLINT_GAMMA_ENTRIES - 1), 1.0 / settings->gamma);
            tables[0][i] = tables[1][i] = tables[2][i] = (uint16_t)lround(65535.0 * level);
        }
        config.gamma = (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables;
    }
    return config;
}

glint_status view_need(const glint_scene *scene, const host_settings *settings, glint_need *need) {
    uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    framebuffer target; /* with its flush two tiles are kept, one of which is sent */
    glint_config config = configure(scene, settings, tables);
    config.flush = framebuffer_flush(&target);
    return glint_arena_need(&config, scene, need);
}

bool view_explain(const glint_scene *scene, const host_settings *settings, bool is_black, host_problem *warning) {
    uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    glint_config config = configure(scene, settings, tables);
    framebuffer target;
    config.flush = framebuffer_flush(&target);
    glint_need need = {0};
    glint_report report = {0};
    if (glint_arena_need(&config, scene, &need) != GLINT_OK) {
        return false;
    }
    config.arena_size = need.one_pass;
    config.arena = memory_new(config.arena_size, 1);
    const glint_status status = glint_check(&config, scene, &report);
    free(config.arena);
    if (status != GLINT_OK || (report.shown > 0 && !is_black)) {
        return false;
    }
    problem_set(warning, 0, "warning: the picture %s: %s", report.shown > 0 ? "is black" : "shows nothing of the model",
                report.sentence);
    return true;
}

bool view_draw(const glint_scene *scene, const host_settings *settings, framebuffer *target, glint_stats *stats,
               host_problem *problem) {
    uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    glint_config config = configure(scene, settings, tables);
    framebuffer_init(target, config.format, config.width, config.height);
    config.flush = framebuffer_flush(target);
    glint_need need = {0};
    glint_status status = glint_arena_need(&config, scene, &need);
    config.arena_size = settings->arena > 0 ? settings->arena : need.one_pass;
    if (status == GLINT_OK) {
        status = draw(scene, &config, stats);
    }
    if (status == GLINT_OK) {
        return true;
    }
    framebuffer_free(target);
    if (status == GLINT_ERROR_ARENA && need.least > 0) {
        return problem_set(problem, 0, "--arena %zu: this scene takes %zu bytes, or %zu to be drawn in one pass",
                           config.arena_size, need.least, need.one_pass);
    }
    return problem_set(problem, 0, "%s", glint_strerror(status));
}
