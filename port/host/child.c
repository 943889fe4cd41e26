/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: poll, fork, limits, clocks */

#include "model.h"

#include "basics.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/** Exit status of a process that could not become the program: the shells' own. */
#define NOT_RUN 127

/** Bytes that are kept of what it says on stderr. */
#define SAID_MAX 160

typedef struct child_process {
    const child_limits *limits;
    pid_t process;
    int output, errors; /* ends of pipes to read from */
    host_bytes *out, said;
} child_process;

/* ---- In the child ----------------------------------------------------------------------------------------------- */

static void limit(int resource, rlim_t most) {
    const struct rlimit both = {most, most};
    setrlimit(resource, &both);
}

/** Has a descriptor closed where the program begins, unless it is one of its own three. */
static void keep_back(int file) {
    if (file > 2) {
        fcntl(file, F_SETFD, FD_CLOEXEC);
    }
}

/** Becomes the program. */
static void become(char *const arguments[], const child_limits *limits, const int output[2], const int errors[2]) {
    const int nothing = open("/dev/null", O_RDONLY);
    limit(RLIMIT_CPU, limits->seconds + 1);
    limit(RLIMIT_AS, (rlim_t)limits->megabytes << 20);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CORE, 0);
    if (nothing >= 0 && dup2(nothing, 0) >= 0 && dup2(output[1], 1) >= 0 && dup2(errors[1], 2) >= 0) {
        keep_back(nothing);
        for (int i = 0; i < 2; i++) {
            keep_back(output[i]);
            keep_back(errors[i]);
        }
        execvp(arguments[0], arguments);
    }
    _exit(NOT_RUN);
}

/* ---- Beside it -------------------------------------------------------------------------------------------------- */

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/** Reads what has come, and keeps it up to a limit. @return false at the end */
static bool take(int pipe, host_bytes *bytes, size_t most) {
    bytes->data = memory_grow(bytes->data, &bytes->capacity, bytes->count + 65536, 1);
    const ssize_t got = read(pipe, bytes->data + bytes->count, 65536);
    bytes->count += got > 0 ? (size_t)got : 0;
    bytes->count = bytes->count < most ? bytes->count : most;
    return got > 0 || (got < 0 && errno == EINTR);
}

/** Reads both pipes to their ends. @return false with a problem when that takes too long or gives too much */
static bool read_all(child_process *child, host_problem *problem) {
    const double end = now() + child->limits->seconds;
    struct pollfd pipes[2] = {{child->output, POLLIN, 0}, {child->errors, POLLIN, 0}};
    while (pipes[0].fd >= 0 || pipes[1].fd >= 0) {
        const double left = end - now();
        if (left <= 0) {
            return problem_set(problem, 0, "takes longer than %u s", child->limits->seconds);
        }
        if (poll(pipes, 2, (int)(left * 1000) + 1) <= 0) {
            continue;
        }
        if (pipes[0].revents != 0 && !take(child->output, child->out, child->limits->output + 1)) {
            pipes[0].fd = -1;
        }
        if (pipes[1].revents != 0 && !take(child->errors, &child->said, SAID_MAX)) {
            pipes[1].fd = -1;
        }
        if (child->out->count > child->limits->output) {
            return problem_set(problem, 0, "comes to more than %zu MB of text", child->limits->output / 1000000);
        }
    }
    return true;
}

/** Says how it ended, where that was not well. */
static bool judge(const child_process *child, int status, host_problem *problem) {
    char quote[SAID_MAX + 1];
    size_t length = 0;
    for (; length < child->said.count && child->said.data[length] != '\n'; length++) {
        const char c = (char)child->said.data[length];
        quote[length] = (char)(c >= ' ' && c <= '~' ? c : '?');
    }
    quote[length] = '\0';
    const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (number == SIGXCPU || number == SIGKILL) {
        return problem_set(problem, 0, "takes longer than %u s, or more memory than there is", child->limits->seconds);
    }
    if (number != 0) {
        return problem_set(problem, 0, "crashed by signal %d, with %u MB of memory", number, child->limits->megabytes);
    }
    return WEXITSTATUS(status) == 0 || problem_set(problem, 0, "%s",
                                                   length > 0                       ? quote
                                                   : WEXITSTATUS(status) == NOT_RUN ? "could not be run"
                                                                                    : "failed without a word");
}

/** Waits for it; it may have closed its pipes and go on. */
static int wait_for(const child_process *child, double end) {
    const struct timespec pause = {0, 2000000};
    int status = 0;
    pid_t ended;
    while ((ended = waitpid(child->process, &status, WNOHANG)) == 0 && now() < end) {
        nanosleep(&pause, NULL);
    }
    if (ended == 0) {
        kill(child->process, SIGKILL);
        while (waitpid(child->process, &status, 0) < 0 && errno == EINTR) {
        }
    }
    return status;
}

static bool attend(child_process *child, host_problem *problem) {
    const double end = now() + child->limits->seconds;
    const bool read = read_all(child, problem);
    close(child->output);
    close(child->errors);
    const int status = wait_for(child, read ? end : 0);
    return read && judge(child, status, problem);
}

static void close_pipe(const int ends[2]) {
    close(ends[0]);
    close(ends[1]);
}

bool child_run(char *const arguments[], const child_limits *limits, host_bytes *out, host_problem *problem) {
    child_process child = {.limits = limits, .out = out};
    int output[2];
    int errors[2];
    memset(out, 0, sizeof *out);
    if (pipe(output) != 0) {
        return problem_set(problem, 0, "could not be run: %s", strerror(errno));
    }
    if (pipe(errors) != 0 || (child.process = fork()) < 0) {
        close_pipe(output);
        return problem_set(problem, 0, "could not be run: %s", strerror(errno));
    }
    if (child.process == 0) {
        become(arguments, limits, output, errors);
    }
    close(output[1]);
    close(errors[1]);
    child.output = output[0];
    child.errors = errors[0];
    const bool ok = attend(&child, problem);
    free(child.said.data);
    if (!ok) {
        free(out->data);
    }
    return ok;
}
