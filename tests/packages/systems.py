# SPDX-License-Identifier: MIT
"""The Pico SDK, ESP-IDF, Zephyr and CMSIS-Pack: manifests, and samples built on doubles of what they call."""
import os
import re
import xml.etree.ElementTree
import zipfile

import yaml
from tree import FIRMWARE, HERE, LINK, M0, check, find, firmware, path, paths, read, read_netpbm, run, version

WARNINGS = "-Wall -Wextra -Werror -Wno-missing-field-initializers"


def sample(b, name, source, *options, env=None):
    """Builds a sample, every file of it and of the library; @return the folder."""
    folder = b.folder(name)
    run("cmake", "-G", "Ninja", "-S", source, "-B", folder, "-DCMAKE_C_FLAGS_INIT=" + WARNINGS, *options, env=env)
    run("ninja", "-C", folder, "-j1")
    return folder


def cross(toolchain):
    return "-DCMAKE_TOOLCHAIN_FILE=" + os.path.join(HERE, "cmake", toolchain + ".cmake")


def same_picture(b, got, width, height):
    """Is it what the sample's scene looks like, drawn to memory?"""
    expected = os.path.join(b.folder("turntable-%d" % width), "expected.ppm")
    run(os.path.join(b.build, "packages", "turntable"), str(width), str(height), expected)
    expected = read_netpbm(expected)
    check(sum(1 for byte in expected[3] if byte) > 5000, "next to nothing is drawn")
    check(got == expected, "another picture than in memory")


# ---- Raspberry Pi Pico SDK

PICO = {"PICO_SDK_PATH": os.path.join(HERE, "pico-sdk")}


def test_pico(b):
    folder = sample(b, "pico", path("examples/pico-sdk"), env=PICO)
    same_picture(b, b.glass("st7789-240x240", run(os.path.join(folder, "teapot"))), 240, 240)


def test_pico_firmware(b):
    """No more than the SDK itself is missing when the sample is linked for its core."""
    folder = sample(b, "pico-m0", path("examples/pico-sdk"), cross("cortex-m0"), "-DCMAKE_EXE_LINKER_FLAGS=-r -nostdlib",
                    env=PICO)
    words = run("arm-none-eabi-nm", "-u", os.path.join(folder, "teapot")).split()
    missing = [name for kind, name in zip(words[::2], words[1::2]) if kind == "U"]  # a weak one may be missing
    check("spi_init" in missing, "the sample does not call the SDK")
    check(not [name for name in missing if name.startswith("glint")], "of glint: %s" % missing)


# ---- ESP-IDF

IDF = {"IDF_PATH": os.path.join(HERE, "esp-idf")}


def esp(b, name, *options):
    """Components are called as their folders are: so the tree is seen through a link named glint."""
    link = os.path.join(b.folder(name + "-tree"), "glint")
    os.symlink(path(), link)
    return sample(b, name, os.path.join(link, "examples", "esp-idf"), *options, env=IDF)


def test_esp_idf(b):
    folder = esp(b, "esp-idf")
    run(os.path.join(folder, "teapot"), cwd=folder)
    same_picture(b, read_netpbm(os.path.join(folder, "teapot.ppm")), 320, 240)


def test_esp_idf_firmware(b):
    folder = esp(b, "esp-idf-riscv", cross("riscv32"))
    symbols = run("riscv64-unknown-elf-nm", os.path.join(folder, "main", "libmain.a"))
    check("U esp_lcd_panel_draw_bitmap" in symbols and "T app_main" in symbols, "the sample is not there")


def test_esp_idf_requirements(_):
    for component, count in ((path("CMakeLists.txt"), len(find("src/*/*.c") + find("port/panel/*.c"))), (path("examples/esp-idf/main/CMakeLists.txt"), 2)):
        said = run("cmake", "-DCOMPONENT=" + component, "-P", os.path.join(HERE, "esp-idf", "requirements.cmake"))
        check(said.startswith("%d sources" % count), said)


def test_esp_idf_manifest(_):
    manifest = yaml.safe_load(read("idf_component.yml"))
    known = {"version": str, "description": str, "license": str, "url": str, "repository": str, "tags": list, "dependencies": dict, "files": dict}
    for field, value in manifest.items():
        check(isinstance(value, known.get(field, ())), "field " + field)
    check(manifest["version"] == version(), "version")
    check(all(re.fullmatch(r"[A-Za-z0-9_-]{3,32}", tag) for tag in manifest["tags"]), "tags")
    for pattern in manifest["files"]["exclude"]:
        check(os.path.isdir(path(pattern.split("/")[0])), pattern)
        check(not pattern.startswith(("src", "LICENSE", "CMakeLists")), pattern + ": needed")


# ---- Zephyr


def zephyr(b, name, *options):
    return sample(b, name, path("examples/zephyr"), "-DZephyr_DIR=" + os.path.join(HERE, "zephyr"), *options)


def test_zephyr(b):
    folder = zephyr(b, "zephyr")
    run(os.path.join(folder, "zephyr"), cwd=folder)
    same_picture(b, read_netpbm(os.path.join(folder, "teapot.ppm")), 320, 240)


def test_zephyr_firmware(b):
    folder = zephyr(b, "zephyr-m0", cross("cortex-m0"), "-DCONFIG_GLINT_PANEL=y")
    check("U display_write" in run("arm-none-eabi-nm", os.path.join(folder, "libapp.a")), "the sample is not there")
    check("T glint_panel_start" in run("arm-none-eabi-nm", os.path.join(folder, "module", "libglint.a")), "no drivers")


def test_zephyr_manifest(_):
    module = yaml.safe_load(read("zephyr/module.yml"))
    check(set(module) <= {"name", "build", "samples", "tests", "boards"}, "fields of module.yml")
    check(os.path.exists(path(module["build"]["cmake"], "CMakeLists.txt")), "build: cmake")
    options = re.findall(r"^config (\w+)$", read(module["build"]["kconfig"]), re.MULTILINE)
    check(options == ["GLINT", "GLINT_PANEL"] and "CONFIG_GLINT" in read("zephyr/CMakeLists.txt"), "options: %s" % options)
    for folder in module["samples"]:
        description = yaml.safe_load(read(folder + "/sample.yaml"))
        check(description["sample"]["name"] and description["tests"], folder)
        check(all(name.count(".") > 1 for name in description["tests"]), folder + ": names of tests")
        check("CONFIG_GLINT=y" in read(folder + "/prj.conf"), folder + ": without the library")


# ---- CMSIS-Pack


def test_cmsis_pack(b):
    """minimal.c from nothing but the files that the pack's description lists."""
    folder = b.folder("pack")
    run("python3", path("tools/packages/pack.py"), folder, version())
    name = os.path.join(folder, "glint.glint.%s.pack" % version())
    with zipfile.ZipFile(name) as pack:
        pack.extractall(folder)
    root = xml.etree.ElementTree.parse(os.path.join(folder, "glint.glint.pdsc")).getroot()
    check([child.tag for child in root] == ["vendor", "name", "description", "url", "license", "releases", "conditions",
                                             "components"],
          "elements of the description")
    check(root.findtext("vendor") + "." + root.findtext("name") == "glint.glint", "the name of the description's file")
    check(root.find("releases/release").get("version") == version(), "version")
    components = root.findall("components/component")
    check([[component.get(name) for name in ("Cclass", "Cgroup", "Csub", "Cversion")] for component in components] ==
          [["Graphics", "glint", sub, version()] for sub in ("renderer", "panels")], "components")
    listed = [(file.get("category"), file.get("name")) for component in components for file in component.find("files")]
    for _, file in listed + [("license", root.findtext("license"))]:
        check(os.path.exists(os.path.join(folder, file)), file + ": not in the pack")
    check([file for kind, file in listed if kind == "source"] == find("src/*/*.c") + find("port/panel/*.c"), "sources")
    check([file for kind, file in listed if kind == "header"] == find("src/*.h") + find("port/panel/*.h"), "headers")
    sources = [os.path.join(folder, file) for kind, file in listed if kind == "source"]
    include = ["-I" + os.path.join(folder, file) for kind, file in listed if kind == "include"]
    elf = os.path.join(folder, "minimal.elf")
    run("arm-none-eabi-gcc", "-Os", *M0, "-ffunction-sections", "-fdata-sections", "-fno-tree-loop-distribute-patterns",
        *include, "-I" + path("port"), "-I" + path("port/libc"), *sources, *paths(FIRMWARE), *LINK, "-o", elf)
    firmware(elf)
