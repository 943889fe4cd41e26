/* SPDX-License-Identifier: MIT */
/** @file victim.h Calls of the library with what tests/attack/stage.h has spoilt, and what must hold after each. */
#ifndef GLINT_ATTACK_VICTIM_H
#define GLINT_ATTACK_VICTIM_H

#include "stage.h"

/** What the flush callback has seen of a frame. */
typedef struct victim_screen {
    glint_rectangle region;                /**< What must come. */
    int left, top;                         /**< Where the screen lies on the display. */
    int next_x, next_y, height;            /**< Of the next tile; of its row. */
    uint32_t calls, painted, sum, fail_at; /**< The call that fails. */
    int is_sending;
} victim_screen;

/** A renderer with all that it writes to, in pages of their own. */
typedef struct victim {
    pages renderer, arena, pixels, out, signatures;
    glint_renderer *drawing;
    glint_config config; /**< That the renderer was set up with. */
    victim_screen screen;
    uint32_t wanted; /**< The sound frame's checksum. */
} victim;

/** An attack: calls that are counted as one. */
typedef struct victim_attack {
    const char *name;
    void (*run)(victim *v, attack_stage *stage, source *s);
} victim_attack;

extern const victim_attack victim_attacks[];
extern const uint32_t victim_attack_count;

void victim_open(victim *v);

/** Sets the renderer up with a configuration from a source, and draws the sound frame. */
void victim_begin(victim *v, source *s);

/** All canaries stand, and the sound frame is what it was. */
void victim_check(victim *v);

/** Ends the program with a report unless something holds. */
void attack_require(int holds, const char *what);

/** Counts what a call ended in; ends the program where that is no documented status. */
void attack_ended(int status);

/** Adds to the checksum of all answers. */
void attack_add(const void *bytes, size_t count);

#endif
