/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* POSIX of 2008: fork, limits */

#include "model.h"

#include "basics.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/** Exit status of a process that could not become the program: the shells' own. */
#define NOT_RUN 127

/** Bytes that are kept of what it says on stderr. */
#define SAID_MAX 160

/* ---- In the child ----------------------------------------------------------------------------------------------- */

static void limit(int resource, rlim_t most) {
    const struct rlimit both = {most, most};
    setrlimit(resource, &both);
}

/** Runs the program in this process. Text on stderr beyond the size of a pipe is lost. */
static void become(char *const arguments[], const child_limits *limits, int input, const int output[2],
                   const int errors[2]) {
    const int others[] = {input, output[0], output[1], errors[0], errors[1]};
    limit(RLIMIT_CPU, limits->seconds + 1);
    limit(RLIMIT_AS, (rlim_t)limits->megabytes << 20);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CORE, 0);
    alarm(limits->seconds);
    if (fcntl(errors[1], F_SETFL, O_NONBLOCK) == 0 && dup2(input, 0) >= 0 && dup2(output[1], 1) >= 0 &&
        dup2(errors[1], 2) >= 0) {
        for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
            if (others[i] > 2) {
                close(others[i]);
            }
        }
        execvp(arguments[0], arguments);
    }
    _exit(NOT_RUN);
}

/* ---- Beside it -------------------------------------------------------------------------------------------------- */

/** Reads a pipe up to its end, or up to `most` bytes. */
static void read_pipe(int pipe, size_t most, host_bytes *bytes) {
    ssize_t got = 1;
    while (bytes->count < most && (got > 0 || (got < 0 && errno == EINTR))) {
        const size_t left = most - bytes->count;
        bytes->data = memory_grow(bytes->data, &bytes->capacity, bytes->count + 65536, 1);
        got = read(pipe, bytes->data + bytes->count, left < 65536 ? left : 65536);
        bytes->count += got > 0 ? (size_t)got : 0;
    }
}

/** Says how it ended, where that was not well. */
static bool judge(const host_bytes *said, const child_limits *limits, int status, host_problem *problem) {
    char quote[SAID_MAX + 1];
    size_t length = 0;
    for (; length < said->count && said->data[length] != '\n'; length++) {
        const char c = (char)said->data[length];
        quote[length] = (char)(c >= ' ' && c <= '~' ? c : '?');
    }
    quote[length] = '\0';
    const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (number == SIGALRM) {
        return problem_set(problem, 0, "takes longer than %u s", limits->seconds);
    }
    if (number == SIGXCPU || number == SIGKILL) {
        return problem_set(problem, 0, "takes longer than %u s, or more memory than there is", limits->seconds);
    }
    if (number != 0) {
        return problem_set(problem, 0, "crashed by signal %d, with %u MB of memory", number, limits->megabytes);
    }
    return WEXITSTATUS(status) == 0 || problem_set(problem, 0, "%s",
                                                   length > 0                       ? quote
                                                   : WEXITSTATUS(status) == NOT_RUN ? "could not be run"
                                                                                    : "failed without a word");
}

/**
 * Opens the input: a temporary file without a name, since a program that does not read a pipe would block us.
 * @return a file descriptor, or -1
 */
static int open_input(const host_bytes *input) {
    FILE *file = input != NULL ? tmpfile() : fopen("/dev/null", "rb");
    const size_t count = input != NULL ? input->count : 0;
    const bool ok = file != NULL && (count == 0 || fwrite(input->data, 1, count, file) == count) && fflush(file) == 0;
    const int number = ok ? dup(fileno(file)) : -1;
    if (file != NULL) {
        fclose(file);
    }
    return number >= 0 && lseek(number, 0, SEEK_SET) == 0 ? number : -1;
}

bool child_run(char *const arguments[], const child_limits *limits, const host_bytes *input, host_bytes *out,
               host_problem *problem) {
    const int from = open_input(input);
    host_bytes said = {NULL, 0, 0};
    int output[2];
    int errors[2];
    int status = 0;
    pid_t process;
    memset(out, 0, sizeof *out);
    if (from < 0 || pipe(output) != 0 || pipe(errors) != 0 || (process = fork()) < 0) {
        return problem_set(problem, 0, "could not be run: %s", strerror(errno));
    }
    if (process == 0) {
        become(arguments, limits, from, output, errors);
    }
    close(from);
    close(output[1]);
    close(errors[1]);
    read_pipe(output[0], limits->output + 1, out);
    const bool fits = out->count <= limits->output;
    if (fits) {
        read_pipe(errors[0], SAID_MAX, &said);
    } else {
        kill(process, SIGKILL);
    }
    close(output[0]);
    close(errors[0]);
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    const bool ok = fits ? judge(&said, limits, status, problem)
                         : problem_set(problem, 0, "comes to more than %zu MB", limits->output / 1000000);
    free(said.data);
    if (!ok) {
        free(out->data);
    }
    return ok;
}
