#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Static checks of the whole tree: lint.sh LOGS. Each prints what it found; none stops the others.
set -u
: "${TEST_SEED:=1}" "${EVERY:=}"
logs=$1
bench=$logs/../bench # the generated scenes of the benchmark
[ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ] || { echo "lint: takes a clone: it checks what git lists"; exit 1; }
mkdir -p "$logs"
jobs=$(nproc 2>/dev/null || echo 2)
failed=0

files() { # files PATTERN...: what belongs to the project, new files included
    git ls-files --cached --others --exclude-standard -- "$@" | sort -u | while read -r file; do
        [ -e "$file" ] && printf '%s\n' "$file"
    done
}

check() { # check NAME COMMAND...
    local name=$1
    shift
    if "$@" >"$logs/$name.log" 2>&1; then
        echo "lint: $name: good"
    else
        echo "lint: $name: FAILED"
        cat "$logs/$name.log"
        failed=1
    fi
}

# Meshes are written by the converter, and judged by what they draw.
format() {
    files '*.c' '*.h' '*.cpp' | grep -v '^examples/meshes/' | xargs clang-format --dry-run -Werror
}

# Each part is read with the headers and for the core that it is compiled for. Programs in tests/stack are wrong on purpose;
# clang 14 has no Xtensa.
tidy() {
    local status=0
    tidy_files "-Isrc" 'src/*.c' || status=1
    tidy_files "-Isrc -Iport/host -Iexamples $(sdl2-config --cflags) -DHOST_WITH_MESHOPTIMIZER -DHOST_WITH_JPEG" 'port/host/*.c' || status=1
    tidy_files "-Isrc -Iport -Iport/libc -Iexamples -Itests -DBOARD_ARENA=65536 -DBOARD_TILE_WIDTH=0 -DBOARD_TILE_HEIGHT=0 $(arm)" \
        'port/*.c' 'examples/firmware/*.c' 'tests/board/*_board.c' \
        'tests/board/pattern.c' 'tests/board/unit.c' 'tests/board/faults.c' ':!port/host' ':!port/virt' ':!port/riscv' ':!port/sifive_e' ':!port/web' \
        ':!port/xtensa' || status=1
    tidy_files "-Isrc -Iport -Iport/libc --target=riscv32-unknown-elf -march=rv32imc -ffreestanding" \
        'port/virt/*.c' 'port/riscv/*.c' 'port/sifive_e/*.c' || status=1
    tidy_files "-Isrc -Iport/host -Iexamples -Itests/reference -Itests/image -Iport/web -Iport/web/libc -nostdlibinc -isystem port/web/libc --target=wasm32 -mbulk-memory" \
        'port/web/*.c' || status=1
    tidy_files "-Isrc -Iport -Iport/libc -Itests -Itools -I$bench $(arm)" 'tools/boards/*.c' 'tools/bench/*.c' ':!tools/bench/scenes.c' ':!tools/bench/float' 'tools/features/*.c' \
        'tools/chart/*_board.c' || status=1
    tidy_files "-Isrc -Iport/host -Iexamples -Iexamples/bench" 'tools/bench/scenes.c' || status=1
    tidy_files "" 'tools/cycles/*.c' || status=1
    tidy_files "-Isrc -Iport/host -Iport/host/window -Iexamples -Itests/reference -Itests/image -Itools/bench -I$bench" 'tools/cost/*.c' 'tools/pages/*.c' 'examples/compose/*.c' 'examples/lines/*.c' || status=1
    tidy_files "-Isrc -Iport -Iexamples -Itests $(adapters) -D_GNU_SOURCE" 'examples/adapters/*.c' 'tests/adapters/*.c' || status=1
    standard=c++11 tidy_files "-Isrc -Iexamples -Itests $(adapters)" 'examples/adapters/*.cpp' 'tests/adapters/*.cpp' || status=1
    tidy_files "-Isrc -Iport -Iport/host -Iexamples" 'tests/packages/*.c' ':!tests/packages/*/*' || status=1
    for system in pico-sdk esp-idf zephyr; do
        tidy_files "-Isrc -Iport -Iexamples -isystem tests/packages/$system/include -isystem tests/adapters/declarations" \
            "examples/$system/*.c" "tests/packages/$system/*.c" || status=1
    done
    tidy_files "-Isrc -Iport -Iport/libc $(arm_fpu)" 'tests/cycles/*.c' || status=1
    tidy_files "-Isrc -Iport -Iport/libc -Itools/bench -Itools/bench/float -I$bench $(arm_fpu)" 'tools/bench/float/*.c' || status=1
    tidy_files "-Isrc -Iport -Iport/host -Iport/web -Iexamples -Iexamples/bench -Itests -Itests/reference -Itests/image -Itests/unit -Itools/bench -Itools/bench/float" \
        'tests/*.c' 'examples/turntable/*.c' 'examples/bench/*.c' 'examples/scenes/*.c' 'tools/chart/*.c' ':!tests/proof' ':!tests/cycles' ':!tests/adapters' ':!tests/packages' \
        ':!tests/stack' ':!tests/board/faults.c' ':!tools/chart/*_board.c' ':!tests/*/*_board.c' ':!tests/board/pattern.c' ':!tests/board/unit.c' || status=1
    return $status
}

arm() {
    echo "--target=arm-none-eabi -mcpu=cortex-m0 -mthumb -ffreestanding"
}

arm_fpu() {
    echo "--target=arm-none-eabi -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffreestanding"
}

adapters() {
    echo "-isystem tests/adapters/declarations -isystem /usr/include/libdrm"
}

# Clang's static analyzer takes nearly all of clang-tidy's time. It reads src/ and port/, and a quarter of other files, which
# the seed picks; with EVERY set all.
is_analyzed() { # is_analyzed FILE
    [[ -n "$EVERY" || $1 == src/* || $1 == port/* ]] || [ $((($(cksum <<<"$1" | cut -d ' ' -f 1) + TEST_SEED) % 4)) -eq 0 ]
}

tidy_files() { # tidy_files FLAGS PATTERN..., in C99 or the standard that is set
    local flags=$1 file
    shift
    files "$@" | while read -r file; do
        printf '%s\n%s\n' "--checks=$(is_analyzed "$file" || echo '-clang-analyzer-*')" "$file"
    done | xargs -r -P "$jobs" -n 2 sh -c 'clang-tidy --quiet "$@" -- '"-std=${standard:-c99} $flags" tidy
}

# Drivers in tests/proof leave values open on purpose; Frama-C reads them.
# src/math/numeric.h owns the shifts of negative numbers, and does not compile where they are not arithmetic.
cppcheck_all() {
    files 'src/*.c' 'port/*.c' 'tests/*.c' 'examples/*.c' 'tools/*.c' ':!tests/proof' | xargs cppcheck --quiet --std=c99 -j "$jobs" --error-exitcode=1 \
        --enable=warning,performance,portability --inline-suppr --suppress=missingIncludeSystem \
        --suppress=shiftTooManyBitsSigned:src/math/numeric.h \
        -Isrc -Iport -Iport/host -Iexamples -Iexamples/bench -Itests -Itests/reference -Itests/image -Itests/unit
}

# What follows no range of a count, and no number of turns of a loop, takes shifts for too far and elements for unset;
# Frama-C, which does, proves that neither happens (tests/proof). To the host's files problem_set, which answers
# false, is any function.
analyzer() {
    files 'src/*.c' 'port/panel/*.c' 'port/host/*.c' ':!port/host/import' ':!port/host/window' | xargs -n 1 -P "$jobs" \
        gcc -std=c99 -O2 -fanalyzer -Werror -Wno-analyzer-shift-count-overflow -Wno-analyzer-use-of-uninitialized-value \
        -Wno-analyzer-null-dereference -D_POSIX_C_SOURCE=200809L -Isrc -Iport -Iport/host -Iexamples -Iexamples/bench -Itests \
        -Itests/reference -Itests/image -c -o /dev/null
}

licence() {
    local status=0
    while read -r file; do
        head -n 3 "$file" | grep -q 'SPDX-License-Identifier: MIT' && continue
        echo "$file: no SPDX-License-Identifier line at its top"
        status=1
    done < <(files '*.c' '*.h' '*.cpp' '*.ld' '*.mk' '*.sh' '*.py' Makefile '*/Makefile' .ci/run .clang-tidy)
    return $status
}

# Whose each file is and under which licence, by the REUSE specification. The tool skips a file whose expression it cannot
# parse, and says so in its output alone.
reuse_all() {
    local found
    found=$(reuse lint 2>&1) && ! grep ERROR <<<"$found" && cmp LICENSE LICENSES/MIT.txt && return
    echo "$found"
    return 1
}

# The README shows all of a program, but for its licence line; glint.h the same without comments.
readme() {
    local program=examples/firmware/own_flush.c
    diff <(tail -n +2 "$program") <(awk '/^```c$/ { on = 1; next } /^```$/ { on = 0 } on' README.md) &&
        diff <(tail -n +2 "$program" | sed -E '/^\/\*.*\*\/$/d; s# +/\*.*\*/##') \
            <(awk '/@code$/ { on = 1; next } /@endcode$/ { exit } on' src/glint.h | sed -E 's/^ \* ?//')
}

# Only tests of arithmetic, proofs and what tells the judge where vertices were snapped look into the library.
interface() {
    local inner
    inner=$(printf '%s|' src/*/ | sed 's#src/##g; s#|$##')
    ! files 'tests/*.[chS]' 'tests/*.cpp' ':!tests/unit' ':!tests/proof' ':!tests/image/library_geometry.c' | xargs grep -nE "include \"(.*/)?($inner)"
}

check format format
check interface interface
check bounds python3 tools/bounds/bounds.py
check readme readme
check licence licence
check reuse reuse_all
check version tools/version.sh
check doxygen "${MAKE:-make}" --no-print-directory doxygen
check cppcheck cppcheck_all
check analyzer analyzer
check clang-tidy tidy
exit $failed
