# SPDX-License-Identifier: MIT
"""Charts through gnuplot, as SVG that is readable on light and on dark pages: panels of points, lines and direct
labels, which are placed so that none covers another."""
import math
import re
import subprocess

FONT = "DejaVu Sans,Verdana,Helvetica,Arial,sans-serif"
TITLE_SIZE, TEXT_SIZE, LABEL_SIZE = 15, 12, 11

# Name: on a light page, on a dark one.
COLOURS = {
    "paper": ("#fcfcfb", "#161b22"),
    "ink": ("#24292f", "#e6edf3"),
    "grid": ("#dce0e5", "#30363d"),
    "grey": ("#6e7781", "#9198a1"),
    "blue": ("#1f6fb5", "#6cb6ff"),
    "gold": ("#946200", "#d9a02e"),
    "red": ("#b3261f", "#ff7b72"),
    "green": ("#1a7a36", "#46c05c"),
    "violet": ("#7a45c4", "#c29bff"),
    "teal": ("#0b7285", "#4fd1d9"),
}

# Of a point and of the circle around a special one, pixels.
POINT_RADIUS, CIRCLE = 4, 9

# A label further than this from its point is joined to it by a line.
NEAR = 16


class Unreadable(Exception):
    """A label finds no free place."""


class Axis:
    def __init__(self, label, low, high, log=False, marks=None):
        """@param marks where a logarithmic axis has its ticks, when not at round numbers"""
        self.label, self.low, self.high, self.log, self.marks = label, low, high, log, marks

    def ticks(self):
        """Of a logarithmic axis: powers of ten, with 2 and 5 or more between them where that is few."""
        if self.marks:
            return self.marks
        first, last = math.floor(math.log10(self.low)), math.ceil(math.log10(self.high))
        decades = math.log10(self.high / self.low)
        steps = (1,) if decades > 3 else (1, 2, 5) if decades > 1 else (1, 1.5, 2, 3, 4, 5, 7)
        return [step * 10.0**power for power in range(first, last + 1) for step in steps
                if self.low <= step * 10.0**power <= self.high]

    def fraction(self, value):
        value = min(max(value, self.low), self.high)
        if self.log:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


def decimal(value):
    """A tick's number without an exponent."""
    return ("%.9f" % value).rstrip("0") if value < 1e-3 else "%g" % value if value < 1e5 else "%d" % value


class Panel:
    """A plot; `box` is the plot's own rectangle in pixels: left, top, width, height."""

    def __init__(self, title, box, x, y):
        self.title, self.box, self.x, self.y = title, box, x, y
        self.points, self.lines, self.rules = [], [], []

    def point(self, x, y, label, colour, filled=True, circled=False):
        self.points.append((x, y, label, colour, filled, circled))

    def line(self, pairs, colour, width=1.5, label=None, dash=1, marks=False):
        self.lines.append((pairs, colour, width, label, dash, marks))

    def rule(self, y, label, right=False):
        """A level across the panel, its name above it at the left or the right."""
        self.rules.append((y, label, right))

    def place(self, x, y):
        left, top, width, height = self.box
        return left + width * self.x.fraction(x), top + height * (1 - self.y.fraction(y))


def text_width(text, size=LABEL_SIZE):
    """Of DejaVu Sans, which is wider than what most pages use in its place."""
    widths = {"narrow": 0.39, "wide": 0.97, "capital": 0.71, "other": 0.64}
    kind = lambda c: ("narrow" if c in "ijlftr.,:;|'()[]/- I" else "wide" if c in "mwMW%@=+^~" else
                      "capital" if c.isupper() else "other")
    return size * sum(widths[kind(c)] for c in text)


def overlap(a, b):
    """Whether two boxes (left, top, right, bottom) share an area."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def crosses(start, end, box):
    """Whether a segment touches a box (Liang and Barsky, 1984)."""
    near, far = 0.0, 1.0
    for axis in (0, 1):
        delta = end[axis] - start[axis]
        for sign, bound in ((-1, box[axis]), (1, box[axis + 2])):
            room = sign * (bound - start[axis])
            if delta == 0:
                if room < 0:
                    return False
                continue
            at = room / (sign * delta)
            if sign * delta < 0:
                near = max(near, at)
            else:
                far = min(far, at)
    return near <= far


class Labels:
    """Finds places for labels beside their points, near ones first, by moving each in turn until none gains."""

    HEIGHT = LABEL_SIZE + 2
    ROUNDS = 8

    def __init__(self, panel):
        left, top, width, height = panel.box
        self.frame = (left + 2, top + 2, left + width - 2, top + height - 2)
        self.anchors = [(panel.place(x, y), label) for x, y, label, *_ in panel.points if label]
        self.points = [(*panel.place(x, y), (CIRCLE if circled else POINT_RADIUS) + 1)
                       for x, y, *_, circled in panel.points]
        self.segments = [(panel.place(*a), panel.place(*b)) for pairs, *_ in panel.lines
                         for a, b in zip(pairs, pairs[1:])]
        self.segments += [(panel.place(panel.x.low, y), panel.place(panel.x.high, y)) for y, *_ in panel.rules]
        self.fixed = [rule_box(panel, rule) for rule in panel.rules]
        self.placed = {}

    def candidates(self, anchor, label):
        """Boxes around a point with the end of a leader."""
        width = text_width(label)
        for distance in (POINT_RADIUS + 3, CIRCLE + 3, NEAR, 26, 38, 52, 68, 86, 106, 130, 160, 190):
            for turn in range(16):
                angle = math.pi * turn / 8
                dx, dy = distance * math.cos(angle), distance * math.sin(angle)
                left = anchor[0] + dx - width * (0.5 - 0.5 * round(math.cos(angle), 3))
                middle = anchor[1] + dy + self.HEIGHT * 0.5 * round(math.sin(angle), 3)
                box = (left, middle - self.HEIGHT / 2, left + width, middle + self.HEIGHT / 2)
                yield distance, box, (min(max(anchor[0], box[0]), box[2]), min(max(anchor[1], box[1]), box[3]))

    def covered(self, index, box):
        """How many labels and points the box of a label covers; points count more, since they cannot move."""
        wide = (box[0] - 3, box[1], box[2] + 3, box[3])
        return (sum(overlap(wide, other[0]) for i, other in self.placed.items() if i != index) +
                3 * sum(overlap(wide, other) for other in self.fixed) +
                3 * sum(overlap(box, (x - r, y - r, x + r, y + r)) for x, y, r in self.points))

    def cost(self, index, distance, box, end):
        """Infinite outside the panel."""
        frame, anchor = self.frame, self.anchors[index][0]
        if box[0] < frame[0] or box[1] < frame[1] or box[2] > frame[2] or box[3] > frame[3]:
            return math.inf
        others = [placed for i, placed in self.placed.items() if i != index]
        cost = distance + 1000 * self.covered(index, box)
        cost += (30 if distance <= NEAR else 60) * sum(crosses(a, b, box) for a, b in self.segments)
        if distance > NEAR:
            cost += 200 * sum(crosses(anchor, end, other) for other in [placed[0] for placed in others] + self.fixed)
            cost += 90 * sum(crosses(anchor, end, (x - r, y - r, x + r, y + r)) for x, y, r in self.points
                             if (x, y) != anchor)
        cost += 200 * sum(crosses(self.anchors[i][0], other[1], box) for i, other in self.placed.items()
                         if i != index and other[2] > NEAR)
        return cost

    def best(self, index):
        anchor, label = self.anchors[index]
        cost, choice = math.inf, None
        for distance, box, end in self.candidates(anchor, label):
            if distance >= cost: # those still to come are further away
                break
            now = self.cost(index, distance, box, end)
            if now < cost:
                cost, choice = now, (box, end, distance)
        if choice is None:
            raise Unreadable("the label '%s' is wider than the panel" % label)
        return choice

    def solve(self):
        """@return for each labelled point its label, its place, the box of its text, and the leader's end or None."""
        for _ in range(self.ROUNDS):
            for index in range(len(self.anchors)):
                self.placed[index] = self.best(index)
        for index, (box, _, _) in self.placed.items():
            if self.covered(index, box):
                raise Unreadable("no room for the label '%s'" % self.anchors[index][1])
        return [(label, anchor, self.placed[i][0], self.placed[i][1] if self.placed[i][2] > NEAR else None)
                for i, (anchor, label) in enumerate(self.anchors)]


def rule_box(panel, rule):
    y, label, at_right = rule
    left, _, width, _ = panel.box
    bottom, length = panel.place(panel.x.low, y)[1] - 1, text_width(label)
    start = left + width - 6 - length if at_right else left + 6
    return (start, bottom - LABEL_SIZE - 2, start + length, bottom)


def spread(wanted, gap, low, high):
    """Moves sorted positions apart until they are `gap` from each other, as little as that takes."""
    if len(wanted) * gap > high - low + gap:
        raise Unreadable("%d labels at the right edge" % len(wanted))
    places = list(wanted)
    for _ in range(1000):
        for i in range(len(places) - 1):
            lack = gap - (places[i + 1] - places[i])
            if lack > 1e-9:
                places[i] -= lack / 2
                places[i + 1] += lack / 2
        places = [min(max(place, low + i * gap), high - (len(places) - 1 - i) * gap)
                  for i, place in enumerate(places)]
    return places


class Chart:
    """Panels under one title; `width` and `height` in pixels."""

    def __init__(self, title, subtitle, width, height, right_labels=0):
        """@param subtitle words and their colours, in a row
        @param right_labels pixels right of the panels in which lines are named"""
        self.title, self.subtitle, self.width, self.height = title, subtitle, width, height
        self.right_labels = right_labels
        self.panels = []
        self.script = []

    def at(self, x, y):
        return "screen %.5f, screen %.5f" % (x / self.width, 1 - y / self.height)

    def text(self, x, y, text, colour="ink", size=LABEL_SIZE, align="left"):
        self.script.append('set label "%s" at %s %s textcolor rgb "%s" font ",%d" front' % (
            text.replace('"', "'"), self.at(x, y), align, COLOURS[colour][0], size))

    def leader(self, start, end, colour="grey", layer="front"):
        self.script.append('set arrow from %s to %s nohead linewidth 0.6 linecolor rgb "%s" %s' % (
            self.at(*start), self.at(*end), COLOURS[colour][0], layer))

    def draw_heading(self):
        self.text(self.width / 2, 20, self.title, size=TITLE_SIZE, align="center")
        gap = 22
        x = (self.width - sum(text_width(words, TEXT_SIZE) + gap for words, _ in self.subtitle) + gap) / 2
        for words, colour in self.subtitle:
            self.text(x, 42, words, colour, TEXT_SIZE)
            x += text_width(words, TEXT_SIZE) + gap

    def draw_labels(self, panel):
        colours = {(x, y, label): colour for x, y, label, colour, *_ in panel.points}
        labelled = [(point, place) for point, place in zip((p for p in panel.points if p[2]), Labels(panel).solve())]
        for (x, y, label, *_), (_, anchor, box, leader) in labelled:
            self.text(box[0], (box[1] + box[3]) / 2, label, colours[(x, y, label)])
            if leader:
                self.leader(anchor, leader, colours[(x, y, label)])

    def draw_line_names(self, panel):
        """Names lines at their right ends, beside the panel."""
        left, top, width, height = panel.box
        height_of = lambda pairs: sum(panel.place(*pair)[1] for pair in pairs) / len(pairs)
        named = sorted((panel.place(*pairs[-1])[1], height_of(pairs), label, colour, panel.place(*pairs[-1]))
                       for pairs, colour, _, label, *_ in panel.lines if label)
        places = spread([name[0] for name in named], LABEL_SIZE + 3, top + 4, top + height - 4)
        for place, (_, _, label, colour, end) in zip(places, named):
            if left + width + 22 + text_width(label) > left + width + self.right_labels:
                raise Unreadable("the name '%s' is too long" % label)
            self.leader(end, (left + width + 18, place), colour)
            self.text(left + width + 22, place, label, colour)

    def draw_panel(self, panel):
        left, top, width, height = panel.box
        self.script += ["unset label", "unset arrow", "unset logscale", "set xtics autofreq", "set ytics autofreq"]
        if not self.panels.index(panel):
            self.draw_heading()
        self.script += [
            "set lmargin at screen %.5f" % (left / self.width),
            "set rmargin at screen %.5f" % ((left + width) / self.width),
            "set tmargin at screen %.5f" % (1 - top / self.height),
            "set bmargin at screen %.5f" % (1 - (top + height) / self.height)]
        for name, axis in (("x", panel.x), ("y", panel.y)):
            self.script += ["set %srange [%.9g:%.9g]" % (name, axis.low, axis.high),
                            'set %slabel "%s" offset %s' % (name, axis.label, "0,0.4" if name == "x" else "1,0")] 
            if axis.log:
                self.script += ["set logscale " + name, "set %stics (%s)" % (
                    name, ", ".join('"%s" %.9g' % (decimal(tick), tick) for tick in axis.ticks()))]
        self.text(left + width / 2, top - 10, panel.title, size=TEXT_SIZE, align="center")
        for y, label, at_right in panel.rules:
            self.leader(panel.place(panel.x.low, y), panel.place(panel.x.high, y), layer="back")
            box = rule_box(panel, (y, label, at_right))
            self.text(box[0], (box[1] + box[3]) / 2, label, "grey")
        self.draw_labels(panel)
        if self.right_labels:
            self.draw_line_names(panel)
        self.draw_data(panel)

    def draw_data(self, panel):
        plots, data = [], []
        clamp = lambda value, axis: min(max(value, axis.low), axis.high)
        for pairs, colour, width, _, dash, marks in panel.lines:
            plots.append("'-' with %s linewidth %g dashtype %d linecolor rgb \"%s\"" % (
                "linespoints pointtype 7 pointsize 0.4" if marks else "lines", width, dash, COLOURS[colour][0]))
            data.append(pairs)
        for x, y, _, colour, filled, circled in panel.points:
            plots.append("'-' with points pointtype %d pointsize 0.75 linewidth 1.3 linecolor rgb \"%s\"" % (
                7 if filled else 6, COLOURS[colour][0]))
            data.append([(x, y)])
            if circled:
                plots.append("'-' with points pointtype 6 pointsize 1.7 linewidth 1.6 linecolor rgb \"%s\"" %
                             COLOURS["ink"][0])
                data.append([(x, y)])
        self.script.append("plot " + ", ".join(plots or ["NaN"]))
        for pairs in data:
            self.script += ["%.9g %.9g" % (clamp(x, panel.x), clamp(y, panel.y)) for x, y in pairs] + ["e"]

    def svg(self):
        self.script = [
            'set terminal svg size %d,%d font "%s,%d" background "%s" noenhanced' % (
                self.width, self.height, FONT.split(",")[0], TEXT_SIZE, COLOURS["paper"][0]),
            "set encoding utf8", "set key off", "set multiplot",
            'set grid linecolor rgb "%s" linewidth 0.6 linetype 1' % COLOURS["grid"][0],
            'set border linecolor rgb "%s"' % COLOURS["grey"][0],
            'set tics textcolor rgb "%s" nomirror scale 0.5' % COLOURS["ink"][0],
            'set xlabel textcolor rgb "%s"' % COLOURS["ink"][0], 'set ylabel textcolor rgb "%s"' % COLOURS["ink"][0]]
        for panel in self.panels:
            self.draw_panel(panel)
        script = "\n".join(self.script + ["unset multiplot", ""])
        drawn = subprocess.run(["gnuplot"], input=script.encode(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if drawn.returncode or drawn.stderr:
            raise Unreadable("gnuplot: " + drawn.stderr.decode())
        return finish(drawn.stdout.decode(), self.title)


def finish(svg, title):
    """Gives it its title, its fonts, text that stands out from lines behind it, and the colours of a dark page."""
    svg = re.sub(r"rgb\( *(\d+), *(\d+), *(\d+)\)", lambda rgb: "#%02x%02x%02x" % tuple(map(int, rgb.groups())), svg)
    svg = svg.replace(COLOURS["paper"][0].upper(), COLOURS["paper"][0])
    rules = ["[%s='%s']{%s:%s}" % (key, light, key, dark) for light, dark in COLOURS.values()
             for key in ("fill", "stroke", "color") if re.search("%s=.%s" % (key, light), svg)]
    halo = ["text{paint-order:stroke;stroke:%s;stroke-width:5px;stroke-linejoin:round}" % paper for paper in COLOURS["paper"]]
    head = "<title>%s</title>\n<style>%s @media (prefers-color-scheme: dark) {%s}</style>" % (
        title.replace("&", "&amp;").replace("<", "&lt;"), halo[0], halo[1] + "".join(rules))
    svg = re.sub(r"<title>.*?</title>\s*<desc>.*?</desc>", lambda _: head, svg, flags=re.S)
    svg = svg.replace('font-family="%s"' % FONT.split(",")[0], 'font-family="%s"' % FONT)
    return "\n".join(line.rstrip() for line in svg.splitlines() if line.strip()) + "\n"
