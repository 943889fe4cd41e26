# SPDX-License-Identifier: MIT
"""What shows in a terminal: help for a command, words that were meant, completion, the manual page."""
import os
import re
import subprocess

from harness import ROOT


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
    host.check("exit statuses are told", "exit status is 0 when all was done, else 2: bad input" in said)


def complete(host, *words):
    """What bash offers for the last word."""
    script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _glint; printf "%s\\n" "${COMPREPLY[@]}"')
    run = subprocess.run(["bash", "-c", script, "bash", os.path.join(ROOT, "port/host/completion.bash"), host.program, *words],
                         capture_output=True, text=True, cwd=host.folder, check=False)
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
    for command in ("render", "scene"):
        host.equal(f"files for {command} -o", complete(host, command, "-o", "a-"), ["a-model.obj"])
    host.check("shapes", "torus:" in complete(host, "info", "tor"))


def test_manual(host):
    run = subprocess.run(["sh", os.path.join(ROOT, "port/host/man.sh"), host.program], capture_output=True, text=True, check=False)
    page = run.stdout.replace("\\-", "-")
    host.check("the manual page", run.returncode == 0 and page.startswith(".TH GLINT 1"), run.stderr)
    for command in commands(host):
        if command != "help":
            text = page.split(f".SS glint {command} ")[1].split(".SS")[0].split(".SH")[0]
            host.equal(f"it has the options of {command}", re.findall(r"^\.B (--?[a-z-]+)", text, re.M), options(host, command))
    host.check("and what else there is", all(f".SH {name}" in page for name in ["NAME", "SYNOPSIS", "COMMANDS", '"EXIT STATUS"', "MODELS"]))
