"""The street from kerb to kerb: pavements, what is painted on the road, the crossing."""

import math

from .gathered import Gathered, at
from .lettering import word_on_road
from .solid import Solid
from .surfaces import ASPHALT, ASPHALT_DARK, CONCRETE, LINE, METAL, PAVING, TRIM, YELLOW_LINE

HALF_WIDTH, PAVEMENT = 3.5, 6.0  # |x| of kerb and of house fronts
KERB, LEAD_IN = 0.15, 0.2
SOUTH, NORTH = -60, 240
ZEBRA = (60, 64)
SQUARE, LANE = (20, 50), (84, 90)  # y: no pavement on the west, on the east
PAINT = 0.004  # a layer of paint lies so much above the one below


def pavements():
    """(side, y from, y to): where kerb and pavement run; between them square, lane and dropped kerbs."""
    west = ((SOUTH, SQUARE[0]), (SQUARE[1], ZEBRA[0]), (ZEBRA[1], NORTH))
    east = ((SOUTH, ZEBRA[0]), (ZEBRA[1], LANE[0]), (LANE[1], NORTH))
    return [(side, y) for side, ys in ((-1, west), (1, east)) for y in ys]


def stretch(length):
    """Kerb and pavement east of a street, `length` m from y = 0 on. CLAMP has a lead-in along the kerb and at
    both ends."""
    whole, x, y = Gathered(), (HALF_WIDTH, PAVEMENT), (0.0, float(length))
    kerbstone = (x[0], x[0] + 0.15)
    stone = whole.of("kerb", CONCRETE).box(x, y, (0, KERB), without=("+z", "-z")).floor(kerbstone, y, KERB)
    stone.floor((x[1] - 0.10, x[1]), y, KERB)
    whole.of("slabs", PAVING).floor((kerbstone[1], x[1] - 0.10), y, KERB)
    # In cells of about 5 m, so that lines meet few large triangles.
    count = round(length / 5)
    for i in range(count):
        whole.body.floor(x, (length * i / count, length * (i + 1) / count), KERB)
    whole.body.box(x, y, (0, KERB), without=("+z", "-z"))
    low = x[0] - LEAD_IN
    whole.clamp.face((low, y[0], 0), (x[0], y[0], KERB), (x[0], y[1], KERB), (low, y[1], 0))
    whole.clamp.face((x[0], -LEAD_IN, 0), (x[1], -LEAD_IN, 0), (x[1], 0, KERB), (x[0], 0, KERB))
    whole.clamp.face((x[0], y[1], KERB), (x[1], y[1], KERB), (x[1], y[1] + LEAD_IN, 0), (x[0], y[1] + LEAD_IN, 0))
    return whole


def dropped_kerb():
    """4 m of pavement at the zebra, east of the street: rises from the road over 1.2 m, then level."""
    whole, run, y = Gathered(), HALF_WIDTH + 1.2, ZEBRA
    solid = Solid().face((HALF_WIDTH, y[0], 0), (run, y[0], KERB), (run, y[1], KERB), (HALF_WIDTH, y[1], 0))
    solid.floor((run, PAVEMENT), y, KERB).face((PAVEMENT, y[0], 0), (PAVEMENT, y[1], 0), (PAVEMENT, y[1], KERB),
                                               (PAVEMENT, y[0], KERB))
    whole.of("slabs", PAVING).add(solid)
    whole.body.add(solid)
    return whole


def all_pavements():
    whole = Gathered()
    for side, (low, high) in pavements():
        whole.add(stretch(high - low), at(0, low) if side > 0 else at(0, high, 0, 180))
    middle = sum(ZEBRA) / 2
    return whole.add(dropped_kerb(), at(0, 0)).add(dropped_kerb(), at(0, 2 * middle, 0, 180))


def pave(whole, name, surface, x, y, layer):
    whole.of(name, surface).floor(x, y, PAINT * layer)


def road():
    """Asphalt and all that is painted on it: seen only."""
    whole = Gathered()
    for i in range(10):
        pave(whole, "asphalt", ASPHALT, (-HALF_WIDTH, HALF_WIDTH), (SOUTH + 30 * i, SOUTH + 30 * (i + 1)), 0)
        y = SOUTH + 30 * i
        if i % 3 == 1:
            pave(whole, "patches", ASPHALT_DARK, (-2.6, -1.7), (y + 2, y + 21), 1)
        x = 1.1 if i % 2 else -1.2
        disc = [(0.32 * math.cos(math.pi * k / 6), y + 16.5 + 0.32 * math.sin(math.pi * k / 6)) for k in range(12)]
        whole.of("iron", METAL).face(*((x + a, b, 2 * PAINT) for a, b in disc))
        for side in (-1, 1):
            pave(whole, "gullies", TRIM, sorted((side * 3.08, side * 3.46)), (y + 9.7, y + 10.2), 1)
        for k in range(5):
            dash = y + 6 * k + 1.5
            if not ZEBRA[0] - 4 < dash < ZEBRA[1] + 1:
                pave(whole, "line", LINE, (-0.06, 0.06), (dash, dash + 3), 2)
    crossing(whole)
    bays(whole)
    return whole


def crossing(whole):
    middle = sum(ZEBRA) / 2
    for i in range(7):
        pave(whole, "line", LINE, (-3.25 + i, -2.75 + i), (middle - 1.8, middle + 1.8), 3)
    for x, y in (((0.15, 3.3), middle - 3.2), ((-3.3, -0.15), middle + 3.2)):
        pave(whole, "line", LINE, x, (y - 0.15, y + 0.15), 3)


def bays(whole):
    """Bus bay, and two parking bays along the east kerb."""
    for y in (69, 82):
        pave(whole, "yellow", YELLOW_LINE, (0.9, 3.4), (y - 0.06, y + 0.06), 3)
    pave(whole, "yellow", YELLOW_LINE, (0.9, 1.02), (69, 82), 3)
    word_on_road("BUS", (2.2, 75, 3 * PAINT), 2.6, 0.11, whole.of("yellow", YELLOW_LINE))
    for y in (144, 150, 156):
        pave(whole, "line", LINE, (1.3, 3.45), (y - 0.05, y + 0.05), 2)
    for y in (144, 150):
        pave(whole, "line", LINE, (1.25, 1.35), (y + 0.05, y + 5.95), 2)
