# SPDX-License-Identifier: MIT
"""How pages put figures."""
import textwrap


def table(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "".join("| %s |\n" % " | ".join(cells) for cells in lines)


def listed(words):
    """@return "a", "a and b", "a, b and c" """
    *most, last = words
    return ", ".join(most) + " and " + last if most else last


def bullets(sentences):
    """What follows from figures."""
    return "What follows:\n\n" + "".join(textwrap.fill("- " + " ".join(sentence.split()), 118, subsequent_indent="  ",
                                                        break_on_hyphens=False) + "\n" for sentence in sentences)
