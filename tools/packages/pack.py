#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the library as a CMSIS-Pack: pack.py FOLDER VERSION. Its description lists the files that the tree has."""
import glob
import os
import sys
import zipfile
from xml.sax.saxutils import quoteattr

ROOT = os.path.normpath(os.path.join(os.path.dirname(__file__), "..", ".."))
VENDOR = NAME = "glint"

# The url is where a pack index finds newer ones; this pack comes from no index.
DESCRIPTION = """<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: MIT -->
<package schemaVersion="1.7.28" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance" xs:noNamespaceSchemaLocation="PACK.xsd">
  <vendor>%(vendor)s</vendor>
  <name>%(name)s</name>
  <description>Lit 3D objects on small displays, in fixed point, tile by tile</description>
  <url></url>
  <license>LICENSE</license>
  <releases>
    <release version="%(version)s">See CHANGELOG.md.</release>
  </releases>
  <components>
    <component Cclass="Graphics" Cgroup="glint" Cversion="%(version)s">
      <description>The renderer</description>
      <files>
%(files)s      </files>
    </component>
  </components>
</package>
"""


def find(pattern):
    return sorted(os.path.relpath(path, ROOT).replace(os.sep, "/") for path in glob.glob(os.path.join(ROOT, pattern)))


def main():
    folder, version = sys.argv[1:]
    public, sources = find("src/*.h"), find("src/*/*.c")
    entries = [("doc", "README.md"), ("include", "src/")] + [("header", name) for name in public] + \
        [("source", name) for name in sources]
    files = "".join('        <file category="%s" name=%s/>\n' % (kind, quoteattr(name)) for kind, name in entries)
    description = DESCRIPTION % {"vendor": VENDOR, "name": NAME, "version": version, "files": files}
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "%s.%s.%s.pack" % (VENDOR, NAME, version))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as pack:
        pack.writestr("%s.%s.pdsc" % (VENDOR, NAME), description)
        for name in ["README.md", "CHANGELOG.md", "LICENSE"] + public + find("src/*/*.h") + sources:
            pack.write(os.path.join(ROOT, name), name)
    print(path)


if __name__ == "__main__":
    main()
