/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: signals; interval timers */

#include "progress.h"

#include "problem.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

/** Seconds before a line shows, and microseconds from one to the next. */
#define FIRST_AFTER 1
#define AGAIN_AFTER 200000

/** Bytes of a line, which a terminal has room for, and of what stands in it before the frames. */
#define LINE_SIZE 79
#define DOING_SIZE 46

/** What goes on. The handler reads it, so it changes while SIGALRM is blocked. */
static struct {
    char doing[DOING_SIZE];
    char line[LINE_SIZE];
    size_t length, shown; /* of the line, and of the one that stands on the terminal */
    struct sigaction before;
    int is_on;
} work;

static void write_all(const char *text, size_t length) {
    while (length > 0) {
        const ssize_t taken = write(STDERR_FILENO, text, length);
        if (taken <= 0) {
            return; /* nothing depends on it */
        }
        text += taken;
        length -= (size_t)taken;
    }
}

/** Writes the line over the one that stands there. */
static void show(int number) {
    static const char blanks[] = "                                                                               ";
    const int error = errno;
    (void)number;
    write_all("\r", 1);
    write_all(work.line, work.length);
    if (work.shown > work.length) {
        write_all(blanks, work.shown - work.length);
        write_all("\r", 1);
    }
    work.shown = work.length;
    errno = error;
}

static sigset_t hold_alarm(void) {
    sigset_t held;
    sigset_t before;
    sigemptyset(&held);
    sigaddset(&held, SIGALRM);
    sigprocmask(SIG_BLOCK, &held, &before);
    return before;
}

static void set_timer(long seconds, long microseconds) {
    const struct itimerval timer = {{0, microseconds}, {seconds, 0}};
    setitimer(ITIMER_REAL, &timer, NULL);
}

void progress_begin(const char *doing, const char *name) {
    struct sigaction action = {.sa_handler = show};
    char quote[PROBLEM_QUOTE_SIZE];
    work.is_on = isatty(STDERR_FILENO);
    if (!work.is_on) {
        return;
    }
    snprintf(work.doing, sizeof work.doing, "glint: %s%s%s", doing, name != NULL ? " " : "",
             name != NULL ? problem_quote(quote, name, strlen(name)) : "");
    snprintf(work.line, sizeof work.line, "%s", work.doing);
    work.length = strlen(work.line);
    work.shown = 0;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, &work.before);
    set_timer(FIRST_AFTER, AGAIN_AFTER);
}

void progress_frame(uint32_t frame, uint32_t count) {
    if (!work.is_on) {
        return;
    }
    const sigset_t mask = hold_alarm();
    snprintf(work.line, sizeof work.line, "%s frame %lu of %lu", work.doing, (unsigned long)frame,
             (unsigned long)count);
    work.length = strlen(work.line);
    sigprocmask(SIG_SETMASK, &mask, NULL);
}

void progress_end(void) {
    if (!work.is_on) {
        return;
    }
    const struct sigaction none = {.sa_handler = SIG_IGN}; /* one that is on its way is dropped */
    const sigset_t mask = hold_alarm();
    set_timer(0, 0);
    sigaction(SIGALRM, &none, NULL);
    sigaction(SIGALRM, &work.before, NULL);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    work.is_on = 0;
    work.length = 0;
    if (work.shown > 0) {
        show(SIGALRM);
    }
}
