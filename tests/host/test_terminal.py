# SPDX-License-Identifier: MIT
"""What shows in a terminal: the preview, help for a command, words that were meant, completion, the manual page."""
import os
import re
import subprocess

from harness import ROOT

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
    for command, option in (("render", "--compare"), ("scene", "--compare"), ("scene", "-o")):
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
