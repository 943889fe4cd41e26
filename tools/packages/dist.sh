#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes the sources of the last commit as an archive, and its SHA-256: dist.sh FOLDER. The bytes depend on the commit alone:
# names are in git's order, times are the commit's, owners are root, and settings of a user are put aside. gzip has no time
# and no name; GNU's has written the same bytes for decades, where xz and zlib change theirs.
set -eu
export LC_ALL=C
umask 022
unset GZIP # options, to some

stop() {
    echo "dist: $1" >&2
    exit 1
}

[ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ] || stop "takes a clone: an archive is made of a commit"
git diff --quiet HEAD -- || stop "files differ from the last commit: commit or undo that first"
gzip --version | grep -q '^gzip' || stop "takes GNU gzip"
tools/version.sh || stop "one version number first"

mkdir -p "$1"
name=glint-$(tools/version.sh print)
part=$(mktemp -d "$1/part-XXXXXX")
trap 'rm -rf "$part"' EXIT
git -c tar.umask=0022 -c core.autocrlf=false -c core.eol=lf -c core.attributesFile=/dev/null \
    archive --format=tar --prefix="$name/" HEAD >"$part/$name.tar"
gzip -n -9 "$part/$name.tar"
(cd "$part" && sha256sum "$name.tar.gz" >SHA256SUMS)
mv "$part/$name.tar.gz" "$part/SHA256SUMS" "$1"
cat "$1/SHA256SUMS"
