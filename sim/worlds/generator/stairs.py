"""Flights of stairs: what isectors run into are treads and risers (BUMP), what the robot stands on is
the line through the nosings (CLAMP)."""

import math

from sdf_writer import box, mesh

from .module import part
from .scenery import write_mesh
from .solid import Solid
from .surfaces import CONCRETE, CONCRETE_DARK, METAL, YELLOW_LINE

LEAD_IN = 0.10  # [m] radius of the robot's small wheels [C]
WEDGE = "meshes/wedge.obj"
WIDTH = 2.4  # [m] unless another one is asked for


def clamp_ramp(link, width, y, z, steps, rise, run):
    """CLAMP proxy of a flight whose first riser is at y: the line through the nosings, and before the
    first one a lead-in. That is as short as the small wheels' radius, for a lowered wheel has to meet
    the riser before the ground lifts it over."""
    link.collision(mesh(WEDGE, (width, LEAD_IN, rise)), (0, y - LEAD_IN, z), proxy="clamp")
    line = (width, (steps - 1) * run, (steps - 1) * rise)
    link.collision(mesh(WEDGE, line), (0, y, z + rise), proxy="clamp")


def flight(link, width, y, z, steps, rise, run, folder):
    """`steps` risers, the first one at y, going up from z; the last one is the face of what follows.
    Returns y and z of the last nosing."""
    name = f"stair_{steps}_{round(rise * 1000)}_{round(run * 1000)}"
    if width != WIDTH:
        name += f"_{round(width * 100)}_wide"
    x = (-width / 2, width / 2)
    treads, strips = Solid(), Solid()
    for i in range(1, steps):
        near, far, top = (i - 1) * run, i * run, i * rise
        treads.box(x, (near, far), (0, top), without=("-z", "-y", "+y"))
        treads.face((x[0], near, top - rise), (x[1], near, top - rise), (x[1], near, top), (x[0], near, top))
        strips.box(x, (near - 0.003, near + 0.04), (top - 0.04, top + 0.003), without=("-z", "+y"))
    body = write_mesh(treads, name, folder)
    link.visual(body, CONCRETE, (0, y, z))
    link.visual(write_mesh(strips, f"{name}_nosings", folder), YELLOW_LINE, (0, y, z))
    link.collision(body, (0, y, z), proxy="bump")
    clamp_ramp(link, width, y, z, steps, rise, run)
    return y + (steps - 1) * run, z + steps * rise


def handrails(points, width, solid):
    """Two rails and posts on both sides of the way over `points` (y, z)."""
    for side in (-1, 1):
        x = side * (width / 2 + 0.04)
        for (y0, z0), (y1, z1) in zip(points, points[1:]):
            for height in (0.5, 0.95):
                solid.beam((x, y0, z0 + height), (x, y1, z1 + height), 0.045)
            posts = max(1, round(math.hypot(y1 - y0, z1 - z0) / 1.1))
            for i in range(posts + 1):
                y, z = y0 + (y1 - y0) * i / posts, z0 + (z1 - z0) * i / posts
                solid.beam((x, y, z - 0.15), (x, y, z + 0.96), 0.04)


def guard(link, width, points):
    """What isectors meet of the handrails: a slab on each side of each stretch."""
    for (y0, z0), (y1, z1) in zip(points, points[1:]):
        slope = math.atan2(z1 - z0, y1 - y0)
        length = math.hypot(y1 - y0, z1 - z0)
        for side in (-1, 1):
            at = (side * (width / 2 + 0.04), (y0 + y1) / 2, (z0 + z1) / 2 + 0.70)
            link.collision(box(0.045, length, 0.55), at, (math.degrees(slope), 0, 0), proxy="bump")


def stairs(name, flights, rise, run, landing, descent_deg, folder, width=WIDTH):
    """Up the flights, over a platform of 2 m and down a ramp. Begins at y = 0 with the first riser."""
    link = part()
    y, z = 0.0, 0.0
    walk = [(-run / 2, 0.0)]
    for number, steps in enumerate(flights):
        if number:
            walk.append((y + landing - run / 2, z))
        y, z = flight(link, width, y, z, steps, rise, run, folder)
        walk.append((y, z))
        depth = landing if number + 1 < len(flights) else 2.0
        body = depth if number + 1 == len(flights) else depth + (flights[number + 1] - 1) * run
        link.solid(box(width, body, z), CONCRETE_DARK, (0, y + body / 2, z / 2))
        y += depth
    walk.append((y, z))
    down = z / math.tan(math.radians(descent_deg))
    link.visual(mesh(WEDGE, (width, down, z)), CONCRETE, (0, y + down, 0), (0, 0, 180))
    link.collision(mesh(WEDGE, (width, down, z)), (0, y + down, 0), (0, 0, 180))
    walk.append((y + down, 0.0))
    rails = Solid()
    handrails(walk, width, rails)
    guard(link, width, walk)
    return link.visual(write_mesh(rails, f"{name}_rails", folder), METAL)
