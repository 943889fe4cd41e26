/* SPDX-License-Identifier: MIT */
/*
 * A plugin for QEMU that counts, by their kind, the instructions that a Cortex-M executes between marks (marks.h), and
 * how often those that may go elsewhere did. The argument out=FILE names where it writes a line at each mark that asks
 * for one, name=count with a space between:
 *     plain=3120 multiply=40 ... branch=410 branch_taken=300 ... multiple_words=120
 * and starts again from nothing. QEMU reports no branch, but the block that it executes next.
 * With tables=FIRST:END, addresses in hexadecimal, the line also counts what goes to memory below 0x20000000, the code
 * region: words of instructions, words that were fetched behind a branch that was taken, those of them where a word
 * begins behind the branch, and words of data: literals, those between the two addresses, and others.
 */
#include "qemu_plugin.h"
#include "thumb.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

QEMU_PLUGIN_EXPORT int qemu_plugin_version = QEMU_PLUGIN_VERSION;
QEMU_PLUGIN_EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv);

/* Hints that no compiler writes: the first one counts and the next one stops counting; the other one writes. */
enum { MARK_TOGGLE = 0xbf40, MARK_WRITE = 0xbf10 };

/* Code region of ARMv6-M and ARMv7-M. */
enum { CODE_END = 0x20000000 };

/* Instructions that are executed one after the other: of a block, or from a mark in it to the next. */
typedef struct run {
    struct run *next;
    uint64_t first, end; /* addresses of the first instruction, and behind the last one */
    thumb_kind last;
    uint64_t executed, taken;
    uint64_t continued; /* how often the word that it begins in was there, fetched for the run before it */
    uint32_t kinds[THUMB_KIND_COUNT];
    uint32_t words[THUMB_KIND_COUNT];
} run;

static run *runs;
static run *before; /* executed last */
static int is_counting;
static unsigned long long tables[2]; /* their first address, and behind the last one */
static uint64_t literals, table_reads, other_reads;
static FILE *output;

static run *run_new(uint64_t address) {
    run *made = calloc(1, sizeof *made);

    if (!made) {
        fputs("cycles: no memory\n", stderr);
        abort();
    }
    made->first = made->end = address;
    made->next = runs;
    runs = made;
    return made;
}

/* ---- While code runs ---- */

static void count_run(unsigned int vcpu, void *context) {
    run *entered = context;

    (void)vcpu;
    if (is_counting) {
        if (before && before->end != entered->first)
            before->taken++;
        else if (before && entered->first % 4 != 0)
            entered->continued++;
        entered->executed++;
    }
    before = entered;
}

static void count_toggle(unsigned int vcpu, void *context) {
    before = NULL;
    is_counting = !is_counting;
    count_run(vcpu, context);
}

/* Nothing is stored where code lies: a word there is read. */
static void count_read(unsigned int vcpu, qemu_plugin_meminfo_t info, uint64_t address, void *context) {
    (void)vcpu;
    (void)info;
    if (is_counting && address < CODE_END)
        ++*(context ? &literals : address >= tables[0] && address < tables[1] ? &table_reads : &other_reads);
}

/* Words that go to the code region, at the end of a line. */
static void write_code_region(void) {
    uint64_t words = 0, ahead = 0, ahead_of_word = 0;

    for (const run *counted = runs; counted; counted = counted->next) {
        if (counted->first < CODE_END) {
            words += counted->executed * ((counted->end + 3) / 4 - counted->first / 4) - counted->continued;
            ahead += counted->taken;
            ahead_of_word += counted->end % 4 == 0 ? counted->taken : 0;
        }
    }
    fprintf(output, " code_words=%llu code_ahead=%llu code_ahead_of_word=%llu", (unsigned long long)words,
            (unsigned long long)ahead, (unsigned long long)ahead_of_word);
    fprintf(output, " code_literals=%llu code_tables=%llu code_data=%llu", (unsigned long long)literals,
            (unsigned long long)table_reads, (unsigned long long)other_reads);
    literals = table_reads = other_reads = 0;
}

static void write_counts(unsigned int vcpu, void *context) {
#define NAME(name) #name,
    static const char *const names[] = {THUMB_KINDS(NAME)};
#undef NAME
    uint64_t kinds[THUMB_KIND_COUNT] = {0}, words[THUMB_KIND_COUNT] = {0}, taken[THUMB_KIND_COUNT] = {0};

    (void)vcpu;
    (void)context;
    for (run *counted = runs; counted; counted = counted->next) {
        for (int i = 0; i < THUMB_KIND_COUNT; i++) {
            kinds[i] += counted->executed * counted->kinds[i];
            words[i] += counted->executed * counted->words[i];
        }
        if (thumb_is_control(counted->last))
            taken[counted->last] += counted->taken;
    }
    for (int i = 0; i < THUMB_KIND_COUNT; i++) {
        fprintf(output, "%s%s=%llu", i ? " " : "", names[i], (unsigned long long)kinds[i]);
        if (thumb_is_control((thumb_kind)i))
            fprintf(output, " %s_taken=%llu", names[i], (unsigned long long)taken[i]);
        if (i == THUMB_multiple || i == THUMB_multiple_jump)
            fprintf(output, " %s_words=%llu", names[i], (unsigned long long)words[i]);
    }
    if (tables[1])
        write_code_region();
    for (run *counted = runs; counted; counted = counted->next) {
        counted->executed = counted->taken = counted->continued = 0;
    }
    fputc('\n', output);
    fflush(output);
}

/* ---- When code is translated ---- */

static int is_load(thumb_kind kind) {
    return kind == THUMB_load || kind == THUMB_load_next || kind == THUMB_float_load || kind == THUMB_float_load_next;
}

/* A load or store right after a load has its address ready, unless it is made of what is loaded. */
static thumb_kind kind_after(const thumb_instruction *earlier, const thumb_instruction *now) {
    const int waits = earlier->target != THUMB_NONE && (earlier->target == now->base || earlier->target == now->index);
    const int follows = is_load(earlier->kind) && !waits;

    if (follows && now->kind == THUMB_load)
        return THUMB_load_next;
    if (follows && now->kind == THUMB_float_load)
        return THUMB_float_load_next;
    if (follows && (now->kind == THUMB_store || now->kind == THUMB_store_indexed))
        return THUMB_store_next;
    return now->kind;
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *block) {
    const size_t count = qemu_plugin_tb_n_insns(block);
    run *filled = run_new(qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(block, 0)));
    thumb_instruction earlier = {.kind = THUMB_plain};

    (void)id;
    qemu_plugin_register_vcpu_tb_exec_cb(block, count_run, QEMU_PLUGIN_CB_NO_REGS, filled);
    for (size_t i = 0; i < count; i++) {
        struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
        const unsigned bytes = (unsigned)qemu_plugin_insn_size(instruction);
        const uint64_t address = qemu_plugin_insn_vaddr(instruction);
        uint16_t code[2];

        memcpy(code, qemu_plugin_insn_data(instruction), bytes);
        if (code[0] == MARK_WRITE)
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, write_counts, QEMU_PLUGIN_CB_NO_REGS, NULL);
        if (code[0] == MARK_TOGGLE) {
            filled = run_new(address + bytes);
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, count_toggle, QEMU_PLUGIN_CB_NO_REGS, filled);
            continue;
        }
        thumb_instruction decoded = thumb_decode(code, bytes);
        decoded.kind = kind_after(&earlier, &decoded);
        filled->kinds[decoded.kind]++;
        filled->words[decoded.kind] += (uint32_t)decoded.registers;
        filled->last = decoded.kind;
        if (tables[1])
            qemu_plugin_register_vcpu_mem_cb(instruction, count_read, QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_MEM_RW,
                                             decoded.base == THUMB_PC ? filled : NULL);
        filled->end = address + bytes;
        earlier = decoded;
    }
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv) {
    static const char option[] = "out=";

    (void)info;
    if (argc < 1 || argc > 2 || strncmp(argv[0], option, sizeof option - 1) != 0 ||
        (argc == 2 && sscanf(argv[1], "tables=%llx:%llx", &tables[0], &tables[1]) != 2)) {
        fputs("cycles: out=FILE expected, and tables=FIRST:END may follow\n", stderr);
        return 1;
    }
    output = fopen(argv[0] + sizeof option - 1, "w");
    if (!output) {
        perror(argv[0]);
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
