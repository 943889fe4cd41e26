#!/bin/sh
# SPDX-License-Identifier: MIT
# The manual page, from what the program says of itself: man.sh GLINT
program=$1
version=$("$program" --version) || exit 1
"$program" help | awk -v version="$version" '
function plain(text) { gsub(/\\/, "\\e", text); gsub(/-/, "\\-", text); return text }
BEGIN {
    printf ".TH GLINT 1 \"\" \"%s\" \"\"\n.SH NAME\nglint \\- lit 3D models and scenes as small displays show them\n", version
    print ".SH SYNOPSIS\n.B glint\n.I COMMAND\n[\n.I options\n]\n.SH DESCRIPTION"
}
/^glint [a-z]+ [A-Z[]/ && $2 != "help" { if (!seen++) print ".SH COMMANDS"; print ".SS " plain($0); next }
/^glint (help|--version)/ { print ".PP\n.B " plain($0); next }
/^MODEL is/ { print ".SH MODELS" }
/^What holds/ { print ".SH \"EXIT STATUS\"" }
/^  [a-z-]+(-|:|\[)[^ ]*[:\[]/ || /^  (--?[a-z-]+|dir:|point:|spot:|box|torus)/ {
    left = substr($0, 3, 26); right = substr($0, 29)
    if (substr($0, 28, 2) !~ /^ /) { split($0, part, /  +/); left = part[2]; right = part[3] }
    sub(/ +$/, "", left); sub(/^ +/, "", right)
    if (left ~ /^-/ && index($0, "  ") && match($0, /^  -[^ ]*( [^ ]+)?  ?/)) {
        left = substr($0, 3, RLENGTH - 3); right = substr($0, RLENGTH + 1); sub(/^ +/, "", right); sub(/ +$/, "", left)
    }
    print ".TP\n.B " plain(left) "\n" plain(right); next
}
/^$/ { print ".PP"; next }
{ sub(/^ +/, ""); print plain($0) }
'
