/* SPDX-License-Identifier: MIT */
/**
 * @file main.c
 * The window: `glint-view [MODEL|SCENE] [options of glint render]`. SDL brings keys, mouse and dropped files in, and
 * the canvas out; all else is in window.h.
 */
#include "window.h"

#include "basics.h"
#include "command.h"

#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** A window opens with room for a picture of this size, so many times magnified where the screen has room for that. */
#define PICTURE_WIDTH 320
#define PICTURE_HEIGHT 240
#define MAGNIFIED_MOST 3

/** Least height of a canvas, which holds the help; and pixels that a title bar may take of the screen. */
#define CANVAS_LEAST 640
#define TITLE_BAR 40

/** What the mouse does as long as its button is down. */
typedef enum grip { GRIP_NONE, GRIP_ORBIT, GRIP_SUBJECT, GRIP_SLIDER } grip;

typedef struct shell {
    SDL_Window *window;
    window_state state;
    grip mouse;
    bool ends, is_stale;
} shell;

/* ---- Canvas ----------------------------------------------------------------------------------------------------- */

static int fail(const char *what) {
    fprintf(stderr, "glint-view: %s: %s\n", what, SDL_GetError());
    return COMMAND_FAILED;
}

/** Draws everything and shows it. @return whether that could be done */
static bool show(shell *all) {
    SDL_Surface *screen = SDL_GetWindowSurface(all->window);
    if (screen == NULL) {
        return false;
    }
    const label_picture canvas = {memory_new((size_t)screen->w * (size_t)screen->h, 3), (uint32_t)screen->w,
                                  (uint32_t)screen->h, 3};
    window_draw(&all->state, &canvas);
    SDL_Surface *drawn = SDL_CreateRGBSurfaceWithFormatFrom(canvas.pixels, screen->w, screen->h, 24, 3 * screen->w,
                                                            SDL_PIXELFORMAT_RGB24);
    const bool ok = drawn != NULL && SDL_BlitSurface(drawn, NULL, screen, NULL) == 0;
    SDL_FreeSurface(drawn);
    free(canvas.pixels);
    all->is_stale = false;
    return ok && SDL_UpdateWindowSurface(all->window) == 0;
}

/* ---- Events ----------------------------------------------------------------------------------------------------- */

static int translate(SDL_Keycode key) {
    static const struct {
        SDL_Keycode key;
        int code;
    } named[] = {{SDLK_F1, WINDOW_KEY_F1},
                 {SDLK_F2, WINDOW_KEY_F2},
                 {SDLK_LEFT, WINDOW_KEY_LEFT},
                 {SDLK_RIGHT, WINDOW_KEY_RIGHT},
                 {SDLK_PAGEUP, WINDOW_KEY_PAGE_UP},
                 {SDLK_HOME, WINDOW_KEY_HOME},
                 {SDLK_PAGEDOWN, WINDOW_KEY_PAGE_DOWN}};
    for (size_t i = 0; i < sizeof named / sizeof named[0]; i++) {
        if (named[i].key == key) {
            return named[i].code;
        }
    }
    return key >= SDLK_a && key <= SDLK_z ? 'A' + (int)(key - SDLK_a) : key < 128 ? (int)key : 0;
}

static void press_key(shell *all, const SDL_KeyboardEvent *event) {
    const int key = translate(event->keysym.sym);
    if (event->keysym.sym == SDLK_ESCAPE) {
        all->ends = true;
    } else if ((event->keysym.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) == 0 && key != 0) {
        window_key(&all->state, key, (event->keysym.mod & KMOD_SHIFT) != 0);
        all->is_stale = true;
    }
}

static void drop_file(shell *all, char *path) {
    host_problem problem;
    if (!window_open(&all->state, path, &problem)) {
        snprintf(all->state.message, sizeof all->state.message, "%.60s:%zu: %.80s", path_base_name(path), problem.line,
                 problem.text);
    }
    SDL_free(path);
    all->is_stale = true;
}

static void move_mouse(shell *all, const SDL_MouseMotionEvent *event) {
    if (all->mouse == GRIP_ORBIT) {
        window_drag(&all->state, event->xrel, event->yrel);
        all->is_stale = true;
    } else if (all->mouse == GRIP_SUBJECT) {
        window_drag_subject(&all->state, event->xrel, event->yrel);
        all->is_stale = true;
    } else if (all->mouse == GRIP_SLIDER) {
        const window_box *slider = &all->state.slider;
        const int last = slider->x + slider->width - 1;
        const int x = event->x < slider->x ? slider->x : event->x > last ? last : event->x;
        all->is_stale |= window_press(&all->state, x, slider->y);
    }
}

static void press_button(shell *all, const SDL_MouseButtonEvent *event) {
    if (event->button == SDL_BUTTON_RIGHT) {
        all->mouse = GRIP_SUBJECT;
    } else if (event->button == SDL_BUTTON_LEFT) {
        all->mouse = window_press(&all->state, event->x, event->y) ? GRIP_SLIDER : GRIP_ORBIT;
        all->is_stale |= all->mouse == GRIP_SLIDER;
    }
}

static void handle(shell *all, const SDL_Event *event) {
    switch (event->type) {
    case SDL_QUIT:
        all->ends = true;
        break;
    case SDL_WINDOWEVENT:
        all->is_stale = true;
        break;
    case SDL_KEYDOWN:
        press_key(all, &event->key);
        break;
    case SDL_DROPFILE:
        drop_file(all, event->drop.file);
        break;
    case SDL_MOUSEMOTION:
        move_mouse(all, &event->motion);
        break;
    case SDL_MOUSEBUTTONUP:
        all->mouse = GRIP_NONE;
        break;
    case SDL_MOUSEWHEEL:
        window_wheel(&all->state, event->wheel.y);
        all->is_stale = true;
        break;
    case SDL_MOUSEBUTTONDOWN:
        press_button(all, &event->button);
        break;
    default:
        break;
    }
}

/** Until the window is closed: waits for events, takes all that are there, and draws once. */
static int run(shell *all) {
    uint64_t next = SDL_GetTicks64() + WINDOW_TICK;
    while (!all->ends) {
        SDL_Event event;
        const bool moves = all->state.runs || all->state.changes.lights_turn;
        if (all->is_stale && !show(all)) {
            return fail("the window cannot be drawn");
        }
        int there = moves ? SDL_WaitEventTimeout(&event, WINDOW_TICK / 4) : SDL_WaitEvent(&event);
        for (; there; there = SDL_PollEvent(&event)) {
            handle(all, &event);
        }
        if (moves && SDL_GetTicks64() >= next) {
            all->is_stale |= window_tick(&all->state);
            next = SDL_GetTicks64() + WINDOW_TICK;
        }
    }
    return 0;
}

/* ---- Program ---------------------------------------------------------------------------------------------------- */

static void print_help(void) {
    printf("glint-view [MODEL|SCENE[:VARIANT]] [options]\n"
           "  a window that shows a model or a scene as a panel does; torus:48x24\n\n");
    for (const window_help *help = window_helps; help->keys != NULL; help++) {
        printf("  %-12s %s\n", help->keys, help->what);
    }
    printf("  %-12s %s\n\nA file that is dropped on the window is shown. Options are those of glint render:\n", "Esc",
           "close the window");
    settings_help(COMMAND_RENDER);
}

/** Opens a window that fits the screen. @return null where that fails */
static SDL_Window *open_window(void) {
    SDL_Rect screen = {0, 0, 0, 0};
    int width = 0;
    int height = 0;
    int times = MAGNIFIED_MOST;
    SDL_GetDisplayUsableBounds(0, &screen); /* no size where it fails: the smallest window */
    do {
        width = times * PICTURE_WIDTH + 2 * WINDOW_MARGIN + WINDOW_SIDE;
        height = times * PICTURE_HEIGHT + 2 * WINDOW_MARGIN + 40;
        height = height > CANVAS_LEAST ? height : CANVAS_LEAST;
    } while ((width > screen.w || height + TITLE_BAR > screen.h) && --times > 0);
    return SDL_CreateWindow("glint", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, width, height,
                            SDL_WINDOW_RESIZABLE);
}

/** Returns whether SDL draws where nobody sees it. It does so by itself where there is no display. */
static bool is_unseen(void) {
    const char *driver = SDL_GetCurrentVideoDriver();
    return SDL_getenv("SDL_VIDEODRIVER") == NULL && (strcmp(driver, "offscreen") == 0 || strcmp(driver, "dummy") == 0);
}

/** Opens what is named, and a window. @return 0, or an exit status */
static int start(shell *all, const host_settings *settings) {
    host_problem problem;
    const char *name = settings->model != NULL ? settings->model : "torus:48x24";
    window_init(&all->state, settings);
    if (!window_open(&all->state, name, &problem)) {
        return command_fail(name, &problem);
    }
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        return fail("no screen");
    }
    if (is_unseen()) {
        SDL_SetError("there is no display");
        return fail("no screen");
    }
    all->window = open_window();
    SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
    return all->window != NULL ? 0 : fail("no window");
}

int main(int count, char *arguments[]) {
    static shell all = {.is_stale = true};
    host_settings settings;
    host_problem problem;
    settings_default(&settings);
    settings.format = framebuffer_find_format("rgb565", NULL);
    if (!settings_parse(&settings, COMMAND_RENDER, count - 1, arguments + 1, &problem)) {
        return command_fail(NULL, &problem);
    }
    if (settings.help) {
        print_help();
        return 0;
    }
    int status = start(&all, &settings);
    status = status != 0 ? status : run(&all);
    window_free(&all.state);
    SDL_Quit();
    return status;
}
