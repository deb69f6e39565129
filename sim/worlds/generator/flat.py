"""Module 1, flat: driving, gates, stopping."""

import math
import random

from sdf_writer import box, cylinder, mesh, plane, sphere

from .furniture import (barrel, broadleaf, building, conifer, container, crate, hurdle,
                        traffic_cone)
from .gathered import Gathered
from .module import Module, part
from .scenery import fence
from .solid import Solid
from .surfaces import (ALONG_X, ALONG_Y, ASPHALT, BLACK, BLUE, BRICK, CONCRETE, CONCRETE_DARK, FOREST,
                       GRASS, GREEN, HAZARD, LINE, MEADOW, METAL, ORANGE, RED, WHITE, WOOD, WOOD_DARK,
                       YELLOW_LINE)


GAPS = ((-12, 0.20), (0, 0.40))  # y where it begins, width


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


def gap_decks(width):
    """Two decks 0.30 high and 1.2 m long with a gap between them, a ramp of 1.6 m before and behind; driven
    along Y, begins at y = 0."""
    whole, x, height, ramp, deck = Gathered(), (-1.2, 1.2), 0.30, 1.6, 1.2
    far = 2 * (ramp + deck) + width
    wood = Solid().wedge(x, (0, ramp), height).wedge(x, (far - ramp, far), -height)
    for y in (ramp, far - ramp - deck):
        wood.box(x, (y, y + deck), (0, height), without=("-z",))
    whole.of("wood", WOOD).add(wood)
    whole.body.add(wood)
    for edge in ((ramp + deck - 0.08, ramp + deck), (far - ramp - deck, far - ramp - deck + 0.08)):
        whole.of("edge", HAZARD).floor(x, edge, height + 0.004)
    return whole


def pylon():
    link = part().solid(cylinder(0.20, 0.10), CONCRETE_DARK, (0, 0, 0.05))
    link.solid(cylinder(0.09, 1.6), WHITE, (0, 0, 0.85))
    for z in (0.35, 0.85, 1.35):
        link.visual(cylinder(0.094, 0.25), RED, (0, 0, z))
    return link.visual(sphere(0.11), ORANGE, (0, 0, 1.72))


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


def flat(folder):
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
    for y, width in GAPS:
        gap_decks(width).stand(yard, f"gap_{round(100 * width)}", folder, (25, y, 0))
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
    yard.model("fence", fence(50, "fence_50", folder))
    spots = [(-9, 34), (4, 38), (17, 33), (27, 24), (34, 8), (-34, 33), (-42, 12), (-40, 2), (-31, -6),
             (-45, -30), (-20, -34), (0, -38), (22, -30), (40, -22), (12, 44), (-3, 27), (38, 38)]
    for i, (x, y) in enumerate(spots):
        scale = rng.uniform(0.9, 1.5)
        tree = conifer(scale) if i % 3 == 1 else broadleaf(scale, rng)
        yard.model(f"tree_{i + 1}", tree, (x, y, 0), rng.uniform(0, 360))
    yard.model("hills", part().visual(mesh("meshes/hills.obj"), MEADOW))
    yard.model("forest", part().visual(mesh("meshes/forest.obj"), FOREST))
    return yard
