# SPDX-License-Identifier: MIT
"""What `make dist` writes: dist.py FOLDER. Closes with `N passed, N failed`; status 1 on a failure."""
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tarfile

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
# What another make, or a git that called it, would hand down.
HANDED_DOWN = re.compile(r"MAKE.*|MFLAGS|GIT_.*|GZIP")
PLAIN = {name: value for name, value in os.environ.items() if not HANDED_DOWN.fullmatch(name)}

# A machine of another time zone, language and habits.
ELSEWHERE = {"TZ": "Asia/Kathmandu", "LC_ALL": "C.UTF-8", "GZIP": "-1", "GIT_CONFIG_COUNT": "2",
             "GIT_CONFIG_KEY_0": "tar.umask", "GIT_CONFIG_VALUE_0": "0077",
             "GIT_CONFIG_KEY_1": "core.autocrlf", "GIT_CONFIG_VALUE_1": "true"}

counts = {True: 0, False: 0}


def check(name, holds, detail=""):
    counts[bool(holds)] += 1
    if not holds:
        print(f"FAILED {name}: {detail}")


def run(*command, folder=ROOT, env=None, mask=0o022):
    return subprocess.run(command, cwd=folder, env={**PLAIN, **(env or {})}, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: os.umask(mask))


def git(*arguments, folder=ROOT):
    done = run("git", "-c", "user.name=test", "-c", "user.email=test", *arguments, folder=folder)
    if done.returncode != 0:
        raise AssertionError(f"git {' '.join(arguments)}: {done.stderr}")
    return done.stdout


def read(*parts):
    with open(os.path.join(*parts), "rb") as file:
        return file.read()


def contents(folder):
    return {name: read(folder, name) for name in os.listdir(folder)}


def make_twice(folder):
    """The archive from two clones; the second one's files are of another time and mode. @return the first clone"""
    made = []
    for name, env, mask in (("here", {}, 0o022), ("elsewhere", ELSEWHERE, 0o077)):
        clone = os.path.join(folder, name)
        git("clone", "-q", ROOT, clone)
        if env:
            os.utime(os.path.join(clone, "Makefile"), (1, 1))
        for turn in ("first", "second"):
            done = run("make", "dist", folder=clone, env=env, mask=mask)
            check(f"{name}, {turn} run", done.returncode == 0, done.stdout + done.stderr)
            made.append(contents(os.path.join(clone, "build", "dist")))
    check("an archive and a sum", len(made[0]) == 2 and "SHA256SUMS" in made[0], sorted(made[0]))
    for other in made[1:]:
        check("the same bytes", other == made[0], {name: hashlib.sha256(data).hexdigest() for name, data in other.items()})
    return os.path.join(folder, "here")


def check_archive(dist, version):
    """What is in it: the commit's files and nothing else, of no owner or time but the commit's."""
    name = f"glint-{version}.tar.gz"
    packed = read(dist, name)
    check("its sum", read(dist, "SHA256SUMS").decode() == f"{hashlib.sha256(packed).hexdigest()}  {name}\n")
    check("gzip: no name, no time", packed[:8] == b"\x1f\x8b\x08\0\0\0\0\0", packed[:8])
    listed = {}
    for line in git("ls-tree", "-r", "-z", "HEAD").split("\0")[:-1]:
        about, path = line.split("\t")
        listed[f"glint-{version}/{path}"] = (0o755 if about.startswith("100755") else 0o644, about.split()[2])
    seen, strange = {}, []
    time = int(git("log", "-1", "--format=%ct"))
    with tarfile.open(os.path.join(dist, name)) as archive:
        for entry in archive:
            fixed = (entry.uid, entry.gid, entry.mtime) == (0, 0, time)
            if entry.isfile():
                data = archive.extractfile(entry).read()
                seen[entry.name] = (entry.mode, hashlib.sha1(b"blob %d\0" % len(data) + data).hexdigest())
            if not fixed or not (entry.isfile() or (entry.isdir() and entry.mode == 0o755)):
                strange.append((entry.name, entry.uid, entry.gid, entry.mtime, oct(entry.mode)))
    check("owners, times, folders", not strange, strange[:3])
    check("the commit's files", seen == listed, sorted(set(seen.items()) ^ set(listed.items()))[:3])


def check_unpacked(dist, version, folder):
    """As a user would: unpacked by tar, the demo made of it; unoptimised, which takes the compiler less and draws the same."""
    os.mkdir(folder)
    done = run("tar", "xzf", os.path.join(dist, f"glint-{version}.tar.gz"), folder=folder)
    check("unpacked", done.returncode == 0 and os.listdir(folder) == [f"glint-{version}"], done.stderr)
    tree = os.path.join(folder, f"glint-{version}")
    before = set(os.listdir(tree))
    done = run("make", f"-j{os.cpu_count()}", "CFLAGS=-O0", "demo", folder=tree)
    check("its demo", done.returncode == 0 and "build/demo.png" in done.stdout, done.stdout + done.stderr)
    picture = os.path.join(tree, "build", "demo.png")
    check("the demo's picture", os.path.exists(picture) and read(picture) == read(tree, "docs", "demo.png"), "not docs/demo.png")
    check("nothing else is written", set(os.listdir(tree)) == before | {"build"}, os.listdir(tree))
    for target in ("dist", "lint"):
        command = ["make", "dist"] if target == "dist" else ["tools/lint.sh", "build/lint"]
        done = run(*command, folder=tree)
        check(f"{target} in it, inside another clone", done.returncode != 0 and "takes a clone" in done.stdout + done.stderr, done.stdout + done.stderr)


def check_refused(clone):
    """No archive is made of what no commit holds, or of two versions; and the one before stays."""
    dist = os.path.join(clone, "build", "dist")
    before = contents(dist)

    def refused(name, text):
        done = run("make", "dist", folder=clone)
        check(name, done.returncode != 0 and text in done.stderr and contents(dist) == before, done.stdout + done.stderr)

    with open(os.path.join(clone, "src", "glint.h"), "a", encoding="utf-8") as header:
        header.write("#define GLINT_VERSION_PATCH 99\n")
    refused("a changed file", "files differ from the last commit")
    git("add", "-A", folder=clone)
    refused("a change that waits for its commit", "files differ from the last commit")
    git("checkout", "-q", "HEAD", ".", folder=clone)
    changelog = os.path.join(clone, "CHANGELOG.md")
    text = read(changelog).decode()
    with open(changelog, "w", encoding="utf-8") as file:
        file.write(text.replace("## ", "## 99.0.0\n\n## ", 1))
    git("commit", "-q", "-a", "-m", "another version", folder=clone)
    refused("two versions", "one version number first")


def main():
    folder = os.path.abspath(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    clone = make_twice(folder)
    version = run("tools/version.sh", "print", folder=clone).stdout.strip()
    dist = os.path.join(clone, "build", "dist")
    check_archive(dist, version)
    check_unpacked(dist, version, os.path.join(folder, "unpacked"))
    check_refused(clone)
    shutil.rmtree(folder)
    print(f"{counts[True]} passed, {counts[False]} failed")
    return 1 if counts[False] else 0


if __name__ == "__main__":
    sys.exit(main())
