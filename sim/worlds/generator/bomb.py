"""Module 3, bomb: training charges on the ground, on a table and under a bench, and two vessels.

Cross lane at y = 2 (2.4 m wide), lanes north of it at x = 4 k, road round the vessels at y = 16..20.
In local metres, all approached with heading 0; z of the charge's middle:

    x    y    z      what
    0    6    0.12   charge_m   60 x 240 mm, 3 kg, free on the ground
    -4   6    0.83   charge_s   30 x 160 mm, 1 kg, on the table (top 0.75, front edge y = 5.72)
    4    6    0.15   charge_l   75 x 300 mm, 6 kg, under the bench (0.65 clear, 1.5 m between its legs,
                                front edge y = 5.70)
    8    6    0.15   charge_h   75 x 300 mm, 12 kg: too heavy at full stretch
    0    18          can        drum: inner radius 0.25, net 0.50, rim 0.85; free from west, south, east
    12   18          chamber    sphere: tray 0.60, x +-0.25, y 17.6..18.4; door and tray towards south
    16   6, 9        carton_1, carton_2      20   5, 8   loose_cone_1, loose_cone_2
    -8   6..8        platform, 0.30 high     -12  6      bin     -16  6  shelf     -20  6  niche in a wall
"""

from sdf_writer import box, cylinder

from .furniture import barrel, building, container, crate
from .module import Module, part
from .movables import carton, charge, loose_cone
from .scenery import Scenery, fence, ground, land, start_pad, trees, write_mesh
from .solid import Solid, write_text
from .surfaces import (ASPHALT, BLACK, BLUE, BRICK_PALE, CONCRETE, CONCRETE_DARK, GREEN, HAZARD, LINE, METAL, ORANGE,
                       RED, STEEL, WHITE, WOOD, WOOD_DARK, YELLOW_LINE)
from .vessels import CHAMBER, DRUM, chamber, drum

HALF = 60
TABLE_TOP, BENCH_CLEARANCE, PLATFORM = 0.75, 0.65, 0.30
# letter, radius, length [m], mass [kg], x, y, what it stands on [m]
CHARGES = (("S", 0.030, 0.160, 1.0, -4, 6, TABLE_TOP), ("M", 0.060, 0.240, 3.0, 0, 6, 0.0),
           ("L", 0.075, 0.300, 6.0, 4, 6, 0.0), ("H", 0.075, 0.300, 12.0, 8, 6, 0.0))
CHARGE_FRICTION = 0.6


def trestle(width, depth, underside, top, surface):
    """Table or bench: top, and a leg at each corner; origin below its middle."""
    link = part().solid(box(width, depth, top - underside), surface, (0, 0, (top + underside) / 2))
    for side in (-1, 1):
        x = side * (width / 2 - 0.05)
        for y in (-depth / 2 + 0.05, depth / 2 - 0.05):
            link.solid(box(0.06, 0.06, underside), METAL, (x, y, underside / 2))
        link.visual(box(0.04, depth - 0.12, 0.05), METAL, (x, 0, 0.15))
    return link.visual(box(width - 0.12, 0.03, 0.07), METAL, (0, depth / 2 - 0.06, underside - 0.04))


def platform():
    link = part().solid(box(2, 2, PLATFORM), CONCRETE, (0, 1, PLATFORM / 2))
    return link.visual(box(2.006, 0.10, 0.10), HAZARD, (0, 0.047, PLATFORM - 0.047))


def litter_bin(folder):
    wall = Solid().ring([(0.22, 0.02), (0.25, 0.75), (0.23, 0.75), (0.20, 0.04)])
    link = part().solid(write_mesh(wall, "bin", folder), GREEN)
    link.solid(cylinder(0.21, 0.04), BLACK, (0, 0, 0.02))
    return link.visual(box(0.20, 0.01, 0.20), WHITE, (0, -0.232, 0.45))


def shelf():
    """Three boards, 1.6 x 0.4 m, at 0.35, 0.80 and 1.25."""
    link = part()
    for z in (0.35, 0.80, 1.25):
        link.solid(box(1.6, 0.4, 0.03), WOOD, (0, 0, z - 0.015))
    for x in (-0.78, 0.78):
        for y in (-0.18, 0.18):
            link.solid(box(0.04, 0.04, 1.5), METAL, (x, y, 0.75))
    for x, z, size, surface in ((-0.45, 0.35, 0.22, ORANGE), (0.30, 0.80, 0.26, BLUE), (0.50, 1.25, 0.2, STEEL)):
        link.visual(cylinder(size / 2, size * 1.3), surface, (x, 0.02, z + size * 0.65))
    return link.visual(box(0.4, 0.28, 0.22), WOOD_DARK, (-0.35, 0, 0.91))


def niche_wall():
    """Wall 3 x 0.6 x 1.8 m with a niche 0.5 wide and high, 0.4 deep, 0.5 above the ground."""
    link = part()
    for x in (-0.875, 0.875):
        link.solid(box(1.25, 0.6, 1.8), BRICK_PALE, (x, 0.3, 0.9))
    link.solid(box(0.5, 0.6, 0.5), BRICK_PALE, (0, 0.3, 0.25)).solid(box(0.5, 0.6, 0.8), BRICK_PALE, (0, 0.3, 1.4))
    link.solid(box(0.5, 0.2, 0.5), CONCRETE_DARK, (0, 0.5, 0.75))
    link.visual(box(3.1, 0.7, 0.06), CONCRETE, (0, 0.3, 1.83))
    return link.visual(box(0.6, 0.08, 0.05), CONCRETE, (0, -0.02, 0.475))


def blast_wall():
    """Concrete blocks, 2 x 0.6 x 0.8 m, in two courses."""
    link = part()
    for course, xs in ((0, (-4, -2, 0, 2, 4)), (1, (-3, -1, 1, 3))):
        for x in xs:
            link.visual(box(1.98, 0.6, 0.79), CONCRETE if course else CONCRETE_DARK, (x, 0, 0.4 + 0.8 * course))
    link.collision(box(10, 0.6, 0.8), (0, 0, 0.4)).collision(box(8, 0.6, 0.8), (0, 0, 1.2))
    return link


def markings(folder):
    """Lanes, lines, signs; seen only."""
    scenery = Scenery("bomb", folder)
    start_pad(scenery)
    scenery.pave("asphalt", ASPHALT, (-22, 22), (0.8, 3.2), 1)
    for x in range(-20, 24, 4):
        scenery.pave("asphalt", ASPHALT, (x - 1.2, x + 1.2), (3.2, 16.0 if x in (0, 12) else 10.0), 1)
        for side in (-1, 1):
            scenery.pave("line", LINE, sorted((x + side * 1.1, x + side * 1.18)), (3.4, 10.0), 2)
    for x in (-2, 2):
        scenery.pave("yellow", YELLOW_LINE, (x - 0.05, x + 0.05), (3.2, 16.0), 2)
    scenery.pave("concrete", CONCRETE, (-4, 16), (16.0, 20.0), 1)
    for x in (0, 12):
        # Where the robot stops: 1.05 m from the axis.
        scenery.pave("red", RED, (x - 0.5, x + 0.5), (16.93, 16.97), 2)
        scenery.pave("yellow", YELLOW_LINE, (x - 1.3, x + 1.3), (16.1, 16.16), 2)
    plates, posts, text = scenery.of("white", WHITE), scenery.of("metal", METAL), scenery.of("black", BLACK)
    for letter, _, _, _, x, y, _ in CHARGES:
        posts.box((x - 1.33, x - 1.27), (y + 1.22, y + 1.28), (0, 1.3), without=("-z",))
        plates.box((x - 1.55, x - 1.05), (y + 1.19, y + 1.22), (0.90, 1.40))
        write_text(letter, (x - 1.30, y + 1.19, 1.15), 0.30, 0.055, text)
    return scenery.link()


def bomb(folder):
    """Module 3."""
    yard = Module(3, "bomb", (0, 0, 0), (2 * HALF, 2 * HALF))
    yard.model("bomb_ground", ground((((-HALF, HALF), (-HALF, HALF)),), HALF, 84))
    yard.model("bomb_markings", markings(folder))
    yard.model("table", trestle(1.4, 0.70, TABLE_TOP - 0.04, TABLE_TOP, WOOD), (-4, 6.07, 0))
    yard.model("bench", trestle(1.66, 0.90, BENCH_CLEARANCE, BENCH_CLEARANCE + 0.06, WOOD_DARK), (4, 6.15, 0))
    yard.model("platform", platform(), (-8, 6, 0))
    yard.model("bin", litter_bin(folder), (-12, 6, 0))
    yard.model("shelf", shelf(), (-16, 6.2, 0))
    yard.model("niche", niche_wall(), (-20, 6, 0))
    yard.vessel("can", drum(folder), (0, 18, 0), DRUM)
    yard.vessel("chamber", chamber(folder), (12, 18, 0), CHAMBER)
    for letter, radius, length, mass, x, y, support in CHARGES:
        yard.movable(f"charge_{letter.lower()}", charge(letter, radius, length, mass, folder),
                     (x, y, support + length / 2), CHARGE_FRICTION, explosive=True)
    for i, (y, size) in enumerate(((6, (0.40, 0.40, 0.35, 2.0)), (9, (0.50, 0.35, 0.30, 2.5)))):
        yard.movable(f"carton_{i + 1}", carton(*size), (16, y, size[2] / 2), 0.5)
    for i, y in enumerate((5, 8)):
        yard.movable(f"loose_cone_{i + 1}", loose_cone(), (20, y, 0), 0.7)
    for i, x in enumerate((0, 12)):
        yard.model(f"blast_wall_{i + 1}", blast_wall(), (x, 23, 0))
    yard.model("bomb_fence", fence(HALF, "fence_60", folder))
    yard.model("bomb_house", building(), (-22, 30, 0), 15)
    yard.model("bomb_container", container(), (26, 14, 0), 100)
    for i, (x, y, surface) in enumerate(((-14, 14, BLUE), (-13.3, 14.3, ORANGE), (23, 18.5, GREEN))):
        yard.model(f"bomb_barrel_{i + 1}", barrel(surface), (x, y, 0), 40 * i)
    for i, (x, y, size) in enumerate(((-15, 13, 0.9), (-9, 22, 0.8))):
        yard.model(f"bomb_crate_{i + 1}", crate(size), (x, y, 0), 25 * i)
    trees(yard, [(-50, 28), (-36, 40), (-6, 36), (8, 44), (28, 38), (44, 30), (50, 6), (46, -26), (18, -30),
                 (-10, -28), (-34, -24), (-52, -8), (-30, 8), (34, -8)], 3)
    land(yard)
    return yard
