#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A header as doxygen is to read it: split.py HEADER. It gives a comment behind several fields to the last one alone."""
import re
import sys

FIELDS = re.compile(r"^([ ]+(?:const )?\w+ )(\w+(?:\[\w+\])?(?:, \w+(?:\[\w+\])?)+);([ ]*/\*\*<.*?\*/)", re.MULTILINE | re.DOTALL)


def split(match):
    kind, names, comment = match.groups()
    return " ".join("%s%s;%s" % (kind, name, comment) for name in names.split(", "))


with open(sys.argv[1], encoding="utf-8") as file:
    sys.stdout.write(FIELDS.sub(split, file.read()))
