"""Containment vessels: an open drum with a wire net, and a sphere with a door and a loading tray."""

import math

from sdf_writer import box, cylinder

from .module import part
from .scenery import write_mesh
from .solid import Solid
from .surfaces import ALONG_X, ALONG_Y, BLACK, BLUE, CONCRETE_DARK, GREEN, HAZARD, METAL, STEEL, WHITE, YELLOW_LINE

DRUM_INNER, DRUM_OUTER = 0.25, 0.33
DRUM_FLOOR, DRUM_RIM = 0.15, 0.85
DRUM_NET = DRUM_RIM - 0.35

SPHERE_INNER, SPHERE_OUTER, SPHERE_Z = 0.60, 0.65, 1.05
DOOR_DEG = 49.0  # half angle of the opening, seen from the centre
TRAY_Z, TRAY_WIDTH = 0.60, 0.50
CHAMBER_DEPTH = 0.80  # along Y, about the centre


def wire_net(radius, top, mesh_width, wire):
    """Wires both ways within a circle."""
    solid = Solid()
    count = int((radius - wire) / mesh_width)
    for i in range(-count, count + 1):
        across = i * mesh_width
        reach = math.sqrt(radius ** 2 - across ** 2)
        solid.beam((-reach, across, top - wire / 2), (reach, across, top - wire / 2), wire)
        solid.beam((across, -reach, top - 1.5 * wire), (across, reach, top - 1.5 * wire), wire)
    return solid


def drum(folder):
    """Origin on the ground on the drum's axis; the trolley's floor at 0.15, wheels outside."""
    wall = Solid().ring([(DRUM_OUTER, DRUM_FLOOR), (DRUM_OUTER, DRUM_RIM), (DRUM_INNER, DRUM_RIM),
                         (DRUM_INNER, DRUM_FLOOR)], closed=True)
    link = part().solid(write_mesh(wall, "can_wall", folder), GREEN)
    for name, low, high, proud, surface in (("band", 0.62, 0.74, 0.002, HAZARD), ("rim", 0.80, 0.853, 0.012, METAL),
                                            ("foot", 0.15, 0.20, 0.012, METAL)):
        outer = DRUM_OUTER + proud
        ring = Solid().ring([(DRUM_OUTER, low), (outer, low), (outer, high), (DRUM_OUTER, high)])
        link.visual(write_mesh(ring, f"can_{name}", folder), surface)
    link.visual(cylinder(DRUM_INNER, 0.01), BLACK, (0, 0, DRUM_FLOOR + 0.006))
    link.visual(write_mesh(wire_net(DRUM_INNER, DRUM_NET, 0.05, 0.006), "can_net", folder), STEEL)
    link.collision(cylinder(DRUM_INNER, 0.02), (0, 0, DRUM_NET - 0.01))
    link.solid(box(0.76, 0.76, 0.05), CONCRETE_DARK, (0, 0, DRUM_FLOOR - 0.025))
    for x in (-0.30, 0.30):
        for y in (-0.30, 0.30):
            link.visual(cylinder(0.05, 0.05), BLACK, (x, y, 0.05), ALONG_X)
    # The lid lies behind; the drawbar too.
    link.solid(cylinder(0.35, 0.05), GREEN, (0, 1.0, 0.025))
    link.visual(cylinder(0.06, 0.03), METAL, (0, 1.0, 0.06))
    return link.visual(box(0.04, 0.30, 0.04), METAL, (0, 0.50, 0.12))


DRUM = f'kind="drum" inner_radius_m="{DRUM_INNER}" net_m="{DRUM_NET}" rim_m="{DRUM_RIM}"'
CHAMBER = (f'kind="chamber" inner_x_m="{TRAY_WIDTH}" inner_y_m="{CHAMBER_DEPTH}" net_m="{TRAY_Z}" '
           f'rim_m="{SPHERE_Z + SPHERE_INNER}"')


def sphere_shell():
    """Shell with a round opening towards -Y, about its own centre."""
    rings = 12
    start = math.radians(DOOR_DEG)

    def arc(radius):
        angles = [math.pi - (math.pi - start) * i / rings for i in range(rings + 1)]
        return [(0.0 if i == 0 else radius * math.sin(a), radius * math.cos(a)) for i, a in enumerate(angles)]

    about_z = Solid().ring([*arc(SPHERE_OUTER), *reversed(arc(SPHERE_INNER))], sides=32)
    return Solid().add(about_z, lambda c: (c[0], -c[2], c[1]))


def chamber(folder):
    """Origin on the ground below the sphere's centre; door and tray towards -Y."""
    link = part().solid(write_mesh(sphere_shell(), "chamber_shell", folder), BLUE, (0, 0, SPHERE_Z))
    link.solid(box(TRAY_WIDTH, 1.08, 0.03), STEEL, (0, -0.24, TRAY_Z - 0.015))
    for side in (-1, 1):
        x = side * TRAY_WIDTH / 2
        link.visual(box(0.02, 1.08, 0.05), YELLOW_LINE, (x, -0.24, TRAY_Z - 0.01))
        link.visual(cylinder(0.22, 0.12), BLACK, (side * 0.62, 0.05, 0.22), ALONG_X)
        link.visual(cylinder(0.10, 0.13), METAL, (side * 0.62, 0.05, 0.22), ALONG_X)
        link.visual(box(0.10, 0.9, 0.30), METAL, (side * 0.36, 0, 0.42))
    link.solid(box(1.00, 0.96, 0.14), METAL, (0, 0.02, 0.28))
    link.visual(box(0.08, 1.0, 0.08), METAL, (0, 0.95, 0.26))
    link.visual(cylinder(0.05, 0.26), METAL, (0, 1.40, 0.13))
    # The door stands open, 110 degrees on its hinge on the right.
    turn = math.radians(110)
    hinge = (0.52, -0.46)
    middle = (hinge[0] - 0.5 * math.cos(turn), hinge[1] - 0.5 * math.sin(turn), SPHERE_Z)
    link.solid(cylinder(0.50, 0.06), BLUE, middle, (90, 0, 110))
    link.visual(cylinder(0.42, 0.10), STEEL, middle, (90, 0, 110))
    link.visual(cylinder(0.05, 0.30), METAL, (hinge[0], hinge[1], SPHERE_Z))
    frame = Solid().ring([(0.455, -0.03), (0.53, -0.03), (0.53, 0.03), (0.455, 0.03)], closed=True)
    link.visual(write_mesh(frame, "chamber_frame", folder), HAZARD, (0, -0.435, SPHERE_Z), ALONG_Y)
    return link.visual(box(0.01, 0.30, 0.20), WHITE, (0.645, 0.0, SPHERE_Z + 0.02))
