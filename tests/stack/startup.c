/* SPDX-License-Identifier: MIT */
/* Programs that tools/stack must judge: PLANTED chooses what is wrong with them. */
enum { NOTHING, RECURSION, UNBOUNDED, UNLISTED, DEEP };

static volatile int sink;
static void (*volatile pointer)(void);

__attribute__((noinline)) static void leaf(void) {
    volatile char room[64];
    room[0] = (char)sink;
    sink = room[0];
}

__attribute__((noinline)) static int again(int n) {
    volatile int here = n;
    return n < 2 ? n : again(n - 1) + again(n - 2) + here;
}

__attribute__((noinline)) static void unbounded(int n) {
    volatile char room[n];
    room[0] = 1;
    sink = room[n - 1];
}

__attribute__((noinline)) static void listed(void) {
    pointer();
    sink++;
}

__attribute__((noinline)) static void unlisted(void) {
    pointer();
    sink--;
}

__attribute__((noinline)) static void deep(void) {
    volatile char room[2000];
    room[sink] = 1;
    leaf();
}

void reset(void);

void reset(void) {
    pointer = leaf;
    listed();
    if (PLANTED == RECURSION)
        sink = again(sink);
    if (PLANTED == UNBOUNDED)
        unbounded(sink);
    if (PLANTED == UNLISTED)
        unlisted();
    if (PLANTED == DEEP)
        deep();
}
