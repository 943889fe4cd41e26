#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs test suites, which are make targets, as many at once as there are cores: test.sh LOGS SUITE...
# One make builds and runs them, so that what several take is built once; it builds most before it runs the first. What each
# prints is kept in LOGS/SUITE.log (tools/suite.sh), and shown whole, in the order given.
# Beside each in the summary is the time that it took of processors, less what it was built by.
# Each closes with one line or several `N passed, N failed`; so does this, with their sums. A suite that fails without
# a failed test, or closes without such a line, counts as one failure; none stops the others.
set -u
logs=$1
shift
mkdir -p "$logs"
rm -f "$logs"/*.log "$logs"/*.status "$logs"/*.times
jobs=$(nproc 2>/dev/null || echo 2)
# Seconds that what a shell started took of processors, from what `times` printed: the second line of each pair.
of_processors() {
    awk -F '[ms ]+' 'NR % 2 == 0 { sum += 60 * ($1 + $3) + $2 + $4 } END { printf "%d", sum }' "$@" /dev/null
}
closing='^[0-9]+ passed, [0-9]+ failed$'
passed=0 failed=0
summary=() broken=()

"${MAKE:-make}" --no-print-directory -k -j"$jobs" --output-sync=target SUITE_LOGS="$logs" "${@/#/ended-}" >"$logs/make.log" 2>&1 &
make=$!
trap 'kill "$make" 2>/dev/null; exit 130' INT TERM

for suite in "$@"; do
    log=$logs/$suite.log
    while [ ! -s "$logs/$suite.status" ] && kill -0 "$make" 2>/dev/null; do
        sleep 0.2
    done
    printf '\n==== %s\n' "$suite"
    [ -e "$log" ] || : >"$log"
    cat "$log"
    read -r lines good bad < <(grep -E "$closing" "$log" | awk '{ good += $1; bad += $3 } END { print NR, good + 0, bad + 0 }')
    status=none
    [ ! -s "$logs/$suite.status" ] || status=$(cat "$logs/$suite.status")
    note=
    if [ "$status" = none ]; then
        bad=$((bad + 1)) note=" (not built, or ended by another: $logs/make.log)"
    elif [ "$lines" -eq 0 ]; then
        bad=1 note=" (printed no closing line; exit status $status)"
    elif [ "$status" -ne 0 ] && [ "$bad" -eq 0 ]; then
        bad=1 note=" (no test failed, but the suite did, with exit status $status)"
    elif [ "$status" -eq 0 ] && [ "$bad" -ne 0 ]; then
        note=" (and yet the suite's exit status is 0)"
    elif [ "$good" -eq 0 ] && [ "$bad" -eq 0 ]; then
        bad=1 note=" (ran no test)"
    fi
    passed=$((passed + good)) failed=$((failed + bad))
    summary+=("$(printf '%-22s %5d passed, %d failed%s; %d s' "$suite" "$good" "$bad" "$note" "$(of_processors "$logs/$suite".times)")")
    [ "$bad" -eq 0 ] || broken+=("$suite")
done
wait "$make"

if [ -s "$logs/make.log" ]; then
    printf '\n==== make\n'
    cat "$logs/make.log"
fi
for suite in "${broken[@]}"; do
    printf '\n==== %s failed; the end of %s\n' "$suite" "$logs/$suite.log"
    tail -n 20 "$logs/$suite.log"
done
printf '\n==== suites\n'
printf '%s\n' "${summary[@]}"
# user and system time of all that was run, after that of this shell alone
times >"$logs/all.times"
printf '%d s, %d s of processors\n' "$SECONDS" "$(of_processors "$logs/all.times")"
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
