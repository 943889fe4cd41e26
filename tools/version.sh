#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Holds every version number against the one in src/glint.h: the newest entry of CHANGELOG.md, and package manifests.
# `version.sh print` prints that one.
set -u
status=0
number() { sed -nE "s/^#define GLINT_VERSION_$1 ([0-9]+)\$/\1/p" src/glint.h; }
version=$(number MAJOR).$(number MINOR).$(number PATCH)
[ "${1:-}" != print ] || { echo "$version"; exit; }

compare() { # compare FILE FOUND
    [ "$2" = "$version" ] && return
    echo "$1 says version '$2', src/glint.h says '$version'"
    status=1
}

compare CHANGELOG.md "$(sed -nE 's/^## ([0-9]+\.[0-9]+\.[0-9]+).*/\1/p' CHANGELOG.md | head -n 1)"
manifest() { # manifest FILE EXPRESSION: when the file is there
    [ ! -e "$1" ] || compare "$1" "$(sed -nE "$2" "$1" | head -n 1)"
}
manifest CMakeLists.txt 's/.*project\(.* VERSION ([0-9.]+).*/\1/p'
manifest meson.build "s/.*[^_]version: '([^']*)'.*/\1/p"
manifest library.properties 's/^version=(.*)$/\1/p'
manifest library.json 's/.*"version": *"([^"]*)".*/\1/p'
manifest idf_component.yml 's/^version: *"?([^"]*)"?$/\1/p'
exit $status
