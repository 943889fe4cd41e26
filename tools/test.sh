#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs test suites, which are make targets, one after another: test.sh LOGS SUITE...
# Each closes with one line or several `N passed, N failed`; so does this, with their sums. A suite that fails without
# a failed test, or closes without such a line, counts as one failure; none stops the others.
set -u
logs=$1
shift
mkdir -p "$logs"
jobs=$(nproc 2>/dev/null || echo 2)
closing='^[0-9]+ passed, [0-9]+ failed$'
passed=0 failed=0
summary=()

for suite in "$@"; do
    log=$logs/$suite.log
    printf '\n==== %s\n' "$suite"
    "${MAKE:-make}" --no-print-directory -j"$jobs" --output-sync=target "$suite" 2>&1 | tee "$log"
    status=${PIPESTATUS[0]}
    read -r lines good bad < <(grep -E "$closing" "$log" | awk '{ good += $1; bad += $3 } END { print NR, good + 0, bad + 0 }')
    note=
    if [ "$lines" -eq 0 ]; then
        bad=1 note=" (printed no closing line; exit status $status)"
    elif [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then
        bad=1 note=" (no test failed, but the suite did, with exit status $status)"
    elif [ "$status" -eq 0 ] && [ "$bad" -ne 0 ]; then
        note=" (and yet the suite's exit status is 0)"
    elif [ "$good" -eq 0 ] && [ "$bad" -eq 0 ]; then
        bad=1 note=" (ran no test)"
    fi
    passed=$((passed + good)) failed=$((failed + bad))
    summary+=("$(printf '%-22s %5d passed, %d failed%s' "$suite" "$good" "$bad" "$note")")
done

printf '\n==== suites\n'
printf '%s\n' "${summary[@]}"
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
