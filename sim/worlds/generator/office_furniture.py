"""What stands in offices. Origin on the floor; whoever uses it sits or stands towards -Y."""

import math
import random

from .assembly import Assembly, turned
from .solid import Solid
from .surfaces import (BLACK, BLUE, BOOKS, CHAIR_BLACK, CHAIR_BLUE, CORK, DESK_TOP, DOOR_WOOD, EARTH, GREY, LAMINATE,
                       METAL, NOTE, ORANGE, PLANT, POT, RACK, RED, SCREEN, SCREEN_LIT, STEEL, WHITE, WOOD)

KNEE, DESK_HEIGHT = 0.65, 0.75
DESK_DEPTH = 0.80
RACK_WIDTH, RACK_DEPTH, RACK_HEIGHT = 0.60, 1.00, 2.00


def monitor(width=0.54):
    """On a desk's top at z = 0, screen towards -Y."""
    thing = Assembly()
    thing.show(BLACK, (-0.12, 0.12), (-0.05, 0.11), (0, 0.015)).show(
        BLACK, (-0.03, 0.03), (0.04, 0.07), (0, 0.25), without=("-z", "+z"))
    thing.show(BLACK, (-width / 2, width / 2), (0, 0.04), (0.12, 0.46))
    thing.panel(SCREEN_LIT, (-width / 2 + 0.015, width / 2 - 0.015), -0.002, (0.14, 0.445))
    for look, x, z, w, h in ((WHITE, -0.10, 0.27, 0.26, 0.22), (BLUE, 0.14, 0.36, 0.16, 0.10), (NOTE, 0.14, 0.22, 0.16, 0.12)):
        thing.panel(look, (x - w / 2, x + w / 2), -0.004, (z - h / 2, z + h / 2))
    return thing


def drawer_unit():
    thing = Assembly().box(LAMINATE, (-0.20, 0.20), (-0.30, 0.30), (0.03, 0.60))
    for i in range(3):
        z = 0.05 + 0.18 * i
        thing.panel(GREY, (-0.19, 0.19), -0.302, (z, z + 0.165)).panel(STEEL, (-0.06, 0.06), -0.304, (z + 0.11, z + 0.125))
    return thing


def desk(width=1.60, screens=1, drawers=0, seed=0):
    """Top at 0.75, knee space 0.65 high between side panels; drawers: -1 left, 1 right, 0 none."""
    rng = random.Random(seed)
    half, front, back = width / 2, -DESK_DEPTH / 2, DESK_DEPTH / 2
    thing = Assembly().box(DESK_TOP, (-half, half), (front, back), (DESK_HEIGHT - 0.03, DESK_HEIGHT))
    thing.box(LAMINATE, (-half + 0.05, half - 0.05), (front + 0.02, back - 0.02), (KNEE, DESK_HEIGHT - 0.03))
    for side in (-1, 1):
        thing.box(LAMINATE, (side * (half - 0.05), side * (half - 0.02)), (front + 0.03, back - 0.03),
                  (0, DESK_HEIGHT - 0.03))
    thing.box(LAMINATE, (-half + 0.05, half - 0.05), (back - 0.06, back - 0.04), (0.22, KNEE))
    if drawers:
        thing.put(drawer_unit(), (drawers * (half - 0.28), -0.02, 0))
    top = DESK_HEIGHT
    for i in range(screens):
        x = (i - (screens - 1) / 2) * 0.60
        thing.put(monitor(), (x, 0.12, top), -12 * (i - (screens - 1) / 2))
    thing.met.box((-0.3 * screens, 0.3 * screens), (0.08, 0.20), (top, top + 0.46))
    thing.show(BLACK, (-0.22, 0.22), (-0.24, -0.10), (top, top + 0.02), without=("-z",))
    thing.pave(GREY, (-0.205, 0.205), (-0.228, -0.112), top + 0.022)
    thing.show(BLACK, (0.30, 0.36), (-0.22, -0.12), (top, top + 0.03), without=("-z",))
    for i in range(2):
        x, y, turn = -half + 0.22 + 0.04 * i, rng.uniform(-0.15, 0.15), rng.uniform(-25, 25)
        sheet = Assembly().show(WHITE, (-0.105, 0.105), (-0.148, 0.148), (0, 0.006 + 0.012 * i), without=("-z",))
        thing.put(sheet, (x, y, top + 0.0015 * i), turn)
    look = rng.choice((RED, BLUE, ORANGE, WHITE))
    thing.round(look, (half - 0.18, rng.uniform(-0.1, 0.2)), 0.04, (top, top + 0.10), 6)
    return thing


def office_chair(surface=CHAIR_BLACK):
    """Faces +Y, towards the desk."""
    thing = Assembly()
    for i in range(5):
        spoke = Solid().box((-0.025, 0.025), (0.02, 0.30), (0.02, 0.075), without=("-y", "-z"))
        thing.of(BLACK).add(spoke, turned((0, 0, 0), 72 * i))
    thing.round(STEEL, (0, 0), 0.03, (0.06, 0.44), 6)
    thing.show(surface, (-0.24, 0.24), (-0.24, 0.24), (0.43, 0.51))
    thing.show(surface, (-0.22, 0.22), (-0.29, -0.23), (0.60, 1.05)).show(BLACK, (-0.03, 0.03), (-0.28, -0.22), (0.40, 0.65))
    for side in (-1, 1):
        thing.show(BLACK, (side * 0.25, side * 0.30), (-0.16, 0.14), (0.66, 0.69))
        thing.show(BLACK, (side * 0.26, side * 0.29), (-0.04, 0.0), (0.46, 0.66), without=("-z", "+z"))
    thing.met.box((-0.24, 0.24), (-0.29, 0.24), (0.02, 1.05))
    return thing


def visitor_chair(surface=CHAIR_BLUE):
    """Four legs; faces +Y."""
    thing = Assembly()
    for x in (-0.21, 0.19):
        for y in (-0.22, 0.19):
            thing.show(STEEL, (x, x + 0.025), (y, y + 0.025), (0, 0.80 if y < 0 else 0.43))
    thing.show(surface, (-0.23, 0.23), (-0.20, 0.23), (0.43, 0.48))
    thing.show(surface, (-0.22, 0.22), (-0.235, -0.195), (0.52, 0.84))
    thing.met.box((-0.23, 0.23), (-0.235, 0.23), (0, 0.84))
    return thing


def cabinet(width=0.80, height=1.10, surface=LAMINATE):
    thing = Assembly().box(surface, (-width / 2, width / 2), (-0.21, 0.22), (0.05, height))
    thing.box(BLACK, (-width / 2 + 0.02, width / 2 - 0.02), (-0.18, 0.22), (0, 0.05))
    for side in (-1, 1):
        thing.panel(GREY if surface is not GREY else METAL, sorted((side * 0.004, side * (width / 2 - 0.01))), -0.213,
                    (0.07, height - 0.02))
        thing.panel(STEEL, sorted((side * 0.03, side * 0.045)), -0.216, (height * 0.5, height * 0.5 + 0.14))
    return thing


def bookshelf(width=0.90, rows=5, seed=0):
    """Boards every 0.35 m with books and files, open towards -Y."""
    rng = random.Random(seed)
    height = 0.35 * rows + 0.06
    thing = Assembly()
    for side in (-1, 1):
        thing.show(WOOD, (side * (width / 2 - 0.02), side * width / 2), (-0.16, 0.16), (0, height))
    thing.show(WOOD, (-width / 2, width / 2), (0.14, 0.16), (0, height), without=("+y",))
    for i in range(rows + 1):
        thing.show(WOOD, (-width / 2 + 0.02, width / 2 - 0.02), (-0.16, 0.14), (0.35 * i, 0.35 * i + 0.02))
    for i in range(rows):
        start = -width / 2 + 0.03 + rng.uniform(0, 0.12)
        end = width / 2 - 0.03 - rng.choice((0.0, 0.1, 0.3))
        thing.show(BOOKS, (start, end), (-0.11, 0.13), (0.35 * i + 0.02, 0.35 * i + 0.31), without=("-z", "+y"))
    thing.met.box((-width / 2, width / 2), (-0.16, 0.16), (0, height))
    return thing


def whiteboard(width=1.8):
    """On the wall at y = 0, from 0.95 to 2.0."""
    thing = Assembly().show(STEEL, (-width / 2 - 0.02, width / 2 + 0.02), (-0.02, 0), (0.93, 2.02), without=("+y",))
    thing.show(WHITE, (-width / 2, width / 2), (-0.024, -0.02), (0.95, 2.0), without=("+y",))
    thing.show(STEEL, (-width / 2 + 0.2, width / 2 - 0.2), (-0.08, -0.024), (0.93, 0.95))
    strokes = ((-0.6, 1.75, 0.7), (-0.6, 1.65, 0.5), (-0.6, 1.55, 0.62), (-0.6, 1.35, 0.4), (-0.6, 1.25, 0.55))
    for i, (x, z, length) in enumerate(strokes):
        thing.panel((BLUE, BLACK, BLACK, RED, BLACK)[i], (x, x + length), -0.0255, (z, z + 0.018))
    for x, z, w, h in ((0.25, 1.30, 0.18, 0.35), (0.45, 1.30, 0.12, 0.50), (0.60, 1.30, 0.10, 0.22)):
        thing.panel(RED if h > 0.4 else BLUE, (x, x + w - 0.04), -0.0255, (z, z + h))
    return thing


def notice_board():
    """On the wall at y = 0."""
    thing = Assembly().show(WOOD, (-0.62, 0.62), (-0.02, 0), (1.18, 2.02), without=("+y",))
    thing.panel(CORK, (-0.59, 0.59), -0.022, (1.21, 1.99))
    for i, (x, z) in enumerate(((-0.42, 1.62), (-0.12, 1.66), (0.20, 1.58), (0.44, 1.70), (-0.30, 1.30), (0.12, 1.28))):
        thing.panel((WHITE, NOTE, WHITE, RED, WHITE, LAMINATE)[i], (x - 0.10, x + 0.10), -0.025, (z - 0.13, z + 0.13))
    return thing


def plant(height=1.4, seed=1):
    rng = random.Random(seed)
    thing = Assembly().round(POT, (0, 0), 0.15, (0, 0.36), 8, top_radius=0.21)
    thing.round(EARTH, (0, 0), 0.18, (0.355, 0.365), 8)
    leaves = thing.of(PLANT)
    for i in range(12):
        angle = 2 * math.pi * i / 12 + rng.uniform(-0.2, 0.2)
        rise, reach = rng.uniform(0.45, 1.0) * (height - 0.36), rng.uniform(0.22, 0.48)
        out, side = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))

        def at(along, across, z, out=out, side=side):
            return (out[0] * along + side[0] * across, out[1] * along + side[1] * across, z)

        low, wide = 0.36, 0.05 + 0.03 * rng.random()
        middle, bend = low + rise * 0.7, low + rise
        quads = ((at(0.02, -0.01, low), at(0.02, 0.01, low), at(reach * 0.45, wide, middle), at(reach * 0.45, -wide, middle)),
                 (at(reach * 0.45, -wide, middle), at(reach * 0.45, wide, middle), at(reach, 0.008, bend), at(reach, -0.008, bend)))
        for quad in quads:
            leaves.face(*quad).face(*reversed(quad))
    thing.met.box((-0.21, 0.21), (-0.21, 0.21), (0, 1.0))
    return thing


def server_rack():
    """Doors with units and lamps towards -Y and +Y."""
    half, deep = RACK_WIDTH / 2, RACK_DEPTH / 2
    thing = Assembly().box(BLACK, (-half, half), (-deep, deep), (0, RACK_HEIGHT), without=("-z",))
    for side in (-1, 1):
        y = side * (deep + 0.004)
        corners = [(-half + 0.03, y, 0.10), (half - 0.03, y, 0.10), (half - 0.03, y, 1.92), (-half + 0.03, y, 1.92)]
        thing.of(RACK).face(*(corners if side < 0 else reversed(corners)))
    return thing


def conference_table(length=3.6, width=1.2):
    thing = Assembly().box(DESK_TOP, (-length / 2, length / 2), (-width / 2, width / 2), (0.71, 0.75))
    for x in (-length / 2 + 0.5, length / 2 - 0.5):
        thing.box(GREY, (x - 0.05, x + 0.05), (-width / 2 + 0.2, width / 2 - 0.2), (0.03, 0.71))
        thing.box(GREY, (x - 0.09, x + 0.09), (-width / 2 + 0.12, width / 2 - 0.12), (0, 0.03), without=("-z",))
    thing.show(BLACK, (-0.14, 0.14), (-0.14, 0.14), (0.75, 0.79), without=("-z",))
    for i in range(4):
        x, y = -1.3 + 0.8 * i, (0.35, -0.35)[i % 2]
        thing.show(WHITE, (x - 0.105, x + 0.105), (y - 0.15, y + 0.15), (0.75, 0.757), without=("-z",))
        thing.round(POT, (x + 0.22, y), 0.035, (0.75, 0.85), 6)
    return thing


def wall_screen(width=1.5):
    """On the wall at y = 0."""
    height = width * 0.56
    thing = Assembly().show(BLACK, (-width / 2, width / 2), (-0.06, 0), (1.15, 1.15 + height))
    thing.show(SCREEN, (-width / 2 + 0.02, width / 2 - 0.02), (-0.063, -0.06), (1.17, 1.13 + height), without=("+y",))
    return thing


def sofa(seats=2):
    """Faces -Y."""
    half = 0.36 * seats + 0.12
    thing = Assembly().box(CHAIR_BLUE, (-half, half), (-0.38, 0.40), (0.10, 0.42))
    thing.box(CHAIR_BLUE, (-half, half), (0.20, 0.40), (0.42, 0.80))
    for side in (-1, 1):
        thing.box(CHAIR_BLUE, (side * (half - 0.12), side * half), (-0.38, 0.20), (0.42, 0.60))
        for y in (-0.34, 0.32):
            thing.show(STEEL, (side * (half - 0.10), side * (half - 0.05)), (y, y + 0.05), (0, 0.10))
    return thing


def low_table():
    thing = Assembly().box(DESK_TOP, (-0.45, 0.45), (-0.3, 0.3), (0.38, 0.42))
    for x in (-0.40, 0.36):
        for y in (-0.26, 0.22):
            thing.box(STEEL, (x, x + 0.04), (y, y + 0.04), (0, 0.38))
    return thing.show(RED, (-0.22, 0.0), (-0.15, 0.15), (0.42, 0.428)).show(WHITE, (-0.1, 0.12), (-0.1, 0.2), (0.428, 0.434))


def reception_desk(length=2.6):
    """Visitors come from -Y; 1.1 m high, a desk behind."""
    half = length / 2
    thing = Assembly().box(DOOR_WOOD, (-half, half), (-0.05, 0.0), (0.08, 1.06))
    thing.box(BLACK, (-half + 0.03, half - 0.03), (-0.03, 0.0), (0, 0.08))
    thing.box(WHITE, (-half - 0.03, half + 0.03), (-0.12, 0.22), (1.06, 1.10))
    thing.box(DESK_TOP, (-half, half), (0.0, 0.75), (0.71, 0.74))
    for side in (-1, 1):
        thing.box(DOOR_WOOD, (side * (half - 0.04), side * half), (0.0, 0.75), (0, 1.06))
    thing.show(STEEL, (-half, half), (-0.056, -0.05), (0.86, 0.90), without=("+y",))
    thing.show(STEEL, (-half, half), (-0.056, -0.05), (0.20, 0.24), without=("+y",))
    thing.put(monitor(), (-0.5, 0.30, 0.74), 180).put(monitor(), (0.5, 0.30, 0.74), 180)
    return thing.show(BLACK, (0.85, 1.0), (-0.02, 0.12), (1.10, 1.13)).show(RED, (-0.95, -0.75), (-0.04, 0.1), (1.10, 1.12))


def printer():
    thing = Assembly().box(LAMINATE, (-0.30, 0.30), (-0.30, 0.30), (0.05, 0.62)).box(GREY, (-0.30, 0.30), (-0.28, 0.30), (0.62, 1.02))
    for z in (0.12, 0.30, 0.48):
        thing.panel(GREY, (-0.28, 0.28), -0.303, (z, z + 0.14))
    thing.show(BLACK, (-0.24, 0.24), (-0.285, -0.28), (0.70, 0.80), without=("+y",))
    thing.show(SCREEN_LIT, (0.05, 0.24), (-0.25, -0.12), (1.02, 1.03))
    return thing.show(LAMINATE, (-0.28, 0.0), (-0.20, 0.26), (1.02, 1.06))


def waste_bin():
    thing = Assembly().round(GREY, (0, 0), 0.12, (0, 0.32), 12, top_radius=0.15)
    return thing.round(BLACK, (0, 0), 0.138, (0.318, 0.322), 12)
