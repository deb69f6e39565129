#!/usr/bin/env python3
"""Writes training_ground.sdf and its meshes: the training ground, 3000 x 3000 m, module by module.

Each module has a frame of its own (origin: its start pad; X east, Y north, Z up; metres) and all of its
models are posed in it. Run in any folder: python3 make_training_ground.py
"""

import math
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "robots"))

from sdf_writer import (HEADER, Link, Surface, box, cone, cylinder, element,  # noqa: E402
                        indent, mesh, numbers, plane, pose, sphere, write_obj)

GRASS = Surface((0.85, 0.95, 0.75), "grass", 2.5, 0.0)
MEADOW = Surface((0.62, 0.72, 0.50), "grass", 12.0, 0.0)
FOREST = Surface((0.16, 0.25, 0.13), "grass", 4.0, 0.0)
LEAVES = Surface((0.22, 0.36, 0.14), "grass", 0.8, 0.0)
NEEDLES = Surface((0.12, 0.25, 0.13), "grass", 0.6, 0.0)
BARK = Surface((0.30, 0.22, 0.15), "wood", 0.5, 0.0)
ASPHALT = Surface((0.55, 0.55, 0.57), "asphalt", 2.0, 0.02)
CONCRETE = Surface((0.85, 0.84, 0.80), "concrete", 1.5, 0.02)
CONCRETE_DARK = Surface((0.50, 0.50, 0.48), "concrete", 1.5, 0.02)
BRICK = Surface((1.0, 1.0, 1.0), "brick", 0.75, 0.02)
BRICK_PALE = Surface((0.95, 0.88, 0.78), "brick", 0.9, 0.02)
WOOD = Surface((0.95, 0.85, 0.70), "wood", 0.9, 0.05)
WOOD_DARK = Surface((0.45, 0.36, 0.27), "wood", 0.9, 0.05)
METAL = Surface((0.50, 0.52, 0.54), "metal", 0.6, 0.4)
ROOF = Surface((0.38, 0.20, 0.16), "metal", 0.9, 0.1)
HAZARD = Surface((1.0, 1.0, 1.0), "hazard", 0.35, 0.1)
LINE = Surface((0.92, 0.92, 0.88), "plain", 1.0, 0.02)
YELLOW_LINE = Surface((0.90, 0.68, 0.06), "plain", 1.0, 0.02)
WHITE = Surface((0.93, 0.93, 0.90), "plain", 1.0, 0.05)
BLACK = Surface((0.03, 0.03, 0.03), "plain", 1.0, 0.05)
RED = Surface((0.62, 0.06, 0.04), "plain", 1.0, 0.15)
ORANGE = Surface((0.92, 0.28, 0.03), "plain", 1.0, 0.15)
BLUE = Surface((0.05, 0.17, 0.40), "metal", 0.7, 0.3)
GREEN = Surface((0.10, 0.28, 0.15), "metal", 0.7, 0.3)
GLASS = Surface((0.10, 0.14, 0.18), "plain", 1.0, 0.9)

ALONG_X = (0, 90, 0)
ALONG_Y = (90, 0, 0)


class Module:
    """One training area: collects its models."""

    def __init__(self, number, name, origin, size):
        self.number, self.name, self.origin, self.size = number, name, origin, size
        self.models = []

    def model(self, name, link, xyz=(0, 0, 0), heading_deg=0):
        lines = ["<static>true</static>", *pose(xyz, (0, 0, heading_deg), self.name), *link.lines()]
        self.models += element(f'model name="{name}"', lines)

    def lines(self):
        x, y = self.size
        return [f'<frame name="{self.name}">{pose(self.origin)[0]}</frame>',
                f'<eod:module id="{self.number}" name="{self.name}" frame="{self.name}" '
                f'size_x_m="{numbers([x])}" size_y_m="{numbers([y])}" start_heading_deg="0"/>',
                *self.models]


def part():
    return Link("link")


def ground():
    """Flat: 2 m cells to stand on inside the fence, 5 m cells to see, reaching out under the hills."""
    return part().visual(plane(150, 150, 5), GRASS).collision(plane(100, 100, 2))


def wall():
    """Near face at y = 0 of the model, 4 m wide, 1.2 m high, 0.25 m thick."""
    link = part().solid(box(4, 0.25, 1.2), BRICK, (0, 0.125, 0.6))
    link.visual(box(4.08, 0.33, 0.05), CONCRETE, (0, 0.125, 1.205))
    link.visual(box(4.0, 0.27, 0.10), CONCRETE_DARK, (0, 0.125, 0.05))
    return link


def gate(width):
    """Opening of `width` along Y, centred on the model; driven through along X."""
    link = part()
    for side in (-1, 1):
        y = side * (width + 0.12) / 2
        link.solid(box(0.12, 0.12, 1.4), HAZARD, (0, y, 0.7))
        link.visual(box(0.30, 0.30, 0.02), METAL, (0, y, 0.01))
        link.visual(cylinder(0.025, 0.30), METAL, (0, y, 1.55))
    link.solid(box(0.08, width + 0.24, 0.16), RED, (0, 0, 1.72))
    link.visual(box(0.085, width * 0.5, 0.09), WHITE, (0, 0, 1.72))
    return link


def board():
    """Near face at x = 0 of the model, facing +X; 1.6 m wide along Y, 1.3 m high, on two legs."""
    link = part().solid(box(0.04, 1.6, 1.3), WOOD, (-0.02, 0, 0.75))
    for radius, surface in ((0.36, WHITE), (0.27, RED), (0.18, WHITE), (0.09, RED)):
        # Rings of a target, each a little prouder than the one outside; seen only.
        proud = 0.002 + (0.36 - radius) * 0.01
        link.visual(cylinder(radius, 0.002), surface, (proud, 0, 0.85), ALONG_X)
    for side in (-1, 1):
        link.solid(box(0.06, 0.06, 1.4), WOOD_DARK, (-0.07, side * 0.65, 0.7))
        link.visual(box(0.55, 0.05, 0.05), WOOD_DARK, (-0.30, side * 0.65, 0.025))
        link.visual(box(0.05, 0.04, 0.75), WOOD_DARK, (-0.30, side * 0.65, 0.33), (0, 38, 0))
    return link


def traffic_cone():
    link = part().solid(box(0.34, 0.34, 0.03), BLACK, (0, 0, 0.015))
    link.solid(cone(0.15, 0.67), ORANGE, (0, 0, 0.365))
    link.visual(cylinder(0.088, 0.09), WHITE, (0, 0, 0.34))
    return link


def pylon():
    link = part().solid(cylinder(0.20, 0.10), CONCRETE_DARK, (0, 0, 0.05))
    link.solid(cylinder(0.09, 1.6), WHITE, (0, 0, 0.85))
    for z in (0.35, 0.85, 1.35):
        link.visual(cylinder(0.094, 0.25), RED, (0, 0, z))
    return link.visual(sphere(0.11), ORANGE, (0, 0, 1.72))


def hurdle(height):
    """Round bar across the lane, its top `height` above the ground."""
    link = part().solid(cylinder(height / 2, 2.4), METAL, (0, 0, height / 2), ALONG_X)
    for side in (-1, 1):
        link.visual(box(0.10, 0.30, height + 0.05), HAZARD, (side * 1.25, 0, (height + 0.05) / 2))
    return link


def inspection_plate(gap):
    """Acuity ring (a Landolt C, `gap` degrees from the top) behind a 0.3 m opening."""
    link = part().visual(box(0.5, 0.01, 0.5), WHITE, (0, 0.16, 1.1))
    link.visual(cylinder(0.10, 0.004), BLACK, (0, 0.153, 1.1), ALONG_Y)
    link.visual(cylinder(0.06, 0.004), WHITE, (0, 0.1505, 1.1), ALONG_Y)
    at = (0.08 * math.sin(math.radians(gap)), 0.149, 1.1 + 0.08 * math.cos(math.radians(gap)))
    link.visual(box(0.04, 0.004, 0.06), WHITE, at, (0, gap, 0))
    for x, z, w, h in ((-0.25, 1.1, 0.2, 0.7), (0.25, 1.1, 0.2, 0.7), (0, 1.35, 0.3, 0.2),
                       (0, 0.85, 0.3, 0.2)):
        link.solid(box(w, 0.03, h), METAL, (x, 0, z))
    for side in (-1, 1):
        link.solid(box(0.06, 0.06, 0.75), METAL, (side * 0.30, 0.05, 0.375))
    return link


def crate(size):
    link = part().solid(box(size, size, size), WOOD, (0, 0, size / 2))
    for z in (0.05, size - 0.05):
        link.visual(box(size + 0.03, size + 0.03, 0.07), WOOD_DARK, (0, 0, z))
    for side in (-1, 1):
        link.visual(box(0.07, size + 0.02, size), WOOD_DARK, (side * size * 0.46, 0, size / 2))
    return link


def barrel(surface):
    link = part().solid(cylinder(0.29, 0.88), surface, (0, 0, 0.44))
    for z in (0.03, 0.30, 0.60, 0.86):
        link.visual(cylinder(0.30, 0.03), METAL, (0, 0, z))
    return link


def container():
    """A 20-foot shipping container: 6.06 x 2.44 x 2.59 m, ribbed."""
    link = part().solid(box(6.06, 2.44, 2.59), BLUE, (0, 0, 1.295))
    for i in range(19):
        x = -2.7 + i * 0.30
        link.visual(box(0.12, 2.50, 2.25), BLUE, (x, 0, 1.295))
    for x in (-3.0, 3.0):
        for y in (-1.19, 1.19):
            link.visual(box(0.14, 0.14, 2.62), METAL, (x, y, 1.31))
    for y in (-0.75, -0.25, 0.25, 0.75):
        link.visual(cylinder(0.02, 2.3), METAL, (3.06, y, 1.30))
    return link.visual(box(0.01, 1.2, 0.35), WHITE, (3.04, 0, 2.0))


def building():
    """Training house, 8 x 6 m: four walls with a door and windows, a gable roof."""
    link = part().solid(box(8, 6, 3), BRICK_PALE, (0, 0, 1.5))
    link.visual(box(8.1, 6.1, 0.35), CONCRETE_DARK, (0, 0, 0.175))
    for side in (-1, 1):
        link.visual(box(8.8, 3.75, 0.12), ROOF, (0, side * 1.62, 3.72), (side * -25, 0, 0))
        # The gables: three steps of wall under the roof.
        for step in range(3):
            link.visual(box(0.24, 4.6 - 1.7 * step, 0.45), BRICK_PALE,
                        (side * 3.88, 0, 3.2 + 0.42 * step))
    link.visual(box(0.6, 0.6, 1.5), BRICK, (2.2, 0.9, 4.4))
    for x in (-2.6, 2.6):
        for side in (-1, 1):
            link.visual(box(1.5, 0.06, 1.2), WHITE, (x, side * 3.0, 1.75))
            link.visual(box(1.3, 0.08, 1.0), GLASS, (x, side * 3.0, 1.75))
            link.visual(box(0.06, 0.10, 1.0), WHITE, (x, side * 3.0, 1.75))
    link.visual(box(1.15, 0.06, 2.2), WHITE, (0, -3.0, 1.1))
    link.visual(box(0.95, 0.08, 2.05), GREEN, (0, -3.0, 1.03))
    link.visual(sphere(0.04), METAL, (0.36, -3.06, 1.05))
    for y in (-1.5, 1.5):
        link.visual(box(0.06, 1.4, 1.2), WHITE, (4.0, y, 1.75))
        link.visual(box(0.08, 1.2, 1.0), GLASS, (4.0, y, 1.75))
    link.solid(box(2.0, 1.0, 0.02), CONCRETE, (0, -3.5, 0.01))
    return link


def fence(half):
    """Posts every 5 m, two rails and a plinth; isectors meet one slab a side."""
    link = part()
    count = int(2 * half / 5)
    for turn in range(4):
        angle = turn * 90
        c, s = round(math.cos(math.radians(angle))), round(math.sin(math.radians(angle)))

        def at(x, y, z, c=c, s=s):
            return (c * x - s * y, s * x + c * y, z)

        for i in range(count):
            link.visual(box(0.09, 0.09, 1.9), WOOD_DARK, at(-half + 5 * i, half, 0.95))
        for z in (0.55, 1.05, 1.55):
            link.visual(box(2 * half, 0.04, 0.14), WOOD, at(0, half, z), (0, 0, angle))
        link.collision(box(2 * half, 0.10, 1.9), at(0, half, 0.95), (0, 0, angle))
    return link


def broadleaf(scale, rng):
    link = part().solid(cylinder(0.16 * scale, 2.2 * scale), BARK, (0, 0, 1.1 * scale))
    for dx, dy, dz, r in ((0, 0, 3.3, 1.35), (0.8, 0.2, 2.8, 0.9), (-0.6, 0.5, 2.9, 0.95),
                          (-0.1, -0.8, 2.7, 0.85)):
        link.visual(sphere(r * scale), LEAVES,
                    (dx * scale, dy * scale, (dz + rng.uniform(-0.1, 0.1)) * scale))
    return link


def conifer(scale):
    link = part().solid(cylinder(0.13 * scale, 1.2 * scale), BARK, (0, 0, 0.6 * scale))
    for z, radius, length in ((1.7, 1.35, 1.9), (2.9, 1.05, 1.8), (4.0, 0.72, 1.6)):
        link.visual(cone(radius * scale, length * scale), NEEDLES, (0, 0, z * scale))
    return link


def lanes():
    """What is painted or paved: seen only, the ground beneath stays flat. Higher layers lie on lower
    ones by 4 mm, so that no two fight for a pixel."""
    link = part()

    def pave(surface, x, y, width, depth, layer):
        link.visual(box(width, depth, 0.02), surface, (x, y, 0.004 * layer - 0.01))

    pave(ASPHALT, -4.2, 1.9, 11.4, 2.4, 1)  # the path to gate and board
    pave(ASPHALT, 8, 0, 2.4, 30, 1)  # slalom
    pave(ASPHALT, -24, 0, 2.4, 30, 1)  # hurdles
    pave(ASPHALT, -13, -8, 14, 2.4, 1)  # narrow gates
    pave(CONCRETE, 0, 0, 3.0, 3.0, 2)  # start pad
    pave(CONCRETE_DARK, 0, 3.0, 5.0, 2.4, 2)  # apron of the wall
    for side in (-1, 1):
        pave(YELLOW_LINE, side * 1.42, 0, 0.10, 2.94, 3)
        pave(YELLOW_LINE, 0, side * 1.42, 2.74, 0.10, 3)
        pave(LINE, 8 + side * 1.15, 0, 0.08, 30, 2)
        pave(LINE, -24 + side * 1.15, 0, 0.08, 30, 2)
        pave(LINE, -13, -8 + side * 1.15, 14, 0.08, 2)
    pave(LINE, -5.8, 0.75, 8.2, 0.08, 3)
    pave(LINE, -5.8, 3.05, 8.2, 0.08, 3)
    for x in (-2.4, -3.2, -4.8, -5.6, -6.4):
        pave(LINE, x, 1.9, 0.45, 0.08, 3)
    pave(RED, -7.66, 1.9, 0.06, 1.6, 2)  # 0.30 m and a hand's width before the board
    pave(LINE, 0, 0.9, 0.08, 0.5, 3)  # arrow on the pad: forward is north
    link.visual(box(0.08, 0.36, 0.02), LINE, (0.1, 1.1, 0.012 - 0.01), (0, 0, 45))
    link.visual(box(0.08, 0.36, 0.02), LINE, (-0.1, 1.1, 0.012 - 0.01), (0, 0, -45))
    return link


def flat():
    """Module 1: driving, gates, stopping. Others rely on wall, gate_1 and board as they stand."""
    rng = random.Random(1)
    yard = Module(1, "flat", (-1000, 1000, 0), (100, 100))
    yard.model("ground", ground())
    yard.model("lanes", lanes())
    yard.model("wall", wall(), (0, 4.0, 0))
    yard.model("gate_1", gate(1.2), (-4.0, 1.9, 0))
    yard.model("board", board(), (-8.0, 1.9, 0))
    yard.model("gate_2", gate(1.0), (-11, -8, 0))
    yard.model("gate_3", gate(0.9), (-16, -8, 0))
    for i in range(6):
        yard.model(f"cone_{i + 1}", traffic_cone(), (8, -5 + 2 * i, 0))
    for i, y in enumerate((-12.5, 12.5)):
        yard.model(f"pylon_{i + 1}", pylon(), (16, y, 0))
    yard.model("hurdle_1", hurdle(0.10), (-24, -4, 0))
    yard.model("hurdle_2", hurdle(0.20), (-24, 4, 0))
    for i, gap in enumerate((0, 90, 225, 180, 315)):
        yard.model(f"plate_{i + 1}", inspection_plate(gap), (-12 + 6 * i, 20, 0))
    for i, (x, y, size, heading) in enumerate(((-5.2, 7.6, 0.9, 12), (-4.1, 7.9, 0.7, -20),
                                               (4.6, 6.4, 0.8, 35), (-13.5, 5.4, 0.9, 8))):
        yard.model(f"crate_{i + 1}", crate(size), (x, y, 0), heading)
    for i, (x, y, surface) in enumerate(((5.6, 7.0, BLUE), (6.2, 6.6, ORANGE), (-12.4, 5.9, GREEN),
                                         (-12.6, -1.6, ORANGE))):
        yard.model(f"barrel_{i + 1}", barrel(surface), (x, y, 0), 40 * i)
    yard.model("container", container(), (-19.5, 9.5, 0), 65)
    yard.model("building", building(), (-21, 26, 0), 35)
    yard.model("shed", building(), (-38, -16, 0), 90)
    yard.model("fence", fence(50))
    spots = [(-9, 34), (4, 38), (17, 33), (27, 24), (34, 8), (-34, 33), (-42, 12), (-40, 2), (-31, -6),
             (-45, -30), (-20, -34), (0, -38), (22, -30), (40, -22), (12, 44), (-3, 27), (38, 38)]
    for i, (x, y) in enumerate(spots):
        scale = rng.uniform(0.9, 1.5)
        tree = conifer(scale) if i % 3 == 1 else broadleaf(scale, rng)
        yard.model(f"tree_{i + 1}", tree, (x, y, 0), rng.uniform(0, 360))
    yard.model("hills", part().visual(mesh("meshes/hills.obj"), MEADOW))
    yard.model("forest", part().visual(mesh("meshes/forest.obj"), FOREST))
    return yard


def hill_height(radius, angle):
    """Height of the land round the yard: below the grass at 60 m, hills from 120 m on."""
    rise = max(0.0, radius - 110) ** 1.35 * 0.028
    waves = 1 + 0.45 * math.sin(3 * angle + 0.6) + 0.3 * math.sin(7 * angle + 2) + \
        0.12 * math.sin(17 * angle)
    near = -0.6 + 0.6 * min(1.0, (radius - 55) / 25)
    return near + rise * max(0.15, waves)


def write_hills(path):
    radii = [55, 80, 110, 140, 180, 230, 290, 360, 450]
    sides = 72
    corners = []
    for radius in radii:
        for i in range(sides):
            angle = 2 * math.pi * i / sides
            corners.append((radius * math.cos(angle), radius * math.sin(angle),
                            hill_height(radius, angle)))
    faces = []
    for ring in range(len(radii) - 1):
        for i in range(sides):
            a, b = ring * sides + i, ring * sides + (i + 1) % sides
            faces.append([a, a + sides, b + sides, b])
    write_obj(path, corners, faces)


def write_forest(path):
    """Firs on the slopes, five-sided, in clumps; too far off for more."""
    rng = random.Random(7)
    corners, faces = [], []
    while len(faces) < 2600:
        angle, radius = rng.uniform(0, 2 * math.pi), rng.uniform(72, 300)
        if math.sin(4 * angle + radius / 60) + rng.uniform(-0.6, 0.6) < 0.15:
            continue
        height, width = rng.uniform(6, 12), rng.uniform(1.6, 2.8)
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        z = hill_height(radius, angle) - 0.3
        first = len(corners)
        for i in range(5):
            a = 2 * math.pi * i / 5 + angle
            corners.append((x + width * math.cos(a), y + width * math.sin(a), z + 0.08 * height))
        corners.append((x, y, z + height))
        faces += [[first + i, first + (i + 1) % 5, first + 5] for i in range(5)]
    write_obj(path, corners, faces)


def main():
    write_hills(HERE / "meshes" / "hills.obj")
    write_forest(HERE / "meshes" / "forest.obj")
    lines = [
        "<scene>", "  <ambient>0.42 0.46 0.52 1</ambient>", "  <background>0.45 0.62 0.85 1</background>",
        "  <fog><color>0.74 0.79 0.84 1</color><density>0.005</density></fog>", "</scene>",
        '<light name="sun" type="directional">', "  <direction>-0.45 0.52 -0.72</direction>",
        "  <diffuse>1 0.95 0.86 1</diffuse>", "  <cast_shadows>true</cast_shadows>", "</light>",
        *flat().lines()]
    world = element('world name="training_ground"', lines)
    text = HEADER.format(script="sim/worlds/make_training_ground.py") + "\n".join(indent(world))
    (HERE / "training_ground.sdf").write_text(text + "\n</sdf>\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
