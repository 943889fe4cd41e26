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

DESCRIPTION = """<?xml version="1.0" encoding="UTF-8"?>
<!-- SPDX-License-Identifier: MIT -->
<package schemaVersion="1.7.28" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance" xs:noNamespaceSchemaLocation="PACK.xsd">
  <vendor>%(vendor)s</vendor>
  <name>%(name)s</name>
  <description>Lit 3D objects on small displays, in fixed point, tile by tile</description>
  <url>https://glint.example/</url>
  <license>LICENSE</license>
  <releases>
    <release version="%(version)s">See CHANGELOG.md.</release>
  </releases>
  <conditions>
    <condition id="renderer">
      <require Cclass="Graphics" Cgroup="glint" Csub="renderer"/>
    </condition>
  </conditions>
  <components>
    <component Cclass="Graphics" Cgroup="glint" Csub="renderer" Cversion="%(version)s">
      <description>The renderer</description>
      <files>
%(files)s      </files>
    </component>
    <component Cclass="Graphics" Cgroup="glint" Csub="panels" Cversion="%(version)s" condition="renderer">
      <description>Drivers of panels</description>
      <files>
%(panels)s      </files>
    </component>
  </components>
</package>
"""


def find(pattern):
    return sorted(os.path.relpath(path, ROOT).replace(os.sep, "/") for path in glob.glob(os.path.join(ROOT, pattern)))


def listed(entries, names):
    entries = entries + [("header" if name.endswith(".h") else "source", name) for name in names]
    return "".join('        <file category="%s" name=%s/>\n' % (kind, quoteattr(name)) for kind, name in entries)


def main():
    folder, version = sys.argv[1:]
    public, sources = find("src/*.h"), find("src/*/*.c")
    panels = find("port/panel/*.[ch]")
    entries = {"vendor": VENDOR, "name": NAME, "version": version,
               "files": listed([("doc", "README.md"), ("include", "src/")], public + sources),
               "panels": listed([("include", "port/")], panels)}
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "%s.%s.%s.pack" % (VENDOR, NAME, version))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as pack:
        pack.writestr("%s.%s.pdsc" % (VENDOR, NAME), DESCRIPTION % entries)
        for name in ["README.md", "CHANGELOG.md", "LICENSE"] + public + find("src/*/*.h") + sources + panels:
            pack.write(os.path.join(ROOT, name), name)
    print(path)


if __name__ == "__main__":
    main()
