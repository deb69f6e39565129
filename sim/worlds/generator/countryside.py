"""What lies round the town: hedges, walls, trees, woods, the church."""

import math
import random

from sdf_writer import Surface

from .gathered import Gathered, at
from .land import hill_height
from .surfaces import (BARK, BLACK, BRICK_PALE, CONCRETE, CONCRETE_DARK, FOREST, GLASS, HEDGE, MEADOW, SLATES, WHITE)

CROWN = Surface((0.62, 0.80, 0.42), "leaves", 1.6, 0.0)


def hedge(length, height, seed):
    """Along X, 0.7 m thick, uneven on top."""
    rng, whole = random.Random(seed), Gathered()
    solid, count = whole.of("hedge", HEDGE), max(2, round(length / 5))
    rows = []
    for i in range(count + 1):
        x, out = -length / 2 + length * i / count, 0.35 + rng.uniform(-0.05, 0.05)
        top = height + rng.uniform(-0.15, 0.08)
        rows.append([(x, -out, 0), (x, -out, top - 0.12), (x, -out + 0.14, top), (x, out - 0.14, top),
                     (x, out, top - 0.12),
                     (x, out, 0)])
    for a, b in zip(rows, rows[1:]):
        for k in range(5):
            solid.face(a[k], b[k], b[k + 1], a[k + 1])
    solid.face(*rows[0]).face(*reversed(rows[-1]))
    whole.body.box((-length / 2, length / 2), (-0.3, 0.3), (0, height))
    return whole


def low_wall(length, height=0.9):
    """Brick with a stone cap, along X."""
    whole, half = Gathered(), length / 2
    whole.block("brick", BRICK_PALE, (-half, half), (-0.15, 0.15), (0, height), without=("-z", "+z"))
    whole.of("cap", CONCRETE).box((-half, half), (-0.19, 0.19), (height, height + 0.07))
    return whole


def cover_wall():
    """Concrete blocks in two courses, 3.6 x 0.6 x 1.6 m: what a robot retreats behind."""
    whole = Gathered()
    for course, xs in ((0, (-1.2, 0.0, 1.2)), (1, (-0.6, 0.6))):
        name, surface = (("dark", CONCRETE_DARK), ("light", CONCRETE))[course]
        for x in xs:
            whole.of(name, surface).box((x - 0.59, x + 0.59), (-0.3, 0.3), (0.8 * course, 0.8 * course + 0.79),
                                        without=("-z",))
    whole.body.box((-1.8, 1.8), (-0.3, 0.3), (0, 0.8)).box((-1.2, 1.2), (-0.3, 0.3), (0.8, 1.6))
    return whole


def lump(solid, centre, radius, rng, sides=8, rows=4):
    """A crown's ball with bumps."""
    rings = []
    for j in range(1, rows):
        up = math.pi * j / rows
        rings.append([tuple(c + radius * rng.uniform(0.85, 1.15) * v for c, v in zip(centre, (
            math.sin(up) * math.cos(2 * math.pi * (i + 0.5 * (j % 2)) / sides),
            math.sin(up) * math.sin(2 * math.pi * (i + 0.5 * (j % 2)) / sides), -math.cos(up)))) for i in range(sides)])
    bottom, top = (tuple(c + s * radius * v for c, v in zip(centre, (0, 0, 1))) for s in (-0.9, 1))
    for i in range(sides):
        j = (i + 1) % sides
        solid.face(bottom, rings[0][j], rings[0][i]).face(rings[-1][i], rings[-1][j], top)
        for k, (low, high) in enumerate(zip(rings, rings[1:])):
            if k % 2 == 0:
                solid.face(low[i], low[j], high[i]).face(low[j], high[j], high[i])
            else:
                solid.face(low[i], high[j], high[i]).face(low[i], low[j], high[j])


def tree(scale, rng, lumps=3):
    """About 4.5 m high at scale 1; `lumps` of its crown, fewer if it is only seen from afar."""
    whole = Gathered()
    whole.of("bark", BARK).ring([(0.20 * scale, -0.3), (0.13 * scale, 1.2 * scale), (0.10 * scale, 2.6 * scale)],
                                sides=7)
    whole.body.box((-0.14 * scale, 0.14 * scale), (-0.14 * scale, 0.14 * scale), (-0.3, 2.2 * scale))
    for x, y, z, radius in ((0, 0, 3.4, 1.35), (0.75, 0.25, 2.8, 0.95), (-0.55, -0.65, 2.9, 1.0))[:lumps]:
        lump(whole.of("crown", CROWN), (x * scale, y * scale, z * scale), radius * scale, rng)
    return whole


def bush(seed):
    """About 1.2 m high."""
    whole = Gathered()
    lump(whole.of("hedge", HEDGE), (0, 0, 0.45), 0.75, random.Random(seed), rows=3)
    whole.body.box((-0.55, 0.55), (-0.55, 0.55), (0, 0.9))
    return whole


def hills():
    """Far off all round: the land beyond the other modules' fences, wider and higher, in fewer facets."""
    whole, radii, sides = Gathered(), (55, 110, 150, 220, 320, 450), 36
    rings = [[(4.6 * r * math.cos(math.pi * i / 18), 4.6 * r * math.sin(math.pi * i / 18),
               2 * hill_height(r, math.pi * i / 18) - 0.3)
              for i in range(sides)] for r in radii]
    for near, far in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            whole.of("meadow", MEADOW).face(near[i], far[i], far[j], near[j])
    return whole


def quarter_of_woods(quarter, reach):
    """Trees beyond `reach` m from the middle, none on the road."""
    rng, whole = random.Random(11 + quarter), Gathered()
    solid = whole.of("trees", FOREST)
    for _ in range(52):
        angle = math.pi / 2 * (quarter + rng.random() - 0.5)
        out = rng.uniform(6, 90) + reach / max(abs(math.cos(angle)), abs(math.sin(angle)))
        x, y = out * math.cos(angle), out * math.sin(angle)
        if abs(x) < 9 and y < 0:
            continue
        height, is_fir = rng.uniform(7, 13), rng.random() < 0.4
        rows = ((0.08, 0.20),) if is_fir else ((0.12, 0.22), (0.5, 0.36))
        rings = [[(x + height * r * math.cos(math.pi * k / 3), y + height * r * math.sin(math.pi * k / 3), height * z)
                  for k in range(6)] for z, r in rows]
        for k in range(6):
            j = (k + 1) % 6
            for low, high in zip(rings, rings[1:]):
                solid.face(low[k], low[j], high[j], high[k])
            solid.face(rings[-1][k], rings[-1][j], (x, y, height))
    return whole


def church():
    """Tower with a clock towards -Y, nave behind it; origin before the door."""
    whole = Gathered()
    stone, roof, dark = whole.of("stone", CONCRETE), whole.of("roof", SLATES), whole.of("windows", GLASS)
    stone.box((-3.5, 3.5), (0, 7), (0, 20), without=("-z",)).box((-6, 6), (7, 27), (0, 8), without=("-z",))
    for x in (-3.5, 3.5):
        stone.box((x - 0.35, x + 0.35), (-0.5, 0.3), (0, 15), without=("-z",))
    base = [(-3.8, -0.3, 20), (3.8, -0.3, 20), (3.8, 7.3, 20), (-3.8, 7.3, 20)]
    for i in range(4):
        roof.face(base[i], base[(i + 1) % 4], (0, 3.5, 31))
    for side in (-1, 1):
        slope = [(side * 6.5, 7, 7.9), (side * 6.5, 27, 7.9), (0, 27, 13.5), (0, 7, 13.5)]
        roof.face(*(slope if side > 0 else reversed(slope)))
        for y in (10, 14, 18, 22):
            pane = [(side * 6.05, y, 2.5), (side * 6.05, y + 1.4, 2.5), (side * 6.05, y + 1.4, 6.2),
                    (side * 6.05, y, 6.2)]
            dark.face(*(pane if side > 0 else reversed(pane)))
    for x, w, z0, z1 in ((0, 1.1, 0, 3.2), (-0.9, 0.45, 14.6, 17.6), (0.9, 0.45, 14.6, 17.6), (0, 0.7, 5.5, 9.0)):
        dark.face((x - w, -0.05, z0), (x + w, -0.05, z0), (x + w, -0.05, z1), (x, -0.05, z1 + w), (x - w, -0.05, z1))
    clock = [(1.4 * math.cos(math.pi * i / 8), -0.08, 12.2 + 1.4 * math.sin(math.pi * i / 8)) for i in range(16)]
    whole.of("clock", WHITE).face(*clock)
    whole.of("hands", BLACK).beam((0, -0.15, 12.2), (0, -0.15, 13.3), 0.14).beam((0, -0.15, 12.2), (0.7, -0.15, 11.8),
                                                                                 0.16)
    whole.body.box((-3.5, 3.5), (0, 7), (0, 8)).box((-6, 6), (7, 27), (0, 8))
    return whole


def placed(things):
    """Several things as one: (thing, x, y, z, heading)."""
    whole = Gathered()
    for thing, x, y, z, heading in things:
        whole.add(thing, at(x, y, z, heading))
    return whole
