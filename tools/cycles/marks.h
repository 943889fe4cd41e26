/* SPDX-License-Identifier: MIT */
/**
 * @file marks.h
 * Marks in firmware between which plugin.c counts: hints that do nothing on any core, and that no compiler writes.
 * Cores that are not Arm's have none.
 */
#ifndef GLINT_CYCLES_MARKS_H
#define GLINT_CYCLES_MARKS_H

#if defined(__arm__)
#define CYCLES_MARK(hint) __asm volatile(hint ::: "memory")
#else
#define CYCLES_MARK(hint) ((void)0)
#endif

/** Counts from here on. */
#define CYCLES_START() CYCLES_MARK("sev")

/** Up to here. */
#define CYCLES_STOP() CYCLES_MARK("sev")

/** Writes what was counted since it was written last. */
#define CYCLES_WRITE() CYCLES_MARK("yield")

#endif
