"""Module 2, slope: planes, side slopes, stairs and obstacles, in lanes side by side.

All lanes lead north from the cross lane at y = 4 (2.4 m wide) to the return lane at y = 22; the obstacle
of lane k stands at x = 4 k and begins at y = 8. Mark lines at y = 6.5. In local metres, all approached
with heading 0:

    x    model           what
    0    kerb            0.15 high, 2 m long: up and down
    4    ramp_10         plane of 3 m up, 2 m level, 3 m down: 10 deg
    8    ramp_15         15 deg
    12   ramp_20         20 deg; lines across the middle of the way up: hold here
    16   ramp_25         25 deg
    20   ramp_30         30 deg
    24   ramp_35         35 deg
    28   ramp_42         42 deg, steeper than the robot climbs
    32   side_10         right side up: 2.5 m of twist, 3 m at 10 deg, 2.5 m back to level
    36   side_15         15 deg
    40   side_20         20 deg
    44   crossing_ramps  12 half ramps, rising 0.17 over 0.59 and falling again; right track one tile later
    -4   stairs_150      10 x 150/300; platform 2 m; ramp of 20 deg down
    -8   stairs_165      9 x 165/280; platform 2 m; ramp of 20 deg down
    -12  stairs_175      6 + 6 x 175/260 with a landing of 1.5 m; platform 2 m; ramp of 25 deg down
    -16  bar_10          round bar, 0.10 high, its axis at y = 8
    -20  bar_20          0.20
    -24  bar_40          0.40, the limit
    -28  bar_55          0.55, above it
    -32  ditches         0.40 wide, 0.30 deep, from y = 8
    -36  ditches         0.60
    -40  ditches         0.90
    -44  stepfield       3 x 1.2 m of posts 0.2 m square, 0..0.2 m high
"""

import math

from sdf_writer import box, mesh

from .furniture import barrel, building, container, crate, hurdle, traffic_cone
from .module import Module, part
from .rough_fields import crossing_ramps, skin_over, stepfield, whole_posts
from .scenery import Scenery, fence, ground, land, start_pad, trees, write_mesh
from .solid import Solid, write_text
from .stairs import WEDGE, stairs
from .surfaces import (ASPHALT, BLACK, BLUE, CONCRETE, CONCRETE_DARK, GREEN, HAZARD, LINE, METAL, ORANGE, RED,
                       WHITE, WOOD, YELLOW_LINE)

START = 8.0  # y where every obstacle begins
WIDTH = 2.4
HALF = 60
PLANES_DEG = (10, 15, 20, 25, 30, 35, 42)
SIDES_DEG = (10, 15, 20)
DITCHES = ((-32, 0.4), (-36, 0.6), (-40, 0.9))
DITCH_DEPTH = 0.3
KERB_LEAD_IN = 0.2
BARS = ((-16, 0.10), (-20, 0.20), (-24, 0.40), (-28, 0.55))
POSTS = (6, 15, 0.2)  # columns, rows, side [m]
SIGNS = {0: "15", -4: "150", -8: "165", -12: "175", 32: "10", 36: "15", 40: "20", 44: "17", -44: "20"}


def inclined_plane(angle_deg, hold=False):
    """Up 3 m, 2 m level, down 3 m."""
    angle = math.radians(angle_deg)
    run, rise = 3 * math.cos(angle), 3 * math.sin(angle)
    link = part().solid(mesh(WEDGE, (WIDTH, run, rise)), CONCRETE)
    link.solid(box(WIDTH, 2, rise), CONCRETE_DARK, (0, run + 1, rise / 2))
    link.solid(mesh(WEDGE, (WIDTH, run, rise)), CONCRETE, (0, 2 * run + 2, 0), (0, 0, 180))
    edge = RED if angle_deg > 40 else YELLOW_LINE

    def stripe(surface, width, depth, x, along):
        """Painted on the way up, `along` metres up from its foot."""
        y, z = along * math.cos(angle), along * math.sin(angle)
        link.visual(box(width, depth, 0.006), surface, (x, y, z), (angle_deg, 0, 0))

    for side in (-1, 1):
        stripe(edge, 0.08, 2.96, side * 1.14, 1.5)
        link.visual(box(0.08, 2.96, 0.006), edge, (side * 1.14, run + 2 + run / 2, rise / 2),
                    (-angle_deg, 0, 0))
    if hold:
        for along in (0.9, 2.1):
            stripe(LINE, 2.0, 0.10, 0, along)
    link.visual(box(WIDTH + 0.01, 0.10, 0.10), HAZARD, (0, run + 0.05, rise - 0.046))
    return link.visual(box(WIDTH + 0.01, 0.10, 0.10), HAZARD, (0, run + 1.95, rise - 0.046))


def side_slope():
    """One wide and one high: level at the near end, twisted within 2.5 m until the right side is up, 3 m
    of that, and back to level."""
    rows = [(2.5 * i / 8, (1 - math.cos(math.pi * i / 8)) / 2) for i in range(9)]
    rows += [(8 - y, f) for y, f in reversed(rows)]
    xs = [-0.5 + i / 4 for i in range(5)]
    solid = Solid()
    for (y0, f0), (y1, f1) in zip(rows, rows[1:]):
        for x0, x1 in zip(xs, xs[1:]):
            # Two triangles each: four corners of a twisted patch lie in no plane.
            a, b = (x0, y0, (x0 + 0.5) * f0), (x1, y0, (x1 + 0.5) * f0)
            c, d = (x1, y1, (x1 + 0.5) * f1), (x0, y1, (x0 + 0.5) * f1)
            solid.face(a, b, c).face(a, c, d)
        solid.face((0.5, y0, 0), (0.5, y1, 0), (0.5, y1, f1), (0.5, y0, f0))
    return solid


def post_height(column, row):
    """Two waves along the way, shifted in every other column; in steps of 0.05 m."""
    return 0.05 * round(2 - 2 * math.cos(2 * math.pi * (row + 0.5 * (column % 2)) / 7))


def kerb():
    link = part().visual(box(WIDTH, 2, 0.15), CONCRETE, (0, 1, 0.075)).collision(box(WIDTH, 2, 0.15), (0, 1, 0.075))
    link.collision(mesh(WEDGE, (WIDTH, KERB_LEAD_IN, 0.15)), (0, -KERB_LEAD_IN, 0), proxy="clamp")
    link.collision(mesh(WEDGE, (WIDTH, KERB_LEAD_IN, 0.15)), (0, 2 + KERB_LEAD_IN, 0), (0, 0, 180), proxy="clamp")
    for y in (0.06, 1.94):
        link.visual(box(WIDTH + 0.004, 0.13, 0.10), YELLOW_LINE, (0, y, 0.103))
    return link


def ditches():
    """A pit of concrete, 12 x 1.5 m, filled but for the ditches."""
    link = part()
    west, east = -42.0, -30.0
    near, far = START - 0.25, START + 1.25
    bottom = -DITCH_DEPTH - 0.2
    blocks = [((west, east), (near, START), 0.0), ((west, east), (START, far), -DITCH_DEPTH)]
    edges = [west]
    for x, width in sorted(DITCHES):
        edges += [x - WIDTH / 2, x + WIDTH / 2]
        blocks.append(((x - WIDTH / 2, x + WIDTH / 2), (START + width, far), 0.0))
        for y in (START - 0.06, START + width + 0.06):
            link.visual(box(WIDTH, 0.10, 0.02), YELLOW_LINE, (x, y, -0.006))
    edges.append(east)
    blocks += [((a, b), (START, far), 0.0) for a, b in zip(edges[::2], edges[1::2])]
    for x, y, top in blocks:
        size = (x[1] - x[0], y[1] - y[0], top - bottom)
        link.solid(box(*size), CONCRETE if top == 0 else CONCRETE_DARK,
                   ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (top + bottom) / 2))
    return link


def markings(folder):
    """Lanes, lines, signs; seen only."""
    scenery = Scenery("slope", folder)
    start_pad(scenery)
    lanes = [4 * k for k in range(-11, 12)]
    ditch, twisted = {x for x, _ in DITCHES}, {32 + 4 * i for i in range(len(SIDES_DEG))}
    for y in (4, 22):
        scenery.pave("asphalt", ASPHALT, (-47, 47), (y - 1.2, y + 1.2), 1)
        scenery.pave("line", LINE, (-47, 47), (y + 1.1, y + 1.18), 2)
        scenery.pave("line", LINE, (-47, 47), (y - 1.18, y - 1.1), 2)
    scenery.pave("asphalt", ASPHALT, (-1.2, 1.2), (1.5, 2.8), 1)
    plates, posts, text = scenery.of("white", WHITE), scenery.of("metal", METAL), scenery.of("black", BLACK)
    signs = dict(SIGNS)
    signs.update({4 * (i + 1): str(angle) for i, angle in enumerate(PLANES_DEG)})
    signs.update({x: str(round(100 * size)) for x, size in (*BARS, *DITCHES)})
    for x in lanes:
        gap = (7.75, 9.25) if x in ditch else (START, START + 8) if x in twisted else (20.8, 20.8)
        for y in ((5.2, gap[0]), (gap[1], 20.8)):
            if y[1] > y[0]:
                scenery.pave("asphalt", ASPHALT, (x - 1.2, x + 1.2), y, 1)
        scenery.pave("yellow", YELLOW_LINE, (x - 1.0, x + 1.0), (6.45, 6.55), 2)
        for side in (-1, 1):
            scenery.pave("line", LINE, sorted((x + side * 1.1, x + side * 1.18)), (5.3, 7.7), 2)
        sign = x - 1.7
        posts.box((sign - 0.03, sign + 0.03), (7.22, 7.28), (0, 1.4), without=("-z",))
        plates.box((sign - 0.38, sign + 0.38), (7.19, 7.22), (0.95, 1.45))
        write_text(signs[x], (sign, 7.19, 1.20), 0.28, 0.05, text)
    return scenery.link()


def slope(folder):
    """Module 2."""
    Solid().wedge((-0.5, 0.5), (0, 1), 1).write(folder / "wedge.obj")
    yard = Module(2, "slope", (1000, 1000, 0), (2 * HALF, 2 * HALF))
    pit = ((-HALF, HALF), (-HALF, 7.75)), ((-HALF, HALF), (9.25, HALF)), ((-HALF, -42), (7.75, 9.25)), \
        ((-30, HALF), (7.75, 9.25))
    yard.model("slope_ground", ground(pit, HALF, 84))
    yard.model("slope_markings", markings(folder))
    yard.model("kerb", kerb(), (0, START, 0))
    for i, angle in enumerate(PLANES_DEG):
        yard.model(f"ramp_{angle}", inclined_plane(angle, hold=angle == 20), (4 * (i + 1), START, 0))
    side_slope().write(folder / "side_slope.obj")
    for i, angle in enumerate(SIDES_DEG):
        scale = (WIDTH, 1, WIDTH * math.tan(math.radians(angle)))
        link = part().solid(mesh("meshes/side_slope.obj", scale), CONCRETE)
        yard.model(f"side_{angle}", link, (32 + 4 * i, START, 0))
    tiles = part().solid(write_mesh(crossing_ramps(), "crossing_ramps", folder), WOOD)
    yard.model("crossing_ramps", tiles, (44, START, 0))
    yard.model("stairs_150", stairs("stairs_150", (10,), 0.15, 0.30, 0, 20, folder), (-4, START, 0))
    yard.model("stairs_165", stairs("stairs_165", (9,), 0.165, 0.28, 0, 20, folder), (-8, START, 0))
    yard.model("stairs_175", stairs("stairs_175", (6, 6), 0.175, 0.26, 1.5, 25, folder), (-12, START, 0))
    for x, height in BARS:
        yard.model(f"bar_{round(100 * height)}", hurdle(height), (x, START, 0))
    yard.model("ditches", ditches())
    posts, skin = whole_posts(*POSTS, post_height), skin_over(*POSTS, post_height)
    yard.model("stepfield", stepfield("stepfield", posts, skin, 3.0, 1.2, folder), (-44, START, 0))
    yard.model("slope_fence", fence(HALF, "fence_60", folder))
    yard.model("slope_house", building(), (-20, 38, 0), 10)
    yard.model("slope_container", container(), (14, 34, 0), 80)
    for i, (x, y, surface) in enumerate(((18, 30, BLUE), (18.7, 30.2, ORANGE), (-26, -6, GREEN))):
        yard.model(f"slope_barrel_{i + 1}", barrel(surface), (x, y, 0), 40 * i)
    for i, (x, y, size) in enumerate(((9, 31, 0.9), (-24.5, -7, 0.8))):
        yard.model(f"slope_crate_{i + 1}", crate(size), (x, y, 0), 25 * i)
    for i, x in enumerate((-2.6, 2.6)):
        yard.model(f"slope_cone_{i + 1}", traffic_cone(), (x, 2.2, 0))
    trees(yard, [(-52, 30), (-40, 44), (-8, 46), (6, 40), (26, 44), (42, 33), (53, 14), (50, -20), (20, -30),
                 (-6, -24), (-32, -28), (-54, -12), (-50, 50), (54, 52)], 2)
    land(yard)
    return yard
