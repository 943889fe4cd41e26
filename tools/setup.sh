#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes sure that everything `make test`, `make lint` and `make fuzz` need is there: installs what is missing with
# apt-get as root or through sudo, or else prints the one command to run and exits with 1. Quick when nothing is missing.
set -u

missing=()
need() { # need PACKAGE COMMAND...: true when all of the commands are there
    local package=$1 command
    shift
    for command in "$@"; do
        command -v "$command" >/dev/null 2>&1 || { missing+=("$package"); return; }
    done
}

look() {
    missing=()
    need gcc gcc
    need g++ g++
    need make make
    need git git
    need python3 python3
    need clang clang
    need llvm llvm-cov llvm-profdata
    need clang-19 clang-19
    need llvm-19 llvm-cov-19 llvm-profdata-19
    need clang-format clang-format
    need clang-tidy clang-tidy
    need cppcheck cppcheck
    need doxygen doxygen
    need reuse reuse
    need gcc-arm-none-eabi arm-none-eabi-gcc
    need qemu-system-arm qemu-system-arm
    need gcc-i686-linux-gnu i686-linux-gnu-gcc
    need gcc-arm-linux-gnueabihf arm-linux-gnueabihf-gcc
    need gcc-s390x-linux-gnu s390x-linux-gnu-gcc
    need gcc-riscv64-linux-gnu riscv64-linux-gnu-gcc
    need qemu-user qemu-i386 qemu-arm qemu-s390x qemu-riscv64
    need gcc-riscv64-unknown-elf riscv64-unknown-elf-gcc
    need gcc-xtensa-lx106 xtensa-lx106-elf-gcc
    need qemu-system-misc qemu-system-riscv32 qemu-system-xtensa
    need gnuplot-nox gnuplot
    need bsdextrautils column
    need nodejs node
    need npm npm
    need cmake cmake
    need meson meson
    need ninja-build ninja
    need pkgconf pkg-config
    need g++ g++
    need arduino-builder arduino-builder
    need arduino-ctags arduino-ctags
    need lld wasm-ld
    need zopfli zopfli
    need chromium chromium
    need frama-c-base frama-c
    need libsdl2-dev sdl2-config
    need xvfb Xvfb
    need xdotool xdotool
    # libraries, which no command shows: Python's YAML, C libraries of the host and of other machines, libdrm's headers, and clang's sanitizers and fuzzer
    [ -e /usr/include/stdio.h ] || missing+=(libc6-dev)
    python3 -c "import yaml" 2>/dev/null || missing+=(python3-yaml)
    [ -e /usr/include/xf86drmMode.h ] || missing+=(libdrm-dev)
    [ -e /usr/i686-linux-gnu/include/stdio.h ] || missing+=(libc6-dev-i386-cross)
    [ -e /usr/arm-linux-gnueabihf/include/stdio.h ] || missing+=(libc6-dev-armhf-cross)
    [ -e /usr/s390x-linux-gnu/include/stdio.h ] || missing+=(libc6-dev-s390x-cross)
    [ -e /usr/riscv64-linux-gnu/include/stdio.h ] || missing+=(libc6-dev-riscv64-cross)
    [ -e /usr/include/assimp/cimport.h ] || missing+=(libassimp-dev)
    [ -e /usr/include/jpeglib.h ] || missing+=(libjpeg-dev)
    [ -e /usr/include/meshoptimizer.h ] || missing+=(libmeshoptimizer-dev)
    /usr/bin/python3 -c 'import Xlib' 2>/dev/null || missing+=(python3-xlib)
    ls /usr/lib/llvm-19/lib/clang/19/lib/linux/libclang_rt.profile-*.a >/dev/null 2>&1 || missing+=(libclang-rt-19-dev)
    if command -v clang >/dev/null 2>&1; then
        ls "$(clang -print-resource-dir)"/lib/linux/libclang_rt.fuzzer-*.a >/dev/null 2>&1 || missing+=(libclang-rt-dev)
    else
        missing+=(libclang-rt-dev)
    fi
}

install() {
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        sudo -n true 2>/dev/null || return 1
        as_root=(sudo -n)
    fi
    command -v apt-get >/dev/null 2>&1 || return 1
    echo "setup: installing ${missing[*]}"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q >/dev/null
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
        -o DPkg::Lock::Timeout=300 "${missing[@]}" >/dev/null
}

look
[ ${#missing[@]} -eq 0 ] && exit 0
wanted=("${missing[@]}")
install
look
[ ${#missing[@]} -eq 0 ] && exit 0
echo "setup: missing: ${missing[*]}. Run:" >&2
echo "    sudo apt-get update && sudo apt-get install -y --no-install-recommends ${wanted[*]}" >&2
exit 1
