# SPDX-License-Identifier: MIT
"""The file that is written: whole or not at all, and nothing beside it, whoever else writes and whatever ends the program."""
import os
import resource
import shutil
import signal
import subprocess
import threading

from harness import MODELS, SQUARE, Preloaded

SMALL = ["--size", "64x48"]

# Between the halves of the file that the program writes it is sent a signal.
INTERRUPTED = """
#define _GNU_SOURCE
#include <signal.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <unistd.h>

ssize_t write(int file, const void *bytes, size_t count) {
    static int begun;
    if (file <= 2 || begun++ != 0)
        return syscall(SYS_write, file, bytes, count);
    ssize_t written = syscall(SYS_write, file, bytes, count / 2);
    raise(atoi(getenv("INTERRUPTED_BY")));
    return written;
}
"""


class Interrupted(Preloaded):
    """Programs in the middle of writing, without waiting for the moment: a library in their place of write()."""

    def __init__(self, host):
        super().__init__(host, INTERRUPTED)

    def __enter__(self):
        return self

    def by(self, number):
        return {"LD_PRELOAD": self.library, "INTERRUPTED_BY": str(int(number))}


# What a signal may end the program with.
ENDING = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGPIPE, signal.SIGXCPU)


def as_in_a_terminal():
    """Signals do what they do by default, whatever the suite was started with; and no core is written."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for number in ENDING:
        signal.signal(number, signal.SIG_DFL)


def test_other_files_stay(host):
    """No file is taken for the program's own, and no link there is followed."""
    wanted = host.render_bytes("torus:8x8", *SMALL)
    host.write("other", "kept")
    for number in range(2):
        host.write(f"part-{number}", "kept")

    def plant():
        """In the program's process: its number is in the names that it chooses."""
        os.symlink("other", f"glint-{os.getpid()}-0.part")
        os.rename("part-0", f"glint-{os.getpid()}-1.part")

    os.rename(host.path("part-1"), host.path("out.png.part"))
    files = len(host.files())
    run = host.run("render", "torus:8x8", *SMALL, "-o", "out.png", before=plant)
    host.equal("names that are taken: status", (run.returncode, run.stderr), (0, ""))
    host.equal("names that are taken: picture", host.read("out.png"), wanted)
    os.remove(host.path("out.png"))
    host.equal("what is there stays", len(host.files()), files + 1)
    for name in host.files():
        if name == "other" or name.endswith(".part"):
            host.equal(f"{name} stays", host.read(name), b"kept")
            os.remove(host.path(name))

    def take_all():
        for i in range(1000):
            os.symlink("nothing", f"glint-{os.getpid()}-{i}.part")

    run = host.run("render", "torus:8x8", *SMALL, "-o", "out.png", before=take_all)
    host.equal("all names are taken", (run.returncode, run.stderr),
               (2, "out.png:0: cannot be written: File exists\n"))
    left = [name for name in host.files() if name.endswith(".part")]
    host.check("links to nothing stay", len(left) == 1000 and all(os.path.islink(host.path(name)) for name in left))
    for name in left:
        os.remove(host.path(name))

    host.write("other", "kept")
    os.symlink("other", host.path("out.png.part"))
    host.equal("beside a link", host.run("render", "torus:8x8", *SMALL, "-o", "out.png").returncode, 0)
    host.equal("a link named so", (os.readlink(host.path("out.png.part")), host.read("other")), ("other", b"kept"))


def test_signals(host):
    """In the middle of writing: the file becomes whole, nothing is left beside it, the status is the signal's."""
    files = host.files()
    wanted = host.render_bytes("torus:8x8", *SMALL, to="other.png")
    with Interrupted(host) as interrupted:
        for number in ENDING:
            run = host.run("render", "torus:8x8", *SMALL, "-o", "out.png", env=interrupted.by(number), before=as_in_a_terminal)
            host.equal(f"{number.name}: status", run.returncode, -number)
            host.equal(f"{number.name}: files", host.files(), sorted([*files, "out.png"]))
            host.check(f"{number.name}: picture", host.read("out.png") == wanted)
            os.remove(host.path("out.png"))
        run = host.run("render", "torus:8x8", *SMALL, "-o", "out.png", env=interrupted.by(signal.SIGHUP),
                       before=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        host.equal("an ignored signal is ignored", run.returncode, 0)
        host.equal("its picture", host.read("out.png"), wanted)
        os.remove(host.path("out.png"))

    def small_files_only():
        as_in_a_terminal()
        resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))

    host.write("out.png", "older")
    run = host.run("render", "torus:24x12", "-o", "out.png", before=small_files_only)
    host.equal("a file beyond the limit", (run.returncode, host.files(), host.read("out.png")),
               (-signal.SIGXFSZ, sorted([*files, "out.png"]), b"older"))


# Moves of files that fail, by their number.
MOVING = """
#define _GNU_SOURCE
#include <errno.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <unistd.h>

int rename(const char *from, const char *to) {
    static int begun;
    if (begun++ == atoi(getenv("MOVE_FAILS"))) {
        errno = EIO;
        return -1;
    }
    return (int)syscall(SYS_renameat2, -100, from, -100, to, 0);
}
"""


def test_moves_of_pairs(host):
    """Neither file is replaced before both are written; nothing is left beside them."""
    files = host.files()
    with Preloaded(host, MOVING) as library:
        for number, name in enumerate(("out.c", "out.h")):
            for file in ("out.c", "out.h"):
                host.write(file, "older")
            run = host.run("convert", "torus:8x8", "-o", "out.c", env={"LD_PRELOAD": library, "MOVE_FAILS": str(number)})
            host.equal(f"move {number}", (run.returncode, run.stdout, run.stderr), (2, "", f"{name}:0: cannot be written: Input/output error\n"))
            host.equal(f"move {number}: files", host.files(), sorted([*files, "out.c", "out.h"]))
            host.equal(f"move {number}: what could not be moved stays", host.read("out.h"), b"older")
            host.equal(f"move {number}: the source", host.read("out.c") == b"older", number == 0)


def test_places_of_pairs(host):
    os.mkdir(host.path("sub"))
    host.write("sub/b.c", "older")
    os.symlink("sub/b.c", host.path("out.c"))
    host.equal("a link", host.run("convert", "box", "-o", "out.c").returncode, 0)
    host.equal("leads where it did", (os.readlink(host.path("out.c")), b'#include "out.h"' in host.read("sub/b.c")), ("sub/b.c", True))
    os.remove(host.path("sub/b.c"))
    os.remove(host.path("out.h"))
    host.refuses("a link to nothing", ["convert", "box", "-o", "out.c"], r"out\.c:0: cannot be written: it is a link to nothing")
    os.remove(host.path("out.c"))
    os.rmdir(host.path("sub"))
    for name in ("out.c", "out.h"):
        os.mkdir(host.path(name))
        host.refuses(f"a folder {name}", ["convert", "box", "-o", "out.c"], rf"{name}:0: cannot be written: it is no regular file")
        os.rmdir(host.path(name))
        os.symlink("/dev/null", host.path(name))
        host.refuses(f"a device {name}", ["convert", "box", "-o", "out.c"], rf"{name}:0: cannot be written: it is no regular file")
        os.remove(host.path(name))
    host.write("out.c", "older")
    os.symlink("out.c", host.path("out.h"))
    host.refuses("one file", ["convert", "box", "-o", "out.c"], r"out\.h:0: cannot be written: it is the other file of the pair")
    host.equal("stays", host.read("out.c"), b"older")
    for name in ("out.c", "out.h"):
        os.remove(host.path(name))
    host.refuses("no folder", ["convert", "box", "-o", "nowhere/out.c"], r"nowhere/out\.c:0: cannot be written: No such file or directory")


def test_writers_of_one_file(host):
    pictures = [host.render_bytes(f"torus:{4 + i}x8", *SMALL) for i in range(6)]
    files = sorted([*host.files(), "out.png"])
    with Interrupted(host) as interrupted:
        host.write("out.png", "older")
        with subprocess.Popen([host.program, "render", "torus:4x8", *SMALL, "-o", "out.png"], cwd=host.folder,
                              env={**os.environ, **interrupted.by(signal.SIGSTOP)}) as slow:
            os.waitpid(slow.pid, os.WUNTRACED)
            host.equal("in the middle of writing", host.read("out.png"), b"older")
            host.equal("a second writer", host.run("render", "torus:5x8", *SMALL, "-o", "out.png").returncode, 0)
            host.equal("its picture", host.read("out.png"), pictures[1])
            slow.send_signal(signal.SIGCONT)
            host.equal("the first writer goes on", slow.wait(timeout=60), 0)
        host.equal("its picture", host.read("out.png"), pictures[0])
        host.equal("nothing beside it", host.files(), files)
    for _ in range(10):
        writers = [subprocess.Popen([host.program, "render", f"torus:{4 + i}x8", *SMALL, "-o", "out.png"],
                                    cwd=host.folder) for i in range(6)]
        host.equal("writers at once", [writer.wait(timeout=60) for writer in writers], [0] * 6)
        host.check("the picture of one of them", host.read("out.png") in pictures)
    host.equal("nothing beside it", host.files(), files)


def mode_of(host, name):
    return os.stat(host.path(name)).st_mode & 0o777


def test_permissions(host):
    for mask, mode in ((0o022, 0o644), (0o077, 0o600), (0o002, 0o664)):
        host.run("render", "torus:8x8", *SMALL, "-o", "out.png", before=lambda mask=mask: os.umask(mask))
        host.equal(f"umask {mask:03o}", mode_of(host, "out.png"), mode)
        os.remove(host.path("out.png"))
    for mode in (0o600, 0o666, 0o640):
        host.write("out.png", "older")
        os.chmod(host.path("out.png"), mode)
        host.run("render", "torus:8x8", *SMALL, "-o", "out.png")
        host.equal(f"the older file's {mode:03o}", (mode_of(host, "out.png"), host.read("out.png")[1:4]), (mode, b"PNG"))
        os.remove(host.path("out.png"))


def test_links(host):
    """A link stays and its file is replaced, as whole as any; links to nothing are refused."""
    wanted = host.render_bytes("torus:8x8", *SMALL)
    os.mkdir(host.path("folder"))
    host.write("folder/real.png", "older")
    os.link(host.path("folder/real.png"), host.path("same.png"))
    os.symlink("folder/real.png", host.path("near.png"))
    os.symlink(host.path("near.png"), host.path("far.png"))
    host.equal("through two links", host.run("render", "torus:8x8", *SMALL, "-o", "far.png").returncode, 0)
    host.equal("the links stay", (os.readlink(host.path("far.png")), os.readlink(host.path("near.png"))),
               (host.path("near.png"), "folder/real.png"))
    host.equal("their file is replaced", host.read("folder/real.png"), wanted)
    host.equal("another name of the older file keeps it", host.read("same.png"), b"older")
    host.equal("nothing beside it", os.listdir(host.path("folder")), ["real.png"])
    os.symlink("folder/none.png", host.path("nothing.png"))
    os.symlink("round.png", host.path("round.png"))
    for name in ("nothing.png", "round.png"):
        host.refuses(f"{name} as output", ["render", "torus:8x8", *SMALL, "-o", name],
                     rf"{name}:0: cannot be written: it is a link to nothing")
    host.refuses("a folder as output", ["render", "torus:8x8", *SMALL, "-o", "folder"],
                 r"folder:0: cannot be written: Is a directory")


def test_what_is_no_regular_file(host):
    """Devices, pipes and the standard output take what is written."""
    wanted = host.render_bytes("torus:8x8", *SMALL)
    arguments = [host.program, "render", "torus:8x8", *SMALL, "-o"]
    run = subprocess.run([*arguments, "/dev/stdout"], capture_output=True, check=False)
    host.equal("/dev/stdout, a pipe", (run.returncode, run.stdout), (0, wanted))
    with open(host.path("to.png"), "w+b") as file:
        host.equal("/dev/stdout, a file", subprocess.run([*arguments, "/dev/stdout"], stdout=file, check=False).returncode, 0)
        file.seek(0)
        host.equal("what the file holds", file.read(), wanted)
    os.remove(host.path("to.png"))
    os.mkfifo(host.path("pipe"))
    got = []

    def read():
        with open(host.path("pipe"), "rb") as file:
            got.append(file.read())

    reader = threading.Thread(target=read)
    reader.start()
    host.equal("a named pipe", subprocess.run([*arguments, host.path("pipe")], check=False, timeout=60).returncode, 0)
    reader.join(60)
    host.equal("what it passed", got, [wanted])


def test_output_is_not_the_model(host):
    host.write("model.obj", SQUARE)
    os.link(host.path("model.obj"), host.path("hard.obj"))
    os.symlink("model.obj", host.path("soft.obj"))
    names = ["model.obj", "./model.obj", host.path("model.obj"), "hard.obj", "soft.obj"]
    for command in ("render", "convert"):
        for model in ("model.obj", "soft.obj"):
            for name in names:
                host.refuses(f"{command} {model} -o {name}", [command, model, "-o", name],
                             rf".*\.obj:0: cannot be written: it is the model")
                host.equal("the model stays", (host.read("model.obj"), os.path.islink(host.path("soft.obj"))),
                           (SQUARE.encode(), True))
    for name in ("model.obj", "hard.obj", "soft.obj"):
        os.remove(host.path(name))
    shutil.copytree(MODELS, host.path("models"))
    before = host.read("models/spot.obj")
    host.refuses("demo -o one of its models", ["demo", "--models", "models", "-o", "models/spot.obj"],
                 r"models/spot\.obj:0: cannot be written: it is the model")
    host.equal("the model stays", host.read("models/spot.obj"), before)
    shutil.rmtree(host.path("models"))
    for _ in range(2):
        host.equal("a file named as a shape is not the shape",
                   host.run("render", "torus:8x8", *SMALL, "-o", "torus:8x8").returncode, 0)


# A disk that is full after so many files and half of the next one, and a file that may not be written, whoever asks.
REFUSING = """
#define _GNU_SOURCE
#include <errno.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <unistd.h>

ssize_t write(int file, const void *bytes, size_t count) {
    static int begun;
    const int left = file <= 2 || getenv("FULL_AFTER") == NULL ? 1 : atoi(getenv("FULL_AFTER")) - begun++;
    if (left >= 0)
        return syscall(SYS_write, file, bytes, left > 0 ? count : count / 2);
    errno = ENOSPC;
    return -1;
}

int access(const char *path, int mode) {
    errno = EACCES;
    return (mode & W_OK) != 0 && getenv("IS_READ_ONLY") != NULL ? -1 : syscall(SYS_faccessat, -100, path, mode);
}
"""


def test_full_disks_and_files_that_may_not_be_written(host):
    with Preloaded(host, REFUSING) as library:
        refuse_to_write(host, library)


def refuse_to_write(host, library):
    for command, name in (("render", "out.png"), ("convert", "out.h"), ("convert", "out.c")):
        for older in (None, "older"):
            if older:
                host.write(name, older)
            arguments = [command, "torus:24x12", "-o", name]
            host.refuses(f"{command} to a full disk", arguments, rf"out\.\w+:0: cannot be written: No space left on device",
                         env={"LD_PRELOAD": library, "FULL_AFTER": "0"})
            if older:
                host.refuses(f"{command} to a file that may not be written", arguments,
                             r"out\.\w+:0: cannot be written: Permission denied", env={"LD_PRELOAD": library, "IS_READ_ONLY": "1"})
                host.equal(f"{command}: the older file stays", host.read(name), b"older")
                os.remove(host.path(name))
        host.refuses(f"{command} where no file can be", [command, "torus:24x12", "-o", "/proc/out"],
                     r"/proc/out:0: cannot be written: .+")


def test_standard_output_to_a_full_disk(host):
    with open("/dev/full", "w", encoding="ascii") as full:
        run = subprocess.run([host.program, "info", "torus:8x8"], cwd=host.folder, stdout=full, stderr=subprocess.PIPE,
                             text=True, timeout=60, check=False)
    host.equal("standard output to a full disk", (run.returncode, run.stderr),
               (2, "glint: standard output cannot be written\n"))


def test_too_little_memory(host):
    """Of address spaces from too small for the program to large enough for the model, some run out: that is told."""
    host.write("large.obj", "".join(f"v {i} {i * i % 977} 0\n" for i in range(200000)) + "f 1 2 3\n")
    wanted = host.run("info", "large.obj").stdout
    told = 0
    for size in range(4, 100, 4):
        run = host.run("info", "large.obj", before=lambda size=size: resource.setrlimit(resource.RLIMIT_AS, (size << 20,) * 2))
        if run.returncode == 2 and run.stderr == "glint: out of memory\n":
            told += run.stdout == ""
        elif run.returncode == 0:
            host.equal(f"memory for a model: {size} MB", (run.stdout, run.stderr), (wanted, ""))
    host.check("too little memory is told", told > 0)
    host.equal("memory enough for a model", run.returncode, 0)
