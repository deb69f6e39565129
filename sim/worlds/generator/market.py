"""The market: stalls and their goods, a fountain."""

from sdf_writer import Surface

from .gathered import Gathered
from .lettering import word
from .surfaces import BLUE, CONCRETE, GLASS, GREEN, METAL, RED, WHITE, WOOD_DARK

TABLE_TOP, TABLE_WIDTH, TABLE_DEPTH = 0.75, 2.4, 0.70
ROOF_LOW, ROOF_HIGH = 2.15, 2.65
FRUIT = {"orange": (0.90, 0.36, 0.04), "red": (0.62, 0.05, 0.04), "green": (0.28, 0.50, 0.10),
         "yellow": (0.88, 0.70, 0.10), "plum": (0.22, 0.08, 0.20), "loaf": (0.62, 0.36, 0.14),
         "white": (0.85, 0.84, 0.78)}
CRATE = (0.40, 0.30, 0.16)


def crate_of(x, y, z, wood, heap):
    """Open box, heaped; `heap`: Solid of that fruit."""
    a, b, h = CRATE
    wood.box((x - a / 2, x + a / 2), (y - b / 2, y + b / 2), (z, z + h), without=("-z", "+z"))
    low, top, inset = z + h - 0.03, z + h + 0.06, 0.09
    corners = [(x - a / 2, y - b / 2), (x + a / 2, y - b / 2), (x + a / 2, y + b / 2), (x - a / 2, y + b / 2)]
    peak = [(px + (inset if px < x else -inset), py + (inset if py < y else -inset)) for px, py in corners]
    for i in range(4):
        j = (i + 1) % 4
        heap.face((*corners[i], low), (*corners[j], low), (*peak[j], top), (*peak[i], top))
    heap.face(*((*p, top) for p in peak))


def stall(cloth, title, goods, free=0.0):
    """Table at 0.75 under a striped roof; its front, with the sign, looks towards -Y. `goods`: names of
    FRUIT from left to right; nothing stands within `free` m of the middle."""
    whole, half, depth = Gathered(), TABLE_WIDTH / 2, TABLE_DEPTH / 2
    wood, posts = whole.of("wood", WOOD_DARK), whole.of("posts", METAL)
    wood.box((-half, half), (-depth, depth), (TABLE_TOP - 0.04, TABLE_TOP))
    whole.body.box((-half, half), (-depth, depth), (TABLE_TOP - 0.04, TABLE_TOP))
    legs = [(x, y, 0.03, TABLE_TOP - 0.04) for x in (-half + 0.06, half - 0.06) for y in (-depth + 0.06, depth - 0.06)]
    legs += [(x, y, 0.025, ROOF_LOW + 0.1) for x in (-half - 0.05, half + 0.05) for y in (-depth - 0.10, depth + 0.85)]
    for x, y, thick, top in legs:
        posts.box((x - thick, x + thick), (y - thick, y + thick), (0, top), without=("-z", "+z"))
        whole.body.box((x - thick, x + thick), (y - thick, y + thick), (0, top))
    striped_roof(whole, cloth, half, -depth - 0.35, depth + 1.0)
    skirt = (-depth - 0.01, 0.30, TABLE_TOP - 0.04)
    whole.of("cloth", cloth).face((-half, *skirt[:2]), (half, *skirt[:2]), (half, skirt[0], skirt[2]),
                                  (-half, skirt[0], skirt[2]))
    whole.of("cloth", cloth).box((-0.85, 0.85), (-depth - 0.41, -depth - 0.37), (ROOF_LOW - 0.40, ROOF_LOW - 0.02))
    word(title, (0, -depth - 0.44, ROOF_LOW - 0.21), 0.24, 0.045, whole.of("white", WHITE), 0.85)
    for i, kind in enumerate(goods):
        x = -half + 0.25 + (TABLE_WIDTH - 0.5) * i / (len(goods) - 1)
        if abs(x) < free + CRATE[0] / 2:
            continue
        for y in (-0.16, 0.17):
            crate_of(x, y, TABLE_TOP, wood, whole.of(kind, Surface(FRUIT[kind], "fruit", 0.42, 0.1)))
        whole.body.box((x - CRATE[0] / 2, x + CRATE[0] / 2), (-0.31, 0.32), (TABLE_TOP, TABLE_TOP + CRATE[2] + 0.05))
    return whole


def striped_roof(whole, cloth, half, near, far):
    """Two slopes in stripes, a fringe along front and back; both sides of the cloth."""
    ridge = (near + far) / 2
    for i in range(8):
        a, b = (-half - 0.2 + 2 * (half + 0.2) * k / 8 for k in (i, i + 1))
        strip = whole.of("white", WHITE) if i % 2 else whole.of("cloth", cloth)
        for y in (near, far):
            slope = [(a, y, ROOF_LOW), (b, y, ROOF_LOW), (b, ridge, ROOF_HIGH), (a, ridge, ROOF_HIGH)]
            fringe = [(a, y, ROOF_LOW - 0.22), (b, y, ROOF_LOW - 0.22), (b, y, ROOF_LOW), (a, y, ROOF_LOW)]
            for cloth_face in (slope, fringe):
                strip.face(*cloth_face).face(*reversed(cloth_face))


def empty_crates():
    whole = Gathered()
    for i, (x, y) in enumerate(((0, 0), (0, 0), (0.02, 0.03), (0.44, 0.02), (0.45, 0))):
        z = 0.17 * (i if i < 3 else i - 3)
        whole.of("wood", WOOD_DARK).box((x - 0.2, x + 0.2), (y - 0.15, y + 0.15), (z, z + 0.16), without=("-z",))
    whole.body.box((-0.2, 0.65), (-0.17, 0.18), (0, 0.5))
    return whole


def fountain():
    """Stone basin, 3 m across, with a column."""
    whole = Gathered()
    stone = whole.of("stone", CONCRETE).ring([(1.5, 0), (1.5, 0.55), (1.25, 0.55), (1.25, 0.30)], sides=12)
    stone.ring([(0.28, 0.30), (0.18, 0.5), (0.14, 1.6), (0.45, 1.75), (0.45, 1.82), (0.0, 1.9)], sides=8)
    whole.of("water", GLASS).ring([(1.26, 0.38), (0.1, 0.38)], sides=12)
    whole.body.ring([(1.5, 0), (1.5, 0.55), (0.0, 0.55)], sides=12).box((-0.2, 0.2), (-0.2, 0.2), (0.5, 1.9))
    return whole


STALLS = (("stall_fruit", RED, "FRUIT", ("orange", "red", "green", "yellow", "plum")),
          ("stall_bread", BLUE, "BREAD", ("loaf", "loaf", "white", "loaf", "loaf")),
          ("stall_cheese", GREEN, "CHEESE", ("yellow", "white", "yellow", "white", "yellow")))
