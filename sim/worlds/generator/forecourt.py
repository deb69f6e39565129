"""Before the office building: street, parking, paths, lamps, hedges, neighbours."""

from .assembly import Assembly
from .module import part
from .scenery import Scenery, start_pad
from .surfaces import (ASPHALT, BLUE, BRICK, BRICK_PALE, CONCRETE, CONCRETE_DARK, EARTH, GLASS, LAMP, LEAVES, LINE, METAL,
                       RED, ROOF, STEEL, WHITE, WOOD)


def paving(folder):
    scenery = Scenery("indoor", folder)
    scenery.pave("asphalt", ASPHALT, (-60, 60), (-18.5, -12.5), 1)
    scenery.pave("asphalt", ASPHALT, (-14.0, 14.0), (-12.5, -7.0), 1)
    scenery.pave("slabs", CONCRETE, (-10.5, 10.5), (-1.4, 3.0), 1)
    scenery.pave("slabs", CONCRETE, (-1.8, 1.8), (-7.0, -1.4), 1)
    start_pad(scenery)
    for i in range(30):
        scenery.pave("line", LINE, (-59 + 4 * i, -57 + 4 * i), (-15.56, -15.44), 2)
    for i in range(11):
        x = -13.5 + 2.5 * i
        if abs(x) > 1.5:
            scenery.pave("line", LINE, (x - 0.05, x + 0.05), (-12.0, -7.1), 2)
    for i in range(5):
        scenery.pave("line", LINE, (-1.4 + 0.62 * i, -1.08 + 0.62 * i), (-12.3, -9.3), 2)
    return scenery.link()


def street_lamp():
    thing = Assembly().round(METAL, (0, 0), 0.07, (0, 4.2), 8, met=True, top_radius=0.05)
    return thing.show(METAL, (-0.12, 0.12), (-0.1, 0.7), (4.15, 4.25)).show(LAMP, (-0.09, 0.09), (0.25, 0.65), (4.14, 4.15))


def hedge(length):
    return Assembly().box(LEAVES, (-length / 2, length / 2), (-0.35, 0.35), (0, 0.75), without=("-z",)).show(
        EARTH, (-length / 2 - 0.15, length / 2 + 0.15), (-0.5, 0.5), (0, 0.06), without=("-z",))


def bench():
    thing = Assembly()
    for i in range(3):
        thing.show(WOOD, (-0.8, 0.8), (-0.22 + 0.16 * i, -0.08 + 0.16 * i), (0.42, 0.46))
    for x in (-0.65, 0.60):
        thing.show(METAL, (x, x + 0.05), (-0.2, 0.22), (0, 0.42))
    thing.met.box((-0.8, 0.8), (-0.22, 0.24), (0, 0.46))
    return thing


def flagpole(surface):
    thing = Assembly().round(WHITE, (0, 0), 0.05, (0, 7), 8, met=True)
    return thing.show(surface, (0.05, 1.45), (-0.01, 0.01), (5.9, 6.9))


def bollard():
    return Assembly().round(STEEL, (0, 0), 0.07, (0, 0.85), 10, met=True).round(RED, (0, 0), 0.073, (0.68, 0.78), 10)


def neighbour(width, depth, storeys, surface):
    """Its front towards -Y; windows are dark bands on it."""
    block = Assembly().box(surface, (-width / 2, width / 2), (-depth / 2, depth / 2), (0, 3.2 * storeys), without=("-z",))
    block.show(ROOF, (-width / 2 - 0.2, width / 2 + 0.2), (-depth / 2 - 0.2, depth / 2 + 0.2),
               (3.2 * storeys, 3.2 * storeys + 0.4))
    count = int(width / 2.6)
    for storey in range(storeys):
        for i in range(count):
            x, z = (i - (count - 1) / 2) * 2.6, 3.2 * storey + 0.9
            for side in (-1, 1):
                for look, wide, proud in ((WHITE, 0.75, 0.02), (GLASS, 0.68, 0.05)):
                    y = side * (depth / 2 + proud)
                    corners = [(x - wide, y, z), (x + wide, y, z), (x + wide, y, z + 1.5), (x - wide, y, z + 1.5)]
                    block.of(look).face(*(corners if side < 0 else reversed(corners)))
    return block


def forecourt(yard, folder):
    yard.model("indoor_paving", paving(folder))
    things = Assembly()
    for x in (-9.5, 9.5):
        things.put(street_lamp(), (x, -6.0, 0))
    for x in (-6.2, 6.2):
        things.put(hedge(7.0), (x, 1.9, 0)).put(hedge(8.0), (x, -6.3, 0))
    for x in (-4.5, 4.5):
        things.put(bench(), (x, -2.6, 0), 180)
    for i, surface in enumerate((BLUE, RED, WHITE)):
        things.put(flagpole(surface), (-9.0 + 1.8 * i, -3.6, 0))
    for x in (-1.6, -0.8, 0.8, 1.6):
        things.put(bollard(), (x, -6.6, 0))
    for x in range(-60, 61, 20):
        things.put(street_lamp(), (x, -11.9 if abs(x) > 15 else -19.2, 0), 180 if abs(x) > 15 else 0)
    things.of(CONCRETE_DARK).box((-14.2, 14.2), (-7.0, -6.85), (0, 0.10), without=("-z",))
    yard.model("forecourt", things.link("forecourt", folder))
    for i, (x, y, width, depth, storeys, surface) in enumerate(((-36, 8, 22, 12, 3, BRICK), (36, 10, 24, 14, 4, BRICK_PALE),
                                                                (-24, -36, 26, 12, 3, BRICK_PALE), (12, -38, 30, 12, 2, BRICK),
                                                                (46, -36, 20, 12, 5, BRICK_PALE))):
        block = neighbour(width, depth, storeys, surface)
        yard.model(f"neighbour_{i + 1}", block.seen_by(part(), f"neighbour_{i + 1}", folder), (x, y, 0))

