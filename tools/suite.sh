#!/bin/sh
# SPDX-License-Identifier: MIT
# The shell of suites while tools/test.sh runs several at once: suite.sh LOGS/SUITE COMMAND. What a line of the recipe prints
# goes to LOGS/SUITE.log, the time that it takes of processors to LOGS/SUITE.times, the status of one that fails to
# LOGS/SUITE.status.
sh -c "$2" >>"$1.log" 2>&1
status=$?
times >>"$1.times"
[ "$status" -ne 0 ] || exit 0
echo "$status" >"$1.status"
exit "$status"
