"""The builders' yard beside the street: a rough course in lanes that lead north, and a warehouse with a
loading dock."""

import math

from sdf_writer import Surface

from .gathered import Gathered, at
from .lettering import word
from .module import part
from .rough_fields import crossing_ramps, posts_as_seen, skin_over, stepfield
from .scenery import write_mesh
from .solid import Solid
from .surfaces import (BLACK, BLUE, CONCRETE, CONCRETE_DARK, GRAVEL, HAZARD, METAL, ORANGE, STEEL, TRIM, WHITE,
                       WOOD_DARK,
                       YELLOW_LINE)

RUST = Surface((0.42, 0.17, 0.08), "metal", 0.7, 0.2)
GRAVEL_WIDTH, GRAVEL_LENGTH, GRAVEL_CELL = 3.0, 12.0, 0.5
DITCH_WIDTH, DITCH_DEPTH, DITCH_LENGTH = 0.6, 0.3, 4.0  # along Y, down, along X
DOCK_HEIGHT, DOCK_DEPTH, RAMP_RUN, RAMP_WIDTH = 1.0, 4.0, 6.0, 2.6
HALL = (30.0, 12.0, 6.5)
POSTS = (12, 30, 0.1)


def gravel_height(i, j):
    """Loose heaps of at most 6 cm; 0 along the border."""
    columns, rows = round(GRAVEL_WIDTH / GRAVEL_CELL), round(GRAVEL_LENGTH / GRAVEL_CELL)
    if i in (0, columns) or j in (0, rows):
        return 0.0
    return 0.035 + 0.015 * math.sin(2.3 * i + 0.9 * j) + 0.010 * math.sin(4.1 * j - 1.7 * i)


def gravel_strip(folder):
    solid, cell, left = Solid(), GRAVEL_CELL, -GRAVEL_WIDTH / 2

    def corner(i, j):
        return (left + i * cell, j * cell, gravel_height(i, j))

    for i in range(round(GRAVEL_WIDTH / cell)):
        for j in range(round(GRAVEL_LENGTH / cell)):
            solid.face(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1))
            solid.face(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1))
    return part().solid(write_mesh(solid, "gravel_strip", folder), GRAVEL)


def pitch_roll_field(folder):
    """2.36 x 6.5 m: half ramps rising 0.17 over 0.59, the right track a tile behind the left one."""
    return part().solid(write_mesh(crossing_ramps(rows=10), "pitch_roll_field", folder), WOOD_DARK)


def post_height(column, row):
    """One ridge across, and blocks of posts 5 cm higher than their neighbours in turn."""
    rough = (column // 2 + row // 3) % 2
    return 0.05 * (round(2.5 - 2.5 * math.cos(2 * math.pi * (row + 0.5) / 30)) + rough)


def step_field(folder):
    """3 x 1.2 m of posts 0.1 m square, 0 to 0.3 m high."""
    posts, skin = posts_as_seen(*POSTS, post_height), skin_over(*POSTS, post_height)
    return stepfield("outdoor_stepfield", posts, skin, 3.0, 1.2, folder)


def drain_ditch(folder):
    """An open drain across the lane: floor and walls of a hole in the ground, which others leave out."""
    solid, (x, y, z) = Solid(), (DITCH_LENGTH / 2, DITCH_WIDTH, -DITCH_DEPTH)
    solid.floor((-x, x), (0, y), z)
    solid.face((x, 0, z), (-x, 0, z), (-x, 0, 0), (x, 0, 0)).face((-x, y, z), (x, y, z), (x, y, 0), (-x, y, 0))
    solid.face((-x, 0, z), (-x, y, z), (-x, y, 0), (-x, 0, 0)).face((x, y, z), (x, 0, z), (x, 0, 0), (x, y, 0))
    return part().solid(write_mesh(solid, "drain_ditch", folder), CONCRETE_DARK)


def loading_dock():
    """Platform 1.0 m high before the hall, 12 m wide, and the ramp that leads up to it from the south; its
    foot is the origin."""
    whole, half = Gathered(), RAMP_WIDTH / 2
    ramp = Solid().wedge((-half, half), (0, RAMP_RUN), DOCK_HEIGHT)
    whole.of("ramp", CONCRETE).add(ramp)
    whole.body.add(ramp)
    far = RAMP_RUN + DOCK_DEPTH
    whole.block("platform", CONCRETE_DARK, (-3, 9), (RAMP_RUN, far), (0, DOCK_HEIGHT), without=("-z",))
    lift = 0.004
    for x in (-half + 0.08, half - 0.08):
        whole.of("yellow", YELLOW_LINE).face((x - 0.04, 0, lift), (x + 0.04, 0, lift),
                                             (x + 0.04, RAMP_RUN, DOCK_HEIGHT + lift),
                                             (x - 0.04, RAMP_RUN, DOCK_HEIGHT + lift))
    for x in (3.4, 5.2, 7.0):
        whole.of("dark", TRIM).box((x - 0.17, x + 0.17), (RAMP_RUN - 0.12, RAMP_RUN), (0.45, 0.84), without=("+y",))
    whole.of("hazard", HAZARD).box((half, 9.01), (RAMP_RUN - 0.02, RAMP_RUN + 0.10),
                                   (DOCK_HEIGHT - 0.12, DOCK_HEIGHT + 0.003))
    rails = whole.of("yellow", YELLOW_LINE)
    for y in (RAMP_RUN + 0.1, far - 0.2):
        rails.beam((-2.9, y, DOCK_HEIGHT), (-2.9, y, DOCK_HEIGHT + 1.0), 0.05)
    for z in (0.5, 1.0):
        rails.beam((-2.9, RAMP_RUN + 0.1, DOCK_HEIGHT + z), (-2.9, far - 0.2, DOCK_HEIGHT + z), 0.05)
    whole.body.box((-2.93, -2.87), (RAMP_RUN + 0.1, far - 0.2), (DOCK_HEIGHT + 0.4, DOCK_HEIGHT + 1.0))
    return whole


def hall():
    """Warehouse; its front looks towards -Y, origin in the middle of the front."""
    whole, (width, depth, height) = Gathered(), HALL
    half, ridge = width / 2, (depth / 2, height + 1.6)
    sheet, roof = whole.of("sheet", STEEL), whole.of("roof", CONCRETE_DARK)
    sheet.box((-half, half), (0, depth), (0, height), without=("-z",))
    whole.of("base", CONCRETE).box((-half, half), (-0.05, 0), (0, 0.7), without=("+y", "-z"))
    for i in range(1, 10):
        x = -half + 3.0 * i
        whole.of("dark", TRIM).box((x - 0.03, x + 0.03), (-0.03, 0), (0.7, height), without=("-z", "+y", "+z"))
    roof.face((-half, -0.4, height), (half, -0.4, height), (half, *ridge), (-half, *ridge))
    roof.face((half, depth + 0.4, height), (-half, depth + 0.4, height), (-half, *ridge), (half, *ridge))
    for x in (-half, half):
        gable = [(x, -0.4, height), (x, depth + 0.4, height), (x, *ridge)]
        roof.face(*(gable if x > 0 else reversed(gable)))
    for x, z, w, h in ((-9.0, 0.0, 2.2, 4.2), (4.6, DOCK_HEIGHT, 1.5, 2.8), (8.4, DOCK_HEIGHT, 1.5, 2.8),
                       (-4.5, 0.0, 0.55, 2.1)):
        whole.of("white", WHITE).box((x - w - 0.12, x + w + 0.12), (-0.10, 0), (z, z + h + 0.12), without=("+y", "-z"))
        doors = whole.of("doors", BLUE).box((x - w, x + w), (-0.12, -0.10), (z, z + h), without=("+y",))
        for k in range(1, int(h / 0.45)):
            doors.box((x - w, x + w), (-0.14, -0.12), (z + 0.45 * k, z + 0.45 * k + 0.05), without=("+y",))
    whole.of("white", WHITE).box((-6.5, 6.5), (-0.14, -0.02), (4.75, 5.85), without=("+y",))
    word("BUILDERS YARD", (0, -0.18, 5.3), 0.75, 0.13, whole.of("dark", TRIM), 0.9)
    whole.body.box((-half, half), (0, depth), (0, height))
    return whole


def board_fence(length):
    """Posts and boards along X, 1.7 m high, centred."""
    whole, half = Gathered(), length / 2
    wood, count = whole.of("wood", WOOD_DARK), max(1, round(length / 2.5))
    for i in range(count + 1):
        x = -half + length * i / count
        wood.box((x - 0.05, x + 0.05), (-0.05, 0.05), (0, 1.7), without=("-z",))
    for z in (0.15, 0.65, 1.15):
        wood.box((-half, half), (-0.02, 0.02), (z, z + 0.40))
    whole.body.box((-half, half), (-0.05, 0.05), (0, 1.6))
    return whole


def pallets():
    """Four, one on the other."""
    whole = Gathered()
    for k in range(4):
        z = 0.144 * k
        for x in (-0.5, 0, 0.5):
            whole.of("wood", WOOD_DARK).box((x - 0.07, x + 0.07), (-0.4, 0.4), (z, z + 0.10), without=("-z", "+z"))
        whole.of("wood", WOOD_DARK).box((-0.6, 0.6), (-0.4, 0.4), (z + 0.10, z + 0.144))
    whole.body.box((-0.6, 0.6), (-0.4, 0.4), (0, 0.576))
    return whole


def barrels():
    """Three of 0.88 m."""
    whole = Gathered()
    for x, y, name, surface in ((0, 0, "blue", BLUE), (0.68, -0.15, "orange", ORANGE), (0.22, 0.62, "blue", BLUE)):
        rings = [(0.29, 0), (0.29, 0.30), (0.305, 0.31), (0.29, 0.32), (0.29, 0.88), (0.0, 0.86)]
        whole.of(name, surface).add(Solid().ring(rings, sides=12), at(x, y))
        whole.body.add(Solid().ring([(0.29, 0), (0.29, 0.88), (0.0, 0.88)], sides=8), at(x, y))
    return whole


def container():
    """A 20-foot shipping container along X: 6.06 x 2.44 x 2.59 m, ribbed."""
    whole, half, side = Gathered(), 3.03, 1.22
    steel = whole.of("orange", RUST).box((-half, half), (-side + 0.04, side - 0.04), (0.05, 2.55), without=("-z",))
    for i in range(19):
        x = -2.76 + i * 0.30
        steel.box((x, x + 0.13), (-side, side), (0.16, 2.45), without=("+z", "-z"))
    for x in (-half + 0.07, half - 0.07):
        for y in (-side + 0.07, side - 0.07):
            whole.of("dark", TRIM).box((x - 0.075, x + 0.075), (y - 0.075, y + 0.075), (0, 2.59), without=("-z",))
    for y in (-0.75, -0.25, 0.25, 0.75):
        whole.of("dark", TRIM).box((half, half + 0.05), (y - 0.02, y + 0.02), (0.2, 2.4), without=("-x",))
    whole.body.box((-half, half), (-side, side), (0, 2.59))
    return whole


def course_markings(stations, y):
    """Lines before each lane, and what it is on a plate."""
    whole = Gathered()
    plates, posts, text = whole.of("white", WHITE), whole.of("metal", METAL), whole.of("black", BLACK)
    for x, label in stations:
        whole.of("yellow", YELLOW_LINE).floor((x - 1.0, x + 1.0), (y - 1.55, y - 1.45), 0.008)
        for side in (-1, 1):
            whole.of("white", WHITE).floor(sorted((x + side * 1.25, x + side * 1.33)), (y - 4.0, y - 0.3), 0.008)
        sign = x - 1.9
        posts.box((sign - 0.03, sign + 0.03), (y - 0.78, y - 0.72), (0, 1.4), without=("-z",))
        plates.box((sign - 0.42, sign + 0.42), (y - 0.81, y - 0.78), (0.95, 1.45))
        word(label, (sign, y - 0.835, 1.20), 0.24, 0.045, text, 0.6)
        whole.body.box((sign - 0.42, sign + 0.42), (y - 0.81, y - 0.72), (0, 1.45))
    return whole
