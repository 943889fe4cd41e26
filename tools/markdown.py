# SPDX-License-Identifier: MIT
"""Tables in pages, and the parts of pages that are written by tools: between markers of a name."""
import textwrap


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def table(head, rows, right=()):
    """A table; columns whose indices are in `right` are right-aligned."""
    return row(head) + row(["---:" if i in right else "---" for i in range(len(head))]) + "".join(map(row, rows))


def listed(words):
    """@return "a", "a and b", "a, b and c" """
    *most, last = words
    return ", ".join(most) + " and " + last if most else last


def bullets(sentences):
    """What follows from figures."""
    return "What follows:\n\n" + "".join(textwrap.fill("- " + " ".join(sentence.split()), 118, subsequent_indent="  ",
                                                        break_on_hyphens=False) + "\n" for sentence in sentences)


def split(page, name):
    """@return the page up to the part of this name, its text, and the rest"""
    begin, end = "<!-- %s: made by make figures -->\n" % name, "<!-- end of %s -->" % name
    if page.count(begin) != 1 or page.count(end) != 1:
        raise ValueError("no part '%s' in the page" % name)
    before, rest = page.split(begin)
    text, after = rest.split(end)
    return before + begin, text, end + after


def fill(page, name, text):
    before, _, after = split(page, name)
    return before + text + after
