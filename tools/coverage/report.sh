#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints llvm-cov's report of a folder, and fails where less is reached: report.sh OUTPUT FOLDER LINES BRANCHES CONDITIONS
# PROFILES PROGRAM... The shares are the least % of lines, branches and MC/DC conditions, over all programs and the raw profiles
# in all folders of PROFILES. OUTPUT/index.html shows what is not reached.
# A function that one program leaves out and another one has is said to have mismatched data.
set -eu
output=$1 folder=$2 lines=$3 branches=$4 conditions=$5 profiles=$6
shift 6
mkdir -p "$output"
for profile in $profiles; do printf '%s\n' "$profile"/*.profraw; done > "$output/profiles"
llvm-profdata-19 merge --input-files="$output/profiles" -o "$output/all.profdata"
first=$1
shift
for program; do
    shift
    set -- "$@" "-object=$program"
done
set -- -instr-profile="$output/all.profdata" "$first" "$@" "$folder"
llvm-cov-19 show -format=html -show-branches=count -show-mcdc -output-dir="$output" "$@"
llvm-cov-19 report -show-region-summary=0 -show-branch-summary -show-mcdc-summary "$@" > "$output/report"
cat "$output/report"
awk -v folder="$folder" -v lines="$lines" -v branches="$branches" -v conditions="$conditions" '
function judge(what, reached, least) {
    good = reached + 0 >= least
    printf "%s %s: %s reached, at least %s %%%s\n", folder, what, reached, least, good ? "" : "  FAILED"
    good ? passed++ : failed++
}
$1 == "TOTAL" { judge("lines", $7, lines); judge("branches", $10, branches); judge("MC/DC", $13, conditions) }
END { printf "%d passed, %d failed\n", passed, failed; exit failed || !passed }' "$output/report"
