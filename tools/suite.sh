#!/bin/sh
# SPDX-License-Identifier: MIT
# The shell of suites while tools/test.sh runs several at once: suite.sh LOGS/SUITE COMMAND. What a line of the recipe prints
# goes to LOGS/SUITE.log, the status of one that fails to LOGS/SUITE.status.
sh -c "$2" >>"$1.log" 2>&1 && exit 0
status=$?
echo "$status" >"$1.status"
exit "$status"
