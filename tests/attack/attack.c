/* SPDX-License-Identifier: MIT */
/*
 * Every public function with extreme, null and random arguments: attack SEED CALLS [ROUND], the round to begin with.
 *
 * What a caller hands in lies between pages that must not be touched, scenes in pages that cannot be written. A call
 * must end in a documented error or in a complete frame; what it fills in stays as it was on an error; and the next
 * frame of a sound scene by the same renderer is, byte for byte, what it was before.
 */
#include "stage.h"
#include "victim.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Calls on one scene and configuration, each spoilt in another way. */
#define CALLS_A_ROUND 32

/* Bytes that a round is made of; what lies behind is 0. */
#define ROUND_BYTES 4096

/* Where the program is, for the report of a fault. */
static struct {
    uint32_t seed, round, call;
    const char *name;
} place;

/* Counts by what calls ended in, from GLINT_OK to the last error. */
static uint32_t endings[30];

/* Calls for which bits of a mesh, a number or an arena were flipped. */
static uint32_t flips;

/* Of what calls answered: the same from every compiler, which shows that they were the same calls. */
static uint32_t checksum = 2166136261u;

static void report(void) {
    char text[160];
    /* NOLINTNEXTLINE(bugprone-signal-handler): a fault is one of the library's, which is never within snprintf */
    const int length = snprintf(text, sizeof text, "seed %u, round %u, call %u: %s\n", (unsigned)place.seed,
                                (unsigned)place.round, (unsigned)place.call, place.name);
    (void)!write(STDERR_FILENO, text, (size_t)length);
}

static void take_signal(int number) {
    report();
    signal(number, SIG_DFL);
    raise(number);
}

void attack_require(int holds, const char *what) {
    if (holds)
        return;
    report();
    fprintf(stderr, "broken: %s\n", what);
    exit(1);
}

void attack_add(const void *bytes, size_t count) {
    const uint8_t *const each = bytes;
    for (size_t i = 0; i < count; i++)
        checksum = (checksum ^ each[i]) * 16777619u; /* FNV-1a (Fowler, Noll and Vo) */
}

void attack_ended(int status) {
    attack_require(status <= 1 && status >= GLINT_ERROR_STRIDE, "a documented status");
    attack_require(strcmp(glint_strerror(status < 0 ? status : 0), "unknown status") != 0, "a status with a sentence");
    endings[status < 0 ? -status : 0]++;
    attack_add(&place.call, sizeof place.call);
    attack_add(&status, sizeof status);
}

static void fill(source *s, uint8_t bytes[ROUND_BYTES], uint32_t *state) {
    for (size_t i = 0; i < ROUND_BYTES; i++)
        bytes[i] = (uint8_t)next_random(state);
    *s = (source){bytes, ROUND_BYTES};
}

/* A scene, a configuration, and many calls. @return how many */
static uint32_t draw_round(attack_stage *stage, victim *v, uint32_t most) {
    static uint8_t bytes[ROUND_BYTES];
    uint32_t state = place.seed * 2654435761u + place.round, calls = 0;
    source s;
    fill(&s, bytes, &state);
    place.name = "the round's scene";
    attack_stage_take(stage, &s, !one_in(&s, 4));
    victim_begin(v, &s);
    for (; calls < CALLS_A_ROUND && calls < most; calls++) {
        fill(&s, bytes, &state);
        place.call = calls;
        const victim_attack *const attack = &victim_attacks[next_random(&state) % victim_attack_count];
        flips += strncmp(attack->name, "flipped", 7) == 0;
        place.name = attack->name;
        if (below(&s, 4))
            attack_stage_spoil(stage, &s);
        attack->run(v, stage, &s);
        victim_check(v);
        attack_stage_restore(stage);
    }
    return calls;
}

/* Every error that a scene or a configuration can have, but for those of panels and buses. */
static int are_all_seen(void) {
    int missing = 0;
    for (int i = 0; i <= -GLINT_ERROR_STRIDE; i++) {
        const int is_of_panels = i >= -GLINT_ERROR_TIMEOUT && i <= -GLINT_ERROR_ROTATION;
        const int is_left = strstr(glint_strerror(-i), "former versions") != NULL;
        if (!is_of_panels && !is_left && !endings[i])
            missing += printf("never ended in: %s\n", glint_strerror(-i)) > 0;
    }
    return !missing;
}

int main(int argc, char **argv) {
    static attack_stage stage;
    static victim v;
    if (argc != 3 && argc != 4) {
        fputs("attack SEED CALLS [ROUND]\n", stderr);
        return 2;
    }
    place.seed = (uint32_t)strtoul(argv[1], NULL, 10);
    place.round = argc == 4 ? (uint32_t)strtoul(argv[3], NULL, 10) : 0;
    const uint32_t wanted = (uint32_t)strtoul(argv[2], NULL, 10);
    const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        signal(signals[i], take_signal);
    attack_stage_open(&stage);
    victim_open(&v);
    uint32_t calls = 0, all = 0;
    for (; calls < wanted; place.round++)
        calls += draw_round(&stage, &v, wanted - calls);
    for (int i = 0; i <= -GLINT_ERROR_STRIDE; i++)
        all += endings[i];
    printf("  %u calls in %u rounds, %u with flipped bits; %u answers, %u of them without an error; checksum %08x\n",
           (unsigned)calls, (unsigned)place.round, (unsigned)flips, (unsigned)all, (unsigned)endings[0],
           (unsigned)checksum);
    const int passed = are_all_seen();
    printf("%d passed, %d failed\n", passed, !passed);
    return !passed;
}
