"""Terraces of houses: flats above shops, or dwellings. They look towards -Y and begin at the origin; z = 0 is
the ground storey's floor, FLOOR above the pavement. Bays are as wide as the texture of their windows has them, so
terraces begin at whole bays of the frame that they are moved to."""

import random

from sdf_writer import Surface

from .gathered import Gathered
from .lettering import word
from .surfaces import LAMP, RED, SHOPWINDOW, SLATES, TILES, TRIM, WHITE, YELLOW_LINE

BAY, STOREY, FLOOR, DEPTH = 3.0, 3.0, 0.3, 9.0
GROUND = -FLOOR - 0.15  # down to the foot of the kerb
STONE = Surface((0.52, 0.51, 0.48), "render", 3.0, 0.02)
GABLES = Surface((0.78, 0.72, 0.62), "render", 3.0, 0.02)
PANE = Surface((0.10, 0.14, 0.18), "plain", 1.0, 0.9)
RENDER = {"cream": (0.86, 0.79, 0.62), "ochre": (0.80, 0.58, 0.30), "rose": (0.76, 0.50, 0.42),
          "sky": (0.52, 0.64, 0.74), "grey": (0.60, 0.60, 0.58), "white": (0.88, 0.87, 0.84),
          "sage": (0.54, 0.62, 0.46), "clay": (0.62, 0.32, 0.22)}
PAINT = {"green": Surface((0.06, 0.20, 0.11), "plain", 1.0, 0.2),
         "blue": Surface((0.04, 0.13, 0.32), "plain", 1.0, 0.2),
         "red": RED, "dark": TRIM, "wood": Surface((0.24, 0.13, 0.07), "plain", 1.0, 0.1), "yellow": YELLOW_LINE}
DOORS = ("green", "blue", "red", "dark", "wood")


class Terrace(Gathered):
    """With the dice that decide on what differs from house to house."""

    def __init__(self, rng):
        super().__init__()
        self.rng = rng

    def windows(self, colour):
        return self.of(f"windows_{colour}", Surface(RENDER[colour], "windows", 2 * STOREY, 0.05))

    def paint(self, name):
        return self.of(name, PAINT[name])

    def stone(self):
        return self.of("stone", STONE)


def wall(solid, x, z, y=0.0):
    """Faces -Y."""
    solid.face((x[0], y, z[0]), (x[1], y, z[0]), (x[1], y, z[1]), (x[0], y, z[1]))


def shell(terrace, x, storeys, colour, is_shop):
    """Walls, roof, chimney. The front's ground storey is left to others where it is a shop."""
    top, (a, b) = storeys * STOREY, x
    front = terrace.windows(colour)
    wall(front, x, (STOREY if is_shop else 0, top))
    front.face((b, DEPTH, 0), (a, DEPTH, 0), (a, DEPTH, top), (b, DEPTH, top))
    sides = terrace.of("gables", GABLES)
    sides.box(x, (0, DEPTH), (GROUND, top), without=("-y", "+y", "+z", "-z"))
    terrace.stone().box(x, (-0.03, DEPTH + 0.03), (GROUND, 0.0), without=("-z", "-x", "+x"))
    eaves, pitch = 0.45, terrace.rng.choice((2.4, 2.9, 3.3))
    roof_name, roof = terrace.rng.choice((("tiles", TILES), ("tiles", TILES), ("slates", SLATES)))
    low, high, ridge = top, top + 0.12, (DEPTH / 2, top + pitch)
    cover = terrace.of(roof_name, roof)
    cover.face((a, -eaves, high), (b, -eaves, high), (b, *ridge), (a, *ridge))
    cover.face((b, DEPTH + eaves, high), (a, DEPTH + eaves, high), (a, *ridge), (b, *ridge))
    edge = terrace.of("white", WHITE)
    wall(edge, x, (low, high), -eaves)
    edge.face((a, -eaves, low), (a, 0, low), (b, 0, low), (b, -eaves, low))
    edge.box((a, b), (-0.06, 0), (top - 0.28, top), without=("+y", "+z"))
    for at, corners in ((a, (1, 0)), (b, (0, 1))):
        profile = [(at, -eaves, low), (at, DEPTH + eaves, low), (at, DEPTH + eaves, high), (at, *ridge),
                   (at, -eaves, high)]
        sides.face(*(profile if corners[1] else reversed(profile)))
    chimney = a + terrace.rng.choice((0.8, b - a - 1.6))
    sides.box((chimney, chimney + 0.7), (DEPTH / 2 - 0.4, DEPTH / 2 + 0.4),
                                   (top + pitch - 0.6, top + pitch + 0.9), without=("-z",))
    terrace.paint("dark").box((a - 0.05, a + 0.05), (-0.12, -0.02), (GROUND, top), without=("-z", "+z", "+y"))


def door(terrace, x, paint, number):
    """Leaf, surround, fanlight and steps; `x`: its middle."""
    white, stone = terrace.of("white", WHITE), terrace.stone()
    white.box((x - 0.78, x + 0.78), (-0.07, 0), (GROUND, 2.64), without=("+y", "-z"))
    wall(terrace.paint(paint), (x - 0.48, x + 0.48), (0.0, 2.02), -0.085)
    wall(terrace.of("glass", PANE), (x - 0.48, x + 0.48), (2.10, 2.48), -0.085)
    wall(terrace.paint("dark"), (x + 0.33, x + 0.41), (0.98, 1.04), -0.10)
    stone.box((x - 0.75, x + 0.75), (-0.40, 0), (GROUND, -FLOOR / 2), without=("-z", "+y"))
    stone.box((x - 0.62, x + 0.62), (-0.20, 0), (-FLOOR / 2, 0), without=("-z", "+y"))
    wall(white, (x + 0.90, x + 1.20), (1.55, 1.85), -0.02)
    word(number, (x + 1.05, -0.035, 1.70), 0.17, 0.03, terrace.paint("dark"), 0.8)


def flower_boxes(terrace, x, storeys):
    flowers = terrace.paint("red")
    for storey in range(1, storeys):
        for bay in range(round((x[1] - x[0]) / BAY)):
            if terrace.rng.random() < 0.16:
                middle, z = x[0] + (bay + 0.5) * BAY, storey * STOREY + 0.76
                terrace.paint("wood").box((middle - 0.5, middle + 0.5), (-0.24, 0), (z, z + 0.17), without=("+y", "+z"))
                flowers.box((middle - 0.47, middle + 0.47), (-0.23, -0.02), (z + 0.17, z + 0.30), without=("+y", "-z"))


def shop(terrace, x, name, paint):
    """Ground storey of glass: door in the last bay, sign above, awning over the panes."""
    a, b = x
    frame = terrace.paint(paint)
    pane = terrace.of("shopwindow", SHOPWINDOW)
    low, high = 0.32, 2.25
    wall(pane, (a, b - 1.9), (low, high), 0.0)
    frame.box((a, b - 1.7), (-0.10, 0.0), (GROUND, low), without=("-z", "+y"))
    count = max(2, round((b - a - 1.9) / 2))
    for i in range(count + 1):
        middle = a + 0.12 + i * (b - a - 2.1) / count
        frame.box((middle - 0.07, middle + 0.07), (-0.08, 0), (low, high), without=("+y", "-z", "+z"))
    frame.box((b - 1.70, b), (-0.06, 0), (GROUND, high), without=("+y", "-z"))
    frame.box((a, b), (-0.18, 0), (high, STOREY), without=("+y",))
    # The door: glass in a frame, a handle, a step.
    terrace.of("glass", PANE).box((b - 1.33, b - 0.45), (-0.075, -0.06), (0.25, 2.1), without=("+y",))
    terrace.paint("dark").box((b - 1.29, b - 1.24), (-0.14, -0.08), (0.8, 1.3), without=("+y",))
    terrace.stone().box((b - 1.5, b - 0.25), (-0.35, -0.03), (GROUND, -FLOOR / 2), without=("-z", "+y"))
    letters = terrace.paint("yellow") if paint in ("dark", "green") else terrace.of("white", WHITE)
    word(name, ((a + b) / 2, -0.21, (high + STOREY) / 2), 0.40, 0.075, letters)
    awning(terrace, (a + 0.15, b - 1.9), high + 0.02, paint)


def awning(terrace, x, z, paint):
    """Cloth from the wall down to 1.1 m before it, in stripes."""
    stripes, near, far = max(3, round((x[1] - x[0]) / 0.8)), (-0.18, z), (-1.15, z - 0.42)
    under = terrace.paint(paint)
    under.face((x[0], *near), (x[1], *near), (x[1], *far), (x[0], *far))
    for i in range(stripes):
        cloth = terrace.of("white", WHITE) if i % 2 else under
        a, b = (x[0] + (x[1] - x[0]) * k / stripes for k in (i, i + 1))
        cloth.face((a, *far), (b, *far), (b, *near), (a, *near))
        wall(cloth, (a, b), (far[1] - 0.16, far[1]), far[0])


def hanging_sign(terrace, x, paint):
    """Board square to the wall."""
    terrace.paint("dark").box((x - 0.02, x + 0.02), (-0.95, 0), (4.12, 4.16), without=("+y",))
    terrace.paint(paint).box((x - 0.04, x + 0.04), (-0.90, -0.20), (3.45, 4.10))


def lantern(terrace, x):
    terrace.of("lamp", LAMP).box((x - 0.07, x + 0.07), (-0.20, 0), (2.18, 2.42), without=("+y", "-z"))


def gable_window(row, x, out, z):
    """In the end wall at x; `out`: -1 or 1."""
    frame, pane = sorted((x, x + out * 0.05)), sorted((x + out * 0.05, x + out * 0.07))
    hidden = ("+x",) if out < 0 else ("-x",)
    row.of("white", WHITE).box(frame, (DEPTH / 2 - 0.62, DEPTH / 2 + 0.62), (z, z + 1.5), without=hidden)
    for y in (DEPTH / 2 - 0.27, DEPTH / 2 + 0.27):
        row.of("glass", PANE).box(pane, (y - 0.23, y + 0.23), (z + 0.1, z + 1.4),
                                  without=(*hidden, "-y", "+y", "-z", "+z"))


def terrace(houses, seed):
    """`houses`: (bays, storeys, colour, name of its shop or house number), from left to right."""
    row, x = Terrace(random.Random(seed)), 0.0
    for bays, storeys, colour, label in houses:
        span = (x, x + BAY * bays)
        paint = row.rng.choice(DOORS)
        is_shop = not label.isdigit()
        shell(row, span, storeys, colour, is_shop)
        if is_shop:
            shop(row, span, label, paint)
            hanging_sign(row, span[0] + 0.5, paint)
        else:
            door(row, span[0] + BAY * (row.rng.randrange(bays) + 0.5), paint, label)
            lantern(row, span[0] + 0.25)
        flower_boxes(row, span, storeys)
        row.stone().box(span, (-0.05, 0), (STOREY - 0.02, STOREY + 0.16), without=("+y",))
        x = span[1]
    gable_window(row, 0.0, -1, STOREY * houses[0][1] - 1.9)
    gable_window(row, x, 1, STOREY * houses[-1][1] - 1.9)
    row.body.box((0.0, x), (0.0, DEPTH), (GROUND, 2 * STOREY))
    return row


def terrace_width(houses):
    return BAY * sum(bays for bays, *_ in houses)
