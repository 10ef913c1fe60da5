# SPDX-License-Identifier: Apache-2.0
"""Panels of curves over a logarithmic axis, side by side over one linear axis, as SVG."""
import math
from html import escape
from typing import NamedTuple

WIDTH, HEIGHT = 440, 300  # of a panel's frame
LEFT, TOP, GAP, BOTTOM = 64, 24, 48, 52
TITLES = 20  # above the frames, for the legend
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7"]  # told apart by all eyes (Okabe and Ito)
INK, RULE = "#222", "#ddd"


class Point(NamedTuple):
    x: float
    y: float
    label: str


class Panel:
    """`curves`: {name: [Point]}, on an axis with these ticks from end to end. Labels stand above their points, of the last curve below."""

    def __init__(self, title, ticks, curves):
        self.title, self.ticks, self.curves = title, ticks, curves

    def place(self, x):
        first, last = math.log(self.ticks[0]), math.log(self.ticks[-1])
        return (math.log(x) - first) / (last - first) * WIDTH


def text(x, y, words, anchor="middle", colour=INK, size=12):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" font-size="{size}">{escape(words)}</text>'


def line(points, colour, width=1.0, dash=""):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{dashes}/>'


def dot(x, y, colour):
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>'


class Plot:
    """`levels`: ticks of the common axis, from 0. `floor`: (y, label) of a dashed line, or none."""

    def __init__(self, axis, levels, panels, floor=None):
        self.axis, self.levels, self.panels, self.floor = axis, levels, panels, floor

    def height(self, y):
        return HEIGHT * (1 - y / self.levels[-1])

    def frame(self, panel, first):
        for y in self.levels:
            yield line([(0, self.height(y)), (WIDTH, self.height(y))], RULE)
            if first:
                yield text(-8, self.height(y) + 4, f"{y:g}", "end")
        for x in panel.ticks:
            yield line([(panel.place(x), 0), (panel.place(x), HEIGHT)], RULE)
            yield text(panel.place(x), HEIGHT + 18, f"{x:g}")
        yield text(WIDTH / 2, HEIGHT + 38, panel.title)

    def curve(self, panel, points, colour, below):
        placed = [p._replace(x=panel.place(p.x), y=self.height(p.y)) for p in points]
        yield line([(p.x, p.y) for p in placed], colour, 2)
        for p in placed:
            yield dot(p.x, p.y, colour)
            yield text(p.x + (0 if below else 7), p.y + (18 if below else -6), p.label, "start", colour, 11)

    def panel(self, index):
        panel = self.panels[index]
        parts = [*self.frame(panel, index == 0)]
        if self.floor:
            y = self.height(self.floor[0])
            parts += [line([(0, y), (WIDTH, y)], INK, 1, "5 4"), text(WIDTH - 4, y - 5, self.floor[1], "end", INK, 11)]
        for i, (points, colour) in enumerate(zip(panel.curves.values(), COLOURS)):
            parts += self.curve(panel, points, colour, below=i + 1 == len(panel.curves))
        x = LEFT + index * (WIDTH + GAP)
        return f'<g transform="translate({x} {TOP + TITLES})">' + "\n".join(parts) + "</g>"

    def legend(self):
        for i, (name, colour) in enumerate(zip(self.panels[0].curves, COLOURS)):
            yield dot(LEFT + 6 + 130 * i, TOP - 6, colour)
            yield text(LEFT + 16 + 130 * i, TOP - 2, name, "start", INK, 13)

    def svg(self):
        width = LEFT + len(self.panels) * (WIDTH + GAP)
        height = TOP + TITLES + HEIGHT + BOTTOM
        middle = TOP + TITLES + HEIGHT / 2
        axis = f'<g transform="rotate(-90 18 {middle})">{text(18, middle, self.axis)}</g>'
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif">'
        background = f'<rect width="{width}" height="{height}" fill="white"/>'
        panels = [self.panel(i) for i in range(len(self.panels))]
        return "\n".join([head, background, axis, *self.legend(), *panels, "</svg>\n"])
