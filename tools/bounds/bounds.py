#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that bounds.csv has each function of src/ which divides by, shifts by or indexes with a number that is computed.

bounds.py [TABLE]: a row has functions, their bound, the functions that establish it, and the suites or proofs at it. The
source's functions are those of clang's syntax tree, in the forms of all cores. No row is needed of a number that is bounded
where it stands: constants, counters of loops, what is masked or taken modulo a constant, comparisons, and sums, products
and choices of those. Exits with 1 where the source and the table differ, where a row has an empty field, and where it names
a function or a test that there is not.
"""
import csv
import glob
import os
import re
import subprocess
import sys

TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bounds.csv")
# What a core decides is compiled, as in tests/tests.mk: all at once as another core has it.
FORMS = ([], ["-DGLINT_SPLIT_PRODUCTS=1", "-DGLINT_DIVIDES=0", "-DGLINT_COUNTS_ZEROS=0"])
LINE = re.compile(r"([|` -]*)(\w+) (0x[0-9a-f]+)(.*)|([|` -]*)<<<NULL>>>")
CASTS = ("ImplicitCastExpr", "CStyleCastExpr", "ParenExpr", "ConstantExpr")


class Node:
    def __init__(self, kind, address, text):
        self.kind, self.address, self.text, self.children = kind, address, text, []

    def all(self):
        yield self
        for child in self.children:
            yield from child.all()

    def operator(self):
        return re.findall(r"'([^' ]+)'", self.text)[-1]


def functions(flags):
    """@return the node of each function's definition, by its name"""
    sources = "".join('#include "%s"\n' % path for path in sorted(glob.glob("src/*/*.c")))
    command = ["clang", "-std=c99", "-ffreestanding", "-w", "-I.", "-Isrc", *flags, "-fsyntax-only", "-Xclang", "-ast-dump",
               "-fno-color-diagnostics", "-x", "c", "-"]
    dump = subprocess.run(command, input=sources, stdout=subprocess.PIPE, text=True, check=True).stdout
    root, path = Node("", "", ""), []
    path.append((-1, root))
    for line in dump.splitlines():
        found = LINE.fullmatch(line)
        if not found:
            continue
        depth = len(found[1] if found[2] else found[5])
        while path[-1][0] >= depth:
            path.pop()
        node = Node(found[2] or "", found[3] or "", found[4] or "")
        path[-1][1].children.append(node)
        path.append((depth, node))
    return {re.search(r" (\w+) '", node.text)[1]: node for node in root.all()
            if node.kind == "FunctionDecl" and any(child.kind == "CompoundStmt" for child in node.children)}


class Reader:
    """One function: its variables that are bounded where they stand."""

    def __init__(self, function):
        self.function, self.bounded = function, {}
        assigned = {self.variable(node.children[0]) for node in function.all() if self.assigns(node)}
        for node in function.all():
            if node.kind == "ForStmt" and len(node.children) > 2 and node.children[2].kind == "BinaryOperator":
                name = self.variable(node.children[2].children[0])
                if name and node.children[2].operator() in ("<", "<=", "!="):
                    self.bounded[name] = True
            if node.kind == "VarDecl" and node.children and node.address not in assigned:
                self.bounded.setdefault(node.address, self.is_bounded(node.children[0]))

    @staticmethod
    def assigns(node):
        return node.children and node.children[0].kind == "DeclRefExpr" and (
            node.kind == "CompoundAssignOperator" or node.kind == "BinaryOperator" and node.operator() == "=" or
            node.kind == "UnaryOperator" and node.operator() in ("++", "--", "&"))

    def variable(self, node):
        while node.kind in CASTS and node.children:
            node = node.children[0]
        found = re.search(r" (?:Var|ParmVar) (0x[0-9a-f]+)", node.text) if node.kind == "DeclRefExpr" else None
        return found and found[1]

    def is_bounded(self, node):
        if node.kind in ("IntegerLiteral", "CharacterLiteral", "UnaryExprOrTypeTraitExpr"):
            return True
        if node.kind in CASTS:
            return self.is_bounded(node.children[0])
        if node.kind == "DeclRefExpr":
            return "EnumConstant" in node.text or self.bounded.get(self.variable(node), False)
        if node.kind == "UnaryOperator":
            return node.operator() == "!" or node.operator() in "-+~" and self.is_bounded(node.children[0])
        if node.kind == "BinaryOperator":
            operator, sides = node.operator(), [self.is_bounded(child) for child in node.children]
            if operator in ("<", "<=", ">", ">=", "==", "!=", "&&", "||"):
                return True
            return any(sides) if operator == "&" else sides[1] if operator == "%" else all(sides)
        if node.kind == "ConditionalOperator":
            return all(self.is_bounded(child) for child in node.children[1:])
        return False

    def deeds(self):
        """@return of "divide", "shift" and "index" what the function does by a number that is not bounded where it stands"""
        found = set()
        for node in self.function.all():
            if node.kind in ("BinaryOperator", "CompoundAssignOperator"):
                deed = {"/": "divide", "%": "divide", "<<": "shift", ">>": "shift"}.get(node.operator().rstrip("="))
                if deed and not self.is_bounded(node.children[1]):
                    found.add(deed)
            elif node.kind == "ArraySubscriptExpr" and not self.is_bounded(node.children[1]):
                found.add("index")
        return found

def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def names_of_tests():
    """@return suites and drivers of proofs"""
    names = {os.path.splitext(os.path.basename(path))[0] for path in glob.glob("tests/*/*.c") + glob.glob("tests/unit/*/*.c")}
    for path in glob.glob("tests/proof/*.c"):
        names.update(re.findall(r"^PROOF\((\w+)\)", text_of(path), re.M))
    return names | set(re.findall(r"^SUITE_(\w+)", text_of("tests/tests.mk"), re.M))


def problems(table):
    found, defined = {}, set()
    for flags in FORMS:
        for name, node in functions(flags).items():
            defined.add(name)
            deeds = Reader(node).deeds()
            if deeds:
                found.setdefault(name, set()).update(deeds)
    with open(table, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    listed, tests = {name for row in rows for name in row["functions"].split()}, names_of_tests()
    for name in sorted(set(found) - listed):
        yield f"{name}: no row, and it does {' and '.join(sorted(found[name]))} by a computed number"
    for name in sorted(listed - set(found)):
        yield f"{name}: a row, and no computed number" if name in defined else f"{name}: no such function"
    for row in rows:
        if not all(row.values()):
            yield f"{row['functions']}: a field is empty"
        for place in row["established"].split():
            path, _, name = place.partition(":")
            if name not in defined or not any(name + "(" in text_of(file) for file in glob.glob("src/*/" + path)):
                yield f"{row['functions']}: {place} is no function"
        for name in set(row["test"].split()) - tests:
            yield f"{row['functions']}: {name} is no suite and no proof"


def main():
    lines = list(problems(sys.argv[1] if len(sys.argv) > 1 else TABLE))
    print("\n".join(lines))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
