/* SPDX-License-Identifier: MIT */
#include "pages.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define PAGE 4096u

/* Bytes looked at on each side of a buffer. */
#define CANARY 64u

#define MARK 0xc5

void pages_open(pages *of, size_t most) {
    const int zeros = open("/dev/zero", O_RDWR);
    *of = (pages){0};
    of->room_size = (most + PAGE - 1) / PAGE * PAGE + PAGE;
    uint8_t *const all = mmap(NULL, of->room_size + 2 * PAGE, PROT_NONE, MAP_PRIVATE, zeros, 0);
    if (zeros < 0 || all == MAP_FAILED || close(zeros) || mprotect(all + PAGE, of->room_size, PROT_READ | PROT_WRITE))
        abort();
    of->room = all + PAGE;
    (void)pages_place(of, 0, 1, 0);
}

void pages_close(pages *of) {
    if (munmap(of->room - PAGE, of->room_size + 2 * PAGE))
        abort();
}

/* The canaries before the buffer, or behind it. @return how many; `at` is set to the first */
static size_t canaries(const pages *of, int behind, uint8_t **at) {
    uint8_t *const end = of->bytes + of->size;
    const size_t room = (size_t)(behind ? of->room + of->room_size - end : of->bytes - of->room);
    const size_t count = room < CANARY ? room : CANARY;
    *at = behind ? end : of->bytes - count;
    return count;
}

void *pages_place(pages *of, size_t size, size_t alignment, int at_end) {
    if (size > of->room_size)
        abort();
    const size_t left = (of->room_size - size) & ~(alignment - 1);
    of->bytes = of->room + (at_end ? left : 0);
    of->size = size;
    for (int behind = 0; behind < 2; behind++) {
        uint8_t *at;
        const size_t count = canaries(of, behind, &at);
        memset(at, MARK, count);
    }
    return of->bytes;
}

static void protect(const pages *of, int protection) {
    if (mprotect(of->room, of->room_size, protection))
        abort();
}

void pages_seal(const pages *of) {
    protect(of, PROT_READ);
}

void pages_unseal(const pages *of) {
    protect(of, PROT_READ | PROT_WRITE);
}

int pages_are_whole(const pages *of) {
    for (int behind = 0; behind < 2; behind++) {
        uint8_t *at;
        const size_t count = canaries(of, behind, &at);
        for (size_t i = 0; i < count; i++)
            if (at[i] != MARK)
                return 0;
    }
    return 1;
}
