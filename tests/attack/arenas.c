/* SPDX-License-Identifier: MIT */
/*
 * Arenas of every size, from none to more than enough, that end where a page begins that must not be touched, or begin
 * where one ends: arenas STEP, every size or one in so many. Each is refused by a named error or draws the picture.
 */
#include "every_format.h"
#include "glint_extras.h"
#include "pages.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define WIDTH 28
#define HEIGHT 20
#define BEYOND 24u /* bytes more than the best size */
#define NEAR 8u    /* all sizes that are nearer to one that is asked for are tried */
#define ARENA_MOST (64u << 10)
#define PIXELS_MOST (2u * 16 * 8 * 3 + 256)

#define VERTICES 64
#define TRIANGLES 96

/* Where the program is, for the report of a fault. */
static struct { unsigned evaluation, format, size, is_at_end; } place;

static void report(void) {
    char text[160];
    const char *const where = place.is_at_end ? "behind" : "before";
    /* NOLINTNEXTLINE(bugprone-signal-handler): a fault is one of the library's, which is never within snprintf */
    const int length = snprintf(text, sizeof text, "evaluation %u, format %u, arena of %u bytes, page %s\n",
                                place.evaluation, place.format, place.size, where);
    (void)!write(STDERR_FILENO, text, (size_t)length);
}

static void take_signal(int number) {
    report();
    signal(number, SIG_DFL);
    raise(number);
}

static void require(int holds, const char *what) {
    if (holds)
        return;
    report();
    fprintf(stderr, "broken: %s\n", what);
    exit(1);
}

/* ---- Scene: two tori, one of which reaches behind the near plane, in front of a sphere ---- */

#define EVALUATIONS 3

static const glint_evaluation *const evaluations[EVALUATIONS] = {&glint_per_fragment, &glint_per_vertex,
                                                                 &glint_per_facet};

typedef struct props {
    int16_t positions[2][VERTICES][3], normals[2][VERTICES][3];
    uint16_t triangles[2][TRIANGLES][3];
    glint_mesh meshes[2];
    glint_material materials[3];
    glint_light lights[2];
    glint_object objects[3];
    glint_scene scene;
} props;

static void build_meshes(props *p) {
    for (int i = 0; i < 2; i++) {
        const glint_mesh_room room = {.vertex_room = VERTICES,
                                      .triangle_room = TRIANGLES,
                                      .positions = p->positions[i],
                                      .normals = p->normals[i],
                                      .triangles = p->triangles[i]};
        const glint_status status = i ? glint_generate_sphere(&p->meshes[i], &room, 8, 4, GLINT_ONE)
                                      : glint_generate_torus(&p->meshes[i], &room, 8, 5, GLINT_ONE, GLINT_ONE / 2);
        require(status == GLINT_OK, "a mesh");
    }
}

static void build(props *p, const glint_evaluation *evaluation) {
    const glint_colour white = {GLINT_ONE, GLINT_ONE, GLINT_ONE}, paint = {GLINT_ONE / 2, GLINT_ONE / 4, GLINT_ONE};
    const glint_shading_model *const models[3] = {&glint_model_blinn_phong, &glint_model_phong, &glint_model_lambert};
    memset(p, 0, sizeof *p);
    build_meshes(p);
    p->lights[0] = (glint_light){.type = &glint_light_directional,
                                 .position = {GLINT_ONE, GLINT_ONE, GLINT_ONE},
                                 .direction = {-GLINT_ONE, -GLINT_ONE, -GLINT_ONE},
                                 .diffuse = white,
                                 .specular = white};
    p->lights[1] = p->lights[0];
    p->lights[1].type = &glint_light_point;
    for (int i = 0; i < 3; i++) {
        p->materials[i] = glint_material_paint(models[i], paint, GLINT_ONE / 8, 20 * GLINT_ONE);
        p->objects[i] =
            (glint_object){.mesh = &p->meshes[i / 2], .material = &p->materials[i], .evaluation = evaluation};
        p->objects[i].pose = glint_pose_rotate_x(40 * GLINT_ONE);
        p->objects[i].pose.m[0][3] = (i - 1) * GLINT_ONE;
        p->objects[i].pose.m[2][3] = i ? -4 * GLINT_ONE : -GLINT_ONE;
    }
    p->scene = (glint_scene){.camera = {glint_pose_identity(), 60 * GLINT_ONE, GLINT_ONE / 2}, .ambient = white};
    p->scene.lights = p->lights;
    p->scene.light_count = 2;
    p->scene.objects = p->objects;
    p->scene.object_count = 3;
}

/* ---- Frames ---- */

typedef struct screen {
    const glint_format *format;
    uint32_t sum, tiles;
} screen;

static int begin(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    screen *const s = context;
    const int is_paged = format_is_paged(s->format);
    const size_t row_bytes = is_paged ? (size_t)width : glint_row_bytes(s->format, (uint32_t)width);
    s->tiles++;
    s->sum = s->sum * 31 + (uint32_t)(x << 8 | y);
    for (int row = 0; row < height; row += is_paged ? 8 : 1)
        for (size_t i = 0; i < row_bytes; i++)
            s->sum = (s->sum ^ ((const uint8_t *)pixels)[(size_t)row * stride + i]) * 16777619u;
    return 0;
}

static int wait(void *context) {
    (void)context;
    return 0;
}

/* What a scene looks like, drawn and asked for. */
typedef struct answer {
    glint_status status, checked;
    uint32_t sums[2]; /* of a frame, and of one that finds what the first has left in the arena */
    int picked;
    glint_hit hit;
} answer;

static answer ask(const glint_config *config, const glint_scene *scene, screen *s) {
    glint_renderer renderer;
    glint_report told;
    answer a = {.picked = -1};
    a.status = glint_init(&renderer, config);
    for (int frame = 0; frame < 2 && a.status == GLINT_OK; frame++) {
        *s = (screen){.format = config->format};
        a.status = glint_render(&renderer, scene);
        a.sums[frame] = s->sum;
        require(a.status == GLINT_OK || s->tiles == 0, "errors found before the first tile");
    }
    if (a.status == GLINT_OK)
        a.picked = glint_pick(&renderer, scene, WIDTH / 2, HEIGHT / 2, &a.hit);
    a.checked = glint_check(config, scene, &told);
    return a;
}

static pages arena, pixels;

static void check_size(const glint_config *of, const glint_scene *scene, size_t size, const glint_need *need,
                       const answer *wanted) {
    glint_config config = *of;
    place.size = (unsigned)size;
    for (int is_at_end = 0; is_at_end < 2; is_at_end++) {
        screen s;
        place.is_at_end = (unsigned)is_at_end;
        config.arena = pages_place(&arena, size, 1, is_at_end);
        config.arena_size = size;
        if (of->pixels_size)
            config.pixels = pages_place(&pixels, of->pixels_size, sizeof(void *), is_at_end);
        config.flush.context = &s;
        const answer got = ask(&config, scene, &s);
        require(got.status == (size < need->least ? GLINT_ERROR_ARENA : GLINT_OK), "refused where it is too small");
        require(got.checked == got.status, "the same told by glint_check");
        require(got.status != GLINT_OK || memcmp(got.sums, wanted->sums, sizeof got.sums) == 0, "the picture");
        require(got.status != GLINT_OK || (got.picked == 1 && got.hit.object == wanted->hit.object &&
                                           got.hit.triangle == wanted->hit.triangle),
                "the triangle that was picked");
        require(pages_are_whole(&arena) && pages_are_whole(&pixels), "no write outside");
    }
}

/* @return how many sizes were tried */
static uint32_t check_format(const glint_scene *scene, unsigned number, size_t step) {
    screen s;
    glint_need need;
    uint32_t sizes = 0;
    glint_config config = {.width = WIDTH,
                           .height = HEIGHT,
                           .tile_width = number % 3 ? 16 : 8,
                           .tile_height = 8,
                           .format = every_format[number],
                           .flush = {begin, number % 2 ? wait : NULL, &s},
                           .keeps_arena = (uint8_t)(number / 2 % 2)};
    place.format = number;
    if (number / 4 % 2) {
        config.pixels_size = glint_pixels_need(&config);
        config.pixels = pages_place(&pixels, config.pixels_size, sizeof(void *), 0);
    }
    require(glint_arena_need(&config, scene, &need) == GLINT_OK && need.one_pass + BEYOND <= ARENA_MOST, "a need");
    config.arena_size = need.one_pass;
    config.arena = pages_place(&arena, config.arena_size, 1, 0);
    const answer wanted = ask(&config, scene, &s);
    require(wanted.status == GLINT_OK && wanted.picked == 1 && wanted.sums[0] == wanted.sums[1], "a picture");
    for (size_t size = 0; size <= need.one_pass + BEYOND; size++) {
        const size_t edges[3] = {need.least, need.resident, need.one_pass};
        int is_near = 0;
        for (int i = 0; i < 3; i++)
            is_near |= size + NEAR > edges[i] && size < edges[i] + NEAR;
        if (!is_near && size % step != number % step)
            continue;
        check_size(&config, scene, size, &need, &wanted);
        sizes++;
    }
    return sizes;
}

int main(int argc, char **argv) {
    static props scenes;
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL};
    const size_t step = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    uint32_t sizes = 0;
    if (step == 0) {
        fputs("arenas STEP\n", stderr);
        return 2;
    }
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        signal(signals[i], take_signal);
    pages_open(&arena, ARENA_MOST);
    pages_open(&pixels, PIXELS_MOST);
    for (unsigned i = 0; i < EVALUATIONS; i++) {
        place.evaluation = i;
        build(&scenes, evaluations[i]);
        for (unsigned number = 0; number < 16; number++)
            sizes += check_format(&scenes.scene, number, step);
    }
    printf("  %u arenas, each at both ends of its pages\n1 passed, 0 failed\n", (unsigned)sizes);
    return 0;
}
