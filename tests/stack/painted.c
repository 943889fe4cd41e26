/* SPDX-License-Identifier: MIT */
/*
 * Firmware that paints the stack below a call of each public function, and finds how much of it the call used, at most
 * over scenes of all kinds: every light, material, evaluation and format, with much arena and with the least. Callbacks
 * do nothing, so that none is counted. It writes `glint_render 1600` for each function.
 */
#include "../../tools/bench/workloads.h"
#include "board.h"
#include "glint_extras.h"
#include "text.h"

extern uint32_t linker_stack_bottom[];

static const uint32_t paint = 0x5AFE57ACu;

/* ---- What functions are called with ---- */

enum { WIDTH = 64, HEIGHT = 32, LINES = 12, LEAST_WIDTH = 160, VERTICES = 64, TRIANGLES = 96 };

static uint32_t arena[(1 << 20) / sizeof(uint32_t)], workspace_memory[(1 << 16) / sizeof(uint32_t)];
static workload_stage stage;
static glint_config config;
static glint_renderer renderer;
static glint_frame frame;
static glint_workspace workspace;
static glint_need need;
static glint_report report;
static glint_hit hit;
static glint_tile tile;
static glint_mesh mesh;
static glint_line lines[LINES];
static glint_segment segments[LINES];
static glint_change_filter filter;
static glint_tile_signature signatures[64];
static glint_screen_point point;
static glint_pose pose, turned;
static glint_camera camera;
static glint_vector vector = GLINT_VECTOR(1, 2, 3);
static glint_material material;
static glint_light light;
static uint32_t tile_number;
static volatile int result;

static int send_nothing(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    (void)context, (void)x, (void)y, (void)width, (void)height, (void)pixels, (void)stride;
    return 0;
}

static int wait_for_nothing(void *context) {
    (void)context;
    return 0;
}

static const glint_mesh_room *room(void) {
    static int16_t positions[VERTICES][3], normals[VERTICES][3];
    static uint16_t triangles[TRIANGLES][3];
    static const glint_mesh_room all = {positions, normals, triangles, VERTICES, TRIANGLES};
    return &all;
}

/* ---- Calls ---- */

#define SCENE (&stage.example.scene)
#define FULL GLINT_COLOUR(1, 1, 1)
#define CALL(name, ...)             \
    static void call_##name(void) { \
        __VA_ARGS__;                \
    }

__attribute__((noinline)) static int nothing(void) {
    __asm volatile("");
    return 0;
}

CALL(nothing, result = nothing())
CALL(glint_init, result = glint_init(&renderer, &config))
CALL(glint_render, result = glint_render(&renderer, SCENE))
CALL(glint_render_region, result = glint_render_region(&renderer, SCENE, &(glint_rectangle){24, 8, 32, 16}))
CALL(glint_arena_need, result = glint_arena_need(&config, SCENE, &need))
CALL(glint_pixels_need, result = (int)glint_pixels_need(&config))
CALL(glint_camera_look_at,
     result = glint_camera_look_at(&camera, vector, (glint_vector){0, 0, 0}, (glint_vector){0, GLINT_ONE, 0}))
CALL(glint_camera_orbit, glint_camera_orbit(&camera, vector, GLINT_Q16(40), GLINT_Q16(20), GLINT_Q16(3)))
CALL(glint_pose_rotate, turned = glint_pose_rotate(vector, GLINT_Q16(40)))
CALL(glint_pose_rotate_x, pose = glint_pose_rotate_x(GLINT_Q16(40)))
CALL(glint_pose_quaternion,
     pose = glint_pose_quaternion(GLINT_Q16(0.5), GLINT_Q16(0.5), GLINT_Q16(0.5), GLINT_Q16(0.5)))
CALL(glint_pose_apply, vector = glint_pose_apply(&turned, vector))
CALL(glint_pose_then, pose = glint_pose_then(&turned, &turned))
CALL(glint_material_paint,
     material = glint_material_paint(&glint_model_phong, (glint_colour)FULL, GLINT_Q16(0.1), GLINT_Q16(20)))
CALL(glint_sun, light = glint_sun(vector, (glint_colour)FULL))
CALL(glint_lamp, light = glint_lamp(vector, (glint_colour)FULL, GLINT_Q16(4)))
CALL(glint_spot, light = glint_spot(vector, (glint_vector){0, 0, 0}, (glint_colour)FULL, GLINT_Q16(4), GLINT_Q16(20)))
CALL(glint_generate_torus, result = glint_generate_torus(&mesh, room(), 6, 6, GLINT_ONE, GLINT_ONE / 4))
CALL(glint_generate_sphere, result = glint_generate_sphere(&mesh, room(), 6, 4, GLINT_ONE))
CALL(glint_generate_cylinder, result = glint_generate_cylinder(&mesh, room(), 6, 1, GLINT_ONE, GLINT_ONE, 1))
CALL(glint_generate_cone, result = glint_generate_cone(&mesh, room(), 6, 1, GLINT_ONE, GLINT_ONE, 1))
CALL(glint_generate_plane, result = glint_generate_plane(&mesh, room(), 2, 2, GLINT_ONE, GLINT_ONE))
CALL(glint_generate_box, result = glint_generate_box(&mesh, room(), GLINT_ONE, GLINT_ONE, GLINT_ONE))
CALL(glint_check, result = glint_check(&config, SCENE, &report))
CALL(glint_camera_project, result = glint_camera_project(&config, &SCENE->camera, vector, &point))
CALL(glint_pick, result = glint_pick(&renderer, SCENE, WIDTH / 2, HEIGHT / 2, &hit))
CALL(glint_lines_project, result = glint_lines_project(segments, &config, &SCENE->camera, &turned, lines, LINES))
CALL(glint_lines_draw, result = glint_lines_draw(&tile, segments, LINES))
CALL(glint_lines_box, glint_lines_box(lines, (glint_vector){0, 0, 0}, vector, (glint_colour)FULL))
CALL(glint_lines_edges, result = (int)glint_lines_edges(lines, LINES, &mesh, (glint_colour)FULL))
CALL(glint_tile_signature_count, result = (int)glint_tile_signature_count(&config))
CALL(glint_change_filter_init, result = glint_change_filter_init(&filter, signatures, &config))
CALL(glint_workspace_size, result = (int)glint_workspace_size(&config))
CALL(glint_workspace_init, glint_workspace_init(&workspace, &config, workspace_memory))
CALL(glint_frame_begin, result = glint_frame_begin(&frame, &config, SCENE))
CALL(glint_frame_next_pass, result = glint_frame_next_pass(&frame))
CALL(glint_render_tile, result = glint_render_tile(&frame, &workspace, tile_number))
CALL(glint_tile_find, glint_tile_find(&frame, &workspace, frame.tile_first, &tile))

/* ---- Measuring ---- */

typedef struct measured_call {
    const char *name;
    void (*call)(void);
    uint32_t most;
} measured_call;

#define ROW(name) \
    { #name, call_##name, 0 }

/* These need no scene. */
static measured_call helpers[] = {
    ROW(glint_camera_look_at),
    ROW(glint_camera_orbit),
    ROW(glint_pose_rotate),
    ROW(glint_pose_rotate_x),
    ROW(glint_pose_quaternion),
    ROW(glint_pose_apply),
    ROW(glint_pose_then),
    ROW(glint_material_paint),
    ROW(glint_sun),
    ROW(glint_lamp),
    ROW(glint_spot),
    ROW(glint_generate_torus),
    ROW(glint_generate_sphere),
    ROW(glint_generate_cylinder),
    ROW(glint_generate_cone),
    ROW(glint_generate_plane),
    ROW(glint_generate_box),
    ROW(glint_lines_edges),
    ROW(glint_lines_box),
};

static measured_call of_config[] = {
    ROW(glint_pixels_need),    ROW(glint_tile_signature_count), ROW(glint_change_filter_init),
    ROW(glint_workspace_size), ROW(glint_workspace_init),
};

static measured_call init = ROW(glint_init), render = ROW(glint_render), region = ROW(glint_render_region),
                     arena_need = ROW(glint_arena_need), check = ROW(glint_check), pick = ROW(glint_pick),
                     project = ROW(glint_camera_project), begin = ROW(glint_frame_begin),
                     next_pass = ROW(glint_frame_next_pass), render_tile = ROW(glint_render_tile),
                     find = ROW(glint_tile_find), project_lines = ROW(glint_lines_project),
                     draw_lines = ROW(glint_lines_draw), base = ROW(nothing);

/* Calls a function, and keeps the bytes of stack below this function's own. */
__attribute__((noinline)) static int measure(measured_call *measured) {
    uint32_t *top;
    __asm volatile("mov %0, sp" : "=r"(top));
    for (uint32_t *word = linker_stack_bottom; word < top; word++) {
        *(volatile uint32_t *)word = paint;
    }
    measured->call();
    const uint32_t *lowest = linker_stack_bottom;
    while (lowest < top && *(const volatile uint32_t *)lowest == paint) {
        lowest++;
    }
    const uint32_t used = (uint32_t)((uintptr_t)top - (uintptr_t)lowest) - base.most;
    measured->most = used > measured->most ? used : measured->most;
    return result;
}

/* Draws tile by tile. @return 0, or an error */
static int measure_tiles(void) {
    int pass = measure(&begin);
    glint_workspace_init(&workspace, &config, workspace_memory);
    while (pass >= 0 && (pass = measure(&next_pass)) > 0) {
        for (tile_number = frame.tile_first; tile_number < frame.tile_end; tile_number++) {
            if (measure(&render_tile) == 1) {
                measure(&find);
                measure(&draw_lines);
            }
        }
    }
    return pass;
}

/* Draws the scene by all functions that draw. @return 0, or an error */
static int measure_scene(size_t bytes) {
    config.arena_size = bytes;
    return measure(&init) || measure(&render) || measure(&check) || measure(&pick) < 0 ? result : 0;
}

static int measure_drawing(const glint_format *format, const uint16_t (*gamma)[GLINT_GAMMA_ENTRIES]) {
    config = (glint_config){.width = WIDTH, .height = HEIGHT, .format = format, .gamma = gamma, .arena = arena};
    config.layers = stage.example.layers;
    config.samples = stage.example.samples;
    config.flush = (glint_flush){send_nothing, wait_for_nothing, 0};
    return measure(&arena_need) || measure_scene(sizeof arena) || measure(&region) || measure_tiles() ? result : 0;
}

/* Evaluates light elsewhere than the scene does. */
static void evaluate(const glint_evaluation *evaluation) {
    for (uint32_t i = 0; i < SCENE->object_count; i++) {
        ((glint_object *)SCENE->objects)[i].evaluation = evaluation;
    }
}

/* An error in the last object is found in parts of the scene, each of which is looked at. */
static void measure_errors(void) {
    glint_object *const last = (glint_object *)&SCENE->objects[SCENE->object_count - 1];
    last->pose = glint_pose_scale(0, 0, 0);
    measure(&check);
    SCENE->camera.near_plane = 0;
    measure(&check);
}

static int measure_workload(const workload *drawn) {
    static uint16_t tables[3][GLINT_GAMMA_ENTRIES];
    static const glint_evaluation *const others[] = {&glint_per_fragment, &glint_per_vertex, &glint_per_facet};
    const uint16_t(*const gamma)[GLINT_GAMMA_ENTRIES] =
        drawn->output->gamma ? (const uint16_t(*)[GLINT_GAMMA_ENTRIES])tables : 0;

    workload_gamma(tables);
    if (workload_build(&stage, drawn) || measure_drawing(drawn->output->format, gamma) || measure_scene(need.least) ||
        measure_drawing(&glint_format_rgb888, 0) || measure_drawing(&glint_format_rgb565_be_dithered, 0)) {
        return 1;
    }
    for (uint32_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        evaluate(others[i]);
        if (measure_drawing(drawn->output->format, gamma)) {
            return 1;
        }
    }
    SCENE->camera.projection = &glint_orthographic;
    SCENE->camera.view_height = GLINT_Q16(4);
    if (measure_drawing(drawn->output->format, gamma)) {
        return 1;
    }
    measure(&project);
    measure(&project_lines);
    measure_errors();
    return 0;
}

static void write(const measured_call *measured, uint32_t count) {
    char line[64];
    for (uint32_t i = 0; i < count; i++) {
        board_write(text_join(line, sizeof line, measured[i].name, measured[i].most));
        board_write("\n");
    }
}

int main(void) {
    static const measured_call *const drawing[] = {&init, &render,        &region,    &arena_need, &check,
                                                   &pick, &project,       &begin,     &next_pass,  &render_tile,
                                                   &find, &project_lines, &draw_lines};
    measure(&base);
    for (uint32_t i = 0; i < sizeof helpers / sizeof helpers[0]; i++) {
        measure(&helpers[i]);
    }
    for (uint32_t i = 0; i < workload_count(); i++) {
        const workload drawn = workload_get(i);
        char text[WORKLOAD_TEXT];
        if (drawn.width < LEAST_WIDTH) {
            continue; /* the same on another screen */
        }
        if (measure_workload(&drawn)) {
            board_write(drawn.scene);
            board_write(",");
            board_write(workload_variant(&drawn, text));
            board_write(text_join(text, sizeof text, " failed, status ", (uint32_t)-result));
            board_write("\n");
            return 1;
        }
    }
    for (uint32_t i = 0; i < sizeof of_config / sizeof of_config[0]; i++) {
        measure(&of_config[i]);
    }
    for (uint32_t i = 0; i < sizeof drawing / sizeof drawing[0]; i++) {
        write(drawing[i], 1);
    }
    write(helpers, sizeof helpers / sizeof helpers[0]);
    write(of_config, sizeof of_config / sizeof of_config[0]);
    return 0;
}
