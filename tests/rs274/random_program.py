#!/usr/bin/env python3
"""Writes a random program of the common core, the same one for the same seed.

    random_program.py SEED [BLOCKS] > programs/random_SEED.ngc

Blocks mix everything that LinuxCNC and Kadr should read alike: motions in all planes, both
dimensions and units, arcs by centre and by radius, offsets, feeds, spindle, tools. The generator
knows where the tool stands, so that every arc closes.
"""

import math
import random
import sys

PLANES = {17: "XYZ", 18: "ZXY", 19: "YZX"}  # first, second, third axis
CENTRES = {"X": "I", "Y": "J", "Z": "K"}


class Program:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines = []
        self.at = {}            # X Y Z in the work system, unit of the text; empty: not known
        self.plane = 17
        self.is_incremental = False
        self.is_inch = False
        self.motion = 0
        self.tool_number = 0

    def block(self, *words):
        words = list(words)
        if self.random.random() < 0.2:
            words.append("(" + self.random.choice(["check", "X1", "G0", "*"]) + ")")
        self.lines.append(f"N{10 * (len(self.lines) + 1)} " + " ".join(words))

    def coordinate(self):
        span = 5 if self.is_inch else 120
        return round(self.random.uniform(-span, span), self.random.choice([0, 1, 3, 4]))

    def number(self, value):
        text = f"{value:.6f}".rstrip("0").rstrip(".")
        return "0" if text in ("-0", "") else text

    def target(self, to):
        """Words of a target; remembers what the control will have read."""
        words = []
        for axis in to:
            text = self.number(to[axis] - self.at[axis] if self.is_incremental else to[axis])
            value = float(text)
            self.at[axis] = self.at[axis] + value if self.is_incremental else value
            words.append(axis + text)
        self.random.shuffle(words)
        return words

    def motion_word(self, code):
        is_needed = code != self.motion or self.random.random() < 0.3
        self.motion = code
        return [f"G{code}"] if is_needed else []

    def feed_word(self, chance=0.3):
        if self.random.random() >= chance:
            return []
        return [f"F{self.random.choice([40, 120.5, 300, 12.25])}"]

    # ------------------------------------------------------------ blocks

    def everywhere(self):
        """After a change of the system: all axes by coordinate, so that the place is known."""
        self.is_incremental = False
        self.at = {axis: 0.0 for axis in "XYZ"}
        to = {axis: self.coordinate() for axis in "XYZ"}
        code = self.random.choice([0, 1]) if len(self.lines) > 1 else 0
        self.motion = code
        self.block("G90", f"G{code}", *self.target(to))

    def straight(self):
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        code = self.random.choice([0, 1, 1])
        words = self.motion_word(code)
        target = self.target({axis: self.coordinate() for axis in axes})
        self.block(*words, *target, *self.feed_word())

    def arc_about_centre(self):
        first, second, third = PLANES[self.plane]
        radius = self.random.uniform(0.2, 3) if self.is_inch else self.random.uniform(2, 60)
        start = self.random.uniform(-math.pi, math.pi)
        i = float(self.number(-radius * math.cos(start)))
        j = float(self.number(-radius * math.sin(start)))
        center = (self.at[first] + i, self.at[second] + j)
        radius = math.hypot(i, j)
        end = self.random.uniform(-math.pi, math.pi)
        to = {first: center[0] + radius * math.cos(end),
              second: center[1] + radius * math.sin(end)}
        if self.random.random() < 0.15:
            to = {}  # a full circle
        if self.random.random() < 0.3:
            to[third] = self.coordinate()
        words = self.motion_word(self.random.choice([2, 3]))
        target = self.target(to)
        centre = [CENTRES[first] + self.number(i), CENTRES[second] + self.number(j)]
        self.block(*words, *target, *centre, *self.feed_word())

    def arc_by_radius(self):
        first, second, third = PLANES[self.plane]
        to = {first: self.coordinate(), second: self.coordinate()}
        half = math.hypot(to[first] - self.at[first], to[second] - self.at[second]) / 2
        if half < 0.01:
            return
        radius = half * self.random.uniform(1.05, 3) * self.random.choice([1, 1, -1])
        if self.random.random() < 0.3:
            to[third] = self.coordinate()
        words = self.motion_word(self.random.choice([2, 3]))
        self.block(*words, *self.target(to), "R" + self.number(radius), *self.feed_word())

    def dimensions(self):
        self.is_incremental = not self.is_incremental
        self.block("G91" if self.is_incremental else "G90")

    def change_plane(self):
        self.plane = self.random.choice([17, 18, 19])
        self.block(f"G{self.plane}")

    def change_units(self):
        self.no_length()  # rs274 on its own mistakes the unit of an active length
        self.is_inch = not self.is_inch
        self.block("G20" if self.is_inch else "G21")
        self.block(f"F{self.random.choice([5, 10])}")
        self.everywhere()

    def work_offset(self):
        self.block(f"G{self.random.randint(54, 59)}")
        self.everywhere()

    def set_position(self):
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        self.block("G92", *(axis + self.number(self.coordinate()) for axis in axes))
        self.everywhere()

    def tool(self):
        number = self.random.choice([n for n in (1, 2, 3) if n != self.tool_number])
        self.tool_number = number
        self.everywhere()  # behind an arc, gcode.parse forgets at M6 where it is
        self.block("M5")
        self.block(f"T{number}", "M6")
        self.block("G90", "G0", "G43", f"H{number}", "Z" + self.number(self.coordinate()))
        self.motion = 0
        self.everywhere()

    def no_length(self):
        self.block("G90", "G0", "G49", "Z" + self.number(self.coordinate()))
        self.motion = 0
        self.everywhere()

    def machine_coordinates(self):
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        self.block("G90", "G0", "G53", *(axis + self.number(self.coordinate()) for axis in axes))
        self.everywhere()

    def spindle(self):
        speed = f"S{self.random.randint(100, 6000)}"
        self.block(*self.random.choice([[speed, "M3"], [speed, "M4"], ["M5"], [speed]]))

    def others(self):
        self.block(*self.random.choice([["M8"], ["M9"], ["G4", "P0.25"], ["M0"], ["M1"], ["F77"]]))

    def write(self, blocks):
        kinds = {
            self.straight: 30, self.arc_about_centre: 20, self.arc_by_radius: 12,
            self.dimensions: 8, self.change_plane: 5, self.change_units: 2,
            self.work_offset: 3, self.set_position: 2, self.machine_coordinates: 2,
            self.tool: 2, self.no_length: 1, self.spindle: 4, self.others: 4,
        }
        self.block("G17", "G21", "G40", "G49", "G54", "G90", "G94", "F100", "S500", "M3")
        self.everywhere()
        while len(self.lines) < blocks:
            self.random.choices(list(kinds), list(kinds.values()))[0]()
        self.block("M30")
        return self.lines


def main():
    seed = int(sys.argv[1])
    blocks = int(sys.argv[2]) if len(sys.argv) > 2 else 80
    print(f"(random blocks of the common core, seed {seed})")
    print("\n".join(Program(seed).write(blocks)))


main()
