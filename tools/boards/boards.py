#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables and pictures of docs/boards.md, the README's table of one board and its moving picture, or checks that
they are true.

boards.py --build BUILD --host SHOW_HOST --stream STREAM --night STREAM --panel PANEL_STREAM --times CSV [--write] PAGE PICTURES README NIGHT

STREAM is what tests/pico/run.js wrote of that one board, and of its first frames of the moving picture; CSV what times.py wrote of the example scenes. With --write the page
and its pictures are written; without, they are checked: figures against the firmware that was built, within 2 %; pictures
against what the host draws, which is what the panels show (tests/board/show.py and animate.py). Scenes that are not in CSV keep the times that the page has.
"""
import argparse
import csv
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(__file__)
sys.path += [os.path.join(HERE, ".."), os.path.join(HERE, "..", "stack"), os.path.join(HERE, "..", "..", "tests", "board")]
import animate  # noqa: E402
import apng  # noqa: E402
import png  # noqa: E402
import show  # noqa: E402
import stack  # noqa: E402
import times  # noqa: E402
from markdown import fill, table  # noqa: E402

PICTURE, PICTURE_OF_ONE_MODEL = "teapot-0", "torus576-0"

# Panels in colour show the example scenes, these boards all of them; and how they move is seen on the last one.
COLOUR = "RGB565"
SCENE_BOARDS = tuple(times.TIMED)
MOVIE_BOARD = "pico"
MOVIE = "scenes-%s.apng" % MOVIE_BOARD

# A figure may be off by so much of itself before the page has to be written anew.
MOST = 0.02

# The board of the README, and what of its program is counted: the second frame of each model, before which nothing starts.
README_BOARD = "pico"
README_FRAMES = (("torus of 576 triangles, one light", "torus576"), ("teapot of 2256 triangles, two lights", "teapot"))

# The moving picture: its program, pictures, and for how long each is shown, as in the scene, milliseconds.
NIGHT = "night"
NIGHT_NAMES = ["%s-%d" % (NIGHT, frame) for frame in range(16)]
NIGHT_STAYS = 120
NIGHT_MOST = 500000  # bytes of the file

# Functions that use no more stack than this, bytes, share a row.
LEAST_STACK = 512


def read_boards():
    with open(os.path.join(HERE, "boards.csv"), newline="") as file:
        return list(csv.DictReader(file))


def read_size(path):
    with open(path) as file:
        return map(int, re.search(r"flash (\d+) \(library (\d+)\), RAM (\d+) \(stack (\d+)\)", file.read()).groups())


def measure_board(build, costs, board):
    """@return flash, of it the library, RAM, the deepest stack and what is reserved for it, in bytes"""
    elf = "%s/%s/release/show.elf" % (build, board)
    flash, library, ram, reserved = read_size(elf[:-len(".elf")] + ".size")
    return flash, library, ram, stack.check(elf, stack.read(elf, costs))[0], reserved


def table_of_boards(build, costs):
    head = ["board", "core", "emulator", "panel", "bus", "pixels go", "flash", "of it glint", "RAM", "stack, at most", "shows", "command"]
    lines = []
    for row in read_boards():
        name, (*sizes, worst, reserved) = row["board"], measure_board(build, costs, row["board"])
        lines.append([row[key] for key in ("name", "core", "emulator", "panel", "bus", "sent")] + list(map(str, sizes)) +
                     ["%d of %d" % (worst, reserved), "![%s](boards/%s.png)" % (name, name),
                      "`make run BOARD=%s`" % (name + (" PROGRAM=animate" if is_in_colour(row) else ""))])
    return table(head, lines, right=range(6, 10))


def is_in_colour(row):
    """A framebuffer is no panel."""
    return COLOUR in row["panel"] and row["bus"] != "framebuffer"


def program_of(row):
    """The firmware that the picture of a board is of."""
    return "animate" if is_in_colour(row) else "show"


def read_times(path):
    """{(board, scene): row}"""
    with open(path, newline="") as file:
        return {(row["board"], row["scene"]): row for row in csv.DictReader(file)}


def text_of_times(row):
    passes, frame, bus = int(row["passes"]), float(row["frame_ms"]), float(row["bus_ms"])
    return "%.0f ms, bus %.0f %%, %d pass%s" % (frame, 100 * bus / frame, passes, "" if passes == 1 else "es")


def cell_of_scene(page, taken, board, scene):
    """A picture and what its frames take; what the page says where that was not measured."""
    picture = "![%s](boards/%s-%s.png)<br>" % (scene, board, scene)
    if (board, scene) in taken:
        return picture + text_of_times(taken[board, scene])
    return picture + page.split(picture)[1].split(" |")[0] if picture in page else picture


def table_of_scenes(build, page, taken):
    rows = {row["board"]: row for row in read_boards()}
    head = ["%s: %s at %.0f MHz<br>%s, %s, %s" % (
        rows[board]["name"], rows[board]["core"], times.TIMED[board].clock / 1e6, rows[board]["panel"], rows[board]["bus"],
        rows[board]["sent"]) for board in SCENE_BOARDS]
    lines = [[scene] + [cell_of_scene(page, taken, board, scene) for board in SCENE_BOARDS] for scene in animate.SCENES]
    sizes = [tuple(read_size("%s/%s/O2/animate.size" % (build, board))) for board in SCENE_BOARDS]
    return table(["", *head], lines + [["bytes"] + ["flash %d, of it glint %d<br>RAM %d, of it stack %d" % size for size in sizes]])


def movie_of(directory):
    """Parts of the animation, from the pictures of one board."""
    board = show.BOARDS[MOVIE_BOARD]
    pictures = [show.read_netpbm(os.path.join(directory, name + ".ppm"))[3] for name in animate.NAMES]
    return apng.parts_of(pictures, board.width, board.height)


def write_movie(path, directory, taken):
    """Each frame stays as long as one of its scene takes."""
    stays = [round(float(taken[MOVIE_BOARD, name.rsplit("-", 1)[0]]["frame_ms"])) for name in animate.NAMES]
    apng.write(path, movie_of(directory), stays)


def instructions_until(stream):
    """@return {picture: instructions that the core had taken when it was done}"""
    with open(stream) as file:
        return {picture: int(count) for count, picture in
                re.findall(r"^# instructions (\d+) nanoseconds \d+ bus \d+\nP (\S+)\.ppm$", file.read(), re.M)}


def table_of_readme(build, costs, stream):
    """Flash, RAM, stack and instructions of one and the same firmware."""
    board = next(row for row in read_boards() if row["board"] == README_BOARD)
    flash, library, ram, worst, reserved = measure_board(build, costs, README_BOARD)
    until = instructions_until(stream)
    return table(["%s: %s, %s" % (board["name"], board["core"], board["panel"]), ""], [
        ["flash, bytes", "%d, of it glint %d" % (flash, library)], ["RAM, bytes, stack and arena included", "%d" % ram],
        ["stack, bytes, at most", "%d of %d" % (worst, reserved)]] + [
            ["instructions a frame: " + title, "%d" % (until[name + "-1"] - until[name + "-0"])]
            for title, name in README_FRAMES], right=[1])


def night_on_host(host):
    """Pictures of 3 bytes a pixel."""
    with tempfile.TemporaryDirectory() as directory:
        show.draw_on_host(NIGHT, host, show.BOARDS[README_BOARD], directory)
        return [show.read_netpbm(os.path.join(directory, name + ".ppm"))[3] for name in NIGHT_NAMES]


def night_on_panel(model, stream):
    """Those of the first frames that a model of the panel shows, by what went over the bus."""
    board = show.BOARDS[README_BOARD]
    with tempfile.TemporaryDirectory() as directory, open(stream) as file:
        subprocess.run([os.path.abspath(model), "-r", str(board.rotation), board.module, "last.ppm"], stdin=file, stdout=subprocess.DEVNULL,
                       cwd=directory, check=True)
        paths = [os.path.join(directory, name + ".ppm") for name in NIGHT_NAMES]
        return [show.read_netpbm(path)[3] for path in paths if os.path.exists(path)]


def night_parts(host):
    board = show.BOARDS[README_BOARD]
    return apng.parts_of(night_on_host(host), board.width, board.height)


def table_of_night(build, stream):
    board = next(row for row in read_boards() if row["board"] == README_BOARD)
    flash, library, ram, _ = read_size("%s/%s/O2/%s.size" % (build, README_BOARD, NIGHT))
    frame, bus = map(times.mean, zip(*show.BOARDS[README_BOARD].frame_times(stream)))
    return table(["board", "panel", "flash", "RAM", "a frame"], [[
        "%s: %s at %.0f MHz" % (board["name"], board["core"], times.TIMED[README_BOARD].clock / 1e6), board["panel"] + ", dithered",
        "%d bytes, of it glint %d" % (flash, library), "%d bytes, stack and arena included" % ram,
        "%.0f ms, bus %.0f ms; above %d ms, as in the scene" % (frame, bus, NIGHT_STAYS)]])


def check_night(tally, path, host, model, stream):
    drawn, shown = night_on_host(host), night_on_panel(model, stream)
    tally.check(len(shown) > 2 and shown == drawn[:len(shown)], "%s: the panel does not show what the host draws" % NIGHT)
    tally.check(os.path.exists(path) and apng.read(path) == (night_parts(host), [NIGHT_STAYS] * len(NIGHT_NAMES)),
                path + " is not what the panel shows: make figures")
    tally.check(os.path.getsize(path) <= NIGHT_MOST, "%s: %d bytes" % (path, os.path.getsize(path)))


def table_of_entries(build):
    with open(os.path.join(build, "stack", "painted.csv"), newline="") as file:
        head, *rows = csv.reader(file)
    counts = {row[0]: list(map(int, row[1:])) for row in rows}
    large = [function for function in counts if max(counts[function]) > LEAST_STACK]
    others = [max(column) for column in zip(*(count for function, count in counts.items() if function not in large))]
    shown = [["`%s`" % function] + counts[function] for function in sorted(large, key=lambda name: -max(counts[name]))]
    return table(head, [list(map(str, row)) for row in shown + [["others, at most"] + others]], right=range(1, len(head)))


def picture_of(row):
    """What is shown of a board: of panels in colour a scene each."""
    if not is_in_colour(row):
        return PICTURE_OF_ONE_MODEL if row["board"] in show.ONE_MODEL else PICTURE
    colours = [other["board"] for other in read_boards() if is_in_colour(other)]
    return list(animate.SCENES)[colours.index(row["board"]) % len(animate.SCENES)] + "-0"


def pictures_of(row):
    """@return {file: picture that the host draws} of a board"""
    name = row["board"]
    wanted = {name + ".png": picture_of(row)}
    wanted.update({"%s-%s.png" % (name, scene): scene + "-0" for scene in animate.SCENES if name in SCENE_BOARDS})
    return wanted


def check_pictures(tally, host, row, pictures):
    """Of a board, against what the host draws for it."""
    with tempfile.TemporaryDirectory() as directory:
        show.draw_on_host(program_of(row), host, show.BOARDS[row["board"]], directory)
        for file, picture in pictures_of(row).items():
            path, drawn = os.path.join(pictures, file), show.read_netpbm(os.path.join(directory, picture + ".ppm"))
            tally.check(os.path.exists(path) and png.read(path).as_bytes() == drawn, path + " is not what the panel shows: make figures")
        if row["board"] == MOVIE_BOARD:
            movie = os.path.join(pictures, MOVIE)
            tally.check(os.path.exists(movie) and apng.read(movie)[0] == movie_of(directory),
                        movie + " is not what the panel shows: make figures")


def write_pictures(host, row, pictures, taken):
    """What the panel of a board shows."""
    with tempfile.TemporaryDirectory() as directory:
        show.draw_on_host(program_of(row), host, show.BOARDS[row["board"]], directory)
        for file, picture in pictures_of(row).items():
            show.write_png(os.path.join(directory, picture + ".ppm"), os.path.join(pictures, file))
        if row["board"] == MOVIE_BOARD:
            write_movie(os.path.join(pictures, MOVIE), directory, taken)


def is_true(says, built):
    """Is a row of a table the same but for figures that moved a little, or by rounding?"""
    figure = r"\b\d{2,}\b|\b\d(?= %)"
    a, b = (list(map(int, re.findall(figure, row))) for row in (says, built))
    return re.sub(figure, "", says) == re.sub(figure, "", built) and len(a) == len(b) and \
        all(abs(x - y) <= max(1, MOST * y) for x, y in zip(a, b))


def text_of(path):
    with open(path) as file:
        return file.read()


def check_page(tally, path, old, new):
    tally.check(len(old.splitlines()) == len(new.splitlines()), "%s: rows are missing; see make figures" % path)
    for says, built in zip(old.splitlines(), new.splitlines()):
        if built.startswith("|") and not built.startswith("| ---"):
            tally.check(is_true(says, built), "%s says\n  %s\ninstead of\n  %s" % (path, says, built))


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "host", "stream", "night", "panel", "times"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--write", action="store_true")
    for name in ("page", "pictures", "readme", "moving"):
        parser.add_argument(name)
    arguments = parser.parse_args()
    costs = stack.read_table()
    old = {path: text_of(path) for path in (arguments.page, arguments.readme)}
    new = dict(old)
    taken = read_times(arguments.times)
    for path, name, text in ((arguments.page, "boards", table_of_boards(arguments.build, costs)),
                              (arguments.page, "scenes", table_of_scenes(arguments.build, old[arguments.page], taken)),
                              (arguments.page, "entries", table_of_entries(arguments.build)),
                              (arguments.readme, "night", table_of_night(arguments.build, arguments.night)),
                              (arguments.readme, "one board", table_of_readme(arguments.build, costs, arguments.stream))):
        new[path] = fill(new[path], name, text)
    if arguments.write:
        for path, text in new.items():
            with open(path, "w") as file:
                file.write(text)
        for row in read_boards():
            write_pictures(os.path.abspath(arguments.host), row, arguments.pictures, taken)
        apng.write(arguments.moving, night_parts(os.path.abspath(arguments.host)), [NIGHT_STAYS] * len(NIGHT_NAMES))
        return 0
    tally = show.Tally()
    for path in old:
        check_page(tally, path, old[path], new[path])
    for row in read_boards():
        check_pictures(tally, os.path.abspath(arguments.host), row, arguments.pictures)
    check_night(tally, arguments.moving, os.path.abspath(arguments.host), arguments.panel, arguments.night)
    return tally.close()


if __name__ == "__main__":
    sys.exit(main())
