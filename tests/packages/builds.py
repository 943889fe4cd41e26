# SPDX-License-Identifier: MIT
"""The library as sources, as one source and two headers, installed, by CMake and by Meson: each builds minimal.c."""
import os
import shutil

from tree import DRIVERS, FIRMWARE, HERE, HOST, LINK, M0, WARNINGS, check, find, firmware, path, paths, run, version

HEADERS = [os.path.basename(name) for name in find("src/*.h")]
INSTALLED = sorted(["bin/glint", "bin/glint-import", "lib/libglint.a", "lib/pkgconfig/glint.pc"] +
                   ["include/" + name for name in HEADERS])


def files(folder):
    """All files below a folder, named from there."""
    return sorted(os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names)


def test_copy(b):
    """src/ copied, as docs/firmware.md tells."""
    folder = b.folder("copy")
    shutil.copytree(path("src"), os.path.join(folder, "src"))
    sources = [os.path.join(folder, name) for name in find("src/*/*.c")]
    include = ["-I" + os.path.join(folder, "src"), "-I" + path("port")]
    run("gcc", "-O1", *include, *sources, *paths(HOST + DRIVERS), "-o", os.path.join(folder, "minimal"))
    b.same(os.path.join(folder, "minimal"))


def test_copy_firmware(b):
    folder = b.folder("copy-m0")
    sources = paths(find("src/*/*.c") + FIRMWARE + DRIVERS)
    run("arm-none-eabi-gcc", "-Os", *M0, "-ffunction-sections", "-fdata-sections", "-fno-tree-loop-distribute-patterns",
        "-I" + path("src"), "-I" + path("port"), "-I" + path("port/libc"), *sources, *LINK, "-o",
        os.path.join(folder, "minimal.elf"))
    firmware(os.path.join(folder, "minimal.elf"))


def single(b, name, compiler):
    """The one source, compiled; minimal.c and the unit tests with them. No header of src/ comes first."""
    folder, at = b.folder(name), os.path.join(b.build, "single")
    library = os.path.join(folder, "glint.o")
    run(*compiler, *WARNINGS, "-I" + at, "-c", os.path.join(at, "glint.c"), "-o", library)
    run(*compiler, "-I" + at, "-I" + path("port"), *paths(HOST + DRIVERS), library, "-o", os.path.join(folder, "minimal"))
    b.same(os.path.join(folder, "minimal"))
    include = ["-I" + path(name) for name in ("tests", "tests/unit", "src")]
    run(*compiler, "-std=c99", "-I" + at, *include, *paths(find("tests/unit/*.c") + ["tests/harness.c", "tests/main.c"]),
        library, "-lm", "-o", os.path.join(folder, "unit"))
    check(", 0 failed" in run(os.path.join(folder, "unit")), "unit tests with glint.c")


def test_single_gcc(b):
    single(b, "single-gcc", ["gcc", "-O2"])


def test_single_clang(b):
    single(b, "single-clang", ["clang", "-Os"])


def test_single_firmware(b):
    folder, at = b.folder("single-m0"), os.path.join(b.build, "single")
    check(files(at) == ["glint.c", "glint.h", "glint_extras.h"], "build/single has other files: %s" % files(at))
    sections = ["-ffunction-sections", "-fdata-sections"]
    run("arm-none-eabi-gcc", "-Os", *M0, *WARNINGS, *sections, "-c", os.path.join(at, "glint.c"), "-o",
        os.path.join(folder, "glint.o"))
    run("arm-none-eabi-gcc", "-Os", *M0, *sections, "-fno-tree-loop-distribute-patterns", "-I" + at, "-I" + path("port"),
        "-I" + path("port/libc"), *paths(FIRMWARE + DRIVERS), os.path.join(folder, "glint.o"), *LINK, "-o",
        os.path.join(folder, "minimal.elf"))
    firmware(os.path.join(folder, "minimal.elf"))


def pkg_config(b, folder, env):
    """Builds minimal.c by what pkg-config says."""
    check(run("pkg-config", "--modversion", "glint", env=env).strip() == version(), "version of the pkg-config file")
    flags = run("pkg-config", "--cflags", "--libs", "glint", env=env).split()
    run("gcc", "-I" + path("port"), *paths(HOST + DRIVERS), *flags, "-o", os.path.join(folder, "minimal"))
    b.same(os.path.join(folder, "minimal"))


def programs(folder, root):
    """The installed glint reads an OBJ file and, through the glint-import beside it, an STL file."""
    model = os.path.join(folder, "triangle.stl")
    with open(model, "w", encoding="utf-8") as file:
        file.write("solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid t\n")
    for name in (path("examples/models/teapot.obj"), model):
        run(os.path.join(root, "bin", "glint"), "info", name)


def test_install(b):
    """make install, pkg-config and what it finds, make uninstall."""
    folder = b.folder("install")
    where = ["make", "-s", "DESTDIR=" + folder, "PREFIX=/opt/glint", "BUILD=" + os.path.relpath(b.build, path())]
    run(*where, "install", cwd=path())
    root = os.path.join(folder, "opt", "glint")
    check(files(root) == INSTALLED, "installed: %s" % files(root))
    env = {"PKG_CONFIG_PATH": os.path.join(root, "lib", "pkgconfig"), "PKG_CONFIG_SYSROOT_DIR": folder}
    pkg_config(b, folder, env)
    programs(folder, root)
    run(*where, "uninstall", cwd=path())
    check(files(root) == [], "left by uninstall: %s" % files(root))


# ---- CMake


def cmake(b, name, *options):
    """Builds minimal.c; @return the folder."""
    folder = b.folder(name)
    run("cmake", "-G", "Ninja", "-S", os.path.join(HERE, "cmake"), "-B", folder, "-DGLINT=" + path(), *options)
    run("ninja", "-C", folder, "-j1")
    return folder


def for_host(drivers=()):
    return ["-DSOURCES=" + ";".join(paths(HOST + list(drivers))), "-DINCLUDES=" + path("port")]


def for_firmware():
    return ["-DSOURCES=" + ";".join(paths(FIRMWARE)), "-DINCLUDES=%s;%s" % (path("port"), path("port/libc")),
            "-DCMAKE_TOOLCHAIN_FILE=" + os.path.join(HERE, "cmake", "cortex-m0.cmake"), "-DCMAKE_BUILD_TYPE=MinSizeRel",
            "-DCMAKE_EXE_LINKER_FLAGS=" + " ".join(LINK[:-1]), "-DCMAKE_C_STANDARD_LIBRARIES=-lgcc"]


def test_cmake_subdirectory(b):
    folder = cmake(b, "cmake-subdirectory", "-DWAY=subdirectory", *for_host())
    b.same(os.path.join(folder, "minimal"))
    run("cmake", "--install", folder, "--prefix", os.path.join(folder, "prefix"))
    check(files(os.path.join(folder, "prefix")) == ["bin/minimal"], "a subproject installs something of glint")


def test_cmake_fetch(b):
    b.same(os.path.join(cmake(b, "cmake-fetch", "-DWAY=fetch", *for_host()), "minimal"))


def test_cmake_firmware(b):
    firmware(os.path.join(cmake(b, "cmake-m0", "-DWAY=subdirectory", *for_firmware()), "minimal"))


def test_cmake_package(b):
    """Built by itself, installed and found; another version is not."""
    folder = b.folder("cmake-itself")
    prefix = os.path.join(folder, "prefix")
    run("cmake", "-G", "Ninja", "-S", path(), "-B", folder)
    run("ninja", "-C", folder, "-j1")
    run("cmake", "--install", folder, "--prefix", prefix)
    check([name for name in files(prefix) if "/cmake/" not in name] == INSTALLED, "installed by CMake: %s" % files(prefix))
    programs(folder, prefix)
    pkg_config(b, folder, {"PKG_CONFIG_PATH": os.path.join(prefix, "lib", "pkgconfig")})
    found = ["-DWAY=package", "-DCMAKE_PREFIX_PATH=" + prefix]
    b.same(os.path.join(cmake(b, "cmake-package", *found, "-DVERSION=" + version(), *for_host(DRIVERS)), "minimal"))
    major, minor, _ = version().split(".")
    other = ["-DVERSION=%s.%d" % (major, int(minor) + 1)]
    try:
        cmake(b, "cmake-other", *found, *other, *for_host())
    except Exception as error:
        check("version" in str(error), str(error))
    else:
        check(False, "CMake takes a version that is not there")


# ---- Meson


def meson(b, name, sources, *options):
    """Builds minimal.c with glint as a subproject; @return the folder."""
    folder = b.folder(name)
    shutil.copytree(os.path.join(HERE, "meson"), os.path.join(folder, "consumer"))
    os.makedirs(os.path.join(folder, "consumer", "subprojects"))
    os.symlink(path("port"), os.path.join(folder, "consumer", "port"))
    os.symlink(path(), os.path.join(folder, "consumer", "subprojects", "glint"))
    run("meson", "setup", os.path.join(folder, "build"), os.path.join(folder, "consumer"),
        "-Dfiles=%s" % paths(sources), *options)
    run("ninja", "-C", os.path.join(folder, "build"), "-j1")
    return os.path.join(folder, "build", "minimal")


def test_meson_subproject(b):
    b.same(meson(b, "meson-subproject", HOST))


def test_meson_firmware(b):
    firmware(meson(b, "meson-m0", FIRMWARE, "--cross-file", os.path.join(HERE, "meson", "cortex-m0.ini"),
                   "--buildtype=minsize", "-Dlink=%s" % LINK))


def test_meson_installed(b):
    """Built by itself, installed, and found through pkg-config."""
    folder = b.folder("meson-itself")
    prefix = os.path.join(folder, "prefix")
    run("meson", "setup", os.path.join(folder, "build"), path(), "--prefix", prefix, "--libdir=lib")
    run("ninja", "-C", os.path.join(folder, "build"), "-j1", "install")
    pkg_config(b, folder, {"PKG_CONFIG_PATH": os.path.join(prefix, "lib", "pkgconfig")})


def test_meson_sources(_):
    """Meson's lists of sources are what the tree has."""
    listed = {line.strip(" ',\n") for line in open(path("meson.build"), encoding="utf-8") if line.startswith(("    'src/", "    'port/"))}
    other = listed ^ set(find("src/*/*.c") + find("port/panel/*.c"))
    check(not other, "meson.build: sources %s" % sorted(other))
    for name in HEADERS:
        check("'src/%s'" % name in open(path("meson.build"), encoding="utf-8").read(), "meson.build: without " + name)
