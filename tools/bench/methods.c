/* SPDX-License-Identifier: MIT */
/*
 * Firmware that counts the instructions of every method in tests/unit/methods, over inputs such as a picture has many
 * of. The loop over them, with its loads and stores, is counted by itself and taken off. It writes a line for each,
 *     power,rational,cos,INSTRUCTIONS,call,BYTES
 * instructions in hundredths, for one call, pixel or vertex; bytes of tables.
 */
#include "unit/methods/methods.h"

#include "counter.h"

/** Units that a figure is the mean of; a tick then is less than a hundredth of an instruction. */
enum { UNITS = 8192 };

/** Words of the largest problem's inputs or outputs. */
enum { WORDS = 32 * 1024 };

static int32_t in[WORDS], out[WORDS];

typedef void (*method_loop)(const int32_t *in, int32_t *out, uint32_t count);

static uint32_t count_ticks(method_loop loop, uint32_t items, uint32_t repeats) {
    const uint32_t start = counter_now();
    for (uint32_t i = 0; i < repeats; i++) {
        loop(in, out, items);
    }
    return counter_ticks_since(start);
}

/* Hundredths of instructions a unit. */
static uint32_t measure(const method *m) {
    const method_problem *problem = m->problem;
    const uint32_t items = problem->units == 1 ? 256 : 32;
    const uint32_t repeats = (UNITS + items * problem->units - 1) / (items * problem->units);
    for (uint32_t i = 0; i < items; i++) {
        problem->bench_input(i, in + problem->in_words * i);
    }
    if (m->prepare) {
        m->prepare(problem->bench_point);
    }
    const uint32_t all = count_ticks(m->run, items, repeats), loop = count_ticks(problem->empty, items, repeats);
    const uint64_t hundredths = (uint64_t)(all > loop ? all - loop : 0) * (100 * COUNTER_INSTRUCTIONS_PER_TICK);
    return (uint32_t)(hundredths / ((uint64_t)items * problem->units * repeats));
}

static void write_field(const char *text) {
    board_write(text);
    board_write(",");
}

int main(void) {
    counter_start();
    for (uint32_t i = 0; i < methods_count(); i++) {
        const method *m = methods_get(i);
        write_field(m->problem->kind);
        write_field(m->name);
        write_field(m->variant);
        write_number(measure(m), ",");
        write_field(m->problem->unit);
        write_number(m->table_bytes, "\n");
    }
    return 0;
}
