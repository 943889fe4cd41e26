#!/bin/sh
# SPDX-License-Identifier: MIT
# clang-19 with MC/DC: clang.sh ARGUMENT... A decision that it cannot measure, as `a && !(b && c)`, is an error.
messages=$(clang-19 -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc "$@" 2>&1)
status=$?
[ -z "$messages" ] || printf '%s\n' "$messages" >&2
case $messages in *'unsupported MC/DC'*) exit 1 ;; esac
exit $status
