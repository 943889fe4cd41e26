# SPDX-License-Identifier: MIT
"""What shows in a terminal: the preview, help for a command, words that were meant, completion, the manual page."""
import os
import pty
import re
import subprocess

from harness import ROOT, Preloaded

CELL = re.compile("\033\\[38;2;(\\d+);(\\d+);(\\d+);48;2;(\\d+);(\\d+);(\\d+)m\u2580")


def read_preview(text):
    """Rows of pixels, from lines of half blocks."""
    rows = []
    for line in text.splitlines():
        if not line.endswith("\033[0m") or CELL.sub("", line) != "\033[0m":
            raise ValueError(repr(line[:80]))
        cells = [tuple(map(int, cell)) for cell in CELL.findall(line)]
        rows += [[cell[:3] for cell in cells], [cell[3:] for cell in cells]]
    return rows


def test_preview(host):
    drawn = host.render("torus:24x12", "--size", "40x31").rows
    run = host.run("render", "torus:24x12", "--size", "40x31", "--preview", "40")
    host.equal("as wide as the picture", read_preview(run.stdout), drawn + [[(0, 0, 0)] * 40])
    host.check("without a file", run.returncode == 0 and "out.png" not in host.files())
    run = host.run("render", "torus:24x12", "--size", "40x31", "--preview", "39")
    means = [[tuple((sum(drawn[y + j][x + i][c] for j in (0, 1) for i in (0, 1)) + 2) // 4 for c in range(3)) for x in range(0, 40, 2)]
             for y in range(0, 30, 2)]
    host.equal("half as wide", read_preview(run.stdout)[:15], means)
    grey = host.run("render", "torus:24x12", "--size", "40x30", "--format", "grey8", "--preview", "1024", "-o", "grey.png")
    host.check("grey, and a file", all(r == g == b for row in read_preview(grey.stdout) for r, g, b in row) and "grey.png" in host.files())
    os.remove(host.path("grey.png"))
    host.check("a scene", len(read_preview(host.run("scene", "teapot", "--preview", "80").stdout)) == 40)


def commands(host):
    return re.findall(r"^glint ([a-z]+) [A-Z[]", host.run("help").stdout, re.M)


def options(host, command):
    return re.findall(r"^  (--?[a-z-]+) ", host.run(command, "--help").stdout, re.M)


def test_help(host):
    for command in commands(host):
        if command != "help":
            host.equal(f"help {command}", host.run("help", command).stdout, host.run(command, "--help").stdout)
    host.refuses("help for no command", ["help", "nothing"], r"glint: unknown command 'nothing': see glint help")
    host.refuses("a command that was meant", ["rendr"], r"glint: unknown command 'rendr': did you mean render\?")
    said = " ".join(host.run("help").stdout.split())
    host.check("exit statuses are told", "exit status is 0 when all was done, 1 when it was and --compare found a difference, else 2" in said)


def complete(host, *words):
    """What bash offers for the last word."""
    script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _glint; printf "%s\\n" "${COMPREPLY[@]}"')
    run = subprocess.run(["bash", "-c", script, "bash", os.path.join(ROOT, "port/host/completion.bash"), host.program, *words],
                         capture_output=True, text=True, cwd=host.folder.name, check=False)
    if run.returncode != 0 or run.stderr:
        raise AssertionError(run.stderr)
    return run.stdout.split()


def test_completion(host):
    host.equal("commands", sorted(complete(host, "")), sorted({*commands(host), "help", "--version"}))
    host.equal("a command", complete(host, "sc"), ["scene"])
    for command in commands(host):
        if command != "help":
            host.equal(f"options of {command}", sorted(complete(host, command, "-")), sorted(set(options(host, command))))
    host.equal("an option", complete(host, "render", "--vi"), ["--viewer"])
    host.equal("its values", complete(host, "render", "--viewer", ""), ["infinite", "local"])
    host.check("scenes", {"teapot", "teapot:vertex"} <= set(complete(host, "scene", "teapot")), str(complete(host, "scene", "teapot")))
    host.write("a-model.obj", "")
    host.check("files", "a-model.obj" in complete(host, "render", "a-m"))
    for command, option in (("render", "--compare"), ("scene", "--compare"), ("scene", "-o"), ("scene", "--heat")):
        host.equal(f"files for {command} {option}", complete(host, command, option, "a-"), ["a-model.obj"])
    host.check("shapes", "torus:" in complete(host, "info", "tor"))
    os.remove(host.path("a-model.obj"))


def test_manual(host):
    run = subprocess.run(["sh", os.path.join(ROOT, "port/host/man.sh"), host.program], capture_output=True, text=True, check=False)
    page = run.stdout.replace("\\-", "-")
    host.check("the manual page", run.returncode == 0 and page.startswith(".TH GLINT 1"), run.stderr)
    for command in commands(host):
        if command != "help":
            text = page.split(f".SS glint {command} ")[1].split(".SS")[0].split(".SH")[0]
            host.equal(f"it has the options of {command}", re.findall(r"^\.B (--?[a-z-]+)", text, re.M), options(host, command))
    host.check("and what else there is", all(f".SH {name}" in page for name in ["NAME", "SYNOPSIS", "COMMANDS", '"EXIT STATUS"', "MODELS"]))


# A second that passes whenever the test wants: a library in place of the timer, which notes what it is set to and, where
# RINGS is set, rings at each piece of memory that the program takes.
TIMER = """
#define _GNU_SOURCE
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

extern void *__libc_calloc(size_t count, size_t size);
static int is_set;

int setitimer(__itimer_which_t which, const struct itimerval *timer, struct itimerval *before) {
    char text[64];
    is_set = timer->it_value.tv_sec + timer->it_value.tv_usec > 0;
    snprintf(text, sizeof text, "%ld.%06ld\\n", (long)timer->it_value.tv_sec, (long)timer->it_value.tv_usec);
    return syscall(SYS_write, atoi(getenv("TIMERS")), text, strlen(text)) < 0;
}

void *calloc(size_t count, size_t size) {
    if (is_set && getenv("RINGS") != NULL)
        raise(SIGALRM);
    return __libc_calloc(count, size);
}
"""


class Terminal(Preloaded):
    """Runs the program with a terminal as stderr, and with that library."""

    def __init__(self, host):
        super().__init__(host, TIMER)
        self.host = host

    def __enter__(self):
        return self

    def run(self, *arguments, rings=True, is_terminal=True):
        """@return exit status, what was written to stderr, and what timers were set to"""
        screen, stderr = pty.openpty() if is_terminal else os.pipe()
        timers, noted = os.pipe()
        environment = {**os.environ, "LD_PRELOAD": self.library, "TIMERS": str(noted), **({"RINGS": "1"} if rings else {})}
        with subprocess.Popen([self.host.program, *arguments], cwd=self.host.folder.name, stdout=subprocess.DEVNULL,
                              stderr=stderr, pass_fds=[noted], env=environment) as process:
            os.close(stderr)
            os.close(noted)
            written = b""
            try:
                while part := os.read(screen, 4096):
                    written += part
            except OSError:  # so a terminal ends
                pass
            set_to = os.read(timers, 65536).decode().split()
        os.close(screen)
        os.close(timers)
        return process.returncode, written.decode(), set_to


def lines_shown(written):
    """The lines that stood on a terminal one after the other, and what stands there in the end."""
    shown, line, at = [""], "", 0
    for piece in re.findall(r"\r|\n|[^\r\n]+", written):
        if piece == "\n":
            line = ""
        elif piece != "\r":
            line = (line[:at] + piece + line[at + len(piece):]).rstrip(" ")
        at = at + len(piece) if piece not in "\r\n" else 0
        if line != shown[-1] and at:
            shown.append(line)
    return [text for text in shown if text], line


def test_progress(host):
    host.write("of this name.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    frames = ["glint: drawing", *(f"glint: drawing frame {i} of 3" for i in (1, 2, 3))]
    small = ["--size", "32x24"]
    reading = "glint: reading of this name.obj"
    with Terminal(host) as terminal:
        for arguments, lines in ((["render", "of this name.obj", *small, "--heat", "heat.png", "-o", "out.png"],
                                  [reading, "glint: drawing", "glint: drawing in double precision"]),
                                 (["scene", "teapot", *small, "-o", "out.png"], ["glint: drawing"]),
                                 (["scene", "teapot", *small, "--animate", "3", "-o", "out.png"], frames),
                                 (["render", "of this name.obj", *small, "--animate", "3", "-o", "out%d.png"], [reading, *frames]),
                                 (["convert", "of this name.obj", "-o", "out.h"], [reading])):
            title = " ".join(arguments)
            pieces = len([line for line in lines if "frame" not in line]) or 1
            status, written, timers = terminal.run(*arguments)
            shown, last = lines_shown(written)
            host.equal(f"{title}: after a second", (status, shown, last), (0, lines, ""))
            host.equal(f"{title}: a second it is", timers[:2], ["1.000000", "0.000000"])
            host.check(f"{title}: once for each piece of work", timers == ["1.000000", "0.000000"] * (len(timers) // 2) and
                       len(timers) // 2 >= pieces, str(timers))
            host.equal(f"{title}: within a second", terminal.run(*arguments, rings=False)[:2], (0, ""))
            host.equal(f"{title}: no terminal", terminal.run(*arguments, is_terminal=False), (0, "", []))
        host.write("flat.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\n")
        status, written, _ = terminal.run("render", "flat.obj", "-o", "out.png")
        host.equal("what is wrong stands alone", (status, lines_shown(written)[0]),
                   (2, ["glint: reading flat.obj", "flat.obj:0: all 1 triangles are without area"]))
    for name in ("flat.obj", "of this name.obj", "heat.png", "out.png", "out0.png", "out1.png", "out2.png", "out.h"):
        os.remove(host.path(name))
